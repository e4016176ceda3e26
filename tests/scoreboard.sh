#!/bin/sh
# Measures the figures of the scoreboard, on a fresh Debian or Ubuntu too:  sh tests/scoreboard.sh [--full] [--publish]
# Quick counts take some minutes; --full takes hours. Results: build/results/scoreboard.json and the table printed.
set -eu
cd "$(dirname "$0")/.."

# shellcheck source=cmake/install_packages.sh
. cmake/install_packages.sh
install_packages 'g++-12|g++' pkg-config python3 libeigen3-dev 'libboost1.81-dev|libboost-dev' libxsimd-dev nlohmann-json3-dev \
  catch2 binutils

exec python3 tests/scoreboard/collect.py "$@"
