// SPDX-License-Identifier: MIT
// A triaxial test: the platens compress the grains at a given rate while the side wall holds the confinement. Load-unload cycles
// at two axial strains, each back to a deviator stress of zero, then on to the end.
#pragma once

#include "packing.hpp"

namespace class5 {

struct TriaxialSettings {
  std::vector<double> cycles{0.02e-2, 0.05e-2};  ///< axial strains at which it unloads [1]
  double end = 2e-2;                             ///< axial strain at which the test ends [1]
  double cycle_rate = 0.0125;                    ///< axial strain rate in the cycles [1/s]
  double end_rate = 0.1;                         ///< after the cycles [1/s]
  double ramp = 0.1;                             ///< share of a cycle's strain in which the rate changes its sign [1]
  double rest = 1e-5;                            ///< unbalanced ratio at which the test begins [1]
  std::int64_t rest_steps = 100000;              ///< then it begins all the same
  int record_every = 10;                         ///< steps in the cycles; five times as many after them

  nlohmann::json to_json() const {
    return {{"cycles", cycles}, {"end", end},   {"cycle_rate", cycle_rate}, {"end_rate", end_rate},
            {"ramp", ramp},     {"rest", rest}, {"rest_steps", rest_steps}, {"record_every", record_every}};
  }
};

/// The state of the specimen at one time.
struct Sample {
  int leg;               ///< 0 at rest, then 1 load, 2 unload, 3 load ...
  double strain;         ///< axial, compression > 0 [1]
  double deviator;       ///< axial stress less radial stress [Pa]
  double radial_stress;  ///< [Pa]
  double volume_strain;  ///< compression > 0 [1]
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Sample, leg, strain, deviator, radial_stress, volume_strain)

/// What the test of a specimen has to remember between two steps.
struct TriaxialState {
  int leg = 0;
  double rate = 0.0;                  ///< axial strain rate now [1/s]
  double turned_at = 0.0;             ///< strain at the last reversal [1]
  double height = 0.0, radius = 0.0;  ///< at the start of loading [m]
  std::int64_t leg_began = 0;         ///< step
  double unbalanced = 0.0;            ///< ratio at the start of loading [1]
  double stress_mismatch = 0.0;       ///< |wall stress - contact stress + unbalanced| / |wall stress| at the start [1]
  double coordination = 0.0, rattlers = 0.0;  ///< at the start
  std::vector<Sample> samples;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(TriaxialState, leg, rate, turned_at, height, radius, leg_began, unbalanced,
                                   stress_mismatch, coordination, rattlers, samples)

template <class Law>
class Triaxial {
 public:
  /// A law with a bridge: grains within the moisture gap are wet from the start.
  Triaxial(const Law& law, const Packing& packing, const TriaxialSettings& settings)
      : settings_(settings), vessel_(law, packing.size, packing.grains) {
    if constexpr (decltype(Law::bridge)::acts) vessel_.scene.make_wet(moisture_gap);
  }

  /// Runs the test to its end. @throws common::Stopped; std::runtime_error as Vessel::look() does
  TriaxialState run(dem::CaseControl& control) {
    control.resume(vessel_.scene, state_);
    while (true) {
      if (vessel_.looks()) {
        control.between_steps(vessel_.scene, state_, done());
        vessel_.look();
        if (state_.leg == 0 && at_rest()) begin();
      }
      if (state_.leg > 0 && leg_ends()) {
        if (state_.leg == last_leg()) break;
        next_leg();
      }
      step();
    }
    return state_;
  }

  const auto& scene() const { return vessel_.scene; }

 private:
  TriaxialSettings settings_;
  Vessel<Law> vessel_;
  TriaxialState state_;

