"""What each trick is worth: the library without it beside the library as it is, in the smallest sketch that uploads."""

from __future__ import annotations

import shutil
import tomllib
from pathlib import Path
from typing import NamedTuple

from building import BUILD, elf_sizes
from simulation.firmware import LIBRARY, digest, exclusive, library_file

from . import features, runs
from .documents import aligned
from .firmware import MEASURED

FILE = MEASURED / "tricks.toml"


class Trick(NamedTuple):
    """`text`, which is there once in the file of this name below src/mavmission, and what would be there without."""

    file: str
    text: str
    instead: str


class Taken(NamedTuple):
    """By the sketch [bytes], and what is left of the processor [%]."""

    flash: int
    globals: int
    cpu_left: float


def tricks() -> dict[str, Trick]:
    return {why: Trick(**trick) for why, trick in tomllib.loads(FILE.read_text()).items()}


def undone(trick: Trick) -> Path:
    """A copy of the library's folder without the trick. Raises ValueError if the code is no longer as it says."""
    source = library_file(trick.file)
    text = source.read_text()
    if text.count(trick.text) != 1:
        raise ValueError(f"{FILE}: {trick.file} does not have this once; say what is there now: {trick.text}")
    changed = text.replace(trick.text, trick.instead)
    copy = BUILD / "tricks" / digest(changed, *(file.read_text() for file in sorted(LIBRARY.rglob("*.*"))))[:12]
    with exclusive(copy):
        if not copy.exists():
            fresh = copy.with_suffix(".new")
            shutil.rmtree(fresh, ignore_errors=True)
            shutil.copytree(LIBRARY, fresh)
            (fresh / source.relative_to(LIBRARY)).write_text(changed)
            fresh.rename(copy)
    return copy


def taken(library: Path = LIBRARY) -> Taken:
    flash, ram = elf_sizes(features.built(features.PLAIN, library=library))
    return Taken(flash, ram, runs.cpu_left(57600, library=library, seconds=0.2))


def table() -> str:
    now = taken()
    lines = [["without it", "flash", "globals", "CPU left, 57600 baud saturated"]]
    for why, trick in tricks().items():
        other = taken(undone(trick))
        lines.append([why, f"{other.flash - now.flash:+,}", f"{other.globals - now.globals:+,}",
                      f"{round(other.cpu_left - now.cpu_left, 1) + 0.0:+.1f} %"])  # fmt: skip
    return aligned(lines, left=1)
