// Derivatives by autodiff: each law's value with derivatives equals the plain one, and the derivatives are its stiffness.
#include "contactlaws/scalars/autodiff.hpp"

#include <new>

#include "law_properties.hpp"

namespace contactlaws::test {
namespace {

constexpr int inputs = 9;  // normal, overlap, velocity, dt, spin
using Gradient = Eigen::Matrix<double, inputs, 1>;
using Dual = Eigen::AutoDiffScalar<Gradient>;

template <class T>
T& input(ContactKinematics<T>& kinematics, int i) {
  if (i < 3) return kinematics.normal[i];
  if (i == 3) return kinematics.overlap;
  if (i < 7) return kinematics.velocity[i - 4];
  return i == 7 ? kinematics.dt : kinematics.normal_spin;
}

Vec3<double> values(const Vec3<Dual>& v) { return {v.x().value(), v.y().value(), v.z().value()}; }

}  // namespace

TEST_CASE("a step with derivatives has the values of the plain step, bit for bit") {
  visit_laws([](const char* name, std::size_t, const auto& law) {
    INFO(name);
    const auto differentiable = law.template cast<Dual>();
    Random random;
    for (int i = 0; i < cases(20); ++i) {
      const Path path = random_path(random, 6);
      auto state = start<std::decay_t<decltype(law)>>(path);
      auto dual_state = start<std::decay_t<decltype(differentiable)>>(path);
      for (const auto& kinematics : path.steps) {
        const auto step = law.step(path.pair, kinematics, state);
        const auto dual = differentiable.step(path.pair.cast<Dual>(), kinematics.template cast<Dual>(), dual_state);
        CHECK((values(dual.force) == step.force));
        CHECK(dual.sliding == step.sliding);
        CHECK(dual.active == step.active);
        state = step.state;
        dual_state = dual.state;
      }
    }
  });
}

TEST_CASE("a virgin state is zero, though a number with derivatives leaves itself unset") {
  visit_laws([](const char* name, std::size_t, const auto& law) {
    INFO(name);
    using Law = std::decay_t<decltype(law.template cast<Dual>())>;
    alignas(typename Law::State) unsigned char memory[sizeof(typename Law::State)];
    for (volatile unsigned char& byte : memory) byte = 0x41;
    const Dual* const values = reinterpret_cast<Dual*>(new (memory) typename Law::State{});
    for (std::size_t i = 0; i < Law::state_size; ++i) {
      CHECK(values[i].value() == 0.0);
      CHECK(values[i].derivatives().isZero(0.0));
    }
  });
}

TEST_CASE("derivatives by autodiff are those of the force, with respect to every input of a step") {
  visit_laws([](const char* name, std::size_t, const auto& law) {
    INFO(name);
    const auto differentiable = law.template cast<Dual>();
    const auto precise = law.template cast<long double>();
    Random random;
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
                                          : 0.1L / kinematics.dt;
        input(ahead, k) += 1e-5L * size;
        input(behind, k) -= 1e-5L * size;
        const auto forward = precise.step(pair, ahead, state), backward = precise.step(pair, behind, state);
        const bool same_branch = forward.sliding == step.sliding && backward.sliding == step.sliding &&
                                 (forward.normal_force > 0) == (backward.normal_force > 0);
        if (!same_branch) continue;
        const Vec3<long double> change = (forward.force - backward.force) / 2e-5L;
        Vec3<long double> expected;
        for (int c = 0; c < 3; ++c) expected[c] = dual.force[c].derivatives()[k] * size;
        INFO("input " << k << " autodiff " << expected.transpose() << " differences " << change.transpose());
        CHECK((expected - change).norm() <= 1e-6L * (force_scale(step) + change.norm()));
        ++compared;
      }
    }
    CHECK(compared > cases(40) * inputs / 2);
  });
}

TEST_CASE("the derivative of the force is the tangent stiffness") {
  visit_laws([](const char* name, std::size_t, const auto& law) {
    INFO(name);
    const auto differentiable = law.template cast<Dual>();
    using Law = std::decay_t<decltype(differentiable)>;
    Random random;
    for (int i = 0; i < cases(20); ++i) {
      const PairProperties<double> pair = random_pair(random);
      const double overlap = pair.effective_radius * random.log_uniform(1e-5, 1e-2);
      ContactKinematics<Dual> contact{{Dual(0), Dual(0), Dual(1)}, Dual(overlap), {Dual(0), Dual(0), Dual(0)}, Dual(1)};
      contact.overlap.derivatives() = Gradient::Unit(0);
      contact.velocity.x().derivatives() = Gradient::Unit(1);  // dt = 1: a shear displacement
      const auto step = differentiable.step(pair.cast<Dual>(), contact, typename Law::State{});

      typename std::decay_t<decltype(law)>::State state{};
      const auto normal = law.normal.respond(state, pair, overlap);
      if (std::string(name) != "Rough incremental")  // whose step goes with the stiffness at its beginning
        CHECK(step.normal_elastic.derivatives()[0] == Approx(normal.stiffness).epsilon(1e-13));
      // What dashpots add for stability is not in the springs.
      CHECK(law.stiffness(pair, overlap, {}).normal == Approx(normal.max_tangent * law.damping.stiffness_factor()));
      if constexpr (has_shear<Law>) {
        const double shear = law.shear.stiffness(pair, normal);
        const double viscous = law.damping.coefficients(pair.effective_mass, 0.0, shear).shear;
        CHECK(step.force.x().derivatives()[1] == Approx(-(shear + viscous)).epsilon(1e-13));
      }
    }
  });
}

}  // namespace contactlaws::test
