#!/usr/bin/env python3
"""The README's program is examples/first_contact.cpp, word for word, and prints what the README says it prints."""

import subprocess
import sys
import tempfile
from pathlib import Path

compiler, *flags = sys.argv[1:]
root = Path(__file__).resolve().parent.parent.parent
readme = (root / "README.md").read_text()
shown = readme.split("```cpp\n")[1].split("```")[0]
said = readme.split("```")[2].strip().split("\n")[0]
example = root / "examples" / "first_contact.cpp"
written = "".join(line for line in example.open() if not line.startswith("//"))
if shown != written:
    sys.exit("README.md and examples/first_contact.cpp show different programs")
with tempfile.TemporaryDirectory() as folder:
    program = Path(folder) / "program"
    subprocess.run([compiler, "-std=c++17", f"-I{root}/include", *flags, str(example), "-o", str(program)], check=True)
    printed = subprocess.run([program], check=True, capture_output=True, text=True).stdout.strip()
if printed != said:
    sys.exit(f"README.md says\n  {said}\nbut the program prints\n  {printed}")
