"""Which vehicle an ArduPilot is: no mode is ordered by another vehicle's number."""

from __future__ import annotations

import pytest

import modes_document
from plans import SURVEY, on_the_wire
from starts import ARM, ASK_VEHICLE, MISSION_START, SET_MODE, hops, told, uploaded

VEHICLES = pytest.mark.scenario(54, "Modes: what is no known vehicle gets no other one's")
TYPES = modes_document.types()
CLAIMED = sorted(set(TYPES) - {1, *range(19, 26)})  # what a plane may say, though it is none


def asked(service) -> int:
    return len([one for one in service.heard("COMMAND_LONG") if one.command == ASK_VEHICLE])


@VEHICLES
@pytest.mark.parametrize("vehicle_type", TYPES)
def test_type_is_its_vehicles(build_service, vehicle_type):
    """Each type of docs/modes.md, by the number of a mode in which the vehicles differ."""
    vehicle = TYPES[vehicle_type]
    fake = {**modes_document.fake_of(vehicle), "vehicle_type": vehicle_type}
    service = build_service("ArduPilot", **fake)
    numbers = modes_document.modes()[vehicle]
    for name in ("Hold", "Land", "Manual"):
        service.set_mode(name)
        assert service.done() == ("Done" if name in numbers else "NoSuchMode")
        service.run(1.1)
        if name in numbers:
            assert service.state.custom_mode == numbers[name][0]


@VEHICLES
@pytest.mark.parametrize("vehicle_type", modes_document.UNKNOWN)
def test_type_that_is_none_of_ardupilots_gets_nothing(build_service, vehicle_type):
    service = uploaded(build_service("ArduPilot", vehicle="plane", vehicle_type=vehicle_type))
    for name in ("Auto", "Guided", "ReturnToLaunch", "Hold", "Land", "Brake", "Manual"):
        service.set_mode(name)
        assert service.done() == "NoSuchMode"
    service.order_of("start")
    assert service.done() == "NoSuchMode"
    assert service.heard("COMMAND_LONG", "COMMAND_INT", "MISSION_SET_CURRENT") == []
    service.order_of("arm")
    assert service.done() == "Done"
    service.order_of("startmission")
    assert service.done() == "NoSuchMode"
    assert told(service) == [(ARM, 1, 0)]


@VEHICLES
@pytest.mark.parametrize("claimed", CLAIMED)
@pytest.mark.parametrize("vehicle", ["plane", "quadplane"])
def test_plane_that_says_another_type_gets_a_planes_modes(build_service, vehicle, claimed):
    """Q_MAV_TYPE. By a copter's numbers, RTL would be FLY_BY_WIRE_B, and AUTO TRAINING."""
    service = build_service("ArduPilot", vehicle=vehicle, vehicle_type=claimed)
    service.autopilot.load(on_the_wire(SURVEY, "ArduPilot"))
    claims = modes_document.modes()[TYPES[claimed]]
    for name, flown in (("ReturnToLaunch", "RTL"), ("Auto", "AUTO"), ("Guided", "GUIDED"), ("Manual", "MANUAL")):
        service.set_mode(name)
        if name not in claims and asked(service) == 0:  # by what it says: it is not even asked
            assert service.done() == "NoSuchMode"
            continue
        assert service.done() == "Done"
        assert service.autopilot.mode == flown
        service.run(1.1)
        assert service.state.modes == [name]
    assert asked(service) == 1


STARTS = {"copter": [(SET_MODE, 1, 4), (ARM, 1, 0), (MISSION_START, 0, 0)], "plane": [(ARM, 1, 0), (SET_MODE, 1, 10)],
          "QuadPlane": [(ARM, 1, 0), (SET_MODE, 1, 10)], "rover": [(ARM, 1, 0), (SET_MODE, 1, 10)],
          "submarine": [(ARM, 1, 0), (SET_MODE, 1, 3)], "blimp": []}  # fmt: skip


@VEHICLES
@pytest.mark.parametrize("vehicle_type", TYPES)
def test_each_type_is_started_as_its_vehicle_is(build_service, vehicle_type):
    """As the last table of docs/modes.md says; a blimp has no AUTO."""
    vehicle = TYPES[vehicle_type]
    fake = {**modes_document.fake_of(vehicle), "vehicle_type": vehicle_type, "uptime_s": 120.0}
    service = build_service("ArduPilot", **fake)
    plan = hops("rover", 3) if vehicle == "rover" else None
    uploaded(service, plan).order_of("start")
    assert service.done(limit_s=20) == ("Done" if STARTS[vehicle] else "NoSuchMode")
    assert told(service) == STARTS[vehicle] and service.autopilot.armed == (vehicle != "blimp")


@VEHICLES
@pytest.mark.parametrize("operation", ["start", "setmode"])
def test_without_an_answer_no_mode_is_ordered(build_service, operation):
    service = uploaded(build_service("ArduPilot", vehicle="quadplane", vehicle_type=2))
    service.wire.lose("<", name="COMMAND_ACK", times=None)
    if operation == "start":
        service.order_of("start")
    else:
        service.set_mode("ReturnToLaunch")
    assert service.done(limit_s=15) == "NoAnswer"
    assert told(service) == [] and asked(service) >= 5


@VEHICLES
def test_vehicle_is_asked_once_also_if_it_was_silent_meanwhile(build_service):
    service = build_service("ArduPilot")
    for name in ("Hold", "Guided"):
        service.set_mode(name)
        assert service.done() == "Done"
    assert asked(service) == 1
    service.autopilot.faults.fall_silent(from_time=service.now, for_s=7.0)
    service.run(9.0)
    service.set_mode("Hold")
    assert service.done() == "Done"
    assert asked(service) == 1
