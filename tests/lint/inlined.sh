#!/bin/sh
# In the loop over packs everything is inlined: a call would store all vector registers and load them again. GCC leaves out
# functions that it has cloned for fewer arguments, which shows where several laws are compiled together.
#   sh tests/lint/inlined.sh COMPILER INCLUDE_FLAGS_OF_EIGEN...
set -eu
cd "$(dirname "$0")/../.."
case $(uname -m) in x86_64 | amd64) ;; *) exit 77 ;; esac
assembly=$(mktemp)
trap 'rm -f "$assembly"' EXIT
for law in DryHill Hill RoughBallast CohesivePowder WetGrains PlasticGrains; do
  law="contactlaws::$law<double>"
  echo "template void contactlaws::evaluate<$law>(const $law&, const ContactBatch<$law>&) noexcept;"
done |
  "$@" -std=c++17 -O3 -DNDEBUG -march=x86-64-v4 -w -Iinclude -include contactlaws/contactlaws.hpp \
    -include contactlaws/scalars/xsimd.hpp -S -o "$assembly" -x c++ -
# memcpy stores the last contacts, which do not fill a pack.
awk '/^[ \t]+call/ && !/memcpy/ { print "the loop over packs calls " $2; found = 1 } END { exit found }' "$assembly"
