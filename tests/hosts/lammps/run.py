#!/usr/bin/env python3
"""The pair styles inside LAMMPS:  run.py CLMP NEGATED

Expected values are closed forms, or come from LAMMPS's own pair styles in the same program.
"""
import math
import os
import pathlib
import subprocess
import sys
import tempfile

here = pathlib.Path(__file__).parent
sys.path.insert(0, str(here.parent))
from closed_forms import exact_bridges, jkr, jkr_gap  # noqa: E402
clmp, negated = (str(pathlib.Path(p).resolve()) for p in sys.argv[1:3])
scratch = tempfile.TemporaryDirectory()
environment = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1", OMP_NUM_THREADS="1")
checks = failures = 0
sub_models = b"contactlaws/pohrt_popov" in pathlib.Path(clmp).read_bytes()  # LAMMPS has them since 2023


def start(name, ranks=1, program=clmp, **variables):
    """Runs an input; returns LAMMPS's output."""
    command = ["mpirun", "--oversubscribe", "-np", str(ranks)] if ranks > 1 else []
    command += [program, "-in", name, "-log", "none"]
    if "style" in variables:
        variables["name"] = variables["style"].split()[0]
    for key, value in variables.items():
        command += ["-var", key, str(value)]
    result = subprocess.run(command, cwd=here, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                            text=True, timeout=120, check=False)
    return result.stdout


def run(name, **arguments):
    """Runs an input; returns its thermo tables, one a `run`, as lists of rows."""
    output = start(name, **arguments)
    tables, columns = [], None
    for line in output.splitlines():
        words = line.split()
        if words[:1] == ["Step"]:
            columns = [word.removeprefix("v_").removeprefix("c_").removeprefix("f_") for word in words]
            tables.append([])
        elif line.startswith("Loop time"):
            columns = None
        elif columns and len(words) == len(columns) and words[0].isdigit():
            tables[-1].append(dict(zip(columns, map(float, words))))
        elif line.startswith("ERROR"):
            sys.exit(f"{name} {arguments}: {line}")
    if not tables or not tables[-1]:
        sys.exit(f"{name} {arguments}: no output:\n{output[-2000:]}")
    return tables


def check(name, got, want, tolerance):
    """Numbers that differ by at most tolerance times the expected one."""
    expect(f"{name}: {got:.12g}, expected {want:.12g} within {tolerance:g}", abs(got - want) <= tolerance * abs(want))


def expect(sentence, true):
    global checks, failures
    checks += 1
    if not true:
        failures += 1
        print("FAILED", sentence)


def close(a, b, tolerance, keys=None):
    """Whether two tables agree within tolerance of the largest value of each column."""
    for key in keys or a[0]:
        size = max(abs(row[key]) for row in a)
        if any(abs(p[key] - q[key]) > tolerance * size for p, q in zip(a, b)):
            return False
    return len(a) == len(b)


# The pair of spheres of two.lmp.
young, poisson, density = 29e9, 0.15, 2650.0
r1, r2 = 0.0075, 0.005
effective_radius = r1 * r2 / (r1 + r2)
e_star = young / (2 * (1 - poisson**2))
g_star = young / (4 * (1 + poisson) * (2 - poisson))
mass1, mass2 = (density * 4 / 3 * math.pi * r**3 for r in (r1, r2))
glass = f"young {young:g} poisson {poisson}"


def hertz(overlap, modulus=e_star):
    return 4 / 3 * modulus * math.sqrt(effective_radius) * overlap**1.5


def mindlin(overlap):
    return 8 * g_star * math.sqrt(effective_radius * overlap)


def distance(row):
    return math.sqrt(row["dx"]**2 + row["dy"]**2 + row["dz"]**2)


def normal_force(row):
    return (row["fx"] * row["dx"] + row["fy"] * row["dy"] + row["fz"] * row["dz"]) / distance(row)


def shear_force(row):
    square = row["fx"]**2 + row["fy"]**2 + row["fz"]**2 - normal_force(row)**2
    return math.sqrt(max(square, 0.0))


def test_four_histories():
    """99 um of shear at an overlap of 0.1 mm, then back to 0.05 mm and on to 0.1 mm: the table of four shear histories."""
    full = mindlin(1e-4) * 99e-6
    half, root = 0.5, math.sqrt(0.5)
    kn, kt = 4 / 3 * e_star, 8 * g_star
    rows = [("dry_hill", "mindlin/force", 1, 1), ("dry_hill/rescaled", "mindlin_rescale/force", root, root),
            ("dry_hill/displacement", "mindlin", root, 1), ("dry_hill/displacement_rescaled", "mindlin_rescale", half, root)]
    for law, theirs, backed_off, again in rows:
        granular = run("path.lmp", style="granular",
                       coeff=f"hertz/material {young:g} 0 {poisson} tangential {theirs} NULL 0 10 damping velocity")
        for how in ("scalar", "packs") if law == "dry_hill" else ("packs",):
            ours = run("path.lmp", style=f"contactlaws/{law} {how}", coeff=f"{glass} friction 10")
            for part, factor, back in zip(range(4), (0, 1, backed_off, again), (0, 0, 5e-5, 0)):
                mine, peer = ours[part][-1], granular[part][-1]
                name = f"{law} {how}, part {part}"
                check(f"{name}: normal force", normal_force(mine), hertz(1e-4 - back), 1e-7)
                check(f"{name}: normal force of LAMMPS", normal_force(mine), normal_force(peer), 1e-9)
                if factor:
                    check(f"{name}: shear force", shear_force(mine), factor * full, 1e-7)
                    check(f"{name}: shear force of LAMMPS", shear_force(mine), shear_force(peer), 1e-8)
            if law == "dry_hill/displacement":
                old = run("path.lmp", style=f"gran/hertz/history {kn} {kt} 0 0 10 0", coeff="")
                for part in range(1, 4):
                    check("gran/hertz/history", shear_force(ours[part][-1]), shear_force(old[part][-1]), 1e-8)
    for law in ("dry_hill", "dry_hill/displacement"):
        slid = run("path.lmp", style=f"contactlaws/{law}", coeff=f"{glass} friction 0.4")[1][-1]
        check(f"{law}: slip", shear_force(slid), 0.4 * hertz(1e-4), 1e-7)


def test_partial_slip():
    """99 um of shear at an overlap of 0.1 mm: Mindlin & Deresiewicz's curve; then as one contact at a time."""
    law, friction = "contactlaws/dry_hill/partial_slip", 1.5
    all_slips = friction * e_star / (4 * g_star) * 1e-4
    coeff = f"{glass} friction {friction}"
    packs, scalar = (run("path.lmp", style=f"{law} {how}", coeff=coeff) for how in ("packs", "scalar"))
    row = packs[1][-1]
    check("partial slip", shear_force(row), friction * hertz(1e-4) * (1 - (1 - 99e-6 / all_slips)**1.5), 1e-7)
    expect("partial slip: packs as one by one", all(close(a, b, 1e-10, ("fx", "fz")) for a, b in zip(packs, scalar)))


