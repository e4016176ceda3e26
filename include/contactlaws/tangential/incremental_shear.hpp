// SPDX-License-Identifier: MIT
// Incremental shear force limited by friction (Potyondy 2019, Eqs 14-18); k the shear stiffness, P >= 0 the friction load:
//
//   trial    F_h* = rotated F_h - k v_s dt        limit  |F_h| <= mu P, direction kept      F_h is the history
//   trial    F*   = F_h - c_s v_s                 limit  |F|   <= mu P, direction kept      F acts on body 2
//
// "Hertz-Mindlin" means four different histories. They agree while the overlap does not change:
//
//   ShearForce                 force                           F_h does not change with k (Potyondy 2019); creates up to
//                                                              0.69 of the largest shear energy per closed loop
//   ShearForceRescaled         force, times k/k_before         when k falls, F_h is scaled by k/k_before, so unloading
//                                                              cannot release more energy than was stored
//   ShearDisplacement          displacement d, F_h = -k d      F_h follows k (absolute form; Potyondy 2019, Appendix A)
//   ShearDisplacementRescaled  displacement, times k/k_before  F_h falls with k^2 (Thornton's rule, as in LAMMPS)
//
// Stiffness: Mindlin (k = 8 G* a), ConstantRatio (of the active tangent), ElasticRatio (of the elastic tangent).
// Friction: Coulomb, or StaticKinetic with two coefficients.
// Domain: any step; mu P > 1e-300 of the trial force. History: three values, four when rescaled, one more with StaticKinetic,
// and those of the rotation. Error: friction limit 4 ULP (tests/laws/test_incremental_shear.cpp); force along random paths of
// 100 steps 1e-13 of the largest (tests/scoreboard).
// In float, increments below half a unit in the last place of the history are lost: a contact under a constant load creeps
// by 1 to 4 % of T/k per million steps (T the shear load; in double not measurable).
#pragma once

#include <array>
#include <type_traits>

#include "contactlaws/core/limit.hpp"
#include "contactlaws/core/parameter.hpp"
#include "contactlaws/slot.hpp"
#include "contactlaws/tangential/rotation.hpp"

namespace contactlaws {

/// The empty shear slot.
template <class T>
struct Frictionless {
  using Slot = ShearSlot<T>;
  template <class U>
  using Rebind = Frictionless<U>;
  static constexpr bool acts = false;

  struct State {};
  static constexpr const char* name = "Frictionless";
  static constexpr std::array<Parameter<Frictionless, T>, 0> parameters() { return {}; }
  static constexpr std::array<StateValue, 0> state_values() { return {}; }
};

/// Shear stiffness k = 8 G* a of a Hertz contact of radius a (Mindlin 1949; Potyondy 2019, Table 4).
template <class T>
struct Mindlin {
  template <class U>
  using Rebind = Mindlin<U>;
  static constexpr std::array<Parameter<Mindlin, T>, 0> parameters() { return {}; }

  CONTACTLAWS_HD T stiffness(const PairProperties<T>& pair, const HertzResponse<T>& normal) const noexcept {
    return T(8) * pair.effective_shear * normal.contact_radius;
  }
};

/// Shear stiffness in a constant ratio to the tangent of the active branch of the normal law. Of a law with loading history
/// that tangent jumps at the largest overlap, and with it k: see ElasticRatio.
template <class T>
struct ConstantRatio {
  template <class U>
  using Rebind = ConstantRatio<U>;
  T ratio = T(1);  ///< k_s / k_n [1]; the linear law's kappa is its inverse
  static constexpr std::array<Parameter<ConstantRatio, T>, 1> parameters() {
    return {{{"ratio", "1", &ConstantRatio::ratio, Range::positive()}}};
  }

  CONTACTLAWS_HD T stiffness(const PairProperties<T>&, const NormalResponse<T>& normal) const noexcept {
    return ratio * normal.stiffness;
  }
};

/// Shear stiffness in a constant ratio to the elastic (unloading) tangent of the normal law: continuous where a law with
/// loading history changes branch. Equal to ConstantRatio beside laws without history of their own.
template <class T>
struct ElasticRatio {
  template <class U>
  using Rebind = ElasticRatio<U>;
  T ratio = T(1);  ///< k_s / k_n [1]
  static constexpr std::array<Parameter<ElasticRatio, T>, 1> parameters() {
    return {{{"ratio", "1", &ElasticRatio::ratio, Range::positive()}}};
  }

