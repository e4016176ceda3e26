// A force update as a DEM code has it, written without this library's kernels, and the faults that it can be given.
//
// Normal spring (linear or Hertz) and dashpot, clipped at zero; shear displacement as history, projected onto the contact
// plane and stretched to its old length; spring and dashpot limited together by static or kinetic friction, and the history
// with them; a rolling spring with a limit, its angle kept like the shear displacement.
#pragma once

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "contactlaws/verify/force_update.hpp"

namespace contactlaws::test {

enum class Fault {
  none,
  torque_sign,              ///< lethe PR 889: sign of a cross product
  torque_lever,             ///< LAMMPS gran/*: arm R instead of R - overlap/2
  couple_alone,             ///< the couple acts on body 2, nothing opposes it
  reaction,                 ///< the force on body 1 is off by 18 epsilon
  not_turned,               ///< lethe PR 1107: the history stays where it was as the contact turns
  roll_not_turned,          ///< the same of the rolling angle
  limit_by_total,           ///< friction times the whole force instead of the normal force
  limit_by_magnitude,       ///< lethe PR 1216: friction times |F_n|, where damping makes F_n < 0
  limit_by_component,       ///< each component of the shear force is limited by itself
  low_static_friction,      ///< nine tenths of the static coefficient
  threshold,                ///< lammps PR 2105: shear displacements below 1 nm are dropped
  slow_threshold,           ///< slip below 1 nm/s is dropped
  without_spin,             ///< velocities of the centres
  velocity_lever,           ///< arm R instead of R - overlap/2
  pulls,                    ///< the clip left out
  magnitude,                ///< MercuryDPM's manual: |spring + dashpot| as the normal force
  jump,                     ///< starts with a hundredth of the force
  length_constant,          ///< overlaps below 1 nm do not count
  mass_constant,            ///< 1e-9 kg in the dashpot's mass
  dt_floor,                 ///< time steps below 10 ns count as 10 ns
  own_dt,                   ///< slip integrated with a step fixed in the code
  shared_state,             ///< lammps PR 1631: a query advances the history
  absolute_velocity,        ///< the dashpot takes body 2's velocity
  mass_of_one,              ///< the dashpot takes the mass of body 1
  normal_dashpot_sign,      ///< CabanaPD PR 204: drives what it should damp, and weak enough for most impacts
  shear_dashpot_sign,       ///< phasicFlow issue 268
  rolling_dashpot_sign,     ///< a weak dashpot that drives rolling
  damping_by_speed,         ///< a fit of alpha over log(speed), used below its range
  damping_when_slow,        ///< nine tenths of the damping below a 30th of the usual speed
  friction_sign,            ///< friction along the slip, of a contact that is nearly frictionless
  force_history,            ///< a force where a displacement is promised
  growing_shear_stiffness,  ///< with the overlap, which yields energy with a displacement history
  history_unlimited,        ///< the force is limited, the history is not
  unclipped_formula,        ///< YADE, Chrono: the damping of the unclipped impact
  stiffness_tangent,        ///< a tangent for a secant: 3/2
  restart_loses,            ///< one component is not stored
  exchange_keeps,           ///< the shear history keeps its sign when the bodies are swapped
  exchange_keeps_roll,      ///< the same of the rolling angle
  keeps_when_open,          ///< a contact that opened keeps its shear
  acts_apart,               ///< a push of 0.01 N across gaps below 0.1 um
  divides_by_overlap,       ///< lammps #4180: sqrt(F/o)
};

struct HostLaw {
  Fault fault = Fault::none;
  bool hertz = false;
  double modulus = 1e10;  ///< E* [Pa]
  double stiffness_given = 1e6;
  double friction = 0.4;
  double static_friction = 0.4;
  double rolling_friction = 0.1;
  double damping = 0.3;  ///< alpha [1]
  double unclipped_damping = 0.3;
  double threshold = 1e-9;  ///< in the unit of the fault
  double nanosecond = 1e-9;
  double microgram = 1e-9;
  double fixed_dt = 1e-6;
  double usual_speed = 0.3;

  struct History {
    Eigen::Vector3d shear = Eigen::Vector3d::Zero(), roll = Eigen::Vector3d::Zero();
    bool slides = false;
  };
  struct State {
    std::shared_ptr<History> kept = std::make_shared<History>();
    bool shared = false;