def test_ranks():
    """A contact that is split between two ranks and changes its owner: as on one rank, to the last digit."""
    for law, more, wet in (("dry_hill", "friction 0.4 damping_constant 0.1", "no"),
                           ("dry_hill/rescaled", "friction 0.4", "no"), ("hill", "friction 0.4 suction 1e6", "yes"),
                           ("rough_ballast", "friction 0.4 fractal_dimension 2.2 roughness 1e-6", "no"),
                           ("dry_hill/partial_slip", "friction 0.4", "no"),
                           ("cohesive_powder", "friction 0.4 rolling_friction 0.1 work_of_adhesion 1", "no"),
                           ("wet_grains", "friction 0.4 surface_tension 0.07 bridge_volume 1e-10", "no")):
        for newton in ("on", "off"):
            one, two = (run("split.lmp", ranks=ranks, px=ranks, newton=newton, wet=wet, style=f"contactlaws/{law}",
                            coeff=f"{glass} {more}", spin="5 40 30") for ranks in (1, 2))
            keys = [k for k in one[0][0] if k not in ("PotEng", "Pxx", "Pyy", "Pzz", "Pxz")]
            expect(f"{law} newton {newton}: two ranks as one", close(one[1], two[1], 0.0, keys))
            expect(f"{law} newton {newton}: energy and pressure", close(one[1], two[1], 1e-12, ["PotEng", "Pxx", "Pyy", "Pzz"]))
            expect(f"{law} newton {newton}: action and reaction", all(
                row["fx"] == -row["f1x"] and row["fy"] == -row["f1y"] and row["fz"] == -row["f1z"] for row in two[1]))
            expect(f"{law} newton {newton}: shears", shear_force(two[1][-1]) > 1)


def bridge_is_right(tables, suction):
    """The pull of a bridge of the memo: psi pi R_o^2 exp(-g / 2 R_o) to a gap of 2 R_o, and none thereafter."""
    largest = suction * math.pi * r2**2
    pulled, pushed = tables[1], tables[2]
    for row, wet in [(r, True) for r in pulled] + [(r, False) for r in pushed]:
        gap = distance(row) - r1 - r2
        wet = wet and gap < 2 * r2
        want = largest * math.exp(-max(gap, 0) / (2 * r2)) if wet else 0.0
        if gap < 0:
            want -= hertz(-gap)
        if abs(-normal_force(row) - want) > 1e-6 * max(largest, abs(want)):
            return False
        if (row["fx"], row["fy"], row["fz"]) != (-row["f1x"], -row["f1y"], -row["f1z"]):
            return False
    return distance(pulled[-1]) > r1 + 3 * r2 and distance(pushed[-1]) < r1 + r2


def test_bridge():
    """From touch to rupture and back, with a skin below and above the range of the bridge."""
    wet = dict(coeff=f"{glass} friction 0.4 suction 1e6")
    for skin in (1e-3, 12e-3):
        for ranks, newton in ((1, "on"), (2, "on"), (2, "off")):
            tables = run("bridge.lmp", style="contactlaws/hill", ranks=ranks, px=ranks, newton=newton, skin=skin, **wet)
            expect(f"bridge, skin {skin}, {ranks} ranks, newton {newton}", bridge_is_right(tables, 1e6))
    one = run("bridge.lmp", program=negated, style="contactlaws/hill/negated", **wet)
    expect("negated transfer: right on one rank", bridge_is_right(one, 1e6))
    two = run("bridge.lmp", program=negated, style="contactlaws/hill/negated", ranks=2, px=2, newton="off", **wet)
    expect("LAMMPS's negated transfer must fail this test", not bridge_is_right(two, 1e6))


soft_young = 1e7
adhesive = dict(work=1.0, modulus=soft_young / 2 / (1 - poisson**2))


def adhesion_is_right(tables, step):
    """No force before touch; JKR's until the pull-off gap; none after it until they touch again."""
    size = 1.5 * math.pi * adhesive["work"] * effective_radius
    holds, pulls, seen = False, [], 0
    for row in [row for table in tables for row in table]:
        overlap = r1 + r2 - distance(row)
        if min(abs(overlap), abs(overlap + jkr_gap(effective_radius, **adhesive))) < step / 2:
            continue  # the very step in which it touches or breaks
        holds = overlap > 0 or holds and overlap > -jkr_gap(effective_radius, **adhesive)
        _, force, energy = jkr(overlap, effective_radius, **adhesive) if holds else (0, 0, 0)
        if abs(normal_force(row) - force) > 1e-5 * size or abs(row["PotEng"] - energy) > 1e-5 * size * 1e-5:
            return False
        if (row["fx"], row["fy"], row["fz"]) != (-row["f1x"], -row["f1y"], -row["f1z"]):
            return False
        pulls.append(-normal_force(row))
        seen += holds and overlap < 0
    return abs(max(pulls) - size) < 1e-5 * size and seen > 900


powder = f"young {soft_young:g} poisson {poisson} work_of_adhesion {adhesive['work']:g}"
around_range = ((1, "on", 1e-3), (2, "on", 1e-3), (2, "off", 1e-3), (1, "on", 1e-6), (2, "off", 1e-6))


def test_adhesion():
    """Cohesive powder, from a gap to touch, to pull-off, and to touch again, with a skin below and above the range of adhesion."""
    step = jkr_gap(effective_radius, **adhesive) / 1000
    for how in ("scalar", "packs"):
        first = None
        for ranks, newton, skin in around_range if how == "packs" else around_range[:1]:
            file = f"{scratch.name}/stretched"
            tables = run("pull.lmp", style=f"contactlaws/cohesive_powder {how}", coeff=f"{powder} friction 0.4", ranks=ranks,
                         px=ranks, newton=newton, skin=skin, step=step, keep="yes", file=file)
            name = f"adhesion {how}, {ranks} ranks, newton {newton}, skin {skin}"
            expect(name, adhesion_is_right(tables, step))
            first = first or tables
            expect(f"{name}: as on one rank", all(close(a, b, 0.0, ("dx", "fx", "f1x")) for a, b in zip(first, tables)))
            again = run("restarted.lmp", ranks=3 - ranks, px=3 - ranks, style="contactlaws/cohesive_powder", file=file,
                        last=1700)[0][0]
            expect(f"{name}: restart of a stretched contact", close([tables[1][-1]], [again], 1e-9, ("dx", "fx")) and again["fx"] < -0.01)
    wrong = dict(program=negated, style="contactlaws/cohesive_powder/negated", coeff=f"{powder} friction 0.4", step=step)
    expect("negated transfer of adhesion: right on one rank", adhesion_is_right(run("pull.lmp", **wrong), step))
    expect("LAMMPS's negated transfer must fail the test of adhesion",
           not adhesion_is_right(run("pull.lmp", ranks=2, px=2, newton="off", **wrong), step))


