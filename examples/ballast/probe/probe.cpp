// SPDX-License-Identifier: MIT
// The small-strain probes on railway ballast of Tolomeo & McDowell (2022), sections 3 and 4: one sample of clumps, confined at
// 150 kPa, loaded axially to 0.1 % and unloaded, under Hertz's law and two laws of rough contact: elastic and elasto-plastic.
//
//   probe [FOLDER] [--full] [--threads N]     writes probe.json, probe.csv and the curves (default: build/results)
//
// By default about 120 grains in a cylinder whose radius the pressure moves; --full: the paper's size, some 750 grains in a
// membrane of 12 600 bonded spheres (hours). Ctrl-C stops it; the same command goes on from
// there: the state of each case is FOLDER/probe/NAME.json.
//
// Exit status: 0 if every number is in its band, 1 if one is not, 2 on a fault, 130 after Ctrl-C.
#include <algorithm>
#include <string>
#include <thread>
#include <vector>

#include "common/output_file.hpp"
#include "common/program.hpp"
#include "results.hpp"
#include "test.hpp"

namespace probe {
namespace {

struct Options {
  std::string folder = "build/results";
  SampleSize size;
  TestPlan plan;
  bool full = false;
  int threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
};

/// The confinement times whose onsets of degradation are compared, beside that of the plan, and the names of their cases [s].
std::vector<std::pair<std::string, double>> other_confinements(const Options& options) {
  const double base = options.plan.confine_time;
  if (options.full) return {{"confined_4_times_slower", 4.0 * base}, {"confined_10_times_slower", 10.0 * base}};
  return {{"confined_10_times_faster", base / 10.0}, {"confined_4_times_faster", base / 4.0}};
}

template <class Law>
dem::Case test_case(const std::string& name, const TestPlan& plan, double work, const Options& options,
                    const Sample& sample, const std::vector<dem::ClumpShape>& shapes) {
  const nlohmann::json settings{{"law", law_name<Law>()}, {"plan", plan}, {"sample", options.size}};
  return {name, work, settings,
          [=](dem::CaseControl& control) { return nlohmann::json(Test<Law>(plan, shapes, sample).run(control)); }};
}

std::vector<dem::Case> cases_of(const Options& options, const Sample& sample,
                                const std::vector<dem::ClumpShape>& shapes) {
  TestPlan noisy = options.plan;
  noisy.noise_levels = {1e-4, 1e-5, 1e-6};
  std::vector<dem::Case> cases{test_case<ElastoPlastic>("elasto_plastic", options.plan, 1.0, options, sample, shapes),
                               test_case<Hertz>("hertz", options.plan, 1.0, options, sample, shapes),
                               test_case<Elastic>("elastic", noisy, 1.0, options, sample, shapes)};
  for (const auto& [name, time] : other_confinements(options)) {
    TestPlan plan = options.plan;
    plan.confine_time = time;
    plan.most_strain = std::min(5e-5, plan.most_strain);  // beyond the onset
    plan.unloads = false;
    cases.push_back(test_case<ElastoPlastic>(name, plan, 0.3 + 0.5 * time, options, sample, shapes));
  }
  return cases;
}

/// Names of the elasto-plastic tests, the fastest confinement first.
std::vector<std::string> by_confinement(const Options& options) {
  std::vector<std::string> names;
  for (const auto& [name, time] : other_confinements(options)) names.push_back(name);
  names.insert(options.full ? names.begin() : names.end(), "elasto_plastic");
  return names;
}

void write_pebbles(std::ostream& out, const Sample& sample, const std::vector<dem::ClumpShape>& shapes) {
  common::Table table{"grain", "shape", "x_m", "y_m", "z_m", "radius_m"};
  for (std::size_t i = 0; i < sample.grains.size(); ++i) {
    const Grain& grain = sample.grains[i];
    for (const dem::Pebble& pebble : shapes[grain.shape].scaled(grain.size).pebbles) {
      const Vec3 place = grain.position + grain.orientation * pebble.centre;
      table.add(
          {static_cast<double>(i), static_cast<double>(grain.shape), place.x(), place.y(), place.z(), pebble.radius});
    }
  }
  table.write_csv(out);
}

void write_grains(std::ostream& out, const Sample& sample, const std::vector<dem::ClumpShape>& shapes) {
  common::Table table{"grain", "shape", "sieve_m", "volume_m3", "longest_m", "intermediate_m", "shortest_m"};
  for (std::size_t i = 0; i < sample.grains.size(); ++i) {
    const Grain& grain = sample.grains[i];
    const Vec3 extent = extents(shapes[grain.shape]) * grain.size;
    table.add({static_cast<double>(i), static_cast<double>(grain.shape), grain.size,
               shapes[grain.shape].volume * std::pow(grain.size, 3), extent.x(), extent.y(), extent.z()});
  }
  table.write_csv(out);
}

void write_curves(common::OutputFolder& folder, const Tests& tests, const Options& options) {
  for (const auto& [name, test] : tests) {
    table_of(test.load).write_csv(folder.file("probe_" + name + "_load.csv"));
    if (!test.unload.empty()) table_of(test.unload).write_csv(folder.file("probe_" + name + "_unload.csv"));
  }
  common::Table onsets{"confine_time_s", "onset_strain", "force_over_largest", "E0_Pa"};
  const auto add = [&](const std::string& name, double time) {
    const TestState& test = tests.at(name);
    onsets.add({time, onset(test.load),
                mean_over(test.load, 1e-9, 1e-8, [](const Point& p) { return p.force_over_largest; }),
                initial_modulus(test.load)});
  };
  for (const auto& [name, time] : other_confinements(options)) add(name, time);
  add("elasto_plastic", options.plan.confine_time);
  onsets.write_csv(folder.file("probe_onset.csv"));
  common::Table noises{"unbalanced", "noise"};
  for (const NoisyProbe& one : tests.at("elastic").noise) noises.add({one.unbalanced, noise(one.load)});
  noises.add({tests.at("elastic").rest_unbalanced, noise(tests.at("elastic").load)});
  noises.write_csv(folder.file("probe_noise.csv"));
}

/// The sample, packed in two phases that go on from where they were stopped.
Sample packed(const Options& options, const std::string& states, const std::vector<dem::ClumpShape>& shapes) {
  const auto run_phase = [&](const char* name, const std::function<Sample(dem::CaseControl&)>& phase) {
    const dem::Case one{name, 1.0, options.size,
                        [&](dem::CaseControl& control) { return nlohmann::json(phase(control)); }};
    return dem::run_cases("probe, " + std::string(name), states, {one}, 1).front().get<Sample>();
  };
  const Sample shrunk =
      run_phase("packing_shrink", [&](dem::CaseControl& control) { return shrink(options.size, shapes, control); });
  return run_phase("packing_relax", [&](dem::CaseControl& control) { return relax(shrunk, shapes, control); });
}

int run(const Options& options) {
  const common::InterruptGuard guard;
  common::OutputFolder folder(options.folder);
  const std::string states = options.folder + "/probe";
  const std::vector<dem::ClumpShape> shapes = unit_clumps();
  const Sample sample = packed(options, states, shapes);
  const std::vector<dem::Case> cases = cases_of(options, sample, shapes);
  const std::vector<nlohmann::json> results = dem::run_cases("probe", states, cases, options.threads);
  Tests tests;
  for (std::size_t i = 0; i < cases.size(); ++i) tests[cases[i].name] = results[i].get<TestState>();

  const common::BandedNumbers numbers = banded_numbers(tests, by_confinement(options), options.full);
  write_json(folder.file("probe.json"), numbers);
  write_csv(folder.file("probe.csv"), numbers);
  write_curves(folder, tests, options);
  write_pebbles(folder.file("probe_pebbles.csv"), tests.at("elasto_plastic").at_rest, shapes);
  write_grains(folder.file("probe_grains.csv"), sample, shapes);
  folder.complete();
  print("Ballast probe (Tolomeo & McDowell 2022)", numbers);
  return verdict(numbers);
}

}  // namespace
}  // namespace probe

