// SPDX-License-Identifier: MIT
// Batches against the scalar kernel and against memory, all in one process: built once per instruction set, the name says
// which. Mix of the contacts: 5 % slide, 5 % are open, or all rest; of the law with a bridge all are wet.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <string>
#include <vector>

#include "passes.hpp"
#include "runs_here.hpp"
#include "triad.hpp"

namespace {

using namespace bench;

constexpr std::size_t in_cache = 1024;
constexpr std::size_t in_memory = 1'000'000;

void count(benchmark::State& run, std::size_t contacts, std::size_t bytes) {
  const double stepped = static_cast<double>(run.iterations()) * static_cast<double>(contacts);
  run.counters["per_contact"] = benchmark::Counter(stepped, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  run.counters["bandwidth"] = benchmark::Counter(stepped * static_cast<double>(bytes), benchmark::Counter::kIsRate,
                                                 benchmark::Counter::OneK::kIs1000);
}

/// Steps all contacts once an iteration.
template <template <class> class Pass, class Law>
void step_all(benchmark::State& run, const Law& law, std::size_t contacts, const Mix& mix) {
  Pass<Law> pass(make_contacts(contacts, mix));
  for (auto _ : run) {
    pass(law);
    benchmark::ClobberMemory();
  }
  count(run, contacts, Pass<Law>::bytes_per_contact);
}

void triad(benchmark::State& run) {
  Triad pass;
  for (auto _ : run) {
    pass();
    benchmark::ClobberMemory();
  }
  count(run, Triad::count, Triad::bytes);
}

template <class Shear, class Rolling = NoRolling<double>>
using With = ContactLaw<Hertz<double>, Dashpots<double>, Shear, Dry<double>, Rolling>;

template <class Law>
void add(const std::string& name, const Law& law, const Mix& mix) {
  const auto with = [&mix](auto measure, const auto& a_law, std::size_t contacts) {
    return [=](benchmark::State& run) { measure(run, a_law, contacts, mix); };
  };
  using Float = typename Law::template Rebind<float>;
  const Float in_float = law.template cast<float>();
  const auto put = [&name](const char* what, const auto& measure) {
    benchmark::RegisterBenchmark((std::string(CONTACTLAWS_BENCH_ARCH "/") + name + what).c_str(), measure);
  };
  put("/double/scalar/1024", with(step_all<OneByOne, Law>, law, in_cache));
  put("/double/batch/1024", with(step_all<Batched, Law>, law, in_cache));
  put("/double/batch/1e6", with(step_all<Batched, Law>, law, in_memory));
  put("/float/scalar/1024", with(step_all<OneByOne, Float>, in_float, in_cache));
  put("/float/batch/1024", with(step_all<Batched, Float>, in_float, in_cache));
  put("/float/batch/1e6", with(step_all<Batched, Float>, in_float, in_memory));
}

}  // namespace

int main(int argc, char** argv) {
  if (!runs_here()) {
    std::puts(CONTACTLAWS_BENCH_ARCH ": this machine lacks the instructions, skipped");
    return 0;
  }
  const Mix mix{0.05, 0.05, 1.0}, resting{0.0, 0.0, 1.0};
  add("SmoothHertz", granite<SmoothHertz<double>>(), mix);
  add("DryHill", granite<DryHill<double>>(), mix);
  add("DryHill/resting", granite<DryHill<double>>(), resting);
  add("DryHill/in_ratio", granite<DryHillInRatio>(), mix);
  add("DryHill/in_ratio/resting", granite<DryHillInRatio>(), resting);
  add("DryHill/turning", granite<DryHill<double>>(), {0.05, 0.05, 1.0, 1e-4});
  add("DryHill/turning/rotate", granite<With<ShearForce<double, Mindlin<double>, rotation::Rotate<double>>>>(),
      {0.05, 0.05, 1.0, 1e-4});
  add("Hill", granite<Hill<double>>(), mix);
  add("Hill/resting", granite<Hill<double>>(), resting);
  add("Jkr", granite<ContactLaw<Jkr<double>>>(), mix);
  add("Jkr+Dashpots+ShearForce", granite<ContactLaw<Jkr<double>, Dashpots<double>, ShearForce<double>>>(), mix);
  add("Dmt", granite<ContactLaw<Dmt<double>>>(), mix);
  add("PlasticGrains", granite<PlasticGrains<double>>(), mix);
  add("LinearHysteretic", granite<ContactLaw<LinearHysteretic<double>>>(), mix);
  add("DryHill/partial_slip", granite<With<MindlinDeresiewicz<double>>>(), mix);
  add("DryHill/rolling_spring", granite<With<ShearForce<double>, RollingSpring<double>>>(), mix);
  add("DryHill/roll_and_twist",
      granite<With<ShearForce<double>,
                   RollAndTwist<double, RollingSpringDashpot<double>, TwistingSpringDashpot<double>>>>(),
      mix);
  add("CohesivePowder", granite<CohesivePowder<double>>(), mix);
  add("WetGrains", granite<WetGrains<double>>(), mix);
  add("WetGrains/willett", granite<WetGrains<double, WillettClosed>>(), mix);
  add("WetGrains/rabinovich", granite<WetGrains<double, Rabinovich>>(), mix);
  add("RoughBallast", granite<RoughBallast<double>>(), mix);
  add("RoughBallast/resting", granite<RoughBallast<double>>(), resting);
  benchmark::RegisterBenchmark(CONTACTLAWS_BENCH_ARCH "/triad", triad);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
}
