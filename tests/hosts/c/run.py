#!/usr/bin/env python3
"""The C face (examples/hosts/c) from outside, in Python, C and Fortran: forces against closed forms, and what a host may do wrong.

    run.py [LIBRARY] [unittest options]        LIBRARY: libcontactlaws.so; without it, it is built here with g++

Exit status 77 if there is neither LIBRARY nor what it is built with. Fortran and C are skipped without a compiler.
"""

import ctypes
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
import threading
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
FACE = ROOT / "examples" / "hosts" / "c"
LAWS = ROOT / "examples" / "contact_path" / "laws"
EIGEN = next((path for path in ("/usr/include/eigen3", "/usr/local/include/eigen3") if os.path.isdir(path)), "")
WORK = tempfile.TemporaryDirectory()

# The pair of spheres of all host checks.
R1, R2, YOUNG, POISSON, OVERLAP, SHEAR = 7.5e-3, 5e-3, 29e9, 0.15, 0.1e-3, 99e-6
RADIUS = R1 * R2 / (R1 + R2)
E_STAR = YOUNG / 2 / (1 - POISSON**2)
G_STAR = YOUNG / 4 / (1 + POISSON) / (2 - POISSON)
NORMAL = 4 / 3 * E_STAR * math.sqrt(RADIUS * OVERLAP**3)  # 1083.304632 N
STICKING = 8 * G_STAR * math.sqrt(RADIUS * OVERLAP) * SHEAR  # 1478.271645 N
GRANITE = {"young": YOUNG, "poisson": POISSON}

# Sums of 9900 increments, each rounded to 1e-16 of the sum: 1e-14 if they are random, 1e-12 if not.
OF_A_PATH = 1e-12
# A few operations, each rounded to 1e-16; the overlap is a difference of lengths a hundred times as large.
OF_A_STEP = 1e-13


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


class Spheres:
    """Two spheres at a constant or changing overlap, sheared along the arc: normal n, tangent t."""

    def __init__(self, law, overlap=OVERLAP):
        self.law, self.state, self.angle, self.overlap = law, law.new_state(), 0.0, overlap
        self.step(0.0, 0.0, 0.0)

    def step(self, dt, slip, approach):
        self.overlap += approach
        distance = R1 + R2 - self.overlap
        self.angle += slip / distance
        n, t = (math.sin(self.angle), 0, math.cos(self.angle)), (math.cos(self.angle), 0, -math.sin(self.angle))
        v = tuple((slip * b - approach * a) / dt if dt > 0 else 0.0 for a, b in zip(n, t))
        below, above = Body(radius=R1), Body(x=tuple(distance * c for c in n), v=v, radius=R2)
        self.force, self.torque1, self.torque2 = self.law.step(dt, below, above, self.state)
        self.normal, self.shear = dot(self.force, n), -dot(self.force, t)

    def slide(self, path, steps):
        for _ in range(steps):
            self.step(1e-6, path / steps, 0.0)

    def press(self, change, steps):
        for _ in range(steps):
            self.step(1e-6, 0.0, change / steps)


class Check(unittest.TestCase):
    def assert_close(self, value, expected, tolerance):
        self.assertLessEqual(abs(value - expected), tolerance * abs(expected), f"{value} instead of {expected}")

    def assert_refused(self, call, *pieces):
        with self.assertRaises(ValueError) as caught:
            call()
        for piece in pieces:
            self.assertIn(piece, str(caught.exception))


