// SPDX-License-Identifier: MIT
// contactlaws_read() of contactlaws.h. An optional source: it needs tomlplusplus and takes longer to compile.
#include <algorithm>
#include <memory>

#include "contact_path/any_law.hpp"
#include "contact_path/law_file.hpp"
#include "law.hpp"

namespace {

using namespace contactlaws_c;
using Values = std::vector<double>;

class ReadLaw final : public contactlaws_law {
 public:
  ReadLaw(const EffectiveModuli<double>& of, std::shared_ptr<const contact_path::AnyLaw<double>> law)
      : contactlaws_law(of, law->state_values()), law_(std::move(law)), new_state_(law_->first_state()) {}

  void new_state(double* state) const override { std::copy(new_state_.begin(), new_state_.end(), state); }
  bool make_wet(double overlap, double moisture_gap, double* state) const override {
    Values values(state, state + new_state_.size());
    const bool has_bridge = law_->make_wet(values, overlap, moisture_gap);
    std::copy(values.begin(), values.end(), state);
    return has_bridge;
  }
  double range(const PairProperties<double>& pair) const override { return law_->interaction_range(pair); }
  void step(const Contacts& contacts) const override {
    for_each_contact(contacts, moduli, new_state_.size(),
                     [this](const auto& pair, const auto& kinematics, double* state) {
                       const auto step = law_->step(pair, kinematics, Values(state, state + new_state_.size()));
                       std::copy(step.state.begin(), step.state.end(), state);
                       return step;
                     });
  }

 private:
  const std::shared_ptr<const contact_path::AnyLaw<double>> law_;
  const Values new_state_;
};

}  // namespace

contactlaws_law* contactlaws_read(const char* file) {
  return guarded<contactlaws_law*>(nullptr, [&] {
    const contact_path::LawSpec spec = contact_path::read_law(file);
    const PairProperties<double> pair = contact_path::build_pair<double>(spec);
    return new ReadLaw({pair.effective_young, pair.effective_shear}, contact_path::build_law<double>(spec, pair));
  });
}
