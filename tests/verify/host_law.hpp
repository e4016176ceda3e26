// A force update as a DEM code has it, written without this library's kernels, and the faults that it can be given.
//
// Normal spring (linear or Hertz) and dashpot, clipped at zero; shear displacement as history, projected onto the contact
// plane and stretched to its old length; spring and dashpot limited together by friction, and the history with them.
#pragma once

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "contactlaws/verify/adapter.hpp"

namespace contactlaws::test {

enum class Fault {
  none,
  torque_sign,              ///< lethe PR 889: sign of a cross product
  torque_lever,             ///< LAMMPS gran/*: arm R instead of R - overlap/2
  reaction,                 ///< the force on body 1 is not the opposite of that on body 2
  not_turned,               ///< the history stays where it was as the contact turns
  limit_by_total,           ///< friction times the whole force instead of the normal force
  limit_by_magnitude,       ///< lethe PR 1216: friction times |F_n|, where damping makes F_n < 0
  limit_by_component,       ///< each component of the shear force is limited by itself
  without_spin,             ///< velocities of the centres
  velocity_lever,           ///< arm R instead of R - overlap/2
  pulls,                    ///< the clip left out
  jump,                     ///< starts with a hundredth of the force
  length_constant,          ///< overlaps below 1 nm do not count
  own_dt,                   ///< slip integrated with a step fixed in the code
  shared_state,             ///< lammps PR 1631: who asks, advances the history
  absolute_velocity,        ///< the dashpot sees body 2's velocity
  mass_of_one,              ///< the dashpot takes the mass of body 1
  shear_dashpot_sign,       ///< drives what it should resist
  force_history,            ///< a force where a displacement is promised
  growing_shear_stiffness,  ///< with the overlap, which a displacement history pays for in energy
  history_unlimited,        ///< the force is limited, the history is not
  unclipped_formula,        ///< YADE, Chrono: the damping of the unclipped impact
  stiffness_tangent,        ///< a tangent for a secant: 3/2
  restart_loses,            ///< one component is not stored
  exchange_keeps,           ///< the history is not turned round with the pair
  never_forgets,            ///< a contact that opened keeps its shear
  divides_by_overlap,       ///< lammps #4180: sqrt(F/o)
};

struct HostLaw {
  Fault fault = Fault::none;
  bool hertz = false;
  double modulus = 1e10;  ///< E* [Pa]
  double stiffness_given = 1e6;
  double friction = 0.4;
  double damping = 0.3;  ///< alpha [1]
  double unclipped_damping = 0.3;
  double nanometre = 1e-9;
  double fixed_dt = 1e-6;

  struct State {
    std::shared_ptr<std::vector<double>> shear = std::make_shared<std::vector<double>>(3, 0.0);
    bool shared = false;

    State() = default;
    State(const State& other) : shear(other.shear), shared(other.shared) {
      if (!shared) shear = std::make_shared<std::vector<double>>(*other.shear);
    }
    State& operator=(const State& other) {
      shared = other.shared;
      shear = shared ? other.shear : std::make_shared<std::vector<double>>(*other.shear);
      return *this;
    }
    ~State() = default;
  };

