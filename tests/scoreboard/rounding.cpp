// Item 12: how far the forces along random paths spread over the four rounding modes, in the largest force of the path.
// Published: a kernel that cancels badly would stand out. Built with -frounding-math.
#include <cfenv>

#include "properties/paths.hpp"
#include "row.hpp"

using namespace contactlaws;
using namespace contactlaws::test;

int main(int argc, char** argv) {
  const Effort effort(argc, argv);
  const std::int64_t paths = effort(500, 20000);
  Worst worst;
  for (const auto& law : all_laws<double>()) {
    Random random = random_for("rounding", law->name);
    for (std::int64_t i = 0; i < paths; ++i) {
      const Path path = random_path(random, 100);
      const auto follow = [&](int mode) {
        std::fesetround(mode);
        const auto steps = law->follow(path.pair, path.steps, start(*law, path));
        std::fesetround(FE_TONEAREST);
        return steps;
      };
      const auto nearest = follow(FE_TONEAREST);
      double largest = 0.0, spread = 0.0;
      for (const auto& step : nearest) largest = std::max(largest, step.force.norm());
      for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        const auto other = follow(mode);
        for (std::size_t k = 0; k < other.size(); ++k)
          spread = std::max(spread, (other[k].force - nearest[k].force).norm());
      }
      if (largest > 0.0) worst.see(spread / largest, law->name, ", path ", i);
    }
  }
  report({12,
          "spread of the force along a path over the four rounding modes, all laws",
          worst.figure,
          "of the largest force",
          {},
          worst.tried,
          worst.where});
}
