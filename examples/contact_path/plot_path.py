#!/usr/bin/env python3
"""Draws what contact_path wrote; of several files it also prints the largest difference of each from the first.

    python3 plot_path.py OUT.csv [MINE.csv ...] [--path PATH.csv] [--tolerance 1e-6] [-o FIGURE.png]

With --tolerance, the exit status is 1 if a difference of forces exceeds that share of the largest force, or is not a number.
MINE.csv may come from another program: it needs the columns fx, fy, fz, and as many rows. PATH.csv puts the overlap under the
normal force, and gives the normals of a MINE.csv that has no fn_total.
"""

import argparse
import csv
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402


def columns(file):
    """The columns of a CSV file by name, without remarks and empty cells' rows."""
    try:
        lines = [line for line in Path(file).read_text().splitlines() if line.strip() and not line.startswith("#")]
        rows = list(csv.DictReader(lines))
        if not rows:
            sys.exit(f"{file}: has no rows")
        return {name: np.array([float(row[name] or "nan") for row in rows]) for name in rows[0]}
    except (OSError, ValueError, TypeError) as fault:
        sys.exit(f"{file}: {fault}")


def forces(file, table):
    """The force, a row a step. Ends the program if it is not there."""
    missing = [name for name in ("fx", "fy", "fz") if name not in table]
    if missing:
        sys.exit(f"{file}: column {missing[0]} is missing")
    return np.column_stack([table["fx"], table["fy"], table["fz"]])


def normal_and_shear(force, table, path):
    """Their sizes; nothing where neither the file nor the path tells the normal."""
    if path is not None:
        normals = np.column_stack([path["nx"], path["ny"], path["nz"]])
        normals /= np.linalg.norm(normals, axis=1)[:, None]
        normal = np.sum(force * normals, axis=1)
        return normal, np.linalg.norm(force - normal[:, None] * normals, axis=1)
    if "fn_total" in table:
        normal = table["fn_total"]
        return normal, np.sqrt(np.clip(np.sum(force**2, axis=1) - normal**2, 0, None))
    return None, None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", nargs="+", metavar="OUT.csv")
    parser.add_argument("--path", metavar="PATH.csv")
    parser.add_argument("--tolerance", type=float, help="largest difference, as a share of the largest force")
    parser.add_argument("-o", "--output", metavar="FIGURE.png", help="default: OUT.png")
    arguments = parser.parse_args()
    tables = [columns(file) for file in arguments.out]
    path = columns(arguments.path) if arguments.path else None

    all_forces = [forces(file, table) for file, table in zip(arguments.out, tables)]
    all_within = True
    first, largest = all_forces[0], np.max(np.linalg.norm(all_forces[0], axis=1))
    for file, force in zip(arguments.out[1:], all_forces[1:]):
        if force.shape != first.shape:
            sys.exit(f"{file}: {len(force)} rows, but {arguments.out[0]} has {len(first)}")
        difference = np.linalg.norm(force - first, axis=1)
        worst = int(np.argmax(difference))  # of a NaN, if there is one
        all_within &= arguments.tolerance is None or bool(difference[worst] <= arguments.tolerance * largest)
        print(f"{file}: largest difference {difference[worst]:.6g} N at step {worst + 1}, "
              f"{difference[worst] / largest:.3g} of the largest force")

    plt.rcParams.update({"axes.grid": True, "grid.alpha": 0.3, "axes.spines.top": False, "axes.spines.right": False})
    figure, (left, middle, right) = plt.subplots(1, 3, figsize=(12, 3.6), layout="constrained")
    for i, (file, table, force) in enumerate(zip(arguments.out, tables, all_forces)):
        normal, shear = normal_and_shear(force, table, path)
        if normal is None:
            continue
        step, style, label = np.arange(1, len(force) + 1), "-" if i == 0 else "--", Path(file).stem
        left.plot(step if path is None else 1e6 * path["overlap"], normal, style, label=label)
        middle.plot(step, shear, style, label=label)
        if i == 0 and "slip" in table and np.any(table["slip"] > 0):
            middle.fill_between(step, 0, 1, where=table["slip"] > 0, alpha=0.15, color="tab:red", linewidth=0,
                                transform=middle.get_xaxis_transform(), label="sliding")
        if "stored_energy" in table and "dissipated_energy" in table:
            right.plot(step, table["stored_energy"], style, color=f"C{2 * i}", label=f"{label}: stored")
            right.plot(step, table["dissipated_energy"], style, color=f"C{2 * i + 1}", label=f"{label}: dissipated")
    left.set(xlabel="step" if path is None else "overlap [µm]", ylabel="normal force [N]")
    middle.set(xlabel="step", ylabel="shear force [N]")
    right.set(xlabel="step", ylabel="energy [J]")
    for axes in (left, middle, right):
        if axes.get_legend_handles_labels()[0]:
            axes.legend(fontsize=8)
    figure.savefig(arguments.output or Path(arguments.out[0]).with_suffix(".png"), dpi=150)
    return 0 if all_within else 1


if __name__ == "__main__":
    sys.exit(main())
