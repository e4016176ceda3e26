#!/usr/bin/env python3
"""The files that drop and memo write for ParaView, read by VTK itself.

    check_vtk.py DROP MEMO [unittest options]

DROP and MEMO are the programs. Exits with 77 (skipped) where no Python here has VTK.
"""

import csv
import math
import os
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

try:
    import vtk
except ImportError:
    if sys.executable != "/usr/bin/python3" and os.path.exists("/usr/bin/python3"):  # Debian's package serves this one
        os.execv("/usr/bin/python3", ["/usr/bin/python3", *sys.argv])
    print("skipped: no Python here has VTK")
    sys.exit(77)

G = 9.81  # [m/s^2]


def read(file):
    """The data set of a .vtp file."""
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(str(file))
    reader.Update()
    if reader.GetErrorCode() != 0:
        raise AssertionError(f"{file}: {vtk.vtkErrorCode.GetStringFromErrorCode(reader.GetErrorCode())}")
    return reader.GetOutput()


def fields(data):
    return {data.GetPointData().GetArrayName(i) for i in range(data.GetPointData().GetNumberOfArrays())}


def field(data, name):
    array = data.GetPointData().GetArray(name)
    values = [array.GetTuple(i) for i in range(array.GetNumberOfTuples())]
    return [v[0] for v in values] if array.GetNumberOfComponents() == 1 else values


def points(data):
    return [data.GetPoint(i) for i in range(data.GetNumberOfPoints())]


def forces_by_place(contacts):
    """Sum of the forces at the ends of contacts that share a place."""
    sums = {}
    for place, force in zip(points(contacts), field(contacts, "force")):
        sums[place] = [a + b for a, b in zip(sums.get(place, (0.0, 0.0, 0.0)), force)]
    return sums


class Drop(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = Path(temporary.name)
        subprocess.run([PROGRAMS["drop"], cls.folder], check=True, stderr=subprocess.DEVNULL)

    def series(self, name):
        """Times and data sets of a .pvd file."""
        files = ElementTree.parse(self.folder / name).getroot().findall("Collection/DataSet")
        return [(float(entry.get("timestep")), read(self.folder / entry.get("file"))) for entry in files]

    def test_series(self):
        with (self.folder / "drop.csv").open() as file:
            times = [float(row["time_s"]) for row in csv.DictReader(file)]
        for name in ("balls.pvd", "contacts.pvd"):
            with self.subTest(name=name):
                series = self.series(name)
                self.assertEqual([time for time, _ in series], times)
                for _, data in series:  # or ParaView drops a field
                    self.assertEqual(fields(data), fields(series[0][1]))
        self.assertEqual(series[0][1].GetNumberOfPoints(), 0)  # the first frame has no contact

    def test_forces(self):
        """A ball's force is its weight and what the lines that end at its centre carry there."""
        for (_, balls), (_, contacts) in list(zip(self.series("balls.pvd"), self.series("contacts.pvd")))[::10]:
            carried = forces_by_place(contacts)
            largest = max(map(abs, (x for force in carried.values() for x in force)), default=0.0)
            for place, force, diameter in zip(points(balls), field(balls, "force"), field(balls, "diameter")):
                weight = math.pi / 6 * diameter**3 * 1200 * G
                at_ends = carried.get(place, (0.0, 0.0, 0.0))
                for a, b in zip(force, (at_ends[0], at_ends[1], at_ends[2] - weight)):
                    # Sums of a dozen terms in another order: 12 roundings of 1.1e-16 each.
                    self.assertAlmostEqual(a, b, delta=2e-15 * max(largest, weight))

    def test_tube_shows_force(self):
        """ParaView's Tube filter, its radius by an absolute scalar: each tube is as thick as its contact's force."""
        _, contacts = self.series("contacts.pvd")[-1]
        self.assertGreater(contacts.GetNumberOfLines(), 100)
        contacts.GetPointData().SetActiveScalars("normal_force")
        tube = vtk.vtkTubeFilter()
        tube.SetInputData(contacts)
        tube.SetNumberOfSides(8)
        tube.SetVaryRadiusToVaryRadiusByAbsoluteScalar()
        tube.Update()
        around = tube.GetOutput()
        self.assertEqual(around.GetNumberOfPoints(), 8 * contacts.GetNumberOfPoints())
        thickness = set()
        for i, (centre, force) in enumerate(zip(points(contacts), field(contacts, "normal_force"))):
            for side in range(8):
                radius = math.dist(around.GetPoint(8 * i + side), centre)
                self.assertAlmostEqual(radius, force, delta=1e-6)  # the filter works in float; positions are below 1
            thickness.add(round(force, 6))
        self.assertGreater(len(thickness), 50)


class Assembly(unittest.TestCase):
    """27 grains at rest on the bottom of a box, with the hill law between them and the linear law at walls."""

    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = Path(temporary.name)
        subprocess.run([PROGRAMS["memo"], cls.folder], check=True, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL)

    def test_grains(self):
        grains = read(self.folder / "assembly_after.vtp")
        with (self.folder / "assembly_after.csv").open() as file:
            places = [tuple(float(row[axis]) for axis in ("x_m", "y_m", "z_m")) for row in csv.DictReader(file)]
        self.assertEqual(points(grains), places)
        self.assertEqual(field(grains, "radius"), [5e-3] * 27)

    def test_columns(self):
        """Nine columns of three grains: between grains and at the bottom the weight of those above."""
        weight = 4 / 3 * math.pi * 5e-3**3 * 2650 * G
        between = read(self.folder / "assembly_contacts.vtp")
        self.assertLessEqual({"overlap", "normal_force", "shear_force", "bridge_force", "sliding", "moisture", "force"},
                             fields(between))
        at_walls = read(self.folder / "assembly_wall_contacts.vtp")
        self.assertNotIn("moisture", fields(at_walls))
        upright = [force for force in field(between, "normal_force") if force != 0.0]  # grains side by side just touch
        forces = sorted(upright) + field(at_walls, "normal_force")
        self.assertEqual(len(forces), 54)  # at both ends
        for force, grains in zip(forces, [1] * 18 + [2] * 18 + [3] * 18):
            # The scene is settled until the unbalanced force is 1e-9 of the contact forces; 1e-6 leaves room for their ratio.
            self.assertAlmostEqual(force, grains * weight, delta=1e-6 * weight)
        for place, force in zip(points(at_walls), field(at_walls, "force")):
            self.assertAlmostEqual(abs(force[2]), 3 * weight, delta=1e-6 * weight)
            # The contact point is the middle of the overlap, below 1e-6 m.
            self.assertAlmostEqual(place[2], 0.0 if force[2] < 0 else 5e-3, delta=1e-6)


if __name__ == "__main__":
    PROGRAMS = {"drop": Path(sys.argv.pop(1)).resolve(), "memo": Path(sys.argv.pop(1)).resolve()}
    unittest.main()
