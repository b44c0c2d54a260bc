find_package(PkgConfig REQUIRED)
pkg_check_modules(GIF REQUIRED IMPORTED_TARGET libgif)
cambrian_wrap(gif PkgConfig::GIF)
