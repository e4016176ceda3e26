#!/bin/sh
# Fails on a source file that clang-format would change.
set -eu
cd "$(dirname "$0")/../.."

# shellcheck source=tests/lint/clang_tool.sh
. tests/lint/clang_tool.sh
find_clang_tool clang-format
find include tests bench examples docs '(' -name '*.hpp' -o -name '*.cpp' -o -name '*.cu' ')' \
  -exec "$tool" --dry-run -Werror {} +
