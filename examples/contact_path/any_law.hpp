// SPDX-License-Identifier: MIT
// A law that is chosen while the program runs, behind one virtual call. The library chooses at compile time. The slots with
// most of the choices (normal, damping, shear and its stiffness) are calls of their own inside the library's ContactLaw:
// sixteen compositions instead of thousands.
#pragma once

#include <array>
#include <cstring>
#include <functional>
#include <memory>
#include <vector>

#include "law_spec.hpp"

namespace contact_path {

using contactlaws::ContactKinematics;
using contactlaws::StateValue;

namespace detail {

/// The values of a slot's state, and the state of these values.
template <class Slot, class T>
typename Slot::State load(const T* values) {
  typename Slot::State state{};
  if constexpr (Slot::state_values().size() > 0) std::memcpy(static_cast<void*>(&state), values, sizeof(state));
  return state;
}
template <class Slot, class T>
void store(const typename Slot::State& state, T* values) {
  if constexpr (Slot::state_values().size() > 0) std::memcpy(static_cast<void*>(values), &state, sizeof(state));
}

/// The names of a slot's state, and empty names after them.
template <class Slot, std::size_t room>
std::array<StateValue, room> names_of() {
  static_assert(Slot::state_values().size() <= room, "the erased slot must have room for the state");
  std::array<StateValue, room> all{};
  for (std::size_t i = 0; i < Slot::state_values().size(); ++i) all[i] = Slot::state_values()[i];
  return all;
}

}  // namespace detail

template <class T>
class AnyNormal {
 public:
  using Slot = contactlaws::NormalSlot<T>;
  using Scalar = T;
  template <class U>
  using Rebind = AnyNormal<U>;
  using Response = contactlaws::AdhesiveResponse<T>;
  static constexpr bool adheres = true;  // a law that does not has an adhesion of zero
  static constexpr std::size_t room = 3;
  struct State {
    std::array<T, room> normal = {T(0), T(0), T(0)};
  };
  static constexpr std::array<StateValue, room> state_values() { return {}; }

  template <class Law>
  explicit AnyNormal(const Law& law) : law_(std::make_shared<Model<Law>>(law)) {}

  Response respond(State& state, const PairProperties<T>& pair, const T& overlap) const {
    return law_->respond(state.normal.data(), pair, overlap);
  }
  T energy(const State& state, const PairProperties<T>& pair, const T& overlap) const {
    return law_->energy(state.normal.data(), pair, overlap);
  }
  bool touches(const State& state, const PairProperties<T>& pair, const T& overlap) const {
    return law_->touches(state.normal.data(), pair, overlap);
  }
  T range(const PairProperties<T>& pair) const { return law_->range(pair); }
  std::array<StateValue, room> names() const { return law_->names(); }

 private:
  struct Interface {
    virtual ~Interface() = default;
    virtual Response respond(T* state, const PairProperties<T>& pair, const T& overlap) const = 0;
    virtual T energy(const T* state, const PairProperties<T>& pair, const T& overlap) const = 0;
    virtual bool touches(const T* state, const PairProperties<T>& pair, const T& overlap) const = 0;
    virtual T range(const PairProperties<T>& pair) const = 0;
    virtual std::array<StateValue, room> names() const = 0;
  };

  template <class Law>
  struct Model final : Interface {
    static constexpr bool pulls = contactlaws::detail::adheres<Law>;
    Law law;
    explicit Model(const Law& l) : law(l) {}

    Response respond(T* values, const PairProperties<T>& pair, const T& overlap) const override {
      typename Law::State state = detail::load<Law, T>(values);
      const auto response = law.respond(state, pair, received(overlap));
      detail::store<Law, T>(state, values);
      return complete(response);
    }
    T energy(const T* values, const PairProperties<T>& pair, const T& overlap) const override {
      return law.energy(detail::load<Law, T>(values), pair, received(overlap));
    }
    bool touches(const T* values, const PairProperties<T>& pair, const T& overlap) const override {
      if constexpr (pulls) return law.touches(detail::load<Law, T>(values), pair, overlap);
      return !(overlap <= T(0));
    }
    T range(const PairProperties<T>& pair) const override {
      if constexpr (pulls) return law.range(pair);
      return T(0);
    }
    std::array<StateValue, room> names() const override { return detail::names_of<Law, room>(); }

