#!/usr/bin/env python3
"""A second oracle: computes the reference tables tests/reference/*.csv anew, from the documents' formulas, in
mpmath at 60 digits. It shares no code with the library or with tables.cpp, which wrote them.

    python3 tests/scoreboard/oracle.py      compares; 1 where it disagrees, 77 without mpmath
"""

import csv
import sys
from pathlib import Path

try:
    from mpmath import acos, acosh, asin, cos, exp, log, mp, mpf, pi, sin, sqrt
except ImportError:
    print("skipped: python3-mpmath is not here")
    sys.exit(77)

mp.dps = 60
TABLES = Path(__file__).resolve().parent.parent / "reference"
PRINTED = mpf("1e-29")  # 30 digits are printed


def pair(young1, poisson1, density1, radius1, young2, poisson2, density2, radius2):
    """Section 2: Table 4 of the memo."""
    mass1, mass2 = (density * 4 * pi / 3 * r**3 for density, r in ((density1, radius1), (density2, radius2)))
    both = ((young1, poisson1), (young2, poisson2))
    return {
        "radius": radius1 * radius2 / (radius1 + radius2),
        "young": 1 / sum((1 - nu**2) / young for young, nu in both),
        "shear": 1 / sum(2 * (2 - nu) * (1 + nu) / young for young, nu in both),
        "mass": mass1 * mass2 / (mass1 + mass2),
    }


def hertz(radius, young, shear, overlap):
    """Sections 2 and 3: k_n o^(3/2), its derivative and integral; k_s o^(1/2)."""
    k_n, k_s = mpf(4) / 3 * young * sqrt(radius), 8 * shear * sqrt(radius)
    return {
        "force": k_n * overlap ** mpf("1.5"),
        "stiffness": mpf("1.5") * k_n * overlap ** mpf("0.5"),
        "contact_radius": (radius * overlap) ** mpf("0.5"),
        "energy": mpf("0.4") * k_n * overlap ** mpf("2.5"),
        "shear_stiffness": k_s * overlap ** mpf("0.5"),
    }


def linear(modulus, min_radius, length, overlap):
    """Section 3: k_n = E pi r^2 / L."""
    stiffness = modulus * pi * min_radius**2 / length
    return {"stiffness": stiffness, "force": stiffness * overlap}


def dashpots(damping_constant, mass, stiffness):
    """Section 3: alpha sqrt(m* k); Eqs 19-21: divide by (sqrt(1 + b^2) - b)^2, b = alpha/2."""
    b = damping_constant / 2
    return {"coefficient": damping_constant * sqrt(mass * stiffness), "stiffening": 1 / (sqrt(1 + b**2) - b) ** 2}


def clipped_ratio(e):
    """Section 6: the damping ratio of a linear spring and dashpot that part when the force ends (Schwager & Poeschel 2007)."""
    if e == 1:
        return mpf(0)

    def decrement(z):
        if z == 1:
            return mpf(2)
        w = sqrt(abs(1 - z * z))
        return 2 * z * (acos(z) if z < 1 else acosh(z)) / w

    low, high = mpf(0), mpf(10) ** 6
    for _ in range(240):
        middle = (low + high) / 2
        low, high = (middle, high) if decrement(middle) < -log(e) else (low, middle)
    return (low + high) / 2


def restitution(restitution):
    """Section 6: alpha = -sqrt(5) ln e / sqrt(ln^2 e + pi^2), or sqrt(5) z of the clipped linear one; linear: 2 z."""
    allowed = -log(restitution) / sqrt(log(restitution) ** 2 + pi**2)
    clipped = clipped_ratio(restitution)
    return {
        "hertz_tension_allowed": sqrt(mpf(5)) * allowed,
        "hertz_tension_clipped": sqrt(mpf(5)) * clipped,
        "linear_tension_allowed": 2 * allowed,
        "linear_tension_clipped": 2 * clipped,
    }


def bridge(suction, decay_length, rupture_gap, min_radius, overlap):
    """Section 3, Eq. 12; the energy is minus the work from here to rupture."""
    largest, decay, gap = suction * pi * min_radius**2, decay_length * min_radius, max(-overlap, mpf(0))
    work = largest * decay * (exp(-gap / decay) - exp(-rupture_gap / decay_length)) + largest * max(overlap, mpf(0))
    return {"force": largest * exp(-gap / decay), "energy": -work}


