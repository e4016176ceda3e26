// SPDX-License-Identifier: MIT
// Measures of a scene of clumps: its largest stable time step, and its distance from equilibrium.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "clumps.hpp"
#include "measures.hpp"

namespace dem {

/// Largest stable step [s], before a safety factor: sqrt(m / sum k) of each clump along each axis, and sqrt(I / sum kappa)
/// about each, I being the smallest principal moment and
///
///   kappa_i = k_n (a x n)_i^2 + k_s (|e_i x a|^2 - (a x n)_i^2)        a the arm from the clump's centre to the contact
///
/// Contacts stiffen as they close, so each clump counts at least one contact of the stiffness `nominal` [N/m] at its rim.
template <class Scene>
double stable_time_step(const Scene& scene, const Clumps& clumps, double nominal) {
  std::vector<contactlaws::BodyStiffness<double>> sums(clumps.size());
  const auto add = [&](std::size_t ball, const contactlaws::ContactStiffness<double>& k, const Vec3& normal,
                       const Vec3& arm) {
    if (scene.balls.group[ball] < 0) return;
    const auto id = static_cast<std::size_t>(scene.balls.group[ball]);
    const Vec3 from_centre = scene.balls.position[ball] + arm - clumps.all[id].position;
    const Vec3 turning = from_centre.cross(normal).cwiseAbs2();
    const Vec3 swept = Vec3::Constant(from_centre.squaredNorm()) - from_centre.cwiseAbs2();
    sums[id].translation += k.normal * normal.cwiseAbs2() + k.shear * (Vec3::Ones() - normal.cwiseAbs2());
    sums[id].rotation += k.normal * turning + k.shear * (swept - turning);
  };
  detail::for_each_contact(
      scene, [&](const auto& law, const auto& contacts, std::size_t c, const auto& outcome, bool ball_first) {
        const auto& geometry = outcome.geometry;
        const auto k = law.stiffness(contacts.pair(c), geometry.overlap, contacts.state(c));
        if (ball_first) add(contacts.first(c), k, geometry.normal, geometry.arm1);
        add(contacts.second(c), k, geometry.normal, geometry.arm2);
      });
  double step = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < clumps.size(); ++i) {
    const Clump& c = clumps.all[i];
    const double least = c.inertia.minCoeff();
    step = std::min({step, std::sqrt(c.mass / nominal), std::sqrt(least / (nominal * c.reach * c.reach))});
    step = contactlaws::stable_time_step(c.mass, least, sums[i], step);
  }
  return step;
}

/// Mean unbalanced force of the free clumps over the mean normal force of the active contacts [1].
template <class Scene>
double unbalanced_force(const Scene& scene, const Clumps& clumps) {
  double normal = 0.0, unbalanced = 0.0;
  std::size_t contacts = 0, bodies = 0;
  detail::for_each_contact(scene, [&](const auto&, const auto&, std::size_t, const auto& outcome, bool) {
    if (!(outcome.response.normal_force > 0.0)) return;
    normal += outcome.response.normal_force;
    ++contacts;
  });
  for (const Clump& c : clumps.all) {
    if (!c.free) continue;
    unbalanced += (c.force + c.mass * scene.gravity).norm();
    ++bodies;
  }
  if (contacts == 0 || bodies == 0) return std::numeric_limits<double>::infinity();
  return unbalanced / static_cast<double>(bodies) / (normal / static_cast<double>(contacts));
}

/// Kinetic energy of the clumps, half a step earlier [J].
inline double kinetic_energy(const Clumps& clumps) {
  double sum = 0.0;
  for (const Clump& c : clumps.all) sum += c.kinetic_energy();
  return sum;
}

}  // namespace dem
