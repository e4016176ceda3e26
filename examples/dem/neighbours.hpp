// SPDX-License-Identifier: MIT
// Pairs of balls that are near each other, in a time proportional to their number (times its logarithm).
//
// Space is divided into rows along x. Balls are sorted by row, and along x within a row. Each ball searches the rows within
// its search radius for balls no larger than itself. Rows are as wide as the mean search radius, so most balls search 3 x 3
// rows and the few large ones more. Sizes may differ by a factor of a hundred; empty space costs nothing.
#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include "balls.hpp"

namespace dem {

/// Ids of two bodies in contact or close to it.
struct Pair {
  int first;
  int second;
  friend bool operator<(const Pair& a, const Pair& b) {
    return std::tie(a.first, a.second) < std::tie(b.first, b.second);
  }
  friend bool operator==(const Pair& a, const Pair& b) { return a.first == b.first && a.second == b.second; }
};

namespace detail {

struct RowEntry {
  double row_z, row_y;  ///< indices of the row
  double x;             ///< [m]
  int ball;
  friend bool operator<(const RowEntry& a, const RowEntry& b) {
    return std::tie(a.row_z, a.row_y, a.x) < std::tie(b.row_z, b.row_y, b.x);
  }
};

}  // namespace detail

/// All pairs (first < second, in no particular order) whose gap is at most `reach` [m] and that `wanted(one, two)` wants.
/// @throws std::runtime_error naming a ball whose position is not finite
template <class Position, class Wanted>
std::vector<Pair> find_neighbours(const std::vector<Position>& position, const std::vector<double>& radius,
                                  double reach, const Wanted& wanted) {
  using detail::RowEntry;
  const std::size_t count = position.size();
  if (count == 0) return {};

  // Largest distance to the centre of a ball no larger than ball i.
  const auto search_radius = [&](std::size_t i) { return 2.0 * radius[i] + reach; };
  double width = 0.0;
  for (std::size_t i = 0; i < count; ++i) width += search_radius(i) / static_cast<double>(count);
  const auto row_of = [width](double coordinate) { return std::floor(coordinate / width); };

  std::vector<RowEntry> rows(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3& p = position[i];
    if (!p.allFinite())
      throw std::runtime_error("ball " + std::to_string(i) +
                               " is lost: its position is not finite. Try a shorter time step.");
    rows[i] = {row_of(p.z()), row_of(p.y()), p.x(), static_cast<int>(i)};
  }
  std::sort(rows.begin(), rows.end());

  std::vector<Pair> pairs;
  for (const RowEntry& entry : rows) {
    const int id = entry.ball;
    const auto i = static_cast<std::size_t>(id);
    const Vec3& p = position[i];
    const double far = search_radius(i);
    const double low_y = row_of(p.y() - far), low_z = row_of(p.z() - far);
    const int rows_y = static_cast<int>(row_of(p.y() + far) - low_y),
              rows_z = static_cast<int>(row_of(p.z() + far) - low_z);
    for (int k = 0; k <= rows_z; ++k) {
      for (int j = 0; j <= rows_y; ++j) {
        const double row_z = low_z + k, row_y = low_y + j;
        auto other = std::lower_bound(rows.begin(), rows.end(), RowEntry{row_z, row_y, p.x() - far, 0});
        for (; other != rows.end() && other->row_z == row_z && other->row_y == row_y && other->x <= p.x() + far;
             ++other) {
          const auto o = static_cast<std::size_t>(other->ball);
          const bool is_larger = radius[o] > radius[i] || (radius[o] == radius[i] && other->ball >= id);
          if (is_larger) continue;  // finds this pair itself
          if (wanted(i, o) && (position[o] - p).norm() - radius[o] - radius[i] <= reach)
            pairs.push_back({std::min(id, other->ball), std::max(id, other->ball)});
        }
      }
    }
  }
  return pairs;
}
template <class Position>
std::vector<Pair> find_neighbours(const std::vector<Position>& position, const std::vector<double>& radius,
                                  double reach) {
  return find_neighbours(position, radius, reach, [](std::size_t, std::size_t) { return true; });
}

}  // namespace dem
