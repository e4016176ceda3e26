#!/usr/bin/env python3
"""The force of a liquid bridge as polynomials, and the values that they are tested against.

    /usr/bin/python3 tests/reference/capillary_bridge.py --check    # the solver against closed forms and published formulas
    /usr/bin/python3 tests/reference/capillary_bridge.py --fit > include/contactlaws/bridge/young_laplace_table.hpp
    /usr/bin/python3 tests/reference/capillary_bridge.py --values > tests/reference/capillary_bridge.hpp

The polynomials stand in the variables in which the exact solution is smooth. With lengths in R and forces in 2 pi R gamma:

    q = V^(1/6), x = h / sqrt(2 V/pi), e = sqrt(x^2 + 1) - x: 1 at touch, e_r at rupture
    F = (1 - x/sqrt(x^2 + 1)) P(q, y, angle),  y = sqrt((e - e_r)/(1 - e_r)),  e_r = q E(q, angle)

The factor of P is the limit of small volumes; y takes up the square root of the force at rupture. Least squares, weighted
towards the smallest largest error, in Chebyshev's polynomials; written as powers.
"""

import sys

import numpy as np
from numpy.polynomial import chebyshev
from young_laplace import Bridges, force, newton, residuals, surface_energy

LOWEST, HIGHEST, WIDEST = 1e-5, 1e-1, np.pi / 3  # V/R^3, V/R^3, contact angle
Q_LOW, Q_HIGH = LOWEST ** (1 / 6), HIGHEST ** (1 / 6)
FORCE_DEGREES = 3, 9, 4  # in q, y, angle
RUPTURE_DEGREES = 5, 10  # in q, angle
BEND = 0.1  # the rupture gap turns from flat to straight near this angle


def chebyshev_points(low, high, count):
    inner = (low + high) / 2 + (high - low) / 2 * np.cos(np.pi * (np.arange(count) + 0.5) / count)
    return np.concatenate([[low], inner[::-1], [high]])


def scaled_q(q):
    return (2 * q - Q_LOW - Q_HIGH) / (Q_HIGH - Q_LOW)


def scaled_angle(angle):
    return 2 * angle / WIDEST - 1


def bent_angle(angle):
    return 2 * np.log(1 + angle / BEND) / np.log(1 + WIDEST / BEND) - 1


def opening(gap, q):
    """e, and the limit of small volumes."""
    x = gap / (np.sqrt(2 / np.pi) * q**3)
    root = np.sqrt(x * x + 1)
    return 1 / (root + x), 1 / (root * (root + x))


def columns(degrees, variables):
    """The products of Chebyshev's polynomials, one a column."""
    product = np.ones((variables[0].size, 1))
    for degree, x in zip(degrees, variables):
        product = (product[:, :, None] * chebyshev.chebvander(x, degree)[:, None, :]).reshape(x.size, -1)
    return product


def samples(bridges):
    """q, angle, y, limit, P and the largest force, along the stable branch of each bridge; e_r of each."""
    q = bridges.volume ** (1 / 6)
    at_rupture = opening(bridges.rupture_gap, q)[0]
    rows = []
    for i in range(q.size):
        count = bridges.first[i]
        path = np.concatenate([bridges.path[:count, :, i].T, bridges.rupture[:, i : i + 1]], axis=1)
        gap = residuals(path, np.full(path.shape[1], bridges.angle[i]))[2]
        gap[0], gap[-1] = 0.0, bridges.rupture_gap[i]
        e, limit = opening(gap, q[i])
        pull = force(path)
        y = np.sqrt(np.maximum(e - at_rupture[i], 0.0) / (1 - at_rupture[i]))
        rows.append([np.full(gap.size, q[i]), np.full(gap.size, bridges.angle[i]), y, limit, pull / limit,
                     np.full(gap.size, pull.max())])
    return np.concatenate(rows, axis=1), at_rupture


def grid(q, angle):
    q, angle = np.meshgrid(q, angle, indexing="ij")
    return Bridges(angle, q**6)


def powers(coefficients):
    """Chebyshev's coefficients as those of powers, along each axis."""
    for axis in range(coefficients.ndim):
        coefficients = np.apply_along_axis(
            lambda c: np.pad(chebyshev.cheb2poly(c), (0, c.size))[: c.size], axis, coefficients)
    return coefficients


def fit():
    (q, angle, y, limit, wanted, largest), _ = samples(grid(chebyshev_points(Q_LOW, Q_HIGH, 12), chebyshev_points(0, WIDEST, 8)))
    table = columns(FORCE_DEGREES, (scaled_q(q), 2 * y - 1, scaled_angle(angle)))
    weight = limit**0.7 / largest
    for _ in range(7):  # weights move to where the error is large
        c = np.linalg.lstsq(table * weight[:, None], wanted * weight, rcond=None)[0]
        error = np.abs((table @ c - wanted) * limit / largest)
        weight = weight * np.sqrt(0.3 + error / error.max())
    bridges = grid(chebyshev_points(Q_LOW, Q_HIGH, 8), WIDEST * chebyshev_points(0, 1, 18) ** 2)
    q = bridges.volume ** (1 / 6)
    at_rupture = opening(bridges.rupture_gap, q)[0] / q
    table = columns(RUPTURE_DEGREES, (scaled_q(q), bent_angle(bridges.angle)))
    e = np.linalg.lstsq(table / at_rupture[:, None], np.ones_like(q), rcond=None)[0]
    return c, e


