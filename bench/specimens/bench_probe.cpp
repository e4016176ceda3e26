// SPDX-License-Identifier: MIT
// What a step of the ballast probe costs in the paper's size (777 clumps of 22 pebbles, elasto-plastic law, at rest under 150 kPa),
// and its parts, on one core:
//
//   step            a whole step, in the breathing cylinder
//   contacts        gather, law and scatter of all contacts between pebbles
//   law             the law alone, on columns of as many contacts
//   clumps          motion of the clumps, places of pebbles with contacts, sums of their forces
//   neighbours      one search for neighbours
//   look            time step and unbalanced force, once in a hundred steps
//   membrane_step   a whole step, in the membrane of 12 600 spheres
//   membrane        the membrane's part of it; bonds: of that, bonds and pressure
//   triad           STREAM's triad, beside them
//
//   bench_probe FOLDER [Google Benchmark's options]
//
// packs and confines the grains first where FOLDER does not hold them (minutes), ten times as fast as the paper does.
// `per_contact` is time per contact that carries a force, walls included.
#include <cstdio>
#include <memory>

#include "ballast/probe/test.hpp"
#include "parts.hpp"

namespace {

using namespace probe;
using Loaded = Test<ElastoPlastic>;

Sample packed(const std::string& folder, const std::vector<dem::ClumpShape>& shapes) {
  SampleSize size;
  size.diameter = 0.3;
  size.height = 0.45;
  dem::CaseControl control(folder + "/packing.json", size);
  if (!control.has_result()) {
    std::puts("packing 777 clumps ...");
    control.finish(make_sample(size, shapes));
  }
  return control.result();
}

std::unique_ptr<Loaded> at_rest(const std::string& folder, const Sample& sample,
                                const std::vector<dem::ClumpShape>& shapes, bool membrane) {
  TestPlan plan;
  plan.settle_time = 0.03;
  plan.confine_time = 0.05;
  plan.unbalanced = 1e-7;  // as the probe begins: while grains still fall, neighbours are listed every hundred steps
  plan.membrane = membrane;
  auto test = std::make_unique<Loaded>(plan, shapes, sample);
  dem::CaseControl control(folder + (membrane ? "/membrane.json" : "/cylinder.json"), plan);
  if (!control.resume(test->specimen.scene, *test)) {
    std::printf("confining them in the %s ...\n", membrane ? "membrane" : "cylinder");
    while (test->state.phase < Phase::load) test->step();
    control.save(test->specimen.scene, *test);
  }
  for (int i = 0; i < 500; ++i) test->step();
  return test;
}

double touching(const Loaded& test) {
  const auto& scene = test.specimen.scene;
  double count = 0.0;
  for (std::size_t c = 0; c < scene.ball_contacts.size(); ++c)
    if (scene.ball_contact(c).response.normal_force > 0.0) count += 1.0;
  for (std::size_t c = 0; c < scene.wall_contacts.size(); ++c)
    if (scene.wall_contact(c).response.normal_force > 0.0) count += 1.0;
  return count;
}

void step(benchmark::State& run, Loaded& test) {
  for (auto _ : run) test.specimen.step();
}
void contacts(benchmark::State& run, Loaded& test) {
  auto list = test.specimen.scene.ball_contacts;
  const dem::BallMotion motion{test.specimen.scene.balls, test.specimen.scene.time_step};
  for (auto _ : run) list.evaluate(test.specimen.scene.ball_law, motion, 0, list.size());
  run.counters["listed"] = static_cast<double>(list.size());
}
void law(benchmark::State& run, Loaded& test) { bench::law_alone<ElastoPlastic, dem::Pack>(run, test.specimen.scene); }
void clumps(benchmark::State& run, Loaded& test) {
  auto& specimen = test.specimen;
  for (auto _ : run) {
    benchmark::DoNotOptimize(specimen.clumps.move(specimen.scene, 0.0, 0.0));  // the same step each time
    specimen.clumps.sum_forces(specimen.scene);
  }
}
void neighbours(benchmark::State& run, Loaded& test) {
  test.specimen.clumps.place_all(test.specimen.scene);
  for (auto _ : run) test.specimen.clumps.resume(test.specimen.scene);
}
void look(benchmark::State& run, Loaded& test) {
  for (auto _ : run) {
    benchmark::DoNotOptimize(dem::stable_time_step(test.specimen.scene, test.specimen.clumps, 1e7));
    benchmark::DoNotOptimize(test.unbalanced());
  }
}
void membrane(benchmark::State& run, Loaded& test) {
  auto& [scene, clumps, vessel, membrane] = test.specimen;
  for (auto _ : run)
    membrane->step(scene, clumps, vessel.pressure, scene.walls[Vessel::bottom], scene.walls[Vessel::top]);
}
void bonds(benchmark::State& run, Loaded& test) {
  for (auto _ : run) test.specimen.membrane->add_outer_forces(150e3);
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (argc != 2) {
    std::fputs("usage: bench_probe FOLDER [options]\n", stderr);
    return 2;
  }
  common::create_folder(argv[1]);
  const std::vector<dem::ClumpShape> shapes = unit_clumps();
  const Sample sample = packed(argv[1], shapes);
  const auto in_cylinder = at_rest(argv[1], sample, shapes, false),
             in_membrane = at_rest(argv[1], sample, shapes, true);
  const auto add = [](const char* name, void (*measure)(benchmark::State&, Loaded&), Loaded& test) {
    benchmark::RegisterBenchmark(name, [measure, &test, count = touching(test)](benchmark::State& run) {
      measure(run, test);
      bench::per_contact(run, count);
    })->Unit(benchmark::kMicrosecond);
  };
  add("step", step, *in_cylinder);
  add("contacts", contacts, *in_cylinder);
  add("law", law, *in_cylinder);
  add("clumps", clumps, *in_cylinder);
  add("neighbours", neighbours, *in_cylinder);
  add("look", look, *in_cylinder);
  add("membrane_step", step, *in_membrane);
  add("membrane", membrane, *in_membrane);
  add("bonds", bonds, *in_membrane);
  benchmark::RegisterBenchmark("triad", bench::triad)->Unit(benchmark::kMicrosecond);
  benchmark::RunSpecifiedBenchmarks();
}
