#!/usr/bin/env python3
"""Builds the report cards of the hosts that are installed, runs them and writes docs/report_cards.md's tables.

    python3 examples/hosts/report_cards/run.py [HOST]...    prints the tables; results in build/results/report_cards/
    python3 examples/hosts/report_cards/run.py --publish    also writes them, and the paths of failures, into docs/, where the page
                                                            has a section of this version

Hosts: lammps (lammps, liblammps-dev) and liggghts (liggghts, libliggghts-dev), both with mpi-default-dev; and yade, minutes long and
therefore only where it is named. Skips (77) without one.
"""

import argparse
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent.parent
RESULTS = ROOT / "build/results/report_cards"
PAGE = ROOT / "docs/report_cards.md"
PATHS = ROOT / "docs/report_cards"
FLAGS = "-std=c++17 -O1 -w -fpermissive -DOMPI_SKIP_MPICXX -DCONTACTLAWS_INLINE=inline".split()


def run(*command, **options):
    return subprocess.run([str(part) for part in command], check=True, text=True, **options)


def eigen():
    return run("pkg-config", "--cflags-only-I", "eigen3", stdout=subprocess.PIPE).stdout.replace("-I", "-isystem").split()


def headers_of(host):
    """The folder of the host's headers, or None where it is not installed."""
    if not shutil.which("mpicxx"):
        return None
    if host == "liggghts":
        folder = Path("/usr/include/liggghts")
        return folder if folder.is_dir() else None
    if not Path("/usr/include/lammps/pair.h").is_file():
        return None
    folder = ROOT / "build/hosts/lammps/headers"
    found = subprocess.run(["sh", str(ROOT / "examples/hosts/lammps/headers.sh"), str(folder)], capture_output=True, text=True)
    if found.returncode:
        print(f"lammps: its headers cannot be fetched: {found.stderr.strip()[-200:]}", file=sys.stderr)
        return None
    return folder


def lines_of(host, said):
    (RESULTS / f"{host}.jsonl").write_text(said)
    return [json.loads(line) for line in said.splitlines() if line.startswith("{")]


def yade_card():
    """YADE has no headers: it runs as a program of its own, beside the checks, with a pipe each way."""
    if not shutil.which("yade"):
        print("yade: skipped, it is not here", file=sys.stderr)
        return None
    program, folder = RESULTS / "report_card_yade", RESULTS / "paths" / "yade"
    flags = [flag for flag in FLAGS if "MPI" not in flag and flag != "-fpermissive"]
    run("g++", *flags, *eigen(), f"-I{ROOT}/include", f"-I{ROOT}", HERE / "yade.cpp", "-o", program)
    folder.mkdir(parents=True, exist_ok=True)
    for pipe in (folder / "to_yade", folder / "from_yade"):
        pipe.unlink(missing_ok=True)
        os.mkfifo(pipe)
    log, lines = folder / "yade.log", folder / "lines"
    with open(log, "w") as of_yade, open(lines, "w") as said:
        yade = subprocess.Popen(["yade", "-n", "-x", HERE / "yade_two_particles.py", folder], stdout=of_yade, stderr=of_yade)
        checks = subprocess.Popen([program, folder], stdout=said)
    yade.wait()  # until the checks close its pipe
    try:
        status = checks.wait(timeout=10)
    except subprocess.TimeoutExpired:  # YADE has gone, and they still wait for it
        checks.kill()
        status = "none"
    if status != 0:
        sys.exit(f"{program}: exit status {status}; YADE said: {log.read_text()[-2000:]}")
    return lines_of("yade", lines.read_text())


def card(host):
    """The lines of a host's report card, or None."""
    if host == "yade":
        return yade_card()
    headers = headers_of(host)
    if headers is None:
        print(f"{host}: skipped, it or its headers are not here", file=sys.stderr)
        return None
    program = RESULTS / f"report_card_{host}"
    defines = ["-DLAMMPS_SMALLBIG"] if host == "lammps" else []
    run("mpicxx", *FLAGS, *defines, "-isystem", headers, *eigen(), f"-I{ROOT}/include", f"-I{ROOT}", HERE / f"{host}.cpp", "-o", program,
        f"-l{host}")
    environment = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    card_run = subprocess.run([program, RESULTS / "paths" / host], capture_output=True, text=True, env=environment)
    if card_run.returncode:  # libliggghts warns of its own tables: shown on failure only
        sys.exit(f"{program}: exit status {card_run.returncode}: {card_run.stderr[-2000:]}")
    return lines_of(host, card_run.stdout)


def table(lines):
    """One row for each property, one column for each law: passed, or the figure of the failure."""
    laws = list(dict.fromkeys(line["law"] for line in lines))
    rows = [f"| | {' | '.join(laws)} | figure |", "|---" * (len(laws) + 2) + "|"]
    for name in dict.fromkeys(line["property"] for line in lines):
        found = {line["law"]: line for line in lines if line["property"] == name}
        cells = []
        for law in laws:
            line = found.get(law)
            cells.append("-" if line is None else "ok" if line["pass"] else f"**{line['figure']:.2g}**")
        measure = next(iter(found.values()))["measure"]
        for line in found.values():
            if not line["pass"]:
                measure = line["measure"].split(" at ")[0]
        rows.append(f"| {name} | {' | '.join(cells)} | {measure} |")
    return f"{lines[0]['host']}:\n\n" + "\n".join(rows) + "\n"


def publish(lines):
    host = lines[0]["host"]
    page = PAGE.read_text()
    begin, end = f"<!-- {host} -->\n", f"<!-- end of {host} -->"
    if begin not in page:
        sys.exit(f"{PAGE.name} has no section '{begin.strip()}'")
    before, rest = page.split(begin)
    PAGE.write_text(before + begin + "\n" + table(lines) + "\n" + end + rest.split(end)[1])
    folder = PATHS / host.lower().replace(' ', '_')
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    for line in lines:
        target = folder / (line["property"].replace(" ", "_") + ".csv")
        if line["path"] and not target.exists():  # of the first law that fails
            shutil.copyfile(line["path"], target)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--publish", action="store_true")
    parser.add_argument("hosts", nargs="*", metavar="HOST", help="lammps, liggghts or yade; without one, the first two")
    options = parser.parse_args()
    hosts = options.hosts or ["lammps", "liggghts"]
    if not set(hosts) <= {"lammps", "liggghts", "yade"}:
        parser.error("HOST is lammps, liggghts or yade")
    RESULTS.mkdir(parents=True, exist_ok=True)
    cards = {host: card(host) for host in hosts}
    for lines in cards.values():
        if lines is None:
            continue
        print(table(lines))
        if options.publish:
            publish(lines)
    return 0 if any(cards.values()) else 77


if __name__ == "__main__":
    sys.exit(main())
