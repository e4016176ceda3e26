// SPDX-License-Identifier: MIT
// The energy balance of a contact: work done on it = stored + dissipated.
//
// The work of a step is -(F_before + F_now)/2 . v dt, and the same with couple and relative spin: second order in the step
// for a velocity and a spin that are constant over it. Exact for a force that is linear in the motion.
#pragma once

#include "contactlaws/contact_law.hpp"

namespace contactlaws {

/// Heat that a contact produces in one step, by cause [J].
template <class T>
struct Dissipation {
  T friction;  ///< sliding and rolling
  T dashpots;  ///< normal, shear and rolling
  T yielding;  ///< flattened asperities
};

/// The heat of a step from the state `before`. First order in the step. The energy that a bridge loses at rupture and the
/// springs of a contact that opens under load are not heat of a step; EnergyLedger counts them.
template <class Law, class T = typename Law::Scalar>
CONTACTLAWS_HD Dissipation<T> dissipation(const Law& law, const PairProperties<T>& pair,
                                          const typename Law::State& before,
                                          const Step<T, typename Law::State>& step) noexcept {
  Dissipation<T> heat{step.friction_work, step.dashpot_work, T(0)};
  if constexpr (detail::yields<decltype(Law::normal)>) {  // a contact that opens may be reset: no heat then
    const T work = law.normal.plastic_dissipation(step.state, pair) - law.normal.plastic_dissipation(before, pair);
    heat.yielding = positive_part<T>(work);
  }
  return heat;
}

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
