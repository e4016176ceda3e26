#!/bin/sh
# Processor time of LAMMPS's Pair with our styles over that with its own gran/hertz/history, in turn on one core: medians of five turns.
#
#   sh bench/hosts/lammps.sh [BUILD_DIRECTORY]
set -eu
cd "$(dirname "$0")/../.."
build=${1:-build/hosts/lammps}
mkdir -p "$build"
sh examples/hosts/lammps/headers.sh "$build/headers" >"$build/headers.log" 2>&1
mpicxx -std=c++17 -O3 -march=native -fno-math-errno -DLAMMPS_SMALLBIG -DOMPI_SKIP_MPICXX -Iinclude -isystem /usr/include/eigen3 \
  -isystem "$build/headers" -o "$build/clmp_native" examples/hosts/lammps/clmp.cpp examples/hosts/lammps/styles.cpp -llammps

pair_time() {
  OMP_NUM_THREADS=1 taskset -c $(($(nproc) - 1)) "$build/clmp_native" -in bench/hosts/lattice.lmp -log none \
    -var style "$1" -var how "$2" | tr -d '|' | awk '/^Pair / { seconds = $3 * $6 / 100 } END { print seconds }'
}
echo 'style,how,gran_seconds,seconds,ratio' > "$build/pair_time.csv"
for _ in 1 2 3 4 5; do
  for style in 'dry_hill scalar' 'dry_hill packs' 'rough_ballast packs' 'hill packs'; do
    theirs=$(pair_time gran -)
    ours=$(pair_time "${style% *}" "${style#* }")
    echo "$style $theirs $ours" | awk '{ printf "%s,%s,%s,%s,%.3f\n", $1, $2, $3, $4, $4 / $3 }' >> "$build/pair_time.csv"
  done
done
python3 - "$build/pair_time.csv" <<'PYTHON'
import csv, statistics, sys
ratios = {}
for row in csv.DictReader(open(sys.argv[1])):
    ratios.setdefault((row["style"], row["how"]), []).append(float(row["ratio"]))
for name, values in ratios.items():
    print("%s %s: %.2f of gran/hertz/history (%.2f to %.2f)" % (*name, statistics.median(values), min(values), max(values)))
PYTHON
