"""tools/field: its trials with a fake ArduPilot in the place of the simulator, and defects that it must find."""

from __future__ import annotations

import re
import subprocess
import sys

import pytest

import trial_names
from benching.flights import CREWS
from benching.scenarios import SCENARIOS
from building import ROOT
from fielding import Kept, Outcome, Runner, report, table, trials
from stand_in import StandIn, started

TRIALS = {(vehicle, one.name): one for vehicle in trial_names.VEHICLES for one in table(vehicle)}


@pytest.fixture(autouse=True)
def few_random_items(monkeypatch):
    monkeypatch.setattr(trials, "ROUNDS", 8)


def played(folder, name: str, vehicle: str = "arducopter", **defects) -> Outcome:
    ((outcome, _, _),) = Runner(started(**defects), Kept(folder)).run([TRIALS[vehicle, name]], [1], None)
    assert outcome.broke == ""
    return outcome


def test_table_is_the_one_that_is_listed():
    assert [one.name for one in table()] == trial_names.simulator_names()
    assert [one.name for one in SCENARIOS] == trial_names.board_names()
    assert len({one.name for one in table()}) == len(table())
    for vehicle in trial_names.VEHICLES:
        assert [one.name for one in table(vehicle)] == trial_names.simulator_names(vehicle)


# A kind of trial with each kind of vehicle.
GOOD = {
    "arducopter": ("the board is reset, and uploads again", "StartButton, a station sets the current item"),
    "px4": ("a second station uploads behind it",),
    "ardurover": ("example GoToPlaces",),
    "quadplane": ("StartMission, a pilot comes while loop() stands still",),
}  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize(
    ("vehicle", "name"), [(vehicle, name) for vehicle, names in GOOD.items() for name in names],
    ids=lambda name: name.replace(" ", "-"),
)  # fmt: skip
def test_library_beside_a_good_autopilot_is_not_contradicted(tmp_path, vehicle, name):
    outcome = played(tmp_path, name, vehicle)
    assert (outcome.contradictions, outcome.fakes_differ) == ([], [])
    assert (tmp_path / outcome.frames).stat().st_size > 300


def shifted(message):
    """Item 3 is kept elsewhere than it was sent, and acknowledged as if it were not."""
    if message.get_type() == "MISSION_ITEM_INT" and message.seq == 3:
        message.x += 1000
        return message
    return None


def flies_on(stand_in: StandIn) -> None:
    """The mode of a pilot or a failsafe is undone after two seconds."""
    autopilot, crew = stand_in.autopilot, CREWS[stand_in.name]
    if stand_in.mode in (crew.takes, crew.returns) and "undone" not in autopilot._timers:
        plan = "MISSION" if "MISSION" in crew.modes else "AUTO"
        autopilot.at("undone", stand_in.now + 2.0, lambda now: stand_in.set_mode(plan))


def keeps_otherwise(message):
    """The height of each item is kept as half of it: no read-back rule knows that."""
    if message.get_type() == "MISSION_ITEM_INT" and message.z > 1:
        message.z /= 2
        return message
    return None


FOUND = [
    ("arducopter", "nothing is lost", {"hears": shifted}, "Accepted, and the plan is not aboard"),
    ("arducopter", trial_names.RANDOM_ITEMS, {"hears": keeps_otherwise}, "right behind Accepted: Item("),
    ("arduplane", "StartMission, a pilot lands", {"defect": flies_on}, "other modes came behind it: ['"),
]


@pytest.mark.parametrize(("vehicle", "name", "defect", "words"), FOUND)
def test_planted_defect_is_named_in_the_report(tmp_path, vehicle, name, defect, words):
    outcome = played(tmp_path, name, vehicle, **defect)
    assert any(words in one for one in outcome.contradictions), outcome
    assert re.fullmatch(rf"{vehicle} \d+\.\d+\.\d+ \(.*\)", outcome.version)
    text = report("2026-01-02", [outcome])
    line = next(one for one in text.splitlines() if one.startswith("- ") and words in one)
    assert f"- {vehicle}: {name}, seed 1: " in line and f"(`{outcome.frames}`)" in line
    assert text.rstrip().splitlines()[-1] == f"| {outcome.version} | 2026-01-02 | {outcome.kind} 1 | 1 |"


def test_tool_flies_a_binary_and_writes_the_report(tmp_path):
    binary = tmp_path / "arducopter"
    binary.write_text(f"#!{sys.executable}\nimport sys\nsys.path[:0] = {sys.path!r}\nimport stub_arducopter\n")
    binary.chmod(0o755)
    words = ["--ardupilot", binary, "--only", "the count is lost", "--out", tmp_path / "out"]
    ran = subprocess.run([ROOT / "tools" / "field", *words], capture_output=True, text=True)
    assert ran.returncode == 0, ran
    assert "] 1 of 1, 0 left: arducopter: the count is lost, seed 1: as it must be (" in ran.stdout
    text = (tmp_path / "out" / "report.md").read_text()
    assert "\n1 trials, 0 with a contradiction; 0 came to nothing. Clock: in step: our physics hands it" in text
