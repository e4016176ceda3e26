// The checks on laws of the library: each has the properties it claims, and the ones it lacks are found.
#include "contactlaws/verify/verify.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include "catch.hpp"
#include "contact_path/path_file.hpp"
#include "contactlaws/contactlaws.hpp"
#include "make_laws.hpp"

using namespace contactlaws;
using verify::Claims, verify::ForceUpdate, verify::Options, verify::Report, verify::Verdict;

namespace {

const ElasticMaterial<double> granite{29e9, 0.15, 2650.0};
const PairProperties<double> pair = pair_properties(sphere(granite, 7.5e-3), sphere(granite, 5e-3));

/// The memo's grains, 10 um deep.
Options options(const Claims& claims) {
  Options o;
  o.radius1 = 7.5e-3;
  o.radius2 = 5e-3;
  o.mass1 = sphere_mass(7.5e-3, 2650.0);
  o.mass2 = sphere_mass(5e-3, 2650.0);
  o.overlap = 1e-5;
  o.claims = claims;
  o.paths = 50;
  return o;
}

template <class Law>
Report check(const Law& law, const Claims& claims, const typename Law::State& first = {}) {
  return verify::check_all(verify::adapt(law, pair, first), options(claims));
}

std::vector<std::string> failures(const Report& report) {
  std::vector<std::string> names;
  for (const auto& result : report.results)
    if (result.verdict == Verdict::fail) names.push_back(result.property);
  return names;
}
using Names = std::vector<std::string>;

const verify::Scales scales{1e-5, 12.5e-3, 1.0, 1e-4, 0.0};  // of the random paths that are tested alone

/// What every law of the library without a bridge claims.
Claims claims_of(double friction) {
  Claims claims;
  claims.friction = friction;
  claims.range = 0.0;
  claims.continuous_at_touch = true;
  return claims;
}

}  // namespace

TEST_CASE("The named laws have the properties they claim") {
  Claims claims = claims_of(0.4);
  claims.continuous_in_motion = true;
  claims.restitution = 0.7;
  DryHillProperties<double> dry;
  dry.friction = 0.4;
  dry.damping_constant = damping_constant(0.7, Spring::hertz, Tension::allowed);
  CHECK(failures(check(dry_hill(dry), claims)) == Names{});
  const EffectiveModuli<double> moduli{pair.effective_young, pair.effective_shear};
  CHECK(failures(check(dry_hill(dry, moduli), claims)) == Names{});
  claims.no_tension = true;
  dry.damping_constant = damping_constant(0.7, Spring::hertz, Tension::clipped);
  CHECK(failures(check(dry_hill<Tension::clipped>(dry), claims)) == Names{});

  SECTION("Hill, wet: the bridge pulls from the start, and costs energy to break") {
    const Hill<double> law = test::hill<double>(0.4, 2e5, 0.07);
    Hill<double>::State wet{};
    Hill<double>::make_wet(wet, 0.0, 0.0);
    Claims sticky = claims_of(0.4);
    sticky.range = law.interaction_range(pair);
    const Report report = check(law, sticky, wet);
    CHECK(failures(report) == Names{});
    CHECK(report.find("no tension")->verdict == Verdict::not_claimed);
    sticky.no_tension = true;
    CHECK(failures(check(law, sticky, wet)) == Names{"no tension"});
  }
  SECTION("RoughBallast") {
    Claims rough = claims_of(0.7);
    rough.no_tension = rough.continuous_in_motion = true;
    RoughBallastProperties<double> ballast;
    ballast.fractal_dimension = 2.13;
    ballast.roughness = 26.1e-6;
    ballast.friction = 0.7;
    ballast.stiffness_ratio = mindlin_ratio(pair);
    CHECK(failures(check(rough_ballast(ballast), rough)) == Names{});
  }
  SECTION("LinearSpringDashpot: its dashpots start with a jump, and it makes no energy") {
    Claims linear = claims_of(0.4);
    linear.passive = linear.no_ratcheting = linear.no_tension = true;
    linear.restitution = 0.7;
    LinearSpringDashpotProperties<double> properties;
    properties.normal_stiffness = 1e6;
    properties.friction = 0.4;
    properties.stiffness_ratio = 0.6;
    properties.damping_constant = damping_constant(0.7, Spring::linear, Tension::clipped);
    const auto law = linear_spring_dashpot<Tension::clipped>(properties);
    CHECK(failures(check(law, linear)) == Names{});
    linear.continuous_in_motion = true;
    CHECK(failures(check(law, linear)) == Names{"continuity in motion"});
  }
}

