// SPDX-License-Identifier: MIT
// Scenes as legacy VTK files, which ParaView opens. Give streams 17 digits (common::OutputFile does).
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "simulation.hpp"

namespace dem {

namespace detail {

/// One field of the VTK file: `kind` is "SCALARS name double 1\nLOOKUP_TABLE default" or "VECTORS name double".
template <class Value>
void write_field(std::ostream& file, const std::string& kind, std::size_t count, const Value& value) {
  file << kind << '\n';
  for (std::size_t i = 0; i < count; ++i) file << value(i) << '\n';
}

inline std::string scalars(const std::string& name) { return "SCALARS " + name + " double 1\nLOOKUP_TABLE default"; }
inline std::string vectors(const std::string& name) { return "VECTORS " + name + " double"; }

}  // namespace detail

/// The balls, as points with radius, velocity, spin and force. In ParaView: Glyph, Sphere, scaled by `radius` x 2.
inline void write_balls_vtk(std::ostream& file, const Balls& balls) {
  const Eigen::IOFormat in_a_line(17, Eigen::DontAlignCols, " ", " ");
  const std::size_t count = balls.size();
  file << "# vtk DataFile Version 3.0\nballs, in m, kg, s\nASCII\nDATASET POLYDATA\nPOINTS " << count << " double\n";
  for (const Vec3& p : balls.position) file << p.format(in_a_line) << '\n';
  file << "VERTICES " << count << ' ' << 2 * count << '\n';
  for (std::size_t i = 0; i < count; ++i) file << "1 " << i << '\n';
  file << "POINT_DATA " << count << '\n';
  detail::write_field(file, detail::scalars("radius"), count, [&](std::size_t i) { return balls.radius[i]; });
  detail::write_field(file, detail::scalars("id"), count, [&](std::size_t i) { return i; });
  const auto field = [&](const char* name, const std::vector<Row>& values) {
    detail::write_field(file, detail::vectors(name), count, [&](std::size_t i) { return values[i].format(in_a_line); });
  };
  field("velocity", balls.velocity);
  field("spin", balls.spin);
  field("force", balls.force);
}

/// The active contacts between balls, as lines from centre to centre with the normal force (tension < 0) and the shear
/// force [N]. In ParaView: Tube.
template <class Scene>
void write_contacts_vtk(std::ostream& file, const Scene& scene) {
  const Balls& balls = scene.balls;
  const Eigen::IOFormat in_a_line(17, Eigen::DontAlignCols, " ", " ");
  std::vector<std::size_t> active;
  for (std::size_t c = 0; c < scene.ball_contacts.size(); ++c)
    if (scene.ball_contact(c).response.active) active.push_back(c);
  const std::size_t count = active.size();
  file << "# vtk DataFile Version 3.0\ncontacts, in N\nASCII\nDATASET POLYDATA\nPOINTS " << balls.size() << " double\n";
  for (const Vec3& p : balls.position) file << p.format(in_a_line) << '\n';
  file << "LINES " << count << ' ' << 3 * count << '\n';
  for (const std::size_t c : active)
    file << "2 " << scene.ball_contacts.first(c) << ' ' << scene.ball_contacts.second(c) << '\n';
  file << "CELL_DATA " << count << '\n';
  const auto normal_force = [&](std::size_t i) {
    const auto contact = scene.ball_contact(active[i]);
    return contact.response.force.dot(contact.geometry.normal);
  };
  detail::write_field(file, detail::scalars("normal_force"), count, normal_force);
  detail::write_field(file, detail::scalars("shear_force"), count, [&](std::size_t i) {
    const auto contact = scene.ball_contact(active[i]);
    const Vec3 normal_part = contact.geometry.normal * normal_force(i);
    return (contact.response.force - normal_part).norm();
  });
}

}  // namespace dem
