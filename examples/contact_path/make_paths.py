#!/usr/bin/env python3
"""Writes paths/*.csv, the motions, and expected.csv: what the laws must answer, from closed forms, apart from the library.

    python3 examples/contact_path/make_paths.py

Equation numbers are those of Potyondy (2019), Hill Contact Model, version 4, and of Tolomeo & McDowell (2022).
"""

import argparse
import csv
from math import cos, exp, pi, sin, sqrt
from pathlib import Path

argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter).parse_args()
here = Path(__file__).resolve().parent
Z = (0.0, 0.0, 1.0)
DT = 1e-6
expected = []


def times(factor, vector):
    return tuple(factor * component for component in vector)


def plus(a, b):
    return tuple(x + y for x, y in zip(a, b))


def minus(a, b):
    return plus(a, times(-1.0, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


class Motion:
    """A contact's history, row by row; `overlap` is where it stands."""

    def __init__(self, text, *more_columns):
        self.text, self.more_columns, self.rows, self.overlap = text, more_columns, [], 0.0

    def step(self, overlap, normal=Z, sliding=(0.0, 0.0, 0.0), dt=DT, **more):
        """To this overlap; `sliding` is the velocity across the normal."""
        overlap = float(f"{overlap:.12g}")  # 1e-06, not 9.999999999999999e-07
        velocity = plus(times((self.overlap - overlap) / dt, normal), sliding)
        self.row(overlap, normal, velocity, dt, **more)

    def row(self, overlap, normal, velocity, dt, **more):
        cells = [dt, overlap, *normal, *velocity]
        self.rows.append([f"{x:.15g}" for x in cells] + [more.get(name, "") for name in self.more_columns])
        self.overlap = overlap

    def press(self, overlap, steps, **more):
        start = self.overlap
        for i in range(1, steps + 1):
            self.step(start + (overlap - start) * i / steps, **more)

    def shear(self, distance, steps, **more):
        for _ in range(steps):
            self.step(self.overlap, sliding=(-distance / (steps * DT), 0.0, 0.0), **more)

    def write(self, name):
        with open(here / "paths" / name, "w", newline="") as file:
            file.write(f"# {self.text}\n")
            table = csv.writer(file, lineterminator="\n")
            table.writerow(["dt", "overlap", "nx", "ny", "nz", "vx", "vy", "vz", *self.more_columns])
            table.writerows(self.rows)


def expect(law, path, step, column, value, tolerance, why):
    expected.append([law, path, step, column, f"{value:.15g}", tolerance, why])


ROUNDING = "1e-12"  # some ten roundings a step, in increments that add up over some hundred steps

# ---------------------------------------------------------------------------------------------------------------------
# Two granite grains (memo, Figure 9 and Table 4): a 5 mm grain on one of 7.5 mm.
young, poisson, density, mu, alpha, psi = 29e9, 0.15, 2650.0, 0.4, 0.07, 200e3
r1, r2 = 7.5e-3, 5e-3
radius = 1 / (1 / r1 + 1 / r2)
effective_young = young / (2 * (1 - poisson**2))
effective_shear = young / (4 * (2 - poisson) * (1 + poisson))
mass = 1 / sum(1 / (4 / 3 * pi * r**3 * density) for r in (r1, r2))
k_n, k_s = 4 / 3 * effective_young * sqrt(radius), 8 * effective_shear * sqrt(radius)
k_linear = young * pi * r2**2 / (r1 + r2)  # Eq. 22
depth, turn = 1e-4, 0.02
slid = turn * (r2 - depth / 2)  # the arm of the turning grain is R - o/2: 99.0 um

a = Motion("Memo, stage A: the top grain pressed down by 0.1 mm.")
a.press(depth, 100)
a.write("stage_a.csv")
expect("memo_linear", "stage_a", 100, "fn_total", k_linear * depth, ROUNDING, "Eq. 22")
expect("memo_hill", "stage_a", 100, "fn_total", k_n * depth**1.5, ROUNDING, "Eq. 13")
expect("memo_hill", "stage_a", 100, "stored_energy", 0.4 * k_n * depth**2.5, ROUNDING, "2/5 F o")
expect("memo_hill", "stage_a", 100, "active", 1, 0, "touches")
expect("memo_hill", "stage_a", 100, "slip", 0, 0, "nothing slides")

b = Motion("Memo, stages A and B: pressed down by 0.1 mm, then turned by 0.02 rad about its own centre.")
b.press(depth, 100)
b.shear(slid, 100)
b.write("stage_b.csv")
expect("memo_linear", "stage_b", 200, "fx", mu * k_linear * depth, ROUNDING, "Eq. 23 strength")
expect("memo_hill", "stage_b", 129, "fx", k_s * sqrt(depth) * slid * 0.29, ROUNDING, "Eq. 15 before it slides")
expect("memo_hill", "stage_b", 129, "slip", 0, 0, "29 of 29.02 um")
expect("memo_hill", "stage_b", 130, "slip", 1, 0, "30 of 29.02 um")
expect("memo_hill", "stage_b", 200, "fx", mu * k_n * depth**1.5, ROUNDING, "Eq. 14")
expect("memo_hill", "stage_b", 200, "fy", 0, 0, "nothing moves along y")
heat = mu * k_n * depth**1.5 * (slid - mu * k_n * depth / k_s)
expect("memo_hill", "stage_b", 200, "dissipated_energy", heat, "2e-3", "friction; the step in which sliding begins")

d = Motion("Memo, normal dashpot: stage A, then 0.1 mm further in one step of 1e-6 s, then at rest.")
d.press(depth, 100)
d.step(2 * depth)
d.step(2 * depth)
d.write("dashpot_normal.csv")
at_rest = k_n * (2 * depth) ** 1.5
moving = at_rest + alpha * sqrt(mass * k_n) * (2 * depth) ** 0.25 * 100
expect("memo_hill_dashpots", "dashpot_normal", 101, "fn_total", moving, ROUNDING, "Eq. 13")
expect("memo_hill_dashpots", "dashpot_normal", 101, "fn_elastic", at_rest, ROUNDING, "Eq. 13")
expect("memo_hill_dashpots", "dashpot_normal", 102, "fn_total", at_rest, ROUNDING, "Eq. 13")

s = Motion("Memo, shear dashpot: stages A and B, then 1000 rad/s for one step of 1e-6 s, then at rest.")
s.press(depth, 100)
s.shear(slid, 100)
s.shear(1000 * DT * (r2 - depth / 2), 1)
s.step(depth)
s.write("dashpot_shear.csv")
at_rest = k_s * sqrt(depth) * (slid + 1000 * DT * (r2 - depth / 2))
moving = at_rest + alpha * sqrt(mass * k_s) * depth**0.25 * 1000 * (r2 - depth / 2)
expect("memo_hill_dashpots", "dashpot_shear", 201, "fx", moving, ROUNDING, "Eq. 17")
expect("memo_hill_dashpots", "dashpot_shear", 202, "fx", at_rest, ROUNDING, "Eq. 15")

m = Motion("A wet contact pulled apart to a gap of 12 mm, and back; wetted again at 3 mm by a moisture gap of 2.5 mm (too\n"
           "# small), then of 3.5 mm.", "make_wet")
m.press(-5e-3, 50)
m.press(-12e-3, 70)
m.press(-3e-3, 90)
m.step(-3e-3, make_wet="2.5e-3")
m.step(-3e-3, make_wet="3.5e-3")
m.press(0.0, 30)
m.write("bridge.csv")
pull = psi * pi * r2**2  # Eq. 12, and its decay length and rupture gap, 2 R_o
wet = "memo_hill_wet", "bridge"
expect(*wet, 50, "fn_total", -pull * exp(-0.5), ROUNDING, "Eq. 12 at half the rupture gap")
expect(*wet, 99, "moisture", 2, 0, "gap 9.9 mm: wet")
expect(*wet, 101, "moisture", 1, 0, "gap 10.1 mm: ruptured")
expect(*wet, 120, "fn_total", 0, 0, "apart")
expect(*wet, 120, "active", 0, 0, "apart")
expect(*wet, 120, "dissipated_energy", 0, "3e-4", "all its work was stored; half of the step in which it ruptures, pull/e x 0.05 mm")
expect(*wet, 210, "fn_total", 0, 0, "no bridge comes back by itself")
expect(*wet, 211, "moisture", 1, 0, "gap beyond the moisture gap")
expect(*wet, 212, "fn_total", -pull * exp(-0.3), ROUNDING, "Eq. 12")
expect(*wet, 242, "fn_total", -pull, ROUNDING, "Eq. 12 at touch")

# ---------------------------------------------------------------------------------------------------------------------
# The path on which the laws that are called Hertz-Mindlin part.
turns = slid / (r1 + r2 - depth)
for name, factor, text in (
    ("eight_laws.csv", 1.0, "as the arms R - o/2 give it"),
    ("eight_laws_yade.csv", (r1 + r2) / (r1 + r2 - depth), "times (R1 + R2)/distance, as YADE multiplies it"),
):
    e = Motion("Pressed by 0.1 mm; 99.0 um of shear along the arc of constant overlap; back to 0.05 mm; to 0.1 mm again.\n"
               f"# Shear velocity: {text}.")
    e.press(depth, 50)
    for i in range(1, 101):
        angle = turns * i / 100
        normal, tangent = (sin(angle), 0.0, cos(angle)), (cos(angle), 0.0, -sin(angle))
        e.step(depth, normal, times(factor * slid / (100 * DT), tangent))
    e.press(depth / 2, 25, normal=normal)
    e.press(depth, 25, normal=normal)
    e.write(name)

# ---------------------------------------------------------------------------------------------------------------------
# Two grains that turn as one: sheared, then turned by a quarter about y, then by a quarter about their own normal.
t = Motion("Pressed, sheared by 20 um; then the pair turns as one by 90 degrees about y, and by 90 degrees about its normal.",
           "normal_spin")
t.press(depth, 20)
t.shear(20e-6, 20)
for i in range(1, 46):
    t.step(depth, (sin(pi / 2 * i / 45), 0.0, cos(pi / 2 * i / 45)))
for i in range(45):
    t.step(depth, (1.0, 0.0, 0.0), normal_spin=f"{pi / 2 / 45 / DT:.17g}")
t.write("rotating_pair.csv")
force = k_s * sqrt(depth) * 20e-6
expect("rotating_pair", "rotating_pair", 40, "fx", force, ROUNDING, "Eq. 15")
expect("rotating_pair", "rotating_pair", 85, "fz", -force, ROUNDING, "turned by 90 degrees about y")
expect("rotating_pair", "rotating_pair", 130, "fy", force, ROUNDING, "and by 90 degrees about x")
expect("rotating_pair", "rotating_pair", 130, "dissipated_energy", 0, "1e-4", "nothing slides; trapezoids of 5 um, second order")
expect("memo_hill", "rotating_pair", 130, "fz", -force, ROUNDING, "projection does not see the twist")

# ---------------------------------------------------------------------------------------------------------------------
# Rough ballast (Table 1): F = k_n d^(3/2) of an indentation d (contactlaws/normal/pohrt_popov.hpp, derived from Eqs 1-6).
fractal, roughness, ballast_radius, ballast_young = 2.13, 26.1e-6, 2.36e-3, 32e9
beta = 0.2567 * fractal
area = 0.75 * pi**1.5 * ballast_radius * roughness * (20 / (pi**1.5 * fractal)) ** (1 / beta)  # Eq. 5
transition = 4 * ballast_young / (3 * ballast_radius) * (area / pi) ** 1.5  # F_c, Eq. 4
slope = pi / 10 * fractal * ballast_young * sqrt(area) * (roughness * ballast_young * sqrt(area)) ** -beta  # C, Eq. 1
hertz = 4 / 3 * ballast_young * sqrt(ballast_radius)


def virgin(overlap):  # dF/do = C F^beta from F(0) = 0; all overlaps here are below the transition, 132.7 um
    return ((1 - beta) * slope * overlap) ** (1 / (1 - beta))


def unloading(overlap, largest):  # along Hertz's curve
    plastic = largest - (virgin(largest) / hertz) ** (2 / 3)
    return hertz * max(overlap - plastic, 0.0) ** 1.5


um = 1e-6
c = Motion("Rough ballast: loaded to 30 um, pulled apart, reloaded to 40 um, where it cycles by 5 um and is sheared by 6 um.")
c.press(30 * um, 30)
c.press(-5 * um, 35)
c.press(40 * um, 45)
c.press(35 * um, 5)
c.press(40 * um, 5)
c.shear(6 * um, 12)
c.write("ballast_cycles.csv")
ballast = "ballast", "ballast_cycles"
for step in (1, 5, 10, 20, 30):
    expect(*ballast, step, "fn_total", virgin(step * um), ROUNDING, "virgin curve, Eqs 1-5")
expect(*ballast, 35, "fn_total", unloading(25 * um, 30 * um), "1e-11", "unloading, Eq. 6; the indentation cancels")
expect(*ballast, 45, "fn_total", 0, 0, "open above the plastic overlap of 19.88 um")
expect(*ballast, 95, "fn_total", virgin(25 * um), ROUNDING, "fresh surfaces meet after a gap")
expect(*ballast, 110, "fn_total", virgin(40 * um), ROUNDING, "virgin curve again")
expect(*ballast, 115, "fn_total", unloading(35 * um, 40 * um), "1e-11", "unloading, Eq. 6")
expect(*ballast, 120, "fn_total", virgin(40 * um), ROUNDING, "reloaded: no ratcheting")
ratio = 2 * (1 - 0.25) / (2 - 0.25)  # k_s/k_n, Eq. 7
expect(*ballast, 132, "fx", ratio * slope * virgin(40 * um) ** beta * 6 * um, "1e-11", "Eqs 1 and 7; 35.7 N of 88.2 N")
loss = virgin(30 * um) * 30 * um / (1 + 1 / (1 - beta)) - 0.4 * virgin(30 * um) * (virgin(30 * um) / hertz) ** (2 / 3)
expect(*ballast, 65, "dissipated_energy", loss, "5e-3", "area of the loop; trapezoids of 1 um, second order")

# ---------------------------------------------------------------------------------------------------------------------
# The history of an oblique impact: aluminium oxide sphere on an aluminium alloy wall, 3.9 m/s, 10 degrees from the normal,
# where it sticks and slides by turns (Chung & Ooi 2011, test 4, elastic). Leapfrog: velocities stand between the positions, as a row of a path wants them.
sphere_radius, friction, angle, dt = 2.5e-3, 0.092, pi / 18, 1e-7
sphere_mass = 4 / 3 * pi * sphere_radius**3 * 4000
wall_young = 1 / ((1 - 0.23**2) / 380e9 + (1 - 0.33**2) / 70e9)
wall_shear = 1 / (2 * (2 - 0.23) * 1.23 / 380e9 + 2 * (2 - 0.33) * 1.33 / 70e9)
velocity, spin = (3.9 * sin(angle), 0.0, -3.9 * cos(angle)), 0.0  # the spin is about y
shear_force, o = 0.0, 0.0
i = Motion("A sphere of 2.5 mm hits a wall at 3.9 m/s, 10 degrees from the normal: overlap and velocity of its surface.")


def energy():
    return 0.5 * sphere_mass * dot(velocity, velocity) + 0.2 * sphere_mass * sphere_radius**2 * spin**2


start = energy()
while True:
    o -= velocity[2] * dt
    surface = velocity[0] - spin * sphere_radius  # the arm is R here: o/2 is a thousandth of it
    i.row(o, Z, (surface, 0.0, velocity[2]), dt)
    if o < 0:
        break
    normal_force = 4 / 3 * wall_young * sqrt(sphere_radius) * o**1.5
    shear_force -= 8 * wall_shear * sqrt(sphere_radius * o) * surface * dt
    shear_force = max(-friction * normal_force, min(friction * normal_force, shear_force))
    velocity = plus(velocity, (shear_force / sphere_mass * dt, 0.0, normal_force / sphere_mass * dt))
    spin -= shear_force * sphere_radius / (0.4 * sphere_mass * sphere_radius**2) * dt
i.write("oblique_impact.csv")
last = len(i.rows)
same_sum = "1e-10"  # leapfrog's energy and the account's trapezoids are the same sum, of 15-digit velocities
expect("oblique_impact", "oblique_impact", last, "dissipated_energy", start - energy(), same_sum, "kinetic energy lost")
expect("oblique_impact", "oblique_impact", last, "stored_energy", 0, 0, "apart")

with open(here / "expected.csv", "w", newline="") as file:
    file.write("# Written by make_paths.py: change it there. Tolerances are relative.\n")
    table = csv.writer(file, lineterminator="\n")
    table.writerow(["law", "path", "step", "column", "expected", "tolerance", "why"])
    table.writerows(expected)
