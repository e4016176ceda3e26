// SPDX-License-Identifier: MIT
// A law that is chosen while the program runs, behind one virtual call. The library chooses at compile time. The slots with
// most of the choices (normal, damping, shear and its stiffness, rolling) are calls of their own inside the library's ContactLaw:
// 24 compositions instead of thousands.
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
  static constexpr bool adheres = true;              // a law that does not has an adhesion of zero
  static constexpr bool outlives_separation = true;  // a law that does not resets its history itself
  static constexpr std::size_t room = 3;
  struct State {
    std::array<T, room> normal = {T(0), T(0), T(0)};
  };
  static constexpr std::array<StateValue, room> state_values() { return {}; }

  template <class Law>
  explicit AnyNormal(const Law& law) : names(detail::names_of<Law, room>()) {
    constexpr bool pulls = contactlaws::detail::adheres<Law>;
    const auto received = [](const T& overlap) { return pulls ? overlap : contactlaws::positive_part<T>(overlap); };
    const auto touches = [=](const T* values, const PairProperties<T>& pair, const T& overlap) {
      if constexpr (pulls) {
        return bool(law.touches(detail::load<Law, T>(values), pair, overlap));
      } else {
        return !(overlap <= T(0));
      }
    };
    respond_ = [law, received, touches](T* values, const PairProperties<T>& pair, const T& overlap) {
      typename Law::State state = detail::load<Law, T>(values);
      Response response{};
      if (contactlaws::detail::outlives_separation<Law> || touches(values, pair, overlap)) {
        response = complete(law.respond(state, pair, received(overlap)));
      } else {
        state = typename Law::State{};
      }
      detail::store<Law, T>(state, values);
      return response;
    };
    energy_ = [law, received](const T* values, const PairProperties<T>& pair, const T& overlap) {
      return law.energy(detail::load<Law, T>(values), pair, received(overlap));
    };
    touches_ = touches;
    range_ = [=]([[maybe_unused]] const PairProperties<T>& pair) {
      if constexpr (pulls) {
        return law.range(pair);
      } else {
        return T(0);
      }
    };
  }

  std::array<StateValue, room> names;

  Response respond(State& state, const PairProperties<T>& pair, const T& overlap) const {
    return respond_(state.normal.data(), pair, overlap);
  }
  T energy(const State& state, const PairProperties<T>& pair, const T& overlap) const {
    return energy_(state.normal.data(), pair, overlap);
  }
  bool touches(const State& state, const PairProperties<T>& pair, const T& overlap) const {
    return touches_(state.normal.data(), pair, overlap);
  }
  T range(const PairProperties<T>& pair) const { return range_(pair); }

 private:
  static Response complete(const Response& response) { return response; }
  static Response complete(const contactlaws::HertzResponse<T>& response) { return {response, T(0), T(0)}; }
  static Response complete(const contactlaws::PullingResponse<T>& response) {
    return {{response, T(0)}, response.pull_off, response.adhesion};
  }
  /// Without a contact radius there is no Mindlin stiffness: check() in law_spec.hpp refuses the two together.
  static Response complete(const contactlaws::NormalResponse<T>& response) { return {{response, T(0)}, T(0), T(0)}; }

  std::function<Response(T*, const PairProperties<T>&, const T&)> respond_;
  std::function<T(const T*, const PairProperties<T>&, const T&)> energy_;
  std::function<bool(const T*, const PairProperties<T>&, const T&)> touches_;
  std::function<T(const PairProperties<T>&)> range_;
};

template <class T>
class AnyDamping {
 public:
  using Slot = contactlaws::DampingSlot<T>;
  template <class U>
  using Rebind = AnyDamping<U>;
  static constexpr bool acts = true;
  static constexpr bool damps_shear = true;

  template <class Law>
  explicit AnyDamping(const Law& law)
      : coefficients(
            [law](const T& mass, const T& normal, const T& shear) { return law.coefficients(mass, normal, shear); }),
        normal_force([law](const T& elastic, const T& coefficient, const T& separating) {
          return law.normal_force(elastic, coefficient, separating);
        }) {
    static_assert(Law::damps_shear, "without a shear dashpot the shear law takes another branch");
  }

  std::function<contactlaws::DampingCoefficients<T>(const T&, const T&, const T&)> coefficients;
  std::function<T(const T&, const T&, const T&)> normal_force;
};

template <class T>
class AnyShear {
 public:
  using Slot = contactlaws::ShearSlot<T>;
  template <class U>
  using Rebind = AnyShear<U>;
  using Input = contactlaws::ShearInput<T>;
  using Response = contactlaws::ShearResponse<T>;
  static constexpr bool acts = true;
  static constexpr std::size_t room = 52;  // partial slip with 12 corners, rotated exactly
  struct State {
    State() { shear.fill(T(0)); }
    std::array<T, room> shear;
  };
  static constexpr std::array<StateValue, room> state_values() { return {}; }