def test_rolling():
    """The couple of a rolling spring on both spheres: stiffness and limit, with adhesion and without."""
    mu = 0.1
    for work in (0.0, adhesive["work"]):
        for how in ("scalar", "packs"):
            tables = run("roll.lmp", style=f"contactlaws/cohesive_powder {how}",
                         coeff=f"{powder} rolling_friction {mu} work_of_adhesion {work}")
            overlap = r1 + r2 - distance(tables[1][-1])
            a, force, energy = jkr(overlap, effective_radius, work, adhesive["modulus"])
            stiffness = 9 / 4 * 2 * adhesive["modulus"] * a * (mu * effective_radius)**2
            elastic = stiffness * 500 * 100e-6
            limit = mu * effective_radius * (force + 3 * math.pi * work * effective_radius)
            name = f"rolling {how}, work of adhesion {work}"
            expect(f"{name}: the test reaches the limit", elastic < 0.9 * limit < 4 * elastic)
            for part, couple in ((1, elastic), (2, limit)):
                row = tables[part][-1]
                for key, want in (("t2x", -0.6 * couple), ("t2y", -0.8 * couple), ("t1x", 0.6 * couple), ("t1y", 0.8 * couple)):
                    check(f"{name}, part {part}: {key}", row[key], want, 1e-9)
                expect(f"{name}, part {part}: twisting is free", row["t1z"] == row["t2z"] == 0.0)
                check(f"{name}, part {part}: energy", row["PotEng"], energy + couple**2 / (2 * stiffness), 1e-9)


# Bridges of V/R^3 = 0.001 and a contact angle of 20 degrees, R = 2 R*, from the exact solution.
contact_angle, tension = 0.349065850399, 0.07
exact = exact_bridges(contact_angle, 0.001)
rupture = exact[0][3]


def bridge_liquid(radius):
    return 0.001 * (2 * radius)**3


def bridge_is_exact(path, radius):
    """Whether pulls and energies of (gap, pull, energy) are the exact ones, to 0.1 and 0.2 % of the largest. The gaps of the exact
    ones are thousandths of the rupture gap, as those of the path."""
    known = {round(1000 * gap / rupture): (force * tension * 2 * radius, energy * tension * (2 * radius)**2)
             for gap, force, energy, _ in exact}
    found = {round(gap * 1000 / (rupture * 2 * radius)): (pull, energy) for gap, pull, energy in path}
    common = sorted(set(known) & set(found) & set(range(1000)))
    return len(common) > 4 and all(abs(a - b) < tolerance * abs(largest) for k in common for a, b, largest, tolerance in
                                   zip(found[k], known[k], known[0], (1e-3, 2e-3)))


def test_liquid():
    """Wet grains, from a gap to touch, to rupture, and to touch again: the exact bridge, and no liquid lost or made."""
    volume, step = bridge_liquid(effective_radius), rupture * 2 * effective_radius / 1000
    coeff = f"{glass} friction 0.4 surface_tension {tension} contact_angle {contact_angle} bridge_volume {volume}"
    for how in ("scalar", "packs"):
        first = None
        for wet in ("no", "yes"):
            ways = ((1, "on", 2e-3), (2, "on", 2e-3), (2, "off", 2e-3), (1, "on", 1e-5), (2, "off", 1e-5))
            for ranks, newton, skin in ways if how == "packs" and wet == "no" else ways[2:3]:
                name = f"wet grains {how}, wet {wet}, {ranks} ranks, newton {newton}, skin {skin}"
                file = f"{scratch.name}/stretched"
                tables = run("pull.lmp", style=f"contactlaws/wet_grains {how}", coeff=coeff, ranks=ranks, px=ranks, newton=newton,
                             skin=skin, step=step, liquid="yes", wet=wet, keep="yes", file=file)
                gaps = [[distance(row) - r1 - r2 for row in table] for table in tables]
                pulls = [[-normal_force(row) for row in table] for table in tables]
                away = [(gap, pull, row) for table in zip(gaps[1:3], pulls[1:3], tables[1:3]) for gap, pull, row in zip(*table)]
                expect(f"{name}: exact force", bridge_is_exact(
                    [(gap, pull, row["PotEng"]) for gap, pull, row in away if gap > -step / 2], effective_radius))
                broken = [gap for gap, pull, _ in away if pull == 0.0 and gap > step / 2]
                expect(f"{name}: rupture at {min(broken) / step} steps", 999.5 < min(broken) / step < 1001.5)
                expect(f"{name}: no pull before touch, nor after rupture until touch", all(
                    pull == 0.0 for part in (0, 3) for gap, pull in zip(gaps[part], pulls[part])
                    if gap > step / 2 and (part or wet == "no")))
                expect(f"{name}: bridge while touching", all(
                    abs(pull + hertz(-gap) - exact[0][1] * tension * 2 * effective_radius) 
                    < 1e-10 * hertz(-gap) + 1e-3 * exact[0][1] * tension * 2 * effective_radius
                    for part in (0, 1, 3) for gap, pull in zip(gaps[part], pulls[part]) if gap < -step / 2))
                poured = 0.0 if wet == "no" else volume
                for table, where in zip(tables, ("in it", "in it", "none", "in it")):
                    last = table[-1]
                    check(f"{name}: liquid in the bridge + V", volume + last["liquid[4]"], volume * (2 if where == "in it" else 1), 1e-12)
                expect(f"{name}: liquid", all(abs(row["liquid[4]"] + row["liquid[5]"] - poured) < 1e-12 * volume
                                              for table in tables for row in table))
                if wet == "no":
                    first = first or tables
                    expect(f"{name}: as on one rank", all(close(a, b, 0.0, ("dx", "fx", "f1x")) for a, b in zip(first, tables)))
                    again = run("restarted.lmp", ranks=3 - ranks, px=3 - ranks, style="contactlaws/wet_grains", file=file, last=1700)[0][0]
                    expect(f"{name}: restart of a bridge", close([tables[1][-1]], [again], 1e-9, ("dx", "fx")) and again["fx"] < -1e-4)
                    check(f"{name}: liquid after a restart", again["heat[5]"], -volume, 1e-12)


