#!/bin/sh
# SPDX-License-Identifier: MIT
# Builds a program by what pkg-config tells about an installation, and runs it.
# usage: pkg_config.sh SOURCE PACKAGE PROGRAM
# PKG_CONFIG_PATH and LD_LIBRARY_PATH name an installation outside the system's folders; PKG_CONFIG, CC and CXX the tools.
set -eu
flags=$("${PKG_CONFIG:-pkg-config}" --cflags --libs "$2")
case $1 in
  *.c) compile="${CC:-cc} -std=c99" ;;
  *) compile="${CXX:-c++} -std=c++20" ;;
esac
# shellcheck disable=SC2086  # several words
$compile "$1" $flags -o "$3"
"$3"