TEST_CASE("Adhesion counts as friction load, and an adhesive contact ends at its range") {
  using Law = ContactLaw<Dmt<double>, NoDashpots<double>, ShearForce<double>>;
  Law law;
  law.normal.work_of_adhesion = 10.0;  // F_c = 0.2 N beside 40 N at the usual overlap
  law.shear.friction = 0.4;
  Claims claims = claims_of(0.4);
  claims.range = law.interaction_range(pair);
  claims.adhesion = law.normal.pull_off_force(pair);
  claims.continuous_at_touch = false;
  CHECK(failures(check(law, claims)) == Names{});
  claims.adhesion *= 1.01;
  CHECK(failures(check(law, claims)) == Names{"friction reached"});
  claims.adhesion *= 0.98;
  CHECK(failures(check(law, claims)) == Names{"Coulomb bound", "friction reached"});
  claims = claims_of(0.0);
  claims.friction.reset();
  claims.no_tension = true;
  CHECK(failures(check(law, claims)) == Names{"no tension", "continuity at touch"});
}

TEST_CASE("A rolling spring: its couple balances, turns, is swapped and scaled with the pair, and makes no energy") {
  using Rolling = RollingSpring<double>;
  ContactLaw<LinearSpring<double>, NoDashpots<double>, ShearForce<double, ConstantRatio<double>>, Dry<double>, Rolling>
      law;
  law.normal.normal_stiffness = 1e6;
  law.shear.friction = 0.4;
  law.shear.ratio = 0.6;
  law.rolling.rolling_friction = 0.1;
  Claims claims = claims_of(0.4);
  claims.couple_turns = claims.passive = claims.no_ratcheting = claims.no_tension = true;
  CHECK(failures(check(law, claims)) == Names{});

  ForceUpdate alone(verify::adapt(law, pair));
  alone.in_units = {};
  alone.step = [step = alone.step](const verify::Bodies& b, double dt, ForceUpdate::State& state) {
    verify::Interaction i = step(b, dt, state);
    const double arm = b.one.radius - (b.length() - b.branch().norm()) / 2;
    i.torque1 = verify::Vector(b.branch().normalized().cross(i.force) * -arm);  // that of the force, without the couple
    return i;
  };
  CHECK(failures(verify::check_all(alone, options(claims))) == Names{"torque balance", "swap of the bodies"});
}

TEST_CASE("Static and kinetic friction, and a shear dashpot of its own") {
  using Shear = ShearDisplacement<double, Mindlin<double>, rotation::ProjectRestore<double>, StaticKinetic<double>>;
  using Damping = Dashpots<double, Tension::clipped, ShearDashpot::given>;
  ContactLaw<Hertz<double>, Damping, Shear> law;
  law.damping.damping_constant = damping_constant(0.7, Spring::hertz, Tension::clipped);
  law.damping.shear_damping_constant = 0.9;
  law.shear.friction = 0.4;
  law.shear.static_friction = 0.6;
  Claims claims = claims_of(0.4);
  claims.restitution = 0.7;
  claims.static_friction = 0.6;
  claims.no_ratcheting = claims.no_tension = claims.continuous_in_motion = true;
  CHECK(failures(check(law, claims)) == Names{});
}

