"""A plan of QGroundControl goes into a sketch, aboard, back by download, and out as a plan equal in every item."""

from __future__ import annotations

import io
import subprocess
import sys

import pytest

from building import ROOT
from demonstration.demonstration import Settings
from demonstration.screen import PlainScreen
from planned import FARM, FILES, NAN, bits, plan_of
from planning import BadPlan, Item, Step, read_plan, write_plan
from planning import round_trip as inside
from planning.exact import float_bits, from_bits
from planning.listing import read_listing
from planning.round_trip import RoundTrip
from simulation.fake_autopilot import FENCE, MISSION, RALLY
from simulation.fake_autopilot import Item as AutopilotsItem

AUTOPILOTS = ["ardupilot", "px4"]
KINDS = {"mission": MISSION, "fence": FENCE, "rally": RALLY}


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


@pytest.mark.parametrize("autopilot", AUTOPILOTS)
def test_plan_comes_back_by_the_demonstration_equal_in_every_item(tmp_path, autopilot):
    plan = read_plan(FARM)
    made, good, text = trip(plan, autopilot=autopilot)
    assert good, text
    assert "equal in all 51 items" in text.splitlines()[-1]
    file = tmp_path / "aboard.plan"
    write_plan(made.aboard, file)
    read = read_plan(file)
    assert len(plan.mission) == 43 and len(plan.fence) == 6 and len(plan.rally) == 2
    assert equal(read, plan)
    assert (read.home, read.hover_speed, read.firmware) == (plan.home, plan.hover_speed, plan.firmware)


def test_plan_comes_back_by_the_service_equal_in_every_item(service, personality, tmp_path):
    plan = read_plan(FARM)
    back = {}
    for kind, mission_type in KINDS.items():
        items = [AutopilotsItem(*item) for item in plan.items(kind)]
        service.upload(items, mission_type)
        assert service.done() == "Accepted"
        assert service.download(mission_type) == "WaitingForAutopilot"
        assert service.done() == "Downloaded"
        back[kind] = [Item(*item) for item in service.sink(len(items))]
    if personality == "ArduPilot":
        assert (
            service.autopilot.received()[1:][40].param1 == plan.mission[40].item.param1 + 1
        )  # the jump: home counts there
    returned = plan_of(back["mission"], back["fence"], back["rally"], plan.home)
    file = tmp_path / "aboard.plan"
    write_plan(returned, file)
    assert equal(read_plan(file), plan)


@pytest.mark.slow
def test_patterns_come_back_as_the_autopilot_keeps_them():
    plan = read_plan(FILES / "patterns.plan")
    made, good, text = trip(plan, autopilot="px4")
    assert good, text
    assert "item 1 of the mission, as PX4 keeps it: param1: 15 -> 0" in text  # the pitch of a takeoff
    # A heading goes through radians there.
    kept = [item._replace(param1=0.0, param4=round(item.param4, 3)) for item in made.aboard.items()]
    assert bits(kept) == bits(item._replace(param1=0.0, param4=round(item.param4, 3)) for item in plan.items())


# One plan for several tests: a sketch takes long to build.
NUMBERS = [
    0.0,
    -0.0,
    0.1,
    20.1,
    -584.09,
    1e-7,
    3.5e-10,
    1.17549435e-38,
    1e-45,
    16777217.0,
    1e9,
    9.9e11,
    1e18,
    2.5e30,
    3.4028235e38,
    -1.5,
    0.30000001,
    255.99998,
]
EXACT = [from_bits(float_bits(number)) for number in NUMBERS]
ODD = plan_of(
    [
        Item(3, 22, 0, 1, 0.0, 0.0, 0.0, NAN, 473977420, 85455970, 20.0),
        Item(3, 16, 0, 1, 2.5, 3.0, 0.0, 45.0, 473977420, 85456970, 20.125),
        *(Item(2, 1000, 0, 1, number, 0.0, 0.0, -number, 5, 0, number) for number in EXACT),
    ]
)


