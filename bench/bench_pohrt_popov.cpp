// SPDX-License-Identifier: MIT
// What the rough normal law costs by itself: ns per contact, over 1024 contacts of the paper's ballast with overlaps up to
// 20 um, half of them on the virgin curve and half between plastic and largest overlap; beside Hertz, and the increments.
#include <benchmark/benchmark.h>

#include <random>
#include <type_traits>
#include <vector>

#include "contactlaws/contactlaws.hpp"
#include "examples/ballast/pohrt_popov_incremental.hpp"

namespace {

using namespace contactlaws;

template <class T>
constexpr RoughSurface<T> surface{T(2.13), T(26.1e-6)};

template <class Law>
void respond(benchmark::State& run, const Law law) {
  using T = typename Law::Scalar;
  const ElasticMaterial<T> granite{T(60e9), T(0.25), T(2700)};
  const PairProperties<T> pair = pair_properties(sphere(granite, T(4.72e-3)), sphere(granite, T(4.72e-3)));
  std::mt19937_64 random(20220101);
  std::uniform_real_distribution<T> uniform;
  std::vector<T> overlaps(1024);
  std::vector<typename Law::State> states(overlaps.size());
  const auto rough = PohrtPopovElastoPlastic<T>::of(surface<T>);
  for (std::size_t i = 0; i < overlaps.size(); ++i) {
    const T largest = T(20e-6) * uniform(random), plastic = rough.plastic_overlap({largest});
    const T reloaded = plastic + (largest - plastic) * uniform(random);
    overlaps[i] = uniform(random) < T(0.5) ? largest : reloaded;
    law.respond(states[i], pair, largest);
  }
  for (auto _ : run) {
    T sum(0);
    for (std::size_t i = 0; i < overlaps.size(); ++i) {
      typename Law::State state = states[i];
      const NormalResponse<T> response = law.respond(state, pair, overlaps[i]);
      sum += response.force + response.stiffness;
      benchmark::DoNotOptimize(state);
    }
    benchmark::DoNotOptimize(sum);
  }
  const double contacts = static_cast<double>(run.iterations()) * static_cast<double>(overlaps.size());
  run.counters["per_contact"] = benchmark::Counter(contacts, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

template <class T>
using Rough = PohrtPopovElastoPlastic<T>;

BENCHMARK_CAPTURE(respond, hertz / double, Hertz<double>{});
BENCHMARK_CAPTURE(respond, closed / double, Rough<double>::of(surface<double>));
BENCHMARK_CAPTURE(respond, increments / double, PohrtPopovIncremental<double>::of(surface<double>, 1e-12));
BENCHMARK_CAPTURE(respond, hertz / float, Hertz<float>{});
BENCHMARK_CAPTURE(respond, closed / float, Rough<float>::of(surface<float>));

}  // namespace
