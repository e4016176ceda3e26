// SPDX-License-Identifier: MIT
// Two bounds of the time step.
//
// Stable: from the stiffnesses of the contacts of a body (Potyondy 2019, Sec. 1.9; Itasca's scheme per axis):
//
//   translation  sqrt(m / sum k_i),      k_i  = k_n n_i^2 + k_s (1 - n_i^2)            along axis i
//   rotation     sqrt(I / sum kappa_i),  kappa_i = k_s r^2 (1 - n_i^2)                 about axis i, r the arm
//
// The smallest over axes and bodies, times a safety factor. The limit of central differences for one spring is
// 2 sqrt(m / k); neighbours that move against each other halve it.
//
// Impact: stiffness grows with the overlap, so it does not bound an impact that is still to come. The duration of an elastic
// impact of two spheres at speed v does (Hertz 1881; Johnson 1985, Eqs 11.21 and 11.24):
//
//   o_max = (15 m* v^2 / (16 E* sqrt(R*)))^(2/5)      t_c = 2.943275 o_max / v
//   2.943275 = 4 sqrt(pi) Gamma(2/5) / (5 Gamma(9/10))
//
// It holds for Hertz. Rough laws are softer than Hertz at any overlap, so their impacts last longer. An impact on a linear
// spring k lasts pi sqrt(m*/k) at any speed, which the stable step covers. Steps of t_c / n of the leapfrog scheme gain at most
// this share of the energy of an undamped impact, over all moments of touch (tests/dem/test_fast_impact.cpp):
//
//   n      4       5       8       10      16      20
//   gain   6.8e-2  3.6e-2  9.6e-3  5.3e-3  1.6e-3  8.6e-4
#pragma once

#include "contactlaws/contact_law.hpp"

namespace contactlaws {

/// Sum of the stiffnesses of a body's contacts, per axis.
template <class T>
struct BodyStiffness {
  Vec3<T> translation = Vec3<T>(T(0), T(0), T(0));  ///< [N/m]
  Vec3<T> rotation = Vec3<T>(T(0), T(0), T(0));     ///< [N m]

  /// Adds a contact; `arm` [m] from the body's centre to it.
  CONTACTLAWS_HD void add(const ContactStiffness<T>& contact, const Vec3<T>& normal, const T& arm) noexcept {
    for (int i = 0; i < 3; ++i) {
      const T along = normal[i] * normal[i];
      translation[i] = translation[i] + contact.normal * along + contact.shear * (T(1) - along);
      rotation[i] = rotation[i] + contact.shear * arm * arm * (T(1) - along);
    }
  }
};

/// Largest stable step [s] of a body of mass [kg] and moment of inertia [kg m^2], before a safety factor;
/// `untouched` [s] where it has no contact.
template <class T>
T stable_time_step(const T& mass, const T& inertia, const BodyStiffness<T>& stiffness, const T& untouched) {
  using std::sqrt;
  T step = untouched;
  for (int i = 0; i < 3; ++i) {
    if (stiffness.translation[i] > T(0)) step = minimum<T>(step, T(sqrt(T(mass / stiffness.translation[i]))));
    if (stiffness.rotation[i] > T(0)) step = minimum<T>(step, T(sqrt(T(inertia / stiffness.rotation[i]))));
  }
  return step;
}

/// Largest overlap [m] of an elastic Hertz impact at the closing speed `speed` > 0 [m/s]. Error: <= 16 ULP for grains of 1 um to
/// 1 m at 1e-6 to 1e3 m/s, since the exponent 2/5 is rounded (tests/composition/test_timestep.cpp).
template <class T>
T impact_overlap(const PairProperties<T>& pair, const T& speed) {
  using std::pow;
  using std::sqrt;
  const T base =
      T(15) * pair.effective_mass * speed * speed / T(T(16) * pair.effective_young * T(sqrt(pair.effective_radius)));
  return pow(base, T(T(2) / T(5)));
}

/// Duration [s] of an elastic Hertz impact at the closing speed `speed` > 0 [m/s]; the shortest of an impact for laws that are
/// softer than Hertz. Error: as impact_overlap().
template <class T>
T impact_duration(const PairProperties<T>& pair, const T& speed) {
  return scalar_cast<T>(2.94327518432470465738L) * impact_overlap<T>(pair, speed) / speed;
}

}  // namespace contactlaws