def largest_errors(c, e, bridges):
    """Of the force, in the largest force of each bridge; of e_r, relative."""
    (q, angle, y, limit, wanted, largest), at_rupture = samples(bridges)
    found = columns(FORCE_DEGREES, (scaled_q(q), 2 * y - 1, scaled_angle(angle))) @ c
    q = bridges.volume ** (1 / 6)
    rupture = columns(RUPTURE_DEGREES, (scaled_q(q), bent_angle(bridges.angle))) @ e * q
    return np.abs((found - wanted) * limit / largest).max(), np.abs(rupture / at_rupture - 1).max()


def array(name, values, comment):
    flat = values.ravel()
    lines = [f"  // {comment}", f"  constexpr double {name}[] = {{"]
    for i in range(0, flat.size, 5):
        lines.append("      " + ", ".join(f"{v:.16e}" for v in flat[i : i + 5]) + ("," if i + 5 < flat.size else "};"))
    return "\n".join(lines)


def write_table():
    c, e = fit()
    random = np.random.default_rng(20240611)
    elsewhere = Bridges(random.uniform(0, WIDEST, 100), 10 ** random.uniform(np.log10(LOWEST), np.log10(HIGHEST), 100))
    of_force, of_rupture = largest_errors(c, e, elsewhere)
    print(f"largest error: force {of_force:.2e} of the largest, e_r {of_rupture:.2e}", file=sys.stderr)
    of_q, of_y, of_angle = FORCE_DEGREES
    shape = powers(c.reshape(of_q + 1, of_y + 1, of_angle + 1)).transpose(2, 1, 0)  # angle, y, q
    rupture = powers(e.reshape(RUPTURE_DEGREES[0] + 1, RUPTURE_DEGREES[1] + 1)).T  # angle, q
    print(f"""// SPDX-License-Identifier: MIT
// The Young-Laplace force of a liquid bridge as polynomials. Written by tests/reference/capillary_bridge.py: change it there.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "contactlaws/core/scalar.hpp"

namespace contactlaws::detail {{

/// The polynomials of one contact angle, in powers of their scaled variables.
template <class T>
struct YoungLaplacePolynomials {{
  static constexpr std::size_t force_terms = {of_y + 1}, volume_terms = {of_q + 1}, rupture_terms = {RUPTURE_DEGREES[0] + 1};
  static constexpr double lowest = {Q_LOW:.17g}, highest = {Q_HIGH:.17g};  ///< of q = (V/R^3)^(1/6)

  std::array<std::array<T, volume_terms>, force_terms> force;  ///< P, by powers of 2 y - 1, then of the scaled q
  std::array<T, volume_terms> touch;                           ///< P at touch, where y = 1, by powers of the scaled q
  std::array<T, rupture_terms> rupture;                        ///< e_r/q, by powers of the scaled q

  /// For this contact angle [rad].
  CONTACTLAWS_HD void prepare(const T& angle) noexcept;
}};

// clang-format off
template <class T>
CONTACTLAWS_HD void YoungLaplacePolynomials<T>::prepare(const T& angle) noexcept {{
  using std::log;
{array("forces", shape, f"P, by powers of 2 angle/(pi/3) - 1 ({of_angle + 1}), of 2 y - 1 ({of_y + 1}), of the scaled q ({of_q + 1})")}
{array("ruptures", rupture, f"e_r/q, by powers of the angle's logarithm ({RUPTURE_DEGREES[1] + 1}), of the scaled q ({RUPTURE_DEGREES[0] + 1})")}
  const T straight = angle * scalar_cast<T>({2 / WIDEST:.17g}) - T(1);
  const T bent = T(log(T(angle * scalar_cast<T>({1 / BEND:.17g}) + T(1)))) * scalar_cast<T>({2 / np.log(1 + WIDEST / BEND):.17g}) - T(1);
  for (std::size_t j = 0; j < force_terms; ++j)
    for (std::size_t i = 0; i < volume_terms; ++i) {{
      T sum = T(0);
      for (std::size_t k = {of_angle + 1}; k-- > 0;) sum = sum * straight + scalar_cast<T>(forces[(k * force_terms + j) * volume_terms + i]);
      force[j][i] = sum;
      touch[i] = j == 0 ? sum : T(touch[i] + sum);
    }}
  for (std::size_t i = 0; i < rupture_terms; ++i) {{
    T sum = T(0);
    for (std::size_t k = {RUPTURE_DEGREES[1] + 1}; k-- > 0;) sum = sum * bent + scalar_cast<T>(ruptures[k * rupture_terms + i]);
    rupture[i] = sum;
  }}
}}
// clang-format on

}}  // namespace contactlaws::detail""")


