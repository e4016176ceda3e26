// Item 4: closed forms. Of a law alone ("D") within 1e-12; with an integrator ("I") 1e-6.
#include "contactlaws/contactlaws.hpp"
#include "contactlaws/damping/restitution.hpp"
#include "examples/dem/simulation.hpp"
#include "impact.hpp"
#include "make_laws.hpp"
#include "properties/oblique_impact.hpp"
#include "row.hpp"

using namespace contactlaws;
using namespace contactlaws::test;
using Long = long double;

namespace {

void law_alone(const std::string& name, double error, const std::string& worst = "") {
  report({4, name, error, "relative", 1e-12, 1, worst});
}
void integrated(const std::string& name, double error, const std::string& worst = "") {
  report({4, name, error, "relative", 1e-6, 1, worst});
}
double relative(Long computed, Long exact) { return static_cast<double>(std::abs(computed / exact - 1)); }

void h1() {
  const ElasticMaterial<double> oxide{380e9, 0.23, 4000}, aluminium{70e9, 0.25, 2700};
  const PairProperties<double> pair = pair_properties(sphere(oxide, 2.5e-3), plane(aluminium));
  const Long nu1 = 0.23L, nu2 = 0.25L, e1 = 380e9L, e2 = 70e9L, radius = 2.5e-3L;
  const Long young = 1 / ((1 - nu1 * nu1) / e1 + (1 - nu2 * nu2) / e2);
  const Long shear = 1 / (2 * (2 - nu1) * (1 + nu1) / e1 + 2 * (2 - nu2) * (1 + nu2) / e2);
  const Long of_force = 4 * young * std::sqrt(radius) / 3, of_shear = 8 * shear * std::sqrt(radius);
  double worst = 0.0;
  for (double overlap = 1e-12; overlap < 1e-3; overlap *= 3.7) {
    const Long root = std::sqrt(Long(overlap));
    const HertzResponse<double> response = hertz_response(pair, overlap);
    worst = std::max({worst, relative(response.force, of_force * root * overlap),
                      relative(response.stiffness, of_force * root * 3 / 2),
                      relative(Mindlin<double>{}.stiffness(pair, response), of_shear * root)});
  }
  law_alone("H1 D: Hertz's force and stiffness, Mindlin's stiffness", worst);
  const double printed =
      std::max(relative(hertz_response(pair, 1.0).force, 4.196771799e9L),
               relative(Mindlin<double>{}.stiffness(pair, hertz_response(pair, 1.0)), 5.408444289e9L));
  report({4, "H1 D: the ten printed digits", printed, "relative", 1.2e-10, 2});
}

void h2_h3() {
  const double factor = 4 * std::sqrt(pi<double>()) * std::tgamma(0.4) / (5 * std::tgamma(0.9));
  struct Case {
    const char* name;
    PairProperties<double> pair;
    double speed, overlap, force, duration;
  };
  const ElasticMaterial<double> glass{48e9, 0.20, 2800.0}, aluminium{70e9, 0.30, 2699.0};
  const Case cases[] = {
      {"two glass spheres at 20 m/s", pair_properties(sphere(glass, 10e-3), sphere(glass, 10e-3)), 20.0, 274.1127e-6,
       10.696889e3, 40.33945e-6},
      {"aluminium on a rigid plane at 0.2 m/s", pair_properties(plane(aluminium).rigid(), sphere(aluminium, 100e-3)),
       0.2, 49.71718e-6, 11.369858e3, 731.6566e-6}};
  for (const Case& c : cases) {
    const double deepest = std::pow(15 * c.pair.effective_mass * c.speed * c.speed /
                                        (16 * c.pair.effective_young * std::sqrt(c.pair.effective_radius)),
                                    0.4);
    const Impact impact = integrate_impact(SmoothHertz<double>{}, c.pair, c.speed, 20000, factor * deepest / c.speed);
    integrated(std::string("H2 I: largest overlap and duration, ") + c.name,
               std::max(relative(impact.deepest, deepest), relative(impact.duration, factor * deepest / c.speed)));
    integrated(std::string("H3 I: the seven printed digits, ") + c.name,
               std::max({relative(impact.deepest, c.overlap), relative(impact.largest_force, c.force),
                         relative(impact.duration, c.duration)}));
  }
}

template <Tension tension>
void t1(const std::string& name) {
  const ElasticMaterial<double> aluminium{70e9, 0.30, 2699.0};
  const auto pair = pair_properties(plane(aluminium).rigid(), sphere(aluminium, 5e-3));
  double of_hertz = 0.0, of_linear = 0.0;
  std::string hertz_at, linear_at;
  for (const double e : {0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 0.9, 0.98, 1.0}) {
    for (const double speed : {1e-6, 1e-3, 0.2, 5.0, 100.0}) {
      const double deepest = std::pow(
          15 * pair.effective_mass * speed * speed / (16 * pair.effective_young * std::sqrt(pair.effective_radius)),
          0.4);
      ContactLaw<Hertz<double>, Dashpots<double, tension>> hertz;
      hertz.damping.damping_constant = damping_constant(e, Spring::hertz, tension);
      ContactLaw<LinearSpring<double>, Dashpots<double, tension>> linear;
      linear.normal.normal_stiffness = 1e7;
      linear.damping.damping_constant = damping_constant(e, Spring::linear, tension);
      const auto see = [&](double& worst, std::string& at, double realised) {
        if (std::abs(realised - e) <= worst) return;
        worst = std::abs(realised - e);
        at = text_of("e = ", e, " at ", speed, " m/s");
      };
      see(of_hertz, hertz_at, integrate_impact(hertz, pair, speed, 20000, 3 * deepest / speed).restitution);
      see(of_linear, linear_at,
          integrate_impact(linear, pair, speed, 20000, 3.2 * std::sqrt(pair.effective_mass / 1e7)).restitution);
    }
  }
  integrated("T1 I: restitution as asked, Hertz, " + name, of_hertz, hertz_at);
  integrated("T1 I: restitution as asked, linear, " + name, of_linear, linear_at);
}

using Vector = Vec3<double>;

/// S1: a sphere that slides throughout an oblique impact on a wall.
void s1() {
  const ElasticMaterial<double> material{70e9, 0.33, 2700.0};
  struct Case {
    double friction, restitution, degrees;
  };
  double worst = 0.0, most_energy = 0.0;
  std::string at;
  for (const Case& c : {Case{0.092, 0.98, 45.0}, Case{0.092, 1.0, 60.0}, Case{0.3, 0.5, 75.0}, Case{0.5, 1.0, 76.0}}) {
    DryHill<double, Tension::clipped> law;
    law.shear.friction = c.friction;
    law.damping.damping_constant = damping_constant(c.restitution, Spring::hertz, Tension::clipped);
    dem::Simulation<DryHill<double, Tension::clipped>> scene(law);
    const double angle = c.degrees * pi<double>() / 180, vn = 3.9 * std::cos(angle), vt = 3.9 * std::sin(angle);
    scene.add(dem::Wall{plane(material), Vector::Zero(), Vector::UnitZ()});
    scene.add(dem::Ball{sphere(material, 2.5e-3), {0.0, 0.0, 2.5e-3}, {vt, 0.0, -vn}});
    scene.time_step = 2e-9;
    const double inertia = scene.balls.inertia[0], mass = scene.balls.mass[0];
    do scene.step();
    while (scene.wall_contact(0).geometry.overlap > 0.0);
    const Vector after = scene.balls.velocity[0];
    const double error = relative(after.x(), vt - c.friction * (vn + after.z()));
    const double energy = (after.squaredNorm() + inertia / mass * scene.balls.spin[0].squaredNorm()) / (3.9 * 3.9);
    most_energy = std::max(most_energy, energy);
    if (error <= worst) continue;
    worst = error;
    at = text_of("mu ", c.friction, ", e ", c.restitution, ", ", c.degrees, " degrees");
  }
  integrated("S1 I: gross sliding, tangential velocity lost = mu times normal momentum", worst, at);
  report({4, "S1 I: kinetic energy after over before, gross sliding", most_energy, "of 1", 1.0, 4, ""});
}

/// S2: a ball set down sliding.
void s2() {
  const ElasticMaterial<double> material{1e9, 0.3, 2500.0};
  const double radius = 5e-3, friction = 0.3, gravity = 9.81, speed = 0.1;
  const auto pair = pair_properties(plane(material), sphere(material, radius));
  const double sunk = std::pow(
      gravity * pair.effective_mass / (4.0 / 3.0 * pair.effective_young * std::sqrt(pair.effective_radius)), 2.0 / 3.0);
  dem::Simulation<DryHill<double>> scene(test::dry_hill<double>(friction, 0.1));
  scene.add(dem::Wall{plane(material), Vector::Zero(), Vector::UnitZ()});
  scene.add(dem::Ball{sphere(material, radius), {0.0, 0.0, radius - sunk}, {speed, 0.0, 0.0}});
  scene.gravity = {0.0, 0.0, -gravity};
  scene.time_step = 1e-6;
  const double rolls_at = 2 * speed / (7 * friction * gravity);
  // The first step presses without slip, the first force being of half a step: compare what one stretch of sliding takes.
  while (scene.time < 0.2 * rolls_at) scene.step();
  const double first = scene.balls.velocity[0].x(), from = scene.time;
  while (scene.time < 0.8 * rolls_at) scene.step();
  const double slowed = first - scene.balls.velocity[0].x();
  integrated("S2 I: sliding slows by mu g t", relative(slowed, friction * gravity * (scene.time - from)));
  while (scene.time < 2 * rolls_at) scene.step();
  // The angular momentum about the contact point stays; the arm is R - o/2, not R.
  const double arm = radius - sunk / 2;
  const double rolling = speed / (1 + 2.0 / 5.0 * radius * radius / (arm * arm));
  integrated("S2 I: rolls at 5/7 of its speed (5/7 for the arm R - o/2)",
             relative(scene.balls.velocity[0].x(), rolling));
}

void s3() {
  const ElasticMaterial<double> material{70e9, 0.33, 2700.0};
  dem::Simulation<DryHill<double>> scene(test::dry_hill<double>(0.4, 0.1));
  const Vector spin(0.0, 300.0, -70.0);
  scene.add(dem::Ball{sphere(material, 2.5e-3), {-2.5e-3, 0.0, 0.0}, {3.9, 0.0, 0.0}, spin});
  scene.add(dem::Ball{sphere(material, 2.5e-3), {2.5e-3, 0.0, 0.0}, {-3.9, 0.0, 0.0}, -spin});
  scene.time_step = 1e-8;
  do scene.step();
  while (scene.ball_contact(0).geometry.overlap > 0.0);
  double off = (scene.balls.spin[0] - spin).norm() + (scene.balls.spin[1] + spin).norm();
  for (const Vector& v : scene.balls.velocity) off += std::abs(v.y()) + std::abs(v.z());
  report({4, "S3 I: equal and opposite spins and tangential velocities unchanged", off, "rad/s and m/s", 0.0, 1});
}

/// E1: what a loop of slip S at o1 and back at o2 extracts from the shear spring.
template <class Shear>
double extracted(double o1, double o2, double slip) {
  ContactLaw<Hertz<double>, NoDashpots<double>, Shear> law;
  law.shear.friction = 1e9;
  const PairProperties<double> pair = granite_pair<double>();
  typename decltype(law)::State state{};
  double work = 0.0, last = 0.0;
  for (const auto& [overlap, distance] : {std::pair(o1, 0.0), {o1, slip}, {o2, 0.0}, {o2, -slip}, {o1, 0.0}}) {
    const auto step = law.step(pair, {{0, 0, 1}, overlap, {distance, 0, 0}, 1.0}, state);
    work += (last + step.force.x()) / 2 * distance;
    last = step.force.x();
    state = step.state;
  }
  return work;
}

void e1() {
  const double slip = 1e-6;
  double worst = 0.0;
  for (const auto& [o1, o2] : {std::pair(1e-4, 0.5e-4), {0.5e-4, 1e-4}, {1e-5, 3e-7}}) {
    const Long pair_stiffness =
        8 * Long(granite_pair<double>().effective_shear) * std::sqrt(Long(granite_pair<double>().effective_radius));
    const Long k1 = pair_stiffness * std::sqrt(Long(o1)), k2 = pair_stiffness * std::sqrt(Long(o2));
    const Long expected = (k1 - k2) * slip * slip / 2;
    worst = std::max({worst, relative(extracted<ShearForce<double>>(o1, o2, slip), expected),
                      relative(extracted<ShearDisplacement<double>>(o1, o2, slip), -expected)});
  }
  law_alone("E1 D: energy extracted by a closed loop, force and displacement", worst);
}

void p1() {
  const RoughSurface<double> surface{2.13, 26.1e-6};
  const auto law = PohrtPopovElastoPlastic<double>::of(surface);
  const PairProperties<double> pair{2.36e-3, 32e9, 1.0, 1.0, 2.36e-3, 2.36e-3};
  const auto at = [&](double overlap, double largest = 0.0) {
    PohrtPopovElastoPlastic<double>::State state{largest};
    return law.respond(state, pair, overlap);
  };
  const double transition = law.transition_overlap;
  double slope = 0.0, inverse = 0.0, loop = 0.0, unloaded = 0.0;
  for (double share = 1e-6; share < 0.5; share *= 2.3) {
    const auto low = at(share * transition), high = at(2 * share * transition);
    const Long exponent = std::log(Long(high.stiffness) / low.stiffness) / std::log(Long(high.force) / low.force);
    slope = std::max(slope, relative(exponent, 0.2567L * 2.13L));
    const double overlap = share * transition, depth = law.indentation(overlap).depth;
    inverse = std::max(inverse, relative(law.overlap_of(depth), overlap));
    // Work: F o / (3/2 p + 1) while loading, 2/5 F d back.
    const Long expected = Long(low.force) * (Long(overlap) / (1.5L * law.exponent + 1) - 0.4L * depth);
    loop = std::max(loop, relative(law.plastic_dissipation({overlap}, pair), expected));
    unloaded = std::max(unloaded, at(law.plastic_overlap({overlap}), overlap).force / low.force);
  }
  law_alone("P1 D: d ln k / d ln F = beta", slope);
  law_alone("P1 D: overlap(force(overlap))", inverse);
  law_alone("P1 D: area of a loop of loading and unloading", loop);
  law_alone("P1 D: force left at the plastic overlap", unloaded);
  const double below = std::nextafter(transition, 0.0);
  law_alone("P1 D: force continuous at F_c", relative(at(below).force, at(transition).force));
  law_alone("P1 D: stiffness continuous at F_c", relative(at(below).stiffness, at(transition).stiffness));
  const auto smooth = PohrtPopov<double>::of({2.13, 1e-25});
  PohrtPopov<double>::State none;
  law_alone("P1 D: no roughness is Hertz",
            relative(smooth.respond(none, pair, 1e-6).force, hertz_response(pair, 1e-6).force));
}

void b1() {
  const SuctionBridge<double> bridge{2e5, 0.7, 1.8};
  const PairProperties<double> pair = granite_pair<double>();
  const auto pull = [&](double gap) {
    SuctionBridge<double>::State wet{2.0};
    return bridge.respond(wet, pair, -gap).force;
  };
  law_alone("B1 D: continuous at touch", relative(pull(1e-300), pull(0.0)));
  const Long rupture = bridge.range(pair), decay = 0.7L * pair.min_radius, most = bridge.largest_force(pair);
  const int n = 20000;  // Simpson's rule: (rupture/decay)^4 / (180 n^4) = 1e-18
  Long work = 0;
  for (int i = 0; i <= 2 * n; ++i) {
    const Long gap = rupture * i / (2 * n);
    const Long force = i == 2 * n ? most * std::exp(-rupture / decay) : Long(pull(static_cast<double>(gap)));
    work += force * (i == 0 || i == 2 * n ? 1 : i % 2 == 1 ? 4 : 2);
  }
  work *= rupture / (6 * n);
  SuctionBridge<double>::State wet{2.0};
  law_alone("B1 D: work to rupture is the integral of the force", relative(-bridge.energy(wet, pair, 0.0), work));
  int formed_again = 0;
  bridge.respond(wet, pair, -bridge.range(pair));
  for (const double gap : {1e-3, 0.0, -1e-5, 5e-3}) formed_again += bridge.respond(wet, pair, -gap).force != 0.0;
  report({4, "B1 D: forces of a bridge that has ruptured", static_cast<double>(formed_again), "of 4", 0.0, 4});
}

/// The laws beyond the two documents, each by a closed form of its source.
void added_laws() {
  const PairProperties<double> pair = granite_pair<double>();
  const Long root = std::sqrt(Long(pair.effective_radius)), pull = 3 * pi<Long>() * 50 * pair.effective_radius / 2;
  const Jkr<double> jkr{50.0};
  Jkr<double>::State holds{1.0};
  law_alone(
      "A1 D: JKR pulls 3/2 pi w R*, and 8/9 of it at touch",
      std::max(relative(jkr.pull_off_force(pair), pull), relative(-jkr.respond(holds, pair, 0.0).force, 8 * pull / 9)));

  // Luding: unloading gives back F^2/(2 k_2) of F = k_1 o_m, with k_2 grown halfway at half of the plastic depth.
  const LinearHysteretic<double> luding{1e6, 5e6, 0.0, 1e-2};
  const Long plastic = 2 * 1e-2L * pair.effective_radius * 5 / 4, deep = plastic / 2, stiffness = 1e6L + 4e6L / 2;
  LinearHysteretic<double>::State loaded{static_cast<double>(deep)};
  law_alone("Y1 D: Luding's line of unloading holds k_1^2 o_m^2/(2 k_2)",
            relative(luding.energy(loaded, pair, static_cast<double>(deep)), 1e12L * deep * deep / (2 * stiffness)));
  const ThorntonNing<double> yields{1e9};
  const Long ratio = pi<Long>() * 1e9L / (2 * Long(pair.effective_young)),
             start = pair.effective_radius * ratio * ratio;
  ThorntonNing<double>::State fresh{};
  law_alone("Y2 D: Thornton-Ning beyond yield, pi p_y R* (o - o_y/3)",
            relative(yields.respond(fresh, pair, static_cast<double>(10 * start)).force,
                     pi<Long>() * 1e9L * pair.effective_radius * (10 * start - start / 3)));

  // Partial slip at a constant load: mu P (1 - (1 - s/s_max)^(3/2)).
  ContactLaw<Hertz<double>, NoDashpots<double>, MindlinDeresiewicz<double>> slips;
  slips.shear.friction = 0.4;
  const double overlap = 1e-4;
  const Long load = 4 * Long(pair.effective_young) / 3 * root * std::pow(Long(overlap), 1.5L);
  const Long most = 3 * 0.4L * load / (16 * Long(pair.effective_shear) * root * std::sqrt(Long(overlap)));
  double worst = 0.0;
  for (const double share : {0.1, 0.5, 0.9}) {
    auto state = decltype(slips)::State{};
    state = slips.step(pair, {{0, 0, 1}, overlap, {0, 0, 0}, 1.0}, state).state;
    const double slip = static_cast<double>(share * most);
    const Vector force = slips.step(pair, {{0, 0, 1}, overlap, {slip, 0, 0}, 1.0}, state).force;
    worst = std::max(worst, relative(-force.x(), 0.4L * load * (1 - std::pow(1 - slip / most, 1.5L))));
  }
  law_alone("M1 D: partial slip at a constant load is Mindlin's curve", worst);

  // Rolling and twisting: springs below their limits.
  using Couples = RollAndTwist<double, RollingSpring<double>, TwistingSpringDashpot<double>>;
  ContactLaw<Hertz<double>, NoDashpots<double>, Frictionless<double>, Dry<double>, Couples> turns;
  turns.rolling.rolling_friction = 0.1;
  turns.rolling.twisting_friction = 0.4;
  const Vector couple = turns.step(pair, {{0, 0, 1}, overlap, {0, 0, 0}, 1.0, 0.0, {1e-5, 0, 1e-5}}, {}).couple;
  const Long a = root * std::sqrt(Long(overlap)), arm = 0.1L * pair.effective_radius;
  law_alone("R1 D: 9/4 k_n (mu_r R*)^2 against rolling, 4 G* a^3 against twisting",
            std::max(relative(-couple.x(), 9 * 2 * Long(pair.effective_young) * a * arm * arm / 4 * 1e-5L),
                     relative(-couple.z(), 4 * Long(pair.effective_shear) * a * a * a * 1e-5L)));
}

/// N1: the moments of F on body 2 and -F on body 1, at the contact point, cancel about any point.
void n1(std::int64_t count) {
  Random random;
  double worst = 0.0;
  for (std::int64_t i = 0; i < count; ++i) {
    const double radius1 = random.log_uniform(1e-4, 1.0), radius2 = random.log_uniform(1e-4, 1.0);
    const Vector x1 = random.direction(), x2 = x1 + (radius1 + radius2) * random.uniform(0.9, 1.1) * random.direction(),
                 f = random.direction();
    const auto geometry = sphere_sphere<double>(x1, radius1, x2, radius2);
    const Vector moment = (x2 + geometry.arm2 - x1 - geometry.arm1).cross(f);
    worst = std::max(worst, moment.norm() / (x1.norm() + x2.norm() + radius1 + radius2));
  }
  report({4, "N1 I: torque balance", worst, "of force times distance", 1e-12, count});
}

}  // namespace

int main(int argc, char** argv) {
  const Effort effort(argc, argv);
  h1();
  h2_h3();
  t1<Tension::allowed>("tension allowed");
  t1<Tension::clipped>("tension clipped");
  s1();
  s2();
  s3();
  report({4, "oblique impact, spins at 10, 30, 45 and 60 degrees, by shear history", ObliqueImpact{}.worst_error(1e-10),
          "relative", 1e-4, 7, "", "figures of an independent integration, of six or seven digits"});
  e1();
  p1();
  b1();
  added_laws();
  n1(effort(100000, 10000000));
}
