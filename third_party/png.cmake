# By pkg-config, which a cross build without a libpng of its own still configures with.
find_package(PkgConfig REQUIRED)
pkg_check_modules(PNG REQUIRED IMPORTED_TARGET libpng)
cambrian_wrap(png PkgConfig::PNG)
