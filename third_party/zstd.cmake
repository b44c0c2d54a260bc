find_package(PkgConfig REQUIRED)
pkg_check_modules(ZSTD REQUIRED IMPORTED_TARGET libzstd)
cambrian_wrap(zstd PkgConfig::ZSTD)
