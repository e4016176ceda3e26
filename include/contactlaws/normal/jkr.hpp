// SPDX-License-Identifier: MIT
// Adhesion of soft spheres, whose contact reaches beyond touch; a the contact radius, o the overlap:
//
//   o = a^2/R* - q,   q = sqrt(2 pi w a/E*)     F = 4 E* a^3/(3 R*) - sqrt(8 pi w E* a^3) = 4/3 E* a (o - q/2)
//   dF/do = 2 E* a (1 - 2 h^(3/2) / (a^(3/2) - h^(3/2)))        h = (pi w R*^2 / (8 E*))^(1/3), a at pull-off
//   energy  E* a (8/15 A^2 - 4/3 A q + q^2/2), A = a^2/R*       0 of free surfaces: the elastic energy less pi a^2 w
//
// w [J/m^2] is the work of adhesion of the pair, twice the surface energy of one material. The bodies touch at o = 0, where F
// jumps to -8/9 F_c; the least force is -F_c = -3/2 pi w R*, at a^3 = 9 h^3; they let go at o = -3 h^2/R*, where F = -5/9 F_c and
// dF/do is infinite. To touch and to let go releases 3.81 and 0.40 pi w h^2 as heat, in all 7.09 (w^5 R*^4 / E*^2)^(1/3).
//
// Johnson, Kendall & Roberts (1971); Johnson (1985) Eqs 5.47-5.49. For the choice between DMT and JKR see normal/dmt.hpp.
// Decided: at o = 0 itself a new contact is still open, as Hertz's is. Friction acts on F + 2 F_c (Thornton 1991; other rules:
// AdhesiveFriction); tangential load does not peel the contact. Dashpots scale with 4/3 E* a, Hertz's secant at the same radius,
// which is finite everywhere: F/o, which some codes take, is infinite at o = 0. Shear, rolling and the time step scale with
// 2 E* a, an upper bound of dF/do, which is negative near pull-off.
//
// History: whether the contact holds. With z = sqrt(a) - sqrt(h) the branch that holds is
//   z^2 (z^2 + 4 sqrt(h) z + 6 h) = R* o + 3 h^2
// without a cancellation at pull-off, where a itself has an infinite slope. A polynomial (0.2 %), one step of Halley's and one of
// Newton's solve it in packs too. w = 0 gives the bits of Hertz.
// Domain: a << R*; in float a > 1e-11 m. Error in double, for overlaps from pull-off to 1e6 times as much: of F <= 6 eps of the
// larger term, 4/3 E* A a or 2 E* a q (2.3 found for o > 0); beyond touch also what moves o by 4 eps of the range, since dF/do is
// infinite at its end. Energy 5 eps of its terms, dF/do 3 eps of 2 E* a, both for o > 0 (tests/laws/test_jkr.cpp).
#pragma once

#include <array>
#include <limits>

#include "contactlaws/core/sixth_root.hpp"
#include "contactlaws/normal/hertz.hpp"

namespace contactlaws {

template <class T, AdhesiveFriction rule = AdhesiveFriction::thornton_jkr>
struct Jkr {
  using Slot = NormalSlot<T>;
  using Scalar = T;
  template <class U>
  using Rebind = Jkr<U, rule>;
  static constexpr bool adheres = true;

  T work_of_adhesion = T(0);  ///< w [J/m^2]

  struct State {
    T in_contact = T(0);  ///< 1 while the contact holds, else 0
  };
  static constexpr Spring spring = Spring::hertz;  ///< for a coefficient of restitution
  static constexpr const char* name = "Jkr";
  static constexpr std::array<Parameter<Jkr, T>, 1> parameters() {
    return {{{"work_of_adhesion", "J/m^2", &Jkr::work_of_adhesion, Range::not_negative()}}};
  }
  static constexpr std::array<StateValue, 1> state_values() { return {{{"in_contact", "1", +1}}}; }

  /// F_c [N]
  CONTACTLAWS_HD T pull_off_force(const PairProperties<T>& pair) const noexcept {
    return T(T(3) / T(2)) * pi<T>() * work_of_adhesion * pair.effective_radius;
  }
  /// h, the contact radius at which the contact lets go [m].
  CONTACTLAWS_HD T pull_off_radius(const PairProperties<T>& pair) const noexcept { return scales(pair).h; }
  CONTACTLAWS_HD Mask<T> touches(const State& state, const PairProperties<T>& pair, const T& overlap) const noexcept {
    const Mask<T> overlaps = negate<T>(overlap <= T(0));
    const Mask<T> stretched = negate<T>(overlaps || state.in_contact <= T(0));
    if (!any<T>(stretched)) return overlaps;
    return overlaps || (stretched && negate<T>(above_pull_off(state, pair, overlap, pull_off_radius(pair)) <= T(0)));
  }
  /// The gap at which the contact lets go, rounded up [m].
  CONTACTLAWS_HD T range(const PairProperties<T>& pair) const noexcept {
    using Limits = std::numeric_limits<typename ScalarTraits<T>::Lane>;
    const T h = pull_off_radius(pair);
    return T(3) * h * h / pair.effective_radius * (T(1) + T(8) * T(Limits::epsilon()));
  }

  CONTACTLAWS_HD AdhesiveResponse<T> respond(State& state, const PairProperties<T>& pair,
                                             const T& overlap) const noexcept {
    const Contact at = contact(state, pair, overlap);
    state.in_contact = select<T>(at.holds, held(state, overlap), T(0));
    const T hertz = T(2) * pair.effective_young * at.radius;
    const T secant = hertz * T(T(2) / T(3));
    const T pull_off = pull_off_force(pair);
    return {{{secant * (overlap - at.stretch / T(2)), hertz, secant, hertz}, at.radius},
            pull_off,
            counted_adhesion<rule>(pull_off)};
  }

