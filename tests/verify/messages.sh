#!/bin/sh
# What the compiler says of a wrong use of the checks is a sentence.   messages.sh COMPILER [FLAGS...]
set -e
expect() {  # the sentence; the program after the include comes by standard input
  sentence=$1
  shift
  if { echo '#include "contactlaws/verify/verify.hpp"' && cat; } |
    "$@" -std=c++17 -Iinclude -fsyntax-only -x c++ - 2>&1 | grep -q "error.*$sentence"; then return; fi
  echo "missing: $sentence"
  exit 1
}
expect "verify needs exceptions" "$@" -fno-exceptions </dev/null
echo 'struct Law {}; contactlaws::verify::ForceUpdate update{Law{}};' | expect "needs a nested State" "$@"
echo 'struct Law { struct State {}; }; contactlaws::verify::ForceUpdate update{Law{}};' | expect "needs .verify::Interaction operator()" "$@"
