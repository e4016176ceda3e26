// SPDX-License-Identifier: GPL-2.0-only
// The pair styles and the walls, offered as LAMMPS's plugins are: those of the table of laws.
#if __has_include(<xsimd/xsimd.hpp>)
#include "contactlaws/scalars/xsimd.hpp"
#endif
#include <deque>

#include "fix_wall_contactlaws.hpp"
#include "lammpsplugin.h"
#include "version.h"

namespace {

using namespace contactlaws;

template <class Parameters>
void* create_pair(void* lammps) {
  return new PairContactLaws<Parameters>(static_cast<LAMMPS_NS::LAMMPS*>(lammps));
}
template <class Parameters>
void* create_wall(void* lammps, int count, char** words) {
  return new FixWallContactLaws<Parameters>(static_cast<LAMMPS_NS::LAMMPS*>(lammps), count, words);
}

}  // namespace

void lammpsplugin_init(void* lammps, void* handle, void* register_style) {
  static std::deque<std::string> names;  // LAMMPS keeps the pointers
  lammpsplugin_t plugin{};
  plugin.version = LAMMPS_VERSION;
  plugin.info = "contact laws of contactlaws";
  plugin.author = "contactlaws";
  plugin.handle = handle;
  const auto offer = [&](const char* style, const std::string& name) {
    plugin.style = style;
    plugin.name = names.emplace_back(name).c_str();
    reinterpret_cast<lammpsplugin_regfunc>(register_style)(&plugin, lammps);
  };
  visit_laws([&](const std::string& name, const auto& parameters) {
    using Parameters = std::decay_t<decltype(parameters)>;
    if constexpr (LawOf<Parameters>::state_size > 0) {  // a pair style keeps a history
      plugin.creator.v1 = create_pair<Parameters>;
      offer("pair", "contactlaws/" + name);
    }
    plugin.creator.v2 = create_wall<Parameters>;
    offer("fix", "wall/contactlaws/" + name);
  });
}
