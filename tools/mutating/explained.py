"""The survivors that are explained: why each changes nothing that matters.

Each is an entry of test/surviving_mutants.toml: the file, the function, the text before (`was`) and after
(`becomes`, one or several), as `tools/mutate --list` has them, and `why`. `nth` tells those apart that are alike in
all that. How the text is broken into lines is of no account.
"""

from __future__ import annotations

import tomllib
from pathlib import Path

from simulation.firmware import ROOT

from .mutants import Mutant

FILE = ROOT / "test" / "surviving_mutants.toml"
ENTRY = {"file", "function", "was", "becomes", "nth", "why"}


class BadEntry(ValueError):
    pass


def explained(file: Path = FILE) -> dict[tuple[str, str, str, str, int], str]:
    """The reason for each, by the key of the mutant."""
    found: dict[tuple[str, str, str, str, int], str] = {}
    for entry in tomllib.loads(file.read_text()).get("survivor", []):
        if not set(entry) >= ENTRY - {"nth"} or not set(entry) <= ENTRY or not entry["why"].strip():
            raise BadEntry(f"{file}: an entry has {', '.join(sorted(ENTRY))} (nth may be left out): {entry}")
        becomes = entry["becomes"]
        for one in [becomes] if isinstance(becomes, str) else becomes:
            was, after = (" ".join(text.split()) for text in (entry["was"], one))
            key = (entry["file"], entry["function"], was, after, entry.get("nth", 1))
            if key in found:
                raise BadEntry(f"{file}: this is explained twice: {key}")
            found[key] = entry["why"]
    return found


def without_a_mutant(reasons: dict[tuple[str, str, str, str, int], str], mutants: list[Mutant]) -> list[str]:
    """What is explained and is none of these mutants, of the files that they are in."""
    files, keys = {mutant.file for mutant in mutants}, {mutant.key for mutant in mutants}
    return [f"{key[0]} {key[1]}: {key[2]} => {key[3]}" for key in reasons if key[0] in files and key not in keys]
