#!/usr/bin/env python3
"""Writes pohrt_popov.hpp: the rough law as its paper prints it, integrated numerically in 50 digits.

    /usr/bin/python3 tests/reference/pohrt_popov.py > tests/reference/pohrt_popov.hpp

Only Eqs 1, 4, 5 and 6 of Tolomeo & McDowell (2022) are used: stiffnesses k(F) as functions of the force. No closed form of
the force-overlap curve: o = integral dF / k(F), work = integral F dF / k(F), by quadrature.
"""

from mpmath import exp, inf, mp, mpf, pi, quad, sqrt

mp.dps = 50


class Paper:
    """D_f, h [m], R* [m], E* [Pa], as decimal texts."""

    def __init__(self, fractal_dimension, roughness, radius, young):
        self.texts = fractal_dimension, roughness, radius, young
        self.d_f, self.h, self.r, self.e = map(mpf, self.texts)
        self.beta = mpf("0.2567") * self.d_f
        self.area = mpf(3) / 4 * pi ** mpf("1.5") * self.r * self.h * (20 / (pi ** mpf("1.5") * self.d_f)) ** (1 / self.beta)
        self.transition = 4 * self.e / (3 * self.r) * (self.area / pi) ** mpf("1.5")

    def rough(self, force):
        """Eq. 1, first line."""
        scale = self.e * sqrt(self.area)
        return pi / 10 * self.d_f * scale * (force / (self.h * scale)) ** self.beta

    def hertz(self, force):
        """Eq. 1, second line."""
        return (6 * self.e**2 * force * self.r) ** (mpf(1) / 3)

    def integral(self, integrand, stiffness, force):
        """Integral of integrand dF / stiffness from 0 to force, in F = force e^-t: k(0) = 0 is an end that quadrature bears."""
        def along(t):
            f = force * exp(-t)
            return integrand(f) * f / stiffness(f)
        return quad(along, [0, 1, 4, 16, 64, inf])

    def loading(self, integrand, force):
        """The same along virgin loading: Eq. 1."""
        if force <= self.transition:
            return self.integral(integrand, self.rough, force)
        beyond = quad(lambda f: integrand(f) / self.hertz(f), [self.transition, force])
        return self.integral(integrand, self.rough, self.transition) + beyond

    def overlap(self, force):
        return self.loading(lambda f: 1, force)

    def work(self, force):
        return self.loading(lambda f: f, force)

    def unloading(self, force):
        """By how much the overlap falls from `force` to 0: Eq. 6, second line."""
        return self.integral(lambda f: 1, self.hertz, force)

    def unloading_work(self, force):
        return self.integral(lambda f: f, self.hertz, force)


def table_1():
    """Table 1: E* by 1/E* = 2 (1 - nu^2)/E."""
    return Paper("2.13", "26.1e-6", "2.36e-3", "32e9")


SURFACES = [table_1(), Paper("2", "1e-6", "5e-3", "15e9"), Paper("2.5", "1e-5", "1e-3", "7e10"), Paper("3", "5e-7", "0.1", "1e9")]
SHARES = ["1e-12", "1e-6", "1e-3", "0.1", "0.5", "0.999", "1.001", "2", "50"]  # of the transition force


def main():
    print("""// SPDX-License-Identifier: MIT
// The paper's stiffnesses, integrated numerically in 50 digits. Written by pohrt_popov.py: change it there.
#pragma once

namespace contactlaws::test::reference {

/// D_f, h [m], R* [m], E* [Pa]; A_0 [m^2] (Eq. 5), F_c [N] (Eq. 4).
struct Surface {
  const char *fractal_dimension, *roughness, *radius, *young, *area, *transition_force;
};

/// Loaded to `force`, halfway back, and all the way back [N, m, J].
struct Cycle {
  int surface;
  const char *force, *overlap, *work, *overlap_at_half, *plastic_overlap, *loop;
};

// clang-format off""")
    n = lambda x: '"%s"' % mp.nstr(x, 30, min_fixed=0, max_fixed=0)
    print("inline constexpr Surface surfaces[] = {")
    for s in SURFACES:
        print("    {%s, %s, %s}," % (", ".join(f'"{t}"' for t in s.texts), n(s.area), n(s.transition)))
    print("};\n\ninline constexpr Cycle cycles[] = {")
    for i, s in enumerate(SURFACES):
        for share in SHARES:
            force = mpf(mp.nstr(s.transition * mpf(share), 30))
            overlap, work = s.overlap(force), s.work(force)
            half = overlap - s.unloading(force) + s.unloading(force / 2)
            rows = n(force), n(overlap), n(work), n(half), n(overlap - s.unloading(force)), n(work - s.unloading_work(force))
            print(f"    {{{i}, {', '.join(rows)}}},")
    print("};\n// clang-format on\n\n}  // namespace contactlaws::test::reference")


if __name__ == "__main__":
    main()
