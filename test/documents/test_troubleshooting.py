"""docs/troubleshooting.md has every status and every verdict, and nothing that is none."""

from __future__ import annotations

import re

import pytest

from simulation.bench import status_names
from simulation.doctor import verdict_names
from simulation.firmware import ROOT, library_file

PAGE = ROOT / "docs" / "troubleshooting.md"


def named() -> set[str]:
    """What stands in code marks and begins as an enumerator does."""
    return set(re.findall(r"`([A-Z][a-z]\w+)`", PAGE.read_text()))


def listed(header: str, macro: str) -> set[str]:
    """The names of one of the library's enumerations, from the list that makes it."""
    text = library_file(header).read_text()
    names = re.findall(r"X\((\w+),", re.search(rf"#define MAVMISSION_{macro}\(X\)((?:.*\\\n)*.*)", text)[1])
    assert len(names) > 5
    return set(names)


@pytest.mark.parametrize("verdict", verdict_names())
def test_every_verdict_is_explained(verdict):
    rows = [line for line in PAGE.read_text().splitlines() if line.startswith("|") and f"`{verdict}`" in line]
    assert any(row.count("|") == 4 for row in rows)  # verdict, what it is, what to do


def test_every_status_is_explained_beside_what_is_printed_for_it():
    statuses = re.search(r"#define MAVMISSION_STATUSES\(X\)((?:.*\\\n)*.*)", library_file("Status.h").read_text())[1]
    printed = dict(re.findall(r'X\((\w+), "(.*?)"\)', statuses))
    assert tuple(printed) == status_names()
    unnamed = {f"InvalidParam{number}" for number in range(2, 7)}  # "InvalidParam1 to InvalidParam7"
    page = " ".join(PAGE.read_text().split())
    assert [name for name, text in printed.items() if f'`{name}` ("{text}")' not in page and name not in unnamed] == []


def test_no_status_is_explained_that_there_is_not():
    others = {"Serial1", "SoftwareSerial", "TelemetryPause", "PlanFiles", "MissionFollower",
              *listed("ItemField.h", "FIELDS"), *listed("Status.h", "ABOARD")}  # fmt: skip
    assert named() - set(status_names()) - set(verdict_names()) - others == set()
