#!/bin/sh
# What the compiler says of a wrong use of the library is a sentence.   messages.sh COMPILER [FLAGS...]
set -e
expect() {  # header, sentence, compiler and flags; the program after the include comes by standard input
  header=$1
  sentence=$2
  shift 2
  if { echo "#include \"contactlaws/$header\"" && cat; } |
    "$@" -Iinclude -fsyntax-only -x c++ - 2>&1 | grep -q "error.*$sentence"; then return; fi
  echo "missing: $sentence"
  exit 1
}
expect contactlaws.hpp 'needs C++17' "$@" -std=c++14 </dev/null
set -- "$@" -std=c++17

using='using namespace contactlaws;'
echo "$using ContactLaw<Hertz<double>, ShearForce<double>> law;" |
  expect contactlaws.hpp 'slot 2 of a ContactLaw is a damping law' "$@"
echo "$using ContactLaw<Hertz<double>, Dashpots<float>> law;" |
  expect contactlaws.hpp 'slot 2 of a ContactLaw is a damping law of the same scalar' "$@"
echo "$using ContactLaw<Hertz<double>, NoDashpots<double>, SuctionBridge<double>> law;" |
  expect contactlaws.hpp 'slot 3 of a ContactLaw is a shear law' "$@"
echo "$using ContactLaw<LinearSpring<double>, NoDashpots<double>, ShearForce<double>> law;" |
  expect contactlaws.hpp 'this shear stiffness needs a normal law with a contact radius' "$@"
echo "$using auto law = dry_hill<double>({0.4, 0.1});" |
  expect contactlaws.hpp 'no matching function' "$@"
expect verify/verify.hpp "verify needs exceptions" "$@" -fno-exceptions </dev/null
echo 'struct Law {}; contactlaws::verify::ForceUpdate update{Law{}};' |
  expect verify/verify.hpp "needs a nested State" "$@"
echo 'struct Law { struct State {}; }; contactlaws::verify::ForceUpdate update{Law{}};' |
  expect verify/verify.hpp "needs .verify::Interaction operator()" "$@"