    static T received(const T& overlap) { return pulls ? overlap : contactlaws::positive_part<T>(overlap); }
    static Response complete(const Response& response) { return response; }
    static Response complete(const contactlaws::HertzResponse<T>& response) { return {response, T(0)}; }
    /// Without a contact radius there is no Mindlin stiffness: check() in law_spec.hpp refuses the two together.
    static Response complete(const contactlaws::NormalResponse<T>& response) { return {{response, T(0)}, T(0)}; }
  };

  std::shared_ptr<const Interface> law_;
};

template <class T>
class AnyDamping {
 public:
  using Slot = contactlaws::DampingSlot<T>;
  template <class U>
  using Rebind = AnyDamping<U>;
  using Coefficients = contactlaws::DampingCoefficients<T>;
  static constexpr bool acts = true;
  static constexpr bool damps_shear = true;

  template <class Law>
  explicit AnyDamping(const Law& law)
      : coefficients_(
            [law](const T& mass, const T& normal, const T& shear) { return law.coefficients(mass, normal, shear); }),
        normal_force_([law](const T& elastic, const T& coefficient, const T& separating) {
          return law.normal_force(elastic, coefficient, separating);
        }) {
    static_assert(Law::damps_shear, "without a shear dashpot the shear law takes another branch");
  }
  Coefficients coefficients(const T& mass, const T& normal, const T& shear) const {
    return coefficients_(mass, normal, shear);
  }
  T normal_force(const T& elastic, const T& coefficient, const T& separating) const {
    return normal_force_(elastic, coefficient, separating);
  }

 private:
  std::function<Coefficients(const T&, const T&, const T&)> coefficients_;
  std::function<T(const T&, const T&, const T&)> normal_force_;
};

/// Mindlin, ConstantRatio or ElasticRatio.
template <class T>
class AnyStiffness {
 public:
  using Normal = contactlaws::AdhesiveResponse<T>;
  template <class U>
  using Rebind = AnyStiffness<U>;
  static constexpr std::array<contactlaws::Parameter<AnyStiffness, T>, 0> parameters() { return {}; }

  AnyStiffness() = default;
  template <class Law>
  explicit AnyStiffness(const Law& law)
      : stiffness_([law](const PairProperties<T>& pair, const Normal& normal) { return law.stiffness(pair, normal); }) {
  }
  T stiffness(const PairProperties<T>& pair, const Normal& normal) const { return stiffness_(pair, normal); }

 private:
  std::function<T(const PairProperties<T>&, const Normal&)> stiffness_;
};

template <class T>
class AnyShear {
 public:
  using Slot = contactlaws::ShearSlot<T>;
  template <class U>
  using Rebind = AnyShear<U>;
  using Input = contactlaws::ShearInput<T>;
  using Response = contactlaws::ShearResponse<T>;
  using Normal = contactlaws::AdhesiveResponse<T>;
  static constexpr bool acts = true;
  static constexpr std::size_t room = 8;
  struct State {
    std::array<T, room> shear = {T(0), T(0), T(0), T(0), T(0), T(0), T(0), T(0)};
  };
  static constexpr std::array<StateValue, room> state_values() { return {}; }

  template <contactlaws::Stored stored, contactlaws::Unloading unloading, class Stiffness, class Rotation,
            class Friction>
  explicit AnyShear(const contactlaws::IncrementalShear<T, stored, unloading, Stiffness, Rotation, Friction>& law) {
    using Law = contactlaws::IncrementalShear<T, stored, unloading, AnyStiffness<T>, Rotation, Friction>;
    law_ = std::make_shared<Model<Law>>(Law{AnyStiffness<T>(static_cast<const Stiffness&>(law)), law});
  }

