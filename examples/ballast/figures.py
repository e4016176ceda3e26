#!/usr/bin/env python3
"""Draws the ballast paper's Figures 1 and 2, and the error of increments, from the results of `contact_curves`.

    python3 examples/ballast/figures.py [FOLDER]       (default: build/results, where `contact_curves` writes)
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "common"))
from page import COMPUTED, LIGHT, OTHER, PUBLISHED, plt, read_results, save, table, verdict, write_section  # noqa: E402

import numpy as np  # noqa: E402
from files import read_json  # noqa: E402

SEEDS = {1e-12: COMPUTED, 1e-6: LIGHT, 1e-3: OTHER}


def seed_name(seed):
    return f"$10^{{{round(np.log10(seed))}}}$ N"


def figure_1(results):
    curves = results.columns("ballast_curves")
    transition = results.computed("contact_curves.transition_force")
    at = results.computed("contact_curves.transition_overlap") * 1e6
    figure, (left, right) = plt.subplots(1, 2, figsize=(8.6, 3.7))
    overlap = curves["overlap_m"] * 1e6
    for law, colour, name in (("hertz", OTHER, "Hertz: smooth"), ("rough", COMPUTED, "Pohrt-Popov: rough")):
        force = curves[f"{law}_force_N"]
        left.plot(force, curves[f"{law}_stiffness_N_per_m"] / 1e6, color=colour, label=name)
        right.plot(overlap, force, color=colour, label=name)
    left.axvline(transition, color=PUBLISHED, linestyle=":", linewidth=1.4)
    left.annotate(f"transition\ncomputed {transition:.1f} N\npaper {results.published('contact_curves.transition_force'):.0f} N",
                  (transition, 3), xytext=(6, 0), textcoords="offset points", fontsize=8, color="#404040")
    left.set(xlabel="normal force [N]", ylabel="normal stiffness [MN/m]", xlim=(0, 2800), ylim=(0, 36),
             title="a)  Softer, until the roughness is pressed flat")
    left.legend(loc=(0.03, 0.83))
    right.axhline(transition, color=PUBLISHED, linestyle=":", linewidth=1.4)
    right.plot([at], [transition], "o", color=COMPUTED, markersize=5)
    right.annotate(f"at {at:.1f} µm", (at, transition), xytext=(-6, 6), textcoords="offset points", ha="right", fontsize=8, color="#404040")
    right.set(xlabel="overlap [µm]", ylabel="normal force [N]", xlim=(0, 160), ylim=(0, 2800),
              title="b)  Beyond it the same slope, at a lower force")
    right.legend(loc="upper left")
    shift = at - np.interp(transition, curves["hertz_force_N"], overlap)
    level = 2400
    start = np.interp(level, curves["hertz_force_N"], overlap)
    right.annotate("", (start, level), xytext=(start + shift, level), arrowprops={"arrowstyle": "<->", "color": "#606060", "lw": 0.9})
    right.annotate(f"{shift:.1f} µm", (start + shift / 2, level), xytext=(0, 4), textcoords="offset points", ha="center", fontsize=8,
                   color="#404040")
    return figure


def figure_2(results):
    curves, cycle = results.columns("ballast_curves"), results.columns("ballast_cycle")
    figure, axes = plt.subplots(figsize=(6.6, 4.2))
    axes.plot(curves["overlap_m"] * 1e6, curves["hertz_force_N"], color=PUBLISHED, linewidth=1.2, label="Hertz: smooth")
    axes.plot(curves["overlap_m"] * 1e6, curves["rough_force_N"], color="#d0d0d0", linewidth=5, label="Pohrt-Popov, elastic")
    overlap, force = cycle["overlap_m"] * 1e6, cycle["force_N"]
    for state, colour, style, name in ((1, COMPUTED, "-", "virgin loading"), (2, OTHER, "-", "unloading"), (3, LIGHT, "--", "reloading")):
        shown = np.where(cycle["loading"] == state, force, np.nan)
        axes.plot(overlap, shown, style, color=colour, label=name, linewidth=1.8 if state < 3 else 2.4, zorder=3 if state < 3 else 4)
    reopening = results.computed("contact_curves.plastic_overlap_after_20um") * 1e6
    axes.plot([reopening], [0], "o", color="black", markersize=5, clip_on=False, zorder=6)
    axes.annotate(f"reopens at {reopening:.2f} µm,\nnot at 0: the plastic overlap", (reopening, 0), xytext=(-28, 66), textcoords="offset points",
                  ha="right", fontsize=8, arrowprops={"arrowstyle": "-", "color": "#606060", "lw": 0.8}, color="#404040")
    axes.annotate("back on the virgin curve\nat the largest force so far", (20, results.computed("contact_curves.virgin_force_20um")),
                  xytext=(-20, 44), textcoords="offset points", ha="right", fontsize=8, color="#404040",
                  arrowprops={"arrowstyle": "-", "color": "#606060", "lw": 0.8})
    axes.set(xlabel="overlap [µm]", ylabel="normal force [N]", xlim=(0, 27), ylim=(0, 80), title="Flattened asperities do not rise again")
    axes.legend(loc="upper right", bbox_to_anchor=(0.86, 1.0))
    return figure


def figure_trade(results):
    machine = read_json(results.folder / "ballast_trade_machine.json")
    increments, closed = results.columns("ballast_trade_increments"), results.columns("ballast_trade_closed")
    figure, (left, right) = plt.subplots(1, 2, figsize=(8.6, 4.0), sharey=True, gridspec_kw={"width_ratios": (1.5, 1)})
    floor = abs(closed["relative_error"][0])
    left.axhline(floor, color="black", linewidth=1.8)
    left.annotate("closed form: any number of steps, 1 included", (12, floor), xytext=(0, 5), textcoords="offset points", fontsize=8)
    for seed, colour in ((0.0, PUBLISHED), *SEEDS.items()):
        chosen = increments["seed_N"] == seed
        steps, error = increments["steps"][chosen], np.abs(increments["relative_error"][chosen])
        ns = increments["ns_per_step"][chosen][0]
        left.loglog(steps, error, "-" if seed else "--", color=colour, marker="o", markersize=3)
        text, place = (f"seed {seed_name(seed)}", (6, 0)) if seed else ("as printed: starts at 0 N and stays at 0 N", (-4, 6))
        left.annotate(text, (steps[-1], error[-1]), xytext=place, textcoords="offset points", fontsize=8, color=colour,
                      ha="left" if seed else "right", va="center", annotation_clip=False)
        if seed:
            decade = np.isin(steps, (10, 100, 1000, 10000, 100000, 1000000))
            total = steps[decade] * ns * 1e-3
            right.loglog(total, error[decade], "-", color=colour, marker="o", markersize=3)
        else:
            right.loglog(steps[[0, -1]] * ns * 1e-3, error[[0, -1]], "--", color=colour)
    ns = closed["ns_per_step"]
    right.plot(ns * 1e-3, np.abs(closed["relative_error"]), "o", color="black", markersize=5)
    right.annotate(f"closed form, one step:\n{ns[0]:.0f} ns", (ns[0] * 1e-3, floor), xytext=(10, 0), textcoords="offset points",
                   fontsize=8, va="center")
    per_step = increments["ns_per_step"][increments["seed_N"] == 1e-12][0]
    right.annotate(f"increments:\n{per_step:.0f} ns a step", (2e3, 1e-6), fontsize=8, ha="right", va="center", color=COMPUTED)
    left.set(xlabel="steps of the loading", ylabel="relative error of the force at 10 µm", ylim=(1e-17, 6), xlim=(8, 1.2e6), title="Error of a loading")
    right.set(xlabel="cost of the loading [µs]", xlim=(5e-3, 2e5), title="… and its cost")
    right.annotate(f"{machine['processor']}\n{machine['compiler']}, {machine['date']}", (1, 0), xycoords="axes fraction", xytext=(0, 6),
                   textcoords="offset points", ha="right", fontsize=6.5, color="#606060")
    return figure


def figure_ratchet(results):
    cycles = results.columns("ballast_ratchet")
    hertz = np.interp(20e-6, results.columns("ballast_curves")["overlap_m"], results.columns("ballast_curves")["hertz_force_N"])
    figure, axes = plt.subplots(figsize=(6.6, 3.9))
    axes.axhline(hertz, color=PUBLISHED, linestyle=":", linewidth=1.4)
    axes.annotate(f"Hertz, no roughness left: {hertz:.0f} N", (1.2, hertz), xytext=(0, 4), textcoords="offset points", fontsize=8, color="#404040")
    for column, colour, text, place in (
            ("increments_apart_N", OTHER, "increments, separated in each cycle", (-6, -12)),
            ("increments_held_N", LIGHT, "increments, unloaded to 1 N", (-6, -10)),
            ("closed_apart_N", COMPUTED, "closed form, separated in each cycle: equal to the bit", (-6, 7))):
        axes.semilogx(cycles["cycle"], cycles[column], color=colour)
        first, last = cycles[column][0], cycles[column][-1]
        change = "" if first == last else f": {100 * (last / first - 1):+.0f} %"
        axes.annotate(text + change, (cycles["cycle"][-1], last), xytext=place, textcoords="offset points", fontsize=8, color=colour, ha="right",
                      va="center")
    axes.set(xlabel="cycle", ylabel="peak force at 20 µm [N]", xlim=(1, 1e6), ylim=(0, 215), title="A million cycles to 20 µm (increments: 25 steps up, 25 down)")
    return figure


FIGURES = [
    ("ballast_1", "Figure 1", figure_1, "A rough contact is softer than Hertz's up to the transition force (dotted) and as stiff beyond it; "
     "the overlap that its asperities took up remains. The paper prints the transition force and no other point of these curves."),
    ("ballast_2", "Figure 2", figure_2, "Loaded to 20 µm, unloaded to 14 µm, loaded to 25 µm and unloaded: unloading and reloading follow Hertz's stiffness. "
     "(The paper draws such a cycle without printing forces; its parameters are those of Table 1.)"),
    ("ballast_trade", "Trade", figure_trade, "Increments F := F + k(F) need a seed force, since k(0) = 0. They converge with the first power of the "
     "step to an error that the seed causes (dips are changes of sign). The closed form has neither step nor seed. (A step of increments evaluates three powers: "
     "one for the force, two for the stiffnesses that it returns.)"),
    ("ballast_ratchet", "Ratchet", figure_ratchet, "Increments that are cut off at zero force load again at once, although flattened surfaces do not touch yet. "
     "So each cycle hardens the contact: within seven cycles to several times the force. The closed form opens and closes at the plastic overlap."),
]

SECTION = """<p>The normal contact of M. Tolomeo and G. R. McDowell, <i>Implementation of real contact behaviour in the DEM modelling of triaxial
tests on railway ballast</i> (2022), with the parameters of their Table 1. <b>Expected</b> is their stiffness, integrated numerically in
50 digits.</p>
{verdict}
{numbers}
<h2>Figures</h2>
{figures}
"""


def main():
    results = read_results("ballast", __doc__)
    rows = list(results.by_id.values())
    shown = [save(draw(results), results.folder, name, label, caption) for name, label, draw, caption in FIGURES]
    write_section(results, "ballast", "Railway ballast", SECTION.format(verdict=verdict(rows), numbers=table(rows), figures="\n".join(shown)))


if __name__ == "__main__":
    main()
