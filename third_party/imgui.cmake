# Debian's library holds the GLFW and OpenGL 3 back-ends.
find_package(PkgConfig REQUIRED)
pkg_check_modules(IMGUI REQUIRED IMPORTED_TARGET imgui)
cambrian_wrap(imgui PkgConfig::IMGUI)
