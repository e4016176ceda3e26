// A law behind one type for all laws of a scalar, so that a property compiles once and not once a law.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "contactlaws/contactlaws.hpp"

namespace contactlaws::test {

/// Calls `visit` with each slot of a law: the one place in the tests that lists them.
template <class Law, class Visit>
void visit_slots(Law& law, const Visit& visit) {
  visit(law.normal);
  visit(law.damping);
  visit(law.shear);
  visit(law.bridge);
  visit(law.rolling);
}

template <class Law>
constexpr bool has_shear = decltype(Law::shear)::acts;
template <class Law>
constexpr bool has_bridge = decltype(Law::bridge)::acts;

template <class Damping>
constexpr bool may_pull = false;
template <class T, ShearDashpot shear>
constexpr bool may_pull<Dashpots<T, Tension::allowed, shear>> = true;

/// Whether a law claims never to create energy: no shear, a rescaled force, partial slip, or a shear stiffness that never
/// changes.
template <class Shear>
constexpr bool never_gains = false;
template <class T, class Stiffness, class Rotation, class Friction>  // by name: g++ 14 fails on a pack of them
constexpr bool never_gains<IncrementalShear<T, Stored::force, Unloading::rescales, Stiffness, Rotation, Friction>> =
    true;
template <class T, class Rotation, int corners>
constexpr bool never_gains<MindlinDeresiewicz<T, Rotation, corners>> = true;
template <class Law>
constexpr bool conserves_energy =
    !decltype(Law::rolling)::acts && (!has_shear<Law> || never_gains<decltype(Law::shear)> ||
                                      std::is_same_v<decltype(Law::normal), LinearSpring<typename Law::Scalar>> ||
                                      std::is_same_v<decltype(Law::normal), LinearModulus<typename Law::Scalar>>);

/// Derivatives of a virgin contact's force as its slots state them [N/m].
template <class T>
struct Tangents {
  T normal;         ///< of the spring
  T for_time_step;  ///< the largest that the spring can enter from here, times what dashpots add
  T shear;          ///< of spring and dashpot over a step of 1 s
};

/// Coefficients of friction, 0 without shear [1].
template <class T>
struct Friction {
  T sliding = T(0);
  T largest = T(0);  ///< that a sticking contact bears
  T least = T(0);    ///< at which a sticking contact may begin to slide
};

template <class T>
class ErasedLaw {
 public:
  using Scalar = T;
  static constexpr std::size_t most_values = 20;
  using State = std::array<T, most_values>;  ///< the law's own values, then zeros

  struct Parameter {
    std::string name, unit;
    Range range;
    T* value;
  };

  std::string name;
  std::vector<StateValue> state_values;
  bool shears = false, bridges = false;  ///< whether the slot acts
  bool damps = false, pulls = false;     ///< whether dashpots act, and whether they may pull
  bool conserves = false;                ///< claims never to create energy
  struct MayRoll {
    static constexpr bool acts = true;
  };
  MayRoll rolling;  ///< EnergyLedger counts the couple

  virtual ~ErasedLaw() = default;
  virtual std::unique_ptr<ErasedLaw> clone() const = 0;
  virtual std::vector<Parameter> parameters() = 0;

  virtual State virgin() const = 0;
  virtual void make_wet(State& state, const T& overlap, const T& moisture_gap) const = 0;
  virtual void make_dry(State& state) const = 0;
  virtual Step<T, State> step(const PairProperties<T>&, const ContactKinematics<T>&, const State&) const = 0;
  virtual ContactStiffness<T> stiffness(const PairProperties<T>&, const T& overlap, const State&) const = 0;
  virtual T stored_energy(const PairProperties<T>&, const T& overlap, const State&) const = 0;
  virtual Tangents<T> tangents(const PairProperties<T>&, const T& overlap) const = 0;
  virtual Dissipation<T> dissipation(const PairProperties<T>&, const State& before, const Step<T, State>&) const = 0;
  virtual T interaction_range(const PairProperties<T>&) const = 0;
  virtual Friction<T> friction() const = 0;
  /// Whether the normal law holds the contact, at an overlap or beyond touch.
  virtual bool touches(const PairProperties<T>&, const T& overlap, const State&) const = 0;
  /// What friction multiplies beside the normal force [N].
  virtual T adhesion(const PairProperties<T>&, const T& overlap) const = 0;
  /// The steps of a path with the law's own state kept from step to step, as a host in C++ keeps it.
  virtual std::vector<Step<T, State>> follow(const PairProperties<T>&, const std::vector<ContactKinematics<T>>&,
                                             const State& start) const = 0;

  std::size_t state_size() const { return state_values.size(); }
};

template <class Law>
class Erased final : public ErasedLaw<typename Law::Scalar> {
 public:
  using T = typename Law::Scalar;
  using Base = ErasedLaw<T>;
  using typename Base::Parameter, typename Base::State;

  Erased(const char* title, const Law& law) : law_(law) {
    using Pair = PairProperties<T>;
    using Kinematics = ContactKinematics<T>;
    using Own = typename Law::State;
    static_assert(Law::state_size <= Base::most_values);
    static_assert(noexcept(law.step(std::declval<Pair>(), std::declval<Kinematics>(), std::declval<Own>())));
    static_assert(noexcept(law.stiffness(std::declval<Pair>(), std::declval<T>(), std::declval<Own>())));
    static_assert(noexcept(law.stored_energy(std::declval<Pair>(), std::declval<T>(), std::declval<Own>())));
    static_assert(noexcept(law.interaction_range(std::declval<Pair>())));
    this->name = title;
    const auto values = Law::state_values();
    this->state_values.assign(values.begin(), values.end());
    this->shears = has_shear<Law>;
    this->bridges = has_bridge<Law>;
    this->damps = decltype(law.damping)::acts;
    this->pulls = may_pull<decltype(Law::damping)>;
    this->conserves = conserves_energy<Law>;
  }

