// SPDX-License-Identifier: MIT
// What the two sources of the C face share: a law behind one virtual call per array of contacts, and the boundary that no
// exception crosses.
#pragma once

#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "contactlaws.h"
#include "contactlaws/kinematics.hpp"
#include "contactlaws/pair.hpp"

namespace contactlaws_c {

using contactlaws::ContactKinematics;
using contactlaws::EffectiveModuli;
using contactlaws::PairProperties;
using contactlaws::StateValue;
using contactlaws::Vec3;

/// The arguments of contactlaws_step().
struct Contacts {
  double dt;
  std::size_t count;
  const contactlaws_body* body1;
  const contactlaws_body* body2;
  double* state;
  double (*force)[3];
  double (*torque1)[3];
  double (*torque2)[3];
};

inline PairProperties<double> pair_of(const EffectiveModuli<double>& moduli, const contactlaws_body& body1,
                                      const contactlaws_body& body2) {
  double mass = body1.mass + body2.mass;  // of the free one, where the other is held in space
  if (body1.mass > 0.0 && body2.mass > 0.0) mass = contactlaws::effective_mass(body1.mass, body2.mass);
  return body1.radius > 0.0 ? sphere_sphere_pair(moduli, body1.radius, body2.radius, mass)
                            : plane_sphere_pair(moduli, body2.radius, mass);
}

/// step(pair, kinematics, state) of each contact, which updates the state and returns force and couple.
template <class StepOne>
void for_each_contact(const Contacts& contacts, const EffectiveModuli<double>& moduli, std::size_t state_size,
                      const StepOne& step_one) {
  const auto store = [](const Vec3<double>& v, double* out) {
    for (int i = 0; i < 3; ++i) out[i] = v[i];
  };
  for (std::size_t i = 0; i < contacts.count; ++i) {
    const contactlaws_body& a = contacts.body1[i];
    const contactlaws_body& b = contacts.body2[i];
    const auto contact = contactlaws::sphere_contact(a.x, a.v, a.w, a.radius, b.x, b.v, b.w, b.radius, contacts.dt);
    double* const state = state_size > 0 ? contacts.state + i * state_size : nullptr;
    const auto step = step_one(pair_of(moduli, a, b), contact.kinematics, state);
    const auto turning = contactlaws::torques(contact, step.force, step.couple);
    store(step.force, contacts.force[i]);
    store(turning.on1, contacts.torque1[i]);
    store(turning.on2, contacts.torque2[i]);
  }
}

inline thread_local char error_text[1024] = "";

/// call(), or `failed` with the text of the exception that it threw.
template <class Result, class Call>
Result guarded(const Result& failed, const Call& call) noexcept {
  try {
    return call();
  } catch (const std::exception& error) {
    std::snprintf(error_text, sizeof(error_text), "%s", error.what());
  } catch (...) {
    std::snprintf(error_text, sizeof(error_text), "unknown exception");
  }
  return failed;
}

}  // namespace contactlaws_c

struct contactlaws_law {
  contactlaws_law(const contactlaws::EffectiveModuli<double>& of, std::vector<contactlaws::StateValue> values)
      : moduli(of), state_values(std::move(values)) {}
  contactlaws_law(const contactlaws_law&) = delete;
  contactlaws_law& operator=(const contactlaws_law&) = delete;
  virtual ~contactlaws_law() = default;

  virtual void new_state(double* state) const = 0;
  /// False if the law has no bridge.
  virtual bool make_wet(double overlap, double moisture_gap, double* state) const = 0;
  virtual double range(const contactlaws::PairProperties<double>& pair) const = 0;
  virtual void step(const contactlaws_c::Contacts& contacts) const = 0;

  const contactlaws::EffectiveModuli<double> moduli;
  const std::vector<contactlaws::StateValue> state_values;
};
