#!/usr/bin/env python3
"""Writes what Doxygen reads into OUT: the headers, a page for each law, and the repository's Markdown files.

    pages.py LAWS.json OUT

LAWS.json is what laws.cpp prints. A file that a page links to is copied into OUT/html/files, for those that are not pages themselves.
"""

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
INCLUDE = ROOT / "include"
SLOTS = {"normal": "normal", "damping": "damping", "tangential": "shear", "bridge": "bridge", "rolling": "rolling"}
# Headers of the slots that are no law by themselves.
PARTS = {"damping/restitution.hpp", "tangential/rotation.hpp", "tangential/spring_row.hpp", "bridge/bridge_force.hpp",
         "bridge/young_laplace_table.hpp"}
# Laws of law files that are not in include/.
ELSEWHERE = {"none", "pohrt_popov_incremental"}

# Members that all slots have. They are written once here, as slot.hpp states them once.
MEMBERS = {
    r"using Slot = ": "The slot that it fills.",
    r"using Scalar = ": "The type of its numbers.",
    r"using Rebind = ": "The same on another scalar.",
    r"static constexpr auto parameters\(\)|static constexpr std::array<Parameter": "Name, unit, member and range of each parameter.",
    r"static constexpr auto state_values\(\)|static constexpr std::array<StateValue": "Name, unit, kind and exchange sign of each value of the history.",
    r"static constexpr const char\* name\b": "Its name in messages.",
    r"static constexpr bool acts\b": "False for an empty slot.",
    r"static constexpr bool adheres\b": "Whether it may pull.",
    r"static constexpr bool outlives_separation\b": "Whether its history survives separation.",
    r"static constexpr bool damps_shear\b": "Whether it damps shear.",
    r"struct (CONTACTLAWS_EMPTY_BASES )?State\b|using State = ": "The history of one contact; new when all is zero.",
    r"\brespond\(": "Response to a step; updates the history. See slot.hpp.",
    r"\bT energy\(": "Energy stored [J].",
    r"\bT stiffness\(": "Stiffness [N/m]; of rolling and twisting [N m].",
    r"\btouches\(": "Whether the contact holds.",
    r"\bT range\(": "The largest gap across which it holds [m].",
    r"\bis_wet\(": "Whether the contact carries a bridge.",
    r"void prepare\(": "Computes what follows from the parameters.",
    r"ByName by_name\b": "Properties are assigned by name.",
    r"\bcast\(\) const": "The same, of another scalar.",
    r"\bcoefficients\(": "Coefficients of the dashpots.",
    r"\bT normal_force\(": "Normal force of spring and dashpot [N].",
    r"\bstiffness_factor\(": "What a dashpot adds to the stiffness, for the time step.",
    r"\bPairProperties<T>&? pair;": "The pair of bodies.",
    r"\bContactKinematics<T>&? kinematics;": "The motion over the step.",
    r"\bmake_wet\(|\bmake_dry\(": "Wets or dries the contact; the next step computes the force.",
    r"static Law of\(|parameters_of\(": "Of the laws that have this profile.",
    r"const char\* (name|unit) = ": "See Parameter and StateValue.",
    # Of scalars (ScalarTraits of core/scalar.hpp and its like).
    r"using (T|Type|type|Pack|Number|Value|Mask|Lane|Bits|Traits) = ": "A type of this scalar.",
    r"static constexpr std::size_t lanes\b": "How many numbers a value holds.",
    r"static constexpr bool known\b": "Whether its bits are known.",
    r"static .*\bselect\(": "yes where the condition holds, else no.",
    r"static .*\bany\(": "Whether it holds in any lane.",
    r"static .*\ball\(": "Whether it holds in every lane.",
    r"static .*\bnegate\(": "Where it does not hold.",
    r"static .* (load|store)\(": "From or to an array of numbers.",
    r"static .*\b(bits|number|nearest)\(": "Its bits; the number of bits; the nearest whole number.",
    # Of friction, rotation and bridge rules.
    r"\bsticking_limit\(": "The largest force that sticks [N].",
    r"\bsliding_force\(": "The force while sliding [N].",
    r"\bset_sliding\(": "Stores whether it slides.",
    r"\bapply\(": "Turns the history with the contact plane.",
    r"\brolling_stiffness_of\(": "k_r [N m].",
    r"\breach\(": "Largest couple over the load [m].",
    r"\bviscosity\(": "Couple over spin [N m s].",
    r"\bT rupture\(": "The rupture gap over the radius, from q.",
    r"\bis_ruptured\(": "Whether the gap is beyond rupture.",
    r"\bforce_at_touch\(": "The force at touch over 2 pi R gamma.",
    r"\bT force\(const T& ?q?, const T& gap": "The force over that at touch.",
    r"\bwork_to_rupture\(": "The work to rupture, in units of the force times the length.",
}


