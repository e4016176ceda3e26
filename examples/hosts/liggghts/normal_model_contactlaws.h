// SPDX-License-Identifier: GPL-2.0-only
// contactlaws as normal models of LIGGGHTS. One model is a whole law, with its shear force: `tangential` stays off.
//
//   pair_style gran model contactlaws/dry_hill                 history: the shear force
//   pair_style gran model contactlaws/dry_hill_displacement    history: a displacement, as of LIGGGHTS's `tangential history`
//   pair_style gran model contactlaws/hill                     dry_hill and a liquid bridge; what touches becomes wet
//   pair_style gran model contactlaws/rough_ballast
//   pair_style gran model contactlaws/cohesive_powder          adhesion, which holds beyond touch; friction and rolling resistance
//   pair_style gran model contactlaws/wet_grains               bridges of a given volume, which form where grains touch
//   fix ID all wall/gran model contactlaws/... primitive ... or mesh ...
//
// Parameters are properties of LIGGGHTS: `property/global youngsModulus` and `poissonsRatio`, peratomtype, and those that
// property_of() names, peratomtypepair.
#ifdef NORMAL_MODEL
NORMAL_MODEL(CONTACTLAWS_DRY_HILL, contactlaws / dry_hill, 40)
NORMAL_MODEL(CONTACTLAWS_DRY_HILL_DISPLACEMENT, contactlaws / dry_hill_displacement, 41)
NORMAL_MODEL(CONTACTLAWS_HILL, contactlaws / hill, 42)
NORMAL_MODEL(CONTACTLAWS_ROUGH_BALLAST, contactlaws / rough_ballast, 43)
NORMAL_MODEL(CONTACTLAWS_COHESIVE_POWDER, contactlaws / cohesive_powder, 44)
NORMAL_MODEL(CONTACTLAWS_WET_GRAINS, contactlaws / wet_grains, 45)
#else
#ifndef NORMAL_MODEL_CONTACTLAWS_H_
#define NORMAL_MODEL_CONTACTLAWS_H_

#include <stdexcept>
#include <string>
#include <vector>

#include "../laws.hpp"
#include "atom.h"
#include "error.h"
#include "fix_property_global.h"
#include "fix_rigid.h"
#include "fix_wall_gran.h"
#include "neighbor.h"
#include "normal_model_base.h"
#include "pair_gran.h"
#include "update.h"

namespace LIGGGHTS {
namespace ContactModels {

/// Parameters: of the table of laws.
template <class Parameters>
class ContactLawsModel : public NormalModelBase {
  using Law = contactlaws::LawOf<Parameters>;
  using Vec = contactlaws::Vec3<double>;

 public:
  ContactLawsModel(LAMMPS* lmp, IContactHistorySetup* history, ContactModelBase* model)
      : NormalModelBase(lmp, history, model),
        is_wall_(model->is_wall()),
        wall_(dynamic_cast<FixWallGran*>(history)),
        pairs_of_grains_(dynamic_cast<PairGran*>(history)) {
    for (const contactlaws::StateValue& value : Law::state_values()) {
      const int at = history->add_history_value(value.name, value.exchange_sign < 0 ? "1" : "0");
      if (offset_ < 0) offset_ = at;
    }
  }
  void registerSettings(Settings&) override {}
  void postSettings(IContactHistorySetup*, ContactModelBase*) override {}
  double stressStrainExponent() override { return 1.5; }
  void beginPass(SurfacesIntersectData&, ForceData&, ForceData&) override {}
  void endPass(SurfacesIntersectData&, ForceData&, ForceData&) override {}

  /// A law and moduli for each pair of types.
  void connectToProperties(PropertyRegistry& registry) override {
    types_ = registry.max_type();
    pairs_.clear();
    try {
      for (int i = 1; i <= types_; ++i)
        for (int j = 1; j <= types_; ++j) pairs_.push_back(pair_of_types(registry, i, j));
    } catch (const std::invalid_argument& out_of_range) {
      error->all(FLERR, out_of_range.what());
    }
    // The range over the sum of radii is largest between the smallest spheres: it is c R^k with k <= 1, and that of a bridge of volume V
    // is R times a function that grows with V/R^3. An open contact is seen within the factor only, and must be seen once for its
    // history to be reset: hence 0.01 more.
    const double smallest = registry.min_radius(), largest = registry.max_radius();
    double factor = 1.01, range_of_largest = 0.0;
    for (const Pair& pair : pairs_) {
      factor = std::max(factor, 1.01 + range_of(pair, smallest) / bodies(pair, smallest, smallest, 1.0).length);
      range_of_largest = std::max(range_of_largest, range_of(pair, largest));
    }
    neighbor->register_contact_dist_factor(factor);
    if (is_wall_) check_skin(range_of_largest);
  }

