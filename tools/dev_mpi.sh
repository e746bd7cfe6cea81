# SPDX-License-Identifier: MIT
# The command `mpi` of ./dev, which includes this file.

# run_mpi test [asan]
# The objects of the library are those of ./dev test: the preset mpi uses the folder of gcc, mpi-asan that of asan.
run_mpi() {
  [ "${1:-}" = test ] || wrong_usage "mpi takes the word test, but was given: $*"
  case ${2:-} in '' | asan) ;; *) wrong_usage "mpi test takes the word asan, but was given: ${*:2}" ;; esac
  [ $# -le 2 ] || wrong_usage "mpi test takes one word, but was given: ${*:2}"
  local preset=mpi packages=("${build_packages[@]}" "${test_packages[@]}" "${mpi_packages[@]}")
  if [ "${2:-}" = asan ]; then
    preset=mpi-asan
    packages+=("${asan_packages[@]}")
  fi
  need "build and run the tests with several ranks" "${packages[@]}"
  configure "$preset" "${packages[@]}"
  build "$preset"
  step "running the tests with several ranks"
  ctest --preset "$preset"
}
