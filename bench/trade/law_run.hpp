// SPDX-License-Identifier: MIT
// A law driven along trajectories in the two ways that hosts have: one contact at a time, or on packs.
#pragma once

#include <array>
#include <vector>

#include "contactlaws/scalars/xsimd.hpp"
#include "run.hpp"

namespace trade {

namespace detail {

using namespace contactlaws;

/// `Law` one contact at a time: the two functions that depend on the law.
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
  if constexpr (decltype(Law::bridge)::acts)
    if (wet) Law::make_wet(state, 0, 0);
  std::vector<typename Law::Scalar> values(Law::state_size);
  Law::store(state, values.data());
  return values;
}

template <class T>
const std::vector<ContactKinematics<T>>& motion_of(const Trajectories& trajectories) {
  if constexpr (std::is_same_v<T, float>) {
    return trajectories.in_float;
  } else {
    return trajectories.in_double;
  }
}

template <class T, class Geometry>
class ScalarRun final : public Run {
 public:
  ScalarRun(Kernel<T, Geometry> kernel, const PairProperties<double>& pair, const Trajectories& trajectories)
      : kernel_(std::move(kernel)),
        trajectories_(trajectories),
        pair_(trajectories.contacts(), pair.cast<T>()),
        force_(trajectories.rows()) {
    reset();
  }
  void reset() override {
    state_.clear();
    for (std::size_t c = 0; c < pair_.size(); ++c)
      state_.insert(state_.end(), kernel_.first_state.begin(), kernel_.first_state.end());
  }
  void advance(std::size_t first, std::size_t last) override {
    kernel_.advance(kernel_.law.get(), pair_.data(), motion_of<Geometry>(trajectories_).data(),
                    &trajectories_.offset[first], last - first, state_.data(), force_.data());
  }
  Vec3<double> force(std::size_t row) const override { return force_[row].template cast<double>(); }
  double stored_energy(std::size_t contact, double overlap) const override {
    return kernel_.stored_energy(kernel_.law.get(), pair_[contact], static_cast<T>(overlap),
                                 state_.data() + contact * kernel_.state_size);
  }
  std::size_t state_bytes() const override { return kernel_.state_size * sizeof(T); }

 private:
  const Kernel<T, Geometry> kernel_;
  const Trajectories& trajectories_;
  const std::vector<PairProperties<T>> pair_;  // one per contact, as a host stores them
  std::vector<T> state_;
  std::vector<Vec3<T>> force_;
};

/// `Law` on packs, over one array per quantity.
template <class Law>
class BatchRun final : public Run {
 public:
  using T = typename Law::Scalar;

  BatchRun(const Law& law, const PairProperties<double>& pair, bool wet, const Trajectories& trajectories)
      : law_(law), trajectories_(trajectories), first_state_(first_state<Law>(wet)), pair_(pair.cast<T>()) {
    const auto& motion = motion_of<T>(trajectories);
    for (const auto& m : motion) {
      for (int i = 0; i < 3; ++i) normal_[std::size_t(i)].push_back(m.normal[i]);
      for (int i = 0; i < 3; ++i) velocity_[std::size_t(i)].push_back(m.velocity[i]);
      overlap_.push_back(m.overlap);
      dt_.push_back(m.dt);
    }
    for (auto& column : force_) column.resize(motion.size());
    const std::array<T, 4> each{pair_.effective_radius, pair_.effective_mass, pair_.min_radius, pair_.length};
    for (std::size_t i = 0; i < each.size(); ++i) pairs_[i].assign(trajectories.contacts(), each[i]);
    reset();
  }
  void reset() override {
    for (std::size_t i = 0; i < first_state_.size(); ++i) state_[i].assign(trajectories_.contacts(), first_state_[i]);
  }
  void advance(std::size_t first, std::size_t last) override {
    ContactBatch<Law> batch;
    batch.pair = {pairs_[0].data(), pair_.effective_young, pair_.effective_shear,
                  pairs_[1].data(), pairs_[2].data(),      pairs_[3].data()};
    for (std::size_t i = 0; i < Law::state_size; ++i) batch.state[i] = batch.next[i] = state_[i].data();
    for (std::size_t step = first; step < last; ++step) {
      const std::size_t row = trajectories_.offset[step];
      batch.count = trajectories_.contacts_at(step);
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
  const Trajectories& trajectories_;
  const std::vector<T> first_state_;
  const PairProperties<T> pair_;
  std::array<std::vector<T>, 3> normal_, velocity_, force_;
  std::vector<T> overlap_, dt_;
  std::array<std::vector<T>, 4> pairs_;
  std::array<std::vector<T>, Law::state_size> state_;
};

}  // namespace detail

}  // namespace trade
