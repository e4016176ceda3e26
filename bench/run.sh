#!/ bin / sh
#Builds the benchmarks and runs them, on a fresh Debian or Ubuntu too : sh bench / run.sh
#Extra arguments go to each benchmark, e.g.--benchmark_filter = DryHill.
set -eu
cd "$(dirname "$0")/.."

#shellcheck source = cmake / install_packages.sh
. cmake/install_packages.sh
install_packages g++ make cmake libeigen3-dev libbenchmark-dev libxsimd-dev

cmake --preset release -B build/bench -DCONTACTLAWS_BUILD_TESTS=OFF -DCONTACTLAWS_BUILD_EXAMPLES=OFF
cmake --build build/bench -j "$(nproc)"
mkdir -p build/results

for benchmark in build/bench/bin/bench_*;
do
"$benchmark" --benchmark_out = "build/results/$(basename " $benchmark
                               ").json"
                               "$@" done