  template <bool damped>
  Response respond(State& state, const Input& input) const {
    return law_->respond(state.shear.data(), input, damped);
  }
  T stiffness(const PairProperties<T>& pair, const Normal& normal) const { return law_->stiffness(pair, normal); }
  T energy(const State& state, const T& stiffness) const { return law_->energy(state.shear.data(), stiffness); }
  std::array<StateValue, room> names() const { return law_->names(); }

 private:
  struct Interface {
    virtual ~Interface() = default;
    virtual Response respond(T* state, const Input& input, bool damped) const = 0;
    virtual T stiffness(const PairProperties<T>& pair, const Normal& normal) const = 0;
    virtual T energy(const T* state, const T& stiffness) const = 0;
    virtual std::array<StateValue, room> names() const = 0;
  };

  template <class Law>
  struct Model final : Interface {
    Law law;
    explicit Model(const Law& l) : law(l) {}

    Response respond(T* values, const Input& input, bool damped) const override {
      typename Law::State state = detail::load<Law, T>(values);
      const Response response =
          damped ? law.template respond<true>(state, input) : law.template respond<false>(state, input);
      detail::store<Law, T>(state, values);
      return response;
    }
    T stiffness(const PairProperties<T>& pair, const Normal& normal) const override {
      return law.stiffness(pair, normal);
    }
    T energy(const T* values, const T& stiffness) const override {
      return law.energy(detail::load<Law, T>(values), stiffness);
    }
    std::array<StateValue, room> names() const override { return detail::names_of<Law, room>(); }
  };

  std::shared_ptr<const Interface> law_;
};

/// A whole law in numbers of type T. Used as a ContactLaw is; its state is the list of values that state_values() names.
template <class T>
class AnyLaw {
 public:
  using Scalar = T;
  using State = std::vector<T>;
  using Step = contactlaws::Step<T, State>;
  struct Rolling {
    static constexpr bool acts = true;
  };
  static constexpr Rolling rolling{};  ///< EnergyLedger counts the work of the couple

  /// `wet`: contacts start wet, where the law has a bridge.
  template <class Law>
  AnyLaw(const Law& law, bool wet) : law_(std::make_shared<Model<Law>>(law, wet)) {}

  State first_state() const { return law_->first_state(); }
  const std::vector<StateValue>& state_values() const { return law_->state_values(); }
  Step step(const PairProperties<T>& pair, const ContactKinematics<T>& kinematics, const State& state) const {
    return law_->step(pair, kinematics, state);
  }
  T stored_energy(const PairProperties<T>& pair, const T& overlap, const State& state) const {
    return law_->stored_energy(pair, overlap, state);
  }
  T interaction_range(const PairProperties<T>& pair) const { return law_->interaction_range(pair); }
  /// Wets the contact where its gap is at most `moisture_gap` [m]. False if the law has no bridge.
  bool make_wet(State& state, const T& overlap, const T& moisture_gap) const {
    return law_->make_wet(state, overlap, moisture_gap);
  }

 private:
  struct Interface {
    virtual ~Interface() = default;
    virtual State first_state() const = 0;
    virtual const std::vector<StateValue>& state_values() const = 0;
    virtual Step step(const PairProperties<T>&, const ContactKinematics<T>&, const State&) const = 0;
    virtual T stored_energy(const PairProperties<T>&, const T&, const State&) const = 0;
    virtual T interaction_range(const PairProperties<T>&) const = 0;
    virtual bool make_wet(State&, const T&, const T&) const = 0;
  };

  template <class Law>
  struct Model final : Interface {
    using LawState = typename Law::State;
    const Law law;
    const bool wet;
    std::vector<StateValue> names;
    std::vector<std::size_t> used;  ///< of the values of LawState, those that have a name

    Model(const Law& l, bool starts_wet) : law(l), wet(starts_wet) {
      std::size_t i = 0;
      const auto add = [&](const auto& values) {
        for (const StateValue& value : values) {
          if (*value.name != '\0') names.push_back(value), used.push_back(i);
          ++i;
        }
      };
      add(law.normal.names());
      if constexpr (decltype(Law::shear)::acts) add(law.shear.names());
      add(law.bridge.state_values());
      add(law.rolling.state_values());
    }

