#!/usr/bin/env python3
"""Writes the library as one file, to paste into a program: python3 cmake/single_header.py [HEADER...] > contactlaws.hpp

HEADER is a path in include/, by default contactlaws/contactlaws.hpp and contactlaws/batch.hpp: all but further scalars and the
checks. The file includes Eigen (unless CONTACTLAWS_NO_EIGEN is defined) and the standard library only; with
contactlaws/scalars/xsimd.hpp also xsimd.
"""

import argparse
import re
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
INCLUDE = ROOT / "include"
OURS = re.compile(r'#include "(contactlaws/.+)"')


def text_of(header, written):
    """The header's lines with those of our headers in the place of their first #include; `written` grows."""
    written.add(header)
    for line in (INCLUDE / header).read_text().splitlines():
        included = OURS.fullmatch(line)
        if included and included[1] not in written:
            yield from text_of(included[1], written)
        elif not included and line not in ("#pragma once", "// SPDX-License-Identifier: MIT"):
            yield line


def main(headers):
    yield from (f"// {line}".rstrip() for line in (ROOT / "LICENSE").read_text().splitlines())
    yield "// The headers of contactlaws as one file, written by cmake/single_header.py: change them, not this."
    yield "#pragma once"
    written = set()
    for header in headers:
        if header not in written:
            yield from text_of(header, written)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("headers", nargs="*", metavar="HEADER", default=["contactlaws/contactlaws.hpp", "contactlaws/batch.hpp"])
    given = parser.parse_args().headers
    for header in given:
        if not (INCLUDE / header).is_file():
            parser.error(f"include/ has no {header}")
    print("\n".join(main(given)))