  verify::Interaction operator()(const verify::Bodies& pair, double dt, State& state) const {
    using V = Eigen::Vector3d;
    state.shared = fault == Fault::shared_state;
    const auto& a = pair.one;
    const auto& b = pair.two;
    const V branch = b.position - a.position;
    const double distance = branch.norm();
    const V n = branch / distance;
    double overlap = a.radius + b.radius - distance;
    const double lever1 = a.radius - (fault == Fault::velocity_lever ? 0 : overlap / 2);
    const double lever2 = b.radius - (fault == Fault::velocity_lever ? 0 : overlap / 2);
    const double place = overlap;
    if (fault == Fault::length_constant) overlap -= nanometre;

    V s((*state.shear)[0], (*state.shear)[1], (*state.shear)[2]);
    if (!(overlap > 0) && !(fault == Fault::divides_by_overlap && overlap >= 0)) {
      if (fault != Fault::never_forgets) *state.shear = {0, 0, 0};
      return answer(V::Zero(), n, pair, place);
    }

    V velocity = b.velocity - a.velocity;
    if (fault != Fault::without_spin) velocity -= b.spin.cross(lever2 * n) + a.spin.cross(lever1 * n);
    const double approach = fault == Fault::absolute_velocity ? b.velocity.dot(n) : velocity.dot(n);
    const V slip = velocity - velocity.dot(n) * n;

    const double secant = normal_secant(pair, overlap), kt = shear_stiffness(pair, overlap);
    double mass = a.mass * b.mass / (a.mass + b.mass);
    if (fault == Fault::mass_of_one) mass = a.mass;
    const double alpha = fault == Fault::unclipped_formula ? unclipped_damping : damping;
    const double cn = alpha * std::sqrt(mass * secant);
    const double ct = (fault == Fault::shear_dashpot_sign ? -alpha : alpha) * std::sqrt(mass * kt);
    double fn = secant * overlap - cn * approach;
    if (fault == Fault::divides_by_overlap)
      fn = secant * overlap - alpha * std::sqrt(mass * (secant * overlap / overlap)) * approach;
    if (fault == Fault::jump) fn += jump_force(pair);
    if (fault != Fault::pulls && fault != Fault::limit_by_magnitude) fn = std::max(fn, 0.0);

    if (fault != Fault::not_turned) {
      const double length = s.norm();
      s -= s.dot(n) * n;
      if (s.norm() > 0) s *= length / s.norm();
    }
    V ft;
    const double step = fault == Fault::own_dt ? fixed_dt : dt;
    if (fault == Fault::force_history) {  // s is a force
      s -= kt * slip * step;
      ft = s - ct * slip;
    } else {
      s += slip * step;
      ft = -kt * s - ct * slip;
    }
    double strength = friction * std::max(fn, 0.0);
    if (fault == Fault::limit_by_magnitude) strength = friction * std::abs(fn);
    if (fault == Fault::limit_by_total) strength = friction * std::hypot(fn, ft.norm());
    if (fault == Fault::limit_by_component) {
      for (double& f : ft) f = std::min(std::max(f, -strength), strength);
    } else if (ft.norm() > strength) {
      ft *= strength / ft.norm();
      if (fault == Fault::force_history) {
        s = ft + ct * slip;
      } else if (fault != Fault::history_unlimited) {
        s = -(ft + ct * slip) / kt;
      }
    }
    *state.shear = {s.x(), s.y(), s.z()};
    return answer(fn * n + ft, n, pair, place);
  }

  HostLaw in_units(const verify::Units& u) const {
    HostLaw other = *this;
    other.modulus *= u.pressure();
    other.stiffness_given *= u.stiffness();
    if (fault == Fault::own_dt) other.fixed_dt *= u.time;  // a wrong step, but in the right units
    return other;
  }
  std::vector<double> store(const State& state) const {
    std::vector<double> kept = *state.shear;
    if (fault == Fault::restart_loses) kept.pop_back();
    return kept;
  }
  State load(std::vector<double> values) const {
    values.resize(3, 0.0);
    State state;
    *state.shear = values;
    return state;
  }
  State exchanged(const State& state) const {
    State other = state;
    if (fault != Fault::exchange_keeps)
      for (double& x : *other.shear) x = -x;
    return other;
  }
  ContactStiffness<double> stiffness(const verify::Bodies& pair, const State&) const {
    const double overlap = pair.one.radius + pair.two.radius - pair.branch().norm();
    const double tangent = normal_secant(pair, overlap) * (hertz ? 1.5 : 1.0);
    return {tangent * (fault == Fault::stiffness_tangent ? 1.5 : 1.0), shear_stiffness(pair, overlap)};
  }

 private:
  /// About a hundredth of the force at an overlap of a thousandth of the radius.
  double jump_force(const verify::Bodies& p) const {
    const double r = p.one.radius * p.two.radius / (p.one.radius + p.two.radius);
    return hertz ? 3e-6 * modulus * r * r : 3e-5 * stiffness_given * r;
  }
  double normal_secant(const verify::Bodies& p, double overlap) const {
    const double r = p.one.radius * p.two.radius / (p.one.radius + p.two.radius);
    return hertz ? 4.0 / 3.0 * modulus * std::sqrt(r * overlap) : stiffness_given;
  }
  double shear_stiffness(const verify::Bodies& p, double overlap) const {
    const double r = p.one.radius * p.two.radius / (p.one.radius + p.two.radius);
    return 0.8 * normal_secant(p, overlap) *
           (fault == Fault::growing_shear_stiffness ? 20 * std::sqrt(overlap / r) : 1.0);
  }

  verify::Interaction answer(const Eigen::Vector3d& force, const Eigen::Vector3d& n, const verify::Bodies& pair,
                             double overlap) const {
    const double less = fault == Fault::torque_lever ? 0.0 : overlap / 2;
    const Eigen::Vector3d back = fault == Fault::reaction ? Eigen::Vector3d(-0.99 * force) : Eigen::Vector3d(-force);
    const Eigen::Vector3d torque1 = -(pair.one.radius - less) * n.cross(force);
    const Eigen::Vector3d torque2 = -(pair.two.radius - less) * n.cross(force);
    return {force, back, torque1, fault == Fault::torque_sign ? Eigen::Vector3d(-torque2) : torque2};
  }
};

}  // namespace contactlaws::test
