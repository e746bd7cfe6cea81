#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs a program of the preset windows under Wine, with graze's DLLs and those of the compiler. GRAZE_WINE is Wine, if it
# is not where Debian's package wine64 installs it.
root=$(dirname "$(readlink -f "$0")")/../..
build=$root/build/windows
compiler_dlls=$(dirname "$(x86_64-w64-mingw32-g++-posix -print-file-name=libstdc++-6.dll)")
thread_dlls=/usr/x86_64-w64-mingw32/lib
export WINEPREFIX="${WINEPREFIX:-$build/wine}" WINEDEBUG="${WINEDEBUG:--all}"
export WINEPATH="$build/graze;$build/bin;$build/bindings/c;$compiler_dlls;$thread_dlls"
exec "${GRAZE_WINE:-/usr/lib/wine/wine64}" "$@"
