#!/usr/bin/env python3
"""Draws the results of contact_path. Of several files it also prints the difference of each from the first.

    python3 plot_path.py OUT.csv [MINE.csv ...] [--path PATH.csv] [--tolerance 1e-6] [-o FIGURE.png]

MINE.csv may come from another program: it needs the columns fx, fy, fz, and as many rows. With PATH.csv the normal force is
drawn over the overlap, and the normals of a MINE.csv without fn_total are known.

Exit status: 0; 1 if a difference is larger than the tolerance, or is not a number; 2 on a fault in the input.
"""

import argparse
import math
import sys
from pathlib import Path

try:
    import numpy as np
except ImportError:
    sys.exit("plot_path.py: this Python has no numpy; on Debian and Ubuntu: apt-get install python3-matplotlib, and /usr/bin/python3")

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "common"))
from files import Table, fail, write_figure  # noqa: E402


def vectors(table, names):
    """Three columns, a row a step."""
    return np.column_stack([table.numbers(name) for name in names])


def normal_and_shear(force, table, normals):
    """Normal and shear force [N]; None where neither the file nor the path gives the normal."""
    if normals is not None:
        normal = np.sum(force * normals, axis=1)
        return normal, np.linalg.norm(force - normal[:, None] * normals, axis=1)
    if "fn_total" in table:
        normal = np.array(table.numbers("fn_total"))
        return normal, np.sqrt(np.clip(np.sum(force**2, axis=1) - normal**2, 0, None))
    return None, None


def read_path(file, steps):
    """Overlaps and unit normals."""
    path = Table(file)
    if len(path) != steps:
        fail(file, f"{len(path)} rows, but the results have {steps}")
    normals = vectors(path, ("nx", "ny", "nz"))
    lengths = np.linalg.norm(normals, axis=1)
    for (line, _), length in zip(path.cells, lengths):
        if not 0 < length < math.inf:
            fail(f"{file}:{line}", "the normal (nx, ny, nz) must have a direction")
    return np.array(path.numbers("overlap")), normals / lengths[:, None]


def differences_are_small(files, forces, tolerance):
    """Prints the largest difference of each file from the first. Whether all are within the tolerance."""
    first, small = forces[0], True
    largest = np.max(np.linalg.norm(first, axis=1))
    for file, force in zip(files[1:], forces[1:]):
        difference = np.linalg.norm(force - first, axis=1)
        worst = int(np.argmax(difference))  # the first NaN, if there is one
        relative = difference[worst] / largest if largest > 0 else math.inf if difference[worst] > 0 else difference[worst]
        print(f"{file}: largest difference {difference[worst]:.6g} N at step {worst + 1}, {relative:.3g} of the largest force")
        if not relative <= tolerance:
            print(f"{file}: the difference is {'larger than the tolerance' if relative > tolerance else 'not a number'}", file=sys.stderr)
            small = False
    return small


def tolerance_of(text):
    value = float(text)
    if not 0 <= value < math.inf:
        raise ValueError
    return value


def draw(files, tables, forces, overlap, normals):
    """Normal force, shear force and energy."""
    import matplotlib  # here, since it takes a second to load

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    plt.rcParams.update({"axes.grid": True, "grid.alpha": 0.3, "axes.spines.top": False, "axes.spines.right": False})
    figure, (left, middle, right) = plt.subplots(1, 3, figsize=(12, 3.6), layout="constrained")
    for i, (file, table, force) in enumerate(zip(files, tables, forces)):
        normal, shear = normal_and_shear(force, table, normals)
        if normal is None:
            continue
        step, style, label = np.arange(1, len(force) + 1), "-" if i == 0 else "--", Path(file).stem
        left.plot(step if overlap is None else 1e6 * overlap, normal, style, label=label)
        middle.plot(step, shear, style, label=label)
        if i == 0 and "slip" in table and any(table.numbers("slip")):
            middle.fill_between(step, 0, 1, where=np.array(table.numbers("slip")) > 0, alpha=0.15, color="tab:red", linewidth=0,
                                transform=middle.get_xaxis_transform(), label="sliding")
        if "stored_energy" in table and "dissipated_energy" in table:
            right.plot(step, table.numbers("stored_energy"), style, color=f"C{2 * i}", label=f"{label}: stored")
            right.plot(step, table.numbers("dissipated_energy"), style, color=f"C{2 * i + 1}", label=f"{label}: dissipated")
    left.set(xlabel="step" if overlap is None else "overlap [µm]", ylabel="normal force [N]")
    middle.set(xlabel="step", ylabel="shear force [N]")
    right.set(xlabel="step", ylabel="energy [J]")
    for axes in (left, middle, right):
        if axes.get_legend_handles_labels()[0]:
            axes.legend(fontsize=8)
    return figure


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", nargs="+", metavar="OUT.csv")
    parser.add_argument("--path", metavar="PATH.csv")
    parser.add_argument("--tolerance", type=tolerance_of, default=math.inf, help="on differences, as a share of the largest force of OUT.csv")
    parser.add_argument("-o", "--output", metavar="FIGURE.png", help="default: OUT.png")
    arguments = parser.parse_args()
    tables = [Table(file) for file in arguments.out]
    for table in tables:
        if len(table) != len(tables[0]):
            fail(table.file, f"{len(table)} rows, but {tables[0].file} has {len(tables[0])}")
    forces = [vectors(table, ("fx", "fy", "fz")) for table in tables]
    overlap, normals = read_path(arguments.path, len(tables[0])) if arguments.path else (None, None)
    small = differences_are_small(arguments.out, forces, arguments.tolerance)

    figure = draw(arguments.out, tables, forces, overlap, normals)
    write_figure(figure, arguments.output or Path(arguments.out[0]).with_suffix(".png"), dpi=150)
    return 0 if small else 1


if __name__ == "__main__":
    sys.exit(main())
