// The forces of every law along random paths, one line a law: compared between builds whose bits may differ (-ffast-math), and
// run under a sanitizer of numerics (clang's NSan).
//
//   forces field|edges [--full | --count N]
#include "edges.hpp"

using namespace contactlaws;
using namespace contactlaws::test;

int main(int argc, char** argv) {
  const std::string where = argc > 1 ? argv[1] : "";
  if (where != "field" && where != "edges") {
    std::cerr << "forces: the paths are '" << where << "', must be field or edges\n";
    return 2;
  }
  const Effort effort(argc - 1, argv + 1);
  const std::int64_t paths = effort(200, 5000);
  const Edges edges{std::numeric_limits<double>::min()};
  for (const auto& law : all_laws<double>()) {
    Random random = random_for(where, law->name);
    nlohmann::ordered_json line;
    line["law"] = law->name;
    for (std::int64_t i = 0; i < paths; ++i) {
      const Path path = where == "edges" ? edges.path(random) : Field{}.path(random);
      if (where == "edges") edges.tune(*law, random);
      nlohmann::ordered_json all;
      for (const auto& s : law->follow(path.pair, path.steps, start(*law, path)))
        all.push_back({s.force.x(), s.force.y(), s.force.z(), s.normal_elastic, s.normal_force, s.bridge_force});
      line["paths"].push_back(all);
    }
    std::cout << line.dump() << '\n';
  }
}
