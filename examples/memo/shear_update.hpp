// SPDX-License-Identifier: MIT
// The shear force when the overlap changes: the memo's Appendix A (Figure 23), and one path with the four laws that are all
// called Hertz-Mindlin.
#pragma once

#include <string>

#include "expected.hpp"
#include "two_grains.hpp"

namespace memo {

template <template <class, class, class> class Shear>
using HertzWith =
    contactlaws::ContactLaw<contactlaws::Hertz<double>, contactlaws::NoDashpots<double>,
                            Shear<double, contactlaws::Mindlin<double>, contactlaws::rotation::ProjectRestore<double>>>;

template <class Law>
Law with_friction(double mu) {
  Law law;
  law.shear.friction = mu;
  return law;
}

/// Appendix A: press to o_A, shear to F_A, press to 2 o_A. Returns the shear force at the end over F_A.
template <class Law>
double shear_then_press(std::ostream& csv) {
  constexpr int steps = 100;
  TwoGrains<Law> grains(with_friction<Law>(10.0));
  Table path{"overlap_m", "shear_displacement_m", "shear_force_N"};
  const auto record = [&] {
    path.add({-grains.read().gap, grains.read().shear_displacement, grains.read().shear_force});
  };
  grains.lift(-depth, steps, record);
  grains.spin(turn, steps, record);
  const double sheared = grains.read().shear_force;
  grains.lift(-depth, steps, record);
  path.write_csv(csv);
  return grains.read().shear_force / sheared;
}

inline void appendix_a(OutputFolder& folder, CheckedNumbers& numbers) {
  numbers.push_back({"shear_update.force_history_ratio",
                     {},
                     {1.0, "1", "force kept"},
                     shear_then_press<HertzWith<contactlaws::ShearForce>>(folder.file("shear_update_force.csv")),
                     prescribed});
  numbers.push_back(
      {"shear_update.displacement_history_ratio",
       {},
       expected::square_root_of_2,
       shear_then_press<HertzWith<contactlaws::ShearDisplacement>>(folder.file("shear_update_displacement.csv")),
       prescribed});
}

/// The path of the eight laws: press by 0.1 mm, then move the top grain on an arc about the bottom grain, at constant overlap,
/// to a shear displacement of 99.0 um.
template <class Law>
TwoGrains<Law> press_and_shear_on_arc(double mu) {
  constexpr int steps = 1000;
  TwoGrains<Law> grains(with_friction<Law>(mu));
  const auto nothing = [] {};
  grains.lift(-depth, steps, nothing);
  const double distance = bottom_radius + top_radius - depth;
  const double angle = turn * (top_radius - depth / 2.0) / distance;
  for (int i = 1; i <= steps; ++i) {
    const double a = angle * i / steps;
    const Vec3 target = distance * Vec3(std::sin(a), 0.0, std::cos(a));
    grains.run((target - grains.scene.balls.position[1]) / grains.scene.time_step, Vec3::Zero(), 1, nothing);
  }
  return grains;
}

struct Force {
  double published;  ///< [N]
  common::Expected expected;
};

/// That path, then back to half the overlap, and to the whole again: shear forces there.
template <class Law>
void one_of_eight_laws(const std::string& name, const Force& backed_off, const Force& returned,
                       CheckedNumbers& numbers) {
  constexpr int steps = 1000;
  const auto nothing = [] {};
  auto grains = press_and_shear_on_arc<Law>(10.0);
  const auto row = [&](const char* what, const Force& force, double computed) {
    numbers.push_back({"eight_laws." + name + "." + what, force.published, force.expected, computed, along_arc});
  };
  row("normal_force", {1083.304632, expected::hill_normal_force}, grains.read().normal_force);
  row("shear_force", {1478.27164, expected::hill_shear_unlimited}, grains.read().shear_force);
  row("shear_force_sliding", {433.321853, expected::hill_shear_force},
      press_and_shear_on_arc<Law>(friction).read().shear_force);

  const Vec3 outward = grains.scene.balls.position[1].normalized() * (depth / 2.0 / (steps * grains.scene.time_step));
  grains.run(outward, Vec3::Zero(), steps, nothing);
  row("backed_off", backed_off, grains.read().shear_force);
  grains.run(-outward, Vec3::Zero(), steps, nothing);
  row("returned", returned, grains.read().shear_force);
}

/// The published figures are those of LAMMPS on this path: mindlin/force, mindlin_rescale/force, mindlin, mindlin_rescale.
inline CheckedNumbers eight_laws() {
  using namespace contactlaws;
  const Force whole{1478.27164, expected::hill_shear_unlimited};
  const Force root_half{1045.29590, expected::shear_root_half};
  const Force half{739.135823, expected::shear_half};
  CheckedNumbers numbers;
  one_of_eight_laws<HertzWith<ShearForce>>("force", whole, whole, numbers);
  one_of_eight_laws<HertzWith<ShearForceRescaled>>("force_rescaled", root_half, root_half, numbers);
  one_of_eight_laws<HertzWith<ShearDisplacement>>("displacement", root_half, whole, numbers);
  one_of_eight_laws<HertzWith<ShearDisplacementRescaled>>("displacement_rescaled", half, root_half, numbers);
  return numbers;
}

}  // namespace memo
