#include "contactlaws/timestep.hpp"
#include "make_laws.hpp"

#include "catch.hpp"
#include "contactlaws/laws.hpp"
#include "oracle.hpp"
#include "random.hpp"

namespace contactlaws::test {

TEST_CASE("Time step: stiffnesses of a contact are the tangents, and dashpots stiffen both") {
  const PairProperties<double> pair = granite_pair<double>();
  const double k_n = 1.08330463206478e9, k_s = 1.49320368203524e9, overlap = 1e-4;
  const ContactStiffness<double> plain = test::dry_hill<double>(0.4, 0.0).stiffness(pair, overlap, {});
  CHECK(plain.normal == Approx(1.5 * k_n * 0.01).epsilon(1e-14));  // (19)
  CHECK(plain.shear == Approx(k_s * 0.01).epsilon(1e-14));
  const ContactStiffness<double> damped = test::dry_hill<double>(0.4, 0.07).stiffness(pair, overlap, {});
  const double b = 0.035, factor = std::pow(std::sqrt(1.0 + b * b) - b, 2);  // (20), (21)
  CHECK(damped.normal == Approx(plain.normal / factor).epsilon(1e-14));
  CHECK(damped.shear == Approx(plain.shear / factor).epsilon(1e-14));
  CHECK(SmoothHertz<double>{}.stiffness(pair, overlap, {}).shear == 0.0);
  const LinearFriction<double> linear{{29e9}, {}, {{0.5}, 0.4}, {}};
  CHECK(linear.stiffness(pair, overlap, {}).normal == Approx(1.82212373908208e8).epsilon(1e-14));
  CHECK(linear.stiffness(pair, overlap, {}).shear == Approx(0.5 * 1.82212373908208e8).epsilon(1e-14));
}

TEST_CASE("Time step: a wet gap counts as an overlap of 2e-4 R_o, a dry one not at all") {
  const PairProperties<double> pair = granite_pair<double>();
  const Hill<double> law = test::hill<double>(0.4, 2e5, 0.07);
  Hill<double>::State wet{};
  wet.moisture = 2.0;
  for (const double overlap : {0.0, -1e-6, -5e-3}) {
    CHECK(law.stiffness(pair, overlap, wet).normal == law.stiffness(pair, 1e-6, {}).normal);
    CHECK(law.stiffness(pair, overlap, wet).shear == law.stiffness(pair, 1e-6, {}).shear);
    CHECK(law.stiffness(pair, overlap, {}).normal == 0.0);
    CHECK(law.stiffness(pair, overlap, {}).shear == 0.0);
  }
}

TEST_CASE("Time step: contacts add up per axis, the normal one along n, shear across") {
  BodyStiffness<double> body;
  body.add({3.0, 2.0}, {1, 0, 0}, 0.5);
  CHECK(body.translation == Vec3<double>(3, 2, 2));
  CHECK(body.rotation == Vec3<double>(0, 0.5, 0.5));  // k_s r^2 about the axes across
  body.add({3.0, 2.0}, {0, 0.6, 0.8}, 1.0);
  CHECK(body.translation.isApprox(Vec3<double>(5, 2 + 3 * 0.36 + 2 * 0.64, 2 + 3 * 0.64 + 2 * 0.36), 1e-15));
  CHECK(body.rotation.isApprox(Vec3<double>(2, 0.5 + 2 * 0.64, 0.5 + 2 * 0.36), 1e-15));
}

TEST_CASE("Time step: the smallest over the axes, of translation and rotation") {
  BodyStiffness<double> body;
  CHECK(stable_time_step(2.0, 1.0, body, 0.125) == 0.125);  // no contact
  body.translation = {8.0, 2.0, 0.5};
  CHECK(stable_time_step(2.0, 1.0, body, 10.0) == 0.5);  // sqrt(m / k) of the max_tangent axis
  body.rotation = {1.0, 25.0, 4.0};
  CHECK(stable_time_step(2.0, 1.0, body, 10.0) == 0.2);  // sqrt(I / kappa)
  CHECK(stable_time_step(2.0, 1.0, body, 0.1) == 0.1);
}

TEST_CASE("Time step: below it a pair on a spring oscillates, beyond twice it explodes") {
  // One sphere on a linear spring against a wall, symplectic Euler: its limit is 2 sqrt(m/k), exactly.
  const LinearSpringDashpot<double> law{{1e6}, {0.0}, {{1.0}, 0.0}, {}};
  const PairProperties<double> pair = granite_pair<double>();
  const double stiffness = law.stiffness(pair, 1e-5, {}).normal;
  BodyStiffness<double> body;
  body.add({stiffness, stiffness}, {0, 0, 1}, 5e-3);
  const double step = stable_time_step(pair.effective_mass, 1.0, body, 1.0);
  const auto largest = [&](double dt) {
    double overlap = 1.0001, separating = 0.0, most = 0.0;  // about a rest at 1, pressed by 1e6 N
    for (int i = 0; i < 1000; ++i) {
      const double force = law.step(pair, {{0, 0, 1}, overlap, {0, 0, separating}, dt}, {}).normal_force;
      separating += (force - 1e6) / pair.effective_mass * dt;
      overlap -= separating * dt;
      most = std::max(most, std::abs(overlap - 1.0));
    }
    return most;
  };
  CHECK(largest(0.2 * step) < 1.2e-4);
  CHECK(largest(1.95 * step) < 1e-3);
  CHECK(largest(2.05 * step) > 0.1);
}

TEST_CASE("Impact: overlap and duration of the published impacts") {
  // Two glass spheres at +-10 m/s; an aluminium sphere on a rigid plane at 0.2 m/s (Chung & Ooi 2011, tests 1 and 2).
  const ElasticMaterial<double> glass{48e9, 0.20, 2800.0}, aluminium{70e9, 0.30, 2699.0};
  const auto spheres = pair_properties(sphere(glass, 10e-3), sphere(glass, 10e-3));
  CHECK(impact_overlap(spheres, 20.0) == Approx(274.1127e-6).epsilon(2e-7));  // digits printed
  CHECK(impact_duration(spheres, 20.0) == Approx(40.33945e-6).epsilon(2e-7));
  const auto on_plane = pair_properties(plane(aluminium).rigid(), sphere(aluminium, 100e-3));
  CHECK(impact_overlap(on_plane, 0.2) == Approx(49.71718e-6).epsilon(2e-7));
  CHECK(impact_duration(on_plane, 0.2) == Approx(731.6566e-6).epsilon(2e-7));
}

TEST_CASE("Impact: the overlap stores the kinetic energy, and the duration scales with it, to the errors stated") {
  Random random;
  Worst overlap("impact overlap"), duration("impact duration");
  const Binary200 factor("2.9432751843247046573817873000829227262");  // 4 sqrt(pi) Gamma(2/5) / (5 Gamma(9/10))
  for (int i = 0; i < test::cases(20000); ++i) {
    const PairProperties<double> pair = random_pair(random);
    const double speed = random.log_uniform(1e-6, 1e3);
    const Binary200 exact = impact_overlap(pair.cast<Binary200>(), Binary200(speed));
    overlap.see(ulps(impact_overlap(pair, speed), exact), pair.effective_radius, speed);
    duration.see(ulps(impact_duration(pair, speed), Binary200(factor * exact / speed)), pair.effective_radius, speed);
    const double kinetic = pair.effective_mass * speed * speed / 2.0;
    CHECK(hertz_energy(pair, static_cast<double>(exact)) == Approx(kinetic).epsilon(1e-14));  // 20 roundings
  }
  CHECK(overlap.error() <= 16.0);
  CHECK(duration.error() <= 16.0);
}

}  // namespace contactlaws::test
