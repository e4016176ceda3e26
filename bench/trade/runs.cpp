// SPDX-License-Identifier: MIT
// TRADE_ONLY: the one normal law that the tests build, as the others take minutes to compile.
#include "run.hpp"

namespace trade {

template <std::size_t index>
std::unique_ptr<Run> make_run_of(const Composition& composition, const Trajectories& trajectories);

namespace {

template <std::size_t index = 0>
std::unique_ptr<Run> make_run_from(const Composition& c, const Trajectories& t) {
  using Laws = std::decay_t<decltype(contact_path::normal_laws())>;
  if constexpr (index < std::tuple_size_v<Laws>) {
    if (std::get<index>(contact_path::normal_laws()).keys.name != c.law.normal.law)
      return make_run_from<index + 1>(c, t);
#ifdef TRADE_ONLY
    if constexpr (index == TRADE_ONLY)
#endif
      return make_run_of<index>(c, t);
  }
  return nullptr;
}

}  // namespace

std::unique_ptr<Run> make_run(const Composition& c, const Trajectories& t) { return make_run_from(c, t); }

}  // namespace trade
