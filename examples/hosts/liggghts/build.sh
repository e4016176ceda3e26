#!/bin/sh
# SPDX-License-Identifier: MIT
# Builds `clliggghts` in the folder $1 (default: build here), on Debian's liggghts, libliggghts-dev and mpi-default-dev.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
headers=${LIGGGHTS_HEADERS:-/usr/include/liggghts}
mkdir -p "${1:-$here/build}"
cd "${1:-$here/build}"

# The lists of models, which the package of headers lacks.
for kind in surface normal tangential cohesion rolling; do
  macro=$(echo "${kind}_model(" | tr '[:lower:]' '[:upper:]')
  for header in "$headers/${kind}"_model_*.h; do
    if grep -q "^$macro" "$header"; then echo "#include \"$(basename "$header")\""; fi
  done >style_${kind}_model.h
done
echo '#include "normal_model_contactlaws.h"' >>style_normal_model.h

mpicxx -std=c++17 -DOMPI_SKIP_MPICXX -O2 -Wall -Wextra -I. -I"$here" -I"$here/../../../include" -isystem "$headers" \
  -isystem "${EIGEN:-/usr/include/eigen3}" "$here/main.cpp" -o clliggghts -lliggghts
