find_package(PkgConfig REQUIRED)
pkg_check_modules(FONTCONFIG REQUIRED IMPORTED_TARGET fontconfig)
cambrian_wrap(fontconfig PkgConfig::FONTCONFIG)
