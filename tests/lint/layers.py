#!/usr/bin/env python3
"""Reads the headers as text and fails where one breaks a rule:

- includes run downwards, by the table of layers below, and in no circle;
- the core and verify/ include nothing but Eigen and the standard library (scalars/ may include what it adapts);
- mathematics is called unqualified, so that every scalar brings its own: `using std::sqrt; sqrt(x)`;
- a header has one subject, and no more than 300 lines, rarely 250.
"""

import re
import sys
from pathlib import Path

# A folder holds its headers in one layer; these may include each other, but not in a circle.
LAYERS = [
    "core/",
    "kinematics pair step",
    "slot tangential/rotation",
    "normal/ damping/ tangential/ rolling/ bridge/",
    "contact_law",
    "laws batch timestep energy",
    "rows",
    "contactlaws",
    "verify/",
]
LAYER = {name: layer for layer, names in enumerate(LAYERS) for name in names.split()}
LONGEST = 300

MATHEMATICS = """abs fabs sqrt cbrt hypot exp exp2 expm1 log log2 log10 log1p pow sin cos tan asin acos atan atan2
    sinh cosh tanh asinh acosh atanh fma fmin fmax min max floor ceil round copysign isfinite isnan isinf""".split()

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
OUR_OWN = re.compile(r"^(?:contactlaws/)?((?:\w+/)*\w+\.hpp)$")
STANDARD_OR_EIGEN = re.compile(r"^(?:[a-z_0-9]+|Eigen/\w+)$")
QUALIFIED = re.compile(rf"\bstd\s*::\s*({'|'.join(MATHEMATICS)})\s*[(<]")


def without_comments(text):
    keep_lines = lambda comment: "\n" * comment.group().count("\n")
    return re.sub(r"//[^\n]*|/\*.*?\*/", keep_lines, text, flags=re.DOTALL)


def layer_of(name):
    """None: no layer is known."""
    return LAYER.get(name.removesuffix(".hpp"), LAYER.get(name.split("/")[0] + "/"))


def complaints(header, name, includes):
    """Notes the headers that `name` includes in `includes`."""
    text = header.read_text()
    includes[name] = set()
    scalars = name.startswith("scalars/")
    if not scalars and layer_of(name) is None:
        yield 1, "has no layer: give it one in tests/lint/layers.py"
        return
    if text.count("\n") > LONGEST:
        yield 1, f"is longer than {LONGEST} lines"
    for number, line in enumerate(without_comments(text).split("\n"), start=1):
        include = INCLUDE.match(line)
        if include:
            file = include.group(2)
            own = OUR_OWN.match(file)
            if own and not scalars:
                includes[name].add(own.group(1))
                below = layer_of(own.group(1))
                same_folder = "/" in name and own.group(1).split("/")[0] == name.split("/")[0]
                if below is None or below > layer_of(name) or (below == layer_of(name) and not same_folder):
                    yield number, f"includes {file}, which does not lie below it"
            if not own and not scalars and not STANDARD_OR_EIGEN.match(file):
                yield number, f"includes {file}: the core needs Eigen and the standard library only"
        for function in QUALIFIED.findall(line):
            yield number, f"calls std::{function}: write `using std::{function};` and call it unqualified"


def includes_itself(name, includes):
    """Whether the header is reached by its own includes."""
    seen, to_see = set(), list(includes[name])
    while to_see:
        other = to_see.pop()
        if other not in seen:
            seen.add(other)
            to_see += includes.get(other, ())
    return name in seen


root = Path(__file__).resolve().parent.parent.parent / "include" / "contactlaws"
headers = sorted(root.rglob("*.hpp"))
includes = {}
errors = [
    f"{header}:{line}: {complaint}"
    for header in headers
    for line, complaint in complaints(header, header.relative_to(root).as_posix(), includes)
]
errors += [f"{root / name}:1: includes itself, by way of others" for name in includes if includes_itself(name, includes)]
print("\n".join(errors) or f"{len(headers)} headers keep the rules")
sys.exit(bool(errors) or not headers)
