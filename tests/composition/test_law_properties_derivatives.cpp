// Derivatives by autodiff: each law's value with derivatives equals the plain one, and the derivatives are its stiffness.
#include <new>

#include "catch.hpp"
#include "properties/dual.hpp"
#include "properties/paths.hpp"

namespace contactlaws::test {
namespace {

template <class T>
T& input(ContactKinematics<T>& kinematics, int i) {
  if (i < 3) return kinematics.normal[i];
  if (i == 3) return kinematics.overlap;
  if (i < 7) return kinematics.velocity[i - 4];
  if (i == 7) return kinematics.dt;
  return i == 8 ? kinematics.normal_spin : kinematics.relative_spin[i - 9];
}

Vec3<double> values(const Vec3<Dual>& v) { return {v.x().value(), v.y().value(), v.z().value()}; }

/// Calls `visit(law, the same law with derivatives, generator)` for each law on T.
template <class T, class Visit>
void for_each_law(const char* property, const Visit& visit) {
  const auto laws = all_laws<T>();
  const auto duals = all_laws<Dual>();
  for (const auto& dual : duals) {
    INFO(dual->name);
    Random random = random_for(property, dual->name);
    visit(law_named(dual->name, laws), *dual, random);
  }
}

/// The state after all steps of the path but the last.
template <class T>
typename ErasedLaw<T>::State before_last(const ErasedLaw<T>& law, const Path& path) {
  auto state = start(law, path);
  for (std::size_t i = 0; i + 1 < path.steps.size(); ++i)
    state = law.step(path.pair.cast<T>(), path.steps[i].template cast<T>(), state).state;
  return state;
}

}  // namespace

TEST_CASE("a step with derivatives has the values of the plain step, bit for bit") {
  for_each_law<double>("values", [](const auto& law, const auto& differentiable, Random& random) {
    for (int i = 0; i < cases(20); ++i) {
      const Path path = random_path(random, 6);
      auto state = start(law, path);
      auto dual_state = start(differentiable, path);
      for (const auto& kinematics : path.steps) {
        const auto step = law.step(path.pair, kinematics, state);
        const auto dual = differentiable.step(path.pair.cast<Dual>(), kinematics.template cast<Dual>(), dual_state);
        CHECK((values(dual.force) == step.force));
        CHECK((values(dual.couple) == step.couple));
        CHECK(dual.sliding == step.sliding);
        CHECK(dual.active == step.active);
        state = step.state;
        dual_state = dual.state;
      }
    }
  });
}

TEST_CASE("a virgin state is zero, though a number with derivatives leaves itself unset") {
  using Turning = ContactLaw<Hertz<Dual>, NoDashpots<Dual>,
                             ShearForceRescaled<Dual, Mindlin<Dual>, rotation::Rotate<Dual>>, SuctionBridge<Dual>>;
  using Yielding = ContactLaw<PohrtPopovElastoPlastic<Dual>>;
  const auto is_zero = [](const auto& law) {
    using Law = std::decay_t<decltype(law)>;
    alignas(typename Law::State) unsigned char memory[sizeof(typename Law::State)];
    for (volatile unsigned char& byte : memory) byte = 0x41;
    Dual stored[Law::state_size];
    Law::store(*new (memory) typename Law::State{}, stored);
    for (const Dual& value : stored) {
      CHECK(value.value() == 0.0);
      CHECK(value.derivatives().isZero(0.0));
    }
  };
  is_zero(Turning{});
  is_zero(Yielding{});
}

TEST_CASE("derivatives by autodiff are those of the force, with respect to every input of a step") {
  for_each_law<long double>("derivatives", [](const auto& precise, const auto& differentiable, Random& random) {
    int compared = 0;
    for (int i = 0; i < cases(40); ++i) {
      Path path = random_path(random, 4);
      if (random.chance(0.3)) {  // exactly where a shortcut may be taken
        path.steps[3].normal = path.steps[2].normal;
        path.steps[3].normal_spin = 0.0;
      }
      const auto state = before_last(precise, path);
      const auto pair = path.pair.cast<long double>();
      const auto kinematics = path.steps.back().cast<long double>();
      const auto step = precise.step(pair, kinematics, state);

      auto seeded = path.steps.back().cast<Dual>();
      for (int k = 0; k < inputs; ++k) input(seeded, k).derivatives() = Gradient::Unit(k);
      const auto dual = differentiable.step(path.pair.cast<Dual>(), seeded, before_last(differentiable, path));

      for (int k = 0; k < inputs; ++k) {
        // Central differences: a relative step h errs by h^2 = 1e-10 and by eps/h = 1e-14 of the terms of the force,
        // of which the dashpot's may be a thousand times the force's own size.
        auto ahead = kinematics, behind = kinematics;
        const long double size = k < 3    ? 1.0L
                                 : k == 3 ? std::abs(kinematics.overlap)
                                 : k < 7  ? kinematics.velocity.norm()
                                 : k == 7 ? kinematics.dt
                                 : k == 8 ? 0.1L / kinematics.dt
                                          : kinematics.relative_spin.norm();
        input(ahead, k) += 1e-5L * size;
        input(behind, k) -= 1e-5L * size;
        const auto forward = precise.step(pair, ahead, state), backward = precise.step(pair, behind, state);
        const bool same_branch = forward.sliding == step.sliding && backward.sliding == step.sliding &&
                                 (forward.normal_force > 0) == (backward.normal_force > 0);
        // Where flattened surfaces are apart, a dashpot takes the square root of 0, which has no derivative.
        const bool flattened = kinematics.overlap > 0 && step.normal_elastic == 0;
        if (!same_branch || flattened) continue;
        const long double radius = pair.effective_radius;  // couples as forces
        Eigen::Matrix<long double, 6, 1> change, expected;
        change << forward.force - backward.force, (forward.couple - backward.couple) / radius;
        change /= 2e-5L;
        for (int c = 0; c < 3; ++c) {
          expected[c] = dual.force[c].derivatives()[k] * size;
          expected[3 + c] = dual.couple[c].derivatives()[k] * size / radius;
        }
        INFO("input " << k << " autodiff " << expected.transpose() << " differences " << change.transpose());
        CHECK((expected - change).norm() <= 1e-6L * (force_scale(step) + change.norm()));
        ++compared;
      }
    }
    CHECK(compared > cases(40) * inputs / 3);  // a rough contact that was deeper carries no force in many instants
  });
}

TEST_CASE("the derivative of the force is the tangent stiffness") {
  for_each_law<double>("stiffness", [](const auto& law, const auto& differentiable, Random& random) {
    for (int i = 0; i < cases(20); ++i) {
      const PairProperties<double> pair = random_pair(random);
      const double overlap = pair.effective_radius * random.log_uniform(1e-5, 1e-2);
      ContactKinematics<Dual> contact{{Dual(0), Dual(0), Dual(1)}, Dual(overlap), {Dual(0), Dual(0), Dual(0)}, Dual(1)};
      contact.overlap.derivatives() = Gradient::Unit(0);
      contact.velocity.x().derivatives() = Gradient::Unit(1);  // dt = 1: a shear displacement
      const auto step = differentiable.step(pair.cast<Dual>(), contact, differentiable.virgin());
      // Slip of a contact at rest: springs that touch while it slips are sheared by a part of it.
      ContactKinematics<Dual> rest = contact;
      rest.velocity.x() = Dual(0);
      const auto pressed = differentiable.step(pair.cast<Dual>(), rest, differentiable.virgin());
      const auto sheared = differentiable.step(pair.cast<Dual>(), contact, pressed.state);
      const Tangents<double> tangents = law.tangents(pair, overlap);
      if (law.name != "Rough incremental")  // whose step goes with the stiffness at its beginning
        CHECK(step.normal_elastic.derivatives()[0] == Approx(tangents.normal).epsilon(1e-13));
      // What dashpots add for stability is not in the springs.
      CHECK(law.stiffness(pair, overlap, law.virgin()).normal == Approx(tangents.for_time_step));
      if (law.shears) CHECK(sheared.force.x().derivatives()[1] == Approx(-tangents.shear).epsilon(1e-13));
    }
  });
}

}  // namespace contactlaws::test
