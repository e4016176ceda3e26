# shellcheck shell=sh
# Sourced by the tests that run clang-format and clang-tidy.
#
#   find_clang_tool NAME    sets `tool` to version 14 of it, or skips the test.
#
# Each version has its own taste and checks; one has to decide, so that a file that passes here passes everywhere.

find_clang_tool() {
  for tool in "$1-14" "$1"; do
    if "$tool" --version 2>/dev/null | grep -q 'version 14\.'; then return; fi
  done
  echo "skipped: no $1 14"
  exit 77
}
