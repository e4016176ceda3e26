#!/bin/sh
# Builds the examples and runs them, on a fresh Debian or Ubuntu too:  sh examples/run.sh
set -eu
cd "$(dirname "$0")/.."

# shellcheck source=cmake/install_packages.sh
. cmake/install_packages.sh
install_packages g++ make cmake libeigen3-dev python3-matplotlib

cmake --preset release -B build/examples -DCONTACTLAWS_BUILD_TESTS=OFF -DCONTACTLAWS_BUILD_BENCH=OFF
cmake --build build/examples -j "$(nproc)"
mkdir -p build/results

build/examples/bin/first_contact
