// SPDX-License-Identifier: MIT
// Notices a step that is unstable: the energy of the scene rises by more than the walls' work. Without a formula of its own:
// kinetic, stored (contactlaws' stored_energy()) and potential energy, from look to look.
#pragma once

#include <stdexcept>
#include <string>

#include "measures.hpp"

namespace dem {

class EnergyWatch {
 public:
  /// To be called after each step: adds what the walls have worked.
  template <class Scene>
  void add_step(const Scene& scene) {
    for (const Wall& wall : scene.walls)
      work_ -= (wall.force.dot(wall.velocity) + wall.torque.dot(wall.spin) + wall.normal_force * wall.radial_velocity) *
               scene.last_step;
  }

  /// To be called now and then, say every hundred steps. @throws std::runtime_error if the energy that the scene had at the last
  /// look has doubled, the work apart. (Friction and damping only take energy. The default shear history may create some, but
  /// less than the shear energy stored.)
  /// Bodies of the program's own, such as clumps, add their kinetic and potential energy [J].
  template <class Scene>
  void look(const Scene& scene, double kinetic_of_bodies = 0.0, double potential_of_bodies = 0.0) {
    double scale = kinetic_of_bodies, energy = kinetic_of_bodies + potential_of_bodies;
    const Balls& balls = scene.balls;
    for (std::size_t b = 0; b < balls.size(); ++b) {
      if (!balls.free[b]) continue;
      const double kinetic =
          balls.mass[b] * balls.velocity[b].squaredNorm() / 2.0 + balls.inertia[b] * balls.spin[b].squaredNorm() / 2.0;
      scale += kinetic;
      energy += kinetic - balls.mass[b] * scene.gravity.dot(balls.position[b]);
    }
    detail::for_each_contact(
        scene, [&](const auto& law, const auto& contacts, std::size_t c, const auto& outcome, bool) {
          const double stored = law.stored_energy(contacts.pair(c), outcome.geometry.overlap, contacts.state(c));
          scale += std::abs(stored);
          energy += stored;
        });
    if (looked_ && !(energy - energy_ - work_ <= scale_))  // true for a NaN
      throw std::runtime_error("the energy rose from " + std::to_string(energy_) + " to " + std::to_string(energy) +
                               " J while the walls worked " + std::to_string(work_) + " J, at " +
                               std::to_string(scene.time) + " s (step " + std::to_string(scene.steps) +
                               "): the time step is unstable. Try a smaller share of the stable step.");
    looked_ = true;
    energy_ = energy;
    scale_ = scale;
    work_ = 0.0;
  }

  /// After a change from outside: a new law, grains brought to rest or wetted.
  void reset() { *this = EnergyWatch(); }

 private:
  bool looked_ = false;
  double energy_ = 0.0, scale_ = 0.0, work_ = 0.0;  // [J]
};

}  // namespace dem
