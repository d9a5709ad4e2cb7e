"""tools/plan says what is wrong with a plan by file, line and item, and what a format does not carry."""

from __future__ import annotations

import json
import math
import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from building import ROOT
from planned import FARM, FILES, at, bits, plan_of
from planning import BadPlan, Home, Item, judge, qgc_plan, read_plan, waypoints
from planning.flight import Speeds, fly
from planning.header import header_of
from planning.orders import autopilots_that_refuse
from planning.table import first_flown, summary
from wrong_plans import WRONG_EVERYWHERE, WRONG_ON_ONE, with_item

PLAN_TEXT = FARM.read_text()
WAYPOINTS_TEXT = (FILES / "mission_planner.waypoints").read_text()
FILE = Path("spoiled.plan")


def read(text: str, suffix: str = ".plan", **options):
    reader = qgc_plan.read if suffix == ".plan" else waypoints.read
    return reader(Path(f"spoiled{suffix}"), text, **options)


def refusal(text: str, suffix: str = ".plan") -> BadPlan:
    """Why a text is refused, by the reader or by the library's checks."""
    with pytest.raises(BadPlan) as refused:
        judge.expect_right(read(text, suffix))
    return refused.value


def line_of(text: str, part: str, turn: int = 1) -> int:
    """The line in which a part stands for the `turn`th time."""
    at = [match.start() for match in re.finditer(re.escape(part), text)][turn - 1]
    return text.count("\n", 0, at) + 1


# What is wrong with a .plan, and where -------------------------------------------

WRONG_IN_A_PLAN = [
    # what is replaced (the first time), by what, what it says, lines that the trouble is away from there
    ('"fileType": "Plan"', '"fileType": "Fence"', 'fileType is "Fence"', 0),
    ('"command": 22,', "", 'mission item 1 has no "command"', -5),
    ('"command": 22,', '"command": 70000,', "whole number from 0 to 65535", 0),
    ('"command": 22,', '"command": 31999,', "command is not known", 3),
    ('"command": 22,', '"command": "22",', "must be a number, and is a text", 0),
    ('"autoContinue": true', '"autoContinue": 1', "must be true or false, and is a number", 0),
    ('"frame": 3', '"frame": 1', "frame 1 is no altitude reference", 1),
    ('"frame": 3', '"frame": 0', "AltitudeMode 1 says another reference than frame 0", -4),
    ('"AltitudeMode": 1', '"AltitudeMode": 5', "AltitudeMode 5 is not known", 0),
    ('"AltitudeMode": 1', '"AltitudeMode": 3', "says another reference", 0),
    ('"AltitudeMode": 2', '"AltitudeMode": 3', "worked out from terrain data, and was not", 0),
    ('"Altitude": 30', '"Altitude": 31', "Altitude is 31, and the altitude in params 30", 0),
    ('"type": "SimpleItem"', '"type": "MissionItem"', 'a "MissionItem", which is not known', 0),
    ('"type": "SimpleItem"', '"type": "SimpleItem", "type": "SimpleItem"', '"type" is there twice', 0),
    ("-35.36323345391089", "91", "a latitude beyond 90 degrees (91.0)", -13),
    ("-35.36323345391089", "null", "it has no latitude", 0),
    ("-35.36323345391089", "500", "500 degrees is more than a coordinate can be", 0),
    ("-35.36323345391089", "-35.36.2", "a comma is missing before '.2", 0),
    ("-35.36323345391089", "-35,36", "params must be 7 numbers, and are 8", -5),
    ("149.16521867360208", "181", "a longitude beyond 180 degrees", -14),
    ('"doJumpId": 40', '"doJumpId": 39', "it jumps to doJumpId 39, and 2 items have that", None),
    ('"doJumpId": 39', '"doJumpId": 400', "it jumps to doJumpId 39, and no items have that", None),
    ('"Items": [', '"NoItems": [', "a survey, does not carry its items", None),
    ('"version": 1\n', '"version": 1 "x"\n', "a comma is missing", 0),
    ('"breachReturn": [', '"breachReturn": [ 1,', "latitude, longitude and altitude, and has 4", 0),
    ('"radius": 12.5', '"radius": 1e39', "more than a 32-bit float can hold", 0),
    ('"radius": 12.5', '"diameter": 25', 'has no "radius"', -5),
    ('"inclusion": true', '"inclusion": "yes"', "must be true or false", 0),
    ('"firmwareType": 12', '"firmwareType": 1.5', "whole number from 0 to 255, and is 1.5", 0),
    ('"plannedHomePosition": [', '"plannedHomePosition": [ 1,', "must be latitude, longitude and altitude", 0),
]


