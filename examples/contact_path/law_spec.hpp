// SPDX-License-Identifier: MIT
// The laws that a LAW.toml may name, and how each is built. One table per slot serves the reader (law_file.hpp), the help
// (list.hpp), contact_path (any_law.hpp) and bench/trade. To add a law, add an entry to the table of its slot.
#pragma once

#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

#include "ballast/pohrt_popov_incremental.hpp"
#include "contactlaws/contactlaws.hpp"
#include "law_keys.hpp"

namespace contact_path {

using contactlaws::PairProperties;

/// A law and its pair of bodies as read from a file. check() has accepted it.
struct LawSpec {
  Chosen normal;
  Chosen damping;
  Chosen shear;
  Chosen bridge;
  Chosen rolling;
  Chosen pair;                 ///< effective values, unless there are bodies
  std::vector<Chosen> bodies;  ///< none or two
};

/// What a law is built from, in numbers of type T.
template <class T>
struct Given {
  const Chosen& chosen;
  const PairProperties<T>& pair;
  const LawSpec& law;
};

/// An entry of a table: keys, and a builder `build(given, use)` that returns use(slot).
template <class Build>
struct Entry {
  KeyTable keys;
  Build build;
};

namespace detail {

using namespace contactlaws;

/// f of a true or a false that the compiler knows.
template <class F>
auto choose(bool yes, const F& f) {
  return yes ? f(std::true_type{}) : f(std::false_type{});
}

/// A slot whose parameters() are its keys.
template <template <class> class Slot>
struct Plain {
  template <class T, class Use>
  auto operator()(const Given<T>& given, const Use& use) const {
    return use(checked(given.chosen.template filled<T>(Slot<T>{})));
  }
};
template <template <class> class Slot>
Entry<Plain<Slot>> law(const std::string& name, const std::string& doc, const std::vector<std::string>& reads = {},
                       const std::vector<FlagKey>& flags = {}, std::optional<Spring> spring = {}) {
  return {{name, doc, reads, number_keys<Slot<double>>(), {}, flags, spring}, {}};
}

struct LinearLaw {
  template <class T, class Use>
  auto operator()(const Given<T>& given, const Use& use) const {
    if (given.chosen.has("modulus")) return use(LinearModulus<T>{given.chosen.template number<T>("modulus")});
    return use(LinearSpring<T>{given.chosen.template number<T>("stiffness")});
  }
};

/// A law of rough surfaces; of two laws, the word of `key` chooses, and First is the default.
template <template <class> class First, template <class> class Second = First>
struct RoughLaw {
  WordKey key;

  template <class T, class Use>
  auto operator()(const Given<T>& given, const Use& use) const {
    const auto surface = given.chosen.template filled<T>(RoughSurface<T>{});
    const auto build = [&](const auto& of) { return use(checked(given.chosen.template filled<T>(of))); };
    if constexpr (!std::is_same_v<First<T>, Second<T>>)
      if (given.chosen.word(key.name) == key.words[1]) return build(rough<Second<T>>(surface));
    return build(rough<First<T>>(surface));
  }

