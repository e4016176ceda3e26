#include "contactlaws/normal/thornton_ning.hpp"

#include "catch.hpp"
#include "contactlaws/laws.hpp"
#include "oracle.hpp"
#include "random.hpp"

namespace contactlaws::test {
namespace {

/// The memo's grains, R* = 3 mm and E* = 14.8 GPa, as if they yielded at 1 GPa.
const PairProperties<double> pair = granite_pair<double>();
const ThorntonNing<double> law{1e9};
constexpr double pi_ = 3.14159265358979323846;

double yield_overlap() { return 3e-3 * std::pow(pi_ * 1e9 / (2.0 * 1.48337595907928e10), 2); }

HertzResponse<double> respond(double largest, double overlap) {
  ThorntonNing<double>::State state{largest};
  return law.respond(state, pair, overlap);
}

/// Restitution of an impact at this speed [m/s], by energies: loading work from quadrature of the force.
double restitution(double speed) {
  const double kinetic = 0.5 * pair.effective_mass * speed * speed;
  // The force rises without a jump; Simpson's rule on 2000 intervals, and the largest overlap by bisection.
  const auto loading_work = [](double largest) {
    constexpr int intervals = 2000;
    const double h = largest / intervals;
    double sum = 0.0;
    for (int i = 0; i <= intervals; ++i)
      sum += (i == 0 || i == intervals ? 1.0 : i % 2 == 1 ? 4.0 : 2.0) * respond(0.0, h * i).force;
    return sum * h / 3.0;
  };
  double low = 0.0, high = 1.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2.0;
    (loading_work(middle) < kinetic ? low : high) = middle;
  }
  return std::sqrt(law.energy({low}, pair, low) / kinetic);
}

/// Thornton (1997), Eq. 17: restitution against the speed over the yield speed.
double thornton(double speed, double yield_speed) {
  const double r = yield_speed / speed;
  return std::sqrt(6.0 * std::sqrt(3.0) / 5.0) * std::sqrt(1.0 - r * r / 6.0) *
         std::pow(r / (r + 2.0 * std::sqrt(1.2 - r * r / 5.0)), 0.25);
}

}  // namespace

TEST_CASE("Thornton-Ning: Hertz up to the yield overlap, then a straight line with the same tangent") {
  const double start = yield_overlap();
  CHECK(law.yield_overlap(pair) == Approx(start).epsilon(1e-14));
  const Hertz<double> hertz;
  Hertz<double>::State none;
  CHECK(respond(0.0, 0.7 * start).force == hertz.respond(none, pair, 0.7 * start).force);
  const double slope = pi_ * 1e9 * 3e-3;
  CHECK(respond(0.0, 10.0 * start).force == Approx(slope * (10.0 - 1.0 / 3.0) * start).epsilon(1e-14));
  CHECK(respond(0.0, 10.0 * start).stiffness == Approx(slope).epsilon(1e-14));
  CHECK(respond(0.0, start * (1.0 + 1e-9)).force ==
        Approx(respond(0.0, start).force + slope * 1e-9 * start).epsilon(1e-15));
  // The mean pressure over the contact is 2/3 p_y at yield and tends to p_y.
  const auto deep = respond(0.0, 1e4 * start);
  CHECK(deep.force / (pi_ * deep.contact_radius * deep.contact_radius) ==
        Approx(1e9 * (1.0 - 1.0 / 3e4)).epsilon(1e-13));
}

TEST_CASE("Thornton-Ning: unloading is Hertz's with a larger radius and opens at the plastic overlap") {
  const double largest = 20.0 * yield_overlap();
  const double share = (3.0 * 20.0 - 1.0) / (2.0 * std::pow(20.0, 1.5));  // R*/R_p
  const double plastic = largest * (1.0 - share);
  CHECK(respond(largest, plastic * (1.0 - 1e-12)).force == 0.0);
  CHECK(respond(largest, plastic * (1.0 + 1e-12)).force > 0.0);
  for (const double part : {0.1, 0.5, 0.9, 1.0}) {
    const double overlap = plastic + part * (largest - plastic);
    const double flattened = 4.0 / 3.0 * 1.48337595907928e10 * std::sqrt(3e-3 / share);
    CHECK(respond(largest, overlap).force ==
          Approx(flattened * std::pow(part * (largest - plastic), 1.5)).epsilon(1e-12));
  }
  // At the largest overlap force and contact area of loading and unloading agree, not the tangent.
  CHECK(respond(largest, largest).force == Approx(respond(0.0, largest).force).epsilon(1e-15));
  CHECK(respond(largest, largest).contact_radius == Approx(std::sqrt(3e-3 * largest)).epsilon(1e-14));
  CHECK(respond(largest, 0.999999 * largest).stiffness > 2.0 * respond(0.0, largest).stiffness);
}

