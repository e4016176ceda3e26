// SPDX-License-Identifier: MIT
// The flexible membrane of the triaxial cell (Tolomeo & McDowell 2022, Table 2): bonded spheres in a triangular lattice around
// the specimen. The pressure outside acts on the true area of each triangle, a third on each corner. Spheres meet pebbles
// without friction, with a linear stiffness, and do not meet each other. The lowest and the highest row move with the platens.
//
// Bonds: the paper prints 1e3 N/m. Such a membrane balloons between grains and fails beyond 95 kPa. A triangular lattice of bonds k
// is a sheet of stiffness E t = 2 k / sqrt(3) and Poisson's ratio 1/3; 4 mm of rubber of 1.4 MPa have k = 5e3 N/m, used here.
//
// The spheres are a scene of their own, with copies of the outer pebbles that grains move.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "dem/clumps.hpp"
#include "laws.hpp"

namespace probe {

using dem::Vec3;

struct MembraneSettings {
  double sphere_radius = 5.4e-3;   ///< [m]
  double density = 248.0;          ///< of a sphere [kg/m^3]: the overlapping spheres weigh as much as the rubber
  double contact_stiffness = 1e6;  ///< [N/m]
  double bond_stiffness = 5e3;     ///< [N/m]
  int around = 150, rows = 84;     ///< numbers of spheres: 12 600
  double reach = 30e-3;            ///< pebbles within this distance of it may touch it [m]

  /// The paper's lattice around a vessel of another size [m].
  static MembraneSettings around_vessel(double radius, double height) {
    MembraneSettings settings;
    settings.around = static_cast<int>(std::lround(settings.around * radius / 0.15));
    settings.rows = static_cast<int>(std::lround(settings.rows * height / 0.45));
    return settings;
  }
};

class Membrane {
 public:
  struct Bond {
    std::size_t one, two;
    double length;  ///< without force [m]
  };

  dem::Simulation<Boundary> scene;  ///< spheres first, then copies of pebbles
  std::vector<Bond> bonds;
  std::vector<std::array<std::size_t, 3>> triangles;  ///< corners, counter-clockwise from outside

  /// Around a cylinder of this radius, from z = 0 up to `height` [m].
  Membrane(const MembraneSettings& settings, double radius, double height)
      : scene(boundary_law(settings.contact_stiffness)), settings_(settings) {
    scene.local_damping = 0.7;
    scene.log = nullptr;
    const contactlaws::ElasticMaterial<double> rubber{1e6, 0.25, settings.density};  // the moduli are not read
    const double pi = contactlaws::pi<double>(), distance = radius + settings.sphere_radius;
    for (int row = 0; row < settings.rows; ++row)
      for (int i = 0; i < settings.around; ++i) {
        const double turn = 2.0 * pi * (i + (row % 2) / 2.0) / settings.around;
        const Vec3 place(distance * std::cos(turn), distance * std::sin(turn), height * row / (settings.rows - 1));
        const bool clamped = row == 0 || row == settings.rows - 1;
        scene.add(dem::Ball{contactlaws::sphere(rubber, settings.sphere_radius), place, Vec3::Zero(), Vec3::Zero(),
                            !clamped, spheres_group});
      }
    spheres_ = scene.balls.size();
    connect();
  }

  std::size_t spheres() const { return spheres_; }

  /// Copies the outer pebbles of the clumps, whose places are kept up to date from now on.
  template <class Grains>
  void surround(const Grains& grains, dem::Clumps& clumps) {
    const double inner = mean_radius() - settings_.reach;
    for (std::size_t b = 0; b < grains.balls.size(); ++b) {
      const Vec3 place = grains.balls.position[b];
      if (std::hypot(place.x(), place.y()) + grains.balls.radius[b] < inner) continue;
      scene.add(dem::Ball{grains.balls.side[b], place, Vec3::Zero(), Vec3::Zero(), false, pebbles_group});
      pebble_.push_back(b);
      clumps.keep_placed(b);
    }
  }

