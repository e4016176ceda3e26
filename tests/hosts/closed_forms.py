"""Closed forms and exact solutions that hosts' forces are compared with."""

import math
import re
from pathlib import Path

REFERENCE = Path(__file__).resolve().parents[1] / "reference" / "capillary_bridge.hpp"


def jkr_pull_off_radius(radius, work, modulus):
    """Of the contact where it lets go, h (Johnson, Kendall & Roberts 1971). radius: R*, modulus: E*, work: w."""
    return (math.pi * work * radius**2 / (8 * modulus))**(1 / 3)


def jkr_gap(radius, work, modulus):
    """The gap at which the contact lets go."""
    return 3 * jkr_pull_off_radius(radius, work, modulus)**2 / radius


def jkr(overlap, radius, work, modulus):
    """Contact radius, force and energy of the branch that holds."""
    low, high = jkr_pull_off_radius(radius, work, modulus), radius
    for _ in range(64):  # R* 2^-64
        a = (low + high) / 2
        low, high = (a, high) if a * a / radius - math.sqrt(2 * math.pi * work * a / modulus) < overlap else (low, a)
    q, flat = math.sqrt(2 * math.pi * work * a / modulus), a * a / radius
    force = 4 * modulus * a**3 / (3 * radius) - math.sqrt(8 * math.pi * work * modulus * a**3)
    return a, force, modulus * a * (8 / 15 * flat**2 - 4 / 3 * flat * q + q * q / 2)


def exact_bridges(angle, volume):
    """Of the Young-Laplace equation between equal spheres: (gap, force, energy, rupture gap) in R, gamma R, gamma R^2."""
    rows = (list(map(float, numbers.split(","))) for numbers in re.findall(r"^    \{([^}]*)\},", REFERENCE.read_text(), re.M))
    return [tuple(row[2:]) for row in rows if len(row) == 6 and row[:2] == [angle, volume]]
