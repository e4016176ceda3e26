#!/bin/sh
# Runs clang-tidy over the headers, through a consumer's program that uses them. Arguments: compiler options that find Eigen.
set -eu
cd "$(dirname "$0")/.."

if ! command -v clang-tidy >/dev/null; then
  echo "skipped: no clang-tidy"
  exit 77
fi
clang-tidy --quiet tests/consume/main.cpp -- -std=c++17 -Iinclude "$@"
