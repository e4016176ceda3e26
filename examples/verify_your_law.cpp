// SPDX-License-Identifier: MIT
// How to check a force update of your own: an update with three faults that reached users of DEM codes, and the same update
// repaired.
//
//   verify_your_law [FOLDER]      writes the paths that show the faults there (PATH.csv of contact_path)
//
// Exit status: 0 if the checks find the three faults and none in the repaired update, 1 if not, 2 if FOLDER cannot be written.
#include <cmath>
#include <iostream>
#include <string>

#include "common/output_file.hpp"
#include "common/program.hpp"
#include "contactlaws/verify/verify.hpp"

namespace {

using namespace contactlaws;
using verify::Vector;

/// Linear spring and dashpot, shear displacement as history, friction: common in DEM codes.
struct MyLaw {
  bool repaired = false;
  double stiffness_normal = 1e6;  ///< [N/m]
  double stiffness_shear = 8e5;   ///< [N/m]
  double damping = 0.5;           ///< [kg/s]
  double friction = 0.4;          ///< [1]

  struct State {
    Vector shear = Vector(0, 0, 0);  ///< displacement of body 2 against body 1 [m]
  };

  verify::Interaction operator()(const verify::Bodies& pair, double dt, State& state) const {
    const auto& [a, b] = pair;
    const Vector n = pair.branch().normalized();
    const double overlap = a.radius + b.radius - pair.branch().norm();
    if (overlap <= 0) {
      state = {};
      return {Vector(0, 0, 0), Vector(0, 0, 0), Vector(0, 0, 0), Vector(0, 0, 0)};
    }
    const Vector arm1 = (a.radius - overlap / 2) * n, arm2 = (overlap / 2 - b.radius) * n;
    // Fault 1: the wrong sign of a cross product (as in Lethe, PR 889).
    const Vector at2 = b.velocity + b.spin.cross(arm2);
    const Vector at1 = a.velocity + (repaired ? a.spin.cross(arm1) : arm1.cross(a.spin));
    const Vector velocity = at2 - at1, slip = velocity - velocity.dot(n) * n;

    const double normal = stiffness_normal * overlap - damping * velocity.dot(n);
    // Fault 2: friction although the normal force pulls (Lethe, PR 1216).
    const double strength = friction * (repaired ? std::max(normal, 0.0) : std::abs(normal));

    const double length = state.shear.norm();
    state.shear -= state.shear.dot(n) * n;
    if (state.shear.norm() > 0) state.shear *= length / state.shear.norm();
    state.shear += slip * dt;
    Vector shear = -stiffness_shear * state.shear;
    if (shear.norm() > strength) {
      shear *= strength / shear.norm();
      state.shear = -shear / stiffness_shear;
    }
    const Vector force = normal * n + shear;
    return {force, Vector(-force), Vector(arm1.cross(-force)), Vector(arm2.cross(force))};
  }

  /// The history when bodies 1 and 2 swap places, as they do when a pair changes its owner.
  State exchanged(const State& state) const {
    // Fault 3: a vector from body 1 to body 2 must change its sign; a scalar must not (LAMMPS and LIGGGHTS treat both alike).
    return repaired ? State{-state.shear} : state;
  }
};

int run(const std::string& folder) {
  verify::Options options;
  options.radius1 = 7.5e-3;
  options.radius2 = 5e-3;
  options.mass1 = 4.7e-3;
  options.mass2 = 1.4e-3;
  options.overlap = 1e-5;
  options.claims.friction = 0.4;
  options.claims.range = 0.0;
  options.claims.continuous_at_touch = true;
  options.claims.passive = true;
  options.claims.no_ratcheting = true;
  options.folder = folder;
  if (!folder.empty()) common::create_folder(folder);

  MyLaw law;
  const verify::Report faulty = verify::check_all(law, options);
  std::cout << "A law with three faults\n" << faulty;
  law.repaired = true;
  const verify::Report repaired = verify::check_all(law, options);
  std::cout << "\nThe same, repaired\n" << repaired;

  bool found = repaired.passed();
  for (const char* property : {"rigid spin", "Coulomb bound", "change of owner"})
    found = found && faulty.find(property)->verdict == verify::Verdict::fail;
  return found ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Checks a force update that has three faults, and the same update repaired.", "verify_your_law");
  std::string folder;
  app.add_option("FOLDER", folder, "where to write the paths that show the faults (default: nowhere)");
  return common::run_program(app, argc, argv, [&folder] { return run(folder); });
}
