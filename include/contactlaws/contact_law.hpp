// SPDX-License-Identifier: MIT
// A contact law is four slots: a normal law, dashpots, a shear law, a liquid bridge. Whatever a slot leaves out costs
// nothing: no byte of state, no operation, no parameter. (Potyondy 2019, Sec. 1.6.)
//
//   force on body 2 = (F_n - F_m) n + F_s        F_n surface force, F_m pull of the bridge, F_s shear force
//
// The one verb is step(): from the pair, the motion and the contact's state to the force and the next state. It is pure
// (asking twice gives the same answer twice), never throws, allocates nothing.
#pragma once

#include <array>
#include <cstddef>
#include <cstring>
#include <tuple>
#include <type_traits>

#include "contactlaws/bridge/suction_bridge.hpp"
#include "contactlaws/damping/dashpots.hpp"
#include "contactlaws/kinematics.hpp"
#include "contactlaws/pair.hpp"
#include "contactlaws/slot.hpp"
#include "contactlaws/tangential/incremental_shear.hpp"

namespace contactlaws {

/// What a step yields.
template <class T, class State>
struct Step {
  Vec3<T> force;     ///< on body 2, at the contact point; body 1 gets the opposite [N]
  State state;       ///< the contact's history after the step
  T normal_elastic;  ///< normal spring's part, compression > 0 [N]
  T normal_force;    ///< normal spring and dashpot, F_n [N]
  T bridge_force;    ///< the bridge's pull, F_m [N]
  Mask<T> active;    ///< touching, or bridged
  Mask<T> sliding;   ///< friction limited the shear force
};

/// Translational stiffnesses of a contact, for the estimate of a stable time step [N/m].
template <class T>
struct ContactStiffness {
  T normal;
  T shear;
};

template <class Normal, class Damping = NoDashpots<typename Normal::Scalar>,
          class Shear = Frictionless<typename Normal::Scalar>, class Bridge = Dry<typename Normal::Scalar>>
struct ContactLaw {
  using T = typename Normal::Scalar;
  using Scalar = T;

  Normal normal;
  Damping damping;
  Shear shear;
  Bridge bridge;

  /// History of one contact: values of T only, trivially copyable, virgin when value-initialised.
  struct CONTACTLAWS_EMPTY_BASES State : Normal::State, Shear::State, Bridge::State {};

  /// Name, unit and sign under exchange of the two bodies, of each value of State in its order.
  static constexpr auto state_values() {
    return concatenate(concatenate(Normal::state_values(), Shear::state_values()), Bridge::state_values());
  }
  static constexpr std::size_t state_size =
      Normal::state_values().size() + Shear::state_values().size() + Bridge::state_values().size();
  static_assert(state_size == 0 || sizeof(State) == state_size * sizeof(T), "a State holds values of T only");

  /// What value i of the state is multiplied by when bodies 1 and 2 swap places: -1 for vectors, +1 for scalars.
  static constexpr int exchange_sign(std::size_t i) { return state_values()[i].exchange_sign; }

  /// A state as the host keeps it, and back: state_size values of T.
  CONTACTLAWS_HD static void store(const State& state, T* values) noexcept {
    if constexpr (state_size > 0) std::memcpy(static_cast<void*>(values), &state, sizeof(State));
  }
  CONTACTLAWS_HD static State load(const T* values) noexcept {
    State state{};
    if constexpr (state_size > 0) std::memcpy(static_cast<void*>(&state), values, sizeof(State));
    return state;
  }

  /// Force on body 2 and the next state.
  CONTACTLAWS_HD Step<T, State> step(const PairProperties<T>& pair, const ContactKinematics<T>& kinematics,
                                     const State& state) const noexcept {
    Step<T, State> result{Vec3<T>(T(0), T(0), T(0)),  state,         T(0), T(0), T(0),
                          kinematics.overlap >= T(0), Mask<T>(false)};
    const Mask<T> touching = kinematics.overlap > T(0);
    if (any<T>(touching)) {
      close_contact(pair, kinematics, result);
      if constexpr (!std::is_same_v<Mask<T>, bool>) mask_open_lanes(!touching, result);
    } else {
      open_contact(pair, result.state);
    }
    if constexpr (Bridge::acts) {
      const BridgeResponse<T> pull = bridge.respond(result.state, pair, kinematics.overlap);
      result.bridge_force = pull.force;
      result.active = result.active || pull.intact;
      result.force = result.force - kinematics.normal * pull.force;
    }
    return result;
  }

  /// Largest gap across which a contact can act [m]: how far a neighbour list must reach beyond touch.
  CONTACTLAWS_HD T interaction_range(const PairProperties<T>& pair) const noexcept { return bridge.range(pair); }

