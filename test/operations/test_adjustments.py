"""How an aircraft flies to its place: a heading, a speed upwards and downwards (Adjustments)."""

from __future__ import annotations

import math

import pytest

from simulation.steered import bits

ADJUSTED = pytest.mark.scenario(68, "Adjustments: a heading and speeds of climb and descent, on ArduCopter alone")
YAW, SPEED = 115, 178


def turn_to(flown, heading: float, turn: float = 0.0, unset: bool = False) -> str:
    flown.order_of("turnTo", bits(heading), bits(turn), int(unset))
    return flown.done(limit_s=12)


def set_speed(flown, word: str, speed: float) -> str:
    flown.order_of(word, bits(speed))
    return flown.done(limit_s=12)


def commands(flown, *numbers: int) -> list:
    return [one for one in flown.ordered() if one.command in numbers]


@ADJUSTED
@pytest.mark.parametrize("heading, told", [(90.0, 90.0), (-90.0, 270.0), (0.0, 0.0), (200.25, 200.25), (-0.5, 359.5)])
def test_copter_turns_to_a_heading_and_stays_in_its_mode_and_place(build_flown, heading, told):
    flown = build_flown("ArduPilot")
    flown.fly()
    where = flown.where
    assert turn_to(flown, heading, 30.0) == "Done"
    (command,) = commands(flown, YAW)
    assert (command.param1, command.param2) == pytest.approx((told, 30.0), abs=1e-4)
    assert (command.param3, command.param4) == (0.0, 0.0)
    assert flown.autopilot.flight.heading(flown.now) == pytest.approx(told, abs=0.01)
    assert flown.mode == "GUIDED" and flown.where.distance(where) < 0.1 and flown.has_arrived()


@ADJUSTED
def test_copter_climbs_and_sinks_as_fast_as_it_is_told(build_flown):
    flown = build_flown("ArduPilot")
    flown.fly()
    before = flown.autopilot.flight.pace
    assert set_speed(flown, "climbs", 1.5) == "Done"
    assert flown.autopilot.flight.pace == before._replace(climb=1.5)
    assert set_speed(flown, "sinks", 0.5) == "Done"
    assert flown.autopilot.flight.pace == before._replace(descent=0.5)  # in GUIDED, one of the two alone
    assert [(one.param1, one.param2) for one in commands(flown, SPEED)] == [(2.0, 1.5), (3.0, 0.5)]


@ADJUSTED
def test_velocity_is_flown_on_beside_it(build_flown):
    flown = build_flown("ArduPilot")
    flown.fly()
    flown.fly_at(1.0)
    assert flown.done(limit_s=15) == "Done"
    assert set_speed(flown, "climbs", 2.0) == "Done"
    flown.run(1.0)
    assert flown.is_flown() and len(flown.velocities(flown.now - 1.0)) >= 4


@ADJUSTED
def test_lost_command_is_sent_again_and_turns_once(build_flown):
    flown = build_flown("ArduPilot")
    flown.fly()
    flown.wire.lose("<", name="COMMAND_ACK", times=1)
    assert turn_to(flown, 90.0) == "Done"
    assert len(commands(flown, YAW)) == 2
    assert flown.autopilot.flight.heading(flown.now) == pytest.approx(90.0)


@ADJUSTED
@pytest.mark.parametrize("mode, status", [("LOITER", "PilotHasIt"), ("RTL", "FailsafeHasIt")])
def test_nothing_is_adjusted_for_a_pilot_or_a_failsafe(build_flown, mode, status):
    flown = build_flown("ArduPilot")
    flown.fly()
    flown.pilot_sets(mode)
    before = len(flown.ordered())
    assert turn_to(flown, 90.0) == status
    assert set_speed(flown, "climbs", 1.0) == status
    assert len(flown.ordered()) == before


@ADJUSTED
@pytest.mark.parametrize("word, numbers, status, field", [
    ("turn", (361.0, 0.0), "BadRange", "Param1"), ("turn", (0.0, -1.0), "BadRange", "Param2"),
    ("turn", (0.0, 361.0), "BadRange", "Param2"), ("turn", (0.0, math.nan), "NotANumber", "Param2"),
    ("climbs", (0.0,), "BadSpeed", "Param2"), ("climbs", (-1.0,), "BadSpeed", "Param2"),
    ("sinks", (20.5,), "BadSpeed", "Param2"), ("sinks", (math.inf,), "NotFinite", "Param2"),
])  # fmt: skip
def test_number_that_cannot_be_meant_is_refused(build_flown, word, numbers, status, field):
    flown = build_flown("ArduPilot")
    flown.fly()
    before = len(flown.ordered())
    if word == "turn" and numbers[0] > 360:
        assert turn_to(flown, *numbers, unset=True) == "NotANumber"  # a Yaw that is not set
    else:
        assert (turn_to(flown, *numbers) if word == "turn" else set_speed(flown, word, *numbers)) == status
    assert flown.state.field == field and len(flown.ordered()) == before


@ADJUSTED
@pytest.mark.parametrize("personality, options", [
    ("PX4", {}), ("ArduPilot", {"vehicle": "rover"}), ("ArduPilot", {"vehicle": "plane"}),
])  # fmt: skip
def test_another_vehicle_is_refused(build_flown, personality, options):
    flown = build_flown(personality, uptime_s=120.0, **options)
    if options:
        flown.arm_in_guided()
    else:
        flown.fly()
    before = len(flown.ordered())
    assert turn_to(flown, 90.0) == "CommandUnsupported"
    assert set_speed(flown, "climbs", 1.0) == "CommandUnsupported"
    assert len(flown.ordered()) == before
