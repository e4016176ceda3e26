"""Reading tables and writing files: a fault ends the script with a message that names file, line and column."""

import csv
import io
import json
import os
import sys
from pathlib import Path


def fail(place, message):
    """Ends the script with status 2."""
    print(f"{place}: {message}", file=sys.stderr)
    sys.exit(2)


class Table:
    """A CSV file: a header that names the columns, then rows. Empty lines and lines that begin with # are skipped."""

    def __init__(self, file):
        self.file = Path(file)
        try:
            text = self.file.read_text(encoding="utf-8-sig")
        except OSError as fault:
            fail(file, f"cannot be read: {fault.strerror}")
        except UnicodeDecodeError:
            fail(file, "is not a text file")
        lines = [(number, line) for number, line in enumerate(text.splitlines(), 1) if line.strip() and not line.startswith("#")]
        cells = [(number, [cell.strip() for cell in row]) for (number, _), row in zip(lines, csv.reader(line for _, line in lines))]
        if not cells:
            fail(file, "is empty; its first line must name the columns")
        self.header, self.cells = cells[0][1], cells[1:]
        if not self.cells:
            fail(file, "has a header but no rows")
        for number, row in self.cells:
            if len(row) != len(self.header):
                fail(f"{file}:{number}", f"{len(row)} cells, but the header names {len(self.header)} columns")

    def __len__(self):
        return len(self.cells)

    def __contains__(self, column):
        return column in self.header

    def rows(self):
        """Each row as text by column."""
        return [dict(zip(self.header, row)) for _, row in self.cells]

    def numbers(self, column):
        """A column as floats."""
        if column not in self.header:
            fail(self.file, f"column {column} is missing")
        index, values = self.header.index(column), []
        for number, row in self.cells:
            try:
                values.append(float(row[index]))
            except ValueError:
                fail(f"{self.file}:{number}", f"column {column} is {row[index]!r}, must be a number")
        return values


def read_json(file):
    try:
        return json.loads(Path(file).read_text(encoding="utf-8"))
    except (OSError, ValueError) as fault:
        fail(file, f"cannot be read: {fault}")


def write(file, content):
    """Writes text or bytes beside the file and renames, so that a full disk leaves an earlier file as it was."""
    partial = Path(f"{file}.partial")
    try:
        partial.write_bytes(content.encode() if isinstance(content, str) else content)
        os.replace(partial, file)
    except OSError as fault:
        partial.unlink(missing_ok=True)
        fail(file, f"cannot be written: {fault.strerror}")


def write_figure(figure, file, **options):
    """The format is that of the file's name."""
    image = io.BytesIO()
    kind = Path(file).suffix[1:] or "png"
    if kind not in figure.canvas.get_supported_filetypes():
        fail(file, f"no such format of figures: {kind}")
    figure.savefig(image, format=kind, **options)
    write(file, image.getvalue())
