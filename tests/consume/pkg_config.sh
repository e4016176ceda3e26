#!/bin/sh
# Compiles and runs the consumer with pkg-config and a plain compiler call. Arguments: compiler, installation prefix.
set -eu
cd "$(dirname "$0")"

if ! command -v pkg-config >/dev/null; then
  echo "skipped: no pkg-config"
  exit 77
fi
compiler=$1
prefix=$2
PKG_CONFIG_PATH=$prefix/share/pkgconfig
export PKG_CONFIG_PATH
# shellcheck disable=SC2046  # a list of flags
"$compiler" -std=c++17 $(pkg-config --cflags contactlaws) main.cpp other.cpp -o "$prefix/pkg_config_consumer"
"$prefix/pkg_config_consumer"
