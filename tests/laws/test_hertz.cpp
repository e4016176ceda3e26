#include "contactlaws/normal/hertz.hpp"

#include "catch.hpp"
#include "oracle.hpp"
#include "random.hpp"

namespace contactlaws::test {

TEST_CASE("Hertz: a sphere of aluminium oxide on a wall of aluminium") {
  const ElasticMaterial<double> oxide{380e9, 0.23, 4000}, aluminium{70e9, 0.25, 2700};
  const PairProperties<double> pair = pair_properties(sphere(oxide, 2.5e-3), plane(aluminium));
  // F = 4.196771799e9 o^(3/2), printed to 10 digits.
  for (const double overlap : {1e-9, 1e-6, 1e-4})
    CHECK(hertz_response(pair, overlap).force == Approx(4.196771799e9 * std::pow(overlap, 1.5)).epsilon(1e-9));
}

TEST_CASE("Hertz: the granite grains of the hill memo") {
  const HertzResponse<double> response = hertz_response(granite_pair<double>(), 1e-4);
  // 15 printed digits
  CHECK(response.force == Approx(1083.30463206478).epsilon(1e-14));
  CHECK(response.contact_radius == Approx(std::sqrt(3e-3 * 1e-4)).epsilon(1e-14));
  CHECK(response.stiffness == Approx(1.5 * 1.08330463206478e9 * 0.01).epsilon(1e-14));  // dF/do
  CHECK(response.secant == Approx(1.08330463206478e9 * 0.01).epsilon(1e-14));           // F/o
  CHECK(response.max_tangent == response.stiffness);
}

TEST_CASE("Hertz: energy is the work of the force") {
  const PairProperties<double> pair = granite_pair<double>();
  const double deep = 1e-4;
  // Simpson's rule in u = sqrt(o), where F do = 2 k_n u^4 du is a polynomial: error 1/(180 n^4) of its 4th derivative.
  const int n = 1000;
  double work = 0.0;
  for (int i = 0; i <= n; ++i) {
    const double u = std::sqrt(deep) * i / n;
    const double weight = i == 0 || i == n ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
    work += weight * hertz_response(pair, u * u).force * 2.0 * u;
  }
  work *= std::sqrt(deep) / n / 3.0;
  CHECK(hertz_energy(pair, deep) == Approx(work).epsilon(1e-11));
  CHECK(hertz_energy(pair, 0.0) == 0.0);
}

TEMPLATE_TEST_CASE("Hertz: accuracy", "", double, float) {
  using T = TestType;
  Random random;
  Worst force("Hertz force" + precision_name<T>()), stiffness("Hertz stiffness" + precision_name<T>()),
      energy("Hertz energy" + precision_name<T>());
  for (int i = 0; i < cases(100000); ++i) {
    const PairProperties<T> pair = wide_pair<T>(random);
    const T overlap = random.binary<T>(smallest_exponent<T>, 4);
    const HertzResponse<T> computed = hertz_response(pair, overlap);
    const HertzResponse<Binary200> exact = hertz_response(pair.template cast<Binary200>(), Binary200(overlap));
    force.see(ulps(computed.force, exact.force), pair.effective_radius, pair.effective_young, overlap);
    stiffness.see(ulps(computed.stiffness, exact.stiffness), pair.effective_radius, pair.effective_young, overlap);
    energy.see(ulps(hertz_energy(pair, overlap), hertz_energy(pair.template cast<Binary200>(), Binary200(overlap))),
               pair.effective_radius, pair.effective_young, overlap);
  }
  CHECK(force.error() <= 4.0);  // what the header promises
  CHECK(stiffness.error() <= 3.0);
  CHECK(energy.error() <= 5.0);  // two more products
}

TEST_CASE("Hertz: every float of two binades of overlap") {
  // Four times the overlap has exactly eight times the force, so that two binades stand for all. In double, which has
  // 29 digits more, the error of the judge is nothing.
  const PairProperties<float> pair = granite_pair<double>().cast<float>();
  const PairProperties<double> same = pair.cast<double>();
  const float stride = sanitized ? 1000.0f : 1.0f;
  double worst = 0.0;
  for (float overlap = 0x1p-14f; overlap < 0x1p-12f; overlap += stride * (overlap < 0x1p-13f ? 0x1p-37f : 0x1p-36f)) {
    const double exact = hertz_response(same, static_cast<double>(overlap)).force;
    const double unit = std::ldexp(1.0, std::ilogb(exact) - 23);
    const double error = std::abs(static_cast<double>(hertz_response(pair, overlap).force) - exact) / unit;
    if (!(error <= worst)) worst = error;
  }
  std::cout << "Hertz force, every float overlap from 2^-14 to 2^-12: " << worst << " ULP\n";
  CHECK(worst <= 4.0);
}

TEMPLATE_TEST_CASE("Hertz: the next larger overlap never has a smaller force", "", double, float) {
  using T = TestType;
  Random random;
  int falls = 0;
  for (int i = 0; i < cases(1000000); ++i) {
    const PairProperties<T> pair = wide_pair<T>(random);
    const T overlap = random.binary<T>(smallest_exponent<T>, 4);
    const T next = std::nextafter(overlap, T(100));
    if (hertz_response(pair, next).force < hertz_response(pair, overlap).force) ++falls;
  }
  CHECK(falls == 0);
}

}  // namespace contactlaws::test
