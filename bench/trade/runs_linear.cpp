// SPDX-License-Identifier: MIT
#include "runs.hpp"

template std::unique_ptr<trade::Run> trade::make_run_of<trade::NormalForm::linear>(const Composition&,
                                                                                   const Parameters&, const Scene&);
