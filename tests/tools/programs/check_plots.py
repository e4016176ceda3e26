#!/usr/bin/env python3
"""Runs examples/contact_path/plot_path.py and the figure scripts from outside: tolerances, and messages for bad input.

    check_plots.py [unittest options]

Exits with 77 (skipped) where no Python here has matplotlib.
"""

import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

EXAMPLES = Path(__file__).resolve().parents[3] / "examples"
PLOT_PATH = EXAMPLES / "contact_path" / "plot_path.py"
OUT = "step,fx,fy,fz\n1,0,0,1\n2,0,0,2\n"
PATH = "dt,overlap,nx,ny,nz,vx,vy,vz\n1e-6,1e-4,0,0,1,0,0,-1\n1e-6,2e-4,0,0,1,0,0,-1\n"
NUMBERS = "id,unit,source,published,expected,computed,relative_error,tolerance,pass\na,N,Eq. 1,,1,1,0,1e-9,yes\n"
FULL = Path("/dev/full")


def python_with_matplotlib():
    for python in (sys.executable, "/usr/bin/python3"):
        if subprocess.run([python, "-c", "import matplotlib"], stderr=subprocess.DEVNULL).returncode == 0:
            return python
    print("skipped: no Python here has matplotlib")
    sys.exit(77)


PYTHON = python_with_matplotlib()


