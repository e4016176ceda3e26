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

/// The columns of a contact's motion, in the order in which read_motion() reads them.
inline const std::vector<Column>& motion_columns() {
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
      {"normal_spin", "rad/s", any, false, "mean spin of the bodies about the normal; read by rotation = \"rotate\""},
      {"wx", "rad/s", any, false, "spin of body 2 relative to body 1; read by rolling laws"},
      {"wy", "rad/s", any, false, ""},
      {"wz", "rad/s", any, false, ""},
  };
  return columns;
}
inline std::vector<Column> path_columns() {
  std::vector<Column> columns = motion_columns();
  columns.push_back({"make_wet", "m", contactlaws::Range::not_negative(), false,
                     "before the step: wets the contact if its gap is at most this; an empty cell does nothing"});
  return columns;
}

/// The motion in a row whose column `first` is the first of motion_columns(). Each number is rounded to T from its decimal
/// text; the normal is scaled to unit length; columns that the file does not have are zero.
/// @throws InputError naming file, line and column
template <class T>
contactlaws::ContactKinematics<T> read_motion(const CsvFile& csv, std::size_t first) {
  using contactlaws::Vec3;
  using std::isfinite;
  const auto vector = [&](std::size_t i) {
    return Vec3<T>(csv.number<T>(first + i), csv.number<T>(first + i + 1), csv.number<T>(first + i + 2));
  };
  const auto or_zero = [&](std::size_t i) { return csv.number_if_any<T>(first + i).value_or(T(0)); };
  const T dt = csv.number<T>(first), overlap = csv.number<T>(first + 1);
  const Vec3<T> direction = vector(2), velocity = vector(5);
  const T length = contactlaws::norm<T>(direction);
  if (!(length > T(0)) || !isfinite(length))
    fail(csv.place(),
         "the normal (nx, ny, nz) is " + std::string(length > T(0) ? "too long" : "zero") + ", must have a direction");
  return {
      Vec3<T>(direction / length), overlap, velocity, dt, or_zero(8), Vec3<T>(or_zero(9), or_zero(10), or_zero(11))};
}

template <class T>
struct PathStep {
  contactlaws::ContactKinematics<T> kinematics;
  std::optional<T> moisture_gap;  ///< wets the contact before the step where its gap is at most this [m]
  std::size_t line;               ///< of the file
};

/// @throws InputError naming file, line and column
template <class T>
std::vector<PathStep<T>> read_path(const std::string& file) {
  CsvFile csv(file, path_columns());
  std::vector<PathStep<T>> path;
  while (csv.next())
    path.push_back({read_motion<T>(csv, 0), csv.number_if_any<T>(motion_columns().size()), csv.place().line});
  if (path.empty()) fail(csv.place(), "has a header but no steps");
  return path;
}

}  // namespace contact_path
