#!/bin/sh
# SPDX-License-Identifier: MIT
# Tries graze as it is installed on this machine, from folders of its own: the program, its page, its manual and
# completions, programs in C++ and C built by pkg-config and by CMake, and the Python module. Needs a compiler, CMake and
# pkg-config. debian/tests runs it, too.
# usage: packaging/try_installed.sh
set -eu
project=$(cd "$(dirname "$0")/.." && pwd)
consumer=$project/tests/package/consumer
scratch=$(mktemp -d)
server=''
finish() {
  [ -z "$server" ] || kill "$server" 2>/dev/null || true
  rm -rf "$scratch"
}
trap finish EXIT
cd "$scratch"

say() { printf '==> %s\n' "$*"; }
fail() { printf 'try_installed: %s\n' "$*" >&2 && exit 1; }

version=$(sed -n 's/^project(graze VERSION \([0-9.]*\) .*/\1/p' "$project/CMakeLists.txt")

say "the program"
[ "$(graze --version)" = "graze $version" ] || fail "graze --version prints '$(graze --version)', not 'graze $version'"
graze check "$project/data/workshop.json" --output report.txt
grep -q 'crate' report.txt || fail "the report of graze check names no crate"

say "its page, written and served"
graze view --html page.html "$project/data/workshop.json"
grep -q '"source": "workshop.json"' page.html || fail "the page has no scene"
graze view "$project/data/workshop.json" >address 2>/dev/null &
server=$!
while [ ! -s address ]; do
  kill -0 "$server" || fail "graze view ended before it served its page"
  sleep 0.1
done
python3 -c 'import sys, urllib.request; sys.stdout.buffer.write(urllib.request.urlopen(sys.argv[1]).read())' \
  "$(cat address)" >served.html
grep -q '"source": "workshop.json"' served.html || fail "the served page has no scene"

say "its manual and completions"
[ -f /usr/share/man/man1/graze.1.gz ] || fail "there is no manual page"
bash -c '. /usr/share/bash-completion/completions/graze && complete -p graze' >/dev/null
[ -f /usr/share/fish/vendor_completions.d/graze.fish ] || fail "there are no completions for fish"
[ -f /usr/share/zsh/vendor-completions/_graze ] || fail "there are no completions for zsh"

say "programs by pkg-config"
for package in graze graze_c; do
  [ "$(pkg-config --modversion $package)" = "$version" ] || fail "pkg-config has another version of $package"
done
sh "$consumer/pkg_config.sh" "$consumer/scene.cpp" graze ./scene
sh "$consumer/pkg_config.sh" "$consumer/distance.c" graze_c ./distance

say "programs by CMake"
for program in scene distance; do
  cmake -S "$consumer" -B "cmake-$program" -DSOURCE=installed "-DPROGRAM=$program" >cmake.txt || fail "$(cat cmake.txt)"
  cmake --build "cmake-$program" >cmake.txt || fail "$(cat cmake.txt)"
  "cmake-$program/$program"
done

say "the Python module"
/usr/bin/python3 "$project/bindings/python/examples/hulls.py"
/usr/bin/python3 -c "import graze, importlib.metadata as metadata; assert metadata.version('graze') == '$version'"
echo "try_installed: all of graze $version works"
