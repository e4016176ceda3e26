#include "ballast/pohrt_popov_incremental.hpp"

#include <cmath>
#include <iostream>
#include <limits>

#include "catch.hpp"
#include "contactlaws/contact_law.hpp"
#include "random.hpp"

namespace contactlaws::test {
namespace {

using Elastic = PohrtPopovIncremental<double, Unloads::elastically>;
using Plastic = PohrtPopovIncremental<double>;

constexpr RoughSurface<double> surface{2.13, 26.1e-6};
constexpr double exact_at_10um = 5.915006726;  // [N], dF/do = C F^beta integrated

PairProperties<double> ballast_pair() {
  const ElasticMaterial<double> rock{60e9, 0.25, 2700.0};
  return pair_properties(sphere(rock, 4.72e-3), sphere(rock, 4.72e-3));
}

/// The force after moving from one overlap to another in equal steps.
template <class Law>
double move(const Law& law, typename Law::State& state, double from, double to, int steps) {
  double force = 0.0;
  for (int i = 1; i <= steps; ++i) force = law.respond(state, ballast_pair(), from + (to - from) * i / steps).force;
  return force;
}

double error_at_10um(double seed, int steps) {
  Plastic::State state;
  return move(Plastic::of(surface, seed), state, 0.0, 10e-6, steps) / exact_at_10um - 1.0;
}

}  // namespace

TEST_CASE("Increments: without a seed the force never leaves zero") {
  CHECK(error_at_10um(0.0, 100) == -1.0);
  CHECK(error_at_10um(0.0, 100000) == -1.0);
  Elastic::State state;
  CHECK(move(Elastic::of(surface, 0.0), state, 0.0, 10e-6, 1000) == 0.0);
}

TEST_CASE("Increments: first order from a small seed, and what a large seed leaves") {
  // Two digits each, found apart from this code.
  CHECK(error_at_10um(1e-12, 100) == Approx(-0.12).margin(0.005));
  CHECK(error_at_10um(1e-12, 1000) == Approx(-0.015).margin(0.0005));
  CHECK(error_at_10um(1e-12, 10000) == Approx(-0.0016).margin(0.00005));
  CHECK(error_at_10um(1e-3, 10000) == Approx(0.04).margin(0.005));
  CHECK(error_at_10um(1e-3, 100000) == Approx(0.04).margin(0.005));
}

TEST_CASE("Increments: the elastic law comes back the way it went, the plastic one along Hertz's curve") {
  const PairProperties<double> pair = ballast_pair();
  const int steps = 100000;
  const Elastic elastic = Elastic::of(surface, 1e-12);
  Elastic::State there;
  move(elastic, there, 0.0, 10e-6, steps);
  CHECK(move(elastic, there, 10e-6, 5e-6, steps) == Approx(1.28163874).epsilon(1e-3));

  const Plastic plastic = Plastic::of(surface, 1e-12);
  Plastic::State loaded;
  const double force = move(plastic, loaded, 0.0, 10e-6, steps);
  const double k_n = 4.0 / 3.0 * 32e9 * std::sqrt(2.36e-3);
  const double depth = std::pow(force / k_n, 2.0 / 3.0);
  Plastic::State back = loaded;
  CHECK(move(plastic, back, 10e-6, 10e-6 - depth / 2, steps) == Approx(force * std::pow(0.5, 1.5)).epsilon(1e-4));
  CHECK(move(plastic, back, 10e-6 - depth / 2, 10e-6, steps) == Approx(force).epsilon(1e-4));
  CHECK(back.largest_force == Approx(force).epsilon(1e-4));
  CHECK(move(plastic, back, 10e-6, 20e-6, steps) == Approx(27.29888187).epsilon(1e-3));  // the virgin curve again
  CHECK(plastic.energy(loaded, pair, 10e-6) == Approx(0.4 * force * depth).epsilon(1e-13));
}

TEST_CASE("Increments: the largest force is that of the same step, not of the step before") {
  const Plastic law = Plastic::of(surface, 1e-12);
  Plastic::State state;
  for (int i = 1; i <= 100; ++i) {
    const double force = law.respond(state, ballast_pair(), 1e-7 * i).force;
    CHECK(state.largest_force == force);
  }
  const double peak = state.normal_force;
  law.respond(state, ballast_pair(), 9e-6);
  CHECK(state.largest_force == peak);
}

TEST_CASE("Increments: a step back that overshoots ends without a force, not with a pull") {
  const Plastic law = Plastic::of(surface, 1e-12);
  Plastic::State state;
  move(law, state, 0.0, 10e-6, 1000);
  // Along Hertz's curve F/k is 2/3 of an indentation of 2 um: much less than the step, which ends still closed.
  CHECK(law.respond(state, ballast_pair(), 1e-9).force == 0.0);
  CHECK(state.normal_force == 0.0);
}

TEST_CASE("Increments: each response is the stiffness that the paper prints") {
  const PairProperties<double> pair = ballast_pair();
  const Plastic law = Plastic::of(surface, 0.0);
  const double a_0 = surface.full_contact_area(pair.effective_radius), scale = pair.effective_young * std::sqrt(a_0),
               h = surface.roughness;
  Random random;
  for (int i = 0; i < cases(1000); ++i) {
    const double force = random.log_uniform(1e-6, 1e5), largest = force * random.log_uniform(0.5, 2.0);
    const double rough = pi<double>() / 10 * 2.13 * scale * std::pow(force / (h * scale), 0.2567 * 2.13);  // Eq. 1
    const double hertz = std::cbrt(6 * pair.effective_young * pair.effective_young * force * pair.effective_radius);
    const bool on_virgin_curve = force >= largest && force < 1776.24400;
    Plastic::State state{force, largest, 20e-6};
    const NormalResponse<double> held = law.respond(state, pair, 20e-6);
    CHECK(held.force == force);
    CHECK(held.stiffness == Approx(on_virgin_curve ? rough : hertz).epsilon(1e-13));
    CHECK(held.max_tangent == Approx(hertz).epsilon(1e-13));
    Plastic::State at_peak{force, force, 20e-6};  // F = F_max: still on the virgin curve
    CHECK(law.respond(at_peak, pair, 20e-6).stiffness == Approx(force < 1776.24400 ? rough : hertz).epsilon(1e-13));

    Plastic::State pressed{force, largest, 20e-6}, eased{force, largest, 20e-6};
    const double little = 1e-3 * force / hertz;
    // A difference of overlaps loses o/little digits.
    const double tolerance = 1e-13 + 4e-16 * 20e-6 / little + 1e-10;
    CHECK(law.respond(pressed, pair, 20e-6 + little).force - force ==
          Approx((on_virgin_curve ? rough : hertz) * little).epsilon(tolerance));
    CHECK(force - law.respond(eased, pair, 20e-6 - little).force ==
          Approx(hertz * little).epsilon(tolerance));  // Eq. 6
  }
}

TEST_CASE("Increments ratchet: cycles through separation climb to Hertz's curve") {
  // F is cut off at zero on the way down and starts from zero at once on the way up, at overlaps where the flattened
  // surfaces are still apart: each cycle gains on the last. The closed form stays where it is.
  const PairProperties<double> pair = ballast_pair();
  const Plastic law = Plastic::of(surface, 1e-12);
  Plastic::State state;
  const double first = move(law, state, 0.0, 20e-6, 1000);
  double last = first;
  int falls = 0;
  for (int cycle = 0; cycle < cases(100); ++cycle) {
    move(law, state, 20e-6, 0.0, 1000);
    const double force = move(law, state, 0.0, 20e-6, 1000);
    if (force < last * (1 - 1e-9)) ++falls;
    last = force;
  }
  std::cout << "Increments, peak force at 20 um: " << first << " N at first, " << last << " N after 100 cycles, Hertz "
            << hertz_response(pair, 20e-6).force << " N\n";
  CHECK(falls == 0);
  CHECK(last > 2 * first);
}

TEST_CASE("Increments: separation ends the force, and keeps the largest") {
  const ContactLaw<Plastic> law{Plastic::of(surface, 1e-12), {}, {}, {}, {}};
  const auto step = [&law](double overlap, const ContactLaw<Plastic>::State& state) {
    return law.step(ballast_pair(), {{0, 0, 1}, overlap, {0, 0, 0}, 1e-6}, state);
  };
  const auto closed = step(1e-6, {});
  const auto open = step(-1e-6, closed.state);
  CHECK(open.state.normal_force == 0.0);
  CHECK(open.state.largest_force == closed.normal_force);
  CHECK(step(1e-7, open.state).normal_force > 0.0);  // closing again from the gap
}

TEST_CASE("Increments: the seed must not be negative") {
  CHECK_THROWS_WITH(Plastic::of(surface, -1e-3), "PohrtPopovIncremental: seed_force is -0.001 N, must lie in [0, inf)");
  CHECK_THROWS_WITH(Plastic::of(surface, std::numeric_limits<double>::quiet_NaN()),
                    ContainsSubstring("seed_force is nan"));
  CHECK_THROWS_WITH(Plastic::of({3.5, 1e-6}, 0.0), ContainsSubstring("fractal_dimension is 3.5"));
}

}  // namespace contactlaws::test
