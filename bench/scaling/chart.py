#!/usr/bin/env python3
"""Draws what `dem_scaling` measured: the cost of a step of examples/dem, and the share of the neighbour search, against the grains.

    python3 bench/scaling/chart.py [directory]          (default: build/results, where dem_scaling writes dem_scaling.csv and .json)
"""

import csv
import json
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

plt.rcParams.update({"figure.dpi": 120, "savefig.dpi": 120, "font.size": 9, "axes.spines.top": False, "axes.spines.right": False,
                     "axes.grid": True, "grid.color": "#e6e6e6", "axes.axisbelow": True, "legend.frameon": False})

# Okabe & Ito, for colour-blind readers too.
STYLES = {"lattice": ("#202020", "s"), "1:1": ("#0072b2", "o"), "1:5": ("#009e73", "^"), "1:10": ("#d55e00", "D")}


def main():
    directory = Path(sys.argv[1] if len(sys.argv) > 1 else "build/results")
    with open(directory / "dem_scaling.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    machine = json.loads((directory / "dem_scaling.json").read_text())
    figure, (cost, search) = plt.subplots(1, 2, figsize=(10, 4.2), constrained_layout=True)
    for packing, (colour, marker) in STYLES.items():
        here = [row for row in rows if row["packing"] == packing]
        grains = [int(row["grains"]) for row in here]
        label = "lattice" if packing == "lattice" else f"random, radii {packing}"
        cost.plot(grains, [float(row["step_ns"]) for row in here], color=colour, marker=marker, label=label)
        search.plot(grains, [100.0 * float(row["search_share"]) for row in here], color=colour, marker=marker, label=label)
    cost.set(xscale="log", ylim=(0, None), xlabel="grains", ylabel="a step [ns per listed contact]", title="Cost of a step")
    search.set(xscale="log", yscale="log", xlabel="grains", ylabel="of all time [%]", title="Search for neighbours, strained at 0.1/s")
    search.axhline(10.0, color="#8c8c8c", linewidth=0.8, linestyle=":")
    cost.legend()
    figure.suptitle(f"examples/dem, dry hill law, one core: {machine['processor']}, {machine['compiler']}, packs of {machine['lanes']} doubles, "
                    f"{machine['date']}", fontsize=9)
    figure.savefig(directory / "dem_scaling.png")
    print(f"written: {directory}/dem_scaling.png")


if __name__ == "__main__":
    main()
