// docs/parameters_elsewhere.md, row by row: our law, set up by the formulas of the row, against the other code's published formula,
// computed here from the other code's parameters. The table is read from the document: a formula that is changed there is tried
// here, a row without a check fails, and so does a check without a row.
#include <cmath>
#include <fstream>
#include <functional>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "catch.hpp"
#include "contactlaws/contactlaws.hpp"
#include "formula.hpp"

namespace contactlaws::test {
namespace {

using Values = std::map<std::string, double>;

struct Row {
  std::string code, model, slots, set;
  std::set<std::string> theirs;
};

/// The cells of a line of a table, without blanks and backticks.
std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream rest(line.substr(1));
  for (std::string cell; std::getline(rest, cell, '|');) {
    std::string plain;
    for (const char c : cell)
      if (c != '`') plain += c;
    const auto first = plain.find_first_not_of(' '), last = plain.find_last_not_of(' ');
    cells.push_back(first == std::string::npos ? "" : plain.substr(first, last - first + 1));
  }
  return cells;
}
std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts;
  std::istringstream rest(text);
  for (std::string part; std::getline(rest, part, at);) parts.push_back(part.substr(part.find_first_not_of(' ')));
  return parts;
}

std::vector<Row> table() {
  std::ifstream file(CONTACTLAWS_DOCS "/parameters_elsewhere.md");
  std::vector<Row> rows;
  for (std::string line; std::getline(file, line);) {
    if (line.substr(0, 1) != "|" || line.substr(0, 6) == "| code" || line.substr(0, 4) == "|---") continue;
    const std::vector<std::string> cells = cells_of(line);
    REQUIRE(cells.size() == 5);
    Row row{cells[0], cells[1], cells[3], cells[4], {}};
    for (const std::string& name : split(cells[2], ',')) row.theirs.insert(name);
    rows.push_back(row);
  }
  return rows;
}

/// Two grains that are unlike, so that R1 for R2 or R for 2 R shows.
constexpr double r1 = 7.5e-3, r2 = 5e-3, m1 = 4.68e-3, m2 = 1.39e-3;
constexpr double r_star = r1 * r2 / (r1 + r2), m_star = m1 * m2 / (m1 + m2);
constexpr double pi_ = 3.14159265358979324;
constexpr double overlap = 2e-5;

template <class Law>
struct Ours {
  Law law{};
  PairProperties<double> pair{};

  /// The force on body 2 along the normal after one step to the overlap.
  double normal(double at = overlap, double separating = 0.0) const {
    return law.step(pair, {{0, 0, 1}, at, {0, 0, separating}, 1e-9}, {}).force.z();
  }
  /// The shear force against one step of this slip.
  double shear(double slip, double dt = 1.0) const {
    return -law.step(pair, {{0, 0, 1}, overlap, {slip / dt, 0, 0}, dt}, {}).force.x();
  }
  /// The couple against one step of this angle of rolling, or of twisting.
  double rolling(double angle, double dt = 1.0) const {
    return -law.step(pair, {{0, 0, 1}, overlap, {0, 0, 0}, dt, 0.0, {angle / dt, 0, 0}}, {}).couple.x();
  }
  double twisting(double angle, double dt = 1.0) const {
    return -law.step(pair, {{0, 0, 1}, overlap, {0, 0, 0}, dt, 0.0, {0, 0, angle / dt}}, {}).couple.z();
  }
};

template <class Owner>
bool has_parameter(const std::string& name) {
  bool found = false;
  Owner owner{};
  visit_parameters(owner, [&](const char*, const auto& p, auto&) { found = found || name == p.name; });
  return found;
}

