#!/bin/sh
# Runs clang-tidy over the headers, through a consumer's program that uses them. Arguments: compiler options that find Eigen.
set -eu
cd "$(dirname "$0")/../.."

# shellcheck source=tests/lint/clang_tool.sh
. tests/lint/clang_tool.sh
find_clang_tool clang-tidy
"$tool" --quiet tests/consume/main.cpp -- -std=c++17 -Iinclude "$@"
