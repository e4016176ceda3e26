// SPDX-License-Identifier: MIT
// Steps a ready-made law through so many passes over the benchmark's contacts, for callgrind to count (instructions.sh):
//
//   instructions list
//   instructions LAW PASSES
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "contacts.hpp"

namespace {

using namespace bench;

template <class Law>
double pass(int passes) {
  const Law law = granite<Law>();
  const std::vector<Contact> contacts = make_contacts(1024);
  std::vector<typename Law::State> state;
  for (const Contact& c : contacts) state.push_back(first_state<Law>(c));
  Vec3<double> sum(0.0, 0.0, 0.0);
  for (int i = 0; i < passes; ++i) {
    for (std::size_t c = 0; c < contacts.size(); ++c) {
      const auto step = law.step(contacts[c].pair, i % 2 == 0 ? contacts[c].there : contacts[c].back, state[c]);
      state[c] = step.state;
      sum += step.force;
    }
  }
  return sum.norm();
}

struct Entry {
  const char* name;
  double (*run)(int);
};
constexpr Entry laws[] = {{"SmoothHertz", pass<SmoothHertz<double>>},
                          {"LinearFriction", pass<LinearFriction<double>>},
                          {"LinearSpringDashpot", pass<LinearSpringDashpot<double>>},
                          {"DryHill", pass<DryHill<double>>},
                          {"Hill", pass<Hill<double>>},
                          {"WetGrains", pass<WetGrains<double>>},
                          {"CohesivePowder", pass<CohesivePowder<double>>},
                          {"PlasticGrains", pass<PlasticGrains<double>>},
                          {"RoughBallast", pass<RoughBallast<double>>}};

}  // namespace

int main(int argc, char** argv) {
  for (const Entry& law : laws) {
    if (argc == 2) std::puts(law.name);
    if (argc == 3 && std::strcmp(argv[1], law.name) == 0) std::printf("%g\n", law.run(std::atoi(argv[2])));
  }
  return argc == 2 || argc == 3 ? 0 : 2;
}
