# SPDX-License-Identifier: MIT
# The command `fuzz` of ./dev, which includes this file.

# run_fuzz [NAME [OPTION...]]: failing inputs are kept in build/fuzz/found, inputs with new coverage in build/fuzz/inputs.
run_fuzz() {
  local packages=("${build_packages[@]}" "${test_packages[@]}" "${asan_packages[@]}") program name options=() failed=()
  need "build and run the fuzzers" "${packages[@]}"
  configure fuzz "${packages[@]}"
  build fuzz
  for program in build/fuzz/fuzz/*; do
    name=${program##*/}
    if [ $# -gt 0 ] && [ "$name" != "$1" ]; then continue; fi
    mkdir -p "build/fuzz/inputs/$name" build/fuzz/found
    options=(-max_total_time=60 "-artifact_prefix=build/fuzz/found/${name}_" -timeout=60)
    if [ -f "tests/fuzz/dictionaries/$name.dict" ]; then options+=("-dict=tests/fuzz/dictionaries/$name.dict"); fi
    options+=("${@:2}" "build/fuzz/inputs/$name")
    if [ -d "tests/fuzz/seeds/$name" ]; then options+=("tests/fuzz/seeds/$name"); fi
    if [ -d "tests/fuzz/found/$name" ]; then options+=("tests/fuzz/found/$name"); fi
    step "$program ${options[*]}"
    "$program" "${options[@]}" || failed+=("$name")
  done
  if [ ${#options[@]} -eq 0 ]; then wrong_usage "there is no fuzzer '$1'; they are: $(cd build/fuzz/fuzz && printf '%s ' *)"; fi
  [ ${#failed[@]} -eq 0 ] || fail "fuzz: failing inputs found by: ${failed[*]}" \
    "The inputs are in build/fuzz/found; pass one to the program as an argument to reproduce the failure."
  echo "fuzz: nothing found"
}
