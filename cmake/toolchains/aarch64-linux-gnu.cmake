# SPDX-License-Identifier: MIT
# Linux on 64-bit ARM, by Debian's cross compiler (g++-aarch64-linux-gnu). The programs run under qemu-user.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64 -L /usr/aarch64-linux-gnu)
# Its notes that GCC 10 changed how small structs are passed concern old libraries, of which there are none here.
set(CMAKE_CXX_FLAGS_INIT -Wno-psabi)
