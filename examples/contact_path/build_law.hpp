// SPDX-License-Identifier: MIT
// From a description to the slots of a law and the properties of a pair, in numbers of type T.
#pragma once

#include <stdexcept>
#include <type_traits>
#include <variant>

#include "any_slots.hpp"
#include "ballast/pohrt_popov_incremental.hpp"
#include "contactlaws/damping/restitution.hpp"
#include "contactlaws/laws.hpp"
#include "law_description.hpp"

namespace contact_path {

template <class T>
struct LawSlots {
  using Damping = std::variant<contactlaws::NoDashpots<T>, contactlaws::Dashpots<T, contactlaws::Tension::allowed>,
                               contactlaws::Dashpots<T, contactlaws::Tension::clipped>>;
  using Shear = std::variant<contactlaws::Frictionless<T>, AnyShear<T>>;
  using Bridge = std::variant<contactlaws::Dry<T>, contactlaws::SuctionBridge<T>>;

  PairProperties<T> pair;
  AnyNormal<T> normal;
  Damping damping;
  Shear shear;
  Bridge bridge;
  bool starts_wet;
};

namespace detail {

/// f of a true or a false that the compiler knows.
template <class F>
auto choose(bool yes, const F& f) {
  return yes ? f(std::true_type{}) : f(std::false_type{});
}

/// The parameters of a slot that the description has.
template <class T, class Slot>
Slot filled(Slot slot, const Description& description) {
  for (const auto& p : Slot::parameters()) slot.*(p.member) = description.number_or<T>(p.name, slot.*(p.member));
  return slot;
}

template <class T>
contactlaws::ContactBody<T> side(const Description& body) {
  using namespace contactlaws;
  // What a rigid or a held body is not asked for does not matter: any value in the range will do.
  const ElasticMaterial<T> material = filled<T>(ElasticMaterial<T>{T(1), T(0), T(1)}, body);
  ContactBody<T> side = body.is("plane") ? plane<T>(material) : sphere<T>(material, body.number<T>("radius"));
  if (body.has("mass")) side = side.with_mass(body.number<T>("mass"));
  if (body.is("fixed")) side = side.fixed();
  if (body.is("rigid")) side = side.rigid();
  return side;
}

template <class T>
PairProperties<T> pair(const LawDescription& law) {
  if (!law.bodies.empty()) return contactlaws::pair_properties<T>(side<T>(law.bodies[0]), side<T>(law.bodies[1]));
  // What the law does not ask for may be left out; should it ask all the same, nothing but NaN would come of it.
  const T unknown = std::numeric_limits<T>::quiet_NaN();
  const auto value = [&](const char* key) { return law.pair.number_or<T>(key, unknown); };
  return {value("radius"), value("young"), value("shear"), value("mass"), value("min_radius"), value("length")};
}

template <class T>
AnyNormal<T> normal(const Description& law) {
  using namespace contactlaws;
  if (law.law == "linear") {
    if (law.has("modulus")) return AnyNormal<T>(LinearModulus<T>{law.number<T>("modulus")});
    return AnyNormal<T>(LinearSpring<T>{law.number<T>("stiffness")});
  }
  if (law.law == "hertz") return AnyNormal<T>(Hertz<T>{});
  const RoughSurface<T> surface = filled<T>(RoughSurface<T>{}, law);
  if (law.law == "pohrt_popov_incremental") {
    return choose(law.word("unloads") == "plastically", [&](auto plastic) {
      constexpr Unloads unloads = plastic ? Unloads::plastically : Unloads::elastically;
      return AnyNormal<T>(PohrtPopovIncremental<T, unloads>::of(surface, law.number<T>("seed_force")));
    });
  }
  if (law.law == "pohrt_popov") return AnyNormal<T>(PohrtPopov<T>::of(surface));
  return choose(law.word("recontact") == "fresh_surface", [&](auto fresh) {
    constexpr Recontact recontact = fresh ? Recontact::fresh_surface : Recontact::same_spot;
    return AnyNormal<T>(PohrtPopovElastoPlastic<T, recontact>::of(surface));
  });
}

template <class T>
typename LawSlots<T>::Damping damping(const LawDescription& law) {
  using namespace contactlaws;
  const Description& said = law.damping;
  if (said.law == "none") return NoDashpots<T>{};
  return choose(said.word("tension") == "clipped", [&](auto clipped) -> typename LawSlots<T>::Damping {
    constexpr Tension tension = clipped ? Tension::clipped : Tension::allowed;
    const Spring spring = law.normal.law == "linear" ? Spring::linear : Spring::hertz;
    if (said.has("damping_constant")) return Dashpots<T, tension>{said.number<T>("damping_constant")};
    return Dashpots<T, tension>{damping_constant<T>(said.number<T>("restitution"), spring, tension)};
  });
}

template <class T, class Stiffness, class Carry>
AnyShear<T> shear_history(const Description& said, const Stiffness& stiffness) {
  using namespace contactlaws;
  const bool displaced = said.law == "displacement" || said.law == "displacement_rescaled";
  const bool rescaled = said.law == "force_rescaled" || said.law == "displacement_rescaled";
  return choose(displaced, [&](auto is_displaced) {
    return choose(rescaled, [&](auto is_rescaled) {
      constexpr Stored stored = is_displaced ? Stored::displacement : Stored::force;
      constexpr Unloading unloading = is_rescaled ? Unloading::rescales : Unloading::keeps;
      return AnyShear<T>(
          IncrementalShear<T, stored, unloading, Stiffness, Carry>{stiffness, said.number<T>("friction")});
    });
  });
}

template <class T, class Stiffness>
AnyShear<T> carried_shear(const Description& said, const Stiffness& stiffness) {
  using namespace contactlaws::rotation;
  const std::string& carry = said.word("carry");
  if (carry == "project") return shear_history<T, Stiffness, Project<T>>(said, stiffness);
  if (carry == "rotate") return shear_history<T, Stiffness, Rotate<T>>(said, stiffness);
  return shear_history<T, Stiffness, ProjectRestore<T>>(said, stiffness);
}

template <class T>
typename LawSlots<T>::Shear shear(const LawDescription& law, const PairProperties<T>& pair) {
  using namespace contactlaws;
  const Description& said = law.shear;
  if (said.law == "none") return Frictionless<T>{};
  if (law.is_mindlin()) return carried_shear<T>(said, Mindlin<T>{});
  return carried_shear<T>(said, ConstantRatio<T>{said.has("ratio") ? said.number<T>("ratio") : mindlin_ratio<T>(pair)});
}

template <class T>
typename LawSlots<T>::Bridge bridge(const Description& law) {
  if (law.law == "none") return contactlaws::Dry<T>{};
  return filled<T>(contactlaws::SuctionBridge<T>{}, law);
}

}  // namespace detail

/// @throws InputError, if the precision cannot hold a value, or the two bodies do not make a pair
template <class T>
LawSlots<T> build_law(const LawDescription& law) {
  try {
    const PairProperties<T> pair = detail::pair<T>(law);
    return {pair,
            detail::normal<T>(law.normal),
            detail::damping<T>(law),
            detail::shear<T>(law, pair),
            detail::bridge<T>(law.bridge),
            law.bridge.is("wet")};
  } catch (const std::invalid_argument& out_of_range) {
    fail(law.pair.place, out_of_range.what());
  }
}

}  // namespace contact_path
