// SPDX-License-Identifier: MIT
// A liquid bridge of a given volume V, held by surface tension gamma at a contact angle theta:
//
//   F = 2 pi R gamma f(V/R^3, theta, h/R)     h the gap; 0 while touching: an overlap does not change the force
//   the bridge ruptures where h reaches the rupture gap, once, and V goes back to the host
//
// R = 2 R*: the radius of equal spheres, Derjaguin's radius 2 R1 R2/(R1 + R2) of unlike ones, 2 R of a sphere on a plane.
// f, with its sources, domain and errors, is a rule of bridge_force.hpp: YoungLaplace (exact), WillettClosed or Rabinovich.
// Derjaguin's radius itself is an approximation for small V/R^3 (Willett et al. 2000).
//
// History: V, and the volume returned so far. V + returned changes only where the host pours or dries. A bridge forms
//   Wets::by_host    where the host sets V, or calls make_wet() (then V = bridge_volume)
//   Wets::at_touch   and also, with V = bridge_volume, where a contact without a bridge touches; `returned` falls by as much
// A bridge holds at most bridge_volume: more is cut to that, so that range() bounds every gap across which one pulls.
// A host that keeps a budget of liquid reads `returned` after a step and sets it to 0. One that drops a pair without a step
// beyond range() takes V itself.
//
// Energy: minus the work that pulling the bridge to rupture takes, the integral of the force.
// Rounding: up to 0.9 of the rupture gap the force is off by at most 10 ULP of that at touch; at rupture its square root turns an
// error of the gap into the root of that error (tests/laws/test_capillary_bridge.cpp).
#pragma once

#include <array>
#include <limits>

#include "contactlaws/bridge/bridge_force.hpp"
#include "contactlaws/core/parameter.hpp"
#include "contactlaws/slot.hpp"

namespace contactlaws {

/// Where bridges come from.
enum class Wets { by_host, at_touch };

template <class T, template <class> class ForceRule = YoungLaplace, Wets wets = Wets::by_host>
struct CapillaryBridge {
  using Slot = BridgeSlot<T>;
  template <class U>
  using Rebind = CapillaryBridge<U, ForceRule, wets>;
  static constexpr bool acts = true;

  T surface_tension = T(0);  ///< gamma [N/m]
  T contact_angle = T(0);    ///< theta [rad]
  T bridge_volume = T(0);    ///< of a new bridge, and the largest [m^3]

  struct State {
    T bridge_volume = T(0);    ///< V, 0 for none [m^3]
    T returned_volume = T(0);  ///< from ruptured bridges to the host, less what touches took [m^3]
  };
  static constexpr const char* name = "CapillaryBridge";
  static constexpr std::array<Parameter<CapillaryBridge, T>, 3> parameters() {
    return {{{"surface_tension", "N/m", &CapillaryBridge::surface_tension, Range::not_negative()},
             {"contact_angle", "rad", &CapillaryBridge::contact_angle, Range::closed(0.0, 1.0471975511965979)},
             {"bridge_volume", "m^3", &CapillaryBridge::bridge_volume, Range::not_negative()}}};
  }
  static constexpr std::array<StateValue, 2> state_values() {
    return {{{"bridge_volume", "m^3", +1}, {"returned_volume", "m^3", +1}}};
  }

  /// gamma [N/m], theta [rad], bridge_volume [m^3]. Not checked.
  static CapillaryBridge of(const T& tension, const T& angle, const T& volume) {
    CapillaryBridge bridge;
    bridge.surface_tension = tension;
    bridge.contact_angle = angle;
    bridge.bridge_volume = volume;
    bridge.prepare();
    return bridge;
  }
  /// Reduces the rule to this contact angle. of() and cast() call it. Without it each step does so anew, at a multiple of the
  /// cost: after the angle was changed, or in a law on Columns.
  CONTACTLAWS_HD void prepare() noexcept {
    prepared_rule.prepare(contact_angle);
    prepared_angle = contact_angle;
  }

  /// Whether the contact carries a bridge. A NaN volume counts as one, so that its force is NaN.
  CONTACTLAWS_HD static Mask<T> is_wet(const State& state) noexcept { return negate<T>(state.bridge_volume <= T(0)); }

  /// Fills the bridge where the gap is at most `moisture_gap` [m]. The next step computes the force.
  CONTACTLAWS_HD static void make_wet(State& state, const T& overlap, const T& moisture_gap) noexcept {
    const T more_than_any = T(std::numeric_limits<typename ScalarTraits<T>::Lane>::max());
    state.bridge_volume = select<T>(T(-overlap) <= moisture_gap, more_than_any, state.bridge_volume);
  }
  /// Dries the contact: its liquid evaporates, none is returned.
  CONTACTLAWS_HD static void make_dry(State& state) noexcept { state.bridge_volume = T(0); }

