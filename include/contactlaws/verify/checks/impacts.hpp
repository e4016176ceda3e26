// SPDX-License-Identifier: MIT
// Impacts of two free solid spheres: restitution head-on, energy at all angles and several speeds.
//
// Leapfrog: positions by the velocities of half a step before, velocities by the forces there, as in a DEM code. Its own
// error falls with the step; an impact is computed twice, and counts as far as both agree.
#pragma once

#include <cmath>
#include <sstream>

#include "contactlaws/verify/checks/energies.hpp"

namespace contactlaws::verify {

namespace detail {

struct Impact {
  double energy_before;  ///< kinetic [J]
  double energy_after;   ///< [J]
  double rebound;        ///< separation over approach, along the initial line of centres [1]
};

inline double kinetic_energy(const Bodies& bodies) {
  double sum = 0.0;
  for (const Body* b : {&bodies.one, &bodies.two})
    sum += b->mass * (b->velocity.squaredNorm() + 0.4 * b->radius * b->radius * b->spin.squaredNorm()) / 2;
  return sum;
}

/// Touching spheres that approach at `speed` [m/s], inclined by `angle` [rad], in some `steps` steps. `path`, if any, is the
/// motion at the contact.
inline Impact collide(const Setup& setup, double speed, double angle, int steps, Path* path = nullptr) {
  using std::cos;
  using std::sin;
  const Options& o = setup.options;
  const Vector line(0, 0, 1), none(0, 0, 0);
  Bodies b{
      {none, none, none, o.radius1, o.mass1},
      {line * (o.radius1 + o.radius2), Vector(speed * sin(angle), 0, -speed * cos(angle)), none, o.radius2, o.mass2}};
  Impact impact{kinetic_energy(b), 0.0, 0.0};
  const double dt = 3 * setup.scales.time / steps, open = -o.claims.range.value_or(0.0);
  ForceUpdate::State state = setup.update.start();
  for (int i = 0; i < 100 * steps; ++i) {  // spheres that stick together stop here
    for (Body* body : {&b.one, &b.two}) body->position = body->position + body->velocity * dt;
    const auto geometry = sphere_sphere<double>(b.one.position, o.radius1, b.two.position, o.radius2);
    if (path)
      path->push_back(contact_kinematics<double>(geometry, {b.one.position, b.one.velocity, b.one.spin},
                                                 {b.two.position, b.two.velocity, b.two.spin}, dt));
    const Interaction a = setup.update.step(b, dt, state);
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
  if (path) set_normal_velocities(*path);
  return impact;
}

/// The fewest steps, from 20 on, in which an impact still `shows` a fault.
template <class Shows>
int fewest_steps(int most, const Shows& shows) {
  int few = 20;
  while (few < most && !shows(few)) few *= 2;
  return few;
}

}  // namespace detail

/// At a speed that gets about as deep as is usual, a tenth and a hundredth of it. 20 000 steps leave an error of some 1e-4.
inline Result restitution_as_claimed(const Setup& setup, const char* name) {
  constexpr int steps = 20000;
  Result result{name};
  result.worst = {0.0, 1e-3};
  result.measure = "off the one claimed";
  for (const double slower : {1.0, 0.1, 0.01}) {
    const double speed = slower * setup.scales.speed();
    const auto off = [&](int n) {
      using std::fabs;
      return fabs(detail::collide(setup, speed, 0.0, n).rebound - *setup.options.claims.restitution);
    };
    const double error = off(steps);
    if (!result.worst.add(error) || !result.worst.failed()) continue;
    const int few = detail::fewest_steps(steps, [&](int n) { return off(n) > 0.9 * error && off(n) < 1.1 * error; });
    result.path.clear();
    detail::collide(setup, speed, 0.0, few, &result.path);
    result.verdict = Verdict::fail;
  }
  return result;
}

/// From head-on to 89 degrees, at the usual speed, a tenth and a hundredth of it. Allowed is a gain of 1e-4, and the change
/// that halving the number of steps makes in it.
inline Result oblique_impacts(const Setup& setup, const char* name) {
  constexpr int steps = 1000;
  Result result{name};
  result.worst = {0.0, 1e-4};
  double worst_angle = 0.0, worst_speed = 0.0;
  const auto gain = [&](double speed, double degrees, int n) {
    const detail::Impact i = detail::collide(setup, speed, degrees * pi<double>() / 180, n);
    return i.energy_after / i.energy_before - 1;
  };
  for (const double slower : {1.0, 0.1, 0.01}) {
    for (const double degrees : {0, 5, 10, 15, 20, 25, 30, 35, 40, 45, 50, 55, 60, 65, 70, 75, 80, 84, 87, 88, 89}) {
      using std::fabs;
      const double speed = slower * setup.scales.speed(), fine = gain(speed, degrees, steps);
      if (!result.worst.add(fine - 2 * fabs(fine - gain(speed, degrees, steps / 2)))) continue;
      worst_angle = degrees;
      worst_speed = speed;
    }
  }
  std::ostringstream text;
  text << "of the kinetic energy, gained";
  if (result.worst.failed()) {
    result.verdict = Verdict::fail;
    text << " at " << worst_angle << " degrees and " << worst_speed << " m/s";
    const int few = detail::fewest_steps(
        steps, [&](int n) { return !(gain(worst_speed, worst_angle, n) < 0.5 * result.worst.error); });
    detail::collide(setup, worst_speed, worst_angle * pi<double>() / 180, few, &result.path);
    // A gain of the force along the imposed motion can be reduced; a gain of a torque needs the bodies.
    const auto shows = [&](const Path& path) {
      return detail::gain_along(setup, path).error > result.worst.error / 10;
    };
    if (shows(result.path)) result.path = reduced(result.path, shows);
  }
  result.measure = text.str();
  return result;
}

}  // namespace contactlaws::verify
