// SPDX-License-Identifier: MIT
// Shear by increments, limited by friction (Potyondy 2019, Eqs 14-18), k = k_s o^(1/2), P the normal surface force >= 0:
//
//   trial    F_h* = carried F_h - k v_s dt        limit  |F_h| <= mu P, direction kept      F_h is the history
//   trial    F*   = F_h - c_s v_s                 limit  |F|   <= mu P, direction kept      F acts on body 2
//
// What the history stores, and what unloading (a falling k) does to it, makes four laws that all go by the name of
// Hertz-Mindlin; they agree while the overlap does not change:
//
//   ShearForce                 force                         keeps the force as the overlap changes (Potyondy 2019)
//   ShearForceRescaled         force, times k/k_before       a falling k lowers the force: gives back no energy it has not
//   ShearDisplacement          displacement, F_h = -k d      force follows k up and down (absolute; memo's Appendix A)
//   ShearDisplacementRescaled  displacement, times k/k_before  a falling k lowers it twice (Thornton's rule as LAMMPS has it)
//
// Where the stiffness comes from: Mindlin (k = 8 G* a, Mindlin 1949) or ConstantRatio (k = ratio dF_n/do).
// Domain: any step; mu P > 1e-300 of the trial force. Three values of history, four when rescaled, and what the carrying
// stores.
#pragma once

#include <array>
#include <type_traits>

#include "contactlaws/core/parameter.hpp"
#include "contactlaws/pair.hpp"
#include "contactlaws/slot.hpp"
#include "contactlaws/tangential/rotation.hpp"

namespace contactlaws {

/// No shear: nothing computed, nothing stored.
template <class T>
struct Frictionless {
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

/// Shear stiffness in a constant ratio to the tangent of the normal law.
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

/// The ratio that Mindlin's stiffness has to Hertz's tangent: 4 G*/E*, for one material 2 (1 - nu)/(2 - nu)
/// (Tolomeo & McDowell 2022, Eq. 7).
template <class T>
CONTACTLAWS_HD T mindlin_ratio(const PairProperties<T>& pair) noexcept {
  return T(4) * pair.effective_shear / pair.effective_young;
}

enum class Stored { force, displacement };
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

/// Whether |force| <= strength for sure: by squares, where these kept their digits.
template <class T>
CONTACTLAWS_HD Mask<T> surely_within(const Vec3<T>& force, const T& strength) noexcept {
  const T strength_square = strength * strength;
  return square_is_exact<T>(strength_square) && dot<T>(force, force) <= strength_square;
}

/// What shortens a force to `strength` >= 0 where it is longer.
template <class T>
struct FrictionLimit {
  T factor;
  Mask<T> exceeded;
};
template <class T>
CONTACTLAWS_HD FrictionLimit<T> friction_limit(const Vec3<T>& force, const T& strength) noexcept {
  const T magnitude = norm<T>(force);
  const Mask<T> exceeded = magnitude > strength;
  return {select<T>(exceeded, strength, T(1)) / select<T>(exceeded, magnitude, T(1)), exceeded};
}

}  // namespace detail

template <class T, Stored stored, Unloading unloading, class Stiffness, class Rotation>
struct IncrementalShear : Stiffness {
  template <class U>
  using Rebind = IncrementalShear<U, stored, unloading, typename Stiffness::template Rebind<U>,
                                  typename Rotation::template Rebind<U>>;
  static constexpr bool acts = true;
  static constexpr bool rescales = unloading == Unloading::rescales;

  T friction = T(0);  ///< mu [1]

  struct CONTACTLAWS_EMPTY_BASES State
      : detail::ShearHistory<T>,
        std::conditional_t<rescales, detail::LastStiffness<T>, detail::NoLastStiffness>,
        Rotation::State {};