def head_of(text):
    """The comment at the head of a header, without slashes, and the number of its first and last line."""
    lines = text.split("\n")
    start = 1
    end = start
    while lines[end].startswith("//"):
        end += 1
    return [line[3:] for line in lines[start:end]], start, end


def in_doxygen(head):
    """Lines of a head; those that are indented keep their shape."""
    shown, drawn = [], []
    for line in [*head, "end"]:
        if line.startswith(" ") or (drawn and not line):
            drawn.append(line)
            continue
        if drawn:
            while drawn and not drawn[-1]:
                drawn.pop()
            shown += ["", "```{.unparsed}", *drawn, "```", ""]
            drawn = []
        if re.match("(Domain|Error|History|Energy|Decided|Source)\\b", line):
            shown.append("")
        shown.append(line)
    return [escaped(line) if not line.startswith((" ", "`")) else line for line in shown[:-1]]


def escaped(text):
    """Text of a comment, in which < and * mean themselves; no word is a link by accident."""
    return re.sub(r"([<>*\\@#_~])", r"\\\1", text)


def with_members(header, lines):
    """The lines of a header, with a sentence above each member that slot.hpp describes and each type that the head describes."""
    shown = []
    types = re.compile(r"(struct|class|enum class) [^;]*$")
    for line in lines:
        if types.match(line):
            above = len(shown)
            while shown[above - 1].startswith(("template <", "        ")):
                above -= 1
            if not shown[above - 1].startswith("///"):
                special = re.match(r"(struct|class) \w+<", line)
                shown.insert(above, "/// For this scalar, as the primary template says." if special else f"/// See the head of {header.name}.")
        for pattern, says in MEMBERS.items():
            if not re.match(r" +\w", line) or "///" in line or line.lstrip().startswith("return") or not re.search(pattern, line):
                continue
            above = len(shown)
            while re.match(r" +template <", shown[above - 1]) or shown[above - 1].endswith(","):
                above -= 1
            if "///" not in shown[above - 1] or "///<" in shown[above - 1]:
                shown.insert(above, f"  /// {says}")
            break
        shown.append(line)
    return shown


def write_headers(out):
    for header in sorted(INCLUDE.rglob("*.hpp")):
        text = header.read_text()
        head, start, end = head_of(text)
        lines = text.split("\n")
        comment = ["/// @file", *("/// " + line for line in in_doxygen(head))]
        target = out / "include" / header.relative_to(INCLUDE)
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text("\n".join([*lines[:start], *comment, *with_members(header, lines[end:])]))


# Pages of laws ---------------------------------------------------------------------------------------------------------


def table(header, rows):
    line = lambda cells: "| " + " | ".join(cells) + " |\n"
    return line(header) + line(["---"] * len(header)) + "".join(line(row) for row in rows)


def law_id(header):
    return "law_" + header.replace("/", "_").removesuffix(".hpp")


def draw(page, file):
    import matplotlib

    matplotlib.use("svg")
    matplotlib.rcParams.update({"svg.hashsalt": "contactlaws", "font.size": 11})
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(figsize=(5, 3.4), layout="constrained")
    for curve, style in zip(page["curves"], ("-", "--", "-.", ":")):
        axes.plot(curve["x"], curve["y"], style, label=curve["label"])
    axes.set_xlabel(page["x"])
    axes.set_ylabel(page["y"])
    axes.axhline(0.0, color="0.8", linewidth=0.8, zorder=0)
    axes.legend(frameon=False, fontsize=9)
    figure.savefig(file, metadata={"Date": None})
    plt.close(figure)


def parameters_of(key, keys):
    rows = []
    for one in keys["keys"]:
        if "words" in one:
            allowed = ", ".join(f'`"{word}"`' for word in one["words"])
            rows.append([f"`{one['name']}`", "", f"{allowed} (the first is the default)", escaped(one["says"])])
        elif "flag" in one:
            rows.append([f"`{one['name']}`", "", "true, false (the default)", escaped(one["says"])])
        else:
            says = ("required" if one["required"] else "") + ("; " if one["required"] and one["says"] else "") + one["says"]
            rows.append([f"`{one['name']}`", *map(escaped, (one["unit"], one["range"], says))])
    text = f"\n`law = \"{key}\"`: {escaped(keys['says'])}\n\n"
    if rows:
        text += table(["parameter", "unit", "range", ""], rows)
    if keys["reads"]:
        text += "\nReads of the pair: " + ", ".join(f"`{name}`" for name in keys["reads"]) + ".\n"
    return text


