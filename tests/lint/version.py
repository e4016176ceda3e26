#!/usr/bin/env python3
"""The files that state a version state that of core/version.hpp."""

import json
import re
import sys
from pathlib import Path

root = Path(__file__).resolve().parent.parent.parent
header = (root / "include/contactlaws/core/version.hpp").read_text()
version = ".".join(re.findall(r"CONTACTLAWS_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)", header))
stated = {
    "cmake/vcpkg/contactlaws/vcpkg.json": json.loads((root / "cmake/vcpkg/contactlaws/vcpkg.json").read_text())["version"],
    "CITATION.cff": re.search(r"^version: (.+)$", (root / "CITATION.cff").read_text(), re.MULTILINE)[1],
}
wrong = [f"{file} states version {other}, core/version.hpp {version}" for file, other in stated.items() if other != version]
sys.exit("\n".join(wrong) or 0)
