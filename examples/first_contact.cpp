// SPDX-License-Identifier: MIT
// The README's program: two grains collide, from positions to forces to positions.
#include <iostream>

#include "contactlaws/contactlaws.hpp"

int main() {
  using namespace contactlaws;
  const ElasticMaterial<double> granite{29e9, 0.15, 2650.0};  // E [Pa], nu [1], density [kg/m^3]
  DryHillProperties<double> properties;
  properties.friction = 0.4;
  properties.damping_constant = damping_constant<DryHill<double>>(0.7);  // restitution 0.7
  const auto law = dry_hill(properties);
  const double radius = 5e-3, mass = sphere_mass(radius, 2650.0);
  const auto pair = pair_properties(sphere(granite, radius), sphere(granite, radius));
  const double dt = impact_duration(pair, 1.0) / 100.0;  // of an impact at 1 m/s

  BodyMotion<double> one{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};  // position [m], velocity [m/s], spin [rad/s]
  BodyMotion<double> two{{0.01, 0, 0}, {-1, 0, 0}, {0, 0, 0}};
  DryHill<double>::State history{};  // of the contact, kept by you; {}: a new one
  for (int i = 0; i < 200; ++i) {
    const auto contact = sphere_sphere(one.position, radius, two.position, radius);
    const auto step = law.step(pair, contact_kinematics(contact, one, two, dt), history);
    history = step.state;
    one.velocity -= step.force * (dt / mass);  // the force acts on body 2
    two.velocity += step.force * (dt / mass);
    one.position += one.velocity * dt;
    two.position += two.velocity * dt;
  }
  std::cout << "they part at " << two.velocity.x() - one.velocity.x() << " m/s\n";
}