def compositions():
    """The ready-made laws and the slot types in them, from laws.hpp."""
    text = (INCLUDE / "contactlaws/laws.hpp").read_text()
    return {name: set(re.findall(r"\w+", law)) for name, law in re.findall(r"using (\w+) =\s+ContactLaw<(.+?)>;", text, re.S)}


def costs():
    """The rows of the README's table of laws, by name, and its header."""
    lines = (ROOT / "README.md").read_text().split("\n")
    start = next(i for i, line in enumerate(lines) if line.startswith("| law | normal |"))
    cells = lambda line: [cell.strip() for cell in line.strip("| ").split("|")]
    rows = {}
    for line in lines[start + 2:]:
        if not line.startswith("|"):
            break
        row = cells(line)
        rows[row[0].strip("`")] = row
    return cells(lines[start]), rows


def elsewhere(types):
    """Rows of docs/parameters_elsewhere.md whose slots name one of the types."""
    rows = []
    for line in (ROOT / "docs/parameters_elsewhere.md").read_text().split("\n"):
        cells = [cell.strip() for cell in line.strip("| ").split("|")]
        if line.startswith("|") and len(cells) == 5 and types & set(re.findall(r"\w+", cells[3])):
            rows.append([cells[0], cells[1], cells[4]])
    return rows


def write_laws(data, out):
    headers = {str(file.relative_to(INCLUDE / "contactlaws")) for folder in SLOTS for file in (INCLUDE / "contactlaws" / folder).glob("*.hpp")}
    if headers - PARTS != set(data["pages"]):
        sys.exit(f"laws.cpp and the folders of the slots differ in {sorted((headers - PARTS) ^ set(data['pages']))}")
    named = {(SLOTS[header.split("/")[0]], key) for header, page in data["pages"].items() for law in page["laws"] for key in law["keys"]}
    listed = {(slot, key) for slot, laws in data["keys"].items() for key in laws if key not in ELSEWHERE}
    if named != listed:
        sys.exit(f"laws.cpp and the table of law files differ in {sorted(named ^ listed)}")

    ready, (cost_header, cost_rows) = compositions(), costs()
    index = {slot: [] for slot in SLOTS.values()}
    for header, page in data["pages"].items():
        slot = SLOTS[header.split("/")[0]]
        types = [law["type"] for law in page["laws"]]
        head, _, _ = head_of((INCLUDE / "contactlaws" / header).read_text())
        figure = law_id(header) + ".svg"
        draw(page, out / "html" / figure)
        text = f"# {', '.join(types)} {{#{law_id(header)}}}\n\n"
        text += f"Header @ref contactlaws/{header}, slot \"{slot}\". Its head says:\n\n"
        text += "\n".join(in_doxygen(head)) + "\n\n"
        text += f'<img src="{figure}" alt="{page["y"]} over {page["x"]}: {page["shows"]}"/>\n\n'
        text += f"{page['shows'][0].upper()}{page['shows'][1:]}. Computed by the law itself, between two spheres of glass of 2 mm.\n\n"
        text += "## Parameters\n\nIn a law file (@ref md_examples_contact_path_README); in C++ the members of the same names.\n"
        for law in page["laws"]:
            for key in law["keys"]:
                if key not in text.split("## Parameters")[1]:
                    text += parameters_of(key, data["keys"][slot][key])
        text += "\n## History\n\n"
        rows = [[f"`{law['type']}`", f"`{value['name']}`", value["unit"], str(value["exchange_sign"])] for law in page["laws"] for value in law["state"]]
        text += table(["law", "value", "unit", "sign when the bodies are swapped"], rows) if rows else "None.\n"
        text += "\n## Cost\n\n"
        uses = [name for name, slots in ready.items() if name in cost_rows and slots & set(types)]
        if uses:
            text += "In ready-made laws, from the README's table; its conditions are there (@ref index_laws).\n\n"
            text += table([cost_header[0], *cost_header[-4:]], [[cost_rows[name][0], *cost_rows[name][-4:]] for name in uses])
        else:
            text += "No ready-made law has it, so no figure is published.\n"
        text += "\n## In other codes\n\n"
        rows = elsewhere(set(types))
        if rows:
            text += "From @ref md_docs_parameters_elsewhere, which says what the letters mean.\n\n"
            text += table(["code", "model", "set"], rows)
        else:
            text += "No row in @ref md_docs_parameters_elsewhere.\n"
        (out / "pages" / (law_id(header) + ".md")).write_text(text)
        index[slot].append((law_id(header), ", ".join(types), re.split(r"[:;]|\. ", " ".join(head))[0]))

    text = "# Laws {#laws}\n\nA law is composed of five slots; @ref md_docs_choose says which to take.\n"
    for slot, pages in index.items():
        text += f"\n## Slot \"{slot}\" {{#laws_{slot}}}\n\n" + "".join(f'- @subpage {page} "{title}": {escaped(first)}\n' for page, title, first in sorted(pages))
    (out / "pages" / "laws.md").write_text(text)


