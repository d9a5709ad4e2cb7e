"""Plans of older programs are read where they are consistent, with a note; what is refused names the cure."""

from __future__ import annotations

import gzip
import json
import math
from pathlib import Path

import pytest

from planned import FARM, bits
from planning import BadPlan, Item, qgc_mission, qgc_plan, read_plan, waypoints

FARM_TEXT = FARM.read_text()
HOME = "0 1 0 16 0 0 0 0 47.5 8.5 480 1"
NAN = math.nan


def read(*rows: str, header: str = "QGC WPL 110", **options):
    return waypoints.read(Path("old.waypoints"), "\n".join([header, *rows]), **options)


def refused(*rows: str, **options) -> BadPlan:
    with pytest.raises(BadPlan) as caught:
        read(*rows, **options)
    return caught.value


def note_of(plan, part: str) -> str:
    found = [note for note in plan.notes if part in note]
    assert len(found) == 1, plan.notes
    return found[0]


# AltitudeMode ---------------------------------------------------------------------


def altitudes(*said: tuple[int | None, int], **more) -> str:
    """A .plan of waypoints with these AltitudeModes and frames."""
    items = [
        {
            "AMSLAltAboveTerrain": 500, "Altitude": 20, "AltitudeMode": mode, "autoContinue": True, "command": 16,
            "doJumpId": number, "frame": frame, "params": [0, 0, 0, None, 47.5, 8.5, 20], "type": "SimpleItem", **more,
        }  # fmt: skip
        for number, (mode, frame) in enumerate(said, start=1)
    ]
    document = {"fileType": "Plan", "version": 1, "mission": {"version": 2, "items": items}}
    return json.dumps(document, indent=1)


def frames(text: str) -> list[int]:
    return [item.frame for item in qgc_plan.read(Path("old.plan"), text).items()]


def test_older_numbering_of_altitude_mode_is_read_where_all_of_a_file_agree():
    for said in ([(0, 3)], [(0, 3), (0, 3)], [(0, 3), (1, 0)], [(1, 0)], [(0, 3), (3, 10)], [(1, 0), (None, 3)]):
        plan = qgc_plan.read(Path("old.plan"), altitudes(*said))
        assert [item.frame for item in plan.items()] == [frame for _, frame in said]
        assert "AltitudeMode is of an older numbering" in note_of(plan, "AltitudeMode")


@pytest.mark.parametrize(
    ("said", "says"),
    [
        ([(0, 3), (1, 3)], "AltitudeMode 0 is not known"),  # the one is of the older, the other of the present
        ([(1, 3), (1, 0)], "AltitudeMode 1 says another reference than frame 0"),
        ([(0, 0)], "AltitudeMode 0 is not known"),
        ([(2, 3)], "AltitudeMode 2 says another reference than frame 3"),
        ([(1, 10)], "AltitudeMode 1 says another reference than frame 10"),
        ([(5, 3)], "AltitudeMode 5 is not known"),
    ],
)
def test_altitude_modes_that_contradict_the_frames_are_refused_with_the_cure(said, says):
    with pytest.raises(BadPlan, match=says) as caught:
        frames(altitudes(*said))
    assert "open the plan in a present QGroundControl, look at this item's altitude, and save it again" in str(
        caught.value
    )


def test_height_worked_out_from_terrain_is_the_third_mode_of_the_older_numbering():
    text = altitudes((2, 0), (0, 3))
    assert "AMSLAltAboveTerrain is 500, and the altitude in params 20" in str(
        pytest.raises(BadPlan, frames, text).value
    )
    plan = qgc_plan.read(Path("old.plan"), altitudes((2, 0), (0, 3), AMSLAltAboveTerrain=20))
    assert any("what QGroundControl worked out from its terrain data" in note for note in plan.notes)


# Line 0 ---------------------------------------------------------------------------


