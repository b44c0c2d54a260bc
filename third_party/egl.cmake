find_package(PkgConfig REQUIRED)
pkg_check_modules(EGL REQUIRED IMPORTED_TARGET egl)
cambrian_wrap(egl PkgConfig::EGL)