namespace {

template <class Shear>
void check_shear(const Shear& shear, bool passive, bool passive_impacts, bool no_ratcheting, bool follows_twist) {
  ContactLaw<Hertz<double>, NoDashpots<double>, Shear> law;
  law.shear = shear;
  Claims claims = claims_of(0.4);
  claims.no_tension = claims.continuous_in_motion = true;
  claims.passive = claims.no_ratcheting = claims.follows_twist = true;
  Names expected;  // the properties that this variant lacks
  if (!follows_twist) expected.push_back("rigid twist");
  if (!no_ratcheting) expected.push_back("ratcheting");
  if (!passive) expected.push_back("energy on closed loops");
  if (!passive_impacts) expected.push_back("energy of impacts");
  INFO(Shear::name);
  CHECK(failures(check(law, claims)) == expected);
}

template <template <class, class, class, class> class Shear, class Rotation>
void check_rotation(bool passive, bool passive_impacts, bool no_ratcheting, bool follows_twist) {
  Shear<double, Mindlin<double>, Rotation, Coulomb<double>> shear;
  shear.friction = 0.4;
  check_shear(shear, passive, passive_impacts, no_ratcheting, follows_twist);
}
template <template <class, class, class, class> class Shear>
void check_history(bool passive, bool passive_impacts, bool no_ratcheting) {
  check_rotation<Shear, rotation::Project<double>>(passive, passive_impacts, no_ratcheting, false);
  check_rotation<Shear, rotation::ProjectRestore<double>>(passive, passive_impacts, no_ratcheting, false);
  check_rotation<Shear, rotation::Rotate<double>>(passive, passive_impacts, no_ratcheting, true);
}

}  // namespace

TEST_CASE("Every shear variant has the properties it claims, and no others") {
  // Which yield energy on loops: tests/composition/test_energy.cpp, in closed form. A displacement alone comes back after a
  // cycle; without dashpots, its energy on a stiffness that grows shows in impacts as well.
  check_history<ShearForce>(false, true, false);
  check_history<ShearForceRescaled>(true, true, false);
  check_history<ShearDisplacement>(false, false, true);
  check_history<ShearDisplacementRescaled>(false, true, false);
}

TEST_CASE("Restitution is checked to 1e-3") {
  Claims claims = claims_of(0.0);
  const DryHill<double> law = test::dry_hill<double>(0.0, damping_constant(0.7, Spring::hertz, Tension::allowed));
  for (const double off : {-2e-3, -5e-4, 5e-4, 2e-3}) {
    claims.restitution = 0.7 + off;
    CHECK(failures(check(law, claims)).empty() == (std::abs(off) < 1e-3));
  }
}

TEST_CASE("Impacts of the kit: gross sliding in closed form, and nothing gained where springs alone act") {
  // Impulses J_n = m* (1 + e) v_n and J_t = mu J_n; spins R J_t / I, solid spheres.
  const double friction = 0.3, speed = 0.01, angle = 75 * pi<double>() / 180;
  const auto law = [](double mu) {
    LinearSpringDashpotProperties<double> properties;
    properties.normal_stiffness = 1e6;
    properties.friction = mu;
    properties.stiffness_ratio = 0.6;
    return ForceUpdate(verify::adapt(linear_spring_dashpot(properties), pair));
  };
  const ForceUpdate slippery = law(friction), sticky = law(100.0);
  const verify::Setup slides(slippery, options({})), sticks(sticky, options({}));
  const double m1 = slides.options.mass1, m2 = slides.options.mass2, mass = m1 * m2 / (m1 + m2);
  const double vn = speed * std::cos(angle), vt = speed * std::sin(angle), jt = friction * 2 * mass * vn;
  const double moved = (m1 + m2) / 2 * std::pow(m2 * speed / (m1 + m2), 2);  // with the common centre of mass
  const double relative = mass / 2 * (vn * vn + std::pow(vt - jt / mass, 2)), spins = jt * jt / (2 * 0.4 * mass);
  const auto impact = verify::detail::collide(slides, speed, angle, 20000);
  CHECK(impact.energy_before == Approx(m2 / 2 * speed * speed).epsilon(1e-14));
  // In 20 000 steps, of which the first and the last are off by a half; the line of centres turns by 1e-4.
  CHECK(impact.energy_after == Approx(moved + relative + spins).epsilon(2e-4));
  CHECK(impact.rebound == Approx(1.0).epsilon(1e-3));
  for (const double slanted : {0.3, 0.8, 1.3}) {
    const auto elastic = verify::detail::collide(sticks, slides.scales.speed(), slanted, 20000);
    // A spring sheared when the contact opens keeps its energy to itself: none is gained.
    CHECK(elastic.energy_after <= elastic.energy_before * (1 + 1e-6));
  }
}

