"""The mutants of a source: what is changed in it, one small thing in each.

A mutant is known by its file's name, the function, and the text before and after, not by a place: it stays itself when
the file is moved, or changed elsewhere.
"""

from __future__ import annotations

import difflib
import hashlib
from collections import Counter
from dataclasses import dataclass
from pathlib import Path

from . import syntax
from .kinds import KINDS


@dataclass(frozen=True)
class Mutant:
    path: Path
    kind: str
    function: str  # "" outside of any
    was: str  # the lines that are changed, joined
    becomes: str
    nth: int  # of those that are alike in all this, from 1
    text: str  # of the whole file, changed
    body: tuple[int, int] | None  # of the function, in the file as it is; None outside of what runs

    @property
    def file(self) -> str:
        return self.path.name

    @property
    def key(self) -> tuple[str, str, str, str, int]:
        return (self.file, self.function, self.was, self.becomes, self.nth)

    @property
    def id(self) -> str:
        return f"{self.path.name}-{hashlib.sha256(repr(self.key).encode()).hexdigest()[:8]}"

    def diff(self) -> str:
        before, after = self.path.read_text().splitlines(), self.text.splitlines()
        return "\n".join(difflib.unified_diff(before, after, self.file, self.file, lineterm=""))


def mutants_of(path: Path) -> list[Mutant]:
    text = path.read_bytes()
    source = syntax.parsed(text)
    seen: Counter[tuple[str, ...]] = Counter()
    found = []
    for kind, changes in KINDS.items():
        for change in changes(source):
            function = syntax.function_around(change.node)
            changed = text[: change.start] + change.text + text[change.end :]
            was, becomes = syntax.lines_around(text, changed, change.start, change.end)
            alike = (function, was, becomes)
            seen[alike] += 1
            body = syntax.body_around(change)
            found.append(Mutant(path, kind, function, was, becomes, seen[alike], changed.decode(), body))
    return found


def sample(mutants: list[Mutant], number: int, seed: int) -> list[Mutant]:
    """Some of them; the same ones of those that are still there, whatever mutants are added or go."""
    ranked = sorted(mutants, key=lambda mutant: hashlib.sha256(f"{seed} {mutant.id}".encode()).digest())
    drawn = set(ranked[:number])
    return [mutant for mutant in mutants if mutant in drawn]
