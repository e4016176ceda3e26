#!/bin/sh
# Fetches LAMMPS's C++ headers into a folder, from the source package of the installed release: liblammps-dev leaves out fmt/
# and some others; with them the sources of the package GRANULAR. Takes the machine's own Debian entry; changes nothing outside
# the folder.
#
#   sh headers.sh FOLDER        then compile with -isystem FOLDER
set -eu
if [ $# -ne 1 ]; then
  echo "headers.sh: name the folder for LAMMPS's headers" >&2
  exit 2
fi
mkdir -p "$1"
if [ -f "$1/pair.h" ]; then exit 0; fi
folder=$(cd "$1" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
mkdir -p lists/partial headers

# The entries of Debian itself, as sources: deb822 files and one-line files.
suite=$(. /etc/os-release && echo "$VERSION_CODENAME")
for file in /etc/apt/sources.list.d/*.sources; do
  if grep -qs "Suites:.*$suite" "$file"; then
    sed 's/^Types:.*/Types: deb-src/' "$file" > entries.sources
    break
  fi
done
if [ ! -f entries.sources ]; then
  sed -n "s/^deb \\(.*$suite .*\\)/deb-src \\1/p" /etc/apt/sources.list > entries.list
fi
entries=$(ls entries.*)
apt() {
  apt-get -qq -o Dir::Etc::sourcelist="$scratch/$entries" -o Dir::Etc::sourceparts=/dev/null \
    -o Dir::State::lists="$scratch/lists" -o Dir::Cache::pkgcache= -o Dir::Cache::srcpkgcache= "$@"
}
apt update
# A mirror may lack a file that is not needed here: what counts is the archive itself.
apt source --download-only --only-source "lammps=$(dpkg-query -W -f='${source:Version}' liblammps-dev)" || ls lammps_*.orig.tar.xz
tar xJf lammps_*.orig.tar.xz -C headers --strip-components=2 --wildcards '*/src/*.h' '*/src/GRANULAR/*.cpp'
cp -R headers/. "$folder"
