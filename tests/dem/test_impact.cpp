// Impacts, slides and spins against closed forms, through the integrator of examples/dem.
#include "catch.hpp"
#include "contactlaws/damping/restitution.hpp"
#include "contactlaws/laws.hpp"
#include "examples/dem/simulation.hpp"
#include "make_laws.hpp"

using namespace contactlaws;
using dem::Ball;
using V = dem::Vec3;

namespace {

/// t_c v / o_max of an elastic impact: 4 sqrt(pi) Gamma(2/5) / (5 Gamma(9/10)).
const double contact_factor = 4 * std::sqrt(pi<double>()) * std::tgamma(0.4) / (5 * std::tgamma(0.9));

double deepest_overlap(const PairProperties<double>& pair, double speed) {
  return std::pow(
      15 * pair.effective_mass * speed * speed / (16 * pair.effective_young * std::sqrt(pair.effective_radius)), 0.4);
}

struct Impact {
  double deepest;   ///< [m]
  double force;     ///< the largest [N]
  double duration;  ///< [s]
};

/// Steps from touch until contact number 0 opens. Extremes by a parabola and the end by a line through the last steps: errors
/// of the second order in the step, or less.
template <class Scene>
Impact watch(Scene& scene) {
  double before = 0.0, last = 0.0, deepest = 0.0, force = 0.0;
  for (;;) {
    scene.step();
    const auto contact = scene.walls.empty() ? scene.ball_contact(0) : scene.wall_contact(0);
    const double overlap = contact.geometry.overlap;
    if (overlap < last && last > before)
      deepest = last + (overlap - before) * (overlap - before) / (16 * last - 8 * (overlap + before));
    force = std::max(force, contact.response.normal_force);
    if (overlap <= 0.0) return {deepest, force, scene.time - scene.time_step * overlap / (overlap - last)};
    before = last;
    last = overlap;
  }
}

/// A ball that hits a rigid wall head-on at `speed` [m/s], in steps of `duration` / `steps`: rebound over approach.
template <class Law>
double rebound(const Law& law, const ElasticMaterial<double>& material, double radius, double speed, double duration,
               int steps) {
  dem::Simulation<Law> scene(law);
  scene.log = nullptr;
  scene.add(dem::Wall{plane(material).rigid(), V::Zero(), V::UnitZ()});
  scene.add(Ball{sphere(material, radius), {0.0, 0.0, radius}, {0.0, 0.0, -speed}});
  scene.time_step = duration / steps;
  double overlap = 0.0, force = 0.0;
  for (;;) {
    scene.step();
    if (scene.wall_contact(0).geometry.overlap <= 0.0) break;
    overlap = scene.wall_contact(0).geometry.overlap;
    force = scene.balls.force[0].z();
  }
  // The last force acted for a whole step, from half a step before its overlap; contact ended at overlap/velocity after.
  const double velocity = scene.balls.velocity[0].z();
  return (velocity + force / scene.balls.mass[0] * (overlap / velocity - scene.time_step / 2)) / speed;
}

}  // namespace

TEST_CASE("H2, H3: two glass spheres at +-10 m/s") {
  const ElasticMaterial<double> glass{48e9, 0.20, 2800.0};
  const double radius = 10e-3;
  dem::Simulation<SmoothHertz<double>> scene(SmoothHertz<double>{});
  scene.add(Ball{sphere(glass, radius), {-radius, 0.0, 0.0}, {10.0, 0.0, 0.0}});
  scene.add(Ball{sphere(glass, radius), {radius, 0.0, 0.0}, {-10.0, 0.0, 0.0}});
  scene.time_step = 2e-9;
  const Impact impact = watch(scene);
  CHECK(impact.deepest == Approx(274.1127e-6).epsilon(2e-7));  // digits printed
  CHECK(impact.force == Approx(10.696889e3).epsilon(2e-7));
  CHECK(impact.duration == Approx(40.33945e-6).epsilon(2e-7));
  const double closed_form = deepest_overlap(pair_properties(sphere(glass, radius), sphere(glass, radius)), 20.0);
  CHECK(impact.deepest == Approx(closed_form).epsilon(1e-7));
  CHECK(impact.duration == Approx(contact_factor * closed_form / 20.0).epsilon(1e-7));
}

