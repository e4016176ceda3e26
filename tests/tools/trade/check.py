#!/usr/bin/env python3
"""Runs `trade --replay` on small recordings whose answer is known without it, and on files with every kind of fault; and
`trade` itself on two laws, whose rounding must keep to its documented bounds.

    python3 tests/tools/trade/check.py PROGRAM

What is cheapest is measured, so no check asks which composition that is, but which may be: those whose forces are within
the tolerance; and that of these the one chosen has the least ns of its own report.
"""

import csv
import math
import re
import subprocess
import sys
import tempfile
from pathlib import Path

PROGRAM = sys.argv[1]
LAWS = Path("bench/trade/laws")
HEADER = "contact,dt,overlap,nx,ny,nz,vx,vy,vz"
failures = 0


def check(what, condition, output=""):
    global failures
    if not condition:
        failures += 1
        print(f"FAILED: {what}\n{output}")


def run(*arguments):
    done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=300)
    return done.returncode, done.stdout, done.stderr


def table_of(file):
    if not file.exists():
        return []
    with open(file, newline="") as lines:
        return list(csv.DictReader(lines))


def replay(rows, law="hill", tolerance=1e-3, directory=None, header=HEADER):
    """Exit code, what was printed, and the compositions within the tolerance."""
    file, results = directory / "recording.csv", directory / "results"
    file.write_text("\n".join([header, *rows]) + "\n")
    law_file = law if isinstance(law, Path) else LAWS / f"{law}.toml"
    (results / "replay.csv").unlink(missing_ok=True)
    code, out, error = run("--replay", file, "--law", law_file, "--tolerance", tolerance, "--repetitions", 1, "-o", results)
    table = table_of(results / "replay.csv")
    within = [r["composition"] for r in table if r["within_tolerance"] == "yes"]
    if table:
        check_choice(table, tolerance, out, code)
    return code, out + error, within


def check_choice(table, tolerance, out, code):
    """That the report's choice follows from its own numbers."""
    for r in table:
        keeps = float(r["largest_error"]) <= float(tolerance)  # false for a NaN
        check(f"{r['composition']}: within the tolerance or not by its error", (r["within_tolerance"] == "yes") == keeps, r)
    within = [r for r in table if r["within_tolerance"] == "yes"]
    chosen = [r for r in table if r["chosen"] == "yes"]
    check("one is chosen if one is within the tolerance", len(chosen) == (1 if within else 0) and code == (0 if within else 1), out)
    if not chosen:
        return
    best, finalists = chosen[0], [r for r in within if r["timed"] == "closely"]
    check("the chosen one is within the tolerance and was timed closely", best in finalists, out)
    fastest = min(float(r["ns"]) for r in finalists)
    equals = [r for r in finalists if float(r["ns"]) <= 1.03 * fastest * (1 + 1e-5)]  # the table's digits: 6
    check("the chosen one is as fast as any, to 3 %", best in equals, out)
    check("of equals it has the fewest bytes", int(best["state_bytes"]) ==
          min(int(r["state_bytes"]) for r in finalists if float(r["ns"]) <= 1.03 * fastest * (1 - 1e-5)), out)
    line = next((l for l in out.splitlines() if l.startswith("cheapest")), "")
    check("the chosen one is the one that is printed", line.endswith(best["composition"]), out)


def some(within, with_=(), without=()):
    """Whether one of the compositions has all these words and none of those."""
    return any(all(w in c for w in with_) and not any(w in c for w in without) for c in within)


def row(contact, dt, overlap, normal=(0, 0, 1), velocity=(0, 0, 0)):
    return ",".join(repr(x) for x in (contact, dt, overlap, *normal, *velocity))


def head_on(steps=60, deepest=1e-5, speed=1.0):
    """In and out along the normal; velocity: the change of the overlap."""
    dt = 2 * deepest / speed / steps
    overlap = lambda i: deepest * math.sin(math.pi * i / steps) + 1e-7
    return [row(1, dt, overlap(i), velocity=(0, 0, -(overlap(i) - overlap(i - 1)) / dt)) for i in range(1, steps)]


