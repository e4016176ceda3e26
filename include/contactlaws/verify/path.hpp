// SPDX-License-Identifier: MIT
// The imposed motion of a contact, as examples/contact_path reads it, and two bodies that move so.
//
// A path gives overlap and normal at the end of each step, and the relative velocity at the contact point during it; it
// starts at touch. The bodies follow the normal with their centres, and the rest of the slip comes from their spins:
//
//   r1 w1 + r2 w2 = d n x (dn/dt - v_t/d)      w2 - w1 = relative spin      r = R - overlap/2, d = r1 + r2
//
// so the velocity that a law computes from the bodies is the path's to the last few digits.
#pragma once

#include <cmath>
#include <ostream>
#include <vector>

#include "contactlaws/verify/force_update.hpp"
#include "contactlaws/verify/options.hpp"

namespace contactlaws::verify {

/// A rotation matrix.
using Rotation = Eigen::Matrix<double, 3, 3>;
/// The motion of one step.
using Motion = ContactKinematics<double>;
/// The motion of a contact, step by step.
using Path = std::vector<Motion>;

/// The part of v in the contact plane.
inline Vector tangential(const Vector& v, const Vector& normal) { return v - normal * dot<double>(v, normal); }

/// By `angle` [rad] about the unit vector `axis` (Rodrigues).
inline Rotation rotation_about(const Vector& axis, double angle) {
  using std::cos;
  using std::sin;
  const double s = sin(angle), c = cos(angle);
  Rotation r;
  for (int j = 0; j < 3; ++j) {
    const Vector e = Vector::Unit(j);
    r.col(j) = e * c + axis.cross(e) * s + axis * (axis[j] * (1 - c));
  }
  return r;
}

/// The smallest rotation that takes the unit vector a to the unit vector b, which must not be opposite.
inline Rotation rotation_between(const Vector& a, const Vector& b) {
  const Vector sine = a.cross(b);
  Rotation r;
  for (int j = 0; j < 3; ++j) {
    const Vector e = Vector::Unit(j), once = sine.cross(e);
    r.col(j) = e + once + sine.cross(once) / (1 + dot<double>(a, b));
  }
  return r;
}

/// Normal velocities set to those of the overlaps, the first from touch; slip is kept.
inline void set_normal_velocities(Path& path) {
  double before = 0.0;
  for (Motion& m : path) {
    const double closing = m.dt > 0.0 ? (m.overlap - before) / m.dt : 0.0;
    m.velocity = tangential(m.velocity, m.normal) - m.normal * closing;
    before = m.overlap;
  }
}

/// The same motion, slower.
inline void slow_down(Path& path, double factor) {
  for (Motion& m : path) {
    m.dt *= factor;
    m.velocity = m.velocity / factor;
  }
}

/// The same motion in steps `parts` times as small. Normals go the shortest way.
inline Path refined(const Path& path, int parts) {
  Path fine;
  double overlap = 0.0;
  Vector normal = path.empty() ? Vector(0, 0, 1) : path.front().normal;
  for (const Motion& m : path) {
    for (int i = 1; i <= parts; ++i) {
      const double share = static_cast<double>(i) / parts;
      Motion part = m;
      part.dt = m.dt / parts;
      part.overlap = overlap + (m.overlap - overlap) * share;
      if (i < parts && normal != m.normal) part.normal = (normal + (m.normal - normal) * share).normalized();
      fine.push_back(part);
    }
    overlap = m.overlap;
    normal = m.normal;
  }
  set_normal_velocities(fine);
  return fine;
}

/// The input of one step of a force update.
struct Instant {
  Bodies bodies;  ///< at the end of the step
  double dt;      ///< [s]
};
/// The same motion, as bodies.
using Trajectory = std::vector<Instant>;

/// Bodies that move along the path, seen from body 1.
inline Trajectory trajectory(const Path& path, const Options& options) {
  Trajectory all;
  all.reserve(path.size());
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Motion& m = path[i];
    const double r1 = options.radius1 - m.overlap / 2, r2 = options.radius2 - m.overlap / 2, d = r1 + r2;
    const Vector slip = tangential(m.velocity, m.normal);
    const Vector turn = i > 0 && m.dt > 0.0 ? Vector((m.normal - path[i - 1].normal) / m.dt) : Vector(0, 0, 0);
    const Vector rolling = tangential(m.relative_spin, m.normal);
    const Vector twisting = (m.relative_spin - rolling) / 2;
    const Vector common = m.normal.cross(tangential(turn, m.normal) - slip / d) + m.normal * m.normal_spin;
    const Vector spin1 = common - rolling * (r2 / d) - twisting, spin2 = common + rolling * (r1 / d) + twisting;
    const Vector by_spin = spin2.cross(m.normal * -r2) - spin1.cross(m.normal * r1);
    const Body one{Vector(0, 0, 0), Vector(0, 0, 0), spin1, options.radius1, options.mass1};
    const Body two{m.normal * d, m.velocity - by_spin, spin2, options.radius2, options.mass2};
    all.push_back({{one, two}, m.dt});
  }
  return all;
}

/// The bodies where they are, at rest.
inline Bodies at_rest(Bodies bodies) {
  for (Body* body : {&bodies.one, &bodies.two}) body->velocity = body->spin = Vector(0, 0, 0);
  return bodies;
}

/// PATH.csv of examples/contact_path.
inline void write_path(std::ostream& out, const Path& path) {
  const auto digits = out.precision(17);
  out << "dt,overlap,nx,ny,nz,vx,vy,vz,normal_spin,wx,wy,wz\n";
  for (const Motion& m : path) {
    out << m.dt << ',' << m.overlap;
    for (const double x : m.normal) out << ',' << x;
    for (const double x : m.velocity) out << ',' << x;
    out << ',' << m.normal_spin;
    for (const double x : m.relative_spin) out << ',' << x;
    out << '\n';
  }
  out.precision(digits);
}

}  // namespace contactlaws::verify