class Forces(Check):
    def test_two_spheres(self):
        for friction, shear in ((10.0, STICKING), (0.4, 0.4 * NORMAL)):
            path = Spheres(Law("dry_hill", friction=friction, **GRANITE))
            self.assert_close(path.normal, NORMAL, 1e-12)  # 0.1 mm is known to 1e-14 of it
            path.slide(SHEAR, 9900)
            self.assert_close(path.shear, shear, OF_A_PATH)
            self.assert_close(path.torque1[1], (R1 - OVERLAP / 2) * shear, OF_A_PATH)  # arms R - o/2
            self.assert_close(path.torque2[1], (R2 - OVERLAP / 2) * shear, OF_A_PATH)

    def test_laws_of_files(self):
        """Each host's row of the table that the hosts themselves gave, to its ten digits: backed off, and pressed again."""
        for name, backed_off, again in (("lammps_mindlin", 1045.29590, 1478.27164), ("lammps_mindlin_force", 1478.27164, 1478.27164),
                                        ("lammps_mindlin_rescale", 739.135823, 1045.29590)):
            file = Path(WORK.name) / "law.toml"
            file.write_text((LAWS / f"{name}.toml").read_text().replace("friction = 0.4", "friction = 10"))
            path = Spheres(Law(file=file))
            path.slide(SHEAR, 100)
            path.press(-OVERLAP / 2, 50)
            self.assert_close(path.shear, backed_off, 5e-9)
            path.press(OVERLAP / 2, 50)
            self.assert_close(path.shear, again, 5e-9)

    def test_named_law_and_file_agree(self):
        """A law by name and by file: the same sums in another order."""
        file = Path(WORK.name) / "law.toml"
        file.write_text((LAWS / "lammps_mindlin_force.toml").read_text())
        both = [Spheres(law) for law in (Law("dry_hill", friction=0.4, **GRANITE), Law(file=file))]
        for path in both:
            path.slide(20e-6, 20)
        for a, b in zip(both[0].force, both[1].force):
            self.assertLessEqual(abs(a - b), OF_A_STEP * NORMAL)

    def test_wall(self):
        """A plane: R* is the sphere's radius; E* as between the spheres. The torque about the sphere's centre is zero."""
        law = Law("smooth_hertz", **GRANITE)
        force, _, torque2 = law.step(0.0, Body(), Body(x=(0, R2 - OVERLAP, 0), radius=R2), law.new_state())
        self.assert_close(force[1], 4 / 3 * E_STAR * math.sqrt(R2 * OVERLAP**3), 1e-12)
        self.assertEqual(list(torque2), [0, 0, 0])

    def test_two_materials(self):
        law = Law("smooth_hertz", young2=70e9, poisson2=0.3, **GRANITE)
        e_star = 1 / ((1 - 0.15**2) / 29e9 + (1 - 0.3**2) / 70e9)
        self.assert_close(Spheres(law).normal, NORMAL * e_star / E_STAR, 1e-12)

    def test_dashpot_and_masses(self):
        """F = k o^(3/2) + alpha sqrt(m* F/o) v of the free masses (Potyondy 2019, Eq. 13)."""
        law, speed = Law("dry_hill", damping_constant=0.1, **GRANITE), 0.5
        for mass1, mass2, effective in ((3.0, 2.0, 1.2), (0.0, 2.0, 2.0), (3.0, 0.0, 3.0)):
            above = Body(x=(0, 0, R1 + R2 - OVERLAP), v=(0, 0, -speed), radius=R2, mass=mass2)
            force, _, _ = law.step(1e-6, Body(radius=R1, mass=mass1), above, law.new_state())
            self.assert_close(force[2], NORMAL + 0.1 * math.sqrt(effective * NORMAL / OVERLAP) * speed, 1e-12)

    def test_bridge(self):
        """psi pi R_o^2 exp(-gap / 2 R_o), until the gap is 2 R_o (Potyondy 2019, Eq. 12)."""
        law = Law("hill", suction=200e3, friction=0.4, **GRANITE)
        self.assertEqual(law.range(R1, R2), 2 * R2)
        self.assertEqual(Law("dry_hill", friction=0.4, **GRANITE).range(R1, R2), 0)
        state = law.new_state()
        for gap, wet, pull in ((4e-3, False, 0), (0, True, 1), (4e-3, True, math.exp(-0.4)), (10.1e-3, True, 0), (4e-3, True, 0)):
            if wet and gap == 0:
                law.make_wet(0.0, 0.0, state)
            force, _, _ = law.step(1e-6, Body(radius=R1), Body(x=(0, 0, R1 + R2 + gap), radius=R2), state)
            self.assert_close(force[2], -pull * 200e3 * math.pi * R2**2, OF_A_STEP)
        self.assertEqual(dict(zip(law.state_names, state))["moisture"], 1)  # ruptured
        self.assert_refused(lambda: Law("dry_hill", **GRANITE).make_wet(0.0, 0.0, state), "no liquid bridge")

    def test_adhesion(self):
        """F(0) = -8/9 F_c, F_c = 3/2 pi w R*; the contact ends at a gap of 3 h^2/R*; the couple of the rolling spring."""
        work, mu = 1.0, 0.1
        law = Law("cohesive_powder", work_of_adhesion=work, rolling_friction=mu, friction=0.4, young=1e7, poisson=0.15)
        e_star = 1e7 / 2 / (1 - 0.15**2)
        h = (math.pi * work * RADIUS**2 / 8 / e_star) ** (1 / 3)
        gap = 3 * h**2 / RADIUS
        self.assert_close(law.range(R1, R2), gap, 1e-12)
        state = law.new_state()
        at = lambda o: law.step(1e-6, Body(radius=R1), Body(x=(0, 0, R1 + R2 - o), radius=R2), state)[0][2]
        self.assertEqual(at(-0.5 * gap), 0)
        at(gap)
        self.assert_close(at(0.0), -8 / 9 * 1.5 * math.pi * work * RADIUS, 1e-8)
        self.assertLess(at(-0.999 * gap), 0)
        self.assertEqual(at(-1.001 * gap), 0)
        self.assertEqual(at(-0.5 * gap), 0)
        state = law.new_state()  # at touch a^3 = 16 h^3
        at(1e-9 * RADIUS)
        _, torque1, torque2 = law.step(1e-6, Body(radius=R1), Body(x=(0, 0, R1 + R2), w=(0, 100, 0), radius=R2), state)
        couple = 9 / 4 * 2 * e_star * 16 ** (1 / 3) * h * (mu * RADIUS) ** 2 * 1e-4
        shear = [t1 - R1 / R2 * t2 for t1, t2 in zip(torque1, torque2)][1]  # without the torques of the shear force
        self.assert_close(shear, couple * (1 + R1 / R2), 1e-8)

    def test_liquid(self):
        """What a bridge holds and what it returned are what it was given; it ends at the exact rupture gap. Pulls and rupture gap at
        V/R^3 = 0.001, angle 0: from the solution of the Young-Laplace equation in tests/reference/capillary_bridge.hpp. The law's
        table is fitted to 1e-3 of the largest pull."""
        radius, volume = 2 * RADIUS, 0.001 * (2 * RADIUS) ** 3
        law = Law("wet_grains", surface_tension=0.07, bridge_volume=volume, **GRANITE)
        rupture = 0.100780963518 * radius
        self.assert_close(law.range(R1, R2), rupture, 1e-5)
        state = law.new_state()
        for gap, held, pull in ((0.5 * rupture, 0, 0), (0.0, 1, 5.88200205809), (0.1 * rupture, 1, 3.86738052895), (1.001 * rupture, 0, 0)):
            force, _, _ = law.step(1e-6, Body(radius=R1), Body(x=(0, 0, R1 + R2 + gap), radius=R2), state)
            self.assertLessEqual(abs(force[2] + pull * 0.07 * radius), 1e-3 * 5.88200205809 * 0.07 * radius)
            of = dict(zip(law.state_names, state))
            self.assertEqual((of["bridge_volume"], of["returned_volume"]), (held * volume, -held * volume))

    def test_rough_ballast(self):
        """F = k_n d^(3/2), below the transition d = o/p (o/o_c)^(p-1); then Hertz from there (Tolomeo & McDowell 2022)."""
        dimension, roughness, o = 2.13, 26.1e-6, 20e-6
        beta = 0.2567 * dimension
        p = 2 / 3 / (1 - beta)
        transition = p * roughness * 0.75 * math.sqrt(math.pi) * (20 / math.pi**1.5 / dimension) ** (1 / beta)
        hertz = 4 / 3 * E_STAR * math.sqrt(RADIUS)
        indentation = o / p * (o / transition) ** (p - 1)
        path = Spheres(Law("rough_ballast", fractal_dimension=dimension, roughness=roughness, friction=0.7, **GRANITE), 0.0)
        path.press(o, 20)
        self.assertLess(o, transition)
        self.assert_close(path.normal, hertz * indentation**1.5, 1e-11)  # the overlap is a difference, to 1e-13
        path.press(-2e-6, 2)
        self.assert_close(path.normal, hertz * (indentation - 2e-6) ** 1.5, 1e-11)
        self.assert_close(dict(zip(path.law.state_names, path.state))["largest_overlap"], o, 1e-12)

    def test_linear_laws(self):
        """F = k o; k = E pi r^2 / L of the smaller radius (Potyondy 2019, Sec. 2.1)."""
        self.assert_close(Spheres(Law("linear_spring_dashpot", normal_stiffness=1e7)).normal, 1e7 * OVERLAP, 1e-12)
        self.assert_close(Spheres(Law("linear_friction", modulus=29e9)).normal,
                          29e9 * math.pi * R2**2 / (R1 + R2) * OVERLAP, 1e-12)


