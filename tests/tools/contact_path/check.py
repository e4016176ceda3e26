#!/usr/bin/env python3
"""Runs examples/contact_path from outside, as its user does: numbers against closed forms and publications, every kind of
fault in its input, and what it leaves behind.

    check.py CONTACT_PATH [unittest options]
"""

import csv
import math
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM = ""
EXAMPLE = Path(__file__).resolve().parents[3] / "examples" / "contact_path"
HEADER = "dt,overlap,nx,ny,nz,vx,vy,vz\n"
STEP = "1e-6,1e-4,0,0,1,0,0,-1\n"
HERTZ = 'normal = "hertz"\n'
FORCE = '[shear]\nlaw = "force"\nfriction = 0.4\n'
PAIR = ("[pair]\neffective_radius = 3e-3\neffective_young = 14e9\neffective_shear = 3e9\neffective_mass = 1e-3\n"
        "min_radius = 5e-3\nlength = 12e-3\n")


def run(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=120)


def rows_of(text):
    lines = [line for line in text.splitlines() if not line.startswith("#")]
    return list(csv.DictReader(lines))


def law_text(name):
    return (EXAMPLE / "laws" / f"{name}.toml").read_text()


class InTemporaryDirectory(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.directory = Path(temporary.name)

    def file(self, name, text):
        path = self.directory / name
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return path

    def drive(self, law, path, precision="double"):
        """The rows of OUT.csv. `law` is text; `path` the name of an example's path, or text."""
        law_file = self.file("law.toml", law)
        path_file = self.file("path.csv", path) if "\n" in path else EXAMPLE / "paths" / f"{path}.csv"
        out = self.directory / "out.csv"
        result = run(law_file, path_file, "-o", out, "--precision", precision)
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""))
        return rows_of(out.read_text())

    def assert_close(self, value, expected, tolerance):
        self.assertLessEqual(abs(float(value) - expected), tolerance * abs(expected), f"{value}, expected {expected}")


