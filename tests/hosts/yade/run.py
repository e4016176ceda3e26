#!/usr/bin/env python3
"""examples/hosts/yade: laws of the C face in YADE, against closed forms and YADE's own MindlinPhys.

    run.py [LIBRARY] [unittest options]        LIBRARY: libcontactlaws.so; without it, it is built here with g++

Exit status 77 if YADE, or LIBRARY and what it is built with, is not there.
"""

import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
HOSTS = ROOT / "examples" / "hosts"
MINDLIN = ROOT / "examples" / "contact_path" / "laws" / "yade_mindlin.toml"
WORK = tempfile.TemporaryDirectory()

R1, R2, YOUNG, POISSON, OVERLAP, SHEAR = 7.5e-3, 5e-3, 29e9, 0.15, 0.1e-3, 99e-6
RADIUS = R1 * R2 / (R1 + R2)
NORMAL = 4 / 3 * YOUNG / 2 / (1 - POISSON**2) * math.sqrt(RADIUS * OVERLAP**3)  # 1083.304632 N
STICKING = 8 * YOUNG / 4 / (1 + POISSON) / (2 - POISSON) * math.sqrt(RADIUS * OVERLAP) * SHEAR  # 1478.271645 N

# Two spheres meet, off centre and spinning, and part again; prints their velocities and spins.
IMPACT = """
import sys
from math import atan
sys.path[:0] = {paths!r}
own, head_on = {own}, {head_on}
O.materials.append(FrictMat(young=29e9, poisson=0.15, frictionAngle=atan(0.4), density=2650))
O.bodies.append([sphere((0, 0, 0), 7.5e-3), sphere((0 if head_on else 4e-3, 0, 12.6e-3), 5e-3)])
if own:
    forces = [InteractionLoop([Ig2_Sphere_Sphere_ScGeom(avoidGranularRatcheting=False)], [Ip2_FrictMat_FrictMat_MindlinPhys()],
                              [Law2_ScGeom_MindlinPhys_Mindlin()])]
else:
    import contactlaws_engine
    from contactlaws import Law
    contactlaws_engine.law = Law(file={law!r})
    forces = contactlaws_engine.engines()
O.engines = [ForceResetter(), InsertionSortCollider([Bo1_Sphere_Aabb()]), *forces, NewtonIntegrator(damping=0)]
O.dt = 4e-8
below, above = O.bodies[0].state, O.bodies[1].state
below.vel, above.vel = (0, 0, 1), (0, 0, -1)
if not head_on:
    below.angVel, above.angVel = (30, -20, 10), (0, 50, -40)
for k in range(15000):
    O.step()
assert not any(i.isReal and i.phys.normalForce.norm() > 0 for i in O.interactions) and (below.pos - above.pos).norm() > 12.5e-3
if not own:
    assert len(contactlaws_engine.states) <= 1
print("velocities", *("%.17g" % x for v in (below.vel, above.vel, below.angVel, above.angVel) for x in v))
"""


def yade(script, **variables):
    environment = {**os.environ, "CONTACTLAWS_LIBRARY": LIBRARY, "PYTHONDONTWRITEBYTECODE": "1", **variables}
    result = subprocess.run(["yade", "-n", "-x", str(script)], capture_output=True, text=True, timeout=300, env=environment)
    return result.stdout + result.stderr


