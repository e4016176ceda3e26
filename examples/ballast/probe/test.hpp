// SPDX-License-Identifier: MIT
// The test of one law on one sample (Tolomeo & McDowell 2022, section 3 and Fig. 5), in phases:
//
//   settle    gravity on; grains and top platen come down
//   confine   the pressure on cylinder and top platen grows linearly to its target
//   rest      until the unbalanced force is small, since it is the noise of the modulus
//   load      the bottom platen rises, the top one is held
//   hold      the bottom platen stops, until motion has died down
//   unload    the bottom platen goes down, until the deviator stress is what it was before loading
//
// The speed of the bottom platen grows with the strain of its phase, from 1e-8 m/s at 1e-9 to 1e-3 m/s at 1e-4 (the paper's
// timings), so that each decade of strain takes about as long.
#pragma once

#include <string>
#include <vector>

#include "micro.hpp"
#include "sample.hpp"

namespace probe {

enum class Phase { settle, confine, rest, load, hold, unload, done };
inline const std::array<const char*, 7> phase_names{{"settle", "confine", "rest", "load", "hold", "unload", "done"}};

struct TestPlan {
  double pressure = 150e3;         ///< [Pa]
  double settle_time = 0.1;        ///< [s]
  double confine_time = 0.5;       ///< [s]
  double unbalanced = 1e-7;        ///< mean unbalanced force over mean contact force at which rest ends [1]
  double longest_rest = 2.0;       ///< then the probe begins all the same, and says so [s]
  double hold_time = 0.03;         ///< [s]
  double slowest = 1e-8;           ///< speed of the bottom platen [m/s]
  double fastest = 1e-3;           ///< [m/s]
  double strain_slow = 1e-9;       ///< strain up to which it is slowest [1]
  double strain_fast = 1e-4;       ///< strain from which it is fastest [1]
  double most_strain = 1e-3;       ///< axial, at the end of loading [1]
  int points_per_decade = 20;      ///< of strain
  double safety = 0.6;             ///< share of the stable step
};

/// One row of a curve.
struct Point {
  double phase_strain;  ///< since the phase began, > 0 [1]
  double strain;        ///< since loading began [1]
  double axial, radial;              ///< stress on the platens and on the cylinder [Pa]
  double branch_axial, branch_radial;  ///< stress from branch vectors between grains [Pa]
  double coordination, touching_grains, fabric;
  double contacts, virgin, unloading, reloading;  ///< numbers
  double virgin_direction, unloading_direction, reloading_direction;  ///< to the horizontal [degrees]
  double force_over_largest, unbalanced;

  double deviator() const { return axial - radial; }
};

/// All of a test that changes, apart from scene and clumps.
struct TestState {
  Phase phase = Phase::settle;
  double phase_start = 0.0;      ///< [s]
  double height = 0.0;           ///< before loading [m]
  double start_place = 0.0;      ///< of the bottom platen when the phase began [m]
  double first_place = 0.0;      ///< of the bottom platen when loading began [m]
  double first_deviator = 0.0;   ///< [Pa]
  double next_point = 0.0;       ///< strain of the phase at which a point is due [1]
  double rest_unbalanced = 0.0;  ///< at the end of rest [1]
  double rest_time = 0.0;        ///< [s]
  double voids_ratio = 0.0;      ///< at the end of rest [1]
  double largest_force = 0.0;    ///< of a contact, at the end of loading [N]
  std::vector<Point> load, unload;
};

template <class Law>
class Test {
 public:
  TestPlan plan;
  Specimen<Law> specimen;
  TestState state;

  Test(const TestPlan& test_plan, const std::vector<dem::ClumpShape>& shapes, const Sample& sample)
      : plan(test_plan), specimen(make_law<Law>(friction), boundary_law(), shapes, sample) {
    specimen.scene.gravity = {0.0, 0.0, -9.81};
    specimen.vessel.top_moves = true;
    for (const dem::Clump& clump : specimen.clumps.all) solid_volume_ += clump.mass / granite.density;
    nominal_ = nominal_stiffness(plan.pressure);
  }

  double unbalanced() const { return dem::unbalanced_force(specimen.scene, specimen.clumps); }
  Micro micro() const { return observe(specimen.scene, specimen.clumps, solid_volume_); }

