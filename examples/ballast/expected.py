#!/usr/bin/env python3
"""Writes expected.hpp: the expected results for the paper's ballast, from its printed stiffnesses, independent of the library.

    /usr/bin/python3 examples/ballast/expected.py > examples/ballast/expected.hpp

Forces at given overlaps: roots of o = integral dF / k(F), by quadrature in 50 digits (tests/reference/pohrt_popov.py).
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tests" / "reference"))
from mpmath import findroot, log, mpf, mp  # noqa: E402
from pohrt_popov import table_1  # noqa: E402

mp.dps = 30
paper = table_1()


def force_at(overlap):
    """Secant method for ln F over ln o, which is nearly linear."""
    miss = lambda ln_force: log(paper.overlap(mp.exp(ln_force)) / overlap)
    return mp.exp(findroot(miss, (mpf(1), mpf(3)), tol=mpf("1e-24"), solver="secant"))


nu = mpf("0.25")
at_20um = force_at(mpf("20e-6"))
VALUES = [
    ("full_contact_area", paper.area, "m^2", "Eq. 5"),
    ("transition_force", paper.transition, "N", "Eq. 4"),
    ("transition_stiffness", paper.hertz(paper.transition), "N/m", "Eq. 3"),
    ("transition_overlap", paper.overlap(paper.transition), "m", "Eq. 1, integrated"),
    *((f"virgin_force_{um}um", force_at(mpf(um) / 10**6), "N", "Eq. 1, integrated") for um in (1, 5, 10, 20, 30)),
    ("plastic_overlap_after_20um", mpf("20e-6") - paper.unloading(at_20um), "m", "Eq. 6, integrated"),
    ("exponent", paper.beta, "1", "0.2567 D_f, Eq. 1"),
    ("shear_ratio", 2 * (1 - nu) / (2 - nu), "1", "Eq. 7"),
]

print(
    """// SPDX-License-Identifier: MIT
// The expected results for the paper's ballast. Written by expected.py: change it there.
#pragma once

#include "common/report.hpp"

namespace ballast::expected {
"""
)
for name, value, unit, source in VALUES:
    print(f'constexpr common::Expected {name}{{{mp.nstr(value, 17)}, "{unit}", "{source}"}};')
print("\n}  // namespace ballast::expected")
