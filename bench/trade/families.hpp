// SPDX-License-Identifier: MIT
// The motions of the measurement: four families, each of 32 contacts drawn with the seed 20190405, of 240 steps.
//
// Body 1 stands still, somewhere within 0.1 m of the origin (so that positions cost float its digits, as they do in a DEM
// run); body 2 moves around it, as smooth functions of time say:
//
//   overlap o(t);   angle phi(t) by which the normal has turned about a fixed axis, in a plane of any direction;
//   sliding velocity u(t) of the surfaces in the plane of that turn;         twist: a common spin about the normal
//
//   o_m   deepest overlap, 10^-3.2 to 10^-2.2 R* (10^-2.6 to 10^-1.7 where the law is rough: its roughness counts)
//   v     speed of the elastic impact that reaches o_m, and t_c its duration (Johnson 1985, Eqs 11.23-11.24)
//   s     mu o_m, about what a contact's surfaces may slide before friction yields
//
//   oblique_impact   o = o_m sin(pi t/t_c), 0.99 t_c long; sliding starts at 0 to 3 v and decays; turns as far as the centre moves
//   cyclic_shear     pressed to o_m in 30 steps and let go by 2 % of it in 10 (held at its largest overlap, a rough contact would
//                    be loading or unloading as rounding has it, at very different stiffnesses); then two cycles of 100 steps,
//                    20 t_c each: slid to and fro by 0.2 to 3 s while the normal rocks by up to 0.05 rad and both bodies twist by
//                    up to 0.02 rad. A closed cycle
//   reload           pressed to o_m in 40 steps while slid by 0.5 s, then two cycles of 100 steps, 20 t_c each: down to
//                    0.3 .. 0.7 o_m and back. A closed cycle
//   wet_approach     from a gap of 0.3 g_r (2 R_o for g_r where the law has no bridge) to touch in 60.5 steps (touch at a step
//                    would be decided by rounding), to o_m and back in 121, slid by 2 s at most meanwhile, and apart
//                    towards 1.3 g_r in the rest; 240 steps take 20 t_c
// 240 steps a t_c is finer than DEM codes step; theirs is nearer to the rows of 5 and 10 steps at once.
// Velocities are those half a step earlier, as leapfrog has them, turned to the contact plane of now.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "contact_path/any_law.hpp"
#include "trajectories.hpp"

