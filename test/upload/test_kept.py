"""On the Mega: what an autopilot keeps in another form verifies; what it would change is refused before COUNT."""

from __future__ import annotations

import pytest

from plans import LAND, SURVEY, jump, waypoint
from simulation.fake_autopilot import item
from simulation.fake_autopilot.items import f32

LOITER_TURNS, LOITER_TIME, LAND_START = 18, 19, 189
PLACE = {"x": 473977420, "y": 85455970, "z": 20.0}

COMES_ABOARD = [
    ("PX4", "copter", waypoint(param4=-90.0), {"param4": 270.0}),
    ("PX4", "copter", waypoint(param4=255.0), {"param4": f32(254.999985)}),
    ("PX4", "copter", waypoint(param4=360.0), {"param4": 0.0}),
    ("PX4", "copter", jump(1, -1), {"param2": 65535.0}),
    ("PX4", "copter", item(LAND_START, x=-353632171, y=1491652721), {"x": -353632160, "y": 1491652736}),
    ("ArduPilot", "copter", jump(1, -1), {"param2": -1.0}),
    ("ArduPilot", "copter", item(LAND, param4=90.0, **PLACE), {"param4": 1.0}),
    ("ArduPilot", "copter", item(LOITER_TURNS, param1=0.25, param3=-2550.0, **PLACE),
     {"param1": 0.25, "param3": -2550.0}),
    ("ArduPilot", "copter", waypoint(z=f32(28.6)), {"z": f32(28.5999985)}),
    ("ArduPilot", "copter", item(207, param1=1.0, param2=-0.0), {"param1": 1.0, "param2": 0.0}),
    ("PX4", "copter", item(178, param1=1.0, param2=5.0, param3=-1.0, param4=1.0), {"param4": 1.0}),
    ("ArduPilot", "plane", waypoint(param2=30.0, param3=20.0), {"param1": 0.0, "param2": 30.0, "param3": 20.0}),
    ("ArduPilot", "rover", waypoint(param1=7.0, param2=30.0, param3=20.0),
     {"param1": 7.0, "param2": 0.0, "param3": 0.0}),
]

REFUSED = [
    ("ArduPilot", "copter", item(LOITER_TURNS, param1=300.0, **PLACE), "NotKept", "Param1"),
    ("ArduPilot", "copter", item(LOITER_TURNS, param1=2.0, param3=303.0, **PLACE), "NotKept", "Param3"),
    ("ArduPilot", "copter", waypoint(param1=2.5), "NotKept", "Param1"),
    ("ArduPilot", "copter", waypoint(z=83000.0), "BadAltitude", "None"),
    ("ArduPilot", "plane", waypoint(param1=7.0), "NotKept", "Param1"),  # a time to hold
    ("ArduPilot", "plane", waypoint(param2=300.0), "NotKept", "Param2"),
    ("ArduPilot", "plane", item(82, **PLACE), "NotFlown", "None"),
    ("ArduPilot", "plane", item(LOITER_TIME, param1=5.0, param3=50.0, **PLACE), "NotKept", "Param3"),
    ("ArduPilot", "copter", item(207, param1=1.0, param2=2.0), "NotKept", "Param2"),  # DO_FENCE_ENABLE: which fences
    ("ArduPilot", "copter", item(178, param1=1.0, param2=5.0, param4=1.0), "NotKept", "Param4"),  # a relative speed
    ("ArduPilot", "plane", item(3000, param1=4.0, param2=1.0), "NotKept", "Param2"),  # DO_VTOL_TRANSITION, at once
    ("PX4", "copter", waypoint(param4=361.0), "NotKept", "Param4"),
    ("PX4", "copter", jump(1, -2), "NotKept", "Param2"),
]


@pytest.mark.parametrize(("personality", "vehicle", "one", "kept"), COMES_ABOARD)
def test_what_means_the_same_comes_aboard_and_verifies(build_service, personality, vehicle, one, kept):
    service = build_service(personality, vehicle=vehicle)
    plan = [waypoint(), waypoint(), one, waypoint()]
    service.upload(plan, proof="Always")
    assert service.done() == "Accepted"
    (held,) = [item for item in service.autopilot.plan()[-2:-1]]
    assert {name: getattr(held, name) for name in kept} == kept
    service.verify()
    assert service.done() == "Verified"


@pytest.mark.parametrize("name", ["param1", "param2", "param3", "param4", "x", "y", "z"])
def test_field_that_a_plane_keeps_differs_when_it_is_altered(build_service, name):
    service = build_service("ArduPilot", vehicle="plane")
    plan = [waypoint(), waypoint(param2=30.0, param3=20.0)]
    service.upload(plan, proof="Always")
    assert service.done() == "Accepted"
    home, first, held = service.autopilot.plan()
    service.autopilot.load([home, first, held._replace(**{name: getattr(held, name) + 1})])
    service.verify(plan)
    # The fake keeps what a plane keeps: it drops what is altered in the parameters that a plane does not use.
    assert service.done() == ("Verified" if name in ("param1", "param4") else "Differs")


@pytest.mark.parametrize(("personality", "vehicle", "one", "status", "field"), REFUSED)
@pytest.mark.parametrize("proof", ["ByAnswer", "InDoubt"])
def test_what_would_be_kept_as_another_value_is_refused(build_service, personality, vehicle, one, status, field, proof):
    service = build_service(personality, vehicle=vehicle)
    service.upload([*SURVEY[:2], one, waypoint()], proof=proof)
    assert service.done() == status
    assert (service.state.failed_item, service.state.field) == (2, field)
    assert service.heard("MISSION_COUNT") == []


def test_plan_that_was_accepted_and_differs_is_no_mixture(build_service):
    """The autopilot took all of it: what it made of an item is what differs."""
    service = build_service("ArduPilot")
    missions = service.autopilot.missions[0]
    plan = [waypoint(), waypoint(z=30.0), waypoint()]
    service.upload(plan, proof="Always")
    while len(missions.held) != 4:
        service.run(0.005)
    missions.held[2] = missions.held[2]._replace(z=31.0)
    assert service.done() == "Differs"
    assert service.state.aboard == "NotKnown"
