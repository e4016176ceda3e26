#include <contactlaws/contactlaws.hpp>

double force_in_other_unit(double overlap) {
  using namespace contactlaws;
  const ElasticMaterial<double> glass{70e9, 0.2, 2500.0};
  const PairProperties<double> pair = pair_properties(sphere(glass, 1e-3), plane(glass));
  ContactKinematics<double> kinematics{};
  kinematics.normal = {1.0, 0.0, 0.0};
  kinematics.overlap = overlap;
  kinematics.velocity.setZero();
  DryHillProperties<double> properties;
  properties.friction = 0.5;
  properties.damping_constant = 0.1;
  return dry_hill(properties).step(pair, kinematics, {}).normal_elastic;
}
