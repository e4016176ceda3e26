#!/usr/bin/env python3
"""Draws the ballast paper's Figures 3, 4, 6, 8 to 12, and two of ours, from the results of `probe`.

    python3 examples/ballast/probe/figures.py [FOLDER]       (default: build/results, where `probe` writes)
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "common"))
from page import COMPUTED, LIGHT, OTHER, PUBLISHED, banded_table, plt, read_results, save, verdict, write_section  # noqa: E402

import numpy as np  # noqa: E402

from sample_picture import draw_sample  # noqa: E402

LAWS = {"hertz": ("Hertz: smooth", OTHER), "elasto_plastic": ("Pohrt-Popov, elasto-plastic", COMPUTED),
        "elastic": ("Pohrt-Popov, elastic", LIGHT)}
BRANCHES = {"virgin": ("virgin loading", COMPUTED), "unloading": ("unloading", OTHER), "reloading": ("reloading", LIGHT)}
STRAIN = "axial strain [%]"
FASTER = [("confined_10_times_faster", "10 times faster"), ("confined_4_times_faster", "4 times faster")]
SLOWER = [("confined_4_times_slower", "4 times slower"), ("confined_10_times_slower", "10 times slower")]


def curve(results, case, phase):
    return results.columns(f"probe_{case}_{phase}")


def confinements(results):
    """The cases of the elasto-plastic law by their confinement, the one of Figures 8 and 9 among them."""
    there = [(case, text) for case, text in FASTER if (results.folder / f"probe_{case}_load.csv").exists()]
    slower = [(case, text) for case, text in SLOWER if (results.folder / f"probe_{case}_load.csv").exists()]
    return there + [("elasto_plastic", "as in Figure 9")] + slower


def smooth(values, width=3):
    """Running median: single landings of grains are noise of the tangent, not of the law."""
    padded = np.pad(values, width // 2, mode="edge")
    return np.median(np.lib.stride_tricks.sliding_window_view(padded, width), axis=1)


def draw_modulus(axes, loading, colour, text, **options):
    axes.semilogx(100 * loading["phase_strain"], loading["modulus_Pa"] / 1e6, ".", color=colour, markersize=2, alpha=0.4)
    axes.semilogx(100 * loading["phase_strain"], smooth(loading["modulus_Pa"]) / 1e6, color=colour, label=text, **options)


def figure_3(results):
    grains = results.columns("probe_grains")
    figure, (left, right) = plt.subplots(1, 2, figsize=(8.6, 3.6), gridspec_kw={"width_ratios": (1.3, 1)})
    order = np.argsort(grains["sieve_m"])
    passing = 100 * np.cumsum(grains["volume_m3"][order]) / np.sum(grains["volume_m3"])
    low = ((22.4, 0), (31.5, 1), (40, 30), (50, 70), (63, 100))  # EN 13450, 31.5 to 50 mm
    high = ((22.4, 3), (31.5, 25), (40, 65), (50, 99), (63, 100))
    for limits, text in ((low, "limits of EN 13450"), (high, None)):
        left.plot(*zip(*limits), "--", color=PUBLISHED, linewidth=1.2, label=text)
    left.plot(1e3 * grains["sieve_m"][order], passing, color=COMPUTED, label=f"the sample, {len(order)} grains", drawstyle="steps-post")
    left.set(xlabel="sieve size [mm]", ylabel="passing, by volume [%]", xlim=(20, 66), ylim=(0, 102), title="a)  Sizes")
    left.legend(loc="upper left")
    for shape, (name, colour, mark) in enumerate((("blocky", COMPUTED, "o"), ("elongated", OTHER, "s"), ("flat", LIGHT, "^"))):
        own = grains["shape"] == shape
        elongation, flatness = (grains[a][own][0] / grains[b][own][0] for a, b in (("intermediate_m", "longest_m"), ("shortest_m", "intermediate_m")))
        right.plot(elongation, flatness, mark, color=colour, markersize=9)
        right.annotate(name, (elongation, flatness), xytext=(8, 8), textcoords="offset points", fontsize=8)
    right.axhline(2 / 3, color=PUBLISHED, linestyle=":", linewidth=1)
    right.axvline(2 / 3, color=PUBLISHED, linestyle=":", linewidth=1)
    right.set(xlabel="intermediate over longest", ylabel="shortest over intermediate", xlim=(0.4, 1), ylim=(0.4, 1), title="b)  The three shapes (lines: Zingg's classes)")
    return figure


def figure_4(results):
    return draw_sample(results.columns("probe_pebbles"), plt)


def figure_6(results):
    figure, axes = plt.subplots(figsize=(7.2, 4.4))
    for case, (text, colour) in LAWS.items():
        draw_modulus(axes, curve(results, case, "load"), colour, text)
    for identity, text in (("E0_elasto_plastic", "paper, elasto-plastic: 128"), ("E0_elastic", "paper, elastic: 90")):
        level = results.published(f"probe.{identity}") / 1e6
        axes.plot([1e-5], [level], "o", markersize=8, markerfacecolor="none", markeredgecolor=PUBLISHED, markeredgewidth=1.6)
        axes.annotate(text, (1e-5, level), xytext=(-8, -4), textcoords="offset points", ha="right", va="top", fontsize=8, color="#404040",
                      bbox={"facecolor": "white", "edgecolor": "none", "pad": 1.5}, zorder=6)
    top = max(results.computed(f"probe.E0_{law}") for law in ("hertz", "elasto_plastic")) / 1e6
    axes.set(xlabel=STRAIN, ylabel="tangent modulus [MPa]", xlim=(1e-7, 1e-1), ylim=(0, 1.45 * top),
             title="One sample, three laws: the elasto-plastic one begins stiff and ends with the elastic one")
    axes.legend(loc="upper right", ncols=3)
    return figure


def draw_states(axes, loading, reach):
    shown = loading["phase_strain"] <= reach
    strain = 100 * loading["phase_strain"][shown]
    for branch, (text, colour) in BRANCHES.items():
        axes.semilogx(strain, smooth(loading[branch][shown], 5), color=colour, label=text)
    axes.semilogx(strain, loading["contacts"][shown], color=PUBLISHED, linewidth=1.2, label="all")
    axes.set(xlabel=STRAIN, ylim=(0, 1.3 * loading["contacts"][0]))


def draw_directions(axes, loading, reach):
    for branch, (text, colour) in BRANCHES.items():
        shown = (loading["phase_strain"] <= reach) & (loading[branch] >= 10)  # fewer contacts have no mean direction
        axes.semilogx(100 * loading["phase_strain"][shown], smooth(loading[f"{branch}_direction"][shown], 5), color=colour, label=text)
    axes.set(xlabel=STRAIN, ylabel="principal direction to the horizontal [°]", ylim=(-3, 93), yticks=(0, 15, 30, 45, 60, 75, 90))


def figure_9(results):
    loading = curve(results, "elasto_plastic", "load")
    figure, (left, right) = plt.subplots(1, 2, figsize=(9.4, 4.0))
    draw_states(left, loading, 1e-4)
    left.set(ylabel="contacts", title="a)  Reloading contacts turn virgin")
    other = left.twinx()
    shown = loading["phase_strain"] <= 1e-4
    start = results.computed("probe.E0_elasto_plastic")
    other.semilogx(100 * loading["phase_strain"][shown], smooth(loading["modulus_Pa"][shown]) / start, color="black", linestyle="--", label="E/E$_0$")
    other.set(ylabel="E/E$_0$ (dashed)", ylim=(0, 1.3))
    other.grid(False)
    left.legend(loc="upper center", ncols=4, fontsize=7.5)
    draw_directions(right, loading, 1e-4)
    right.set_title("b)  Virgin: vertical; unloading: horizontal")
    right.legend(loc="center left", bbox_to_anchor=(0.0, 0.62))
    return figure


def figure_10(results):
    figure, axes = plt.subplots(figsize=(7.2, 4.0))
    top = 1.45e-6 * results.computed("probe.E0_elasto_plastic")
    colours = (OTHER, LIGHT, COMPUTED, "black", "#2e7d32")
    for (case, text), colour in zip(confinements(results), colours):
        loading = curve(results, case, "load")
        # Where a grain was still landing the first moduli are noise of any size.
        loading["modulus_Pa"] = np.where(np.abs(loading["modulus_Pa"] - 1e6 * top / 2) < 0.45e6 * top, loading["modulus_Pa"], np.nan)
        axes.semilogx(100 * loading["phase_strain"], loading["modulus_Pa"] / 1e6, color=colour, label=f"confined {text}")
    axes.set(xlabel=STRAIN, ylabel="tangent modulus [MPa]", xlim=(1e-7, 1e-2), ylim=(0, top),
             title="Slower confinement leaves contacts closer to their largest force: they yield earlier")
    axes.legend(loc="lower left")
    return figure


def figure_11(results):
    figure, (left, right) = plt.subplots(1, 2, figsize=(9.4, 4.0))
    for case, (text, colour) in LAWS.items():
        loading, unloading = curve(results, case, "load"), curve(results, case, "unload")
        left.plot(100 * loading["strain"], (loading["axial_Pa"] - loading["radial_Pa"]) / 1e3, color=colour, label=text)
        left.plot(100 * unloading["strain"], (unloading["axial_Pa"] - unloading["radial_Pa"]) / 1e3, color=colour)
        left.plot(100 * unloading["strain"][-1:], (unloading["axial_Pa"] - unloading["radial_Pa"])[-1:] / 1e3, "o", color=colour, markersize=5)
        draw_modulus(right, unloading, colour, text)
    left.set(xlabel=STRAIN, ylabel="deviator stress [kPa]", title="a)  The elasto-plastic law leaves most strain (dots)", ylim=(0, None))
    left.legend(loc="upper left")
    right.set(xlabel="axial strain since unloading began [%]", ylabel="tangent modulus [MPa]", xlim=(1e-6, 1e-1), ylim=(0, 2.0e-6 * results.computed("probe.E0_hertz")),
              title="b)  Unloading: stiffer, and for long")
    right.legend(loc="lower left")
    return figure


def figure_12(results):
    unloading = curve(results, "elasto_plastic", "unload")
    figure, (left, right) = plt.subplots(1, 2, figsize=(9.4, 4.0))
    draw_states(left, unloading, 1e-3)
    left.set(ylabel="contacts", title="a)  Virgin contacts unload at once", xlabel="axial strain since unloading began [%]")
    left.legend(loc="upper center", ncols=4, fontsize=7.5)
    draw_directions(right, unloading, 1e-3)
    right.set(title="b)  Now unloading contacts are vertical", xlabel="axial strain since unloading began [%]")
    right.legend(loc="center left")
    return figure


def figure_onset(results):
    onsets = results.columns("probe_onset")
    order = np.argsort(onsets["confine_time_s"])
    time, strain, ratio = (onsets[name][order] for name in ("confine_time_s", "onset_strain", "force_over_largest"))
    figure, axes = plt.subplots(figsize=(6.4, 3.9))
    axes.loglog(time, 100 * strain, "o-", color=COMPUTED)
    for x, y, close in zip(time, 100 * strain, ratio):
        axes.annotate(f"F/F$_{{max}}$ {close:.3f}", (x, y), xytext=(8, 6), textcoords="offset points", fontsize=8)
    axes.set(xlabel="time in which the pressure grew [s]", ylabel="strain at which E = 0.95 E$_0$ [%]", xlim=(time[0] / 1.5, time[-1] * 2.5),
             ylim=(60 * strain.min(), 170 * strain.max()), title="Slower confinement: earlier onset")
    axes.set_xticks(time, [f"{x:g}" for x in time])
    axes.minorticks_off()
    return figure


def figure_noise(results):
    noises = results.columns("probe_noise")
    figure, axes = plt.subplots(figsize=(6.4, 3.9))
    axes.loglog(noises["unbalanced"], 100 * noises["noise"], "o-", color=COMPUTED, label="computed")
    line = np.geomspace(noises["unbalanced"].min() / 2, noises["unbalanced"].max() * 2, 10)
    step = 1.8e-9 * (1 - 10 ** (-1 / 20))  # between two points of the curve, in the middle of the first half decade
    axes.loglog(line, 100 * line * 150e3 / step / results.computed("probe.E0_elastic"), ":", color=PUBLISHED, label="unbalanced force × p / (strain step × E$_0$)")
    axes.axvline(1e-7, color=OTHER, linewidth=1)
    axes.annotate("rest ends here", (1e-7, 0.02), xycoords=("data", "axes fraction"), xytext=(5, 4), textcoords="offset points", fontsize=8, color=OTHER)
    axes.set(xlabel="mean unbalanced force over mean contact force, as the probe begins", ylabel="rms noise of E over E$_0$ [%]",
             title="A modulus at small strain needs a sample at rest")
    axes.legend(loc="lower right", bbox_to_anchor=(1.0, 0.08))
    return figure


FIGURES = [
    ("probe_3", "Figure 3", figure_3, "The sieve curve follows the middle of the limits of EN 13450 for 31.5 to 50 mm; sieve size is the intermediate extent. "
     "The three shapes are ours: polyhedra filled with 22 spheres."),
    ("probe_4", "Figure 4", figure_4, "The sample at 150 kPa, before the probe: from outside, and cut open along the axis. Each colour is one grain. Cut faces are dark."),
    ("probe_6", "Figures 6 and 8", figure_6, "Tangent modulus while the bottom platen rises: points, and their running median. Rough elastic contacts are softer than Hertz's at any strain. "
     "Elasto-plastic ones begin as stiff as Hertz's, since nearly all contacts reload; from the strain at which they reach their largest force they follow the elastic "
     "rough law. Circles: the paper's two values; ours depend on packing and size, so the ratios are what is judged."),
    ("probe_9", "Figure 9", figure_9, "The elasto-plastic law: numbers of contacts on each branch of their history, and the direction of each group. The dashed modulus falls as reloading "
     "contacts become virgin ones. (Groups of fewer than ten contacts have no direction shown.)"),
    ("probe_10", "Figure 10", figure_10, "The elasto-plastic law on the same sample, confined within different times. The initial moduli are close; degradation begins earlier after a "
     "slower confinement. (Gaps at small strain: a grain was landing.)"),
    ("probe_11", "Figure 11", figure_11, "Loading to 0.1 % and unloading to the initial deviator stress, which is not zero: grains and top platen weigh. The strain that remains and the modulus of unloading are "
     "larger with loading history."),
    ("probe_12", "Figure 12", figure_12, "The elasto-plastic law while unloading: virgin contacts vanish at once, vertical contacts unload, horizontal ones load."),
    ("probe_onset", "Onset", figure_onset, "Ours: the strain at which the modulus of the elasto-plastic law has fallen by 5 %, against the time of confinement. F/F_max is the mean of "
     "reloading contacts before the probe: the closer to 1, the less strain brings them back to virgin loading."),
    ("probe_noise", "Noise", figure_noise, "Ours: copies of one specimen (elastic law) loaded before it was at rest. Shown is the noise of the tangent modulus from 1e-7 % to 3e-7 %; later in each probe the sample has come to rest. "
     "It follows the unbalanced force (dotted: an unbalanced force that acts from one point of the curve to the next) and is below it, since motion dies down within the probe."),
]

SECTION = """<p>The triaxial probes of M. Tolomeo and G. R. McDowell, <i>Implementation of real contact behaviour in the DEM modelling of triaxial tests
on railway ballast</i> (2022), sections 3 and 4, on a sample of {grains} grains of our own shapes. Absolute moduli follow packing and size, so ratios
between laws on one sample are judged.</p>
{verdict}
{numbers}
<h2>Figures</h2>
{figures}
"""


def main():
    results = read_results("probe", __doc__)
    rows = list(results.by_id.values())
    shown = [save(draw(results), results.folder, name, label, caption) for name, label, draw, caption in FIGURES]
    grains = len(results.columns("probe_grains")["grain"])
    write_section(results, "probe", "Small-strain probes on railway ballast", SECTION.format(verdict=verdict(rows), numbers=banded_table(rows), figures="\n".join(shown), grains=grains))


if __name__ == "__main__":
    main()