def test_impacts():
    """Restitution, momenta, and heat."""
    for e in (1.0, 0.6):
        for law in ("dry_hill", "hill", "wet_grains"):  # the dashpots of the last do not pull
            after = run("impact.lmp", style=f"contactlaws/{law}", coeff=f"{glass} restitution {e}", steps=30000, ours="yes",
                        dt=5e-9)[0][-1]
            check(f"{law}: restitution", after["v2z"] - after["v1z"], 0.3 * e, 2e-5)
            energy = mass1 * mass2 / (mass1 + mass2) / 2 * 0.3**2
            check(f"{law}: heat of the dashpots", 1 + after["dashpots"] / energy, 2 - e**2, 1e-4)
            mean = (0.1 * mass1 - 0.2 * mass2) / (mass1 + mass2)
            check(f"{law}: speed after a head-on impact", after["v1z"], mean - mass2 / (mass1 + mass2) * 0.3 * e, 1e-4)
    frozen = run("impact.lmp", style="contactlaws/dry_hill", coeff=f"{glass} restitution 0.6", steps=20000, ours="yes",
                 freeze="yes", dt=1e-8)[0][-1]
    check("restitution on a frozen atom", frozen["v2z"], 0.12, 2e-5)

    oblique = dict(coeff=f"{glass} friction 0.3 damping_constant 0.2", ours="yes", off=0.006, spin=-30, steps=20000, dt=1e-8)
    for how in ("scalar", "packs"):
        table = run("impact.lmp", style=f"contactlaws/dry_hill {how}", **oblique)[0]

        def motion(row):
            x2, z2 = row["x1"] + row["dx"], row["z1"] + row["dz"]
            spin1, spin2 = (0.4 * m * r * r * row[w] for m, r, w in ((mass1, r1, "w1"), (mass2, r2, "w2")))
            orbit = mass1 * (row["z1"] * row["v1x"] - row["x1"] * row["v1z"]) + mass2 * (z2 * row["v2x"] - x2 * row["v2z"])
            energy = (mass1 * (row["v1x"]**2 + row["v1z"]**2) + mass2 * (row["v2x"]**2 + row["v2z"]**2) +
                      spin1 * row["w1"] + spin2 * row["w2"]) / 2
            return (mass1 * row["v1x"] + mass2 * row["v2x"], mass1 * row["v1z"] + mass2 * row["v2z"],
                    orbit + spin1 + spin2, energy)

        before, after = motion(table[0]), motion(table[-1])
        expect(f"{how}: off-centre impact turns the spheres", abs(table[-1]["w1"]) > 1)
        for k, scale in enumerate((mass1 * 0.1, mass1 * 0.1, mass1 * 0.1 * r1)):
            check(f"{how}: momentum {k}", after[k] / scale + 1, before[k] / scale + 1, 1e-12)
        heat = table[-1]["friction"] + table[-1]["dashpots"]
        check(f"{how}: heat", heat, before[3] - after[3], 0.05)  # this shear law loses or creates some, as Hertz's k changes
    peer = run("impact.lmp", style="granular", coeff=f"hertz/material {young:g} 0 {poisson} tangential mindlin/force NULL 0 "
               "0.3 damping velocity", **{k: v for k, v in oblique.items() if k not in ("coeff", "ours")}, ours="no")[0][-1]
    mine = run("impact.lmp", style="contactlaws/dry_hill", **dict(oblique, coeff=f"{glass} friction 0.3"))[0][-1]
    for key in ("v1x", "v1z", "v2x", "v2z", "w1", "w2"):  # their spin acts at R, ours at R - o/2
        check(f"off-centre impact beside LAMMPS: {key}", mine[key], peer[key], 1e-3)


def test_still():
    """Set-up passes and queries change nothing; energy, pressure and pair/local are those of the closed forms."""
    mixed = 1 / ((1 - poisson**2) / young + (1 - 0.22**2) / 70e9)
    for how, types, modulus in (("scalar", 1, e_star), ("packs", 1, e_star), ("packs", 2, mixed)):
        name = f"still {how}, {types} types"
        tables = run("still.lmp", style=f"contactlaws/dry_hill {how}", coeff=f"{glass} friction 10", types=types)
        first, last = tables[0][-1], tables[-1][-1]
        for key in ("fx", "fz", "PotEng"):
            check(f"{name}: {key} after set-up passes", last[key], first[key], 1e-12)
        overlap = r1 + r2 - distance(last)
        force, shear = normal_force(last), shear_force(last)
        check(f"{name}: normal force", force, hertz(overlap, modulus), 1e-9)
        check(f"{name}: pair/local normal force", last["queried[1]"], force, 1e-12)
        check(f"{name}: pair/local shear force", last["queried[5]"], shear, 1e-9)
        check(f"{name}: pair/local F_n", last["queried[6]"], force, 1e-12)
        check(f"{name}: pair/local shear vector", last["queried[2]"]**2 + last["queried[4]"]**2, shear**2, 1e-9)
        check(f"{name}: virial zz", last["Pzz"] * last["Volume"], last["dz"] * last["fz"], 1e-12)
        check(f"{name}: virial xz", last["Pxz"] * last["Volume"], last["dx"] * last["fz"], 1e-9)
        if types == 1:
            check(f"{name}: energy", last["PotEng"], 0.4 * force * overlap + shear**2 / (2 * mindlin(overlap)), 1e-9)


def test_restart():
    """From a restart file at any step, on one rank and two, the run goes on as if it had not stopped."""
    keys = ("dx", "dy", "dz", "fx", "fy", "fz")
    for law, more, wet in (("hill", "suction 1e5", "yes"), ("hill scalar", "suction 1e5", "yes"),
                           ("dry_hill/partial_slip", "", "no"), ("cohesive_powder", "rolling_friction 0.1 work_of_adhesion 1", "no"),
                           ("wet_grains", "surface_tension 0.07 bridge_volume 1e-9", "yes")):
        for ranks in (1, 2):
            file = f"{scratch.name}/restart"
            # Soft spheres, so that they touch and stick all the time.
            style = dict(style=f"contactlaws/{law}", coeff=f"young 29e6 poisson 0.15 friction 10 {more}")
            rows = {row["Step"]: row for table in run("restart.lmp", ranks=ranks, px=ranks, file=file, wet=wet, **style) for row in table}
            expect(f"restart of {law}: shears", min(row["dz"] for row in rows.values()) < r1 + r2 - 1e-4 and
                   max(abs(row["fy"]) for row in rows.values()) > 1e-3)
            for step in (200, 300, 301):
                for other in (1, 2):
                    again = [row for row in run("restarted.lmp", ranks=other, px=other, style=style["style"],
                                                file=f"{file}.{step}")[0] if row["Step"] in rows]
                    expect(f"restart of {law} at {step}, {ranks} to {other} ranks",
                           len(again) > 20 and close([rows[row["Step"]] for row in again], again, 1e-9, keys))


def test_restart_of_sums():
    """The sums of `compute pair` go on from those of all ranks: what a restart file holds, and what is added since, to rounding."""
    style, file = "contactlaws/dry_hill", f"{scratch.name}/sums"
    coeff = "young 29e6 poisson 0.15 friction 0.2 damping_constant 0.1"
    for ranks in (1, 2):
        rows = run("restart.lmp", ranks=ranks, px=ranks, x=-1e-4, file=file, wet="no", style=style, coeff=coeff)[-1]
        kept = rows[0]  # of step 301, where the last run begins; by then both ranks have had the contact
        for other in (1, 2):
            again = run("restarted.lmp", ranks=other, px=other, file=f"{file}.301", style=style)[0]
            for heat in ("heat[1]", "heat[2]"):
                expect(f"sums, {ranks} ranks: {heat} before and after", 0 < kept[heat] < 0.9 * rows[-1][heat])
                check(f"sums, {ranks} to {other} ranks: {heat} of the file", again[0][heat], kept[heat], 1e-12)
                check(f"sums, {ranks} to {other} ranks: {heat} at the end", again[-1][heat], rows[-1][heat], 1e-9)


dimension, roughness = 2.2, 2e-5