  void surfacesIntersect(SurfacesIntersectData& s, ForceData& on_i, ForceData& on_j) override {
    const double rest[3] = {0.0, 0.0, 0.0};
    s.Fn = step(s, s.meff, s.omega_i, is_wall_ ? rest : s.omega_j, on_i, on_j).normal_force;
    s.kn = s.kt = s.gamman = s.gammat = 0.0;  // nothing is left for other models
  }
  /// Near, but not touching. LIGGGHTS sets neither masses nor spins of grains here.
  void surfacesClose(SurfacesCloseData& s, ForceData& on_i, ForceData& on_j) override {
    if (s.contact_history == NULL) return;
    const double rest[3] = {0.0, 0.0, 0.0};
    if (step(s, mass_of(s), atom->omega[s.i], is_wall_ ? rest : atom->omega[s.j], on_i, on_j).active)
      s.has_force_update = true;
  }

 private:
  struct Pair {
    Law law;
    contactlaws::EffectiveModuli<double> moduli;
  };

  Pair pair_of_types(PropertyRegistry& registry, int i, int j) const {
    const auto of_type = [&](const char* name, int type) {
      return registry.getGlobalProperty(name, "property/global", "peratomtype", types_, 0, "contactlaws")
          ->compute_vector(type - 1);
    };
    const auto material = [&](int type) {
      return contactlaws::ElasticMaterial<double>{of_type("youngsModulus", type), of_type("poissonsRatio", type), 1.0};
    };
    Parameters parameters;
    contactlaws::visit_parameters(parameters, [&](const char*, const auto& parameter, double& value) {
      value = value_of(registry, parameter.name, value, i, j);
    });
    return {contactlaws::make_law(parameters), contactlaws::given_moduli(material(i), material(j))};
  }

  /// LIGGGHTS's property for a law's parameter, or null.
  static const char* property_of(const std::string& parameter) {
    static constexpr const char* properties[][2] = {{"friction", "coefficientFriction"},
                                                    {"rolling_friction", "coefficientRollingFriction"},
                                                    {"suction", "suction"},
                                                    {"fractal_dimension", "fractalDimension"},
                                                    {"roughness", "roughness"},
                                                    {"stiffness_ratio", "stiffnessRatio"},
                                                    {"work_of_adhesion", "workOfAdhesion"},
                                                    {"surface_tension", "surfaceTension"},
                                                    {"contact_angle", "contactAngle"},
                                                    {"bridge_volume", "bridgeVolume"},
                                                    {"damping_constant", "coefficientRestitution"}};
    for (const auto& [of_law, property] : properties)
      if (parameter == of_law) return property;
    return nullptr;
  }
  /// The value of a law's parameter for two types; its default where LIGGGHTS has no property for it.
  double value_of(PropertyRegistry& registry, const std::string& parameter, double otherwise, int i, int j) const {
    const char* property = property_of(parameter);
    if (property == nullptr) return otherwise;
    const double value =
        registry.getGlobalProperty(property, "property/global", "peratomtypepair", types_, types_, "contactlaws")
            ->compute_array(i - 1, j - 1);
    if constexpr (decltype(Law::damping)::acts)
      if (parameter == "damping_constant") return contactlaws::damping_constant<Law>(value);
    return value;
  }

  contactlaws::PairProperties<double> bodies(const Pair& types, double radius_i, double radius_j, double mass) const {
    return is_wall_ ? plane_sphere_pair(types.moduli, radius_i, mass)
                    : sphere_sphere_pair(types.moduli, radius_i, radius_j, mass);
  }
  double range_of(const Pair& types, double radius) const {
    return types.law.interaction_range(bodies(types, radius, radius, 1.0));
  }

  /// LIGGGHTS sees grains near a wall to a distance of the skin. A tenth of the range more: a bridge of a given volume reaches farther
  /// from smaller grains, by less than that, and its rupture must be seen.
  void check_skin(double range) const {
    if (1.1 * range <= neighbor->skin) return;
    const std::string message = "contactlaws: this law reaches " + std::to_string(range) +
                                " m from a wall, and `neighbor` has a skin of " + std::to_string(neighbor->skin) +
                                " m: make it 1.1 times the range or more";
    error->all(FLERR, message.c_str());
  }

