// SPDX-License-Identifier: MIT
// Every composition around one normal law, made at compile time. CMakeLists.txt compiles one file per normal law, as there are
// hundreds of compositions.
#pragma once

#include "law_run.hpp"

namespace trade {

namespace detail {

/// Slots that are not measured, to limit the number of compositions. check_measured() refuses them.
template <class Slot>
inline constexpr bool is_measured = true;
template <class T>
inline constexpr bool is_measured<PohrtPopovElastoPlastic<T, Recontact::same_spot>> = false;
template <class T>
inline constexpr bool is_measured<PohrtPopovIncremental<T, Unloads::elastically>> = false;
template <class T, Tension tension>
inline constexpr bool is_measured<Dashpots<T, tension, ShearDashpot::given>> = false;
template <class T, Stored stored, Unloading unloading, class Stiffness, class Rotation>
inline constexpr bool is_measured<IncrementalShear<T, stored, unloading, Stiffness, Rotation, StaticKinetic<T>>> =
    false;
template <class T, class Rotation, int corners>
inline constexpr bool is_measured<MindlinDeresiewicz<T, Rotation, corners>> =
    std::is_same_v<MindlinDeresiewicz<T, Rotation, corners>, MindlinDeresiewicz<T>>;
template <class T, Stored stored, Unloading unloading, class Rotation>
inline constexpr bool is_measured<IncrementalShear<T, stored, unloading, ElasticRatio<T>, Rotation, Coulomb<T>>> =
    false;

/// Batches and pure float are offered with a force history (or none) that is not rotated, and tension allowed.
template <class Shear>
inline constexpr bool is_plain_shear = !Shear::acts;
template <class T, class Stiffness>
inline constexpr bool is_plain_shear<ShearForce<T, Stiffness>> = true;
template <class Damping>
inline constexpr bool is_plain_damping = true;
template <class T>
inline constexpr bool is_plain_damping<Dashpots<T, Tension::clipped>> = false;

template <class Law, class Geometry>
std::unique_ptr<Run> scalar_run(const Law& law, const PairProperties<double>& pair, bool wet, const Trajectories& t) {
  using T = typename Law::Scalar;
  Kernel<T, Geometry> kernel{std::make_shared<const Law>(law), Law::state_size, first_state<Law>(wet),
                             advance_one_by_one<Law, Geometry>, stored_energy<Law>};
  return std::make_unique<ScalarRun<T, Geometry>>(std::move(kernel), pair, t);
}

template <class Law>
std::unique_ptr<Run> run_of(const Law& law, const Composition& c, const PairProperties<double>& pair,
                            const Trajectories& t) {
  const bool wet = c.law.bridge.is("wet");
  const auto in_float = [&law] { return law.template cast<float>(); };
  if constexpr (is_plain_shear<decltype(Law::shear)> && is_plain_damping<decltype(Law::damping)>) {
    using InFloat = decltype(in_float());
    if (c.loop == Loop::batch && c.precision == Precision::in_double)
      return std::make_unique<BatchRun<Law>>(law, pair, wet, t);
    if (c.loop == Loop::batch && c.precision == Precision::in_float)
      return std::make_unique<BatchRun<InFloat>>(in_float(), pair, wet, t);
    if (c.precision == Precision::in_float) return scalar_run<InFloat, float>(in_float(), pair, wet, t);
  }
  if (c.loop == Loop::batch || c.precision == Precision::in_float) return nullptr;
  if (c.precision == Precision::law_in_float) return scalar_run<decltype(in_float()), double>(in_float(), pair, wet, t);
  return scalar_run<Law, double>(law, pair, wet, t);
}

}  // namespace detail

/// With the normal law `normal_laws()[index]`. Null for what is not offered.
template <std::size_t index>
std::unique_ptr<Run> make_run_of(const Composition& c, const Trajectories& t) {
  using namespace contact_path;
  const PairProperties<double> pair = pair_of<double>(c.law);
  const auto given = [&](const Chosen& chosen) { return Given<double>{chosen, pair, c.law}; };
  return std::get<index>(normal_laws()).build(given(c.law.normal), [&](const auto& normal) {
    return with_law(damping_laws(), given(c.law.damping), [&](const auto& damping) {
      return with_law(shear_laws(), given(c.law.shear), [&](const auto& shear) {
        return with_law(bridge_laws(), given(c.law.bridge), [&](const auto& bridge) -> std::unique_ptr<Run> {
          using Normal = std::decay_t<decltype(normal)>;
          using Damping = std::decay_t<decltype(damping)>;
          using Shear = std::decay_t<decltype(shear)>;
          using Bridge = std::decay_t<decltype(bridge)>;
          if constexpr (detail::is_measured<Normal> && detail::is_measured<Damping> && detail::is_measured<Shear> &&
                        contactlaws::detail::stiffness_fits<Normal, Shear>) {
            using Law = contactlaws::ContactLaw<Normal, Damping, Shear, Bridge>;
            return detail::run_of(Law{normal, damping, shear, bridge, {}}, c, pair, t);
          } else {
            return nullptr;
          }
        });
      });
    });
  });
}

}  // namespace trade
