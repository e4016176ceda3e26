// SPDX-License-Identifier: GPL-2.0-only
// Laws of contactlaws as sub-models of LAMMPS's package GRANULAR (2023 and later), for pairs and walls:
//
//   pair_style granular
//   pair_coeff I J NORMAL tangential TANGENTIAL damping ...
//   fix        ID GROUP wall/gran granular NORMAL tangential TANGENTIAL damping ... zplane 0 NULL
//
//   NORMAL      contactlaws/hertz E e nu                 e is what LAMMPS's damping reads (coeff_restitution: the restitution)
//               contactlaws/pohrt_popov E e nu D_f h     rough surfaces, with loading history
//   TANGENTIAL  contactlaws/force RATIO xt mu            and force_rescaled, displacement, displacement_rescaled
//               RATIO: of the shear to the normal stiffness; NULL is Mindlin's. xt: of the shear to the normal dashpot.
//
// Our tangential models stand beside our normal models; our normal models beside any others. Copy this file into LAMMPS's
// src/GRANULAR, and build LAMMPS with C++17 and the library's include/ in its path.
//
// Body 1 is LAMMPS's atom j (or the wall), body 2 atom i. The slip velocity of pairs has the arms of the torques, R - overlap/2.
#ifdef GRAN_SUB_MOD_CLASS
// clang-format off
GranSubModStyle(contactlaws/hertz,GranSubModNormalContactLawsHertz,NORMAL);
GranSubModStyle(contactlaws/pohrt_popov,GranSubModNormalContactLawsPohrtPopov,NORMAL);
GranSubModStyle(contactlaws/force,GranSubModTangentialContactLawsForce,TANGENTIAL);
GranSubModStyle(contactlaws/force_rescaled,GranSubModTangentialContactLawsForceRescaled,TANGENTIAL);
GranSubModStyle(contactlaws/displacement,GranSubModTangentialContactLawsDisplacement,TANGENTIAL);
GranSubModStyle(contactlaws/displacement_rescaled,GranSubModTangentialContactLawsDisplacementRescaled,TANGENTIAL);
// clang-format on
#else
#ifndef CONTACTLAWS_GRAN_SUB_MOD_H
#define CONTACTLAWS_GRAN_SUB_MOD_H

#include <algorithm>
#include <stdexcept>
#include <string>

#include "contactlaws/contactlaws.hpp"
#include "error.h"
#include "gran_sub_mod_damping.h"
#include "gran_sub_mod_normal.h"
#include "gran_sub_mod_tangential.h"
#include "granular_model.h"

namespace contactlaws {

using LAMMPS_NS::Granular_NS::GranularModel;

/// History of a sub-model: that of a law with one slot filled.
template <class Law, class SubModel>
void declare_history(SubModel& model) {
  model.size_history = int(Law::state_size);
  model.nondefault_history_transfer = 1;
  model.transfer_history_factor = new double[Law::state_size + 1];  // LAMMPS deletes it
  for (std::size_t k = 0; k < Law::state_size; ++k) model.transfer_history_factor[k] = Law::exchange_sign(k);
}

/// The library's complaint becomes LAMMPS's error.
template <class Action>
void or_fail(LAMMPS_NS::Error* error, const std::string& model, const Action& action) {
  try {
    action();
  } catch (const std::invalid_argument& complaint) {
    error->all(FLERR, "Granular sub-model " + model + ": " + complaint.what());
  }
}

/// A normal sub-model of ours, as our tangential ones see it.
class SubModNormal : public LAMMPS_NS::Granular_NS::GranSubModNormal {
 public:
  using GranSubModNormal::GranSubModNormal;
  PairProperties<double> pair{};  ///< of the contact that is computed
  NormalResponse<double> response{};
};

inline Hertz<double> normal_law(const Hertz<double>*, const double*) { return {}; }
inline PohrtPopovElastoPlastic<double> normal_law(const PohrtPopovElastoPlastic<double>*, const double* surface) {
  return PohrtPopovElastoPlastic<double>::of({surface[0], surface[1]});
}

/// E, e, nu, then `surface` coefficients of the law.
template <class Normal, int surface>
class SubModNormalOf : public SubModNormal {
  using History = ContactLaw<Normal>;

 public:
  SubModNormalOf(GranularModel* model, LAMMPS_NS::LAMMPS* lammps) : SubModNormal(model, lammps) {
    num_coeffs = 3 + surface;
    material_properties = 1;
    declare_history<History>(*this);
  }
  void coeffs_to_local() override {
    Emod = coeffs[0];
    damp = coeffs[1];
    poiss = coeffs[2];
    or_fail(error, name, [this] {
      require_in(Range::not_negative(), damp, "damping", "its coefficient e", "1");
      if (!mixed_) moduli_ = effective_moduli(material(coeffs), material(coeffs));
      law_ = normal_law(&law_, coeffs + 3);
    });
  }
  void mix_coeffs(double* a, double* b) override {
    or_fail(error, name, [&] { moduli_ = effective_moduli(material(a), material(b)); });
    mixed_ = true;
    for (int k = 0; k < num_coeffs; ++k) coeffs[k] = k == 2 ? mix_mean(a[k], b[k]) : mix_geom(a[k], b[k]);
    coeffs_to_local();
  }
  double calculate_forces() override {
    const bool wall = gm->contact_type != LAMMPS_NS::Granular_NS::PAIR;
    pair = {gm->Reff,  moduli_.young, moduli_.shear, gm->meff, wall ? gm->radi : std::min(gm->radi, gm->radj),
            gm->radsum};
    double* const history = gm->history + history_index;
    typename History::State state = History::load(history);
    response = law_.respond(state, pair, gm->delta);
    if (gm->history_update != 0) History::store(state, history);
    return response.force;
  }

