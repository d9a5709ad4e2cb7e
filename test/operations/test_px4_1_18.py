"""What PX4 1.18 does in another way than 1.17: the client beside a fake that does as the recorded one did."""

from __future__ import annotations

import pytest

from plans import SURVEY
from simulation.fake_autopilot import item
from starts import HOPS, MISSION_START, is_flying, jump_on, told, uploaded

AGAIN = pytest.mark.scenario(25, "MISSION_COUNT comes again while a plan is read")
FLOWN_AGAIN = pytest.mark.scenario(49, "start() of a plan that was flown to its end", "PX4")
KEPT = pytest.mark.scenario(60, "Commands that PX4 keeps by other numbers")
TAKEOFF, WAYPOINT, LANDING = HOPS["PX4"]
HOPS_TWICE = [TAKEOFF, WAYPOINT, jump_on(1), LANDING]
ENDS_IN_THE_AIR = [TAKEOFF, WAYPOINT, WAYPOINT._replace(x=WAYPOINT.x + 1000)]


@pytest.fixture(params=[False, True], ids=["1.17", "1.18"])
def px4(build_service, request):
    return build_service("PX4", is_1_18=request.param)


@pytest.fixture
def px4_1_18(build_service):
    return build_service("PX4", is_1_18=True)


def note_items(service) -> list[int]:
    flight, begun = service.autopilot.flight, []
    tell = flight._begun

    def note(index: int, item, now: float) -> None:
        begun.append(index)
        tell(index, item, now)

    flight._begun = note
    return begun


def fly_to_the_end(service, limit_s: float = 120.0) -> None:
    limit = service.now + limit_s
    while not service.autopilot.complete:
        assert service.now < limit
        service.run(0.5)
    service.run(3.0)


def start(service) -> None:
    service.order_of("start")
    assert service.done(limit_s=20) == "Done"
    assert is_flying(service)


@FLOWN_AGAIN
def test_plan_that_was_flown_and_landed_is_flown_again_with_its_jumps(px4):
    begun = note_items(uploaded(px4, HOPS_TWICE))
    for _ in range(3):
        begun.clear()
        start(px4)
        fly_to_the_end(px4)
        assert not px4.autopilot.armed
        assert begun == [0, 1, 1, 3]
    assert told(px4) == 3 * [(MISSION_START, 0, 0)]


@FLOWN_AGAIN
def test_plan_that_ended_in_the_air_is_flown_again_where_that_is_allowed(px4):
    begun = note_items(uploaded(px4, ENDS_IN_THE_AIR))
    start(px4)
    fly_to_the_end(px4)
    assert px4.autopilot.armed and px4.state.modes == ["Hold"]
    px4.order_of("start")
    assert px4.done() == "Armed"
    px4.tell("armed", 1)
    begun.clear()
    start(px4)
    fly_to_the_end(px4)
    assert begun[:3] == [0, 1, 2]


@FLOWN_AGAIN
@pytest.mark.parametrize("order", ["startMission()", "setMode(Auto)"])
def test_finished_plan_is_flown_again_only_when_its_item_is_set(px4, order):
    """As docs/starting.md says: without, it is in its mission's mode for a moment, and holds again."""
    def fly() -> str:
        if order == "startMission()":
            px4.order_of("startmission")
        else:
            px4.set_mode("Auto")
        ended = px4.done()
        px4.run(2.5)
        return ended

    begun = note_items(uploaded(px4, ENDS_IN_THE_AIR))
    start(px4)
    fly_to_the_end(px4)
    px4.tell("armed", 1)
    begun.clear()
    assert fly() == "Done" and begun == []
    assert px4.autopilot.armed and px4.state.modes == ["Hold"]
    px4.order_of("setcurrent", 0)
    assert px4.done(limit_s=20) == "Done"
    assert fly() == "Done" and begun[:1] == [0] and px4.state.modes == ["Auto"]


@AGAIN
@pytest.mark.parametrize("late_s", [0.3, 0.6, 0.9])
@pytest.mark.parametrize("word", ["download", "verify"])
def test_count_that_is_told_again_until_the_first_item_is_asked_for_changes_nothing(px4_1_18, word, late_s):
    service = uploaded(px4_1_18, SURVEY)
    service.run(0.5)  # behind an upload a reading waits that long
    lists = len(service.heard("MISSION_REQUEST_LIST"))
    until = service.now + late_s
    service.wire.lose(">", name="MISSION_REQUEST_INT", times=None, where=lambda _: service.now < until)
    counts = len(service.wire.frames("<", "MISSION_COUNT"))
    if word == "download":
        service.download()
    else:
        service.verify(SURVEY)
    assert service.done(limit_s=20) == ("Downloaded" if word == "download" else "Verified")
    assert len(service.wire.frames("<", "MISSION_COUNT")) - counts >= 2
    assert len(service.heard("MISSION_REQUEST_LIST")) == lists + 1


@KEPT
def test_delay_and_region_of_interest_are_taken_and_read_back_as_each_version_keeps_them(px4):
    at = {"x": WAYPOINT.x, "y": WAYPOINT.y, "z": 20.0}
    plan = [TAKEOFF, WAYPOINT, item(112, frame=2, param1=3.0), item(80, param1=3.0, **at), item(201, param1=3.0, **at),
            LANDING]
    uploaded(px4, plan)
    px4.verify(plan)
    assert px4.done(limit_s=20) == "Verified"
    kept = 93 if px4.autopilot.is_1_18 else 112
    assert [held.command for held in px4.autopilot.missions.held[0]] == [22, 16, kept, 201, 201, 21]