TEST_CASE("Thornton-Ning: restitution is Thornton's closed form, 1 below the yield speed, and falls as v^(-1/4)") {
  // The work at yield is 2/5 F_y o_y.
  const double start = yield_overlap();
  const double yield_speed = std::sqrt(2.0 * 0.4 * respond(0.0, start).force * start / pair.effective_mass);
  // Simpson's error beside the kink of the second derivative at o_y: (1/2000)^3 of it.
  CHECK(restitution(0.5 * yield_speed) == Approx(1.0).epsilon(1e-6));
  for (const double ratio : {1.5, 4.0, 20.0, 300.0})
    CHECK(restitution(ratio * yield_speed) == Approx(thornton(ratio * yield_speed, yield_speed)).epsilon(1e-6));
  const double fast = thornton(1e8 * yield_speed, yield_speed), faster = thornton(16e8 * yield_speed, yield_speed);
  CHECK(faster / fast == Approx(0.5).epsilon(1e-6));
}

TEST_CASE("Thornton-Ning: work of loading = stored energy + dissipation") {
  for (const double u : {0.5, 1.0, 1.0001, 2.0, 50.0}) {
    const double largest = u * yield_overlap();
    constexpr int intervals = 20000;
    const double h = largest / intervals;
    double work = 0.0;
    for (int i = 0; i < intervals; ++i) work += respond(0.0, (i + 0.5) * h).force * h;
    const double stored = law.energy({largest}, pair, largest), lost = law.plastic_dissipation({largest}, pair);
    CHECK(stored + lost == Approx(work).epsilon(1e-8));  // midpoint rule: h^2, and h^(5/2) at touch
    CHECK((u <= 1.0 ? lost == 0.0 : lost >= 0.0));
  }
  CHECK(law.plastic_dissipation({2.0 * yield_overlap()}, pair) > 0.0);
}

TEMPLATE_TEST_CASE("Thornton-Ning: accuracy", "", double, float) {
  using T = TestType;
  using Exact = Binary200;
  Random random(11);
  Worst loading("Thornton-Ning loading" + precision_name<T>()),
      unloading("Thornton-Ning unloading" + precision_name<T>()),
      stiffness("Thornton-Ning stiffness" + precision_name<T>());
  for (int i = 0; i < cases(20000); ++i) {
    const T radius = random.binary<T>(-20, 4), young = random.binary<T>(20, 40);
    const PairProperties<T> any{radius, young, young, T(1), radius, radius};
    const ThorntonNing<T> yields{young * static_cast<T>(random.log_uniform(1e-4, 1e-1))};
    const T largest = static_cast<T>(yields.yield_overlap(any) * static_cast<T>(random.log_uniform(1e-3, 1e5)));
    const ThorntonNing<Exact> exact_law{Exact(yields.yield_pressure)};
    const auto exact_pair = any.template cast<Exact>();
    typename ThorntonNing<T>::State fresh{}, loaded{largest};
    typename ThorntonNing<Exact>::State exact_fresh{}, exact_loaded{Exact(largest)};
    const auto up = yields.respond(fresh, any, largest);
    const auto exact_up = exact_law.respond(exact_fresh, exact_pair, Exact(largest));
    loading.see(ulps(up.force, exact_up.force), radius, young, yields.yield_pressure, largest);
    stiffness.see(ulps(up.stiffness, exact_up.stiffness), radius, young, yields.yield_pressure, largest);
    // Between the whole elastic overlap and half of it.
    const Exact elastic = exact_up.force / exact_up.secant;
    const T back = static_cast<T>(Exact(largest) - elastic * Exact(random.uniform(0.0, 0.5)));
    const auto down = yields.respond(loaded, any, back);
    const auto exact_down = exact_law.respond(exact_loaded, exact_pair, Exact(back));
    unloading.see(ulps(down.force, exact_down.force), radius, young, yields.yield_pressure, largest, back);
  }
  CHECK(loading.error() <= 8.0);  // what the header promises
  CHECK(unloading.error() <= 16.0);
  CHECK(stiffness.error() <= 3.0);
}

TEST_CASE("Thornton-Ning: its parameter is checked; PlasticGrains is made of it") {
  PlasticGrainsProperties<double> properties;
  properties.friction = 0.3;
  CHECK_THROWS_WITH(plastic_grains(properties),
                    Catch::Matchers::Equals("ThorntonNing: yield_pressure is 0 Pa, must lie in (0, inf)"));
  properties.yield_pressure = 1e9;
  CHECK(plastic_grains(properties).normal.yield_pressure == 1e9);
  CHECK(PlasticGrains<double>::state_size == 4);
}

}  // namespace contactlaws::test