 private:
  template <class Law, class T>
  static Law rough(const RoughSurface<T>& surface) {
    const auto profile = PohrtPopov<T>::of(surface);
    Law law;
    law.exponent = profile.exponent;
    law.transition_overlap = profile.transition_overlap;
    return law;
  }
};
template <template <class> class First, template <class> class Second = First>
Entry<RoughLaw<First, Second>> rough_law(const std::string& name, const std::string& doc, const WordKey& key = {}) {
  std::vector<NumberKey> numbers = number_keys<RoughSurface<double>>();
  for (const NumberKey& own : number_keys<First<double>>())
    if (own.name != "exponent" && own.name != "transition_overlap") numbers.push_back(own);
  const std::vector<WordKey> words = key.words.empty() ? std::vector<WordKey>{} : std::vector<WordKey>{key};
  return {{name, doc, {"effective_radius", "effective_young"}, numbers, words, {}, {}}, {key}};
}
template <class T>
using RoughFresh = PohrtPopovElastoPlastic<T, Recontact::fresh_surface>;
template <class T>
using RoughSameSpot = PohrtPopovElastoPlastic<T, Recontact::same_spot>;
template <class T>
using IncrementsPlastic = PohrtPopovIncremental<T, Unloads::plastically>;
template <class T>
using IncrementsElastic = PohrtPopovIncremental<T, Unloads::elastically>;

/// A law that pulls, with the rule of friction that the word chooses; the first is the law's own.
template <template <class, AdhesiveFriction> class Law, AdhesiveFriction own>
struct AdhesiveLaw {
  template <class T, class Use>
  auto operator()(const Given<T>& given, const Use& use) const {
    const auto with = [&](auto law) { return use(checked(given.chosen.template filled<T>(law))); };
    const std::string& rule = given.chosen.word("adhesive_friction");
    if (rule == "none") return with(Law<T, AdhesiveFriction::none>{});
    if (rule == "thornton_dmt") return with(Law<T, AdhesiveFriction::thornton_dmt>{});
    if (rule == "thornton_jkr") return with(Law<T, AdhesiveFriction::thornton_jkr>{});
    return with(Law<T, own>{});
  }
};
template <template <class, AdhesiveFriction> class Law, AdhesiveFriction own>
Entry<AdhesiveLaw<Law, own>> adhesive_law(const std::string& name, const std::string& doc) {
  return {{name,
           doc,
           {"effective_radius", "effective_young"},
           number_keys<Law<double, own>>(),
           {{"adhesive_friction",
             {"default", "none", "thornton_dmt", "thornton_jkr"},
             "friction multiplies max(F, 0), F + F_c or F + 2 F_c; default: thornton_" + name}},
           {},
           {}},
          {}};
}
/// Of the force rules only the exact one, of the two ways of wetting only the host's: each type of a bridge compiles anew
/// beside each type of every other slot.
struct CapillaryLaw {
  template <class T, class Use>
  auto operator()(const Given<T>& given, const Use& use) const {
    CapillaryBridge<T> bridge = checked(given.chosen.template filled<T>(CapillaryBridge<T>{}));
    bridge.prepare();
    return use(bridge);
  }
};

template <class T>
using SpringDashpot = RollingSpringDashpot<T>;
template <class T>
using SpringDashpotOfShear = RollingSpringDashpot<T, ShearRolling<T>>;
template <class T>
using SpringDashpotGiven = RollingSpringDashpot<T, GivenRolling<T>>;
template <class T>
using Twist = TwistingSpringDashpot<T>;
template <class T>
using TwistGiven = TwistingSpringDashpot<T, GivenTwisting<T>>;
template <class T>
using SpringAndTwist = RollAndTwist<T, RollingSpringDashpot<T>>;
template <class T>
using GivenAndTwist = RollAndTwist<T, SpringDashpotGiven<T>, Twist<T>>;

struct DashpotsLaw {
  template <class T, class Use>
  auto operator()(const Given<T>& given, const Use& use) const;
};

inline WordKey rotation_key() {
  return {"rotation", {"project_restore", "project", "rotate"}, "how the history follows the contact plane"};
}
template <Stored stored, Unloading unloading>
struct ShearLaw {
  template <class T, class Use>
  auto operator()(const Given<T>& given, const Use& use) const {
    const Chosen& chosen = given.chosen;
    const auto with = [&](auto rotation, auto friction, auto stiffness) {
      using Shear = IncrementalShear<T, stored, unloading, decltype(stiffness), decltype(rotation), decltype(friction)>;
      Shear shear;
      if constexpr (!std::is_same_v<decltype(stiffness), Mindlin<T>>)
        if (!chosen.has("ratio")) shear.ratio = mindlin_ratio<T>(given.pair);
      return use(checked(chosen.template filled<T>(shear)));
    };
    const auto with_stiffness = [&](auto rotation, auto friction) {
      if (chosen.word("stiffness") == "mindlin") return with(rotation, friction, Mindlin<T>{});
      if (chosen.word("stiffness") == "elastic_ratio") return with(rotation, friction, ElasticRatio<T>{});
      return with(rotation, friction, ConstantRatio<T>{});
    };
    const auto with_friction = [&](auto rotation) {
      if (chosen.has("static_friction")) return with_stiffness(rotation, StaticKinetic<T>{});
      return with_stiffness(rotation, Coulomb<T>{});
    };
    if (chosen.word("rotation") == "project") return with_friction(rotation::Project<T>{});
    if (chosen.word("rotation") == "rotate") return with_friction(rotation::Rotate<T>{});
    return with_friction(rotation::ProjectRestore<T>{});
  }
};
template <Stored stored, Unloading unloading>
Entry<ShearLaw<stored, unloading>> shear_law(const std::string& name, const std::string& doc) {
  using Shear = IncrementalShear<double, stored, unloading, ConstantRatio<double>, rotation::Project<double>,
                                 StaticKinetic<double>>;
  return {
      {name,
       doc,
       {},
       {number_key<Shear>("friction", Presence::required, "coefficient, the tangent of the angle of friction"),
        number_key<Shear>("static_friction", Presence::optional, "of a contact that sticks; default: friction"),
        number_key<Shear>("ratio", Presence::optional,
                          "of constant_ratio and elastic_ratio; default: Mindlin's to Hertz's, 4 G*/E* of the pair")},
       {rotation_key(),
        {"stiffness",
         {"default", "mindlin", "constant_ratio", "elastic_ratio"},
         "8 G* a, or ratio times the normal law's tangent or elastic tangent; default: mindlin where the normal law "
         "has a contact radius a, else constant_ratio"}},
       {},
       {}},
      {}};
}

struct PartialSlipLaw {
  template <class T, class Use>
  auto operator()(const Given<T>& given, const Use& use) const {
    const auto with = [&](auto rotation) {
      const auto built = [&](auto shear) { return use(checked(given.chosen.template filled<T>(shear))); };
      if (given.chosen.word("corners") == "12") return built(MindlinDeresiewicz<T, decltype(rotation), 12>{});
      return built(MindlinDeresiewicz<T, decltype(rotation)>{});
    };
    if (given.chosen.word("rotation") == "project") return with(rotation::Project<T>{});
    if (given.chosen.word("rotation") == "rotate") return with(rotation::Rotate<T>{});
    return with(rotation::ProjectRestore<T>{});
  }
};

}  // namespace detail

/// From simple to full: trade tries the earlier laws in place of a later one whose numbers they can use.
inline const auto& normal_laws() {
  using namespace detail;
  static const std::tuple laws{
      Entry<LinearLaw>{
          {"linear",
           "F = k o, with k given, or k = E pi r^2/L from an effective modulus",
           {},
           {{"stiffness", "N/m", Range::positive(), Presence::either, ""},
            number_key<LinearModulus<double>>("modulus", Presence::either, "reads the pair's min_radius and length")},
           {},
           {},
           Spring::linear},
          {}},
      law<Hertz>("hertz", "F = 4/3 E* sqrt(R*) o^(3/2)", {"effective_radius", "effective_young"}, {}, Spring::hertz),
      adhesive_law<Dmt, AdhesiveFriction::thornton_dmt>("dmt",
                                                        "hertz less the constant pull 2 pi w R* while it touches"),
      adhesive_law<Jkr, AdhesiveFriction::thornton_jkr>(
          "jkr", "adhesion of soft spheres: touches at o = 0, pulls 3/2 pi w R* at most, lets go beyond touch"),
      law<LinearHysteretic>(
          "linear_hysteretic",
          "Luding's lines: loading k1, unloading up to k2 as the largest overlap grows, pulling -kc o",
          {"effective_radius"}),
      law<ThorntonNing>("thornton_ning",
                        "hertz up to the yield pressure, linear beyond; unloading with a flattened radius",
                        {"effective_radius", "effective_young"}),
      rough_law<PohrtPopov>("pohrt_popov", "rough surfaces, elastic"),
      rough_law<RoughFresh, RoughSameSpot>(
          "pohrt_popov_elasto_plastic", "rough surfaces that flatten: unloading along Hertz's curve, in closed form",
          {"recontact", {"fresh_surface", "same_spot"}, "which surfaces meet after the bodies were apart"}),
      rough_law<IncrementsPlastic, IncrementsElastic>(
          "pohrt_popov_incremental", "the same by increments F := F + k(F) do",
          {"unloads", {"plastically", "elastically"}, "whether surfaces flatten"})};
  return laws;
}

inline const auto& damping_laws() {
  using namespace detail;
  using Both = Dashpots<double, Tension::allowed, ShearDashpot::given>;
  static const std::tuple laws{
      law<NoDashpots>("none", ""),
      Entry<DashpotsLaw>{
          {"dashpots",
           "c = damping_constant sqrt(m* k), normal and shear",
           {"effective_mass"},
           {number_key<Both>("damping_constant", Presence::either),
            {"restitution", "1", Range::left_open(0.0, 1.0), Presence::either,
             "coefficient of restitution instead; for normal hertz and linear"},
            number_key<Both>("shear_damping_constant", Presence::optional, "default: damping_constant; 0: none")},
           {{"tension", {"allowed", "clipped"}, "whether spring and dashpot together may pull"}},
           {},
           {}},
          {}}};
  return laws;
}

inline const auto& shear_laws() {
  using namespace detail;
  static const std::tuple laws{
      law<Frictionless>("none", "frictionless"),
      shear_law<Stored::force, Unloading::keeps>("force", "history: the shear force, kept as the overlap changes"),
      shear_law<Stored::force, Unloading::rescales>("force_rescaled", "the same, times k/k_before where k falls"),
      shear_law<Stored::displacement, Unloading::keeps>("displacement",
                                                        "history: the shear displacement d; force = -k d"),
      shear_law<Stored::displacement, Unloading::rescales>("displacement_rescaled",
                                                           "the same, times k/k_before where k falls"),
      Entry<PartialSlipLaw>{{"partial_slip",
                             "Mindlin and Deresiewicz: the edge slips while the centre sticks; beside a normal law "
                             "with a contact radius that does not pull",
                             {},
                             number_keys<MindlinDeresiewicz<double>>(),
                             {rotation_key(),
                              {"corners", {"4", "12"}, "of the history: how much of it is kept"},
                              {"stiffness", {"default", "mindlin"}, "8 G* a"}},
                             {},
                             {}},
                            {}}};
  return laws;
}

inline const auto& bridge_laws() {
  using namespace detail;
  static const std::tuple laws{
      law<Dry>("none", "dry"),
      law<SuctionBridge>("suction", "F = psi pi R_o^2 exp(-gap / (decay_length R_o)), until the gap is rupture_gap R_o",
                         {"min_radius"}, {{"wet", "whether the contact is wet before the first step"}}),
      Entry<CapillaryLaw>{{"capillary",
                           "a bridge of a given volume, the exact force; while touching that at gap 0",
                           {"effective_radius"},
                           number_keys<CapillaryBridge<double>>(),
                           {},
                           {{"wet", "whether the contact is wet before the first step"}},
                           {}},
                          {}}};
  return laws;
}

inline const auto& rolling_laws() {
  using namespace detail;
  static const std::tuple laws{
      law<NoRolling>("none", ""),
      law<RollingSpring>("spring", "elastic-plastic spring against rolling: |M| <= rolling_friction R* P",
                         {"effective_radius"}),
      law<RollingTorque>("torque", "constant torque rolling_friction R* P against rolling; 0 at rest",
                         {"effective_radius"}),
      law<SpringDashpot>("spring_dashpot", "the spring, and a dashpot below its limit",
                         {"effective_radius", "effective_mass"}),
      law<SpringDashpotOfShear>("spring_dashpot_of_shear",
                                "the same with k_r = stiffness_ratio k_n R*^2, k_n the normal law's tangent",
                                {"effective_radius", "effective_mass"}),
      law<SpringDashpotGiven>("spring_dashpot_given", "the same with a given stiffness",
                              {"effective_radius", "effective_mass"}),
      law<Twist>("twisting", "Marshall's spring and dashpot against twisting; beside Hertz",
                 {"effective_mass", "effective_young", "effective_shear"}),
      law<TwistGiven>("twisting_given", "spring and dashpot against twisting: |M| <= twisting_reach P"),
      law<GivenAndTwist>("spring_dashpot_given_twisting", "spring_dashpot_given and twisting",
                         {"effective_radius", "effective_mass", "effective_young", "effective_shear"}),
      law<SpringAndTwist>("spring_dashpot_twisting",
                          "spring with a dashpot against rolling, spring against twisting; beside Hertz",
                          {"effective_radius", "effective_mass", "effective_young", "effective_shear"})};
  return laws;
}

/// The keys of a table's laws.
template <class... Builds>
std::vector<KeyTable> keys_of(const std::tuple<Entry<Builds>...>& laws) {
  return std::apply([](const auto&... entry) { return std::vector<KeyTable>{entry.keys...}; }, laws);
}

/// use(slot) of the law that was chosen from a table.
template <std::size_t i = 0, class Laws, class T, class Use>
auto with_law(const Laws& laws, const Given<T>& given, const Use& use) {
  const auto& entry = std::get<i>(laws);
  if constexpr (i + 1 < std::tuple_size_v<Laws>)
    if (entry.keys.name != given.chosen.law) return with_law<i + 1>(laws, given, use);
  if (entry.keys.name != given.chosen.law) throw std::logic_error("no law is called " + given.chosen.law);
  return entry.build(given, use);
}

/// A slot: its name in the file, the law chosen for it, the laws that it may hold. A slot without `none` is required.
struct SlotTable {
  const char* name;
  Chosen LawSpec::*chosen;
  std::vector<KeyTable> laws;
};
inline const std::vector<SlotTable>& slot_tables() {
  static const std::vector<SlotTable> all{{"normal", &LawSpec::normal, keys_of(normal_laws())},
                                          {"damping", &LawSpec::damping, keys_of(damping_laws())},
                                          {"shear", &LawSpec::shear, keys_of(shear_laws())},
                                          {"bridge", &LawSpec::bridge, keys_of(bridge_laws())},
                                          {"rolling", &LawSpec::rolling, keys_of(rolling_laws())}};
  return all;
}
/// What converts a coefficient of restitution beside a normal law, where that is known.
inline std::optional<contactlaws::Spring> spring_of(const Chosen& normal) {
  for (const KeyTable& keys : slot_tables()[0].laws)
    if (keys.name == normal.law) return keys.spring;
  return {};
}

/// [pair] with effective values.
inline const KeyTable& effective_pair() {
  const auto key = [](const char* name, const char* unit, const char* doc) {
    return NumberKey{name, unit, contactlaws::Range::positive(), Presence::optional, doc};
  };
  static const KeyTable keys{
      "pair",
      "effective values: those that the law reads",
      {},
      {key("effective_radius", "m", "R*: 1/R* = 1/R1 + 1/R2"),
       key("effective_young", "Pa", "E*: 1/E* = (1-nu1^2)/E1 + (1-nu2^2)/E2"),
       key("effective_shear", "Pa", "G*: 1/G* = 2(2-nu1)(1+nu1)/E1 + 2(2-nu2)(1+nu2)/E2"),
       key("effective_mass", "kg", "m*: 1/m* = 1/m1 + 1/m2"), key("min_radius", "m", "R_o, of the smaller body"),
       key("length", "m", "L = R1 + R2; a wall adds nothing")},
      {},
      {},
      {}};
  return keys;
}

/// [pair.body1] and [pair.body2].
inline const KeyTable& body() {
  using Material = contactlaws::ElasticMaterial<double>;
  using contactlaws::Range;
  static const KeyTable keys{
      "body",
      "a sphere, or a wall",
      {},
      {{"radius", "m", Range::positive(), Presence::optional, "unless plane"},
       number_key<Material>("young", Presence::optional, "unless rigid"),
       number_key<Material>("poisson", Presence::optional, "unless rigid"),
       number_key<Material>("density", Presence::optional, "this or mass, unless fixed or plane"),
       {"mass", "kg", Range::positive(), Presence::optional, ""}},
      {},
      {{"plane", "a flat wall, held in space"}, {"fixed", "held in space"}, {"rigid", "does not deform"}},
      {}};
  return keys;
}

namespace detail {

template <class T, class Use>
auto DashpotsLaw::operator()(const Given<T>& given, const Use& use) const {
  const Chosen& chosen = given.chosen;
  return choose(chosen.word("tension") == "clipped", [&](auto clipped) {
    constexpr Tension tension = clipped ? Tension::clipped : Tension::allowed;
    const auto with = [&](auto dashpots) {
      if (chosen.has("restitution"))
        dashpots.damping_constant =
            damping_constant<T>(chosen.template number<T>("restitution"), spring_of(given.law.normal).value(), tension);
      return use(checked(chosen.template filled<T>(dashpots)));
    };
    if (chosen.has("shear_damping_constant")) return with(Dashpots<T, tension, ShearDashpot::given>{});
    return with(Dashpots<T, tension>{});
  });
}

template <class T>
ContactBody<T> contact_body(const Chosen& chosen) {
  // A rigid body needs no stiffness and a fixed body no density: any value in the range will do.
  const ElasticMaterial<T> material = chosen.filled<T>(ElasticMaterial<T>{T(1), T(0), T(1)});
  ContactBody<T> made = chosen.is("plane") ? plane<T>(material) : sphere<T>(material, chosen.number<T>("radius"));
  if (chosen.has("mass")) made = made.with_mass(chosen.number<T>("mass"));
  if (chosen.is("fixed")) made = made.fixed();
  if (chosen.is("rigid")) made = made.rigid();
  return made;
}

/// Whether a normal law has the contact radius that Mindlin's stiffness reads.
template <class Normal>
inline constexpr bool has_contact_radius =
    std::is_base_of_v<HertzResponse<double>, decltype(std::declval<const Normal&>().respond(
                                                 std::declval<typename Normal::State&>(),
                                                 std::declval<const PairProperties<double>&>(), 0.0))>;

}  // namespace detail

/// The properties of the pair; NaN for those that are not given, which the law does not read.
/// @throws std::invalid_argument if the two bodies do not make a pair
template <class T>
PairProperties<T> pair_of(const LawSpec& law) {
  if (!law.bodies.empty())
    return contactlaws::pair_properties<T>(detail::contact_body<T>(law.bodies[0]),
                                           detail::contact_body<T>(law.bodies[1]));
  const auto value = [&](const char* key) { return law.pair.number_or<T>(key, std::numeric_limits<T>::quiet_NaN()); };
  return {value("effective_radius"), value("effective_young"), value("effective_shear"),
          value("effective_mass"),   value("min_radius"),      value("length")};
}

/// The checks that need more than one table; sets the stiffness of [shear] where it is left to the normal law.
/// @throws InputError naming file, line, key and reason
inline void check(LawSpec& law) {
  const auto needs = [&law](const std::string& key, const std::string& reader) {
    if (!law.bodies.empty() || law.pair.has(key)) return;
    for (const NumberKey& number : effective_pair().numbers)
      if (number.name == key)
        law.pair.refuse(key, "is missing, must be a number in " + contactlaws::to_string(number.range) + ' ' +
                                 number.unit + ": " + reader + " reads it");
  };
  for (const SlotTable& slot : slot_tables())
    for (const KeyTable& keys : slot.laws)
      for (const std::string& property : keys.reads)
        if (keys.name == (law.*slot.chosen).law) needs(property, (law.*slot.chosen).title + ' ' + keys.name);
  if (law.normal.has("modulus"))
    for (const char* property : {"min_radius", "length"}) needs(property, "[normal] modulus");
  if (law.damping.has("restitution") && !spring_of(law.normal))
    law.damping.refuse("restitution", "is given, but beside " + law.normal.law +
                                          " it depends on the speed of impact: give damping_constant");
  if (!law.shear.acts()) return;

  const PairProperties<double> unused{};
  const bool pulls = with_law(normal_laws(), Given<double>{law.normal, unused, law}, [](const auto& normal) {
    return contactlaws::detail::adheres<std::decay_t<decltype(normal)>>;
  });
  const bool has_radius = with_law(normal_laws(), Given<double>{law.normal, unused, law}, [](const auto& normal) {
    return detail::has_contact_radius<std::decay_t<decltype(normal)>>;
  });
  std::string& stiffness = law.shear.words["stiffness"];
  if (stiffness == "default") stiffness = has_radius ? "mindlin" : "constant_ratio";
  if (law.shear.law == "partial_slip") {
    if (!has_radius || pulls)
      law.shear.refuse(
          "law",
          "is partial_slip, which needs a normal law with a contact radius that does not pull, not " + law.normal.law);
    stiffness = "mindlin";
  }
  if (stiffness == "mindlin") {
    if (!has_radius) law.shear.refuse("stiffness", "is \"mindlin\", but " + law.normal.law + " has no contact radius");
    if (law.shear.has("ratio"))
      law.shear.refuse("ratio",
                       "is given, but Mindlin's stiffness does not read it: add stiffness = \"constant_ratio\"");
    needs("effective_shear", "Mindlin's stiffness");
  } else if (!law.shear.has("ratio")) {
    for (const char* property : {"effective_young", "effective_shear"}) needs(property, "[shear] without a ratio");
  }
}

}  // namespace contact_path
