// SPDX-License-Identifier: MIT
// Reduces a path that shows a fault to a short and plain one that still shows it.
//
// Steps are left out: halves, quarters, ... single steps, then any two at once (to and fro must go together). The next step
// then moves from where the last one ended. The remaining path is simplified: the first normal along z, the first
// slip along x; then, step by step, no twist, no rolling, no slip, the normal of the step before.
#pragma once

#include <cmath>
#include <functional>

#include "contactlaws/verify/path.hpp"

namespace contactlaws::verify {

using Shows = std::function<bool(const Path&)>;

namespace detail {

inline Path without(const Path& path, std::size_t begin, std::size_t count) {
  Path shorter(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(begin));
  const std::size_t end = minimum<std::size_t>(begin + count, path.size());
  shorter.insert(shorter.end(), path.begin() + static_cast<std::ptrdiff_t>(end), path.end());
  set_normal_velocities(shorter);
  return shorter;
}

/// Turned so that the first normal is z and the first slip x, with zeros where the rotation leaves rounding.
inline Path laid_along_axes(Path path) {
  using std::fabs;
  Rotation rotation = rotation_between(path.front().normal, Vector(0, 0, 1));
  for (const Motion& m : path) {
    const Vector slip = rotation * tangential(m.velocity, m.normal);
    if (m.normal != path.front().normal || !(norm<double>(slip) > 1e-9 * norm<double>(m.velocity))) continue;
    rotation = rotation_between(slip.normalized(), Vector(1, 0, 0)) * rotation;
    break;
  }
  const auto turned = [&rotation](const Vector& v) {
    Vector w = rotation * v;
    for (double& x : w)
      if (fabs(x) < 1e-9 * norm<double>(v)) x = 0.0;
    return w;
  };
  for (Motion& m : path) {
    m.velocity = turned(tangential(m.velocity, m.normal));
    m.relative_spin = turned(m.relative_spin);
    m.normal = turned(m.normal).normalized();
  }
  set_normal_velocities(path);
  return path;
}

/// Leaves out pieces of `size` steps, from the first to the last; whether it found any.
inline bool leave_out(Path& path, std::size_t size, const Shows& shows) {
  bool found = false;
  for (std::size_t begin = 0; begin < path.size() && path.size() > size;) {
    const Path shorter = without(path, begin, size);
    if (shows(shorter)) {
      path = shorter;
      found = true;
    } else {
      begin += size;
    }
  }
  return found;
}

/// Leaves out pairs of steps, once through; whether it found any.
inline bool leave_out_pairs(Path& path, const Shows& shows) {
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
inline Path reduced(Path path, const Shows& shows) {
  for (std::size_t size = path.size() / 2; size > 1; size /= 2) detail::leave_out(path, size, shows);
  constexpr std::size_t most_for_pairs = 64;  // their number is the square
  do {
    while (detail::leave_out(path, 1, shows)) continue;
  } while (path.size() <= most_for_pairs && detail::leave_out_pairs(path, shows));

  const auto try_instead = [&](Path plainer) {
    set_normal_velocities(plainer);
    if (shows(plainer)) path = plainer;
  };
  try_instead(detail::laid_along_axes(path));
  for (std::size_t i = 0; i < path.size(); ++i) {
    for (const int what : {0, 1, 2, 3}) {
      Path plainer = path;
      if (what == 0) plainer[i].normal_spin = 0.0;
      if (what == 1) plainer[i].relative_spin = Vector(0, 0, 0);
      if (what == 2) plainer[i].velocity = Vector(0, 0, 0);
      if (what == 3) plainer[i].normal = path[i > 0 ? i - 1 : 0].normal;
      try_instead(plainer);
    }
  }
  return path;
}

}  // namespace contactlaws::verify
