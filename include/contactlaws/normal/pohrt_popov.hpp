// SPDX-License-Identifier: MIT
// Contact of rough surfaces, with loading history. A rough contact is softer than Hertz's until its roughness is pressed
// flat, at the transition; in closed form it is a Hertz contact at a reduced indentation d(o) of the overlap o:
//
//   F = k_n d^(3/2),   k_n = 4/3 E* sqrt(R*),   x = o / o_c
//   d = d_c x^p = o/p x^(p-1)   o < o_c      (dF/do = C F^beta, integrated)         p   = 2 / (3 (1 - beta))
//   d = d_c + (o - o_c)         o >= o_c     (Hertz, shifted)                       o_c = p d_c
//   beta = 0.2567 D_f           d_c = h 3/4 sqrt(pi) (20 / (pi^(3/2) D_f))^(1/beta)
//
// Force and slope are continuous at o_c; d_c and o_c depend on the surface alone, not on R* or E*.
// Elasto-plastic: virgin loading follows d(o); below the largest overlap o_m ever reached, Hertz from there,
//   d = d(o_m) - (o_m - o), never negative: the contact reopens at the plastic overlap o_p = o_m - d(o_m).
//
// Pohrt & Popov (2012); Tolomeo & McDowell (2022) Eqs 1-6, whose increments (pohrt_popov_incremental.hpp) these replace:
// no step, no drift, no start. Domain: D_f in [2, 3], h > 0, o << R*.
// Error of F, given p and o_c: <= 6 ULP; of the stiffness 5. Packs add 3/2 |(p-1) log x| eps (power.hpp).
// Unloading, d is right to 3 ULP of d(o_m) and, near o_p, no better: no number stands for d(o_m)
// to less than half one (tests/laws/test_pohrt_popov_accuracy.cpp).
#pragma once

#include <array>

#include "contactlaws/core/parameter.hpp"
#include "contactlaws/core/power.hpp"
#include "contactlaws/core/validate.hpp"
#include "contactlaws/normal/hertz.hpp"
#include "contactlaws/pair.hpp"
#include "contactlaws/slot.hpp"

namespace contactlaws {

/// A fractal surface.
template <class T>
struct RoughSurface {
  T fractal_dimension;  ///< D_f [1]
  T roughness;          ///< h, root mean square height [m]

  static constexpr const char* name = "RoughSurface";
  static constexpr std::array<Parameter<RoughSurface, T>, 2> parameters() {
    return {{{"fractal_dimension", "1", &RoughSurface::fractal_dimension, Range::closed(2.0, 3.0)},
             {"roughness", "m", &RoughSurface::roughness, Range::positive()}}};
  }

  /// beta, of k ~ F^beta before the transition.
  T stiffness_exponent() const { return T(2567) / T(10000) * fractal_dimension; }
  /// A_0 [m^2], the contact area at the transition (Tolomeo & McDowell 2022, Eq. 5).
  T full_contact_area(const T& effective_radius) const { return pi<T>() * effective_radius * transition_indentation(); }
  /// d_c [m], the indentation at which Hertz's contact would carry the transition force.
  T transition_indentation() const {
    using std::pow;
    using std::sqrt;
    const T root_pi = sqrt(pi<T>());
    const T base = T(20) / (pi<T>() * root_pi * fractal_dimension);
    return roughness * T(3) / T(4) * root_pi * T(pow(base, T(T(1) / stiffness_exponent())));
  }
};

/// What the surfaces remember once the bodies have been fully apart.
enum class Recontact {
  same_spot,     ///< the flattened asperities meet again: a rattling contact neither hardens nor softens (default)
  fresh_surface  ///< virgin asperities meet: a contact that has moved on
};

/// Where on its loading history a contact stands.
enum class Loading { open, virgin, unloading, reloading };

/// d(o), and what it takes to get there.
template <class T>
struct RoughProfile {
  T exponent = T(1);            ///< p [1]
  T transition_overlap = T(0);  ///< o_c [m]

