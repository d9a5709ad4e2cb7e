"""tools/plan check and tools/demo promise what they know of each autopilot, and no more."""

from __future__ import annotations

import io
import re
import subprocess
import sys

import pytest

from building import ROOT
from demonstration.demonstration import Settings
from demonstration.screen import PlainScreen
from planned import FARM, at, plan_of
from planning import Item, judge, waypoints
from planning.round_trip import RoundTrip

HOME = "0 1 0 16 0 0 0 0 47.5 8.5 480 1"
PLACE = {"x": 473977420, "y": 85455970}


def corners(count: int, says: float, command: int = 5001) -> list[Item]:
    return [
        Item(0, command, 0, 1, says, 0.0, 0.0, 0.0, 474000000 + n * n * 1000, 85000000 + n * 1000, 0.0)
        for n in range(count)
    ]


def circle(radius: float) -> Item:
    return Item(0, 5003, 0, 1, radius, 0.0, 0.0, 0.0, 474000000, 85000000, 0.0)


def found(plan) -> list[tuple[int, str]]:
    """What is wrong for every autopilot: the item, and the reason."""
    refused = judge.refusals(plan)
    for autopilot in ("ardupilot", "px4"):
        assert len(refused[autopilot]) >= len(refused["any"])
    return [(refusal.index, refusal.text) for refusal in refused["any"]]


# Fences as a whole -----------------------------------------------------------------------


@pytest.mark.parametrize(
    ("fence", "wrong"),
    [
        (corners(18, 19.0), [(0, "a polygon of 19 corners has 18 of them in the plan")]),
        (corners(4, 4.0) + corners(18, 19.0), [(4, "a polygon of 19 corners has 18 of them in the plan")]),
        (corners(2, 3.0) + corners(3, 3.0, 5002), [(0, "a polygon of 3 corners has 2 of them in the plan")]),
        (corners(2, 3.0) + [circle(5.0)], [(0, "a polygon of 3 corners has 2 of them in the plan")]),
        (corners(2, 2.0), [(0, "a polygon has 3 to 255 corners, and this one says that it has 2")]),
        ([circle(-5.0)], [(0, "a circle's radius must be more than 0 m, and is -5")]),
        ([circle(0.0)], [(0, "a circle's radius must be more than 0 m, and is 0")]),
        (corners(3, 3.0) + [circle(-1.0), circle(2.0)], [(3, "a circle's radius must be more than 0 m, and is -1")]),
        (corners(3, 3.0) + corners(3, 3.0) + corners(255, 255.0, 5002) + [circle(0.5)], []),
    ],
)
def test_fence_that_is_not_whole_is_found(fence, wrong):
    assert found(plan_of(fence=fence)) == wrong


def test_tool_refuses_a_fence_that_is_not_whole(tmp_path):
    file = tmp_path / "fence.waypoints"
    rows = [f"{n} 0 0 5001 19 0 0 0 47.{n:02} 8.5 0 1" for n in range(1, 19)]
    file.write_text("\n".join(["QGC WPL 110", HOME, *rows]) + "\n")
    for words in (["check", file], ["to-header", file]):
        command = [sys.executable, ROOT / "tools" / "plan", *words]
        ran = subprocess.run(command, capture_output=True, text=True, check=False)
        said = ran.stdout + ran.stderr
        assert ran.returncode == 1 and f"{file}:3: " in said and "a polygon of 19 corners has 18" in said


# What each autopilot takes -----------------------------------------------------------------


def check(tmp_path, rows: list[str], autopilot: str) -> tuple[int, str]:
    """What tools/plan check ends with and says of a mission of these lines behind the number."""
    file = tmp_path / "drawn.waypoints"
    file.write_text("\n".join(["QGC WPL 110", HOME, *(f"{n} {row}" for n, row in enumerate(rows, 1))]) + "\n")
    command = [sys.executable, ROOT / "tools" / "plan", "check", file, "--autopilot", autopilot]
    ran = subprocess.run(command, capture_output=True, text=True, check=False)
    assert ran.stderr == "", ran.stderr
    return ran.returncode, ran.stdout


