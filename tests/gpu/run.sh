#!/bin/sh
# Builds the test of batches on a GPU and runs it. Skipped without nvcc, and without a GPU, where only the comparison
# itself is tested.   run.sh OPTIONS_THAT_FIND_EIGEN...
set -eu
cd "$(dirname "$0")/../.."

# shellcheck source=tests/gpu/nvcc.sh
. tests/gpu/nvcc.sh
find_nvcc
build=$(mktemp -d)
trap 'rm -rf "$build"' EXIT

for_gpu -O2 -fmad=false "$@" tests/gpu/test_gpu.cu -o "$build/bits"
"$build/bits" --stand-in --small
"$build/bits"
for_gpu -O2 -DCONTACTLAWS_TEST_CONTRACTS "$@" tests/gpu/test_gpu.cu -o "$build/contracted"
"$build/contracted"
