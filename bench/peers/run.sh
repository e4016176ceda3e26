#!/bin/sh
# LAMMPS and examples/dem in turn on one core, on the same lattice: ns of processor time per contact and step, and the ratio.
# (Processor time, since other programs may use the core.)
#
#   sh bench/peers/run.sh BUILD_DIRECTORY [RESULTS_DIRECTORY]
#
# LAMMPS (GPL) runs as a separate program. Of the builds of bench_dem the fastest counts.
set -eu
cd "$(dirname "$0")/../.."
build=$1
results=${2:-build/results}
mkdir -p "$results"
core=$(($(nproc) - 1))
turns=5

# 30 x 30 x 29 contacts along each axis.
contacts=$((3 * 30 * 30 * 29))
lammps() {
  OMP_NUM_THREADS=1 taskset -c $core lmp -in bench/peers/lattice.lmp -log "$results/lammps.log" -screen none
  # The last "Loop time of SECONDS on 1 procs for STEPS steps with ATOMS atoms", and "PERCENT% CPU use".
  awk -v contacts=$contacts '/^Loop time of/ { clock = $4 / $9 / contacts * 1e9 } /% CPU use/ { ns = clock * $1 / 100 }
    END { printf "%.2f", ns }' "$results/lammps.log"
}
ours() {
  rm -f "$results"/bench_dem*.json
  for program in "$build"/bin/bench_dem*; do
    taskset -c $core "$program" --benchmark_filter='batch/threads:1/' --benchmark_min_time=1 \
      --benchmark_out="$results/$(basename "$program").json" >/dev/null 2>&1
  done
  python3 -c 'import json, os, sys
files = [f for f in sys.argv[1:] if os.path.getsize(f)]  # one whose instructions are missing here writes nothing
print("%.2f" % min(r["cpu_time"] / r["contacts"] for f in files for r in json.load(open(f))["benchmarks"]))' "$results"/bench_dem*.json
}

echo 'turn,lammps_ns,contactlaws_ns,ratio' > "$results/peers.csv.partial"
turn=1
while [ $turn -le $turns ]; do
  theirs=$(lammps)
  mine=$(ours)
  ratio=$(echo "$theirs $mine" | awk '{ printf "%.2f", $1 / $2 }')
  echo "$turn,$theirs,$mine,$ratio" >> "$results/peers.csv.partial"
  echo "turn $turn: LAMMPS $theirs ns, ours $mine ns per contact and step, ratio $ratio"
  turn=$((turn + 1))
done
mv "$results/peers.csv.partial" "$results/peers.csv"
python3 -c 'import csv, statistics, sys
rows = list(csv.DictReader(open(sys.argv[1])))
theirs, mine, ratio = (statistics.median(float(row[k]) for row in rows) for k in ("lammps_ns", "contactlaws_ns", "ratio"))
print("median: LAMMPS %.2f ns, ours %.2f ns per contact and step, ratio %.2f" % (theirs, mine, ratio))' "$results/peers.csv"
