"""DESIGN.md and its pages say what the code does: its numbers, its states and its budget of RAM are compared."""

from __future__ import annotations

import re

import pytest

import retry_rules
from building import ROOT
from measuring import where
from simulation.firmware import library_file

DESIGN = (ROOT / "DESIGN.md").read_text()
PAGES = sorted((ROOT / "docs" / "design").glob("*.md"))
RETRIES = (ROOT / "docs" / "design" / "retries.md").read_text()
SOURCES = ROOT / "src" / "mavmission"


# The rules of retrying --------------------------------------------------------


def rules() -> list[list[str]]:
    """The cells of each row of the tables of timeouts and retries, without their heads."""
    rows = [[cell.strip() for cell in line.strip("|").split("|")]
            for line in RETRIES.splitlines() if line.startswith("| ")]  # fmt: skip
    return [row for row in rows if row[0] != "rule"]


def told() -> dict[str, str]:
    """Constant -> the rule that has its number."""
    pairs = [(name, row[0]) for row in rules() for name in re.findall(r"`(\w+::\w+)`", row[1])]
    assert len(pairs) == len(dict(pairs)), "one is there twice"
    return dict(pairs)


def is_told(rule: str, name: str, number: int) -> bool:
    if name.endswith("Ms"):
        return bool(re.search(rf"\b({number} ms|{number / 1000:g} s)\b", rule))
    return bool(re.search(rf"\b{number} s\b" if name.endswith("S") else rf"(?<![\d.]){number}(?![\d.]*\d)", rule))


def test_every_wait_in_the_code_is_a_rule_of_the_table():
    assert set(told()) == set(retry_rules.constants())


def test_every_rule_has_the_number_of_the_code_in_its_words():
    rule = told()
    assert rule.pop("ClientRules::defaultLimitS").count("120 s and 2 s for each item") == 1
    assert retry_rules.constants()["ClientRules::defaultLimitS"] == "120 + 2 * count"
    assert [name for name in rule if not is_told(rule[name], name, retry_rules.number(name))] == []


def test_another_number_or_unit_is_not_the_rule():
    assert is_told("after 1.5 s", "kMs", 1500) and is_told("after 1500 ms", "kMs", 1500) and is_told("8 s", "kS", 8)
    assert not is_told("after 11.5 s", "kMs", 500)
    assert not is_told("after 15 s", "kS", 5) and not is_told("after 8 ms", "kS", 8)
    assert not is_told("28 times", "kTries", 8) and not is_told("1.8 times", "kTries", 8)
    assert is_told("up to 8.", "kTries", 8)


def test_numbers_of_attempts_in_the_headers_are_those_of_the_code():
    number = retry_rules.number
    counting = number("UploadRules::kCountingMs") // number("UploadRules::kRepeatMs")
    confirming = number("UploadRules::kConfirmingMs") // number("UploadRules::kRepeatMs") - 1
    headers = [file for file in SOURCES.rglob("*.h") if "mavlink" not in file.relative_to(SOURCES).parts]
    attempts = r"\b(\d+)(?= attempts| repetitions| times, as)"
    said = {file.name: [int(found) for found in re.findall(attempts, file.read_text())] for file in headers}
    assert {name: numbers for name, numbers in said.items() if numbers} == {
        "ItemSink.h": [number("DownloadRules::kItemTries")],
        "DownloadTransfer.h": [number("DownloadRules::kListTries"), number("DownloadRules::kItemTries")],
        "UploadTransfer.h": [counting, confirming], "CommandTransfer.h": [number("CommandRules::kTries")],
    }  # fmt: skip


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


# The budget -------------------------------------------------------------------


def test_budget_of_ram_is_of_the_client_that_is_linked_and_its_parts_lie_one_after_another():
    def sizes(part: where.Part) -> list[int]:
        return [part.size, *(size for inner in part.parts for size in sizes(inner))]

    whole = where.client()
    assert {"state_", "link_"} <= {part.name for part in whole.parts}
    assert min(sizes(whole)) > 0
    assert "`link_.parser_`" in where.ram()  # It raises an error where the size that the linker gives differs.
