find_package(PkgConfig REQUIRED)
pkg_check_modules(XCB REQUIRED IMPORTED_TARGET xcb)
cambrian_wrap(xcb PkgConfig::XCB)
