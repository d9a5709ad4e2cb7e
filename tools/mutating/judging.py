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

from simulation import host_build
from simulation.firmware import LIBRARY, digest
from simulation.host_build import STANDARD

from .mutants import Mutant
from .overlay import Overlay
from .programs import NICE, OUTPUT, Program, explorer, flights, unit_program
from .subjects import EXPLORED, FLOWN, Subject, units_of
from .together import CHOSEN, FEWEST, NotTogether, Together

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
    quick = [unit_program(unit, sanitized=False) for unit in units_of(subject)]
    own = [unit_program(unit, sanitized=True) for unit in units_of(subject) if unit.stem in subject.units]
    flown = [flights(FLOWN)] if subject.is_flown else []
    return [*quick, *own, *flown, explorer(EXPLORED)]


def judge(
    mutants: Iterable[tuple[Subject, Mutant]], told: Callable[[Verdict], None] = lambda _: None, jobs: int = 1
) -> list[Verdict]:
    """In the order given, so many at a time. `told` hears of each when it is known."""
    work = list(mutants)
    with tempfile.TemporaryDirectory(prefix="mutants-") as folder, ThreadPoolExecutor(jobs) as pool:
        desks: queue.SimpleQueue[Desk] = queue.SimpleQueue()
        for number in range(jobs):
            desks.put(Desk(Path(folder) / str(number)))

        def all_of(subject: Subject, mutants: list[Mutant]) -> None:
            desk = desks.get()
            try:
                desk.judge_together(subject, mutants)
            finally:
                desks.put(desk)

        def one(subject: Subject, mutant: Mutant) -> Verdict:
            desk = desks.get()
            try:
                verdict = desk.judge(subject, mutant)
            finally:
                desks.put(desk)
            told(verdict)
            return verdict

        groups: dict[tuple[Subject, Path], list[Mutant]] = {}
        for subject, mutant in work:
            groups.setdefault((subject, mutant.path), []).append(mutant)
        list(pool.map(lambda group: all_of(group[0][0], group[1]), groups.items()))
        return list(pool.map(lambda pair: one(*pair), work))


class Desk:
    """A place where one mutant at a time is made and run."""

    def __init__(self, place: Path) -> None:
        self.place = place
        self.overlay = Overlay(place / "src")
        self.made: dict[tuple[str, ...], Path | None] = {}  # objects of the mutant at hand, by command

    def judge_together(self, subject: Subject, mutants: list[Mutant]) -> None:
        """What judge() shall remember of these, which are of one file: those that can be are tried in one program."""
        together = Together(self.place, self.overlay, mutants)
        found: set[int] = set()
        for killer in killers(subject):
            left = {number: mutant for number, mutant in together.mutants.items() if number not in found}
            if len(left) < FEWEST:
                break
            asked = {number: Remembered("killed", killer, mutant) for number, mutant in left.items()}
            if sum(not remembered.outcome for remembered in asked.values()) >= FEWEST:
                try:
                    program = together.program(killer)
                except NotTogether:
                    continue
                for number, remembered in asked.items():
                    if not remembered.outcome and number in together.mutants:
                        reason = killer.finds(program, **{CHOSEN: str(number)})
                        remembered.keep(killer.killer if reason else SURVIVED, reason)
            found |= {number for number, remembered in asked.items() if remembered.outcome == killer.killer}

    def judge(self, subject: Subject, mutant: Mutant) -> Verdict:
        self.overlay.put(mutant.path, mutant.text)
        self.made = {}
        try:
            return self.tried(subject, mutant)
        finally:
            self.overlay.restore(mutant.path)

    def is_left_out(self, mutant: Mutant) -> bool:
        """Whether the preprocessor leaves out what is changed, as it does what is for signing, or for the AVR."""
        places = [f"-I{self.overlay.place}", *host_build.PLACES]
        words = ["g++", "-E", "-P", "-x", "c++", *STANDARD, *places]
        texts = [
            subprocess.run([*words, file], capture_output=True, check=True).stdout
            for file in (self.overlay.path(mutant.path), mutant.path)
        ]
        return texts[0] == texts[1]

    def tried(self, subject: Subject, mutant: Mutant) -> Verdict:
        """By one program after the other. Those after the one that finds it are not made."""
        is_looked_at = False
        for killer in killers(subject):
            remembered = Remembered("killed", killer, mutant)
            # Under the sanitizers an object does not say that the code is the same; asking the preprocessor takes long.
            if not remembered.outcome and killer.is_sanitized and not is_looked_at:
                if self.is_left_out(mutant):
                    return Verdict(mutant, SAME)
                is_looked_at = True
            if not remembered.outcome:
                remembered.keep(*self.run(killer, mutant))
            if remembered.outcome in (killer.killer, NO_CODE):
                return Verdict(mutant, remembered.outcome, remembered.reason)
        last = killers(subject)[-1]
        code = Remembered("code", last, mutant)
        if not code.outcome:
            code.keep(self.code(last, mutant), "")
        return Verdict(mutant, code.outcome)

    def code(self, program: Program, mutant: Mutant) -> str:
        """SURVIVED if any object of the library is another one with the mutant, compiled as for this program."""
        ours = [source for source in program.objects if LIBRARY in source.parents]
        sources = [source for source in ours if program.includes(source, mutant.path)]
        return SURVIVED if any(self.differs(program, source) for source in sources) else SAME

    def run(self, killer: Program, mutant: Mutant) -> tuple[str, str]:
        """The outcome with this killer, and its reason."""
        changed = {}
        for source in killer.includers(mutant.path):
            made = self.compiled(killer, source)
            if made is None:
                return NO_CODE, ""
            if self.differs(killer, source):
                changed[source] = made
        if not changed:
            return SAME, ""
        program = self.place / "program"
        try:
            killer.link(program, changed)
        except host_build.HostProgramNotBuilt:
            return NO_CODE, ""
        found = killer.finds(program)
        return (killer.killer, found) if found else (SURVIVED, "")

    def differs(self, killer: Program, source: Path) -> bool:
        made = self.compiled(killer, source)
        return made is None or killer.is_sanitized or made.read_bytes() != killer.objects[source].read_bytes()

    def compiled(self, killer: Program, source: Path) -> Path | None:
        """None if it does not compile; a mutant may have warnings. Programs with the same flags share the objects."""
        command = [*killer.command(source), "-g0", "-w"]
        quick = host_build.quickened(source, command)
        words = [*NICE, quick[0], f"-I{self.overlay.place}", *quick[1:], str(self.overlay.path(source))]
        key = tuple(words)
        if key not in self.made:
            made = self.place / f"{digest(*words)[:12]}.o"
            ran = subprocess.run([*words, "-o", made], capture_output=True, check=False)
            self.made[key] = made if ran.returncode == 0 else None
        return self.made[key]


class Remembered:
    """The answer to a question about a mutant and a program from an earlier run, of the same sources."""

    def __init__(self, question: str, program: Program, mutant: Mutant) -> None:
        key = digest(question, program.digest, str(mutant.path), mutant.text)
        self.file = RESULTS / key[:2] / key[2:18]
        self.outcome, self.reason = "", ""
        if self.file.exists():
            self.outcome, self.reason = json.loads(self.file.read_text())

    def keep(self, outcome: str, reason: str) -> None:
        self.outcome, self.reason = outcome, reason
        self.file.parent.mkdir(parents=True, exist_ok=True)
        fresh = self.file.with_suffix(".new")
        fresh.write_text(json.dumps([outcome, reason]))
        fresh.replace(self.file)