/// Our law as the row sets it up.
template <class Law>
Ours<Law> ours(const Row& row, const Values& theirs, const Law& law = {}) {
  Values known{{"R1", r1}, {"R2", r2}, {"R", r_star}, {"m1", m1}, {"m2", m2}, {"m", m_star}, {"pi", pi_}};
  known.insert(theirs.begin(), theirs.end());
  ElasticMaterial<double> material{29e9, 0.15, 2650.0};
  Ours<Law> result{law, {}};
  const auto make_pair = [&] {
    result.pair = sphere_sphere_pair(effective_moduli(material, material), r1, r2, m_star);
    known["E_eff"] = result.pair.effective_young;
    known["G_eff"] = result.pair.effective_shear;
  };
  make_pair();
  std::set<std::string> read, auxiliary;
  for (const std::string& formula : split(row.set, ';')) {
    const auto equals = formula.find('=');
    const std::string name = formula.substr(0, formula.find(' '));
    const double value = Formula(formula.substr(equals + 1), known, read).value();
    if (has_parameter<ElasticMaterial<double>>(name)) {
      set_parameter(material, name, value);
      make_pair();
    } else if (has_parameter<PairProperties<double>>(name)) {
      set_parameter(result.pair, name, value);
    } else if (has_parameter<Law>(name)) {
      set_parameter(result.law, name, value);
    } else {
      known[name] = value;
      auxiliary.insert(name);
    }
  }
  for (const std::string& name : auxiliary) {
    INFO("neither a parameter of the law nor read by a later formula: " << name);
    CHECK(read.count(name) == 1);
  }
  for (const auto& [name, value] : theirs) {
    INFO("read by no formula: " << name);
    CHECK(read.count(name) == 1);
  }
  result.law = checked(result.law);
  return result;
}

/// Closed forms on both sides: some ten roundings each.
Approx is(double expected) { return Approx(expected).epsilon(1e-13); }

template <class Normal, class Damping = NoDashpots<double>, class Shear = Frictionless<double>,
          class Rolling = NoRolling<double>>
using Law = ContactLaw<Normal, Damping, Shear, Dry<double>, Rolling>;
using Undamped = NoDashpots<double>;
using Smooth = Frictionless<double>;
using Linear = LinearSpring<double>;
using HertzD = Hertz<double>;
using Damped = Dashpots<double>;
using TwoDashpots = Dashpots<double, Tension::allowed, ShearDashpot::given>;
using LinearShear = ShearForce<double, ConstantRatio<double>>;
using OfShear = RollingSpringDashpot<double, ShearRolling<double>>;
using Given = RollingSpringDashpot<double, GivenRolling<double>>;

/// What the other codes derive from Young's modulus and Poisson's ratio of equal materials, as all of them document it.
double modulus(double young, double poisson) { return young / (2 * (1 - poisson * poisson)); }
double shear_modulus(double young, double poisson) { return young / (4 * (2 - poisson) * (1 + poisson)); }
double hertz_force(double e, double at = overlap) { return 4.0 / 3.0 * e * std::sqrt(r_star) * std::pow(at, 1.5); }
const double contact_radius = std::sqrt(r_star * overlap);

/// LAMMPS, JKR: delta = a^2/R - 2 sqrt(pi gamma a/E), F = 4 E a^3/(3 R) - 2 pi a^2 sqrt(4 gamma E/(pi a)); a by bisection.
double lammps_jkr(double e, double gamma, double delta) {
  double low = std::cbrt(pi_ * gamma * r_star * r_star / (4 * e)),
         high = 1e-2;  // the overlap rises with a beyond `low`
  for (int i = 0; i < 200; ++i) {
    const double a = (low + high) / 2;
    (a * a / r_star - 2 * std::sqrt(pi_ * gamma * a / e) < delta ? low : high) = a;
  }
  return 4 * e * low * low * low / (3 * r_star) - 2 * pi_ * low * low * std::sqrt(4 * gamma * e / (pi_ * low));
}
double tsuji(double e) {
  return 1.2728 + e * (-4.2783 + e * (11.087 + e * (-22.348 + e * (27.467 + e * (-18.022 + e * 4.8218)))));
}

/// A rolling or twisting couple that is k angle + c angle/dt to a limit.
template <class Couple>
void check_couple(const Couple& couple, double k, double c, double limit) {
  const double angle = 1e-3 * limit / k;
  CHECK(couple(angle, 1e6) == Approx(k * angle).epsilon(1e-9));  // a slow step: the dashpot bears c k of it, 1e-6
  if (c > 0.0) CHECK(couple(angle, c / k) == is(2 * k * angle));
  CHECK(couple(1e3 * limit / k, 1e6) == is(limit));
}