  CONTACTLAWS_HD T stiffness(const PairProperties<T>&, const NormalResponse<T>& normal) const noexcept {
    return ratio * normal.max_tangent;
  }
};

/// The ratio of Mindlin's stiffness to Hertz's tangent: 4 G*/E*, for one material 2 (1 - nu)/(2 - nu)
/// (Tolomeo & McDowell 2022, Eq. 7).
template <class T>
CONTACTLAWS_HD T mindlin_ratio(const PairProperties<T>& pair) noexcept {
  return T(4) * pair.effective_shear / pair.effective_young;
}

/// One coefficient of friction.
template <class T>
struct Coulomb {
  template <class U>
  using Rebind = Coulomb<U>;
  T friction = T(0);  ///< mu [1]

  struct State {};
  static constexpr std::array<Parameter<Coulomb, T>, 1> parameters() {
    return {{{"friction", "1", &Coulomb::friction, Range::not_negative()}}};
  }
  static constexpr std::array<StateValue, 0> state_values() { return {}; }

  /// Largest force that sticks under a load, and the force while sliding [N].
  CONTACTLAWS_HD T sticking_limit(const State&, const T& load) const noexcept { return friction * load; }
  CONTACTLAWS_HD T sliding_force(const T& sticking_limit, const T&) const noexcept { return sticking_limit; }
  CONTACTLAWS_HD static void set_sliding(State&, const Mask<T>&, const T& /*dt*/) noexcept {}
};

/// Static and kinetic friction: a sticking contact slides beyond static_friction P, a sliding one carries friction P and
/// sticks again where its trial force falls below that.
template <class T>
struct StaticKinetic {
  template <class U>
  using Rebind = StaticKinetic<U>;
  T friction = T(0);         ///< mu while sliding [1]
  T static_friction = T(0);  ///< mu_s while sticking; below `friction` it limits both [1]

  struct State {
    T sliding = T(0);  ///< 1 if friction limited the last step, else 0
  };
  static constexpr std::array<Parameter<StaticKinetic, T>, 2> parameters() {
    return {{{"friction", "1", &StaticKinetic::friction, Range::not_negative()},
             {"static_friction", "1", &StaticKinetic::static_friction, Range::not_negative()}}};
  }
  static constexpr std::array<StateValue, 1> state_values() { return {{{"sliding", "1", +1}}}; }

  CONTACTLAWS_HD T sticking_limit(const State& state, const T& load) const noexcept {
    const T sticking = select<T>(state.sliding <= T(0), static_friction, state.sliding);  // passes a NaN on
    return select<T>(state.sliding > T(0), friction, sticking) * load;
  }
  CONTACTLAWS_HD T sliding_force(const T& sticking_limit, const T& load) const noexcept {
    return minimum<T>(sticking_limit, T(friction * load));
  }
  CONTACTLAWS_HD static void set_sliding(State& state, const Mask<T>& sliding, const T& dt) noexcept {
    state.sliding = select<T>(dt > T(0), select<T>(sliding, T(1), T(0)), state.sliding);
  }
};

/// What the history holds.
enum class Stored { force, displacement };
/// What happens to it where the stiffness falls.
enum class Unloading { keeps, rescales };

namespace detail {

template <class T>
struct ShearHistory {
  std::array<T, 3> shear = {T(0), T(0), T(0)};  ///< shear force [N] or displacement [m]
};
template <class T>
struct LastStiffness {
  T last_stiffness = T(0);  ///< shear stiffness of the step before [N/m]
};
struct NoLastStiffness {};

}  // namespace detail

template <class T, Stored stored, Unloading unloading, class Stiffness, class Rotation, class Friction = Coulomb<T>>
struct IncrementalShear : Stiffness, Friction {
  using Slot = ShearSlot<T>;
  template <class U>
  using Rebind = IncrementalShear<U, stored, unloading, typename Stiffness::template Rebind<U>,
                                  typename Rotation::template Rebind<U>, typename Friction::template Rebind<U>>;
  static constexpr bool acts = true;
  static constexpr bool rescales = unloading == Unloading::rescales;  ///< as Unloading

  struct CONTACTLAWS_EMPTY_BASES State
      : detail::ShearHistory<T>,
        std::conditional_t<rescales, detail::LastStiffness<T>, detail::NoLastStiffness>,
        Rotation::State,
        Friction::State {};

  static constexpr const char* name = stored == Stored::force ? (rescales ? "ShearForceRescaled" : "ShearForce")
                                      : rescales              ? "ShearDisplacementRescaled"
                                                              : "ShearDisplacement";
  static constexpr auto parameters() {
    return concatenate(inherited<IncrementalShear, T>(Friction::parameters()),
                       inherited<IncrementalShear, T>(Stiffness::parameters()));
  }
  static constexpr auto state_values() {
    constexpr const char* unit = stored == Stored::force ? "N" : "m";
    const std::array<StateValue, 3> vector{{{"shear_x", unit, -1, ValueKind::vector},
                                            {"shear_y", unit, -1, ValueKind::vector},
                                            {"shear_z", unit, -1, ValueKind::vector}}};
    const auto others = concatenate(Rotation::state_values(), Friction::state_values());
    if constexpr (rescales) {
      const std::array<StateValue, 1> last{{{"last_stiffness", "N/m", +1}}};
      return concatenate(concatenate(vector, last), others);
    } else {
      return concatenate(vector, others);
    }
  }

