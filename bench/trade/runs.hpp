// SPDX-License-Identifier: MIT
// Every composition around one normal law, made at compile time: a source file each, as there are hundreds.
#pragma once

#include "law_run.hpp"

namespace trade {

namespace detail {

/// The normal law of a form, and the shear stiffness beside it.
template <NormalForm form, class T>
struct NormalOf;
template <class T>
struct NormalOf<NormalForm::linear, T> {
  using type = LinearSpring<T>;
};
template <class T>
struct NormalOf<NormalForm::hertz, T> {
  using type = Hertz<T>;
};
template <class T>
struct NormalOf<NormalForm::elastic, T> {
  using type = PohrtPopov<T>;
};
template <class T>
struct NormalOf<NormalForm::plastic, T> {
  using type = PohrtPopovElastoPlastic<T>;
};
template <class T>
struct NormalOf<NormalForm::incremental, T> {
  using type = PohrtPopovIncremental<T>;
};

/// Chosen slot by slot: the normal law is given, the others follow from the composition.
template <NormalForm form>
class Maker {
  template <class T>
  using Normal = typename NormalOf<form, T>::type;
  template <class T>
  using Stiffness = std::conditional_t<form == NormalForm::hertz, Mindlin<T>, ConstantRatio<T>>;

 public:
  Maker(const Composition& composition, const Parameters& parameters, const Scene& scene)
      : c_(composition), p_(parameters), scene_(scene) {}

  std::unique_ptr<Run> make() const {
    switch (c_.precision) {
      case Precision::in_double:
        return with_damping<double, double>();
      case Precision::law_in_float:
        return with_damping<float, double>();
      case Precision::in_float:
        return with_damping<float, float>();
    }
    return nullptr;
  }

 private:
  template <class T, class Geometry>
  std::unique_ptr<Run> with_damping() const {
    switch (c_.damping) {
      case Damping::none:
        return with_carrying<T, Geometry, NoDashpots<T>>();
      case Damping::allowed:
        return with_carrying<T, Geometry, Dashpots<T>>();
      case Damping::clipped:
        return with_carrying<T, Geometry, Dashpots<T, Tension::clipped>>();
    }
    return nullptr;
  }
  template <class T, class Geometry, class Damper>
  std::unique_ptr<Run> with_carrying() const {
    if (c_.history == History::none) return with_bridge<T, Geometry, Damper, Frictionless<T>>();
    switch (c_.carrying) {
      case Carrying::project:
        return with_history<T, Geometry, Damper, rotation::Project<T>>();
      case Carrying::project_restore:
        return with_history<T, Geometry, Damper, rotation::ProjectRestore<T>>();
      case Carrying::rotate:
        return with_history<T, Geometry, Damper, rotation::Rotate<T>>();
    }
    return nullptr;
  }
  template <class T, class Geometry, class Damper, class Carry>
  std::unique_ptr<Run> with_history() const {
    using K = Stiffness<T>;
    switch (c_.history) {
      case History::none:
        break;
      case History::force:
        return with_bridge<T, Geometry, Damper, ShearForce<T, K, Carry>>();
      case History::force_rescaled:
        return with_bridge<T, Geometry, Damper, ShearForceRescaled<T, K, Carry>>();
      case History::displacement:
        return with_bridge<T, Geometry, Damper, ShearDisplacement<T, K, Carry>>();
      case History::displacement_rescaled:
        return with_bridge<T, Geometry, Damper, ShearDisplacementRescaled<T, K, Carry>>();
    }
    return nullptr;
  }
  template <class T, class Geometry, class Damper, class Shear>
  std::unique_ptr<Run> with_bridge() const {
    if (c_.bridge) return on_path<Geometry, ContactLaw<Normal<T>, Damper, Shear, SuctionBridge<T>>>();
    return on_path<Geometry, ContactLaw<Normal<T>, Damper, Shear>>();
  }
  template <class Geometry, class Law>
  std::unique_ptr<Run> on_path() const {
    using T = typename Law::Scalar;
    using Shear = decltype(Law::shear);
    constexpr bool in_one_type = std::is_same_v<T, Geometry>;
    constexpr bool plain_damping = !std::is_same_v<decltype(Law::damping), Dashpots<T, Tension::clipped>>;
    constexpr bool plain_shear = !Shear::acts || std::is_same_v<Shear, ShearForce<T, Stiffness<T>>>;
    constexpr bool plain = in_one_type && plain_damping && plain_shear;
    if (c_.path == Path::batch) {
      if constexpr (plain) return std::make_unique<BatchRun<Law>>(law<Law>(), p_, scene_);
    } else if constexpr (plain || std::is_same_v<Geometry, double>) {
      return std::make_unique<ScalarRun<T, Geometry>>(
          Kernel<T, Geometry>{std::make_shared<const Law>(law<Law>()), Law::state_size, first_state<Law>(p_.starts_wet),
                              advance_one_by_one<Law, Geometry>, detail::stored_energy<Law>},
          p_, scene_);
    }
    return nullptr;
  }

  template <class Law>
  Law law() const {
    return law_of<typename Law::template Rebind<double>>(p_).template cast<typename Law::Scalar>();
  }

  const Composition& c_;
  const Parameters& p_;
  const Scene& scene_;
};

}  // namespace detail

/// Instantiated in runs_*.cpp, a form each.
template <NormalForm form>
std::unique_ptr<Run> make_run_of(const Composition& composition, const Parameters& parameters, const Scene& scene) {
  return detail::Maker<form>(composition, parameters, scene).make();
}

}  // namespace trade