class Numbers(InTemporaryDirectory):
    def test_closed_forms_of_the_examples(self):
        """expected.csv, whose tolerances have their reasons beside them."""
        answers = {}
        expected = rows_of((EXAMPLE / "expected.csv").read_text())
        self.assertGreater(len(expected), 40)
        for row in expected:
            key = row["law"], row["path"]
            if key not in answers:
                answers[key] = self.drive(law_text(row["law"]), row["path"])
            with self.subTest(**row):
                value, wanted = float(answers[key][int(row["step"]) - 1][row["column"]]), float(row["expected"])
                # Where nothing is expected, the tolerance is absolute: of joules or newtons of order one and more.
                scale = abs(wanted) if wanted != 0 else 1.0
                self.assertLessEqual(abs(value - wanted), float(row["tolerance"]) * scale)

    def test_numbers_of_the_memo(self):
        """Potyondy (2019), recomputed to twelve digits."""

        def at(law, path, step, column, *change):
            return self.drive(law_text(law).replace(*change) if change else law_text(law), path)[step - 1][column]

        no_limit = "friction = 0.4", "friction = 1000"
        for number, value in {
            18221.2373908: at("memo_linear", "stage_a", 100, "fn_total"),
            18039.0250169: at("memo_linear", "stage_b", 200, "fx", *no_limit),
            7288.49495633: at("memo_linear", "stage_b", 200, "fx"),
            1083.30463206478: at("memo_hill", "stage_a", 100, "fn_total"),
            1478.27164521: at("memo_hill", "stage_b", 200, "fx", *no_limit),
            433.321852826: at("memo_hill", "stage_b", 200, "fx"),
            3960.44634634: at("memo_hill_dashpots", "dashpot_normal", 101, "fn_total"),
            3064.04820570: at("memo_hill_dashpots", "dashpot_normal", 102, "fn_total"),
            1595.99115427: at("memo_hill_dashpots", "dashpot_shear", 201, "fx"),
            1552.18522748: at("memo_hill_dashpots", "dashpot_shear", 202, "fx"),
            -15.70796: at("memo_hill_wet", "bridge", 242, "fn_total"),
        }.items():
            with self.subTest(number=number):
                printed = 1e-6 if number == -15.70796 else 1e-11  # half a unit in the last digit printed, at most
                self.assert_close(value, number, printed)

    def test_laws_of_other_codes(self):
        """Forces that those codes gave on this path: F_t with mu = 10, with 0.4, backed off, returned."""
        whole, rescaled, half, slipping = 1478.27164, 1045.29590, 739.135823, 433.321853
        # The codes' own steps leave some 1e-9; figures are printed to nine digits.
        # Projection without restored length loses a^2/2N on an arc of a = 0.008 rad in N = 100 steps: 3e-7.
        table = [
            ("lammps_mindlin", "eight_laws", (whole, slipping, rescaled, whole), 1e-8),
            ("lammps_mindlin_rescale", "eight_laws", (whole, slipping, half, rescaled), 1e-8),
            ("lammps_mindlin_force", "eight_laws", (whole, slipping, whole, whole), 1e-8),
            ("lammps_mindlin_rescale_force", "eight_laws", (whole, slipping, rescaled, rescaled), 1e-8),
            ("liggghts_hertz_history", "eight_laws", (whole, slipping, rescaled, whole), 4e-7),
            ("yade_mindlin", "eight_laws_yade", (1490.193193, slipping, 1490.193193, 1490.193193), 1e-8),
            ("yade_mindlin", "eight_laws", (whole, slipping, whole, whole), 1e-8),
        ]
        def shear(row):
            force = math.hypot(*(float(row[c]) for c in ("fx", "fy", "fz")))
            return math.sqrt(force**2 - float(row["fn_total"]) ** 2)

        for law, path, (sheared, limited, backed_off, returned), tolerance in table:
            with self.subTest(law=law, path=path):
                sticking = self.drive(law_text(law).replace("friction = 0.4", "friction = 10"), path)
                sliding = self.drive(law_text(law), path)
                self.assert_close(sticking[149]["fn_total"], 1083.304632, 1e-9)
                self.assert_close(shear(sticking[149]), sheared, tolerance)
                self.assert_close(shear(sliding[149]), limited, tolerance)
                self.assert_close(shear(sticking[174]), backed_off, tolerance)
                self.assert_close(shear(sticking[199]), returned, tolerance)

    def test_restitution_as_other_codes_make_it(self):
        """What is realised when 0.7 is asked (the closed forms of impacts, at the damping that the driver shows)."""
        exact = {
            "allowed": lambda z: math.exp(-math.pi * z / math.sqrt(1 - z**2)),
            "clipped": lambda z: math.exp(-2 * z * math.acos(z) / math.sqrt(1 - z**2)),
        }
        mass = 1 / sum(1 / (4 / 3 * math.pi * r**3 * 2650) for r in (7.5e-3, 5e-3))
        for law, tension, realised in (
            ("liggghts_restitution", "allowed", 0.7),
            ("liggghts_limit_force", "clipped", 0.7182),
            ("kratos_restitution", "clipped", 0.7),
        ):
            with self.subTest(law=law):
                self.assertIn(f'tension = "{tension}"', law_text(law))
                row = self.drive(law_text(law), HEADER + STEP)[0]  # overlap 0.1 mm, 1 m/s
                elastic = float(row["fn_elastic"])
                alpha = (float(row["fn_total"]) - elastic) / math.sqrt(mass * elastic / 1e-4)
                self.assertAlmostEqual(exact[tension](alpha / math.sqrt(5)), realised, delta=5e-5)  # four digits printed

    def test_shear_moduli_of_other_codes(self):
        def shear(text, path="eight_laws"):
            row = self.drive(text.replace("friction = 0.4", "friction = 100"), path)[149]
            force = math.hypot(*(float(row[c]) for c in ("fx", "fy", "fz")))
            return math.sqrt(force**2 - float(row["fn_total"]) ** 2)

        # MercuryDPM: 2/3 of everybody else's, its history projected as LIGGGHTS's.
        self.assert_close(shear(law_text("mercurydpm_mindlin")), 2 / 3 * 1478.27164521, 4e-7)
        # Averaged: G and nu, then G* = G/(2 (2 - nu)); others sum (2 - nu)/G.
        (g1, nu1), (g2, nu2) = ((young / 2 / (1 + nu), nu) for young, nu in ((48e9, 0.2), (208e9, 0.3)))
        averaged = (g1 + g2) / 2 / (2 * (2 - (nu1 + nu2) / 2))
        summed = 1 / ((2 - nu1) / g1 + (2 - nu2) / g2)
        own = law_text("averaged_moduli")
        bodies = own[: own.index("[pair]")] + "".join(
            f"[pair.body{i}]\nradius = {r}\nyoung = {young}\npoisson = {nu}\ndensity = 1\n"
            for i, r, young, nu in ((1, 7.5e-3, 48e9, 0.2), (2, 5e-3, 208e9, 0.3))
        )
        self.assert_close(shear(own) / shear(bodies), averaged / summed, 1e-11)

    def test_every_law_that_names_a_code_is_tested(self):
        source = Path(__file__).read_text()
        codes = [file.stem for file in (EXAMPLE / "laws").glob("*.toml") if file.stem.split("_")[0] not in
                 ("memo", "ballast", "oblique", "rotating", "scene")]
        self.assertGreaterEqual(len(codes), 11)
        for law in codes:
            self.assertIn(f'"{law}"', source)

    def test_laws_of_scenes(self):
        """The normal force of a contact pressed to 1e-6 m without speed: Hertz's, yield along a line, Luding's line, the pull of JKR and water.

        1e-12: the overlap is written in 12 digits.
        """
        press = HEADER + "".join(f"1,{i * 1e-8:.12g},0,0,1,0,0,0\n" for i in range(1, 101))
        hertz = lambda young, nu, r: 4 / 3 * young / (2 * (1 - nu**2)) * math.sqrt(r / 2) * 1e-6**1.5
        force = lambda scene: float(self.drive(law_text(f"scene_{scene}"), press)[-1]["fn_total"])
        self.assert_close(force("rolling_grains"), hertz(29e9, 0.15, 5e-3), 1e-12)
        self.assert_close(force("sticky_powder"), 1e3 * 1e-6, 1e-12)
        stiffness, radius, pressure = 70e9 / (2 * (1 - 0.33**2)), 0.5e-3, 0.5e9
        first = radius * (math.pi * pressure / (2 * stiffness)) ** 2  # overlap of first yield (Thornton & Ning 1998)
        at_first = 4 / 3 * stiffness * math.sqrt(radius) * first**1.5
        self.assert_close(force("plastic_grains"), at_first + math.pi * pressure * radius * (1e-6 - first), 1e-12)
        pull = hertz(29e9, 0.15, 1e-3) - force("wet_grains")
        self.assertTrue(0.9 < pull / (2 * math.pi * 1e-3 * 0.072 * math.cos(0.2)) < 1, pull)  # Derjaguin's, of a vanishing volume; V = 1e-3 R^3 pulls some percent less
        smallest = min(float(row["fn_total"]) for row in self.drive(law_text("scene_cohesive_powder"), HEADER + "".join(
            f"1,{o * 1e-11:.12g},0,0,1,0,0,0\n" for o in range(100, -2000, -1))))
        self.assert_close(smallest, -1.5 * math.pi * 0.05 * 2.5e-6, 1e-4)  # of points 1e-11 m apart, near a smooth minimum

    def test_incremental_ballast_follows_the_closed_form(self):
        """To the first order of its steps: 1.5 % at 1000 steps to 10 um (Tolomeo & McDowell's update)."""
        fine = HEADER + "".join(f"1e-6,{(i + 1) * 1e-8:.12g},0,0,1,0,0,-1e-2\n" for i in range(1000))
        wanted = float(self.drive(law_text("ballast"), fine)[-1]["fn_total"])
        law = law_text("ballast_incremental").replace("seed_force = 1e-6", "seed_force = 1e-12")
        self.assertAlmostEqual(float(self.drive(law, fine)[-1]["fn_total"]) / wanted - 1, -0.015, delta=0.001)

    def test_surfaces_that_meet_again(self):
        """After 30 um and a gap, at 20 um: the virgin curve, or Hertz's from the plastic overlap (Tolomeo & McDowell)."""
        path = rows_of((EXAMPLE / "paths/ballast_cycles.csv").read_text())
        virgin = {o: float(next(r["expected"] for r in rows_of((EXAMPLE / "expected.csv").read_text())
                                if (r["law"], r["step"], r["column"]) == ("ballast", str(o), "fn_total"))) for o in (20, 30)}
        hertz = 4 / 3 * 32e9 * math.sqrt(2.36e-3)
        plastic = 30e-6 - (virgin[30] / hertz) ** (2 / 3)
        again = next(i for i in range(66, len(path)) if abs(float(path[i]["overlap"]) - 20e-6) < 1e-12)
        # On the same spot the indentation is 0.6 % of the overlap, of which it is a difference.
        for recontact, force, tolerance in (("fresh_surface", virgin[20], 1e-12),
                                            ("same_spot", hertz * (20e-6 - plastic) ** 1.5, 1e-10)):
            law = law_text("ballast").replace("[shear]", f'recontact = "{recontact}"\n[shear]')
            self.assert_close(self.drive(law, "ballast_cycles")[again]["fn_total"], force, tolerance)
        self.assertEqual(self.drive(law_text("ballast"), "ballast_cycles")[again]["fn_total"],
                         self.drive(law_text("ballast").replace("[shear]", 'recontact = "fresh_surface"\n[shear]'),
                                    "ballast_cycles")[again]["fn_total"])  # the default

    def test_rolling(self):
        """M = -k_r w dt from the first step on, k_r = 9/4 k_n (mu_r R*)^2, up to mu_r R* F (Ai et al. 2011, model C)."""
        law = '[normal]\nlaw = "linear"\nstiffness = 1e6\n[rolling]\nlaw = "spring"\nrolling_friction = 0.1\n' + PAIR
        spin = HEADER.replace("\n", ",wx,wy,wz\n") + "1e-3,1e-4,0,0,1,0,0,0,0,2,7\n" * 400
        rows = self.drive(law, spin)
        stiffness, limit = 9 / 4 * 1e6 * (0.1 * 3e-3) ** 2, 0.1 * 3e-3 * 1e6 * 1e-4
        self.assert_close(rows[0]["my"], -stiffness * 2e-3, 1e-14)
        self.assert_close(rows[-1]["my"], -limit, 1e-14)
        self.assertEqual({row["mx"] for row in rows} | {row["mz"] for row in rows} | {row["fx"] for row in rows} - {"-0"}, {"0"})
        # dissipated: the work of the couple less what the spring stores; trapezoids, 74 of them to the limit
        loaded = limit / stiffness
        self.assert_close(rows[-1]["dissipated_energy"], limit * (0.8 - loaded), 1e-2)

    def test_rolling_stiffness(self):
        """k_r = ratio k_n R*^2 (Iwashita & Oda 1998) or as given; a dashpot alpha_r sqrt(m* R*^2 k_r) beside it."""
        rolling = '[normal]\nlaw = "linear"\nstiffness = 1e6\n[rolling]\nlaw = "{}"\nrolling_friction = 0.1\n{}'
        spin = HEADER.replace("\n", ",wx,wy,wz\n") + "1e-6,1e-4,0,0,1,0,0,0,0,2,7\n"
        for law, key, stiffness in (("spring_dashpot", "", 9 / 4 * 1e6 * (0.1 * 3e-3) ** 2),
                                    ("spring_dashpot_of_shear", "stiffness_ratio = 0.6\n", 0.6e6 * 3e-3**2),
                                    ("spring_dashpot_given", "rolling_stiffness = 7\n", 7)):
            row = self.drive(rolling.format(law, "rolling_damping = 0.02\n" + key) + PAIR, spin)[0]
            self.assert_close(row["my"], -stiffness * 2e-6 - 2 * 0.02 * 3e-3 * math.sqrt(1e-3 * stiffness), 1e-12)
            self.assertEqual(row["mz"], "0")

    def test_twisting(self):
        """Within the limit -k_t w dt - c_t w; beside Hertz k_t = 4 G* a^3 and c_t = alpha_t a^2/2 sqrt(8 G* a m*)."""
        spin = HEADER.replace("\n", ",wx,wy,wz\n") + "1e-6,1e-4,0,0,1,0,0,0,3,2,7\n"
        given = 'twisting_given"\ntwisting_stiffness = 9\ntwisting_reach = 0.1\ntwisting_viscosity = 2e-6\n'
        row = self.drive(HERTZ + f'[rolling]\nlaw = "{given}' + PAIR, spin)[0]
        self.assert_close(row["mz"], -9 * 7e-6 - 2e-6 * 7, 1e-12)
        self.assertEqual({float(row["mx"]), float(row["my"])}, {0})
        marshall = 'twisting"\ntwisting_friction = 0.4\ntwisting_damping = 1e-3\n'
        row = self.drive(HERTZ + f'[rolling]\nlaw = "{marshall}' + PAIR, spin)[0]
        a, shear = math.sqrt(3e-3 * 1e-4), 3e9
        damping = 1e-3 * a**2 / 2 * math.sqrt(8 * shear * a * 1e-3)
        self.assert_close(row["mz"], -4 * shear * a**3 * 7e-6 - damping * 7, 1e-12)

    def test_adhesion(self):
        """DMT: Hertz less 2 pi w R*."""
        law = '[normal]\nlaw = "dmt"\nwork_of_adhesion = 10\n' + PAIR
        smooth, adhesive = (self.drive(text, HEADER + STEP)[0] for text in (HERTZ + PAIR, law))
        self.assert_close(float(smooth["fn_total"]) - float(adhesive["fn_total"]), 2 * math.pi * 10 * 3e-3, 1e-12)

    def test_adhesion_beyond_touch(self):
        """JKR: -8/9 F_c at touch, which holds until -3/4 (pi^2 w^2 R*/E*^2)^(1/3); friction by each rule."""
        pull_off = 1.5 * math.pi * 10 * 3e-3
        law = '[normal]\nlaw = "jkr"\nwork_of_adhesion = 10\n{}' + FORCE + PAIR
        path = HEADER + "1e-6,-1e-12,0,0,1,0,0,0\n1e-6,1e-18,0,0,1,1e3,0,0\n1e-6,-1e-9,0,0,1,0,0,0\n1e-6,-1,0,0,1,0,0,0\n"
        for rule, counted in (("", 2), ("none", 0), ("thornton_dmt", 1)):
            rows = self.drive(law.format(f'adhesive_friction = "{rule}"\n' if rule else ""), path)
            self.assertEqual([float(rows[i]["fn_total"]) for i in (0, 3)], [0, 0])
            self.assert_close(rows[1]["fn_total"], -8 / 9 * pull_off, 1e-6)
            self.assertLess(float(rows[2]["fn_total"]), -pull_off / 2)
            self.assert_close(-float(rows[1]["fx"]), 0.4 * max(counted - 8 / 9, 0) * pull_off, 1e-6)

    def test_restitution_is_the_damping_constant_that_it_names(self):
        # alpha = -sqrt(5) ln e / sqrt(ln^2 e + pi^2), and 2 z for a linear spring
        ratio = -math.log(0.7) / math.sqrt(math.log(0.7) ** 2 + math.pi**2)
        for normal, per_ratio in ((HERTZ, math.sqrt(5)), ('[normal]\nlaw = "linear"\nstiffness = 1e6\n', 2)):
            by = lambda key, value: normal + f'[damping]\nlaw = "dashpots"\n{key} = {value!r}\n' + PAIR
            asked = self.drive(by("restitution", 0.7), HEADER + STEP)[0]
            given = self.drive(by("damping_constant", per_ratio * ratio), HEADER + STEP)[0]
            self.assert_close(asked["fn_total"], float(given["fn_total"]), 1e-14)
            self.assertGreater(float(asked["fn_total"]), float(asked["fn_elastic"]))

    def test_tension_is_clipped_where_asked(self):
        law = HERTZ + '[damping]\nlaw = "dashpots"\ndamping_constant = 1\ntension = "{}"\n' + PAIR
        leaving = HEADER + "1e-6,1e-6,0,0,1,0,0,5\n"
        self.assertLess(float(self.drive(law.format("allowed"), leaving)[0]["fn_total"]), 0)
        self.assertEqual(float(self.drive(law.format("clipped"), leaving)[0]["fn_total"]), 0)

    def test_two_bodies_and_their_effective_values_are_the_same_pair(self):
        nu, young, rho, r1, r2 = 0.15, 29e9, 2650, 7.5e-3, 5e-3
        masses = [4 / 3 * math.pi * r**3 * rho for r in (r1, r2)]
        effective = (
            f"[pair]\neffective_radius = {r1 * r2 / (r1 + r2)!r}\neffective_young = {young / 2 / (1 - nu**2)!r}\n"
            f"effective_shear = {young / 4 / (2 - nu) / (1 + nu)!r}\neffective_mass = {1 / sum(1 / m for m in masses)!r}\n"
        )
        bodies = law_text("memo_hill_dashpots")
        law = bodies[: bodies.index("[pair.body1]")] + effective
        for mine, other in zip(self.drive(law, "dashpot_shear"), self.drive(bodies, "dashpot_shear")):
            for column in ("fx", "fz"):
                self.assert_close(mine[column], float(other[column]), 1e-13)

    def test_kinds_of_bodies(self):
        steel = "young = 2e11\npoisson = 0.3\n"
        head = 'normal = "hertz"\n[damping]\nlaw = "dashpots"\ndamping_constant = 0.1\n'

        def force(body1, body2):
            row = self.drive(f"{head}[pair.body1]\n{body1}\n[pair.body2]\n{body2}\n", HEADER + STEP)[0]
            return float(row["fn_elastic"]), float(row["fn_total"]) - float(row["fn_elastic"])

        ball, mass = steel + "radius = 1e-3\ndensity = 7850\n", 4 / 3 * math.pi * 1e-9 * 7850
        spring, dashpot = force(ball, ball)
        by_mass = force(ball.replace("density = 7850", f"mass = {mass!r}"), ball)
        # A dashpot's share is the difference of two forces a thousand times as large.
        self.assert_close(by_mass[1], dashpot, 1e-12)
        self.assert_close(force(steel + "plane = true", ball)[0], spring * math.sqrt(2), 1e-12)  # R* = R, not R/2
        self.assert_close(force(ball + "rigid = true", ball)[0], spring * 2, 1e-12)  # 1/E* has one side
        self.assert_close(force(ball + "fixed = true", ball)[1], dashpot * math.sqrt(2), 1e-12)  # m* = m, not m/2
        self.assert_close(force("radius = 1e-3\nrigid = true\nfixed = true", ball)[0], spring * 2, 1e-12)

    def test_all_compositions_run_in_all_precisions(self):
        rough = 'law = "pohrt_popov{}"\nfractal_dimension = 2.13\nroughness = 26.1e-6\n'
        normals = ['law = "linear"\nstiffness = 1e7\n', 'law = "linear"\nmodulus = 1e9\n', 'law = "hertz"\n']
        normals += [rough.format(""), 'law = "dmt"\nwork_of_adhesion = 10\n', 'law = "jkr"\nwork_of_adhesion = 10\n']
        normals += [
            rough.format("_elasto_plastic") + f'recontact = "{recontact}"\n'
            for recontact in ("same_spot", "fresh_surface")
        ]
        normals += [
            rough.format("_incremental") + f'seed_force = 1e-9\nunloads = "{unloads}"\n'
            for unloads in ("plastically", "elastically")
        ]
        dampings = ['law = "none"\n'] + [
            f'law = "dashpots"\ndamping_constant = 0.07\ntension = "{tension}"\n{shear}'
            for tension, shear in (("allowed", ""), ("clipped", ""), ("allowed", "shear_damping_constant = 0.01\n"))
        ]
        shears = ['law = "none"\n'] + [
            f'law = "{law}"\nfriction = 0.5\nrotation = "{rotation}"\n{more}'
            for law in ("force", "force_rescaled", "displacement", "displacement_rescaled")
            for rotation in ("project", "project_restore", "rotate")
            for more in ("", 'stiffness = "constant_ratio"\nratio = 0.8\n',
                         'stiffness = "elastic_ratio"\nstatic_friction = 0.6\n')
        ]
        bridges = ['law = "none"\n', 'law = "suction"\nsuction = 2e4\nwet = true\n']
        rollings = ['law = "none"\n', 'law = "spring"\nrolling_friction = 0.1\n']
        path = HEADER.replace("\n", ",wx,wy,wz\n") + "".join(
            f"1e-6,{o}e-6,{a / 100},0,1,{-0.5 + a / 10},0.1,{-v},{10 - a},20,5\n"
            for a, (o, v) in enumerate([(2, 2), (4, 2), (6, 2), (5, -1), (4, -1), (-2, -6), (3, 5)])
        )
        # Not the whole product of a thousand: each law of each slot in turn, beside each of the slot before it.
        compositions = []
        for i, normal in enumerate(normals):
            for j, shear in enumerate(shears):
                if (i + j) % 3 == 0 or j == 0:
                    compositions.append((normal, dampings[(i + j // 3) % 4], shear, bridges[(i + j // 3) % 2],
                                         rollings[(i + j // 6) % 2]))
        for number, (normal, damping, shear, bridge, rolling) in enumerate(compositions):
            law = f"[normal]\n{normal}[damping]\n{damping}[shear]\n{shear}[bridge]\n{bridge}[rolling]\n{rolling}{PAIR}"
            with self.subTest(law=law):
                # Steps of 2 um in 6: the increments of the incremental law amplify a rounding no more than the others do.
                exact = self.drive(law, path, "200")
                largest = max(abs(float(row[c])) for row in exact for c in ("fx", "fy", "fz"))
                self.assertGreater(largest, 0)
                precision, epsilon = [("double", 2.0**-52), ("float", 2.0**-23), ("long", 2.0**-52)][number % 3]
                rounded = self.drive(law, path, precision)
                for row, other in zip(rounded, exact):
                    self.assertEqual(list(row), list(other))
                    for c in ("fx", "fy", "fz", "fn_elastic", "fn_total"):
                        self.assertLessEqual(abs(float(row[c]) - float(other[c])), 100 * epsilon * largest, c)
                    for c in ("mx", "my", "mz"):  # |M| <= rolling_friction R* P
                        self.assertLessEqual(abs(float(row[c]) - float(other[c])), 100 * epsilon * 0.1 * 3e-3 * largest, c)

    def test_precision(self):
        """Each precision is as far from 200 bits as its rounding, and no nearer: it is the one that was asked for."""
        exact = self.drive(law_text("memo_hill_dashpots"), "dashpot_shear", "200")
        for precision, epsilon in (("float", 2.0**-23), ("double", 2.0**-52)):
            rows = self.drive(law_text("memo_hill_dashpots"), "dashpot_shear", precision)
            errors = [abs(float(r["fx"]) - float(e["fx"])) / 1600 for r, e in zip(rows, exact)]
            self.assertLessEqual(max(errors), 100 * epsilon)  # half a rounding in each of 100 increments
            self.assertGreater(max(errors), epsilon / 4)
        rows = self.drive(law_text("memo_hill_dashpots"), "dashpot_shear", "long")
        errors = [abs(float(r["fx"]) - float(e["fx"])) / 1600 for r, e in zip(rows, exact)]
        self.assertLessEqual(max(errors), 2.0**-52)  # of the doubles that this script reads

    def test_decimals_are_rounded_once(self):
        """At 200 bits 0.1 is 0.1, not the double next to it: 17 digits of F = k o show that in every one."""
        law = '[normal]\nlaw = "linear"\nstiffness = 0.1\n'
        row = self.drive(law, HEADER + "1,0.3,0,0,1,0,0,0\n", "200")[0]
        self.assertEqual(row["fn_total"], "0.03")
        self.assertEqual(self.drive(law, HEADER + "1,0.3,0,0,1,0,0,0\n")[0]["fn_total"], "0.029999999999999999")
        grouped = '[normal]\nlaw = "linear"\nstiffness = 1_00.5e-3\n'
        self.assertEqual(self.drive(grouped, HEADER + "1,1,0,0,1,0,0,0\n", "200")[0]["fn_total"], "0.1005")
        hexadecimal = '[normal]\nlaw = "linear"\nstiffness = 0x10\n'
        self.assertEqual(self.drive(hexadecimal, HEADER + "1,1,0,0,1,0,0,0\n", "200")[0]["fn_total"], "16")


class Forms(InTemporaryDirectory):
    """What the files may look like."""

    def test_columns(self):
        rows = self.drive(law_text("memo_hill_wet"), "bridge")
        self.assertEqual(
            ",".join(rows[0]),
            "step,fx,fy,fz,mx,my,mz,fn_elastic,fn_total,slip,active,stored_energy,dissipated_energy,"
            "shear_x,shear_y,shear_z,moisture",
        )
        self.assertEqual([row["step"] for row in rows[:3]], ["1", "2", "3"])

    def test_csv_as_spreadsheets_write_it(self):
        law = HERTZ + PAIR
        plain = self.drive(law, HEADER + STEP)
        bom = "\ufeff# a remark\r\n\r\n" + HEADER.replace("\n", "\r\n") + " 1e-6 ,\t1e-4 ,0,0,+1,0,0,-1.0 \r\n\r\n"
        self.assertEqual(self.drive(law, bom), plain)
        self.assertEqual(self.drive(law, HEADER + STEP.rstrip("\n")), plain)  # no newline at the end
        other_order = "vz,vy,vx,nz,ny,nx,overlap,dt\n-1,0,0,1,0,0,1e-4,1e-6\n"
        self.assertEqual(self.drive(law, other_order), plain)

    def test_length_of_the_normal_does_not_matter(self):
        plain = self.drive(HERTZ + FORCE + PAIR, HEADER + "1,1e-4,3,0,4,1e-6,0,0\n")
        for normal in ("0.6,0,0.8", "3e200,0,4e200", "3e-200,0,4e-200"):
            scaled = self.drive(HERTZ + FORCE + PAIR, HEADER + f"1,1e-4,{normal},1e-6,0,0\n")
            for column in ("fx", "fz"):
                self.assert_close(scaled[0][column], float(plain[0][column]), 1e-15)

    def test_without_a_file_the_rows_go_to_the_standard_output(self):
        law, path = self.file("law.toml", HERTZ + PAIR), self.file("path.csv", HEADER + STEP)
        result = run(law, path)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual(rows_of(result.stdout), self.drive(HERTZ + PAIR, HEADER + STEP))

    def test_list_and_help(self):
        result = run("--list")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        names = """linear hertz pohrt_popov pohrt_popov_elasto_plastic pohrt_popov_incremental none dashpots force
            force_rescaled displacement displacement_rescaled constant_ratio suction wet damping_constant restitution
            tension friction rotation project project_restore rotate fractal_dimension roughness seed_force stiffness modulus
            effective_radius effective_young effective_shear effective_mass min_radius length poisson density plane fixed rigid make_wet dissipated_energy
            kg/m^3 [0, (-1, 0.5] (0, 1]""".split()
        for name in names:
            self.assertIn(name, result.stdout)
        self.assertEqual(run("--help").returncode, 0)


class Notes(InTemporaryDirectory):
    """Inputs that are allowed but probably not meant: exit code 0, the rows, and a note on the standard error."""

    def notes(self, law, path):
        result = run(self.file("law.toml", law), self.file("path.csv", path))
        self.assertEqual(result.returncode, 0)
        self.assertGreater(len(rows_of(result.stdout)), 0)
        return result.stderr

    def test_a_contact_that_never_touches(self):
        opening = "".join(f"1e-6,-{i}e-5,0,0,1,0,0,-10\n" for i in (1, 2, 3))
        self.assertIn("path.csv: note: the contact is open in every step", self.notes(HERTZ + PAIR, HEADER + opening))
        bridge = '[bridge]\nlaw = "suction"\nsuction = 1\nwet = true\n'
        self.assertNotIn("open in every step", self.notes(HERTZ + bridge + PAIR, HEADER + opening))

    def test_overlap_and_velocity_that_contradict_each_other(self):
        grows = "".join(f"1e-6,{i}e-5,0,0,N,0,0,-10\n" for i in (1, 2, 3))
        self.assertEqual(self.notes(HERTZ + PAIR, HEADER + grows.replace("N", "1")), "")
        self.assertIn("note: the overlap grows where the velocity separates", self.notes(HERTZ + PAIR, HEADER + grows.replace("N", "-1")))

    def test_an_overlap_beyond_the_smaller_radius(self):
        deep = HEADER + STEP + STEP.replace("1e-4", "{}")
        self.assertEqual(self.notes(HERTZ + PAIR, deep.format("4.9e-3")), "")
        self.assertIn("path.csv:3: note: the overlap is larger", self.notes(HERTZ + PAIR, deep.format("5.1e-3")))

    def test_friction_as_an_angle(self):
        self.assertIn("law.toml:4:12: note: [shear] friction is 30", self.notes(HERTZ + FORCE.replace("0.4", "30") + PAIR, HEADER + STEP))
        for coefficient in ("0.4", "10", "100"):
            self.assertEqual(self.notes(HERTZ + FORCE.replace("0.4", coefficient) + PAIR, HEADER + STEP), "")

    def test_progress_of_a_long_run(self):
        law = law_text("memo_hill_dashpots")
        path = HEADER + STEP * 300000  # some 4 s; the first second has no progress
        result = run(self.file("law.toml", law), self.file("path.csv", path), "-o", self.directory / "out.csv", "--precision", "200")
        self.assertIn("contact_path: ", result.stderr)
        self.assertIn(" %", result.stderr)


class Faults(InTemporaryDirectory):
    """Exit code 2, a message that names what is wrong, and nothing left behind."""

    def refuse(self, law, path, *words, arguments=()):
        law_file = self.file("law.toml", law) if law is not None else self.directory / "law.toml"
        path_file = self.file("path.csv", path) if path is not None else self.directory / "path.csv"
        before = sorted(os.listdir(self.directory))
        result = run(law_file, path_file, "-o", self.directory / "out.csv", *arguments)
        with self.subTest(words=words):
            self.assertEqual(result.returncode, 2)
            self.assertEqual(result.stdout, "")
            for word in words:
                self.assertIn(word, result.stderr)
            self.assertEqual(sorted(os.listdir(self.directory)), before)

    def refuse_law(self, law, *words):
        self.refuse(law, HEADER + STEP, *words)

    def refuse_path(self, path, *words):
        self.refuse(HERTZ + FORCE + PAIR, path, *words)

    def test_law_files(self):
        dashpots = '[damping]\nlaw = "dashpots"\n'
        linear = '[normal]\nlaw = "linear"\n'
        rough = '[normal]\nlaw = "pohrt_popov"\nfractal_dimension = 2.1\nroughness = 1e-6\n'
        self.refuse(None, HEADER + STEP, "law.toml: cannot be opened")
        self.refuse_law("", "law.toml: normal is missing", "linear, hertz")
        self.refuse_law("normal = hertz\n", "law.toml:1:")
        self.refuse_law("normal = 3\n", "law.toml:1:10: [normal] law is 3", "linear, hertz")
        self.refuse_law('normal = "herz"\n', 'law.toml:1:10: [normal] law is "herz"', "must be one of linear, hertz")
        self.refuse_law("[normal]\n", "law.toml:1:1: [normal] law is missing")
        self.refuse_law(HERTZ + "friktion = 1\n" + PAIR, "law.toml:2:1:", "'friktion'", "normal, damping, shear")
        self.refuse_law(HERTZ + FORCE + "frction = 1\n" + PAIR, "law.toml:5:11: [shear] force", "'frction'", "friction")
        self.refuse_law(HERTZ + '[shear]\nlaw = "force"\n' + PAIR, "law.toml:2:1: [shear] friction is missing", "[0, inf)")
        self.refuse_law(HERTZ + FORCE.replace("0.4", "-0.5") + PAIR, "law.toml:4:12: [shear] friction is -0.5", "[0, inf)")
        self.refuse_law(HERTZ + FORCE.replace("friction =", "friction_angle =") + PAIR, "'friction_angle'", "tangent of the angle")
        self.refuse_law(linear + "stiffness = 1\n" + FORCE + 'stiffness = "mindlin"\n', "[shear] stiffness", "no contact radius")
        self.refuse_law('normal = "jrk"\n' + PAIR, 'law.toml:1:10: [normal] law is "jrk"', "linear, hertz, dmt, jkr")
        self.refuse_law(HERTZ + '[rolling]\nlaw = "spring"\n' + PAIR, "[rolling] rolling_friction is missing")
        self.refuse_law(HERTZ + FORCE.replace("0.4", "nan") + PAIR, "law.toml:4:12: [shear] friction is 'nan'", "[0, inf)")
        self.refuse_law(HERTZ + FORCE.replace("0.4", "inf") + PAIR, "law.toml:4:12: [shear] friction is 'inf'", "[0, inf)")
        self.refuse_law(HERTZ + FORCE.replace("0.4", '"a"') + PAIR, "law.toml:4:12: [shear] friction is '\"a\"'", "number")
        self.refuse_law(HERTZ + FORCE + 'rotation = "spin"\n' + PAIR, "law.toml:5:12: [shear] rotation", "project_restore")
        self.refuse_law(HERTZ + '[bridge]\nlaw = "suction"\nsuction = 1\nwet = 1\n' + PAIR, "law.toml:5:7: [bridge] wet", "true or")
        self.refuse_law(rough.replace("2.1", "3.5") + PAIR, "law.toml:3:21:", "fractal_dimension is 3.5", "[2, 3]")
        self.refuse_law(rough.replace("1e-6", "0") + PAIR, "law.toml:4:13:", "roughness is 0 m", "(0, inf)")
        self.refuse_law(rough.replace("roughness = 1e-6\n", "") + PAIR, "roughness is missing", "(0, inf) m")
        self.refuse_law(HERTZ + dashpots + PAIR, "law.toml:2:1:", "one of damping_constant, restitution", "none")
        self.refuse_law(HERTZ + dashpots + "damping_constant = 1\nrestitution = 1\n" + PAIR, "restitution, and has more")
        self.refuse_law(HERTZ + dashpots + "restitution = 0\n" + PAIR, "law.toml:4:15: [damping] restitution is 0", "(0, 1]")
        self.refuse_law(rough + dashpots + "restitution = 0.5\n" + PAIR, "law.toml:7:15:", "beside pohrt_popov")
        self.refuse_law(linear + PAIR, "one of stiffness, modulus")
        self.refuse_law(linear + "stiffness = 1\nmodulus = 1\n" + PAIR, "one of stiffness, modulus", "more")
        self.refuse_law(HERTZ + FORCE + "ratio = 1\n" + PAIR, "law.toml:5:9: [shear] ratio", "constant_ratio")
        self.refuse_law(HERTZ + '[damping]\nlaw = "none"\ntension = "clipped"\n' + PAIR, "no key 'tension'; it has none")
        self.refuse_law("x" * 100 + "\n", "law.toml:")
        self.refuse_law(b"\xff\xfe\x00", "law.toml:")
        self.refuse_law(HERTZ + HERTZ, "law.toml:2:")
        self.refuse_law(HERTZ + "[pair]\neffective_radius = 1e-3\n", "law.toml:2:1: [pair] effective_young is missing", "Pa", "[normal] hertz")
        self.refuse_law(HERTZ + "pair = 1\n", "law.toml:2:8: pair must be a table")
        self.refuse_law(HERTZ, "[pair] effective_radius is missing")
        self.refuse_law(HERTZ + PAIR.replace("3e-3", "-3e-3"), "[pair] effective_radius is -3e-3 m", "(0, inf)")
        self.refuse_law(linear + "modulus = 1\n", "[pair] min_radius is missing", "modulus")
        self.refuse_law(linear + "stiffness = 1\n" + FORCE, "[pair] effective_young is missing", "without a ratio")
        self.refuse_law(HERTZ + FORCE + "[pair]\neffective_radius = 1\neffective_young = 1\n", "[pair] effective_shear is missing", "Mindlin")

    def test_bodies(self):
        body = "radius = 1e-3\nyoung = 1e9\npoisson = 0.3\ndensity = 1000\n"

        def refuse(body1, body2, *words):
            self.refuse_law(f"{HERTZ}[pair.body1]\n{body1}[pair.body2]\n{body2}", *words)

        self.refuse_law(HERTZ + "[pair.body1]\n" + body, "[pair] body2 is missing")
        self.refuse_law(HERTZ + "[pair]\neffective_radius = 1\n[pair.body1]\n" + body + "[pair.body2]\n" + body, "cannot have 'effective_radius'")
        refuse(body, body.replace("0.3", "0.7"), "law.toml:10:11: [pair.body2] poisson is 0.7", "(-1, 0.5]")
        refuse(body, body.replace("poisson = 0.3\n", ""), "law.toml:7:1: [pair.body2] poisson is missing")
        refuse(body, body.replace("density = 1000\n", ""), "[pair.body2] density is missing")
        refuse(body, body + "mass = 1\n", "[pair.body2] density is given, but so is mass")
        refuse(body, body + "plane = true\n", "[pair.body2] radius is given, but a plane has none")
        refuse(body + "rigid = true\n", body + "rigid = true\n", "one side must deform")
        refuse(body + "fixed = true\n", body + "fixed = true\n", "one side must be free")
        refuse(body, body + "colour = 1\n", "no key 'colour'", "radius, young, poisson")

    def test_path_files(self):
        self.refuse(HERTZ + PAIR, None, "path.csv: cannot be opened")
        self.refuse_path("", "path.csv: is empty", "dt, overlap, nx")
        self.refuse_path("# only a remark\n", "path.csv: is empty")
        self.refuse_path(HEADER, "path.csv:1: has a header but no steps")
        self.refuse_path(STEP, "path.csv:1:1: the header is missing", "'1e-6'")
        self.refuse_path("dt;overlap\n1;2\n", "path.csv:1:1: no such column: 'dt;overlap'", "commas")
        self.refuse_path(HEADER.replace("vz", "v_z") + STEP, "path.csv:1:27: no such column: 'v_z'", "dt, overlap, nx")
        self.refuse_path(HEADER.replace("vz", "vx") + STEP, "path.csv:1:27: column vx is named twice")
        self.refuse_path(HEADER.replace(",vz", "") + STEP, "path.csv:1: column vz is missing")
        self.refuse_path(HEADER + STEP + "\n" + STEP.replace("1e-4", "1e-4x"), "path.csv:4:6: column overlap is '1e-4x'", "number")
        self.refuse_path(HEADER + STEP.replace("1e-4", "nan"), "path.csv:2:6: column overlap is 'nan'", "(-inf, inf) m")
        self.refuse_path(HEADER + STEP.replace("1e-4", "inf"), "path.csv:2:6: column overlap is 'inf'")
        self.refuse_path(HEADER + STEP.replace("1e-4", "0x1"), "path.csv:2:6: column overlap is '0x1'")
        self.refuse_path(HEADER + STEP.replace("1e-4", "1e999"), "path.csv:2:6: column overlap is 1e999 m", "(-inf, inf)")
        self.refuse_path(HEADER + STEP.replace("1e-4", ""), "path.csv:2:6: column overlap is ''")
        self.refuse_path(HEADER + STEP.replace("1e-6", "-1e-6"), "path.csv:2:1: column dt is -1e-6 s", "[0, inf)")
        self.refuse_path(HEADER + STEP.replace("0,0,1,", "0,0,0,"), "path.csv:2: the normal (nx, ny, nz) is zero")
        self.refuse_path(HEADER + STEP.replace("\n", ",5\n"), "path.csv:2: 9 cells", "8 columns")
        self.refuse_path(HEADER + "1e-6\n", "path.csv:2: 1 cells", "8 columns")
        self.refuse_path(HEADER.replace("\n", ",make_wet\n") + STEP.replace("\n", ",1e-3\n"), "path.csv:2:", "no bridge")
        self.refuse_path(HEADER + STEP.replace("1e-4", "'" + "9" * 10000), "path.csv:2:6:", "999...'")
        self.refuse_path(HEADER + STEP.replace("1e-4", "\0"), "path.csv:2:6:", "'?'")
        self.refuse_path(b"\x89PNG\r\n\x1a\n\0\0\xff", "path.csv:1:1: no such column")

    def test_results_beyond_the_range(self):
        self.refuse_path(HEADER + STEP.replace("1e-4", "1e300"), "path.csv:2: the force or the energy is out of the range")
        self.refuse(HERTZ + PAIR, HEADER + STEP.replace("1e-4", "1e39"), "too large for this precision",
                    arguments=("--precision", "float"))
        self.refuse(HERTZ + PAIR.replace("14e9", "14e99"), HEADER + STEP, "law.toml:", "too large for this precision",
                    arguments=("--precision", "float"))

    def test_arguments(self):
        law, path = self.file("law.toml", HERTZ + PAIR), self.file("path.csv", HEADER + STEP)
        for arguments in ([], [law], [law, path, "more"], [law, path, "--precision", "half"], [law, path, "--what"]):
            result = run(*arguments)
            self.assertEqual((result.returncode, result.stdout), (2, ""), arguments)
            self.assertNotEqual(result.stderr, "")

    def test_output(self):
        law, path = self.file("law.toml", HERTZ + PAIR), self.file("path.csv", HEADER + STEP)
        bad = self.file("bad.csv", HEADER + STEP + "1\n")
        kept = self.file("out.csv", "precious")

        def refused(path_file, out, *words):
            before = sorted(os.listdir(self.directory))
            result = run(law, path_file, "-o", out)
            self.assertEqual(result.returncode, 2)
            for word in words:
                self.assertIn(word, result.stderr)
            self.assertEqual(sorted(os.listdir(self.directory)), before)

        refused(bad, kept, "bad.csv:3: 1 cells")
        self.assertEqual(kept.read_text(), "precious")
        refused(path, self.directory / "nowhere" / "out.csv", "nowhere/out.csv: cannot be written")
        refused(path, self.directory, "is not a plain file")
        refused(path, "/dev/null", "/dev/null: is not a plain file")
        refused(path, path, "path.csv: is also an input")
        refused(path, law, "law.toml: is also an input")
        self.assertEqual(run(law, path, "-o", kept).returncode, 0)
        self.assertTrue(kept.read_text().startswith("step,"))
        self.assertEqual(sorted(os.listdir(self.directory)), ["bad.csv", "law.toml", "out.csv", "path.csv"])
        self.assertEqual(run(law, self.directory).returncode, 2)

    @unittest.skipUnless(os.path.exists("/dev/full"), "needs /dev/full")
    def test_full_disk(self):
        law, path = self.file("law.toml", HERTZ + PAIR), self.file("path.csv", HEADER + STEP)
        with open("/dev/full", "w") as full:
            result = subprocess.run([PROGRAM, law, path], stdout=full, stderr=subprocess.PIPE, text=True)
        self.assertEqual(result.returncode, 2)
        self.assertIn("cannot be written", result.stderr)


if __name__ == "__main__":
    PROGRAM = str(Path(sys.argv.pop(1)).resolve())
    unittest.main()
