# The engine of pages (src/app/engine) is this project for another platform, so it has a build of its own.
# Where the group `engine` of packages.txt is installed, it is built along.
find_program(CAMBRIAN_WASM_LINKER NAMES wasm-ld wasm-ld-14)
find_program(CAMBRIAN_CLANG clang++)
find_file(CAMBRIAN_WASI_LIBRARY libc++.a PATHS /usr/lib/llvm-14/lib/wasm32-wasi /usr/lib/wasm32-wasi NO_DEFAULT_PATH)
set(possible OFF)
if(CAMBRIAN_WASM_LINKER AND CAMBRIAN_CLANG AND CAMBRIAN_WASI_LIBRARY AND NOT CAMBRIAN_SANITIZE AND NOT CMAKE_CROSSCOMPILING)
  set(possible ON)
endif()
option(CAMBRIAN_BUILD_ENGINE "Build the engine of pages (needs clang, lld and libc++ for WebAssembly)" ${possible})
set(CAMBRIAN_ENGINE_FOLDER ${CMAKE_BINARY_DIR}/engine/bin)
if(CAMBRIAN_BUILD_ENGINE)
  include(ExternalProject)
  ExternalProject_Add(engine
    SOURCE_DIR ${CMAKE_SOURCE_DIR} BINARY_DIR ${CMAKE_BINARY_DIR}/engine
    CONFIGURE_COMMAND ${CMAKE_COMMAND} --preset engine -S <SOURCE_DIR> -B <BINARY_DIR>
      -DCMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER}
    BUILD_COMMAND ${CMAKE_COMMAND} --build <BINARY_DIR>
    BUILD_ALWAYS ON USES_TERMINAL_BUILD ON INSTALL_COMMAND "")
endif()
