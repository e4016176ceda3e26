// Any adapter behind one type, so that the checks are compiled once for all laws.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "contactlaws/verify/adapter.hpp"

namespace contactlaws::test {

/// Offers all that an adapter may. A state is what the law stores of it.
struct AnyLaw {
  using State = std::vector<double>;

  std::function<State()> start;
  std::function<verify::Interaction(const verify::Bodies&, double, State&)> call;
  std::function<AnyLaw(const verify::Units&)> in_units;
  std::function<State(const State&)> exchanged;
  std::function<ContactStiffness<double>(const verify::Bodies&, const State&)> stiffness;

  verify::Interaction operator()(const verify::Bodies& bodies, double dt, State& state) const {
    return call(bodies, dt, state);
  }
  std::vector<double> store(const State& state) const { return state; }
  State load(const std::vector<double>& values) const { return values; }
};

template <class Adapter>
AnyLaw any_law(const Adapter& law) {
  using State = AnyLaw::State;
  return {[law] { return law.store(law.start()); },
          [law](const verify::Bodies& bodies, double dt, State& values) {
            auto state = law.load(values);
            const verify::Interaction answer = law(bodies, dt, state);
            values = law.store(state);
            return answer;
          },
          [law](const verify::Units& units) { return any_law(law.in_units(units)); },
          [law](const State& values) { return law.store(law.exchanged(law.load(values))); },
          [law](const verify::Bodies& bodies, const State& values) { return law.stiffness(bodies, law.load(values)); }};
}

}  // namespace contactlaws::test
