// SPDX-License-Identifier: MIT
// TRADE_HERTZ_ALONE: as the tests build it, without the other forms, which take two minutes to compile.
#include "run.hpp"

namespace trade {

template <NormalForm form>
std::unique_ptr<Run> make_run_of(const Composition& composition, const Parameters& parameters, const Scene& scene);

std::unique_ptr<Run> make_run(const Composition& c, const Parameters& p, const Scene& scene) {
  switch (c.normal) {
    case NormalForm::hertz:
      return make_run_of<NormalForm::hertz>(c, p, scene);
#ifndef TRADE_HERTZ_ALONE
    case NormalForm::linear:
      return make_run_of<NormalForm::linear>(c, p, scene);
    case NormalForm::elastic:
      return make_run_of<NormalForm::elastic>(c, p, scene);
    case NormalForm::plastic:
      return make_run_of<NormalForm::plastic>(c, p, scene);
    case NormalForm::incremental:
      return make_run_of<NormalForm::incremental>(c, p, scene);
#endif
    default:
      return nullptr;
  }
}

}  // namespace trade
