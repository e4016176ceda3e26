#!/bin/sh
# Instructions per contact of each ready-made law's scalar kernel, as callgrind counts them: no clock, no noise.
#
#   sh bench/instructions.sh [directory]      writes instructions.csv there (default: build/results)
#
# Counted twice, at 20 and 40 passes over the 1024 contacts of contacts.hpp: the difference is the kernel's alone. Compiled
# with g++ -O3 for plain x86-64, which callgrind knows.
set -eu
cd "$(dirname "$0")/.."
results=${1:-build/results}
build=$(mktemp -d)
trap 'rm -rf "$build"' EXIT
mkdir -p "$results"

include=$(pkg-config --cflags-only-I eigen3 2>/dev/null || echo -I/usr/include/eigen3)
# shellcheck disable=SC2086  # a list of options
g++ -std=c++17 -O3 -Iinclude $include bench/instructions.cpp -o "$build/instructions"

count() {
  valgrind --tool=callgrind --callgrind-out-file=/dev/null "$build/instructions" "$1" "$2" 2>&1 |
    sed -n 's/.*Collected : \([0-9]*\).*/\1/p'
}
echo 'law,instructions_per_contact' > "$build/table"
for law in $("$build/instructions" list); do
  few=$(count "$law" 20)
  many=$(count "$law" 40)
  echo "$law,$(((many - few) / (20 * 1024)))" >> "$build/table"
done
mv "$build/table" "$results/instructions.csv"
cat "$results/instructions.csv"