void luding(const Row& row, const Values& v, double k1, double k2, double kc, double phi) {
  // k1 loading; unloading k2(o - o_0) with k2 grown in proportion, o_0 = (1 - k1/k2) o_max; -kc o (Luding 2008 Eqs 6 to 8).
  const auto law = ours<Law<LinearHysteretic<double>>>(row, v);
  const double limit = k2 / (k2 - k1) * phi * 2 * r1 * r2 / (r1 + r2);
  for (const double deepest : {0.4 * limit, 1.5 * limit}) {
    auto state = decltype(law.law)::State{};
    const auto at = [&](double o) {
      const auto s = law.law.step(law.pair, {{0, 0, 1}, o, {0, 0, 0}, 1.0}, state);
      state = s.state;
      return s.force.z();
    };
    const double grown = std::min(deepest, limit), stiffness = k1 + (k2 - k1) * grown / limit;
    const double plastic = (1 - k1 / stiffness) * grown;
    CHECK(at(deepest) == is(deepest < limit ? k1 * deepest : k2 * (deepest - plastic)));
    CHECK(at(1.1 * plastic) == Approx(stiffness * 0.1 * plastic).epsilon(1e-12));  // a tenth is left of the terms
    const double pulled = 0.1 * plastic;
    CHECK(at(pulled) == is(-kc * pulled));
  }
}

struct Peer {
  const char* code;
  const char* model;
  Values theirs;
  std::function<void(const Row&, const Values&)> check;
};

const std::vector<Peer>& peers();

}  // namespace

TEST_CASE("Parameters elsewhere: each row of the table sets our law up to give the other code's force") {
  const std::vector<Row> rows = table();
  std::set<std::string> checked_rows;
  for (const Row& row : rows) {
    const std::string name = row.code + " | " + row.model;
    INFO(name);
    CHECK(checked_rows.insert(name).second);  // no row twice
    const Peer* found = nullptr;
    for (const Peer& peer : peers())
      if (row.code == peer.code && row.model == peer.model) found = &peer;
    if (found == nullptr) {
      FAIL_CHECK("a row of docs/parameters_elsewhere.md that nothing checks");
      continue;
    }
    std::set<std::string> names;
    for (const auto& value : found->theirs) names.insert(value.first);
    CHECK(row.theirs == names);
    found->check(row, found->theirs);
  }
  for (const Peer& peer : peers()) {
    INFO(peer.code << " | " << peer.model << ": a check without a row of docs/parameters_elsewhere.md");
    CHECK(checked_rows.count(std::string(peer.code) + " | " + peer.model) == 1);
  }
}