  /// One step of the test.
  void step() {
    auto& scene = specimen.scene;
    if (scene.steps % 100 == 0) {
      specimen.clumps.start(scene);
      scene.time_step = plan.safety * dem::stable_time_step(scene, specimen.clumps, nominal_);
    }
    control();
    specimen.step();
    if (state.phase == Phase::load || state.phase == Phase::unload) record_if_due();
    if (scene.steps % 50 == 0 || state.phase == Phase::load || state.phase == Phase::unload) end_phase_if_due();
  }

 private:
  double solid_volume_ = 0.0;  ///< [m^3]
  double nominal_ = 0.0;       ///< [N/m]

  double phase_time() const { return specimen.scene.time - state.phase_start; }
  double bottom() const { return specimen.scene.walls[Vessel::bottom].point.z(); }
  double phase_strain() const { return std::abs(bottom() - state.start_place) / state.height; }
  double deviator() const { return Vessel::axial_stress(specimen.scene) - Vessel::radial_stress(specimen.scene); }

  /// Pressure and speed of the bottom platen for the next step.
  void control() {
    auto& scene = specimen.scene;
    double speed = 0.0;
    switch (state.phase) {
      case Phase::confine: specimen.vessel.pressure = plan.pressure * std::min(1.0, phase_time() / plan.confine_time); break;
      case Phase::load: speed = probe_speed(); break;
      case Phase::unload: speed = -probe_speed(); break;
      default: break;
    }
    scene.walls[Vessel::bottom].velocity = {0.0, 0.0, speed};
  }
  double probe_speed() const {
    const double way = (phase_strain() - plan.strain_slow) / (plan.strain_fast - plan.strain_slow);
    return plan.slowest + (plan.fastest - plan.slowest) * std::clamp(way, 0.0, 1.0);
  }

  void record_if_due() {
    const double strain = phase_strain();
    if (strain < state.next_point) return;
    while (state.next_point <= strain) state.next_point *= std::pow(10.0, 1.0 / plan.points_per_decade);
    record();
  }
  void record() {
    const auto& scene = specimen.scene;
    const Micro now = micro();
    const auto number = [](const Branch& branch) { return static_cast<double>(branch.count); };
    const Point point{phase_strain(), (bottom() - state.first_place) / state.height, Vessel::axial_stress(scene),
                      Vessel::radial_stress(scene), now.stress(2, 2), (now.stress(0, 0) + now.stress(1, 1)) / 2.0,
                      now.coordination, now.touching_grains, now.fabric, number(now.all), number(now.virgin),
                      number(now.unloading), number(now.reloading), now.virgin.direction(), now.unloading.direction(),
                      now.reloading.direction(), now.force_over_largest, unbalanced()};
    (state.phase == Phase::load ? state.load : state.unload).push_back(point);
    state.largest_force = std::max(state.largest_force, now.largest_force);
  }

  bool phase_is_over() {
    switch (state.phase) {
      case Phase::settle: return phase_time() >= plan.settle_time;
      case Phase::confine: return phase_time() >= plan.confine_time;
      case Phase::rest:
        state.rest_unbalanced = unbalanced();
        return state.rest_unbalanced <= plan.unbalanced || phase_time() >= plan.longest_rest;
      case Phase::load: return phase_strain() >= plan.most_strain;
      case Phase::hold: return phase_time() >= plan.hold_time;
      case Phase::unload: return deviator() <= state.first_deviator || phase_strain() >= plan.most_strain;
      case Phase::done: return false;
    }
    return false;
  }

  void end_phase_if_due() {
    if (!phase_is_over()) return;
    auto& scene = specimen.scene;
    if (state.phase == Phase::rest) {
      state.rest_time = phase_time();
      state.voids_ratio = Vessel::area(scene) * Vessel::height(scene) / solid_volume_ - 1.0;
    }
    if (state.phase == Phase::load || state.phase == Phase::unload) record();
    state.phase = static_cast<Phase>(static_cast<int>(state.phase) + 1);
    state.phase_start = scene.time;
    state.start_place = bottom();
    state.next_point = plan.strain_slow;
    if (state.phase == Phase::confine) specimen.vessel.side_moves = true;
    if (state.phase == Phase::load) {
      state.height = Vessel::height(scene);
      state.first_place = bottom();
      state.first_deviator = deviator();
      specimen.vessel.top_moves = false;
      scene.walls[Vessel::top].velocity = Vec3::Zero();
    }
    if (state.phase == Phase::load || state.phase == Phase::unload) record();
  }
};

}  // namespace probe
