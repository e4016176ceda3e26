// SPDX-License-Identifier: MIT
// Linear springs, o the overlap:
//
//   F = k o        with k given (LinearSpring), or from an effective modulus (LinearModulus):
//                  k = E pi r^2 / L,  r = R_o the smaller radius, L = R1 + R2 (a ball on a wall: r = L = R)
//
// Potyondy (2019) Sec. 2.1 and Eq. 22. Domain: any overlap; stiffness does not grow with it. No history.
// Error: <= 1 ULP for a given k, <= 5 ULP from a modulus (tests/laws/test_linear.cpp).
#pragma once

#include <array>

#include "contactlaws/core/parameter.hpp"
#include "contactlaws/slot.hpp"

namespace contactlaws {

namespace detail {
template <class T>
CONTACTLAWS_HD NormalResponse<T> linear_response(const T& stiffness, const T& overlap) noexcept {
  const T active = select<T>(overlap <= T(0), T(0), stiffness);
  return {active * overlap, active, active, active};
}
}  // namespace detail

template <class T>
struct LinearSpring {
  using Slot = NormalSlot<T>;
  using Scalar = T;
  template <class U>
  using Rebind = LinearSpring<U>;

  T normal_stiffness = T(0);  ///< k [N/m]

  struct State {};
  static constexpr Spring spring = Spring::linear;  ///< for a coefficient of restitution
  static constexpr const char* name = "LinearSpring";
  static constexpr std::array<Parameter<LinearSpring, T>, 1> parameters() {
    return {{{"normal_stiffness", "N/m", &LinearSpring::normal_stiffness, Range::positive()}}};
  }
  static constexpr std::array<StateValue, 0> state_values() { return {}; }

  CONTACTLAWS_HD NormalResponse<T> respond(State&, const PairProperties<T>&, const T& overlap) const noexcept {
    return detail::linear_response<T>(normal_stiffness, overlap);
  }
  CONTACTLAWS_HD T energy(const State&, const PairProperties<T>&, const T& overlap) const noexcept {
    return T(normal_stiffness * overlap) * overlap / T(2);
  }
};

template <class T>
struct LinearModulus {
  using Slot = NormalSlot<T>;
  using Scalar = T;
  template <class U>
  using Rebind = LinearModulus<U>;

  T modulus = T(0);  ///< effective modulus E [Pa]

  struct State {};
  static constexpr Spring spring = Spring::linear;  ///< for a coefficient of restitution
  static constexpr const char* name = "LinearModulus";
  static constexpr std::array<Parameter<LinearModulus, T>, 1> parameters() {
    return {{{"modulus", "Pa", &LinearModulus::modulus, Range::positive()}}};
  }
  static constexpr std::array<StateValue, 0> state_values() { return {}; }

  /// k [N/m]
  CONTACTLAWS_HD T normal_stiffness(const PairProperties<T>& pair) const noexcept {
    return modulus * pi<T>() * pair.min_radius * T(pair.min_radius / pair.length);
  }
  CONTACTLAWS_HD NormalResponse<T> respond(State&, const PairProperties<T>& pair, const T& overlap) const noexcept {
    return detail::linear_response<T>(normal_stiffness(pair), overlap);
  }
  CONTACTLAWS_HD T energy(const State&, const PairProperties<T>& pair, const T& overlap) const noexcept {
    return T(normal_stiffness(pair) * overlap) * overlap / T(2);
  }
};

}  // namespace contactlaws
