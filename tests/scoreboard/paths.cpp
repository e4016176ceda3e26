// Items 3 and 14: every law along random paths of 100 steps, against the same template at 200 bits; and saved and restored
// at every step of the way.
#include "contactlaws/scalars/multiprecision.hpp"
#include "laws_along_paths.hpp"

using namespace contactlaws;
using namespace contactlaws::test;

namespace {

constexpr int length = 100;

/// Largest difference of the forces of a law on double and on `Exact`, relative to the largest force of the path.
template <class Exact, class Law>
double deviation(const Law& law, const Path& path) {
  using ExactLaw = typename Law::template Rebind<Exact>;
  const auto exact_law = law.template cast<Exact>();
  const PairProperties<Exact> exact_pair = path.pair.cast<Exact>();
  typename Law::State state = start<Law>(path);
  typename ExactLaw::State exact_state = start<ExactLaw>(path);
  double largest = 0.0, worst = 0.0;
  for (const auto& kinematics : path.steps) {
    const auto step = law.step(path.pair, kinematics, state);
    const auto exact = exact_law.step(exact_pair, kinematics.template cast<Exact>(), exact_state);
    largest = std::max(largest, length_of(exact.force));
    Vec3<Exact> off = exact.force;
    for (int i = 0; i < 3; ++i) off[i] -= Exact(step.force[i]);
    worst = std::max(worst, length_of(off));
    state = step.state;
    exact_state = exact.state;
  }
  return largest > 0.0 ? worst / largest : 0.0;
}

/// Whether a law that is stored as plain numbers after each step, and loaded into a fresh state, feels the same forces.
template <class Law>
bool survives_storage(const Law& law, const Path& path) {
  typename Law::State kept = start<Law>(path);
  auto values = stored<Law>(kept);
  for (const auto& kinematics : path.steps) {
    const auto uninterrupted = law.step(path.pair, kinematics, kept);
    const auto restored = law.step(path.pair, kinematics, Law::load(values.data()));
    kept = uninterrupted.state;
    values = stored<Law>(restored.state);
    if (!same_values(values_of(uninterrupted.force), values_of(restored.force)) ||
        !same_values(stored<Law>(kept), values))
      return false;
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  const Effort effort(argc, argv);
  const std::int64_t paths = effort(2000, 40000);  // of each law
  std::int64_t laws = 0, lost = 0;
  double worst = 0.0;
  std::string worst_at, lost_at;
  visit_laws([&](const char* name, std::size_t, const auto& law) {
    Random random;
    // 64 bits find the paths that 200 bits then judge: their own error is a two thousandth of what they look for.
    for (std::int64_t i = 0; i < paths; ++i) {
      const Path path = random_path(random, length);
      if (!survives_storage(law, path)) {
        ++lost;
        lost_at = text_of(name, ", path ", i);
      }
      if (deviation<long double>(law, path) < 0.9 * worst && i % 1024 != 0) continue;
      const double exact = deviation<Binary200>(law, path);
      if (exact <= worst) continue;
      worst = exact;
      worst_at = text_of(name, ", path ", i, " of random_path(seed 20190501)");
    }
    ++laws;
  });
  report({3, "force along paths of 100 steps, all laws", worst, "of the largest force", 1e-13, laws * paths, worst_at});
  report({14, "save and restore at every step, all laws", static_cast<double>(lost), "paths with other bits", 0.0,
          laws * paths * length, lost_at});
}
