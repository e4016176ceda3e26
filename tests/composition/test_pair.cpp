#include "contactlaws/pair.hpp"

#include "catch.hpp"
#include "oracle.hpp"
#include "random.hpp"

namespace contactlaws::test {
namespace {

using Catch::Matchers::Equals;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();
const ElasticMaterial<double> granite{29e9, 0.15, 2650.0};

}  // namespace

TEST_CASE("Material: effective properties of the memo's granite grains") {
  const PairProperties<double> pair = granite_pair<double>();
  CHECK(pair.effective_radius == Approx(3e-3).epsilon(1e-15));
  CHECK(pair.effective_young == Approx(1.48337595907928e10).epsilon(1e-14));  // 15 printed digits
  CHECK(pair.effective_shear == Approx(3.40775558166863e9).epsilon(1e-14));
  CHECK(pair.effective_mass == Approx(1.07038549697309e-3).epsilon(1e-14));
  CHECK(pair.min_radius == 5e-3);
  CHECK(pair.length == 12.5e-3);
}

TEST_CASE("Material: the order of the bodies does not matter") {
  const ElasticMaterial<double> steel{208e9, 0.3, 7850.0};
  const ContactBody<double> a = sphere(granite, 7.5e-3), b = sphere(steel, 1e-3);
  const PairProperties<double> ab = pair_properties(a, b), ba = pair_properties(b, a);
  CHECK(ab.effective_radius == ba.effective_radius);
  CHECK(ab.effective_young == ba.effective_young);
  CHECK(ab.effective_shear == ba.effective_shear);
  CHECK(ab.effective_mass == ba.effective_mass);
  CHECK(ab.min_radius == 1e-3);
  CHECK(ba.min_radius == 1e-3);
  CHECK(ab.length == ba.length);
}

TEST_CASE("Material: a plane has no curvature, and is held in space") {
  const PairProperties<double> pair = pair_properties(plane(granite), sphere(granite, 5e-3));
  CHECK(pair.effective_radius == Approx(5e-3).epsilon(1e-15));
  CHECK(pair.min_radius == 5e-3);
  CHECK(pair.length == 5e-3);
  CHECK(pair.effective_mass == Approx(4.0 / 3.0 * 3.14159265358979324 * 1.25e-7 * 2650.0).epsilon(1e-15));
}

TEST_CASE("Material: moduli of two materials with radii and a mass give the same pair") {
  const ElasticMaterial<double> steel{208e9, 0.3, 7850.0};
  const EffectiveModuli<double> moduli = effective_moduli(granite, steel);
  const double m1 = sphere_mass<double>(7.5e-3, 2650.0), m2 = sphere_mass<double>(1e-3, 7850.0);
  // Both ways round the same exact values: each within the errors at the head of pair.hpp.
  const auto check = [](const PairProperties<double>& a, const PairProperties<double>& b) {
    CHECK(a.effective_radius == Approx(b.effective_radius).epsilon(2e-15));
    CHECK(a.effective_young == Approx(b.effective_young).epsilon(2e-15));
    CHECK(a.effective_shear == Approx(b.effective_shear).epsilon(2e-15));
    CHECK(a.effective_mass == Approx(b.effective_mass).epsilon(3e-15));
    CHECK(a.min_radius == b.min_radius);
    CHECK(a.length == b.length);
  };
  check(sphere_sphere_pair(moduli, 7.5e-3, 1e-3, effective_mass(m1, m2)),
        pair_properties(sphere(granite, 7.5e-3), sphere(steel, 1e-3)));
  check(sphere_sphere_pair(moduli, 7.5e-3, 1e-3, m2),
        pair_properties(sphere(granite, 7.5e-3).fixed(), sphere(steel, 1e-3)));
  check(plane_sphere_pair(moduli, 1e-3, m2), pair_properties(plane(granite), sphere(steel, 1e-3)));
  static_assert(noexcept(sphere_sphere_pair(moduli, 1.0, 1.0, 1.0)));
  CHECK_THROWS_WITH(effective_moduli(granite, {208e9, 0.7, 7850.0}),
                    Equals("ElasticMaterial: poisson is 0.7, must lie in (-1, 0.5]"));
}

TEST_CASE("Material: properties that a host fills are checked on demand") {
  PairProperties<double> pair = granite_pair<double>();
  CHECK_NOTHROW(checked(pair));
  pair.effective_young = -1e9;
  CHECK_THROWS_WITH(checked(pair), Equals("PairProperties: effective_young is -1e+09 Pa, must lie in (0, inf)"));
  pair = granite_pair<double>();
  pair.effective_mass = nan;
  CHECK_THROWS_WITH(checked(pair), Equals("PairProperties: effective_mass is nan kg, must lie in (0, inf)"));
}

TEST_CASE("Material: a concave wall has negative curvature") {
  const PairProperties<double> pair = pair_properties(spherical_cup(granite, 20e-3), sphere(granite, 5e-3));
  CHECK(pair.effective_radius == Approx(1.0 / (200.0 - 50.0)).epsilon(1e-15));
  CHECK(pair.min_radius == 5e-3);
}

TEST_CASE("Material: a rigid side adds no compliance, a fixed one no mobility, another mass replaces the sphere's") {
  const ContactBody<double> ball = sphere(granite, 5e-3);
  const PairProperties<double> both = pair_properties(ball, ball);
  const PairProperties<double> rigid = pair_properties(ball, ball.rigid());
  CHECK(rigid.effective_young == 2.0 * both.effective_young);
  CHECK(rigid.effective_shear == 2.0 * both.effective_shear);
  CHECK(rigid.effective_mass == both.effective_mass);
  const PairProperties<double> fixed = pair_properties(ball.fixed(), ball);
  CHECK(fixed.effective_mass == 2.0 * both.effective_mass);
  CHECK(fixed.effective_young == both.effective_young);
  CHECK(pair_properties(ball.with_mass(0.5), ball.fixed()).effective_mass == 0.5);
  CHECK(pair_properties(plane(granite).rigid(), ball).effective_young == 2.0 * both.effective_young);
}

TEST_CASE("Material: bad values are named, with value, unit and range") {
  const auto refuses = [](const ElasticMaterial<double>& material, const std::string& message) {
    CHECK_THROWS_WITH(sphere(material, 1e-3), Equals("ElasticMaterial: " + message));
    CHECK_THROWS_WITH(plane(material), Equals("ElasticMaterial: " + message));
    CHECK_THROWS_WITH(spherical_cup(material, 1.0), Equals("ElasticMaterial: " + message));
  };
  refuses({0.0, 0.25, 2650}, "young is 0 Pa, must lie in (0, inf)");
  refuses({-29e9, 0.25, 2650}, "young is -2.9e+10 Pa, must lie in (0, inf)");
  refuses({inf, 0.25, 2650}, "young is inf Pa, must lie in (0, inf)");
  refuses({nan, 0.25, 2650}, "young is nan Pa, must lie in (0, inf)");
  refuses({29e9, 0.7, 2650}, "poisson is 0.7, must lie in (-1, 0.5]");
  refuses({29e9, -1.0, 2650}, "poisson is -1, must lie in (-1, 0.5]");
  refuses({29e9, nan, 2650}, "poisson is nan, must lie in (-1, 0.5]");
  refuses({29e9, 0.25, 0.0}, "density is 0 kg/m^3, must lie in (0, inf)");
  refuses({29e9, 0.25, nan}, "density is nan kg/m^3, must lie in (0, inf)");
  CHECK_NOTHROW(sphere(ElasticMaterial<double>{29e9, 0.5, 2650}, 1e-3));
  CHECK_NOTHROW(sphere(ElasticMaterial<double>{29e9, -0.999, 2650}, 1e-3));
}

TEST_CASE("Material: bad radii and masses are named") {
  for (const double radius : {0.0, -5e-3, inf, nan}) {
    CHECK_THROWS_WITH(sphere(granite, radius),
                      ContainsSubstring("sphere: radius is ") && ContainsSubstring(" m, must lie in (0, inf)"));
    CHECK_THROWS_WITH(spherical_cup(granite, radius),
                      ContainsSubstring("spherical_cup: radius is ") && ContainsSubstring(" m, must lie in (0, inf)"));
    CHECK_THROWS_WITH(sphere(granite, 1.0).with_mass(radius),
                      ContainsSubstring("mass is ") && ContainsSubstring(" kg, must lie in (0, inf)"));
  }
  CHECK_THROWS_WITH(sphere(granite, -0.5), Equals("sphere: radius is -0.5 m, must lie in (0, inf)"));
}

TEST_CASE("Material: pairs that cannot be are refused") {
  const ContactBody<double> ball = sphere(granite, 5e-3);
  CHECK_THROWS_WITH(pair_properties(ball.rigid(), plane(granite).rigid()), ContainsSubstring("one side must deform"));
  CHECK_THROWS_WITH(pair_properties(ball.fixed(), plane(granite)), ContainsSubstring("one side must be free"));
  // A ball in a socket of its own size, or a smaller one: the surfaces conform.
  CHECK_THROWS_WITH(pair_properties(ball, spherical_cup(granite, 5e-3)),
                    ContainsSubstring("sum of the curvatures) is 0 1/m"));
  CHECK_THROWS_WITH(pair_properties(ball, spherical_cup(granite, 4e-3)),
                    ContainsSubstring("sum of the curvatures) is -50"));
  CHECK_THROWS_WITH(pair_properties(plane(granite), plane(granite)), ContainsSubstring("curvatures"));
  CHECK_THROWS_AS(pair_properties(plane(granite), plane(granite)), std::invalid_argument);
}

TEST_CASE("Material: accuracy of the effective properties") {
  Random random;
  Worst worst[] = {Worst("effective radius (double)"), Worst("effective modulus (double)"),
                   Worst("effective shear modulus (double)"), Worst("effective mass (double)")};
  for (int i = 0; i < cases(20000); ++i) {
    const ElasticMaterial<double> m1{random.log_uniform(1e3, 1e12), random.uniform(-0.99, 0.5),
                                     random.log_uniform(1, 1e5)},
        m2{random.log_uniform(1e3, 1e12), random.uniform(-0.99, 0.5), random.log_uniform(1, 1e5)};
    const double r1 = random.log_uniform(1e-9, 1e3), r2 = random.log_uniform(1e-9, 1e3);
    const auto precise = [](const ElasticMaterial<double>& m) {
      return ElasticMaterial<Binary200>{Binary200(m.young), Binary200(m.poisson), Binary200(m.density)};
    };
    const PairProperties<double> computed = pair_properties(sphere(m1, r1), sphere(m2, r2));
    const PairProperties<Binary200> exact =
        pair_properties(sphere(precise(m1), Binary200(r1)), sphere(precise(m2), Binary200(r2)));
    worst[0].see(ulps(computed.effective_radius, exact.effective_radius), r1, r2);
    worst[1].see(ulps(computed.effective_young, exact.effective_young), m1.young, m1.poisson, m2.young, m2.poisson);
    worst[2].see(ulps(computed.effective_shear, exact.effective_shear), m1.young, m1.poisson, m2.young, m2.poisson);
    worst[3].see(ulps(computed.effective_mass, exact.effective_mass), r1, r2);
  }
  // Sums of positive numbers: each rounding counts once, and there are 4 for a radius, 5 to 9 for the others.
  CHECK(worst[0].error() <= 4.0);
  CHECK(worst[1].error() <= 6.0);
  CHECK(worst[2].error() <= 6.0);
  CHECK(worst[3].error() <= 9.0);
}

}  // namespace contactlaws::test
