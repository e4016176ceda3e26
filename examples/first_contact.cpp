// SPDX-License-Identifier: MIT
// The README's program: a law, a pair of grains, one step.
#include <iostream>

#include "contactlaws/laws.hpp"

int main() {
  using namespace contactlaws;
  const ElasticMaterial<double> granite{29e9, 0.15, 2650.0};  // E [Pa], nu [1], density [kg/m^3]
  DryHillProperties<double> properties;
  properties.friction = 0.4;
  const auto law = dry_hill(properties);
  const auto pair = pair_properties(sphere(granite, 7.5e-3), sphere(granite, 5e-3));  // radii [m]

  const Vec3<double> up(0.0, 0.0, 1.0), sideways(0.01, 0.0, 0.0);
  const ContactKinematics<double> motion{up, 0.1e-3, sideways, 1e-3};  // normal, overlap [m], velocity [m/s], step [s]
  const auto step = law.step(pair, motion, {});                        // {}: a new contact

  std::cout << step.force.transpose() << " N, sliding: " << step.sliding << '\n';
}
