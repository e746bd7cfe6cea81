# SPDX-License-Identifier: MIT
# The command `python` of ./dev, which includes this file. It uses the system's Python, which has Debian's NumPy; the
# first one in the PATH may be another.

python_bench_packages=(python3-scipy python3-shapely python3-open3d)
system_python=${GRAZE_PYTHON:-/usr/bin/python3}

# pack_wheel PRESET FOLDER: packs the module that a preset has built in build/PRESET, and prints the path of the wheel.
pack_wheel() {
  local name
  rm -f "$2"/graze-*.whl
  name=$("$system_python" -B bindings/python/graze_build.py "build/$1" "$2") || fail "packing the wheel failed, see above"
  echo "$2/$name"
}

# Builds build/python/dist/graze-*.whl, optimised.
build_python() {
  local wheel
  need "build the wheel for Python" "${build_packages[@]}" "${python_packages[@]}"
  configure python-release "${build_packages[@]}" "${python_packages[@]}"
  build python-release
  wheel=$(pack_wheel release build/python/dist)
  echo "the wheel: $PWD/$wheel"
}

# Runs the tests with the wheel of the preset python, whose library is that of ./dev test, in a fresh environment.
test_python() {
  local wheel environment=build/python/environment
  need "run the tests of Python" "${build_packages[@]}" "${test_packages[@]}" "${python_packages[@]}"
  configure python "${build_packages[@]}" "${test_packages[@]}" "${python_packages[@]}"
  build python
  wheel=$(pack_wheel gcc build/python/test)
  step "installing $wheel into $environment"
  rm -rf "$environment"
  logged build/log/python-environment.txt "$system_python" -m venv --system-site-packages "$environment" ||
    fail "creating $environment failed, see above"
  logged build/log/python-install.txt "$environment/bin/pip" install --no-index --no-deps "$wheel" ||
    fail "installing $wheel failed, see above"
  step "running the tests of Python"
  run_python_tests "$PWD/$environment/bin/python"
}

# Runs them from another folder, so that `import graze` finds the installed wheel. The last line is a summary.
run_python_tests() {
  local log=build/log/python-tests.txt all failed=0 status=0
  "$1" -B -m unittest discover -s bindings/python/tests -t bindings/python/tests 2>&1 | tee "$log" >&2 || status=$?
  [[ $(grep -E '^Ran [0-9]+ tests? in' "$log") =~ Ran\ ([0-9]+) ]] || fail "the tests of Python did not finish"
  all=${BASH_REMATCH[1]}
  if [ "$status" -ne 0 ]; then
    failed=$(grep -cE '^(FAIL|ERROR): ' "$log" || true)
    fail "python: $failed of $all tests failed"
  fi
  echo "python: $all tests passed"
}

# bench_python [OPTION...]: compares the wheel's module with C++ and with other libraries of Python, on the same arrays.
bench_python() {
  need "build the benchmarks of Python" "${build_packages[@]}" "${python_packages[@]}" "${python_bench_packages[@]}"
  configure python-release "${build_packages[@]}" "${python_packages[@]}"
  build python-bench
  step "bench/python/table.py $*"
  PYTHONPATH=build/release/python:build/release/bench/python "$system_python" -B bench/python/table.py "$@"
}

# run_python [test]
run_python() {
  case ${1:-} in '' | test) ;; *) wrong_usage "python takes the word test, but was given: $1" ;; esac
  [ $# -le 1 ] || wrong_usage "python takes one word, but was given: $*"
  if [ "${1:-}" = test ]; then test_python; else build_python; fi
}
