// SPDX-License-Identifier: MIT
// A whole DEM step of examples/dem: check of the neighbour list, kinematics, law, sums of forces, motion. The scene is the
// lattice of bench/peers: 30 x 30 x 30 touching balls of granite with friction and dashpots. Built once per instruction set.
// `per_contact` is wall time times threads, per contact.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <random>

#include "../examples/dem/simulation.hpp"
#include "contactlaws/laws.hpp"
#include "contacts.hpp"
#include "runs_here.hpp"

namespace {

using namespace contactlaws;
using dem::Vec3;

template <class Pack>
void step(benchmark::State& run) {
  const ElasticMaterial<double> granite{29e9, 0.15, 2650.0};
  const double radius = 5e-3, spacing = 2.0 * radius - 2e-6;  // [m]
  const int edge = 30;
  dem::Simulation<DryHill<double>, DryHill<double>, Pack> scene(bench::granite<DryHill<double>>());
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> shake(-1e-6, 1e-6);
  for (int z = 0; z < edge; ++z)
    for (int y = 0; y < edge; ++y)
      for (int x = 0; x < edge; ++x)
        scene.add(dem::Ball{sphere(granite, radius), (Vec3(x, y, z) + Vec3::Constant(0.5)) * spacing,
                            Vec3(shake(engine), shake(engine), shake(engine))});
  scene.time_step = 1e-8;
  scene.threads = static_cast<int>(run.range(0));
  scene.step();
  for (auto _ : run) scene.step();
  const double contacts = static_cast<double>(scene.ball_contacts.size());
  run.counters["contacts"] = contacts;
  run.counters["per_contact"] =
      benchmark::Counter(static_cast<double>(run.iterations()) * contacts / static_cast<double>(scene.threads),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

}  // namespace

int main(int argc, char** argv) {
  if (!bench::runs_here()) {
    std::puts(CONTACTLAWS_BENCH_ARCH ": this machine lacks the instructions, skipped");
    return 0;
  }
  for (const int threads : {1, 2}) {
    const auto add = [threads](const char* name, void (*measure)(benchmark::State&)) {
      benchmark::RegisterBenchmark(name, measure)->Arg(threads)->ArgName("threads")->UseRealTime();
    };
    add(CONTACTLAWS_BENCH_ARCH "/dem/scalar", step<double>);
    add(CONTACTLAWS_BENCH_ARCH "/dem/batch", step<dem::Pack>);
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
}