  /// Stiffnesses for the time step (Potyondy 2019, Eqs 19-21); a bridged gap counts as an overlap of 2e-4 R_o.
  CONTACTLAWS_HD ContactStiffness<T> stiffness(const PairProperties<T>& pair, const T& overlap,
                                               const State& state) const noexcept {
    State scratch = state;
    const T counted = select<T>(overlap > T(0), overlap, T(pair.min_radius * T(2) / T(10000)));
    auto response = normal.respond(scratch, pair, counted);
    response.stiffness = response.max_tangent;
    const T factor = damping.stiffness_factor();
    if constexpr (Shear::acts) {
      return {response.stiffness * factor, T(shear.stiffness(pair, response) * factor)};
    } else {
      return {response.stiffness * factor, T(0)};
    }
  }

  /// Energy stored in springs and bridge [J], of a state that step() returned at this overlap.
  CONTACTLAWS_HD T stored_energy(const PairProperties<T>& pair, const T& overlap, const State& state) const noexcept {
    const T closed = positive_part<T>(overlap);
    T total = normal.energy(state, pair, closed);
    if constexpr (Shear::acts) {
      State scratch = state;
      total = total + shear.energy(state, shear.stiffness(pair, normal.respond(scratch, pair, closed)));
    }
    if constexpr (Bridge::acts) total = total + bridge.energy(state, pair, overlap);
    return total;
  }

  /// Wets the contact where its gap is at most `moisture_gap` [m]; dries it. Forces follow with the next step.
  CONTACTLAWS_HD static void make_wet(State& state, const T& overlap, const T& moisture_gap) noexcept {
    static_assert(Bridge::acts, "make_wet needs a law with a bridge");
    Bridge::make_wet(state, overlap, moisture_gap);
  }
  CONTACTLAWS_HD static void make_dry(State& state) noexcept {
    static_assert(Bridge::acts, "make_dry needs a law with a bridge");
    Bridge::make_dry(state);
  }

  std::tuple<const Normal&, const Damping&, const Shear&, const Bridge&> slots() const {
    return {normal, damping, shear, bridge};
  }

  /// The same law on another scalar: float, a pack, a number of 200 bits.
  template <class U>
  using Rebind = ContactLaw<typename Normal::template Rebind<U>, typename Damping::template Rebind<U>,
                            typename Shear::template Rebind<U>, typename Bridge::template Rebind<U>>;
  template <class U>
  CONTACTLAWS_HD Rebind<U> cast() const {
    return cast<U>([](const T& x) { return scalar_cast<U>(x); });
  }
  /// Each parameter as `convert` makes it.
  template <class U, class Convert>
  CONTACTLAWS_HD Rebind<U> cast(const Convert& convert) const {
    return {slot_cast<U>(normal, convert), slot_cast<U>(damping, convert), slot_cast<U>(shear, convert),
            slot_cast<U>(bridge, convert)};
  }

 private:
  CONTACTLAWS_HD void close_contact(const PairProperties<T>& pair, const ContactKinematics<T>& kinematics,
                                    Step<T, State>& result) const noexcept {
    const auto response = normal.respond(result.state, pair, positive_part<T>(kinematics.overlap));
    T shear_stiffness = T(0);
    if constexpr (Shear::acts) shear_stiffness = shear.stiffness(pair, response);
    const DampingCoefficients<T> dashpot = damping.coefficients(pair.effective_mass, response.secant, shear_stiffness);

    const T separating = dot<T>(kinematics.velocity, kinematics.normal);
    result.normal_elastic = response.force;
    result.normal_force = damping.normal_force(response.force, dashpot.normal, separating);
    result.force = kinematics.normal * result.normal_force;
    if constexpr (Shear::acts) {
      const ShearInput<T> input{kinematics, Vec3<T>(kinematics.velocity - kinematics.normal * separating),
                                shear_stiffness, dashpot.shear, positive_part<T>(result.normal_force)};
      const ShearResponse<T> sheared = shear.template respond<Damping::acts>(result.state, input);
      result.force = result.force + sheared.force;
      result.sliding = sheared.sliding;
    }
  }

  /// What an open contact keeps: the normal law says, shear forgets.
  CONTACTLAWS_HD void open_contact(const PairProperties<T>& pair, State& state) const noexcept {
    normal.respond(state, pair, T(0));
    static_cast<typename Shear::State&>(state) = typename Shear::State{};
  }

  /// The same for the open lanes of a pack in which others touch; the normal law has seen them.
  CONTACTLAWS_HD static void mask_open_lanes(const Mask<T>& open, Step<T, State>& result) noexcept {
    if (!any<T>(open)) return;
    result.sliding = result.sliding && !open;
    result.force = result.force * select<T>(open, T(0), T(1));
    if constexpr (Shear::acts) {
      typename Shear::State& shear_state = result.state;
      T values[Shear::state_values().size()];
      std::memcpy(values, &shear_state, sizeof(values));
      for (T& value : values) value = select<T>(open, T(0), value);
      std::memcpy(&shear_state, values, sizeof(values));
    }
  }
};

}  // namespace contactlaws