  struct Indentation {
    T depth;  ///< d [m]
    T slope;  ///< dd/do [1]
  };

  /// d_c [m]
  CONTACTLAWS_HD T transition_indentation() const noexcept { return transition_overlap / exponent; }

  /// d and its slope x^(p-1) at an overlap >= 0 [m].
  CONTACTLAWS_HD Indentation indentation(const T& overlap) const noexcept {
    const Mask<T> rough = overlap > T(0) && overlap < transition_overlap;
    if (!any<T>(rough)) return {flattened(overlap), T(1)};
    const T closed = select<T>(rough, overlap, transition_overlap);
    const T slope = power_of_quotient<T>(closed, transition_overlap, T(exponent - T(1)));
    return {select<T>(rough, T(overlap / exponent * slope), flattened(overlap)), slope};
  }

  /// The overlap at which the indentation is `depth` >= 0 [m].
  T overlap_of(const T& depth) const {
    using std::pow;
    const T at_transition = transition_indentation();
    if (depth >= at_transition) return transition_overlap + (depth - at_transition);
    return transition_overlap * T(pow(T(depth / at_transition), T(T(1) / exponent)));
  }

  /// What it costs to flatten the asperities on the way to an overlap >= 0, in full from the transition on [J].
  CONTACTLAWS_HD T flattening_work(const PairProperties<T>& pair, const T& overlap) const noexcept {
    const T rough_part = minimum<T>(overlap, transition_overlap);
    const T depth = indentation(rough_part).depth;
    const T force = hertz_response<T>(pair, depth).force;  // F ~ o^(3/2 p), so the work is F o / (3/2 p + 1)
    return force * (rough_part / (T(T(3) / T(2)) * exponent + T(1)) - T(T(2) / T(5)) * depth);
  }
  /// Work of virgin loading to an overlap >= 0 [J].
  CONTACTLAWS_HD T virgin_work(const PairProperties<T>& pair, const T& overlap) const noexcept {
    return hertz_energy<T>(pair, indentation(overlap).depth) + flattening_work(pair, overlap);
  }

 private:
  /// d beyond the transition [m].
  CONTACTLAWS_HD T flattened(const T& overlap) const noexcept {
    return positive_part<T>(T(transition_indentation() + (overlap - transition_overlap)));
  }

 protected:
  template <class Law>
  static Law of(const RoughSurface<T>& surface) {
    checked(surface);
    Law law;
    law.exponent = T(2) / (T(3) * (T(1) - surface.stiffness_exponent()));
    law.transition_overlap = law.exponent * surface.transition_indentation();
    return law;
  }
  template <class Owner>
  static constexpr std::array<Parameter<Owner, T>, 2> parameters_of() {
    return {{{"exponent", "1", &Owner::exponent, Range::left_open(1.0, 3.0)},
             {"transition_overlap", "m", &Owner::transition_overlap, Range::positive()}}};
  }
};

/// Elastic: loading and unloading follow the same curve. No history.
template <class T>
struct PohrtPopov : RoughProfile<T> {
  using Scalar = T;
  template <class U>
  using Rebind = PohrtPopov<U>;

  struct State {};
  static constexpr const char* name = "PohrtPopov";
  static constexpr auto parameters() { return PohrtPopov::template parameters_of<PohrtPopov>(); }
  static constexpr std::array<StateValue, 0> state_values() { return {}; }

  /// @throws std::invalid_argument naming the surface's parameter out of range
  static PohrtPopov of(const RoughSurface<T>& surface) { return RoughProfile<T>::template of<PohrtPopov>(surface); }

