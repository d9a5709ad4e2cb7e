"""Defects planted in the library are found: a fixed sample of what tools/mutate plants, and the tool itself.

All of them: tools/mutate. What may survive, and why, is in surviving_mutants.toml.
"""

from __future__ import annotations

import pytest

from mutating import report, run
from mutating.explained import explained, file_of, without_a_mutant
from mutating.judging import SAME, SURVIVED, judge
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
