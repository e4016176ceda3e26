#include "contactlaws/damping/dashpots.hpp"
#include "make_laws.hpp"

#include "catch.hpp"
#include "contactlaws/laws.hpp"
#include "oracle.hpp"
#include "random.hpp"

namespace contactlaws::test {
namespace {

/// A contact that moves along its normal.
ContactKinematics<double> moving(double overlap, double separating) {
  return {{0.0, 0.0, 1.0}, overlap, {0.0, 0.0, separating}, 1e-6};
}

}  // namespace

TEST_CASE("Dashpots: alpha sqrt(m* k_n) o^(1/4), with k_n o^(1/2) the secant, not the tangent") {
  const PairProperties<double> pair = granite_pair<double>();
  const DryHill<double> law = test::dry_hill<double>(0.4, 0.07);
  const double overlap = 2e-4;
  const auto step = law.step(pair, moving(overlap, -100.0), {});
  // Memo, Table 4: alpha_n = alpha_h sqrt(m* k_n), k_n as printed to 15 digits.
  const double alpha_n = 0.07 * std::sqrt(1.07038549697309e-3 * 1.08330463206478e9);
  CHECK(step.normal_force - step.normal_elastic ==
        Approx(alpha_n * std::sqrt(std::sqrt(overlap)) * 100.0).epsilon(1e-13));

  const double alpha_s = 0.07 * std::sqrt(1.07038549697309e-3 * 1.49320368203524e9);
  const DampingCoefficients<double> c =
      law.damping.coefficients(pair.effective_mass, 0.0, 1.49320368203524e9 * std::sqrt(overlap));
  CHECK(c.shear == Approx(alpha_s * std::sqrt(std::sqrt(overlap))).epsilon(1e-13));
}

TEST_CASE("Dashpots: oppose the motion, and rest with it") {
  const Dashpots<double> law{0.3};
  const DampingCoefficients<double> c = law.coefficients(2.0, 8.0, 18.0);
  CHECK(c.normal == 0.3 * 4.0);
  CHECK(c.shear == 0.3 * 6.0);
  CHECK(law.normal_force(10.0, c.normal, 0.0) == 10.0);
  CHECK(law.normal_force(10.0, c.normal, 1.0) == 10.0 - 0.3 * 4.0);
  CHECK(law.normal_force(10.0, c.normal, -1.0) == 10.0 + 0.3 * 4.0);
}

TEST_CASE("Dashpots: the end of an impact pulls where tension is allowed, and never where it is clipped") {
  const PairProperties<double> pair = granite_pair<double>();
  const DryHill<double> pulls = test::dry_hill<double>(0.4, 0.5);
  const DryHill<double, Tension::clipped> never{{}, {0.5}, {{}, 0.4}, {}};
  for (const double overlap : {1e-12, 1e-8, 1e-5}) {
    CHECK(pulls.step(pair, moving(overlap, 5.0), {}).normal_force < 0.0);
    CHECK(never.step(pair, moving(overlap, 5.0), {}).normal_force == 0.0);
    CHECK(never.step(pair, moving(overlap, 5.0), {}).force.z() == 0.0);
    CHECK(never.step(pair, moving(overlap, -5.0), {}).normal_force ==
          pulls.step(pair, moving(overlap, -5.0), {}).normal_force);
  }
}

TEST_CASE("Dashpots, fault: damping is NaN as the overlap goes to 0 with cohesion") {
  const PairProperties<double> pair = granite_pair<double>();
  const Hill<double> law = test::hill<double>(0.4, 2e5, 0.07);
  Hill<double>::State wet{};
  Hill<double>::make_wet(wet, 0.0, 0.0);
  const double tiny = std::numeric_limits<double>::denorm_min();
  for (const double overlap : {-1e-6, -tiny, 0.0, tiny, 1e-300, 1e-20}) {
    ContactKinematics<double> contact = moving(overlap, -1.0);
    contact.velocity.x() = 0.3;
    const auto step = law.step(pair, contact, wet);
    CHECK(step.force.allFinite());
    // At touch only the bridge is left: the dashpot fades as o^(1/4), 2e-5 of it at 1e-20.
    CHECK(step.force.z() == Approx(-15.707963267949).epsilon(1e-4));
  }
}

TEST_CASE("Dashpots, fault: 0/0 at an undamped wall") {
  const ElasticMaterial<double> granite{29e9, 0.15, 2650};
  const PairProperties<double> pair = pair_properties(plane(granite), sphere(granite, 5e-3));
  const DryHill<double> law = test::dry_hill<double>(0.4, 0.0);
  const ContactLaw<Hertz<double>, NoDashpots<double>, ShearForce<double>> without{{}, {}, {{}, 0.4}, {}};
  for (const double overlap : {0.0, 1e-6}) {
    ContactKinematics<double> contact = moving(overlap, 0.0);
    contact.velocity.x() = 1e-3;
    const auto step = law.step(pair, contact, {});
    CHECK(step.force.allFinite());
    CHECK(step.force == without.step(pair, contact, {}).force);
  }
  CHECK(law.stiffness(pair, 1e-6, {}).normal == without.stiffness(pair, 1e-6, {}).normal);
}

TEST_CASE("Dashpots: factor of a contact, for the time step") {
  CHECK(Dashpots<double>{0.0}.stiffness_factor() == 1.0);
  CHECK(NoDashpots<double>{}.stiffness_factor() == 1.0);
  for (const double alpha : {1e-3, 0.07, 0.5, 1.0}) {
    const long double b = alpha / 2.0L;
    const long double memo = 1.0L / std::pow(std::sqrt(1.0L + b * b) - b, 2.0L);  // Eqs 20-21
    CHECK(Dashpots<double>{alpha}.stiffness_factor() == Approx(static_cast<double>(memo)).epsilon(1e-15));
  }
}

TEMPLATE_TEST_CASE("Dashpots: accuracy", "", double, float) {
  using T = TestType;
  Random random;
  Worst coefficient("dashpot coefficient" + precision_name<T>()), factor("dashpot factor" + precision_name<T>());
  for (int i = 0; i < cases(100000); ++i) {
    const Dashpots<T> law{random.binary<T>(-20, 1)};
    const T mass = random.binary<T>(-60, 20), stiffness = random.binary<T>(-40, 40);
    const DampingCoefficients<T> computed = law.coefficients(mass, T(1), stiffness);
    const auto reference = slot_cast<Binary200>(law);
    coefficient.see(
        ulps(computed.shear, reference.coefficients(Binary200(mass), Binary200(1), Binary200(stiffness)).shear),
        law.damping_constant, mass, stiffness);
    factor.see(ulps(law.stiffness_factor(), reference.stiffness_factor()), law.damping_constant);
  }
  CHECK(coefficient.error() <= 2.0);  // what the header promises
  CHECK(factor.error() <= 4.0);       // a square doubles the error of the root
}

TEST_CASE("Dashpots: the shear coefficient is the normal one's, none, or given") {
  // roots of m* k: 4 and 6
  CHECK(Dashpots<double>{0.3}.coefficients(2.0, 8.0, 18.0).shear == 0.3 * 6.0);
  const Dashpots<double, Tension::allowed, ShearDashpot::none> none{0.3};
  CHECK(none.coefficients(2.0, 8.0, 18.0).normal == 0.3 * 4.0);
  CHECK(none.coefficients(2.0, 8.0, 18.0).shear == 0.0);
  const Dashpots<double, Tension::allowed, ShearDashpot::given> given{0.3, 0.1};
  CHECK(given.coefficients(2.0, 8.0, 18.0).normal == 0.3 * 4.0);
  CHECK(given.coefficients(2.0, 8.0, 18.0).shear == 0.1 * 6.0);
  CHECK(given.stiffness_factor() == Dashpots<double>{0.3}.stiffness_factor());  // of the larger constant
  CHECK(none.parameters().size() == 1);
  CHECK(given.parameters().size() == 2);
  CHECK_THROWS_WITH(checked(decltype(given){0.3, -0.1}),
                    Catch::Matchers::Equals("Dashpots: shear_damping_constant is -0.1, must lie in [0, inf)"));
}

}  // namespace contactlaws::test
