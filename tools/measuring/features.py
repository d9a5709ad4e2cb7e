"""What each feature adds to a sketch: flash and globals, feature by feature."""

from __future__ import annotations

from typing import NamedTuple

from building import elf_sizes

from .firmware import MEASURED, measured
from .report import aligned

FOLDER = "features"


class Feature(NamedTuple):
    """A sketch of test/measured/features, and what it takes on a Mega [bytes]."""

    label: str
    flash: int
    globals: int


def features() -> list[Feature]:
    """In the order of the file names; the label is the first line of each file."""
    found = []
    for source in sorted((MEASURED / FOLDER).glob("*.cpp")):
        label = source.read_text().splitlines()[0].removeprefix("// ").rstrip(".")
        found.append(Feature(label, *elf_sizes(measured(f"{FOLDER}/{source.stem}"))))
    return found


def table() -> str:
    """Each feature, and how much more than the first, which is a sketch that only opens Serial1."""
    rows = features()
    base = rows[0]
    lines = [["sketch, on a Mega", "flash", "globals", "more flash", "more globals"]]
    for row in rows:
        lines.append([row.label, f"{row.flash:,}", f"{row.globals:,}",
                      f"{row.flash - base.flash:+,}", f"{row.globals - base.globals:+,}"])  # fmt: skip
    return aligned(lines, left=1)
