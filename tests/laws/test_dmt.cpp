#include "contactlaws/normal/dmt.hpp"

#include "catch.hpp"
#include "contactlaws/laws.hpp"
#include "oracle.hpp"
#include "random.hpp"

namespace contactlaws::test {
namespace {

using Law = ContactLaw<Dmt<double>, Dashpots<double, Tension::clipped>, ShearForce<double>>;

/// A contact that moves along its normal and across it.
ContactKinematics<double> moving(double overlap, double separating, double slip = 0.0) {
  return {{0.0, 0.0, 1.0}, overlap, {slip, 0.0, separating}, 1e-6};
}

/// The memo's grains, R* = 3 mm, with w = 0.05 J/m^2: F_c = 2 pi w R* = 9.42477796076938e-4 N.
const PairProperties<double> pair = granite_pair<double>();
constexpr double work_of_adhesion = 0.05, pull_off = 9.42477796076938e-4;

}  // namespace

TEST_CASE("DMT: Hertz's force less the pull-off force 2 pi w R*, while the bodies touch") {
  const ContactLaw<Dmt<double>> law{{work_of_adhesion}, {}, {}, {}, {}};
  CHECK(law.normal.pull_off_force(pair) == Approx(pull_off).epsilon(1e-14));  // 15 digits
  CHECK(law.step(pair, moving(1e-4, 0.0), {}).force.z() == Approx(1083.30463206478 - pull_off).epsilon(1e-14));
  // At touch the force jumps from 0 to the pull-off force. Hertz adds 1e9 N/m^(3/2) (1e-12 m)^(3/2) = 1e-9 N.
  CHECK(law.step(pair, moving(1e-12, 0.0), {}).force.z() == Approx(-pull_off).epsilon(2e-6));
  CHECK(law.step(pair, moving(0.0, 0.0), {}).force.z() == 0.0);
  CHECK(law.step(pair, moving(-1e-12, 0.0), {}).force.z() == 0.0);
  CHECK(law.interaction_range(pair) == 0.0);
  const auto touching = law.step(pair, moving(1e-4, 0.0), {});
  CHECK(touching.normal_elastic == touching.normal_force);
  CHECK(law.step(pair, moving(-1e-12, 0.0), {}).normal_force == 0.0);
}

TEST_CASE("DMT: friction acts on the force and the adhesion together") {
  Law law;
  law.normal.work_of_adhesion = work_of_adhesion;
  law.shear.friction = 0.4;
  // Where Hertz's force equals the pull, nothing presses, and friction bears mu F_c.
  const double balance = std::pow(pull_off / 1.08330463206478e9, 2.0 / 3.0);
  const auto step = law.step(pair, moving(balance, 0.0, 10.0), {});
  CHECK(std::abs(step.normal_force) <= 1e-13 * pull_off);  // rounding of the power above
  CHECK(step.sliding);
  CHECK(step.force.x() == Approx(-0.4 * pull_off).epsilon(1e-13));
}

TEST_CASE("DMT: a clipped dashpot pulls no more than the adhesion") {
  Law law;
  law.normal.work_of_adhesion = work_of_adhesion;
  law.damping.damping_constant = 0.5;
  CHECK(law.step(pair, moving(1e-6, 100.0), {}).normal_force == Approx(-pull_off).epsilon(1e-14));
  // Approaching, the dashpot adds alpha sqrt(m* k_n) o^(1/4) v, with Hertz's secant for k_n.
  const double dashpot = 0.5 * std::sqrt(1.07038549697309e-3 * 1.08330463206478e9) * std::pow(1e-6, 0.25) * 2.0;
  CHECK(law.step(pair, moving(1e-6, -2.0), {}).normal_force ==
        Approx(1.08330463206478 - pull_off + dashpot).epsilon(1e-13));
}

TEST_CASE("DMT: energy is the work of the force, zero at touch") {
  const Dmt<double> law{work_of_adhesion};
  const double deep = 1e-6;
  // Integrated: 2/5 k_n o^(5/2) - F_c o.
  CHECK(law.energy({}, pair, deep) ==
        Approx(0.4 * 1.08330463206478e9 * std::pow(deep, 2.5) - pull_off * deep).epsilon(1e-13));
  CHECK(law.energy({}, pair, 0.0) == 0.0);
  CHECK(law.energy({}, pair, -1e-6) == 0.0);
}

TEMPLATE_TEST_CASE("DMT: accuracy", "", double, float) {
  using T = TestType;
  Random random(20240611);
  double worst = 0.0;
  for (int i = 0; i < cases(100000); ++i) {
    const PairProperties<T> wide = wide_pair<T>(random);
    const T overlap = random.binary<T>(-40, 4);
    const Dmt<T> law{random.binary<T>(-30, 20)};
    typename Dmt<T>::State state;
    typename Dmt<Binary200>::State state_200;
    const T computed = law.respond(state, wide, overlap).force;
    const auto exact = Dmt<Binary200>{Binary200(law.work_of_adhesion)}.respond(
        state_200, wide.template cast<Binary200>(), Binary200(overlap));
    const Binary200 larger = maximum<Binary200>(exact.force + exact.adhesion, exact.adhesion);
    const Binary200 error = abs(Binary200(computed) - exact.force) / larger / std::numeric_limits<T>::epsilon();
    worst = std::max(worst, static_cast<double>(error));
  }
  CHECK(worst <= 5.0);  // in eps of the larger term: 4 of Hertz's force, half of the pull and of the difference each
}

TEST_CASE("DMT: its parameter is checked") {
  CHECK_THROWS_WITH(checked(Dmt<double>{-1.0}),
                    Catch::Matchers::Equals("Dmt: work_of_adhesion is -1 J/m^2, must lie in [0, inf)"));
}

}  // namespace contactlaws::test
