"""Shared by the figure scripts of the examples: style of the figures, reading of results, the page that shows them all.

Each script writes its own section; build/results/index.html is made of the sections that exist.
"""

import argparse
import html
import re
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from files import Table, fail, write, write_figure

COMPUTED, OTHER, PUBLISHED, LIGHT = "#1f4e79", "#c0504d", "#7f7f7f", "#5b9bd5"
plt.rcParams.update({
    "figure.dpi": 100, "savefig.dpi": 200, "font.size": 9, "axes.titlesize": 9, "axes.titleweight": "bold",
    "axes.spines.top": False, "axes.spines.right": False, "axes.linewidth": 0.8, "axes.grid": True,
    "grid.color": "#e6e6e6", "grid.linewidth": 0.6, "axes.axisbelow": True, "lines.linewidth": 1.8,
    "legend.frameon": False, "legend.fontsize": 8, "mathtext.default": "regular", "figure.constrained_layout.use": True,
})

SECTIONS = ["drop", "memo", "class5", "ballast", "probe", "capillary"]  # in the order of the page
NUMBERS = ["expected", "computed", "relative_error", "tolerance"]

PAGE = """<!doctype html>
<html lang="en"><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>Published problems, computed by contactlaws</title>
<style>
  body {{ font: 16px/1.5 system-ui, sans-serif; color: #222; max-width: 62rem; margin: 2rem auto; padding: 0 1rem; }}
  h1 {{ font-size: 1.5rem; margin-top: 3rem; }} h2 {{ font-size: 1.15rem; margin-top: 2.2rem; }}
  .wide {{ overflow-x: auto; }} nav li {{ margin: .3rem 0; }} .data {{ font-size: .86rem; }}
  table {{ border-collapse: collapse; font-size: .86rem; width: 100%; }}
  th, td {{ padding: .22rem .6rem; border-bottom: 1px solid #e4e4e4; text-align: right; font-variant-numeric: tabular-nums; }}
  th:first-child, td:first-child, td.source {{ text-align: left; }} td.source {{ min-width: 9rem; }} th {{ border-bottom: 2px solid #999; }}
  .yes {{ color: #2e7d32; }} .no {{ color: #c62828; font-weight: bold; }}
  figure {{ margin: 2rem 0; }} figcaption {{ color: #444; }} img {{ max-width: 100%; height: auto; }}
</style>
<nav><h1>Published problems, computed by contactlaws</h1>
<ul>
{contents}
</ul></nav>
{sections}
</html>
"""


class Folder:
    """The folder of the results, and the names of the files that were read from it."""

    def __init__(self, folder):
        self.folder, self.read = Path(folder), []

    def table(self, name):
        self.read += [] if f"{name}.csv" in self.read else [f"{name}.csv"]
        return Table(self.folder / f"{name}.csv")

    def columns(self, name):
        return Columns(self.table(name))


class Results(Folder):
    """The files of one example in a folder: `<name>.csv` holds its numbers, others hold curves."""

    def __init__(self, folder, name):
        super().__init__(folder)
        self.name = name
        self.by_id = {row["id"]: row for row in self.rows(name)}

    def rows(self, name):
        table = self.table(name)
        for column in ["computed"] if "low" in table else NUMBERS:
            table.numbers(column)  # or fail
        for column in ("id", "unit", "published", "pass", *([] if "low" in table else ["source"])):
            if column not in table:
                fail(table.file, f"column {column} is missing")
        return table.rows()

    def number(self, identity, column):
        file = self.folder / f"{self.name}.csv"
        if identity not in self.by_id:
            fail(file, f"no row has the id {identity}")
        try:
            return float(self.by_id[identity][column])
        except ValueError:
            fail(file, f"{identity}: column {column} is {self.by_id[identity][column]!r}, must be a number")

    def computed(self, identity):
        return self.number(identity, "computed")

    def published(self, identity):
        return self.number(identity, "published")


class Columns(dict):
    """The columns of a table by name, as arrays."""

    def __init__(self, table):
        super().__init__((column, np.array(table.numbers(column))) for column in table.header)
        self.file = table.file

    def __missing__(self, column):
        fail(self.file, f"column {column} is missing")


def read_results(name, description):
    """The results in the folder that the command line names."""
    return Results(folder_argument(description), name)


def folder_argument(description):
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", default="build/results", help="default: build/results")
    return Path(parser.parse_args().folder)


def shaded_ball(colour, size=200):
    """An image of a sphere lit from the upper left, transparent around it."""
    y, x = np.mgrid[1:-1:size * 1j, -1:1:size * 1j]
    inside = x**2 + y**2
    z = np.sqrt(np.clip(1 - inside, 0, None))
    light = np.array([-0.45, 0.6, 0.66])
    diffuse = np.clip(x * light[0] + y * light[1] + z * light[2], 0, None)
    shine = np.clip(2 * diffuse * z - light[2], 0, None) ** 24
    rgb = np.array(matplotlib.colors.to_rgb(colour))
    image = np.empty((size, size, 4))
    image[..., :3] = np.clip(rgb * (0.38 + 0.72 * diffuse[..., None]) + 0.35 * shine[..., None], 0, 1)
    image[..., 3] = np.clip((1 - np.sqrt(inside)) * size / 2, 0, 1)
    return image


