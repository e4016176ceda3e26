// SPDX-License-Identifier: MIT
// A scene's progress as JSON, and back: positions, velocities, forces and every contact's history. What the scene is made of
// (materials, laws, gravity) stays in the program that builds it. A restored scene goes on bit for bit as the saved one.
#pragma once

#include <fstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "common/output_file.hpp"
#include "simulation.hpp"

namespace dem {

namespace detail {

template <class Vector>
nlohmann::json to_json(const std::vector<Vector>& vectors) {
  nlohmann::json list = nlohmann::json::array();
  for (const Vec3& v : vectors) list.push_back({v.x(), v.y(), v.z()});
  return list;
}
template <class Vector>
void from_json(const nlohmann::json& list, std::vector<Vector>& vectors) {
  for (std::size_t i = 0; i < vectors.size(); ++i)
    vectors[i] = Vec3(list.at(i).at(0), list.at(i).at(1), list.at(i).at(2));
}

template <class Law, class T>
nlohmann::json to_json(const Contacts<Law, T>& contacts) {
  nlohmann::json list = nlohmann::json::array();
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    std::vector<double> history(Law::state_size);
    Law::store(contacts.state(c), history.data());
    list.push_back({{"bodies", {contacts.first(c), contacts.second(c)}}, {"history", history}});
  }
  return list;
}
template <class Law, class T>
void from_json(const nlohmann::json& list, Contacts<Law, T>& contacts) {
  for (const nlohmann::json& entry : list) {
    const Pair bodies{entry.at("bodies").at(0), entry.at("bodies").at(1)};
    const auto at = std::lower_bound(contacts.bodies.begin(), contacts.bodies.end(), bodies);
    if (at == contacts.bodies.end() || !(*at == bodies)) continue;  // listed then, but too far apart to have a history
    const std::vector<double> history = entry.at("history");
    contacts.set_state(static_cast<std::size_t>(at - contacts.bodies.begin()), Law::load(history.data()));
  }
}

}  // namespace detail

/// @throws common::InputError naming the file that cannot be written
template <class Scene>
void save(const std::string& path, const Scene& scene) {
  std::vector<Vec3> wall_points;
  for (const Wall& wall : scene.walls) wall_points.push_back(wall.point);
  const nlohmann::json checkpoint = {
      {"time", scene.time},
      {"steps", scene.steps},
      {"last_step", scene.last_step},
      {"position", detail::to_json(scene.balls.position)},
      {"velocity", detail::to_json(scene.balls.velocity)},
      {"spin", detail::to_json(scene.balls.spin)},
      {"force", detail::to_json(scene.balls.force)},
      {"moment", detail::to_json(scene.balls.moment)},
      {"walls", detail::to_json(wall_points)},
      {"ball_contacts", detail::to_json(scene.ball_contacts)},
      {"wall_contacts", detail::to_json(scene.wall_contacts)},
  };
  common::OutputFile file(path);
  file.stream() << checkpoint.dump(1) << '\n';
  file.complete();
}

/// Takes up what save() wrote, in a scene built alike that has not moved yet. @throws std::runtime_error if the file cannot
/// be read, or holds another number of bodies
template <class Scene>
void restore(const std::string& path, Scene& scene) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read " + path);
  const nlohmann::json checkpoint = nlohmann::json::parse(file);
  if (checkpoint.at("position").size() != scene.balls.size() || checkpoint.at("walls").size() != scene.walls.size())
    throw std::runtime_error(path + " belongs to a scene with another number of bodies");

  std::vector<Vec3> wall_points(scene.walls.size());
  detail::from_json(checkpoint.at("walls"), wall_points);
  for (std::size_t w = 0; w < wall_points.size(); ++w) scene.walls[w].point = wall_points[w];
  detail::from_json(checkpoint.at("position"), scene.balls.position);
  detail::from_json(checkpoint.at("velocity"), scene.balls.velocity);
  detail::from_json(checkpoint.at("spin"), scene.balls.spin);
  scene.start();  // lists the contacts, in these positions
  detail::from_json(checkpoint.at("ball_contacts"), scene.ball_contacts);
  detail::from_json(checkpoint.at("wall_contacts"), scene.wall_contacts);
  detail::from_json(checkpoint.at("force"), scene.balls.force);
  detail::from_json(checkpoint.at("moment"), scene.balls.moment);
  scene.time = checkpoint.at("time");
  scene.steps = checkpoint.at("steps");
  scene.last_step = checkpoint.at("last_step");
}

}  // namespace dem
