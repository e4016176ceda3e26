#!/usr/bin/env python3
"""Seeds the faults of faults.toml, one at a time, in a copy of the headers, and sees whether the tests notice.

    python3 tests/faults/run.py [--only NAME...] [--every N] [--jobs 2]   builds and runs the test of each fault; prints a JSON line
    python3 tests/faults/run.py --publish                  the same, and writes tests/faults/README.md; with --only, those rows
    python3 tests/faults/run.py --check                    only whether each fault still applies and is published

A fault that does not apply, or does not compile, is not caught. Ends with 1 unless all are caught.
"""

import argparse
import json
import os
import queue
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib
import xml.etree.ElementTree as ElementTree
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
ROOT = FOLDER.parent.parent
README = FOLDER / "README.md"
COMPILER = os.environ.get("CXX", "g++")
LONGEST = 300  # [s] that a build or a test may take

# What the tests include besides our own headers: compiled once, which halves the time.
COMMON = """#include <cmath>
#include <iostream>
#include <random>
#include <sstream>
#include <vector>
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/eigen.hpp>
#include "catch.hpp"
"""


def eigen():
    found = subprocess.run(["pkg-config", "--cflags-only-I", "eigen3"], capture_output=True, text=True)
    return found.stdout.replace("-I", "-isystem ").split() or ["-isystem", "/usr/include/eigen3"]


FLAGS = ["-std=c++17", "-O1", "-ffp-contract=off", "-DCONTACTLAWS_INLINE=inline", "-pthread", *eigen()]


def note(text):
    print(text, file=sys.stderr, flush=True)


def seeded(fault, text):
    """The header with the fault. Raises ValueError where it does not apply."""
    times = text.count(fault["old"])
    if times != 1 or "\n" in fault["old"] + fault["new"]:
        raise ValueError(f"does not apply: {fault['file']} holds {times} times: {fault['old']}")
    return text.replace(fault["old"], fault["new"])


def header(root, fault):
    of_the_core = root / "include" / "contactlaws" / fault["file"]
    return of_the_core if of_the_core.is_file() else root / fault["file"]


def source(root, test):
    return next((root / "tests").glob(f"*/test_{test}.cpp"), None)


def sources(root, test):
    """Of a test's program: its own, and the laws that tests/CMakeLists.txt links."""
    linked = re.search(rf"target_link_libraries\(test_{test} PRIVATE ([^)]*)\)", (root / "tests/CMakeLists.txt").read_text())
    laws = linked.group(1).split() if linked else []
    return [source(root, test), *(root / "tests/properties" / f"{name}.cpp" for name in laws)]


def copy_of_project(place):
    files = subprocess.run(
        ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
        cwd=ROOT, check=True, capture_output=True, text=True,
    ).stdout
    for name in filter(None, files.split("\0")):
        if (ROOT / name).is_file():
            (place / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / name, place / name)


def compile_once(place):
    """Catch itself, and what all tests include."""
    (place / "common.hpp").write_text(COMMON)
    include = ["-I", str(ROOT / "tests")]
    for options in (
        [*include, "-x", "c++-header", str(place / "common.hpp"), "-o", str(place / "common.hpp.gch")],
        ["-c", str(ROOT / "tests" / "main.cpp"), "-o", str(place / "main.o")],
    ):
        subprocess.run([COMPILER, *FLAGS, *options], check=True)


def verdict(common, copy, test):
    """Builds and runs a test of the copy: ("passes", ""), ("fails", the test case) or ("does not compile", why)."""
    program = copy / f"test_{test}"
    command = [COMPILER, *FLAGS, "-w", "-include", str(common / "common.hpp"), "-I", str(copy / "include"),
               "-I", str(copy / "tests"), "-I", str(copy), "-I", str(copy / "examples"), *map(str, sources(copy, test)),
               str(common / "main.o"), "-o", str(program)]
    built = subprocess.run(command, capture_output=True, text=True, timeout=LONGEST)
    if built.returncode != 0:
        return "does not compile", next((line for line in built.stderr.split("\n") if "error" in line), "")
    try:
        run = subprocess.run([program, "--abort", "--reporter", "xml"], capture_output=True, text=True, timeout=LONGEST)
    except subprocess.TimeoutExpired:
        return "fails", "no end"
    if run.returncode == 0:
        return "passes", ""
    try:
        report = ElementTree.fromstring(run.stdout)
        failed = [c.get("name") for c in report.iter("TestCase") if c.find("OverallResult").get("success") == "false"]
        return "fails", failed[0]
    except (ElementTree.ParseError, IndexError, AttributeError):
        return "fails", f"ends with {run.returncode}"