  CONTACTLAWS_HD NormalResponse<T> respond(State&, const PairProperties<T>& pair, const T& overlap) const noexcept {
    const auto at = this->indentation(overlap);
    const HertzResponse<T> hertz = hertz_response<T>(pair, at.depth);
    const T stiffness = hertz.stiffness * at.slope;
    const T secant = hertz.force / select<T>(overlap > T(0), overlap, T(1));
    return {hertz.force, stiffness, secant, stiffness};
  }
  CONTACTLAWS_HD T energy(const State&, const PairProperties<T>& pair, const T& overlap) const noexcept {
    return this->virgin_work(pair, overlap);
  }
};

/// Elasto-plastic. History: the largest overlap, one exact number, from which the plastic overlap follows. The tangent jumps
/// there, from the virgin branch's to Hertz's: a contact held at its largest overlap has either, as its overlap rounds.
template <class T, Recontact recontact = Recontact::same_spot>
struct PohrtPopovElastoPlastic : RoughProfile<T> {
  using Scalar = T;
  template <class U>
  using Rebind = PohrtPopovElastoPlastic<U, recontact>;

  struct State {
    T largest_overlap = T(0);  ///< o_m [m]
  };
  static constexpr const char* name = "PohrtPopovElastoPlastic";
  static constexpr auto parameters() {
    return PohrtPopovElastoPlastic::template parameters_of<PohrtPopovElastoPlastic>();
  }
  static constexpr std::array<StateValue, 1> state_values() { return {{{"largest_overlap", "m", +1}}}; }

  /// @throws std::invalid_argument naming the surface's parameter out of range
  static PohrtPopovElastoPlastic of(const RoughSurface<T>& surface) {
    return RoughProfile<T>::template of<PohrtPopovElastoPlastic>(surface);
  }

  CONTACTLAWS_HD NormalResponse<T> respond(State& state, const PairProperties<T>& pair,
                                           const T& overlap) const noexcept {
    const Mask<T> virgin = overlap >= state.largest_overlap;
    const T largest = select<T>(virgin, overlap, state.largest_overlap);
    const auto at_largest = this->indentation(largest);
    const T depth = positive_part<T>(T(at_largest.depth - (largest - overlap)));
    state.largest_overlap = largest;
    if constexpr (recontact == Recontact::fresh_surface)
      state.largest_overlap = select<T>(overlap > T(0), largest, T(0));
    if (!any<T>(depth > T(0))) return {T(0), T(0), T(0), T(0)};  // a square root has no derivative at 0
    const HertzResponse<T> hertz = hertz_response<T>(pair, depth);
    const T virgin_stiffness = hertz.stiffness * at_largest.slope;
    return {hertz.force, select<T>(virgin, virgin_stiffness, hertz.stiffness), hertz.secant, hertz.stiffness};
  }

  /// o_p [m], where the contact reopens.
  CONTACTLAWS_HD T plastic_overlap(const State& state) const noexcept {
    return state.largest_overlap - this->indentation(state.largest_overlap).depth;
  }

  /// What unloading would give back [J].
  CONTACTLAWS_HD T energy(const State& state, const PairProperties<T>& pair, const T& overlap) const noexcept {
    return hertz_energy<T>(pair, elastic_indentation(state, overlap));
  }
  /// What flattening the asperities has cost since they were fresh [J].
  CONTACTLAWS_HD T plastic_dissipation(const State& state, const PairProperties<T>& pair) const noexcept {
    return this->flattening_work(pair, state.largest_overlap);
  }

  /// Where a contact stands whose state was `before` at the last step; `separating` = v_n [m/s]. Open: without force.
  Loading loading(const State& before, const T& overlap, const T& separating) const noexcept {
    if (!(elastic_indentation(before, overlap) > T(0))) return Loading::open;
    if (overlap >= before.largest_overlap) return Loading::virgin;
    return separating > T(0) ? Loading::unloading : Loading::reloading;
  }

 private:
  CONTACTLAWS_HD T elastic_indentation(const State& state, const T& overlap) const noexcept {
    const T largest = maximum<T>(overlap, state.largest_overlap);
    return positive_part<T>(T(this->indentation(largest).depth - (largest - overlap)));
  }
};

}  // namespace contactlaws
