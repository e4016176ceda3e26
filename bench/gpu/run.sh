#!/bin/sh
# The batches of scalars/cuda.hpp on this machine's GPU, in a few minutes: build, test, measure, check memory accesses.
#
#   sh bench/gpu/run.sh FOLDER      results and logs in FOLDER: gpu.json, stages.csv, STAGE.log
#
# A stage that fails does not stop those after it; the table at the end has every status. Eigen is taken from $EIGEN_DIR
# or the system; where there is none, the library's own vectors are. The card's settings are left as they are.
set -u
mkdir -p "${1:?usage: sh bench/gpu/run.sh FOLDER}"
results=$(cd "$1" && pwd)
cd "$(dirname "$0")/../.." || exit 1

PATH=$PATH:/usr/local/cuda/bin
for folder in /opt/nvidia/nsight-compute/*/; do PATH=$PATH:${folder%/}; done
# shellcheck source=tests/gpu/nvcc.sh
. tests/gpu/nvcc.sh
build=build/gpu
mkdir -p $build

vectors=-DCONTACTLAWS_NO_EIGEN
for folder in "${EIGEN_DIR:-}" "$(pkg-config --variable=includedir eigen3 2> /dev/null)/eigen3" /usr/include/eigen3; do
  if [ -f "$folder/Eigen/Core" ]; then
    vectors="-isystem $folder"
    break
  fi
done
echo "vectors: $vectors"

now() { date +%s; }
# note STAGE STATUS STARTED
note() {
  echo "$1,$2,$(($(now) - $3))" >> "$results/stages.csv"
  echo "== $1: status $2"
}
# stage LINES STAGE SECONDS_AT_MOST COMMAND...   its output goes to STAGE.log, whose last lines are shown
stage() {
  lines=$1
  name=$2
  limit=$3
  shift 3
  started=$(now)
  status=127
  if command -v "$1" > /dev/null; then
    timeout "$limit" "$@" > "$results/$name.log" 2>&1
    status=$?
  else
    echo "$1: not found" > "$results/$name.log"
  fi
  note "$name" $status "$started"
  if [ $status != 0 ] && [ "$lines" -lt 15 ]; then lines=15; fi
  tail -n "$lines" "$results/$name.log" | cut -c 1-160
}
# compile STAGE PROGRAM OPTIONS...
compile() {
  name=$1
  program=$2
  shift 2
  started=$(now)
  # shellcheck disable=SC2086  # two words
  for_gpu -O3 -Xptxas -v $vectors "$@" -o "$build/$program" > "$results/$name.log" 2>&1
  status=$?
  note "$name" $status "$started"
  if [ $status != 0 ]; then grep -m 5 -A 3 -i error "$results/$name.log" | cut -c 1-200; fi
}
card() {
  nvidia-smi --format=csv,noheader \
    --query-gpu=name,driver_version,memory.total,clocks.sm,clocks.max.sm,clocks.mem,temperature.gpu,power.draw
}

echo stage,status,seconds > "$results/stages.csv"
card | tee "$results/card.csv"

compile build_test_bits test_bits -fmad=false tests/gpu/test_gpu.cu &
compile build_test_contracted test_contracted -DCONTACTLAWS_TEST_CONTRACTS tests/gpu/test_gpu.cu &
compile build_bench bench_gpu bench/gpu/bench_gpu.cu &
wait

stage 32 test_bits 90 $build/test_bits &
stage 32 test_contracted 90 $build/test_contracted &
wait
stage 65 bench 120 $build/bench_gpu "$results/gpu.json"
card | tee -a "$results/card.csv"
for tool in memcheck racecheck initcheck; do
  stage 2 $tool 90 compute-sanitizer --tool $tool --error-exitcode 9 $build/test_bits --small &
done
wait
stage 1 ncu 60 ncu --clock-control none --kernel-name regex:step_contacts --launch-skip 2 --launch-count 1 \
  --section SpeedOfLight --section MemoryWorkloadAnalysis --section Occupancy --section LaunchStats \
  --section WarpStateStats $build/bench_gpu --one
grep -E 'Throughput|Registers|Achieved Occ|Duration|Local|Issued' "$results/ncu.log"
stage 0 sass 30 cuobjdump -sass $build/bench_gpu
gzip -f "$results/sass.log"

echo
cat "$results/stages.csv"
if grep -qv -e ',0,' -e '^stage' "$results/stages.csv"; then exit 1; fi