# Markdown files --------------------------------------------------------------------------------------------------------


def page_id(file):
    return "index" if file == "README.md" else "md_" + file.removesuffix(".md").replace("/", "_").replace(".", "")


def slug(heading):
    """GitHub's name of a heading."""
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")


def anchor(file, fragment):
    return f"{page_id(file)}_{fragment.replace('-', '_')}" if fragment else page_id(file)


class Site:
    def __init__(self, out):
        self.out = out
        tracked = subprocess.run(["git", "-C", ROOT, "ls-files", "--cached", "--others", "--exclude-standard"], check=True,
                                 capture_output=True, text=True).stdout.split("\n")
        self.files = {file for file in tracked if file}
        self.folders = {str(parent) for file in self.files for parent in Path(file).parents}
        self.pages = sorted(file for file in self.files if file.endswith(".md"))
        self.guides = [file for file in self.pages if file.startswith("docs/") and file != "docs/README.md"]

    def write(self):
        for file in self.pages:
            (self.out / "pages" / (page_id(file) + ".md")).write_text(self.converted(file))

    def converted(self, file):
        text = (ROOT / file).read_text()
        parts = re.split(r"(^```.*?^```$)", text, flags=re.M | re.S)  # code keeps its text
        first = True
        for i in range(0, len(parts), 2):
            lines = []
            for line in parts[i].split("\n"):
                heading = re.fullmatch(r"(#+) (.+)", line)
                if heading:
                    name = page_id(file) if first else anchor(file, slug(heading[2]))
                    line = f"{heading[1]} {heading[2]} {{#{'mainpage' if name == 'index' else name}}}"
                    first = False
                elif line.startswith("<!--"):
                    continue
                elif not line.startswith("    "):
                    line = self.with_links(file, line)
                lines.append(line)
            parts[i] = "\n".join(lines)
        return "".join(parts)

    def with_links(self, file, line):
        def picture(match):
            target = os.path.normpath(Path(file).parent / match[2])
            shutil.copy(ROOT / target, self.out / "html" / target.replace("/", "_"))
            return f'<img src="{target.replace("/", "_")}" alt="{match[1]}"/>'

        def link(match):
            return self.link(file, match[1], match[2])

        line = re.sub(r"!\[([^\]]*)\]\(([^)]+)\)", picture, line)
        return re.sub(r"(?<!!)\[([^\]]+)\]\(([^)\s]+)\)", link, line)

    def link(self, file, text, target):
        if re.match(r"https?:|mailto:", target):
            return f"[{text}]({target})"
        path, _, fragment = target.partition("#")
        path = os.path.normpath(Path(file).parent / path) if path else file
        if path in self.pages:
            kind = "@subpage" if file == "docs/README.md" and path in self.guides else "@ref"
            return f'{kind} {anchor(path, fragment)} "{text}"'
        if path.startswith("include/") and path.endswith(".hpp"):
            return f'@ref {path.removeprefix("include/")} "{text}"'
        if path in self.files:
            copied = self.out / "html" / "files" / (path + ".txt")
            copied.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / path, copied)
            return f'<a href="files/{path}.txt">{text}</a>'
        if path in self.folders:
            return text
        sys.exit(f"{file} links to {target}, which is not there")


def main(laws, out):
    out = Path(out)
    shutil.rmtree(out / "pages", ignore_errors=True)
    shutil.rmtree(out / "html", ignore_errors=True)
    for folder in ("pages", "html"):
        (out / folder).mkdir(parents=True)
    write_headers(out)
    write_laws(json.loads(Path(laws).read_text()), out)
    Site(out).write()


if __name__ == "__main__":
    main(*sys.argv[1:])
