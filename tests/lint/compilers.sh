#!/bin/sh
# All headers, with packs, under every compiler that is installed: g++ 12 to 14, clang++ 14 to 19, plain and with -ffast-math,
# with Eigen and without.  sh tests/lint/compilers.sh INCLUDE_FLAGS_OF_EIGEN...
set -eu
cd "$(dirname "$0")/../.."
found=0
for compiler in g++-12 g++-13 g++-14 clang++-14 clang++-15 clang++-16 clang++-17 clang++-18 clang++-19; do
  command -v "$compiler" > /dev/null || continue
  found=$((found + 1))
  for options in '' -ffast-math -DCONTACTLAWS_NO_EIGEN; do
    # shellcheck disable=SC2086  # a list of options
    printf '#include "contactlaws/contactlaws.hpp"\n#include "contactlaws/scalars/xsimd.hpp"\n%s\n' \
      'void step(const contactlaws::ContactBatch<contactlaws::RoughBallast<float>>& b) { contactlaws::evaluate({}, b); }' |
      "$compiler" -std=c++17 -fsyntax-only -Wall -Wextra -Wpedantic -Wconversion -Werror $options -Iinclude "$@" -x c++ -
  done
done
echo "$found compilers"
if [ $found = 0 ]; then exit 77; fi