  template <bool damped>
  CONTACTLAWS_HD ShearResponse<T> respond(State& state, const ShearInput<T>& in) const noexcept {
    const T twist = T(in.kinematics.normal_spin * in.kinematics.dt);
    Vec3<T> history =
        Rotation::apply(state, Vec3<T>(state.shear[0], state.shear[1], state.shear[2]), in.kinematics.normal, twist);
    if constexpr (rescales) {
      const Mask<T> keeps = in.stiffness >= state.last_stiffness;  // not where one is NaN
      const T fall = select<T>(keeps, T(1), in.stiffness) / select<T>(keeps, T(1), state.last_stiffness);
      history = history * fall;
      state.last_stiffness = in.stiffness;
    }

    const T limit = this->sticking_limit(state, in.friction_load);
    const Vec3<T> slip = Rotation::slip(Vec3<T>(in.slip_velocity * in.kinematics.dt), in.kinematics.normal, twist);
    Vec3<T> spring;
    if constexpr (stored == Stored::force) {
      spring = history = history - slip * in.stiffness;
    } else {
      history = history + slip;
      spring = history * T(-in.stiffness);
    }
    Vec3<T> total = spring;
    if constexpr (damped) total = spring - in.slip_velocity * in.dashpot;

    // Most contacts stick: one branch skips both limits.
    Mask<T> sticks = detail::surely_within<T>(spring, limit);
    if constexpr (damped) sticks = sticks && detail::surely_within<T>(total, limit);
    Mask<T> sliding(false);
    T friction_work = T(0);
    if (!all<T>(in.open || sticks)) {
      const T kinetic = this->sliding_force(limit, in.friction_load);
      const detail::LengthLimit<T> first = detail::length_limit<T>(spring, limit, kinetic);
      friction_work = first.excess * kinetic / select<T>(in.stiffness > T(0), in.stiffness, T(1));
      spring = spring * first.factor;
      if constexpr (stored == Stored::force) {
        history = spring;
      } else {  // without stiffness a displacement carries no force: the history is reset
        history = history * select<T>(in.stiffness > T(0), first.factor, T(0));
      }
      total = spring;
      sliding = first.exceeded;
      if constexpr (damped) {
        total = spring - in.slip_velocity * in.dashpot;
        const T limit_of_total = select<T>(sliding, kinetic, limit);
        const detail::LengthLimit<T> second = detail::length_limit<T>(total, limit_of_total, kinetic);
        total = total * second.factor;
        sliding = sliding || second.exceeded;
      }
    }
    this->set_sliding(state, sliding, in.kinematics.dt);
    state.shear = {history.x(), history.y(), history.z()};
    return {total, spring, sliding, friction_work};
  }

  /// Energy stored in the shear spring [J]; `stiffness` at the overlap of the state.
  CONTACTLAWS_HD T energy(const State& state, const T& stiffness) const noexcept {
    const Vec3<T> history(state.shear[0], state.shear[1], state.shear[2]);
    const T square = dot<T>(history, history);
    if constexpr (stored == Stored::force) {
      return detail::spring_energy<T>(square, stiffness);
    } else {
      return square * stiffness / T(2);
    }
  }
};

template <class T, class Stiffness = Mindlin<T>, class Rotation = rotation::ProjectRestore<T>,
          class Friction = Coulomb<T>>
/// History: the force.
using ShearForce = IncrementalShear<T, Stored::force, Unloading::keeps, Stiffness, Rotation, Friction>;
template <class T, class Stiffness = Mindlin<T>, class Rotation = rotation::ProjectRestore<T>,
          class Friction = Coulomb<T>>
/// History: the force, scaled where the stiffness falls.
using ShearForceRescaled = IncrementalShear<T, Stored::force, Unloading::rescales, Stiffness, Rotation, Friction>;
template <class T, class Stiffness = Mindlin<T>, class Rotation = rotation::ProjectRestore<T>,
          class Friction = Coulomb<T>>
/// History: the displacement.
using ShearDisplacement = IncrementalShear<T, Stored::displacement, Unloading::keeps, Stiffness, Rotation, Friction>;
template <class T, class Stiffness = Mindlin<T>, class Rotation = rotation::ProjectRestore<T>,
          class Friction = Coulomb<T>>
/// History: the displacement, scaled where the stiffness falls.
using ShearDisplacementRescaled =
    IncrementalShear<T, Stored::displacement, Unloading::rescales, Stiffness, Rotation, Friction>;

}  // namespace contactlaws
