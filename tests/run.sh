#!/bin/sh
# Builds and runs all tests, on a fresh Debian or Ubuntu too:  sh tests/run.sh
set -eu
cd "$(dirname "$0")/.."

# shellcheck source=cmake/install_packages.sh
. cmake/install_packages.sh
install_packages g++ make cmake pkg-config python3 python3-mpmath libeigen3-dev catch2 'libboost1.81-dev|libboost-dev' \
  libxsimd-dev nlohmann-json3-dev libtomlplusplus-dev libcli11-dev clang libclang-rt-dev \
  'clang-format-14|clang-format' 'clang-tidy-14|clang-tidy'

only_tests='-DCONTACTLAWS_BUILD_BENCH=OFF -DCONTACTLAWS_BUILD_EXAMPLES=OFF'
jobs=$(nproc)

# The other compiler carries the sanitizers: one build for both.
# shellcheck disable=SC2086  # a list of options
cmake --preset sanitize -B build/tests-sanitize -DCMAKE_CXX_COMPILER=clang++ $only_tests
cmake --build build/tests-sanitize -j "$jobs"
ctest --test-dir build/tests-sanitize -j "$jobs" --output-on-failure -L programs

# shellcheck disable=SC2086
cmake --preset release -B build/tests -DCMAKE_CXX_COMPILER=g++ $only_tests
cmake --build build/tests -j "$jobs"
ctest --test-dir build/tests -j "$jobs" --output-on-failure
