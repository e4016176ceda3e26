// SPDX-License-Identifier: MIT
// Every tier of a law on every scene, against the law's fullest model: shear rotated exactly, 200 bits.
#pragma once

#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "../../examples/common/output_file.hpp"
#include "../../examples/common/progress.hpp"
#include "description.hpp"
#include "families.hpp"
#include "measure.hpp"
#include "tiers.hpp"

namespace trade {

struct Row {
  std::string law, scene;
  Tier tier;
  double ns;  ///< per contact and dt of the motion: a tier of several steps at once shares its cost among them
  std::size_t bytes;
  Errors errors;
  double rounding;     ///< from the same composition in 200 bits; NaN where more than rounding differs
  double drift;        ///< NaN where the scene is no closed cycle
  bool front = false;  ///< nothing else of this law is as right here and cheaper, or as cheap and more right
};

struct Effort {
  int repetitions = 11;
  double least = 2e-3;  ///< of one repetition [s]
  std::size_t drift_steps = 1'000'000;
};

/// Costs within 5 % and errors within 10 % of each other count as equal.
inline void mark_front(std::vector<Row>& rows) {
  for (Row& row : rows) {
    row.front = std::none_of(rows.begin(), rows.end(), [&row](const Row& other) {
      const double cost = other.ns / row.ns, error = other.errors.largest, as_right = 1.1 * row.errors.largest;
      return (cost < 0.95 && error <= as_right) || (cost <= 1.05 && 1.1 * error < row.errors.largest);
    });
  }
}

/// Whether a row keeps to its documented bound; a NaN does not.
inline bool keeps_bound(const Row& row) {
  return !row.tier.only_rounds() || row.rounding <= rounding_bound(row.tier.composition.precision);
}

/// `progress` is told the share of the work that is done.
template <class Progress>
std::vector<Row> measure_law(const std::string& law_name, const LawDescription& law, const Effort& effort,
                             const Progress& progress) {
  const Composition ours = composition_of(law);
  const Parameters parameters = parameters_of(law);
  LawDescription fullest = law;
  if (ours.history != History::none) fullest.shear.words["carry"] = name(Carrying::rotate);
  const std::vector<Tier> tiers = tiers_of(ours);
  std::vector<Row> all;
  double done = 0.0;
  for (const std::string& family : families()) {
    const auto scene_of = [&](std::size_t multiple, std::size_t contacts) {
      return make_scene(family, parameters, ours.is_rough(), ours.bridge, multiple, contacts);
    };
    const Scene full = scene_of(1, 32);
    const Scene few = scene_of(1, 8);
    const Reference reference = solve(fullest, full), same = solve(law, full);
    std::vector<Row> rows;
    for (const Tier& tier : tiers) {
      const Scene scene = tier.multiple > 1 ? scene_of(tier.multiple, 32) : full;
      const auto run = make_run(tier.composition, parameters, scene);
      if (!run) continue;  // not offered, run.hpp says why
      constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
      Row row{law_name,
              family,
              tier,
              0.0,
              run->state_bytes(),
              compare(*run, scene, reference, full),
              tier.only_rounds() ? compare(*run, scene, same, full).largest : unknown,
              unknown};
      row.ns = nanoseconds(*run, scene, effort.repetitions, effort.least) / double(tier.multiple);
      if (scene.cycle_start > 0) {
        const Scene few_steps = tier.multiple > 1 ? scene_of(tier.multiple, 8) : few;
        row.drift = drift(*make_run(tier.composition, parameters, few_steps), few_steps, effort.drift_steps);
      }
      rows.push_back(row);
      done += 1.0 / double(tiers.size() * families().size());
      progress(done);
      if (common::stop_requested()) return all;
    }
    mark_front(rows);
    all.insert(all.end(), rows.begin(), rows.end());
  }
  return all;
}

/// @throws contact_path::InputError naming the file that cannot be written
inline void write_table(const std::string& directory, const std::vector<Row>& rows,
                        const nlohmann::ordered_json& machine) {
  common::OutputFile csv(directory + "/trade.csv");
  csv.stream() << "law,scene,axis,tier,composition,ns,state_bytes,largest_error,rms_error,energy_error,rounding,"
                  "rounding_bound,drift,front\n";
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  csv.stream().precision(4);
  for (const Row& r : rows) {
    const std::string composition = describe(r.tier.composition);
    const auto or_null = [](double x) {
      return std::isnan(x) ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(x);
    };
    csv.stream() << r.law << ',' << r.scene << ',' << r.tier.axis << ",\"" << r.tier.name << "\",\"" << composition
                 << "\"," << r.ns << ',' << r.bytes << ',' << r.errors.largest << ',' << r.errors.rms << ','
                 << r.errors.energy << ',';
    if (r.tier.only_rounds())
      csv.stream() << r.rounding << ',' << rounding_bound(r.tier.composition.precision) << ',';
    else
      csv.stream() << ",,";
    if (!std::isnan(r.drift)) csv.stream() << r.drift;
    csv.stream() << ',' << (r.front ? "yes" : "no") << '\n';
    list.push_back({{"law", r.law},
                    {"scene", r.scene},
                    {"axis", r.tier.axis},
                    {"tier", r.tier.name},
                    {"composition", composition},
                    {"ns", r.ns},
                    {"state_bytes", r.bytes},
                    {"largest_error", r.errors.largest},
                    {"rms_error", r.errors.rms},
                    {"energy_error", r.errors.energy},
                    {"rounding", or_null(r.rounding)},
                    {"drift", or_null(r.drift)},
                    {"front", r.front}});
  }
  csv.complete();
  common::OutputFile json(directory + "/trade.json");
  json.stream() << nlohmann::ordered_json{{"machine", machine}, {"rows", list}}.dump(1) << '\n';
  json.complete();
}

}  // namespace trade