TEST_CASE("A stiffness is that of the branch that is active, not of the steeper one") {
  ContactLaw<PohrtPopovElastoPlastic<double>> law;
  law.normal = PohrtPopovElastoPlastic<double>::of({2.13, 26.1e-6});
  ForceUpdate max_tangent(verify::adapt(law, pair));
  max_tangent.stiffness = [law](const verify::Bodies& b, const ForceUpdate::State& values) {
    const double overlap = b.one.radius + b.two.radius - b.branch().norm();
    return law.stiffness(pair, overlap, std::any_cast<decltype(law)::State>(values));
  };
  CHECK(failures(verify::check_all(max_tangent, options({}))) == Names{"derivative = stiffness"});
}

TEST_CASE("A law in float is allowed its own rounding") {
  const ElasticMaterial<float> rock{29e9f, 0.15f, 2650.0f};
  const auto of_rock = pair_properties(sphere(rock, 7.5e-3f), sphere(rock, 5e-3f));
  const ForceUpdate law(verify::adapt(test::dry_hill<float>(0.4), of_rock));
  Options o = options(claims_of(0.4));
  CHECK_FALSE(verify::check_all(law, o).passed());
  o.epsilon = std::numeric_limits<float>::epsilon();
  CHECK(failures(verify::check_all(law, o)) == Names{});
}

TEST_CASE("A loop that yields energy is reduced to one that our own ledger books the same way") {
  Claims claims = claims_of(0.4);
  claims.passive = true;
  const DryHill<double> law = test::dry_hill<double>(0.4);
  const Report report = check(law, claims);
  REQUIRE(failures(report) == Names{"energy on closed loops"});
  const verify::Path& path = report.find("energy on closed loops")->path;
  CHECK(path.size() <= 6);  // close, shear, half open, shear back, open: with one overlap on the way
  EnergyLedger<double> ledger;
  DryHill<double>::State state{};
  for (const auto& motion : verify::refined(path, 64)) {
    const auto step = law.step(pair, motion, state);
    ledger.enter(law, pair, motion, step);
    state = step.state;
  }
  CHECK(ledger.stored == 0.0);
  CHECK(ledger.dissipated() < 0.0);
}

TEST_CASE("PATH.csv: contact_path reads what is written, bit by bit") {
  verify::Random random(7);
  const verify::Path path = verify::random_path(random, scales);
  const std::string file = (std::filesystem::temp_directory_path() / "contactlaws_test_verify.csv").string();
  std::ofstream out(file);
  verify::write_path(out, path);
  out.close();
  const auto again = contact_path::read_path<double>(file);
  REQUIRE(again.size() == path.size());
  for (std::size_t i = 0; i < path.size(); ++i) {
    const auto& motion = again[i].kinematics;
    CHECK(motion.dt == path[i].dt);
    CHECK(motion.overlap == path[i].overlap);
    CHECK((motion.normal - path[i].normal).norm() < 3e-16);  // scaled to unit length again
    CHECK(motion.velocity == path[i].velocity);
    CHECK(motion.normal_spin == path[i].normal_spin);
    CHECK(motion.relative_spin == path[i].relative_spin);
  }
  std::filesystem::remove(file);
}