  /// Derjaguin's radius R [m]
  CONTACTLAWS_HD static T radius(const PairProperties<T>& pair) noexcept { return T(2) * pair.effective_radius; }

  /// Gap at which a bridge of this volume ruptures [m].
  CONTACTLAWS_HD T rupture_gap(const PairProperties<T>& pair, const T& volume) const noexcept {
    return with_rule([&](const ForceRule<T>& rule) { return Size(pair, volume).rupture_gap(rule); });
  }
  /// Largest gap across which a bridge exists [m]: the rupture gap of bridge_volume.
  CONTACTLAWS_HD T range(const PairProperties<T>& pair) const noexcept {
    return select<T>(bridge_volume > T(0), rupture_gap(pair, bridge_volume), T(0));
  }

  CONTACTLAWS_HD BridgeResponse<T> respond(State& state, const PairProperties<T>& pair,
                                           const T& overlap) const noexcept {
    T volume = minimum<T>(state.bridge_volume, bridge_volume);
    if constexpr (wets == Wets::at_touch) {
      const Mask<T> forms = overlap >= T(0) && volume <= T(0);
      volume = select<T>(forms, bridge_volume, volume);
      state.returned_volume = select<T>(forms, T(state.returned_volume - bridge_volume), state.returned_volume);
    }
    const Mask<T> dry = volume <= T(0);
    state.bridge_volume = volume;
    if (all<T>(dry)) return {T(0), negate<T>(dry)};
    return with_rule([&](const ForceRule<T>& rule) -> BridgeResponse<T> {
      const T gap = positive_part<T>(T(-overlap));
      const Size size(pair, volume);
      const Mask<T> touching = gap <= T(0);
      T relative = rule.force_at_touch(size.q);
      Mask<T> ruptured = Mask<T>(false);
      if (!all<T>(touching || dry)) {
        relative = select<T>(touching, relative, rule.force(size.q, gap, size.length));
        ruptured = rule.is_ruptured(size.q, gap, size.length) && negate<T>(dry);
      }
      const Mask<T> intact = negate<T>(dry || ruptured);
      const T force = T(2) * pi<T>() * surface_tension * radius(pair) * relative;
      state.bridge_volume = select<T>(ruptured, T(0), volume);
      state.returned_volume = select<T>(ruptured, T(state.returned_volume + volume), state.returned_volume);
      return {select<T>(intact, force, T(0)), intact};
    });
  }

  /// Stored energy, zero at rupture [J].
  CONTACTLAWS_HD T energy(const State& state, const PairProperties<T>& pair, const T& overlap) const noexcept {
    return with_rule([&](const ForceRule<T>& rule) {
      const T volume = minimum<T>(state.bridge_volume, bridge_volume);
      const T gap = positive_part<T>(T(-overlap));
      const Size size(pair, volume);
      const Mask<T> intact = negate<T>(volume <= T(0) || rule.is_ruptured(size.q, gap, size.length));
      const T work = size.length * rule.work_to_rupture(size.q, gap, size.length) +
                     positive_part<T>(overlap) * rule.force_at_touch(size.q);
      return select<T>(intact, T(-(T(2) * pi<T>() * surface_tension * radius(pair)) * work), T(0));
    });
  }

 private:
  /// A bridge of volume V, at most R^3. Of no liquid, that of R^3: what is computed with it is not used.
  struct Size {
    T q;       ///< (V/R^3)^(1/6)
    T length;  ///< sqrt(2 V/(pi R)), the gap of x = 1 [m]

    CONTACTLAWS_HD Size(const PairProperties<T>& pair, const T& volume) noexcept {
      const T r = radius(pair);
      const T cube = r * r * r;
      q = power_of_quotient<T>(select<T>(volume <= T(0), cube, minimum<T>(volume, cube)), cube, T(T(1) / T(6)));
      length = detail::bridge_scale<T>() * r * T(T(q * q) * q);
    }
    /// Rounded up: is_ruptured() rounds otherwise, and holds from here on.
    CONTACTLAWS_HD T rupture_gap(const ForceRule<T>& rule) const noexcept {
      using Limits = std::numeric_limits<typename ScalarTraits<T>::Lane>;
      return length * rule.rupture(q) * T(T(1) + T(16) * T(Limits::epsilon()));
    }
  };
  /// use(the rule for this contact angle): the prepared one, unless the angle was changed since.
  template <class Use>
  CONTACTLAWS_HD auto with_rule(const Use& use) const noexcept {
    const Mask<T> is_ready = contact_angle <= prepared_angle && contact_angle >= prepared_angle;
    ForceRule<T> anew;
    const ForceRule<T>* rule = &prepared_rule;
    if (!all<T>(is_ready)) {
      anew.prepare(contact_angle);
      rule = &anew;
    }
    return use(*rule);
  }

  ForceRule<T> prepared_rule = ForceRule<T>();
  T prepared_angle = T(-1);  // no angle
};

}  // namespace contactlaws
