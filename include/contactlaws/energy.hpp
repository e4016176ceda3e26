// SPDX-License-Identifier: MIT
// Where the energy of a contact goes: work done on it = stored + dissipated.
//
// The work of a step is -(F_before + F_now)/2 . v dt, second order in the step for a velocity v constant over it.
#pragma once

#include "contactlaws/contact_law.hpp"

namespace contactlaws {

/// Follows one contact, step by step.
template <class T>
struct EnergyLedger {
  T work = T(0);                                   ///< done on the contact by the motion of its bodies [J]
  T stored = T(0);                                 ///< in springs and bridge [J]
  T stored_at_start = T(0);                        ///< [J]
  Vec3<T> last_force = Vec3<T>(T(0), T(0), T(0));  ///< on body 2 [N]

  /// Turned into heat by friction, dashpots and yielding (negative: the law created energy) [J].
  T dissipated() const { return work - (stored - stored_at_start); }

  /// Enters what `law.step(pair, kinematics, ...)` returned.
  template <class Law>
  void enter(const Law& law, const PairProperties<T>& pair, const ContactKinematics<T>& kinematics,
             const Step<T, typename Law::State>& step) {
    const Vec3<T> mean_force = (last_force + step.force) / T(2);
    work = work - dot<T>(mean_force, kinematics.velocity) * kinematics.dt;
    stored = law.stored_energy(pair, kinematics.overlap, step.state);
    last_force = step.force;
  }
};

}  // namespace contactlaws
