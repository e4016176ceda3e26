// SPDX-License-Identifier: MIT
// Every variant of a law on every family of motions, against the reference: the law with its shear rotated exactly, in 200
// bits.
#pragma once

#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "common/output_file.hpp"
#include "common/progress.hpp"
#include "families.hpp"
#include "measure.hpp"
#include "variants.hpp"

namespace trade {

struct Measurement {
  std::string law, motion;
  Variant variant;
  double ns;  ///< per contact and dt of the motion: a variant of several steps at once shares its cost among them
  std::size_t bytes;
  Errors errors;
  double rounding;      ///< from the same composition in 200 bits; NaN where more than rounding differs
  double drift;         ///< NaN where the motion is no closed cycle
  bool pareto = false;  ///< no other variant is as accurate here and cheaper, or as cheap and more accurate
};

struct Effort {
  int repetitions = 11;
  double least = 2e-3;  ///< of one repetition [s]
  std::size_t drift_steps = 1'000'000;
};

/// Costs within 5 % and errors within 10 % of each other count as equal.
inline void mark_pareto(std::vector<Measurement>& rows) {
  for (Measurement& row : rows) {
    row.pareto = std::none_of(rows.begin(), rows.end(), [&row](const Measurement& other) {
      const double cost = other.ns / row.ns, error = other.errors.largest, accurate = 1.1 * row.errors.largest;
      return (cost < 0.95 && error <= accurate) || (cost <= 1.05 && 1.1 * error < row.errors.largest);
    });
  }
}

/// Whether the rounding is within its documented bound; false for a NaN.
inline bool within_bound(const Measurement& row) {
  return !row.variant.only_rounds() || row.rounding <= rounding_bound(row.variant.composition.precision);
}

/// Calls progress(share of the work that is done). @throws Stopped
template <class Progress>
std::vector<Measurement> measure_law(const std::string& law_name, const LawSpec& law, const Effort& effort,
                                     const Progress& progress) {
  LawSpec exactly_rotated = law;
  if (law.shear.acts()) exactly_rotated.shear.words["rotation"] = "rotate";
  if (law.shear.law == "partial_slip") exactly_rotated.shear.words["corners"] = "12";
  const std::vector<Variant> variants = variants_of(law);
  std::vector<Measurement> all;
  double done = 0.0;
  for (const std::string& family : families()) {
    const auto trajectories = [&](std::size_t multiple, std::size_t contacts) {
      return make_trajectories(family, law, multiple, contacts);
    };
    const Trajectories full = trajectories(1, 32);
    const Reference reference = solve(exactly_rotated, full), same = solve(law, full);
    std::vector<Measurement> rows;
    for (const Variant& variant : variants) {
      const Trajectories motion = variant.multiple > 1 ? trajectories(variant.multiple, 32) : full;
      const auto run = make_run(variant.composition, motion);
      if (!run) continue;  // not offered: runs.hpp
      constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
      Measurement row{law_name,
                      family,
                      variant,
                      0.0,
                      run->state_bytes(),
                      compare(*run, motion, reference, full),
                      variant.only_rounds() ? compare(*run, motion, same, full).largest : unknown,
                      unknown};
      row.ns = nanoseconds(*run, motion, effort.repetitions, effort.least) / double(variant.multiple);
      if (motion.cycle_start > 0) {
        const Trajectories few = trajectories(variant.multiple, 8);
        row.drift = drift(*make_run(variant.composition, few), few, effort.drift_steps);
      }
      rows.push_back(row);
      done += 1.0 / double(variants.size() * families().size());
      progress(done);
      common::stop_if_requested();
    }
    mark_pareto(rows);
    all.insert(all.end(), rows.begin(), rows.end());
  }
  return all;
}

/// trade.csv and trade.json, with the same columns. @throws InputError naming the file that cannot be written
inline void write_table(common::OutputFolder& folder, const std::vector<Measurement>& rows,
                        const nlohmann::ordered_json& machine) {
  using Json = nlohmann::ordered_json;
  const auto or_null = [](double x) { return std::isnan(x) ? Json(nullptr) : Json(x); };
  Json list = Json::array();
  for (const Measurement& r : rows)
    list.push_back(
        {{"law", r.law},
         {"motion", r.motion},
         {"axis", r.variant.axis},
         {"variant", r.variant.name},
         {"composition", describe(r.variant.composition)},
         {"ns", r.ns},
         {"state_bytes", r.bytes},
         {"largest_error", or_null(r.errors.largest)},
         {"rms_error", or_null(r.errors.rms)},
         {"energy_error", or_null(r.errors.energy)},
         {"rounding", or_null(r.rounding)},
         {"rounding_bound", r.variant.only_rounds() ? Json(rounding_bound(r.variant.composition.precision)) : Json()},
         {"drift", or_null(r.drift)},
         {"pareto", r.pareto}});

  std::ostream& csv = folder.file("trade.csv");
  csv.precision(4);
  for (const auto& column : list.at(0).items()) csv << (column.key() == "law" ? "" : ",") << column.key();
  for (const Json& row : list) {
    const char* separator = "\n";
    for (const Json& cell : row) {
      csv << separator;
      separator = ",";
      if (cell.is_number()) csv << cell.get<double>();
      if (cell.is_boolean()) csv << (cell.get<bool>() ? "yes" : "no");
      if (cell.is_string()) csv << cell;  // in quotes
    }
  }
  csv << '\n';
  folder.file("trade.json") << Json{{"machine", machine}, {"rows", list}}.dump(1) << '\n';
  folder.complete();
}

}  // namespace trade
