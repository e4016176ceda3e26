// SPDX-License-Identifier: MIT
// Every composition around one normal law, made at compile time: a source file each, as there are hundreds.
#pragma once

#include <array>
#include <vector>

#include "contactlaws/adapt/xsimd.hpp"
#include "run.hpp"

namespace trade {

namespace detail {

using namespace contactlaws;

template <class Law>
Law law_of(const Parameters& p) {
  using Normal = decltype(Law::normal);
  Law law;
  if constexpr (std::is_same_v<Normal, LinearSpring<double>>) {
    law.normal.normal_stiffness = p.normal_stiffness;
  } else if constexpr (!std::is_same_v<Normal, Hertz<double>>) {
    law.normal.exponent = p.surface.exponent;
    law.normal.transition_overlap = p.surface.transition_overlap;
  }
  if constexpr (std::is_same_v<Normal, PohrtPopovIncremental<double>>) law.normal.seed_force = p.seed_force;
  if constexpr (decltype(Law::damping)::dissipates) law.damping.damping_constant = p.damping_constant;
  if constexpr (decltype(Law::shear)::resists) law.shear.friction = p.friction;
  if constexpr (decltype(Law::shear)::resists && !std::is_same_v<Normal, Hertz<double>>) law.shear.ratio = p.ratio;
  if constexpr (decltype(Law::bridge)::attracts) law.bridge = p.bridge;
  return checked(law);
}

/// `Law` one contact at a time: the two functions that know which law it is. Everything else of a run does not.
template <class T, class Geometry>
struct Kernel {
  std::shared_ptr<const void> law;
  std::size_t state_size;
  std::vector<T> first_state;
  void (*advance)(const void* law, const PairProperties<T>* pair, const ContactKinematics<Geometry>* motion,
                  const std::size_t* offset, std::size_t steps, T* state, Vec3<T>* force);
  T (*stored_energy)(const void* law, const PairProperties<T>& pair, const T& overlap, const T* state);
};

template <class Law, class Geometry>
void advance_one_by_one(const void* erased, const PairProperties<typename Law::Scalar>* pair,
                        const ContactKinematics<Geometry>* motion, const std::size_t* offset, std::size_t steps,
                        typename Law::Scalar* state, Vec3<typename Law::Scalar>* force) {
  using T = typename Law::Scalar;
  const Law& law = *static_cast<const Law*>(erased);
  for (std::size_t step = 0; step < steps; ++step) {
    const std::size_t row = offset[step], count = offset[step + 1] - row;
    for (std::size_t c = 0; c < count; ++c) {
      T* const values = state + c * Law::state_size;
      const auto answer = law.step(pair[c], motion[row + c].template cast<T>(), Law::load(values));
      Law::store(answer.state, values);
      force[row + c] = answer.force;
    }
  }
}

template <class Law>
typename Law::Scalar stored_energy(const void* erased, const PairProperties<typename Law::Scalar>& pair,
                                   const typename Law::Scalar& overlap, const typename Law::Scalar* state) {
  return static_cast<const Law*>(erased)->stored_energy(pair, overlap, Law::load(state));
}

template <class Law>
std::vector<typename Law::Scalar> first_state(bool wet) {
  typename Law::State state{};
  if constexpr (decltype(Law::bridge)::attracts)
    if (wet) Law::make_wet(state, 0, 0);
  std::vector<typename Law::Scalar> values(Law::state_size);
  Law::store(state, values.data());
  return values;
}

template <class T>
const std::vector<ContactKinematics<T>>& motion_of(const Scene& scene) {
  if constexpr (std::is_same_v<T, float>) {
    return scene.in_float;
  } else {
    return scene.in_double;
  }
}

template <class T, class Geometry>
class ScalarRun final : public Run {
 public:
  ScalarRun(Kernel<T, Geometry> kernel, const Parameters& p, const Scene& scene)
      : kernel_(std::move(kernel)), scene_(scene), pair_(scene.contacts(), p.pair.cast<T>()), force_(scene.rows()) {
    reset();
  }
  void reset() override {
    state_.clear();
    for (std::size_t c = 0; c < pair_.size(); ++c)
      state_.insert(state_.end(), kernel_.first_state.begin(), kernel_.first_state.end());
  }
  void advance(std::size_t first, std::size_t last) override {
    kernel_.advance(kernel_.law.get(), pair_.data(), motion_of<Geometry>(scene_).data(), &scene_.offset[first],
                    last - first, state_.data(), force_.data());
  }
  Vec3<double> force(std::size_t row) const override { return force_[row].template cast<double>(); }
  double stored_energy(std::size_t contact, double overlap) const override {
    return kernel_.stored_energy(kernel_.law.get(), pair_[contact], static_cast<T>(overlap),
                                 state_.data() + contact * kernel_.state_size);
  }
  std::size_t state_bytes() const override { return kernel_.state_size * sizeof(T); }