  /// The history does not read the parameters of the stiffness: one type of it serves all stiffnesses.
  template <contactlaws::Stored stored, contactlaws::Unloading unloading, class Stiffness, class Rotation,
            class Friction>
  explicit AnyShear(const contactlaws::IncrementalShear<T, stored, unloading, Stiffness, Rotation, Friction>& law)
      : stiffness([law](const PairProperties<T>& pair, const contactlaws::AdhesiveResponse<T>& normal) {
          return law.stiffness(pair, normal);
        }) {
    using History = contactlaws::IncrementalShear<T, stored, unloading, contactlaws::Mindlin<T>, Rotation, Friction>;
    remember(History{{}, law});
  }
  template <class Rotation, int corners>
  explicit AnyShear(const contactlaws::MindlinDeresiewicz<T, Rotation, corners>& law)
      : stiffness([](const PairProperties<T>& pair, const contactlaws::AdhesiveResponse<T>& normal) {
          return contactlaws::Mindlin<T>{}.stiffness(pair, normal);
        }) {
    remember(law);
  }

  std::array<StateValue, room> names;
  std::function<T(const PairProperties<T>&, const contactlaws::AdhesiveResponse<T>&)> stiffness;

  template <bool damped>
  Response respond(State& state, const Input& input) const {
    return respond_(state.shear.data(), input, damped);
  }
  T energy(const State& state, const T& k) const { return energy_(state.shear.data(), k); }

 private:
  template <class History>
  void remember(const History& history) {
    names = detail::names_of<History, room>();
    respond_ = [history](T* values, const Input& input, bool damped) {
      typename History::State state = detail::load<History, T>(values);
      const Response response =
          damped ? history.template respond<true>(state, input) : history.template respond<false>(state, input);
      detail::store<History, T>(state, values);
      return response;
    };
    energy_ = [history](const T* values, const T& k) { return history.energy(detail::load<History, T>(values), k); };
  }

  std::function<Response(T*, const Input&, bool)> respond_;
  std::function<T(const T*, const T&)> energy_;
};

template <class T>
class AnyRolling {
 public:
  using Slot = contactlaws::RollingSlot<T>;
  template <class U>
  using Rebind = AnyRolling<U>;
  using Input = contactlaws::RollingInput<T>;
  using Response = contactlaws::RollingResponse<T>;
  static constexpr bool acts = true;
  static constexpr std::size_t room = 4;  // a couple against rolling and one against twisting
  struct State {
    std::array<T, room> rolling = {T(0), T(0), T(0), T(0)};
  };
  static constexpr std::array<StateValue, room> state_values() { return {}; }

  template <class Law>
  explicit AnyRolling(const Law& law) : names(detail::names_of<Law, room>()) {
    respond_ = [law](T* values, const Input& input) {
      typename Law::State state = detail::load<Law, T>(values);
      const Response response = law.respond(state, input);
      detail::store<Law, T>(state, values);
      return response;
    };
    energy_ = [law](const T* values, const PairProperties<T>& pair, const T& normal_stiffness) {
      return law.energy(detail::load<Law, T>(values), pair, normal_stiffness);
    };
  }

  std::array<StateValue, room> names;

  Response respond(State& state, const Input& input) const { return respond_(state.rolling.data(), input); }
  T energy(const State& state, const PairProperties<T>& pair, const T& normal_stiffness) const {
    return energy_(state.rolling.data(), pair, normal_stiffness);
  }

 private:
  std::function<Response(T*, const Input&)> respond_;
  std::function<T(const T*, const PairProperties<T>&, const T&)> energy_;
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

  virtual ~AnyLaw() = default;
  /// Of a new contact: wet, where the law starts wet.
  virtual State first_state() const = 0;
  virtual const std::vector<StateValue>& state_values() const = 0;
  virtual Step step(const PairProperties<T>&, const ContactKinematics<T>&, const State&) const = 0;
  virtual T stored_energy(const PairProperties<T>&, const T& overlap, const State&) const = 0;
  virtual T interaction_range(const PairProperties<T>&) const = 0;
  /// Wets the contact where its gap is at most `moisture_gap` [m]. False if the law has no bridge.
  virtual bool make_wet(State&, const T& overlap, const T& moisture_gap) const = 0;
};

namespace detail {

template <class Law, class T>
class ErasedLaw final : public AnyLaw<T> {
  using State = std::vector<T>;
  using LawState = typename Law::State;
  static constexpr bool has_bridge = decltype(Law::bridge)::acts;

