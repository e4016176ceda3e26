#!/usr/bin/env python3
"""Runs a program from outside, as its user does: arguments, results, a full disk, an interrupt.

    check.py PROGRAM [unittest options]

PROGRAM is the file of memo, contact_curves, verify_your_law, drop or record_grains.
"""

import csv
import json
import math
import os
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

PROGRAM = Path()
FULL = Path("/dev/full")
# Of each program: arguments that name the output, the options of a short run, and one of its output files.
OUTPUTS = {
    "memo": ("{folder}", [], "memo.json"),
    "contact_curves": ("{folder}", [], "ballast.csv"),
    "verify_your_law": ("{folder}", [], "rigid_spin.csv"),
    "drop": ("{folder}", ["--time", "0.01"], "balls_0000.vtp"),
    "record_grains": ("{folder}/grains.csv", [], "grains.csv"),
}


def run(*arguments, **options):
    options = {"stdout": subprocess.PIPE, **options}
    return subprocess.run([PROGRAM, *map(str, arguments)], stderr=subprocess.PIPE, text=True, timeout=300, **options)


def is_named(*names):
    return PROGRAM.name in names


class InTemporaryDirectory(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.directory = Path(temporary.name)
        output, self.short, self.name = OUTPUTS[PROGRAM.name]
        self.output = output.format(folder=self.directory)

    def names(self):
        return sorted(os.listdir(self.directory))


class Arguments(InTemporaryDirectory):
    def test_help(self):
        result = run("--help", cwd=self.directory)
        self.assertEqual(result.returncode, 0)
        self.assertIn("Usage", result.stdout)
        self.assertEqual(self.names(), [])

    def test_unknown_and_extra_arguments(self):
        for arguments in ([self.output, "--nonsense"], [self.output, "another"]):
            with self.subTest(arguments=arguments):
                result = run(*arguments, cwd=self.directory)
                self.assertEqual(result.returncode, 2)
                self.assertIn(arguments[-1], result.stderr)
                self.assertEqual(self.names(), [])

    def test_folder_that_cannot_be_written(self):
        (self.directory / "file").write_text("")
        for folder in (self.directory / "file" / "folder", "/proc/nowhere"):
            with self.subTest(folder=folder):
                output = OUTPUTS[PROGRAM.name][0].format(folder=folder)
                result = run(output, *self.short)
                self.assertEqual(result.returncode, 2)
                self.assertIn(f"{PROGRAM.name}: {output}: ", result.stderr)
                self.assertRegex(result.stderr, "cannot be (created|written)")


@unittest.skipUnless(FULL.exists(), "needs /dev/full")
class FullDisk(InTemporaryDirectory):
    def check_refusal(self, result, message):
        self.assertEqual(result.returncode, 2)
        self.assertIn(message, result.stderr)
        self.assertNotIn("All numbers are right", result.stdout or "")

    def test_one_file_does_not_fit(self):
        """Then no result of an earlier run changes."""
        if is_named("verify_your_law"):
            (self.directory / self.name).symlink_to(FULL)
            self.check_refusal(run(self.output), f"{self.name}: cannot be written")
            return
        earlier = self.directory / self.name
        earlier.write_text("of an earlier run")
        (self.directory / f"{self.name}.partial").symlink_to(FULL)
        self.check_refusal(run(self.output, *self.short), f"{self.name}: cannot be written")
        self.assertEqual(self.names(), [self.name])
        self.assertEqual(earlier.read_text(), "of an earlier run")

    def test_file_is_a_device(self):
        if is_named("verify_your_law"):
            self.skipTest("writes to it, above")
        (self.directory / self.name).symlink_to(FULL)
        self.check_refusal(run(self.output, *self.short), f"{self.name}: is not a plain file")

    def test_standard_output(self):
        with FULL.open("w") as full:
            arguments = [self.output] if is_named("memo", "verify_your_law") else ["--help"]
            result = run(*arguments, stdout=full)
        self.check_refusal(result, "the standard output cannot be written")


class Interrupt(InTemporaryDirectory):
    def interrupted(self, sent):
        """Exit status and standard output of a run that gets the signal when it has opened its output."""
        process = subprocess.Popen([PROGRAM, self.output], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        while process.poll() is None and not any(name.endswith(".partial") for name in self.names()):
            time.sleep(0.001)
        process.send_signal(sent)
        output, _ = process.communicate(timeout=300)
        return process.returncode, output

    def test_earlier_results_stay(self):
        if is_named("verify_your_law"):
            self.skipTest("ends within a second")
        earlier = self.directory / self.name
        for sent, status in ((signal.SIGINT, 130), (signal.SIGTERM, 143)):
            with self.subTest(signal=sent):
                for _ in range(20):  # a run may end before the signal arrives
                    for name in self.names():
                        (self.directory / name).unlink()
                    earlier.write_text("of an earlier run")
                    returned, output = self.interrupted(sent)
                    if returned != 0:
                        break
                self.assertEqual(returned, status)
                self.assertNotIn("All numbers are right", output)
                self.assertEqual(self.names(), [self.name])
                self.assertEqual(earlier.read_text(), "of an earlier run")


class Results(InTemporaryDirectory):
    def rows(self, name):
        with (self.directory / name).open() as file:
            return list(csv.DictReader(file))

    def test_numbers(self):
        """The programs compare their numbers with closed forms and say so in their exit status."""
        if not is_named("memo", "contact_curves"):
            self.skipTest("has no table of numbers")
        result = run(self.output)
        self.assertEqual(result.returncode, 0)
        self.assertIn("All numbers are right.", result.stdout)
        for name in ("memo", "eight_laws") if is_named("memo") else ("ballast",):
            numbers = json.loads((self.directory / f"{name}.json").read_text())
            self.assertGreater(len(numbers), 10)
            self.assertTrue(all(number["pass"] for number in numbers))
            self.assertEqual([row["id"] for row in self.rows(f"{name}.csv")], [number["id"] for number in numbers])
        self.assertEqual([name for name in self.names() if name.endswith(".partial")], [])

    def test_paths_of_the_faults(self):
        if not is_named("verify_your_law"):
            self.skipTest("finds no faults")
        self.assertEqual(run(self.directory / "new" / "folder").returncode, 0)
        names = sorted(os.listdir(self.directory / "new" / "folder"))
        for name in ("rigid_spin.csv", "Coulomb_bound.csv", "change_of_owner.csv"):
            self.assertIn(name, names)

    def test_recording(self):
        if not is_named("record_grains"):
            self.skipTest("records nothing")
        self.assertEqual(run(self.output).returncode, 0)
        rows = self.rows(self.name)
        self.assertGreater(len(rows), 100)
        self.assertEqual(list(rows[0])[:3], ["contact", "dt", "overlap"])

    def test_drop(self):
        if not is_named("drop"):
            self.skipTest("drops nothing")
        self.assertEqual(run(self.output, "--time", "0.8").returncode, 0)
        rows = [{name: float(value) for name, value in row.items()} for row in self.rows("drop.csv")]
        frames = sorted(self.directory.glob("balls_*.vtp"))
        self.assertEqual((len(rows), len(frames)), (51, 51))

        energy = [row["energy_J"] for row in rows]
        # A shear force that is held while the overlap vibrates stores or releases a little: 4e-10 of the energy at the start.
        self.assertLess(max(after - before for before, after in zip(energy, energy[1:])), 1e-8 * energy[0])
        self.assertLess(energy[-1], 0.6 * energy[0])  # most of the height is lost

        # At rest: only a ball that touches no other may still roll, slowly, since DryHill has no rolling resistance.
        self.assertLess(rows[-1]["fastest_m_per_s"], 0.01 * max(row["fastest_m_per_s"] for row in rows))
        arrays = {array.get("Name"): array.text.strip().split("\n")
                  for array in ElementTree.parse(frames[-1]).iter("DataArray")}
        positions = [[float(x) for x in line.split()] for line in arrays["points"]]
        diameters = [float(line) for line in arrays["diameter"]]
        self.assertEqual((len(positions), len(diameters)), (100, 100))
        for (x, y, z), diameter in zip(positions, diameters):
            # Walls yield by the overlap: under the weight of all balls on one, 0.6 N, Hertz gives 0.05 mm.
            inside = 0.03 - diameter / 2 + 5e-5
            self.assertLess(abs(x), inside)
            self.assertLess(abs(y), inside)
            self.assertGreater(z, diameter / 2 - 5e-5)

        weight = sum(math.pi / 6 * d**3 * 1200 * 9.81 for d in diameters)
        # What is missing is the balls' vertical acceleration: vibrations that the dashpots have not yet damped.
        self.assertAlmostEqual(rows[-1]["force_on_box_N"], weight, delta=1e-2 * weight)


if __name__ == "__main__":
    PROGRAM = Path(sys.argv.pop(1)).resolve()
    unittest.main()
