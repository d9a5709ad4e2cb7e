"""The survivors that are explained: why each changes nothing that matters.

Each is a line of test/surviving_mutants.toml, under the name of its file: the number by which `tools/mutate --list` and
`--show` know it, its function, and why.
"""

from __future__ import annotations

import tomllib
from pathlib import Path

from simulation.firmware import ROOT

from .mutants import Mutant

FILE = ROOT / "test" / "surviving_mutants.toml"


class BadEntry(ValueError):
    pass


def explained(file: Path = FILE) -> dict[str, str]:
    """The function and the reason of each, by the id of the mutant."""
    found = {}
    for name, entries in tomllib.loads(file.read_text()).items():
        for number, why in entries.items() if isinstance(entries, dict) else [("", entries)]:
            if not number or not isinstance(why, str) or not why.strip():
                raise BadEntry(f"{file}: an entry is NUMBER = 'FUNCTION: WHY', under ['FILE']: {name} {number} {why}")
            found[f"{name}-{number}"] = why
    return found


def without_a_mutant(reasons: dict[str, str], mutants: list[Mutant]) -> list[str]:
    """What is explained and is none of these mutants, of the files that they are in."""
    files, ids = {mutant.file for mutant in mutants}, {mutant.id for mutant in mutants}
    return [f"{one} {why}" for one, why in reasons.items() if file_of(one) in files and one not in ids]


def file_of(mutant: str) -> str:
    """By its id."""
    return mutant.rpartition("-")[0]
