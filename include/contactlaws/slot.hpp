// SPDX-License-Identifier: MIT
// A law has four slots: normal, damping, shear, bridge. This is what they say to each other; start here to write one.
//
//   normal   respond(State&, pair, overlap)                                      -> NormalResponse
//            energy(State, pair, overlap) [J]
//   damping  coefficients(mass, normal secant, shear stiffness)                  -> DampingCoefficients
//            normal_force(elastic, coefficient, separating) [N], stiffness_factor() [1], dissipates (whether it does anything)
//   shear    respond<damped>(State&, ShearInput)                                 -> ShearResponse
//            stiffness(pair, normal response) [N/m], energy(State, stiffness) [J]
//   bridge   respond(State&, pair, overlap)                                      -> BridgeResponse
//            energy(State, pair, overlap) [J], range(pair) [m]
//
// A slot has parameters but no memory; what it remembers of a contact is its nested State: values of T only, virgin when all are zero,
// listed by state_values(). respond() is handed a copy of the state to bring up to date. `overlap` is never negative
// for normal and shear (0 means open, and yields zeros); a bridge sees gaps as negative overlaps.
#pragma once

#include "contactlaws/core/scalar.hpp"
#include "contactlaws/kinematics.hpp"

namespace contactlaws {

template <class T>
struct NormalResponse {
  T force;        ///< elastic (or plastic) force, compression > 0 [N]
  T stiffness;    ///< tangent stiffness dF/do of the active branch [N/m]
  T secant;       ///< force over indentation of the active branch, what dashpots scale with [N/m]
  T max_tangent;  ///< tangent of the max_tangent branch that motion can enter from here, for the time step [N/m]
};

/// Of the normal laws that know the radius a of the contact: Mindlin's shear stiffness asks for it.
template <class T>
struct HertzResponse : NormalResponse<T> {
  T contact_radius;  ///< a [m]
};

template <class T>
struct DampingCoefficients {
  T normal;  ///< c_n [kg/s]
  T shear;   ///< c_s [kg/s]
};

template <class T>
struct ShearInput {
  const ContactKinematics<T>& kinematics;
  Vec3<T> slip_velocity;  ///< of sliding: in the contact plane, body 2 relative to body 1 [m/s]
  T stiffness;            ///< k_s o^(1/2) at this overlap, 0 when open [N/m]
  T dashpot;              ///< c_s [kg/s]; read when damped
  T friction_load;        ///< normal surface force, bridge not counted, never negative: what friction multiplies [N]
};

template <class T>
struct ShearResponse {
  Vec3<T> force;    ///< in the contact plane, on body 2 [N]
  Mask<T> sliding;  ///< whether friction limited it
};

template <class T>
struct BridgeResponse {
  T force;         ///< attraction > 0 [N]
  Mask<T> intact;  ///< whether the bridge is there
};

}  // namespace contactlaws