class Contract(Check):
    def test_query_changes_nothing(self):
        path = Spheres(Law("dry_hill", friction=0.4, **GRANITE))
        path.slide(20e-6, 20)
        force, state = list(path.force), list(path.state)
        path.step(0.0, 0.0, 0.0)
        for a, b in zip(list(path.force) + list(path.state), force + state):  # to rounding: the history is projected again
            self.assertLessEqual(abs(a - b), OF_A_STEP * NORMAL)

    def test_swapped_bodies(self):
        path = Spheres(Law("dry_hill", friction=0.4, **GRANITE))
        path.slide(20e-6, 20)
        law, x = path.law, tuple((R1 + R2 - OVERLAP) * c for c in (math.sin(path.angle), 0, math.cos(path.angle)))
        swapped = (ctypes.c_double * 3)(*(sign * value for sign, value in zip(law.exchange_signs, path.state)))
        force, torque1, torque2 = law.step(0.0, Body(x=x, radius=R2), Body(radius=R1), swapped)
        for a, b in zip([*force, *torque1, *torque2], [*path.force, *path.torque2, *path.torque1]):
            self.assertLessEqual(abs(abs(a) - abs(b)), OF_A_STEP * NORMAL)
        self.assertLess(dot(force, path.force), 0)
        self.assertGreater(torque1[1] * path.torque2[1], 0)
        self.assertEqual(law.exchange_signs, [-1, -1, -1])

    def test_many_contacts_are_many_steps(self):
        law, count = Law("hill", suction=1e5, friction=0.4, damping_constant=0.1, **GRANITE), 7
        size = len(law.state_names)
        below = (Body * count)(*(Body(radius=R1, mass=1.0, w=(0.1 * i, 3, 0)) for i in range(count)))
        above = (Body * count)(*(Body(x=(1e-3 * i, 0, 12.3e-3), v=(1, i, -2), radius=R2, mass=0.5) for i in range(count)))
        states = (ctypes.c_double * (size * count))()
        outs = [(contactlaws.Vector * count)() for _ in range(3)]
        self.assertEqual(contactlaws._step(law._law, 1e-6, count, below, above, states, *outs), 0)
        for i in range(count):
            state = law.new_state()
            for one, many in zip(law.step(1e-6, below[i], above[i], state), outs):
                self.assertEqual(list(one), list(many[i]))
            self.assertEqual(list(state), states[size * i:size * (i + 1)])

    def test_what_is_wrong_is_named(self):
        hill = {"suction": 1e5, **GRANITE}
        self.assert_refused(lambda: Law("dry_hil"), "no law 'dry_hil'", "there are:", "dry_hill", "rough_ballast")
        self.assert_refused(lambda: Law("dry_hill", friktion=1), "no parameter 'friktion'", "friction", "damping_constant", "young2", "restitution")
        self.assert_refused(lambda: Law("dry_hill", friction=-1, **GRANITE), "friction is -1", "[0, inf)")
        self.assert_refused(lambda: Law("dry_hill", friction=0.4), "young is missing, must lie in (0, inf) Pa")
        self.assert_refused(lambda: Law("dry_hill", restitution=1.2, **GRANITE), "restitution")
        self.assert_refused(lambda: Law("linear_friction", young=1e9), "no parameter 'young'", "modulus")
        self.assert_refused(lambda: Law("hill", **{**hill, "poisson": 0.7}), "poisson is 0.7", "(-1, 0.5]")
        self.assert_refused(lambda: Law(file="no/such.toml"), "no/such.toml: cannot be opened")
        file = Path(WORK.name) / "law.toml"
        file.write_text('normal = "herz"\n')
        self.assert_refused(lambda: Law(file=file), 'law.toml:1:10: [normal] law is "herz"')

    def test_bodies_are_checked_before_anything_changes(self):
        law = Law("dry_hill", friction=0.4, **GRANITE)
        good = Body(x=(0, 0, 12e-3), v=(1, 0, 0), radius=R2)
        for bad, message in ((Body(x=(0, 0, 1), radius=-1), "contact 1, body 2: radius is -1 m"),
                             (Body(x=(0, 0, 1), radius=0), "radius is 0 m"), (Body(x=(0, 0, 1), radius=math.nan), "nan"),
                             (Body(x=(0, 0, 1), radius=1, mass=-1), "contact 1, body 2: mass is -1 kg")):
            states, outs = (ctypes.c_double * 6)(), [(contactlaws.Vector * 2)() for _ in range(3)]
            below = (Body * 2)(Body(radius=R1), Body(radius=R1))
            self.assertEqual(contactlaws._step(law._law, 1e-6, 2, below, (Body * 2)(good, bad), states, *outs), 1)
            self.assertIn(message, contactlaws._error().decode())
            self.assertEqual(list(states) + [c for out in outs for v in out for c in v], [0.0] * 24)

    def test_threads_share_a_law(self):
        """Each thread has its own contact and its own error text; ctypes releases Python's lock during a call."""
        law, results, texts = Law("dry_hill", friction=10.0, **GRANITE), {}, {}
        barrier = threading.Barrier(4)

        def work(i):
            barrier.wait()
            path = Spheres(law)
            path.slide(SHEAR * (i + 1) / 4, 2000)
            results[i] = path.shear
            try:
                Law("dry_hill", friction=-1 - i, **GRANITE)
            except ValueError as error:
                barrier.wait()
                texts[i] = str(error), contactlaws._error().decode()

        threads = [threading.Thread(target=work, args=(i,)) for i in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for i in range(4):
            self.assert_close(results[i], STICKING * (i + 1) / 4, OF_A_PATH)
            for text in texts[i]:
                self.assertIn(f"friction is {-1 - i},", text)


class OtherLanguages(Check):
    def run_program(self, *command):
        result = subprocess.run(command, capture_output=True, text=True, cwd=WORK.name, env={**os.environ, "CONTACTLAWS_LIBRARY": LIBRARY})
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stdout

    def check_lines(self, output):
        """What the examples print: two lines of friction, normal, shear (on body 2, against the slip), two torques."""
        lines = [[float(x) for x in re.findall(r"-?\d+\.?\d*", line)] for line in output.splitlines() if line.startswith("friction")]
        self.assertEqual(len(lines), 2)
        for line, shear in zip(lines, (STICKING, 0.4 * NORMAL)):
            _, normal, sheared, torque1, torque2 = line
            # half a unit of the last digit printed, and rounding
            self.assertLess(abs(normal - NORMAL), 6e-7)
            self.assertLess(abs(sheared + shear), 6e-8)
            self.assertLess(abs(torque1 - (R1 - OVERLAP / 2) * shear), 6e-10)
            self.assertLess(abs(torque2 - (R2 - OVERLAP / 2) * shear), 6e-10)

    def test_python(self):
        self.check_lines(self.run_program(sys.executable, str(FACE / "two_spheres.py")))

    def test_fortran(self):
        compiler = shutil.which("gfortran")
        if not compiler:
            self.skipTest("no gfortran")
        folder, name = os.path.split(LIBRARY)
        self.run_program(compiler, "-Wall", "-Wextra", "-Werror", str(FACE / "two_spheres.f90"), "-o", "two_spheres",
                         LIBRARY, f"-Wl,-rpath,{folder}")
        self.check_lines(self.run_program("./two_spheres"))

    def test_header_is_c(self):
        compiler = shutil.which("gcc") or shutil.which("cc")
        if not compiler:
            self.skipTest("no C compiler")
        self.run_program(compiler, "-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-fsyntax-only", "-x", "c",
                         str(FACE / "contactlaws.h"))


if __name__ == "__main__":
    if len(sys.argv) > 1 and not sys.argv[1].startswith("-") and os.path.exists(sys.argv[1]):
        LIBRARY = os.path.abspath(sys.argv.pop(1))
    else:
        if not shutil.which("g++") or not EIGEN or not os.path.exists("/usr/include/toml++/toml.h"):
            print("skipped: no library given, and g++, libeigen3-dev and libtomlplusplus-dev are not all installed")
            sys.exit(77)
        LIBRARY = os.path.join(WORK.name, "libcontactlaws.so")
        subprocess.run(["sh", ROOT / "tests" / "hosts" / "library.sh", LIBRARY], check=True)
    os.environ["CONTACTLAWS_LIBRARY"] = LIBRARY
    sys.path.insert(0, str(FACE))
    sys.dont_write_bytecode = True
    import contactlaws
    from contactlaws import Body, Law
    unittest.main()