    State first_state() const override {
      LawState state{};
      if constexpr (decltype(Law::bridge)::acts)
        if (wet) Law::make_wet(state, T(0), T(0));
      return values_of(state);
    }
    const std::vector<StateValue>& state_values() const override { return names; }
    Step step(const PairProperties<T>& pair, const ContactKinematics<T>& kinematics,
              const State& state) const override {
      const auto of_law = law.step(pair, kinematics, state_of(state));
      return {of_law.force,        of_law.couple,       values_of(of_law.state), of_law.normal_elastic,
              of_law.normal_force, of_law.bridge_force, of_law.active,           of_law.sliding};
    }
    T stored_energy(const PairProperties<T>& pair, const T& overlap, const State& state) const override {
      return law.stored_energy(pair, overlap, state_of(state));
    }
    T interaction_range(const PairProperties<T>& pair) const override { return law.interaction_range(pair); }
    bool make_wet(State& values, const T& overlap, const T& moisture_gap) const override {
      if constexpr (decltype(Law::bridge)::acts) {
        LawState state = state_of(values);
        Law::make_wet(state, overlap, moisture_gap);
        values = values_of(state);
      }
      return decltype(Law::bridge)::acts;
    }

    LawState state_of(const State& values) const {
      std::array<T, Law::state_size> all{};
      for (std::size_t i = 0; i < used.size(); ++i) all[used[i]] = values[i];
      return Law::load(all.data());
    }
    State values_of(const LawState& state) const {
      std::array<T, Law::state_size> all{};
      Law::store(state, all.data());
      State values;
      for (const std::size_t i : used) values.push_back(all[i]);
      return values;
    }
  };

  std::shared_ptr<const Interface> law_;
};

/// @throws InputError if the precision cannot hold a value, or the two bodies do not make a pair
template <class T>
PairProperties<T> build_pair(const LawSpec& law) {
  try {
    return pair_of<T>(law);
  } catch (const std::invalid_argument& out_of_range) {
    fail(law.pair.place, out_of_range.what());
  }
}

namespace detail {
/// A slot erased; nothing where it is empty.
template <class Any>
inline constexpr auto erase = [](const auto& slot) {
  if constexpr (std::decay_t<decltype(slot)>::acts) {
    return std::optional<Any>(Any(slot));
  } else {
    return std::optional<Any>();
  }
};
}  // namespace detail

/// @throws InputError if the precision cannot hold a value
template <class T>
AnyLaw<T> build_law(const LawSpec& law, const PairProperties<T>& pair) {
  const auto given = [&](const Chosen& chosen) { return Given<T>{chosen, pair, law}; };
  try {
    const AnyNormal<T> normal =
        with_law(normal_laws(), given(law.normal), [](const auto& slot) { return AnyNormal<T>(slot); });
    const auto damping = with_law(damping_laws(), given(law.damping), detail::erase<AnyDamping<T>>);
    const auto shear = with_law(shear_laws(), given(law.shear), detail::erase<AnyShear<T>>);
    return with_law(bridge_laws(), given(law.bridge), [&](const auto& bridge) {
      return with_law(rolling_laws(), given(law.rolling), [&](const auto& rolling) {
        const auto compose = [&](const auto& dashpots, const auto& friction) {
          using Law =
              contactlaws::ContactLaw<AnyNormal<T>, std::decay_t<decltype(dashpots)>, std::decay_t<decltype(friction)>,
                                      std::decay_t<decltype(bridge)>, std::decay_t<decltype(rolling)>>;
          return AnyLaw<T>(Law{normal, dashpots, friction, bridge, rolling}, law.bridge.is("wet"));
        };
        const contactlaws::NoDashpots<T> undamped;
        const contactlaws::Frictionless<T> frictionless;
        if (damping) return shear ? compose(*damping, *shear) : compose(*damping, frictionless);
        return shear ? compose(undamped, *shear) : compose(undamped, frictionless);
      });
    });
  } catch (const std::invalid_argument& out_of_range) {
    fail(law.normal.place, out_of_range.what());
  }
}

}  // namespace contact_path
