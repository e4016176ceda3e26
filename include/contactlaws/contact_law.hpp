// SPDX-License-Identifier: MIT
// A contact law has five slots: a normal law, dashpots, a shear law, a liquid bridge, rolling resistance. An empty slot costs
// no byte of state, no operation and no parameter. (Potyondy 2019, Sec. 1.6.)
//
//   force on body 2 = (F_n - F_m) n + F_s        F_n normal force, F_m pull of the bridge, F_s shear force
//
// step() computes the force, the couple and the next state from the pair, the motion and the state. It is pure: the same
// input gives the same output. It never throws and allocates nothing.
//
// Set-up, restart and query take dt = 0: the force of the last step, and the state unchanged to rounding. (With the real dt
// the history would advance by one increment.)
//
// NaN: a NaN in what a contact reads (overlap, and where it touches velocity, step and state) gives a NaN force. It is never
// replaced by a number. An open contact does not read its velocity, and its shear history is reset.
#pragma once

#include <array>
#include <cstddef>
#include <tuple>
#include <type_traits>

#include "contactlaws/bridge/suction_bridge.hpp"
#include "contactlaws/damping/dashpots.hpp"
#include "contactlaws/kinematics.hpp"
#include "contactlaws/rolling/rolling_spring.hpp"
#include "contactlaws/slot.hpp"
#include "contactlaws/step.hpp"
#include "contactlaws/tangential/incremental_shear.hpp"

namespace contactlaws {

template <class Normal, class Damping = NoDashpots<typename Normal::Scalar>,
          class Shear = Frictionless<typename Normal::Scalar>, class Bridge = Dry<typename Normal::Scalar>,
          class Rolling = NoRolling<typename Normal::Scalar>>
struct ContactLaw {
  using T = typename Normal::Scalar;
  using Scalar = T;

  static_assert(detail::is_slot<Normal, NormalSlot<T>>, "slot 1 of a ContactLaw is a normal law: contactlaws/normal/");
  static_assert(detail::is_slot<Damping, DampingSlot<T>>,
                "slot 2 of a ContactLaw is a damping law of the same scalar: contactlaws/damping/");
  static_assert(detail::is_slot<Shear, ShearSlot<T>>,
                "slot 3 of a ContactLaw is a shear law of the same scalar: contactlaws/tangential/");
  static_assert(detail::is_slot<Bridge, BridgeSlot<T>>,
                "slot 4 of a ContactLaw is a liquid bridge of the same scalar: contactlaws/bridge/");
  static_assert(detail::is_slot<Rolling, RollingSlot<T>>,
                "slot 5 of a ContactLaw is a rolling law of the same scalar: contactlaws/rolling/");
  static_assert(detail::stiffness_fits<Normal, Shear>,
                "this shear stiffness needs a normal law with a contact radius (Mindlin beside Hertz); "
                "beside others take ConstantRatio or ElasticRatio; partial slip is not for laws that pull");

  Normal normal = Normal();     ///< slot 1
  Damping damping = Damping();  ///< slot 2
  Shear shear = Shear();        ///< slot 3
  Bridge bridge = Bridge();     ///< slot 4
  Rolling rolling = Rolling();  ///< slot 5

  /// Whether the normal law may pull.
  static constexpr bool adheres = detail::adheres<Normal>;
  /// Whether a host must keep the state of a pair while it is farther apart than interaction_range(). Otherwise it may
  /// drop the pair: the state of a contact that comes back is new.
  static constexpr bool outlives_separation = detail::outlives_separation<Normal>;

  /// History of one contact: values of T only, trivially copyable, new when value-initialised.
  struct CONTACTLAWS_EMPTY_BASES State : Normal::State, Shear::State, Bridge::State, Rolling::State {};

  /// Name, unit, kind and sign under exchange of the two bodies, of each value of State in its order.
  static constexpr auto state_values() {
    return concatenate(concatenate(concatenate(Normal::state_values(), Shear::state_values()), Bridge::state_values()),
                       Rolling::state_values());
  }
  static constexpr std::size_t state_size = state_values().size();  ///< values of T a contact
  static_assert(state_size == 0 || sizeof(State) == state_size * sizeof(T), "a State holds values of T only");

  /// Factor of value i of the state when bodies 1 and 2 are swapped.
  static constexpr int exchange_sign(std::size_t i) { return state_values()[i].exchange_sign; }

  /// The state of the same contact with bodies 1 and 2 swapped: each value times its exchange_sign().
  CONTACTLAWS_HD static void exchange_bodies(T* values) noexcept {
    constexpr auto described = state_values();
    for (std::size_t i = 0; i < state_size; ++i)
      if (described[i].exchange_sign < 0) values[i] = -values[i];
  }

  /// A state as state_size values of T, and back.
  CONTACTLAWS_HD static void store(const State& state, T* values) noexcept {
    if constexpr (state_size > 0) detail::copy_values<T, state_size>(values, &state);
  }
  CONTACTLAWS_HD static State load(const T* values) noexcept {
    State state{};
    if constexpr (state_size > 0) detail::copy_values<T, state_size>(&state, values);
    return state;
  }