 private:
  static ElasticMaterial<double> material(const double* c) { return {c[0], c[2], 1.0}; }

  Normal law_;
  EffectiveModuli<double> moduli_{};
  bool mixed_ = false;  ///< of two types, whose moduli are not functions of mean coefficients
};

template <class Shear>
class SubModTangentialOf : public LAMMPS_NS::Granular_NS::GranSubModTangential {
  using History = ContactLaw<Hertz<double>, NoDashpots<double>, Shear>;
  static constexpr double mindlin = -1.0;  ///< how LAMMPS passes NULL

 public:
  SubModTangentialOf(GranularModel* model, LAMMPS_NS::LAMMPS* lammps) : GranSubModTangential(model, lammps) {
    num_coeffs = 3;
    declare_history<History>(*this);
  }
  void coeffs_to_local() override {
    law_.ratio = coeffs[0] == mindlin ? 1.0 : coeffs[0];
    law_.friction = mu = coeffs[2];
    or_fail(error, name, [this] {
      checked(law_);
      require_in(Range::not_negative(), coeffs[1], "damping", "xt", "1");
    });
  }
  void mix_coeffs(double* a, double* b) override {
    coeffs[0] = a[0] == mindlin || b[0] == mindlin ? mindlin : mix_geom(a[0], b[0]);
    coeffs[1] = mix_geom(a[1], b[1]);
    coeffs[2] = mix_geom(a[2], b[2]);
    coeffs_to_local();
  }
  void init() override {
    normal_ = dynamic_cast<const SubModNormal*>(gm->normal_model);
    if (normal_ == nullptr) error->all(FLERR, "Granular sub-model " + name + " needs a normal model contactlaws/...");
  }
  void calculate_forces() override {
    if (coeffs[0] == mindlin) law_.ratio = mindlin_ratio(normal_->pair);
    k = law_.stiffness(normal_->pair, normal_->response);
    damp = coeffs[1] * gm->damping_model->get_damp_prefactor();
    const Vec3<double> normal(gm->nx[0], gm->nx[1], gm->nx[2]);
    Vec3<double> slip(gm->vtr[0], gm->vtr[1], gm->vtr[2]);
    if (gm->contact_type == LAMMPS_NS::Granular_NS::PAIR) {  // LAMMPS's vtr has arms R, its torques R - overlap/2
      const double *wi = gm->omegai, *wj = gm->omegaj;
      const Vec3<double> spins(wi[0] + wj[0], wi[1] + wj[1], wi[2] + wj[2]);
      slip = slip + spins.cross(normal) * (gm->delta / 2);
    }
    const double dt = gm->history_update != 0 ? gm->dt : 0.0;
    const ContactKinematics<double> kinematics{normal, gm->delta, slip, dt};
    double* const history = gm->history + history_index;
    typename History::State state = History::load(history);
    const ShearResponse<double> sheared =
        law_.template respond<true>(state, {kinematics, slip, k, damp, positive_part<double>(gm->Fntot), false});
    if (gm->history_update != 0) History::store(state, history);
    for (int d = 0; d < 3; ++d) gm->fs[d] = sheared.force[d];
  }

 private:
  Shear law_;
  const SubModNormal* normal_ = nullptr;
};

}  // namespace contactlaws

namespace LAMMPS_NS::Granular_NS {

template <template <class, class...> class Shear>
using GranSubModTangentialContactLaws =
    contactlaws::SubModTangentialOf<Shear<double, contactlaws::ConstantRatio<double> > >;

using GranSubModNormalContactLawsHertz = contactlaws::SubModNormalOf<contactlaws::Hertz<double>, 0>;
using GranSubModNormalContactLawsPohrtPopov =
    contactlaws::SubModNormalOf<contactlaws::PohrtPopovElastoPlastic<double>, 2>;
using GranSubModTangentialContactLawsForce = GranSubModTangentialContactLaws<contactlaws::ShearForce>;
using GranSubModTangentialContactLawsForceRescaled = GranSubModTangentialContactLaws<contactlaws::ShearForceRescaled>;
using GranSubModTangentialContactLawsDisplacement = GranSubModTangentialContactLaws<contactlaws::ShearDisplacement>;
using GranSubModTangentialContactLawsDisplacementRescaled =
    GranSubModTangentialContactLaws<contactlaws::ShearDisplacementRescaled>;

}  // namespace LAMMPS_NS::Granular_NS

#endif
#endif
