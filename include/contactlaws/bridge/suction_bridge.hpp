// SPDX-License-Identifier: MIT
// A liquid bridge that pulls by suction, g the gap (-overlap), R_o the smaller radius:
//
//   F_m = F_max                      g <= 0                F_max = psi pi R_o^2
//         F_max exp(-g / lambda)     0 < g < g_r           lambda = decay_length R_o
//         0, and the bridge is gone  g >= g_r              g_r    = rupture_gap R_o
//
// Potyondy (2019) Eq. 12, where lambda = g_r = 2 R_o. Domain: psi >= 0. One value of history, the moisture state.
// Error: <= 5 ULP at gaps within a decay length, 2 more for each further one (tests/laws/test_suction_bridge.cpp).
#pragma once

#include <array>

#include "contactlaws/core/parameter.hpp"
#include "contactlaws/slot.hpp"

namespace contactlaws {

/// The empty bridge slot.
template <class T>
struct Dry {
  using Slot = BridgeSlot<T>;
  template <class U>
  using Rebind = Dry<U>;
  static constexpr bool acts = false;

  struct State {};
  static constexpr const char* name = "Dry";
  static constexpr std::array<Parameter<Dry, T>, 0> parameters() { return {}; }
  static constexpr std::array<StateValue, 0> state_values() { return {}; }

  CONTACTLAWS_HD T range(const PairProperties<T>&) const noexcept { return T(0); }
};

template <class T>
struct SuctionBridge {
  using Slot = BridgeSlot<T>;
  template <class U>
  using Rebind = SuctionBridge<U>;
  static constexpr bool acts = true;

  T suction = T(0);       ///< psi [Pa]
  T decay_length = T(2);  ///< lambda / R_o [1]
  T rupture_gap = T(2);   ///< g_r / R_o [1]

  struct State {
    T moisture = T(0);  ///< 0 dry, 1 dry after rupture, 2 wet
  };
  static constexpr const char* name = "SuctionBridge";
  static constexpr std::array<Parameter<SuctionBridge, T>, 3> parameters() {
    return {{{"suction", "Pa", &SuctionBridge::suction, Range::not_negative()},
             {"decay_length", "1", &SuctionBridge::decay_length, Range::positive()},
             {"rupture_gap", "1", &SuctionBridge::rupture_gap, Range::positive()}}};
  }
  static constexpr std::array<StateValue, 1> state_values() { return {{{"moisture", "1", +1}}}; }

  /// Whether the contact carries a bridge. A NaN moisture counts as wet, so that its force is NaN.
  CONTACTLAWS_HD static Mask<T> is_wet(const State& state) noexcept { return negate<T>(state.moisture < T(2)); }

  /// Wets the contact where its gap is at most `moisture_gap` [m]. The next step computes the force.
  CONTACTLAWS_HD static void make_wet(State& state, const T& overlap, const T& moisture_gap) noexcept {
    state.moisture = select<T>(T(-overlap) <= moisture_gap, T(2), state.moisture);
  }
  /// Dries the contact. The next step computes the force.
  CONTACTLAWS_HD static void make_dry(State& state) noexcept { state.moisture = T(0); }

  /// Gap at which a bridge ruptures [m].
  CONTACTLAWS_HD T rupture(const PairProperties<T>& pair) const noexcept { return rupture_gap * pair.min_radius; }
  /// Largest gap across which a bridge pulls [m]: 0 without suction.
  CONTACTLAWS_HD T range(const PairProperties<T>& pair) const noexcept {
    return select<T>(suction > T(0), rupture(pair), T(0));
  }

  /// F_max [N]
  CONTACTLAWS_HD T largest_force(const PairProperties<T>& pair) const noexcept {
    return suction * pi<T>() * T(pair.min_radius * pair.min_radius);
  }

  CONTACTLAWS_HD BridgeResponse<T> respond(State& state, const PairProperties<T>& pair,
                                           const T& overlap) const noexcept {
    using std::exp;
    const Mask<T> dry = state.moisture < T(2);
    if (all<T>(dry)) return {T(0), negate<T>(dry)};
    const T gap = positive_part<T>(T(-overlap));
    const Mask<T> ruptured = gap >= rupture(pair);
    const Mask<T> intact = negate<T>(dry || ruptured);
    T force = largest_force(pair);
    if (!all<T>(gap <= T(0))) force = force * T(exp(T(-gap / (decay_length * pair.min_radius))));
    force = select<T>(state.moisture >= T(2), force, state.moisture);  // a NaN moisture gives a NaN force
    state.moisture = select<T>(ruptured && negate<T>(dry), T(1), state.moisture);
    return {select<T>(intact, force, T(0)), intact};
  }

  /// Stored energy, zero at rupture: minus the work that pulling the bridge to rupture takes [J].
  CONTACTLAWS_HD T energy(const State& state, const PairProperties<T>& pair, const T& overlap) const noexcept {
    using std::exp;
    const T gap = positive_part<T>(T(-overlap));
    const T decay = decay_length * pair.min_radius;
    const T beyond_touch = decay * T(T(exp(T(-gap / decay))) - T(exp(T(-rupture(pair) / decay))));
    const Mask<T> intact = is_wet(state) && negate<T>(gap >= rupture(pair));
    return select<T>(intact, T(-largest_force(pair) * T(beyond_touch + positive_part<T>(overlap))), T(0));
  }
};

}  // namespace contactlaws
