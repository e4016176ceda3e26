// Forces of three laws along a path, one contact at a time and in packs, as hexadecimal numbers. compare.sh builds this with
// each vector type and compares what is printed.
#if defined(HOST_USES_EIGEN)
#include <Eigen/Core>
#endif

#include <array>
#include <cstdio>
#include <random>
#include <vector>

#include "contactlaws/batch.hpp"
#include "contactlaws/contactlaws.hpp"
#include "contactlaws/rows.hpp"
#include "contactlaws/scalars/xsimd.hpp"

#if defined(HOST_USES_EIGEN)
using Vector = Eigen::Vector3d;  // the host's own; it converts to the library's and back
#else
using Vector = contactlaws::Vec3<double>;
#if defined(CONTACTLAWS_NO_EIGEN) && defined(EIGEN_WORLD_VERSION)
#error "a header includes Eigen"
#endif
#endif

namespace {

using namespace contactlaws;

void print(const char* name, const Vector& force) {
  std::printf("%s %a %a %a\n", name, force.x(), force.y(), force.z());
}

/// In packs, from the state after the path; the contacts differ in their overlaps.
template <class Law>
void print_batch(const char* name, const Law& law, const PairProperties<double>& pair, const Vector& normal,
                 const Vector& velocity, std::array<double, Law::state_size> state) {
  constexpr std::size_t count = 11;
  std::vector<double> overlap, force(3 * count), history(Law::state_size * count);
  for (std::size_t i = 0; i < count; ++i) overlap.push_back(1e-6 * static_cast<double>(i) - 2e-6);
  ContactBatch<Law> batch;
  batch.count = count;
  batch.pair = {pair.effective_radius, pair.effective_young, pair.effective_shear,
                pair.effective_mass,   pair.min_radius,      pair.length};
  batch.overlap = overlap.data();
  batch.dt = 1e-6;
  for (std::size_t i = 0; i < 3; ++i) {
    batch.normal[i] = normal[static_cast<int>(i)];
    batch.velocity[i] = velocity[static_cast<int>(i)];
    batch.force[i] = &force[i * count];
  }
  for (std::size_t i = 0; i < Law::state_size; ++i) {
    for (std::size_t j = 0; j < count; ++j) history[i * count + j] = state[i];
    batch.state[i] = batch.next[i] = &history[i * count];
  }
  evaluate(law, batch);
  for (std::size_t i = 0; i < count; ++i) print(name, Vector(force[i], force[i + count], force[i + 2 * count]));
}

template <class Law>
void print_forces(const char* name, const Law& law) {
  const ElasticMaterial<double> granite{29e9, 0.15, 2650.0};
  const PairProperties<double> pair = pair_properties(sphere(granite, 7.5e-3), sphere(granite, 5e-3));
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  typename Law::State state{};
  if constexpr (decltype(Law::bridge)::acts) state.moisture = 2.0;  // wet
  const Vector x1(0.0, 0.0, 0.0);
  Vector velocity = x1;
  ContactGeometry<double> geometry{};
  for (int i = 0; i < 200; ++i) {
    const double x = 1e-4 * uniform(random), y = 1e-4 * uniform(random);
    const Vector x2(x, y, 0.012495 + 2e-5 * uniform(random));
    const double vx = uniform(random), vy = uniform(random);
    velocity = Vector(vx, vy, 0.01 * uniform(random));
    const BodyMotion<double> still{x1, x1, velocity * 0.5}, moving{x2, velocity, velocity + velocity};
    geometry = sphere_sphere<double>(x1, 7.5e-3, x2, 5e-3);
    const auto step = law.step(pair, contact_kinematics<double>(geometry, still, moving, 1e-6), state);
    state = step.state;
    const Vector force = step.force;
    print(name, force);
  }
  std::array<double, Law::state_size> values{};
  Law::store(state, values.data());
  print_batch(name, law, pair, Vector(geometry.normal), velocity, values);
}

}  // namespace

int main() {
  DryHillProperties<double> dry;
  dry.friction = 0.4;
  dry.damping_constant = 0.07;
  print_forces("DryHill", dry_hill(dry));
  HillProperties<double> wet;
  wet.friction = 0.4;
  wet.suction = 2e5;
  wet.damping_constant = 0.07;
  print_forces("Hill", hill(wet));
  RoughBallastProperties<double> rough;
  rough.fractal_dimension = 2.13;
  rough.roughness = 26.1e-6;
  rough.friction = 0.7;
  print_forces("RoughBallast", rough_ballast(rough));
}
