#!/bin/sh
# The library as one file: a program of two units builds with it alone, and forces have the bits that the headers give.
# Arguments: compiler, folder of xsimd, options that find Eigen...
set -eu
cd "$(dirname "$0")/../.."
compiler=$1
xsimd=$2
shift 2
build=$(mktemp -d)
trap 'rm -rf "$build"' EXIT

mkdir "$build/contactlaws"
python3 cmake/single_header.py > "$build/contactlaws/contactlaws.hpp"
"$compiler" -std=c++17 "-I$build" "$@" tests/consume/main.cpp tests/consume/other.cpp -o "$build/consumer"
"$build/consumer"

python3 cmake/single_header.py contactlaws/contactlaws.hpp contactlaws/batch.hpp contactlaws/rows.hpp \
  contactlaws/scalars/xsimd.hpp > "$build/one.hpp"
{ echo '#include "one.hpp"'; grep -v '#include "contactlaws/' tests/no_eigen/forces.cpp; } > "$build/pasted.cpp"
forces() {  # name, options and source
  "$compiler" -std=c++17 -O1 -ffp-contract=off -DCONTACTLAWS_INLINE=inline -DCONTACTLAWS_NO_EIGEN -idirafter "$xsimd" "$2" "$3" \
    -o "$build/$1"
  "$build/$1" > "$build/$1.txt"
}
forces headers -Iinclude tests/no_eigen/forces.cpp
forces pasted "-I$build" "$build/pasted.cpp"
cmp "$build/headers.txt" "$build/pasted.txt"
echo "$(wc -l < "$build/pasted.txt") forces are the same"
