#!/bin/sh
# Builds the benchmarks and runs them, on a fresh Debian or Ubuntu too:
#
#   sh bench/run.sh               laws, batches, limits, the trade and the step of examples/dem: tables and charts in build/results
#   sh bench/run.sh --publish     the same, copied to bench/results/<processor>
#   sh bench/run.sh --peers       LAMMPS too, installed if it is not there, in turn with our own step
#
# Other arguments go to each Google benchmark, e.g. --benchmark_filter=DryHill.
set -eu
case ${1:-} in
-h | --help)
  sed -n '1d; /^#/!q; s/^# \{0,1\}//p' "$0"
  exit 0
  ;;
esac
cd "$(dirname "$0")/.."

publish=no
peers=no
for argument in "$@"; do
  shift
  case $argument in
    --publish) publish=yes ;;
    --peers) peers=yes ;;
    *) set -- "$@" "$argument" ;;
  esac
done

# shellcheck source=cmake/install_packages.sh
. cmake/install_packages.sh
install_packages g++ make cmake util-linux valgrind libeigen3-dev libbenchmark-dev libxsimd-dev \
  'libboost1.81-dev|libboost-dev' libtomlplusplus-dev libcli11-dev nlohmann-json3-dev python3-matplotlib
if [ $peers = yes ]; then install_packages lammps; fi

cmake --preset release -B build/bench -DCONTACTLAWS_BUILD_TESTS=OFF -DCONTACTLAWS_BUILD_EXAMPLES=OFF
cmake --build build/bench -j "$(nproc)"
results=build/results
mkdir -p $results

# One core for all: the last, as systems put their own work on the first.
on_one_core() { taskset -c "$(($(nproc) - 1))" "$@"; }

for benchmark in build/bench/bin/bench_*; do
  name=$(basename "$benchmark")
  case $name in
    bench_dem*) continue ;;  # it asks for all cores; peers/run.sh runs it
    bench_class5) kept=$results/class5_packing.json ;;  # a specimen, made by the first run: minutes
    bench_probe) kept=$results/probe_at_rest ;;
    *) kept= ;;
  esac
  echo "$name"
  on_one_core "$benchmark" ${kept:+"$kept"} --benchmark_out="$results/$name.json" --benchmark_repetitions=11 \
    --benchmark_min_time=0.02 --benchmark_report_aggregates_only=true "$@"
done

# A header and the rows of each instruction set.
for limits in build/bench/bin/limits_*; do on_one_core "$limits"; done | awk 'NR == 1 || !/^instructions,/' > $results/limits.csv

on_one_core build/bench/bin/trade bench/trade/laws/*.toml -o $results
build/bench/bin/record_grains $results/grains.csv
on_one_core build/bench/bin/trade --replay $results/grains.csv --law bench/trade/record/grains.toml | tee $results/replay_grains.txt
sh bench/instructions.sh $results

# The first Python that has matplotlib: Debian's package serves /usr/bin/python3, which need not be the first on the path.
for python in python3 /usr/bin/python3; do
  if "$python" -c 'import matplotlib' 2>/dev/null; then break; fi
done
"$python" bench/trade/chart.py $results

# A million grains need 3 GB.
on_one_core build/bench/bin/dem_scaling $results
"$python" bench/scaling/chart.py $results

if [ $peers = yes ]; then sh bench/peers/run.sh build/bench $results; fi

if [ $publish = yes ]; then
  processor=$(sed -n 's/^model name[^:]*: *//p' /proc/cpuinfo | head -n 1 | tr -cs '[:alnum:]\n' '-' | sed 's/^-//; s/-$//')
  folder=bench/results/${processor:-unknown-processor}
  mkdir -p "$folder"
  cp $results/dem_scaling.csv $results/dem_scaling.json $results/dem_scaling.png $results/limits.csv "$folder"
  cp $results/trade.csv $results/trade.json $results/trade_*.png $results/replay_grains.txt $results/instructions.csv "$folder"
  if [ $peers = yes ]; then cp $results/peers.csv "$folder"; fi
  for name in bench_laws bench_pohrt_popov bench_class5 bench_probe bench_batch_x86-64 bench_batch_x86-64-v3 bench_batch_x86-64-v4; do
    if [ ! -f "$results/$name.json" ]; then continue; fi
    # Without host, paths and dates.
    "$python" -c 'import json, sys
table = json.load(open(sys.argv[1]))
keep = ("name", "per_contact", "state_bytes", "sliding", "bandwidth")
rows = [{k: r[k] for k in keep if k in r} for r in table["benchmarks"] if r.get("aggregate_name") == "median"]
json.dump(rows, open(sys.argv[2], "w"), indent=1)' "$results/$name.json" "$folder/$name.json"
  done
  echo "published in $folder"
fi
