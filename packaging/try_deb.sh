#!/bin/sh
# SPDX-License-Identifier: MIT
# Installs the packages that `./dev package deb` has built, tries them, removes them, and checks that nothing is left.
# It changes this machine, so run it as root in a container or another system of its own, such as a fresh Debian 12.
# usage: packaging/try_deb.sh [FOLDER]    the folder of the packages, build/package by default
set -eu
here=$(cd "$(dirname "$0")" && pwd)
folder=$(cd "${1:-$here/../build/package}" && pwd)
packages=$(for file in "$folder"/*.deb; do dpkg-deb --field "$file" Package; done | tr '\n' ' ')
files=$(mktemp)
export DEBIAN_FRONTEND=noninteractive

say() { printf '==> %s\n' "$*"; }
fail() { printf 'try_deb: %s\n' "$*" >&2 && exit 1; }

for package in $packages; do
  if dpkg -s "$package" >/dev/null 2>&1; then fail "$package is installed already; this needs a system without graze"; fi
done

say "installing $packages"
apt-get -q update
apt-get -q install -y --no-install-recommends "$folder"/*.deb
# shellcheck disable=SC2086  # several packages
dpkg -L $packages | grep -v '^/\.$' | sort -u >"$files"

say "installing what the trial needs"
apt-get -q install -y --no-install-recommends g++ cmake make pkg-config
sh "$here/try_installed.sh"

say "removing $packages"
# shellcheck disable=SC2086
apt-get -q purge -y $packages
left=$(
  while read -r path; do
    [ ! -e "$path" ] || dpkg -S "$path" >/dev/null 2>&1 || echo "$path"
  done <"$files"
  find /usr /etc /var -xdev -name '*graze*' -not -path '/var/lib/apt/*' -not -path '/var/cache/*' -not -path "$folder/*"
)
rm "$files"
[ -z "$left" ] || fail "these files are left after the removal: $left"
echo "try_deb: installed, tried and removed $packages"