  int last_leg() const { return 2 * static_cast<int>(settings_.cycles.size()) + 1; }
  bool loads() const { return state_.leg % 2 == 1; }
  /// The strain that ends a leg that loads.
  double goal() const {
    return state_.leg == last_leg() ? settings_.end : settings_.cycles[static_cast<std::size_t>(state_.leg / 2)];
  }
  double strain() const { return state_.leg == 0 ? 0.0 : 1.0 - vessel_.size().height / state_.height; }
  double deviator() const { return vessel_.axial_stress() - vessel_.radial_stress(); }

  bool at_rest() const {
    const auto& scene = vessel_.scene;
    return scene.steps - state_.leg_began >= 1000 &&
           (scene.steps - state_.leg_began >= settings_.rest_steps || dem::unbalanced_ratio(scene) < settings_.rest);
  }
  void begin() {
    const auto& scene = vessel_.scene;
    const Size size = vessel_.size();
    state_.height = size.height;
    state_.radius = size.radius;
    state_.unbalanced = dem::unbalanced_ratio(scene);
    const Eigen::Matrix3d by_walls = dem::wall_stress(scene, size.volume());
    const Eigen::Matrix3d difference =
        by_walls - dem::contact_stress(scene, size.volume()) + dem::unbalanced_stress(scene.balls, size.volume());
    state_.stress_mismatch = difference.norm() / by_walls.norm();
    const dem::Coordination contacts = dem::coordination(scene);
    state_.coordination = contacts.mean;
    state_.rattlers = static_cast<double>(contacts.rattlers);
    next_leg();
  }
  void next_leg() {
    state_.turned_at = strain();
    ++state_.leg;
    state_.leg_began = vessel_.scene.steps;
  }
  bool leg_ends() const { return loads() ? strain() >= goal() : deviator() <= 0.0; }

  void step() {
    auto& scene = vessel_.scene;
    vessel_.hold_pressure(vessel_.side);
    if (state_.leg == 0) {
      vessel_.hold_pressure(vessel_.bottom);
      vessel_.hold_pressure(vessel_.top);
    } else {
      change_rate();
      for (const std::size_t platen : {vessel_.bottom, vessel_.top})
        vessel_.drive(platen, state_.rate * state_.height / 2.0);
    }
    vessel_.step();
    const bool in_cycles = state_.leg < last_leg() || strain() < settings_.cycles.back();
    if (state_.leg > 0 && (scene.steps - state_.leg_began) % (settings_.record_every * (in_cycles ? 1 : 5)) == 0)
      record();
  }
  /// The rate goes to its goal in the time in which a cycle's ramp is strained, so that no wave starts.
  void change_rate() {
    const bool ends = state_.leg == last_leg() && strain() > settings_.cycles.back();
    const double goal_rate = loads() ? (ends ? settings_.end_rate : settings_.cycle_rate) : -settings_.cycle_rate;
    const double time = settings_.ramp * settings_.cycles.front() / settings_.cycle_rate;
    const double change = settings_.cycle_rate / time * vessel_.scene.time_step;
    state_.rate += std::clamp(goal_rate - state_.rate, -change, change);
  }
  void record() {
    const Size size = vessel_.size();
    const double volume = pi * state_.radius * state_.radius * state_.height;
    state_.samples.push_back({state_.leg, strain(), deviator(), vessel_.radial_stress(), 1.0 - size.volume() / volume});
  }

  /// Share of the strain path so far, weighted by the time that it takes.
  double done() const {
    double all = 0.0, so_far = 0.0;
    for (int leg = 1; leg <= last_leg(); ++leg) {
      const double length = leg == last_leg() ? settings_.end / settings_.end_rate * settings_.cycle_rate
                                              : settings_.cycles[static_cast<std::size_t>((leg - 1) / 2)];
      all += length;
      if (leg < state_.leg) so_far += length;
      if (leg == state_.leg)
        so_far += std::min(
            length, std::abs(strain() - state_.turned_at) * length / (leg == last_leg() ? settings_.end : length));
    }
    return so_far / all;
  }
};

}  // namespace class5
