// SPDX-License-Identifier: MIT
// Writes what the page of each law shows as JSON: the keys of its parameters from the table that law files are read by, its
// state, and the curves of its picture, computed by the law itself.   laws > laws.json
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "contact_path/law_spec.hpp"

namespace {

using namespace contactlaws;
using nlohmann::json;
using Vector = Vec3<double>;

// Two spheres of glass, 2 mm in diameter.
const ElasticMaterial<double> glass{70e9, 0.2, 2500.0};
const PairProperties<double> pair = pair_properties(sphere(glass, 1e-3), sphere(glass, 1e-3));
constexpr double depth = 1e-6;  // [m]

json keys_of(const contact_path::KeyTable& table) {
  json keys = json::array();
  for (const auto& key : table.numbers)
    keys.push_back({{"name", key.name},
                    {"unit", key.unit},
                    {"range", to_string(key.range)},
                    {"required", key.presence == contact_path::Presence::required},
                    {"says", key.doc}});
  for (const auto& key : table.words) keys.push_back({{"name", key.name}, {"words", key.words}, {"says", key.doc}});
  for (const auto& key : table.flags) keys.push_back({{"name", key.name}, {"flag", true}, {"says", key.doc}});
  return {{"says", table.doc}, {"keys", keys}, {"reads", table.reads}};
}

/// A law of a page: its type, its names in law files, its state.
template <class Law>
json law(const char* type, const std::vector<std::string>& keys) {
  json state = json::array();
  if constexpr (!std::is_same_v<typename Law::Slot, DampingSlot<double>>)
    for (const StateValue& value : Law::state_values())
      state.push_back({{"name", value.name}, {"unit", value.unit}, {"exchange_sign", value.exchange_sign}});
  return {{"type", type}, {"keys", keys}, {"state", state}};
}

struct Curve {
  std::string label;
  std::vector<double> x, y;
};

/// The laws of a page, and its picture: axes, what it shows in words, curves.
json page(const json& laws, const std::string& x, const std::string& y, const std::string& shows,
          const std::vector<Curve>& curves) {
  json lines = json::array();
  for (const Curve& curve : curves) lines.push_back({{"label", curve.label}, {"x", curve.x}, {"y", curve.y}});
  return {{"laws", laws}, {"x", x}, {"y", y}, {"shows", shows}, {"curves", lines}};
}

/// From 0 in straight lines from corner to corner, 400 steps each.
std::vector<double> zigzag(const std::vector<double>& corners) {
  std::vector<double> values;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i)
    for (int k = 1; k <= 400; ++k) values.push_back(corners[i] + (corners[i + 1] - corners[i]) * k / 400.0);
  return values;
}

/// Normal force over overlap [um].
template <class Normal>
Curve pressed(const std::string& label, const Normal& normal, const std::vector<double>& overlaps) {
  Curve curve{label, {}, {}};
  const ContactLaw<Normal> law{normal};
  typename ContactLaw<Normal>::State state{};
  for (const double overlap : zigzag(overlaps)) {
    const auto step = law.step(pair, {Vector(0.0, 0.0, 1.0), overlap, Vector(0.0, 0.0, 0.0), 1e-6}, state);
    state = step.state;
    curve.x.push_back(overlap * 1e6);
    curve.y.push_back(step.normal_force);
  }
  return curve;
}

/// Shear force over slip [um] at a constant overlap.
template <class Shear>
Curve sheared(const std::string& label, const Shear& shear, const std::vector<double>& slips) {
  Curve curve{label, {}, {}};
  using Law = ContactLaw<Hertz<double>, NoDashpots<double>, Shear>;
  const Law law{{}, {}, shear, {}, {}};
  typename Law::State state{};
  double before = 0.0;
  for (const double slip : zigzag(slips)) {
    const auto step = law.step(pair, {Vector(0.0, 0.0, 1.0), depth, Vector(slip - before, 0.0, 0.0), 1.0}, state);
    state = step.state;
    before = slip;
    curve.x.push_back(slip * 1e6);
    curve.y.push_back(-step.shear_force.x());
  }
  return curve;
}

