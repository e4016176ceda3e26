// SPDX-License-Identifier: MIT
// The life of a liquid bridge between the two grains (Figures 13 to 16): rest, pull and release, pull to rupture, come back
// and wet again, release. Without gravity, since the memo's equilibrium is between bridge and surface force alone; the top
// grain's weight would add 4 nm of overlap.
#pragma once

#include <string>

#include "dem/settle.hpp"
#include "expected.hpp"
#include "two_grains.hpp"

namespace memo {

class MoistureProblem {
 public:
  using Law = contactlaws::Hill<double>;

  void run(OutputFolder& folder, CheckedNumbers& numbers) {
    grains_.scene.make_wet(0.0);
    const double rest = release(13);

    pull_to(8e-3, 14);
    const double released = release(14);

    const double rupture = pull_to_rupture();
    pull_to(12e-3, 15);

    pull_to(1.999e-3, 16);
    grains_.scene.make_wet(2.5e-3);
    const double rewetted = release(16);

    path_.write_csv(folder.file("moisture.csv"));
    numbers.push_back({"two_grains.moisture.rest_overlap", {}, expected::moisture_rest_overlap, rest, equilibrium});
    numbers.push_back(
        {"two_grains.moisture.released_overlap", {}, expected::moisture_rest_overlap, released, equilibrium});
    numbers.push_back({"two_grains.moisture.rupture_gap", {}, expected::moisture_rupture_gap, rupture, prescribed});
    numbers.push_back(
        {"two_grains.moisture.rewetted_overlap", {}, expected::moisture_rest_overlap, rewetted, equilibrium});
  }

 private:
  TwoGrains<Law> grains_{damped_hill_law()};
  Table path_{"figure", "time_s", "gap_m", "surface_force_N", "moisture_force_N", "wet", "released"};

  bool wet() const {
    const auto& contacts = grains_.scene.ball_contacts;
    return contacts.size() > 0 && contactlaws::SuctionBridge<double>::is_wet(contacts.state(0));
  }
  double gap() const {
    const auto& balls = grains_.scene.balls;
    return (balls.position[1] - balls.position[0]).norm() - balls.radius[0] - balls.radius[1];
  }

  void record(int figure, bool released) {
    const bool listed = grains_.scene.ball_contacts.size() > 0;
    double surface = 0.0, attraction = 0.0;
    if (listed) {
      const auto response = grains_.scene.ball_contact(0).response;
      surface = response.normal_force;
      attraction = response.bridge_force;
    }
    path_.add({double(figure), grains_.scene.time, gap(), surface, attraction, double(wet()), double(released)});
  }

  /// Releases the top grain and runs to equilibrium. Returns the overlap [m].
  double release(int figure) {
    auto& scene = grains_.scene;
    scene.local_damping = local_damping;
    scene.release(grains_.top);
    // The bridge accelerates the grains to some m/s before they touch: short steps resolve that impact.
    dem::settle(scene, {1e-9, 0.02, 1000000}, [&] {
      if (scene.steps % 10 == 0) record(figure, true);
    });
    record(figure, true);
    return -gap();
  }

  /// Moves the top grain at 1 m/s to this gap [m], and stops it.
  void pull_to(double target, int figure) {
    auto& scene = grains_.scene;
    constexpr int steps = 1000;
    scene.time_step = std::abs(target - gap()) / steps;
    scene.drive(grains_.top, {0.0, 0.0, target > gap() ? 1.0 : -1.0});
    for (int i = 0; i < steps; ++i) {
      stop_if_requested();
      scene.step();
      record(figure, false);
    }
  }

  /// Moves the top grain up until the bridge ruptures, halving the step where it would pass that gap. Returns the gap [m].
  double pull_to_rupture() {
    auto& scene = grains_.scene;
    scene.drive(grains_.top, Vec3::UnitZ());
    scene.time_step = 1e-5;
    while (scene.time_step > 1e-15) {  // at 1 m/s: 1e-13 of the gap
      stop_if_requested();
      const auto before = scene;
      scene.step();
      if (wet()) {
        record(15, false);
      } else {
        scene = before;
        scene.time_step /= 2.0;
      }
    }
    return gap();
  }
};

}  // namespace memo
