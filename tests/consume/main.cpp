#include <contactlaws/contactlaws.hpp>
#include <iostream>

double force_in_other_unit(double overlap);

int main() {
  using namespace contactlaws;
  const ElasticMaterial<double> glass{70e9, 0.2, 2500.0};
  const PairProperties<double> pair = pair_properties(sphere(glass, 1e-3), plane(glass));
  HillProperties<double> properties;
  properties.friction = 0.5;
  properties.suction = 2e4;
  properties.damping_constant = 0.1;
  const Hill<double> law = hill(properties);

  ContactKinematics<double> kinematics{};
  kinematics.normal = {1.0, 0.0, 0.0};
  kinematics.overlap = 1e-7;
  kinematics.velocity = {0.0, 1e-3, 0.0};
  kinematics.dt = 1e-6;
  const auto step = law.step(pair, kinematics, Hill<double>::State{});

  const double elsewhere = force_in_other_unit(kinematics.overlap);
  std::cout << "contactlaws " << version << ": " << step.normal_elastic << " N, " << elsewhere << " N\n";
  return step.normal_elastic > 0.0 && step.normal_elastic == elsewhere ? 0 : 1;
}
