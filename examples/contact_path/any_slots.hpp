// SPDX-License-Identifier: MIT
// A normal law and a shear law that are chosen while the program runs. The library chooses at compile time; this program has
// thousands of combinations to offer, so it hides these two slots behind a virtual call. What runs behind it is the
// library's text, and so is the ContactLaw around it.
#pragma once

#include <array>
#include <cstring>
#include <memory>

#include "contactlaws/contact_law.hpp"

namespace contact_path {

using contactlaws::HertzResponse;
using contactlaws::NormalResponse;
using contactlaws::PairProperties;
using contactlaws::ShearInput;
using contactlaws::ShearResponse;
using contactlaws::StateValue;

namespace detail {

/// The state of a slot, out of the first of `values`, and back.
template <class Slot, class T>
typename Slot::State load(const T* values) {
  typename Slot::State state{};
  if constexpr (Slot::state_values().size() > 0) std::memcpy(static_cast<void*>(&state), values, sizeof(state));
  return state;
}
template <class Slot, class T>
void store(const typename Slot::State& state, T* values) {
  if constexpr (Slot::state_values().size() > 0) {
    static_assert(sizeof(state) == Slot::state_values().size() * sizeof(T), "a State holds values of T only");
    std::memcpy(static_cast<void*>(values), &state, sizeof(state));
  }
}

/// The names of a slot's state, and empty ones after them.
template <class Slot, std::size_t room>
std::array<StateValue, room> state_values_of() {
  static_assert(Slot::state_values().size() <= room, "the erased slot must have room for the state");
  std::array<StateValue, room> all{};
  for (std::size_t i = 0; i < Slot::state_values().size(); ++i) all[i] = Slot::state_values()[i];
  return all;
}

}  // namespace detail

template <class T>
class AnyNormal {
 public:
  using Scalar = T;
  template <class U>
  using Rebind = AnyNormal<U>;
  static constexpr std::size_t room = 3;
  struct State {
    std::array<T, room> normal = {T(0), T(0), T(0)};
  };
  /// As many as the longest state has; names() tells which they are.
  static constexpr std::array<StateValue, room> state_values() { return {}; }

  template <class Law>
  explicit AnyNormal(const Law& law) : law_(std::make_shared<Model<Law>>(law)) {}

  HertzResponse<T> respond(State& state, const PairProperties<T>& pair, const T& overlap) const {
    return law_->respond(state.normal.data(), pair, overlap);
  }
  T energy(const State& state, const PairProperties<T>& pair, const T& overlap) const {
    return law_->energy(state.normal.data(), pair, overlap);
  }
  std::array<StateValue, room> names() const { return law_->names(); }

 private:
  struct Interface {
    virtual ~Interface() = default;
    virtual HertzResponse<T> respond(T* state, const PairProperties<T>& pair, const T& overlap) const = 0;
    virtual T energy(const T* state, const PairProperties<T>& pair, const T& overlap) const = 0;
    virtual std::array<StateValue, room> names() const = 0;
  };

  template <class Law>
  struct Model final : Interface {
    Law law;
    explicit Model(const Law& l) : law(l) {}

    HertzResponse<T> respond(T* values, const PairProperties<T>& pair, const T& overlap) const override {
      typename Law::State state = detail::load<Law, T>(values);
      const auto response = law.respond(state, pair, overlap);
      detail::store<Law, T>(state, values);
      return with_radius(response);
    }
    T energy(const T* values, const PairProperties<T>& pair, const T& overlap) const override {
      return law.energy(detail::load<Law, T>(values), pair, overlap);
    }
    std::array<StateValue, room> names() const override { return detail::state_values_of<Law, room>(); }

    static HertzResponse<T> with_radius(const HertzResponse<T>& response) { return response; }
    /// Without a contact radius there is no Mindlin stiffness; law_file.hpp never puts the two together.
    static HertzResponse<T> with_radius(const NormalResponse<T>& response) { return {response, T(0)}; }
  };

  std::shared_ptr<const Interface> law_;
};

template <class T>
class AnyShear {
 public:
  template <class U>
  using Rebind = AnyShear<U>;
  static constexpr bool acts = true;
  static constexpr std::size_t room = 7;
  struct State {
    std::array<T, room> shear = {T(0), T(0), T(0), T(0), T(0), T(0), T(0)};
  };
  /// As many as the longest state has; names() tells which they are.
  static constexpr std::array<StateValue, room> state_values() { return {}; }

  template <class Law>
  explicit AnyShear(const Law& law) : law_(std::make_shared<Model<Law>>(law)) {}

  template <bool damped>
  ShearResponse<T> respond(State& state, const ShearInput<T>& input) const {
    return law_->respond(state.shear.data(), input, damped);
  }
  T stiffness(const PairProperties<T>& pair, const HertzResponse<T>& normal) const {
    return law_->stiffness(pair, normal);
  }
  T energy(const State& state, const T& stiffness) const { return law_->energy(state.shear.data(), stiffness); }
  std::array<StateValue, room> names() const { return law_->names(); }

 private:
  struct Interface {
    virtual ~Interface() = default;
    virtual ShearResponse<T> respond(T* state, const ShearInput<T>& input, bool damped) const = 0;
    virtual T stiffness(const PairProperties<T>& pair, const HertzResponse<T>& normal) const = 0;
    virtual T energy(const T* state, const T& stiffness) const = 0;
    virtual std::array<StateValue, room> names() const = 0;
  };

  template <class Law>
  struct Model final : Interface {
    Law law;
    explicit Model(const Law& l) : law(l) {}

    ShearResponse<T> respond(T* values, const ShearInput<T>& input, bool damped) const override {
      typename Law::State state = detail::load<Law, T>(values);
      const ShearResponse<T> response =
          damped ? law.template respond<true>(state, input) : law.template respond<false>(state, input);
      detail::store<Law, T>(state, values);
      return response;
    }
    T stiffness(const PairProperties<T>& pair, const HertzResponse<T>& normal) const override {
      return law.stiffness(pair, normal);
    }
    T energy(const T* values, const T& stiffness) const override {
      return law.energy(detail::load<Law, T>(values), stiffness);
    }
    std::array<StateValue, room> names() const override { return detail::state_values_of<Law, room>(); }
  };

  std::shared_ptr<const Interface> law_;
};

}  // namespace contact_path