namespace trade {

namespace detail {

constexpr double pi = 3.14159265358979323846;

/// A number and its rate.
struct Moving {
  double value;
  double rate;
};

struct ContactMotion {
  std::function<Moving(double)> overlap;
  std::function<double(double)> angle;    ///< [rad]
  std::function<double(double)> sliding;  ///< [m/s]
  std::function<double(double)> twist;    ///< [rad/s]
};

/// From 0 to 1 and from standstill to standstill, as x goes from 0 to 1.
inline Moving ramp(double x) {
  if (x <= 0.0) return {0.0, 0.0};
  if (x >= 1.0) return {1.0, 0.0};
  return {(1.0 - std::cos(pi * x)) / 2.0, pi / 2.0 * std::sin(pi * x)};
}

}  // namespace detail

inline const std::vector<std::string>& families() {
  static const std::vector<std::string> names{"oblique_impact", "cyclic_shear", "reload", "wet_approach"};
  return names;
}

/// The motions of a family for a law; `multiple` steps at once.
inline Trajectories make_trajectories(const std::string& family, const contact_path::LawSpec& law,
                                      std::size_t multiple = 1, std::size_t contacts = 32) {
  using namespace detail;
  constexpr std::size_t steps = 240, pressing = 40, cycle = 100;
  const bool cyclic = family == "cyclic_shear" || family == "reload";
  const auto pair = contact_path::build_pair<double>(law);
  const bool rough = law.normal.has("roughness");
  const double friction = law.shear.number_or<double>("friction", 0.0);
  const double half = pair.length / 2.0,
               root = std::sqrt(std::max(half * half - pair.effective_radius * pair.length, 0.0));
  const double radius1 = half + root, radius2 = half - root;  // R1 R2 / (R1 + R2) = R*

  std::mt19937_64 random(20190405);
  std::uniform_real_distribution<double> uniform;
  std::normal_distribution<double> normal;
  const auto between = [&](double a, double b) { return a + (b - a) * uniform(random); };
  const auto direction = [&] { return Vec3<double>(normal(random), normal(random), normal(random)).normalized(); };

  struct Drawn {
    ContactMotion motion;
    Vec3<double> place, start, axis;
    double duration;
  };
  std::vector<Drawn> drawn;
  for (std::size_t c = 0; c < contacts; ++c) {
    const double deepest = pair.effective_radius * std::pow(10.0, rough ? between(-2.6, -1.7) : between(-3.2, -2.2));
    const double speed = std::sqrt(16.0 / 15.0 * pair.effective_young * std::sqrt(pair.effective_radius) *
                                   std::pow(deepest, 2.5) / pair.effective_mass);
    const double impact = 2.943275 * deepest / speed, slow = 20.0 * impact;
    const double bearable = (friction > 0.0 ? friction : 0.4) * deepest;
    const double first = between(0.0, 1.0), second = between(0.0, 1.0), third = between(-1.0, 1.0);
    const double start_of_cycle = slow * double(pressing) / double(cycle);
    ContactMotion m{{}, [](double) { return 0.0; }, [](double) { return 0.0; }, [](double) { return 0.0; }};
    double duration = 0.99 * impact;  // not to the end, where rounding decides whether there is an overlap at all
    if (family == "oblique_impact") {
      const double sideways = 3.0 * speed * first, length = pair.length;
      m.overlap = [=](double t) {
        return Moving{deepest * std::sin(pi * t / impact), deepest * pi / impact * std::cos(pi * t / impact)};
      };
      m.angle = [=](double t) { return sideways * t / length; };
      m.sliding = [=](double t) { return sideways * (1.0 - t / impact); };
    } else if (cyclic) {
      duration = slow * double(steps) / double(cycle);
      const auto phase = [=](double t) { return t <= start_of_cycle ? 0.0 : 2.0 * pi * (t - start_of_cycle) / slow; };
      const double rate = 2.0 * pi / slow;
      if (family == "cyclic_shear") {
        m.overlap = [=](double t) {
          const Moving up = ramp(t / (0.75 * start_of_cycle)), back = ramp((t / start_of_cycle - 0.75) / 0.25);
          return Moving{deepest * (up.value - 0.02 * back.value),
                        deepest * (up.rate / 0.75 - 0.02 * back.rate / 0.25) / start_of_cycle};
        };
        const double amplitude = bearable * (0.2 + 2.8 * first), rocking = 0.05 * second, twisting = 0.02 * third;
        m.angle = [=](double t) { return rocking * std::sin(phase(t)); };
        m.sliding = [=](double t) { return phase(t) > 0.0 ? amplitude * rate * std::cos(phase(t)) : 0.0; };
        m.twist = [=](double t) { return phase(t) > 0.0 ? twisting * rate * std::cos(phase(t)) : 0.0; };
      } else {
        const double low = 0.3 + 0.4 * first;
        m.overlap = [=](double t) {
          const Moving r = ramp(t / start_of_cycle);
          const double x = phase(t);
          if (!(x > 0.0)) return Moving{deepest * r.value, deepest * r.rate / start_of_cycle};
          const double dip = (1.0 - low) / 2.0;
          return Moving{deepest * (1.0 - dip * (1.0 - std::cos(x))), -deepest * dip * std::sin(x) * rate};
        };
        m.sliding = [=](double t) { return t < start_of_cycle ? 0.5 * bearable / start_of_cycle : 0.0; };
      }
    } else {
      duration = slow;
      const double rupture = law.bridge.acts() ? contact_path::build_law<double>(law, pair)->interaction_range(pair)
                                               : 2.0 * pair.min_radius;
      const double near = 0.3 * rupture, far = 1.3 * rupture;
      const double quarter = slow * 60.5 / double(steps);
      m.overlap = [=](double t) {
        const Moving come = ramp(t / quarter), go = ramp((t - 3.0 * quarter) / quarter);
        const double x = std::clamp((t - quarter) / (2.0 * quarter), 0.0, 1.0);  // of the time in touch
        const double pressed = std::pow(std::sin(pi * x), 2),
                     pressing_rate = pi / (2.0 * quarter) * std::sin(2.0 * pi * x);
        return Moving{deepest * pressed - near * (1.0 - come.value) - far * go.value,
                      deepest * pressing_rate + near * come.rate / quarter - far * go.rate / quarter};
      };
      m.sliding = [=](double) { return 4.0 * bearable * second / slow; };
    }
    const Vec3<double> start = direction();
    drawn.push_back({m,
                     {between(-0.1, 0.1), between(-0.1, 0.1), between(-0.1, 0.1)},
                     start,
                     start.cross(direction()).normalized(),
                     duration});
  }

  Trajectories trajectories;
  trajectories.name = family;
  trajectories.multiple = multiple;
  trajectories.cycle_start = cyclic ? (pressing + cycle) / multiple : 0;
  for (std::size_t step = 0; step < steps / multiple; ++step) {
    for (const Drawn& d : drawn) {
      const double dt = d.duration / double(steps) * double(multiple);
      const double now = dt * double(step + 1), then = now - dt / 2.0;
      const double angle = d.motion.angle(now);
      const Vec3<double> n = d.start * std::cos(angle) + d.axis.cross(d.start) * std::sin(angle);
      const Vec3<double> velocity = -d.motion.overlap(then).rate * n + d.motion.sliding(then) * d.axis.cross(n);
      const Vec3<double> other = d.place + (pair.length - d.motion.overlap(now).value) * n;
      const auto enter = [&](auto zero, auto& rows) {
        using T = decltype(zero);
        const auto in = [](const Vec3<double>& v) { return Vec3<T>(v.template cast<T>()); };
        const auto at = contactlaws::sphere_sphere<T>(in(d.place), T(radius1), in(other), T(radius2));
        rows.push_back({at.normal, at.overlap, in(velocity), T(dt), T(d.motion.twist(then))});
      };
      enter(double(0), trajectories.in_double);
      enter(float(0), trajectories.in_float);
      enter(Binary200(0), trajectories.exact);
    }
    trajectories.offset.push_back(trajectories.in_double.size());
  }
  return trajectories;
}

}  // namespace trade
