// Every law that inherits the properties. To add a law, add a line.
#pragma once

#include <cstddef>

#include "ballast/pohrt_popov_incremental.hpp"
#include "erased_law.hpp"
#include "make_laws.hpp"

namespace contactlaws::test {

template <class Normal, class Damping, class Shear, class Bridge, class Rolling = NoRolling<double>>
auto compose(const Normal& normal, const Damping& damping, const Shear& shear, const Bridge& bridge,
             const Rolling& rolling = {}) {
  return ContactLaw<Normal, Damping, Shear, Bridge, Rolling>{normal, damping, shear, bridge, rolling};
}

/// The slots with the parameters that the laws below have.
struct Slots {
  using T = double;
  Hertz<T> hertz;
  LinearSpring<T> spring{1e6};
  LinearModulus<T> modulus{5e8};
  NoDashpots<T> undamped;
  Dashpots<T> damped{0.3};
  Dashpots<T, Tension::clipped> clipped{0.6};
  Dashpots<T, Tension::allowed, ShearDashpot::none> normal_only{0.3};
  Dashpots<T, Tension::clipped, ShearDashpot::given> two_constants{0.3, 0.1};
  Dashpots<T, Tension::allowed, ShearDashpot::in_ratio> in_ratio{{0.3}, 1.2};
  Frictionless<T> smooth;
  Dry<T> dry;
  SuctionBridge<T> wet{2e5, 2.0, 2.0};
  CapillaryBridge<T> capillary = CapillaryBridge<T>::of(0.072, 0.5, 1e-9);
  CapillaryBridge<T, WillettClosed> willett = CapillaryBridge<T, WillettClosed>::of(0.072, 0.2, 1e-10);
  CapillaryBridge<T, Rabinovich> rabinovich = CapillaryBridge<T, Rabinovich>::of(0.072, 0.2, 1e-10);
  Mindlin<T> mindlin;
  ConstantRatio<T> ratio{0.6};
  ElasticRatio<T> elastic_ratio{0.6};
  RollingSpring<T> rolling{0.2};
  RoughSurface<T> ballast{2.13, 26.1e-6};
};

/// Calls `visit(name, values of history, law)` for laws in which every slot occurs: enough for a scalar beside double.
template <class Visit>
void visit_each_slot(const Visit& visit) {
  using T = double;
  using rotation::Project, rotation::Rotate;
  const Slots s{};
  visit("SmoothHertz", 0, SmoothHertz<T>{});
  visit("DryHill", 3, dry_hill<T>(0.4, 0.07));
  visit("Hill clipped", 4, compose(s.hertz, s.clipped, ShearForce<T>{s.mindlin, 0.4}, s.wet));
  visit("LinearFriction", 3, compose(s.modulus, s.undamped, ShearForce<T, ConstantRatio<T>>{s.ratio, 0.4}, s.dry));
  visit("LinearSpringDashpot", 3, compose(s.spring, s.damped, ShearForce<T, ConstantRatio<T>>{s.ratio, 0.4}, s.dry));
  visit("RoughBallast", 4,
        compose(PohrtPopovElastoPlastic<T>::of(s.ballast), s.undamped, ShearForce<T, ConstantRatio<T>>{s.ratio, 0.7},
                s.dry));
  visit("Rough elastic damped", 3,
        compose(PohrtPopov<T>::of(s.ballast), s.damped, ShearForce<T, ConstantRatio<T>>{s.ratio, 0.7}, s.dry));
  visit("Rough fresh wet", 2, compose(PohrtPopovElastoPlastic<T>::of(s.ballast), s.clipped, s.smooth, s.wet));
  visit("Rough same spot", 5,
        compose(PohrtPopovElastoPlastic<T, Recontact::same_spot>::of(s.ballast), s.normal_only,
                ShearForceRescaled<T, ElasticRatio<T>>{s.elastic_ratio, 0.5}, s.dry));
  visit("Hertz capillary", 2, compose(s.hertz, s.clipped, s.smooth, s.capillary));
  visit("Dmt", 3, compose(Dmt<T>{0.05}, s.two_constants, ShearForce<T>{s.mindlin, 0.4}, s.dry));
  visit("ThorntonNing", 4, compose(ThorntonNing<T>{3e8}, s.undamped, ShearForce<T>{s.mindlin, 0.4}, s.dry));
  visit("Hysteretic", 4,
        compose(LinearHysteretic<T>{1e6, 5e6, 5e5, 1e-3}, s.damped, ShearForce<T, ConstantRatio<T>>{s.ratio, 0.4},
                s.dry));
  visit("CohesivePowder", 7, compose(Jkr<T>{0.5}, s.damped, ShearForce<T>{s.mindlin, 0.4}, s.dry, s.rolling));
  visit("MindlinDeresiewicz", 17, compose(s.hertz, s.damped, MindlinDeresiewicz<T>{{}, {0.4}}, s.dry));
  visit("Hertz rolling", 6, compose(s.hertz, s.in_ratio, ShearForce<T>{s.mindlin, 0.4}, s.dry, s.rolling));
  visit("Rolling torque", 0, compose(s.hertz, s.undamped, s.smooth, s.dry, RollingTorque<T>{0.1}));
  visit("Rolling dashpot, twisting", 4,
        compose(s.hertz, s.undamped, s.smooth, s.dry, RollAndTwist<T, RollingSpringDashpot<T>>{{{}, 0.2, 0.3}, {0.4}}));
  visit("Twisting dashpot", 1, compose(s.hertz, s.undamped, s.smooth, s.dry, TwistingSpringDashpot<T>{{0.4, 0.3}}));
  visit(
      "Static and kinetic friction", 5,
      compose(s.hertz, s.undamped,
              ShearForce<T, Mindlin<T>, rotation::ProjectRestore<T>, StaticKinetic<T>>{s.mindlin, {0.3, 0.5}}, s.wet));
  visit("Rough incremental", 3, compose(PohrtPopovIncremental<T>::of(s.ballast, 1e-12), s.undamped, s.smooth, s.dry));
  visit("ForceRescaled Rotate", 7,
        compose(s.hertz, s.damped, ShearForceRescaled<T, Mindlin<T>, Rotate<T>>{s.mindlin, 0.5}, s.dry));
  visit("Displacement Project", 3,
        compose(s.hertz, s.undamped, ShearDisplacement<T, ConstantRatio<T>, Project<T>>{s.ratio, 0.5}, s.dry));
  visit("DisplacementRescaled", 4, compose(s.hertz, s.damped, ShearDisplacementRescaled<T>{s.mindlin, 0.5}, s.dry));
}

/// The same for every law. To add a law, add a line here, or above where it brings a slot of its own.
template <class Visit>
void visit_laws(const Visit& visit) {
  using T = double;
  using rotation::Project, rotation::Rotate;
  const Slots s{};
  visit_each_slot(visit);
  visit("DryHill clipped", 3, compose(s.hertz, s.clipped, ShearForce<T>{s.mindlin, 0.4}, s.dry));
  visit("Hill", 4, hill<T>(0.4, 2e5, 0.07));
  visit("LinearSpringDashpot clipped", 3,
        compose(s.spring, s.clipped, ShearForce<T, ConstantRatio<T>>{s.ratio, 0.4}, s.dry));
  visit("Hysteretic clipped", 1, compose(LinearHysteretic<T>{1e6, 2e6, 0.0, 1e-4}, s.clipped, s.smooth, s.dry));
  visit("Rolling of shear", 3,
        compose(s.spring, s.damped, s.smooth, s.dry, RollingSpringDashpot<T, ShearRolling<T>>{{0.6}, 0.1, 0.2}));
  visit("Rolling of a given stiffness", 3,
        compose(s.hertz, s.clipped, s.smooth, s.dry, RollingSpringDashpot<T, GivenRolling<T>>{{10.0}, 0.1, 0.2}));
  visit("Rolling, twisting of a given stiffness", 4,
        compose(s.spring, s.damped, s.smooth, s.dry,
                RollAndTwist<T, RollingSpring<T>, TwistingSpringDashpot<T, GivenTwisting<T>>>{{0.2},
                                                                                              {{10.0, 1e-4, 1e-5}}}));
  visit("Jkr wet", 2, compose(Jkr<T>{0.5}, s.undamped, s.smooth, s.wet));
  visit("Hertz damped", 0, compose(s.hertz, s.damped, s.smooth, s.dry));
  visit("Hertz wet", 1, compose(s.hertz, s.undamped, s.smooth, s.wet));
  visit("WetGrains by host", 5, compose(s.hertz, s.damped, ShearForce<T>{s.mindlin, 0.4}, s.capillary));
  visit("Hertz Willett", 2, compose(s.hertz, s.undamped, s.smooth, s.willett));
  visit("Hertz Rabinovich", 2, compose(s.hertz, s.undamped, s.smooth, s.rabinovich));
  visit("Linear damped wet", 1, compose(s.modulus, s.clipped, s.smooth, s.wet));
  visit("Force Project", 3, compose(s.hertz, s.undamped, ShearForce<T, Mindlin<T>, Project<T>>{s.mindlin, 0.5}, s.dry));
  visit("Force Rotate", 7, compose(s.hertz, s.damped, ShearForce<T, Mindlin<T>, Rotate<T>>{s.mindlin, 0.5}, s.wet));
  visit("ForceRescaled Project", 4,
        compose(s.hertz, s.clipped, ShearForceRescaled<T, Mindlin<T>, Project<T>>{s.mindlin, 0.5}, s.dry));
  visit("ForceRescaled", 4, compose(s.hertz, s.undamped, ShearForceRescaled<T>{s.mindlin, 0.5}, s.dry));
  visit("Displacement", 4, compose(s.hertz, s.damped, ShearDisplacement<T>{s.mindlin, 0.5}, s.wet));
  visit("MindlinDeresiewicz Rotate", 20,
        compose(s.hertz, s.undamped, MindlinDeresiewicz<T, Rotate<T>>{{}, {0.5}}, s.dry));
  visit("MindlinDeresiewicz yields", 18,
        compose(ThorntonNing<T>{3e8}, s.undamped, MindlinDeresiewicz<T>{{}, {0.4}}, s.dry));
  visit("Displacement Rotate", 6,
        compose(s.spring, s.clipped, ShearDisplacement<T, ConstantRatio<T>, Rotate<T>>{s.ratio, 0.5}, s.dry));
  visit("DisplacementRescaled Project", 5,
        compose(s.hertz, s.undamped, ShearDisplacementRescaled<T, Mindlin<T>, Project<T>>{s.mindlin, 0.5}, s.wet));
  visit("DisplacementRescaled Rotate", 7,
        compose(s.modulus, s.undamped, ShearDisplacementRescaled<T, ConstantRatio<T>, Rotate<T>>{s.ratio, 0.5}, s.dry));
}

/// The laws on T, for the definitions of all_laws<T>: every law in double and float, elsewhere every slot.
template <class T>
Laws<T> erase_laws() {
  Laws<T> laws;
  const auto add = [&laws](const char* name, std::size_t, const auto& law) {
    const auto on_scalar = law.template cast<T>();
    laws.push_back(std::make_unique<Erased<std::decay_t<decltype(on_scalar)>>>(name, on_scalar));
  };
  if constexpr (std::is_same_v<T, double> || std::is_same_v<T, float>) {
    visit_laws(add);
  } else {
    visit_each_slot(add);
  }
  return laws;
}

}  // namespace contactlaws::test
