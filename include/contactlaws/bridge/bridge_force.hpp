// SPDX-License-Identifier: MIT
// The force of a liquid bridge of volume V between two spheres of radius R, contact angle theta, gap h, as three rules. Each
// takes q = (V/R^3)^(1/6), h and l = sqrt(2 V/(pi R)), and returns F/(2 pi R gamma), the rupture gap over l, and the integral of
// the force over h/l up to there. None counts gravity or the pinning of the contact line. In what follows x = h/l.
//
//   YoungLaplace    the exact axisymmetric bridge on its stable branch, as polynomials:
//                   F = (1 - x/sqrt(x^2 + 1)) P(q, y, theta),   e = sqrt(x^2 + 1) - x
//                   y = sqrt((e - e_r)/(1 - e_r)): 1 at touch, 0 at rupture
//                   rupture at e_r = q E(q, theta), the largest gap at which the equation has a solution
//   WillettClosed   F = cos(theta) / (1 + 1.05 s + 2.5 s^2),    s = h sqrt(R/V)        Willett et al. (2000) Eq. 12
//   Rabinovich      F = cos(theta) (1 - x/sqrt(x^2 + 1))                               Rabinovich et al. (2005) Eqs 19, 20
//
// Both closed forms rupture at h = (1 + theta/2) V^(1/3) (Lian, Thornton & Adams 1993). Rabinovich's second term, the pull of
// the surface along the rim, is left out: with it the formula is off by up to 2.7 times the largest force.
//
// Domain: V/R^3 from 1e-5 to 0.1, theta from 0 to 60 degrees. Beyond, YoungLaplace keeps P and E of the nearest volume, so that
// force and rupture gap scale as those of small volumes do (at touch then 2 to 5 % low); V > R^3 counts as R^3.
// Error in the largest force of the bridge, over the domain up to the exact rupture (tests/laws/test_capillary_bridge.cpp):
//   YoungLaplace    0.06 %, 0.1 % at rupture itself; rupture gap 5e-6, energy 0.2 % of that at touch
//   WillettClosed   -34 to +94 %, to 20 degrees -9 to +31 %; Lian's rupture gap -14 to +4 %
//   Rabinovich      -35 to +94 %, to 20 degrees -10 to +31 %
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "contactlaws/bridge/young_laplace_table.hpp"
#include "contactlaws/core/power.hpp"
#include "contactlaws/core/scalar.hpp"

namespace contactlaws {

namespace detail {

/// sqrt(2/pi), what x is scaled by.
template <class T>
CONTACTLAWS_HD T bridge_scale() noexcept {
  return scalar_cast<T>(0.79788456080286535588);
}

/// How far a bridge is open, by one division: packs divide slowly.
template <class T>
struct BridgeOpening {
  T e;      ///< sqrt(x^2 + 1) - x
  T limit;  ///< 1 - x/sqrt(x^2 + 1), the force of a small bridge

  CONTACTLAWS_HD static BridgeOpening of(const T& gap, const T& length) noexcept {
    using std::sqrt;
    const T root = sqrt(T(gap * gap + length * length));
    const T scaled = length / T(root * T(root + gap));
    return {root * scaled, length * scaled};
  }
};

/// x at the rupture gap (1 + theta/2) V^(1/3).
template <class T>
CONTACTLAWS_HD T rupture_of_lian(const T& angle, const T& q) noexcept {
  return T(T(1) + angle / T(2)) / T(bridge_scale<T>() * q);
}
template <class T>
CONTACTLAWS_HD Mask<T> ruptures_by_lian(const T& angle, const T& q, const T& gap, const T& length) noexcept {
  return bridge_scale<T>() * q * gap >= T(T(1) + angle / T(2)) * length;
}

}  // namespace detail

/// The exact force. prepare() reduces the table to one contact angle.
template <class T>
struct YoungLaplace {
  template <class U>
  using Rebind = YoungLaplace<U>;
  static constexpr const char* name = "YoungLaplace";

  CONTACTLAWS_HD void prepare(const T& angle) noexcept { polynomials.prepare(angle); }

  CONTACTLAWS_HD T rupture(const T& q) const noexcept {
    const T e = least_e(q);
    return T(T(1) / e - e) / T(2);
  }
  /// gap >= rupture(q) length, without a division.
  CONTACTLAWS_HD Mask<T> is_ruptured(const T& q, const T& gap, const T& length) const noexcept {
    const T e = least_e(q);
    return T(2) * e * gap >= T(T(1) - e * e) * length;
  }
  CONTACTLAWS_HD T force_at_touch(const T& q) const noexcept {
    return detail::polynomial(polynomials.touch, scaled(q));
  }
  CONTACTLAWS_HD T force(const T& q, const T& gap, const T& length) const noexcept {
    const auto opening = detail::BridgeOpening<T>::of(gap, length);
    return opening.limit * detail::polynomial(shape(q), centred_y(q, opening.e));
  }
  /// With x' = -(1 + e^2)/(2 e^2) e', the factor of P dx turns into -de = -(1 - e_r) 2 y dy: a polynomial again.
  CONTACTLAWS_HD T work_to_rupture(const T& q, const T& gap, const T& length) const noexcept {
    const std::array<T, Polynomials::force_terms> p = shape(q);
    std::array<T, Polynomials::force_terms + 2> integral;  // of P (1 + t)/2 by t = 2 y - 1
    for (std::size_t i = 0; i < integral.size(); ++i) integral[i] = T(0);
    for (std::size_t i = 0; i < p.size(); ++i) {
      integral[i + 1] = integral[i + 1] + p[i] / scalar_cast<T>(2 * (i + 1));
      integral[i + 2] = integral[i + 2] + p[i] / scalar_cast<T>(2 * (i + 2));
    }
    const T here = centred_y(q, detail::BridgeOpening<T>::of(gap, length).e);
    return T(T(1) - least_e(q)) * T(detail::polynomial(integral, here) - detail::polynomial(integral, T(-1)));
  }

