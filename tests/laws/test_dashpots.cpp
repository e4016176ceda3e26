#include "contactlaws/damping/dashpots.hpp"
#include "make_laws.hpp"

#include "catch.hpp"
#include "contactlaws/damping/restitution.hpp"
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

namespace {

template <class T>
using InRatio = Dashpots<T, Tension::allowed, ShearDashpot::in_ratio>;

template <class T>
EffectiveModuli<T> moduli_of(const PairProperties<T>& pair) {
  return {pair.effective_young, pair.effective_shear};
}

}  // namespace

TEST_CASE("Dashpots in ratio: one root, and a ratio that must be given") {
  const InRatio<double> law{{0.3}, 1.5};
  const DampingCoefficients<double> c = law.coefficients(2.0, 8.0, 1e300);  // the shear stiffness is not read
  CHECK(c.normal == 0.3 * 4.0);
  CHECK(c.shear == 1.5 * (0.3 * 4.0));
  CHECK(law.damps_shear);
  CHECK(law.stiffness_factor() == Dashpots<double>{0.3}.stiffness_factor());
  CHECK(law.normal_force(10.0, c.normal, 1.0) == 10.0 - 0.3 * 4.0);
  CHECK(law.parameters().size() == 2);
  CHECK_THROWS_WITH(checked(InRatio<double>{{0.3}}),
                    Catch::Matchers::Equals("Dashpots: dashpot_ratio is 0, must lie in (0, inf)"));
}

TEST_CASE("Dashpots in ratio: Mindlin's is sqrt(3 (1 - nu)/(2 - nu)) of one material, and between 1 and sqrt(2)") {
  for (const double nu : {-0.9, -0.5, 0.0, 0.15, 0.3, 0.5}) {
    const ElasticMaterial<double> material{29e9, nu, 2650.0};
    CHECK(mindlin_dashpot_ratio(effective_moduli(material, material)) ==
          Approx(std::sqrt(3.0 * (1.0 - nu) / (2.0 - nu))).epsilon(1e-15));  // some five roundings
  }
  // Stiffnesses of the memo's grains over o^(1/2), as printed to 15 digits.
  CHECK(mindlin_dashpot_ratio(moduli_of(granite_pair<double>())) ==
        Approx(std::sqrt(1.49320368203524e9 / 1.08330463206478e9)).epsilon(1e-14));
  Random random;
  for (int i = 0; i < 1000; ++i) {
    const double of_two = mindlin_dashpot_ratio(moduli_of(random_pair(random)));  // nu from -0.5 to 0.5
    CHECK(of_two > 1.0);
    CHECK(of_two < std::sqrt(2.0));
  }
}

TEST_CASE("Dashpots in ratio: at 200 bits the coefficients are those of DryHill") {
  Random random;
  for (int i = 0; i < 100; ++i) {
    const auto pair = wide_pair<double>(random).cast<Binary200>();
    Hertz<Binary200>::State none{};
    const auto normal = Hertz<Binary200>{}.respond(none, pair, pair.effective_radius / 1000);
    const Dashpots<Binary200> two_roots{Binary200(0.3)};
    const InRatio<Binary200> one_root{{Binary200(0.3)}, mindlin_dashpot_ratio(moduli_of(pair))};
    const auto expected =
        two_roots.coefficients(pair.effective_mass, normal.secant, Mindlin<Binary200>{}.stiffness(pair, normal));
    const auto computed = one_root.coefficients(pair.effective_mass, normal.secant, Binary200(0));
    CHECK(computed.normal == expected.normal);
    CHECK(abs(computed.shear - expected.shear) <= expected.shear * 1e-58);  // 200 bits are 60 digits
  }
}

TEMPLATE_TEST_CASE("Dashpots in ratio: accuracy", "", double, float) {
  using T = TestType;
  Random random;
  Worst ratio("Mindlin's dashpot ratio" + precision_name<T>()), coefficient("c_s in ratio" + precision_name<T>());
  for (int i = 0; i < cases(100000); ++i) {
    const EffectiveModuli<T> moduli = moduli_of(wide_pair<T>(random));
    const EffectiveModuli<Binary200> exact{moduli.young, moduli.shear};
    ratio.see(ulps(mindlin_dashpot_ratio(moduli), mindlin_dashpot_ratio(exact)), moduli.young, moduli.shear);
    const T alpha = random.binary<T>(-20, 1);
    const InRatio<T> law{{alpha}, random.binary<T>(-3, 3)};
    const T mass = random.binary<T>(-60, 20);
    const T secant = random.binary<T>(-40, 40);
    const auto reference = slot_cast<Binary200>(law).coefficients(Binary200(mass), Binary200(secant), Binary200(0));
    coefficient.see(ulps(law.coefficients(mass, secant, T(0)).shear, reference.shear), alpha, mass, secant);
  }
  CHECK(ratio.error() <= 2.0);  // what the header promises
  CHECK(coefficient.error() <= 3.0);
}

