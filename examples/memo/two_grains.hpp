// SPDX-License-Identifier: MIT
// The memo's scene of two granite grains (Figures 8 and 9): a 5 mm grain touches one of 7.5 mm, which is held below it.
#pragma once

#include "common/output_file.hpp"
#include "common/progress.hpp"
#include "common/report.hpp"
#include "common/table.hpp"
#include "contactlaws/laws.hpp"
#include "dem/simulation.hpp"

namespace memo {

using common::CheckedNumbers;
using common::OutputFolder;
using common::stop_if_requested;
using common::Table;
using dem::Vec3;

// Tolerances on relative errors.
/// The motion is prescribed. What remains is rounding: of positions of 1e-2 m in overlaps of 1e-4 m, over some hundred steps.
constexpr double prescribed = 1e-9;
/// The end of a run to equilibrium, which stops at an unbalanced ratio of 1e-9.
constexpr double equilibrium = 1e-6;
/// An arc is followed in chords of 8e-6 rad; the error is the square of that, times some hundred chords.
constexpr double along_arc = 1e-8;

inline const contactlaws::ElasticMaterial<double> granite{29e9, 0.15, 2650.0};
constexpr double friction = 0.4;           ///< mu [1]
constexpr double suction = 200e3;          ///< psi [Pa]
constexpr double damping_constant = 0.07;  ///< alpha_h [1]
constexpr double local_damping = 0.7;      ///< [1]
constexpr double bottom_radius = 7.5e-3;   ///< [m]
constexpr double top_radius = 5e-3;        ///< [m]
constexpr double depth = 0.1e-3;           ///< overlap at the end of stage A [m]
constexpr double turn = 0.02;              ///< of the top grain in stage B [rad]

/// The hill law with all of the memo's properties.
inline contactlaws::Hill<double> damped_hill_law() {
  contactlaws::HillProperties<double> properties;
  properties.friction = friction;
  properties.suction = suction;
  properties.damping_constant = damping_constant;
  return hill(properties);
}

/// Gap, displacement and forces at the contact.
struct ContactReading {
  double gap;                 ///< [m], negative when overlapping
  double normal_force;        ///< compression > 0 [N]
  double shear_displacement;  ///< tangential displacement so far [m]
  double shear_force;         ///< [N]
};

template <class Law>
class TwoGrains {
 public:
  dem::Simulation<Law> scene;
  const int bottom;
  const int top;

  explicit TwoGrains(const Law& law, double step = 1e-6)
      : scene(law),
        bottom(scene.add(dem::Ball{contactlaws::sphere(granite, bottom_radius), Vec3::Zero()})),
        top(scene.add(dem::Ball{contactlaws::sphere(granite, top_radius), {0.0, 0.0, bottom_radius + top_radius}})) {
    scene.drive(bottom, Vec3::Zero());
    scene.drive(top, Vec3::Zero());
    scene.time_step = step;
  }

  /// Moves the top grain up (or down, < 0) by `distance` [m] in so many steps.
  template <class Record>
  void lift(double distance, int steps, const Record& record) {
    run({0.0, 0.0, distance / (steps * scene.time_step)}, Vec3::Zero(), steps, record);
  }
  /// Turns the top grain about its own centre by `angle` [rad] in so many steps.
  template <class Record>
  void spin(double angle, int steps, const Record& record) {
    run(Vec3::Zero(), {0.0, angle / (steps * scene.time_step), 0.0}, steps, record);
  }
  /// The top grain at this velocity [m/s] and spin [rad/s], for so many steps.
  template <class Record>
  void run(const Vec3& velocity, const Vec3& spin, int steps, const Record& record) {
    scene.drive(top, velocity, spin);
    for (int i = 0; i < steps; ++i) {
      stop_if_requested();
      scene.step();
      const auto motion = scene.ball_contact(0).motion;
      displaced_ += (motion.velocity - motion.normal * motion.velocity.dot(motion.normal)).norm() * motion.dt;
      record();
    }
  }

  ContactReading read() const {
    const auto contact = scene.ball_contact(0);
    const Vec3& n = contact.geometry.normal;
    const Vec3& force = contact.response.force;
    return {-contact.geometry.overlap, force.dot(n), displaced_, (force - n * force.dot(n)).norm()};
  }

 private:
  double displaced_ = 0.0;
};

}  // namespace memo
