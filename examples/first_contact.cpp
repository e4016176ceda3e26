// SPDX-License-Identifier: MIT
// A law, a pair of grains, one step: the force between two granite grains that are pressed together by 0.1 mm.
#include <iostream>

#include "contactlaws/laws.hpp"

int main() {
  using namespace contactlaws;
  const ElasticMaterial<double> granite{29e9, 0.15, 2650.0};  // E [Pa], nu [1], density [kg/m^3]
  const DryHill<double> law = dry_hill<double>({0.4});        // friction [1]; no suction, no dashpots
  const auto pair = pair_properties(sphere(granite, 7.5e-3), sphere(granite, 5e-3));  // radii [m]

  const Vec3<double> up(0.0, 0.0, 1.0), sideways(0.01, 0.0, 0.0);
  const ContactKinematics<double> motion{up, 0.1e-3, sideways, 1e-3};  // normal, overlap [m], velocity [m/s], step [s]
  const DryHill<double>::State before{};                               // a new contact
  const auto [force, after, elastic, surface, attraction, active, sliding] = law.step(pair, motion, before);

  std::cout << "force on the upper grain: " << force.transpose() << " N\n"
            << "shear history kept for the next step: " << after.shear[0] << " N\n"
            << "sliding: " << (sliding ? "yes" : "no") << '\n';
}