def rough_depth(overlap):
    """Indentation of a rough surface under virgin loading."""
    beta = 0.2567 * dimension
    p = 2 / (3 * (1 - beta))
    depth_c = roughness * 0.75 * math.sqrt(math.pi) * (20 / (math.pi**1.5 * dimension))**(1 / beta)
    x = overlap / (p * depth_c)
    return depth_c * x**p if x < 1 else depth_c + overlap - p * depth_c


def test_rattle():
    """A rough contact that opens meets fresh surfaces when it closes."""
    depth = rough_depth
    rough = f"contactlaws/pohrt_popov {young:g} 0 {poisson} {dimension} {roughness}"
    ways = [(f"contactlaws/rough_ballast {how}", f"{glass} friction 0.4 fractal_dimension {dimension} roughness {roughness}")
            for how in ("scalar", "packs")]
    if sub_models:
        ways.append(("granular", f"{rough} tangential contactlaws/force 1 0 0.4 damping velocity"))
    for how, coeff in ways:
        tables = run("rattle.lmp", style=how, coeff=coeff)
        virgin, largest, unloaded, _, again = (r1 + r2 - distance(table[-1]) for table in tables)
        for part, d in ((0, depth(virgin)), (1, depth(largest)), (2, depth(largest) - (largest - unloaded)), (4, depth(again))):
            check(f"rough contact {how}, part {part}", normal_force(tables[part][-1]), hertz(d), 1e-8)
        expect("an open rough contact has no force", tables[3][-1]["fz"] == 0.0)


def test_rigid():
    """The effective mass is that of the rigid body."""
    for ranks in (1, 2):
        after = run("rigid.lmp", ranks=ranks, pz=ranks, style="contactlaws/dry_hill", coeff=f"{glass} restitution 0.6")[0][-1]
        check(f"restitution on a rigid body, {ranks} ranks", after["vs"] - after["vb"], 0.12, 1e-3)
        check(f"momentum beside a rigid body, {ranks} ranks", after["vs"] + 2 * after["vb"], -0.2, 1e-9)


def granular(normal="hertz", e=0, tangential="force", ratio="NULL", friction=0.4, damping="velocity"):
    """The same laws as sub-models of LAMMPS."""
    surface = f"{dimension} {roughness}" if normal == "pohrt_popov" else ""
    return (f"contactlaws/{normal} {young:g} {e} {poisson} {surface} tangential contactlaws/{tangential} {ratio} 0 {friction} "
            f"damping {damping}")


def test_sub_models():
    """Sub-models of `pair_style granular` are the pair styles of the same laws, on one rank and on two."""
    if not sub_models:
        print("sub-models: skipped, this LAMMPS has none (they came in 2023)")
        return
    for tangential, law in (("force", "dry_hill"), ("force_rescaled", "dry_hill/rescaled"),
                            ("displacement", "dry_hill/displacement"),
                            ("displacement_rescaled", "dry_hill/displacement_rescaled")):
        for friction in (10, 0.4):
            ours = run("path.lmp", style=f"contactlaws/{law}", coeff=f"{glass} friction {friction}")
            theirs = run("path.lmp", style="granular", coeff=granular(tangential=tangential, friction=friction))
            for part in range(4):
                for key in ("fx", "fz", "f1x", "f1z"):
                    check(f"sub-model {tangential}, friction {friction}, part {part}: {key} + 1 kN",
                          1e3 + theirs[part][-1][key], 1e3 + ours[part][-1][key], 1e-8)
    off_centre = dict(off=0.006, spin=-30, steps=20000, dt=1e-8)
    ours = run("impact.lmp", style="contactlaws/dry_hill", coeff=f"{glass} friction 0.3", ours="yes", **off_centre)[0][-1]
    theirs = run("impact.lmp", style="granular", coeff=granular(friction=0.3), ours="no", **off_centre)[0][-1]
    for key in ("v1x", "v1z", "v2x", "v2z", "w1", "w2"):  # with their arms, as test_impacts() shows, only to 1e-3
        check(f"sub-model, off-centre impact: {key}", theirs[key], ours[key], 1e-9)
    for coeff in (granular("pohrt_popov", ratio=1), granular(tangential="force_rescaled")):
        for newton in ("on", "off"):
            one, two = (run("split.lmp", ranks=ranks, px=ranks, newton=newton, wet="no", style="granular", coeff=coeff)
                        for ranks in (1, 2))
            keys = [k for k in one[0][0] if k not in ("PotEng", "Pxx", "Pyy", "Pzz", "Pxz")]
            expect(f"{coeff}, newton {newton}: two ranks as one", close(one[1], two[1], 0.0, keys))
            expect(f"{coeff}, newton {newton}: shears", shear_force(two[1][-1]) > 1)
    mixed = 1 / ((1 - poisson**2) / young + (1 - 0.22**2) / 70e9)
    second = f"pair_coeff 2 2 contactlaws/hertz 70e9 0 0.22 tangential contactlaws/force NULL 0 10 damping velocity"
    row = run("still.lmp", style="granular", coeff=granular(friction=10), types=2, which="1 1", second=second)[-1][-1]
    check("sub-models of two types: mixed moduli", normal_force(row), hertz(r1 + r2 - distance(row), mixed), 1e-9)


def wall_of(law, more="", shape="zplane 0 NULL"):
    return f"wall/contactlaws/{law} {shape} {glass} {more}"


def sub_model_wall(*arguments, shape="zplane 0 NULL", **named):
    return f"wall/gran granular {granular(*arguments, **named)} {shape}"


