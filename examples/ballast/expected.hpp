// SPDX-License-Identifier: MIT
// The expected results for the paper's ballast. Written by expected.py: change it there.
#pragma once

#include "common/report.hpp"

namespace ballast::expected {

constexpr common::Expected full_contact_area{6.6890916607436831e-7, "m^2", "Eq. 5"};
constexpr common::Expected transition_force{1776.2439987575723, "N", "Eq. 4"};
constexpr common::Expected transition_stiffness{29531711.100640054, "N/m", "Eq. 3"};
constexpr common::Expected transition_overlap{0.00013270776097012912, "m", "Eq. 1, integrated"};
constexpr common::Expected virgin_force_1um{0.03677605122301564, "N", "Eq. 1, integrated"};
constexpr common::Expected virgin_force_5um{1.2816387401006375, "N", "Eq. 1, integrated"};
constexpr common::Expected virgin_force_10um{5.915006725782897, "N", "Eq. 1, integrated"};
constexpr common::Expected virgin_force_20um{27.298881870026508, "N", "Eq. 1, integrated"};
constexpr common::Expected virgin_force_30um{66.783761772284417, "N", "Eq. 1, integrated"};
constexpr common::Expected plastic_overlap_after_20um{1.442300705371101e-5, "m", "Eq. 6, integrated"};
constexpr common::Expected exponent{0.546771, "1", "0.2567 D_f, Eq. 1"};
constexpr common::Expected shear_ratio{0.85714285714285714, "1", "Eq. 7"};

}  // namespace ballast::expected