  /// Force and couple on body 2, and the next state.
  CONTACTLAWS_HD Step<T, State> step(const PairProperties<T>& pair, const ContactKinematics<T>& kinematics,
                                     const State& state) const noexcept {
    const auto zero = [] { return Vec3<T>(T(0), T(0), T(0)); };
    Step<T, State> result{zero(),        zero(), state, T(0), T(0), T(0), negate<T>(kinematics.overlap < T(0)),
                          Mask<T>(false)};
    const Mask<T> open = is_open(state, pair, kinematics.overlap);
    if constexpr (adheres) result.active = result.active || negate<T>(open);
    if (all<T>(open)) {
      open_contact(pair, kinematics.overlap, result.state);
    } else {
      close_contact(pair, kinematics, open, result);
      if constexpr (!std::is_same_v<Mask<T>, bool>) mask_open_lanes(open, result);
    }
    if constexpr (Bridge::acts) {
      const BridgeResponse<T> pull = bridge.respond(result.state, pair, kinematics.overlap);
      result.bridge_force = pull.force;
      result.active = result.active || pull.intact;
      result.force = result.force - kinematics.normal * pull.force;
    }
    return result;
  }

  /// Largest gap across which a contact may act [m]: a neighbour list must reach this far beyond touch.
  CONTACTLAWS_HD T interaction_range(const PairProperties<T>& pair) const noexcept {
    T range = bridge.range(pair);
    if constexpr (adheres) range = maximum<T>(range, normal.range(pair));
    return range;
  }

  /// Stiffnesses for the time step (Potyondy 2019, Eqs 19-21). A bridged gap counts as an overlap of 2e-4 R_o; an open contact
  /// without a bridge has none.
  CONTACTLAWS_HD ContactStiffness<T> stiffness(const PairProperties<T>& pair, const T& overlap,
                                               const State& state) const noexcept {
    T counted = normal_overlap(overlap);
    if constexpr (Bridge::acts) {
      const Mask<T> bridged = overlap <= T(0) && Bridge::is_wet(state);
      counted = select<T>(bridged, T(pair.min_radius * T(2) / T(10000)), counted);
    }
    State scratch = state;
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
    const T closed = normal_overlap(overlap);
    T total = normal.energy(state, pair, closed);
    if constexpr (Shear::acts || Rolling::acts) {
      State scratch = state;
      const auto response = normal.respond(scratch, pair, closed);
      if constexpr (Shear::acts) total = total + shear.energy(state, shear.stiffness(pair, response));
      if constexpr (Rolling::acts) total = total + rolling.energy(state, pair, response.stiffness);
    }
    if constexpr (Bridge::acts) total = total + bridge.energy(state, pair, overlap);
    return total;
  }

  /// Wets the contact where its gap is at most `moisture_gap` [m]; dries it. The next step computes the force.
  CONTACTLAWS_HD static void make_wet(State& state, const T& overlap, const T& moisture_gap) noexcept {
    static_assert(Bridge::acts, "make_wet needs a law with a bridge");
    Bridge::make_wet(state, overlap, moisture_gap);
  }
  CONTACTLAWS_HD static void make_dry(State& state) noexcept {
    static_assert(Bridge::acts, "make_dry needs a law with a bridge");
    Bridge::make_dry(state);
  }

  auto slots() const { return std::tie(normal, damping, shear, bridge, rolling); }  ///< all five
  auto slots() { return std::tie(normal, damping, shear, bridge, rolling); }        ///< all five

  /// The same law on another scalar: float, a pack, a number of 200 bits.
  template <class U>
  using Rebind = ContactLaw<typename Normal::template Rebind<U>, typename Damping::template Rebind<U>,
                            typename Shear::template Rebind<U>, typename Bridge::template Rebind<U>,
                            typename Rolling::template Rebind<U>>;
  template <class U>
  CONTACTLAWS_HD Rebind<U> cast() const {
    return cast<U>([](const T& x) { return scalar_cast<U>(x); });
  }
  /// Each parameter converted by `convert`.
  template <class U, class Convert>
  CONTACTLAWS_HD Rebind<U> cast(const Convert& convert) const {
    return {slot_cast<U>(normal, convert), slot_cast<U>(damping, convert), slot_cast<U>(shear, convert),
            slot_cast<U>(bridge, convert), slot_cast<U>(rolling, convert)};
  }

 private:
  /// Not where the overlap is NaN: the force is NaN then.
  CONTACTLAWS_HD Mask<T> is_open(const State& state, const PairProperties<T>& pair, const T& overlap) const noexcept {
    if constexpr (adheres) {
      return negate<T>(normal.touches(state, pair, overlap));
    } else {
      return overlap <= T(0);
    }
  }
  /// The overlap that the normal law receives.
  CONTACTLAWS_HD static T normal_overlap(const T& overlap) noexcept {
    if constexpr (adheres) {
      return overlap;
    } else {
      return positive_part<T>(overlap);
    }
  }