@pytest.mark.parametrize(("old", "new", "says", "away"), WRONG_IN_A_PLAN, ids=[row[2][:40] for row in WRONG_IN_A_PLAN])
def test_wrong_plan_is_refused_by_its_line(old, new, says, away):
    assert old in PLAN_TEXT
    error = refusal(PLAN_TEXT.replace(old, new, 1))
    assert says in str(error)
    assert str(error).startswith(f"spoiled.plan:{error.line}: ")
    if away is not None:
        assert error.line == line_of(PLAN_TEXT, old) + away


@pytest.mark.parametrize("key", ["type", "frame", "params", "autoContinue", "command"])
def test_missing_key_is_named_with_the_items_line(key):
    document = json.loads(PLAN_TEXT)
    del document["mission"]["items"][1][key]
    text = json.dumps(document, indent=4)
    error = refusal(text)
    assert f'mission item 2 has no "{key}"' in str(error)
    assert error.line == line_of(text, '"items": [') + 20  # the second item


@pytest.mark.parametrize(
    ("part", "key"), [("mission", "mission"), ("geoFence", "geoFence"), ("rallyPoints", "rallyPoints")]
)
def test_version_that_is_not_read_is_told(part, key):
    document = json.loads(PLAN_TEXT)
    document[part]["version"] = 7
    assert f'"{key}" is of version 7, and only version 2 is read' in str(refusal(json.dumps(document)))


@settings(deadline=None, max_examples=150, derandomize=True)
@given(st.integers(0, len(PLAN_TEXT)), st.integers(0, 40), st.text('{}[],:"0123456789.-enul \n', max_size=6))
def test_plan_that_is_spoiled_anywhere_is_read_or_refused_with_a_line(start, length, new):
    text = PLAN_TEXT[:start] + new + PLAN_TEXT[start + length :]
    try:
        plan = read(text)
    except BadPlan as error:
        assert 1 <= error.line <= text.count("\n") + 1
    else:
        assert plan.kinds


def test_structure_scan_without_its_items_says_how_to_get_them():
    with pytest.raises(BadPlan, match="a StructureScan, does not carry its items: .* download it again") as refused:
        read_plan(FILES / "structure_scan_without_its_items.plan")
    assert refused.value.line == line_of(
        (FILES / "structure_scan_without_its_items.plan").read_text(), "            {", 3
    )


# What is wrong with .waypoints, and where ----------------------------------------

WRONG_IN_WAYPOINTS = [
    # the line, the column (None: the whole line), what stands there, what it says
    (1, None, "QGC WPL 100", 'the first line must be "QGC WPL 110"'),
    (1, None, "", 'the first line must be "QGC WPL 110"'),
    (4, None, "2\t0\t3\t16\t0\t0\t0\t0\t-35.3\t149.1\t20", "11 columns, and not 12"),
    (4, 0, "3", "this is number 3, and 2 is due"),
    (4, 0, "-2", "this is number -2, and 2 is due"),
    (4, 1, "x", "current must be a number"),
    (4, 2, "4", "frame 4 is no altitude reference"),
    (4, 3, "16.0", "command must be a whole number"),
    (4, 4, "nan", "a NaN where none is allowed (parameter 1)"),
    (4, 4, "inf", "parameter 1 must be a number, and is 'inf'"),
    (4, 8, "91", "a latitude beyond 90 degrees (latitude is '91')"),
    (4, 8, "-35,36", "latitude must be a number, and is '-35,36': write a point, not a comma"),
    (4, 8, "NaN", "latitude must be a number, and is 'NaN'"),
    (4, 9, "1e12", "a number too large (longitude is '1e12')"),
    (4, 10, "1e39", "a number too large (altitude is '1e39')"),
    (4, 11, "2", "neither 0 nor 1 (autocontinue is '2')"),
    (9, 4, "0", "it jumps to number 0, which is home and no item"),
    (9, 4, "11", "it jumps to number 11, and no line has that"),
    (9, 4, "2.5", "it jumps to number 2.5, and no line has that"),
    (9, 4, "nan", "it jumps to number nan, and no line has that"),
    (9, 4, "1e30", "it jumps to number 1e30, and no line has that"),
    (8, 8, "1.5", "latitude must be a whole number, and is '1.5'"),
    (2, 8, "nan", "latitude must be a number"),
    (5, 3, "5001", "mission, fence or rally items together"),
]


