// SPDX-License-Identifier: MIT
// The state of clumps as JSON, beside that of their scene (checkpoint.hpp). Shapes and masses belong to the program that adds them.
#pragma once

#include "checkpoint.hpp"
#include "clumps.hpp"

namespace dem {

inline nlohmann::json clumps_to_json(const Clumps& clumps) {
  nlohmann::json list = nlohmann::json::array();
  for (const Clump& c : clumps.all) {
    const Eigen::Quaterniond& q = c.orientation;
    list.push_back({c.position, c.velocity, nlohmann::json{q.w(), q.x(), q.y(), q.z()}, c.angular_momentum, c.spin,
                    c.force, c.torque, c.free});
  }
  return list;
}

/// Restores the clumps of a restored scene. @throws std::runtime_error if there is another number of them
template <class Scene>
void clumps_from_json(const nlohmann::json& list, Clumps& clumps, Scene& scene) {
  if (list.size() != clumps.size()) throw std::runtime_error("the saved scene has another number of clumps");
  for (std::size_t i = 0; i < clumps.size(); ++i) {
    Clump& c = clumps.all[i];
    const nlohmann::json& saved = list[i];
    const nlohmann::json& q = saved.at(2);
    saved.at(0).get_to(c.position);
    saved.at(1).get_to(c.velocity);
    c.orientation = Eigen::Quaterniond(q.at(0), q.at(1), q.at(2), q.at(3));
    saved.at(3).get_to(c.angular_momentum);
    saved.at(4).get_to(c.spin);
    saved.at(5).get_to(c.force);
    saved.at(6).get_to(c.torque);
    saved.at(7).get_to(c.free);
  }
  clumps.resume(scene);
}

}  // namespace dem
