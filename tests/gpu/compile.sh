#!/bin/sh
# Compiles, but does not run, kernels that step a law on a GPU. Arguments: compiler options that find Eigen.
set -eu
cd "$(dirname "$0")"

if ! command -v nvcc >/dev/null; then
  echo "skipped: no nvcc"
  exit 77
fi
# Warnings are errors, since a host function called on the device is only a warning. Not meant are
# 20012: Eigen puts host/device words on defaulted functions, where nvcc ignores them;
# 20208: pi is written to the digits of long double; 186: a loop over an empty array.
nvcc -std=c++17 --expt-relaxed-constexpr -diag-suppress 20012,20208,186 -Werror all-warnings \
  -I../../include "$@" -c kernel.cu -o /dev/null
