#!/usr/bin/env python3
"""Runs `trade --replay` on small scenes whose answer is known without it, and on files with every kind of fault.

    python3 tests/trade/check.py PROGRAM

Run by hand: what is cheapest is measured, so on a busy machine a check may fail with nothing wrong.
"""

import math
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


def replay(rows, law="hill", tolerance=1e-3, directory=None, header=HEADER):
    file = directory / "recording.csv"
    file.write_text("\n".join([header, *rows]) + "\n")
    law_file = law if isinstance(law, Path) else LAWS / f"{law}.toml"
    code, out, error = run("--replay", file, "--law", law_file, "--tolerance", tolerance, "--repetitions", 1)
    cheapest = [line for line in out.splitlines() if line.startswith("cheapest")]
    return code, out + error, cheapest[0] if cheapest else ""


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
    # Nobody is wet: the bridge goes, whatever the motion.
    dry = law_without(directory, "hill", "wet")
    code, out, cheapest = replay(head_on(), dry, directory=directory)
    check("a dry scene is replayed", code == 0, out)
    check("a dry scene never uses the bridge", "bridge: no contact is wet" in out, out)
    check("a dry scene drops the bridge", "suction" not in cheapest, out)

    # Wet, but out of range: 2 R_o = 10 mm.
    code, out, cheapest = replay(apart(11e-3), "hill", directory=directory)
    check("far contacts are out of the bridge's range", "came within the bridge's range (10 mm)" in out, out)
    code, out, cheapest = replay(apart(1e-3), "hill", directory=directory)
    check("near wet contacts keep the bridge", "suction" in cheapest, out)

    # Head-on: no sideways motion, so no shear force at any tolerance.
    code, out, cheapest = replay(head_on(), "dry_hill", directory=directory)
    check("head-on impacts drop shear", code == 0 and "shear" not in cheapest, out)
    check("head-on: nothing slid", "no contact slid" in out, out)
    # alpha sqrt(m* k) v_n is some 10 % of the largest force here.
    check("a fast impact keeps its dashpots", "dashpots" in cheapest, out)

    # Standing still, the dashpots do nothing.
    code, out, cheapest = replay([row(1, 1e-6, 1e-5)] * 20, "dry_hill", directory=directory)
    check("at rest dashpots go", code == 0 and "dashpots" not in cheapest, out)

    # Projection loses 1 - cos(d) of the length in each turn by d: over 90 degrees in 200 steps
    # 1 - cos(pi/400)^200 = 6.1e-3 of the shear force; restored or rotated, none but rounding.
    code, out, cheapest = replay(turning(), "dry_hill", 1e-6, directory)
    check("a turning scene keeps more than Project at 1e-6", "/project," not in cheapest, out)
    lost = 1 - math.cos(math.pi / 400) ** 200
    found = [l for l in out.splitlines() if "carrying: project " in l]
    shear_share = [l for l in out.splitlines() if "shear: no shear force" in l]
    check("its error is what projection loses", found and shear_share, out)
    if found and shear_share:
        error = float(found[0].split()[3])
        share = float(shear_share[0].split(" N, ")[1].split()[0]) / 100
        # the share is printed to 3 digits and the error to 2
        check(f"projection loses {lost * share:.3g}, found {error}", abs(error / (lost * share) - 1) < 0.06, out)
    code, out, cheapest = replay(turning(), "dry_hill", 0.1, directory)
    check("a tolerance of 0.1 lets the law be in float", "law in float" in cheapest or "shear" not in cheapest, out)

    # A tolerance below rounding.
    code, out, cheapest = replay(head_on(), "dry_hill", 1e-18, directory)
    check("no composition is exact", code == 1 and "No composition" in out, out)


def faults(directory):
    good = head_on()

    def refused(what, rows, *words, header=HEADER, law="dry_hill"):
        code, out, _ = replay(rows, law, directory=directory, header=header)
        check(f"{what}: exit code 2, not {code}", code == 2, out)
        for word in ("recording.csv", *words):
            check(f"{what}: names {word!r}", word in out, out)
        check(f"{what}: no result beside it", "cheapest" not in out, out)

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
    code, out, error = run("-o", directory / "none", bad)
    check("a fault in a law writes nothing", code == 2 and not (directory / "none").exists(), error)


with tempfile.TemporaryDirectory() as name:
    known_answers(Path(name))
    faults(Path(name))
print("trade --replay: " + ("all right" if failures == 0 else f"{failures} failures"))
sys.exit(1 if failures else 0)
