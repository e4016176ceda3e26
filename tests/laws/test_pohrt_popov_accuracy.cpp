// The rough law against 200 bits: its formulas against the paper's, its rounding against its own text.
#include <limits>
#include <string>

#include "catch.hpp"
#include "contactlaws/normal/pohrt_popov.hpp"
#include "contactlaws/scalars/xsimd.hpp"
#include "oracle.hpp"
#include "random.hpp"
#include "reference/pohrt_popov.hpp"

namespace contactlaws::test {
namespace {

using Exact = Binary200;

/// 30 digits are printed; a force to the power beta of them keeps 28.
const double printed = 1e-27;

double relative(const Exact& computed, const char* expected) {
  return static_cast<double>(abs(computed / Exact(expected) - 1));
}

/// R* and E* alone matter to the normal law.
template <class T>
PairProperties<T> pair_of(const T& radius, const T& young) {
  return {radius, young, young, T(1), radius, radius};
}

template <class T>
T half_epsilon() {
  return std::numeric_limits<T>::epsilon() / 2;
}

/// A law with parameters drawn from all that a surface can give.
template <class T>
PohrtPopovElastoPlastic<T> random_law(Random& random) {
  const T fractal_dimension = random.chance(0.2) ? T(random.chance(0.5) ? 2 : 3) : static_cast<T>(random.uniform(2, 3));
  return PohrtPopovElastoPlastic<T>::of({fractal_dimension, random.binary<T>(-30, 0)});
}

/// The response to an overlap at which the largest was `largest`.
template <class T, class Law>
NormalResponse<T> response(const Law& law, const PairProperties<T>& pair, const T& largest, const T& overlap) {
  typename Law::State state{largest};
  return law.respond(state, pair, overlap);
}

}  // namespace

TEST_CASE("Pohrt-Popov: the closed form is the paper's stiffness, integrated") {
  for (const reference::Surface& s : reference::surfaces) {
    const RoughSurface<Exact> surface{Exact(s.fractal_dimension), Exact(s.roughness)};
    const PairProperties<Exact> pair = pair_of(Exact(s.radius), Exact(s.young));
    CHECK(relative(surface.full_contact_area(pair.effective_radius), s.area) < printed);
    CHECK(relative(hertz_response(pair, surface.transition_indentation()).force, s.transition_force) < printed);
  }
  for (const reference::Cycle& c : reference::cycles) {
    INFO("surface " << c.surface << ", loaded to " << c.force << " N");
    const reference::Surface& s = reference::surfaces[c.surface];
    const PairProperties<Exact> pair = pair_of(Exact(s.radius), Exact(s.young));
    const RoughSurface<Exact> surface{Exact(s.fractal_dimension), Exact(s.roughness)};
    const auto elastic = PohrtPopov<Exact>::of(surface);
    const auto plastic = PohrtPopovElastoPlastic<Exact>::of(surface);
    const Exact loaded(c.overlap);

    PohrtPopov<Exact>::State none;
    PohrtPopovElastoPlastic<Exact>::State state;
    CHECK(relative(elastic.respond(none, pair, loaded).force, c.force) < printed);
    CHECK(relative(elastic.energy(none, pair, loaded), c.work) < printed);
    CHECK(relative(plastic.respond(state, pair, loaded).force, c.force) < printed);
    CHECK(relative(plastic.plastic_dissipation(state, pair), c.loop) < printed);

    // Differences of overlaps that agree in their first digits: their 30 digits lose as many.
    const double lost = static_cast<double>(loaded / elastic.indentation(loaded).depth);
    CHECK(relative(plastic.respond(state, pair, Exact(c.overlap_at_half)).force * 2, c.force) < printed * lost);
    CHECK(relative(plastic.plastic_overlap(state), c.plastic_overlap) < printed);
    CHECK(plastic.respond(state, pair, Exact(c.plastic_overlap) * (1 - Exact(printed))).force == 0);
    CHECK(plastic.respond(state, pair, Exact(c.plastic_overlap) * (1 + Exact(printed))).force > 0);
  }
}

TEMPLATE_TEST_CASE("Pohrt-Popov: accuracy on the virgin curve", "", double, float) {
  using T = TestType;
  Random random;
  Worst force("Pohrt-Popov force" + precision_name<T>()),
      near("Pohrt-Popov force at the transition" + precision_name<T>()),
      stiffness("Pohrt-Popov stiffness" + precision_name<T>());
  for (int i = 0; i < cases(15000); ++i) {
    const auto law = random_law<T>(random);
    const auto exact_law = slot_cast<Exact>(law);
    const PairProperties<T> pair = wide_pair<T>(random);
    const bool at_transition = i % 4 == 0;
    const bool anywhere = i % 4 == 1;  // denormals too
    const T share = anywhere        ? T(random.binary<T>(smallest_exponent<T>, 4) / law.transition_overlap)
                    : at_transition ? T(1) + half_epsilon<T>() * static_cast<T>(random.uniform(-20, 20))
                                    : static_cast<T>(random.log_uniform(1e-9, 1e3));
    const T overlap = law.transition_overlap * share;
    const NormalResponse<T> computed = response(law, pair, T(0), overlap);
    const NormalResponse<Exact> exact = response(exact_law, pair.template cast<Exact>(), Exact(0), Exact(overlap));
    if (!holds<T>(exact.force)) continue;
    const double error = ulps(computed.force, exact.force);
    force.see(error, law.exponent, law.transition_overlap, overlap);
    if (at_transition) near.see(error, law.exponent, law.transition_overlap, overlap);
    // Further down the indentation, a denormal number, has lost the digits that the stiffness would need.
    if (exact_law.indentation(Exact(overlap)).depth >= std::numeric_limits<T>::min())
      stiffness.see(ulps(computed.stiffness, exact.stiffness), law.exponent, law.transition_overlap, overlap);
  }
  CHECK(force.error() <= 6.0);  // what the header promises
  CHECK(near.error() <= 6.0);   // log x is small here
  CHECK(stiffness.error() <= 5.0);
}

TEMPLATE_TEST_CASE("Pohrt-Popov: packs keep the error bound of their power", "", double, float) {
  using T = TestType;
  using Pack = xsimd::batch<T>;
  Random random;
  Worst share_of_bound("Pohrt-Popov, packs: of their bound," + precision_name<T>()),
      ulp("Pohrt-Popov, packs against scalar" + precision_name<T>());
  const PairProperties<T> pair = pair_of(T(2.5e-3), T(3e10));
  for (int i = 0; i < cases(15000); ++i) {
    const auto law = random_law<T>(random);
    const T x = static_cast<T>(random.log_uniform(1e-7, 10.0));
    const T overlap = law.transition_overlap * x;
    const T alone = response(law, pair, T(0), overlap).force;
    if (alone < std::numeric_limits<T>::min()) continue;
    const double y = x < 1 ? std::abs(static_cast<double>((law.exponent - 1) * std::log(x))) : 0.0;
    const auto packed = slot_cast<Pack>(law);
    const T force = response(packed, pair.template cast<Pack>(), Pack(0), Pack(overlap)).force.get(0);
    const double difference = static_cast<double>(std::abs(force / alone - 1) / std::numeric_limits<T>::epsilon());
    // The pack: 7 eps of the law around the power, and 1.5 y of the power. The single number: 7 eps.
    share_of_bound.see(difference / (14.0 + 1.5 * y), law.exponent, law.transition_overlap, overlap);
    ulp.see(ulps(force, Exact(alone)), law.exponent, law.transition_overlap, overlap);
  }
  CHECK(share_of_bound.error() <= 1.0);
}

TEMPLATE_TEST_CASE("Pohrt-Popov: accuracy while unloading, down to the plastic overlap", "", double, float) {
  using T = TestType;
  Random random;
  Worst depth("Pohrt-Popov indentation while unloading, in ULP of the largest," + precision_name<T>());
  for (int i = 0; i < cases(15000); ++i) {
    const auto law = random_law<T>(random);
    const PairProperties<T> pair = pair_of(T(2.5e-3), T(3e10));
    const T largest = law.transition_overlap * static_cast<T>(random.log_uniform(1e-6, 10.0));
    const T deepest = law.indentation(largest).depth;
    const T above =
        deepest * static_cast<T>(random.log_uniform(half_epsilon<T>(), 1.0));  // the reopening, by ever less
    const T overlap = (largest - deepest) + above;
    const PairProperties<Exact> exact_pair = pair.template cast<Exact>();
    const Exact computed = response(law, pair, largest, overlap).force;
    const auto exact_law = slot_cast<Exact>(law);
    const Exact exact = response(exact_law, exact_pair, Exact(largest), Exact(overlap)).force;
    const auto indentation_at = [&exact_pair](const Exact& f) {
      return pow(Exact(f / hertz_response(exact_pair, Exact(1)).force), Exact(Exact(2) / 3));
    };
    const Exact unit = Exact(ldexp(Exact(1), std::ilogb(deepest) + 1 - std::numeric_limits<T>::digits));
    depth.see(static_cast<double>(abs(indentation_at(computed) - indentation_at(exact)) / unit), law.exponent, largest,
              overlap);
  }
  // d(o_m), a power, is right to some ULP of its own, and d = d(o_m) - (o_m - o) inherits them as they are: no number of
  // T stands for d(o_m) better than to half of one. Two thirds of Hertz's 4 ULP come on top.
  CHECK(depth.error() <= 6.0);
}

TEMPLATE_TEST_CASE("Pohrt-Popov: conditioning with respect to the surface", "", double, float) {
  using T = TestType;
  Random random;
  Worst share_of_bound("Pohrt-Popov from D_f and h: of its bound," + precision_name<T>()),
      table_1("Pohrt-Popov from D_f = 2.13, h = 26.1 um, 1 to 30 um, in eps," + precision_name<T>());
  const auto error_of = [](const RoughSurface<T>& surface, const T& overlap) {
    const PairProperties<T> pair = pair_of(T(2.5e-3), T(3e10));
    const auto exact_law =
        PohrtPopovElastoPlastic<Exact>::of({Exact(surface.fractal_dimension), Exact(surface.roughness)});
    const Exact exact = response(exact_law, pair.template cast<Exact>(), Exact(0), Exact(overlap)).force;
    const T computed = response(PohrtPopovElastoPlastic<T>::of(surface), pair, T(0), overlap).force;
    return static_cast<double>(abs(computed / exact - 1)) / static_cast<double>(std::numeric_limits<T>::epsilon());
  };
  for (int i = 0; i < cases(8000); ++i) {
    const RoughSurface<T> surface{static_cast<T>(random.uniform(2, 3)), random.binary<T>(-30, 0)};
    const auto law = PohrtPopovElastoPlastic<T>::of(surface);
    const double x = random.log_uniform(1e-9, 1.0);
    const T overlap = law.transition_overlap * static_cast<T>(x);
    // ln F = 3/2 (p ln(o / (p d_c)) + ln d_c) + ...: an error of p counts 3/2 p |ln x - 1| times, of d_c 3/2 (p - 1) times.
    // p = 2/(3 (1 - beta)) in eps: one of beta, times beta/(1 - beta), and two more. d_c: a power with an inexact exponent.
    const double p = static_cast<double>(law.exponent);
    const double beta = static_cast<double>(surface.stiffness_exponent());
    const double of_exponent = 1.5 * p * std::abs(std::log(x) - 1.0) * (beta / (1.0 - beta) + 2.0);
    const double of_transition = 1.5 * (p - 1.0) * 8.0;
    share_of_bound.see(error_of(surface, overlap) / (7.0 + of_exponent + of_transition), surface.fractal_dimension,
                       surface.roughness, overlap);
  }
  for (int i = 0; i < cases(2000); ++i) {
    const T overlap = static_cast<T>(random.uniform(1e-6, 30e-6));
    table_1.see(error_of({T(213) / T(100), static_cast<T>(26.1e-6)}, overlap), overlap);
  }
  CHECK(share_of_bound.error() <= 1.0);
  CHECK(table_1.error() <= 24.0);  // the bound, at p = 1.47 and ln x = -4.9
}

TEST_CASE("Pohrt-Popov: why the history is the largest overlap, not the plastic one") {
  // Asked twice for the same overlap, a law must answer the same. The plastic overlap of a light contact is nearly the
  // overlap itself, so that its rounding is many ULP of the small indentation.
  const auto law = PohrtPopovElastoPlastic<double>::of({2.13, 26.1e-6});
  const PairProperties<double> pair = pair_of(2.36e-3, 32e9);
  Random random;
  double of_largest = 0.0, of_plastic[6] = {};
  for (int i = 0; i < cases(30000); ++i) {
    const int decade = i % 6;
    const double x = std::pow(10.0, -decade - random.uniform(0, 1));
    const double overlap = x * law.transition_overlap;
    PohrtPopovElastoPlastic<double>::State state;
    const double force = law.respond(state, pair, overlap).force;
    of_largest = std::max(of_largest, std::abs(law.respond(state, pair, overlap).force - force));
    const double plastic_overlap = law.plastic_overlap(state);
    const double again = hertz_response(pair, overlap - plastic_overlap).force;
    const double unit = std::ldexp(1.0, std::ilogb(force) - 52);
    of_plastic[decade] = std::max(of_plastic[decade], std::abs(again - force) / unit);
  }
  std::cout << "Pohrt-Popov from a stored plastic overlap, force asked again, ULP by decade of o/o_c from 1 down:";
  for (const double error : of_plastic) std::cout << ' ' << error;
  std::cout << "; from the largest overlap: " << of_largest << '\n';
  CHECK(of_largest == 0.0);
  CHECK(of_plastic[5] > 100.0);
}

}  // namespace contactlaws::test
