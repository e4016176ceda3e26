// SPDX-License-Identifier: MIT
// Elastic-plastic, cohesive spheres by straight lines. o the overlap, o_m the largest so far, not beyond o_p:
//
//   loading            F = k_1 o
//   un- and reloading  F = k_1 o_m - k_2(o_m) (o_m - o)       zero at o_0 = (1 - k_1/k_2(o_m)) o_m; beyond o_p also loading
//   pulling            F = -k_c o                             where the line above lies below it
//
//   k_2(o_m) = k_1 + (k_2 - k_1) o_m / o_p,   o_p = 2 phi R* k_2 / (k_2 - k_1)
//
// S. Luding (2008), Cohesive, frictional powders: contact models for tension, Granular Matter 10, Eqs 6 to 8 (numbers as YADE's
// LudingPM.cpp gives them): the loading line, the cohesive line, and k_2 that grows to its largest at the plastic depth phi. A contact
// that pulls along -k_c o and is pressed again follows the line of unloading through that point:
// o_m falls to the value whose line it is, in closed form. Decided here: the same without cohesion (k_c = 0, where Walton and
// Braun keep o_m), so that the law is continuous in k_c. Friction counts F + k_c o. The contact ends at o = 0, where F = 0.
//
// Restitution from a speed v, v_p = o_p sqrt(k_1/m*), without dashpots:
//
//   v <= v_p   e^2 = k_1/k_2 - k_c (k_2 - k_1)^2 / (k_1 k_2 (k_2 + k_c)),   k_2 = k_2(o_p v/v_p)
//   v >  v_p   1 - e^2 = (1 - e^2(v_p)) (v_p/v)^2                       where e^2 is negative the contact sticks
//
// Domain: any overlap; k_2 below k_1 counts as k_1. History: o_m. Error: 4 ULP of the larger of k_1 o_m and |F|
// (tests/laws/test_linear_hysteretic.cpp). First loading just beyond o_p: k_2/k_1 ULP, the factor by which an error of o_p is magnified.
#pragma once

#include <array>
#include <limits>

#include "contactlaws/core/parameter.hpp"
#include "contactlaws/slot.hpp"

namespace contactlaws {

template <class T>
struct LinearHysteretic {
  using Slot = NormalSlot<T>;
  using Scalar = T;
  template <class U>
  using Rebind = LinearHysteretic<U>;
  static constexpr bool adheres = true;

  T loading_stiffness = T(0);    ///< k_1 [N/m]
  T unloading_stiffness = T(0);  ///< k_2, the largest [N/m]
  T cohesive_stiffness = T(0);   ///< k_c [N/m]
  T plastic_depth = T(1);        ///< phi: where unloading is stiffest, o_0 in 2 R* [1]

  struct State {
    T largest_overlap = T(0);  ///< o_m [m]
  };
  static constexpr const char* name = "LinearHysteretic";
  static constexpr std::array<Parameter<LinearHysteretic, T>, 4> parameters() {
    return {{{"loading_stiffness", "N/m", &LinearHysteretic::loading_stiffness, Range::positive()},
             {"unloading_stiffness", "N/m", &LinearHysteretic::unloading_stiffness, Range::positive()},
             {"cohesive_stiffness", "N/m", &LinearHysteretic::cohesive_stiffness, Range::not_negative()},
             {"plastic_depth", "1", &LinearHysteretic::plastic_depth, Range::positive()}}};
  }
  static constexpr std::array<StateValue, 1> state_values() { return {{{"largest_overlap", "m", +1}}}; }

  CONTACTLAWS_HD Mask<T> touches(const State&, const PairProperties<T>&, const T& overlap) const noexcept {
    return negate<T>(overlap <= T(0));
  }
  /// Beyond touch the law exerts no force [m].
  CONTACTLAWS_HD T range(const PairProperties<T>&) const noexcept { return T(0); }

  CONTACTLAWS_HD PullingResponse<T> respond(State& state, const PairProperties<T>& pair,
                                            const T& overlap) const noexcept {
    const T closed = positive_part<T>(overlap);
    const Plastic plastic = yields(pair);
    const Mask<T> virgin = closed >= state.largest_overlap && negate<T>(closed > plastic.overlap);
    T largest = select<T>(closed >= state.largest_overlap, closed, state.largest_overlap);
    largest = minimum<T>(largest, plastic.overlap);
    T stiffness = loading_stiffness + plastic.growth * largest;
    const T pull = cohesive_stiffness * closed;
    T force = loading_stiffness * largest - stiffness * (largest - closed);
    // A contact that rests on the pulling line stays there, whatever the roundings of the other.
    using Lane = typename ScalarTraits<T>::Lane;
    const T rounding = T(Lane(16) * std::numeric_limits<Lane>::epsilon()) * (loading_stiffness * largest);
    const Mask<T> pulls = plastic.growth > T(0) && force < rounding - pull && closed < largest;
    if (any<T>(pulls)) {
      // Of the line through (o, -k_c o): growth (o_m^2 - o o_m) = (k_1 + k_c) o.
      const T along = (loading_stiffness + cohesive_stiffness) * closed / select<T>(pulls, plastic.growth, T(1));
      const T root = sqrt_of_positive<T>(T(closed * closed + T(4) * along));
      largest = select<T>(pulls, minimum<T>(largest, T((closed + root) / T(2))), largest);
      stiffness = loading_stiffness + plastic.growth * largest;
      force = select<T>(pulls, -pull, force);
    }
    state.largest_overlap = largest;
    return {{force, select<T>(virgin, loading_stiffness, stiffness), stiffness, stiffness}, pull, pull};
  }

  /// Energy of the line of unloading, F^2 / (2 k_2(o_m)) [J].
  CONTACTLAWS_HD T energy(const State& state, const PairProperties<T>& pair, const T& overlap) const noexcept {
    State at = state;
    const PullingResponse<T> response = respond(at, pair, overlap);
    return response.force * response.force / (T(2) * response.secant);
  }

 private:
  struct Plastic {
    T overlap;  ///< o_p; 0 where nothing yields [m]
    T growth;   ///< dk_2/do_m [N/m^2]
  };
  CONTACTLAWS_HD Plastic yields(const PairProperties<T>& pair) const noexcept {
    const T excess = positive_part<T>(T(unloading_stiffness - loading_stiffness));
    const T depth = T(2) * plastic_depth * pair.effective_radius * unloading_stiffness;
    const T overlap = select<T>(excess > T(0), T(depth / select<T>(excess > T(0), excess, T(1))), T(0));
    return {overlap, T(excess * excess / depth)};
  }
};

}  // namespace contactlaws
