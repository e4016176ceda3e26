#!/bin/sh
# Builds and runs the tests, on a fresh Debian or Ubuntu too:  sh tests/run.sh [--all|--hosts]
#
# --all: what must pass before a change goes in. Also the examples' code, lints, each header alone, the fuzz corpus, packs as
# wide as this machine has them, consumers' projects, and the sanitizers of a second compiler.
# --hosts: the adapters of examples/hosts, each inside its host, and nothing else; 77 where a host cannot be had here.
set -eu
cd "$(dirname "$0")/.."
all=OFF
case ${1:-} in
'') ;;
--all) all=ON ;;
--hosts) ;;
*)
  echo "tests/run.sh: $1 is neither --all nor --hosts" >&2
  exit 2
  ;;
esac

# shellcheck source=cmake/install_packages.sh
. cmake/install_packages.sh
if [ "${1:-}" = --hosts ]; then
  if ! (install_packages lammps liblammps-dev mpi-default-bin mpi-default-dev g++ python3 libeigen3-dev libxsimd-dev); then
    echo 'LAMMPS: skipped, its packages cannot be installed here'
    exit 77
  fi
  sh tests/hosts/lammps.sh build/hosts/lammps
  exit
fi
install_packages g++ make cmake pkg-config python3 python3-mpmath libeigen3-dev catch2 'libboost1.81-dev|libboost-dev' \
  libxsimd-dev nlohmann-json3-dev
if [ $all = ON ]; then
  install_packages libtomlplusplus-dev libcli11-dev clang libclang-rt-dev 'clang-format-14|clang-format' 'clang-tidy-14|clang-tidy'
fi

# build FOLDER PRESET COMPILER LABEL: builds the tests and runs those with the label.
build() {
  cmake --preset "$2" -B "$1" -DCMAKE_CXX_COMPILER="$3" -DCONTACTLAWS_BUILD_BENCH=OFF -DCONTACTLAWS_BUILD_EXAMPLES=OFF \
    -DCONTACTLAWS_ALL_TESTS=$all
  cmake --build "$1" -j "$(nproc)"
  ctest --test-dir "$1" -j "$(nproc)" --output-on-failure -L "$4"
}

build build/tests release g++ '.'
if [ $all = ON ]; then build build/tests-sanitize sanitize clang++ programs; fi
