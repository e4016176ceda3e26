// The forces of every law along random paths, one line a law: compared between builds whose bits may differ (-ffast-math), and
// run under a sanitizer of numerics (clang's NSan).
//
//   forces field|edges [--full | --count N]
#include "edges.hpp"

using namespace contactlaws;
using namespace contactlaws::test;

namespace {

/// Along one path: the force, and the parts whose sum it is.
template <class Law>
nlohmann::ordered_json forces(const Law& law, const Path& path) {
  nlohmann::ordered_json all;
  typename Law::State state = start<Law>(path);
  for (const auto& kinematics : path.steps) {
    const auto step = law.step(path.pair, kinematics, state);
    state = step.state;
    all.push_back(
        {step.force.x(), step.force.y(), step.force.z(), step.normal_elastic, step.normal_force, step.bridge_force});
  }
  return all;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string where = argc > 1 ? argv[1] : "";
  if (where != "field" && where != "edges") {
    std::cerr << "forces: the paths are '" << where << "', must be field or edges\n";
    return 2;
  }
  const Effort effort(argc - 1, argv + 1);
  const std::int64_t paths = effort(200, 5000);
  const Edges edges{std::numeric_limits<double>::min()};
  visit_laws([&](const char* name, std::size_t, auto law) {
    Random random;
    nlohmann::ordered_json line;
    line["law"] = name;
    for (std::int64_t i = 0; i < paths; ++i) {
      const Path path = where == "edges" ? edges.path(random) : Field{}.path(random);
      if (where == "edges") edges.tune(law, random);
      line["paths"].push_back(forces(law, path));
    }
    std::cout << line.dump() << '\n';
  });
}
