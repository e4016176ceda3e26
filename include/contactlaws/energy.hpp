// SPDX-License-Identifier: MIT
// The energy balance of a contact: work done on it = stored + dissipated.
//
// The work of a step is -(F_before + F_now)/2 . v dt, and the same with couple and relative spin: second order in the step
// for a velocity and a spin that are constant over it. Exact for a force that is linear in the motion.
#pragma once

#include "contactlaws/contact_law.hpp"

namespace contactlaws {

/// Accumulates the energies of one contact, step by step.
template <class T>
struct EnergyLedger {
  T work = T(0);                                    ///< done on the contact by the motion of its bodies [J]
  T stored = T(0);                                  ///< in springs and bridge [J]
  T stored_at_start = T(0);                         ///< [J]
  Vec3<T> last_force = Vec3<T>(T(0), T(0), T(0));   ///< on body 2 [N]
  Vec3<T> last_couple = Vec3<T>(T(0), T(0), T(0));  ///< on body 2 [N m]

  /// Converted to heat by friction, dashpots and yielding (negative: the law created energy) [J].
  T dissipated() const { return work - (stored - stored_at_start); }

  /// Adds a step: the result of `law.step(pair, kinematics, ...)`.
  template <class Law>
  void enter(const Law& law, const PairProperties<T>& pair, const ContactKinematics<T>& kinematics,
             const Step<T, typename Law::State>& step) {
    const Vec3<T> mean_force = (last_force + step.force) / T(2);
    T power = dot<T>(mean_force, kinematics.velocity);
    if constexpr (decltype(Law::rolling)::acts) {
      const Vec3<T> mean_couple = (last_couple + step.couple) / T(2);
      power = power + dot<T>(mean_couple, kinematics.relative_spin);
      last_couple = step.couple;
    }
    work = work - power * kinematics.dt;
    stored = law.stored_energy(pair, kinematics.overlap, step.state);
    last_force = step.force;
  }
};

}  // namespace contactlaws
