// SPDX-License-Identifier: MIT
// Contact of rough surfaces, with loading history. A rough contact is softer than Hertz's until its asperities are flat, at
// the transition. In closed form it is a Hertz contact at an elastic indentation d(o) below the overlap o:
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
// Pohrt & Popov (2012); Tolomeo & McDowell (2022) Eqs 1-6. The closed form replaces the paper's increments, which depend on
// the step and on a start force (examples/ballast/pohrt_popov_incremental.hpp). Domain: D_f in [2, 3], h > 0, o << R*.
// The secant for dashpots is F/d of the elastic indentation in both laws, so that they damp the same virgin curve alike. F/o
// would count the flattened asperities as part of the spring, and halve the damping.
// Error of F, given p and o_c: <= 6 ULP; of the stiffness 5. Packs add 3/2 |(p-1) log x| eps (core/power.hpp).
// While unloading, the absolute error of d is 3 ULP of d(o_m): F is right to 9 ULP where d >= d(o_m)/2, and
// near o_p its relative error is unbounded (tests/laws/test_pohrt_popov_accuracy.cpp).
#pragma once

#include <array>

#include "contactlaws/core/parameter.hpp"
#include "contactlaws/core/power.hpp"
#include "contactlaws/core/validate.hpp"
#include "contactlaws/normal/hertz.hpp"
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

/// The loading history after the bodies have been apart.
enum class Recontact {
  fresh_surface,  ///< fresh asperities meet: no result depends on how long a host keeps a pair listed (default)
  same_spot       ///< the flattened asperities meet again: for hosts that keep the history of separated pairs
};

/// The branch of the loading history on which a contact is.
enum class Loading { open, virgin, unloading, reloading };

/// The curve d(o) of a rough surface.
template <class T>
struct RoughProfile {
  T exponent = T(1);            ///< p [1]
  T transition_overlap = T(0);  ///< o_c [m]

  /// Indentation of a smooth sphere that has the same force.
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

  /// Work that flattens the asperities up to an overlap >= 0; constant beyond the transition [J].
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
  using Slot = NormalSlot<T>;
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
    return {hertz.force, stiffness, hertz.secant, stiffness};
  }
  CONTACTLAWS_HD T energy(const State&, const PairProperties<T>& pair, const T& overlap) const noexcept {
    return this->virgin_work(pair, overlap);
  }
};

/// Elastic-plastic. History: the largest overlap, an exact number, which defines the plastic overlap. The tangent jumps at the
/// largest overlap from the virgin branch's to Hertz's; a contact held there has one or the other, depending on rounding. A
/// shear stiffness in proportion to it (ConstantRatio) then creates up to 56 % of k S^2/2 per load cycle: see ElasticRatio.
template <class T, Recontact recontact = Recontact::fresh_surface>
struct PohrtPopovElastoPlastic : RoughProfile<T> {
  using Slot = NormalSlot<T>;
  using Scalar = T;
  template <class U>
  using Rebind = PohrtPopovElastoPlastic<U, recontact>;

  static constexpr bool outlives_separation = recontact == Recontact::same_spot;

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
    if (all<T>(depth <= T(0))) return {T(0), T(0), T(0), T(0)};  // a square root has no derivative at 0
    const HertzResponse<T> hertz = hertz_response<T>(pair, depth);
    const T virgin_stiffness = hertz.stiffness * at_largest.slope;
    return {hertz.force, select<T>(virgin, virgin_stiffness, hertz.stiffness), hertz.secant, hertz.stiffness};
  }

  /// o_p [m], where the contact opens.
  CONTACTLAWS_HD T plastic_overlap(const State& state) const noexcept {
    return state.largest_overlap - this->indentation(state.largest_overlap).depth;
  }

  /// Elastic energy, which unloading releases [J].
  CONTACTLAWS_HD T energy(const State& state, const PairProperties<T>& pair, const T& overlap) const noexcept {
    return hertz_energy<T>(pair, elastic_indentation(state, overlap));
  }
  /// Work that has flattened the asperities since they were fresh [J].
  CONTACTLAWS_HD T plastic_dissipation(const State& state, const PairProperties<T>& pair) const noexcept {
    return this->flattening_work(pair, state.largest_overlap);
  }

  /// The branch of a contact whose state was `before` at the last step; `separating` = v_n [m/s]. Open: no force.
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
