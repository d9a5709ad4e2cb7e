"""What becomes of each mutant: who finds it, if it is one at all."""

from __future__ import annotations

import functools
import json
import queue
import subprocess
import tempfile
from collections.abc import Callable, Iterable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import NamedTuple

import host_build
from firmware import LIBRARY, digest

from .mutants import Mutant
from .overlay import Overlay
from .programs import NICE, OUTPUT, Program, explorer, unit_program
from .subjects import EXPLORED, Subject, units_of

WORKERS = 2
RESULTS = OUTPUT / "results"
# What is no mutant: it is not counted.
NO_CODE, SAME = "does not compile", "same code"
SURVIVED = "survived"


class Verdict(NamedTuple):
    mutant: Mutant
    outcome: str  # the killer's name, SURVIVED, or why it is no mutant
    reason: str = ""  # what the killer said

    @property
    def counts(self) -> bool:
        return self.outcome not in (NO_CODE, SAME)


@functools.cache
def killers(subject: Subject) -> list[Program]:
    """In the order of what they cost."""
    units = units_of(subject)
    quick = [unit_program(unit, sanitized=False) for unit in units]
    return [*quick, *(unit_program(unit, sanitized=True) for unit in units), explorer(EXPLORED)]


def judge(mutants: Iterable[tuple[Subject, Mutant]], told: Callable[[Verdict], None] = lambda _: None) -> list[Verdict]:
    """In the order given. `told` hears of each when it is known."""
    work = list(mutants)
    for subject in dict.fromkeys(subject for subject, _ in work):
        for killer in killers(subject):
            killer.limits_s  # noqa: B018  (each is made, and passes on the library as it is, before anything is mutated)
    with tempfile.TemporaryDirectory(prefix="mutants-") as folder, ThreadPoolExecutor(WORKERS) as pool:
        desks: queue.SimpleQueue[Desk] = queue.SimpleQueue()
        for number in range(WORKERS):
            desks.put(Desk(Path(folder) / str(number)))

        def one(subject: Subject, mutant: Mutant) -> Verdict:
            desk = desks.get()
            try:
                verdict = desk.judge(subject, mutant)
            finally:
                desks.put(desk)
            told(verdict)
            return verdict

        return list(pool.map(lambda pair: one(*pair), work))


class Desk:
    """A place where one mutant at a time is made and run."""

    def __init__(self, place: Path) -> None:
        self.place = place
        self.overlay = Overlay(place / "src")

    def judge(self, subject: Subject, mutant: Mutant) -> Verdict:
        known = {killer: Remembered(killer, mutant) for killer in killers(subject)}
        for killer, remembered in known.items():
            if remembered.outcome == killer.killer:
                return Verdict(mutant, killer.killer, remembered.reason)
        self.overlay.put(mutant.path, mutant.text)
        try:
            return self.tried(mutant, known)
        finally:
            self.overlay.restore(mutant.path)

    def tried(self, mutant: Mutant, known: dict[Program, Remembered]) -> Verdict:
        differs = False
        for killer, remembered in known.items():
            if not remembered.outcome:
                remembered.keep(*self.run(killer, mutant))
            if remembered.outcome in (killer.killer, NO_CODE):
                return Verdict(mutant, remembered.outcome, remembered.reason)
            differs |= remembered.outcome == SURVIVED
        return Verdict(mutant, SURVIVED if differs else SAME)

    def run(self, killer: Program, mutant: Mutant) -> tuple[str, str]:
        """The outcome with this killer, and its reason."""
        changed = {}
        for source in killer.includers(mutant.path):
            made = self.compiled(killer, source)
            if made is None:
                return NO_CODE, ""
            # A test's own object tells nothing of the library, and a sanitizer's checks are not the code that ships.
            if made.read_bytes() != killer.objects[source].read_bytes():
                changed[source] = made
        if not any(LIBRARY in source.parents for source in changed):
            return SAME, ""
        program = self.place / "program"
        try:
            killer.link(program, changed)
        except host_build.HostProgramNotBuilt:
            return NO_CODE, ""
        found = killer.finds(program)
        return (killer.killer, found) if found else (SURVIVED, "")

    def compiled(self, killer: Program, source: Path) -> Path | None:
        made = self.place / f"{digest(str(source))[:8]}.o"
        places = [f"-I{self.overlay.place}", *host_build.PLACES]
        words = [*NICE, *killer.command(source), *places, self.overlay.path(source), "-o", made]
        ran = subprocess.run(words, capture_output=True, check=False)
        return made if ran.returncode == 0 else None


class Remembered:
    """What is known of a mutant and a killer from an earlier run, of the same sources."""

    def __init__(self, killer: Program, mutant: Mutant) -> None:
        key = digest(killer.digest, str(mutant.path), mutant.text)
        self.file = RESULTS / key[:2] / key[2:18]
        self.outcome, self.reason = json.loads(self.file.read_text()) if self.file.exists() else ("", "")

    def keep(self, outcome: str, reason: str) -> None:
        self.outcome, self.reason = outcome, reason
        self.file.parent.mkdir(parents=True, exist_ok=True)
        fresh = self.file.with_suffix(".new")
        fresh.write_text(json.dumps([outcome, reason]))
        fresh.replace(self.file)
