// SPDX-License-Identifier: MIT
// The material-behaviour study of Potyondy (2019), Hill Contact Model, version 4, Sec. 2.3: Class 5 aggregate, packed in a vessel
// at 150 kPa and tested in triaxial compression with load-unload cycles, under the linear law and the hill law, dry and wet.
//
//   class5 [FOLDER] [--full] [--threads N]     writes class5.json, class5.csv and the curves (default: build/results)
//
// By default the narrow grading up to 1 % axial strain (about half a minute of computation); --full: both gradings, three
// packings of each, up to 2 % (hours). Ctrl-C stops it; the same command goes on from there.
//
// Exit status: 0 if every number is in its band, 1 if one is not, 2 on a fault, 130 after Ctrl-C.
#include <filesystem>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "common/output_file.hpp"
#include "common/program.hpp"
#include "common/table.hpp"
#include "results.hpp"

namespace class5 {
namespace {

using common::BandedNumbers;

struct Plan {
  std::vector<std::string> gradings{"narrow"};
  std::vector<int> seeds{10000};
  double end = 1e-2;
};

/// The tests on one packing. Those of the first seed go on to the end, the others show how far moduli scatter.
struct Test {
  std::string name;
  std::string law;  ///< "linear", "hill" or "wet"
  TriaxialSettings settings;
};

std::vector<Test> tests_of(const Plan& plan, int seed) {
  TriaxialSettings whole;
  whole.end = plan.end;
  TriaxialSettings cycles = whole, half_rate = whole;
  cycles.end = 0.06e-2;
  half_rate.end = 0.8e-2;
  half_rate.cycle_rate /= 2.0;
  half_rate.end_rate /= 2.0;
  half_rate.record_every *= 2;
  if (seed != plan.seeds.front()) return {{"linear", "linear", cycles}, {"hill", "hill", cycles}};
  return {
      {"linear", "linear", whole}, {"hill", "hill", whole}, {"wet", "wet", whole}, {"half_rate", "hill", half_rate}};
}

TriaxialState run_test(const Test& test, const Packing& packing, dem::CaseControl& control) {
  if (test.law == "linear") return Triaxial<LinearLaw>(linear_law(friction), packing, test.settings).run(control);
  if (test.law == "hill") return Triaxial<DryLaw>(hill_law(), packing, test.settings).run(control);
  return Triaxial<WetLaw>(wet_law(), packing, test.settings).run(control);
}

std::string case_name(const std::string& grading, int seed, const std::string& what) {
  return grading + '_' + std::to_string(seed) + '_' + what;
}

/// All packings and tests by name.
struct Study {
  std::map<std::string, Packing> packings;
  std::map<std::string, TriaxialState> tests;
};

Study run_cases(const Plan& plan, const std::string& folder, int threads) {
  Study study;
  std::vector<dem::Case> cases;
  for (const std::string& grading : plan.gradings) {
    for (const int seed : plan.seeds) {
      PackingSettings settings;
      settings.grading = grading;
      settings.seed = seed;
      cases.push_back({case_name(grading, seed, "packing"), 1.0, settings.to_json(),
                       [settings](dem::CaseControl& control) { return nlohmann::json(pack(settings, control)); }});
    }
  }
  std::vector<nlohmann::json> results = dem::run_cases("Class 5: packing", folder, cases, threads);
  for (std::size_t i = 0; i < cases.size(); ++i) results[i].get_to(study.packings[cases[i].name]);

  cases.clear();
  for (const std::string& grading : plan.gradings) {
    for (const int seed : plan.seeds) {
      const Packing& packing = study.packings.at(case_name(grading, seed, "packing"));
      for (const Test& test : tests_of(plan, seed)) {
        const double seconds = test.settings.end / test.settings.end_rate + 1.2e-3 / test.settings.cycle_rate;
        const double work = seconds * std::pow(static_cast<double>(packing.grains.size()), 4.0 / 3.0);
        cases.push_back(
            {case_name(grading, seed, test.name), work, test.settings.to_json(),
             [test, &packing](dem::CaseControl& control) { return nlohmann::json(run_test(test, packing, control)); }});
      }
    }
  }
  results = dem::run_cases("Class 5: triaxial tests", folder, cases, threads);
  for (std::size_t i = 0; i < cases.size(); ++i) results[i].get_to(study.tests[cases[i].name]);
  return study;
}

// Numbers -------------------------------------------------------------------------------------------------------------

constexpr double strength_strain = 0.7e-2;

/// What holds for one grading, on the packing of the first seed.
void judge_grading(const Study& study, const std::string& grading, int seed, BandedNumbers& numbers) {
  const auto test = [&](const char* name) -> const TriaxialState& {
    return study.tests.at(case_name(grading, seed, name));
  };
  const Packing& packing = study.packings.at(case_name(grading, seed, "packing"));
  const std::string id = grading + '.';
  const auto add = [&](const std::string& name, const char* unit, std::optional<double> published,
                       std::optional<double> low, std::optional<double> high, double computed) {
    common::BandedNumber number{id + name, unit, published};
    if (low) number.low = *low;
    if (high) number.high = *high;
    number.computed = computed;
    numbers.push_back(number);
  };
  const double published = grading == "narrow" ? 0.379 : 0.319;
  add("grains", "1", {}, {}, {}, static_cast<double>(packing.grains.size()));
  add("porosity.sphere", "1", published, published - 0.008, published + 0.008, sphere_porosity(packing));
  add("porosity.vessel", "1", {}, {}, {}, packing.porosity());

  for (const char* name : {"linear", "hill", "wet"}) {
    const std::string law = name;
    add(law + ".coordination", "1", {}, {}, {}, test(name).coordination);
    for (const int number : {1, 2}) {
      const std::string at = law + (number == 1 ? ".at_0.02_percent." : ".at_0.05_percent.");
      const Cycle cycle = cycle_of(test(name), number);
      add(at + "resilient_modulus", "Pa", {}, {}, {}, cycle.resilient_modulus);
      add(at + "residual_strain_share", "1", {}, {}, {}, cycle.residual_strain);
      add(at + "loop_energy", "J/m3", {}, {}, {}, cycle.loop_energy);
    }
    add(law + ".strength", "1", {}, {}, {}, strength_at(test(name), strength_strain));
    add(law + ".confinement_error", "1", {}, {}, 0.015, confinement_error(test(name)));
    add(law + ".stress_of_walls_and_contacts_differ", "1", {}, {}, 1e-9, test(name).stress_mismatch);
    add(law + ".unbalanced_at_start", "1", {}, {}, {}, test(name).unbalanced);
  }

  const double more = std::nextafter(1.0, 2.0);  // "> 1"
  for (const int number : {1, 2}) {
    const std::string at = number == 1 ? "at_0.02_percent." : "at_0.05_percent.";
    const Cycle linear = cycle_of(test("linear"), number), hill = cycle_of(test("hill"), number);
    const Cycle wet = cycle_of(test("wet"), number), half_rate = cycle_of(test("half_rate"), number);
    add(at + "resilient_modulus.hill_over_linear", "1", {}, more, {},
        hill.resilient_modulus / linear.resilient_modulus);
    add(at + "resilient_modulus.wet_over_dry", "1", {}, 1.05, {}, wet.resilient_modulus / hill.resilient_modulus);
    add(at + "resilient_modulus.changes_at_half_the_rate", "1", {}, -0.01, 0.01,
        half_rate.resilient_modulus / hill.resilient_modulus - 1.0);
    const bool judged = number == 2;  // at 0.02 % the order of the loops is noise
    add(at + "residual_strain.hill_over_linear", "1", {}, judged ? std::optional(more) : std::nullopt, {},
        hill.residual_strain / linear.residual_strain);
    add(at + "loop_energy.hill_over_linear", "1", {}, judged ? std::optional(more) : std::nullopt, {},
        hill.loop_energy / linear.loop_energy);
    add(at + "loop_energy.changes_at_half_the_rate", "1", {}, judged ? std::optional(-0.05) : std::nullopt,
        judged ? std::optional(0.05) : std::nullopt, half_rate.loop_energy / hill.loop_energy - 1.0);
  }
  add("strength.changes_at_half_the_rate", "1", {}, -0.05, 0.05,
      strength_at(test("half_rate"), strength_strain) / strength_at(test("hill"), strength_strain) - 1.0);
}

/// What the memo concludes from both gradings.
void compare_gradings(const Study& study, const Plan& plan, BandedNumbers& numbers) {
  const int seed = plan.seeds.front();
  const auto porosity = [&](const char* grading) {
    return sphere_porosity(study.packings.at(case_name(grading, seed, "packing")));
  };
  common::BandedNumber denser{"porosity.narrow_less_broad", "1", 0.060, 0.04};
  denser.computed = porosity("narrow") - porosity("broad");
  numbers.push_back(denser);

  const auto strength_ratio = [&](const char* law) {
    return strength_at(study.tests.at(case_name("broad", seed, law)), strength_strain) /
           strength_at(study.tests.at(case_name("narrow", seed, law)), strength_strain);
  };
  const double more = std::nextafter(1.0, 2.0);
  common::BandedNumber linear{"strength.linear.broad_over_narrow", "1", {}, more},
      hill{"strength.hill.broad_over_narrow", "1", {}, more},
      both{"strength.broad_over_narrow.hill_over_linear", "1", {}, more};
  linear.computed = strength_ratio("linear");
  hill.computed = strength_ratio("hill");
  both.computed = hill.computed / linear.computed;
  for (const common::BandedNumber& number : {linear, hill, both}) numbers.push_back(number);

  for (const char* law : {"linear", "hill"}) {
    for (const int number : {1, 2}) {
      double sum = 0.0;
      for (const int s : plan.seeds)
        sum += cycle_of(study.tests.at(case_name("broad", s, law)), number).resilient_modulus /
               cycle_of(study.tests.at(case_name("narrow", s, law)), number).resilient_modulus;
      common::BandedNumber stiffer{std::string(number == 1 ? "at_0.02_percent" : "at_0.05_percent") +
                                       ".resilient_modulus." + law + ".broad_over_narrow.mean_of_packings",
                                   "1",
                                   {}};
      stiffer.computed = sum / static_cast<double>(plan.seeds.size());
      numbers.push_back(stiffer);
    }
  }
}

// Files ---------------------------------------------------------------------------------------------------------------

void write_curves(const Study& study, common::OutputFolder& folder) {
  for (const auto& [name, test] : study.tests) {
    common::Table curve{"leg", "axial_strain", "deviator_Pa", "radial_stress_Pa", "volume_strain"};
    for (const Sample& s : test.samples)
      curve.add({static_cast<double>(s.leg), s.strain, s.deviator, s.radial_stress, s.volume_strain});
    curve.write_csv(folder.file("class5_" + name + ".csv"));
  }
  for (const auto& [name, packing] : study.packings) {
    common::Table grains{"x_m", "y_m", "z_m", "radius_m", "load_N"};
    for (std::size_t g = 0; g < packing.grains.size(); ++g) {
      const Grain& grain = packing.grains[g];
      grains.add({grain.position.x(), grain.position.y(), grain.position.z(), grain.radius, packing.load[g]});
    }
    grains.write_csv(folder.file("class5_" + name + ".csv"));
  }
}

int run(const std::string& directory, bool full, int threads) {
  const common::InterruptGuard guard;
  Plan plan;
  if (full) plan = {{"narrow", "broad"}, {10000, 10001, 10002}, 2e-2};
  const std::string cases = directory + (full ? "/class5_full_cases" : "/class5_cases");
  common::create_folder(directory);
  const Study study = run_cases(plan, cases, threads);

  BandedNumbers numbers;
  for (const std::string& grading : plan.gradings) judge_grading(study, grading, plan.seeds.front(), numbers);
  if (full) compare_gradings(study, plan, numbers);
  common::OutputFolder folder(directory);
  write_curves(study, folder);
  write_json(folder.file("class5.json"), numbers);
  write_csv(folder.file("class5.csv"), numbers);
  folder.complete();
  std::filesystem::remove_all(cases);
  print("Class 5 (Potyondy 2019, Sec. 2.3)", numbers);
  return common::verdict(numbers);
}

}  // namespace
}  // namespace class5

int main(int argc, char** argv) {
  CLI::App app("Runs the material-behaviour study of the Hill memo (Potyondy 2019, Sec. 2.3).", "class5");
  std::string directory = "build/results";
  bool full = false;
  int threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  app.add_option("FOLDER", directory, "where to write the results (default: build/results)");
  app.add_flag("--full", full, "both gradings, three packings of each, to 2 % axial strain: hours");
  app.add_option("--threads", threads, "cases that run at the same time (default: one per core)")
      ->check(CLI::Range(1, 1024));
  return common::run_program(app, argc, argv, [&] { return class5::run(directory, full, threads); });
}
