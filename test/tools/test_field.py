"""tools/field: its trials with a fake ArduPilot in the place of the simulator, and defects that it must find."""

from __future__ import annotations

import csv
import re
import subprocess
import sys

import pytest

import trial_names
from benching.flights import CREWS
from benching.items import Row, fakes_differ
from benching.scenarios import SCENARIOS
from building import ROOT
from fielding import Kept, Outcome, Runner, report, table, trials
from fielding.ardupilot import sensors
from fielding.vehicles import GRAVITY, Copter, Plane, QuadPlane, Rover
from simulation import recordings
from simulation.fake_autopilot import Item, mavlink
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


# What a world does for each kind of trial with a copter, and what is otherwise with the others. How a flight is judged:
# test_field_judge.py.
GOOD = {
    "arducopter": (
        "the count is lost", "2 of 1000 bytes are lost or altered",
        "one operation right behind another", "cancelled, and another right behind it, each way takes 150 ms",
        "loop() stands still for 3 s in an upload", "the cable is out for 3 s",
        "the board is reset, and uploads again", "a second station uploads meanwhile", "StartMission, a failsafe",
        "StartButton, a station sets the current item"),
    "px4": (
        "a second station uploads behind it", "example FenceAndRally", "FlyByButtons, 3 % of bytes",
        "StartMission, the ground station is lost"),
    "ardurover": ("nothing is lost", "StartMission, undisturbed", "example GoToPlaces"),
    "quadplane": ("StartMission, a pilot comes while loop() stands still",),
    "ardusub": ("the autopilot is armed", "example GoToPlaces"),
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
    ("px4", "nothing is lost", {"hears": shifted}, "Accepted was expected"),  # its checksum tells the library
    ("arducopter", trial_names.RANDOM_ITEMS, {"hears": keeps_otherwise}, "right behind Accepted: Item("),
    ("px4", trial_names.RANDOM_ITEMS, {"hears": keeps_otherwise}, "OtherPlanAboard right behind the upload of Item("),
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


def test_run_goes_on_where_it_stopped(tmp_path):
    two = [TRIALS["arducopter", name] for name in ("nothing is lost", "the count is lost")]
    first = list(Runner(started(), Kept(tmp_path)).run(two[:1], [1], None))
    assert [(one.name, done, total) for one, done, total in first] == [("nothing is lost", 1, 1)]
    runner = Runner(started(), Kept(tmp_path))
    rest = [(one.name, one.seed, done, total) for one, done, total in runner.run(two, [1, 2], None)]
    assert rest == [("the count is lost", 1, 2, 4), ("nothing is lost", 2, 3, 4), ("the count is lost", 2, 4, 4)]
    assert len(Kept(tmp_path).outcomes) == len((tmp_path / trials.RESULTS).read_text().splitlines()) == 4


def test_no_trial_is_begun_after_its_minutes(tmp_path):
    clock = iter(range(0, 10_000, 40))  # [s]: each look at it takes so long
    runner = Runner(started(), Kept(tmp_path), lambda: next(clock))
    assert len(list(runner.run([TRIALS["arducopter", "nothing is lost"]], [1, 2, 3, 4, 5], 2.0))) == 1


def test_simulator_that_breaks_is_told_and_tried_again(tmp_path):
    def breaks(vehicle, folder):
        raise OSError("no such simulator")

    trial = TRIALS["arducopter", "nothing is lost"]
    ((outcome, _, _),) = Runner(breaks, Kept(tmp_path)).run([trial], [1], None)
    assert outcome.broke == "OSError: no such simulator"
    text = report("2026-01-02", [outcome])
    assert "0 trials, 0 with a contradiction; 1 came to nothing" in text
    assert "- arducopter: nothing is lost, seed 1: OSError: no such simulator" in text
    assert played(tmp_path, trial.name).status == "Accepted"


def test_frames_are_kept_as_recordings_are(tmp_path, monkeypatch):
    clean, lossy = (played(tmp_path, name) for name in ("nothing is lost", "5 items, 3 % of bytes, 0 ms"))
    monkeypatch.setattr(recordings, "FOLDER", tmp_path)
    heard = recordings.heard(clean.frames.removesuffix(".txt"))
    sent = [one.message.seq for one in heard if one.message.get_type() == "MISSION_ITEM_INT"]
    assert sent == list(range(11)) and {one.direction for one in heard} == {">", "<"}
    name = lossy.frames.removesuffix(".txt")
    raw = {mark: b"".join(data for _, data in recordings.raw(name, mark)) for mark in (">", ">>", "<<", "<")}
    assert len(raw[">"]) > len(raw[">>"]) > 0 and len(raw["<<"]) > len(raw["<"]) > 0


def test_random_items_are_kept_as_the_read_back_files_are(tmp_path):
    outcome = played(tmp_path, trial_names.RANDOM_ITEMS)
    assert (outcome.contradictions, outcome.fakes_differ) == ([], [])
    with open(tmp_path / "readback_random_arducopter.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    with open(recordings.FOLDER / "readback_random_arducopter.csv", newline="") as file:
        assert list(rows[0]) == next(csv.reader(file))
    assert rows and all(row["result"] == "ACCEPTED" for row in rows if row["read_command"])
    assert all(int(row["sent_x"]) == int(float(row["sent_x"])) for row in rows)


def test_what_the_fake_keeps_otherwise_is_told():
    waypoint = Item(3, mavlink.MAV_CMD_NAV_WAYPOINT, 0, 1, 0.0, 0.0, 0.0, 0.0, -353632621, 1491652374, 20.0)
    assert list(fakes_differ([Row(waypoint, "Accepted", waypoint)], "arducopter", "")) == []
    assert "and by the fake as" in next(
        fakes_differ([Row(waypoint, "Accepted", waypoint._replace(z=21.0))], "arducopter", "")
    )
    assert "Unsupported, and the fake says MAV_MISSION_ACCEPTED" in next(
        fakes_differ([Row(waypoint, "Unsupported", None)], "px4", "px4 1.17.0")
    )


def test_copter_stands_climbs_and_tilts_as_its_motors_say():
    copter = Copter()
    for _ in range(100):
        copter.step((1000,) * 4, 0.00125)
    assert copter.position == [0.0] * 3 and copter.force == [0.0, 0.0, -GRAVITY]
    for _ in range(800):
        copter.step((1400,) * 4, 0.00125)
    assert copter.position[2] < -0.3 and abs(copter.position[0]) < 1e-9
    for _ in range(80):
        copter.step((1300, 1500, 1500, 1300), 0.00125)  # the left ones turn faster: it rolls to the right
    assert copter.turning[0] > 0.1 and copter.position[1] >= 0.0
    assert sensors(copter).startswith('"timestamp":1.225')


def test_rover_drives_and_turns_as_its_servos_say():
    rover = Rover()
    for _ in range(800):
        rover.step((1500, 0, 1500), 0.00125)
    assert rover.position == [0.0] * 3 and rover.force == [0.0, 0.0, -GRAVITY]
    for _ in range(1600):
        rover.step((1500, 0, 1750), 0.00125)
    assert rover.velocity[0] == pytest.approx(3.0, abs=0.2) and rover.position[1] == 0.0
    for _ in range(800):
        rover.step((2000, 0, 1750), 0.00125)  # to the right: the force that holds it on its curve comes from there
    assert rover.turning[2] > 0.8 and rover.velocity[1] > 1.0 and rover.force[1] > 2.0


def test_plane_takes_off_turns_and_lands_as_its_servos_say():
    def flown(pulses: tuple[int, ...], seconds: float) -> None:
        for _ in range(round(seconds / 0.00125)):
            plane.step(pulses, 0.00125)

    plane = Plane()
    flown((0,) * 4, 0.2)
    assert plane.position == [0.0] * 3 and plane.force == [0.0, 0.0, -GRAVITY]
    flown((1500, 1500, 1900, 1500), 3.0)
    assert plane.position[0] > 10 and plane.position[2] == 0.0  # not as fast yet as it must be
    flown((1500, 1500, 1900, 1500), 3.0)
    assert plane.position[2] < -1.0 and plane.force[2] < -GRAVITY
    flown((1700, 1550, 1700, 1500), 0.5)
    flown((1500, 1550, 1700, 1500), 2.0)
    assert plane.velocity[1] > 3.0 and plane.turning[2] > 0.1  # to the side to which it is banked
    plane.quaternion = [1.0, 0.0, 0.0, 0.0]
    flown((1500, 1500, 1100, 1500), 30.0)
    assert plane.position[2] == 0.0 and max(map(abs, plane.velocity)) < 0.1


def test_quadplane_is_carried_by_its_motors_and_by_its_wing():
    plane = QuadPlane()
    for _ in range(1600):
        plane.step((1500, 1500, 1100, 1500, *(1400,) * 4), 0.00125)
    assert plane.position[2] < -0.3 and abs(plane.position[0]) < 0.1
    plane.velocity = [12.0, 0.0, 0.0]
    plane.step((1500, 1500, 1350, 1500, *(1000,) * 4), 0.00125)
    assert plane.force[2] < -GRAVITY  # with what the motors have left


def binary(file, text: str):
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text)
    file.chmod(0o755)
    return file


def stub(file):
    """In the place of the binary of this name."""
    return binary(file, f"#!{sys.executable}\nimport sys\nsys.path[:0] = {sys.path!r}\nimport stub_{file.name}\n")


def px4_build(folder, make=stub):
    """Its folder, as PX4's make leaves it."""
    make(folder / "bin" / "px4")
    (folder / "etc" / "init.d-posix").mkdir(parents=True)
    (folder / "etc" / "init.d-posix" / "rcS").touch()
    return folder


def field(*words, out) -> subprocess.CompletedProcess:
    return subprocess.run([ROOT / "tools" / "field", *words, "--out", out], capture_output=True, text=True)


@pytest.mark.parametrize(
    ("vehicle", "clock"),
    [("arducopter", "in step: our physics hands it"), ("px4", "in step: our sensors hand it each moment (lockstep)")],
)
def test_tool_is_physics_and_clock_of_a_binary_and_writes_the_report(tmp_path, vehicle, clock):
    way = ["--px4", px4_build(tmp_path)] if vehicle == "px4" else ["--ardupilot", stub(tmp_path / vehicle)]
    out = tmp_path / "out"
    ran = field(*way, "--only", "the count is lost", out=out)
    assert ran.returncode == 0, ran
    assert f"] 1 of 1, 0 left: {vehicle}: the count is lost, seed 1: as it must be (" in ran.stdout
    text = (out / "report.md").read_text()
    assert f"\n1 trials, 0 with a contradiction; 0 came to nothing. Clock: {clock}" in text
    assert re.search(rf"\n\| {vehicle} [\d.]+ \(.*\) \| \d{{4}}-\d\d-\d\d \| uploads 1 \| none \|\n$", text)
    again = field(*way, "--only", "the count is lost", out=out)
    assert again.stdout == f"the report: {out / 'report.md'}\n"
    assert (out / "report.md").read_text() == text


ENDS = "#!/bin/sh\necho I do not fly\nexit 3\n"


def test_binaries_that_end_at_once_are_told(tmp_path):
    for name in ("arducopter", "ardurover"):
        binary(tmp_path / "bin" / name, ENDS)
    px4_build(tmp_path / "px4", lambda file: binary(file, ENDS))
    ran = field("--ardupilot", tmp_path, "--px4", tmp_path / "px4", "--only", "the count is lost", out=tmp_path / "out")
    assert ran.returncode == 1
    for name in ("arducopter", "ardurover", "px4"):
        assert f"{name}: the count is lost, seed 1: Gone: {name} has ended: I do not fly" in ran.stdout


def test_what_is_not_to_be_flown_is_told(tmp_path):
    def told(*words) -> str:
        ran = field(*words, out=tmp_path / "out")
        assert (ran.returncode, ran.stdout) == (1, "")
        return ran.stderr

    assert f"there is no px4 in {tmp_path}" in told("--px4", tmp_path)
    assert "is none of arducopter, ardurover, arduplane" in told("--ardupilot", binary(tmp_path / "antenna", ENDS))
    assert "has no etc/init.d-posix/rcS: was it built" in told("--px4", binary(tmp_path / "bin" / "px4", ENDS))
    (tmp_path / "arducopter").touch()
    assert "cannot be run" in told("--ardupilot", tmp_path)
    assert "no trial has 'nowhere' in its name" in told("--px4", px4_build(tmp_path / "own"), "--only", "nowhere")


def test_tool_lists_its_trials():
    def run(*words: str) -> list[str]:
        return subprocess.run([ROOT / "tools" / "field", *words], capture_output=True, text=True).stdout.splitlines()

    names = [f"{one}: {name}" for one in trial_names.VEHICLES for name in trial_names.simulator_names(one)]
    assert run("--list") == names
    assert run("--list", "--only", "plane: Start") == [one for one in names if "plane: Start" in one]