def turning(steps=200, angle=math.pi / 2, slide=3e-6, overlap=1e-5):
    """Sheared about y within a tenth of the steps, then turned about that axis: the shear force turns along."""
    rows = [row(1, 1e-6, overlap, velocity=(slide / (steps // 10) / 1e-6, 0, 0)) for _ in range(steps // 10)]
    for i in range(1, steps + 1):
        a = angle * i / steps
        rows.append(row(1, 1e-6, overlap, normal=(math.sin(a), 0, math.cos(a))))
    return rows


def apart(gap):
    """Two contacts that never touch."""
    return [row(c, 1e-6, -gap * (1 + i / 10), velocity=(0, 0, 1)) for i in range(10) for c in (3, 8)]


def law_without(directory, law, *lines):
    """A copy of a law file without the lines that begin so."""
    text = [l for l in (LAWS / f"{law}.toml").read_text().splitlines() if not l.startswith(lines)]
    file = directory / "law.toml"
    file.write_text("\n".join(text) + "\n")
    return file


def known_answers(directory):
    # Nobody is wet: the bridge may go, whatever the motion.
    dry = law_without(directory, "hill", "wet")
    code, out, within = replay(head_on(), dry, directory=directory)
    check("a dry scene is replayed", code == 0, out)
    check("a dry scene never uses the bridge", "bridge: no contact is wet" in out, out)
    check("a dry scene may drop the bridge", some(within, without=["suction"]), out)

    # Wet, but out of range: 2 R_o = 10 mm.
    code, out, within = replay(apart(11e-3), "hill", directory=directory)
    check("far contacts are out of the bridge's range", "came within the bridge's range (10 mm)" in out, out)
    check("far contacts may drop the bridge", some(within, without=["suction"]), out)
    check("a recording without a touch is noted", "recording.csv: note: no contact touches" in out, out)
    code, out, within = replay(apart(1e-3), "hill", directory=directory)
    check("near wet contacts keep the bridge", within and not some(within, without=["suction"]), out)

    # Head-on: no sideways motion, so no shear force at any tolerance.
    code, out, within = replay(head_on(), "dry_hill", directory=directory)
    check("head-on impacts may drop shear", some(within, without=["shear"]), out)
    check("what a change does is printed plainly", "no shear " in out and "within the tolerance" in out and "kept" not in out, out)
    check("head-on: nothing slid", "no contact slid" in out, out)
    # alpha sqrt(m* k) v_n is some 10 % of the largest force here.
    check("a fast impact keeps its dashpots", within and not some(within, without=["dashpots"]), out)

    # Standing still, the dashpots do nothing.
    code, out, within = replay([row(1, 1e-6, 1e-5)] * 20, "dry_hill", directory=directory)
    check("at rest dashpots may go", some(within, without=["dashpots"]), out)
    check("at rest dashpots are never used", "dashpots: no damping above 0 N" in out.split("\nused:")[0], out)

    # Projection loses 1 - cos(d) of the length in each turn by d: over 90 degrees in 200 steps
    # 1 - cos(pi/400)^200 = 6.1e-3 of the shear force; restored or rotated, none but rounding.
    code, out, within = replay(turning(), "dry_hill", 1e-6, directory)
    check("a turning scene may restore the length or rotate", some(within, ["/project_restore"]) and some(within, ["/rotate"]), out)
    check("a turning scene keeps more than Project at 1e-6", not some(within, ["/project,"]), out)
    check("a turning scene keeps its shear", not some(within, without=["shear"]), out)
    lost = 1 - math.cos(math.pi / 400) ** 200
    found = [l for l in out.splitlines() if "rotation: project " in l]
    shear_share = [l for l in out.splitlines() if "shear: no shear force" in l]
    check("its error is what projection loses", found and shear_share, out)
    if found and shear_share:
        error = float(found[0].split()[2])
        share = float(shear_share[0].split(" N, ")[1].split()[0]) / 100
        # the share is printed to 3 digits and the error to 2
        check(f"projection loses {lost * share:.3g}, found {error}", abs(error / (lost * share) - 1) < 0.06, out)
        # It grows in equal parts from step to step, so its root mean square is 0.55 of that at the end.
        code, out, within = replay(turning(), "dry_hill", 0.8 * error, directory)
        check("the largest error counts, not the mean", within and not some(within, ["/project,"]), out)
    code, out, within = replay(turning(), "dry_hill", 0.1, directory)
    check("a tolerance of 0.1 allows projection and the law in float", some(within, ["/project,", "law in float"]), out)

    # A tolerance below rounding.
    code, out, within = replay(head_on(), "dry_hill", 1e-18, directory)
    check("no composition is exact", code == 1 and not within and "No composition" in out, out)


def documented_bounds(directory):
    """Rounding keeps to the bounds that the README states, and is there: a bound that is never met is no bound."""
    readme = Path("bench/trade/README.md").read_text()
    bounds = {}
    for precision in ("double", "law in float", "float"):
        line = re.search(rf"^\| {precision} \| ([0-9.e-]+) \|", readme, re.MULTILINE)
        check(f"README states the bound of {precision}", line)
        bounds[precision] = float(line[1]) if line else 0.0
    code, out, error = run(LAWS / "smooth_hertz.toml", LAWS / "hill.toml", "--repetitions", 1, "-o", directory / "variants")
    check("every variant is within its bound", code == 0, error)
    table = table_of(directory / "variants/trade.csv")
    fast = [r for r in table if r["rounding"] != ""]
    for law in ("smooth_hertz", "hill"):
        for variant in ("default", "law in float", "all in float", "batch", "batch in float"):
            found = [r for r in fast if r["law"] == law and r["variant"] == variant]
            check(f"{law}, {variant}: on four motions", len(found) == 4, found)
    for precision, bound in bounds.items():
        rows = [r for r in fast if r["composition"].endswith(", " + precision)]
        worst = max((float(r["rounding"]) for r in rows), default=float("nan"))
        check(f"{precision}: {worst} within {bound}, and of its size", bound / 100 < worst <= bound)


def other_defaults(directory):
    """A law that is not the ready-made one has itself for a default, and every other choice for a variant; what is not offered
    beside it is left out."""
    file = directory / "turned.toml"
    file.write_text((LAWS / "dry_hill.toml").read_text().replace('law = "force"', 'law = "displacement"\nrotation = "rotate"')
                    .replace('law = "dashpots"', 'law = "dashpots"\ntension = "clipped"'))
    code, out, error = run(file, "--repetitions", 1, "-o", directory / "turned")
    table = [r for r in table_of(directory / "turned/trade.csv") if r["motion"] == "reload"]
    variants = lambda axis: {r["variant"] for r in table if r["axis"] == axis}
    check("a law of displacements, rotated and clipped, is measured", code == 0 and table, error)
    check("its variants are the other histories", variants("history") == {"force", "force_rescaled", "displacement_rescaled"}, table)
    check("and the other rotations", variants("rotation") == {"project", "project_restore"}, table)
    check("batches are not offered", not variants("batch"), table)
    # Its own fullest model: whatever it is off by, rounding is all of it.
    check("the default's error is its rounding", [r for r in table if r["axis"] == "default" and
                                                  r["largest_error"] == r["rounding"]], table)


def faults(directory):
    good = head_on()

    def refused(what, rows, *words, header=HEADER, law="dry_hill"):
        code, out, within = replay(rows, law, directory=directory, header=header)
        check(f"{what}: exit code 2, not {code}", code == 2, out)
        for word in ("recording.csv", *words):
            check(f"{what}: names {word!r}", word in out, out)
        check(f"{what}: no result beside it", "cheapest" not in out and not (directory / "results/replay.csv").exists(), out)

    refused("not a number", [*good, "1,1e-6,abc,0,0,1,0,0,0"], f":{len(good) + 2}:8:", "overlap", "abc")
    refused("NaN", [*good, "1,1e-6,nan,0,0,1,0,0,0"], f":{len(good) + 2}:8:")
    refused("negative dt", ["1,-1e-6,1e-5,0,0,1,0,0,0"], ":2:3:", "dt")
    refused("fraction of a contact", ["1.5,1e-6,1e-5,0,0,1,0,0,0"], ":2", "contact")
    refused("a cell too few", ["1,1e-6,1e-5,0,0,1,0,0"], ":2", "8 cells", "9 columns")
    refused("no normal", ["1,1e-6,1e-5,0,0,0,0,0,0"], ":2", "normal")
    refused("a column is missing", good, ":1", "vz", header=HEADER[:-3])
    refused("an unknown column", good, ":1:", "colour", header=HEADER + ",colour")
    refused("no header", good[1:], ":1:", header=good[0])
    refused("no rows", [], "no rows")
    refused("an empty file", [], "is empty", header="")

    code, out, error = run("--replay", directory / "absent.csv", "--law", LAWS / "hill.toml")
    check("an absent file is named", code == 2 and "absent.csv" in error and out == "", error)
    code, out, error = run("--replay", directory / "absent.csv")
    check("--replay asks for --law", code == 2, error)
    bad = directory / "bad.toml"
    bad.write_text('normal = "herz"\n')
    code, out, error = run("--replay", directory / "recording.csv", "--law", bad)
    check("a fault in the law is named", code == 2 and "bad.toml:1:" in error and "herz" in error, error)
    for law, word, only in (("", 'recontact = "same_spot"', "fresh_surface"),
                            ("_incremental", 'unloads = "elastically"', "plastically")):
        form = "pohrt_popov_incremental" if law else "pohrt_popov_elasto_plastic"
        seed = "seed_force = 1e-6\n" if law else ""
        bad.write_text((LAWS / "rough_ballast.toml").read_text().replace('"pohrt_popov_elasto_plastic"', f'"{form}"\n{seed}{word}'))
        code, out, error = run("--replay", directory / "recording.csv", "--law", bad)
        check(f"{word} is refused, what is measured named", code == 2 and word in error and only in error and "bad.toml:" in error,
              error)
    for tolerance in ("nan", "-1", "0", "inf", "1e-3x"):
        code, out, error = run("--replay", directory / "recording.csv", "--law", LAWS / "hill.toml", "--tolerance", tolerance)
        check(f"a tolerance of {tolerance} is refused", code == 2 and "--tolerance" in error and out == "", out + error)
    bad.write_text('normal = "jrk"\n')
    code, out, error = run("--replay", directory / "recording.csv", "--law", bad)
    check("an unknown normal law is refused", code == 2 and "jrk" in error and "hertz" in error, error)
    for key in ("static_friction = 0.5", 'stiffness = "elastic_ratio"'):
        bad.write_text((LAWS / "dry_hill.toml").read_text().replace("friction = 0.4", "friction = 0.4\n" + key))
        code, out, error = run("--replay", directory / "recording.csv", "--law", bad)
        check(f"{key} is refused", code == 2 and key.split()[0] in error and "not measured" in error, error)
    bad.write_text('normal = "herz"\n')
    code, out, error = run("-o", directory / "none", bad)
    check("a fault in a law writes nothing", code == 2 and not (directory / "none").exists(), error)


with tempfile.TemporaryDirectory() as name:
    known_answers(Path(name))
    documented_bounds(Path(name))
    other_defaults(Path(name))
    faults(Path(name))
print("trade: " + ("all right" if failures == 0 else f"{failures} failures"))
sys.exit(1 if failures else 0)
