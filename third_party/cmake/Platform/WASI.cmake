# CMake does not know the system WASI; it needs nothing beyond the defaults.
