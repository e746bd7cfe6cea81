# SPDX-License-Identifier: MIT
# The command `cross` of ./dev, which includes this file. Debian has no packages of the libraries for these platforms, so
# the presets take headers from the machine's packages and compile the rest from sources (cmake/graze_packages.cmake).
. tools/dev_sources.sh

# Builds for one platform and runs the tests.
cross_one() {
  local packages=("${build_packages[@]}" python3 googletest librapidcheck-dev libboost-dev)
  case $1 in
    arm64) packages+=(g++-aarch64-linux-gnu qemu-user) ;;
    windows) packages+=(g++-mingw-w64-x86-64-posix wine64) ;;
    libcxx) packages+=(clang lld libc++-dev libc++abi-dev) ;;
  esac
  need "build for $1" "${packages[@]}"
  fetch_source pugixml src/pugixml.cpp
  fetch_source rapidcheck include/rapidcheck.h
  fetch_source highway hwy/targets.cc
  configure "$1" "${packages[@]}"
  build "$1"
  step "running the tests of build/$1"
  ctest --preset "$1"
}

# run_cross arm64|windows|libcxx|all
run_cross() {
  local platform
  case "$*" in
    arm64 | windows | libcxx) cross_one "$1" ;;
    all) for platform in arm64 windows libcxx; do cross_one "$platform"; done ;;
    *) wrong_usage "cross takes one word: arm64, windows, libcxx or all" ;;
  esac
}
