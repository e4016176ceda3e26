// SPDX-License-Identifier: MIT
// Hertz contact of two elastic spheres, o the overlap:
//
//   a = sqrt(R* o)     F = 4/3 E* sqrt(R*) o^(3/2) = 4/3 E* a o     dF/do = 2 E* a
//
// Johnson (1985) Eqs 4.22-4.24; Potyondy (2019) Eq. 13.
// Domain: o << R*, no adhesion (with it: normal/dmt.hpp). No history.
// Error: <= 4 ULP in force, <= 3 in stiffness (tests/laws/test_hertz.cpp).
#pragma once

#include <array>

#include "contactlaws/core/parameter.hpp"
#include "contactlaws/slot.hpp"

namespace contactlaws {

/// Hertz's response to an indentation >= 0 [m], of rough surfaces less than the overlap.
template <class T>
CONTACTLAWS_HD HertzResponse<T> hertz_response(const PairProperties<T>& pair, const T& indentation) noexcept {
  const T contact_radius = sqrt_of_product<T>(pair.effective_radius, indentation);
  const T stiffness = T(2) * pair.effective_young * contact_radius;
  const T secant = stiffness * T(T(2) / T(3));
  return {{secant * indentation, stiffness, secant, stiffness}, contact_radius};
}

/// Work of loading to an indentation along Hertz's curve: 2/5 F d [J].
template <class T>
CONTACTLAWS_HD T hertz_energy(const PairProperties<T>& pair, const T& indentation) noexcept {
  return T(hertz_response<T>(pair, indentation).force * indentation) * T(T(2) / T(5));
}

template <class T>
struct Hertz {
  using Slot = NormalSlot<T>;
  using Scalar = T;
  template <class U>
  using Rebind = Hertz<U>;

  struct State {};
  static constexpr Spring spring = Spring::hertz;  ///< for a coefficient of restitution
  static constexpr const char* name = "Hertz";
  static constexpr std::array<Parameter<Hertz, T>, 0> parameters() { return {}; }
  static constexpr std::array<StateValue, 0> state_values() { return {}; }

  CONTACTLAWS_HD HertzResponse<T> respond(State&, const PairProperties<T>& pair, const T& overlap) const noexcept {
    return hertz_response<T>(pair, overlap);
  }
  CONTACTLAWS_HD T energy(const State&, const PairProperties<T>& pair, const T& overlap) const noexcept {
    return hertz_energy<T>(pair, overlap);
  }
};

}  // namespace contactlaws