 private:
  using Polynomials = detail::YoungLaplacePolynomials<T>;

  /// q in the table's domain, scaled to [-1, 1].
  CONTACTLAWS_HD static T scaled(const T& q) noexcept {
    constexpr double lowest = Polynomials::lowest, highest = Polynomials::highest;
    const T inside = minimum<T>(maximum<T>(q, scalar_cast<T>(lowest)), scalar_cast<T>(highest));
    return inside * scalar_cast<T>(2 / (highest - lowest)) - scalar_cast<T>((highest + lowest) / (highest - lowest));
  }
  /// e at rupture.
  CONTACTLAWS_HD T least_e(const T& q) const noexcept { return q * detail::polynomial(polynomials.rupture, scaled(q)); }
  /// 2 y - 1
  CONTACTLAWS_HD T centred_y(const T& q, const T& e) const noexcept {
    using std::sqrt;
    const T least = least_e(q);
    return T(2) * T(sqrt(T(positive_part<T>(e - least) / T(T(1) - least)))) - T(1);
  }
  /// P of this volume, by powers of 2 y - 1.
  CONTACTLAWS_HD std::array<T, Polynomials::force_terms> shape(const T& q) const noexcept {
    const T s = scaled(q);
    std::array<T, Polynomials::force_terms> p;
    for (std::size_t i = 0; i < p.size(); ++i) p[i] = detail::polynomial(polynomials.force[i], s);
    return p;
  }

  Polynomials polynomials;
};

/// What the closed forms share: cos(angle) at touch, and the rupture gap of Lian, Thornton & Adams (1993).
template <class T>
struct ClosedBridgeForce {
  CONTACTLAWS_HD void prepare(const T& angle) noexcept {
    using std::cos;
    prepared_angle = angle;
    cosine = cos(angle);
  }
  CONTACTLAWS_HD T rupture(const T& q) const noexcept { return detail::rupture_of_lian<T>(prepared_angle, q); }
  CONTACTLAWS_HD Mask<T> is_ruptured(const T& q, const T& gap, const T& length) const noexcept {
    return detail::ruptures_by_lian<T>(prepared_angle, q, gap, length);
  }
  CONTACTLAWS_HD T force_at_touch(const T&) const noexcept { return cosine; }

 protected:
  T prepared_angle = T(0);  ///< of prepare() [rad]
  T cosine = T(1);          ///< of that angle
};

/// A closed form fitted to perfectly wetting bridges.
template <class T>
struct WillettClosed : ClosedBridgeForce<T> {
  template <class U>
  using Rebind = WillettClosed<U>;
  static constexpr const char* name = "WillettClosed";

  CONTACTLAWS_HD T force(const T&, const T& gap, const T& length) const noexcept {
    const T s = detail::bridge_scale<T>() * gap;  // times length
    const T square = length * length;
    return this->cosine * square / T(square + s * (scalar_cast<T>(1.05) * length + scalar_cast<T>(2.5) * s));
  }
  /// The integral of 1/(1 + b s + c s^2) is 2/d artan((2 c s + b)/d), d^2 = 4 c - b^2.
  CONTACTLAWS_HD T work_to_rupture(const T& q, const T& gap, const T& length) const noexcept {
    using std::asin;
    using std::sqrt;
    const T d = sqrt(scalar_cast<T>(10.0 - 1.05 * 1.05));
    const auto angle_at = [&](const T& at) {
      const T u = T(scalar_cast<T>(5.0) * T(detail::bridge_scale<T>() * at) + scalar_cast<T>(1.05)) / d;
      return T(asin(T(u / T(sqrt(T(T(1) + u * u))))));  // artan u
    };
    return this->cosine * T(2) / T(d * detail::bridge_scale<T>()) *
           T(angle_at(this->rupture(q)) - angle_at(T(gap / length)));
  }
};

/// The limit of small volumes.
template <class T>
struct Rabinovich : ClosedBridgeForce<T> {
  template <class U>
  using Rebind = Rabinovich<U>;
  static constexpr const char* name = "Rabinovich";

  CONTACTLAWS_HD T force(const T&, const T& gap, const T& length) const noexcept {
    return this->cosine * detail::BridgeOpening<T>::of(gap, length).limit;
  }
  CONTACTLAWS_HD T work_to_rupture(const T& q, const T& gap, const T& length) const noexcept {
    using Opening = detail::BridgeOpening<T>;
    return this->cosine * T(Opening::of(gap, length).e - Opening::of(this->rupture(q), T(1)).e);
  }
};

}  // namespace contactlaws
