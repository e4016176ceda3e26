// The kit on a force update with one fault at a time: each is found by the properties that it breaks, and by no other.
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "catch.hpp"
#include "contactlaws/damping/restitution.hpp"
#include "contactlaws/verify/verify.hpp"
#include "random.hpp"
#include "verify/host_law.hpp"

using namespace contactlaws;
using test::Fault, test::HostLaw;
using verify::Options, verify::Path, verify::Report, verify::Result, verify::Vector, verify::Verdict;

namespace {

/// A law with a linear spring has two coefficients of friction where `apart` says so.
Options options(bool hertz, bool apart = false) {
  Options o;
  if (apart) o.claims.static_friction = 0.6;
  o.radius1 = 7.5e-3;
  o.radius2 = 5e-3;
  o.mass1 = 4.7e-3;
  o.mass2 = 1.4e-3;
  o.overlap = 1e-5;
  o.paths = 50;
  o.claims.friction = 0.4;
  o.claims.restitution = 0.7;
  o.claims.range = 0.0;
  o.claims.no_tension = o.claims.continuous_at_touch = o.claims.no_ratcheting = true;
  o.claims.passive = !hertz;  // a displacement history on a stiffness that grows yields energy
  o.claims.continuous_in_motion = hertz;
  o.claims.couple_turns = true;
  return o;
}

HostLaw host_law(Fault fault, bool hertz, bool apart = false) {
  HostLaw law;
  if (apart) law.static_friction = 0.6;
  law.fault = fault;
  law.hertz = hertz;
  const Spring spring = hertz ? Spring::hertz : Spring::linear;
  law.damping = damping_constant(0.7, spring, Tension::clipped);
  law.unclipped_damping = damping_constant(0.7, spring, Tension::allowed);
  return law;
}

Report check(Fault fault, bool hertz, std::uint64_t seed = Options{}.seed) {
  const bool apart = fault == Fault::low_static_friction;
  Options o = options(hertz, apart);
  o.seed = seed;
  return verify::check_all(host_law(fault, hertz, apart), o);
}

std::set<std::string> failures(const Report& report) {
  std::set<std::string> names;
  for (const auto& result : report.results)
    if (result.verdict == Verdict::fail) names.insert(result.property);
  return names;
}

struct Case {
  Fault fault;
  bool hertz;
  const char* meant;             ///< the property that is there for this fault
  std::set<std::string> others;  ///< which it breaks too
  std::size_t steps;             ///< at most, of the reduced path
};

const Case cases[] = {
    {Fault::torque_sign, false, "torque balance", {"swap of the bodies", "change of owner", "energy of impacts"}, 1},
    {Fault::torque_lever, false, "torque balance", {"change of owner"}, 2},
    {Fault::couple_alone, false, "torque balance", {"swap of the bodies"}, 1},
    {Fault::reaction, false, "third law", {}, 1},
    {Fault::not_turned, false, "rigid spin", {"Coulomb bound", "derivative = stiffness"}, 4},
    {Fault::roll_not_turned, false, "rigid spin", {}, 4},
    {Fault::limit_by_total, false, "Coulomb bound", {"friction reached", "step of zero duration"}, 4},
    {Fault::limit_by_magnitude, false, "Coulomb bound", {"no tension", "restitution"}, 4},
    {Fault::limit_by_component,
     false,
     "frame indifference",
     {"Coulomb bound", "friction reached", "derivative = stiffness", "energy on closed loops"},
     2},
    {Fault::low_static_friction, false, "static friction reached", {}, 700},
    {Fault::threshold, false, "slip in small steps", {"derivative = stiffness", "step-size convergence"}, 4},
    {Fault::slow_threshold, false, "slip in small steps", {}, 4},
    {Fault::without_spin, false, "rigid spin", {"friction reached", "derivative = stiffness", "energy of impacts"}, 4},
    {Fault::velocity_lever, false, "rigid spin", {"ratcheting"}, 4},
    {Fault::pulls, false, "no tension", {"restitution"}, 4},
    {Fault::magnitude, false, "dashpots dissipate", {"restitution"}, 2},
    {Fault::jump, false, "continuity at touch", {"restitution"}, 1},
    {Fault::jump, true, "continuity at touch", {"continuity in motion", "restitution"}, 1},
    {Fault::length_constant, false, "unit scaling", {}, 1},
    {Fault::mass_constant, false, "unit scaling", {}, 1},
    {Fault::dt_floor, false, "step of zero duration", {"unit scaling"}, 1},
    {Fault::own_dt, false, "step-size convergence", {"derivative = stiffness", "step of zero duration"}, 16},
    {Fault::shared_state, false, "purity", {"change of owner", "restart"}, 4},
    {Fault::absolute_velocity,
     false,
     "Galilean invariance",
     {"swap of the bodies", "change of owner", "restitution"},
     1},
    {Fault::mass_of_one, false, "swap of the bodies", {"change of owner", "restitution"}, 1},
    {Fault::normal_dashpot_sign, false, "dashpots dissipate", {"energy of impacts", "restitution"}, 1},
    {Fault::shear_dashpot_sign, false, "dashpots dissipate", {"energy on closed loops"}, 2},
    {Fault::shear_dashpot_sign, false, "energy on closed loops", {"dashpots dissipate"}, 6},
    {Fault::rolling_dashpot_sign, false, "dashpots dissipate", {"energy on closed loops"}, 2},
    {Fault::damping_by_speed,
     false,
     "energy of impacts",
     {"dashpots dissipate", "energy on closed loops", "restitution"},
     2},
    {Fault::friction_sign,
     false,
     "energy of impacts",
     {"dashpots dissipate", "energy on closed loops", "friction reached", "step of zero duration"},
     40},
    {Fault::growing_shear_stiffness, false, "energy on closed loops", {"energy of impacts"}, 6},
    {Fault::history_unlimited, false, "energy on closed loops", {}, 7},
    {Fault::force_history, true, "ratcheting", {}, 9},
    {Fault::unclipped_formula, false, "restitution", {}, 200},
    {Fault::damping_when_slow, false, "restitution", {}, 400},
    {Fault::stiffness_tangent, true, "derivative = stiffness", {}, 1},
    {Fault::restart_loses, false, "restart", {}, 4},
    {Fault::exchange_keeps, false, "change of owner", {}, 4},
    {Fault::exchange_keeps_roll, false, "change of owner", {}, 4},
    {Fault::keeps_when_open, false, "open contact", {}, 4},
    {Fault::acts_apart, false, "open contact", {"continuity at touch", "unit scaling"}, 1},
    {Fault::divides_by_overlap, false, "finite force", {"no tension"}, 1},
};

/// The interactions along the path, without the kit's measures.
std::vector<verify::Interaction> replay(const HostLaw& law, const Path& path) {
  HostLaw::State state;
  std::vector<verify::Interaction> all;
  for (const verify::Instant& m : verify::trajectory(path, options(law.hertz)))
    all.push_back(law(m.bodies, m.dt, state));
  return all;
}

Path path_of(Fault fault, bool hertz, const char* property) {
  const Report report = check(fault, hertz);
  const Result* result = report.find(property);
  REQUIRE(result->verdict == Verdict::fail);
  return result->path;
}

}  // namespace

