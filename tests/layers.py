#!/usr/bin/env python3
"""Reads the headers as text and fails where one breaks a rule of the house:

- includes run strictly downwards, by the table of layers below;
- the core and verify/ include nothing but Eigen and the standard library (scalars/ may include what it adapts);
- mathematics is called unqualified, so that every scalar brings its own: `using std::sqrt; sqrt(x)`;
- a header has one subject, and no more than 250 lines.
"""

import re
import sys
from pathlib import Path

LAYERS = [
    "core/config core/version",
    "core/scalar",
    "core/parameter core/power",
    "core/validate kinematics",
    "pair tangential/rotation slot",
    "normal/linear normal/hertz damping/dashpots tangential/incremental_shear bridge/suction_bridge",
    "normal/pohrt_popov contact_law damping/restitution",
    "laws batch timestep energy",
    "contactlaws",
    "verify/force_update verify/options",
    "verify/path verify/adapt",
    "verify/report verify/reduce verify/random_paths",
    "verify/setup",
    "verify/checks/symmetries verify/checks/limits verify/checks/friction verify/checks/histories verify/checks/energies",
    "verify/checks/impacts",
    "verify/verify",
]
LAYER = {f"{name}.hpp": layer for layer, names in enumerate(LAYERS) for name in names.split()}
LONGEST = 250

MATHEMATICS = """abs fabs sqrt cbrt hypot exp exp2 expm1 log log2 log10 log1p pow sin cos tan asin acos atan atan2
    sinh cosh tanh asinh acosh atanh fma fmin fmax min max floor ceil round copysign isfinite isnan isinf""".split()

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
OUR_OWN = re.compile(r"^(?:contactlaws/)?((?:\w+/)*\w+\.hpp)$")
STANDARD_OR_EIGEN = re.compile(r"^(?:[a-z_0-9]+|Eigen/\w+)$")
QUALIFIED = re.compile(rf"\bstd\s*::\s*({'|'.join(MATHEMATICS)})\s*[(<]")


def without_comments(text):
    keep_lines = lambda comment: "\n" * comment.group().count("\n")
    return re.sub(r"//[^\n]*|/\*.*?\*/", keep_lines, text, flags=re.DOTALL)


def complaints(header, name):
    text = header.read_text()
    scalars = name.startswith("scalars/")
    if not scalars and name not in LAYER:
        yield 1, "has no layer: give it one in tests/layers.py"
        return
    if text.count("\n") > LONGEST:
        yield 1, f"is longer than {LONGEST} lines"
    for number, line in enumerate(without_comments(text).split("\n"), start=1):
        include = INCLUDE.match(line)
        if include:
            file = include.group(2)
            own = OUR_OWN.match(file)
            if own and not scalars and LAYER.get(own.group(1), len(LAYERS)) >= LAYER[name]:
                yield number, f"includes {file}, which does not lie below it"
            if not own and not scalars and not STANDARD_OR_EIGEN.match(file):
                yield number, f"includes {file}: the core needs Eigen and the standard library only"
        for function in QUALIFIED.findall(line):
            yield number, f"calls std::{function}: write `using std::{function};` and call it unqualified"


root = Path(__file__).resolve().parent.parent / "include" / "contactlaws"
headers = sorted(root.rglob("*.hpp"))
errors = [
    f"{header}:{line}: {complaint}"
    for header in headers
    for line, complaint in complaints(header, header.relative_to(root).as_posix())
]
print("\n".join(errors) or f"{len(headers)} headers keep the rules")
sys.exit(bool(errors) or not headers)
