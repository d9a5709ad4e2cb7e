"""DESIGN.md and its pages say what the code does: its numbers, its states and its budget of RAM are compared."""

from __future__ import annotations

import re

import pytest

from building import ROOT
from measuring import budget
from refreshing import retries
from simulation.firmware import library_file

DESIGN = (ROOT / "DESIGN.md").read_text()
PAGES = sorted((ROOT / "docs" / "design").glob("*.md"))
RETRIES = retries.DOCUMENT.read_text()
SOURCES = ROOT / "src" / "mavmission"
MOST_LINES = 400


def test_design_is_short_enough_to_be_read_once_and_leads_to_each_of_its_pages():
    assert len(DESIGN.splitlines()) <= MOST_LINES
    linked = re.findall(r"\]\((docs/design/\w+\.md)\)", DESIGN)
    assert {page.name for page in PAGES} == {link.rpartition("/")[2] for link in linked}


# The rules of retrying --------------------------------------------------------


def waits_in_the_code() -> dict[str, str]:
    return retries.values(library_file("RetryRules.h").read_text())


def rules() -> list[list[str]]:
    """The cells of each row of the tables of timeouts and retries, without their heads."""
    rows = [[cell.strip() for cell in line.strip("|").split("|")]
            for line in RETRIES.splitlines() if line.startswith("| ")]  # fmt: skip
    return [row for row in rows if row[0] != "rule"]


def named(cell: str) -> list[tuple[str, str]]:
    return re.findall(r"`(\w+::\w+)` = ([^,]+)", cell)


def test_every_wait_in_the_code_is_a_rule_of_the_table_with_its_value():
    written = [pair for row in rules() for pair in named(row[1])]
    assert len(written) == len(dict(written)), "one is there twice"
    assert dict(written) == waits_in_the_code()


def test_numbers_of_attempts_in_the_headers_are_those_of_the_code():
    code = waits_in_the_code()
    counting = int(code["UploadRules::kCountingMs"]) // int(code["UploadRules::kRepeatMs"])
    confirming = int(code["UploadRules::kConfirmingMs"]) // int(code["UploadRules::kRepeatMs"]) - 1
    headers = [file for file in SOURCES.rglob("*.h") if "mavlink" not in file.relative_to(SOURCES).parts]
    number = r"\b(\d+)(?= attempts| repetitions| times, as)"
    said = {file.name: re.findall(number, file.read_text()) for file in headers}
    assert {name: numbers for name, numbers in said.items() if numbers} == {
        "ItemSink.h": [code["DownloadRules::kItemTries"]],
        "DownloadTransfer.h": [code["DownloadRules::kListTries"], code["DownloadRules::kItemTries"]],
        "UploadTransfer.h": [str(counting), str(confirming)], "CommandTransfer.h": [code["CommandRules::kTries"]],
    }  # fmt: skip


def test_value_of_the_code_is_put_behind_its_name():
    row = "| `UploadRules::kRepeatMs` = 7, `UploadRules::kBusyTries` = 8 | seen |"
    assert retries.with_values(row, {"UploadRules::kRepeatMs": "1 + 2", "UploadRules::kBusyTries": "9"}) == (
        "| `UploadRules::kRepeatMs` = 1 + 2, `UploadRules::kBusyTries` = 9 | seen |"
    )
    with pytest.raises(KeyError, match="kGone"):
        retries.with_values("| `UploadRules::kGone` = 7 |", waits_in_the_code())


def worth(name: str, value: str) -> str:
    """The number that a constant comes to: it may be a sum with another one of its struct."""
    struct = name.partition("::")[0]
    known = waits_in_the_code()
    return str(sum(int(known.get(f"{struct}::{part}", known.get(part, part))) for part in value.split(" + ")))


def test_numbers_in_words_are_those_of_the_code():
    for rule, constants, _ in rules():
        for name, written in named(constants):
            if name.endswith("defaultLimitS"):
                continue
            number = worth(name, written)
            if name.endswith("Ms"):
                ways = {f"{number} ms", f"{int(number) / 1000:g} s"}
                assert any(way in rule for way in ways), f"{rule}: {name} is {number}"
            elif name.endswith("Tries"):
                assert number in re.findall(r"\d+", rule), f"{rule}: {name} is {number}"


def test_each_rule_is_told_in_whole_sentences():
    told = [cell for rule, _, why in rules() for cell in (rule, why)]
    assert [cell for cell in told if not re.match(r"[A-Z0-9`*]", cell) or not re.search(r"\.\)?$", cell)] == []


