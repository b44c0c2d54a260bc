# Optional: without it the program evolves on one machine only and says so.
set(CAMBRIAN_BUILD_CLUSTER AUTO CACHE STRING
  "Evaluation on several machines (needs libnats): ON, OFF, or AUTO for whether libnats is there")
set_property(CACHE CAMBRIAN_BUILD_CLUSTER PROPERTY STRINGS AUTO ON OFF)
set(wanted ${CAMBRIAN_BUILD_CLUSTER})
if(wanted STREQUAL "AUTO" AND CMAKE_CROSSCOMPILING)
  set(wanted OFF)  # pkg-config would find the library of this machine
endif()
if(wanted)
  set(required "")
  if(NOT wanted STREQUAL "AUTO")
    set(required REQUIRED)
  endif()
  find_package(PkgConfig REQUIRED)
  pkg_check_modules(LIBNATS ${required} IMPORTED_TARGET libnats>=3.4)
  if(LIBNATS_FOUND)
    cambrian_wrap(libnats PkgConfig::LIBNATS)
  endif()
endif()
