// SPDX-License-Identifier: MIT
// The test of one law on one sample (Tolomeo & McDowell 2022, section 3 and Fig. 5), in phases:
//
//   settle    gravity on; grains and top platen come down
//   confine   the pressure on cylinder and top platen grows linearly to its target
//   rest      until the unbalanced force is small, since it is the noise of the modulus; with little and much damping in turn
//   load      the bottom platen rises, the top one is held
//   hold      the bottom platen stops, until motion has died down
//   unload    the bottom platen goes down, until the deviator stress is what it was before loading
//
// The speed of the bottom platen grows with the strain of its phase, from 1e-8 m/s at 1e-9 to 1e-3 m/s at 1e-4 (the paper's
// timings), so that each decade of strain takes about as long.
//
// Local damping of .7 slows the grains that carry nothing but their weight: at the frictionless cylinder they slide on for seconds,
// and their impacts on the platen are larger than the stress of a strain of 1e-7. Under little damping they fall within .2 s.
#pragma once

#include "dem/energy_watch.hpp"
#include "micro.hpp"
#include "packing.hpp"
#include "test_state.hpp"

namespace probe {

template <class Law>
class Test {
 public:
  TestPlan plan;
  Specimen<Law> specimen;
  TestState state;

  Test(const TestPlan& test_plan, const std::vector<dem::ClumpShape>& shapes, const Sample& sample)
      : plan(test_plan), specimen(make_law<Law>(friction), boundary_law(), shapes, sample) {
    state.at_rest = sample;
    if (plan.membrane) specimen.add_membrane(MembraneSettings::around_vessel(sample.radius, sample.height));
    specimen.scene.gravity = {0.0, 0.0, -9.81};
    specimen.vessel.top_moves = true;
    specimen.vessel.top_tilts = plan.tilts;
    for (const dem::Clump& clump : specimen.clumps.all) solid_volume_ += clump.mass / granite.density;
    nominal_ = nominal_stiffness(plan.pressure);
  }

  double unbalanced() const { return dem::unbalanced_force(specimen.scene, specimen.clumps); }
  Micro micro() const { return observe(specimen, solid_volume_); }

  /// Runs the test to its end, from where an earlier run left it. @throws common::Stopped; std::runtime_error if a step is
  /// unstable or a grain leaves the vessel
  TestState run(dem::CaseControl& control) {
    control.resume(specimen.scene, *this);
    while (state.phase != Phase::done) {
      const Phase before = state.phase;
      step();
      if (state.phase != before) control.save(specimen.scene, *this);
      if (specimen.scene.steps % look_every == 0) {
        check();
        control.between_steps(specimen.scene, *this,
                              share_done(plan, state.phase, phase_time(), Vessel::height(specimen.scene)));
      }
    }
    return state;
  }

  /// One step of the test.
  void step() {
    auto& scene = specimen.scene;
    if (scene.steps % look_every == 0) {
      specimen.clumps.start(scene);
      scene.time_step = plan.safety * dem::stable_time_step(scene, specimen.clumps, nominal_);
    }
    control_walls();
    scene.local_damping = falls() ? plan.fall_damping : plan.damping;
    specimen.step();
    watch_.add_step(scene);
    const bool probes = state.phase == Phase::load || state.phase == Phase::unload;
    if (probes) record_if_due();
    if (scene.steps % look_every == 0 || probes) end_phase_if_due();
  }

  friend void to_json(nlohmann::json& json, const Test& test) {
    json = {{"test", test.state}, {"specimen", test.specimen}, {"before_noise", test.before_noise_}};
  }
  friend void from_json(const nlohmann::json& json, Test& test) {
    json.at("test").get_to(test.state);
    test.specimen.set_skin(test.state.phase < Phase::load ? resting_skin : probe_skin);
    json.at("specimen").get_to(test.specimen);
    test.before_noise_ = json.at("before_noise");
  }

 private:
  double solid_volume_ = 0.0;  ///< [m^3]
  double nominal_ = 0.0;       ///< [N/m]
  dem::EnergyWatch watch_;
  nlohmann::json before_noise_;  ///< scene and state to go back to after a probe of noise; null outside of one
  static constexpr double probe_skin = 0.1e-3;  ///< grains hardly move from loading on [m]

  double phase_time() const { return specimen.scene.time - state.phase_start; }
  bool falls() const {
    return state.phase == Phase::rest && std::fmod(phase_time(), 2.0 * plan.fall_time) < plan.fall_time;
  }
  double bottom() const { return specimen.scene.walls[Vessel::bottom].point.z(); }
  double phase_strain() const { return std::abs(bottom() - state.start_place) / state.height; }
  double deviator() const {
    return specimen.vessel.axial_stress(specimen.scene) - specimen.vessel.radial_stress(specimen.scene);
  }

