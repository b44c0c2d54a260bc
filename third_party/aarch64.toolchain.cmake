# 64-bit ARM by Debian's cross compiler, run by qemu-user. Debian's cross compiler searches
# /usr/include for headers that are the same on every architecture, so the header-only libraries need
# nothing more; what is compiled for this machine (/usr/include/x86_64-linux-gnu, /usr/lib/...) is
# not on its paths. No window: its libraries are not header-only.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64 -L /usr/aarch64-linux-gnu)