 public:
  ErasedLaw(const Law& law, bool wet) : law_(law), wet_(wet) {
    std::size_t i = 0;
    const auto add = [&](const auto& values) {
      for (const StateValue& value : values) {
        if (*value.name != '\0') names_.push_back(value), used_.push_back(i);
        ++i;
      }
    };
    add(law.normal.names);
    if constexpr (decltype(Law::shear)::acts) add(law.shear.names);
    add(law.bridge.state_values());
    if constexpr (decltype(Law::rolling)::acts) add(law.rolling.names);
  }

  State first_state() const override {
    State state(used_.size());
    if (wet_) make_wet(state, T(0), T(0));
    return state;
  }
  const std::vector<StateValue>& state_values() const override { return names_; }
  typename AnyLaw<T>::Step step(const PairProperties<T>& pair, const ContactKinematics<T>& kinematics,
                                const State& state) const override {
    const auto s = law_.step(pair, kinematics, state_of(state));
    return {s.force,        s.couple,       values_of(s.state), s.normal_elastic,
            s.normal_force, s.bridge_force, s.active,           s.sliding};
  }
  T stored_energy(const PairProperties<T>& pair, const T& overlap, const State& state) const override {
    return law_.stored_energy(pair, overlap, state_of(state));
  }
  T interaction_range(const PairProperties<T>& pair) const override { return law_.interaction_range(pair); }
  bool make_wet(State& values, const T& overlap, const T& moisture_gap) const override {
    if constexpr (has_bridge) {
      LawState state = state_of(values);
      Law::make_wet(state, overlap, moisture_gap);
      values = values_of(state);
    }
    return has_bridge;
  }

 private:
  LawState state_of(const State& values) const {
    std::array<T, Law::state_size> all{};
    for (std::size_t i = 0; i < used_.size(); ++i) all[used_[i]] = values[i];
    return Law::load(all.data());
  }
  State values_of(const LawState& state) const {
    std::array<T, Law::state_size> all{};
    Law::store(state, all.data());
    State values;
    for (const std::size_t i : used_) values.push_back(all[i]);
    return values;
  }

  const Law law_;
  const bool wet_;
  std::vector<StateValue> names_;
  std::vector<std::size_t> used_;  ///< of the values of LawState, those that have a name
};

}  // namespace detail

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
    return std::optional<Any>(slot);
  } else {
    return std::optional<Any>();
  }
};
}  // namespace detail

/// @throws InputError if the precision cannot hold a value
template <class T>
std::shared_ptr<const AnyLaw<T>> build_law(const LawSpec& law, const PairProperties<T>& pair) {
  const auto given = [&](const Chosen& chosen) { return Given<T>{chosen, pair, law}; };
  try {
    const AnyNormal<T> normal =
        with_law(normal_laws(), given(law.normal), [](const auto& slot) { return AnyNormal<T>(slot); });
    const auto damping = with_law(damping_laws(), given(law.damping), detail::erase<AnyDamping<T>>);
    const auto shear = with_law(shear_laws(), given(law.shear), detail::erase<AnyShear<T>>);
    const auto rolling = with_law(rolling_laws(), given(law.rolling), detail::erase<AnyRolling<T>>);
    return with_law(bridge_laws(), given(law.bridge), [&](const auto& bridge) {
      const auto compose = [&](const auto& dashpots, const auto& friction,
                               const auto& couples) -> std::shared_ptr<const AnyLaw<T>> {
        using Law =
            contactlaws::ContactLaw<AnyNormal<T>, std::decay_t<decltype(dashpots)>, std::decay_t<decltype(friction)>,
                                    std::decay_t<decltype(bridge)>, std::decay_t<decltype(couples)>>;
        return std::make_shared<detail::ErasedLaw<Law, T>>(Law{normal, dashpots, friction, bridge, couples},
                                                           law.bridge.is("wet"));
      };
      const auto with_rolling = [&](const auto& dashpots, const auto& friction) {
        return rolling ? compose(dashpots, friction, *rolling)
                       : compose(dashpots, friction, contactlaws::NoRolling<T>{});
      };
      const contactlaws::NoDashpots<T> undamped;
      const contactlaws::Frictionless<T> frictionless;
      if (damping) return shear ? with_rolling(*damping, *shear) : with_rolling(*damping, frictionless);
      return shear ? with_rolling(undamped, *shear) : with_rolling(undamped, frictionless);
    });
  } catch (const std::invalid_argument& out_of_range) {
    fail(law.normal.place, out_of_range.what());
  }
}

}  // namespace contact_path
