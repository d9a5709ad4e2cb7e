"""What each feature adds to a sketch: flash and globals, feature by feature."""

from __future__ import annotations

import re
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
    """In the order of the file names; the label is the first line of each file, the second may name macros."""
    found = []
    for source in sorted((MEASURED / FOLDER).glob("*.cpp")):
        first, second, *_ = source.read_text().splitlines()
        label = first.removeprefix("// ").rstrip(".")
        found.append(Feature(label, *elf_sizes(measured(f"{FOLDER}/{source.stem}", **macros(second)))))
    return found


def macros(line: str) -> dict[str, str]:
    """Of a comment such as `// -DMAVMISSION_SIGNING=1`: the macros that a sketch is compiled with."""
    return dict(re.findall(r"-D(\w+)=(\w+)", line)) if line.startswith("// -D") else {}


def table() -> str:
    """Each feature, and how much more than the first, which is a sketch that only opens Serial1."""
    rows = features()
    base = rows[0]
    lines = [["sketch, on a Mega", "flash", "globals", "more flash", "more globals"]]
    for row in rows:
        lines.append([row.label, f"{row.flash:,}", f"{row.globals:,}",
                      f"{row.flash - base.flash:+,}", f"{row.globals - base.globals:+,}"])  # fmt: skip
    return aligned(lines, left=1)