TEST_CASE("The bodies of a path move as it says, and their centres follow their velocities") {
  verify::Random random(11);
  const Options o = options({});
  const verify::Path path = verify::refined(verify::random_path(random, scales), 1000);
  const verify::Trajectory trajectory = verify::trajectory(path, o);
  for (std::size_t i = 1; i < trajectory.size(); ++i) {
    const auto& [one, two] = trajectory[i].bodies;
    const auto motion = contact_kinematics<double>(
        sphere_sphere<double>(one.position, o.radius1, two.position, o.radius2), {one.position, one.velocity, one.spin},
        {two.position, two.velocity, two.spin}, trajectory[i].dt);
    const double fastest = two.velocity.norm() + 0.0125 * (one.spin.norm() + two.spin.norm());
    // Overlaps are differences of lengths of 12.5 mm, velocities of parts as large as these: some ten roundings each.
    CHECK(std::abs(motion.overlap - path[i].overlap) <= 10 * 0.0125 * 2.3e-16);
    CHECK((motion.velocity - path[i].velocity).norm() <= 20 * fastest * 2.3e-16);
    // The step's own turn, 5e-5 rad at most, is the error of a straight step.
    const verify::Vector moved = trajectory[i].bodies.branch() - trajectory[i - 1].bodies.branch();
    CHECK((moved - (two.velocity - one.velocity) * trajectory[i].dt).norm() <= 1e-4 * moved.norm() + 1e-16);
  }
}