  /// dF/do, 0 when open [N/m]
  CONTACTLAWS_HD T tangent(const State& state, const PairProperties<T>& pair, const T& overlap) const noexcept {
    const Contact at = contact(state, pair, overlap);
    const T& z = at.above_root;
    const auto [h, root_h, per_root] = scales(pair);
    const T softened = T(2) * h * root_h / (z * (z * (z + T(3) * root_h) + T(3) * h));
    return select<T>(at.holds, T(2) * pair.effective_young * at.radius * (T(1) - softened), T(0));
  }

  /// Elastic energy and that of the joined surfaces, 0 while they are apart [J].
  CONTACTLAWS_HD T energy(const State& state, const PairProperties<T>& pair, const T& overlap) const noexcept {
    const Contact at = contact(state, pair, overlap);
    const T flat = overlap + at.stretch;
    return pair.effective_young * at.radius *
           (flat * (T(T(8) / T(15)) * flat - T(T(4) / T(3)) * at.stretch) + at.stretch * at.stretch / T(2));
  }

 private:
  struct Contact {
    Mask<T> holds;
    T radius;      ///< a, 0 when open [m]
    T stretch;     ///< q, 0 when open [m]
    T above_root;  ///< z, not read when open or without adhesion [m^(1/2)]
  };

  struct Scales {
    T h;         ///< [m]
    T root_h;    ///< [m^(1/2)]
    T per_root;  ///< q / sqrt(a) = sqrt(2 pi w / E*) = 4 h^(3/2) / R* [m^(1/2)]
  };
  CONTACTLAWS_HD Scales scales(const PairProperties<T>& pair) const noexcept {
    const T& radius = pair.effective_radius;
    const T inverse = T(1) / (pair.effective_young * radius);  // one division for 1/E* and 1/R*
    const T eighth = pi<T>() * work_of_adhesion / T(8);
    const SixthRoot<T> root = sixth_root<T>(eighth * radius * radius * (radius * inverse));
    return {root.third, root.sixth, T(4) * root.third * root.sixth * (pair.effective_young * inverse)};
  }
  /// 1 where the contact is made by its overlap or was made before, 0 where not. Passes a NaN on.
  CONTACTLAWS_HD static T held(const State& state, const T& overlap) noexcept {
    return select<T>(overlap > T(0), T(1), state.in_contact);
  }
  /// R* o + 3 h^2 [m^2]: positive where the contact holds.
  CONTACTLAWS_HD static T above_pull_off(const State& state, const PairProperties<T>& pair, const T& overlap,
                                         const T& h) noexcept {
    return (pair.effective_radius * overlap + T(3) * (h * h)) * held(state, overlap);
  }

  CONTACTLAWS_HD Contact contact(const State& state, const PairProperties<T>& pair, const T& overlap) const noexcept {
    using std::sqrt;
    if (all<T>(work_of_adhesion <= T(0))) {  // Hertz: a square root has no derivative at 0
      const T closed = positive_part<T>(overlap);
      return {!(overlap <= T(0)), hertz_response<T>(pair, closed).contact_radius, T(closed - overlap), T(1)};
    }
    const auto [h, root_h, per_root] = scales(pair);
    const T s = above_pull_off(state, pair, overlap, h);
    const Mask<T> holds = negate<T>(s <= T(0));
    if (!any<T>(holds)) return {holds, T(0), T(0), T(1)};
    const T z = root_above_pull_off(select<T>(holds, s, T(h * h)), h, root_h);
    const T root_a = root_h + z;
    const T stretch = select<T>(holds, per_root * root_a, T(0));
    // For o > 0 the definition of a as a root of R* (o + q) damps the rounding of q; beyond touch o + q cancels.
    const Mask<T> overlaps = overlap > T(0);
    const T squared = select<T>(overlaps, T(pair.effective_radius * (overlap + stretch)), h);
    const T radius = select<T>(overlaps, sqrt(squared), T(root_a * root_a));
    return {holds, select<T>(holds, radius, T(0)), stretch, z};
  }

  /// The root z > 0 of z^2 (z^2 + 4 H z + 6 h) = s, H = sqrt(h) [m^(1/2)].
  CONTACTLAWS_HD static T root_above_pull_off(const T& s, const T& h, const T& root_h) noexcept {
    using std::sqrt;
    constexpr int digits = std::numeric_limits<typename ScalarTraits<T>::Lane>::digits;
    constexpr int newton_steps = digits <= 53 ? 1 : digits <= 113 ? 2 : 5;
    const T r = sqrt(T(sqrt(s)));  // z where h = 0
    const T near = T(T(5) / T(4)) * root_h;
    const T t = r / (r + near);
    const T bend =
        T(-0.48974609375) + t * (T(0.0390625) + t * (T(0.13720703125) + t * (T(2.0068359375) + t * T(-1.49853515625))));
    T z = r * t * (T(1) + (T(1) - t) * bend);
    const auto excess = [&](const T& x) { return T(x * x * (x * (x + T(4) * root_h) + T(6) * h) - s); };
    const auto slope = [&](const T& x) { return T(T(4) * x * (x * (x + T(3) * root_h) + T(3) * h)); };
    const T f = excess(z), df = slope(z), root = z + root_h;
    z = z - f * df / (df * df - T(6) * f * (root * root));  // f'' = 12 (z + H)^2
    for (int i = 0; i < newton_steps; ++i) z = z - excess(z) / slope(z);
    return z;
  }
};

}  // namespace contactlaws
