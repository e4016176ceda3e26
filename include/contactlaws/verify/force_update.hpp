// SPDX-License-Identifier: MIT
// A force update as the kit calls it: two spheres and a time step in, forces and torques out, the history in a State.
//
//   struct MyLaw {
//     struct State { double shear[3] = {0, 0, 0}; };                   // copyable; State{} is a new contact
//     Interaction operator()(const Bodies& pair, double dt, State& state) const;
//
//     State start() const;                                             // a new contact, where State{} is not one
//     MyLaw in_units(const Units& units) const;                        // the same law in other units   -> unit scaling
//     std::vector<double> store(const State& state) const;             // what a restart file keeps     -> restart
//     State load(const std::vector<double>& values) const;
//     State exchanged(const State& state) const;                       // bodies 1 and 2 swap places    -> change of owner
//     ContactStiffness<double> stiffness(const Bodies& pair, const State& state) const;   // -> derivative = stiffness
//   };
//
// Only the first two are required; a property that needs another one is reported as "not offered". SI units.
// ForceUpdate holds any such law behind one type, so that the checks are compiled once for all laws.
#pragma once

#if !defined(__cpp_exceptions)
#error \
    "contactlaws/verify needs exceptions: build the checks without -fno-exceptions (the laws themselves do not need them)"
#endif
#if defined(CONTACTLAWS_NO_EIGEN)
#error \
    "contactlaws/verify needs Eigen: build the checks without CONTACTLAWS_NO_EIGEN (the laws themselves do not need it)"
#endif

#include <any>
#include <functional>
#include <optional>
#include <type_traits>
#include <utility>

#include "contactlaws/contact_law.hpp"

namespace contactlaws::verify {

/// Three numbers.
using Vector = Vec3<double>;

/// A sphere. Positions are those at the end of the step, velocities those during it.
struct Body {
  Vector position;  ///< of the centre [m]
  Vector velocity;  ///< [m/s]
  Vector spin;      ///< [rad/s]
  double radius;    ///< [m]
  double mass;      ///< [kg]
};

struct Bodies {
  Body one;  ///< body 1
  Body two;  ///< body 2

  Vector branch() const { return two.position - one.position; }  ///< from centre to centre [m]
  double length() const { return one.radius + two.radius; }      ///< R1 + R2 [m]
};

/// What an update returns: at least the force on body 2. A torque left out is that of the force at the contact point.
struct Interaction {
  Vector force;                        ///< on body 2 [N]
  std::optional<Vector> force1 = {};   ///< on body 1 [N]
  std::optional<Vector> torque1 = {};  ///< on body 1, about its centre [N m]
  std::optional<Vector> torque2 = {};  ///< on body 2, about its centre [N m]
  double bridge_force = 0.0;           ///< the part of the pull that does not reduce friction, e.g. a bridge's [N]
};

/// Other units: a quantity is multiplied by the product of these that its dimension requires.
struct Units {
  double length;  ///< of a metre
  double mass;    ///< of a kilogram
  double time;    ///< of a second

  double velocity() const { return length / time; }                  ///< of 1 m/s
  double force() const { return mass * length / (time * time); }     ///< of 1 N
  double stiffness() const { return mass / (time * time); }          ///< of 1 N/m
  double pressure() const { return mass / (length * time * time); }  ///< of 1 Pa
  double damping() const { return mass / time; }                     ///< of 1 kg/s
};

namespace detail {

template <template <class> class Hook, class Law, class = void>
inline constexpr bool offers = false;
template <template <class> class Hook, class Law>
inline constexpr bool offers<Hook, Law, std::void_t<Hook<Law>>> = true;

template <class Law>
using State = typename Law::State;
template <class Law>
using Call = decltype(Interaction(
    std::declval<const Law&>()(std::declval<const Bodies&>(), 0.0, std::declval<typename Law::State&>())));
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
using Stiffness =
    decltype(std::declval<const Law&>().stiffness(std::declval<const Bodies&>(), std::declval<const State<Law>&>()));

}  // namespace detail

/// One force update of any law. Functions that the law does not offer are empty.
struct ForceUpdate {
  using State = std::any;

  std::function<Interaction(const Bodies&, double dt, State&)> step;  ///< of one step
  std::function<State()> start;                                       ///< of a new contact
  std::function<ForceUpdate(const Units&)> in_units;                  ///< the same law in other units
  std::function<State(const State&)> restarted;                       ///< the state stored, and loaded again
  std::function<State(const State&)> exchanged;                       ///< of the swapped bodies
  std::function<ContactStiffness<double>(const Bodies&, const State&)> stiffness;  ///< of the springs

  /// Any law of these hooks.
  template <class Law, class = std::enable_if_t<!std::is_same_v<Law, ForceUpdate>>>
  ForceUpdate(const Law& law) {  // implicit, for check_all(MyLaw{}, options)
    constexpr bool has_state = detail::offers<detail::State, Law>;
    static_assert(has_state, "a force update needs a nested State: `struct State {};` where it has no history");
    if constexpr (has_state) {
      constexpr bool has_call = detail::offers<detail::Call, Law>;
      static_assert(has_call,
                    "a force update needs `verify::Interaction operator()(const verify::Bodies& pair, "
                    "double dt, State& state) const`");
      if constexpr (has_call) hold(law);
    }
  }

 private:
  template <class Law>
  void hold(const Law& law) {
    using Own = typename Law::State;
    const auto own = [](const State& state) -> const Own& { return *std::any_cast<Own>(&state); };
    step = [law](const Bodies& pair, double dt, State& state) -> Interaction {
      return law(pair, dt, *std::any_cast<Own>(&state));
    };
    if constexpr (detail::offers<detail::Start, Law>) {
      start = [law] { return State(law.start()); };
    } else {
      start = [] { return State(Own{}); };
    }
    if constexpr (detail::offers<detail::InUnits, Law>)
      in_units = [law](const Units& units) { return ForceUpdate(law.in_units(units)); };
    if constexpr (detail::offers<detail::StoreAndLoad, Law>)
      restarted = [law, own](const State& state) { return State(law.load(law.store(own(state)))); };
    if constexpr (detail::offers<detail::Exchanged, Law>)
      exchanged = [law, own](const State& state) { return State(law.exchanged(own(state))); };
    if constexpr (detail::offers<detail::Stiffness, Law>)
      stiffness = [law, own](const Bodies& pair, const State& state) { return law.stiffness(pair, own(state)); };
  }
};

}  // namespace contactlaws::verify