def pohrt_popov(fractal_dimension, roughness, radius, young, overlap, largest_overlap):
    """Section 5: F = min(F_v(o), k_n max(o - o_p, 0)^(3/2)), and the stiffness of the branch that is active."""
    beta = mpf(2567) / 10000 * fractal_dimension
    area = mpf(3) / 4 * pi ** mpf("1.5") * radius * roughness * (20 / (pi ** mpf("1.5") * fractal_dimension)) ** (1 / beta)
    transition = 4 * young / (3 * radius) * (area / pi) ** mpf("1.5")
    scale = young * sqrt(area)
    c = pi / 10 * fractal_dimension * scale * (1 / (roughness * scale)) ** beta
    k_n = mpf(4) / 3 * young * sqrt(radius)
    o_c = transition ** (1 - beta) / ((1 - beta) * c)
    shift = o_c - (transition / k_n) ** (mpf(2) / 3)

    def virgin(o):
        return ((1 - beta) * c * o) ** (1 / (1 - beta)) if o < o_c else k_n * (o - shift) ** mpf("1.5")

    largest = max(overlap, largest_overlap)
    plastic = largest - (virgin(largest) / k_n) ** (mpf(2) / 3)
    if overlap >= largest_overlap:
        force = virgin(overlap)
        stiffness = c * force**beta if force < transition else (6 * young**2 * force * radius) ** (mpf(1) / 3)
    else:
        force = k_n * max(overlap - plastic, mpf(0)) ** mpf("1.5")
        stiffness = (6 * young**2 * force * radius) ** (mpf(1) / 3)
    return {"transition_overlap": o_c, "force": force, "stiffness": stiffness}


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def turned(v, axis, angle):
    """v turned about a unit axis."""
    c = (axis[1] * v[2] - axis[2] * v[1], axis[2] * v[0] - axis[0] * v[2], axis[0] * v[1] - axis[1] * v[0])
    along = dot(axis, v)
    return [x * cos(angle) + y * sin(angle) + a * along * (1 - cos(angle)) for x, y, a in zip(v, c, axis)]


def rotation_rotate(last_x, last_y, last_z, normal_x, normal_y, normal_z, shear_x, shear_y, shear_z, twist):
    """Section 3: the shear turns with n, about the axis across both normals by the angle between them, then about n."""
    last, normal, shear = (last_x, last_y, last_z), (normal_x, normal_y, normal_z), (shear_x, shear_y, shear_z)
    last, normal = ([x / sqrt(dot(v, v)) for x in v] for v in (last, normal))
    axis = (last[1] * normal[2] - last[2] * normal[1], last[2] * normal[0] - last[0] * normal[2],
            last[0] * normal[1] - last[1] * normal[0])
    sine = sqrt(dot(axis, axis))
    if sine > mpf("1e-30"):
        shear = turned(shear, [x / sine for x in axis], acos(dot(last, normal)) if sine > 0.5 else asin(sine))
    carried = turned(shear, normal, twist)
    return dict(zip(("carried_x", "carried_y", "carried_z"), carried))


# The largest disagreement allowed. Of rotation_rotate, of the whole vector: its normals are unit vectors to double precision only.
ORACLES = {
    "pair": (pair, PRINTED),
    "hertz": (hertz, PRINTED),
    "linear": (linear, PRINTED),
    "dashpots": (dashpots, PRINTED),
    "restitution": (restitution, PRINTED),
    "bridge": (bridge, PRINTED),
    "pohrt_popov_virgin": (pohrt_popov, PRINTED),
    "pohrt_popov_unloading": (pohrt_popov, PRINTED),
    "rotation_rotate": (rotation_rotate, mpf("1e-15")),
}


def disagreement(name, oracle):
    """The largest relative one over the table, and its row."""
    worst, where = mpf(0), ""
    with open(TABLES / f"{name}.csv") as file:
        rows = list(csv.DictReader(file))
    inputs = oracle.__code__.co_varnames[: oracle.__code__.co_argcount]
    for row in rows:
        expected = oracle(**{key: mpf(float(row[key])) for key in inputs})
        if set(expected) | set(inputs) != set(row):
            sys.exit(f"{name}.csv: columns are {', '.join(row)}; expected {', '.join([*inputs, *expected])}")
        size = max(abs(x) for x in expected.values())
        for key, value in expected.items():
            scale = size if name == "rotation_rotate" else abs(value)
            off = abs(mpf(row[key]) - value)
            relative = off / scale if scale > 0 else off
            if relative > worst:
                worst, where = relative, f"{key}, where " + ", ".join(f"{i} = {row[i]}" for i in inputs)
    return worst, where, len(rows)


def main():
    failed = False
    for name, (oracle, allowed) in ORACLES.items():
        worst, where, rows = disagreement(name, oracle)
        verdict = "agrees" if worst <= allowed else "DISAGREES"
        failed |= worst > allowed
        print(f"{name}: {verdict} to {mp.nstr(worst, 3)} over {rows} rows{'; ' + where if worst > allowed else ''}")
    if {file.stem for file in TABLES.glob("*.csv")} != set(ORACLES):
        sys.exit("tests/reference: a table has no oracle, or an oracle no table")
    return int(failed)


if __name__ == "__main__":
    sys.exit(main())
