#!/bin/sh
# Builds the C face (examples/hosts/c), which reads law files too, for the tests of C, Fortran, Python and YADE:
#
#   sh tests/hosts/library.sh LIBRARY
set -eu
mkdir -p "$(dirname "$1")"
library=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
cd "$(dirname "$0")/../.."
eigen=$(pkg-config --cflags-only-I eigen3 2>/dev/null | sed 's/-I/-isystem /')
# shellcheck disable=SC2086  # a list of options
g++ -std=c++17 -O1 -DCONTACTLAWS_INLINE=inline -shared -fPIC -Iinclude -Iexamples ${eigen:--isystem /usr/include/eigen3} \
  examples/hosts/c/contactlaws.cpp examples/hosts/c/contactlaws_toml.cpp -o "$library"
