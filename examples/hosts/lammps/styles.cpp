// SPDX-License-Identifier: GPL-2.0-only
// The pair styles, offered as LAMMPS's plugins are: one line a law.
#if __has_include(<xsimd/xsimd.hpp>)
#include "contactlaws/scalars/xsimd.hpp"
#endif
#include "lammpsplugin.h"
#include "pair_contactlaws.hpp"
#include "version.h"

namespace {

using namespace contactlaws;

template <template <class, class...> class Shear>
using HertzWith = ContactLaw<Hertz<double>, Dashpots<double>, Shear<double>>;

template <class Parameters>
void* create(void* lammps) {
  return new PairContactLaws<Parameters>(static_cast<LAMMPS_NS::LAMMPS*>(lammps));
}

struct Style {
  const char* name;
  void* (*create)(void*);
};
const Style styles[] = {
    {"contactlaws/dry_hill", create<DryHill<double>>},
    {"contactlaws/dry_hill/rescaled", create<HertzWith<ShearForceRescaled>>},
    {"contactlaws/dry_hill/displacement", create<HertzWith<ShearDisplacement>>},
    {"contactlaws/dry_hill/displacement_rescaled", create<HertzWith<ShearDisplacementRescaled>>},
    {"contactlaws/hill", create<Hill<double>>},
    {"contactlaws/rough_ballast", create<RoughBallastProperties<double>>},
};

}  // namespace

void lammpsplugin_init(void* lammps, void* handle, void* register_style) {
  lammpsplugin_t plugin{};
  plugin.version = LAMMPS_VERSION;
  plugin.style = "pair";
  plugin.info = "contact laws of contactlaws";
  plugin.author = "contactlaws";
  plugin.handle = handle;
  for (const Style& style : styles) {
    plugin.name = style.name;
    plugin.creator.v1 = style.create;
    reinterpret_cast<lammpsplugin_regfunc>(register_style)(&plugin, lammps);
  }
}
