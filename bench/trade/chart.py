#!/usr/bin/env python3
"""Draws what `trade` measured: for each law a chart of error against cost, motion by motion.

    python3 bench/trade/chart.py [directory]          (default: build/results, where `trade` writes trade.csv and trade.json)

Lower is more accurate, further left is cheaper. The band joins the Pareto-optimal variants, whose names are bold; the ring is
the default. Variants whose marks overlap share a label.
"""

import csv
import json
import math
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.transforms import Bbox

plt.rcParams.update({
    "figure.dpi": 120, "savefig.dpi": 120, "font.size": 9, "axes.titlesize": 9, "axes.titleweight": "bold",
    "axes.spines.top": False, "axes.spines.right": False, "axes.linewidth": 0.8, "axes.grid": True,
    "grid.color": "#e6e6e6", "grid.linewidth": 0.6, "axes.axisbelow": True, "lines.linewidth": 1.8,
    "legend.frameon": False, "legend.fontsize": 8, "mathtext.default": "regular", "figure.constrained_layout.use": True,
})

# What is chosen: colour (Okabe & Ito, for colour-blind readers too), marker, words.
AXES = {
    "default": ("#0072b2", "o", "the default, in double"), "batch": ("#009e73", "D", "batches"),
    "precision": ("#56b4e9", "s", "precision"), "rotation": ("#cc79a7", "^", "rotation of shear"),
    "history": ("#d55e00", "v", "shear history"),
    "normal": ("#e69f00", "X", "normal law"), "step": ("#7f7f7f", ">", "several steps at once"),
    "slot": ("#202020", "x", "a slot left out"),
}
MOTIONS = {"oblique_impact": "Oblique impact", "cyclic_shear": "Cyclic shear, turning and twisting",
          "reload": "Load, unload, reload", "wet_approach": "Approach and separation"}
FLOOR = 1e-14  # of the chart: errors below are drawn here
BAND, INK = "#d3dfea", "#262626"


def place(row):
    return float(row["ns"]), max(float(row["largest_error"]), FLOOR)


def pareto(rows):
    best, line = float("inf"), []
    for x, y in sorted(place(r) for r in rows if r["pareto"] == "yes"):
        if y < best:
            line.append((x, y))
            best = y
    return line


def gathered(axes, rows, near=9):
    """Variants whose marks touch, together: a list of (x, y in pixels, rows)."""
    groups = []
    for row in sorted(rows, key=lambda r: (r["axis"] != "default", place(r))):
        x, y = axes.transData.transform(place(row))
        for group in groups:
            if any(abs(x - u) < near and abs(y - v) < near for u, v in group[2]):
                group[3].append(row)
                group[2].append((x, y))
                break
        else:
            groups.append((x, y, [(x, y)], [row]))
    return groups


def words(rows):
    names = [r["variant"].replace("_", " ") for r in rows]
    lines = [", ".join(names[i:i + 2]) for i in range(0, len(names), 2)]
    return ",\n".join(lines)


def place_labels(axes, rows, line, figure):
    """Names beside marks: each at the nearest place where it covers nothing, with a thin line to marks that are not beside it."""
    renderer, frame = figure.canvas.get_renderer(), axes.get_window_extent()
    groups = gathered(axes, rows)
    marks = [Bbox.from_bounds(x - 7, y - 7, 14, 14) for _, _, points, _ in groups for x, y in points]
    marks += [Bbox.from_bounds(x - 11, y - 11, 22, 22) for x, y, _, members in groups if members[0]["axis"] == "default"]
    corners = [axes.transData.transform(p) for p in line]
    band = []
    for (x0, y0), (x1, y1) in zip(corners, corners[1:] + [(frame.x1, corners[-1][1])]):
        band += [Bbox.from_extents(x0, y0 - 4, x1, y0 + 4), Bbox.from_extents(x1 - 4, min(y0, y1), x1 + 4, max(y0, y1))]
    taken = []
    for x, y, _, members in sorted(groups, key=lambda g: (-len(g[3]), g[0])):
        label = axes.annotate(words(members), (0, 0), xytext=(0, 0), xycoords="figure pixels", textcoords="figure pixels",
                              fontsize=7.5, color=INK, linespacing=0.95, zorder=6,
                              weight="bold" if any(m["pareto"] == "yes" for m in members) else "normal")
        size = label.get_window_extent(renderer)
        best = None
        for reach in (11, 16, 24, 34, 46, 60, 76, 94):
            for angle in range(0, 360, 15):
                dx, dy = reach * math.cos(math.radians(angle)), reach * math.sin(math.radians(angle))
                left = x + dx - (0 if dx > 3 else size.width if dx < -3 else size.width / 2)
                low = y + dy - size.height / 2 + (size.height / 2 if dy > 8 else -size.height / 2 if dy < -8 else 0) * 0.8
                box = Bbox.from_bounds(left - 2, low - 1, size.width + 4, size.height + 2)
                if box.x0 < frame.x0 or box.x1 > frame.x1 + 8 or box.y0 < frame.y0 or box.y1 > frame.y1 + 6:
                    continue
                if any(box.overlaps(other) for other in marks + taken):
                    continue
                cost = reach + 0.2 * min(angle, 360 - angle) ** 0.5 + 14 * any(box.overlaps(b) for b in band)
                if best is None or cost < best[0]:
                    best = cost, box, reach, x + dx, y + dy
        if best is None:
            label.set_position((x + 9, y))
            continue
        _, box, reach, end_x, end_y = best
        taken.append(box)
        label.set_position((box.x0 + 2, box.y0 + 1))
        if reach > 16:
            inverse = axes.transData.inverted().transform
            axes.plot(*zip(inverse((x, y)), inverse((end_x, end_y))), color="#9a9a9a", linewidth=0.6, zorder=2)


