// SPDX-License-Identifier: MIT
// PATH.csv: the motion that is imposed on a contact, a row a step. Signs and frames as in contactlaws/kinematics.hpp.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/csv_file.hpp"
#include "contactlaws/kinematics.hpp"

namespace contact_path {

using namespace common;

inline const std::vector<Column>& path_columns() {
  using contactlaws::Range;
  const Range any = Range::any();
  static const std::vector<Column> columns{
      {"dt", "s", Range::not_negative(), true, "time since the step before"},
      {"overlap", "m", any, true, "at the end of the step; negative across a gap"},
      {"nx", "1", any, true, "normal from body 1 to body 2, at the end of the step; its length does not matter"},
      {"ny", "1", any, true, ""},
      {"nz", "1", any, true, ""},
      {"vx", "m/s", any, true, "velocity of body 2 relative to body 1 at the contact point, during the step"},
      {"vy", "m/s", any, true, ""},
      {"vz", "m/s", any, true, ""},
      {"spin", "rad/s", any, false, "mean of the two bodies' spins about the normal; only carry = \"rotate\" asks"},
      {"make_wet", "m", Range::not_negative(), false,
       "before the step: wets the contact if its gap is at most this; an empty cell does nothing"},
  };
  return columns;
}

template <class T>
struct PathStep {
  contactlaws::ContactKinematics<T> kinematics;
  std::optional<T> moisture_gap;  ///< wets the contact before the step where its gap is at most this [m]
  std::size_t line;               ///< where it stands in the file
};

/// Each number is rounded to T from its decimal text; the normal is scaled to unit length.
/// @throws InputError naming file, line and column
template <class T>
std::vector<PathStep<T>> read_path(const std::string& file) {
  using contactlaws::Vec3;
  using std::isfinite;
  CsvFile csv(file, path_columns());
  const auto vector = [&csv](std::size_t first) {
    return Vec3<T>(csv.number<T>(first), csv.number<T>(first + 1), csv.number<T>(first + 2));
  };
  std::vector<PathStep<T>> path;
  while (csv.next()) {
    const T dt = csv.number<T>(0), overlap = csv.number<T>(1);
    const Vec3<T> direction = vector(2), velocity = vector(5);
    const T length = contactlaws::norm<T>(direction);
    if (!(length > T(0)) || !isfinite(length))
      fail(csv.place(), "the normal (nx, ny, nz) is " + std::string(length > T(0) ? "too long" : "zero") +
                            ", must have a direction");
    path.push_back({{Vec3<T>(direction / length), overlap, velocity, dt, csv.number_if_any<T>(8).value_or(T(0))},
                    csv.number_if_any<T>(9),
                    csv.place().line});
  }
  if (path.empty()) fail(csv.place(), "has a header but no steps");
  return path;
}

}  // namespace contact_path