TEST_CASE("Options and claims out of range are rejected before any check, by name, value and range") {
  int calls = 0;
  ForceUpdate law(verify::adapt(test::dry_hill<double>(0.4), pair));
  law.step = [&calls, step = law.step](const verify::Bodies& b, double dt, ForceUpdate::State& state) {
    ++calls;
    return step(b, dt, state);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto message = [&law](const auto& change) -> std::string {
    Options o = options(claims_of(0.4));
    change(o);
    try {
      verify::check_all(law, o);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "none";
  };
  CHECK(message([](Options& o) { o.mass2 = -1.0; }) == "verify::Options: mass2 is -1 kg, must lie in (0, inf)");
  CHECK(message([](Options& o) { o.radius1 = 0.0; }) == "verify::Options: radius1 is 0 m, must lie in (0, inf)");
  CHECK(message([&](Options& o) { o.overlap = nan; }) == "verify::Options: overlap is nan m, must lie in (0, 0.005)");
  CHECK(message([](Options& o) { o.overlap = 0.005; }) ==
        "verify::Options: overlap is 0.005 m, must lie in (0, 0.005)");
  CHECK(message([](Options& o) { o.paths = 0; }) == "verify::Options: paths is 0, must lie in [1, inf)");
  CHECK(message([&](Options& o) { o.epsilon = nan; }) == "verify::Options: epsilon is nan, must lie in (0, 0.001]");
  CHECK(message([&](Options& o) { o.claims.friction = nan; }) ==
        "verify::Options: claims.friction is nan, must lie in [0, inf)");
  CHECK(message([](Options& o) { o.claims.static_friction = 0.3; }) ==
        "verify::Options: claims.static_friction is 0.3, must lie in [0.4, inf)");
  CHECK(message([](Options& o) { o.claims.friction.reset(), o.claims.static_friction = 0.5; }) ==
        "verify::Options: claims.static_friction needs claims.friction, the kinetic coefficient");
  CHECK(message([](Options& o) { o.claims.restitution = 1.5; }) ==
        "verify::Options: claims.restitution is 1.5, must lie in [0, 1]");
  CHECK(message([](Options& o) { o.claims.range = -1e-6; }) ==
        "verify::Options: claims.range is -1e-06 m, must lie in [0, inf)");
  CHECK(message([&](Options& o) { o.claims.adhesion = nan; }) ==
        "verify::Options: claims.adhesion is nan N, must lie in [0, inf)");
  CHECK(message([](Options& o) { o.folder = "/not/there"; }) ==
        "verify::Options: folder is '/not/there', must be an existing folder");
  CHECK(calls == 0);

  law.step = [](const verify::Bodies&, double, ForceUpdate::State&) {
    return verify::Interaction{verify::Vector(0, 0, 0), {}, {}, {}};
  };
  CHECK_THROWS_WITH(verify::check_all(law, options({})), ContainsSubstring("force at the overlap is 0 N"));
}

TEST_CASE("A report is a line per property, and its failures are files") {
  const auto folder = std::filesystem::temp_directory_path() / "contactlaws_test_verify";
  std::filesystem::create_directories(folder);
  Options o = options({});
  o.claims.passive = true;
  o.folder = folder.string();
  const Report report = verify::check_all(verify::adapt(test::dry_hill<double>(0.4), pair), o);
  std::ostringstream text;
  text << report;
  const std::string file = (folder / "energy_on_closed_loops.csv").string();
  CHECK_THAT(text.str(), ContainsSubstring("third law               pass") && ContainsSubstring(file) &&
                             ContainsSubstring("seed 20190501") && ContainsSubstring("not claimed"));
  CHECK_FALSE(report.passed());
  CHECK(contact_path::read_path<double>(file).size() == report.find("energy on closed loops")->path.size());
  std::filesystem::remove(file);
  std::filesystem::create_directory(file);  // in the way of the file
  CHECK_THROWS_WITH(verify::check_all(verify::adapt(test::dry_hill<double>(0.4), pair), o),
                    ContainsSubstring("energy_on_closed_loops.csv: cannot be written"));
  std::filesystem::remove_all(folder);
}

namespace {

/// A law that returns only a force.
struct ForceAlone {
  struct State {};
  verify::Interaction operator()(const verify::Bodies& b, double, State&) const {
    const verify::Vector branch = b.branch();
    const double overlap = b.one.radius + b.two.radius - branch.norm();
    return {verify::Vector(branch.normalized() * (1e6 * positive_part<double>(overlap))), {}, {}, {}};
  }
};

}  // namespace

TEST_CASE("What a law does not offer or claim is not called passed") {
  const Report report = verify::check_all(ForceAlone{}, options({}));
  CHECK(report.passed());
  for (const char* name :
       {"third law", "torque balance", "change of owner", "unit scaling", "restart", "derivative = stiffness"})
    CHECK(report.find(name)->verdict == Verdict::not_offered);
  for (const char* name :
       {"rigid twist", "Coulomb bound", "friction reached", "no tension", "continuity at touch", "continuity in motion",
        "open contact", "ratcheting", "energy on closed loops", "static friction reached", "restitution"})
    CHECK(report.find(name)->verdict == Verdict::not_claimed);
}

TEST_CASE("An open contact may return a force alone; the rest is checked where it is returned") {
  const ForceUpdate full(verify::adapt(test::dry_hill<double>(0.4), pair));
  ForceUpdate terse = full;
  terse.step = [full](const verify::Bodies& b, double dt, ForceUpdate::State& state) {
    const verify::Interaction all = full.step(b, dt, state);
    return b.branch().norm() < b.one.radius + b.two.radius ? all : verify::Interaction{all.force};
  };
  CHECK(failures(verify::check_all(terse, options(claims_of(0.4)))) == Names{});
  ForceUpdate wrong = terse;
  wrong.step = [terse](const verify::Bodies& b, double dt, ForceUpdate::State& state) {
    verify::Interaction all = terse.step(b, dt, state);
    if (all.force1) all.force1 = verify::Vector(*all.force1 * (1 + 1e-14));
    return all;
  };
  CHECK(failures(verify::check_all(wrong, options({}))) == Names{"third law"});
}

TEST_CASE("A NaN is a failure, whatever number follows it") {
  verify::Finding finding{0.0, 1.0};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(finding.add(0.5));
  CHECK(finding.add(nan));
  CHECK_FALSE(finding.add(2.0));
  CHECK(finding.failed());

  const ForceUpdate law(verify::adapt(test::dry_hill<double>(0.4), pair));
  for (const bool normal : {true, false}) {
    ForceUpdate wrong = law;  // no stiffness for the shallow half of the contacts
    wrong.stiffness = [law, normal, nan](const verify::Bodies& b, const ForceUpdate::State& state) {
      auto claimed = law.stiffness(b, state);
      const bool shallow = b.one.radius + b.two.radius - b.branch().norm() < 5e-6;
      if (shallow) (normal ? claimed.normal : claimed.shear) = nan;
      return claimed;
    };
    CHECK(failures(verify::check_all(wrong, options({}))) == Names{"derivative = stiffness"});
  }
}
