// SPDX-License-Identifier: MIT
// Reduces a path that shows a fault to one that is short and plain and still shows it.
//
// Steps are left out: halves, quarters, ... single steps, then any two at once (a detour must go as a whole).
// Left-out steps leave no hole: the next one moves from where the last one ended. What is left is made plain: the first normal
// along z, the first slip along x; then, step by step, no twist, no slip, the normal of the step before.
#pragma once

#include <cmath>

#include "contactlaws/verify/path.hpp"

namespace contactlaws::verify {

namespace detail {

inline Path without(const Path& path, std::size_t begin, std::size_t count) {
  Path shorter(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(begin));
  const std::size_t end = minimum<std::size_t>(begin + count, path.size());
  shorter.insert(shorter.end(), path.begin() + static_cast<std::ptrdiff_t>(end), path.end());
  settle(shorter);
  return shorter;
}

/// Turned so that the first normal is z and the first slip x, with zeros where that leaves rounding.
inline Path laid_along_axes(Path path) {
  using std::fabs;
  const Vector up(0, 0, 1);
  Rotation rotation = Eigen::Quaterniond::FromTwoVectors(path.front().normal, up).toRotationMatrix();
  for (const Motion& m : path) {
    const Vector slip = rotation * across(m.velocity, m.normal);
    if (m.normal != path.front().normal || !(norm<double>(slip) > 1e-9 * norm<double>(m.velocity))) continue;
    rotation = Eigen::Quaterniond::FromTwoVectors(slip, Vector(1, 0, 0)).toRotationMatrix() * rotation;
    break;
  }
  const auto turned = [&rotation](const Vector& v) {
    Vector w = rotation * v;
    for (double& x : w)
      if (fabs(x) < 1e-9 * norm<double>(v)) x = 0.0;
    return w;
  };
  for (Motion& m : path) {
    m.velocity = turned(across(m.velocity, m.normal));
    m.normal = turned(m.normal).normalized();
  }
  settle(path);
  return path;
}

/// Leaves out pairs of steps, once through; whether it found any.
template <class Shows>
bool leave_out_pairs(Path& path, const Shows& shows) {
  bool found = false;
  for (std::size_t i = 0; i < path.size(); ++i) {
    for (std::size_t j = i + 1; j < path.size(); ++j) {
      const Path shorter = without(without(path, j, 1), i, 1);
      if (shorter.empty() || !shows(shorter)) continue;
      path = shorter;
      found = true;
      j = i;
    }
  }
  return found;
}

}  // namespace detail

/// `shows(path)` holds at the start and at the end.
template <class Shows>
Path shrunk(Path path, const Shows& shows) {
  const auto leave_out = [&](std::size_t size) {
    bool found = false;
    for (std::size_t begin = 0; begin < path.size() && path.size() > size;) {
      const Path shorter = detail::without(path, begin, size);
      if (shows(shorter)) {
        path = shorter;
        found = true;
      } else {
        begin += size;
      }
    }
    return found;
  };
  for (std::size_t size = path.size() / 2; size > 1; size /= 2) leave_out(size);
  constexpr std::size_t most_for_pairs = 64;  // their number is the square
  do {
    while (leave_out(1)) continue;
  } while (path.size() <= most_for_pairs && detail::leave_out_pairs(path, shows));

  const auto try_instead = [&](Path plainer) {
    settle(plainer);
    if (shows(plainer)) path = plainer;
  };
  try_instead(detail::laid_along_axes(path));
  for (std::size_t i = 0; i < path.size(); ++i) {
    Path plainer = path;
    plainer[i].normal_spin = 0.0;
    try_instead(plainer);
    plainer = path;
    plainer[i].velocity = Vector(0, 0, 0);
    try_instead(plainer);
    if (i == 0) continue;
    plainer = path;
    plainer[i].normal = path[i - 1].normal;
    try_instead(plainer);
  }
  return path;
}

}  // namespace contactlaws::verify