TEST_CASE("H3: an aluminium sphere on a rigid plane at 0.2 m/s") {
  const ElasticMaterial<double> aluminium{70e9, 0.30, 2699.0};
  const double radius = 100e-3;
  dem::Simulation<SmoothHertz<double>> scene(SmoothHertz<double>{});
  scene.add(dem::Wall{plane(aluminium).rigid(), V::Zero(), V::UnitZ()});
  scene.add(Ball{sphere(aluminium, radius), {0.0, 0.0, radius}, {0.0, 0.0, -0.2}});
  scene.time_step = 5e-8;
  const Impact impact = watch(scene);
  CHECK(impact.deepest == Approx(49.71718e-6).epsilon(2e-7));  // digits printed
  CHECK(impact.force == Approx(11.369858e3).epsilon(2e-7));
  CHECK(impact.duration == Approx(731.6566e-6).epsilon(2e-7));
}

template <Tension tension>
void check_restitution() {
  const ElasticMaterial<double> aluminium{70e9, 0.30, 2699.0};
  const double radius = 5e-3, stiffness = 1e7;
  const auto pair = pair_properties(plane(aluminium).rigid(), sphere(aluminium, radius));
  for (const double e : {0.05, 0.1, 0.3, 0.5, 0.7, 0.9, 0.98, 1.0}) {
    ContactLaw<Hertz<double>, Dashpots<double, tension>> hertz;
    hertz.damping.damping_constant = damping_constant(e, Spring::hertz, tension);
    ContactLaw<LinearSpring<double>, Dashpots<double, tension>> linear;
    linear.normal.normal_stiffness = stiffness;
    linear.damping.damping_constant = damping_constant(e, Spring::linear, tension);
    // Velocities are half a step old, so the damping is first order in the step: one extrapolation removes that error. The
    // dashpot of a Hertz contact starts as o^(1/4), which leaves an error of the order 5/4 and determines the step.
    const auto extrapolated = [](const auto& of_steps) { return 2 * of_steps(80000) - of_steps(40000); };
    for (const double speed : {0.01, 0.2, 5.0}) {
      const double hertz_duration = contact_factor * deepest_overlap(pair, speed) / speed;
      const double linear_duration = pi<double>() * std::sqrt(pair.effective_mass / stiffness);
      CAPTURE(e, speed);
      CHECK(extrapolated([&](int n) { return rebound(hertz, aluminium, radius, speed, hertz_duration, n); }) ==
            Approx(e).margin(1e-6).epsilon(0));
      CHECK(extrapolated([&](int n) { return rebound(linear, aluminium, radius, speed, linear_duration, n); }) ==
            Approx(e).margin(1e-6).epsilon(0));
    }
  }
}

TEST_CASE("T1: restitution as asked, tension allowed") { check_restitution<Tension::allowed>(); }
TEST_CASE("T1: restitution as asked, tension clipped") { check_restitution<Tension::clipped>(); }

TEST_CASE("J1: two JKR grains stick below the sticking speed, and part above it less the work of separation") {
  // v_s^2 = 2 U / m*, U = 7.0918 (w^5 R*^4 / E*^2)^(1/3) (Thornton & Ning 1998, with 7.09).
  const ElasticMaterial<double> soft{2e6, 0.30, 1000.0};
  const double radius = 1e-3, work_of_adhesion = 0.05;
  const auto pair = pair_properties(sphere(soft, radius), sphere(soft, radius));
  ContactLaw<Jkr<double>> law;
  law.normal.work_of_adhesion = work_of_adhesion;
  const double separation = 7.0918 * std::cbrt(std::pow(work_of_adhesion, 5.0) * std::pow(pair.effective_radius, 4.0) /
                                               (pair.effective_young * pair.effective_young));
  const double sticking = std::sqrt(2 * separation / pair.effective_mass);
  const double stiffness = 2 * pair.effective_young * law.normal.pull_off_radius(pair);
  /// The relative speed with which two balls part, 0 if they do not within many periods.
  const auto parting = [&](double speed) {
    dem::Simulation<ContactLaw<Jkr<double>>> scene(law);
    scene.log = nullptr;
    scene.add(Ball{sphere(soft, radius), {-radius, 0.0, 0.0}, {speed / 2, 0.0, 0.0}});
    scene.add(Ball{sphere(soft, radius), {radius, 0.0, 0.0}, {-speed / 2, 0.0, 0.0}});
    scene.time_step = 2e-3 * std::sqrt(pair.effective_mass / stiffness);
    const double gone = 2 * radius + 1.01 * law.interaction_range(pair);
    for (int i = 0; i < 30000; ++i) {
      scene.step();
      if (scene.balls.position[1].x() - scene.balls.position[0].x() > gone)
        return scene.balls.velocity[1].x() - scene.balls.velocity[0].x();
    }
    return 0.0;
  };
  CHECK(parting(0.97 * sticking) == 0.0);
  CHECK(parting(1.03 * sticking) == Approx(std::sqrt(1.03 * 1.03 - 1) * sticking).epsilon(0.03));
  CHECK(parting(3 * sticking) == Approx(std::sqrt(8.0) * sticking).epsilon(1e-3));
}

