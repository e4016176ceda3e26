// SPDX-License-Identifier: MIT
// What a step of the broad Class 5 specimen costs (13 500 grains of 4.8 to 23 mm, dry hill law, at rest under 150 kPa), and its
// parts, on one core:
//
//   step            a whole step, grains in spatial order
//   step_shuffled   the same with the grains in random order
//   contacts        gather, law and scatter of all contacts between grains
//   law             the law alone, on columns of as many contacts
//   neighbours      one search for neighbours; `per_step`: over the steps between two searches while the specimen is strained
//   look            time step, energy and stiffness of the walls, once in a hundred steps
//   triad           STREAM's triad, beside them
//
//   bench_class5 PACKING.json [Google Benchmark's options]
//
// packs the grains first where the file is not there (minutes), and keeps them in it. `per_contact` is time per listed contact.
#include <benchmark/benchmark.h>

#include <cstdio>

#include "memo/class5/packing.hpp"
#include "parts.hpp"

namespace {

using namespace class5;

Packing packed(const std::string& file) {
  PackingSettings settings;
  settings.grading = "broad";
  dem::CaseControl control(file, settings.to_json());
  if (!control.has_result()) {
    std::puts("packing 13 500 grains ...");
    control.finish(pack(settings, control));
  }
  return control.result();
}

/// The packing under the hill law, at rest.
std::unique_ptr<Vessel<DryLaw>> at_rest(Packing packing, bool shuffled) {
  if (shuffled) {
    std::mt19937_64 engine(1);
    std::shuffle(packing.grains.begin(), packing.grains.end(), engine);
  } else {
    dem::sort_in_space(packing.grains);
  }
  auto vessel = std::make_unique<Vessel<DryLaw>>(hill_law(), packing.size, packing.grains);
  for (int step = 0; step < 1000; ++step) {
    if (vessel->looks()) vessel->look();
    for (const std::size_t wall : {vessel->bottom, vessel->top, vessel->side}) vessel->hold_pressure(wall);
    vessel->step();
  }
  return vessel;
}

double listed(const Vessel<DryLaw>& vessel) {
  return static_cast<double>(vessel.scene.ball_contacts.size() + vessel.scene.wall_contacts.size());
}

void step(benchmark::State& run, Vessel<DryLaw>& vessel) {
  for (auto _ : run) {
    for (const std::size_t wall : {vessel.bottom, vessel.top, vessel.side}) vessel.hold_pressure(wall);
    vessel.step();
  }
  bench::per_contact(run, listed(vessel));
}

void contacts(benchmark::State& run, Vessel<DryLaw>& vessel) {
  auto list = vessel.scene.ball_contacts;
  const dem::BallMotion motion{vessel.scene.balls, vessel.scene.time_step};
  for (auto _ : run) list.evaluate(vessel.scene.ball_law, motion, 0, list.size());
  bench::per_contact(run, static_cast<double>(list.size()));
}

void law(benchmark::State& run, Vessel<DryLaw>& vessel) {
  bench::law_alone<DryLaw, dem::Pack>(run, vessel.scene);
  bench::per_contact(run, static_cast<double>(vessel.scene.ball_contacts.size()));
}

void neighbours(benchmark::State& run, Vessel<DryLaw>& vessel) {
  auto scene = vessel.scene;
  for (auto _ : run) scene.resume();
  // Two grains approach by the strain times their distance; a list lasts until a grain has moved half its margin.
  const double margin = scene.skin * *std::min_element(scene.balls.radius.begin(), scene.balls.radius.end());
  const double speed = 0.1 * vessel.size().height / 2.0;  // of a platen, at 0.1/s
  run.counters["steps_of_a_list"] = margin / 2.0 / speed / scene.time_step;
  bench::per_contact(run, listed(vessel));
}

void look(benchmark::State& run, Vessel<DryLaw>& vessel) {
  for (auto _ : run) vessel.look();
  bench::per_contact(run, listed(vessel));
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (argc != 2) {
    std::fputs("usage: bench_class5 PACKING.json [options]\n", stderr);
    return 2;
  }
  const Packing packing = packed(argv[1]);
  const auto in_order = at_rest(packing, false), in_disorder = at_rest(packing, true);
  const auto add = [](const char* name, void (*measure)(benchmark::State&, Vessel<DryLaw>&), Vessel<DryLaw>& vessel) {
    benchmark::RegisterBenchmark(name, [measure, &vessel](benchmark::State& run) {
      measure(run, vessel);
    })->Unit(benchmark::kMicrosecond);
  };
  add("step", step, *in_order);
  add("step_shuffled", step, *in_disorder);
  add("contacts", contacts, *in_order);
  add("law", law, *in_order);
  add("neighbours", neighbours, *in_order);
  add("look", look, *in_order);
  benchmark::RegisterBenchmark("triad", bench::triad)->Unit(benchmark::kMicrosecond);
  benchmark::RunSpecifiedBenchmarks();
}