/// Shear force over overlap [um]: slip at the full overlap, then the overlap is halved and doubled without slip.
template <class Shear>
Curve backed_off(const std::string& label) {
  Curve curve{label, {}, {}};
  Shear shear;
  shear.friction = 10.0;
  using Law = ContactLaw<Hertz<double>, NoDashpots<double>, Shear>;
  const Law law{{}, {}, shear, {}, {}};
  typename Law::State state =
      law.step(pair, {Vector(0.0, 0.0, 1.0), depth, Vector(0.1 * depth, 0.0, 0.0), 1.0}, {}).state;
  for (const double overlap : zigzag({depth, 0.5 * depth, depth})) {
    const auto step = law.step(pair, {Vector(0.0, 0.0, 1.0), overlap, Vector(0.0, 0.0, 0.0), 1.0}, state);
    state = step.state;
    curve.x.push_back(overlap * 1e6);
    curve.y.push_back(-step.shear_force.x());
  }
  return curve;
}

/// Force over overlap [um] in an impact at 0.1 m/s, by small steps of velocity Verlet.
template <class Damping>
Curve impact(const std::string& label, const Damping& damping) {
  Curve curve{label, {}, {}};
  const ContactLaw<Hertz<double>, Damping> law{{}, damping, {}, {}, {}};
  const double dt = 1e-9;
  double overlap = 0.0, speed = 0.1, force = 0.0;
  for (int i = 0; i < 40000 && overlap >= 0.0; ++i) {
    speed -= force / pair.effective_mass * dt / 2.0;
    overlap += speed * dt;
    force = law.step(pair, {Vector(0.0, 0.0, 1.0), overlap, Vector(0.0, 0.0, -speed), dt}, {}).normal_force;
    speed -= force / pair.effective_mass * dt / 2.0;
    if (i % 20 != 0) continue;
    curve.x.push_back(overlap * 1e6);
    curve.y.push_back(force);
  }
  return curve;
}

/// Pull over gap, in the unit given [m], of a bridge that is wet at touch.
template <class Bridge>
Curve pulled(const std::string& label, const Bridge& bridge, double last_gap, double unit) {
  Curve curve{label, {}, {}};
  using Law = ContactLaw<Hertz<double>, NoDashpots<double>, Frictionless<double>, Bridge>;
  const Law law{{}, {}, {}, bridge, {}};
  typename Law::State state{};
  bridge.make_wet(state, 0.0, 0.0);
  for (const double gap : zigzag({0.0, last_gap})) {
    const auto step = law.step(pair, {Vector(0.0, 0.0, 1.0), -gap, Vector(0.0, 0.0, 0.0), 1e-6}, state);
    state = step.state;
    curve.x.push_back(gap / unit);
    curve.y.push_back(step.bridge_force);
  }
  return curve;
}

/// Couple about the axis of the spin [N mm] over the angle [mrad], about y for rolling, about the normal for twisting.
template <class Rolling>
Curve turned(const std::string& label, const Rolling& rolling, const Vector& axis, const std::vector<double>& angles) {
  Curve curve{label, {}, {}};
  using Law = ContactLaw<Hertz<double>, NoDashpots<double>, Frictionless<double>, Dry<double>, Rolling>;
  const Law law{{}, {}, {}, {}, rolling};
  typename Law::State state{};
  double before = 0.0;
  const double dt = 1e-6;
  for (const double angle : zigzag(angles)) {
    ContactKinematics<double> motion{Vector(0.0, 0.0, 1.0), depth, Vector(0.0, 0.0, 0.0), dt};
    motion.relative_spin = axis * ((angle - before) / dt);
    const auto step = law.step(pair, motion, state);
    state = step.state;
    before = angle;
    curve.x.push_back(angle * 1e3);
    curve.y.push_back(-dot<double>(step.couple, axis) * 1e3);
  }
  return curve;
}

