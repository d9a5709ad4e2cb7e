"""On the Mega, whose integers have 16 bits: what an autopilot keeps in another form verifies. (What it would change is
refused, and every rule of it is tried: test/host/units/comparison.cpp, kept_value.cpp, wire_plan.cpp.)"""

from __future__ import annotations

import pytest

from plans import LAND, jump, waypoint
from simulation.fake_autopilot import item
from simulation.fake_autopilot.items import f32

LOITER_TURNS, LAND_START = 18, 189
PLACE = {"x": 473977420, "y": 85455970, "z": 20.0}

# By the autopilot and its vehicle, items and what of each is kept.
COMES_ABOARD = {
    ("PX4", "copter"): [
        (waypoint(param4=-90.0), {"param4": 270.0}),
        (waypoint(param4=255.0), {"param4": f32(254.999985)}),
        (waypoint(param4=360.0), {"param4": 0.0}),
        (jump(1, -1), {"param2": 65535.0}),
        (item(LAND_START, x=-353632171, y=1491652721), {"x": -353632160, "y": 1491652736}),
        (item(178, param1=1.0, param2=5.0, param3=-1.0, param4=1.0), {"param4": 1.0}),
    ],
    ("ArduPilot", "copter"): [
        (jump(1, -1), {"param2": -1.0}),
        (item(LAND, param4=90.0, **PLACE), {"param4": 1.0}),
        (item(LOITER_TURNS, param1=0.25, param3=-2550.0, **PLACE), {"param1": 0.25, "param3": -2550.0}),
        (waypoint(z=f32(28.6)), {"z": f32(28.5999985)}),
        (item(207, param1=1.0, param2=-0.0), {"param1": 1.0, "param2": 0.0}),
    ],
    ("ArduPilot", "plane"): [
        (waypoint(param2=30.0, param3=20.0), {"param1": 0.0, "param2": 30.0, "param3": 20.0})],
    ("ArduPilot", "rover"): [
        (waypoint(param1=7.0, param2=30.0, param3=20.0), {"param1": 7.0, "param2": 0.0, "param3": 0.0})],
}  # fmt: skip
REFUSED = {
    ("ArduPilot", "copter"): (item(LOITER_TURNS, param1=2.0, param3=303.0, **PLACE), "Param3"),
    ("ArduPilot", "plane"): (waypoint(param2=300.0), "Param2"),
    ("ArduPilot", "rover"): (waypoint(param1=2.5), "Param1"),
    ("PX4", "copter"): (waypoint(param4=361.0), "Param4"),
}


@pytest.mark.parametrize("vehicle", COMES_ABOARD, ids="-".join)
def test_what_means_the_same_comes_aboard_and_verifies_and_another_value_is_refused(build_service, vehicle):
    service = build_service(vehicle[0], vehicle=vehicle[1])
    rows = COMES_ABOARD[vehicle]
    plan = [waypoint(), waypoint(), *(one for one, _ in rows), waypoint()]
    service.upload(plan, proof="Always")
    assert service.done() == "Accepted"
    held = service.autopilot.plan()[-len(rows) - 1 : -1]
    for one, (_, kept) in zip(held, rows, strict=True):
        assert {name: getattr(one, name) for name in kept} == kept
    service.verify()
    assert service.done() == "Verified"
    wrong, field = REFUSED[vehicle]
    counts = len(service.heard("MISSION_COUNT"))
    service.upload([*plan[:2], wrong])
    assert (service.done(), service.state.failed_item, service.state.field) == ("NotKept", 2, field)
    assert len(service.heard("MISSION_COUNT")) == counts
