// Every law that inherits the properties (test_law_properties*.cpp), and the random paths they are tried on.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "ballast/pohrt_popov_incremental.hpp"
#include "catch.hpp"
#include "contactlaws/contactlaws.hpp"
#include "make_laws.hpp"
#include "random.hpp"

namespace contactlaws::test {

template <class Normal, class Damping, class Shear, class Bridge>
auto compose(const Normal& normal, const Damping& damping, const Shear& shear, const Bridge& bridge) {
  return ContactLaw<Normal, Damping, Shear, Bridge>{normal, damping, shear, bridge};
}

/// Calls `visit(name, values of history, law)` for every law. To add a law, add a line.
template <class Visit>
void visit_laws(Visit visit) {
  using T = double;
  using rotation::Project, rotation::ProjectRestore, rotation::Rotate;
  const Hertz<T> hertz;
  const LinearSpring<T> spring{1e6};
  const LinearModulus<T> modulus{5e8};
  const NoDashpots<T> undamped;
  const Dashpots<T> damped{0.3};
  const Dashpots<T, Tension::clipped> clipped{0.6};
  const Frictionless<T> smooth;
  const Dry<T> dry;
  const SuctionBridge<T> wet{2e5, 2.0, 2.0};
  const Mindlin<T> mindlin;
  const ConstantRatio<T> ratio{0.6};
  const RoughSurface<T> ballast{2.13, 26.1e-6};

  visit("SmoothHertz", 0, SmoothHertz<T>{});
  visit("DryHill", 3, test::dry_hill<T>(0.4, 0.07));
  visit("DryHill clipped", 3, DryHill<T, Tension::clipped>{hertz, clipped, {mindlin, 0.4}, dry});
  visit("Hill", 4, test::hill<T>(0.4, 2e5, 0.07));
  visit("Hill clipped", 4, Hill<T, Tension::clipped>{hertz, clipped, {mindlin, 0.4}, wet});
  visit("LinearFriction", 3, LinearFriction<T>{modulus, undamped, {ratio, 0.4}, dry});
  visit("LinearSpringDashpot", 3, LinearSpringDashpot<T>{spring, damped, {ratio, 0.4}, dry});
  visit("LinearSpringDashpot clipped", 3, LinearSpringDashpot<T, Tension::clipped>{spring, clipped, {ratio, 0.4}, dry});

  visit("RoughBallast", 4, RoughBallast<T>{PohrtPopovElastoPlastic<T>::of(ballast), undamped, {ratio, 0.7}, dry});
  visit("Rough elastic damped", 3,
        compose(PohrtPopov<T>::of(ballast), damped, ShearForce<T, ConstantRatio<T>>{ratio, 0.7}, dry));
  visit("Rough fresh wet", 2,
        compose(PohrtPopovElastoPlastic<T, Recontact::fresh_surface>::of(ballast), clipped, smooth, wet));
  visit("Rough incremental", 3, compose(PohrtPopovIncremental<T>::of(ballast, 1e-12), undamped, smooth, dry));

  visit("Hertz damped", 0, compose(hertz, damped, smooth, dry));
  visit("Hertz wet", 1, compose(hertz, undamped, smooth, wet));
  visit("Linear damped wet", 1, compose(modulus, clipped, smooth, wet));

  visit("Force Project", 3, compose(hertz, undamped, ShearForce<T, Mindlin<T>, Project<T>>{mindlin, 0.5}, dry));
  visit("Force Rotate", 7, compose(hertz, damped, ShearForce<T, Mindlin<T>, Rotate<T>>{mindlin, 0.5}, wet));
  visit("ForceRescaled Project", 4,
        compose(hertz, clipped, ShearForceRescaled<T, Mindlin<T>, Project<T>>{mindlin, 0.5}, dry));
  visit("ForceRescaled", 4, compose(hertz, undamped, ShearForceRescaled<T>{mindlin, 0.5}, dry));
  visit("ForceRescaled Rotate", 7,
        compose(hertz, damped, ShearForceRescaled<T, Mindlin<T>, Rotate<T>>{mindlin, 0.5}, dry));
  visit("Displacement Project", 3,
        compose(hertz, undamped, ShearDisplacement<T, ConstantRatio<T>, Project<T>>{ratio, 0.5}, dry));
  visit("Displacement", 4, compose(hertz, damped, ShearDisplacement<T>{mindlin, 0.5}, wet));
  visit("Displacement Rotate", 6,
        compose(spring, clipped, ShearDisplacement<T, ConstantRatio<T>, Rotate<T>>{ratio, 0.5}, dry));
  visit("DisplacementRescaled Project", 5,
        compose(hertz, undamped, ShearDisplacementRescaled<T, Mindlin<T>, Project<T>>{mindlin, 0.5}, wet));
  visit("DisplacementRescaled", 4, compose(hertz, damped, ShearDisplacementRescaled<T>{mindlin, 0.5}, dry));
  visit("DisplacementRescaled Rotate", 7,
        compose(modulus, undamped, ShearDisplacementRescaled<T, ConstantRatio<T>, Rotate<T>>{ratio, 0.5}, dry));
}

/// Calls `property(law, random)` for every law, as a law on T.
template <class T, class Property>
void for_each_law(Property property) {
  visit_laws([&property](const char* name, std::size_t, const auto& law) {
    INFO(name);
    Random random;
    property(law.template cast<T>(), random);
  });
}

/// What a contact goes through. The normal turns and twists, the overlap wanders, the bodies stick, slip and now and
/// then part; and a bridge is wetted at the start, or not.
struct Path {
  PairProperties<double> pair;
  std::vector<ContactKinematics<double>> steps;
  bool wet;
};

inline Path random_path(Random& random, int length) {
  Path path{random_pair(random), {}, random.chance(0.7)};
  const double deep = path.pair.effective_radius * random.log_uniform(1e-4, 1e-2);
  const double stiffness = path.pair.effective_young * std::sqrt(path.pair.effective_radius * deep);
  const double dt = random.log_uniform(0.01, 1.0) * std::sqrt(path.pair.effective_mass / stiffness);
  Vec3<double> normal = random.direction();
  for (int i = 0; i < length; ++i) {
    const double turn = random.uniform(0.0, 0.1);
    normal = (normal + turn * random.direction()).normalized();
    const double overlap = deep * (random.chance(0.1) ? random.uniform(-1.0, 0.0) : random.uniform(0.2, 1.0));
    const double speed = deep / dt * random.log_uniform(1e-3, 0.3);
    const Vec3<double> velocity = speed * random.direction();
    path.steps.push_back({normal, overlap, velocity, dt, random.uniform(-0.1, 0.1) / dt});
  }
  return path;
}

template <class Law>
constexpr bool has_bridge = decltype(std::declval<Law>().bridge)::acts;
template <class Law>
constexpr bool has_shear = decltype(std::declval<Law>().shear)::acts;

/// The state in which a contact of this law starts the path.
template <class Law>
typename Law::State start(const Path& path) {
  using T = typename Law::Scalar;
  typename Law::State state{};
  if constexpr (has_bridge<Law>) {
    if (path.wet) Law::make_wet(state, T(0), T(0));
  }
  return state;
}

/// The state after all steps of the path but the last.
template <class Law>
typename Law::State before_last(const Law& law, const Path& path) {
  using T = typename Law::Scalar;
  typename Law::State state = start<Law>(path);
  for (std::size_t i = 0; i + 1 < path.steps.size(); ++i)
    state = law.step(path.pair.cast<T>(), path.steps[i].template cast<T>(), state).state;
  return state;
}

/// A state as the T[N] that hosts see.
template <class Law>
typename Law::Scalar* values_of(typename Law::State& state) {
  return reinterpret_cast<typename Law::Scalar*>(&state);
}

/// Forces large enough to measure the error of any part of a step against [N].
template <class T, class State>
T force_scale(const Step<T, State>& step) {
  using std::abs;
  return norm<T>(step.force) + abs(step.normal_elastic) + abs(step.normal_force) + step.bridge_force;
}

}  // namespace contactlaws::test
