// Item 12: how far the forces along random paths spread over the four rounding modes, in the largest force of the path.
// Published: a kernel that cancels badly would stand out. Built with -frounding-math.
#include <cfenv>

#include "laws_along_paths.hpp"

using namespace contactlaws;
using namespace contactlaws::test;

namespace {

constexpr int length = 100;

template <class Law>
std::vector<Vec3<double>> forces(const Law& law, const Path& path, int mode) {
  std::vector<Vec3<double>> result;
  std::fesetround(mode);
  typename Law::State state = start<Law>(path);
  for (const auto& kinematics : path.steps) {
    const auto step = law.step(path.pair, kinematics, state);
    state = step.state;
    result.push_back(step.force);
  }
  std::fesetround(FE_TONEAREST);
  return result;
}

}  // namespace

int main(int argc, char** argv) {
  const Effort effort(argc, argv);
  const std::int64_t paths = effort(500, 20000);
  std::int64_t tried = 0;
  double worst = 0.0;
  std::string where;
  visit_laws([&](const char* name, std::size_t, const auto& law) {
    Random random;
    for (std::int64_t i = 0; i < paths; ++i) {
      const Path path = random_path(random, length);
      const auto nearest = forces(law, path, FE_TONEAREST);
      double largest = 0.0, spread = 0.0;
      for (const auto& f : nearest) largest = std::max(largest, f.norm());
      for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        const auto other = forces(law, path, mode);
        for (std::size_t k = 0; k < other.size(); ++k) spread = std::max(spread, (other[k] - nearest[k]).norm());
      }
      if (!(spread > worst * largest)) continue;
      worst = spread / largest;
      where = text_of(name, ", path ", i, " of random_path(seed 20190501)");
    }
    tried += paths;
  });
  report({12,
          "spread of the force along a path over the four rounding modes, all laws",
          worst,
          "of the largest force",
          {},
          tried,
          where});
}
