// SPDX-License-Identifier: MIT
// What a contact law returns.
#pragma once

#include "contactlaws/core/scalar.hpp"

namespace contactlaws {

/// The result of a step.
template <class T, class State>
struct Step {
  Vec3<T> force;     ///< on body 2, at the contact point; body 1 gets the opposite [N]
  Vec3<T> couple;    ///< on body 2, beside arm x force; body 1 gets the opposite; zero without a rolling law [N m]
  State state;       ///< history after the step
  T normal_elastic;  ///< force of the normal spring, compression > 0 [N]
  T normal_force;    ///< normal spring and dashpot, F_n [N]
  T bridge_force;    ///< pull of the bridge, F_m [N]
  Mask<T> active;    ///< touching, or bridged
  Mask<T> sliding;   ///< friction limited the shear force
  Vec3<T> shear_force = Vec3<T>(T(0), T(0), T(0));  ///< shear spring and dashpot, F_s, on body 2 [N]
  T friction_work = T(0);                           ///< heat from sliding and rolling in this step [J]
  T dashpot_work = T(0);                            ///< heat from both dashpots in this step [J]
};

/// Translational stiffnesses of a contact, for the estimate of a stable time step [N/m].
template <class T>
struct ContactStiffness {
  T normal;  ///< along the normal
  T shear;   ///< in the contact plane
};

}  // namespace contactlaws
