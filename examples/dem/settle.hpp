// SPDX-License-Identifier: MIT
// Steps a scene until it is at rest.
#pragma once

#include "common/progress.hpp"
#include "measures.hpp"

namespace dem {

struct Settling {
  double ratio = 1e-9;                 ///< the unbalanced_ratio() that counts as equilibrium [1]
  double safety = 0.5;                 ///< share of stable_time_step() to take [1]
  std::int64_t most_steps = 10000000;  ///< then give up
};

/// Steps until equilibrium, calling `watch()` after each step. Whether it was reached before `most_steps` and Ctrl-C.
template <class Scene, class Watch>
bool settle(Scene& scene, const Settling& settling, const Watch& watch) {
  constexpr int every = 10;  // steps between two checks: an impact takes 20 at the default safety
  constexpr int hold = 100;  // checks in a row with a small ratio: a force may also pass through zero
  int held = 0;
  for (std::int64_t step = 0; step < settling.most_steps && !common::stop_requested(); ++step) {
    if (step % every == 0) {
      scene.time_step = settling.safety * stable_time_step(scene);
      held = step > 0 && unbalanced_ratio(scene) < settling.ratio ? held + 1 : 0;
      if (held == hold) return true;
    }
    scene.step();
    watch();
  }
  return false;
}

}  // namespace dem
