#!/bin/sh
# Fails on a source file that clang-format would change. Versions differ in taste: 14 decides.
set -eu
cd "$(dirname "$0")/.."

for tool in clang-format-14 clang-format ''; do
  if $tool --version 2>/dev/null | grep -q 'version 14\.'; then break; fi
done
if [ -z "$tool" ]; then
  echo "skipped: no clang-format 14"
  exit 77
fi
find include tests bench examples '(' -name '*.hpp' -o -name '*.cpp' -o -name '*.cu' ')' \
  -exec "$tool" --dry-run -Werror {} +
