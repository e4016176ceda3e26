// SPDX-License-Identifier: MIT
// The expected results of the memo's problems, in closed form. Written by expected.py: change it there.
#pragma once

namespace memo::expected {

/// [N] Eq. 22
constexpr double linear_normal_force = 18221.237390820801;
/// [N] Eq. 23, trial
constexpr double linear_shear_unlimited = 18039.025016912593;
/// [N] Eq. 23, strength
constexpr double linear_shear_force = 7288.4949563283203;
/// [N] Eq. 24
constexpr double hill_normal_force = 1083.3046320647787;
/// [N] Eq. 15
constexpr double hill_shear_unlimited = 1478.2716452148831;
/// [N] Eq. 14
constexpr double hill_shear_force = 433.32185282591147;
/// [N] Eq. 13
constexpr double dashpot_normal_moving = 3960.4463463356487;
/// [N] Eq. 13
constexpr double dashpot_normal_stopped = 3064.0482056952113;
/// [N] Eq. 17
constexpr double dashpot_shear_moving = 1595.9911542698659;
/// [N] Eq. 15
constexpr double dashpot_shear_stopped = 1552.1852274756273;
/// [m] 3/2 k_n o^(1/2) = k
constexpr double crossover_stiffness_overlap = 0.012573958253691185;
/// [m] k_n o^(3/2) = k o
constexpr double crossover_force_overlap = 0.028291406070805167;
/// [m] k_n o^(3/2) = psi pi R_o^2
constexpr double moisture_rest_overlap = 0.0000059462913515280103;
/// [m] 2 s_cr = 2 R_o, Eq. 12
constexpr double moisture_rupture_gap = 0.010;
/// [N] 27 4/3 pi R^3 rho g
constexpr double assembly_weight = 0.36751686038571177;
/// [1] (2 o)^(1/2) / o^(1/2)
constexpr double square_root_of_2 = 1.4142135623730950;
/// [N] rescaled displacement at half the overlap
constexpr double shear_half = 739.13582260744156;
/// [N] unlimited shear, times 2^(-1/2)
constexpr double shear_root_half = 1045.2959047672380;

}  // namespace memo::expected
