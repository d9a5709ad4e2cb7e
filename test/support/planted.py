"""The library with a defect planted in it, and the defects of test/proof that each proof must find."""

from __future__ import annotations

import os
from pathlib import Path
from typing import NamedTuple

from simulation.firmware import ROOT, digest, library_file, library_sources


class Defect(NamedTuple):
    file: str
    words: str  # what shows it
    rule: str  # how the rule begins that is broken then
    right: str
    wrong: str

    @property
    def library(self) -> tuple[Path, ...]:
        return with_defect(self.file, self.right, self.wrong)


def defects(table: str) -> dict[str, Defect]:
    """Of a file of test/proof, by their names."""
    found = {}
    for entry in (ROOT / "test" / "proof" / table).read_text().split("\n\n"):
        lines = [line for line in entry.splitlines() if not line.startswith("#")]
        name, *head = [line for line in lines if not line.startswith(("-", "+"))] or [""]
        file, words, rule, *_ = [*(part.strip() for part in " ".join(head).split("|")), "", ""]
        right, wrong = ("\n".join(line[1:] for line in lines if line.startswith(mark)) for mark in "-+")
        assert name not in found, f"two defects of {table} have this name: {name}"
        found[name] = Defect(file, words, rule, right, wrong)
    return {name: defect for name, defect in found.items() if name}


def with_defect(file: str, right: str, wrong: str) -> tuple[Path, ...]:
    """The library's sources, the one of this name a copy in which `right`, which must be there once, is `wrong`."""
    source = library_file(file)
    text = source.read_text()
    assert text.count(right) == 1, f"{source}: the line that the defect is planted in has changed: {right}"
    changed = text.replace(right, wrong).replace('#include "', f'#include "{source.parent}/')
    copy = ROOT / "build" / "planted" / digest(changed)[:12] / file
    if not copy.exists():
        copy.parent.mkdir(parents=True, exist_ok=True)
        fresh = copy.with_suffix(f".{os.getpid()}")
        fresh.write_text(changed)
        fresh.replace(copy)
    return tuple(copy if path == source else path for path in library_sources())