  static constexpr const char* name = stored == Stored::force ? (rescales ? "ShearForceRescaled" : "ShearForce")
                                      : rescales              ? "ShearDisplacementRescaled"
                                                              : "ShearDisplacement";
  static constexpr auto parameters() {
    std::array<Parameter<IncrementalShear, T>, 1> own{
        {{"friction", "1", &IncrementalShear::friction, Range::not_negative()}}};
    std::array<Parameter<IncrementalShear, T>, Stiffness::parameters().size()> inherited{};
    for (std::size_t i = 0; i < inherited.size(); ++i) {
      const auto p = Stiffness::parameters()[i];
      inherited[i] = {p.name, p.unit, p.member, p.range};
    }
    return concatenate(own, inherited);
  }
  static constexpr auto state_values() {
    constexpr const char* unit = stored == Stored::force ? "N" : "m";
    const std::array<StateValue, 3> vector{{{"shear_x", unit, -1}, {"shear_y", unit, -1}, {"shear_z", unit, -1}}};
    if constexpr (rescales) {
      const std::array<StateValue, 1> last{{{"last_stiffness", "N/m", +1}}};
      return concatenate(concatenate(vector, last), Rotation::state_values());
    } else {
      return concatenate(vector, Rotation::state_values());
    }
  }

  template <bool damped>
  CONTACTLAWS_HD ShearResponse<T> respond(State& state, const ShearInput<T>& in) const noexcept {
    Vec3<T> history = Rotation::apply(state, Vec3<T>(state.shear[0], state.shear[1], state.shear[2]),
                                      in.kinematics.normal, T(in.kinematics.normal_spin * in.kinematics.dt));
    if constexpr (rescales) {
      const Mask<T> falls = in.stiffness < state.last_stiffness;
      const T fall = select<T>(falls, in.stiffness, T(1)) / select<T>(falls, state.last_stiffness, T(1));
      history = history * fall;
      state.last_stiffness = in.stiffness;
    }

    const T strength = friction * in.friction_load;
    const Vec3<T> slid = in.slip_velocity * in.kinematics.dt;
    Vec3<T> spring;
    if constexpr (stored == Stored::force) {
      spring = history = history - slid * in.stiffness;
    } else {
      history = history + slid;
      spring = history * T(-in.stiffness);
    }
    Vec3<T> total = spring;
    if constexpr (damped) total = spring - in.slip_velocity * in.dashpot;

    // Most contacts stick: one look at both limits tells.
    Mask<T> sticks = detail::surely_within<T>(spring, strength);
    if constexpr (damped) sticks = sticks && detail::surely_within<T>(total, strength);
    Mask<T> sliding(false);
    if (any<T>(in.kinematics.overlap > T(0) && !sticks)) {
      const detail::FrictionLimit<T> first = detail::friction_limit<T>(spring, strength);
      spring = spring * first.factor;
      if constexpr (stored == Stored::force) {
        history = spring;
      } else {  // a displacement that nothing resists is forgotten
        history = history * select<T>(in.stiffness > T(0), first.factor, T(0));
      }
      total = spring;
      sliding = first.exceeded;
      if constexpr (damped) {
        total = spring - in.slip_velocity * in.dashpot;
        const detail::FrictionLimit<T> second = detail::friction_limit<T>(total, strength);
        total = total * second.factor;
        sliding = sliding || second.exceeded;
      }
    }
    state.shear = {history.x(), history.y(), history.z()};
    return {total, sliding};
  }

  /// Energy stored in the shear spring [J]; `stiffness` at the overlap of the state.
  CONTACTLAWS_HD T energy(const State& state, const T& stiffness) const noexcept {
    const Vec3<T> history(state.shear[0], state.shear[1], state.shear[2]);
    const T square = dot<T>(history, history);
    if constexpr (stored == Stored::force) {
      const Mask<T> closed = stiffness > T(0);
      return select<T>(closed, square, T(0)) / (T(2) * select<T>(closed, stiffness, T(1)));
    } else {
      return square * stiffness / T(2);
    }
  }
};

template <class T, class Stiffness = Mindlin<T>, class Rotation = rotation::ProjectRestore<T>>
using ShearForce = IncrementalShear<T, Stored::force, Unloading::keeps, Stiffness, Rotation>;
template <class T, class Stiffness = Mindlin<T>, class Rotation = rotation::ProjectRestore<T>>
using ShearForceRescaled = IncrementalShear<T, Stored::force, Unloading::rescales, Stiffness, Rotation>;
template <class T, class Stiffness = Mindlin<T>, class Rotation = rotation::ProjectRestore<T>>
using ShearDisplacement = IncrementalShear<T, Stored::displacement, Unloading::keeps, Stiffness, Rotation>;
template <class T, class Stiffness = Mindlin<T>, class Rotation = rotation::ProjectRestore<T>>
using ShearDisplacementRescaled = IncrementalShear<T, Stored::displacement, Unloading::rescales, Stiffness, Rotation>;

}  // namespace contactlaws
