"""Defects planted in the library are found: a fixed sample of what tools/mutate plants, and the tool itself.

All of them: tools/mutate. What may survive, and why, is in surviving_mutants.toml.
"""

from __future__ import annotations

import os
import subprocess

import pytest

from mutating import report, run, syntax, together
from mutating.explained import explained, file_of, without_a_mutant
from mutating.judging import SAME, SURVIVED, judge
from mutating.kinds import KINDS
from mutating.mutants import mutants_of
from mutating.subjects import AROUND, ENGINES, SUBJECTS, files_of, units_of

SAMPLE = 60
SAMPLE_AROUND = 20  # of what is around the engines, where a mutant costs more


@pytest.mark.slow
def test_every_mutant_of_a_fixed_sample_is_found(record_property):
    """But for the explained ones, which cost most, since all that may find them is run: tools/mutate tries them."""
    reasons = explained()
    drawn = run.drawn([subject.name for subject in ENGINES], SAMPLE, seed=1)
    drawn += run.drawn([subject.name for subject in AROUND], SAMPLE_AROUND, seed=1)
    verdicts = judge([pair for pair in drawn if pair[1].id not in reasons])
    record_property("table", ["mutants: a fixed sample", report.rows(verdicts, reasons)])
    assert [report.line(verdict.mutant) for verdict in report.unexplained(verdicts, reasons)] == []
    assert sum(verdict.counts for verdict in verdicts) > (SAMPLE + SAMPLE_AROUND) / 2


def test_each_explanation_is_of_a_mutant_that_there_is():
    mutants = [mutant for _, mutant in run.of_all([])]
    assert without_a_mutant(explained(), mutants) == []
    assert {file_of(one) for one in explained()} <= {mutant.file for mutant in mutants}


def test_each_file_that_is_mutated_has_tests_of_its_own():
    for subject in SUBJECTS:
        assert files_of(subject.name)
        assert all(unit.exists() for unit in units_of(subject)) and subject.units


def outcome(file: str, was: str, becomes: str) -> str:
    """Of the first mutant of the library with this text of its line."""
    pair = [
        (subject, mutant)
        for subject, mutant in run.of_all([file])
        if (mutant.was, mutant.becomes) == (was, becomes) and mutant.file == f"{file}.cpp"
    ][0]
    (verdict,) = judge([pair])
    return verdict.outcome


@pytest.mark.slow
def test_mutant_is_found_by_the_cheapest_tests_that_can_and_one_that_changes_nothing_by_none():
    asked = "if (item == item_) {"
    assert outcome("UploadTransfer", asked, asked.replace("==", "!=")) == "unit tests"
    # (Neither flights nor explorations have this file: they would take longest.)
    assert outcome("FitReasons", "uint32_t greatest = 0;", "uint32_t greatest = 1;") == SURVIVED
    # Compiled only with MAVMISSION_SIGNING.
    signing = "if (--skip_ != 1) return grow(byte);"
    assert outcome("FrameParser", signing, signing.replace("!=", "==")) == SAME


CODE = b"""
enum Plain { One, Two };
struct Room { unsigned count : 3; };
// A comment with 1 < 2 && true.
static_assert(sizeof(int) == 4, "");
#if 1 < 2
bool Thing::isNear(int a, int b) const {
  if (a < b && !has_) return false;
  for (int i = 0; i != b; ++i) call(0x10);
  state_ = State::Here;
  return b > a ? state_ == State::There : kind(Two);
}
#endif
"""


def changes(kind: str) -> set[tuple[str, str]]:
    """What a kind makes of CODE: the text that is changed, and what is there instead."""
    found = KINDS[kind](syntax.parsed(CODE))
    return {(CODE[change.start : change.end].decode(), change.text.decode()) for change in found}


def test_each_kind_changes_what_its_name_says_and_nothing_else():
    assert changes("condition negated") == {
        ("<", ">="), ("!=", "=="), (">", "<="), ("==", "!="), ("!has_", "has_"),
        ("a < b && !has_", "!(a < b && !has_)"),
    }  # fmt: skip
    assert changes("boundary moved") == {("<", "<="), (">", ">=")}
    assert changes("and, or exchanged") == {("&&", "||")}
    assert changes("constant changed") == {
        ("3", "2"), ("false", "true"), ("0", "1"), ("0x10", "0x11"), ("0x10", "0xf"),
    }  # fmt: skip
    assert changes("enumerator exchanged") == {
        ("State::Here", "State::There"), ("State::There", "State::Here"), ("Two", "One"),
    }  # fmt: skip
    assert changes("assignment left out") == {("state_ = State::Here;", ";")}
    assert changes("call left out") == {("call(0x10);", ";")}


PROGRAM = """
static const int kLimit = 3;
constexpr int twice(int a) { return a * 2; }
static int next(int a) {
  for (int i = 0; i < 2; ++i) a += 1;
  if (a < kLimit || a > 9) return 1;
  return twice(a);
}
int main() { return next(1) == 6 && next(8) == 1 ? 0 : 1; }
"""


def test_mutants_in_one_program_do_what_each_does_in_its_own(tmp_path):
    path = tmp_path / "program.cpp"
    path.write_text(PROGRAM)
    every = mutants_of(path)
    numbered = {number: mutant for number, mutant in enumerate(every, start=1) if mutant.body is not None}
    outside = {mutant.was for mutant in every if mutant.body is None}
    assert outside == {"static const int kLimit = 3;", "constexpr int twice(int a) { return a * 2; }"}

    def made(name: str, text: str) -> list[str]:
        source = tmp_path / f"{name}.cpp"
        source.write_text(text)
        subprocess.run(["g++", "-std=c++11", "-w", source, "-o", tmp_path / name], check=True)
        return ["prlimit", "--cpu=1:2", str(tmp_path / name)]

    def passes(program: list[str], number: int) -> bool:
        ran = subprocess.run(program, env={**os.environ, together.CHOSEN: str(number)}, check=False)
        return ran.returncode == 0

    all_of_them = made("together", together.text_of(path, numbered))
    assert passes(all_of_them, 0)
    found = {number for number in numbered if not passes(all_of_them, number)}
    assert found == {number for number, mutant in numbered.items() if not passes(made("alone", mutant.text), 0)}
    assert 0 < len(found) < len(numbered)
