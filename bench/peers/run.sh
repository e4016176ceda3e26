#!/bin/sh
# LAMMPS and our own step, in turn on one core, over the same lattice: ns per contact and step, and the ratio.
#
#   sh bench/peers/run.sh BUILD_DIRECTORY [RESULTS_DIRECTORY]
#
# LAMMPS (GPL) runs as a program of its own. Of ours, bin/bench_dem* are asked, whose JSON has a counter `per_contact` [s].
set -eu
cd "$(dirname "$0")/../.."
build=$1
results=${2:-build/results}
mkdir -p "$results"
core=$(($(nproc) - 1))
turns=3

# 30 x 30 x 29 contacts along each axis.
contacts=$((3 * 30 * 30 * 29))
lammps() {
  OMP_NUM_THREADS=1 taskset -c $core lmp -in bench/peers/lattice.lmp -log "$results/lammps.log" -screen none
  # The last "Loop time of SECONDS on 1 procs for STEPS steps with ATOMS atoms".
  awk -v contacts=$contacts '/^Loop time of/ { ns = $4 / $9 / contacts * 1e9 } END { printf "%.2f", ns }' "$results/lammps.log"
}
# The fastest of the builds that this machine can run, one for each instruction set.
ours() {
  for program in "$build"/bin/bench_dem*; do
    if [ ! -x "$program" ]; then continue; fi
    taskset -c $core "$program" --benchmark_filter='threads:1/' --benchmark_out="$results/$(basename "$program").json" >/dev/null 2>&1
  done
  python3 -c 'import json, os, sys
files = [f for f in sys.argv[1:] if os.path.exists(f) and os.path.getsize(f)]
runs = [r["per_contact"] * 1e9 for f in files for r in json.load(open(f))["benchmarks"] if "per_contact" in r]
print("%.2f" % min(runs) if runs else "")' "$results"/bench_dem*.json
}

echo 'turn,lammps_ns,contactlaws_ns' > "$results/peers.csv.partial"
turn=1
while [ $turn -le $turns ]; do
  theirs=$(lammps)
  mine=$(ours)
  echo "$turn,$theirs,$mine" >> "$results/peers.csv.partial"
  echo "turn $turn: LAMMPS $theirs ns, ours ${mine:-not built} ns per contact and step"
  turn=$((turn + 1))
done
mv "$results/peers.csv.partial" "$results/peers.csv"
