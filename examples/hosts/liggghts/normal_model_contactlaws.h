// SPDX-License-Identifier: GPL-2.0-only
// contactlaws as normal models of LIGGGHTS. One model is a whole law, with its shear force: `tangential` stays off.
//
//   pair_style gran model contactlaws/dry_hill                 history: the shear force
//   pair_style gran model contactlaws/dry_hill_displacement    history: a displacement, as of LIGGGHTS's `tangential history`
//   pair_style gran model contactlaws/hill                     dry_hill and a liquid bridge; what touches becomes wet
//   pair_style gran model contactlaws/rough_ballast
//   fix ID all wall/gran model contactlaws/... primitive ... or mesh ...
//
// Parameters are properties of LIGGGHTS, read for the law's parameters by the table in value_of():
//   property/global  youngsModulus, poissonsRatio                  peratomtype
//                    coefficientFriction, coefficientRestitution, suction, fractalDimension, roughness, stiffnessRatio
//                                                                  peratomtypepair
#ifdef NORMAL_MODEL
NORMAL_MODEL(CONTACTLAWS_DRY_HILL, contactlaws / dry_hill, 40)
NORMAL_MODEL(CONTACTLAWS_DRY_HILL_DISPLACEMENT, contactlaws / dry_hill_displacement, 41)
NORMAL_MODEL(CONTACTLAWS_HILL, contactlaws / hill, 42)
NORMAL_MODEL(CONTACTLAWS_ROUGH_BALLAST, contactlaws / rough_ballast, 43)
#else
#ifndef NORMAL_MODEL_CONTACTLAWS_H_
#define NORMAL_MODEL_CONTACTLAWS_H_

#include <stdexcept>
#include <string>
#include <vector>

#include "../laws.hpp"
#include "error.h"
#include "fix_property_global.h"
#include "neighbor.h"
#include "normal_model_base.h"
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
      : NormalModelBase(lmp, history, model), is_wall_(model->is_wall()) {
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
    // An open contact is seen within this factor only, and must be seen once for its history to be reset.
    double factor = 1.01;
    for (const Pair& pair : pairs_) {
      const auto bodies =
          is_wall_ ? plane_sphere_pair(pair.moduli, 1.0, 1.0) : sphere_sphere_pair(pair.moduli, 1.0, 1.0, 1.0);
      factor = std::max(factor, 1.0 + pair.law.interaction_range(bodies) / bodies.length);
    }
    neighbor->register_contact_dist_factor(factor);
  }

  void surfacesIntersect(SurfacesIntersectData& s, ForceData& on_i, ForceData& on_j) override {
    const double rest[3] = {0.0, 0.0, 0.0};
    s.Fn = step(s, s.meff, s.omega_i, is_wall_ ? rest : s.omega_j, on_i, on_j).normal_force;
    s.kn = s.kt = s.gamman = s.gammat = 0.0;  // nothing is left for other models
  }
  /// Near, but not touching. Masses and spins are not set here; an open contact reads neither.
  void surfacesClose(SurfacesCloseData& s, ForceData& on_i, ForceData& on_j) override {
    if (s.contact_history == NULL) return;
    const double rest[3] = {0.0, 0.0, 0.0};
    if (step(s, 1.0, rest, rest, on_i, on_j).active) s.has_force_update = true;
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

  /// The value of a law's parameter for two types; its default where LIGGGHTS has no property for it.
  double value_of(PropertyRegistry& registry, const std::string& parameter, double otherwise, int i, int j) const {
    const auto property = [&](const char* name) {
      return registry.getGlobalProperty(name, "property/global", "peratomtypepair", types_, types_, "contactlaws")
          ->compute_array(i - 1, j - 1);
    };
    using contactlaws::Spring;
    using contactlaws::Tension;
    if (parameter == "friction") return property("coefficientFriction");
    if (parameter == "damping_constant")
      return contactlaws::damping_constant(property("coefficientRestitution"), Spring::hertz, Tension::allowed);
    if (parameter == "suction") return property("suction");
    if (parameter == "fractal_dimension") return property("fractalDimension");
    if (parameter == "roughness") return property("roughness");
    if (parameter == "stiffness_ratio") return property("stiffnessRatio");
    return otherwise;
  }

  /// The contact of j (body 1) and i (body 2); a wall j has radius 0. Adds forces and torques.
  contactlaws::Step<double, typename Law::State> step(SurfacesCloseData& s, double mass, const double* spin_i,
                                                      const double* spin_j, ForceData& on_i, ForceData& on_j) const {
    const bool advances = s.computeflag && s.shearupdate;  // not in the set-up pass
    const Pair& types = pairs_[std::size_t((s.itype - 1) * types_ + s.jtype - 1)];
    const auto pair = is_wall_ ? plane_sphere_pair(types.moduli, s.radi, mass)
                               : sphere_sphere_pair(types.moduli, s.radi, s.radj, mass);
    const double origin[3] = {0.0, 0.0, 0.0};
    const auto contact = contactlaws::sphere_contact(origin, s.v_j, spin_j, is_wall_ ? 0.0 : s.radj, s.delta, s.v_i,
                                                     spin_i, s.radi, advances ? update->dt : 0.0);
    double* const values = s.contact_history + offset_;
    auto state = Law::load(values);
    if constexpr (decltype(Law::bridge)::acts) Law::make_wet(state, contact.kinematics.overlap, 0.0);
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

}  // namespace ContactModels
}  // namespace LIGGGHTS

#endif
#endif
