#!/bin/sh
# What a contact costs inside LAMMPS at scale: nanoseconds of processor time a contact and step, all in, and bytes a contact, for
# LAMMPS's own gran/hertz/history and our laws, in turn, on one and two ranks.
#
#   sh bench/hosts/scale.sh [--large] [BUILD_DIRECTORY]      --large: 8 million grains too, 5 GB
#
# Writes scale.csv there. Build clmp_native first: sh bench/hosts/lammps.sh
set -eu
cd "$(dirname "$0")/../.."
large=no
if [ "${1:-}" = --large ]; then
  large=yes
  shift
fi
build=${1:-build/hosts/lammps}
export OMP_NUM_THREADS=1 OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1

# measure RANKS N NZ STEPS STYLE: a line of the table. The ranks' largest memory, and the loop's time.
measure() {
  rm -f "$build"/memory.*
  seconds=$(mpirun --oversubscribe -np "$1" sh -c \
    '/usr/bin/time -f %M -o "$1/memory.$$" "$1/clmp_native" -in bench/hosts/lattice.lmp -log none -var n "$2" -var nz "$3" -var steps "$4" \
      -var style "$5" -var how packs' sh "$build" "$2" "$3" "$4" "$5" | awk '/^Loop time/ { seconds = $4 } END { print seconds }')
  kilobytes=$(cat "$build"/memory.* | awk '{ sum += $1 } END { print sum }')
  echo "$1 $2 $3 $4 $5 $seconds $kilobytes" | awk '{
    contacts = 3 * $2 * $2 * $3 - $2 * $2 - 2 * $2 * $3
    printf "%s,%d,%d,%s,%s,%.2f,%.0f\n", $5, $1, $2 * $2 * $3, $4, contacts, $6 * $1 / $4 / contacts * 1e9, $7 * 1024 / contacts }'
}
echo 'style,ranks,grains,steps,contacts,ns_per_contact_and_step,bytes_per_contact' | tee "$build/scale.csv"
for turn in 1 2 3; do
  for style in gran dry_hill rough_ballast; do
    measure 1 40 40 100 $style   # 64 000 grains
    measure 2 40 40 100 $style   # strong scaling
    measure 2 40 80 100 $style   # weak scaling
    if [ $turn = 1 ]; then measure 2 100 100 20 $style; fi
    if [ $turn = 1 ] && [ $large = yes ]; then measure 2 200 200 10 $style; fi
  done
done | tee -a "$build/scale.csv"