def test_command_that_one_autopilot_refuses_is_found_for_it_alone(tmp_path):
    # SET_CAMERA_MODE, NAV_CONTINUE_AND_CHANGE_ALT, NAV_GUIDED_ENABLE, DO_GUIDED_LIMITS, DO_SET_ACTUATOR
    rows = ["0 2 530 0 2 0 0 0 0 0 1", "0 3 30 0 0 0 0 0 0 150 1", "0 3 92 1 0 0 0 0 0 0 1", "0 2 222 10 0 0 0 0 0 0 1",
            "0 2 187 1 0 0 0 0 0 0 1"]  # fmt: skip
    for ours, items, other, first in (("ArduPilot", "04", "PX4", "1.*, and 2 more"), ("PX4", "123", "ArduPilot", "0")):
        status, text = check(tmp_path, rows, ours.lower())
        assert status == 1 and "is known to refuse" not in text
        assert re.findall(r":\d+: item (\d) \(.*the autopilot takes no such command", text) == [*items], text
        assert re.search(f"on {other}: item {first}", text), text


def test_command_of_which_nothing_is_known_is_said_to_be_so(tmp_path):
    status, text = check(tmp_path, ["0 3 16 0 0 0 0 47.5 8.5 20 1", "0 3 34 90 0 0 0 47.5 8.6 20 1"], "px4")
    lines = text.splitlines()
    assert status == 0
    assert (
        ":4: not known: item 1 (DO_ORBIT, number 2 in the file): no autopilot that was tried takes this"
        in lines[0]
    )
    assert lines[-1].endswith("nothing in it that PX4 is known to refuse; of 1 item it is not known")
    assert "not known" not in check(tmp_path, ["0 3 16 0 0 0 0 47.5 8.5 20 1"], "px4")[1]


def test_number_that_an_autopilot_would_keep_as_another_is_found_with_both(tmp_path):
    turns = "0 3 18 300 0 10 0 47.5 8.5 20 1"
    status, text = check(tmp_path, [turns], "ardupilot")
    assert status == 1 and "it would be stored as another value: param1, 300 -> 255" in text


def test_plan_is_judged_for_the_vehicle_that_it_was_drawn_for():
    """A copter drops the distances at which a plane passes a waypoint, and a plane has no splines."""
    plan = plan_of([at(0, command=82, param4=0.0)])
    assert judge.refusals(plan)["ardupilot"] == []
    plan.vehicle = 1
    assert [refusal.status for refusal in judge.refusals(plan)["ardupilot"]] == ["NotFlown"]
    plan = plan_of([at(0, command=84), at(0, command=82, param4=0.0)])  # of a plane that can hover
    assert [refusal.index for refusal in judge.refusals(plan)["ardupilot"]] == [1]


# The demonstration -----------------------------------------------------------------------


def shown(plan, **settings) -> tuple[bool, str]:
    out = io.StringIO()
    screen = PlainScreen(out)
    trip = RoundTrip(plan, Settings(fast=True, **settings), screen)
    verdict = trip.run()
    screen.verdict(verdict.sentence, verdict.good)
    return verdict.good, out.getvalue()


SERVO = Item(2, 183, 0, 1, 5.0, 1500.0, 0.0, 0.0, 0, 0, 0.0)


def test_plan_that_this_autopilot_refuses_ends_with_the_reason_at_once():
    plan = plan_of([at(0, **PLACE), at(0, **PLACE), SERVO])
    good, text = shown(plan, autopilot="px4")
    assert not good
    last = text.splitlines()[-1]
    assert "FAILED: the library did not send the plan to PX4." in last
    assert "the autopilot takes no such command (item 2)." in last
    assert "drawn.plan:1: item 2 (DO_SET_SERVO): the autopilot takes no such command" in text
    times = [float(line.split()[0]) for line in text.splitlines() if line[:8].strip().replace(".", "").isdigit()]
    assert times and max(times) < 3
    assert shown(plan, autopilot="ardupilot")[0]


def test_waypoints_of_a_plan_that_is_refused_name_their_lines():
    rows = "\n".join(["QGC WPL 110", HOME, "1 0 3 16 0 0 0 0 47.6 8.5 20 1", "2 0 3 183 5 1500 0 0 0 0 0 1"])
    refused = judge.refusals(waypoints.read(FARM, rows))["px4"]
    assert [(refusal.step.line, refusal.status) for refusal in refused] == [(4, "NotFlown")]
