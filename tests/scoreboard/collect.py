#!/usr/bin/env python3
"""Builds and runs the programs of the scoreboard, writes build/results/scoreboard.json and prints the table.

    python3 tests/scoreboard/collect.py [--full] [--publish]

--full      the full counts (hours); otherwise a quick look, and the table says so
--publish   writes the table into tests/scoreboard/README.md too

Ends with 1 if a program failed. A target that is missed is no failure: its row says MISSED, and why.
"""

import argparse
import json
import math
import os
import platform
import shutil
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from datetime import date
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
HERE = ROOT / "tests/scoreboard"
BUILD = ROOT / "build/scoreboard"
RESULTS = ROOT / "build/results/scoreboard.json"
README = HERE / "README.md"

PLAIN = ["-O2"]
EXACT = ["-O2", "-ffp-contract=off"]
WARNINGS = "-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror".split()

# program: the items that it measures, its flags; LAWS: the scalars whose laws it links
PROGRAMS = {
    "accuracy": ([1], PLAIN),
    "floats": ([2], PLAIN),
    "paths": ([3, 14], ["-O1"]),
    "closed_forms": ([4], PLAIN + ["-pthread"]),
    "energy": ([5], PLAIN),
    "symmetries": ([6, 7, 8], ["-O1"]),
    "order": ([9], PLAIN),
    "finite": ([10], PLAIN),
    "rounding": ([12], ["-O1", "-frounding-math"]),
    "steps": ([15], PLAIN),
}
LAWS = {
    "bits": ["double", "float"],
    "finite": ["double", "float"],
    "forces": ["double"],
    "paths": ["double", "long", "200"],
    "rounding": ["double"],
    "symmetries": ["double"],
}
COMPILERS = ["g++-12", "clang++-14", "clang++-19"]
LEVELS = ["-O0", "-O2", "-O3"]


FLUSHED = ("published; -ffast-math flushes denormals: paths below 1e-60 N are left out, and an overlap of 1e-308 m on the way "
           "may leave another shear history")


class Failure(Exception):
    pass


def row(item, name, figure, unit, target=None, count=0, worst="", reason="", **extra):
    met = None if target is None else figure is not None and figure <= target
    return dict(item=item, name=name, figure=figure, unit=unit, target=target, met=met, count=count, worst=worst,
                reason=reason, **extra)


def not_run(item, name, why):
    return row(item, name, None, "", reason=why, state="not run")


def run(command, **options):
    """Runs at low priority; its standard output. Raises Failure with the end of what it said."""
    text = " ".join(str(part) for part in command)
    print(text, file=sys.stderr, flush=True)
    result = subprocess.run(["nice", "-n", "5", *map(str, command)], cwd=ROOT, text=True, capture_output=True, **options)
    if result.returncode:
        said = " ".join((result.stderr or result.stdout)[-400:].split())
        raise Failure(f"{text}: exit status {result.returncode}: {said}")
    return result.stdout


def out_of_date(binary):
    """Whether a file that the compiler read for it is newer."""
    notes = binary.with_name(binary.name + ".d")
    if not binary.exists() or not notes.exists():
        return True
    read = notes.read_text().split(":", 1)[1].replace("\\\n", " ").split()
    return any(not (ROOT / file).exists() or (ROOT / file).stat().st_mtime > binary.stat().st_mtime for file in read)


def built(program, compiler, flags, warnings=()):
    """The path of the program, built if a source is newer."""
    binary = BUILD / "_".join([program, compiler, *flags]).replace("=", "-")
    if out_of_date(binary):
        eigen = run(["pkg-config", "--cflags-only-I", "eigen3"]).split()
        includes = ["-Iinclude", "-I.", "-Itests", "-Iexamples", *(flag.replace("-I", "-isystem", 1) for flag in eigen)]
        fresh = binary.with_name(binary.name + ".new")
        unit = binary.with_name(binary.name + ".cpp")  # one unit: the laws on each scalar, then the program that uses them
        files = [*(ROOT / f"tests/properties/laws_{scalar}.cpp" for scalar in LAWS.get(program, [])), HERE / f"{program}.cpp"]
        unit.write_text("".join(f'#include "{file}"\n' for file in files))
        run([compiler, "-std=c++17", *flags, *warnings, "-DCONTACTLAWS_INLINE=inline", *includes,
             "-MMD", "-MF", f"{binary}.d", unit, "-o", fresh])
        fresh.rename(binary)
    return binary


def lines(text):
    return [json.loads(line) for line in text.splitlines() if line.startswith("{")]


def measure(program, effort):
    items, flags = PROGRAMS[program]
    compiler = "g++"
    rows = lines(run([built(program, compiler, flags, WARNINGS), *effort]))
    if sorted({r["item"] for r in rows}) != items:
        raise Failure(f"{program}: printed rows of items {sorted({r['item'] for r in rows})}, not of {items}")
    return [dict(r, command=" ".join([program, *effort]), compiler=compiler, flags=" ".join(flags)) for r in rows]


