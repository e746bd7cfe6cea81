# SPDX-License-Identifier: MIT
# Sources of libraries that have no package for the compiler, for the commands `web` and `cross` of ./dev, which include
# this file.

# fetch_source PACKAGE FILE: unpacks the sources of a Debian package, one of which is FILE, into build/PACKAGE.
fetch_source() {
  local package=$1 folder=build/$1 file
  [ ! -f "$folder/$2" ] || return 0
  has apt-get || fail "$folder/$2 is missing, and there is no apt-get to fetch it" \
    "Put the sources of $package into $PWD/$folder."
  step "fetching the sources of $package with apt-get (log: build/log/$package.txt)"
  # Uses its own apt state, so that root is not needed and the machine's package lists do not change.
  mkdir -p "$folder"/apt/{lists/partial,archives/partial,sources}
  for file in /etc/apt/sources.list /etc/apt/sources.list.d/{debian,ubuntu}.sources; do
    [ -f "$file" ] || continue
    sed 's/^deb /deb-src /; s/^Types: .*/Types: deb-src/' "$file" >"$folder/apt/sources/${file##*/}"
  done
  (
    cd "$folder"
    options=(-q -o "Dir::Etc::sourcelist=/dev/null" -o "Dir::Etc::sourceparts=$PWD/apt/sources" -o "Dir::State::lists=$PWD/apt/lists"
      -o "Dir::Cache::archives=$PWD/apt/archives" -o "Dir::Cache::pkgcache=" -o "Dir::Cache::srcpkgcache=")
    if [ -f apt/sources/sources.list ]; then mv apt/sources/sources.list apt/sources/machine.list; fi
    logged "../log/$package.txt" apt-get "${options[@]}" update
    logged "../log/$package.txt" apt-get "${options[@]}" source --download-only "$package"
    tar -xf "${package}"_*.orig.tar.?z --strip-components=1
  ) || fail "the sources of $package could not be fetched, see above" "Put them into $PWD/$folder."
  [ -f "$folder/$2" ] || fail "the sources of $package lack $2"
}

# The sources of pugixml, in GRAZE_PUGIXML_SOURCE or fetched.
fetch_pugixml() {
  if [ -z "${GRAZE_PUGIXML_SOURCE:-}" ]; then
    fetch_source pugixml src/pugixml.cpp
    export GRAZE_PUGIXML_SOURCE=$PWD/build/pugixml/src
  fi
}