def put_ball(axes, image, x, y, radius, zorder):
    axes.imshow(image, extent=(x - radius, x + radius, y - radius, y + radius), zorder=zorder, interpolation="bilinear",
                aspect="equal")


def published_point(axes, x, y, text, offset, align="left"):
    axes.plot([x], [y], "o", markersize=9, markerfacecolor="none", markeredgecolor=PUBLISHED, markeredgewidth=1.6, zorder=5,
              clip_on=False)
    axes.annotate(text, (x, y), xytext=offset, textcoords="offset points", ha=align, va="center", color="#404040", fontsize=8)


def table(rows):
    lines = ["<div class=\"wide\"><table><tr><th>id</th><th>source</th><th>published</th><th>expected</th><th>computed</th><th>unit</th>"
             "<th>error</th><th>allowed</th><th></th></tr>"]
    for row in rows:
        published = f"{float(row['published']):.9g}" if row["published"] else "–"
        mark = "✓" if row["pass"] == "yes" else "✗"
        lines.append(f"<tr><td>{html.escape(row['id'])}</td><td class=\"source\">{html.escape(row['source'])}</td>"
                     f"<td>{published}</td><td>{float(row['expected']):.12g}</td>"
                     f"<td>{float(row['computed']):.12g}</td><td>{row['unit'] if row['unit'] != '1' else ''}</td>"
                     f"<td>{float(row['relative_error']):.0e}</td><td>{float(row['tolerance']):.0e}</td>"
                     f"<td class=\"{row['pass']}\">{mark}</td></tr>")
    return "\n".join(lines + ["</table></div>"])


def banded_table(rows):
    """Numbers with the band where each must lie; those without a band are shown, not judged."""
    lines = ["<div class=\"wide\"><table><tr><th>id</th><th>published</th><th>at least</th><th>at most</th><th>computed</th><th>unit</th><th></th></tr>"]
    for row in rows:
        published, low, high = (f"{float(row[column]):.5g}" if row[column] else "" for column in ("published", "low", "high"))
        mark = "" if not low and not high else "✓" if row["pass"] == "yes" else "✗"
        lines.append(f"<tr><td>{html.escape(row['id'])}</td><td>{published}</td><td>{low}</td><td>{high}</td>"
                     f"<td>{float(row['computed']):.5g}</td><td>{row['unit'] if row['unit'] != '1' else ''}</td>"
                     f"<td class=\"{row['pass']}\">{mark}</td></tr>")
    return "\n".join(lines + ["</table></div>"])


def verdict(rows):
    wrong = sum(row["pass"] != "yes" for row in rows)
    return f"<p><b>{'All numbers are right.' if wrong == 0 else f'{wrong} numbers are wrong.'}</b></p>"


def save(figure, folder, name, label, caption):
    """Writes the figure; returns it as a piece of the page."""
    write_figure(figure, folder / f"{name}.png")
    plt.close(figure)
    return (f'<figure id="{name}"><img src="{name}.png" alt="{html.escape(caption)}">'
            f"<figcaption><b>{label}.</b> {html.escape(caption)}</figcaption></figure>")


def contents(section):
    """The entry of a section: its title and its figures."""
    name, title = re.search(r'<section id="(.*?)">\s*<h1>(.*?)</h1>', section).groups()
    figures = re.findall(r'<figure id="(.*?)">.*?<b>(.*?)\.</b>', section)
    return f'<li><a href="#{name}"><b>{title}</b></a>: ' + ", ".join(f'<a href="#{i}">{label}</a>' for i, label in figures) + "</li>"


def write_section(results, name, title, text):
    """Writes or renews one section, with links to the files that it was made of, and with it the page and its contents."""
    folder = results.folder
    files = sorted(results.read + ([f"{name}.json"] if (folder / f"{name}.json").exists() else []))
    links = ", ".join(f'<a href="{file}">{file}</a>' for file in files)
    write(folder / f"{name}_section.html",
          f'<section id="{name}">\n<h1>{title}</h1>\n{text}\n<p class="data">Data: {links}</p>\n</section>\n')
    there = [file for file in (folder / f"{section}_section.html" for section in SECTIONS) if file.exists()]
    sections = [file.read_text(encoding="utf-8") for file in there]
    write(folder / "index.html", PAGE.format(contents="\n".join(map(contents, sections)), sections="\n".join(sections)))
    print(f"figures and {folder / 'index.html'}")