def there(compiler):
    """g++-12 is g++ where that is the version."""
    if shutil.which(compiler):
        return compiler
    name, version = compiler.rsplit("-", 1)
    if shutil.which(name) and run([name, "-dumpversion"]).split(".")[0] == version:
        return name
    return None


def same_bits():
    """Item 13."""
    rows, hashes = [], {}
    builds = [(compiler, [level, "-ffp-contract=off"]) for compiler in COMPILERS for level in LEVELS]
    builds.append(("g++-12", ["-O2", "-march=native", "-ffp-contract=off"]))
    for compiler, flags in builds:
        found = there(compiler)
        if not found:
            rows.append(not_run(13, f"same bits, {compiler} {flags[0]}", "this compiler is not here"))
            continue
        for line in lines(run([built("bits", found, flags)])):
            hashes.setdefault((line["law"], line["way"]), {})[" ".join([compiler, *flags[:-1]])] = line["hash"]
    first = next(iter(hashes.values()))
    other = [f"{law} {way}: {', '.join(b for b in by if by[b] != next(iter(by.values())))}"
             for (law, way), by in hashes.items() if len(set(by.values())) > 1]
    laws = len(hashes) - 1
    rows.append(row(13, "same bits from " + ", ".join(first), len(other), "hashes of laws that differ", 0, laws,
                    "; ".join(other)))
    pairs = {law for law, way in hashes if way == "batch"}
    differ = [law for law in sorted(pairs) if hashes[law, "batch"] != hashes[law, "scalar"]]
    rows.append(row(13, "batch against scalar, in each of these builds", len(differ), "laws that differ", 0, len(pairs),
                    ", ".join(differ)))
    return rows


def largest_difference(plain, fast):
    """Of two outputs of `forces`, in the largest part of a force along the path; paths of next to no force left out."""
    worst, where, count = 0.0, "", 0
    for law, other in zip(lines(plain), lines(fast)):
        for number, (path, same_path) in enumerate(zip(law["paths"], other["paths"])):
            if any(x is None for force in path + same_path for x in force):
                return math.inf, f"{law['law']}, path {number}: not finite", count
            largest = max(abs(x) for force in path for x in force)
            count += len(path)
            if largest < 1e-60:
                continue
            off = max(math.dist(a[:3], b[:3]) for a, b in zip(path, same_path)) / largest
            if off > worst:
                worst, where = off, f"{law['law']}, path {number}"
    return worst, where, count


def fast_math(effort):
    """What -ffast-math does: it promises nothing, so it is published."""
    rows = []
    for compiler in "g++-12", "clang++-19":
        found = there(compiler)
        if not found:
            rows.append(not_run(10, f"-ffast-math, {compiler}", "this compiler is not here"))
            continue
        fast = ["-O2", "-ffast-math"]
        for paths in "field", "edges":
            figure, where, count = largest_difference(*(
                run([built("forces", found, flags), paths, *effort]) for flags in (EXACT, fast)))
            rows.append(row(10, f"{compiler} -ffast-math against without, paths: {paths}", figure, "of the largest force",
                            None, count, where, FLUSHED if paths == "edges" else ""))
        for r in lines(run([built("finite", found, fast), *effort])):
            if r["target"] == 0:
                rows.append(dict(r, name=f"{compiler} -ffast-math: {r['name']}"))
    return rows


