#!/bin/sh
# Fuzzes every law and every reader of files, with libFuzzer, ASan and UBSan:   sh tests/fuzz/run.sh [--runs N]
#
# N: kernel steps of all laws together (default 1e8; an input is a path of 64 steps, and the one step asked twice and the
# batches are not counted). A reader gets one file for every 2000 steps.
# Prints a JSON line a harness. A finding goes to build/fuzz/findings/: once it is understood, it moves to tests/fuzz/corpus/.
set -eu
cd "$(dirname "$0")/../.."
runs=100000000
if [ "${1:-}" = --runs ]; then runs=$2; fi

# shellcheck source=cmake/install_packages.sh
. cmake/install_packages.sh
install_packages make cmake libeigen3-dev catch2 'libboost1.81-dev|libboost-dev' libxsimd-dev nlohmann-json3-dev \
  libtomlplusplus-dev libcli11-dev clang libclang-rt-dev >&2

build=$PWD/build/fuzz
cmake --preset debug -B "$build" -DCMAKE_CXX_COMPILER=clang++ -DCONTACTLAWS_FUZZ=ON -DCONTACTLAWS_ALL_TESTS=ON -DCONTACTLAWS_BUILD_BENCH=OFF \
  -DCONTACTLAWS_BUILD_EXAMPLES=OFF >&2
cmake --build "$build" -j "$(nproc)" --target fuzz_laws fuzz_law_file fuzz_path_file fuzz_recording_file >&2

laws=$("$build/tests/fuzz/fuzz_laws" --law=none 2>/dev/null || true)
inputs=$((runs / 64 / $(echo "$laws" | wc -w) + 1))
{
  for law in $laws; do echo "$law fuzz_laws $inputs 64"; done
  for reader in law_file path_file recording_file; do echo "$reader fuzz_$reader $((runs / 2000 + 1)) 1"; done
} | ASAN_OPTIONS=quarantine_size_mb=4:malloc_context_size=4 xargs -P "$(nproc)" -n 4 sh tests/fuzz/harness.sh "$build"
