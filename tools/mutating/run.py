"""What tools/mutate does."""

from __future__ import annotations

import sys

from . import report
from .explained import explained, file_of, without_a_mutant
from .judging import Verdict, judge
from .mutants import Mutant, mutants_of, sample
from .subjects import SUBJECTS, Subject, files_of, subjects


def drawn(names: list[str], number: int | None, seed: int) -> list[tuple[Subject, Mutant]]:
    every = of_all(names)
    if number is None:
        return every
    chosen = set(sample([mutant for _, mutant in every], number, seed))
    return [(subject, mutant) for subject, mutant in every if mutant in chosen]


def of_all(names: list[str]) -> list[tuple[Subject, Mutant]]:
    files = [(subject, file) for subject in subjects(names) for file in files_of(subject.name)]
    return [(subject, mutant) for subject, file in files for mutant in mutants_of(file)]


def listed(names: list[str], number: int | None, seed: int) -> str:
    return "\n".join(report.line(mutant) for _, mutant in drawn(names, number, seed))


def shown(wanted: str) -> str:
    file = wanted.partition("-")[0]
    found = [pair for pair in of_all([file]) if pair[1].id == wanted]
    if not found:
        raise ValueError(f"no mutant {wanted}; tools/mutate --list --file {file} has those that there are")
    (verdict,) = judge(found)
    said = f"{verdict.outcome}: {verdict.reason}" if verdict.reason else verdict.outcome
    lines = [verdict.mutant.diff(), "", said]
    if verdict.mutant.id in (reasons := explained()):
        lines.append(f"explained: {reasons[verdict.mutant.id]}")
    return "\n".join(lines)


def whole(names: list[str], number: int | None, seed: int, jobs: int) -> int:
    """Run them and print what was found; what the program exits with."""
    reasons = explained()
    chosen = drawn(names, number, seed)
    verdicts = judge(chosen, Progress(len(chosen)), jobs)
    print(report.text(verdicts, reasons))
    gone = without_a_mutant(reasons, [mutant for _, mutant in of_all(names)])
    if gone:
        print("\nis explained, and is no mutant any more:", *gone, sep="\n")
    files = {path.name for subject in SUBJECTS for path in files_of(subject.name)}
    strangers = sorted({file_of(one) for one in reasons} - files)
    if strangers:
        print("\nis explained, and is not mutated:", *strangers, sep="\n")
    out_of_date = gone or strangers or report.killed_but_explained(verdicts, reasons)
    return int(bool(report.unexplained(verdicts, reasons) or out_of_date))


class Progress:
    """A line on the terminal that counts."""

    def __init__(self, number: int) -> None:
        self.number = number
        self.done = 0

    def __call__(self, verdict: Verdict) -> None:
        self.done += 1
        if sys.stderr.isatty():
            end = "\n" if self.done == self.number else ""
            print(f"\r{self.done} of {self.number}", end=end, file=sys.stderr, flush=True)
