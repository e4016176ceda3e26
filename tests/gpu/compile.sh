#!/bin/sh
# Compiles, but does not run, kernels that step each ready-made law on a GPU, and the program of docs/gpu.md. The header
# tells a compiler without CUDA what it needs.   compile.sh OPTIONS_THAT_FIND_EIGEN...
set -eu
cd "$(dirname "$0")/../.."

# shellcheck source=tests/gpu/nvcc.sh
. tests/gpu/nvcc.sh
find_nvcc
build=$(mktemp -d)
trap 'rm -rf "$build"' EXIT

# shellcheck disable=SC2016  # not shell
sed -n '/^```cpp$/,/^```$/p' docs/gpu.md | sed '/^```/d' > "$build/example.cu"
grep -q evaluate "$build/example.cu"
for_gpu "$@" -c tests/gpu/kernel.cu -o /dev/null
for_gpu "$@" -c "$build/example.cu" -o /dev/null
for_gpu -DCONTACTLAWS_NO_EIGEN -c "$build/example.cu" -o /dev/null

echo '#include "contactlaws/scalars/cuda.hpp"' > "$build/host.cpp"
if "${CXX:-c++}" -std=c++17 -Iinclude "$@" -fsyntax-only "$build/host.cpp" 2> "$build/message"; then exit 1; fi
grep -q 'needs a CUDA compiler' "$build/message"