  /// Pressure and speed of the bottom platen for the next step.
  void control_walls() {
    auto& scene = specimen.scene;
    double speed = 0.0;
    switch (state.phase) {
      case Phase::confine:
        specimen.vessel.pressure = plan.pressure * std::min(1.0, phase_time() / plan.confine_time);
        break;
      case Phase::load:
        speed = probe_speed();
        break;
      case Phase::unload:
        speed = -probe_speed();
        break;
      default:
        break;
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
    const Point point{phase_strain(),
                      (bottom() - state.first_place) / state.height,
                      specimen.vessel.axial_stress(scene),
                      specimen.vessel.radial_stress(scene),
                      now.stress(2, 2),
                      (now.stress(0, 0) + now.stress(1, 1)) / 2.0,
                      now.coordination,
                      now.touching_grains,
                      now.fabric,
                      number(now.all),
                      number(now.virgin),
                      number(now.unloading),
                      number(now.reloading),
                      now.virgin.direction(),
                      now.unloading.direction(),
                      now.reloading.direction(),
                      now.force_over_largest,
                      unbalanced()};
    (state.phase == Phase::load ? state.load : state.unload).push_back(point);
    state.largest_force = std::max(state.largest_force, now.largest_force);
  }

  /// Whether the unbalanced force has fallen to the next of the levels at which the noise of the modulus is probed.
  bool noise_probe_is_due() const {
    const std::size_t next = state.noise.size();
    return state.phase == Phase::rest && next < plan.noise_levels.size() &&
           state.rest_unbalanced <= plan.noise_levels[next];
  }
  bool probes_noise() const { return !before_noise_.is_null(); }
  /// Goes back to where a probe of noise began, and keeps its curve.
  void end_noise_probe() {
    const NoisyProbe probe{state.rest_unbalanced, state.load};
    const nlohmann::json before = std::move(before_noise_);
    before_noise_ = nlohmann::json();
    dem::scene_from_json(before.at("scene"), specimen.scene);
    before.at("state").get_to(*this);
    state.noise.push_back(probe);
    watch_.reset();
  }

  /// @throws std::runtime_error if a step is unstable or a grain has left the vessel
  void check() {
    const auto& scene = specimen.scene;
    watch_.look(scene, dem::kinetic_energy(specimen.clumps), potential_energy());
    const double radius = specimen.vessel.radius(scene), low = bottom(), high = low + Vessel::height(scene);
    for (std::size_t i = 0; i < specimen.clumps.size(); ++i) {
      const Vec3& place = specimen.clumps.all[i].position;
      if (std::hypot(place.x(), place.y()) < radius && place.z() > low && place.z() < high) continue;
      throw std::runtime_error(
          "grain " + std::to_string(i) + " has left the vessel at " + std::to_string(scene.time) + " s (step " +
          std::to_string(scene.steps) + ", phase " + phase_names[static_cast<std::size_t>(state.phase)] +
          "). Try a smaller share of the stable step (--safety) or a slower confinement (--confine).");
    }
  }
  double potential_energy() const {
    double sum = 0.0;
    for (const dem::Clump& c : specimen.clumps.all) sum -= c.mass * specimen.scene.gravity.dot(c.position);
    return sum;
  }

  bool phase_is_over() {
    switch (state.phase) {
      case Phase::settle:
        return phase_time() >= plan.settle_time;
      case Phase::confine:
        return phase_time() >= plan.confine_time;
      case Phase::rest:
        state.rest_unbalanced = unbalanced();
        return state.rest_unbalanced <= plan.unbalanced || phase_time() >= plan.longest_rest || noise_probe_is_due();
      case Phase::load:
        return phase_strain() >= (probes_noise() ? plan.noise_strain : plan.most_strain);
      case Phase::hold:
        return phase_time() >= plan.hold_time;
      case Phase::unload:
        return deviator() <= state.first_deviator || phase_strain() >= plan.most_strain;
      case Phase::done:
        return false;
    }
    return false;
  }

  void end_phase_if_due() {
    if (!phase_is_over()) return;
    auto& scene = specimen.scene;
    if (probes_noise()) return end_noise_probe();
    if (noise_probe_is_due()) before_noise_ = {{"scene", dem::scene_to_json(scene)}, {"state", *this}};
    if (state.phase == Phase::rest) {
      state.rest_time = phase_time();
      state.voids_ratio = specimen.vessel.volume(scene) / solid_volume_ - 1.0;
      state.identity = micro().missing();
      specimen.take_places(state.at_rest);
    }
    if (state.phase == Phase::load || state.phase == Phase::unload) record();
    state.phase = static_cast<Phase>(static_cast<int>(state.phase) + 1);
    if (state.phase == Phase::hold && !plan.unloads) state.phase = Phase::done;
    state.phase_start = scene.time;
    state.start_place = bottom();
    state.next_point = plan.strain_slow;
    if (state.phase == Phase::confine) specimen.vessel.side_moves = !specimen.membrane;
    if (state.phase == Phase::load) {
      specimen.set_skin(probe_skin);
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
