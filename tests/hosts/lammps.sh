#!/bin/sh
# Builds LAMMPS's driver with our pair styles, against Debian's library, and runs their tests. 77: cannot be built here.
#
#   sh tests/hosts/lammps.sh BUILD_DIRECTORY
set -eu
cd "$(dirname "$0")/../.."
build=$1
mkdir -p "$build"

skip() {
  echo "LAMMPS: skipped, $1"
  exit 77
}
# The styles are written for the LAMMPS of Debian 12; others differ in the functions that a pair style overrides.
version=$(dpkg-query -W -f='${source:Upstream-Version}' liblammps0 2>/dev/null) || skip 'liblammps is not installed'
case $version in
20220106*) ;;
*) skip "its version here is $version, not Debian 12's" ;;
esac
sh examples/hosts/lammps/headers.sh "$build/headers" >"$build/headers.log" 2>&1 ||
  skip "its headers cannot be fetched ($build/headers.log)"

eigen=$(pkg-config --cflags-only-I eigen3 2>/dev/null | sed 's/-I/-isystem /')
compile() {
  out=$1
  shift
  # shellcheck disable=SC2086  # a list of options
  mpicxx -std=c++17 -O2 -Wall -Wextra -Werror -DLAMMPS_SMALLBIG -DOMPI_SKIP_MPICXX -Iinclude -Iexamples/hosts/lammps \
    ${eigen:--isystem /usr/include/eigen3} -isystem "$build/headers" -o "$build/$out" "$@" -llammps
}
compile clmp examples/hosts/lammps/clmp.cpp examples/hosts/lammps/styles.cpp
compile negated tests/hosts/lammps/negated.cpp
python3 tests/hosts/lammps/run.py "$build/clmp" "$build/negated"