KEPT_OTHERWISE = plan_of(
    [
        Item(3, 22, 0, 1, 0.0, 0.0, 0.0, NAN, 473977420, 85455970, 20.0),
        Item(3, 16, 0, 1, 2.0, 3.0, 0.0, 45.0, 473977420, 85456970, 20.125),
        Item(3, 21, 0, 1, 0.0, 0.0, 0.0, 90.0, 473977420, 85456970, 0.0),
        Item(2, 20, 0, 1, 0.0, 0.0, 0.0, 0.0, 0, 0, 25.0),
    ]
)


def test_what_an_autopilot_does_not_keep_is_told():
    _, good, text = trip(KEPT_OTHERWISE, autopilot="ardupilot")
    assert good, text
    kept = "param2: 3 -> 0, param4: 45 -> NaN, z: 20.125 -> 20.119999"
    assert f"item 1 of the mission, as ArduPilot keeps it: {kept}" in text
    assert "item 3 of the mission, as ArduPilot keeps it: z: 25 -> 0" in text
    assert text.splitlines()[-1] == "The plan went aboard and came back: all 4 items, as ArduPilot keeps them."


def test_plan_for_a_plane_goes_aboard_a_plane():
    # What its passing distances are is kept there, and dropped by a copter.
    plan = plan_of(
        [
            Item(3, 22, 0, 1, 0.0, 0.0, 0.0, NAN, 473977420, 85455970, 20.0),
            Item(3, 16, 0, 1, 0.0, 3.0, 5.0, NAN, 473977420, 85456970, 20.0),
        ]
    )
    plan.vehicle = 1
    made, good, text = trip(plan, autopilot="ardupilot")
    assert good, text
    assert bits(made.aboard.items()) == bits(plan.items())


def test_sketch_lists_each_float_so_that_it_is_read_the_same():
    made, good, text = trip(ODD, autopilot="px4")
    assert good, text
    assert bits(made.aboard.items()[2:]) == bits(ODD.items()[2:])


def test_item_that_comes_back_elsewhere_is_a_failure(monkeypatch):
    original = inside.aboard_like

    def moved(plan, listing):
        aboard = original(plan, listing)
        step = aboard.mission[1]
        aboard.mission[1] = Step(step.item._replace(x=step.item.x + 1), step.line, step.name)
        return aboard

    monkeypatch.setattr(inside, "aboard_like", moved)
    _, good, text = trip(ODD, autopilot="px4")
    assert not good
    assert "FAILED: item 1 of the mission came back with another x: 473977420 -> 473977421" in text


def test_plan_that_is_wrong_everywhere_is_refused_before_anything_is_built():
    with pytest.raises(BadPlan, match="a latitude beyond 90 degrees"):
        trip(plan_of([Item(3, 16, 0, 1, 0.0, 0.0, 0.0, NAN, 910000000, 0, 20.0)]))


# The listing -------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "line", "says"),
    [
        ("nothing here", None, "no listing"),
        ("QGC WPL 110\n0\t1\t0\t16\t0\t0\t0\t0\t1\t1\t1\t1", 2, "ends in the middle"),
        ("x\nQGC WPL 110\n0\t1\t0\t16\t0\t0\t0\t0\t1\t1\t1\t1\n1\t0\t3\t16\t0\t0\ndownloaded: all", 4, "broken off"),
        ("QGC WPL 110\n0\t1\t0\t16\t0\t0\t0\t0\t1\t1\t1\t1\nthe autopilot fell silent", 3, "broken off"),
    ],
)
def test_listing_that_is_not_whole_is_refused(text, line, says):
    with pytest.raises(BadPlan, match=says) as refused:
        read_listing(FARM, text)
    assert refused.value.line == line


def test_tool_shows_the_round_trip_and_saves_what_came_back(tmp_path):
    file = tmp_path / "aboard.waypoints"
    ran = subprocess.run(
        [sys.executable, ROOT / "tools" / "demo", "--fast", "--plan", FARM, "--save", file, "--autopilot", "px4"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert (ran.returncode, ran.stderr) == (0, "")
    assert "equal in all 51 items" in ran.stdout
    assert bits(read_plan(file).items()) == bits(read_plan(FARM).items())
