// SPDX-License-Identifier: MIT
// Grains in a cylindrical vessel about the z axis: a bottom and a top platen and a side wall, without friction, each held at a
// pressure by a servo or driven.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "contactlaws/laws.hpp"
#include "dem/assembly_measures.hpp"
#include "dem/cases.hpp"
#include "dem/energy_watch.hpp"
#include "dem/servo.hpp"
#include "dem/settle.hpp"
#include "dem/spatial_order.hpp"
#include "grading.hpp"

namespace class5 {

using dem::Vec3;

inline const contactlaws::ElasticMaterial<double> granite{29e9, 0.15, 2650.0};
constexpr double wall_modulus = 500e6;  ///< [Pa]
constexpr double friction = 0.4;        ///< of two grains [1]
constexpr double confinement = 150e3;   ///< [Pa]
constexpr double suction = 20e3;        ///< of wet grains [Pa]
constexpr double moisture_gap = 3e-3;   ///< grains this near are wetted [m]
constexpr double local_damping = 0.7;   ///< [1]
constexpr double step_safety = 0.8;     ///< share of the stable time step that is taken [1]
constexpr int look_every = 100;  ///< steps between two looks at time step, equilibrium and stiffness of the walls

using LinearLaw = contactlaws::LinearFriction<double>;
using DryLaw = contactlaws::DryHill<double>;
using WetLaw = contactlaws::Hill<double>;

/// The linear law of Table 7: an effective modulus of 500 MPa, k_n / k_s = 1.5.
inline LinearLaw linear_law(double mu) {
  contactlaws::LinearFrictionProperties<double> properties;
  properties.modulus = wall_modulus;
  properties.friction = mu;
  properties.stiffness_ratio = 1.0 / 1.5;
  return linear_friction(properties);
}

/// The hill law of Table 7, dry.
inline DryLaw hill_law() {
  contactlaws::DryHillProperties<double> properties;
  properties.friction = friction;
  return dry_hill(properties);
}
/// The same with suction between wet grains.
inline WetLaw wet_law() {
  contactlaws::HillProperties<double> properties;
  properties.friction = friction;
  properties.suction = suction;
  return hill(properties);
}

struct Size {
  double height, radius;  ///< [m]
  double volume() const { return pi * radius * radius * height; }
};

struct Grain {
  double radius;
  Vec3 position;
};

/// Grains and the vessel that holds them.
struct Packing {
  Size size{};
  std::vector<Grain> grains;
  std::vector<double> load;  ///< of each grain: sum of the normal forces on it [N]

  double porosity() const {
    double filled = 0.0;
    for (const Grain& grain : grains) filled += 4.0 / 3.0 * pi * grain.radius * grain.radius * grain.radius;
    return 1.0 - filled / size.volume();
  }
};
inline void to_json(nlohmann::json& json, const Packing& packing) {
  json = {{"height", packing.size.height},
          {"radius", packing.size.radius},
          {"load", packing.load},
          {"grains", nlohmann::json::array()}};
  for (const Grain& grain : packing.grains) json["grains"].push_back({grain.radius, grain.position});
}
inline void from_json(const nlohmann::json& json, Packing& packing) {
  packing = {{json.at("height"), json.at("radius")}, {}, json.at("load")};
  for (const nlohmann::json& grain : json.at("grains"))
    packing.grains.push_back({grain.at(0), grain.at(1).get<Vec3>()});
}

template <class Law>
class Vessel {
 public:
  enum : std::size_t { bottom, top, side };
  dem::Simulation<Law, LinearLaw> scene;

