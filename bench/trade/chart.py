#!/usr/bin/env python3
"""Draws what `trade` measured: for each law a chart of error against cost, scene by scene.

    python3 bench/trade/chart.py [directory]          (default: build/results, where `trade` writes trade.csv)

Lower is more accurate, further left is cheaper. The line joins what nothing else beats on both; the ring is the default.
"""

import csv
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

plt.rcParams.update({
    "figure.dpi": 100, "savefig.dpi": 130, "font.size": 9, "axes.titlesize": 9, "axes.titleweight": "bold",
    "axes.spines.top": False, "axes.spines.right": False, "axes.linewidth": 0.8, "axes.grid": True,
    "grid.color": "#e6e6e6", "grid.linewidth": 0.6, "axes.axisbelow": True, "lines.linewidth": 1.8,
    "legend.frameon": False, "legend.fontsize": 8, "mathtext.default": "regular", "figure.constrained_layout.use": True,
})

AXES = {  # what is chosen: colour, marker, words
    "default": ("#1f4e79", "o", "the default, in double"), "batch": ("#2e8b57", "D", "batches"),
    "precision": ("#5b9bd5", "s", "precision"), "carrying": ("#8064a2", "^", "carrying of shear"),
    "history": ("#c0504d", "v", "shear history"), "power": ("#e0a030", "P", "power"),
    "normal": ("#e07b39", "X", "normal form"), "step": ("#7f7f7f", ">", "several steps at once"),
    "slot": ("#202020", "x", "a slot left out"),
}
SCENES = {"oblique_impact": "Oblique impact", "cyclic_shear": "Cyclic shear, turning and twisting",
          "reload": "Load, unload, reload", "wet_approach": "Approach and separation"}
FLOOR = 1e-14  # of the chart: errors below are drawn here


def front(rows):
    best, line = float("inf"), []
    for row in sorted(rows, key=lambda r: (float(r["ns"]), float(r["largest_error"]))):
        error = max(float(row["largest_error"]), FLOOR)
        if error < best:
            line.append((float(row["ns"]), error))
            best = error
    return line


def place_labels(axes, points, figure):
    """Names beside points, each at the first of a few places where it covers no other."""
    renderer = figure.canvas.get_renderer()
    taken = [axes.transData.transform((x, y)) for x, y, _, _ in points]
    boxes = []
    for x, y, text, colour in sorted(points, key=lambda p: p[1]):
        for dx, dy, ha in ((7, 0, "left"), (-7, 0, "right"), (0, 9, "center"), (0, -9, "center"), (7, 9, "left"),
                           (7, -9, "left"), (-7, 9, "right"), (-7, -9, "right"), (7, 18, "left"), (7, -18, "left"),
                           (-7, 18, "right"), (-7, -18, "right"), (7, 27, "left"), (-7, 27, "right"), (7, -27, "left")):
            label = axes.annotate(text, (x, y), xytext=(dx, dy), textcoords="offset points", ha=ha, va="center", fontsize=7,
                                  color=colour)
            box = label.get_window_extent(renderer)
            frame = axes.get_window_extent(renderer)
            clear = not any(box.overlaps(other) for other in boxes)
            clear = clear and not any(box.contains(px, py) for px, py in taken)
            clear = clear and box.x0 >= frame.x0 and box.x1 <= frame.x1 + 60 and box.y0 >= frame.y0 - 6
            if clear:
                boxes.append(box)
                break
            label.remove()


def draw(law, rows):
    figure, panels = plt.subplots(2, 2, figsize=(10.5, 8.2), sharex=True, sharey=True)
    costs = [float(r["ns"]) for r in rows]
    for axes, scene in zip(panels.flat, SCENES):
        here = [r for r in rows if r["scene"] == scene]
        axes.set(xscale="log", yscale="log", xlim=(min(costs) * 0.7, max(costs) * 1.9), ylim=(FLOOR / 3, 30),
                 title=SCENES[scene])
        line = front(here)
        axes.step([x for x, _ in line] + [max(costs) * 1.9], [y for _, y in line] + [line[-1][1]], where="post",
                  color="#c8d8e8", linewidth=5, zorder=1, solid_capstyle="round")
        axes.axhline(1e-3, color="#b0b0b0", linewidth=0.8, linestyle=":", zorder=1)
        for row in here:
            colour, marker, _ = AXES[row["axis"]]
            axes.plot([float(row["ns"])], [max(float(row["largest_error"]), FLOOR)], marker, color=colour, markersize=5.5,
                      zorder=4, clip_on=False)
            if row["axis"] == "default":
                axes.plot([float(row["ns"])], [max(float(row["largest_error"]), FLOOR)], "o", markersize=12,
                          markerfacecolor="none", markeredgecolor=colour, markeredgewidth=1.6, zorder=5)
    figure.canvas.draw()
    for axes, scene in zip(panels.flat, SCENES):
        place_labels(axes, [(float(r["ns"]), max(float(r["largest_error"]), FLOOR), r["tier"], AXES[r["axis"]][0])
                            for r in rows if r["scene"] == scene], figure)
    for axes in panels[1]:
        axes.xaxis.set_major_formatter(plt.FuncFormatter(lambda x, _: f"{x:g}"))
        axes.set_xlabel("ns per contact and dt of the motion")
    for axes in panels[:, 0]:
        axes.set_ylabel("largest error of force / largest force")
    used = [axis for axis in AXES if any(r["axis"] == axis for r in rows)]
    marks = [plt.Line2D([], [], color=AXES[a][0], marker=AXES[a][1], linestyle="", label=AXES[a][2]) for a in used]
    marks.append(plt.Line2D([], [], color="#c8d8e8", linewidth=5, label="front: nothing is cheaper and as right"))
    figure.legend(handles=marks, loc="lower center", ncols=5)
    figure.get_layout_engine().set(rect=(0, 0.06, 1, 0.94))
    figure.suptitle(f"{law.replace('_', ' ')}: what each choice costs and saves", fontweight="bold")
    return figure


def main():
    directory = Path(sys.argv[1] if len(sys.argv) > 1 else "build/results")
    with open(directory / "trade.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    for law in dict.fromkeys(row["law"] for row in rows):
        figure = draw(law, [row for row in rows if row["law"] == law])
        figure.savefig(directory / f"trade_{law}.png")
        plt.close(figure)
        print(f"written: {directory}/trade_{law}.png")


if __name__ == "__main__":
    main()
