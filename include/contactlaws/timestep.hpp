// SPDX-License-Identifier: MIT
// A stable time step from the stiffnesses of the contacts (Potyondy 2019, Sec. 1.9; Itasca's scheme per axis):
//
//   translation  sqrt(m / sum k_i),      k_i  = k_n n_i^2 + k_s (1 - n_i^2)            along axis i
//   rotation     sqrt(I / sum kappa_i),  kappa_i = k_s r^2 (1 - n_i^2)                 about axis i, r the arm
//
// The smallest over axes and bodies, times a safety factor. The limit of central differences for one spring would be
// 2 sqrt(m / k); the factor 2 is what neighbours that move against each other use up.
#pragma once

#include "contactlaws/contact_law.hpp"

namespace contactlaws {

/// Stiffness that a body's contacts add up to, per axis.
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

}  // namespace contactlaws
