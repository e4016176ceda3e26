// SPDX-License-Identifier: MIT
// The triaxial cell: a bottom and a top platen, and a cylinder that breathes: its radius is one degree of freedom, loaded by the
// pressure outside and by the grains inside. A pressure that acts on a mass needs no servo, and leaves no noise of one. The top
// platen may tilt about its centre, where the ram touches it.
#pragma once

#include "contactlaws/core/scalar.hpp"
#include "dem/simulation.hpp"

namespace probe {

using dem::Vec3;

struct Vessel {
  static constexpr std::size_t bottom = 0, top = 1, side = 2;  ///< ids of the walls
  // Steel discs of 40 mm on a specimen of 300 mm, and 4 mm of rubber, per area. The paper gives no numbers for the platens.
  static constexpr double platen_mass_per_area = 312.0;  ///< [kg/m^2]
  static constexpr double platen_thickness = 40e-3;      ///< [m]
  static constexpr double side_mass_per_area = 4.0;      ///< [kg/m^2]

  double pressure = 0.0;         ///< outside of the cylinder and on the top platen [Pa]
  double platen_mass = 0;        ///< [kg]
  double platen_inertia = 0;     ///< of a disc about a diameter [kg m^2]
  double side_mass = 0.0;        ///< [kg]
  bool top_moves = false;        ///< whether forces move the top platen up and down
  bool top_tilts = false;        ///< whether moments tilt it about the two horizontal axes
  bool side_moves = false;       ///< whether forces move the cylinder
  double membrane_radius = 0.0;  ///< mean radius, where a membrane stands in for the cylinder [m]; 0 without one

  /// Adds the walls to an empty scene: a cylinder about the z-axis from z = 0 up [m].
  template <class Scene>
  void add_to(Scene& scene, double radius, double height) {
    const contactlaws::ContactBody<double> rigid{0.0, 0.0, 0.0, 0.0, 0.0};
    scene.add(dem::Wall{rigid, Vec3::Zero(), Vec3::UnitZ()});
    dem::Wall lid{rigid, {0.0, 0.0, height}, -Vec3::UnitZ()};
    lid.extent = radius;
    scene.add(lid);
    dem::Wall cylinder{rigid, Vec3::Zero(), Vec3::UnitZ()};
    cylinder.radius = radius;
    scene.add(cylinder);
    platen_mass = platen_mass_per_area * contactlaws::pi<double>() * radius * radius;
    platen_inertia = platen_mass * (radius * radius / 4.0 + platen_thickness * platen_thickness / 12.0);
    side_mass = side_mass_per_area * 2.0 * contactlaws::pi<double>() * radius * height;
  }

  template <class Scene>
  static double height(const Scene& scene) {
    return scene.walls[top].point.z() - scene.walls[bottom].point.z();
  }
  template <class Scene>
  double radius(const Scene& scene) const {
    return membrane_radius > 0.0 ? membrane_radius : scene.walls[side].radius;
  }
  template <class Scene>
  double area(const Scene& scene) const {
    return contactlaws::pi<double>() * radius(scene) * radius(scene);
  }
  template <class Scene>
  double volume(const Scene& scene) const {
    return area(scene) * height(scene);
  }
  template <class Scene>
  double lateral_area(const Scene& scene) const {
    return 2.0 * contactlaws::pi<double>() * radius(scene) * height(scene);
  }
  /// Mean stress on the two platens; on the cylinder, or the pressure on the membrane [Pa].
  template <class Scene>
  double axial_stress(const Scene& scene) const {
    return (scene.walls[bottom].normal_force + scene.walls[top].normal_force) / 2.0 / area(scene);
  }
  template <class Scene>
  double radial_stress(const Scene& scene) const {
    if (membrane_radius > 0.0) return pressure;
    return scene.walls[side].normal_force / lateral_area(scene);
  }

  /// Before each step: new velocities of the walls that forces move.
  template <class Scene>
  void push(Scene& scene) const {
    const double kick = scene.kick();
    dem::Wall& lid = scene.walls[top];
    dem::Wall& cylinder = scene.walls[side];
    if (top_moves) {
      const Vec3 force(0.0, 0.0, lid.normal_force - pressure * area(scene) + platen_mass * scene.gravity.z());
      lid.velocity += scene.damped(force, lid.velocity) * (kick / platen_mass);
    }
    if (top_tilts) {
      const Vec3 moment(lid.torque.x(), lid.torque.y(), 0.0);
      lid.spin += scene.damped(moment, lid.spin) * (kick / platen_inertia);
    }
    if (side_moves) {
      const Vec3 force(cylinder.normal_force - pressure * lateral_area(scene), 0.0, 0.0);
      const Vec3 velocity(cylinder.radial_velocity, 0.0, 0.0);
      cylinder.radial_velocity += scene.damped(force, velocity).x() * (kick / side_mass);
    }
  }
};

}  // namespace probe
