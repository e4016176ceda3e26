// Items 3 and 14: laws along random paths of 100 steps, against the same templates at 200 bits; and saved and restored at
// every step.
#include "contactlaws/scalars/multiprecision.hpp"
#include "properties/contact.hpp"
#include "row.hpp"

using namespace contactlaws;
using namespace contactlaws::test;

namespace {

constexpr int length = 100;

template <class T>
auto follow(const ErasedLaw<T>& law, const Path& path) {
  std::vector<ContactKinematics<T>> steps;
  for (const auto& kinematics : path.steps) steps.push_back(kinematics.template cast<T>());
  return law.follow(path.pair.cast<T>(), steps, start(law, path));
}

/// Largest difference of the forces of a law on double and on `Exact`, relative to the largest force of the path.
template <class Exact>
double deviation(const ErasedLaw<double>& law, const ErasedLaw<Exact>& exact_law, const Path& path) {
  const auto steps = follow(law, path);
  const auto exact = follow(exact_law, path);
  double largest = 0.0, worst = 0.0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    Vec3<Exact> off = exact[i].force;
    for (int axis = 0; axis < 3; ++axis) off[axis] -= Exact(steps[i].force[axis]);
    largest = std::max(largest, static_cast<double>(norm<Exact>(exact[i].force)));
    worst = std::max(worst, static_cast<double>(norm<Exact>(off)));
  }
  return largest > 0.0 ? worst / largest : 0.0;
}

/// Whether a law that is stored as plain numbers after each step, and loaded into a new state, gives the same forces.
bool survives_storage(const ErasedLaw<double>& law, const Path& path) {
  auto state = start(law, path);
  const auto kept = law.follow(path.pair, path.steps, state);
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const auto restored = law.step(path.pair, path.steps[i], state);  // loads and stores
    state = restored.state;
    if (!same<double>(kept[i].force, restored.force) || kept[i].state != restored.state) return false;
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  const Effort effort(argc, argv);
  const std::int64_t paths = effort(2000, 40000);  // of each law
  const auto laws = all_laws<double>();
  const auto sieves = all_laws<long double>();
  Worst worst, lost;
  for (const auto& exact : all_laws<Binary200>()) {
    const ErasedLaw<double>& law = law_named(exact->name, laws);
    const ErasedLaw<long double>& sieve = law_named(exact->name, sieves);
    Random random = random_for("paths", law.name);
    // 64 bits find the paths that 200 bits then judge: their own error is a two thousandth of what they look for.
    for (std::int64_t i = 0; i < paths; ++i) {
      const Path path = random_path(random, length);
      const bool near_record = deviation(law, sieve, path) >= 0.9 * worst.figure;
      worst.see(near_record || i % 1024 == 0 ? deviation(law, *exact, path) : 0.0, law.name, ", path ", i);
    }
  }
  for (const auto& law : laws) {
    Random random = random_for("storage", law->name);
    for (std::int64_t i = 0; i < paths; ++i)
      lost.see(survives_storage(*law, random_path(random, length)) ? 0.0 : 1.0, law->name, ", path ", i);
  }
  report({3, "force along paths of 100 steps, every slot", worst.figure, "of the largest force", 1e-13, worst.tried,
          worst.where});
  report({14, "save and restore at every step, all laws", lost.figure, "1: some path has other bits", 0.0,
          lost.tried * length, lost.where});
}
