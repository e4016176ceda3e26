#!/bin/sh
# Forces have the same bits with each vector type: Eigen's, the library's own (CONTACTLAWS_NO_EIGEN, without Eigen's headers),
# and the library's own in a host that uses Eigen.   compare.sh COMPILER XSIMD_DIRECTORY OPTIONS_THAT_FIND_EIGEN...
set -eu
cd "$(dirname "$0")/../.."
compiler=$1
xsimd=$2
shift 2
build=$(mktemp -d)
trap 'rm -rf "$build"' EXIT

forces() {  # name of the program, options
  program=$build/$1
  shift
  "$compiler" -std=c++17 -O1 -ffp-contract=off -DCONTACTLAWS_INLINE=inline \
    -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wno-missing-braces -Werror \
    -Iinclude -idirafter "$xsimd" "$@" tests/no_eigen/forces.cpp -o "$program"
  "$program" > "$program.txt"
}
forces eigen "$@"
forces no_eigen -DCONTACTLAWS_NO_EIGEN
forces host_uses_eigen -DCONTACTLAWS_NO_EIGEN -DHOST_USES_EIGEN "$@"
cmp "$build/eigen.txt" "$build/no_eigen.txt"
cmp "$build/eigen.txt" "$build/host_uses_eigen.txt"
echo "$(wc -l < "$build/eigen.txt") forces are the same"