class Check(unittest.TestCase):
    def assert_close(self, value, expected, tolerance):
        self.assertLessEqual(abs(value - expected), tolerance * abs(expected), f"{value} instead of {expected}")

    def two_spheres(self, **variables):
        output = yade(HOSTS / "yade" / "two_spheres.py", **variables)
        lines = [line for line in output.splitlines() if line.startswith("normal")]
        self.assertEqual(len(lines), 2, output)
        return [float(x) for x in re.findall(r"-?\d+\.?\d*(?:e-?\d+)?", lines[1])]

    def impact(self, own, head_on):
        script = Path(WORK.name) / "impact.py"
        script.write_text(IMPACT.format(paths=[str(HOSTS / "yade"), str(HOSTS / "c")], law=str(MINDLIN), own=own, head_on=head_on))
        output = yade(script)
        found = re.search(r"^velocities (.*)$", output, re.MULTILINE)
        self.assertTrue(found, output)
        return [float(x) for x in found.group(1).split()]

    def test_two_spheres(self):
        """Ten digits are printed; the overlap is a sum of 10 000 moves, right to 1e-10."""
        for friction, shear in (("10", STICKING), ("0.4", 0.4 * NORMAL)):
            normal, sheared, torque1, torque2 = self.two_spheres(MU=friction)
            self.assert_close(normal, NORMAL, 1e-9)
            self.assert_close(sheared, shear, 1e-9)
            self.assert_close(torque1, (R1 - OVERLAP / 2) * shear, 1e-9)
            self.assert_close(torque2, (R2 - OVERLAP / 2) * shear, 1e-9)

    def test_own_law_of_the_host(self):
        """MindlinPhys multiplies shear by (R1 + R2)/distance, or does not; then it is our law, but for 2e-9 in how forces turn."""
        for own, shear in (("1", STICKING * (R1 + R2) / (R1 + R2 - OVERLAP)), ("2", STICKING)):
            normal, sheared, _, _ = self.two_spheres(MU="10", OWN=own)
            self.assert_close(normal, NORMAL, 1e-9)
            self.assert_close(sheared, shear, 5e-9)

    def test_laws_beyond_touch_are_refused(self):
        script = Path(WORK.name) / "refused.py"
        script.write_text(f"""
import sys
sys.path[:0] = {[str(HOSTS / "yade"), str(HOSTS / "c")]!r}
import contactlaws_engine
from contactlaws import Law
contactlaws_engine.law = Law("cohesive_powder", young=1e9, poisson=0.2, work_of_adhesion=0.1)
contactlaws_engine.engines()
""")
        self.assertIn("acts beyond touch", yade(script))

    def test_head_on_impact(self):
        """Velocities of two masses in the ratio of R^3, elastic. Leapfrog's error is of the second order in dt: 1e-8 at 1e-3 of the
        duration of the contact, 40 us."""
        m1, m2 = R1**3, R2**3
        velocities = self.impact(own=False, head_on=True)
        self.assertLess(abs(velocities[2] - ((m1 - m2) - 2 * m2) / (m1 + m2)), 1e-7)
        self.assertLess(abs(velocities[5] - ((m1 - m2) + 2 * m1) / (m1 + m2)), 1e-7)

    def test_oblique_impact_as_with_the_own_law(self):
        """With friction and spin. Our law turns the slip of a step by half of its spin about the normal, 9.4 rad/s times 20 ns; YADE
        does not. So the impulse of friction may differ by that share: it is at most 0.4 of the normal one, which changes a velocity
        by 4 m/s at most, and spins by 5/(2 R) times as much. A shear force that the spin does not turn differs by nine times
        these bounds."""
        ours, own = self.impact(own=False, head_on=False), self.impact(own=True, head_on=False)
        self.assertGreater(abs(ours[10] - 50), 10)  # friction acts
        velocities = 9.4 * 20e-9 * 0.4 * 4
        for a, b in zip(ours[:6], own[:6]):
            self.assertLess(abs(a - b), velocities)
        for a, b in zip(ours[6:], own[6:]):
            self.assertLess(abs(a - b), 2.5 / R2 * velocities)


if __name__ == "__main__":
    if not shutil.which("yade"):
        print("skipped: yade is not installed")
        sys.exit(77)
    if len(sys.argv) > 1 and not sys.argv[1].startswith("-") and os.path.exists(sys.argv[1]):
        LIBRARY = os.path.abspath(sys.argv.pop(1))
    elif shutil.which("g++") and os.path.isdir("/usr/include/eigen3") and os.path.exists("/usr/include/toml++/toml.h"):
        LIBRARY = os.path.join(WORK.name, "libcontactlaws.so")
        subprocess.run(["sh", ROOT / "tests" / "hosts" / "library.sh", LIBRARY], check=True)
    else:
        print("skipped: no library given, and g++, libeigen3-dev and libtomlplusplus-dev are not all installed")
        sys.exit(77)
    unittest.main()