 private:
  const Kernel<T, Geometry> kernel_;
  const Scene& scene_;
  const std::vector<PairProperties<T>> pair_;  // one each, as a host has them
  std::vector<T> state_;
  std::vector<Vec3<T>> force_;
};

/// `Law` on packs, over arrays with one quantity each.
template <class Law>
class BatchRun final : public Run {
 public:
  using T = typename Law::Scalar;

  BatchRun(const Law& law, const Parameters& p, const Scene& scene)
      : law_(law), scene_(scene), first_state_(first_state<Law>(p.starts_wet)), pair_(p.pair.cast<T>()) {
    const auto& motion = motion_of<T>(scene);
    for (const auto& m : motion) {
      for (int i = 0; i < 3; ++i) normal_[std::size_t(i)].push_back(m.normal[i]);
      for (int i = 0; i < 3; ++i) velocity_[std::size_t(i)].push_back(m.velocity[i]);
      overlap_.push_back(m.overlap);
      dt_.push_back(m.dt);
    }
    for (auto& column : force_) column.resize(motion.size());
    const std::array<T, 4> each{pair_.radius, pair_.mass, pair_.smaller_radius, pair_.length};
    for (std::size_t i = 0; i < each.size(); ++i) pairs_[i].assign(scene.contacts(), each[i]);
    reset();
  }
  void reset() override {
    for (std::size_t i = 0; i < first_state_.size(); ++i) state_[i].assign(scene_.contacts(), first_state_[i]);
  }
  void advance(std::size_t first, std::size_t last) override {
    ContactBatch<Law> batch;
    batch.pair = {pairs_[0].data(), pair_.young, pair_.shear, pairs_[1].data(), pairs_[2].data(), pairs_[3].data()};
    for (std::size_t i = 0; i < Law::state_size; ++i) batch.state[i] = batch.next[i] = state_[i].data();
    for (std::size_t step = first; step < last; ++step) {
      const std::size_t row = scene_.offset[step];
      batch.count = scene_.contacts_at(step);
      for (std::size_t i = 0; i < 3; ++i) {
        batch.normal[i] = normal_[i].data() + row;
        batch.velocity[i] = velocity_[i].data() + row;
        batch.force[i] = force_[i].data() + row;
      }
      batch.overlap = overlap_.data() + row;
      batch.dt = dt_.data() + row;
      evaluate(law_, batch);
    }
  }
  Vec3<double> force(std::size_t row) const override {
    return {double(force_[0][row]), double(force_[1][row]), double(force_[2][row])};
  }
  double stored_energy(std::size_t contact, double overlap) const override {
    std::array<T, Law::state_size> values{};
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = state_[i][contact];
    return detail::stored_energy<Law>(&law_, pair_, static_cast<T>(overlap), values.data());
  }
  std::size_t state_bytes() const override { return Law::state_size * sizeof(T); }

 private:
  const Law law_;
  const Scene& scene_;
  const std::vector<T> first_state_;
  const PairProperties<T> pair_;
  std::array<std::vector<T>, 3> normal_, velocity_, force_;
  std::vector<T> overlap_, dt_;
  std::array<std::vector<T>, 4> pairs_;
  std::array<std::vector<T>, Law::state_size> state_;
};

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
struct NormalOf<NormalForm::elastic_fast, T> {
  using type = PohrtPopov<T, Power::fast>;
};
template <class T>
struct NormalOf<NormalForm::plastic, T> {
  using type = PohrtPopovElastoPlastic<T>;
};
template <class T>
struct NormalOf<NormalForm::plastic_fast, T> {
  using type = PohrtPopovElastoPlastic<T, Recontact::same_spot, Power::fast>;
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
        return with_history<T, Geometry, Damper, carry::Project<T>>();
      case Carrying::project_restore:
        return with_history<T, Geometry, Damper, carry::ProjectRestore<T>>();
      case Carrying::rotate:
        return with_history<T, Geometry, Damper, carry::Rotate<T>>();
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
    constexpr bool plain_shear = !Shear::resists || std::is_same_v<Shear, ShearForce<T, Stiffness<T>>>;
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