    State() = default;
    State(const State& other) { *this = other; }
    State& operator=(const State& other) {
      shared = other.shared;
      kept = shared ? other.kept : std::make_shared<History>(*other.kept);
      return *this;
    }
    ~State() = default;
  };

  verify::Interaction operator()(const verify::Bodies& pair, double dt, State& state) const {
    state.shared = is(Fault::shared_state);
    const auto& a = pair.one;
    const auto& b = pair.two;
    const V n = pair.branch().normalized();
    double overlap = a.radius + b.radius - pair.branch().norm();
    const double lever1 = a.radius - (is(Fault::velocity_lever) ? 0 : overlap / 2);
    const double lever2 = b.radius - (is(Fault::velocity_lever) ? 0 : overlap / 2);
    const double place = overlap;
    if (is(Fault::length_constant)) overlap -= threshold;

    History& h = *state.kept;
    if (!(overlap > 0) && !(is(Fault::divides_by_overlap) && overlap >= 0)) {
      if (!is(Fault::keeps_when_open)) h = {};
      const V push = is(Fault::acts_apart) && overlap > -1e-7 ? V(0.01 * n) : V::Zero();
      return interaction(push, V::Zero(), n, pair, place);
    }

    V velocity = b.velocity - a.velocity;
    if (!is(Fault::without_spin)) velocity -= b.spin.cross(lever2 * n) + a.spin.cross(lever1 * n);
    const double approach = is(Fault::absolute_velocity) ? b.velocity.dot(n) : velocity.dot(n);
    V slip = velocity - velocity.dot(n) * n;
    if (is(Fault::slow_threshold) && slip.norm() < threshold) slip = V::Zero();

    const double secant = normal_secant(pair, overlap), kt = shear_stiffness(pair, overlap);
    double mass = a.mass * b.mass / (a.mass + b.mass);
    if (is(Fault::mass_of_one)) mass = a.mass;
    if (is(Fault::mass_constant)) mass += microgram;
    const double alpha = damping_at(approach);
    const double cn = alpha * std::sqrt(mass * secant);
    const double ct = (is(Fault::shear_dashpot_sign) ? -damping : damping) * std::sqrt(mass * kt);
    double fn = secant * overlap - cn * approach;
    if (is(Fault::divides_by_overlap))
      fn = secant * overlap - alpha * std::sqrt(mass * (secant * overlap / overlap)) * approach;
    if (is(Fault::jump)) fn += jump_force(pair);
    if (is(Fault::magnitude)) fn = std::abs(fn);
    if (!is(Fault::pulls) && !is(Fault::limit_by_magnitude)) fn = std::max(fn, 0.0);

    if (!is(Fault::not_turned)) turn(h.shear, n);
    if (!is(Fault::roll_not_turned)) turn(h.roll, n);
    V& s = h.shear;
    V ft;
    double step = is(Fault::own_dt) ? fixed_dt : dt;
    if (is(Fault::dt_floor)) step = std::max(step, 10 * nanosecond);
    if (is(Fault::force_history)) {  // s is a force
      s -= kt * slip * step;
      ft = s - ct * slip;
    } else {
      s += slip * step;
      if (is(Fault::threshold) && s.norm() < threshold) s = V::Zero();
      ft = -kt * s - ct * slip;
    }
    double strength = (h.slides ? friction : static_friction) * std::max(fn, 0.0);
    if (is(Fault::low_static_friction) && !h.slides) strength *= 0.9;
    if (is(Fault::limit_by_magnitude)) strength = friction * std::abs(fn);
    if (is(Fault::limit_by_total)) strength = friction * std::hypot(fn, ft.norm());
    h.slides = ft.norm() > strength;
    if (is(Fault::limit_by_component)) {
      for (double& f : ft) f = std::min(std::max(f, -strength), strength);
    } else if (h.slides) {
      if (static_friction > friction) strength = friction * std::max(fn, 0.0);
      ft *= strength / ft.norm();
      if (is(Fault::force_history)) {
        s = ft + ct * slip;
      } else if (!is(Fault::history_unlimited)) {
        s = -(ft + ct * slip) / kt;
      }
      if (is(Fault::friction_sign)) ft *= -0.025;
    }

    const V relative = b.spin - a.spin;
    const V rolling = relative - relative.dot(n) * n;
    h.roll += rolling * step;
    const double radius = reduced_radius(pair), kr = 0.1 * kt * radius * radius;
    const double most = rolling_friction * radius * std::max(fn, 0.0);
    if (kr * h.roll.norm() > most) h.roll *= most / (kr * h.roll.norm());
    const double cr = is(Fault::rolling_dashpot_sign) ? -1e-3 * std::sqrt(mass * kt) * radius * radius : 0.0;
    return interaction(fn * n + ft, -kr * h.roll - cr * rolling, n, pair, place);
  }

