// SPDX-License-Identifier: MIT
// The rough law as its paper steps it (Tolomeo & McDowell 2022, Eqs 1 and 6): F := F + k(F) do, with
//
//   k(F) = k_c (F / F_c)^beta                 F < F_c      k_c = 2 E* sqrt(R* d_c)
//        = k_c (F / F_c)^(1/3)                F >= F_c     (Hertz: (6 E*^2 F R*)^(1/3))
//   elasto-plastic: unloading, and reloading up to the largest force, take Hertz's stiffness at every force
//
// k(0) = 0, so an update that starts at F = 0 stays there: it is given a start, the seed force to which a closing contact
// is lifted. An alternative to pohrt_popov.hpp, kept so that the two can be compared.
// Domain: as there, and small steps. Error: first order in the step, on top of what the seed adds for good; and it
// ratchets where the closed form does not (tests/laws/test_pohrt_popov_incremental.cpp, examples/ballast). A midpoint rule
// does not help: F^(1-beta) keeps what its first steps miss, so it is of first order too, at twice the price.
#pragma once

#include <array>

#include "contactlaws/normal/pohrt_popov.hpp"

namespace contactlaws {

enum class Unloads { elastically, plastically };

template <class T, Unloads unloads = Unloads::plastically>
struct PohrtPopovIncremental : RoughProfile<T> {
  using Slot = NormalSlot<T>;
  using Scalar = T;
  template <class U>
  using Rebind = PohrtPopovIncremental<U, unloads>;
  static constexpr bool outlives_separation = true;
  static constexpr bool plastic = unloads == Unloads::plastically;

  T seed_force = T(0);  ///< the start: a closing contact carries at least this [N]

  struct State {
    T normal_force = T(0);   ///< F [N]
    T largest_force = T(0);  ///< F_max [N]
    T last_overlap = T(0);   ///< [m]
  };
  static constexpr const char* name = "PohrtPopovIncremental";
  static constexpr auto parameters() {
    const std::array<Parameter<PohrtPopovIncremental, T>, 1> seed{
        {{"seed_force", "N", &PohrtPopovIncremental::seed_force, Range::not_negative()}}};
    return concatenate(PohrtPopovIncremental::template parameters_of<PohrtPopovIncremental>(), seed);
  }
  static constexpr std::array<StateValue, 3> state_values() {
    return {{{"normal_force", "N", +1}, {"largest_force", "N", +1}, {"last_overlap", "m", +1}}};
  }

  /// @throws std::invalid_argument naming the surface's parameter, or the seed force, where out of range
  static PohrtPopovIncremental of(const RoughSurface<T>& surface, const T& seed_force) {
    PohrtPopovIncremental law = RoughProfile<T>::template of<PohrtPopovIncremental>(surface);
    law.seed_force = seed_force;
    return checked(law);
  }

  CONTACTLAWS_HD NormalResponse<T> respond(State& state, const PairProperties<T>& pair,
                                           const T& overlap) const noexcept {
    const T closing = overlap - state.last_overlap;
    const T start = select<T>(closing > T(0), maximum<T>(state.normal_force, seed_force), state.normal_force);
    const T largest = state.largest_force;
    const T slope = stiffness(pair, start, start < largest || closing < T(0));
    const T trial = start + slope * closing + T(0) * largest;  // the last term passes a NaN on
    const T force = select<T>(overlap <= T(0), T(0), positive_part<T>(trial));
    state = {force, maximum<T>(largest, force), overlap};
    const T tangent = stiffness(pair, force, force < largest);
    const T max_tangent = stiffness(pair, force, Mask<T>(true));
    // Hertz's secant at this force: force/overlap diverges at touch, where the seed force acts on no overlap.
    return {force, tangent, max_tangent * T(T(2) / T(3)), max_tangent};
  }

  /// As if unloading from here along Hertz's curve [J].
  CONTACTLAWS_HD T energy(const State& state, const PairProperties<T>& pair, const T& overlap) const noexcept {
    if constexpr (!plastic) return this->virgin_work(pair, overlap);
    const T d = this->transition_indentation();
    const T ratio = state.normal_force / hertz_response<T>(pair, d).force;
    return T(T(2) / T(5)) * state.normal_force * d * power_of(ratio, T(T(2) / T(3)));
  }

 private:
  /// k(F) = k_c (F / F_c)^beta or, as Hertz's stiffness is in the same units, k_c (F / F_c)^(1/3) [N/m].
  CONTACTLAWS_HD T stiffness(const PairProperties<T>& pair, const T& force, const Mask<T>& unloaded) const noexcept {
    const HertzResponse<T> transition = hertz_response<T>(pair, this->transition_indentation());
    const T ratio = force / transition.force;
    Mask<T> rough = ratio < T(1);
    if constexpr (plastic) rough = rough && !unloaded;
    const T beta = T(1) - T(2) / (T(3) * this->exponent);
    return transition.stiffness * power_of(ratio, select<T>(rough, beta, T(T(1) / T(3))));
  }
  /// x^y, and 0 for x = 0, where the logarithm within has no derivative.
  CONTACTLAWS_HD static T power_of(const T& x, const T& y) noexcept {
    using std::pow;
    const Mask<T> positive = x > T(0);
    return select<T>(positive, T(pow(select<T>(positive, x, T(1)), y)), T(0));
  }
};

}  // namespace contactlaws