TEST_CASE("The update without a fault passes") {
  for (const bool hertz : {false, true}) CHECK(failures(check(Fault::none, hertz)).empty());
}

TEST_CASE("Static and kinetic friction can be claimed apart") {
  for (const bool hertz : {false, true}) {
    CHECK(failures(verify::check_all(host_law(Fault::none, hertz, true), options(hertz, true))).empty());
    CHECK(failures(verify::check_all(host_law(Fault::none, hertz, true), options(hertz))).count("Coulomb bound") == 1);
    CHECK(failures(verify::check_all(host_law(Fault::none, hertz), options(hertz, true))) ==
          std::set<std::string>{"static friction reached"});
    Options larger = options(hertz);
    larger.claims.friction = 0.6;  // the static one, claimed for the whole slide
    CHECK(failures(verify::check_all(host_law(Fault::none, hertz, true), larger)).count("friction reached") == 1);
  }
}

TEST_CASE("Without any claim, a dashpot that drives, a dropped slip and a history that does not turn are found") {
  for (const Fault fault : {Fault::none, Fault::normal_dashpot_sign, Fault::shear_dashpot_sign, Fault::magnitude,
                            Fault::threshold, Fault::not_turned}) {
    Options o = options(false);
    o.claims = {};
    CAPTURE(static_cast<int>(fault));
    CHECK(verify::check_all(host_law(fault, false), o).passed() == (fault == Fault::none));
  }
}