def draw(law, rows, machine):
    figure, panels = plt.subplots(2, 2, figsize=(11.5, 9.6), sharex=True, sharey=True)
    costs = [float(r["ns"]) for r in rows]
    right = max(costs) * 2.2
    for axes, motion in zip(panels.flat, MOTIONS):
        here = [r for r in rows if r["motion"] == motion]
        axes.set(xscale="log", yscale="log", xlim=(min(costs) * 0.6, right), ylim=(FLOOR / 3, 100), title=MOTIONS[motion])
        line = pareto(here)
        axes.step([x for x, _ in line] + [right], [y for _, y in line] + [line[-1][1]], where="post", color=BAND, linewidth=5,
                  zorder=1, solid_capstyle="round")
        axes.axhline(1e-3, color="#8c8c8c", linewidth=0.8, linestyle=":", zorder=1)
        axes.text(min(costs) * 0.63, 1.3e-3, "0.1 %", fontsize=7, color="#6e6e6e")
        for row in here:
            colour, marker, _ = AXES[row["axis"]]
            axes.plot(*[[v] for v in place(row)], marker, color=colour, markersize=6, zorder=4, clip_on=False)
            if row["axis"] == "default":
                axes.plot(*[[v] for v in place(row)], "o", markersize=13, markerfacecolor="none", markeredgecolor=colour,
                          markeredgewidth=1.8, zorder=5)
    for axes in panels[1]:
        axes.xaxis.set_major_formatter(plt.FuncFormatter(lambda x, _: f"{x:g}"))
        axes.set_xlabel("cheaper  \N{LEFTWARDS ARROW}  cost [ns per contact and step of the motion]")
    for axes in panels[:, 0]:
        axes.set_ylabel("more accurate  \N{LEFTWARDS ARROW}  largest error of force / largest force [1]")
    used = [axis for axis in AXES if any(r["axis"] == axis for r in rows)]
    marks = [plt.Line2D([], [], color=AXES[a][0], marker=AXES[a][1], linestyle="", label=AXES[a][2],
                        **({"markersize": 9, "markerfacecolor": "none", "markeredgewidth": 1.8} if a == "default" else {}))
             for a in used]
    marks.append(plt.Line2D([], [], color=BAND, linewidth=5, label="Pareto front: nothing is cheaper and as accurate"))
    figure.legend(handles=marks, loc="lower center", ncols=5)
    figure.get_layout_engine().set(rect=(0, 0.06, 1, 0.94))
    figure.suptitle(f"{law.replace('_', ' ')}: what each choice costs and saves\n", fontweight="bold")
    measured_on = f"{machine['processor']}, {machine['compiler']}, packs of {machine['lanes']} doubles, {machine['date']}"
    figure.text(0.5, 0.963, f"{measured_on}. The motions are imposed: that longer steps change a motion, too, is not shown.", ha="center",
                fontsize=8, color=INK)
    figure.canvas.draw()
    figure.set_layout_engine("none")  # labels are placed in pixels: nothing may move now
    for axes, motion in zip(panels.flat, MOTIONS):
        here = [r for r in rows if r["motion"] == motion]
        place_labels(axes, here, pareto(here), figure)
    return figure


def main():
    directory = Path(sys.argv[1] if len(sys.argv) > 1 else "build/results")
    with open(directory / "trade.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    machine = json.loads((directory / "trade.json").read_text())["machine"]
    for law in dict.fromkeys(row["law"] for row in rows):
        figure = draw(law, [row for row in rows if row["law"] == law], machine)
        figure.savefig(directory / f"trade_{law}.png")
        plt.close(figure)
        print(f"written: {directory}/trade_{law}.png")


if __name__ == "__main__":
    main()
