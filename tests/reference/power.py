#!/usr/bin/env python3
"""The polynomials of include/contactlaws/core/power.hpp: checks that they are as close as their header says, in 60 digits;
with --print, interpolates them anew at Chebyshev's points.

    P(z) = log2((1 + s)/(1 - s)) / s,  z = s^2 <= ((sqrt(2) - 1)/(sqrt(2) + 1))^2        Q(f) = 2^f,  |f| <= 1/2
"""

import re
import sys
from decimal import Decimal as D
from decimal import getcontext
from pathlib import Path

getcontext().prec = 60
HEADER = Path(__file__).resolve().parent.parent.parent / "include" / "contactlaws" / "core" / "power.hpp"
PI = D("3.14159265358979323846264338327950288419716939937510582097494")
LN2 = D(2).ln()


def logarithm(z):
    s = z.sqrt()
    return ((1 + s) / (1 - s)).ln() / (s * LN2) if s else 2 / LN2


def exponential(f):
    return (f * LN2).exp()


EDGE = ((D(2).sqrt() - 1) / (D(2).sqrt() + 1)) ** 2
SERIES = {"logarithm": (logarithm, D(0), EDGE), "exponential": (exponential, D("-0.5"), D("0.5"))}
BOUND = {"double": D("4e-16"), "float": D("3e-9")}


def cosine(x):
    term = total = D(1)
    k = 0
    while abs(term) > D("1e-58"):
        k += 2
        term *= -x * x / (k * (k - 1))
        total += term
    return total


def interpolate(function, low, high, count):
    """Coefficients of the polynomial through `count` Chebyshev points, by divided differences."""
    at = [(low + high) / 2 + (high - low) / 2 * cosine(PI * (2 * i + 1) / (2 * count)) for i in range(count)]
    difference = [function(x) for x in at]
    for j in range(1, count):
        for i in range(count - 1, j - 1, -1):
            difference[i] = (difference[i] - difference[i - 1]) / (at[i] - at[i - j])
    result = [D(0)] * count
    for i in range(count - 1, -1, -1):
        result = [difference[i] - at[i] * result[0]] + [result[k - 1] - at[i] * result[k] for k in range(1, count)]
    return result


def largest_error(coefficients, function, low, high):
    worst = D(0)
    for i in range(401):
        x = low + (high - low) * i / 400
        value = D(0)
        for c in reversed(coefficients):
            value = value * x + c
        worst = max(worst, abs(value / function(x) - 1))
    return worst


def in_header():
    """(precision, series, coefficients) as the header has them."""
    for precision, text in re.findall(r"struct PowerCoefficients<(\w+)> \{(.*?)\n\};", HEADER.read_text(), re.DOTALL):
        for series, numbers in re.findall(r"(\w+)\(\) noexcept \{\s*return \{(.*?)\};", text, re.DOTALL):
            yield precision, series, [float(n) for n in re.findall(r"T\(([-+.e\d]+)F?\)", numbers)]


failed = False
found = list(in_header())
for precision, series, coefficients in found:
    function, low, high = SERIES[series]
    if "--print" in sys.argv:
        print(precision, series, *map(float, interpolate(function, low, high, len(coefficients))))
        continue
    error = largest_error([D(c) for c in coefficients], function, low, high)
    failed |= error > BOUND[precision]
    print(f"{precision} {series}: {len(coefficients)} terms, off by {error:.2g} at most")
sys.exit(failed or len(found) != 4)