TEMPLATE_TEST_CASE("Dashpots in ratio: a DryHill of one pair of materials moves as DryHill, its shear force to 8 eps",
                   "", double, float) {
  using T = TestType;
  const T eps = std::numeric_limits<T>::epsilon();
  Random random;
  int sticking = 0, sliding = 0;
  for (int i = 0; i < cases(2000); ++i) {
    const PairProperties<T> pair = random_pair(random).template cast<T>();
    DryHillProperties<T> properties;
    properties.friction = T(random.uniform(0.1, 1.0));
    properties.damping_constant = T(random.log_uniform(1e-2, 2.0));
    const auto two_roots = contactlaws::dry_hill(properties);
    const auto one_root = contactlaws::dry_hill(properties, moduli_of(pair));
    T history[3] = {}, same[3] = {};
    const Vec3<T> normal = random.direction().template cast<T>().normalized();
    const T period = T(std::sqrt(pair.effective_mass / pair.effective_young / pair.effective_radius));
    for (int k = 0; k < 10; ++k) {
      const T overlap = pair.effective_radius * T(random.log_uniform(1e-6, 1e-3));
      const T speed = overlap / period * T(random.log_uniform(1e-4, 1e-1));
      const ContactKinematics<T> motion{normal, overlap, random.direction().template cast<T>() * speed, period};
      const auto expected = two_roots.step(pair, motion, two_roots.load(history));
      const auto step = one_root.step(pair, motion, one_root.load(same));
      two_roots.store(expected.state, history);
      one_root.store(step.state, same);
      CHECK(std::equal(history, history + 3, same));
      CHECK(step.normal_force == expected.normal_force);
      // Roundings of c_s, in eps/2: of two roots 3 (k_s 1 and a product 1, halved; root, alpha), of one root 7 (secant 3 and a
      // product 1, halved; root, alpha, the ratio 2, its product). Together 5 eps; 3 more for the sum and its limit.
      const T c_s = properties.damping_constant * std::sqrt(pair.effective_mass * 8 * pair.effective_shear *
                                                            std::sqrt(pair.effective_radius * overlap));
      const T error = norm<T>(Vec3<T>(step.shear_force - expected.shear_force));
      CHECK(error <= 8 * eps * (c_s * speed + norm<T>(expected.shear_force)));
      (expected.sliding ? sliding : sticking) += 1;
    }
  }
  CHECK(sticking > cases(2000));
  CHECK(sliding > cases(2000));
}

TEST_CASE("Dashpots in ratio: restitution, time step and heat are those of DryHill") {
  const PairProperties<double> pair = granite_pair<double>();
  DryHillProperties<double> properties;
  properties.friction = 0.4;
  properties.damping_constant = damping_constant<DryHill<double>>(0.7);
  const auto law = contactlaws::dry_hill(properties, moduli_of(pair));
  CHECK(damping_constant<std::decay_t<decltype(law)>>(0.7) == properties.damping_constant);
  using Clipped = DryHill<double, Tension::clipped, ShearDashpot::in_ratio>;
  CHECK(damping_constant<Clipped>(0.7) == damping_constant<DryHill<double, Tension::clipped>>(0.7));

  const ContactStiffness<double> stiffness = law.stiffness(pair, 1e-5, {});
  const ContactStiffness<double> expected = contactlaws::dry_hill(properties).stiffness(pair, 1e-5, {});
  CHECK(stiffness.normal == expected.normal);
  CHECK(stiffness.shear == expected.shear);

  // c_n v_n^2 dt + c_s v_s^2 dt with the memo's stiffnesses; the sum of spring and dashpot cancels to 1e-12.
  const double root = std::sqrt(1e-5), dt = 1e-7, alpha = properties.damping_constant, mass = pair.effective_mass;
  const auto step = law.step(pair, {{0, 0, 1}, 1e-5, {0.1, 0, -0.3}, dt}, {});
  CHECK_FALSE(step.sliding);
  CHECK(step.dashpot_work == Approx(alpha * dt *
                                    (std::sqrt(mass * 1.08330463206478e9 * root) * 0.09 +
                                     std::sqrt(mass * 1.49320368203524e9 * root) * 0.01))
                                 .epsilon(1e-12));
}

}  // namespace contactlaws::test
