// SPDX-License-Identifier: MIT
// What a force update is to the kit: two spheres and a step in, forces and torques out, history in a State of its own.
//
//   struct MyLaw {
//     struct State { double shear[3] = {0, 0, 0}; };                   // copyable; State{} is a new contact
//     Interaction operator()(const Bodies& pair, double dt, State& state) const;
//
//     State start() const;                                             // where State{} is not where a contact starts
//     MyLaw in_units(const Units& units) const;                        // the same law in other units   -> unit scaling
//     std::vector<double> store(const State& state) const;             // what a restart file keeps     -> restart
//     State load(const std::vector<double>& values) const;
//     State exchanged(const State& state) const;                       // bodies 1 and 2 swap places    -> change of owner
//     ContactStiffness<double> stiffness(const Bodies& pair, const State& state) const;   // -> derivative = stiffness
//   };
//
// Only the first two are needed; a property that asks for more is reported as "not offered". SI units.
#pragma once

#include <optional>
#include <type_traits>
#include <utility>

#include "contactlaws/contact_law.hpp"

namespace contactlaws::verify {

using Vector = Vec3<double>;
using Rotation = Eigen::Matrix<double, 3, 3>;

/// A sphere. Positions are those at the end of the step, velocities those during it.
struct Body {
  Vector position;  ///< of the centre [m]
  Vector velocity;  ///< [m/s]
  Vector spin;      ///< [rad/s]
  double radius;    ///< [m]
  double mass;      ///< [kg]
};

struct Bodies {
  Body one;
  Body two;

  Vector branch() const { return two.position - one.position; }
};

/// What an update answers: at least the force on body 2.
struct Interaction {
  Vector force;                        ///< on body 2 [N]
  std::optional<Vector> force1 = {};   ///< on body 1 [N]
  std::optional<Vector> torque1 = {};  ///< on body 1, about its centre [N m]
  std::optional<Vector> torque2 = {};  ///< on body 2, about its centre [N m]
  double bridge_force = 0.0;           ///< pull within the force that friction does not count, a bridge's [N]
};

/// Other units: every quantity is multiplied by the product of these that its dimension says.
struct Units {
  double length;
  double mass;
  double time;

  double velocity() const { return length / time; }
  double force() const { return mass * length / (time * time); }
  double stiffness() const { return mass / (time * time); }
  double pressure() const { return mass / (length * time * time); }
  double damping() const { return mass / time; }
};

namespace detail {

template <template <class> class Hook, class Law, class = void>
inline constexpr bool offers = false;
template <template <class> class Hook, class Law>
inline constexpr bool offers<Hook, Law, std::void_t<Hook<Law>>> = true;

template <class Law>
using State = typename Law::State;
template <class Law>
using Start = decltype(std::declval<const Law&>().start());
template <class Law>
using InUnits = decltype(std::declval<const Law&>().in_units(std::declval<const Units&>()));
template <class Law>
using StoreAndLoad =
    decltype(std::declval<const Law&>().load(std::declval<const Law&>().store(std::declval<const State<Law>&>())));
template <class Law>
using Exchanged = decltype(std::declval<const Law&>().exchanged(std::declval<const State<Law>&>()));
template <class Law>
using OwnStiffness =
    decltype(std::declval<const Law&>().stiffness(std::declval<const Bodies&>(), std::declval<const State<Law>&>()));

}  // namespace detail

/// The state in which a contact of this law starts.
template <class Law>
detail::State<Law> start_of(const Law& law) {
  if constexpr (detail::offers<detail::Start, Law>) {
    return law.start();
  } else {
    return {};
  }
}

}  // namespace contactlaws::verify