/// By header.
json pages() {
  const std::string overlap = "overlap [µm]", force = "normal force [N]";
  const std::vector<double> in_and_out{0.0, depth, 0.0};
  json all;

  const double stiffness = 1e6;
  all["normal/linear.hpp"] = page(
      {law<LinearSpring<double>>("LinearSpring", {"linear"}), law<LinearModulus<double>>("LinearModulus", {"linear"})},
      overlap, force, "a straight line through the origin",
      {pressed("k = 1e6 N/m", LinearSpring<double>{stiffness}, {0.0, depth})});
  all["normal/hertz.hpp"] =
      page(json::array({law<Hertz<double>>("Hertz", {"hertz"})}), overlap, force,
           "force grows as overlap to the power 3/2", {pressed("glass, R = 1 mm", Hertz<double>{}, {0.0, depth})});
  Dmt<double> dmt;
  Jkr<double> jkr;
  dmt.work_of_adhesion = jkr.work_of_adhesion = 0.5;
  const double small = 0.02 * depth, beyond = 1.2 * jkr.range(pair);
  all["normal/dmt.hpp"] =
      page(json::array({law<Dmt<double>>("Dmt", {"dmt"})}), overlap, force,
           "Hertz's curve, lowered by a constant pull while the spheres touch",
           {pressed("dmt, w = 0.5 J/m²", dmt, {-small, small}), pressed("hertz", Hertz<double>{}, {-small, small})});
  all["normal/jkr.hpp"] = page(
      json::array({law<Jkr<double>>("Jkr", {"jkr"})}), overlap, force,
      "force drops to a pull at touch, grows with overlap, and on the way back pulls beyond touch until it lets go",
      {pressed("w = 0.5 J/m²", jkr, {-beyond, 4.0 * beyond, -beyond})});
  LinearHysteretic<double> lines;
  lines.loading_stiffness = stiffness;
  lines.unloading_stiffness = 5.0 * stiffness;
  lines.cohesive_stiffness = stiffness;
  lines.plastic_depth = 0.002;
  all["normal/linear_hysteretic.hpp"] =
      page(json::array({law<LinearHysteretic<double>>("LinearHysteretic", {"linear_hysteretic"})}), overlap, force,
           "straight lines of loading, steeper unloading and reloading, and pulling",
           {pressed("k1 = kc = 1e6 N/m, k2 = 5e6 N/m", lines,
                    {0.0, 0.6 * depth, 0.4 * depth, depth, 0.2 * depth, 0.7 * depth, 0.0})});
  ThorntonNing<double> yielding;
  yielding.yield_pressure = 1e9;
  all["normal/thornton_ning.hpp"] =
      page(json::array({law<ThorntonNing<double>>("ThorntonNing", {"thornton_ning"})}), overlap, force,
           "Hertz's curve up to the yield pressure, a straight line beyond, a steep curve of unloading",
           {pressed("p_y = 1 GPa", yielding, in_and_out), pressed("hertz", Hertz<double>{}, {0.0, depth})});
  const RoughSurface<double> rough{2.4, 0.2e-6};
  all["normal/pohrt_popov.hpp"] = page(
      {law<PohrtPopov<double>>("PohrtPopov", {"pohrt_popov"}),
       law<PohrtPopovElastoPlastic<double>>("PohrtPopovElastoPlastic", {"pohrt_popov_elasto_plastic"})},
      overlap, force, "a rough contact is softer than a smooth one; after loading it unloads along a stiffer curve",
      {pressed("elastic", PohrtPopov<double>::of(rough), {0.0, depth}),
       pressed("with loading history", PohrtPopovElastoPlastic<double>::of(rough),
               {0.0, 0.6 * depth, 0.3 * depth, depth, 0.0}),
       pressed("hertz", Hertz<double>{}, {0.0, depth})});

  Dashpots<double> dashpots;
  dashpots.damping_constant = 0.6;
  Dashpots<double, Tension::clipped> clipped;
  clipped.damping_constant = 0.6;
  all["damping/dashpots.hpp"] = page(json::array({law<Dashpots<double>>("Dashpots", {"dashpots"})}), overlap, force,
                                     "force in an impact: a loop, which ends in a pull unless tension is clipped",
                                     {impact("tension allowed", dashpots), impact("tension clipped", clipped),
                                      impact("no dashpots", NoDashpots<double>{})});

  all["tangential/incremental_shear.hpp"] =
      page({law<ShearForce<double>>("ShearForce", {"force"}),
            law<ShearForceRescaled<double>>("ShearForceRescaled", {"force_rescaled"}),
            law<ShearDisplacement<double>>("ShearDisplacement", {"displacement"}),
            law<ShearDisplacementRescaled<double>>("ShearDisplacementRescaled", {"displacement_rescaled"})},
           overlap, "shear force [N]",
           "sheared at the full overlap, then backed off to half of it and pressed again without slip: four histories, "
           "four forces",
           {backed_off<ShearForce<double>>("ShearForce"), backed_off<ShearForceRescaled<double>>("ShearForceRescaled"),
            backed_off<ShearDisplacement<double>>("ShearDisplacement"),
            backed_off<ShearDisplacementRescaled<double>>("ShearDisplacementRescaled")});
  MindlinDeresiewicz<double> partial;
  ShearForce<double> plain;
  partial.friction = plain.friction = 0.3;
  const std::vector<double> slips{0.0, 0.25 * depth, -0.25 * depth, 0.25 * depth};
  all["tangential/mindlin_deresiewicz.hpp"] = page(
      json::array({law<MindlinDeresiewicz<double>>("MindlinDeresiewicz", {"partial_slip"})}), "slip [µm]",
      "shear force [N]",
      "loops of force over slip: with partial slip they round off before the friction limit, without they are lines",
      {sheared("partial slip", partial, slips), sheared("ShearForce", plain, slips)});

  SuctionBridge<double> suction;
  suction.suction = 100e3;
  all["bridge/suction_bridge.hpp"] =
      page(json::array({law<SuctionBridge<double>>("SuctionBridge", {"suction"})}), "gap [mm]", "pull [N]",
           "an exponential decay that ends at the rupture gap", {pulled("suction 100 kPa", suction, 2.2e-3, 1e-3)});
  const auto capillary = [](auto bridge) {
    bridge.surface_tension = 0.072;
    bridge.contact_angle = 0.35;
    bridge.bridge_volume = 1e-11;
    bridge.prepare();
    return bridge;
  };
  all["bridge/capillary_bridge.hpp"] =
      page(json::array({law<CapillaryBridge<double>>("CapillaryBridge", {"capillary"})}), "gap [mm]", "pull [N]",
           "the pull falls with the gap and ends at rupture; closed forms beside the exact force",
           {pulled("YoungLaplace", capillary(CapillaryBridge<double>{}), 0.3e-3, 1e-3),
            pulled("WillettClosed", capillary(CapillaryBridge<double, WillettClosed>{}), 0.3e-3, 1e-3),
            pulled("Rabinovich", capillary(CapillaryBridge<double, Rabinovich>{}), 0.3e-3, 1e-3)});

  const Vector across(0.0, 1.0, 0.0), normal(0.0, 0.0, 1.0);
  const std::string angle = "angle [mrad]", couple = "couple [N mm]";
  RollingSpring<double> spring;
  RollingTorque<double> torque;
  RollingSpringDashpot<double> damped;
  spring.rolling_friction = torque.rolling_friction = damped.rolling_friction = 0.1;
  damped.rolling_damping = 0.2;
  TwistingSpring<double> twisting;
  twisting.twisting_friction = 0.3;
  const std::vector<double> rolls{0.0, 0.02, -0.02, 0.02};
  all["rolling/rolling_spring.hpp"] = page(
      json::array({law<RollingSpring<double>>("RollingSpring", {"spring"})}), angle, couple,
      "a couple that grows with the angle up to its limit, and back", {turned("mu_r = 0.1", spring, across, rolls)});
  all["rolling/rolling_torque.hpp"] =
      page(json::array({law<RollingTorque<double>>("RollingTorque", {"torque"})}), angle, couple,
           "a couple of constant magnitude against the motion", {turned("mu_r = 0.1", torque, across, rolls)});
  all["rolling/rolling_spring_dashpot.hpp"] =
      page(json::array({law<RollingSpringDashpot<double>>(
               "RollingSpringDashpot", {"spring_dashpot", "spring_dashpot_of_shear", "spring_dashpot_given"})}),
           angle, couple, "the spring's loop, with the dashpot's couple added while the spring is below its limit",
           {turned("with dashpot", damped, across, rolls), turned("spring alone", spring, across, rolls)});
  TwistingSpringDashpot<double> viscous;
  viscous.twisting_friction = 0.3;
  viscous.twisting_damping = 0.2;
  all["rolling/twisting_spring_dashpot.hpp"] =
      page(json::array({law<TwistingSpringDashpot<double>>("TwistingSpringDashpot", {"twisting", "twisting_given"})}),
           angle, couple, "the spring's loop, with the dashpot's couple added, both together within the limit",
           {turned("with dashpot", viscous, normal, {0.0, 0.5, -0.5, 0.5}),
            turned("spring alone", twisting, normal, {0.0, 0.5, -0.5, 0.5})});
  all["rolling/twisting_spring.hpp"] =
      page({law<TwistingSpring<double>>("TwistingSpring", {}),
            law<RollAndTwist<double, RollingSpringDashpot<double>>>(
                "RollAndTwist", {"spring_dashpot_twisting", "spring_dashpot_given_twisting"})},
           angle, couple, "a couple about the normal that grows with the angle up to its limit, and back",
           {turned("mu = 0.3", twisting, normal, {0.0, 0.5, -0.5, 0.5})});
  return all;
}

}  // namespace

int main() {
  json keys;
  for (const auto& slot : contact_path::slot_tables())
    for (const auto& law : slot.laws) keys[slot.name][law.name] = keys_of(law);
  std::cout << json{{"keys", keys}, {"pages", pages()}}.dump(1) << '\n';
}
