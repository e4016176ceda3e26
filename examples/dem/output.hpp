// SPDX-License-Identifier: MIT
// Scenes for ParaView: balls as points, contacts as lines with data at both ends. docs/paraview.md says how to look at them.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "common/vtk.hpp"
#include "simulation.hpp"

namespace dem {

/// The balls, with radius [m], id, velocity [m/s], spin [rad/s] and force [N].
inline common::VtkData balls_for_vtk(const Balls& balls) {
  common::VtkData data;
  data.points.assign(balls.position.begin(), balls.position.end());
  data.scalars["radius"] = balls.radius;
  std::vector<double>& id = data.scalars["id"];
  for (std::size_t i = 0; i < balls.size(); ++i) id.push_back(static_cast<double>(i));
  data.vectors["velocity"].assign(balls.velocity.begin(), balls.velocity.end());
  data.vectors["spin"].assign(balls.spin.begin(), balls.spin.end());
  data.vectors["force"].assign(balls.force.begin(), balls.force.end());
  return data;
}

namespace detail {

/// A line for each active contact of `count`, to the centre of body 2 from that of body 1, or from the contact point at a wall.
/// Both ends have overlap [m], normal force (compression > 0, with the bridge), shear force, the bridge's pull [N], whether it
/// slides, and the scalars of its history by their names. The vector `force` [N] acts on the body at its end.
template <class Law, class OutcomeOf, class CentreOf>
common::VtkData contacts_for_vtk(std::size_t count, bool at_walls, const OutcomeOf& outcome, const CentreOf& centre) {
  common::VtkData data;
  data.shape = common::VtkData::Shape::lines;
  std::vector<Vec3>& force = data.vectors["force"];
  std::array<std::vector<double>*, 5> numbers{&data.scalars["overlap"], &data.scalars["normal_force"],
                                              &data.scalars["shear_force"], &data.scalars["bridge_force"],
                                              &data.scalars["sliding"]};
  constexpr auto described = Law::state_values();
  std::vector<std::pair<std::size_t, std::vector<double>*>> history;  // the first value of each name
  for (std::size_t i = 0; i < Law::state_size; ++i) {
    if (described[i].kind != contactlaws::ValueKind::scalar) continue;
    const auto [column, is_new] = data.scalars.try_emplace(described[i].name);
    if (is_new) history.emplace_back(i, &column->second);
  }

  for (std::size_t c = 0; c < count; ++c) {
    const auto contact = outcome(c);
    const auto& step = contact.response;
    if (!step.active) continue;
    const Vec3 end = centre(c), point = end + contact.geometry.arm2;
    data.points.push_back(at_walls ? point : Vec3(point - contact.geometry.arm1));
    data.points.push_back(end);
    force.push_back(-step.force);
    force.push_back(step.force);
    const std::array<double, 5> of_step{contact.geometry.overlap, step.normal_force - step.bridge_force,
                                        step.shear_force.norm(), step.bridge_force, step.sliding ? 1.0 : 0.0};
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i]->insert(numbers[i]->end(), 2, of_step[i]);
    std::array<double, Law::state_size> state{};
    Law::store(step.state, state.data());
    for (const auto& [i, column] : history) column->insert(column->end(), 2, state[i]);
  }
  return data;
}

}  // namespace detail

/// The active contacts between balls.
template <class BallLaw, class WallLaw, class BallPack>
common::VtkData ball_contacts_for_vtk(const Simulation<BallLaw, WallLaw, BallPack>& scene) {
  return detail::contacts_for_vtk<BallLaw>(
      scene.ball_contacts.size(), false, [&scene](std::size_t c) { return scene.ball_contact(c); },
      [&scene](std::size_t c) -> Vec3 { return scene.balls.position[scene.ball_contacts.second(c)]; });
}

/// The active contacts of balls at walls.
template <class BallLaw, class WallLaw, class BallPack>
common::VtkData wall_contacts_for_vtk(const Simulation<BallLaw, WallLaw, BallPack>& scene) {
  return detail::contacts_for_vtk<WallLaw>(
      scene.wall_contacts.size(), true, [&scene](std::size_t c) { return scene.wall_contact(c); },
      [&scene](std::size_t c) -> Vec3 { return scene.balls.position[scene.wall_contacts.second(c)]; });
}

}  // namespace dem