  Vessel(const Law& law, const Size& size, const std::vector<Grain>& grains) : scene(law, linear_law(0.0)) {
    const auto wall = contactlaws::plane(granite);
    scene.add(dem::Wall{wall, Vec3(0, 0, -size.height / 2.0), Vec3::UnitZ()});
    scene.add(dem::Wall{wall, Vec3(0, 0, size.height / 2.0), -Vec3::UnitZ()});
    dem::Wall cylinder{wall, Vec3::Zero(), Vec3::UnitZ()};
    cylinder.radius = size.radius;
    scene.add(cylinder);
    for (const Grain& grain : grains) scene.add(dem::Ball{contactlaws::sphere(granite, grain.radius), grain.position});
    scene.local_damping = local_damping;
    scene.skin = 0.1;     // the grains move little
    scene.log = nullptr;  // they overlap at the start
    for (dem::Servo& servo : servos_) servo.target = confinement;
  }

  Size size() const { return {scene.walls[top].point.z() - scene.walls[bottom].point.z(), scene.walls[side].radius}; }
  double area(std::size_t wall) const {
    return wall == side ? 2.0 * pi * size().radius * size().height : pi * size().radius * size().radius;
  }
  /// Pressure of the grains on a wall [Pa].
  double pressure(std::size_t wall) const { return scene.walls[wall].normal_force / area(wall); }
  double axial_stress() const { return (pressure(bottom) + pressure(top)) / 2.0; }
  double radial_stress() const { return pressure(side); }

  /// Whether it is time for a look.
  bool looks() const { return scene.steps % look_every == 0; }
  /// Renews the time step and the stiffnesses of the walls. @throws std::runtime_error if a grain has left the vessel or the step
  /// is unstable
  void look() {
    check_grains();
    scene.start();
    energy_.look(scene);
    scene.time_step = step_safety * dem::stable_time_step(scene);
    for (std::size_t wall = 0; wall < 3; ++wall) servos_[wall].measure(scene, wall);
  }
  void hold_pressure(std::size_t wall) {
    drive(wall, servos_[wall].speed(scene.walls[wall], area(wall), scene.time_step));
  }
  void step() {
    scene.step();
    energy_.add_step(scene);
  }
  /// Takes the grains' velocities.
  void calm() {
    for (std::size_t b = 0; b < scene.balls.size(); ++b) scene.release(static_cast<int>(b));
    energy_.reset();
  }
  /// Drives a wall towards the grains [m/s].
  void drive(std::size_t wall, double speed) {
    if (wall == side)
      scene.walls[side].radial_velocity = -speed;
    else
      scene.walls[wall].velocity = speed * scene.walls[wall].facing;
  }

  /// What a test begins with. The vessel's middle becomes the origin.
  Packing packing() const {
    const Vec3 middle = (scene.walls[bottom].point + scene.walls[top].point) / 2.0;
    Packing now{size(), {}, std::vector<double>(scene.balls.size())};
    for (std::size_t b = 0; b < scene.balls.size(); ++b)
      now.grains.push_back({scene.balls.radius[b], scene.balls.position[b] - middle});
    dem::detail::for_each_contact(
        scene, [&now](const auto&, const auto& contacts, std::size_t c, const auto& outcome, bool ball_first) {
          if (ball_first) now.load[contacts.first(c)] += outcome.response.normal_force;
          now.load[contacts.second(c)] += outcome.response.normal_force;
        });
    return now;
  }

 private:
  std::array<dem::Servo, 3> servos_;
  dem::EnergyWatch energy_;

  void check_grains() const {
    const Size now = size();
    const double low = scene.walls[bottom].point.z(), high = scene.walls[top].point.z();
    for (std::size_t b = 0; b < scene.balls.size(); ++b) {
      const Vec3& x = scene.balls.position[b];
      const bool inside = x.z() > low && x.z() < high && std::hypot(x.x(), x.y()) < now.radius;  // false for a NaN
      if (!inside)
        throw std::runtime_error("grain " + std::to_string(b) + " left the vessel at " + std::to_string(scene.time) +
                                 " s (step " + std::to_string(scene.steps) +
                                 "). Try a shorter time step or slower walls.");
    }
  }
};

}  // namespace class5