  /// As LIGGGHTS's own loops have it where surfaces intersect.
  double mass_of(const SurfacesCloseData& s) const {
    if (is_wall_)
      return wall_->fix_rigid() != NULL && wall_->body(s.i) >= 0 ? wall_->masstotal(wall_->body(s.i))
                                                                 : atom->rmass[s.i];
    const auto mass = [&](int k) {
      const double of_body = pairs_of_grains_->fr_pair() != NULL ? pairs_of_grains_->mr_pair()[k] : 0.0;
      return of_body > 0.0 ? of_body : atom->rmass[k];
    };
    const int frozen = pairs_of_grains_->freeze_group_bit();
    if ((atom->mask[s.j] & frozen) != 0) return mass(s.i);
    if ((atom->mask[s.i] & frozen) != 0) return mass(s.j);
    return contactlaws::effective_mass(mass(s.i), mass(s.j));
  }

  /// The contact of j (body 1) and i (body 2); a wall j has radius 0. Adds forces and torques.
  contactlaws::Step<double, typename Law::State> step(SurfacesCloseData& s, double mass, const double* spin_i,
                                                      const double* spin_j, ForceData& on_i, ForceData& on_j) const {
    const bool advances = s.computeflag && s.shearupdate;  // not in the set-up pass
    const Pair& types = pairs_[std::size_t((s.itype - 1) * types_ + s.jtype - 1)];
    const auto pair = bodies(types, s.radi, s.radj, mass);
    const double origin[3] = {0.0, 0.0, 0.0};
    const auto contact = contactlaws::sphere_contact(origin, s.v_j, spin_j, is_wall_ ? 0.0 : s.radj, s.delta, s.v_i,
                                                     spin_i, s.radi, advances ? update->dt : 0.0);
    double* const values = s.contact_history + offset_;
    auto state = Law::load(values);
    if constexpr (contactlaws::has_bridge<Law>) Law::make_wet(state, contact.kinematics.overlap, 0.0);
    const auto result = types.law.step(pair, contact.kinematics, state);
    if (advances) Law::store(result.state, values);
    if (s.contact_flags != NULL)  // the host keeps the history of contacts with a flag
      *s.contact_flags =
          result.active ? *s.contact_flags | CONTACT_NORMAL_MODEL : *s.contact_flags & ~CONTACT_NORMAL_MODEL;

    const auto turning = contactlaws::torques(contact, result.force, result.couple);
    add(result.force, turning.on2, s.area_ratio, on_i);
    if (!is_wall_) add(Vec(-result.force), turning.on1, 1.0, on_j);
    return result;
  }
  static void add(const Vec& force, const Vec& torque, double share, ForceData& to) {
    for (int d = 0; d < 3; ++d) {
      to.delta_F[d] += share * force[d];
      to.delta_torque[d] += share * torque[d];
    }
  }

  const bool is_wall_;
  FixWallGran* const wall_;          ///< null for pairs of grains
  PairGran* const pairs_of_grains_;  ///< null for walls
  int offset_ = -1;
  int types_ = 0;
  std::vector<Pair> pairs_;
};

template <>
class NormalModel<CONTACTLAWS_DRY_HILL> : public ContactLawsModel<contactlaws::DryHill<double> > {
 public:
  using ContactLawsModel::ContactLawsModel;
};
template <>
class NormalModel<CONTACTLAWS_DRY_HILL_DISPLACEMENT>
    : public ContactLawsModel<contactlaws::HertzWith<contactlaws::ShearDisplacement> > {
 public:
  using ContactLawsModel::ContactLawsModel;
};
template <>
class NormalModel<CONTACTLAWS_HILL> : public ContactLawsModel<contactlaws::Hill<double> > {
 public:
  using ContactLawsModel::ContactLawsModel;
};
template <>
class NormalModel<CONTACTLAWS_ROUGH_BALLAST> : public ContactLawsModel<contactlaws::RoughBallastProperties<double> > {
 public:
  using ContactLawsModel::ContactLawsModel;
};
template <>
class NormalModel<CONTACTLAWS_COHESIVE_POWDER>
    : public ContactLawsModel<contactlaws::CohesivePowderProperties<double> > {
 public:
  using ContactLawsModel::ContactLawsModel;
};
template <>
class NormalModel<CONTACTLAWS_WET_GRAINS> : public ContactLawsModel<contactlaws::WetGrainsProperties<double> > {
 public:
  using ContactLawsModel::ContactLawsModel;
};

}  // namespace ContactModels
}  // namespace LIGGGHTS

#endif
#endif
