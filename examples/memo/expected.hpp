// SPDX-License-Identifier: MIT
// The expected results of the memo's problems, in closed form. Written by expected.py: change it there.
#pragma once

#include "common/report.hpp"

namespace memo::expected {

constexpr common::Expected linear_normal_force{18221.237390820801, "N", "Eq. 22"};
constexpr common::Expected linear_shear_unlimited{18039.025016912593, "N", "Eq. 23, trial"};
constexpr common::Expected linear_shear_force{7288.4949563283203, "N", "Eq. 23, strength"};
constexpr common::Expected hill_normal_force{1083.3046320647787, "N", "Eq. 24"};
constexpr common::Expected hill_shear_unlimited{1478.2716452148831, "N", "Eq. 15"};
constexpr common::Expected hill_shear_force{433.32185282591147, "N", "Eq. 14"};
constexpr common::Expected dashpot_normal_moving{3960.4463463356487, "N", "Eq. 13"};
constexpr common::Expected dashpot_normal_stopped{3064.0482056952113, "N", "Eq. 13"};
constexpr common::Expected dashpot_shear_moving{1595.9911542698659, "N", "Eq. 17"};
constexpr common::Expected dashpot_shear_stopped{1552.1852274756273, "N", "Eq. 15"};
constexpr common::Expected crossover_stiffness_overlap{0.012573958253691185, "m", "3/2 k_n o^(1/2) = k"};
constexpr common::Expected crossover_force_overlap{0.028291406070805167, "m", "k_n o^(3/2) = k o"};
constexpr common::Expected moisture_rest_overlap{0.0000059462913515280103, "m", "k_n o^(3/2) = psi pi R_o^2"};
constexpr common::Expected moisture_rupture_gap{0.010, "m", "2 s_cr = 2 R_o, Eq. 12"};
constexpr common::Expected assembly_weight{0.36751686038571177, "N", "27 4/3 pi R^3 rho g"};
constexpr common::Expected square_root_of_2{1.4142135623730950, "1", "(2 o)^(1/2) / o^(1/2)"};
constexpr common::Expected shear_half{739.13582260744156, "N", "rescaled displacement at half the overlap"};
constexpr common::Expected shear_root_half{1045.2959047672380, "N", "unlimited shear, times 2^(-1/2)"};

}  // namespace memo::expected
