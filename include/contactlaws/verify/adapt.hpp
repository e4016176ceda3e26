// SPDX-License-Identifier: MIT
// A ContactLaw as a force update: the laws of this library pass the same checks as any other.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "contactlaws/verify/force_update.hpp"

namespace contactlaws::verify {

template <class Law>
struct Adapted {
  using T = typename Law::Scalar;
  using State = typename Law::State;

  Law law;        ///< of contactlaws
  T young;        ///< effective modulus E* [Pa]
  T shear;        ///< effective shear modulus G* [Pa]
  State first{};  ///< of a new contact

  // The hooks of force_update.hpp.

  /// One step.
  Interaction operator()(const Bodies& bodies, double dt, State& state) const {
    const auto geometry = place(bodies);
    const auto motion =
        contact_kinematics<double>(geometry, {bodies.one.position, bodies.one.velocity, bodies.one.spin},
                                   {bodies.two.position, bodies.two.velocity, bodies.two.spin}, dt);
    const auto step = law.step(pair(bodies), motion.template cast<T>(), state);
    state = step.state;
    const Vector force = step.force.template cast<double>(), couple = step.couple.template cast<double>();
    return {force, Vector(-force), Vector(geometry.arm1.cross(-force) - couple),
            Vector(geometry.arm2.cross(force) + couple), static_cast<double>(step.bridge_force)};
  }

  State start() const { return first; }  ///< the state of a new contact
  /// The state as numbers.
  std::vector<double> store(const State& state) const {
    std::vector<T> values(Law::state_size);
    Law::store(state, values.data());
    return {values.begin(), values.end()};
  }
  /// The state of these numbers.
  State load(const std::vector<double>& values) const {
    const std::vector<T> kept(values.begin(), values.end());
    return Law::load(kept.data());
  }
  /// The state of the same contact with the bodies swapped.
  State exchanged(const State& state) const {
    std::vector<double> values = store(state);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] *= Law::exchange_sign(i);
    return load(values);
  }
  /// The law in other units.
  Adapted in_units(const Units& units) const {
    const auto slot = [&units](auto s) {
      for (const auto& p : decltype(s)::parameters()) s.*p.member = T(s.*p.member * factor(units, p.unit));
      return s;
    };
    std::vector<double> values = store(first);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] *= factor(units, Law::state_values()[i].unit);
    const Law other{slot(law.normal), slot(law.damping), slot(law.shear), slot(law.bridge), slot(law.rolling)};
    return {other, T(young * units.pressure()), T(shear * units.pressure()), load(values)};
  }
  /// The slopes of the springs on the active branch. (Law::stiffness() is the largest of any branch, for the time step.)
  ContactStiffness<double> stiffness(const Bodies& bodies, const State& state) const {
    State scratch = state;
    const auto response = law.normal.respond(scratch, pair(bodies), T(positive_part<double>(place(bodies).overlap)));
    T along = T(0);
    if constexpr (decltype(law.shear)::acts) along = law.shear.stiffness(pair(bodies), response);
    return {static_cast<double>(response.stiffness), static_cast<double>(along)};
  }

 private:
  static ContactGeometry<double> place(const Bodies& b) {
    return sphere_sphere<double>(b.one.position, b.one.radius, b.two.position, b.two.radius);
  }
  PairProperties<T> pair(const Bodies& b) const {
    const double radius = 1 / (1 / b.one.radius + 1 / b.two.radius), mass = 1 / (1 / b.one.mass + 1 / b.two.mass);
    return {T(radius),
            young,
            shear,
            T(mass),
            T(minimum<double>(b.one.radius, b.two.radius)),
            T(b.one.radius + b.two.radius)};
  }
  static double factor(const Units& units, const std::string& unit) {
    if (unit == "1" || unit == "rad") return 1.0;
    if (unit == "m") return units.length;
    if (unit == "m^3") return units.length * units.length * units.length;
    if (unit == "N") return units.force();
    if (unit == "N m") return units.force() * units.length;
    if (unit == "N/m" || unit == "J/m^2") return units.stiffness();
    if (unit == "Pa") return units.pressure();
    if (unit == "kg/s") return units.damping();
    throw std::invalid_argument("verify::Adapted: unit '" + unit + "' is not known");
  }
};

/// The law between two spheres of these effective moduli; radii and masses are those of the options. `first`: the state in
/// which a contact starts, e.g. wetted.
template <class Law>
Adapted<Law> adapt(const Law& law, const PairProperties<typename Law::Scalar>& pair,
                   const typename Law::State& first = {}) {
  return {law, pair.effective_young, pair.effective_shear, first};
}

}  // namespace contactlaws::verify