@pytest.mark.parametrize(
    ("line", "column", "new", "says"), WRONG_IN_WAYPOINTS, ids=[row[3][:40] for row in WRONG_IN_WAYPOINTS]
)
def test_wrong_waypoints_are_refused_by_their_line(line, column, new, says):
    lines = WAYPOINTS_TEXT.splitlines()
    words = lines[line - 1].split("\t")
    lines[line - 1] = new if column is None else "\t".join([*words[:column], new, *words[column + 1 :]])
    error = refusal("\n".join(lines), ".waypoints")
    assert says in str(error)
    assert error.line == line


def test_waypoints_without_home_are_refused():
    assert read("QGC WPL 110\n", ".waypoints").kinds == []
    assert refusal("", ".waypoints").line == 1


@settings(deadline=None, max_examples=150, derandomize=True)
@given(st.integers(0, len(WAYPOINTS_TEXT)), st.integers(0, 30), st.text("0123456789.-e\t\n #nQ", max_size=5))
def test_waypoints_that_are_spoiled_anywhere_are_read_or_refused_with_a_line(start, length, new):
    text = WAYPOINTS_TEXT[:start] + new + WAYPOINTS_TEXT[start + length :]
    try:
        read(text, ".waypoints")
    except BadPlan as error:
        assert 1 <= error.line <= text.count("\n") + 1


# What the files mean --------------------------------------------------------------


def test_mission_planners_file_is_read_as_it_means():
    plan = read_plan(FILES / "mission_planner.waypoints")
    assert plan.home == Home(-353632621, 1491652374, plan.home.z) and round(plan.home.z, 2) == 584.09
    assert [item.command for item in plan.items()] == [22, 16, 82, 16, 183, 203, 177, 115, 19, 20]
    jump, shot, terrain = plan.items()[6], plan.items()[5], plan.items()[3]
    assert (jump.param1, jump.frame) == (1.0, 2)  # to the line with number 2
    assert (shot.x, shot.y, shot.frame) == (1, 0, 2)  # parameter 5, and no place
    assert terrain.frame == 10
    assert plan.mission[6].line == 9


def test_fence_of_mission_planner_is_a_fence():
    plan = read_plan(FILES / "fence.waypoints")
    assert plan.kinds == ["fence"]
    assert [item.command for item in plan.items("fence")] == [5001] * 4 + [5004]


def test_fence_without_a_home_is_read_as_well():
    lines = (FILES / "fence.waypoints").read_text().splitlines()
    lines = [lines[0], *(f"{number}{line[line.index(chr(9)) :]}" for number, line in enumerate(lines[2:]))]
    plan = read("\n".join(lines), ".waypoints")
    assert bits(plan.items("fence")) == bits(read_plan(FILES / "fence.waypoints").items("fence"))
    assert plan.home is None


def test_version_of_what_is_empty_does_not_matter():
    document = json.loads(PLAN_TEXT)
    document["rallyPoints"] = {"points": [], "version": 1}
    document["geoFence"] = {"polygon": [], "version": 1}
    assert read(json.dumps(document)).kinds == ["mission"]
    document["geoFence"]["polygon"] = [[1, 1], [2, 2], [1, 2]]
    assert '"geoFence" is of version 1' in str(refusal(json.dumps(document)))


def test_patterns_are_taken_by_the_items_that_they_carry():
    plan = read_plan(FILES / "patterns.plan")
    groups = [step.group for step in plan.mission]
    assert (groups.count("CorridorScan"), groups.count("StructureScan"), groups.count("")) == (8, 17, 6)
    assert [step.group for step in read_plan(FARM).mission].count("survey") == 36


def test_null_is_an_unset_yaw_or_a_parameter_that_is_not_used():
    plan = read_plan(FILES / "patterns.plan")
    camera, takeoff = plan.items()[:2]
    assert bits([camera]) == bits([Item(2, 530, 0, 1, *[0.0] * 4, 0, 0, 0.0)])
    assert takeoff.param4 != takeoff.param4
    assert any("does not use are unset" in note for note in plan.notes)


def test_camera_that_leaves_a_number_unset_is_for_px4_and_with_0_for_both():
    file = FILES / "hover_and_capture.plan"
    plan = read_plan(file)
    judge.expect_right(plan)
    found = judge.refusals(plan)
    assert found["px4"] == found["any"] == []
    assert {one.step.item.command for one in found["ardupilot"]} == {2000}
    assert all("--unset-as-zero for 0" in one.text for one in found["ardupilot"])
    plan = read_plan(file, unset_as_zero=True)
    assert not any(judge.refusals(plan).values())
    assert plan.items()[2].param4 == 0
    assert math.isnan(plan.items()[0].param4)  # a yaw: 0 is north