TEST_CASE("Each fault is found by the property that is there for it, on a short path") {
  for (const Case& c : cases) {
    CAPTURE(static_cast<int>(c.fault), c.hertz, c.meant);
    const Report report = check(c.fault, c.hertz);
    std::set<std::string> expected = c.others;
    expected.insert(c.meant);
    CHECK(failures(report) == expected);
    const std::size_t steps = report.find(c.meant)->path.size();
    CHECK(steps >= 1);
    CHECK(steps <= c.steps);
  }
}

TEST_CASE("No fault hides behind a seed") {
  for (std::uint64_t seed = 1; seed <= (test::sanitized ? 1 : 3); ++seed) {
    CAPTURE(seed);
    for (const bool hertz : {false, true}) CHECK(failures(check(Fault::none, hertz, seed)).empty());
    for (const Case& c : cases) {
      CAPTURE(static_cast<int>(c.fault), c.hertz, c.meant);
      CHECK(check(c.fault, c.hertz, seed).find(c.meant)->verdict == Verdict::fail);
    }
  }
}

TEST_CASE("Reduced paths show the fault when they are replayed") {
  SECTION("Coulomb bound") {
    for (const Fault fault : {Fault::limit_by_total, Fault::limit_by_magnitude}) {
      const Path path = path_of(fault, false, "Coulomb bound");
      const Vector force = replay(host_law(fault, false), path).back().force, n = path.back().normal;
      const double pressing = force.dot(n), shear = (force - pressing * n).norm();
      CHECK(shear > 1.01 * 0.4 * std::max(pressing, 0.0));
    }
  }
  SECTION("no tension") {
    const Path path = path_of(Fault::pulls, false, "no tension");
    CHECK(replay(host_law(Fault::pulls, false), path).back().force.dot(path.back().normal) < 0.0);
    CHECK(replay(host_law(Fault::none, false), path).back().force.dot(path.back().normal) >= 0.0);
  }
  SECTION("third law") {
    const auto found = replay(host_law(Fault::reaction, false), path_of(Fault::reaction, false, "third law"));
    CHECK((found.back().force + *found.back().force1).norm() > 1e-15 * found.back().force.norm());
  }
  SECTION("rigid spin") {
    const Path path = path_of(Fault::not_turned, false, "rigid spin");
    // Spring forces: the last step neither slips nor changes the overlap, so that the shear force keeps its length.
    const Vector n = path.back().normal;
    const auto shear = [&n](const Vector& force) { return Vector(force - force.dot(n) * n); };
    CHECK(std::abs(replay(host_law(Fault::not_turned, false), path).back().force.dot(n)) > 0.0);
    const Vector faulty = replay(host_law(Fault::not_turned, false), path).back().force;
    const Vector right = replay(host_law(Fault::none, false), path).back().force;
    CHECK((faulty - right).norm() > 0.01 * shear(right).norm());
  }
  SECTION("energy on closed loops") {
    for (const Fault fault : {Fault::growing_shear_stiffness, Fault::history_unlimited}) {
      const Path path = verify::refined(path_of(fault, false, "energy on closed loops"), 64);
      const auto found = replay(host_law(fault, false), path);
      double work = 0.0;  // by the trapezoidal rule
      for (std::size_t i = 1; i < path.size(); ++i)
        work -= (found[i].force + found[i - 1].force).dot(path[i].velocity) * path[i].dt / 2;
      CHECK(work < 0.0);
      CHECK(path.back().overlap <= 0.0);
    }
  }
  SECTION("restart") {
    const HostLaw law = host_law(Fault::restart_loses, false);
    const Path path = path_of(Fault::restart_loses, false, "restart");
    HostLaw::State state, restarted;
    Vector through(0, 0, 0), again(0, 0, 0);
    for (const verify::Instant& m : verify::trajectory(path, options(false))) {
      through = law(m.bodies, m.dt, state).force;
      restarted = law.load(law.store(restarted));
      again = law(m.bodies, m.dt, restarted).force;
    }
    CHECK(through != again);
  }
  SECTION("finite force") {
    const Path path = path_of(Fault::divides_by_overlap, false, "finite force");
    CHECK_FALSE(replay(host_law(Fault::divides_by_overlap, false), path).back().force.allFinite());
  }
}