def test_home_above_home_is_home_with_a_note():
    plan = read("0 1 3 16 0 0 0 0 47.5 8.5 0 1", "1 0 3 16 0 0 0 0 47.6 8.5 20 1")
    assert (plan.home.x, plan.home.y) == (475000000, 85000000) and len(plan.mission) == 1
    assert "put a line of home before it" in note_of(plan, "line 0 has frame 3")


def test_plan_that_begins_with_a_takeoff_has_it_as_its_first_item():
    plan = read("0 1 3 22 0 0 0 0 47.5 8.5 20 1", "1 0 3 16 0 0 0 0 47.6 8.5 20 1", "2 0 2 177 1 3 0 0 0 0 0 1")
    assert plan.home is None
    assert [item.command for item in plan.items()] == [22, 16, 177]
    assert plan.items()[2].param1 == 1.0  # the line that it names
    assert "a NAV_TAKEOFF, is the first item" in note_of(plan, "the first line")


def test_version_120_has_no_home():
    rows = ["0 1 3 16 0 0 0 0 47.5 8.5 20 1", "1 0 3 16 0 0 0 0 47.6 8.5 20 1", "2 0 2 177 0 3 0 0 0 0 0 1"]
    plan = read(*rows, header="QGC WPL 120")
    assert plan.home is None and len(plan.mission) == 3 and plan.items()[2].param1 == 0.0
    assert '"QGC WPL 120" has no home' in note_of(plan, "the first line")
    assert 'must be "QGC WPL 110" (or "QGC WPL 120"), and is \'QGC WPL 100\'' in str(
        refused(*rows, header="QGC WPL 100")
    )


def test_mission_and_fence_in_one_file_are_refused():
    error = refused(HOME, "1 0 3 16 0 0 0 0 47.6 8.5 20 1", "2 0 0 5003 30 0 0 0 47.6 8.5 0 1")
    assert "mission, fence or rally items together" in str(error) and error.line == 4
    error = refused("0 0 0 5003 30 0 0 0 47.6 8.5 0 1", "1 0 3 5100 0 0 0 0 47.6 8.5 20 1")
    assert error.line == 3


# Numbering ------------------------------------------------------------------------

GAPS = [
    HOME, "2 0 3 22 0 0 0 0 47.5 8.5 20 1", "5 0 3 16 0 0 0 0 47.6 8.5 20 1", "9 0 3 16 0 0 0 0 47.7 8.5 20 1",
    "10 0 2 177 5 2 0 0 0 0 0 1",
]  # fmt: skip


def test_gaps_in_the_numbering_are_closed_where_that_is_asked_for():
    error = refused(*GAPS)
    assert error.line == 3 and "--renumber numbers them as they stand, and their jumps with them" in str(error)
    plan = read(*GAPS, renumber=True)
    assert [item.command for item in plan.items()] == [22, 16, 16, 177]
    assert plan.items()[3].param1 == 1.0  # to the line with number 5
    assert "from line 3 on the items are renumbered" in note_of(plan, "renumbered")
    assert read(HOME, "1 0 3 16 0 0 0 0 47.6 8.5 20 1", renumber=True).notes == []


@pytest.mark.parametrize(
    ("rows", "says"),
    [
        ([*GAPS[:4], "10 0 2 177 4 2 0 0 0 0 0 1"], "it jumps to number 4, and no line has that"),
        ([*GAPS, "5 0 3 16 0 0 0 0 47.6 8.5 20 1"], "number 5 is there twice"),
        ([*GAPS[:4], "10 0 2 177 0 2 0 0 0 0 0 1"], "it jumps to number 0, which is home and no item"),
    ],
)
def test_jump_that_renumbering_leaves_without_a_line_is_refused(rows, says):
    assert says in str(refused(*rows, renumber=True))