class InTemporaryDirectory(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.directory = Path(temporary.name)
        self.out = self.file("out.csv", OUT)

    def file(self, name, text):
        (self.directory / name).write_bytes(text if isinstance(text, bytes) else text.encode())
        return self.directory / name

    def run_script(self, script, *arguments):
        return subprocess.run([PYTHON, script, *map(str, arguments)], capture_output=True, text=True, timeout=120)

    def check_refusal(self, result, message):
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertIn(message, result.stderr)
        self.assertNotIn("Traceback", result.stderr)


class PlotPath(InTemporaryDirectory):
    def plot(self, *arguments):
        return self.run_script(PLOT_PATH, *arguments)

    def test_figure(self):
        result = self.plot(self.out, "--path", self.file("path.csv", PATH))
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual((self.directory / "out.png").read_bytes()[1:4], b"PNG")

    def test_tolerance(self):
        mine = self.file("mine.csv", OUT.replace("0,0,2", "0,1e-3,2"))  # 1e-3 N of 2 N
        for tolerance, status in ((None, 0), ("6e-4", 0), ("4e-4", 1), ("0", 1)):
            with self.subTest(tolerance=tolerance):
                result = self.plot(self.out, mine, *(["--tolerance", tolerance] if tolerance else []))
                self.assertEqual(result.returncode, status)
                self.assertIn("largest difference 0.001 N at step 2, 0.0005 of the largest force", result.stdout)
        for tolerance in ("nan", "-1", "much"):
            result = self.plot(self.out, mine, "--tolerance", tolerance)
            self.check_refusal(result, "argument --tolerance")

    def test_difference_that_is_not_a_number(self):
        mine = self.file("mine.csv", OUT.replace("0,0,1", "0,0,nan"))
        for arguments in ((self.out, mine), (mine, self.out)):
            result = self.plot(*arguments)
            self.assertEqual(result.returncode, 1)
            self.assertIn("the difference is not a number", result.stderr)

    def test_zero_forces(self):
        zero = self.file("zero.csv", "fx,fy,fz\n0,0,0\n0,0,0\n")
        self.assertEqual(self.plot(zero, zero, "--tolerance", "0").returncode, 0)
        self.assertEqual(self.plot(zero, self.out, "--tolerance", "1").returncode, 1)

    def test_bad_input(self):
        mine = lambda text: self.file("mine.csv", text)
        for text, message in (("", "mine.csv: is empty"), ("fx,fy,fz\n", "mine.csv: has a header but no rows"),
                              (b"\xff\xfe\x00", "mine.csv: is not a text file"),
                              ("fx,fy\n1,2\n1,2\n", "mine.csv: column fz is missing"),
                              ("# remark\nfx,fy,fz\n1,2,3\n1,2\n", "mine.csv:4: 2 cells, but the header names 3 columns"),
                              ("fx,fy,fz\n1,2,3\n1,2,much\n", "mine.csv:3: column fz is 'much', must be a number"),
                              ("fx,fy,fz\n1,2,3\n1,2,\n", "mine.csv:3: column fz is '', must be a number"),
                              ("fx,fy,fz\n1,2,3\n", "mine.csv: 1 rows, but")):
            with self.subTest(text=text):
                self.check_refusal(self.plot(self.out, mine(text)), message)
        self.check_refusal(self.plot(self.directory / "nothing.csv"), "nothing.csv: cannot be read: No such file")
        path = self.file("path.csv", PATH.replace("2e-4,0,0,1", "2e-4,0,0,0"))
        self.check_refusal(self.plot(self.out, "--path", path), "path.csv:3: the normal (nx, ny, nz)")
        path = self.file("path.csv", PATH.replace("overlap", "depth"))
        self.check_refusal(self.plot(self.out, "--path", path), "path.csv: column overlap is missing")
        self.check_refusal(self.plot(self.out, "-o", "/nowhere/figure.png"), "/nowhere/figure.png: cannot be written")
        self.check_refusal(self.plot(self.out, "-o", self.directory / "figure.xyz"), "no such format of figures: xyz")

    @unittest.skipUnless(FULL.exists(), "needs /dev/full")
    def test_full_disk(self):
        (self.directory / "out.png").write_text("of an earlier run")
        (self.directory / "out.png.partial").symlink_to(FULL)
        self.check_refusal(self.plot(self.out), "out.png: cannot be written: No space left on device")
        self.assertEqual((self.directory / "out.png").read_text(), "of an earlier run")
        self.assertFalse(os.path.lexists(self.directory / "out.png.partial"))


class Figures(InTemporaryDirectory):
    """One script stands for both where examples/common/page.py does the work."""

    def figures(self, name, *arguments):
        return self.run_script(EXAMPLES / name / "figures.py", *arguments)

    def test_bad_input(self):
        self.check_refusal(self.figures("memo", self.directory), "memo.csv: cannot be read: No such file")
        self.file("memo.csv", NUMBERS.replace("1,1,0", "1,much,0"))
        self.check_refusal(self.figures("memo", self.directory), "memo.csv:2: column computed is 'much', must be a number")
        self.file("ballast.csv", NUMBERS)
        self.file("ballast_curves.csv", "overlap_m\n0\n")
        self.check_refusal(self.figures("ballast", self.directory),
                           "ballast.csv: no row has the id contact_curves.transition_force")

    def test_page(self):
        """Two balls over 51 frames: each link of the page leads to a part of it or to a file."""
        (self.directory / "drop").mkdir()
        fields = {"diameter": "1e-2 1e-2", "velocity": "0 0 0 0 0 -1", "points": "0 0 .05 0 .01 .05"}
        arrays = "".join(f'<DataArray Name="{name}">{text}</DataArray>' for name, text in fields.items())
        self.file("drop/frame.vtp", f"<VTKFile>{arrays}</VTKFile>")
        entries = "".join(f'<DataSet timestep="{i / 100}" file="frame.vtp"/>' for i in range(51))
        self.file("drop/balls.pvd", f"<VTKFile>{entries}</VTKFile>")
        self.file("drop/drop.csv", "time_s,energy_J,force_on_box_N\n0,1,0\n1,.5,.6\n")
        drawn = self.run_script(EXAMPLES / "drop_figures.py", self.directory)
        self.assertEqual((drawn.returncode, drawn.stderr), (0, ""))
        page = (self.directory / "index.html").read_text()
        links = re.findall('(?:href|src)="(.*?)"', page)
        self.assertEqual(set(links), {"#drop", "#drop_frames", "#drop_energy", "drop/drop.csv", "drop_frames.png", "drop_energy.png"})
        for link in links:
            self.assertTrue(f'id="{link[1:]}"' in page if link[0] == "#" else (self.directory / link).exists(), link)

        self.file("drop/balls.pvd", f"<VTKFile>{entries[:-9]}</VTKFile>")
        self.check_refusal(self.run_script(EXAMPLES / "drop_figures.py", self.directory), "balls.pvd: cannot be read: ")

    def test_arguments(self):
        self.assertEqual(self.figures("memo", "--help").returncode, 0)
        self.check_refusal(self.figures("ballast", "--nonsense"), "--nonsense")


if __name__ == "__main__":
    unittest.main()
