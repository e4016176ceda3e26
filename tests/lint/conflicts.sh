#!/bin/sh
# No file holds the marks of a merge that was left unfinished.
set -eu
cd "$(dirname "$0")/../.."
if grep -rnE '^(<<<<<<<|>>>>>>>) ' --exclude-dir=.git --exclude-dir=build .; then
  echo "the lines above are marks of an unfinished merge" >&2
  exit 1
fi
