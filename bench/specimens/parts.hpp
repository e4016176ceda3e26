// SPDX-License-Identifier: MIT
// What the benchmarks of both specimens measure beside a step: the law alone, and STREAM's triad.
#pragma once

#include <benchmark/benchmark.h>

#include <array>
#include <vector>

#include "bench/triad.hpp"
#include "contactlaws/batch.hpp"
#include "contactlaws/scalars/xsimd.hpp"

namespace bench {

inline void per_contact(benchmark::State& run, double contacts) {
  run.counters["contacts"] = contacts;
  run.counters["per_contact"] = benchmark::Counter(static_cast<double>(run.iterations()) * contacts,
                                                   benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// The law of the contacts between balls of a scene, on columns of their motion at the last step.
template <class Law, class Pack, class Scene>
void law_alone(benchmark::State& run, const Scene& scene) {
  const auto& list = scene.ball_contacts;
  const std::size_t count = list.size();
  std::vector<double> radius(count), mass(count), least(count), length(count), overlap(count);
  std::array<std::vector<double>, 3> normal, velocity, force;
  std::array<std::vector<double>, Law::state_size> state, next;
  for (auto* columns : {&normal, &velocity, &force})
    for (auto& column : *columns) column.resize(count);
  for (auto* columns : {&state, &next})
    for (auto& column : *columns) column.resize(count);
  for (std::size_t c = 0; c < count; ++c) {
    const auto contact = scene.ball_contact(c);
    const auto pair = list.pair(c);
    radius[c] = pair.effective_radius;
    mass[c] = pair.effective_mass;
    least[c] = pair.min_radius;
    length[c] = pair.length;
    overlap[c] = contact.geometry.overlap;
    std::array<double, Law::state_size> values{};
    Law::store(list.state(c), values.data());
    for (std::size_t i = 0; i < values.size(); ++i) state[i][c] = values[i];
    for (int i = 0; i < 3; ++i) {
      const auto axis = static_cast<std::size_t>(i);
      normal[axis][c] = contact.geometry.normal[i];
      velocity[axis][c] = contact.motion.velocity[i];
    }
  }
  const auto pair = list.pair(0);  // one material
  contactlaws::ContactBatch<Law> batch;
  batch.count = count;
  batch.pair = {radius.data(), pair.effective_young, pair.effective_shear, mass.data(), least.data(), length.data()};
  batch.overlap = overlap.data();
  batch.dt = scene.time_step;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    batch.normal[axis] = normal[axis].data();
    batch.velocity[axis] = velocity[axis].data();
    batch.force[axis] = force[axis].data();
  }
  for (std::size_t i = 0; i < Law::state_size; ++i) {
    batch.state[i] = state[i].data();
    batch.next[i] = next[i].data();  // not in place: the same step each time
  }
  for (auto _ : run) contactlaws::evaluate<Law, Pack>(scene.ball_law, batch);
}

inline void triad(benchmark::State& run) {
  Triad pass;
  for (auto _ : run) {
    pass();
    benchmark::ClobberMemory();
  }
  run.counters["bandwidth"] =
      benchmark::Counter(static_cast<double>(run.iterations()) * static_cast<double>(Triad::bytes * Triad::count),
                         benchmark::Counter::kIsRate);
}

}  // namespace bench
