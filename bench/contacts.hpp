// SPDX-License-Identifier: MIT
// The contacts that every benchmark steps: a stated mix, so that figures can be compared.
//
//   granite spheres of 2 to 10 mm radius (log-uniform), normals over the sphere, overlaps up to 3e-5 m (half normal, 1e-5)
//   every second pass each contact moves back: its velocity reversed, its normal turned by 1e-4 rad if the mix turns
//   by default 5 % of the contacts slide, roll and twist at the limit of friction, none is open or bridged, and normals rest; a Mix says
//   otherwise
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <type_traits>
#include <vector>

#include "contactlaws/contactlaws.hpp"

namespace bench {

using namespace contactlaws;

struct Mix {
  double sliding = 0.05;  ///< share of the contacts that slide for ever
  double open = 0.0;      ///< share of the contacts that do not touch
  double wet = 0.0;       ///< share of the contacts that carry a bridge, where the law has one
  double turn = 0.0;      ///< angle between the normals of two passes [rad]
};

struct Contact {
  PairProperties<double> pair;
  ContactKinematics<double> there;  ///< in even passes
  ContactKinematics<double> back;   ///< in odd passes
  bool wet;
};

inline constexpr ElasticMaterial<double> material{29e9, 0.15, 2650.0};  // granite

using DryHillInRatio = DryHill<double, Tension::allowed, ShearDashpot::in_ratio>;

inline std::vector<Contact> make_contacts(std::size_t count, const Mix& mix = {}) {
  std::mt19937_64 random(20190405);
  std::uniform_real_distribution<double> uniform;
  std::normal_distribution<double> normal;
  const auto unit = [](const Vec3<double>& v) { return Vec3<double>(v / norm<double>(v)); };
  const auto direction = [&] { return unit(Vec3<double>(normal(random), normal(random), normal(random))); };
  std::vector<Contact> contacts;
  for (std::size_t i = 0; i < count; ++i) {
    const auto radius = [&] { return 2e-3 * std::pow(5.0, uniform(random)); };
    const PairProperties<double> pair = pair_properties(sphere(material, radius()), sphere(material, radius()));
    const bool is_open = uniform(random) < mix.open;
    const bool slides = uniform(random) < mix.sliding;
    const double touching = std::abs(normal(random)) * 1e-5;
    const double overlap = is_open ? -touching : touching;
    const Vec3<double> n = direction();
    const Vec3<double> sideways = n.cross(direction());
    // Per step of 1e-7 s: a slow contact strains its shear spring by 1e-4 of what friction bears, a fast one slides.
    const Vec3<double> velocity = sideways * (overlap * (slides ? 1e7 : 1e2)) + n * (overlap * 1e2);
    const Vec3<double> turned = unit(Vec3<double>(n + mix.turn * sideways));
    const double dt = 1e-7;
    // Slow contacts roll and twist within what friction bears, fast ones beyond it.
    const Vec3<double> spin = (unit(n.cross(sideways)) + n) * (10.0 * norm<double>(velocity) / pair.effective_radius);
    contacts.push_back({pair,
                        {n, overlap, velocity, dt, 0.0, spin},
                        {turned, overlap, -velocity, dt, 0.0, -spin},
                        uniform(random) < mix.wet});
  }
  return contacts;
}

/// A bridge of 200 kPa, or of water: V/R^3 from 1e-4 to 1e-2, and rupture beyond every gap of the mix.
inline void for_bridge(Dry<double>&) {}
inline void for_bridge(SuctionBridge<double>& bridge) { bridge.suction = 200e3; }
template <template <class> class ForceRule, Wets wets>
void for_bridge(CapillaryBridge<double, ForceRule, wets>& bridge) {
  bridge = CapillaryBridge<double, ForceRule, wets>::of(0.072, 0.35, 1e-10);
}

template <Tension tension>
void for_damping(Dashpots<double, tension, ShearDashpot::in_ratio>& dashpots) {
  dashpots.dashpot_ratio = mindlin_dashpot_ratio(effective_moduli(material, material));
}
template <class Damping>
void for_damping(Damping&) {}

inline void for_rolling(RollingSpring<double>& law) { law.rolling_friction = 0.1; }
inline void for_rolling(RollingTorque<double>& law) { law.rolling_friction = 0.1; }
inline void for_rolling(RollingSpringDashpot<double>& law) {
  law.rolling_friction = 0.1;
  law.rolling_damping = 0.3;
}
inline void for_rolling(TwistingSpringDashpot<double>& law) {
  law.twisting_friction = 0.4;
  law.twisting_damping = 0.07;
}
template <class Rolling, class Twisting>
void for_rolling(RollAndTwist<double, Rolling, Twisting>& law) {
  for_rolling(static_cast<Rolling&>(law));
  for_rolling(static_cast<Twisting&>(law));
}

/// Any composition, with the memo's granite for its parameters (and the paper's ballast where it is rough).
template <class Law>
Law granite() {
  using Normal = decltype(Law::normal);
  Law law;
  if constexpr (std::is_same_v<Normal, LinearModulus<double>>) law.normal.modulus = 29e9;
  if constexpr (std::is_same_v<Normal, LinearSpring<double>>) law.normal.normal_stiffness = 1e7;
  if constexpr (std::is_base_of_v<RoughProfile<double>, Normal>) law.normal = Normal::of({2.13, 26.1e-6});
  if constexpr (std::is_same_v<Normal, Jkr<double>> || std::is_same_v<Normal, Dmt<double>>)
    law.normal.work_of_adhesion = 0.1;
  if constexpr (std::is_same_v<Normal, LinearHysteretic<double>>) {
    law.normal.loading_stiffness = 1e7;
    law.normal.unloading_stiffness = 2e7;
    law.normal.cohesive_stiffness = 1e6;
    law.normal.plastic_depth = 0.05;
  }
  if constexpr (std::is_same_v<Normal, ThorntonNing<double>>) law.normal.yield_pressure = 500e6;
  if constexpr (decltype(Law::damping)::acts) law.damping.damping_constant = 0.07;
  for_damping(law.damping);
  if constexpr (decltype(Law::shear)::acts) law.shear.friction = 0.4;
  for_bridge(law.bridge);
  if constexpr (decltype(Law::rolling)::acts) for_rolling(law.rolling);
  return checked(law);
}

/// The state that a contact of the mix starts from: where it rests, it bears a tenth of what friction bears.
template <class Law>
typename Law::State first_state(const Contact& contact) {
  using T = typename Law::Scalar;
  using Reference = typename Law::template Rebind<double>;
  static const Reference law = granite<Reference>();
  typename Reference::State state{};
  if constexpr (decltype(Law::bridge)::acts)
    if (contact.wet) Reference::make_wet(state, 1.0, 0.0);
  ContactKinematics<double> loading = contact.there;
  loading.dt *= 1000.0;
  std::array<double, Law::state_size> values;
  Reference::store(law.step(contact.pair, loading, state).state, values.data());
  std::array<T, Law::state_size> rounded;
  for (std::size_t i = 0; i < values.size(); ++i) rounded[i] = static_cast<T>(values[i]);
  return Law::load(rounded.data());
}

}  // namespace bench
