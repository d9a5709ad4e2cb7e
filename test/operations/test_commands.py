"""Commands on the firmware: their forms, the current item, and each vehicle's modes, as docs/modes.md has them."""

from __future__ import annotations

import pytest

import modes_document
from downloads import loaded
from plans import SURVEY, on_the_wire
from simulation.fake_autopilot import mavlink
from simulation.service import MODES
from starts import ARM, MISSION_START, SET_CURRENT, SET_MODE, current_on_the_wire, hops, told, uploaded

LONG_ONLY, INT_ONLY = 7, 8  # MAV_RESULT
NUMBERS = (1.5, -2.25, 1e-20, 4.0, -9.0, 16777216.0, 7.125)


def answered_by(service, results: dict[str, int]) -> None:
    """Each command, by its form."""
    for name, result in results.items():
        service.autopilot._hears[name] = lambda message, sender, now, result=result: service.autopilot.answer(
            mavlink.MAVLink_command_ack_message(message.command, result, 0, 0, *sender), now)  # fmt: skip


@pytest.mark.scenario(54, "Commands: in the form that is taken")
@pytest.mark.parametrize("is_place", [False, True], ids=["COMMAND_LONG", "COMMAND_INT"])
def test_command_goes_out_as_it_was_meant_and_in_the_other_form_where_that_is_the_only_one(service, is_place):
    answered_by(service, {"COMMAND_LONG": INT_ONLY * (not is_place), "COMMAND_INT": LONG_ONLY * is_place})
    if is_place:
        service.send_command(31000, *NUMBERS[:4], 0.0, 0.0, NUMBERS[6], place=(-9, 16777216), frame=2)
    else:
        service.send_command(31000, *NUMBERS)
    assert service.done() == "Done"
    (as_long,), (as_int,) = service.heard("COMMAND_LONG"), service.heard("COMMAND_INT")
    assert [getattr(as_long, f"param{n}") for n in range(1, 8)] == pytest.approx(NUMBERS)
    assert [as_int.param1, as_int.param2, as_int.param3, as_int.param4] == pytest.approx(NUMBERS[:4])
    assert (as_int.x, as_int.y, as_int.z, as_int.frame) == (-9, 16777216, 7.125, mavlink.MAV_FRAME_MISSION)


@pytest.mark.scenario(51, "A command that must not happen twice is not repeated")
@pytest.mark.parametrize("command", [181, 42600], ids=["relay", "winch"])
def test_command_that_must_not_happen_twice_leaves_once(service, command):
    """The first and the last of their list in flash."""
    service.wire.lose("<", name="COMMAND_ACK", times=None, where=lambda message: message.command == command)
    service.send_command(command, 1.0, 1.0)
    assert service.done() == "Unconfirmed" and len(service.heard("COMMAND_LONG")) == 1


MODE = pytest.mark.scenario(54, "Modes by one name on every vehicle")
TYPES = modes_document.types()
STARTS = {"copter": [(SET_MODE, 1, 4), (ARM, 1, 0), (MISSION_START, 0, 0)], "plane": [(ARM, 1, 0), (SET_MODE, 1, 10)],
          "QuadPlane": [(ARM, 1, 0), (SET_MODE, 1, 10)], "rover": [(ARM, 1, 0), (SET_MODE, 1, 10)],
          "submarine": [(ARM, 1, 0), (SET_MODE, 1, 3)], "blimp": [], "none": []}  # fmt: skip


@MODE
@pytest.mark.parametrize("vehicle", modes_document.modes())
def test_each_mode_has_the_vehicles_own_number(build_service, vehicle):
    personality = "PX4" if vehicle == "PX4" else "ArduPilot"
    service = build_service(personality, **modes_document.fake_of(vehicle))
    service.autopilot.load(on_the_wire(SURVEY, personality))
    numbers = modes_document.modes()[vehicle]
    for name in MODES:
        service.run(1.1)
        before, flown = len(told(service)), service.state.modes
        service.set_mode(name)
        if name not in numbers:
            assert service.done() == "NoSuchMode" and len(told(service)) == before
            continue
        assert service.done() == "Done"
        main, sub = numbers[name]
        assert told(service)[before:] == [(SET_MODE, 1, main)] * (flown != [name])
        service.run(1.1)
        assert service.state.modes == [name]
        assert service.state.custom_mode == (main << 16 | sub << 24 if vehicle == "PX4" else main)


@MODE
@pytest.mark.parametrize("vehicle_type", [*TYPES, *modes_document.UNKNOWN])
def test_each_type_is_started_and_held_as_its_vehicle_is(build_service, vehicle_type):
    """By the first and the last table of docs/modes.md: a blimp has no AUTO, an unknown type no mode."""
    vehicle = TYPES.get(vehicle_type, "none")
    fake = {**modes_document.fake_of("plane" if vehicle == "none" else vehicle), "uptime_s": 120.0}
    service = build_service("ArduPilot", **{**fake, "vehicle_type": vehicle_type})
    # (A QuadPlane must not land where its last waypoint is.)
    uploaded(service, hops("rover", 3) if vehicle in ("rover", "QuadPlane") else None).order_of("start")
    assert service.done(limit_s=20) == ("Done" if STARTS[vehicle] else "NoSuchMode")
    assert told(service) == STARTS[vehicle] and service.autopilot.armed == bool(STARTS[vehicle])
    service.set_mode("Hold")
    if vehicle == "none":
        assert service.done() == "NoSuchMode"
        assert service.heard("COMMAND_LONG", "COMMAND_INT", "MISSION_SET_CURRENT") == []
        return
    assert service.done() == "Done"
    service.run(1.1)
    assert service.state.custom_mode == modes_document.modes()[vehicle]["Hold"][0]


@pytest.mark.scenario(46, "Set current: in the sketch's numbering")
def test_current_item_is_set_in_the_sketchs_numbering(service, personality):
    loaded(service, SURVEY)
    service.order_of("setcurrent", 2)
    assert service.done() == "Done"
    home = personality == "ArduPilot"
    assert told(service)[-1] == (SET_CURRENT, 2 + home, 0)
    service.run(1.5)
    assert current_on_the_wire(service) == 2 + home and service.followed.current == 2