def test_numbers_out_of_order_are_taken_as_they_stand_where_no_item_is_named_by_its_number():
    """As ArduPilot's and Mission Planner's readers do."""
    rows = [HOME, "2 0 3 22 0 0 0 0 47.5 8.5 20 1", "1 0 3 16 0 0 0 0 47.6 8.5 20 1", "7 0 3 16 0 0 0 0 47.7 8.5 20 1"]
    plan = read(*rows)
    assert [item.command for item in plan.items()] == [22, 16, 16]
    assert note_of(plan, "renumbered") == "from line 3 on the items are renumbered"
    for naming in ("8 0 2 177 1 2 0 0 0 0 0 1", "8 0 2 224 1 0 0 0 0 0 0 1", "8 0 3 201 2 1 0 0 47.6 8.5 20 1"):
        assert "--renumber numbers them as they stand" in str(refused(*rows, naming))


@pytest.mark.parametrize("current", ["-1", "2", "255"])
def test_current_that_means_nothing_in_a_plan_goes_out_as_0(current):
    plan = read(HOME, f"1 {current} 3 16 0 0 0 0 47.6 8.5 20 1")
    assert plan.items()[0].current == 0
    assert note_of(plan, '"current"').startswith("item 0: ")
    assert read(HOME, "1 1 3 16 0 0 0 0 47.6 8.5 20 1").items()[0].current == 1


# .mission and .gz ------------------------------------------------------------------

OLD = {
    "firmwareType": 3,
    "groundStation": "QGroundControl",
    "items": [
        {
            "autoContinue": True, "command": 22, "coordinate": [47.5, 8.5, 20.5], "doJumpId": 1, "frame": 3,
            "params": [0, 0, 0, None], "type": "SimpleItem",
        },
        {
            "autoContinue": True, "command": 177, "coordinate": [0, 0, 0], "doJumpId": 2, "frame": 2,
            "params": [1, 3, 0, 0], "type": "SimpleItem",
        },
    ],
    "plannedHomePosition": [47.4, 8.4, 480],
    "version": 2,
}


def oldest() -> dict:
    """The same of version 1.0."""
    items = []
    for number, item in enumerate(OLD["items"], start=1):
        params = {f"param{i}": value or 0 for i, value in enumerate(item["params"], start=1)}
        items.append(
            {key: item[key] for key in ("autoContinue", "command", "coordinate", "frame")}
            | params
            | {"id": number, "type": "missionItem"}
        )
    home = {"coordinate": [47.4, 8.4, 480], "command": 16}
    return {"MAV_AUTOPILOT": 3, "complexItems": [], "items": items, "plannedHomePosition": home, "version": "1.0"}


@pytest.mark.parametrize("document", [OLD, oldest()], ids=["version 2", "version 1.0"])
def test_old_json_of_qgroundcontrol_is_read(tmp_path, document):
    file = tmp_path / "old.mission"
    file.write_text(json.dumps(document))
    plan = read_plan(file)
    yaw = 0.0 if document is not OLD else NAN
    assert bits(plan.items()) == bits(
        [
            Item(3, 22, 0, 1, 0.0, 0.0, 0.0, yaw, 475000000, 85000000, 20.5),
            Item(2, 177, 0, 1, 0.0, 3.0, 0.0, 0.0, 0, 0, 0.0),
        ]
    )
    assert (plan.home.x, plan.home.z) == (474000000, 480.0)
    assert any("its fence and rally points are not in it" in note for note in plan.notes)


def test_old_json_that_holds_a_survey_or_another_version_names_the_cure():
    survey = {**oldest(), "complexItems": [{"complexItemType": "survey"}]}
    with pytest.raises(BadPlan, match="open the file in a present QGroundControl, save it as .plan"):
        qgc_mission.read(Path("old.mission"), json.dumps(survey))
    with pytest.raises(BadPlan, match="only versions 1.0 and 2"):
        qgc_mission.read(Path("old.mission"), json.dumps({**OLD, "version": 3}))
    short = {**OLD, "items": [{**OLD["items"][0], "coordinate": [1, 2]}]}
    with pytest.raises(BadPlan, match="params must be 4 numbers, and coordinate 3"):
        qgc_mission.read(Path("old.mission"), json.dumps(short))


@pytest.mark.parametrize("name", ["farm.plan.gz", "FARM.PLAN.GZ"])
def test_packed_plan_is_read_as_it_was(tmp_path, name):
    file = tmp_path / name
    file.write_bytes(gzip.compress(FARM.read_bytes()))
    assert bits(read_plan(file).items()) == bits(read_plan(FARM).items())