def one_item(tmp_path: Path, command: int, params: list) -> Path:
    document = json.loads((FILES / "hover_and_capture.plan").read_text())
    document["mission"]["items"].append(
        {"autoContinue": True, "command": command, "doJumpId": 9, "frame": 2, "params": params, "type": "SimpleItem"}
    )
    file = tmp_path / "one.plan"
    file.write_text(json.dumps(document))
    return file


@pytest.mark.parametrize("as_zero", [False, True])
def test_actuator_that_no_item_can_leave_unset_is_refused(tmp_path, as_zero):
    with pytest.raises(BadPlan, match="parameter 5 is unset, .* would move that actuator"):
        read_plan(one_item(tmp_path, 187, [0.5, *[None] * 5, 0]), unset_as_zero=as_zero)


@pytest.mark.parametrize("as_zero", [False, True])
def test_number_whose_nan_means_nothing_is_refused_unless_it_is_said_to_be_0(tmp_path, as_zero):
    plan = read_plan(one_item(tmp_path, 93, [None, 0, 0, 0, 0, 0, 0]), unset_as_zero=as_zero)
    texts = [one.text for one in judge.refusals(plan)["any"]]
    if as_zero:
        assert texts == []
    else:
        assert len(texts) == 1 and "a NaN where none is allowed (parameter 1)" in texts[0]
        assert texts[0].endswith("or say --unset-as-zero for 0")


def test_altitudes_keep_what_they_are_measured_from():
    frames = {item.frame for item in read_plan(FILES / "patterns.plan").items()}
    assert frames == {0, 2, 3}
    assert [item.frame for item in read_plan(FILES / "above_the_ground.plan").items()] == [3, 10, 10, 2]
    assert any("worked out from its terrain data" in note for note in read_plan(FILES / "patterns.plan").notes)


def test_file_of_another_kind_is_refused(tmp_path):
    (tmp_path / "plan.xyz").write_text("x")
    with pytest.raises(BadPlan, match="is not a known kind of file"):
        read_plan(tmp_path / "plan.xyz")
    with pytest.raises(BadPlan, match="cannot be read: No such file"):
        read_plan(tmp_path / "missing.plan")
    (tmp_path / "binary.plan").write_bytes(b"{\n\xff\xfe")
    with pytest.raises(BadPlan, match="is not a text in UTF-8") as refused:
        read_plan(tmp_path / "binary.plan")
    assert refused.value.line == 2


def test_byte_order_mark_and_carriage_returns_do_no_harm(tmp_path):
    file = tmp_path / "windows.plan"
    file.write_bytes(b"\xef\xbb\xbf" + PLAN_TEXT.replace("\n", "\r\n").encode())
    assert bits(read_plan(file).items()) == bits(read_plan(FARM).items())
    assert read_plan(file).mission[5].line == read_plan(FARM).mission[5].line


# The judge is the library ----------------------------------------------------------


def as_plan(items) -> object:
    return plan_of([Item(*item) for item in items])


@pytest.mark.parametrize(
    ("status", "wrong"), WRONG_EVERYWHERE, ids=lambda value: value if isinstance(value, str) else ""
)
def test_judge_refuses_what_the_firmware_refuses(status, wrong):
    found = judge.refusals(as_plan(with_item(2, wrong)))
    for autopilot in ("ardupilot", "px4"):
        assert [(refused.index, refused.status) for refused in found[autopilot]] == [(2, status)]
    assert [refused.status for refused in found["any"]] == ([] if status == "BadFrame" else [status])


@pytest.mark.parametrize(
    ("personality", "status", "wrong"), WRONG_ON_ONE, ids=lambda value: value if isinstance(value, str) else ""
)
def test_judge_refuses_for_one_autopilot_what_the_firmware_refuses_for_it(personality, status, wrong):
    plan = as_plan(with_item(3, wrong))
    found = judge.refusals(plan)
    assert [(refused.index, refused.status) for refused in found[personality.lower()]] == [(3, status)]
    assert found["any"] == []
    assert autopilots_that_refuse(plan)[0].startswith(f"{personality} would not get it: item 3")


# Flying it -------------------------------------------------------------------------