def test_walls():
    """Impacts on walls, rest, pressure, history, restart: closed forms, for our fix and for the sub-models."""
    r = 0.005
    mass = density * 4 / 3 * math.pi * r**3

    def push(overlap, modulus=e_star, radius=r):
        return 4 / 3 * modulus * math.sqrt(radius) * overlap**1.5

    def both(ours, theirs):
        return [("fix", dict(wall=ours))] + ([("sub-model", dict(wall=theirs, ours="no"))] if sub_models else [])

    for e in (1.0, 0.6):
        for name, wall in both(wall_of("dry_hill", f"restitution {e}"), sub_model_wall(e=e, damping="coeff_restitution")):
            row = run("wall.lmp", **wall)[0][-1]
            check(f"wall, {name}: restitution", row["vz"], 0.3 * e, 2e-5)
            if name == "fix":
                check("wall: heat of the dashpots", 1 + row["wall[5]"] / (mass * 0.045), 2 - e**2, 1e-4)
    speed, mu = 0.8, 0.2  # slides to the end: 0.8 > 7/2 mu 2 0.1
    for name, wall in both(wall_of("dry_hill", f"friction {mu}"), sub_model_wall(friction=mu)):
        row = run("wall.lmp", vx=speed, vz=-0.1, steps=30000, **wall)[0][-1]
        check(f"wall, {name}: speed after sliding", row["vx"], speed - 2 * mu * 0.1, 1e-5)
        check(f"wall, {name}: spin after sliding", row["wy"], 2.5 * 2 * mu * 0.1 / r, 1e-3)  # the arm is R - overlap/2
        if name == "fix":
            lost = mass * (speed**2 - row["vx"]**2 + 0.01 - row["vz"]**2) / 2 - 0.2 * mass * r**2 * row["wy"]**2
            check("wall: heat of friction", row["wall[4]"], lost, 1e-3)
    soft = "young 1e7 poisson 0.15"
    rest = run("wall.lmp", wall=f"wall/contactlaws/dry_hill zplane 0 NULL {soft} restitution 0.3", gravity=9.81, vz=0, dt=1e-5,
               steps=40000)[0][-1]
    overlap = (mass * 9.81 / push(1, modulus=1e7 / 2 / (1 - poisson**2)))**(2 / 3)
    check("wall: resting sphere", 0.005 - rest["z"], overlap, 1e-5)
    check("wall: carries the weight", -rest["wall[3]"], mass * 9.81, 1e-5)
    check("wall: energy", rest["wall"], 0.4 * mass * 9.81 * overlap, 1e-4)

    # Pressed by 10 um, then sheared by 1 um; the normal force, the shear force and the torque's arm.
    pressed = dict(motion="moved", vz=-0.1, vx=0.01, steps=10000)
    for name, wall in both(wall_of("dry_hill", "friction 10"), sub_model_wall(friction=10)):
        row = run("wall.lmp", **pressed, **wall)[0][-1]
        check(f"wall, {name}: normal force", row["fz"], push(1e-5), 1e-7)
        # k grows with the root of the overlap, and the overlap with the slip: two thirds of the last stiffness times the slip
        check(f"wall, {name}: shear force", -row["fx"], 2 / 3 * 8 * g_star * math.sqrt(r * 1e-5) * 1e-6, 1e-3)
        check(f"wall, {name}: torque", row["ty"], -row["fx"] * r, 2e-3)
    steel = 1 / ((1 - poisson**2) / young + (1 - 0.3**2) / 210e9)
    row = run("wall.lmp", wall=wall_of("dry_hill", "wall_young 210e9 wall_poisson 0.3"), **pressed)[0][-1]
    check("wall of another material", row["fz"], push(1e-5, steel), 1e-7)
    row = run("wall.lmp", wall=wall_of("dry_hill", shape="zcylinder 0.02"), motion="moved", x=0.015, vx=0.1, vz=0,
              steps=10000)[0][-1]
    check("inside a cylinder", -row["fx"], push(1e-5, radius=1 / (1 / r - 0.5 / 0.02)), 1e-7)
    row = run("wall.lmp", wall=wall_of("dry_hill", shape="zcylinder 0.02"), motion="moved", x=0.025, vx=-0.1, vz=0,
              steps=10000)[0][-1]
    check("outside a cylinder", row["fx"], push(1e-5, radius=1 / (1 / r + 0.5 / 0.02)), 1e-7)
    row = run("wall.lmp", wall=wall_of("dry_hill", shape="xplane NULL 0.02"), motion="moved", x=0.015, vx=0.1, vz=0,
              steps=10000)[0][-1]
    check("upper wall", -row["fx"], push(1e-5), 1e-7)
    for name, wall in both(wall_of("rough_ballast", f"fractal_dimension {dimension} roughness {roughness}"),
                           sub_model_wall("pohrt_popov", ratio=1, friction=0)):
        loaded, unloaded = run("wall.lmp", back=1000, **dict(pressed, vx=0), **wall)
        check(f"rough wall, {name}", loaded[-1]["fz"], push(rough_depth(1e-5)), 1e-7)
        check(f"rough wall, {name}: unloading", unloaded[-1]["fz"], push(rough_depth(1e-5) - 1e-6), 1e-6)
    wet = run("wall.lmp", wall=wall_of("hill", "suction 1e5 wet 1e-4"), motion="moved", vz=0.1, steps=10000)[0]
    for row in wet[:1] + wet[-1:]:
        pull = 1e5 * math.pi * r**2 * math.exp(-(row["z"] - r) / (2 * r))
        check("bridge to a wall", -row["fz"], pull, 1e-6)

    # A sphere that shears on the wall and crosses the boundary between ranks; then from a restart file.
    style = dict(wall=f"wall/contactlaws/dry_hill zplane 0 NULL {soft} friction 10", x=-0.001, z=0.00495, vx=2, vz=0, dt=1e-6,
                 steps=2000, keep="yes", file=f"{scratch.name}/wall")
    style["wall"] += " wiggle z 1e-5 3e-3"
    one, two = (run("wall.lmp", ranks=ranks, px=ranks, back=2000, **style) for ranks in (1, 2))
    expect("wall: two ranks as one", close(one[1], two[1], 0.0, ("x", "fx", "fz", "wy")) and abs(one[1][-1]["wy"]) > 1)
    for ranks in (1, 2):
        again = run("wall_restarted.lmp", ranks=ranks, back=2000, **{k: style[k] for k in ("wall", "file")})[0]
        expect(f"wall: restart on {ranks} ranks", close(one[1], again, 1e-9, ("x", "fx", "fz")))


def test_walls_that_pull():
    """Cohesive powder and wet grains on a wall, from touch to where it breaks; the rolling couple; the liquid."""
    r = 0.005
    moved = dict(motion="moved", vx=0, dt=1e-6, every=50, steps=400, back=1600)
    step = jkr_gap(r, **adhesive) / 1000
    for row in [row for table in run("wall.lmp", wall=f"wall/contactlaws/cohesive_powder zplane 0 NULL {powder}", vz=-step / 1e-6,
                                     **moved) for row in table if abs(row["z"] - r) > step / 2]:
        gap = row["z"] - r
        _, force, energy = jkr(-gap, r, **adhesive) if gap < 999 * step else (0, 0, 0)
        size = 1.5 * math.pi * adhesive["work"] * r
        if abs(gap - 1000 * step) > step / 2:
            check(f"adhesion to a wall at {gap / step:g} steps: force + F_c", row["fz"] + size, force + size, 1e-5)
            check(f"adhesion to a wall at {gap / step:g} steps: energy + F_c", row["wall"] + size, energy + size, 1e-9)
    rolled = run("wall.lmp", wall=f"wall/contactlaws/cohesive_powder zplane 0 NULL {powder} rolling_friction 0.1", z=0.0049, vz=0, spin=300,
                 motion="moved", vx=0, dt=1e-6, steps=100)[0][-1]
    stiffness = 9 / 4 * 2 * adhesive["modulus"] * jkr(1e-4, r, **adhesive)[0] * (0.1 * r)**2
    check("rolling on a wall", rolled["ty"], -stiffness * 300 * 1e-4, 1e-9)

    volume, step = bridge_liquid(r), rupture * 2 * r / 1000
    wet = f"surface_tension {tension} contact_angle {contact_angle} bridge_volume {volume}"
    for more, poured in (("", 0), ("wet 0", volume)):
        tables = run("wall.lmp", wall=f"wall/contactlaws/wet_grains zplane 0 NULL {glass} {wet} {more}", vz=-step / 1e-6,
                     **dict(moved, every=10))
        away = [(row["z"] - r, -row["fz"], row["wall"]) for row in tables[1]]
        expect(f"wet wall {more}: exact force", bridge_is_exact([a for a in away if a[0] > -step / 2], r))
        expect(f"wet wall {more}: rupture", all((pull > 0) == (gap < 999 * step) for gap, pull, _ in away
                                                if gap > step / 2 and abs(gap - 1000 * step) > step / 2))
        for where, last in (("in the bridge", tables[0][-1]), ("returned", tables[1][-1])):
            check(f"wet wall {more}: liquid {where}", volume + last["wall[7]"], volume * (2 if where == "in the bridge" else 1), 1e-12)
            check(f"wet wall {more}: sum of liquid", volume + last["wall[7]"] + last["wall[8]"], volume + poured, 1e-12)