@pytest.mark.parametrize(
    ("data", "says"),
    [
        (b"no gzip", "is not a gzip file, or is damaged"),
        (gzip.compress(FARM.read_bytes())[:-9], "is a gzip file that was cut off"),
        (gzip.compress(b"0" * 65_000_000), "is larger than 64 MB"),
    ],
)
def test_packed_file_that_is_damaged_or_swells_is_refused(tmp_path, data, says):
    file = tmp_path / "a.plan.gz"
    file.write_bytes(data)
    with pytest.raises(BadPlan, match=says):
        read_plan(file)


# Landing patterns -----------------------------------------------------------------


def with_landing(**more) -> str:
    """The farm, and a landing pattern behind it."""
    document = json.loads(FARM_TEXT)
    pattern = {
        "altitudesAreRelative": True, "complexItemType": "fwLandingPattern", "landCoordinate": [47.5, 8.5, 2],
        "landingApproachCoordinate": [47.51, 8.5, 40], "loiterClockwise": False, "loiterRadius": 75,
        "stopTakingPhotos": True, "stopVideoPhotos": True, "type": "ComplexItem", "useLoiterToAlt": True, "version": 2,
        **more,
    }  # fmt: skip
    document["mission"]["items"].append({key: value for key, value in pattern.items() if value is not None})
    return json.dumps(document, indent=1)


def landing(**more) -> list[Item]:
    plan = qgc_plan.read(Path("landing.plan"), with_landing(**more))
    return [step.item for step in plan.mission if "LandingPattern" in step.group]


def test_landing_pattern_is_the_items_that_qgroundcontrol_uploads():
    plain = [Item(2, command, 0, 1, 0.0, 0.0, 0.0, 0.0, 0, 0, 0.0) for command in (189, 206, 2001, 2501)]
    approach = Item(3, 31, 0, 1, 1.0, -75.0, 0.0, 1.0, 475100000, 85000000, 40.0)
    land = Item(3, 21, 0, 1, 0.0, 0.0, 0.0, 0.0, 475000000, 85000000, 2.0)
    assert landing() == [*plain, approach, land]
    assert landing(stopTakingPhotos=False, stopVideoPhotos=False) == [plain[0], approach, land]
    assert landing(loiterClockwise=True)[4].param2 == 75.0
    assert landing(complexItemType="vtolLandingPattern")[-1] == land._replace(command=85)
    assert [item.frame for item in landing(altitudesAreRelative=False)[4:]] == [0, 0]
    straight = landing(useLoiterToAlt=False)[4]
    assert (straight.command, straight.x, straight.z) == (16, 475100000, 40.0) and math.isnan(straight.param4)


def test_landing_pattern_of_an_older_file_says_its_references_twice():
    older = {"altitudesAreRelative": None, "landingApproachCoordinate": None, "loiterCoordinate": [47.51, 8.5, 40]}
    read = landing(**older, loiterAltitudeRelative=False, landingAltitudeRelative=False)
    assert [item.frame for item in read[4:]] == [0, 0]
    with pytest.raises(BadPlan, match="measures one altitude from home and the other from sea level"):
        landing(**older, loiterAltitudeRelative=True, landingAltitudeRelative=False)


def test_landing_pattern_that_is_not_whole_is_refused_by_its_line():
    with pytest.raises(BadPlan, match='has no "landCoordinate"'):
        landing(landCoordinate=None)
    with pytest.raises(BadPlan, match="for which no item is known here: upload the plan from QGroundControl"):
        landing(useDoChangeSpeed=True)
    with pytest.raises(BadPlan, match='"landCoordinate" must be latitude, longitude and altitude, and has 2') as caught:
        landing(landCoordinate=[1, 2])
    lines = with_landing(landCoordinate=[1, 2]).splitlines()
    assert '"landCoordinate"' in lines[caught.value.line - 1]
