#!/usr/bin/env python3
"""Draws the figures of the Class 5 study from the results of `class5`, and their section of the page.

    python3 examples/memo/class5/figures.py [FOLDER]          (default: build/results, where `class5` writes)

Figures 18 to 22 of Potyondy (2019), and a packing cut open. Without the broad grading (`class5 --full`) the figures show the
narrow one.
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "common"))
from page import COMPUTED, LIGHT, OTHER, PUBLISHED, banded_table, plt, read_results, save, verdict, write_section  # noqa: E402

import numpy as np  # noqa: E402
from matplotlib.collections import EllipseCollection  # noqa: E402

SEED = 10000  # Table 7
COLOURS = {"linear": OTHER, "hill": COMPUTED, "wet": LIGHT}
LABELS = {"linear": "linear", "hill": "hill", "wet": "hill, wet (20 kPa)"}

# Limits of the Class 5 designation, sieve [mm]: share passing [%] (Minnesota DOT, Standard Specifications, 3138).
CLASS_5 = [(25.0, 100, 100), (19.0, 90, 100), (9.5, 50, 90), (4.75, 35, 80), (2.0, 20, 65)]


def gradings(results):
    names = ("narrow", "broad")
    return [name for name in names if (results.folder / f"class5_{name}_{SEED}_packing.csv").exists() and f"{name}.grains" in results.by_id]


def figure_18(results):
    """Grain-size distribution by volume."""
    figure, axes = plt.subplots(figsize=(6.2, 3.6))
    sieves, low, high = np.array(CLASS_5).T
    axes.fill_between(sieves, low, high, color="#eeeeee", label="limits of Class 5 (Minnesota DOT 3138)", linewidth=0)
    for name, colour in (("narrow", OTHER), ("broad", COMPUTED)):
        if name not in gradings(results):
            continue
        diameter = np.sort(2e3 * results.columns(f"class5_{name}_{SEED}_packing")["radius_m"])
        passing = np.cumsum(diameter**3) / np.sum(diameter**3) * 100
        axes.plot(np.r_[diameter[0], diameter], np.r_[0, passing], color=colour, label=f"{name}: {len(diameter)} grains")
    axes.set(xscale="log", xlim=(2, 30), ylim=(0, 102), xlabel="diameter [mm]", ylabel="share of the volume that is finer [%]",
             xticks=[2, 5, 10, 20, 30])
    axes.set_xticklabels(["2", "5", "10", "20", "30"])
    axes.minorticks_off()
    axes.legend(loc="upper left")
    return figure


def cut_open(axes, grains, values, label, limits):
    """Grains behind a vertical cut through the axis, far ones first; those that the cut meets are drawn as it cuts them."""
    x, y, z, radius = (grains[column] * 1e3 for column in ("x_m", "y_m", "z_m", "radius_m"))
    behind = y > -radius
    cut = np.where(y < radius, np.sqrt(np.maximum(radius**2 - np.minimum(y, 0) ** 2, 0)), radius)  # radius in the picture
    shown = np.where(y < 0, cut, radius)
    order = [i for i in np.argsort(-y) if behind[i]]
    offsets, diameters = np.c_[x, z][order], 2 * shown[order]
    circles = EllipseCollection(diameters, diameters, np.zeros(len(order)), units="xy", offsets=offsets, transOffset=axes.transData,
                                cmap="viridis", edgecolors="#303030", linewidths=0.25, norm=limits)
    circles.set_array(values[order])
    axes.add_collection(circles)
    half_width, half_height = np.max(np.hypot(x, y) + radius), np.max(np.abs(z) + radius)
    axes.plot([-half_width, half_width, half_width, -half_width, -half_width],
              [-half_height, -half_height, half_height, half_height, -half_height], color="#404040", linewidth=1)
    axes.set(xlim=(-1.05 * half_width, 1.05 * half_width), ylim=(-1.03 * half_height, 1.03 * half_height), xticks=[], yticks=[])
    axes.set_aspect("equal")
    axes.grid(False)
    for spine in axes.spines.values():
        spine.set_visible(False)
    bar = axes.figure.colorbar(circles, ax=axes, shrink=0.6, pad=0.02)
    bar.set_label(label)
    bar.outline.set_visible(False)


def figure_19(results):
    names = gradings(results)
    figure, all_axes = plt.subplots(len(names), 2, figsize=(8.4, 4.9 * len(names)), squeeze=False)
    for name, (left, right) in zip(names, all_axes):
        grains = results.columns(f"class5_{name}_{SEED}_packing")
        diameter = 2e3 * grains["radius_m"]
        cut_open(left, grains, diameter, "diameter [mm]", None)
        # Mean normal stress of a grain: sum of force times radius, over three times its volume.
        stress = grains["load_N"] / (4 * np.pi * grains["radius_m"] ** 2) / 1e3
        cut_open(right, grains, stress, "mean stress of the grain [kPa]", plt.Normalize(0, np.percentile(stress, 98)))
        porosity = results.computed(f"{name}.porosity.sphere")
        left.set_title(f"{name}: {len(diameter)} grains\nporosity {porosity:.3f} (inscribed sphere)")
        right.set_title("the same grains\nby load")
    return figure


def stress_strain(results, names, laws, title):
    figure, (whole, cycles) = plt.subplots(1, 2, figsize=(8.6, 3.7))
    for name in names:
        for law in laws:
            curve = results.columns(f"class5_{name}_{SEED}_{law}")
            strain, deviator = curve["axial_strain"] * 100, curve["deviator_Pa"] / 1e3
            whole.plot(strain, deviator, color=COLOURS[law], label=LABELS[law], linewidth=1.2)
            shown = strain < 0.07
            cycles.plot(strain[shown], deviator[shown], color=COLOURS[law], linewidth=1.2)
    for axes in (whole, cycles):
        axes.set(xlabel="axial strain [%]", ylabel="deviator stress [kPa]")
        axes.set_xlim(left=0)
        axes.set_ylim(bottom=0)
    whole.set_title(title)
    cycles.set_title("the two load-unload cycles")
    whole.legend(loc="lower right")
    return figure


def comparison(results, name):
    """The figures of the numbers in the captions."""
    value = lambda law, what: results.computed(f"{name}.{law}.at_0.05_percent.{what}")
    return (f"Resilient modulus at 0.05 %: {value('linear', 'resilient_modulus') / 1e6:.0f} MPa linear, "
            f"{value('hill', 'resilient_modulus') / 1e6:.0f} MPa hill; area of the loop {value('linear', 'loop_energy'):.2f} and "
            f"{value('hill', 'loop_energy'):.2f} J/m³.")


SECTION = """<p>The material-behaviour study of D. Potyondy, <i>Hill Contact Model [version 4]</i> (2019), section 2.3: aggregate is packed in a
cylinder at 150 kPa by moving its walls inwards, and tested in triaxial compression with load-unload cycles at 0.02 % and 0.05 %
axial strain. The linear and the hill law start from one packing. <b>Published</b> is what the memo prints. A number with a band is
judged, one without is shown. {scope}</p>
{verdict}
{figures}
{numbers}
"""


def main():
    results = read_results("class5", __doc__)
    names = gradings(results)
    rows = list(results.by_id.values())
    broad = "broad" in names
    moist = "broad" if broad else "narrow"
    drawn = [
        ("18", figure_18(results), "Grain-size distributions. The broad grading is the upper end of the Class 5 designation."),
        ("19", figure_19(results), "The packing at 150 kPa, cut open along its axis: by size, and by the load that each grain carries. "
         "Chains of loaded grains cross the vessel." + (" The broad grading packs denser." if broad else "")),
    ]
    for number, name in (("20", "narrow"), ("21", "broad")):
        if name in names:
            drawn.append((number, stress_strain(results, [name], ["linear", "hill"], f"{name} grading, 150 kPa"),
                          "Each cycle makes a hysteretic loop; the hill law is stiffer here and its loop is larger. "
                          + comparison(results, name)))
    wet_over_dry = results.computed(f"{moist}.at_0.05_percent.resilient_modulus.wet_over_dry")
    drawn.append(("22", stress_strain(results, [moist], ["hill", "wet"], f"{moist} grading, dry and wet"),
                  f"Moisture raises the resilient modulus ({wet_over_dry:.2f} times at 0.05 %) and the strength."
                  + ("" if broad else " The memo shows the broad grading.")))
    shown = [save(figure, results.folder, f"class5_figure_{number}", f"Figure {number}", caption) for number, figure, caption in drawn]
    scope = "" if broad else "This is the short run: the narrow grading. <code>class5 --full</code> runs both."
    write_section(results, "class5", "Class 5 specimens",
                  SECTION.format(scope=scope, verdict=verdict(rows), figures="\n".join(shown), numbers=banded_table(rows)))


if __name__ == "__main__":
    main()