def test_moving_walls():
    """Displacement and speed of a wall: closed forms, and wall/gran with the same law; the wall's part in the virial."""
    r = 0.005
    still = dict(motion="moved", vx=0, vz=0, steps=10000)  # the sphere is held, the wall moves for 0.1 ms

    def push(overlap):
        return 4 / 3 * e_star * math.sqrt(r) * overlap**1.5

    for motion, overlap in (("velocity z 0.1", 1e-5), ("wiggle z 5e-6 2e-4", 1e-5), ("wiggle z 1e-5 4e-4", 1e-5)):
        row = run("wall.lmp", wall=wall_of("dry_hill", motion), **still)[0][-1]
        check(f"{motion}: force on a sphere at rest", row["fz"], push(overlap), 1e-7)
    row = run("wall.lmp", wall=wall_of("dry_hill", "restitution 0.6 velocity z 0.3"), vz=0)[0][-1]
    check("a wall that hits a sphere at rest", row["vz"], 0.3 * 1.6, 2e-5)

    # Pressed by 10 um in 0.1 ms while the wall's surface moves: as LAMMPS's own wall of the same law.
    pressed = dict(motion="moved", vz=-0.1, vx=0.01, steps=10000)
    kn, kt = 4 / 3 * e_star, 8 * g_star
    for motion in ("shear x 0.05", "shear y -0.05", "wiggle x 1e-5 3e-4", "wiggle z 3e-6 3e-4"):
        mine = run("wall.lmp", wall=wall_of("dry_hill/displacement", f"friction 10 {motion}"), **pressed)[0][-1]
        peer = run("wall.lmp", wall=f"wall/gran hertz/history {kn} {kt} 1e-9 0 10 0 zplane 0 NULL {motion}", ours="no",
                   **pressed)[0][-1]
        size = math.hypot(mine["fx"], mine["fy"])
        expect(f"{motion}: shears", size > 0.1)
        for key in ("fx", "fy", "fz"):
            check(f"{motion}: {key} beside wall/gran", 2 * size + mine[key], 2 * size + peer[key], 1e-6)
    # Not beside wall/gran hertz/history, whose friction in LAMMPS 4 Feb 2025 is 0.18 of the normal force here.
    row = run("wall.lmp", wall=wall_of("dry_hill/displacement", "friction 0.4 shear x 5"), **pressed)[0][-1]
    check("a wall that slides: friction", row["fx"], 0.4 * row["fz"], 1e-9)
    check("a wall that slides: normal force", row["fz"], push(1e-5), 1e-6)
    round_about = dict(motion="moved", bounds="f f f", x=0.015, vx=0.1, vz=0, steps=10000)
    for motion, key in (("shear x 0.05", "fy"), ("shear z 0.05", "fz"), ("wiggle z 1e-5 3e-4", "fz"), ("velocity z 0.05", "fz")):
        mine = run("wall.lmp", wall=wall_of("dry_hill/displacement", f"friction 10 {motion}", shape="zcylinder 0.02"),
                   **round_about)[0][-1]
        if "velocity" in motion:
            expect("a cylinder that moves drags", mine[key] > 1)
            continue
        if key == "fz":
            check(f"cylinder, {motion}: virial xz", mine["virial[5]"] * mine["Volume"], (mine["x"] - 0.02) * mine["fz"], 1e-9)
        peer = run("wall.lmp", wall=f"wall/gran hertz/history {kn} {kt} 1e-9 0 10 0 zcylinder 0.02 {motion}", ours="no",
                   **round_about)[0][-1]
        # Both forces grow as the root of the effective radius, which wall/gran takes as that of a sphere in a sphere.
        check(f"cylinder, {motion}: {key} beside wall/gran", mine[key] / mine["fx"] * peer["fx"], peer[key], 1e-6)

    row = run("wall.lmp", wall=wall_of("dry_hill", "friction 10"), **pressed)[0][-1]
    check("virial of a wall: zz", row["virial[3]"] * row["Volume"], row["z"] * row["fz"], 1e-9)


def test_yield():
    """Spheres that yield: the heat of yielding is what an impact loses, between spheres and on a wall."""
    metal = "young 70e9 poisson 0.33 yield_pressure 500e6"
    lost = mass1 * mass2 / (mass1 + mass2) / 2 * 0.3**2
    for how in ("scalar", "packs"):
        for ranks, newton in ((1, "on"), (2, "off")):
            table = run("impact.lmp", style=f"contactlaws/plastic_grains {how}", coeff=metal, steps=30000, dt=5e-9, ours="yes",
                        ranks=ranks, px=ranks, newton=newton)[0]
            after = table[-1]
            restitution = (after["v2z"] - after["v1z"]) / 0.3
            expect(f"plastic {how}: loses energy, {restitution}", 0.3 < restitution < 0.9)
            check(f"plastic {how}, {ranks} ranks: heat of yielding", after["yielding"], lost * (1 - restitution**2), 1e-4)
    r = 0.005
    row = run("wall.lmp", wall=f"wall/contactlaws/plastic_grains zplane 0 NULL {metal}", steps=30000)[0][-1]
    kinetic = density * 4 / 3 * math.pi * r**3 * (0.3**2 - row["vz"]**2) / 2
    expect("plastic wall: bounces", 0.03 < row["vz"] < 0.27)
    check("plastic wall: heat of yielding", row["wall[6]"], kinetic, 1e-4)


