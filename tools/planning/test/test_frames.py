"""What an altitude is measured from is what the file says, in tools/plan and in the firmware's reader alike."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from planned import FARM
from planning import BadPlan, commands, judge, qgc_plan, waypoints
from planning.commands import table

HOME = "0\t1\t0\t16\t0\t0\t0\t0\t-35.3632621\t149.1652374\t584\t1"
CHANGE_ALTITUDE, ALTITUDE_WAIT, GUIDED, GO_AROUND, LAND_START, MOUNT = 30, 83, 92, 191, 189, 205
OF_A_MISSION = [command for command in sorted(table()) if command not in (*range(5000, 5005), 5100, 177)]


def text_of(rows) -> str:
    """A .waypoints text of (frame, command, parameters 1 to 7)."""
    lines = [
        "\t".join(map(str, (number, 0, frame, command, *numbers, 1)))
        for number, (frame, command, *numbers) in enumerate(rows, start=1)
    ]
    return "\n".join(["QGC WPL 110", HOME, *lines]) + "\n"


def read(*rows, **options):
    return waypoints.read(Path("drawn.waypoints"), text_of(rows), **options)


@pytest.mark.parametrize("frame", [0, 3, 10])
@pytest.mark.parametrize("command", [CHANGE_ALTITUDE, GUIDED, GO_AROUND, 31, 16, LAND_START])
def test_altitude_keeps_what_it_is_measured_from(frame, command):
    plan = read((frame, command, 0, 0, 0, 0, 0, 0, 150))
    item = plan.items()[0]
    assert (item.frame, item.z) == (frame, 150.0)
    assert waypoints.read(Path("a"), waypoints.write(plan)[0]).items() == [item]
    assert qgc_plan.read(Path("a"), qgc_plan.write(plan)[0]).items() == [item]


@pytest.mark.parametrize("frame", [0, 3, 10])
@pytest.mark.parametrize("command", [20, 93, 115, 177, 178, 183, 203])
def test_item_with_neither_a_place_nor_an_altitude_goes_out_in_the_frame_that_is_taken(frame, command):
    assert read((frame, command, 1, 0, 0, 0, 0, 0, 0)).items()[0].frame == 2


def test_frame_of_an_item_that_has_a_place_is_never_changed():
    """Whatever the command: a frame of a place becomes frame 2 only where the firmware's table has no place for it."""
    for command in OF_A_MISSION:
        for frame in (0, 3, 10):
            try:
                item = read((frame, command, 0, 0, 0, 0, 1, 2, 3)).items()[0]
            except BadPlan:
                continue
            assert item.frame == (2 if command in judge.placeless() else frame), command


def test_plain_numbers_in_the_frame_of_a_place_are_told_with_the_cure():
    # MAV_CMD_DO_ADSB_OUT_IDENT and the like have nothing there; a mode of a camera's has.
    command = next(
        command
        for command in OF_A_MISSION
        if not commands.is_at_a_place(command) and command not in judge.placeless() and commands.uses(command, 5)
    )
    with pytest.raises(BadPlan, match="is a plain number, and frame 3 says that it is a place: give the item frame 2"):
        qgc_plan.read(FARM, dot_plan(command, 0, 0, 0, 0, 7, 0, 0, frame=3))
    assert any("if they are numbers, write 2" in note for note in read((3, command, 0, 0, 0, 0, 7, 0, 0)).notes)
    assert read((2, command, 0, 0, 0, 0, 7, 0, 0)).items()[0].x == 7


def dot_plan(command: int, *numbers, frame: int = 2) -> str:
    """The farm with one item more."""
    document = json.loads(FARM.read_text())
    document["mission"]["items"].append(
        {
            "autoContinue": True, "command": command, "doJumpId": 99, "frame": frame, "params": [*numbers],
            "type": "SimpleItem",
        }  # fmt: skip
    )
    return json.dumps(document)


def test_place_of_a_landing_sequence_in_frame_2_is_a_place():
    plan = qgc_plan.read(FARM, dot_plan(LAND_START, 0, 0, 0, 0, 47.39697211349564, 8.5485, 20))
    item = plan.items()[-1]
    assert (item.frame, item.x, item.y) == (2, 473969721, 85485000)
    assert any("parameters 5 and 6 are degrees, though frame 2" in note for note in plan.notes)
    whole = qgc_plan.read(FARM, dot_plan(LAND_START, 0, 0, 0, 0, 473969721, 85485000, 20))
    assert whole.items()[-1] == item
    with pytest.raises(BadPlan, match="degrees is more than a coordinate can be"):
        qgc_plan.read(FARM, dot_plan(LAND_START, 0, 0, 0, 0, 470.5, 8, 20))


def test_place_of_a_camera_mount_counts_only_where_it_points_at_a_place():
    plan = qgc_plan.read(FARM, dot_plan(MOUNT, -90, 0, 0, 0, 47.5, 8.5, 4))
    assert (plan.items()[-1].x, plan.items()[-1].y, plan.items()[-1].z) == (475000000, 85000000, 4.0)
    plan = qgc_plan.read(FARM, dot_plan(MOUNT, -90, 0, 0, 0, 47.5, 8.5, 2))
    assert (plan.items()[-1].x, plan.items()[-1].y, plan.items()[-1].z) == (0, 0, 2.0)
    assert any("this camera mount is not pointed at a place" in note for note in plan.notes)
