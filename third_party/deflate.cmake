find_package(PkgConfig REQUIRED)
pkg_check_modules(DEFLATE REQUIRED IMPORTED_TARGET libdeflate)
cambrian_wrap(deflate PkgConfig::DEFLATE)
