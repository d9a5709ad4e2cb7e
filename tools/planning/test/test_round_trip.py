"""A plan of QGroundControl goes into a sketch, aboard, back by download, and out as a plan equal in every item."""

from __future__ import annotations

import io
import re
import subprocess
import sys

import pytest

from building import ROOT
from demonstration.demonstration import Settings
from demonstration.screen import PlainScreen
from planned import FARM, NAN, bits, plan_of
from planning import BadPlan, Item, Step, read_plan, write_plan
from planning import round_trip as inside
from planning.exact import float_bits, from_bits
from planning.listing import read_listing
from planning.round_trip import RoundTrip, vehicle_for

KINDS = ("mission", "fence", "rally")


def trip(plan, **settings) -> tuple[RoundTrip, bool, str]:
    """The run, whether its verdict is good, and everything on the screen."""
    out = io.StringIO()
    screen = PlainScreen(out)
    made = RoundTrip(plan, Settings(fast=True, **settings), screen)
    verdict = made.run()
    screen.verdict(verdict.sentence, verdict.good)
    return made, verdict.good, out.getvalue()


def equal(one, other) -> bool:
    return all(bits(one.items(kind)) == bits(other.items(kind)) for kind in KINDS)


def test_plan_comes_back_by_the_demonstration_equal_in_every_item(tmp_path):
    plan = read_plan(FARM)
    made, good, text = trip(plan, autopilot="ardupilot")
    assert good, text
    assert "equal in all 51 items" in text.splitlines()[-1]
    file = tmp_path / "aboard.plan"
    write_plan(made.aboard, file)
    read = read_plan(file)
    assert len(plan.mission) == 43 and len(plan.fence) == 6 and len(plan.rally) == 2
    assert equal(read, plan)
    assert (read.home, read.hover_speed, read.firmware) == (plan.home, plan.hover_speed, plan.firmware)


# One plan for several tests: a sketch takes long to build. Numbers that are easily read as others, in commands that
# are no flying, behind what an autopilot keeps otherwise or does not keep.
NUMBERS = [0.0, -0.0, 0.1, 20.1, -584.09, 1e-7, 3.5e-10, 1.17549435e-38, 1e-45, 16777217.0, 1e9, 9.9e11, 1e18, 2.5e30,
           3.4028235e38, -1.5, 0.30000001, 255.99998]  # fmt: skip
EXACT = [from_bits(float_bits(number)) for number in NUMBERS]
PLACE = (473977420, 85456970)
ODD = plan_of([
    Item(3, 22, 0, 1, 15.0, 0.0, 0.0, 100.0, *PLACE, 20.0),
    *(Item(2, 1000, 0, 1, number, 0.0, 0.0, -number, 5, 0, number) for number in EXACT),
])  # fmt: skip
TAKEN = [Item(2, command, 0, 1, 1.0, 0.0, 0.0, 0.0, 0, 0, 0.0) for command in (83, 92, 208, 216, 218, 222, 223)]
KEPT_OTHERWISE = plan_of([
    Item(3, 22, 0, 1, 0.0, 0.0, 0.0, NAN, *PLACE, 20.0), Item(3, 16, 0, 1, 2.0, 3.0, 0.0, 45.0, *PLACE, 20.125),
    Item(3, 30, 0, 1, 0.0, 0.0, 0.0, 0.0, 0, 0, 150.0), *TAKEN, Item(3, 21, 0, 1, 0.0, 0.0, 0.0, 90.0, *PLACE, 0.0),
    Item(2, 20, 0, 1, 0.0, 0.0, 0.0, 0.0, 0, 0, 25.0),
])  # fmt: skip


def test_what_an_autopilot_does_not_keep_is_told_and_is_no_failure():
    """A return has no altitude, a landing's yaw is not flown; its commands ArduPilot keeps in its own way."""
    _, good, text = trip(KEPT_OTHERWISE, autopilot="ardupilot")
    assert good, text
    kept = "param2: 3 -> 0, param4: 45 -> NaN, z: 20.125 -> 20.119999"
    assert f"item 1 of the mission, as ArduPilot keeps it: {kept}" in text
    assert "item 11 of the mission, as ArduPilot keeps it: z: 25 -> 0" in text
    assert text.splitlines()[-1] == "The plan went aboard and came back: all 12 items, as ArduPilot keeps them."


def test_plan_is_put_aboard_the_vehicle_that_it_was_drawn_for():
    plan = plan_of([])
    for vehicle, name in ((1, "plane"), (2, "copter"), (10, "rover")):
        plan.vehicle = vehicle
        assert (vehicle_for(plan, "ardupilot"), vehicle_for(plan, "px4")) == (name, "copter")


def test_sketch_lists_each_float_so_that_it_is_read_the_same():
    made, good, text = trip(ODD, autopilot="px4")
    assert good, text
    assert bits(made.aboard.items()[1:]) == bits(ODD.items()[1:])
    # The pitch of a takeoff; and a heading goes through radians there.
    assert "item 0 of the mission, as PX4 keeps it: param1: 15 -> 0, param4: 100 -> 99.99999" in text


def test_item_that_comes_back_elsewhere_is_a_failure(monkeypatch):
    original = inside.aboard_like

    def moved(plan, listing):
        aboard = original(plan, listing)
        step = aboard.mission[0]
        aboard.mission[0] = Step(step.item._replace(x=step.item.x + 1), step.line, step.name)
        return aboard

    monkeypatch.setattr(inside, "aboard_like", moved)
    _, good, text = trip(ODD, autopilot="px4")
    assert not good
    assert re.search("FAILED: item 0 of the mission came back with another .*x: 473977420 -> 473977421", text)


def test_plan_that_is_wrong_everywhere_is_refused_before_anything_is_built():
    with pytest.raises(BadPlan, match="a latitude beyond 90 degrees"):
        trip(plan_of([Item(3, 16, 0, 1, 0.0, 0.0, 0.0, NAN, 910000000, 0, 20.0)]))


# The listing -------------------------------------------------------------------


BEGUN = "QGC WPL 110\n0\t1\t0\t16\t0\t0\t0\t0\t1\t1\t1\t1"


@pytest.mark.parametrize(("text", "line", "says"), [
    ("nothing here", None, "no listing"), (BEGUN, 2, "ends in the middle"),
    (f"x\n{BEGUN}\n1\t0\t3\t16\t0\t0\ndownloaded: all", 4, "broken off"),
    (f"{BEGUN}\nthe autopilot fell silent", 3, "broken off"),
])  # fmt: skip
def test_listing_that_is_not_whole_is_refused(text, line, says):
    with pytest.raises(BadPlan, match=says) as refused:
        read_listing(FARM, text)
    assert refused.value.line == line


def test_tool_shows_the_round_trip_and_saves_what_came_back(tmp_path):
    file = tmp_path / "aboard.waypoints"
    ran = subprocess.run(
        [sys.executable, ROOT / "tools" / "demo", "--fast", "--plan", FARM, "--save", file, "--autopilot", "px4"],
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert (ran.returncode, ran.stderr) == (0, "")
    assert "equal in all 51 items" in ran.stdout
    assert bits(read_plan(file).items()) == bits(read_plan(FARM).items())
