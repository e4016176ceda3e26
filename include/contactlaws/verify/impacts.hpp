// SPDX-License-Identifier: MIT
// Impacts of two free solid spheres: restitution head-on, energy under all angles.
//
// Leapfrog: positions by the velocities of half a step ago, velocities by the forces there, as a DEM code does. Its own
// error falls with the step; an impact is computed twice, and counts as far as both agree.
#pragma once

#include <cmath>

#include "contactlaws/verify/energies.hpp"

namespace contactlaws::verify {

namespace detail {

struct Impact {
  double energy_before;  ///< kinetic [J]
  double energy_after;   ///< [J]
  double rebound;        ///< separation over approach, along the line of centres of the start [1]
  Path path;             ///< as the contact saw it
};

inline double kinetic_energy(const Bodies& bodies) {
  double sum = 0.0;
  for (const Body* b : {&bodies.one, &bodies.two})
    sum += b->mass * (b->velocity.squaredNorm() + 0.4 * b->radius * b->radius * b->spin.squaredNorm()) / 2;
  return sum;
}

/// Touching spheres that approach at `speed` [m/s], slanted by `angle` [rad], in some `steps` steps.
template <class Law>
Impact collide(const Trial<Law>& trial, double speed, double angle, int steps) {
  using std::cos;
  using std::sin;
  const Options& o = trial.options;
  const Vector line(0, 0, 1), none(0, 0, 0);
  Bodies b{
      {none, none, none, o.radius1, o.mass1},
      {line * (o.radius1 + o.radius2), Vector(speed * sin(angle), 0, -speed * cos(angle)), none, o.radius2, o.mass2}};
  Impact impact{kinetic_energy(b), 0.0, 0.0, {}};
  const double dt = 3 * trial.scales.time / steps, open = -o.claims.range.value_or(0.0);
  State<Law> state = start_of(trial.law);
  for (int i = 0; i < 100 * steps; ++i) {  // one that sticks together ends here
    for (Body* body : {&b.one, &b.two}) body->position = body->position + body->velocity * dt;
    const auto geometry = sphere_sphere<double>(b.one.position, o.radius1, b.two.position, o.radius2);
    impact.path.push_back(contact_kinematics<double>(geometry, {b.one.position, b.one.velocity, b.one.spin},
                                                     {b.two.position, b.two.velocity, b.two.spin}, dt));
    const Interaction a = trial.law(b, dt, state);
    const auto kick = [dt](Body& body, const Vector& force, const Vector& torque) {
      body.velocity = body.velocity + force * (dt / body.mass);
      body.spin = body.spin + torque * (dt / (0.4 * body.mass * body.radius * body.radius));
    };
    const Vector force1 = a.force1 ? *a.force1 : Vector(-a.force);
    kick(b.one, force1, a.torque1 ? *a.torque1 : Vector(geometry.arm1.cross(force1)));
    kick(b.two, a.force, a.torque2 ? *a.torque2 : Vector(geometry.arm2.cross(a.force)));
    if (geometry.overlap <= open) break;
  }
  impact.energy_after = kinetic_energy(b);
  impact.rebound = dot<double>(Vector(b.two.velocity - b.one.velocity), line) / (speed * cos(angle));
  settle(impact.path);
  return impact;
}

}  // namespace detail

/// At a speed that gets about as deep as is usual, a tenth and a hundredth of it. 20 000 steps leave some 1e-4.
template <class Law>
Result restitution_as_asked(const Trial<Law>& trial) {
  constexpr const char* name = "restitution";
  if (!trial.options.claims.restitution) return not_claimed(name);
  constexpr int steps = 20000;
  const double asked = *trial.options.claims.restitution;
  Result result{name};
  result.worst = {0.0, 1e-3};
  result.measure = "off what is asked";
  for (const double slower : {1.0, 0.1, 0.01}) {
    const auto off = [&](int n) {
      using std::fabs;
      return fabs(detail::collide(trial, slower * trial.scales.speed(), 0.0, n).rebound - asked);
    };
    const double error = off(steps);
    if (!result.worst.see(error) || !result.worst.failed()) continue;
    int few = 20;  // the fewest steps in which the impact is itself to a tenth of the error
    while (few < steps && !(off(few) > 0.9 * error && off(few) < 1.1 * error)) few *= 2;
    result.path = detail::collide(trial, slower * trial.scales.speed(), 0.0, few).path;
    result.verdict = Verdict::fail;
  }
  return result;
}

/// Every two degrees from head-on to 88, at the usual speed. Allowed is a gain of 1e-4, and what another step makes of it.
template <class Law>
Result oblique_impacts(const Trial<Law>& trial) {
  constexpr const char* name = "energy of impacts";
  if (!trial.options.claims.passive_impacts) return not_claimed(name);
  constexpr int steps = 2000;
  Result result{name};
  result.worst = {0.0, 1e-4};
  double worst_angle = 0.0;
  using std::fabs;
  const auto gain = [&](double degrees, int n) {
    const detail::Impact i = detail::collide(trial, trial.scales.speed(), degrees * pi<double>() / 180, n);
    return i.energy_after / i.energy_before - 1;
  };
  for (int degrees = 0; degrees < 90; degrees += 2) {
    const double fine = gain(degrees, steps), error = fine - 2 * fabs(fine - gain(degrees, steps / 2));
    if (result.worst.see(error)) worst_angle = degrees;
  }
  std::ostringstream text;
  text << "of the kinetic energy, gained";
  if (result.worst.failed()) {
    result.verdict = Verdict::fail;
    text << " at " << worst_angle << " degrees";
    int few = 20;
    while (few < steps && gain(worst_angle, few) < 0.5 * result.worst.error) few *= 2;
    const double radians = worst_angle * pi<double>() / 180;
    result.path = detail::collide(trial, trial.scales.speed(), radians, few).path;
    // What the force alone gains along the imposed motion can be reduced; what a torque gains needs the bodies.
    const auto shows = [&](const Path& path) {
      return detail::gain_along(trial, path).error > result.worst.error / 10;
    };
    if (shows(result.path)) result.path = shrunk(result.path, shows);
  }
  result.measure = text.str();
  return result;
}

}  // namespace contactlaws::verify