HOME = Home(1, 0, 100.0)


def flown(*items: Item, home: Home | None = HOME, **speeds):
    return fly(plan_of(items, home=home), Speeds(**{"cruise": 5.0, "climb": 2.0, "descent": 1.0, **speeds}))


def test_flight_takes_its_legs_and_climbs():
    flight = flown(at(0, z=20.0, command=22), at(100), at(100, 50, z=30.0), Item(2, 20, 0, 1, *[0.0] * 4, 0, 0, 0.0))
    back = (100**2 + 50**2) ** 0.5
    assert flight.distance == pytest.approx(150 + back, abs=0.1)
    assert flight.climb == 30
    assert first_flown(flight)[1] == ([leg for leg in flight.legs if leg.index == 1], pytest.approx(100, abs=0.1))
    assert flight.seconds == pytest.approx(20 / 2 + 100 / 5 + 50 / 5 + back / 5 + 30 / 1, abs=0.1)


def test_flight_goes_by_the_speeds_of_the_plan_and_waits():
    slow = Item(2, 178, 0, 1, 1.0, 2.0, -1.0, 0.0, 0, 0, 0.0)
    flight = flown(at(0), slow, at(100, param1=7.0), Item(2, 93, 0, 1, 3.0, -1.0, -1.0, -1.0, 0, 0, 0.0))
    assert flight.seconds == pytest.approx(10 + 50 + 7 + 3, abs=0.1)


def test_flight_carries_out_its_jumps():
    jump = Item(2, 177, 0, 1, 0.0, 2.0, 0.0, 0.0, 0, 0, 0.0)
    assert flown(at(0), at(100), jump).distance == pytest.approx(500, abs=0.5)
    endless = flown(at(0), at(100), jump._replace(param2=-1.0))
    assert not endless.ends and "without an end" in summary(endless, Speeds(5.0))[0]
    whirl = Item(2, 177, 0, 1, 0.0, 30000.0, 0.0, 0.0, 0, 0, 0.0)
    assert not flown(at(0), whirl, whirl, whirl, whirl, whirl).ends


# The tool --------------------------------------------------------------------------


def run(*words, **options) -> subprocess.CompletedProcess:
    return subprocess.run(
        [sys.executable, ROOT / "tools" / "plan", *map(str, words)],
        capture_output=True,
        text=True,
        check=False,
        **options,
    )


def test_tool_checks_for_the_autopilot_that_the_plan_was_drawn_for():
    ran = run("check", FARM)
    assert (ran.returncode, ran.stderr) == (0, "")
    assert ran.stdout == f"{FARM}: mission of 43, fence of 6, rally of 2: nothing in it that PX4 is known to refuse\n"
    file = FILES / "above_the_ground.plan"
    ran = run("check", file)
    assert ran.returncode == 0
    assert f"{file}:34: on PX4: item 1 (NAV_WAYPOINT, doJumpId 2): no such altitude reference" in ran.stdout
    ran = run("check", file, "--autopilot", "px4")
    assert ran.returncode == 1
    first = ran.stdout.splitlines()[0]
    assert first.startswith(f"{file}:34: item 1 (NAV_WAYPOINT, doJumpId 2): no such altitude reference")


def test_tool_converts_there_and_back_and_tells_what_is_not_carried(tmp_path):
    there, back = tmp_path / "farm.waypoints", tmp_path / "farm.plan"
    ran = run("convert", FARM, there)
    assert ran.returncode == 0
    assert f"{there}: the fence (6 items) is not in it; --part fence writes it to one of its own" in ran.stderr
    assert run("convert", there, back).returncode == 0
    assert bits(read_plan(back).items()) == bits(read_plan(FARM).items())
    assert run("convert", FARM, there, "--part", "fence").returncode == 0
    assert bits(read_plan(there).items("fence")) == bits(
        read_plan(FARM).items("fence")[:5] + [read_plan(FARM).items("fence")[5]]
    )
    ran = run("convert", FARM, tmp_path / "farm.gpx")
    assert ran.returncode == 1 and "is not a kind of file that can be written" in ran.stderr


