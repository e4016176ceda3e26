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
# Tried with the LAMMPS of Debian 12 and 13; others may differ in the functions that a pair style overrides.
version=$(dpkg-query -W -f='${source:Upstream-Version}' liblammps-dev 2>/dev/null) || skip 'liblammps-dev is not installed'
case $version in
20220106* | 20250204*) ;;
*) skip "its version here is $version, not that of Debian 12 or 13" ;;
esac
sh examples/hosts/lammps/headers.sh "$build/headers" >"$build/headers.log" 2>&1 ||
  skip "its headers cannot be fetched ($build/headers.log)"

eigen=$(pkg-config --cflags-only-I eigen3 2>/dev/null | sed 's/-I/-isystem /')
# -O1: the tests wait for the compiler, not for the runs.
compile() {
  out=$1
  shift
  # shellcheck disable=SC2086  # a list of options
  mpicxx -std=c++17 -O1 -Wall -Wextra -Werror -DCONTACTLAWS_INLINE=inline -DLAMMPS_SMALLBIG -DOMPI_SKIP_MPICXX -Iinclude -Iexamples/hosts/lammps \
    ${eigen:--isystem /usr/include/eigen3} -isystem "$build/headers" -o "$build/$out" "$@" -llammps
}
# LAMMPS makes its sub-models in one function, from a list of headers. The driver has its own copy of that function, with ours in
# the list: the linker gives it to the unmodified library too.
sub_models=''
if [ -f "$build/headers/GRANULAR/granular_model.cpp" ]; then
  mkdir -p "$build/list"
  (cd "$build/headers/GRANULAR" && ls gran_sub_mod_*.h && echo gran_sub_mod_contactlaws.h) | sed 's/.*/#include "&"/' \
    > "$build/list/style_gran_sub_mod.h"
  cp "$build/headers/GRANULAR/granular_model.cpp" "$build/list/"
  sub_models="-I$build/list -isystem $build/headers/GRANULAR $build/list/granular_model.cpp"
fi
# shellcheck disable=SC2086
compile clmp examples/hosts/lammps/clmp.cpp examples/hosts/lammps/styles.cpp $sub_models
compile negated tests/hosts/lammps/negated.cpp
python3 tests/hosts/lammps/run.py "$build/clmp" "$build/negated"
