// SPDX-License-Identifier: MIT
// What a contact costs: ns per contact and bytes of state for each law, one contact at a time (array of structures).
#include <benchmark/benchmark.h>

#include "contacts.hpp"

namespace {

using namespace bench;

template <class Law>
struct Stored {
  PairProperties<typename Law::Scalar> pair;
  ContactKinematics<typename Law::Scalar> there;
  ContactKinematics<typename Law::Scalar> back;
  typename Law::State state;
  Vec3<typename Law::Scalar> force;
};

template <class Law>
void step_each(benchmark::State& run, const Law& law, const Mix& mix) {
  using T = typename Law::Scalar;
  std::vector<Stored<Law>> stored;
  for (const Contact& c : make_contacts(1024, mix))
    stored.push_back(
        {c.pair.cast<T>(), c.there.cast<T>(), c.back.cast<T>(), first_state<Law>(c), Vec3<T>(T(0), T(0), T(0))});
  std::size_t sliding = 0;
  bool even = true;
  for (auto _ : run) {
    for (Stored<Law>& s : stored) {
      auto step = law.step(s.pair, even ? s.there : s.back, s.state);
      s.state = step.state;
      s.force = step.force;
      sliding += step.sliding;
    }
    even = !even;
    benchmark::ClobberMemory();
  }
  const double contacts = static_cast<double>(run.iterations()) * static_cast<double>(stored.size());
  run.counters["per_contact"] = benchmark::Counter(contacts, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  run.counters["state_bytes"] = static_cast<double>(Law::state_size * sizeof(T));
  run.counters["sliding"] = static_cast<double>(sliding) / contacts;
}

template <class Law>
void add(const char* name, const Law& law, const Mix& mix = {}) {
  benchmark::RegisterBenchmark((std::string(name) + "/double").c_str(),
                               [=](benchmark::State& run) { step_each(run, law, mix); });
  benchmark::RegisterBenchmark((std::string(name) + "/float").c_str(),
                               [=](benchmark::State& run) { step_each(run, law.template cast<float>(), mix); });
}

template <class Shear>
using Damped = ContactLaw<Hertz<double>, Dashpots<double>, Shear>;
template <class Rolling>
using Rolled = ContactLaw<Hertz<double>, Dashpots<double>, ShearForce<double>, Dry<double>, Rolling>;
using Mi = Mindlin<double>;

}  // namespace

int main(int argc, char** argv) {
  add("SmoothHertz", granite<SmoothHertz<double>>());
  add("LinearFriction", granite<LinearFriction<double>>());
  add("LinearSpringDashpot", granite<LinearSpringDashpot<double>>());
  add("DryHill", granite<DryHill<double>>());
  add("DryHill/in_ratio", granite<DryHillInRatio>());
  add("DryHill/turning", granite<DryHill<double>>(), {0.05, 0.0, 0.0, 1e-4});
  add("Hill", granite<Hill<double>>(), {0.05, 0.05, 0.5});
  add("WetGrains", granite<WetGrains<double>>(), {0.05, 0.05, 1.0});
  add("RoughBallast", granite<RoughBallast<double>>());
  add("PlasticGrains", granite<PlasticGrains<double>>());
  add("LinearHysteretic", granite<ContactLaw<LinearHysteretic<double>>>());
  add("Dmt", granite<ContactLaw<Dmt<double>>>());
  add("Jkr", granite<ContactLaw<Jkr<double>>>());
  add("Jkr+Dashpots+ShearForce", granite<ContactLaw<Jkr<double>, Dashpots<double>, ShearForce<double>>>());
  add("CohesivePowder", granite<CohesivePowder<double>>());
  add("Hertz+Dashpots", granite<ContactLaw<Hertz<double>, Dashpots<double>>>());
  add("Hertz+ShearForce", granite<ContactLaw<Hertz<double>, NoDashpots<double>, ShearForce<double>>>());
  add("DryHill/clipped", granite<DryHill<double, Tension::clipped>>());
  add("DryHill/turning/project", granite<Damped<ShearForce<double, Mi, rotation::Project<double>>>>(),
      {0.05, 0.0, 0.0, 1e-4});
  add("DryHill/turning/rotate", granite<Damped<ShearForce<double, Mi, rotation::Rotate<double>>>>(),
      {0.05, 0.0, 0.0, 1e-4});
  add("DryHill/force_rescaled", granite<Damped<ShearForceRescaled<double>>>());
  add("DryHill/displacement", granite<Damped<ShearDisplacement<double>>>());
  add("DryHill/displacement_rescaled", granite<Damped<ShearDisplacementRescaled<double>>>());
  add("DryHill/partial_slip", granite<Damped<MindlinDeresiewicz<double>>>());
  add("DryHill/rolling_torque", granite<Rolled<RollingTorque<double>>>());
  add("DryHill/rolling_spring", granite<Rolled<RollingSpring<double>>>());
  add("DryHill/rolling_spring_dashpot", granite<Rolled<RollingSpringDashpot<double>>>());
  add("DryHill/twisting_spring_dashpot", granite<Rolled<TwistingSpringDashpot<double>>>());
  add("DryHill/roll_and_twist",
      granite<Rolled<RollAndTwist<double, RollingSpringDashpot<double>, TwistingSpringDashpot<double>>>>());
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
}