  CONTACTLAWS_HD void close_contact(const PairProperties<T>& pair, const ContactKinematics<T>& kinematics,
                                    const Mask<T>& open, Step<T, State>& result) const noexcept {
    T overlap = kinematics.overlap;
    if constexpr (!std::is_same_v<Mask<T>, bool>) overlap = normal_overlap(overlap);  // some lanes may be open
    const auto response = normal.respond(result.state, pair, overlap);
    T shear_stiffness = T(0);
    if constexpr (Shear::acts) shear_stiffness = shear.stiffness(pair, response);
    const DampingCoefficients<T> dashpot = damping.coefficients(pair.effective_mass, response.secant, shear_stiffness);

    const T separating = dot<T>(kinematics.velocity, kinematics.normal);
    result.normal_elastic = response.force;
    T load;  // what presses the surfaces together: of a law that pulls, with the adhesion that friction counts
    if constexpr (adheres) {
      const T above_pull_off = damping.normal_force(T(response.force + response.pull_off), dashpot.normal, separating);
      result.normal_force = Damping::acts ? T(above_pull_off - response.pull_off) : response.force;
      load = above_pull_off + (response.adhesion - response.pull_off);
    } else {
      load = result.normal_force = damping.normal_force(response.force, dashpot.normal, separating);
    }
    result.force = kinematics.normal * result.normal_force;
    if constexpr (Shear::acts) {
      const ShearInput<T> input{kinematics,
                                Vec3<T>(kinematics.velocity - kinematics.normal * separating),
                                shear_stiffness,
                                dashpot.shear,
                                positive_part<T>(load),
                                open};
      const ShearResponse<T> sheared = shear.template respond<Damping::damps_shear>(result.state, input);
      result.force = result.force + sheared.force;
      result.shear_force = sheared.force;
      result.sliding = sheared.sliding;
      result.friction_work = sheared.friction_work;
      if constexpr (Damping::damps_shear)
        result.dashpot_work = dot<T>(Vec3<T>(sheared.spring - sheared.force), input.slip_velocity) * kinematics.dt;
    }
    if constexpr (Damping::acts)
      result.dashpot_work =
          result.dashpot_work + (result.normal_elastic - result.normal_force) * separating * kinematics.dt;
    if constexpr (Rolling::acts) {
      const RollingInput<T> input{pair, kinematics, response.stiffness, positive_part<T>(load)};
      const RollingResponse<T> rolled = rolling.respond(result.state, input);
      result.couple = rolled.couple;
      result.friction_work = result.friction_work + rolled.friction_work;
      result.dashpot_work = result.dashpot_work + rolled.dashpot_work;
    }
  }

  /// Open contact: the history is reset, except that of a normal law that outlives separation.
  CONTACTLAWS_HD void open_contact(const PairProperties<T>& pair, const T& overlap, State& state) const noexcept {
    if constexpr (outlives_separation) {
      normal.respond(state, pair, adheres ? overlap : T(0));
    } else {
      reset<Normal>(state);
    }
    reset<Shear>(state);
    reset<Rolling>(state);
  }
  template <class Slot>
  CONTACTLAWS_HD static void reset(State& state) noexcept {
    if constexpr (Slot::state_values().size() > 0) static_cast<typename Slot::State&>(state) = typename Slot::State{};
  }

  /// The same for the open lanes of a pack in which other lanes touch.
  CONTACTLAWS_HD static void mask_open_lanes(const Mask<T>& open, Step<T, State>& result) noexcept {
    if (!any<T>(open)) return;
    const auto cleared = [&open](const T& x) { return select<T>(open, T(0), x); };
    const auto clear = [&cleared](Vec3<T>& v) { v = Vec3<T>(cleared(v.x()), cleared(v.y()), cleared(v.z())); };
    result.sliding = result.sliding && negate<T>(open);
    result.normal_elastic = cleared(result.normal_elastic);
    result.normal_force = cleared(result.normal_force);
    clear(result.force);
    clear(result.shear_force);
    result.friction_work = cleared(result.friction_work);
    result.dashpot_work = cleared(result.dashpot_work);
    if constexpr (Rolling::acts) clear(result.couple);
    if constexpr (!outlives_separation) reset<Normal>(open, result.state);
    reset<Shear>(open, result.state);
    reset<Rolling>(open, result.state);
  }
  /// The state of a slot set to that of a new contact in some lanes.
  template <class Slot>
  CONTACTLAWS_HD static void reset(const Mask<T>& lanes, State& state) noexcept {
    if constexpr (Slot::state_values().size() > 0) {
      typename Slot::State& of_slot = state;
      constexpr std::size_t count = Slot::state_values().size();
      T values[count];
      detail::copy_values<T, count>(values, &of_slot);
      detail::for_each_index<count>([&](std::size_t i)
                                        CONTACTLAWS_INLINE_LAMBDA { values[i] = select<T>(lanes, T(0), values[i]); });
      detail::copy_values<T, count>(&of_slot, values);
    }
  }
};

}  // namespace contactlaws
