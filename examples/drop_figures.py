#!/usr/bin/env python3
"""Draws frames of `drop`, its energy and the force on the box, and their section of the page.

    python3 examples/drop_figures.py [FOLDER]          (default: build/results, where examples/run.sh has `drop` write its folder)
"""

import sys
from pathlib import Path
from xml.etree import ElementTree

sys.path.insert(0, str(Path(__file__).resolve().parent / "common"))
from page import COMPUTED, OTHER, PUBLISHED, Folder, folder_argument, plt, put_ball, save, shaded_ball, write_section  # noqa: E402

import numpy as np  # noqa: E402
from files import fail  # noqa: E402

SHOWN = 0, 5, 9, 11, 20, 50  # frames, .01 s each
SHADES = 32


def read_frames(series):
    """Time, positions [m], diameters [m] and speeds [m/s] of each frame of a .pvd file."""
    try:
        for entry in ElementTree.parse(series).iter("DataSet"):
            frame = ElementTree.parse(series.parent / entry.get("file"))
            fields = {a.get("Name"): np.array(a.text.split(), float) for a in frame.iter("DataArray")}
            speed = np.linalg.norm(fields["velocity"].reshape(-1, 3), axis=1)
            yield float(entry.get("timestep")), fields["points"].reshape(-1, 3), fields["diameter"], speed
    except (OSError, ElementTree.ParseError, KeyError) as fault:
        fail(series, f"cannot be read: {fault}")


def strip(frames):
    figure, row = plt.subplots(1, len(SHOWN), figsize=(9.4, 3.3), sharey=True)
    fastest = max(np.max(frames[i][3]) for i in SHOWN)
    images = [shaded_ball(plt.cm.viridis(shade), 80) for shade in np.linspace(0, 1, SHADES)]
    half = 30.0  # of the box [mm]
    for axes, i in zip(row, SHOWN):
        time, points, diameter, speed = frames[i]
        x, y, z = 1e3 * points.T
        for order, ball in enumerate(np.argsort(-y)):  # the far ones first
            put_ball(axes, images[int((SHADES - 1) * speed[ball] / fastest)], x[ball], z[ball], 500 * diameter[ball], 10 + order)
        axes.plot([-half, -half, half, half], [105, 0, 0, 105], color="#404040", linewidth=1.2)
        axes.set(xlim=(-half - 2, half + 2), ylim=(-2, 105), xticks=[], yticks=[], title=f"{time:.2f} s")
        axes.set_aspect("equal")
        axes.grid(False)
        for spine in axes.spines.values():
            spine.set_visible(False)
    bar = figure.colorbar(plt.cm.ScalarMappable(plt.Normalize(0, fastest), "viridis"), ax=row, shrink=0.7, pad=0.01)
    bar.set_label("speed [m/s]")
    bar.outline.set_visible(False)
    return figure


def energy_and_force(table, weight):
    figure, (left, right) = plt.subplots(1, 2, figsize=(8.6, 3.2))
    left.plot(table["time_s"], 1e3 * table["energy_J"], color=COMPUTED)
    left.set(xlabel="time [s]", ylabel="energy [mJ]", xlim=(0, None), ylim=(0, None), title="kinetic, potential and elastic energy")
    right.plot(table["time_s"], table["force_on_box_N"], color=OTHER)
    right.axhline(weight, color=PUBLISHED, linestyle=":", linewidth=1.4, label=f"weight of the balls: {weight:.3f} N")
    right.legend(loc="lower right")
    right.set(xlabel="time [s]", ylabel="vertical force on the box [N]", xlim=(0, None), title="force on the floor")
    return figure


def main():
    results = Folder(folder_argument(__doc__))
    frames = list(read_frames(results.folder / "drop" / "balls.pvd"))
    if len(frames) <= max(SHOWN):
        fail(results.folder / "drop" / "balls.pvd", f"has {len(frames)} frames, of {max(SHOWN) + 1} that are drawn")
    weight = np.sum(np.pi / 6 * frames[0][2] ** 3) * 1200.0 * 9.81  # density and gravity as in drop.cpp
    pieces = [
        save(strip(frames), results.folder, "drop_frames", "Frames",
             f"{len(frames[0][2])} balls of plastic, 8 to 12 mm in diameter, fall into a box, seen from the front."),
        save(energy_and_force(results.columns("drop/drop"), weight), results.folder, "drop_energy", "Energy and force",
             "Dashpots and friction only take energy. Once the balls rest, the floor carries their weight."),
    ]
    text = "<p>The whole discrete element method of <code>examples/drop.cpp</code>, in one file.</p>\n" + "\n".join(pieces)
    write_section(results, "drop", "Balls that fall into a box", text)


if __name__ == "__main__":
    main()
