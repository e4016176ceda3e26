// SPDX-License-Identifier: MIT
// Rows of published, expected and computed numbers: gathered by the problems, printed as a table, written as JSON and CSV.
#pragma once

#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "../dem/output.hpp"

namespace memo {

/// Motion is prescribed: what remains is rounding, of positions of 1e-2 m in overlaps of 1e-4 m, over some hundred steps.
constexpr double prescribed = 1e-9;
/// Found at the end of a run to equilibrium, which stops at an unbalanced ratio of 1e-9.
constexpr double equilibrium = 1e-6;
/// Along an arc, in chords: each is off the arc by the square of its angle, 8e-6 rad.
constexpr double along_arc = 1e-8;

struct Row {
  std::string id;
  const char* unit;
  std::optional<double> published;  ///< as the document prints it; none where it prints none
  double expected;                  ///< closed form (expected.py)
  double computed;                  ///< by the integrator
  double tolerance;                 ///< on the relative error

  double relative_error() const { return std::abs(computed - expected) / std::abs(expected); }
  bool pass() const { return relative_error() <= tolerance; }  // false for a NaN
};

using Rows = std::vector<Row>;

inline bool all_pass(const Rows& rows) {
  for (const Row& row : rows)
    if (!row.pass()) return false;
  return true;
}

inline void print(const char* title, const Rows& rows) {
  std::printf("\n%-48s %12s %19s %19s  %5s\n", title, "published", "expected", "computed", "error");
  for (const Row& row : rows) {
    char published[32] = "-";
    if (row.published) std::snprintf(published, sizeof published, "%.10g", *row.published);
    const std::string name = row.id + (*row.unit == '1' ? "" : std::string(" [") + row.unit + "]");
    std::printf("%-48s %12s %19.12g %19.12g  %5.0e %s\n", name.c_str(), published, row.expected, row.computed,
                row.relative_error(), row.pass() ? "" : "FAILS");
  }
}

/// @throws std::runtime_error naming the file that cannot be written
inline void write_json(const std::string& path, const Rows& rows) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Row& row : rows) {
    list.push_back({{"id", row.id},
                    {"published", row.published ? nlohmann::ordered_json(*row.published) : nullptr},
                    {"expected", row.expected},
                    {"computed", row.computed},
                    {"relative_error", row.relative_error()},
                    {"tolerance", row.tolerance},
                    {"pass", row.pass()}});
  }
  dem::detail::open_for_writing(path) << list.dump(1) << '\n';
}

/// The same with units, for a spreadsheet. @throws std::runtime_error naming the file that cannot be written
inline void write_csv(const std::string& path, const Rows& rows) {
  std::ofstream file = dem::detail::open_for_writing(path);
  file << "id,unit,published,expected,computed,relative_error,tolerance,pass\n";
  for (const Row& row : rows) {
    file << row.id << ',' << row.unit << ',';
    if (row.published) file << *row.published;
    file << ',' << row.expected << ',' << row.computed << ',' << row.relative_error() << ',' << row.tolerance << ','
         << (row.pass() ? "yes" : "no") << '\n';
  }
}

}  // namespace memo