int main(int argc, char** argv) {
  CLI::App app("Runs the small-strain probes on railway ballast (Tolomeo & McDowell 2022).", "probe");
  probe::Options options;
  app.add_option("FOLDER", options.folder, "where to write the results (default: build/results)");
  app.add_flag("--full", options.full,
               "the paper's size: some 750 grains in 300 x 450 mm, in a membrane of 12 600 spheres (hours)");
  app.add_option("--threads", options.threads, "cases that run at the same time (default: one per core)")
      ->check(CLI::Range(1, 1024));
  app.add_option("--seed", options.size.seed, "of the sample (default: 1)")->check(CLI::Range(1, 1000000000));
  app.add_option("--diameter", options.size.diameter,
                 "of the vessel [m]; its height is 1.5 times as large (default: 0.16)")
      ->check(CLI::Range(0.12, 0.3));
  app.add_flag("--membrane", options.plan.membrane, "a flexible membrane in the place of the breathing cylinder");
  app.add_flag("--tilt", options.plan.tilts, "a top platen that may tilt (always with --full)");
  app.add_option("--confine", options.plan.confine_time, "time in which the pressure grows [s] (default: 0.5)")
      ->check(CLI::Range(0.01, 10.0));
  app.add_option("--safety", options.plan.safety, "share of the stable step (default: 0.6)")
      ->check(CLI::Range(0.05, 0.8));
  return common::run_program(app, argc, argv, [&options] {
    if (options.full) {
      options.size.diameter = 0.3;
      options.plan.membrane = options.plan.tilts = true;
    }
    options.size.height = 1.5 * options.size.diameter;
    return probe::run(options);
  });
}
