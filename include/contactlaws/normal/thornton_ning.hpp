// SPDX-License-Identifier: MIT
// Elastic spheres that yield: Hertz until the largest contact pressure reaches the yield pressure p_y; then the pressure is p_y
// over a growing part of the contact. Unloading follows Hertz with a flattened radius R_p. o the overlap, o_m the largest so far:
//
//   o_y = R* (pi p_y / (2 E*))^2                          where yield begins
//   loading     F = 4/3 E* sqrt(R*) o^(3/2)               o <= o_y
//               F = pi p_y R* (o - o_y/3)                 o > o_y; force and tangent are continuous at o_y
//   unloading   F = 4/3 E* sqrt(R_p) (o - o_p)^(3/2)      dF/do = 2 E* a,  a = sqrt(R_p (o - o_p))
//
//   R*/R_p = F(o_m) / (4/3 E* sqrt(R*) o_m^(3/2))         the contact area at o_m is the same for both radii
//   o_p = o_m (1 - R*/R_p)                                the plastic overlap, where the contact opens
//
// Thornton & Ning (1998), Powder Technology 99, Eqs 6-13 with one radius of unloading; written in overlaps. History: o_m.
// A new contact is fresh: a pair that was apart has its first shape again. Elastic up to the yield speed v_y, and beyond with a
// restitution that falls as v^(-1/4) (Thornton 1997): see ThorntonNing::yield_overlap() and tests/laws/test_thornton_ning.cpp.
// Domain: o << R*, spheres without adhesion. Error: loading <= 8 ULP; unloading <= 16 to half of the elastic overlap.
#pragma once

#include <array>

#include "contactlaws/normal/hertz.hpp"

namespace contactlaws {

template <class T>
struct ThorntonNing {
  using Slot = NormalSlot<T>;
  using Scalar = T;
  template <class U>
  using Rebind = ThorntonNing<U>;

  T yield_pressure = T(0);  ///< p_y, about 2.5 times the yield stress of a metal [Pa]

  struct State {
    T largest_overlap = T(0);  ///< o_m [m]
  };
  static constexpr const char* name = "ThorntonNing";
  static constexpr std::array<Parameter<ThorntonNing, T>, 1> parameters() {
    return {{{"yield_pressure", "Pa", &ThorntonNing::yield_pressure, Range::positive()}}};
  }
  static constexpr std::array<StateValue, 1> state_values() { return {{{"largest_overlap", "m", +1}}}; }

  /// o_y [m]
  CONTACTLAWS_HD T yield_overlap(const PairProperties<T>& pair) const noexcept {
    const T pressure = pi<T>() * yield_pressure / T(T(2) * pair.effective_young);
    return pair.effective_radius * pressure * pressure;
  }

  CONTACTLAWS_HD HertzResponse<T> respond(State& state, const PairProperties<T>& pair,
                                          const T& overlap) const noexcept {
    const Mask<T> virgin = overlap >= state.largest_overlap;
    const T largest = select<T>(virgin, overlap, state.largest_overlap);
    state.largest_overlap = largest;
    const Flattened at = flattened(pair, largest);
    const T elastic = at.indentation(largest, overlap);
    if (all<T>(elastic <= T(0))) return {{T(0), T(0), T(0), T(0)}, T(0)};  // a square root has no derivative at 0
    HertzResponse<T> response = hertz_response<T>(at.pair, elastic);
    const T yielding = pi<T>() * yield_pressure * pair.effective_radius;
    response.stiffness = select<T>(virgin, minimum<T>(response.stiffness, yielding), response.stiffness);
    return response;
  }

  /// Elastic energy, which unloading releases [J].
  CONTACTLAWS_HD T energy(const State& state, const PairProperties<T>& pair, const T& overlap) const noexcept {
    const T largest = maximum<T>(overlap, state.largest_overlap);
    const Flattened at = flattened(pair, largest);
    return hertz_energy<T>(at.pair, at.indentation(largest, overlap));
  }
  /// Work of yielding since the contact was new [J]: of loading to o_m, less what unloading releases.
  CONTACTLAWS_HD T plastic_dissipation(const State& state, const PairProperties<T>& pair) const noexcept {
    const T start = yield_overlap(pair);
    const T beyond = positive_part<T>(T(state.largest_overlap - start));
    const T elastic = minimum<T>(state.largest_overlap, start);
    const T yielding = pi<T>() * yield_pressure * pair.effective_radius;
    const T loading = hertz_energy<T>(pair, elastic) + yielding * beyond * T(start * T(T(2) / T(3)) + beyond / T(2));
    return select<T>(beyond > T(0), positive_part<T>(T(loading - energy(state, pair, state.largest_overlap))), T(0));
  }

 private:
  /// A contact after its largest overlap.
  struct Flattened {
    PairProperties<T> pair;  ///< with the radius R_p
    T ratio;                 ///< R*/R_p [1]

    /// o - o_p where positive [m]. Close to o_m, which is where o_p is small beside o, no digit cancels.
    CONTACTLAWS_HD T indentation(const T& largest, const T& overlap) const noexcept {
      return positive_part<T>(T(largest * ratio - (largest - overlap)));
    }
  };
  /// With u = o_m / o_y >= 1: R*/R_p = (3 u - 1) / (2 u^(3/2)).
  CONTACTLAWS_HD Flattened flattened(const PairProperties<T>& pair, const T& largest) const noexcept {
    using std::sqrt;
    const T u = maximum<T>(T(largest / yield_overlap(pair)), T(1));
    Flattened result{pair, T(T(3) * u - T(1)) / T(T(2) * u * T(sqrt(u)))};
    result.pair.effective_radius = pair.effective_radius / result.ratio;
    return result;
  }
};

}  // namespace contactlaws
