#!/usr/bin/env python3
"""Draws the hill memo's figures from the results of `memo`, and a page that shows them.

    python3 examples/memo/figures.py [FOLDER]          (default: build/results, where `memo` writes)

Numbers are those of the memo's Figures 10 to 17 and 23. Filled lines are computed here; open circles and grey lines are the
memo's own numbers and formulas.
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "common"))
from page import COMPUTED, LIGHT, OTHER, PUBLISHED, plt, published_point, put_ball, read_results, save, shaded_ball, table, verdict, write_section  # noqa: E402

import numpy as np  # noqa: E402

RADII = 7.5, 5.0  # of the two grains [mm]
SUCTION_FORCE = 200e3 * np.pi * 5e-3**2  # F_max, Eq. 12 [N]


# Parts of figures ------------------------------------------------------------------------------------------------------


def draw_pair(axes, gap, wet, caption, moves=None, top=34):
    """The two grains from the side, `gap` between them [mm], with a bridge where wet; the upper one moves "up" or "down"."""
    below, above = RADII
    z_top = below + gap + above
    if wet:
        reach = 3.2 * np.exp(-max(gap, 0) / 14)  # for the picture only: the law has no shape of the bridge
        z = np.linspace(below - 0.9, below + max(gap, 0) + 1.1, 60)
        middle, half = (z[0] + z[-1]) / 2, (z[-1] - z[0]) / 2
        width = reach * (0.62 + 0.38 * ((z - middle) / half) ** 2)
        axes.fill_betweenx(z, -width, width, color=LIGHT, alpha=0.9, linewidth=0, zorder=1)
    put_ball(axes, shaded_ball("#8c8477"), 0, 0, below, 2)
    put_ball(axes, shaded_ball("#d9b382"), 0, z_top, above, 3)
    axes.plot([-9, 9], [-below, -below], color="#404040", linewidth=1.2)
    axes.add_patch(plt.Rectangle((-9, -below - 1.2), 18, 1.2, facecolor="none", edgecolor="#404040", hatch="//////", linewidth=0))
    if moves:
        tip, tail = (9.5, 5.5) if moves == "up" else (5.3, 9.3)
        axes.annotate("", (0, z_top + tip), xytext=(0, z_top + tail), arrowprops={"arrowstyle": "-|>", "color": "#202020", "lw": 1.4})
    axes.set(xlim=(-10.5, 10.5), ylim=(-9, top), xticks=[], yticks=[])
    axes.set_aspect("equal")
    axes.set_title(caption, fontweight="normal", fontsize=8.5)
    axes.grid(False)
    for spine in axes.spines.values():
        spine.set_visible(False)


# The figures -----------------------------------------------------------------------------------------------------------


def force_displacement(results, law, name, strength, strength_text):
    path, unlimited = results.columns(law), results.columns(f"{law}_unlimited")
    figure, (left, right) = plt.subplots(1, 2, figsize=(8.2, 3.5))
    pressing = path["shear_displacement_m"] == 0
    normal = results.published(f"two_grains.{law}.normal_force")
    trial = results.published(f"two_grains.{law}.shear_unlimited")

    left.plot(np.r_[0, path["gap_m"][pressing]] * 1e3, np.r_[0, path["normal_force_N"][pressing]] / 1e3, color=COMPUTED)
    published_point(left, -0.1, normal / 1e3, f"memo: {normal / 1e3:.5g} kN", (12, 0))
    left.set(xlabel="gap [mm]", ylabel="normal force [kN]", title="Stage A: the top grain moves down by 0.1 mm", ylim=(0, None))

    slide = ~pressing
    start = lambda table, column: np.r_[0, table[column][slide]]
    right.plot(start(unlimited, "shear_displacement_m") * 1e6, start(unlimited, "shear_force_N") / 1e3, "--", color=OTHER,
               label="without a limit ($\\mu$ = 1000)")
    right.plot(start(path, "shear_displacement_m") * 1e6, start(path, "shear_force_N") / 1e3, color=COMPUTED,
               label="with friction ($\\mu$ = 0.4)")
    right.axhline(strength / 1e3, color=PUBLISHED, linewidth=0.9, zorder=1)
    right.annotate(strength_text, (95, strength / 1e3), xytext=(0, -12), textcoords="offset points", ha="right", color="#404040",
                   fontsize=8)
    published_point(right, 99.0, trial / 1e3, f"memo: {trial / 1e3:.5g} kN", (-12, 0), "right")
    published_point(right, 99.0, strength / 1e3, "", (0, 0))
    right.set(xlabel="shear displacement [µm]", ylabel="shear force [kN]", title="Stage B: it turns by 0.02 rad", xlim=(0, 104),
              ylim=(0, None))
    right.legend(loc="upper left")
    figure.suptitle(name)
    return figure


def figure_10(results):
    strength = results.published("two_grains.linear.shear_force")
    return force_displacement(results, "linear", "Linear law", strength, f"memo: $\\mu F_n$ = {strength / 1e3:.5g} kN")


def figure_11(results):
    strength = 0.4 * results.published("two_grains.hill.normal_force")
    return force_displacement(results, "hill", "Hill law: dry, dashpots inactive", strength, "memo: $\\mu F_n$")


def figure_12(results):
    curve = results.columns("crossover")
    overlap = curve["overlap_m"] * 1e3
    figure, axes = plt.subplots(figsize=(6.4, 4.2))
    axes.plot(overlap, curve["linear_force_N"] / 1e6, color=OTHER, label="linear law")
    axes.plot(overlap, curve["hill_force_N"] / 1e6, color=COMPUTED, label="hill law")
    axes.axvspan(2, 30, color="#f3f3f3", zorder=0)
    axes.annotate("beyond 2 mm: too deep for the method to hold", (2.3, 5.15), color="#606060", fontsize=8)

    at = lambda x, column: np.interp(x, curve["overlap_m"], curve[column])
    same_slope = results.computed("two_grains.crossover.stiffness_overlap")
    same_force = results.computed("two_grains.crossover.force_overlap")
    slope = at(same_slope, "linear_force_N") / same_slope
    ends = same_slope + np.array([-3.5e-3, 3.5e-3])
    axes.plot(ends * 1e3, (at(same_slope, "hill_force_N") + slope * (ends - same_slope)) / 1e6, color=OTHER, linewidth=1.2)
    for x, column, text, published, place in (
            (same_slope, "hill_force_N", "equal slope", results.published("two_grains.crossover.stiffness_overlap"), (14, -20)),
            (same_force, "hill_force_N", "equal force", results.published("two_grains.crossover.force_overlap"), (-8, -105))):
        y = at(x, column) / 1e6
        axes.axvline(published * 1e3, color=PUBLISHED, linewidth=0.9, zorder=1)
        axes.plot([x * 1e3], [y], "o", color=COMPUTED, markersize=5)
        axes.annotate(f"{text}\ncomputed {x * 1e3:.3f} mm\nmemo {published * 1e3:.1f} mm", (x * 1e3, y), xytext=place,
                      textcoords="offset points", fontsize=8, va="center", ha="left" if place[0] > 0 else "right",
                      bbox={"facecolor": "#f3f3f3", "edgecolor": "none", "pad": 1})
    axes.set(xlabel="overlap [mm]", ylabel="normal force [MN]", xlim=(0, 30), ylim=(0, 5.6), title="Hill starts softer, and overtakes")
    axes.legend(loc=(0.08, 0.74))
    return figure


def moisture(results, number):
    path = results.columns("moisture")
    chosen = path["figure"] == number
    return {column: values[chosen] for column, values in path.items()}


def bridge_law(gap_mm):
    """Eq. 12, with 2 s_cr = 2 R_o = 10 mm [N]."""
    return np.where(gap_mm < 10, SUCTION_FORCE * np.exp(-np.clip(gap_mm, 0, None) / 10), 0)


def grains_above(columns, title):
    """A row of drawings above two plots: (drawing axes, left axes, right axes)."""
    figure = plt.figure(figsize=(8.2, 6.0))
    top, bottom = figure.subfigures(2, 1, height_ratios=(1.25, 1))
    drawings = top.subplots(1, columns)
    left, right = bottom.subplots(1, 2)
    figure.suptitle(title)
    return figure, np.atleast_1d(drawings), left, right


def gap_over_time(axes, path, title="Gap"):
    time = (path["time_s"] - path["time_s"][0]) * 1e3
    driven = path["released"] == 0
    axes.plot(time, path["gap_m"] * 1e3, color=COMPUTED)
    if driven.any() and not driven.all():
        axes.axvspan(0, time[driven][-1], color="#f3f3f3", zorder=0)
        axes.annotate("moved", (time[driven][-1] / 2, 0.9), xycoords=("data", "axes fraction"), ha="center", fontsize=8, color="#606060")
        axes.annotate("released", (0.98, 0.9), xycoords="axes fraction", ha="right", fontsize=8, color="#606060")
    axes.set(xlabel="time [ms]", ylabel="gap [mm]", xlim=(0, None), title=title)


def force_over_gap(axes, path, limit, legend="lower left"):
    gap = np.linspace(-0.3, limit, 400)
    axes.plot(gap, bridge_law(gap), color="#d0d0d0", linewidth=5, label="memo, Eq. 12")
    axes.plot(path["gap_m"] * 1e3, path["moisture_force_N"], color=COMPUTED, linewidth=1.4, label="computed")
    axes.set(xlabel="gap [mm]", ylabel="moisture force [N]", ylim=(-0.5, 17), xlim=(-0.3, limit), title="Pull of the bridge")
    axes.legend(loc=legend)


def figure_13(results):
    path = moisture(results, 13)
    rest = results.computed("two_grains.moisture.rest_overlap")
    figure = plt.figure(figsize=(8.6, 3.6))
    drawing, left, right = figure.subplots(1, 3, gridspec_kw={"width_ratios": (0.7, 1, 1)})
    draw_pair(drawing, 0, True, "At rest, held by the bridge", top=19)
    time = path["time_s"] * 1e3
    left.plot(time, path["surface_force_N"], color=OTHER, label="surface force, pushes apart")
    left.plot(time, path["moisture_force_N"], color=COMPUTED, label="moisture force, pulls together")
    left.axhline(SUCTION_FORCE, color=PUBLISHED, linewidth=0.9, zorder=1)
    left.set(xlabel="time [ms]", ylabel="force [N]", title="Forces come to balance", ylim=(0, None), xlim=(0, 1.5))
    left.annotate("memo: $\\psi \\pi R_o^2$ = 15.708 N", (1.48, SUCTION_FORCE), xytext=(0, -12), textcoords="offset points",
                  ha="right", color="#404040", fontsize=8)
    left.legend(loc="lower right")
    overlap = np.linspace(0, 10e-6, 200)
    right.plot(overlap * 1e6, 1.08330463206478e9 * overlap**1.5, color="#d0d0d0", linewidth=5, label="memo, Eq. 13")
    right.plot(-path["gap_m"] * 1e6, path["surface_force_N"], color=OTHER, linewidth=1.2, label="surface force")
    right.plot(-path["gap_m"] * 1e6, path["moisture_force_N"], color=COMPUTED, label="moisture force")
    right.plot([rest * 1e6], [SUCTION_FORCE], "o", color="black", markersize=5, zorder=6)
    right.annotate(f"rest at {rest * 1e6:.3f} µm", (rest * 1e6, SUCTION_FORCE), xytext=(8, -14), textcoords="offset points", fontsize=8)
    right.set(xlabel="overlap [µm]", ylabel="force [N]", title="… at one overlap", xlim=(0, 10), ylim=(0, 30))
    right.legend(loc="upper left")
    return figure


def figure_14(results):
    path = moisture(results, 14)
    back = results.computed("two_grains.moisture.released_overlap") * 1e6
    figure, drawings, left, right = grains_above(3, "Moved up by 8 mm and released, the grain returns")
    draw_pair(drawings[0], 0, True, "before")
    draw_pair(drawings[1], 8, True, "held at a gap of 8 mm", "up")
    draw_pair(drawings[2], 0, True, "released: back in contact")
    gap_over_time(left, path, f"At rest again: an overlap of {back:.3f} µm")
    force_over_gap(right, path, 11)
    return figure


def figure_15(results):
    path = moisture(results, 15)
    rupture = results.computed("two_grains.moisture.rupture_gap") * 1e3
    figure, drawings, left, right = grains_above(3, "Moved up beyond 2 $s_{cr}$, the bridge ruptures")
    draw_pair(drawings[0], 0, True, "before")
    draw_pair(drawings[1], 9.9, True, "just before rupture", "up")
    draw_pair(drawings[2], 12, False, "ruptured: no contact", "up")
    gap_over_time(left, path)
    left.axhline(10, color=PUBLISHED, linewidth=0.9)
    left.annotate("memo: 2 $s_{cr}$ = 2 $R_o$ = 10 mm", (0.2, 10), xytext=(0, 4), textcoords="offset points", fontsize=8, color="#404040")
    force_over_gap(right, path, 12.3)
    right.axvline(10, color=PUBLISHED, linewidth=0.9, zorder=1)
    right.annotate(f"ruptures at {rupture:.6f} mm", (10, 11), xytext=(-5, 0), textcoords="offset points", fontsize=8, ha="right")
    return figure


def figure_16(results):
    path = moisture(results, 16)
    back = results.computed("two_grains.moisture.rewetted_overlap") * 1e6
    figure, drawings, left, right = grains_above(3, "Moved down to a gap below 2.0 mm, wetted again, released: it returns")
    draw_pair(drawings[0], 12, False, "ruptured: no contact", "down")
    draw_pair(drawings[1], 1.999, True, "stopped at 1.999 mm and wetted")
    draw_pair(drawings[2], 0, True, "released: back in contact")
    gap_over_time(left, path, f"At rest again: an overlap of {back:.3f} µm")
    left.axhline(2.5, color=PUBLISHED, linewidth=0.9)
    left.annotate("memo: moisture gap 2.5 mm", (0.2, 2.5), xytext=(0, 4), textcoords="offset points", fontsize=8, color="#404040")
    force_over_gap(right, path, 12.3, "upper right")
    return figure


class Camera:
    """Parallel projection of a box of `edge` from the front, a little from the right and from above."""

    def __init__(self, edge, azimuth=24, elevation=14):
        a, e = np.radians([azimuth, elevation])
        self.right = np.array([np.cos(a), np.sin(a), 0])
        self.away = np.array([-np.sin(a) * np.cos(e), np.cos(a) * np.cos(e), -np.sin(e)])
        self.up = np.cross(self.right, self.away)
        self.middle = np.full(3, edge / 2)

    def see(self, points):
        points = np.asarray(points) - self.middle
        return points @ self.right, points @ self.up, points @ self.away


def draw_box(axes, camera, grains, edge, title):
    corners = np.array([[x, y, z] for x in (0, edge) for y in (0, edge) for z in (0, edge)])
    x, y, depth = camera.see(corners)
    nearest = np.argmin(depth)
    floor = camera.see([[0, 0, 0], [edge, 0, 0], [edge, edge, 0], [0, edge, 0]])
    axes.fill(floor[0], floor[1], color="#e9e4da", zorder=0)
    for i in range(8):
        for j in range(i):
            if np.count_nonzero(corners[i] != corners[j]) == 1:
                front = nearest in (i, j)
                axes.plot(x[[i, j]], y[[i, j]], color="#505050", linewidth=0.9, zorder=1000 if front else 1, alpha=0.8 if front else 0.45)
    angle = np.linspace(0, 2 * np.pi, 60)
    for cx, cy, cz, radius in grains:  # shadows, paler from higher up
        if cz > 1.2 * radius and any(abs(o[0] - cx) < 1e-9 and abs(o[1] - cy) < 1e-9 and o[2] < cz - 1e-9 for o in grains):
            continue
        height = cz - radius
        ring = np.c_[cx + radius * np.cos(angle), cy + radius * np.sin(angle), np.zeros_like(angle)]
        sx, sy, _ = camera.see(ring)
        axes.fill(sx, sy, color="#3a3226", alpha=0.32 if height < 1e-3 * edge else 0.14, zorder=2, linewidth=0)
    x, y, depth = camera.see(grains[:, :3])
    layer_colours = ["#8c8477", "#b89a6a", "#d9b382"]
    images = [shaded_ball(colour) for colour in layer_colours]
    layer = np.unique(np.round(grains[:, 2], 4), return_inverse=True)[1]
    for order, i in enumerate(np.argsort(-depth)):
        put_ball(axes, images[layer[i] % 3], x[i], y[i], grains[i, 3], 10 + order)
    axes.set_title(title)
    span = 0.76 * edge
    axes.set(xlim=(-span, span), ylim=(-span, span), xticks=[], yticks=[])
    axes.set_aspect("equal")
    axes.grid(False)
    for spine in axes.spines.values():
        spine.set_visible(False)


def figure_17(results):
    figure, (before, after, force) = plt.subplots(1, 3, figsize=(10.5, 3.9), gridspec_kw={"width_ratios": (1, 1, 0.85)})
    edge, camera = 50.0, Camera(50.0)
    for axes, name, title in ((before, "assembly_before", "Before: packed in the middle of the box"),
                              (after, "assembly_after", "After: at rest under gravity")):
        table = results.columns(name)
        draw_box(axes, camera, np.c_[table["x_m"], table["y_m"], table["z_m"], table["radius_m"]] * 1e3, edge, title)
    history = results.columns("assembly_history")
    published = results.published("grain_assembly.bottom_wall_force")
    time = history["time_s"] * 1e3
    force.semilogy(time, np.clip(history["bottom_wall_force_N"], 1e-3, None), color=COMPUTED, linewidth=1.1)
    force.axhline(published, color=PUBLISHED, linewidth=0.9)
    force.set(xlabel="time [ms]", ylabel="force on the bottom wall [N]", ylim=(1e-2, 1e3), xlim=(80, time[-1]),
              title="Impacts, then the weight alone")
    force.annotate(f"memo: {published:.3f} N\ncomputed: {results.computed('grain_assembly.bottom_wall_force'):.9f} N", (0.97, 0.88),
                   xycoords="axes fraction", fontsize=8, ha="right", color="#404040")
    return figure


def figure_23(results):
    force, displacement = results.columns("shear_update_force"), results.columns("shear_update_displacement")
    figure, (left, right) = plt.subplots(1, 2, figsize=(8.2, 3.5), sharey=True)
    last = force["shear_displacement_m"][-1]
    sheared = np.argmax(force["shear_displacement_m"] >= last * (1 - 1e-9))
    pressed = np.argmax(force["shear_displacement_m"] > 0)
    at_a = force["shear_force_N"][sheared]
    left.plot(np.r_[0, force["shear_displacement_m"][pressed:sheared + 1]] * 1e6, np.r_[0, force["shear_force_N"][pressed:sheared + 1]] / 1e3,
              color=COMPUTED)
    left.set(xlabel="shear displacement [µm]", ylabel="shear force [kN]", title="Shear by 99 µm at 0.1 mm overlap …", xlim=(0, 104), ylim=(0, 2.4))
    left.annotate("$F_A$", (99, at_a / 1e3), xytext=(-6, 8), textcoords="offset points", ha="right")
    for table, colour, style, text in ((displacement, OTHER, "--", "displacement stored (absolute): × $\\sqrt{2}$"),
                                       (force, COMPUTED, "-", "force stored (incremental): unchanged")):
        right.plot(table["overlap_m"][sheared:] * 1e3, table["shear_force_N"][sheared:] / 1e3, style, color=colour, label=text)
    for axes, x in ((left, 99.0), (right, 0.1)):
        axes.plot([x], [at_a / 1e3], "o", color="black", markersize=5, zorder=6)
    published_point(right, 0.2, at_a / 1e3, "memo: “the shear force\nshould not change”", (-10, -20), "right")
    right.set(xlabel="overlap [mm]", title="… then press to twice the overlap", xlim=(0.098, 0.202))
    right.legend(loc="upper left")
    return figure


FIGURES = [
    (10, figure_10, "The linear law presses and shears along straight lines, and slips at its friction limit."),
    (11, figure_11, "The hill law stiffens as it is pressed; its shear stiffness is constant while the overlap is."),
    (12, figure_12, "Hill starts softer than linear; stiffnesses are equal at 12.6 mm, forces at 28.3 mm of overlap."),
    (13, figure_13, "Wetted in contact, the grain is drawn in until Hertz's push equals the bridge's pull."),
    (14, figure_14, "Pulled up by 8 mm and released, the grain returns to the same overlap."),
    (15, figure_15, "Pulled beyond twice the critical gap of 5 mm, the bridge ruptures and no force acts."),
    (16, figure_16, "Lowered to a gap just under 2 mm and wetted across it, the grain returns again."),
    (17, figure_17, "27 balls in cubic packing sink to the bottom, where the wall carries their weight."),
    (23, figure_23, "At twice the overlap the shear force of an incremental law is the same; that of an absolute law is √2 times as large."),
]


SECTION = """<p>The test problems of D. Potyondy, <i>Hill Contact Model [version 4]</i> (2019), run through the integrator of
<code>examples/dem</code>. <b>Published</b> is what the memo prints, <b>expected</b> the closed form, <b>error</b> that of computed
against expected.</p>
{verdict}
{memo}
<h2>Figures</h2>
<p>Filled lines are computed; open circles and grey lines are the memo's numbers and formulas.</p>
{figures}
<h2>One path through four shear histories</h2>
<p>Pressed by 0.1 mm, sheared by 99.0 µm round the lower grain, backed off to half the overlap, pressed again. All four laws go by
the name of Hertz-Mindlin. Published: LAMMPS, with mindlin/force, mindlin_rescale/force, mindlin, mindlin_rescale.</p>
{eight_laws}
"""


def main():
    results = read_results("memo", __doc__)
    rows, eight_laws = list(results.by_id.values()), results.rows("eight_laws")
    shown = [save(draw(results), results.folder, f"figure_{number}", f"Figure {number}", caption) for number, draw, caption in FIGURES]
    text = SECTION.format(verdict=verdict(rows + eight_laws), memo=table(rows), eight_laws=table(eight_laws), figures="\n".join(shown))
    write_section(results, "memo", "Hill memo", text)


if __name__ == "__main__":
    main()