namespace {

const std::vector<Peer>& peers() {
  static const std::vector<Peer> all{
      {"LAMMPS",
       "hooke",
       {{"k_n", 3e6}},
       [](const Row& row, const Values& v) { CHECK(ours<Law<Linear>>(row, v).normal() == is(3e6 * overlap)); }},
      {"LAMMPS",
       "hertz",
       {{"k_n", 3e10}},
       [](const Row& row, const Values& v) {
         CHECK(ours<Law<HertzD>>(row, v).normal() == is(3e10 * std::sqrt(r_star) * std::pow(overlap, 1.5)));
       }},
      {"LAMMPS",
       "hertz/material",
       {{"E", 5e9}, {"nu", 0.3}},
       [](const Row& row, const Values& v) {
         CHECK(ours<Law<HertzD>>(row, v).normal() == is(hertz_force(modulus(5e9, 0.3))));
       }},
      {"LAMMPS",
       "dmt",
       {{"E", 5e9}, {"nu", 0.3}, {"gamma", 40.0}, {"mu", 0.4}},
       [](const Row& row, const Values& v) {
         const auto law = ours<Law<Dmt<double, AdhesiveFriction::thornton_jkr>, Undamped, ShearForce<double>>>(row, v);
         const double pull_off = 4 * pi_ * 40.0 * r_star, force = hertz_force(modulus(5e9, 0.3)) - pull_off;
         CHECK(law.normal() == Approx(force).epsilon(1e-12));
         CHECK(law.shear(1.0) == Approx(0.4 * (force + 2 * pull_off)).epsilon(1e-12));
       }},
      {"LAMMPS",
       "jkr",
       {{"E", 5e9}, {"nu", 0.3}, {"gamma", 40.0}, {"mu", 0.4}},
       [](const Row& row, const Values& v) {
         const auto law = ours<Law<Jkr<double>, Undamped, ShearForce<double>>>(row, v);
         const double e = modulus(5e9, 0.3), pull_off = 3 * pi_ * 40.0 * r_star;
         // The bisection finds a to a rounding, of which the force keeps 1e-13 or so.
         for (const double o : {overlap, overlap / 10})
           CHECK(law.normal(o) == Approx(lammps_jkr(e, 40.0, o)).epsilon(1e-11));
         CHECK(law.law.normal.pull_off_force(law.pair) == is(pull_off));
         CHECK(law.shear(1.0) == Approx(0.4 * (lammps_jkr(e, 40.0, overlap) + 2 * pull_off)).epsilon(1e-11));
       }},
      {"LAMMPS",
       "damping velocity, hooke",
       {{"k_n", 3e6}, {"eta_n0", 20.0}},
       [](const Row& row, const Values& v) {
         const auto law = ours<Law<Linear, Damped>>(row, v);
         CHECK(law.normal(overlap, -0.5) == is(3e6 * overlap + 20.0 * 0.5));
       }},
      {"LAMMPS",
       "damping mass_velocity, hooke",
       {{"k_n", 3e6}, {"eta_n0", 2e4}},
       [](const Row& row, const Values& v) {
         const auto law = ours<Law<Linear, Damped>>(row, v);
         CHECK(law.normal(overlap, -0.5) == is(3e6 * overlap + 2e4 * m_star * 0.5));
       }},
      {"LAMMPS",
       "damping tsuji, tangential mindlin NULL",
       {{"E", 5e9}, {"nu", 0.3}, {"e", 0.6}, {"x_gammat", 0.7}, {"mu", 0.4}},
       [](const Row& row, const Values& v) {
         const auto law = ours<Law<HertzD, TwoDashpots, ShearDisplacement<double>>>(row, v);
         const double e = modulus(5e9, 0.3), k = 4.0 / 3.0 * e * contact_radius;
         const double eta = tsuji(0.6) * std::sqrt(m_star * k);
         CHECK(law.normal(overlap, -0.5) == is(hertz_force(e) + eta * 0.5));
         const double k_t = 8 * shear_modulus(5e9, 0.3), slip = 1e-8;
         CHECK(law.shear(slip, 1e-3) == is(k_t * contact_radius * slip + 0.7 * eta * slip / 1e-3));
         CHECK(law.shear(1.0, 1e9) == is(0.4 * hertz_force(e)));
       }},
      {"LAMMPS",
       "tangential mindlin",
       {{"k_n", 3e10}, {"k_t", 2e10}, {"mu", 0.4}},
       [](const Row& row, const Values& v) {
         const auto law = ours<Law<HertzD, Undamped, ShearDisplacement<double>>>(row, v);
         CHECK(law.shear(1e-8) == is(2e10 * contact_radius * 1e-8));
         CHECK(law.shear(1.0) == is(0.4 * 3e10 * std::sqrt(r_star) * std::pow(overlap, 1.5)));
       }},
      {"LAMMPS",
       "tangential linear_history, hooke",
       {{"k_n", 3e6}, {"k_t", 1e6}, {"mu", 0.4}},
       [](const Row& row, const Values& v) {
         const auto law = ours<Law<Linear, Undamped, LinearShear>>(row, v);
         CHECK(law.shear(1e-6) == is(1e6 * 1e-6));
         CHECK(law.shear(1.0) == is(0.4 * 3e6 * overlap));
       }},
      {"LAMMPS",
       "rolling sds",
       {{"k_roll", 1e5}, {"gamma_roll", 3.0}, {"mu_roll", 0.1}},
       [](const Row& row, const Values& v) {
         // A pseudo-force k_roll xi + gamma_roll v_roll with v_roll = R w, and the couple R times it.
         const auto law = ours<Law<HertzD, Undamped, Smooth, Given>>(row, v);
         const double load = hertz_force(law.pair.effective_young);
         check_couple([&](double a, double dt) { return law.rolling(a, dt); }, r_star * 1e5 * r_star,
                      r_star * 3.0 * r_star, r_star * 0.1 * load);
       }},
      {"LAMMPS",
       "twisting sds",
       {{"k_twist", 2.0}, {"gamma_twist", 1e-5}, {"mu_twist", 1e-4}},
       [](const Row& row, const Values& v) {
         using Twist = TwistingSpringDashpot<double, GivenTwisting<double>>;
         const auto law = ours<Law<HertzD, Undamped, Smooth, Twist>>(row, v);
         check_couple([&](double a, double dt) { return law.twisting(a, dt); }, 2.0, 1e-5,
                      1e-4 * hertz_force(law.pair.effective_young));
       }},
      {"LAMMPS",
       "twisting marshall, damping tsuji, tangential mindlin NULL",
       {{"E", 5e9}, {"nu", 0.3}, {"e", 0.6}, {"x_gammat", 0.7}, {"mu", 0.4}},
       [](const Row& row, const Values& v) {
         // k_twist = k_t a^2/2, eta_twist = eta_t a^2/2, mu_twist = 2/3 a mu; here k_t is 8 G a, eta_t = x eta_n.
         const auto law = ours<Law<HertzD, Undamped, Smooth, TwistingSpringDashpot<double>>>(row, v);
         const double e = modulus(5e9, 0.3), a = contact_radius;
         const double eta = 0.7 * tsuji(0.6) * std::sqrt(m_star * 4.0 / 3.0 * e * a);
         check_couple([&](double t, double dt) { return law.twisting(t, dt); },
                      0.5 * 8 * shear_modulus(5e9, 0.3) * a * a * a, 0.5 * eta * a * a,
                      2.0 / 3.0 * a * 0.4 * hertz_force(e));
       }},
      {"LIGGGHTS",
       "model hertz, tangential history",
       {{"youngsModulus", 5e9}, {"poissonsRatio", 0.3}, {"coefficientRestitution", 0.6}, {"coefficientFriction", 0.4}},
       [](const Row& row, const Values& v) {
         // gamma_n = -2 sqrt(5/6) beta sqrt(S_n m*), S_n = 2 Y* sqrt(R* delta); gamma_t with S_t = 8 G* sqrt(R* delta) = k_t.
         const auto law = ours<Law<HertzD, TwoDashpots, ShearDisplacement<double>>>(row, v);
         const double e = modulus(5e9, 0.3), s_n = 2 * e * contact_radius;
         const double s_t = 8 * shear_modulus(5e9, 0.3) * contact_radius;
         const double beta = std::log(0.6) / std::sqrt(std::pow(std::log(0.6), 2) + pi_ * pi_);
         const double gamma_n = -2 * std::sqrt(5.0 / 6.0) * beta * std::sqrt(s_n * m_star);
         const double gamma_t = -2 * std::sqrt(5.0 / 6.0) * beta * std::sqrt(s_t * m_star);
         CHECK(law.normal(overlap, -0.5) == is(hertz_force(e) + gamma_n * 0.5));
         CHECK(law.shear(1e-8, 1e-3) == is(s_t * 1e-8 + gamma_t * 1e-5));
         CHECK(law.shear(1.0, 1e9) == is(0.4 * hertz_force(e)));
       }},
      {"LIGGGHTS",
       "model hooke/stiffness",
       {{"kn", 3e6}, {"kt", 1e6}, {"gamman", 2e4}, {"coefficientFriction", 0.4}},
       [](const Row& row, const Values& v) {
         // absolute_damping off, its default: the coefficient is multiplied by the effective mass.
         const auto law = ours<Law<Linear, Damped, LinearShear>>(row, v);
         CHECK(law.normal(overlap, -0.5) == is(3e6 * overlap + m_star * 2e4 * 0.5));
         CHECK(law.shear(1e-8, 1e9) == Approx(1e6 * 1e-8).epsilon(1e-9));
         CHECK(law.shear(1.0, 1e9) == is(0.4 * 3e6 * overlap));
       }},
      {"LIGGGHTS",
       "rolling_friction cdt",
       {{"coefficientRollingFriction", 0.1}},
       [](const Row& row, const Values& v) {
         // rmu k_n delta_n R*, against the direction of rolling.
         const auto law = ours<Law<HertzD, Undamped, Smooth, RollingTorque<double>>>(row, v);
         CHECK(law.rolling(1e-9) == is(0.1 * hertz_force(law.pair.effective_young) * r_star));
       }},
      {"LIGGGHTS",
       "rolling_friction epsd, model hooke/stiffness",
       {{"kn", 3e6}, {"coefficientRollingFriction", 0.1}, {"coefficientRollingViscousDamping", 0.2}},
       [](const Row& row, const Values& v) {
         const auto law = ours<Law<Linear, Undamped, Smooth, RollingSpringDashpot<double>>>(row, v);
         const double i1 = 1.4 * m1 * r1 * r1, i2 = 1.4 * m2 * r2 * r2, inertia = 1 / (1 / i1 + 1 / i2);
         const double k = 2.25 * 3e6 * 0.1 * 0.1 * r_star * r_star;
         check_couple([&](double a, double dt) { return law.rolling(a, dt); }, k, 0.2 * 2 * std::sqrt(inertia * k),
                      3e6 * overlap * r_star * 0.1);
       }},
      {"LIGGGHTS",
       "rolling_friction epsd, model hertz",
       {{"youngsModulus", 5e9},
        {"poissonsRatio", 0.3},
        {"coefficientRollingFriction", 0.1},
        {"coefficientRollingViscousDamping", 0.2}},
       [](const Row& row, const Values& v) {
         const auto law = ours<Law<HertzD, Undamped, Smooth, OfShear>>(row, v);
         const double e = modulus(5e9, 0.3), k_n = 4.0 / 3.0 * e * contact_radius;
         const double i1 = 1.4 * m1 * r1 * r1, i2 = 1.4 * m2 * r2 * r2, inertia = 1 / (1 / i1 + 1 / i2);
         const double k = 2.25 * k_n * 0.1 * 0.1 * r_star * r_star;
         check_couple([&](double a, double dt) { return law.rolling(a, dt); }, k, 0.2 * 2 * std::sqrt(inertia * k),
                      k_n * overlap * r_star * 0.1);
       }},
      {"LIGGGHTS",
       "rolling_friction epsd2, model hertz",
       {{"youngsModulus", 5e9}, {"poissonsRatio", 0.3}, {"coefficientRollingFriction", 0.1}},
       [](const Row& row, const Values& v) {
         const auto law = ours<Law<HertzD, Undamped, Smooth, OfShear>>(row, v);
         const double k_t = 8 * shear_modulus(5e9, 0.3) * contact_radius;
         check_couple([&](double a, double dt) { return law.rolling(a, dt); }, k_t * r_star * r_star, 0.0,
                      hertz_force(modulus(5e9, 0.3)) * r_star * 0.1);
       }},
      {"LIGGGHTS",
       "rolling_friction epsd3, model hertz",
       {{"youngsModulus", 5e9},
        {"poissonsRatio", 0.3},
        {"coefficientRollingFriction", 0.1},
        {"coeffRollingStiffness", 4.0}},
       [](const Row& row, const Values& v) {
         const auto law = ours<Law<HertzD, Undamped, Smooth, OfShear>>(row, v);
         const double e = modulus(5e9, 0.3), k_n = 4.0 / 3.0 * e * contact_radius;
         check_couple([&](double a, double dt) { return law.rolling(a, dt); }, 4.0 * k_n * 0.1 * 0.1 * r_star * r_star,
                      0.0, hertz_force(e) * r_star * 0.1);
       }},
      {"LIGGGHTS",
       "cohesion sjkr, same pull-off",
       {{"youngsModulus", 5e9}, {"poissonsRatio", 0.3}, {"cohesionEnergyDensity", 5e6}},
       [](const Row& row, const Values& v) {
         const auto law = ours<Law<Jkr<double>>>(row, v);
         const double e = modulus(5e9, 0.3);
         // Hertz less k A, A = pi/4 (d - R1 - R2)(d + R1 - R2)(d - R1 + R2)(d + R1 + R2)/d^2 as documented, with the sign of an area.
         double deepest = 0.0;
         for (double o = 1e-9; o < 1e-6; o *= 1.001) {
           const double d = r1 + r2 - o;
           const double area = -pi_ / 4 * (d - r1 - r2) * (d + r1 - r2) * (d - r1 + r2) * (d + r1 + r2) / (d * d);
           deepest = std::min(deepest, hertz_force(e, o) - 5e6 * area);
         }
         // Near its lowest the force is off by the square of half a step of o; the area by o/R, 1e-5.
         CHECK(law.law.normal.pull_off_force(law.pair) == Approx(-deepest).epsilon(2e-5));
       }},
      {"LIGGGHTS",
       "cohesion sjkr2, same pull-off",
       {{"youngsModulus", 5e9}, {"poissonsRatio", 0.3}, {"cohesionEnergyDensity", 5e6}},
       [](const Row& row, const Values& v) {
         const auto law = ours<Law<Jkr<double>>>(row, v);
         double deepest = 0.0;
         for (double o = 1e-9; o < 1e-6; o *= 1.001)
           deepest = std::min(deepest, hertz_force(modulus(5e9, 0.3), o) - 5e6 * 2 * pi_ * o * 2 * r_star);
         CHECK(law.law.normal.pull_off_force(law.pair) == Approx(-deepest).epsilon(1e-6));
       }},
      {"YADE",
       "FrictMat, FrictPhys",
       {{"young", 5e8}, {"poisson", 0.3}, {"frictionAngle", 0.5}},
       [](const Row& row, const Values& v) {
         const auto law = ours<Law<Linear, Undamped, LinearShear>>(row, v);
         const double k_n = 2 * 5e8 * r1 * 5e8 * r2 / (5e8 * r1 + 5e8 * r2);
         const double k_s = 2 * (5e8 * r1 * 0.3) * (5e8 * r2 * 0.3) / (5e8 * r1 * 0.3 + 5e8 * r2 * 0.3);
         CHECK(law.normal() == is(k_n * overlap));
         CHECK(law.shear(1e-6) == is(k_s * 1e-6));
         CHECK(law.shear(1.0) == is(std::tan(0.5) * k_n * overlap));
       }},
      {"YADE",
       "FrictMat, MindlinPhys",
       {{"young", 5e9}, {"poisson", 0.3}, {"frictionAngle", 0.5}, {"betan", 0.1}, {"betas", 0.2}, {"gamma", 40.0}},
       [](const Row& row, const Values& v) {
         // c = 2 beta sqrt(m k) with the tangents; adhesion 4 pi R gamma; friction limits by the whole normal force.
         using Normal = Dmt<double, AdhesiveFriction::none>;
         const auto law = ours<Law<Normal, TwoDashpots, ShearForce<double>>>(row, v);
         const double e = modulus(5e9, 0.3), k_n = 2 * e * std::sqrt(r_star * overlap);
         const double k_s = 8 * shear_modulus(5e9, 0.3) * std::sqrt(r_star * overlap);
         const double force = hertz_force(e) - 4 * pi_ * r_star * 40.0;
         CHECK(law.normal(overlap, -0.5) == Approx(force + 2 * 0.1 * std::sqrt(m_star * k_n) * 0.5).epsilon(1e-12));
         CHECK(law.shear(1e-8, 1e-3) == is(k_s * 1e-8 + 2 * 0.2 * std::sqrt(m_star * k_s) * 1e-5));
         CHECK(law.shear(1.0, 1e9) == Approx(std::tan(0.5) * force).epsilon(1e-12));
       }},
      {"YADE",
       "CohFrictMat, rolling",
       {{"young", 5e8}, {"poisson", 0.3}, {"alphaKr", 2.0}, {"etaRoll", 0.1}},
       [](const Row& row, const Values& v) {
         // kr = R1 R2 ks alphaKr, the largest couple min(etaRoll R1, etaRoll R2) F_n.
         const auto law = ours<Law<Linear, Undamped, Smooth, OfShear>>(row, v);
         const double k_n = 2 * 5e8 * r1 * 5e8 * r2 / (5e8 * r1 + 5e8 * r2);
         const double k_s = 2 * (5e8 * r1 * 0.3) * (5e8 * r2 * 0.3) / (5e8 * r1 * 0.3 + 5e8 * r2 * 0.3);
         check_couple([&](double a, double dt) { return law.rolling(a, dt); }, r1 * r2 * k_s * 2.0, 0.0,
                      std::min(0.1 * r1, 0.1 * r2) * k_n * overlap);
       }},
      {"YADE",
       "LudingMat",
       {{"k1", 1e6}, {"kp", 5e6}, {"kc", 5e5}, {"PhiF", 0.01}},
       [](const Row& row, const Values& v) { luding(row, v, 1e6, 5e6, 5e5, 0.01); }},
      {"MercuryDPM",
       "LinearViscoelastic, SlidingFriction",
       {{"stiffness", 3e6}, {"dissipation", 20.0}, {"slidingStiffness", 1e6}, {"slidingFrictionCoefficient", 0.4}},
       [](const Row& row, const Values& v) {
         const auto law = ours<Law<Linear, Damped, LinearShear>>(row, v);
         CHECK(law.normal(overlap, -0.5) == is(3e6 * overlap + 20.0 * 0.5));
         CHECK(law.shear(1e-8, 1e9) == Approx(1e6 * 1e-8).epsilon(1e-9));
         CHECK(law.shear(1.0, 1e9) == is(0.4 * 3e6 * overlap));
       }},
      {"MercuryDPM",
       "HertzianViscoelastic",
       {{"elasticModulus", 5e9}},
       [](const Row& row, const Values& v) {
         const double diameter = 2 * r1 * r2 / (r1 + r2);
         CHECK(ours<Law<HertzD>>(row, v).normal() == is(4.0 / 3.0 * 5e9 * std::sqrt(diameter * overlap) * overlap));
       }},
      {"MercuryDPM",
       "LinearPlasticViscoelastic",
       {{"loadingStiffness", 1e6},
        {"unloadingStiffnessMax", 5e6},
        {"cohesionStiffness", 5e5},
        {"penetrationDepthMax", 0.01}},
       [](const Row& row, const Values& v) { luding(row, v, 1e6, 5e6, 5e5, 0.01); }},
      {"MercuryDPM",
       "Friction, rolling",
       {{"rollingStiffness", 1e5}, {"rollingDissipation", 3.0}, {"rollingFrictionCoefficient", 0.1}},
       [](const Row& row, const Values& v) {
         // A force k xi + nu v with v = D w, D = 2 R1 R2/(R1 + R2), and the couple D times it.
         const auto law = ours<Law<HertzD, Undamped, Smooth, Given>>(row, v);
         const double d = 2 * r1 * r2 / (r1 + r2), load = hertz_force(law.pair.effective_young);
         check_couple([&](double a, double dt) { return law.rolling(a, dt); }, d * 1e5 * d, d * 3.0 * d,
                      d * 0.1 * load);
       }},
      {"PFC",
       "linear",
       {{"kn", 3e6}, {"ks", 1e6}, {"fric", 0.4}, {"dp_nratio", 0.1}, {"dp_sratio", 0.2}},
       [](const Row& row, const Values& v) {
         const auto law = ours<Law<Linear, TwoDashpots, LinearShear>>(row, v);
         CHECK(law.normal(overlap, -0.5) == is(3e6 * overlap + 2 * 0.1 * std::sqrt(m_star * 3e6) * 0.5));
         CHECK(law.shear(1e-8, 1e-3) == is(1e6 * 1e-8 + 2 * 0.2 * std::sqrt(m_star * 1e6) * 1e-5));
         CHECK(law.shear(1.0, 1e9) == is(0.4 * 3e6 * overlap));
       }},
      {"PFC",
       "linear, method deformability",
       {{"emod", 5e8}, {"kratio", 1.5}, {"fric", 0.4}},
       [](const Row& row, const Values& v) {
         // kn = A E*/L, A = pi r^2 with the smaller radius, L = R1 + R2; ks = kn/kratio.
         const auto law = ours<Law<LinearModulus<double>, Undamped, LinearShear>>(row, v);
         const double k_n = pi_ * r2 * r2 * 5e8 / (r1 + r2);
         CHECK(law.normal() == is(k_n * overlap));
         CHECK(law.shear(1e-8) == is(k_n / 1.5 * 1e-8));
         CHECK(law.shear(1.0) == is(0.4 * k_n * overlap));
       }},
      {"PFC",
       "hertz",
       {{"hz_shear", 2e9}, {"hz_poiss", 0.3}, {"fric", 0.4}},
       [](const Row& row, const Values& v) {
         const auto law = ours<Law<HertzD, Undamped, ShearForce<double>>>(row, v);
         const double radius = 1 / (0.5 * (1 / r1 + 1 / r2)), h_n = 2 * 2e9 * std::sqrt(2 * radius) / (3 * (1 - 0.3));
         const double force = h_n * std::pow(overlap, 1.5), tangent = 1.5 * h_n * std::sqrt(overlap);
         CHECK(law.normal() == is(force));
         CHECK(law.shear(1e-8) == is(2 * (1 - 0.3) / (2 - 0.3) * tangent * 1e-8));
         CHECK(law.shear(1.0) == is(0.4 * force));
       }},
      {"PFC",
       "rrlinear",
       {{"kn", 3e6}, {"ks", 1e6}, {"rr_fric", 0.1}},
       [](const Row& row, const Values& v) {
         const auto law = ours<Law<Linear, Undamped, Smooth, OfShear>>(row, v);
         const double radius = 1 / (1 / r1 + 1 / r2);
         check_couple([&](double a, double dt) { return law.rolling(a, dt); }, 1e6 * radius * radius, 0.0,
                      0.1 * radius * 3e6 * overlap);
       }},
      {"paper",
       "Thornton & Ning (1998)",
       {{"p_y", 3e8}},
       [](const Row& row, const Values& v) {
         // Yield where the pressure of Hertz, 2 E* a/(pi R*), is p_y; from there dF/do = pi p_y R*.
         const auto law = ours<Law<ThorntonNing<double>>>(row, v);
         const double e = law.pair.effective_young, a = pi_ * 3e8 * r_star / (2 * e), start = a * a / r_star;
         CHECK(law.normal(start / 2) == is(hertz_force(e, start / 2)));
         CHECK(law.normal(4 * start) == is(hertz_force(e, start) + pi_ * 3e8 * r_star * 3 * start));
       }},
  };
  return all;
}

}  // namespace
}  // namespace contactlaws::test
