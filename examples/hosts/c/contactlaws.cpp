// SPDX-License-Identifier: MIT
// The C face: see contactlaws.h.
#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <memory>

#include "../laws.hpp"
#include "law.hpp"

namespace {

using namespace contactlaws;
using namespace contactlaws_c;

constexpr double not_given = std::numeric_limits<double>::quiet_NaN();

/// The materials of the two bodies, by name.
struct Materials {
  double young = not_given, poisson = not_given, young2 = not_given, poisson2 = not_given;

  static constexpr const char* name = "Materials";
  static constexpr std::array<Parameter<Materials, double>, 4> parameters() {
    return {{{"young", "Pa", &Materials::young, Range::positive()},
             {"poisson", "1", &Materials::poisson, Range::left_open(-1.0, 0.5)},
             {"young2", "Pa", &Materials::young2, Range::positive()},
             {"poisson2", "1", &Materials::poisson2, Range::left_open(-1.0, 0.5)}}};
  }
  EffectiveModuli<double> moduli() const {
    const auto or_first = [](double second, double first) { return second == second ? second : first; };
    return given_moduli({young, poisson, 1.0}, {or_first(young2, young), or_first(poisson2, poisson), 1.0});
  }
};
/// Of laws that read no moduli.
struct NoMaterials {
  static constexpr const char* name = "NoMaterials";
  static constexpr std::array<Parameter<NoMaterials, double>, 0> parameters() { return {}; }
  static EffectiveModuli<double> moduli() { return {not_given, not_given}; }
};

/// All that contactlaws_make() may set: set_parameter() finds it by name.
template <class Parameters>
struct Request {
  using OfBodies = std::conditional_t<reads_moduli<Parameters>, Materials, NoMaterials>;
  Parameters properties;
  OfBodies materials;
  auto slots() { return std::tie(properties, materials); }
};

template <class Law>
class MadeLaw final : public contactlaws_law {
 public:
  MadeLaw(const EffectiveModuli<double>& of, const Law& law) : contactlaws_law(of, described()), law_(law) {}

  void new_state(double* state) const override { Law::store({}, state); }
  bool make_wet(double overlap, double moisture_gap, double* values) const override {
    if constexpr (has_bridge) {
      auto state = Law::load(values);
      Law::make_wet(state, overlap, moisture_gap);
      Law::store(state, values);
    }
    return has_bridge;
  }
  double range(const PairProperties<double>& pair) const override { return law_.interaction_range(pair); }
  void step(const Contacts& contacts) const override {
    for_each_contact(contacts, moduli, Law::state_size,
                     [this](const auto& pair, const auto& kinematics, double* values) {
                       const auto step = law_.step(pair, kinematics, Law::load(values));
                       Law::store(step.state, values);
                       return step;
                     });
  }

 private:
  static constexpr bool has_bridge = decltype(Law::bridge)::acts;
  static std::vector<StateValue> described() {
    constexpr auto values = Law::state_values();
    return {values.begin(), values.end()};
  }

  const Law law_;
};

struct Given {
  std::size_t count;
  const char* const* names;
  const double* values;
};
using Maker = std::function<contactlaws_law*(const Given&)>;

template <class Parameters>
contactlaws_law* make(const Given& given) {
  Request<Parameters> request{};
  for (std::size_t i = 0; i < given.count; ++i) {
    const std::string name = given.names[i];
    if (!set_restitution(request.properties, name, given.values[i]))
      set_parameter(request, name, given.values[i], restitution_name<Parameters>);
  }
  return new MadeLaw<LawOf<Parameters>>(request.materials.moduli(), make_law(request.properties));
}

const std::map<std::string, Maker>& makers() {
  static const std::map<std::string, Maker> all = [] {
    std::map<std::string, Maker> table;
    visit_laws([&table](const char* name, const auto& parameters) {
      table.emplace(name, make<std::decay_t<decltype(parameters)>>);
    });
    return table;
  }();
  return all;
}

/// @throws std::invalid_argument naming the contact, the body and the value
void check_bodies(const Contacts& contacts) {
  const auto check = [](std::size_t i, const char* name, const contactlaws_body& body, const Range& radii) {
    const auto owner = [&] { return "contact " + std::to_string(i) + ", " + name; };
    if (!radii.contains(body.radius)) require_in(radii, body.radius, owner().c_str(), "radius", "m");
    if (!Range::not_negative().contains(body.mass))
      require_in(Range::not_negative(), body.mass, owner().c_str(), "mass", "kg");
  };
  for (std::size_t i = 0; i < contacts.count; ++i) {
    check(i, "body 1", contacts.body1[i], Range::not_negative());
    check(i, "body 2", contacts.body2[i], Range::positive());
  }
}

}  // namespace

contactlaws_law* contactlaws_make(const char* name, size_t count, const char* const* names, const double* values) {
  return guarded<contactlaws_law*>(nullptr, [&] {
    const auto found = makers().find(name);
    if (found == makers().end()) {
      std::string known;
      for (const auto& [law, make] : makers()) known += (known.empty() ? "" : ", ") + law;
      reject("no law '" + std::string(name) + "'; there are: " + known);
    }
    return found->second({count, names, values});
  });
}

void contactlaws_free(contactlaws_law* law) { delete law; }

const char* contactlaws_error(void) { return error_text; }

size_t contactlaws_state_size(const contactlaws_law* law) { return law->state_values.size(); }
const char* contactlaws_state_name(const contactlaws_law* law, size_t i) { return law->state_values[i].name; }
const char* contactlaws_state_unit(const contactlaws_law* law, size_t i) { return law->state_values[i].unit; }
int contactlaws_exchange_sign(const contactlaws_law* law, size_t i) { return law->state_values[i].exchange_sign; }

void contactlaws_new_state(const contactlaws_law* law, double* state) { law->new_state(state); }

int contactlaws_make_wet(const contactlaws_law* law, double overlap, double moisture_gap, double* state) {
  return guarded(1, [&] {
    if (!law->make_wet(overlap, moisture_gap, state)) reject("this law has no liquid bridge");
    return 0;
  });
}

double contactlaws_range(const contactlaws_law* law, double radius1, double radius2) {
  return law->range(pair_of(law->moduli, {{}, {}, {}, radius1, 0.0}, {{}, {}, {}, radius2, 0.0}));
}

int contactlaws_step(const contactlaws_law* law, double dt, size_t count, const contactlaws_body* body1,
                     const contactlaws_body* body2, double* state, double (*force)[3], double (*torque1)[3],
                     double (*torque2)[3]) {
  return guarded(1, [&] {
    const Contacts contacts{dt, count, body1, body2, state, force, torque1, torque2};
    check_bodies(contacts);
    law->step(contacts);
    return 0;
  });
}