  HostLaw in_units(const verify::Units& u) const {
    HostLaw other = *this;
    other.modulus *= u.pressure();
    other.stiffness_given *= u.stiffness();
    if (is(Fault::own_dt)) other.fixed_dt *= u.time;  // a wrong step, but in the right units
    if (is(Fault::threshold)) other.threshold *= u.length;
    if (is(Fault::slow_threshold)) other.threshold *= u.velocity();
    other.usual_speed *= u.velocity();
    return other;
  }
  std::vector<double> store(const State& state) const {
    const History& h = *state.kept;
    std::vector<double> values{h.slides ? 1.0 : 0.0, h.roll.x(), h.roll.y(), h.roll.z(), h.shear.x(), h.shear.y()};
    if (!is(Fault::restart_loses)) values.push_back(h.shear.z());
    return values;
  }
  State load(std::vector<double> values) const {
    values.resize(7, 0.0);
    State state;
    *state.kept = {V(values[4], values[5], values[6]), V(values[1], values[2], values[3]), values[0] > 0.0};
    return state;
  }
  State exchanged(const State& state) const {
    State other = state;
    if (!is(Fault::exchange_keeps)) other.kept->shear *= -1.0;
    if (!is(Fault::exchange_keeps_roll)) other.kept->roll *= -1.0;
    return other;
  }
  ContactStiffness<double> stiffness(const verify::Bodies& pair, const State&) const {
    const double overlap = pair.one.radius + pair.two.radius - pair.branch().norm();
    const double tangent = normal_secant(pair, overlap) * (hertz ? 1.5 : 1.0);
    return {tangent * (is(Fault::stiffness_tangent) ? 1.5 : 1.0), shear_stiffness(pair, overlap)};
  }

 private:
  using V = Eigen::Vector3d;

  bool is(Fault other) const { return fault == other; }
  static double reduced_radius(const verify::Bodies& p) {
    return p.one.radius * p.two.radius / (p.one.radius + p.two.radius);
  }
  /// About a hundredth of the force at an overlap of a thousandth of the radius.
  double jump_force(const verify::Bodies& p) const {
    const double r = reduced_radius(p);
    return hertz ? 3e-6 * modulus * r * r : 3e-5 * stiffness_given * r;
  }
  double normal_secant(const verify::Bodies& p, double overlap) const {
    return hertz ? 4.0 / 3.0 * modulus * std::sqrt(reduced_radius(p) * overlap) : stiffness_given;
  }
  double shear_stiffness(const verify::Bodies& p, double overlap) const {
    return 0.8 * normal_secant(p, overlap) *
           (is(Fault::growing_shear_stiffness) ? 20 * std::sqrt(overlap / reduced_radius(p)) : 1.0);
  }
  double damping_at(double approach) const {
    if (is(Fault::unclipped_formula)) return unclipped_damping;
    if (is(Fault::normal_dashpot_sign)) return -1e-3;
    if (is(Fault::damping_when_slow) && std::abs(approach) < usual_speed / 30) return 0.9 * damping;
    if (is(Fault::damping_by_speed))
      return damping + 0.2 * std::log10(std::max(std::abs(approach) / usual_speed, 1e-6));
    return damping;
  }
  static void turn(V& history, const V& n) {
    const double length = history.norm();
    history -= history.dot(n) * n;
    if (history.norm() > 0) history *= length / history.norm();
  }

  verify::Interaction interaction(const V& force, const V& couple, const V& n, const verify::Bodies& pair,
                                  double overlap) const {
    const double less = is(Fault::torque_lever) ? 0.0 : overlap / 2;
    const V back = is(Fault::reaction) ? V(-(1 - 4e-15) * force) : V(-force);
    const V by_force1 = -(pair.one.radius - less) * n.cross(force),
            by_force2 = -(pair.two.radius - less) * n.cross(force);
    const V torque1 = is(Fault::couple_alone) ? by_force1 : V(by_force1 - couple);
    return {force, back, torque1, is(Fault::torque_sign) ? V(-by_force2 + couple) : V(by_force2 + couple)};
  }
};

}  // namespace contactlaws::test