def test_what_a_dot_plan_cannot_have_is_told(tmp_path):
    item = Item(0, 5001, 0, 1, 3.0, 1.0, 0.0, 0.0, 1, 1, 0.0)
    for wrong, says in [
        ([item] * 3, "parameters 2 to 4"),
        ([item._replace(param2=0.0)] * 2, "has not the 3 corners"),
        ([item._replace(param2=0.0, z=5.0)] * 3, "has no altitude"),
        ([item._replace(command=5000, param1=0.0, param2=0.0)] * 2, "one return point"),
    ]:
        with pytest.raises(ValueError, match=says):
            qgc_plan.write(plan_of(fence=wrong))
    with pytest.raises(ValueError, match="above home"):
        qgc_plan.write(plan_of(rally=[Item(0, 5100, 0, 1, *[0.0] * 4, 1, 1, 5.0)]))
    _, notes = qgc_plan.write(plan_of([at(0)._replace(current=1)]))
    assert any('"current" is not in a .plan' in note for note in notes)


def test_tool_writes_a_header_and_refuses_a_plan_that_is_wrong(tmp_path):
    file = tmp_path / "farm.h"
    assert run("to-header", FARM, "-o", file).returncode == 0
    assert (
        "constexpr MissionItem mission[] PROGMEM = {\n    takeoff(-35.3632335_deg, 149.1652187_deg, 30_m),  // 0\n"
        in file.read_text()
    )
    assert run("to-header", FARM).stdout == file.read_text()
    assert "namespace field {" in run("to-header", FARM, "--namespace", "field").stdout
    assert "is no name in C++" in run("to-header", FARM, "--namespace", "a b").stderr
    wrong = tmp_path / "wrong.plan"
    wrong.write_text(PLAN_TEXT.replace("-35.36323345391089", "91"))
    ran = run("to-header", wrong)
    assert (ran.returncode, ran.stdout) == (1, "")
    assert ran.stderr.startswith(
        f"{wrong}:{line_of(PLAN_TEXT, '-35.36323345391089') - 13}: item 0 (NAV_TAKEOFF, doJumpId 1): "
    )


def test_plan_that_no_array_in_flash_holds_is_refused():
    assert "1057 items" not in header_of(plan_of([at(n) for n in range(1057)]))
    with pytest.raises(BadPlan, match="its mission has 1058 items, and an array in a Mega's flash holds 1057"):
        header_of(plan_of([at(n) for n in range(1058)]))


def test_tool_shows_a_table_with_legs_and_times():
    ran = run("show", FARM, "--speed", "7")
    assert ran.returncode == 0
    assert re.search(
        r"│ +3 │ NAV_WAYPOINT \(survey\) +│ -35.3627232 │ 149.1655679 │ 50 m above home +│ +│ +10 │ +\+0.0 │ +69 ",
        ran.stdout,
    )
    assert "to item 38, 2 times" in ran.stdout
    assert "(at 7 m/s, as was asked for, climbing 2.5 and sinking 1.5, in still air" in ran.stdout
    assert "CIRCLE_EXCLUSION" in ran.stdout and "25 m above home" in ran.stdout


@pytest.mark.slow
def test_tool_draws_the_same_drawing_of_the_same_plan(tmp_path):
    one, other = tmp_path / "one.svg", tmp_path / "other.svg"
    for file in (one, other):
        ran = run("draw", FARM, "-o", file)
        assert (ran.returncode, ran.stderr) == (0, "")
    assert one.read_bytes() == other.read_bytes()
    assert ElementTree.parse(one).getroot().tag.endswith("svg")
    assert "written as .svg or .png" in run("draw", FARM, "-o", tmp_path / "farm.pdf").stderr


def test_tool_writes_a_sketch_for_a_real_board(tmp_path):
    folder = tmp_path / "farm"
    assert run("to-sketch", FARM, folder).stdout == f"{folder / 'farm.ino'}\n"
    assert sorted(file.name for file in folder.iterdir()) == ["farm.ino", "farmPlan.h"]
    text = (folder / "farm.ino").read_text()
    assert '#include "farmPlan.h"' in text and "return inFlash(farmPlan::rally);" in text and "@" not in text
    assert "Arduino wants letters" in run("to-sketch", FARM, tmp_path / "my farm").stderr


def test_tool_makes_a_plan_of_a_listing(tmp_path):
    listing, file = tmp_path / "monitor.txt", tmp_path / "aboard.plan"
    text, _ = waypoints.write(read_plan(FARM))
    listing.write_text(f"accepted: the plan is aboard\n{text}downloaded: the plan has been read\n")
    ran = run("from-download", listing, file)
    assert ran.returncode == 0, ran.stderr
    assert bits(read_plan(file).items()) == bits(read_plan(FARM).items())
    listing.write_text("QGC WPL 110\n")
    assert run("from-download", listing, file).returncode == 1