TEST_CASE("S1: gross sliding on a wall loses mu (1 + e) v_n of tangential velocity, and never gains energy") {
  const ElasticMaterial<double> material{70e9, 0.33, 2700.0};
  const double radius = 2.5e-3, speed = 3.9;
  struct Case {
    double friction, restitution, degrees;  // from the normal; beyond the onset of gross sliding, tan = 3.5 mu (1 + e)
  };
  for (const Case& c : {Case{0.092, 0.98, 45.0}, Case{0.092, 1.0, 60.0}, Case{0.3, 0.5, 75.0}, Case{0.5, 1.0, 76.0}}) {
    CAPTURE(c.friction, c.restitution, c.degrees);
    DryHill<double, Tension::clipped> law;  // friction counts no pull, so an impact that ends without one is exact
    law.shear.friction = c.friction;
    law.damping.damping_constant = damping_constant(c.restitution, Spring::hertz, Tension::clipped);
    dem::Simulation<DryHill<double, Tension::clipped>> scene(law);
    const double angle = c.degrees * pi<double>() / 180, vn = speed * std::cos(angle), vt = speed * std::sin(angle);
    scene.add(dem::Wall{plane(material), V::Zero(), V::UnitZ()});
    scene.add(Ball{sphere(material, radius), {0.0, 0.0, radius}, {vt, 0.0, -vn}});
    scene.time_step = 1e-9;
    const auto kinetic = [&scene] {
      return (scene.balls.mass[0] * scene.balls.velocity[0].squaredNorm() +
              scene.balls.inertia[0] * scene.balls.spin[0].squaredNorm()) /
             2;
    };
    const double before = kinetic();
    do scene.step();
    while (scene.wall_contact(0).geometry.overlap > 0.0);
    const V after = scene.balls.velocity[0];
    CHECK(after.z() == Approx(c.restitution * vn).epsilon(1e-4));                  // damping is first order in the step
    CHECK(after.x() == Approx(vt - c.friction * (vn + after.z())).epsilon(1e-6));  // sliding throughout
    // The arm is R - o/2, so the spin is that of an arm R to within half the deepest overlap.
    const double shorter =
        deepest_overlap(pair_properties(plane(material), sphere(material, radius)), vn) / (2 * radius);
    const double spin = 2.5 * c.friction * (vn + after.z()) / radius;
    CHECK(scene.balls.spin[0].y() <= spin);
    CHECK(scene.balls.spin[0].y() >= spin * (1 - shorter));
    CHECK(kinetic() < before);
  }
}

TEST_CASE("S2: a sliding ball slows by mu g until it rolls at 5/7 of its speed") {
  const ElasticMaterial<double> material{1e9, 0.3, 2500.0};
  const double radius = 5e-3, friction = 0.3, gravity = 9.81, speed = 0.1;
  const auto pair = pair_properties(plane(material), sphere(material, radius));
  const double weight = gravity * pair.effective_mass;
  const double sunk =
      std::pow(weight / (4.0 / 3.0 * pair.effective_young * std::sqrt(pair.effective_radius)), 2.0 / 3.0);
  dem::Simulation<DryHill<double>> scene(test::dry_hill<double>(friction, 0.1));  // dashpots calm the start of rolling
  scene.add(dem::Wall{plane(material), V::Zero(), V::UnitZ()});
  scene.add(Ball{sphere(material, radius), {0.0, 0.0, radius - sunk}, {speed, 0.0, 0.0}});
  scene.gravity = {0.0, 0.0, -gravity};
  scene.time_step = 1e-6;
  const double rolls_at = 2 * speed / (7 * friction * gravity);
  while (scene.time < 0.9 * rolls_at) scene.step();
  const double sliding_for = scene.time - scene.time_step / 2;  // velocities are half a step old
  CHECK(scene.balls.velocity[0].x() == Approx(speed - friction * gravity * sliding_for).epsilon(1e-4));
  CHECK(scene.wall_contact(0).response.sliding);
  while (scene.time < 1.5 * rolls_at) scene.step();
  const double tolerance = 2 * sunk / radius;  // the arm is shorter than R by half the overlap
  CHECK(scene.balls.velocity[0].x() == Approx(5.0 / 7.0 * speed).epsilon(tolerance));
  CHECK(scene.balls.spin[0].y() * radius == Approx(5.0 / 7.0 * speed).epsilon(tolerance));
  CHECK_FALSE(scene.wall_contact(0).response.sliding);
}