  std::unique_ptr<Base> clone() const override { return std::make_unique<Erased>(*this); }
  std::vector<Parameter> parameters() override {
    std::vector<Parameter> all;
    visit_slots(law_, [&all](auto& slot) {
      for (const auto& p : std::decay_t<decltype(slot)>::parameters())
        all.push_back({p.name, p.unit, p.range, &(slot.*p.member)});
    });
    return all;
  }

  State virgin() const override { return erased(typename Law::State{}); }
  void make_wet(State& state, const T& overlap, const T& moisture_gap) const override {
    if constexpr (has_bridge<Law>) {
      typename Law::State own = Law::load(state.data());
      Law::make_wet(own, overlap, moisture_gap);
      state = erased(own);
    }
  }
  void make_dry(State& state) const override {
    if constexpr (has_bridge<Law>) {
      typename Law::State own = Law::load(state.data());
      Law::make_dry(own);
      state = erased(own);
    }
  }
  Step<T, State> step(const PairProperties<T>& pair, const ContactKinematics<T>& kinematics,
                      const State& state) const override {
    return erased(law_.step(pair, kinematics, Law::load(state.data())));
  }
  ContactStiffness<T> stiffness(const PairProperties<T>& pair, const T& overlap, const State& state) const override {
    return law_.stiffness(pair, overlap, Law::load(state.data()));
  }
  T stored_energy(const PairProperties<T>& pair, const T& overlap, const State& state) const override {
    return law_.stored_energy(pair, overlap, Law::load(state.data()));
  }
  Dissipation<T> dissipation(const PairProperties<T>& pair, const State& before,
                             const Step<T, State>& step) const override {
    Step<T, typename Law::State> own{};
    own.state = Law::load(step.state.data());
    own.friction_work = step.friction_work;
    own.dashpot_work = step.dashpot_work;
    return contactlaws::dissipation(law_, pair, Law::load(before.data()), own);
  }
  Tangents<T> tangents(const PairProperties<T>& pair, const T& overlap) const override {
    typename Law::State state{};
    const auto normal = law_.normal.respond(state, pair, overlap);
    T shear = T(0);
    if constexpr (has_shear<Law>) shear = law_.shear.stiffness(pair, normal);
    const T dashpot = law_.damping.coefficients(pair.effective_mass, normal.secant, shear).shear;
    return {tangent(law_.normal, pair, overlap, normal.stiffness), normal.max_tangent * law_.damping.stiffness_factor(),
            shear + dashpot};
  }
  T interaction_range(const PairProperties<T>& pair) const override { return law_.interaction_range(pair); }
  Friction<T> friction() const override {
    Friction<T> result;
    for (const auto& p : decltype(Law::shear)::parameters()) {
      const T& value = law_.shear.*p.member;
      if (p.name == std::string_view("friction")) result = {value, value, value};
      if (p.name == std::string_view("static_friction"))  // comes after the other
        result = {result.sliding, maximum<T>(value, result.sliding), minimum<T>(value, result.sliding)};
    }
    return result;
  }
  bool touches(const PairProperties<T>& pair, const T& overlap, const State& state) const override {
    if constexpr (Law::adheres) {
      return any<T>(law_.normal.touches(Law::load(state.data()), pair, overlap));
    } else {
      return any<T>(overlap > T(0));
    }
  }
  T adhesion(const PairProperties<T>& pair, const T& overlap) const override {
    if constexpr (Law::adheres) {
      typename decltype(Law::normal)::State state{};
      return law_.normal.respond(state, pair, overlap).adhesion;
    } else {
      return T(0);
    }
  }
  std::vector<Step<T, State>> follow(const PairProperties<T>& pair, const std::vector<ContactKinematics<T>>& path,
                                     const State& start) const override {
    std::vector<Step<T, State>> steps;
    typename Law::State own = Law::load(start.data());
    for (const auto& kinematics : path) {
      const auto step = law_.step(pair, kinematics, own);
      own = step.state;
      steps.push_back(erased(step));
    }
    return steps;
  }

 private:
  /// Of a law whose tangent may be negative it is a function of its own.
  template <class Normal>
  static auto tangent(const Normal& normal, const PairProperties<T>& pair, const T& overlap, const T&)
      -> decltype(normal.tangent({}, pair, overlap)) {
    return normal.tangent({}, pair, overlap);
  }
  template <class Normal, class... Other>
  static T tangent(const Normal&, const PairProperties<T>&, const T&, const T& stiffness, const Other&...) {
    return stiffness;
  }
  static State erased(const typename Law::State& own) {
    State state;
    state.fill(T(0));
    Law::store(own, state.data());
    return state;
  }
  static Step<T, State> erased(const Step<T, typename Law::State>& own) {
    return {own.force,  own.couple,  erased(own.state), own.normal_elastic, own.normal_force, own.bridge_force,
            own.active, own.sliding, own.shear_force,   own.friction_work,  own.dashpot_work};
  }

  Law law_;
};

template <class T>
using Laws = std::vector<std::unique_ptr<ErasedLaw<T>>>;

/// The laws of law_list.hpp on T. Defined in laws_*.cpp, one for each T.
template <class T>
Laws<T> all_laws();

template <class T>
const ErasedLaw<T>& law_named(const std::string& name, const Laws<T>& laws) {
  for (const auto& law : laws)
    if (law->name == name) return *law;
  throw std::logic_error("no law " + name);
}

}  // namespace contactlaws::test
