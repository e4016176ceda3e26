// SPDX-License-Identifier: MIT
// Coefficient of restitution e <-> damping constant alpha of the dashpots, exact for a head-on impact.
//
// In y = o^(5/4) and dtau = o^(1/4) dt a damped Hertz contact is a damped linear oscillator of ratio z = alpha / sqrt(5)
// (Tsuji et al. 1992; Antypov & Elliott 2011); a linear contact is one of ratio z = alpha / 2. The impact ends
//
//   tension allowed   where the overlap ends:   e = exp(-pi z / sqrt(1 - z^2)),          z = -ln e / sqrt(ln^2 e + pi^2)
//   tension clipped   where the force ends:     e = exp(-2 z acos(z) / sqrt(1 - z^2)),   z by one scalar solve
//                     (z > 1: acosh(z) / sqrt(z^2 - 1), the same function; Schwager & Poeschel 2007)
//
// Domain: e in (0, 1]. Error in z: <= 3 ULP with tension, <= 4 - 2 ln e ULP without, where z grows as 1/sqrt(e) beyond
// critical damping (tests/laws/test_restitution.cpp). An impact realises e to 1e-6 (tests/dem/test_impact.cpp).
#pragma once

#include <type_traits>

#include "contactlaws/core/validate.hpp"
#include "contactlaws/damping/dashpots.hpp"

namespace contactlaws {

namespace detail {

/// acos(z)/sqrt(1 - z^2), z > -1, and its continuation acosh(z)/sqrt(z^2 - 1) beyond 1.
template <class T>
T arc_over_chord(const T& z) {
  using std::abs;
  using std::atan2;
  using std::log1p;
  using std::sqrt;
  const T one_minus = T(1) - z;
  const T chord = T(sqrt(T(abs(one_minus)))) * T(sqrt(T(T(1) + z)));  // z^2 may overflow
  const T half_tangent = sqrt(T(abs(one_minus) / (T(1) + z)));        // tan(acos(z)/2), or tanh(acosh(z)/2)
  if (half_tangent < T(1) / T(16)) {                                  // artan(h)(u)/u by series: 0/0 at z = 1
    const T u2 = z < T(1) ? T(-half_tangent * half_tangent) : T(half_tangent * half_tangent);
    T sum = T(0);
    for (int k = 60; k >= 0; --k) sum = sum * u2 + T(1) / T(2 * k + 1);
    return T(2) * sum / (T(1) + z);
  }
  if (z < T(1)) return T(2) * T(atan2(half_tangent, T(1))) / chord;
  return T(log1p(T(chord - one_minus))) / chord;  // acosh(z) = log(z + sqrt(z^2 - 1))
}

}  // namespace detail

/// Restitution of a linear contact with damping ratio z >= 0.
template <class T>
T restitution_of_damping_ratio(const T& z, Tension tension) {
  using std::acos;
  using std::exp;
  using std::sqrt;
  if (tension == Tension::clipped) return exp(T(T(-2) * z * detail::arc_over_chord<T>(z)));
  if (z >= T(1)) return T(0);  // creeps back, never to part
  return exp(T(-pi<T>() * z / T(sqrt(T((T(1) - z) * (T(1) + z))))));
}

/// Damping ratio for a coefficient of restitution. @throws std::invalid_argument unless e in (0, 1]
template <class T>
T damping_ratio_of_restitution(const T& e, Tension tension) {
  using std::abs;
  using std::log;
  using std::sqrt;
  require_in(Range::left_open(0.0, 1.0), static_cast<double>(e), "Dashpots", "restitution", "1");
  const T decrement = T(0) - T(log(e));  // not -0 at e = 1
  const T allowed = decrement / T(sqrt(T(decrement * decrement + pi<T>() * pi<T>())));
  if (tension == Tension::allowed) return allowed;
  // Newton on 2 z A(z) = decrement. With A = acos(z)/sqrt(1 - z^2):  A' = (z A - 1)/(1 - z^2), and A'(1) = -1/3.
  // The left side is concave and grows with z, so from a start to the left no step overshoots.
  T z = decrement / pi<T>();
  T before = z;
  for (int i = 0; i < 100; ++i) {
    const T arc = detail::arc_over_chord<T>(z);
    const T beyond_one = z - T(1);
    const T slope_of_arc =
        abs(beyond_one) < T(1) / T(2000) ? T(T(-1) / T(3)) : T((T(1) - z * arc) / beyond_one / (T(1) + z));
    const T step = (decrement - T(2) * z * arc) / (T(2) * (arc + z * slope_of_arc));
    const T next = z + step;
    if (next == z || next == before) break;  // there, or dithering by a digit
    before = z;
    z = next;
  }
  return z;
}

/// alpha [1] of Dashpots that realise the coefficient of restitution e.
/// @throws std::invalid_argument unless e in (0, 1]
template <class T>
T damping_constant(const T& e, Spring spring, Tension tension) {
  using std::sqrt;
  const T per_ratio = spring == Spring::hertz ? T(sqrt(T(5))) : T(2);
  return per_ratio * damping_ratio_of_restitution<T>(e, tension);
}

/// Whether the dashpots of a law may pull.
template <class Damping>
inline constexpr Tension tension_of = Tension::allowed;
/// That of Dashpots.
template <class T, Tension tension, ShearDashpot shear>
inline constexpr Tension tension_of<Dashpots<T, tension, shear>> = tension;

/// alpha [1] of a law's own dashpots beside its own normal law: damping_constant<DryHill<double>>(0.7). Without pull, where the law adheres.
/// @throws std::invalid_argument unless e in (0, 1]
template <class Law>
typename Law::Scalar damping_constant(const typename Law::Scalar& e) {
  using Damping = std::decay_t<decltype(Law::damping)>;
  static_assert(Damping::acts, "the law has no dashpots");
  return damping_constant<typename Law::Scalar>(e, std::decay_t<decltype(Law::normal)>::spring, tension_of<Damping>);
}

/// The coefficient of restitution that Dashpots of constant alpha >= 0 realise.
template <class T>
T restitution(const T& alpha, Spring spring, Tension tension) {
  using std::sqrt;
  const T per_ratio = spring == Spring::hertz ? T(sqrt(T(5))) : T(2);
  return restitution_of_damping_ratio<T>(T(alpha / per_ratio), tension);
}

}  // namespace contactlaws