TEST_CASE("S3: equal spheres with equal opposite spin keep both, exactly") {
  const ElasticMaterial<double> material{70e9, 0.33, 2700.0};
  const double radius = 2.5e-3;
  dem::Simulation<DryHill<double>> scene(test::dry_hill<double>(0.4, 0.1));
  const V spin(0.0, 300.0, -70.0);
  scene.add(Ball{sphere(material, radius), {-radius, 0.0, 0.0}, {3.9, 0.0, 0.0}, spin});
  scene.add(Ball{sphere(material, radius), {radius, 0.0, 0.0}, {-3.9, 0.0, 0.0}, -spin});
  scene.time_step = 1e-8;
  do scene.step();
  while (scene.ball_contact(0).geometry.overlap > 0.0);
  CHECK(scene.balls.velocity[0].x() < 0.0);
  CHECK(scene.balls.spin[0] == spin);
  CHECK(scene.balls.spin[1] == -spin);
  for (const V& v : scene.balls.velocity) {
    CHECK(v.y() == 0.0);
    CHECK(v.z() == 0.0);
  }
}

TEST_CASE("a rolling ball stops after v0 / (5/7 mu_r g) and stays") {
  const ElasticMaterial<double> material{1e8, 0.3, 2500.0};
  const double radius = 5e-3, gravity = 9.81, speed = 0.05, rolling_friction = 0.02;
  ContactLaw<Hertz<double>, Dashpots<double>, ShearForce<double>, Dry<double>, RollingSpring<double>> law;
  law.damping.damping_constant = 0.3;
  law.shear.friction = 0.5;
  law.rolling.rolling_friction = rolling_friction;
  const auto pair = pair_properties(plane(material), sphere(material, radius));
  const double stiffness = 4.0 / 3.0 * pair.effective_young * std::sqrt(radius);
  const double sunk = std::pow(gravity * pair.effective_mass / stiffness, 2.0 / 3.0);
  for (const bool along_y : {false, true}) {
    dem::Simulation<decltype(law)> scene(law);
    scene.add(dem::Wall{plane(material), V::Zero(), V::UnitZ()});
    const V direction = along_y ? V(0.0, 1.0, 0.0) : V(0.6, -0.8, 0.0);
    scene.add(Ball{sphere(material, radius),
                   {0.0, 0.0, radius - sunk},
                   speed * direction,
                   V::UnitZ().cross(direction) * speed / radius});
    scene.gravity = {0.0, 0.0, -gravity};
    scene.time_step = 1e-5;
    const double stops_at = speed / (5.0 / 7.0 * rolling_friction * gravity);
    while (scene.balls.velocity[0].dot(direction) > 0.0 && scene.time < 2.0 * stops_at) scene.step();
    // The couple grows over the first 0.3 sunk/mu_r of the way, and the arm is R - o/2: together 5e-4.
    CHECK(scene.time == Approx(stops_at).epsilon(1e-3));
    const V stopped = scene.balls.position[0];
    while (scene.time < 1.5 * stops_at) scene.step();
    CHECK((scene.balls.position[0] - stopped).norm() < sunk / rolling_friction);  // the spring's own way
  }
}

TEST_CASE("couples of a contact are opposite on its two balls") {
  ContactLaw<Hertz<double>, NoDashpots<double>, Frictionless<double>, Dry<double>, RollingSpring<double>> law;
  law.rolling.rolling_friction = 0.1;
  const ElasticMaterial<double> material{1e8, 0.3, 2500.0};
  for (const double sign : {1.0, -1.0}) {
    dem::Simulation<decltype(law)> scene(law);
    scene.add(Ball{sphere(material, 5e-3), V::Zero(), V::Zero(), {0.0, sign * 1.0, 0.0}});
    scene.add(Ball{sphere(material, 5e-3), {9.99e-3, 0.0, 0.0}, V::Zero(), {0.0, -sign * 3.0, 0.0}});
    scene.time_step = 1e-7;
    for (int i = 0; i < 10; ++i) scene.step();
    CHECK(scene.balls.torque[0] == -scene.balls.torque[1]);
    CHECK(scene.balls.torque[1].y() * sign > 0.0);  // against the relative spin of ball 1, -4 rad/s
    CHECK(scene.balls.torque[1] == scene.ball_contact(0).response.couple);
  }
}
