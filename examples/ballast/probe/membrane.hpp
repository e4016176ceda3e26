// SPDX-License-Identifier: MIT
// The flexible membrane of the triaxial cell (Tolomeo & McDowell 2022, Table 2): bonded spheres in a triangular lattice around
// the specimen. The pressure outside acts on the true area of each triangle, a third on each corner. Spheres meet pebbles
// without friction, with a linear stiffness, and do not meet each other. The lowest and the highest row are clamped to the rims of
// the platens and move with them.
//
// The spheres meet the platens too, as pebbles do. Without that the pressure blows the membrane through the gap between a platen
// and the grains, past the platen's face: at 150 kPa a pocket then grows under the bottom platen until grains are lost.
//
// Bonds: the paper prints 1e3 N/m. Such a membrane balloons between grains and fails beyond 95 kPa. A triangular lattice of bonds k
// is a sheet of stiffness E t = 2 k / sqrt(3) and Poisson's ratio 1/3; 4 mm of rubber of 1.4 MPa have k = 5e3 N/m, used here.
//
// The spheres are a scene of their own, with copies of the outer pebbles that grains move. Only copies with listed contacts are
// kept up to date; all are before neighbours are listed.
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

  dem::Simulation<Boundary> scene;  ///< spheres first, then copies of pebbles; walls: bottom and top platen
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
    const contactlaws::ContactBody<double> rigid{0.0, 0.0, 0.0, 0.0, 0.0};
    dem::Wall bottom{rigid, Vec3::Zero(), Vec3::UnitZ()}, top{rigid, {0.0, 0.0, height}, -Vec3::UnitZ()};
    bottom.group = top.group = pebbles_group;  // pebbles meet the platens in the scene of the grains
    top.extent = radius;
    scene.add(bottom);
    scene.add(top);
  }

  std::size_t spheres() const { return spheres_; }

  /// Copies the outer pebbles of the grains.
  template <class Grains>
  void surround(const Grains& grains) {
    const double inner = mean_radius() - settings_.reach;
    for (std::size_t b = 0; b < grains.balls.size(); ++b) {
      const Vec3 place = grains.balls.position[b];
      if (std::hypot(place.x(), place.y()) + grains.balls.radius[b] < inner) continue;
      scene.add(dem::Ball{grains.balls.side[b], place, Vec3::Zero(), Vec3::Zero(), false, pebbles_group});
      pebble_.push_back(b);
    }
  }

  /// After the grains' step: moves the membrane over the same step, and adds its forces to the clumps.
  template <class Grains>
  void step(Grains& grains, dem::Clumps& clumps, double pressure, const dem::Wall& bottom, const dem::Wall& top) {
    scene.time_step = grains.last_step;
    move_with(bottom, 0, 0);
    move_with(top, 1, spheres_ - static_cast<std::size_t>(settings_.around));
    bool moved_far = scene.begin_step() || listed_.size() != clumps.size();
    for (std::size_t i = 0; i < clumps.size() && !moved_far; ++i)
      moved_far = !clumps.all[i].is_near(listed_[i], scene.allowed_motion());
    if (moved_far) {
      clumps.place_all(grains);
      for (std::size_t k = 0; k < pebble_.size(); ++k) copy(grains, k);
    } else {
      for (const std::size_t k : active_) copy(grains, k);
    }
    scene.finish_step(moved_far);
    if (moved_far) note_listing(grains, clumps);
    add_outer_forces(pressure);
    for_each_push([&](std::size_t pebble, const Vec3& force) {
      dem::Clump& clump = clumps.all[static_cast<std::size_t>(grains.balls.group[pebble])];
      clump.force += force;
      clump.torque += Vec3(grains.balls.position[pebble] - clump.position).cross(force);
    });
  }
  /// Calls `visit(pebble, force)`: the id of a pebble among the grains' balls, and the force of the membrane on it [N]. Without
  /// friction it passes through the pebble's centre.
  template <class Visit>
  void for_each_push(const Visit& visit) const {
    for (const std::size_t k : active_) visit(pebble_[k], Vec3(scene.balls.force[spheres_ + k]));
  }

  /// Adds bonds and pressure to the forces of the contacts. (The fourth number of a row is the radius, the same for all spheres.)
  void add_outer_forces(double pressure) {
    std::vector<dem::Row>&force = scene.balls.force, &place = scene.balls.position;
    for (const Bond& bond : bonds) {
      const Eigen::Vector4d along = place[bond.two].all() - place[bond.one].all();
      const double stretched = 1.0 - bond.length / std::sqrt(along.squaredNorm());
      const Eigen::Vector4d pull = along * (settings_.bond_stiffness * stretched);
      force[bond.one].all() += pull;
      force[bond.two].all() -= pull;
    }
    for (const auto& [a, b, c] : triangles) {
      const Vec3 one = place[b] - place[a], two = place[c] - place[a];
      const Vec3 third = one.cross(two) * (-pressure / 6.0);  // of the pressure on half of one x two
      force[a] += third;
      force[b] += third;
      force[c] += third;
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

  /// After a restored scene: the next step copies all pebbles and lists neighbours.
  void resume() { listed_.clear(); }

 private:
  static constexpr int spheres_group = -2, pebbles_group = 0;
  MembraneSettings settings_;
  std::size_t spheres_ = 0;
  std::vector<std::size_t> pebble_;  ///< of each copy, its id among the grains' balls
  std::vector<std::size_t> active_;  ///< copies with listed contacts
  std::vector<dem::Clump> listed_;   ///< as they were when neighbours were listed; empty before

  /// Wall `id` and the row that begins with sphere `first` move as the platen does.
  void move_with(const dem::Wall& platen, std::size_t id, std::size_t first) {
    dem::Wall& own = scene.walls[id];
    own.velocity = platen.velocity;
    own.spin = platen.spin;
    for (std::size_t b = first; b < first + static_cast<std::size_t>(settings_.around); ++b)
      scene.balls.velocity[b] = own.velocity + own.spin.cross(Vec3(scene.balls.position[b] - own.point));
  }
  template <class Grains>
  void copy(const Grains& grains, std::size_t k) {
    scene.balls.position[spheres_ + k].all() = grains.balls.position[pebble_[k]].all();
    scene.balls.velocity[spheres_ + k].all() = grains.balls.velocity[pebble_[k]].all();
  }
  template <class Grains>
  void note_listing(const Grains& grains, dem::Clumps& clumps) {
    listed_ = clumps.all;
    active_.clear();
    std::vector<std::size_t> placed;
    for (std::size_t k = 0; k < pebble_.size(); ++k) {
      const std::size_t ball = spheres_ + k;
      if (!scene.ball_contacts.has_first(ball) && !scene.ball_contacts.has_second(ball)) continue;
      active_.push_back(k);
      placed.push_back(pebble_[k]);
    }
    clumps.keep_placed(grains, placed);
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
