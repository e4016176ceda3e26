#!/usr/bin/env python3
"""The programs of the README and of docs/ compile, and print what the text says.

    readme.py COMPILER OPTIONS_THAT_FIND_EIGEN...

A program is a block of C++ with a main(); the indented block that follows is what it prints. That of the README is
examples/first_contact.cpp, word for word. A block without main() is no program: that of docs/gpu.md is compiled by tests/gpu.
"""

import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

compiler, *flags = sys.argv[1:]
root = Path(__file__).resolve().parent.parent.parent


def programs():
    """File, program, what it should print, and whether to compile it without Eigen, in a third of the time: the README's both ways."""
    for file in (root / "README.md", *sorted((root / "docs").glob("*.md"))):
        for shown, after in re.findall(r"^```cpp\n((?:.*\n)*?)```\n\n?((?:    .*\n)*)", file.read_text(), re.M):
            if "int main(" in shown:
                said = "".join(line[4:] for line in after.splitlines(keepends=True))
                needs_eigen = "contactlaws/verify/" in shown
                yield file, shown, said, not needs_eigen
                if file.name == "README.md":
                    yield file, shown, said, False


def fault(given):
    file, shown, said, without_eigen = given
    with tempfile.TemporaryDirectory() as folder:
        source, program = Path(folder) / "program.cpp", Path(folder) / "program"
        source.write_text(shown)
        options = ["-std=c++17", "-O0", "-DCONTACTLAWS_INLINE=inline", f"-I{root}/include", *flags]
        options += ["-DCONTACTLAWS_NO_EIGEN"] if without_eigen else []
        built = subprocess.run([compiler, *options, source, "-o", program], capture_output=True, text=True)
        if built.returncode != 0:
            return f"{file.relative_to(root)}: its program does not compile\n{built.stderr}"
        printed = subprocess.run([program], capture_output=True, text=True).stdout
    if printed.strip() != said.strip():
        return f"{file.relative_to(root)} says\n{said}but its program prints\n{printed}"
    return None


readme_program = (root / "README.md").read_text().split("```cpp\n")[1].split("```")[0]
example = "".join(line for line in (root / "examples" / "first_contact.cpp").open() if not line.startswith("//"))
faults = [] if readme_program == example else ["README.md and examples/first_contact.cpp show different programs"]
all_programs = list(programs())
if len(all_programs) < 6:
    faults.append(f"only {len(all_programs)} programs found")
with ThreadPoolExecutor(2) as pool:
    faults += filter(None, pool.map(fault, all_programs))
print(f"{len(all_programs)} programs")
sys.exit("\n".join(faults) or 0)
