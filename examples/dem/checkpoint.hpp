// SPDX-License-Identifier: MIT
// Writes the whole state of a scene as JSON and reads it back: bodies, how they move, forces, every history, time steps.
// Laws, skin and threads belong to the program that builds the scene. A restored scene goes on bit for bit as the saved one.
#pragma once

#include <fstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "common/output_file.hpp"
#include "simulation.hpp"

namespace nlohmann {

template <>
struct adl_serializer<dem::Vec3> {
  static void to_json(json& list, const dem::Vec3& v) { list = {v.x(), v.y(), v.z()}; }
  static void from_json(const json& list, dem::Vec3& v) { v = dem::Vec3(list.at(0), list.at(1), list.at(2)); }
};
template <>
struct adl_serializer<dem::Row> {
  static void to_json(json& list, const dem::Row& row) { list = {row.x(), row.y(), row.z(), row.w}; }
  static void from_json(const json& list, dem::Row& row) {
    row = dem::Vec3(list.at(0), list.at(1), list.at(2));
    row.w = list.at(3);
  }
};
template <>
struct adl_serializer<contactlaws::ContactBody<double>> {
  using Body = contactlaws::ContactBody<double>;
  static void to_json(json& list, const Body& b) {
    list = {b.curvature, b.radius, b.inverse_mass, b.normal_compliance, b.shear_compliance};
  }
  static void from_json(const json& list, Body& b) { b = {list.at(0), list.at(1), list.at(2), list.at(3), list.at(4)}; }
};
template <>
struct adl_serializer<dem::Wall> {
  static void to_json(json& list, const dem::Wall& w) {
    list = {w.side,         w.point, w.facing, w.velocity, w.force, w.radius, w.radial_velocity,
            w.normal_force, w.spin,  w.torque, w.extent,   w.group};
  }
  static void from_json(const json& list, dem::Wall& w) {
    w = {list.at(0), list.at(1), list.at(2), list.at(3), list.at(4),  list.at(5),
         list.at(6), list.at(7), list.at(8), list.at(9), list.at(10), list.at(11)};
  }
};

}  // namespace nlohmann

namespace dem {

namespace detail {

/// Calls `visit(name, member)` for each member of a scene that changes as it runs, contacts apart.
template <class Scene, class Visit>
void for_each_member(Scene& scene, const Visit& visit) {
  visit("time", scene.time);
  visit("steps", scene.steps);
  visit("time_step", scene.time_step);
  visit("last_step", scene.last_step);
  visit("contact_dt", scene.contact_dt);
  visit("gravity", scene.gravity);
  visit("local_damping", scene.local_damping);
  visit("position", scene.balls.position);
  visit("velocity", scene.balls.velocity);
  visit("spin", scene.balls.spin);
  visit("force", scene.balls.force);
  visit("torque", scene.balls.torque);
  visit("radius", scene.balls.radius);
  visit("mass", scene.balls.mass);
  visit("inertia", scene.balls.inertia);
  visit("side", scene.balls.side);
  visit("free", scene.balls.free);
  visit("walls", scene.walls);
}

template <class Law, class Pack>
nlohmann::json histories_to_json(const Contacts<Law, Pack>& contacts) {
  nlohmann::json list = nlohmann::json::array();
  for (const auto& pair : contacts.histories()) {
    std::array<double, Law::state_size> before{}, now{};
    Law::store(pair.before, before.data());
    Law::store(pair.now, now.data());
    list.push_back({pair.bodies.first, pair.bodies.second, before, now});
  }
  return list;
}
template <class Law, class Pack>
void histories_from_json(const nlohmann::json& list, Contacts<Law, Pack>& contacts) {
  std::vector<PairHistory<typename Law::State>> histories;
  for (const nlohmann::json& entry : list) {
    const std::vector<double> before = entry.at(2), now = entry.at(3);
    histories.push_back({{entry.at(0), entry.at(1)}, Law::load(before.data()), Law::load(now.data())});
  }
  contacts.set_histories(histories);
}

}  // namespace detail

/// The state of a scene. Laws, skin and threads belong to the program that builds the scene.
template <class Scene>
nlohmann::json scene_to_json(const Scene& scene) {
  nlohmann::json state;
  detail::for_each_member(scene, [&](const char* name, const auto& member) { state[name] = member; });
  state["ball_contacts"] = detail::histories_to_json(scene.ball_contacts);
  state["wall_contacts"] = detail::histories_to_json(scene.wall_contacts);
  return state;
}
/// Restores it, in a scene with the same laws and the same number of bodies. @throws std::runtime_error if it holds another
/// number of bodies
template <class Scene>
void scene_from_json(const nlohmann::json& state, Scene& scene) {
  if (state.at("position").size() != scene.balls.size() || state.at("walls").size() != scene.walls.size())
    throw std::runtime_error("the saved scene has another number of bodies");
  detail::for_each_member(scene, [&](const char* name, auto& member) { state.at(name).get_to(member); });
  detail::histories_from_json(state.at("ball_contacts"), scene.ball_contacts);
  detail::histories_from_json(state.at("wall_contacts"), scene.wall_contacts);
  scene.resume();
}

/// @throws common::InputError naming the file that cannot be written
inline void write_checkpoint(const std::string& path, const nlohmann::json& checkpoint) {
  common::OutputFile file(path);
  file.stream() << checkpoint << '\n';
  file.complete();
}
template <class Scene>
void save(const std::string& path, const Scene& scene) {
  write_checkpoint(path, scene_to_json(scene));
}

/// Restores what save() wrote. @throws std::runtime_error naming the file if it cannot be read or holds another number of bodies
template <class Scene>
void restore(const std::string& path, Scene& scene) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read " + path);
  try {
    scene_from_json(nlohmann::json::parse(file), scene);
  } catch (const std::exception& fault) {
    throw std::runtime_error(path + ": " + fault.what());
  }
}

}  // namespace dem
