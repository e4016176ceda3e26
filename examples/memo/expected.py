#!/usr/bin/env python3
"""Writes expected.hpp: the expected results of the memo's problems, from closed forms in 40 digits, independent of the library.

    python3 examples/memo/expected.py > examples/memo/expected.hpp

Equation numbers are those of Potyondy (2019), Hill Contact Model, version 4.
"""

from decimal import Decimal as D
from decimal import getcontext

getcontext().prec = 40
PI = D("3.141592653589793238462643383279502884197")


def cube_root(x):
    root = D(float(x) ** (1 / 3))
    for _ in range(6):  # Newton doubles the digits each time
        root -= (root**3 - x) / (3 * root**2)
    return root


# Granite, and the two grains of Figure 9: a 5 mm grain on one of 7.5 mm.
density, young, poisson, friction, suction, alpha = D(2650), D("29e9"), D("0.15"), D("0.4"), D("200e3"), D("0.07")
r1, r2 = D("7.5e-3"), D("5e-3")
m1, m2 = (D(4) / 3 * PI * r**3 * density for r in (r1, r2))

# Table 4.
effective_radius = 1 / (1 / r1 + 1 / r2)
effective_young = 1 / (2 * (1 - poisson**2) / young)
effective_shear = 1 / (4 * (2 - poisson) * (1 + poisson) / young)
effective_mass = 1 / (1 / m1 + 1 / m2)
k_n = D(4) / 3 * effective_young * effective_radius.sqrt()
k_s = 8 * effective_shear * effective_radius.sqrt()
alpha_n = alpha * (effective_mass * k_n).sqrt()
alpha_s = alpha * (effective_mass * k_s).sqrt()

# Stages A and B: overlap o, then the top grain turns by 0.02 rad about its centre; its arm is R - o/2.
o, dt = D("1e-4"), D("1e-6")
arm = r2 - o / 2
shear = D("0.02") * arm  # 99.0 um
k_linear = young * PI * r2**2 / (r1 + r2)  # Eq. 22


def hertz(overlap):
    return k_n * overlap * overlap.sqrt()


# The dashpot problems: one step at 100 m/s down, which doubles the overlap; one step at 1000 rad/s.
doubled = o + 100 * dt
sheared = shear + 1000 * dt * arm

bridge = suction * PI * r2**2  # Eq. 12
rest = cube_root((bridge / k_n) ** 2)  # Hertz's force = the bridge's

unlimited = k_s * o.sqrt() * shear
half = D(2).sqrt() / 2

VALUES = [
    ("linear_normal_force", k_linear * o, "N", "Eq. 22"),
    ("linear_shear_unlimited", k_linear * shear, "N", "Eq. 23, trial"),
    ("linear_shear_force", friction * k_linear * o, "N", "Eq. 23, strength"),
    ("hill_normal_force", hertz(o), "N", "Eq. 24"),
    ("hill_shear_unlimited", unlimited, "N", "Eq. 15"),
    ("hill_shear_force", friction * hertz(o), "N", "Eq. 14"),
    ("dashpot_normal_moving", hertz(doubled) + alpha_n * doubled.sqrt().sqrt() * 100, "N", "Eq. 13"),
    ("dashpot_normal_stopped", hertz(doubled), "N", "Eq. 13"),
    ("dashpot_shear_moving", k_s * o.sqrt() * sheared + alpha_s * o.sqrt().sqrt() * 1000 * arm, "N", "Eq. 17"),
    ("dashpot_shear_stopped", k_s * o.sqrt() * sheared, "N", "Eq. 15"),
    ("crossover_stiffness_overlap", (2 * k_linear / (3 * k_n)) ** 2, "m", "3/2 k_n o^(1/2) = k"),
    ("crossover_force_overlap", (k_linear / k_n) ** 2, "m", "k_n o^(3/2) = k o"),
    ("moisture_rest_overlap", rest, "m", "k_n o^(3/2) = psi pi R_o^2"),
    ("moisture_rupture_gap", 2 * r2, "m", "2 s_cr = 2 R_o, Eq. 12"),
    ("assembly_weight", 27 * D(4) / 3 * PI * r2**3 * density * D("9.81"), "N", "27 4/3 pi R^3 rho g"),
    ("square_root_of_2", D(2).sqrt(), "1", "(2 o)^(1/2) / o^(1/2)"),
    ("shear_half", unlimited / 2, "N", "rescaled displacement at half the overlap"),
    ("shear_root_half", unlimited * half, "N", "unlimited shear, times 2^(-1/2)"),
]

print(
    """// SPDX-License-Identifier: MIT
// The expected results of the memo's problems, in closed form. Written by expected.py: change it there.
#pragma once

#include "common/report.hpp"

namespace memo::expected {
"""
)
for name, value, unit, source in VALUES:
    print(f'constexpr common::Expected {name}{{{value:.17g}, "{unit}", "{source}"}};')
print("\n}  // namespace memo::expected")
