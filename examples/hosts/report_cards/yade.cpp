// SPDX-License-Identifier: MIT
// YADE's own laws under the checks of contactlaws/verify. YADE runs as a program of its own (yade_two_particles.py), which computes
// the steps that come through a pipe.
//
//   report_card_yade FOLDER             a JSON line for each law and property; the paths of failures in FOLDER. The pipes
//                                       FOLDER/to_yade and FOLDER/from_yade must be there, with YADE at their other ends.
#include <array>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "contactlaws/verify/verify.hpp"
#include "examples/hosts/report_cards/report_card.hpp"

namespace {

using namespace contactlaws;
using verify::Vector;

/// A YADE at the other ends of two pipes.
class Yade {
 public:
  explicit Yade(const std::string& folder)
      : to_(std::fopen((folder + "/to_yade").c_str(), "wb")), from_(std::fopen((folder + "/from_yade").c_str(), "rb")) {
    if (!to_ || !from_) throw std::runtime_error("no pipes to and from YADE in " + folder);
  }
  template <std::size_t n>
  std::array<double, n> ask(const std::vector<double>& question) const {
    std::array<double, n> answer;
    if (std::fwrite(question.data(), sizeof(double), question.size(), to_.get()) != question.size() ||
        std::fflush(to_.get()) != 0 || std::fread(answer.data(), sizeof(double), n, from_.get()) != n)
      throw std::runtime_error("YADE does not answer");
    return answer;
  }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::unique_ptr<std::FILE, Close> to_, from_;
};

/// One of YADE's laws as a force update. A contact has no owner in YADE that could change.
struct YadeLaw {
  const Yade* yade;
  int number;  ///< in LAWS of yade_two_particles.py

  /// Whether the spheres touch; shear force, elastic shear force, two slips, normal.
  struct State {
    std::array<double, 16> values{};
  };
  verify::Interaction operator()(const verify::Bodies& bodies, double dt, State& state) const {
    std::vector<double> step = {double(number), dt};
    for (const verify::Body* body : {&bodies.one, &bodies.two}) {
      for (const Vector* v : {&body->position, &body->velocity, &body->spin})
        step.insert(step.end(), {v->x(), v->y(), v->z()});
      step.insert(step.end(), {body->radius, body->mass});
    }
    step.insert(step.end(), state.values.begin(), state.values.end());
    const std::array<double, 28> answer = yade->ask<28>(step);
    std::copy(answer.begin() + 12, answer.end(), state.values.begin());
    const auto vector = [&answer](std::size_t k) { return Vector(answer[k], answer[k + 1], answer[k + 2]); };
    return {vector(3), vector(0), vector(6), vector(9)};
  }
  std::vector<double> store(const State& state) const { return {state.values.begin(), state.values.end()}; }
  State load(const std::vector<double>& values) const {
    State state;
    std::copy(values.begin(), values.end(), state.values.begin());
    return state;
  }
};

struct Named {
  const char* title;
  double restitution;
};

void run(const std::string& folder) {
  const Yade yade(folder);
  int number = 0;
  for (const Named& law : {Named{"MindlinPhys", 1.0}, Named{"MindlinPhys, no avoidGranularRatcheting", 1.0},
                           Named{"MindlinPhys, no avoidGranularRatcheting, en = es = 0.8", 0.8},
                           Named{"FrictPhys, Cundall-Strack", 1.0}}) {
    verify::Options options = two_grains(0.4);
    options.claims.restitution = law.restitution;
    options.paths = 30;  // a step through the pipe takes some 50 us
    ReportCard card("YADE 2023.02a", law.title, folder);
    card.check(YadeLaw{&yade, number++}, options);
  }
}

}  // namespace

int main(int argc, char** argv) { return contactlaws::run_report_card(argc, argv, run); }