def test_every_rule_says_where_it_is_from():
    assert len(rules()) > 20
    assert [row for row in rules() if len(row) != 3 or not all(row)] == []


# The diagrams -----------------------------------------------------------------


def enumerators(file: str, name: str) -> set[str]:
    text = library_file(file).read_text()
    body = re.search(rf"enum class {name} : uint8_t \{{(.*?)\}}", text, re.S)[1]
    listed = re.search(r"(\w+)\(MAVMISSION_NAME\)", body)
    if listed:
        return set(re.findall(r"\bX\((\w+),", text.split(f"#define {listed[1]}(X)")[1].split("\n\n")[0]))
    return set(re.findall(r"\w+", body))


def statuses() -> set[str]:
    return set(re.findall(r"\bX\((\w+),", library_file("Status.h").read_text()))


def diagrams() -> str:
    text = "\n".join([DESIGN, *(page.read_text() for page in PAGES)])
    return "\n".join(re.findall(r"^```states\n(.*?)^```$", text, re.M | re.S))


STATES = {
    "upload": ("UploadVerdict.h", "UploadState"), "download": ("DownloadTransfer.h", "State"),
    "reading a file": ("FileReadTransfer.h", "State"), "writing a file": ("FileWriteTransfer.h", "State"),
    "clear": ("ClearTransfer.h", "State"), "command": ("CommandTransfer.h", "State"),
    "order of a mode": ("ModeOrder.h", "Sight"), "start": ("Operations.h", "StartStep"),
    "phases of start": ("StartTransfer.h", "State"), "steering": ("Steering.h", "SteerStep"),
    "orders of a flight": ("FlightStages.h", "FlightOrder"),
}  # fmt: skip


# Requests of MAVLink FTP, by the guide's names.
FTP = ("CreateFile", "WriteFile", "ReadFile", "BurstReadFile", "TerminateSession")


@pytest.mark.parametrize("machine", STATES)
def test_every_state_is_in_a_diagram(machine):
    assert enumerators(*STATES[machine]) - {"None"} - set(re.findall(r"\w+", diagrams())) == set()


def test_every_name_in_a_diagram_is_one_of_the_code():
    known = statuses().union(*(enumerators(*place) for place in STATES.values())) | {"PlanType", *FTP}
    known |= set(re.findall(r"\bX\((\w+),", library_file("FlightState.h").read_text()))
    assert "Accepted" in known
    named_there = set(re.findall(r"\b(?:[A-Z][a-z]+){2,}\b", diagrams()))
    assert len(named_there) > 10
    assert named_there - known == set()


# How to change it ---------------------------------------------------------------


def changes(design: str) -> dict[str, list[str]]:
    """Change -> what the table tells a stranger to open, as far as it is named as a path or a file."""
    section = design.partition("\n## How to change it\n")[2].partition("\n## ")[0]
    rows = [line.strip("|").split("|") for line in section.splitlines() if line.startswith("| ")][1:]
    return {row[0].strip(): re.findall(r"`([^`\s]+)`", row[1]) for row in rows}


@pytest.mark.parametrize("change", changes(DESIGN))
def test_change_names_files_that_exist(change):
    named_files = changes(DESIGN)[change]
    assert named_files
    assert len(set(named_files)) == len(named_files)
    assert [name for name in named_files if not (ROOT / name).exists()] == []


def test_every_change_that_was_tried_is_in_the_table():
    subjects = " ".join(changes(DESIGN))
    for subject in ("result code", "submarine", "COUNT", "NAV_SPLINE_WAYPOINT", "280 bytes", "third autopilot",
                    "`Status`", "order of `Steering`", "message of telemetry", "Linux", "timeline"):  # fmt: skip
        assert subject in subjects
    assert len(changes(DESIGN)) == 11


def test_table_of_changes_is_read_to_its_last_row():
    head = "\n## How to change it\n\n| change | files | what |\n|---|---|---|\n"
    table = f"{head}| one | `a.h`, `b.h` | why |\n| two | `c` | `x` |\n"
    assert changes(f"{table}\n## Next\n\n| three | `d` |\n") == {"one": ["a.h", "b.h"], "two": ["c"]}


# The budget -------------------------------------------------------------------


def test_parts_of_the_budget_add_up_to_the_whole():
    def check(part: budget.Part) -> None:
        if part.parts and not part.is_choice:
            assert sum(inner.size for inner in part.parts) == part.size, part.name
        if part.is_choice:
            assert max(inner.size for inner in part.parts) == part.size, part.name
        for inner in part.parts:
            check(inner)

    whole = budget.client()
    assert {"state_", "link_"} <= {part.name for part in whole.parts}
    check(whole)
