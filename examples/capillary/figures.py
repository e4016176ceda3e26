#!/usr/bin/env python3
"""Draws the force of liquid bridges against the gap, and the errors of the rules, from the results of `bridge_curves`.

    python3 examples/capillary/figures.py [FOLDER]       (default: build/results, where `bridge_curves` writes)

The Young-Laplace equation is solved here anew, for the points and for the errors (tests/reference/young_laplace.py).
"""

import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "examples" / "common"), str(ROOT / "tests" / "reference")]
from page import COMPUTED, LIGHT, OTHER, Folder, folder_argument, plt, save, write_section  # noqa: E402

import numpy as np  # noqa: E402
from matplotlib.colors import SymLogNorm  # noqa: E402
from matplotlib.lines import Line2D  # noqa: E402
from young_laplace import Bridges, force  # noqa: E402

RULES = [("young_laplace", "YoungLaplace (exact, as a table)", COMPUTED, "-"), ("willett", "WillettClosed", OTHER, "--"),
         ("rabinovich", "Rabinovich", LIGHT, ":")]
SHOWN = 1e-5, 1e-4, 1e-3, 1e-2, 1e-1


class Curves:
    """By angle [deg], volume and gap."""

    def __init__(self, columns):
        self.angles, self.volumes = np.unique(columns["angle_deg"]), np.unique(columns["volume"])
        shape = self.angles.size, self.volumes.size, -1
        self.gap = columns["gap"].reshape(shape)
        self.force = {name: columns[name].reshape(shape) for name, *_ in RULES}

    def exact(self):
        """The solution of the equation at the same gaps; NaN at and beyond its own rupture."""
        angle, volume = np.meshgrid(np.radians(self.angles), self.volumes, indexing="ij")
        bridges = Bridges(angle, volume)
        self.rupture_gap = bridges.rupture_gap.reshape(volume.shape)
        found = []
        for i in range(self.gap.shape[2]):
            gap = self.gap[:, :, i].ravel()
            found.append(np.where(gap < bridges.rupture_gap, force(bridges.at(gap)), np.nan).reshape(volume.shape))
        return np.stack(found, axis=-1)


def figure_force(curves, exact):
    figure, axes = plt.subplots(1, 2, figsize=(9.2, 4.4), sharey=True)
    for panel, degrees in zip(axes, (0.0, 40.0)):
        a = list(curves.angles).index(degrees)
        for volume in SHOWN:
            v = int(np.argmin(np.abs(np.log(curves.volumes / volume))))
            scale = volume ** (1 / 3)
            gap = curves.gap[a, v] / scale
            lian = 1 + np.radians(degrees) / 2
            for name, _, colour, style in RULES:
                pull = curves.force[name][a, v]
                shown = pull if name == "young_laplace" else np.where(gap < lian, pull, np.nan)
                panel.plot(gap, shown, style, color=colour, linewidth=2.0 if style == "-" else 1.3)
            panel.plot(gap[::8], exact[a, v][::8], "o", color="black", markersize=3, zorder=5)
            panel.plot(gap[-1:], curves.force["young_laplace"][a, v][-1:], "x", color=COMPUTED, markersize=6, zorder=6)
            # Each where its curve stands apart.
            level = {1e-5: 0.17, 1e-4: 0.24, 1e-3: 0.31, 1e-2: 0.38, 1e-1: 0.45}[volume] * (1.0 if degrees == 0 else 0.85)
            pull = curves.force["young_laplace"][a, v]
            panel.annotate(f"$10^{{{round(np.log10(volume))}}}$", (np.interp(-level, -pull, gap), level), fontsize=8, color="black", ha="center",
                           va="center", bbox={"boxstyle": "round,pad=0.15", "facecolor": "white", "edgecolor": "none"}, zorder=7)
        panel.set(xlabel="gap / $V^{1/3}$", xlim=(0, None), ylim=(0, 1.02), title=f"contact angle {degrees:.0f}°, numbers: $V/R^3$")
    axes[0].set_ylabel("force / $2 \\pi R \\gamma$")
    handles = [Line2D([], [], color=colour, linestyle=style, label=label) for _, label, colour, style in RULES]
    handles.append(Line2D([], [], color="black", marker="o", linestyle="", markersize=3, label="Young-Laplace equation, solved"))
    handles.append(Line2D([], [], color=COMPUTED, marker="x", linestyle="", label="rupture, exact"))
    axes[1].legend(handles=handles, loc="upper right")
    return figure


def figure_errors(curves, exact):
    largest = np.nanmax(exact, axis=2, keepdims=True)
    figure, axes = plt.subplots(3, curves.angles.size, figsize=(9.2, 6.6), sharex=True, sharey=True)
    for row, (name, label, *_) in zip(axes, RULES):
        is_exact = name == "young_laplace"
        norm = plt.Normalize(-0.1, 0.1) if is_exact else SymLogNorm(1.0, vmin=-100, vmax=100, base=10)
        for a, (panel, degrees) in enumerate(zip(row, curves.angles)):
            error = 100 * (curves.force[name][a] - exact[a]) / largest[a]
            fraction = curves.gap[a] / curves.gap[a][:, -1:]
            volume = np.broadcast_to(curves.volumes[:, None], fraction.shape)
            shown = panel.pcolormesh(fraction, volume, error, cmap="RdBu_r", norm=norm, shading="gouraud", rasterized=True)
            panel.set(yscale="log")
            panel.grid(False)
            low, high = np.nanmin(error), np.nanmax(error)
            text = f"{low:+.2f} to {high:+.2f} %" if is_exact else f"{low:+.0f} to {high:+.0f} %"
            panel.set_title(f"{degrees:.0f}°: {text}", fontsize=8)
        row[0].set_ylabel(f"{label.split(' ')[0]}\n$V/R^3$")
        figure.colorbar(shown, ax=row[-1], label="% of the largest force")
    for panel in axes[-1]:
        panel.set_xlabel("gap / rupture gap")
    return figure


def main():
    results = Folder(folder_argument(__doc__))
    curves = Curves(results.columns("bridge_curves"))
    exact = curves.exact()
    shapes = [
        ("capillary_force", "Force against gap", figure_force,
         "Five volumes V/R³. Points: the Young-Laplace equation, solved. Both closed forms hold for small volumes and angles, and rupture at Lian's gap."),
        ("capillary_error", "Error of each rule", figure_errors,
         "In the largest force of each bridge, up to the exact rupture gap; mind the scales: ±0.1 % for the table, ±100 % below."),
    ]
    pieces = "\n".join(save(draw(curves, exact), results.folder, name, label, caption) for name, label, draw, caption in shapes)
    write_section(results, "capillary", "Liquid bridges of a given volume", pieces)


if __name__ == "__main__":
    main()