def try_all(faults, jobs):
    """(fault, whether caught, by which test case or why not), in the order of the list."""
    with tempfile.TemporaryDirectory(prefix="faults.") as folder:
        common = Path(folder) / "common"
        common.mkdir()
        copies = queue.SimpleQueue()
        for job in range(jobs):
            copy = Path(folder) / str(job)
            copy_of_project(copy)
            copies.put(copy)
        note("compiling what all tests include")
        compile_once(common)

        def in_a_copy(work):
            copy = copies.get()
            try:
                return work(copy)
            finally:
                copies.put(copy)

        def sound(test):
            state, which = in_a_copy(lambda copy: verdict(common, copy, test))
            note(f"test_{test} without a fault: {state} {which}")
            return state == "passes"

        def tried(fault):
            def work(copy):
                path = header(copy, fault)
                text = path.read_text()
                try:
                    path.write_text(seeded(fault, text))
                    state, which = verdict(common, copy, fault["test"])
                except ValueError as fault_of_the_list:
                    state, which = "does not apply", str(fault_of_the_list)
                finally:
                    path.write_text(text)
                note(f"{fault['name']}: {state}: {which}")
                return state, which

            if fault["test"] in unsound:
                return fault, False, f"test_{fault['test']} fails without the fault"
            state, which = in_a_copy(work)
            return fault, state == "fails", which or state

        with ThreadPoolExecutor(jobs) as pool:
            tests = sorted({fault["test"] for fault in faults})
            unsound = {test for test, is_sound in zip(tests, pool.map(sound, tests)) if not is_sound}
            return list(pool.map(tried, faults))


def cell(text):
    return "`" + (text.replace("|", "\\|") or " ") + "`"


def definition(fault):
    """The cells of its row that faults.toml states."""
    return f"| {fault['name']} | {fault['file']} | {cell(fault['old'].strip())} | {cell(fault['new'].strip())} | {fault['why']} |"


def publish(results, faults):
    """One row for each fault. Those not tried now keep the row that they have."""
    rows = {line.split(" | ")[0]: line for line in README.read_text().splitlines()}
    for fault, caught, which in results:
        by = f"test_{fault['test']}" if caught else "**nothing**"
        rows[f"| {fault['name']}"] = f"{definition(fault)} {by} | {which} |"
    lines = [rows[f"| {fault['name']}"] for fault in faults if f"| {fault['name']}" in rows]
    README.write_text("\n".join([
        "# Faults seeded, and what caught them",
        "",
        f"Written by `python3 tests/faults/run.py --publish`: {sum('**nothing**' not in line for line in lines)} of "
        f"{len(faults)} caught. Each is one line of `faults.toml`.",
        "",
        "| fault | file | instead of | stands | because | caught by | test case |",
        "|---|---|---|---|---|---|---|",
        *lines,
    ]) + "\n")


def check(faults):
    """Complaints about the list, without compiling anything."""
    published = README.read_text()
    for fault in faults:
        try:
            seeded(fault, header(ROOT, fault).read_text())
        except (OSError, ValueError) as complaint:
            yield f"{fault['name']}: {complaint}"
        if source(ROOT, fault["test"]) is None:
            yield f"{fault['name']}: there is no test_{fault['test']}"
        if f"\n{definition(fault)} " not in published:
            yield f"{fault['name']}: is not so in {README.name}: run.py --only {fault['name']} --publish"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", metavar="NAME", nargs="+", help="faults by their names")
    parser.add_argument("--every", metavar="N", type=int, default=1, help="one fault of each N, for a quick look")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--publish", action="store_true")
    parser.add_argument("--check", action="store_true")
    arguments = parser.parse_args()
    faults = tomllib.loads((FOLDER / "faults.toml").read_text())["fault"]
    if len({fault["name"] for fault in faults}) < len(faults):
        sys.exit("faults.toml: a name is there twice")
    if arguments.check:
        complaints = list(check(faults))
        print("\n".join(complaints) or f"{len(faults)} faults apply")
        return bool(complaints)
    tried = faults
    if arguments.only:
        unknown = set(arguments.only) - {fault["name"] for fault in faults}
        if unknown:
            sys.exit(f"faults.toml has no {', '.join(sorted(unknown))}")
        tried = [fault for fault in faults if fault["name"] in arguments.only]

    results = try_all(tried[:: arguments.every], arguments.jobs)
    if arguments.publish:
        publish(results, faults)
    missed = [f"{fault['name']} ({which})" for fault, caught, which in results if not caught]
    print(json.dumps({
        "item": 16, "name": "seeded faults caught", "figure": len(results) - len(missed), "unit": "faults",
        "target": len(results), "met": not missed, "count": len(results), "worst": "; ".join(missed), "reason": "",
        "command": " ".join(["python3", "tests/faults/run.py", *sys.argv[1:]]),
    }))
    return bool(missed)


sys.exit(main())
