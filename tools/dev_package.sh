# SPDX-License-Identifier: MIT
# The commands `package` and `release` of ./dev, which includes this file. All dates in packages are that of the last commit,
# so the same commit gives the same bytes.

package_names=(source deb wheel npm vcpkg conan)
package_folder=build/package
deb_folder=build/deb

project_version() { sed -n 's/^project(graze VERSION \([0-9.]*\) .*/\1/p' CMakeLists.txt; }

# Sets the date of everything that is packed to that of the commit.
use_date_of_commit() {
  git rev-parse --verify -q HEAD >/dev/null || fail "packages are made from a commit, but this is not a checkout by git"
  SOURCE_DATE_EPOCH=$(git log -1 --format=%ct)
  export SOURCE_DATE_EPOCH
  mkdir -p "$package_folder"
}

# pack ARCHIVE TAR_ARGUMENT...: writes a .tar.gz whose bytes depend only on names and contents.
pack() {
  local archive=$1
  shift
  tar --sort=name --mtime="@$SOURCE_DATE_EPOCH" --owner=0 --group=0 --numeric-owner --mode=go=rX,u+rw,a-s --create "$@" |
    gzip -9n >"$archive"
}

# The files of the commit.
package_source() {
  local archive
  if [ -n "$(git status --porcelain)" ]; then step "the source is that of the last commit, without later changes"; fi
  archive=$package_folder/graze-$(project_version).tar.gz
  git archive --format=tar --prefix="graze-$(project_version)/" HEAD | gzip -9n >"$archive"
  echo "the source: $archive"
}

# The page that `graze view` fills in, which needs packages of npm, and so is not built by the Debian package.
need_report_page() {
  [ -f build/web/viewer/report.html ] || run_web >&2
}

# Unpacks what a Debian source package is made of: the source, the page, and the folder debian.
prepare_deb() {
  local version
  version=$(project_version)
  rm -rf "$deb_folder"
  mkdir -p "$deb_folder/report"
  cp "$package_folder/graze-$version.tar.gz" "$deb_folder/graze_$version.orig.tar.gz"
  cp build/web/viewer/report.html "$deb_folder/report"
  pack "$deb_folder/graze_$version.orig-report.tar.gz" -C "$deb_folder" report
  tar -xzf "$deb_folder/graze_$version.orig.tar.gz" -C "$deb_folder"
  mv "$deb_folder/report" "$deb_folder/graze-$version/report"
  cp -R "$deb_folder/graze-$version/packaging/debian" "$deb_folder/graze-$version/debian"
}

# Builds the packages of Debian in build/deb, checks them, and copies them.
package_deb() {
  need "build the packages of Debian" "${build_packages[@]}" "${python_packages[@]}" "${deb_packages[@]}"
  need_report_page
  package_source
  prepare_deb
  # debhelper gives the build another home folder, where ccache would start anew.
  if has ccache; then
    export CMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER:-ccache} CCACHE_DIR=${CCACHE_DIR:-$(ccache --get-config cache_dir)}
  fi
  step "building $deb_folder (log: build/log/deb.txt)"
  (
    cd "$deb_folder/graze-$(project_version)"
    DEB_BUILD_OPTIONS="noautodbgsym parallel=$(jobs)" logged ../../log/deb.txt dpkg-buildpackage --no-sign
  ) || fail "building the packages of Debian failed, see above"
  step "checking them with lintian"
  # The first version of a package closes the request for it in Debian's tracker; there is none, because it is not uploaded.
  lintian --allow-root --suppress-tags initial-upload-closes-no-bugs --fail-on error,warning "$deb_folder"/*.changes ||
    fail "lintian finds faults, see above"
  rm -f "$package_folder"/*.deb "$package_folder"/graze_*
  cp "$deb_folder"/*.deb "$deb_folder"/*.dsc "$deb_folder"/*.tar.?z "$package_folder"
  echo "the packages of Debian: $package_folder/*.deb"
}

package_wheel() {
  # shellcheck source=tools/dev_python.sh
  . tools/dev_python.sh
  build_python >&2
  cp build/python/dist/graze-*.whl "$package_folder"
  echo "the wheel: $(ls "$package_folder"/graze-*.whl)"
}

package_npm() {
  need "pack the module for JavaScript" "${web_packages[@]}"
  build_wasm >&2
  (cd build/web/package && logged ../../log/npm-pack.txt npm pack --pack-destination "$root/$package_folder") ||
    fail "npm pack failed, see above"
  # The name of npm's archive is that of the source.
  mv "$package_folder/graze-$(project_version).tgz" "$package_folder/graze-$(project_version)-npm.tgz"
  echo "the npm package: $package_folder/graze-$(project_version)-npm.tgz"
}

# pack_recipe NAME FOLDER: packs a recipe with the source beside it, so that it needs no checkout.
pack_recipe() {
  local version scratch archive
  version=$(project_version)
  archive=$package_folder/graze-$version-$1.tar.gz
  scratch=build/$1
  package_source
  rm -rf "$scratch"
  mkdir -p "$scratch"
  git archive HEAD "packaging/$1" | tar -x -C "$scratch"
  cp "$package_folder/graze-$version.tar.gz" "$scratch/packaging/$2"
  pack "$archive" -C "$scratch/packaging" "$1"
  echo "the recipe for $1: $archive"
}

package_vcpkg() { pack_recipe vcpkg vcpkg/graze; }
package_conan() { pack_recipe conan conan; }

# run_package NAME
run_package() {
  if [ $# -ne 1 ] || [[ " ${package_names[*]} " != *" $1 "* ]]; then
    wrong_usage "package takes one of these words: ${package_names[*]}"
  fi
  use_date_of_commit
  "package_$1"
}

# run_release [check]: all packages and their checksums; check: builds them again, and compares.
run_release() {
  local name sums=build/package/SHA256SUMS
  case ${1:-} in
    '') ;;
    check)
      [ -f "$sums" ] || fail "there is no $sums to compare with" "Run ./dev release first."
      package_folder=build/package_again
      ;;
    *) wrong_usage "release takes the word check, but was given: $1" ;;
  esac
  [ $# -le 1 ] || wrong_usage "release takes one word, but was given: $*"
  [ -z "$(git status --porcelain)" ] || fail "there are changes without a commit; a release is made from a commit"
  rm -rf "$package_folder"
  use_date_of_commit
  run_web >&2  # the page, from the sources of the commit
  for name in "${package_names[@]}"; do "package_$name"; done
  if [ "${1:-}" = check ]; then
    (cd "$package_folder" && sha256sum --check "$root/$sums") || fail "the packages differ from those of the first build"
    echo "release: the same bytes as in build/package"
  else
    (cd "$package_folder" && sha256sum -- *) >build/SHA256SUMS
    mv build/SHA256SUMS "$sums"
    echo "the release: $(wc -l <"$sums") files and $sums"
  fi
}
