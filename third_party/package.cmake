# `cpack --config build/release/CPackConfig.cmake` makes a Debian package of the program, its samples, help,
# manual and, if it was built, the engine of pages. It depends on the libraries that the program is linked
# to (needs dpkg-dev).
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_NAME cambrian)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "The Cambrian authors <cambrian@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "studio for evolving virtual creatures")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "Cambrian evolves virtual creatures that walk, jump, swim or fly, with bodies\n\
 and brains that nobody designed, after Karl Sims (1994). A window shows them\n\
 while they evolve; every number can be changed and every result repeated to\n\
 the last bit.")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "fonts-inter, libgl1-mesa-dri")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "ffmpeg")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

# What Debian's rules ask of every package.
set(documents ${CMAKE_BINARY_DIR}/package)
file(WRITE ${documents}/copyright "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/\n\
Upstream-Name: Cambrian\n\nFiles: *\nCopyright: 2026 The Cambrian authors\nLicense: Expat\n")
file(STRINGS ${CMAKE_SOURCE_DIR}/LICENSE licence)
list(SUBLIST licence 4 -1 licence)
foreach(line IN LISTS licence)
  if(line STREQUAL "")
    set(line .)
  endif()
  file(APPEND ${documents}/copyright " ${line}\n")
endforeach()
file(WRITE ${documents}/changelog "cambrian (${PROJECT_VERSION}) stable; urgency=low\n\n  * See /usr/share/cambrian/help/what_changed.md.\n\n\
 -- The Cambrian authors <cambrian@example.org>  Mon, 30 Nov 2026 00:00:00 +0000\n")
find_program(CAMBRIAN_GZIP gzip)
if(CAMBRIAN_GZIP)
  execute_process(COMMAND ${CAMBRIAN_GZIP} -9nf ${documents}/changelog)
  install(FILES ${documents}/copyright ${documents}/changelog.gz DESTINATION ${CMAKE_INSTALL_DOCDIR})
endif()
# The manual is compressed in the package only.
file(WRITE ${documents}/compress.cmake "file(GLOB_RECURSE manuals \"\${CPACK_TEMPORARY_DIRECTORY}/*.1\")\n\
if(manuals)\n  execute_process(COMMAND gzip -9nf \${manuals})\nendif()\n")
set(CPACK_PRE_BUILD_SCRIPTS ${documents}/compress.cmake)
include(CPack)
