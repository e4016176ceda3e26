// SPDX-License-Identifier: MIT
// Adhesion of stiff small spheres: Hertz's force less a constant pull while the bodies touch, o the overlap:
//
//   F = 4/3 E* sqrt(R*) o^(3/2) - F_c,   F_c = 2 pi w R*,   a = sqrt(R* o),   dF/do = 2 E* a     o > 0
//   F = 0                                                                                       o <= 0
//
// w [J/m^2] is the work of adhesion of the pair, twice the surface energy of one material. The pull-off force is F_c, at
// touch; the force jumps there, and there is no hysteresis. Friction acts on F + F_c (Thornton 1991; other rules:
// AdhesiveFriction). Dashpots scale with Hertz's secant, which is finite at touch: (F + F_c)/o, not F/o.
//
// Derjaguin, Muller & Toporov (1975); for the choice between DMT and JKR: Tabor's parameter
// (R* w^2 / (E*^2 z0^3))^(1/3) << 1, z0 the interatomic distance.
// Domain: o << R*. No history. Error: <= 5 ULP of the larger of both terms (tests/laws/test_dmt.cpp).
#pragma once

#include <array>

#include "contactlaws/normal/hertz.hpp"

namespace contactlaws {

template <class T, AdhesiveFriction rule = AdhesiveFriction::thornton_dmt>
struct Dmt {
  using Slot = NormalSlot<T>;
  using Scalar = T;
  template <class U>
  using Rebind = Dmt<U, rule>;
  static constexpr bool adheres = true;

  T work_of_adhesion = T(0);  ///< w [J/m^2]

  struct State {};
  static constexpr Spring spring = Spring::hertz;  ///< for a coefficient of restitution
  static constexpr const char* name = "Dmt";
  static constexpr std::array<Parameter<Dmt, T>, 1> parameters() {
    return {{{"work_of_adhesion", "J/m^2", &Dmt::work_of_adhesion, Range::not_negative()}}};
  }
  static constexpr std::array<StateValue, 0> state_values() { return {}; }

  /// F_c [N]
  CONTACTLAWS_HD T pull_off_force(const PairProperties<T>& pair) const noexcept {
    return T(2) * pi<T>() * work_of_adhesion * pair.effective_radius;
  }
  CONTACTLAWS_HD Mask<T> touches(const State&, const PairProperties<T>&, const T& overlap) const noexcept {
    return negate<T>(overlap <= T(0));
  }
  /// Beyond touch the law exerts no force [m].
  CONTACTLAWS_HD T range(const PairProperties<T>&) const noexcept { return T(0); }

  CONTACTLAWS_HD AdhesiveResponse<T> respond(State&, const PairProperties<T>& pair, const T& overlap) const noexcept {
    const T pull_off = pull_off_force(pair);
    AdhesiveResponse<T> response{hertz_response<T>(pair, positive_part<T>(overlap)), pull_off,
                                 counted_adhesion<rule>(pull_off)};
    response.force = response.force - pull_off;
    return response;
  }

  /// Zero at touch: loading first releases F_c o [J].
  CONTACTLAWS_HD T energy(const State&, const PairProperties<T>& pair, const T& overlap) const noexcept {
    const T closed = positive_part<T>(overlap);
    return hertz_energy<T>(pair, closed) - pull_off_force(pair) * closed;
  }
};

}  // namespace contactlaws
