# shellcheck shell=sh
# Sourced by what compiles for a GPU.
#
#   find_nvcc             skips the test where there is no nvcc
#   for_gpu OPTION...     nvcc as our own programs are compiled, for GPU_ARCH (sm_90 unless it is set)
#
# Warnings are errors, since a host function called on the device is only a warning. Not meant are
# 20012: Eigen puts host/device words on defaulted functions, where nvcc ignores them;
# 20208: pi is written to the digits of long double; 186: a loop over an empty array.

find_nvcc() {
  if ! command -v nvcc > /dev/null; then
    echo "skipped: no nvcc"
    exit 77
  fi
}
for_gpu() {
  nvcc -arch="${GPU_ARCH:-sm_90}" -std=c++17 --expt-relaxed-constexpr -diag-suppress 20012,20208,186 \
    -Werror all-warnings -Xcompiler -ffp-contract=off -Iinclude -I. "$@"
}