def test_pour():
    """Wet grains poured, on balanced ranks: none is lost, they come to rest, and early steps agree to rounding."""
    coeff = "young 1e8 poisson 0.2 friction 0.5 restitution 0.5 suction 1e3"
    runs = {}
    for how, ranks in (("scalar", 1), ("packs", 1), ("packs", 2)):
        runs[how, ranks] = run("pour.lmp", style=f"contactlaws/hill {how}", coeff=coeff, ranks=ranks, steps=40000)
    first = runs["scalar", 1][0]
    for key, (poured, wet) in runs.items():
        expect(f"pour {key}: all grains are there", poured[-1]["Atoms"] == 150 == wet[-1]["Atoms"])
        expect(f"pour {key}: early kinetic energy", close(first[:17], poured[:17], 1e-6, ["ke"]))
        expect(f"pour {key}: heat", poured[-1]["heat[1]"] > 0 and poured[-1]["heat[2]"] > 0)
        expect(f"pour {key}: they come to rest", poured[-1]["ke"] < 0.05 * max(row["ke"] for row in poured))
        expect(f"pour {key}: bridges hold them", wet[-1]["PotEng"] < -1e-3 and wet[-1]["ke"] < poured[-1]["ke"])
    # Bridges of a given volume form and rupture, some from rank to rank; `wet` fills those of the last part. 1 mm^3 each.
    coeff = "young 1e8 poisson 0.2 friction 0.5 restitution 0.5 surface_tension 0.07 bridge_volume 1e-9"
    poured, wet = run("pour.lmp", style="contactlaws/wet_grains", coeff=coeff, ranks=2, steps=20000)
    bridges = [row["heat[4]"] / 1e-9 for row in poured]
    expect("pour of wet grains: whole bridges, some of which rupture", max(bridges) > 50 and any(
        b < a for a, b in zip(bridges, bridges[1:])) and all(abs(b - round(b)) < 1e-9 for b in bridges))
    expect("pour of wet grains: no liquid is made", all(abs(row["heat[4]"] + row["heat[5]"]) < 1e-9 * 1e-9 for row in poured))
    sums = [round((row["heat[4]"] + row["heat[5]"]) / 1e-9, 6) for row in wet[1:]]
    expect(f"pour of wet grains: wet pours once, whole bridges, {sums}", sums[0] >= 1 and sums[0] == int(sums[0]) and len(set(sums)) == 1)


def test_readme():
    """The README's example prints what the README says."""
    example = here.parents[2] / "examples" / "hosts" / "lammps"
    printed = [line for line in start(example / "impact.lmp").splitlines() if line.startswith(("they", "a bridge"))]
    expect("README", len(printed) == 2 and all(f"    {line}\n" in (example / "README.md").read_text() for line in printed))


def test_bad_input():
    """LAMMPS's own error, naming what is wrong."""
    good = dict(style="contactlaws/hill", coeff=f"{glass} friction 0.4")
    for change, message in (
            (dict(style="contactlaws/hil"), "Unrecognized pair style 'contactlaws/hil'"),
            (dict(style="contactlaws/hill fast"), "packs or scalar, not 'fast'"),
            (dict(coeff=f"{glass} frction 0.4"), "no parameter 'frction'; there are: damping_constant, friction, suction, decay_length, rupture_gap, restitution, young, poisson, wet"),
            (dict(coeff=f"{glass} friction"), "pairs of a name and a value"),
            (dict(coeff=f"{glass} friction -0.4"), "friction is -0.4, must lie in [0, inf)"),
            (dict(coeff="young -1 poisson 0.2"), "young is -1 Pa, must lie in (0, inf)"),
            (dict(coeff="young 0 poisson 0.2"), "young is 0 Pa, must lie in (0, inf)"),
            (dict(coeff="young 1e9 poisson 0.7"), "poisson is 0.7, must lie in (-1, 0.5]"),
            (dict(coeff=f"{glass} restitution 1.2"), "restitution"),
            (dict(coeff=f"{glass} wet -1"), "wet is -1 m, must lie in [0, inf)"),
            (dict(style="contactlaws/dry_hill", coeff=f"{glass} wet 0"), "no parameter 'wet'"),
            (dict(coeff="poisson 0.2"), "types 1 1: young is missing, must lie in (0, inf) Pa"),
            (dict(coeff="young 1e9"), "types 1 1: poisson is missing, must lie in (-1, 0.5]"),
            (dict(style="contactlaws/rough_ballast"), "fractal_dimension is 0, must lie in [2, 3]"),
            (dict(vel="no"), "comm_modify vel yes")):
        output = start("still.lmp", **dict(good, **change))
        expect(f"{change}: error '{message}' in: {[l for l in output.splitlines() if 'ERROR' in l]}",
               any("ERROR" in line and message in line for line in output.splitlines()) and "terminate called" not in output)
    for wall, message in (
            ("dry_hill zplane 0", "the shape is xplane, yplane or zplane LOW HIGH, or zcylinder RADIUS"),
            ("dry_hill zcylinder -1 young 1e9 poisson 0.2", "radius is -1 m"),
            ("dry_hill zplane 0 NULL poisson 0.2", "young is missing"),
            ("dry_hill zplane 0 NULL young", "a value is missing after young"),
            ("dry_hill zplane 0 NULL young 1e9 poisson 0.2 wall_young 0", "young is 0 Pa, must lie in (0, inf)"),
            ("dry_hill zplane 0 NULL young 1e9 poisson 0.2 wet 0", "no parameter 'wet'"),
            ("dry_hill zplane 0 NULL young 1e9 poisson 0.2 shear z 1", "a plane shears along itself"),
            ("dry_hill zplane 0 NULL young 1e9 poisson 0.2 wiggle w 1 1", "along x, y or z, not 'w'"),
            ("dry_hill zplane 0 NULL young 1e9 poisson 0.2 wiggle z 1", "a value is missing after wiggle"),
            ("dry_hill zplane 0 NULL young 1e9 poisson 0.2 wiggle z 1 0", "period is 0 s, must lie in (0, inf)"),
            ("dry_hill zplane 0 NULL young 1e9 poisson 0.2 velocity z 1 shear x 1", "one motion, not shear too"),
            ("dry_hill zcylinder 1 young 1e9 poisson 0.2 velocity x 1", "a cylinder moves along z"),
            ("hill zplane 0 NULL young 1e9 poisson 0.2 suction -1", "suction is -1 Pa")):
        output = start("wall.lmp", wall=f"wall/contactlaws/{wall}")
        expect(f"wall {wall}: error '{message}' in: {[l for l in output.splitlines() if 'ERROR' in l]}",
               any("ERROR: Fix wall/contactlaws/" in line and message in line for line in output.splitlines()))
    if sub_models:
        for coeff, message in (
                ("contactlaws/hertz -1 0 0.2 tangential contactlaws/force NULL 0 0.4", "young is -1 Pa, must lie in (0, inf)"),
                (f"contactlaws/pohrt_popov {young:g} 0 0.2 3.5 1e-6 tangential contactlaws/force NULL 0 0.4",
                 "fractal_dimension is 3.5, must lie in [2, 3]"),
                (f"contactlaws/hertz {young:g} 0 0.2 tangential contactlaws/force NULL 0 -1", "friction is -1"),
                (f"hertz/material {young:g} 0 0.2 tangential contactlaws/force NULL 0 0.4", "needs a normal model contactlaws/")):
            output = start("still.lmp", style="granular", coeff=coeff)
            expect(f"{coeff}: error '{message}'", "ERROR: Granular sub-model contactlaws/" in output and message in output)
    output = start("no_radius.lmp")
    expect("atoms without radius", "atom_style sphere" in output and "ERROR" in output)


if __name__ == "__main__":
    chosen = sys.argv[3:]
    for name, test in list(globals().items()):
        if name.startswith("test_") and (not chosen or name[5:] in chosen):
            test()
    print(f"{checks - failures} of {checks} checks passed")
    sys.exit(failures > 0)
