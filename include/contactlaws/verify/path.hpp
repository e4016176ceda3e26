// SPDX-License-Identifier: MIT
// The motion imposed on a contact, as examples/contact_path reads it, and the two bodies that move so.
//
// A path says overlap and normal at the end of each step, and the relative velocity at the contact during it; it starts at
// touch. Bodies are found that do this: centres that follow the normal, spins that make up the rest of the slip,
//
//   r1 w1 + r2 w2 = d n x (dn/dt - v_t/d) + roll       r = R - overlap/2, d = r1 + r2
//
// so that the law, which sees bodies, is told the path's velocity to the last few digits.
#pragma once

#include <istream>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "contactlaws/verify/adapter.hpp"
#include "contactlaws/verify/options.hpp"

namespace contactlaws::verify {

using Motion = ContactKinematics<double>;
using Path = std::vector<Motion>;

inline Vector across(const Vector& v, const Vector& normal) { return v - normal * dot<double>(v, normal); }

/// Normal velocities as the overlaps ask for, the first from touch; slip is kept.
inline void settle(Path& path) {
  double before = 0.0;
  for (Motion& m : path) {
    const double closing = m.dt > 0.0 ? (m.overlap - before) / m.dt : 0.0;
    m.velocity = across(m.velocity, m.normal) - m.normal * closing;
    before = m.overlap;
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
  settle(fine);
  return fine;
}

/// What a law is asked in one step.
struct Moment {
  Bodies bodies;
  double dt;  ///< [s]
};
using Scene = std::vector<Moment>;

/// Bodies that go along the path, seen from body 1.
inline Scene staged(const Path& path, const Options& options) {
  Scene scene;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Motion& m = path[i];
    const double r1 = options.radius1 - m.overlap / 2, r2 = options.radius2 - m.overlap / 2, d = r1 + r2;
    const Vector slip = across(m.velocity, m.normal);
    const Vector turn = i > 0 && m.dt > 0.0 ? Vector((m.normal - path[i - 1].normal) / m.dt) : Vector(0, 0, 0);
    const Vector together = m.normal.cross(across(turn, m.normal) - slip / d) + m.normal * m.normal_spin;
    const Vector roll = slip / (2 * d * (r1 + r2));
    const Vector spin1 = together + roll * r2, spin2 = together - roll * r1;
    const Vector by_spin = spin2.cross(m.normal * -r2) - spin1.cross(m.normal * r1);
    const Body one{Vector(0, 0, 0), Vector(0, 0, 0), spin1, options.radius1, options.mass1};
    const Body two{m.normal * d, m.velocity - by_spin, spin2, options.radius2, options.mass2};
    scene.push_back({{one, two}, m.dt});
  }
  return scene;
}

/// The bodies where they are, at rest.
inline Bodies at_rest(Bodies bodies) {
  for (Body* body : {&bodies.one, &bodies.two}) body->velocity = body->spin = Vector(0, 0, 0);
  return bodies;
}

/// PATH.csv of examples/contact_path.
inline void write_path(std::ostream& out, const Path& path) {
  const auto digits = out.precision(17);
  out << "dt,overlap,nx,ny,nz,vx,vy,vz,normal_spin\n";
  for (const Motion& m : path) {
    out << m.dt << ',' << m.overlap;
    for (int i = 0; i < 3; ++i) out << ',' << m.normal[i];
    for (int i = 0; i < 3; ++i) out << ',' << m.velocity[i];
    out << ',' << m.normal_spin << '\n';
  }
  out.precision(digits);
}

/// What write_path wrote. @throws std::runtime_error on anything else
inline Path read_path(std::istream& in) {
  Path path;
  std::string line;
  if (!std::getline(in, line) || line != "dt,overlap,nx,ny,nz,vx,vy,vz,normal_spin")
    throw std::runtime_error("not a path of contactlaws::verify: its first line is '" + line + "'");
  while (std::getline(in, line)) {
    std::istringstream cells(line);
    double x[9];
    char comma = ',';
    for (int i = 0; i < 9; ++i)
      if (!((i == 0 || cells >> comma) && cells >> x[i]) || comma != ',')
        throw std::runtime_error("not nine numbers: '" + line + "'");
    path.push_back({Vector(x[2], x[3], x[4]), x[1], Vector(x[5], x[6], x[7]), x[0], x[8]});
  }
  return path;
}

}  // namespace contactlaws::verify