def write_values():
    angle, volume = np.meshgrid(np.radians([0, 5, 20, 40, 60]), 10.0 ** np.arange(-5, -0.9, 0.5), indexing="ij")
    bridges = Bridges(angle, volume)
    at_rupture = surface_energy(bridges.rupture, bridges.angle)
    print("""// SPDX-License-Identifier: MIT
// Liquid bridges between equal spheres by the Young-Laplace equation, solved to 1e-11. Written by capillary_bridge.py: change it there.
#pragma once

namespace contactlaws::test::reference {

/// In R, gamma R, gamma R^2. `energy` is the surface energy less that at rupture.
struct Bridge {
  double angle, volume, gap, force, energy, rupture_gap;
};

// clang-format off
inline constexpr Bridge bridges[] = {""")
    for fraction in (0, 0.01, 0.03, 0.1, 0.2, 0.4, 0.6, 0.8, 0.9, 0.97, 0.999, 1):
        x = bridges.at(fraction * bridges.rupture_gap)
        pull, energy = 2 * np.pi * force(x), 2 * np.pi * (surface_energy(x, bridges.angle) - at_rupture)
        for i in range(bridges.volume.size):
            row = bridges.angle[i], bridges.volume[i], fraction * bridges.rupture_gap[i], pull[i], energy[i], bridges.rupture_gap[i]
            print("    {" + ", ".join(f"{v:.12g}" for v in row) + "},")
    print("""};
// clang-format on

}  // namespace contactlaws::test::reference""")


def check():
    """The solver against what is known in closed form."""

    def says(what, found, limit):
        print(f"{'ok ' if found <= limit else 'BAD'} {what}: {found:.1e} (at most {limit:.0e})")
        return found <= limit

    good = True
    angle, volume = np.meshgrid(np.radians([0, 20, 40, 60]), [1e-5, 1e-3, 1e-1], indexing="ij")
    bridges = Bridges(angle, volume)
    # The force is the derivative of the surface energy at fixed volume: central differences of sixth order.
    step = 1e-3 * bridges.rupture_gap
    energies = [surface_energy(bridges.at(0.3 * bridges.rupture_gap + k * step), bridges.angle) for k in (-3, -2, -1, 1, 2, 3)]
    slope = sum(w * u for w, u in zip((-1, 9, -45, 45, -9, 1), energies)) / (60 * step)
    good &= says("force = d(surface energy)/d(gap)", np.abs(slope / force(bridges.at(0.3 * bridges.rupture_gap)) - 1).max(), 1e-8)
    # A catenoid, p = 0: r = r0 cosh(z/r0), volume pi r0^2 (z + r0 sinh(2 z/r0)/2)/2 of each half.
    r0, length = np.array([0.2]), np.array([0.3])
    height = r0 * np.arcsinh(length / r0)
    rim = np.sqrt(r0**2 + length**2)
    cap = 1 - np.sqrt(1 - rim**2)
    exact = np.pi * r0**2 * (height + r0 * np.sinh(2 * height / r0) / 2) / 2 - np.pi * cap**2 * (3 - cap) / 3
    _, volume, gap = residuals(np.array([r0, 0 * r0, length]), 0.0)
    good &= says("catenoid: volume and gap", max(abs(volume / (2 * exact) - 1)[0], abs(gap - 2 * (height - cap))[0]), 1e-13)
    # Small volumes: F = 2 pi R gamma cos(angle) at touch, and 1 - x/sqrt(x^2 + 1) times it beyond (Rabinovich 2005, Eqs 19-20).
    off = []
    for v in (1e-6, 1e-8):
        small = Bridges(np.radians([0, 30, 60]), v)
        off.append(np.abs(small.touch_force / np.cos(small.angle) - 1).max())
        beyond = force(small.at(np.sqrt(v))) / np.cos(small.angle) / opening(np.sqrt(v), v ** (1 / 6))[1]
        off[-1] = max(off[-1], np.abs(beyond - 1).max())
    good &= says("limit of small volumes, V = 1e-8", off[1], 0.04)
    good &= says("it is approached as V^(1/4)", abs(np.log(off[0] / off[1]) / np.log(100) / 0.25 - 1), 0.2)
    # Rupture: (1 + angle/2) V^(1/3) (Lian, Thornton & Adams 1993), fitted to 0 to 40 degrees.
    low = bridges.angle < 0.7
    lian = (1 + bridges.angle / 2) * bridges.volume ** (1 / 3)
    good &= says("rupture gap against Lian's fit", np.abs(bridges.rupture_gap / lian - 1)[low].max(), 0.08)
    # Convergence: the same bridge with the contact angle, volume and gap met to rounding.
    x, error = newton(bridges.at(0.5 * bridges.rupture_gap), bridges.angle, bridges.volume, 2, 0.5 * bridges.rupture_gap)
    good &= says("residuals", error.max(), 1e-12)
    return 0 if good else 1


if __name__ == "__main__":
    if sys.argv[1:] == ["--check"]:
        sys.exit(check())
    elif sys.argv[1:] == ["--fit"]:
        write_table()
    elif sys.argv[1:] == ["--values"]:
        write_values()
    else:
        sys.exit(__doc__)