  /// After the grains' step: moves the membrane over the same step, and adds its forces to the clumps.
  template <class Grains>
  void step(const Grains& grains, dem::Clumps& clumps, double pressure, double bottom_speed, double top_speed) {
    scene.time_step = grains.last_step;
    const auto in_row = static_cast<std::size_t>(settings_.around);
    for (std::size_t i = 0; i < in_row; ++i) {
      scene.balls.velocity[i] = Vec3(0.0, 0.0, bottom_speed);
      scene.balls.velocity[spheres_ - 1 - i] = Vec3(0.0, 0.0, top_speed);
    }
    bool moved_far = scene.begin_step() || listed_at_.size() != pebble_.size();
    const double allowed = scene.allowed_motion() * scene.allowed_motion();
    for (std::size_t k = 0; k < pebble_.size(); ++k) {
      const std::size_t copy = spheres_ + k;
      scene.balls.position[copy].all() = grains.balls.position[pebble_[k]].all();
      scene.balls.velocity[copy].all() = grains.balls.velocity[pebble_[k]].all();
      moved_far = moved_far || (scene.balls.position[copy] - listed_at_[k]).squaredNorm() > allowed;
    }
    scene.finish_step(moved_far);
    if (moved_far) note_places();
    add_outer_forces(pressure);
    for (std::size_t k = 0; k < pebble_.size(); ++k) {
      const Vec3 force = scene.balls.force[spheres_ + k];
      if (!(force.squaredNorm() > 0.0)) continue;
      dem::Clump& clump = clumps.all[static_cast<std::size_t>(grains.balls.group[pebble_[k]])];
      clump.force += force;
      clump.torque += Vec3(grains.balls.position[pebble_[k]] - clump.position).cross(force);
    }
  }

  /// Adds bonds and pressure to the forces of the contacts.
  void add_outer_forces(double pressure) {
    auto& balls = scene.balls;
    for (const Bond& bond : bonds) {
      const Vec3 force = tension(bond) * (balls.position[bond.two] - balls.position[bond.one]).normalized();
      balls.force[bond.one] = balls.force[bond.one] + force;
      balls.force[bond.two] = balls.force[bond.two] - force;
    }
    for (const auto& corner : triangles) {
      const Vec3 third = area(corner) * (-pressure / 3.0);
      for (const std::size_t c : corner) balls.force[c] = balls.force[c] + third;
    }
  }
  double tension(const Bond& bond) const {
    const double length = (scene.balls.position[bond.two] - scene.balls.position[bond.one]).norm();
    return settings_.bond_stiffness * (length - bond.length);
  }

  /// Mean distance of the inner surface from the axis [m].
  double mean_radius() const {
    double sum = 0.0;
    for (std::size_t b = 0; b < spheres_; ++b)
      sum += std::hypot(scene.balls.position[b].x(), scene.balls.position[b].y());
    return sum / static_cast<double>(spheres_) - settings_.sphere_radius;
  }
  /// Mean length of the bonds over that without force [1].
  double mean_stretch() const {
    double sum = 0.0;
    for (const Bond& bond : bonds) sum += 1.0 + tension(bond) / settings_.bond_stiffness / bond.length;
    return sum / static_cast<double>(bonds.size());
  }

  /// After a restored scene.
  void resume() { note_places(); }

 private:
  static constexpr int spheres_group = -2, pebbles_group = 0;
  MembraneSettings settings_;
  std::size_t spheres_ = 0;
  std::vector<std::size_t> pebble_;  ///< of each copy, its id among the grains' balls
  std::vector<Vec3> listed_at_;      ///< places of the copies when neighbours were listed [m]

  Vec3 area(const std::array<std::size_t, 3>& corner) const {  // outward [m^2]
    const Vec3 a = scene.balls.position[corner[0]];
    return 0.5 * (scene.balls.position[corner[1]] - a).cross(scene.balls.position[corner[2]] - a);
  }
  void note_places() {
    listed_at_.clear();
    for (std::size_t k = 0; k < pebble_.size(); ++k) listed_at_.push_back(scene.balls.position[spheres_ + k]);
  }

  void connect() {
    const int n = settings_.around;
    const auto id = [n](int row, int i) { return static_cast<std::size_t>(row * n + (i + n) % n); };
    const auto bond = [this](std::size_t one, std::size_t two) {
      bonds.push_back({one, two, (scene.balls.position[two] - scene.balls.position[one]).norm()});
    };
    for (int row = 0; row < settings_.rows; ++row)
      for (int i = 0; i < n; ++i) {
        bond(id(row, i), id(row, i + 1));
        if (row + 1 == settings_.rows) continue;
        // Odd rows are turned by half a spacing, so above sphere i stand i - 1 and i, or i and i + 1.
        const int left = row % 2 == 0 ? i - 1 : i;
        bond(id(row, i), id(row + 1, left));
        bond(id(row, i), id(row + 1, left + 1));
        triangles.push_back({id(row, i), id(row + 1, left + 1), id(row + 1, left)});
        triangles.push_back({id(row, i), id(row, i + 1), id(row + 1, left + 1)});
      }
  }
};

}  // namespace probe