def nsan(effort):
    """Item 12: clang's sanitizer of numerics, which shadows every double by 113 bits."""
    name = "NSan: places that lose more than 2^-{} of a value"
    if not there("clang++-19"):
        return [not_run(12, name.format(30), "clang++-19 is not here")]
    flags = ["-O1", "-g", "-fsanitize=numerical", "-ffp-contract=off"]
    binary = built("forces", "clang++-19", flags)
    rows = []
    cancels = "published: components that cancel beside larger ones of their vector"
    heat = "the heat of a dashpot that is small beside its spring is the difference of two forces; no step reads it"
    for bits, target, reason in (30, 0, heat), (40, None, cancels):
        options = {
            "halt_on_error": 0,
            "log2_max_relative_error": bits,
            "log2_absolute_error_threshold": 120,
        }
        text = ":".join(f"{key}={value}" for key, value in options.items())
        result = subprocess.run(["nice", "-n", "5", binary, "field", *effort], text=True, cwd=ROOT, env={**os.environ,
            "NSAN_OPTIONS": text}, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        if "WARNING: NumericalStabilitySanitizer" not in result.stderr and result.returncode:
            raise Failure(f"forces under NSan: {result.stderr[-400:]}")
        places = {line.split("(")[1].split(")")[0].split("+")[-1] for line in result.stderr.splitlines() if " #0 " in line}
        found = subprocess.run(["addr2line", "-e", binary, *places], text=True, capture_output=True).stdout if places else ""
        sites = sorted({"/".join(Path(place.split(" ")[0]).parts[-2:]) for place in found.splitlines()})
        rows.append(row(12, name.format(bits), len(sites), "places", target, 26, ", ".join(sites), reason, compiler="clang++-19",
                        flags=" ".join(flags)))
    return rows


def script(command):
    """Another folder's part of the scoreboard, in the same format of rows."""
    return lines(run(command))


def jobs(full):
    """Item, name, what yields its rows; what takes longest first."""
    effort = ["--full"] if full else []
    yield 13, "bits", same_bits
    for program in PROGRAMS:
        yield PROGRAMS[program][0][0], program, lambda program=program: measure(program, effort)
    yield 12, "NSan", lambda: nsan(effort)
    yield 10, "forces and finite under -ffast-math", lambda: fast_math(effort)
    yield 11, "fuzz", lambda: script(["sh", "tests/fuzz/run.sh", "--runs", "1000000000" if full else "20000000"])
    yield 16, "seeded faults", lambda: script(["python3", "tests/faults/run.py", *([] if full else ["--every", "4"])])


def attempt(item, name, job):
    started = time.time()
    try:
        rows = job()
    except (Failure, OSError, ValueError, KeyError) as failure:
        rows = [row(item, name, None, "", reason=str(failure), state="failed")]
    return [dict(r, seconds=round(time.time() - started, 1)) for r in rows]


def state(r):
    if "state" in r:
        return r["state"]
    return "published" if r["met"] is None else "met" if r["met"] else "MISSED"


def machine():
    versions = {}
    for compiler in ["g++", *COMPILERS]:
        found = there(compiler)
        if found:
            versions[compiler] = run([found, "--version"]).splitlines()[0]
    cpu = [line.split(":")[1].strip() for line in open("/proc/cpuinfo") if line.startswith("model name")]
    return dict(cpu=cpu[0] if cpu else platform.processor(), cores=os.cpu_count(), system=platform.system(), compilers=versions)


def number(x):
    return "" if x is None else f"{x:.0f}" if x == int(x) and abs(x) < 1e6 else f"{x:.3g}"


def table(board):
    text = [f"{board['date']}, {'full counts' if board['full'] else 'the quick look (smaller counts)'}. "
            f"{board['machine']['cpu']}; " + "; ".join(sorted(set(board["machine"]["compilers"].values()))) + ".",
            "Flags: " + "; ".join(f"{name} {' '.join(flags)}" for name, (_, flags) in PROGRAMS.items()) + ".", "",
            "| # | what | figure | | target | | cases |", "|--:|---|--:|---|--:|---|--:|"]
    for r in board["rows"]:
        verdict = state(r)
        text.append(f"| {r['item']} | {r['name']} | {number(r['figure'])} | {r['unit']} | {number(r['target'])} | "
                    f"{'**' + verdict + '**' if verdict in ('MISSED', 'failed') else verdict} | {number(r['count'])} |")
    notes = [f"- {r['item']}, {r['name']}: {r['reason']}" for r in board["rows"]
             if r["reason"] and state(r) in ("MISSED", "failed", "not run", "published")]
    worst = [f"- {r['item']}, {r['name']}: `{r['worst']}`" for r in board["rows"] if r["worst"]]
    return "\n".join([*text, "", "## Why", "", *notes, "", "## Worst inputs", "", *worst, ""])


def publish(text):
    start = "<!-- written by collect.py --publish -->\n"
    README.write_text(README.read_text().split(start)[0] + start + "\n" + text)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--full", action="store_true")
    parser.add_argument("--publish", action="store_true")
    options = parser.parse_args()
    BUILD.mkdir(parents=True, exist_ok=True)
    RESULTS.parent.mkdir(parents=True, exist_ok=True)
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        parts = list(pool.map(lambda job: attempt(*job), jobs(options.full)))
    rows = sorted((r for part in parts for r in part), key=lambda r: r["item"])
    board = dict(date=date.today().isoformat(), full=options.full, machine=machine(), rows=rows)
    fresh = RESULTS.with_suffix(".new")
    fresh.write_text(json.dumps(board, indent=1) + "\n")
    fresh.rename(RESULTS)
    text = table(board)
    print(text)
    if options.publish:
        publish(text)
    counts = {verdict: sum(state(r) == verdict for r in rows) for verdict in map(state, rows)}
    print(", ".join(f"{count} {verdict}" for verdict, count in sorted(counts.items())) + f"; {RESULTS.relative_to(ROOT)}")
    return 1 if counts.get("failed") else 0


if __name__ == "__main__":
    sys.exit(main())
