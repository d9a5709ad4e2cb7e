"""A pilot, or a failsafe, takes the aircraft in the same moment as an order of Steering: he keeps it."""

from __future__ import annotations

import random

import pytest

from plans import on_the_wire, waypoint
from simulation.wire import Wire

MOMENT = pytest.mark.scenario(60, "Steering: whoever takes the aircraft in the moment of an order keeps it")
GIVEN_BACK_S = 0.3  # a mode is undone for so long at most, on a line that loses nothing
# And where so many of 100 bytes are lost: two heartbeats.
GIVEN_BACK_AT_S = {0.0: GIVEN_BACK_S, 1.0: 2.0, 3.0: 2.0}
WINDOW_S = 0.03  # from the heartbeat that shows no foreign mode to the order's arrival
OURS = {"ArduPilot": "Guided", "PX4": "Hold"}
PILOT = {"ArduPilot": "LOITER", "PX4": (3, 0)}
RETURNS, LANDS = {"ArduPilot": "RTL", "PX4": (4, 5)}, {"ArduPilot": "LAND", "PX4": (4, 6)}

ORDERS = {
    "goTo": lambda steered: steered.go_to(steered.place(10, 10), 15.0),
    "pause": lambda steered: steered.order_of("hold"),
    "resume": lambda steered: steered.order_of("goOn"),
    "returnHome": lambda steered: steered.order_of("home"),
    "landNow": lambda steered: steered.order_of("landNow"),
}


def far(steered) -> list:
    """A plan that is flown for minutes."""
    return [waypoint(*steered.place(20.0 * north, 0.0), 20.0) for north in range(1, 60)]


def in_the_air(steered, personality) -> None:
    steered.autopilot.load(on_the_wire(far(steered), personality))
    steered.fly(20.0)


def others(order: str) -> tuple[dict, dict]:
    """The modes of a pilot and of a failsafe; not the one that is ordered, which would not show."""
    return PILOT, LANDS if order == "returnHome" else RETURNS


def take_back(steered, mode: str) -> None:
    steered.set_mode(mode)
    assert steered.done() == "Done"
    steered.run(0.3)


def heartbeat_before(steered, time: float) -> float:
    """When the last heartbeat that came through had left the autopilot [s]."""
    return max(entry.time for entry in steered.wire.frames("<", "HEARTBEAT")
               if entry.time < time and "lost" not in entry.fate and entry.message.autopilot != 8)  # fmt: skip


def windows(steered, since: float) -> list[tuple[float, float]]:
    """When each order arrived that could change the mode, and how long before that the heartbeat had left [s]."""
    return [(time, time - heartbeat_before(steered, time)) for time, order in steered.orders_since(since)
            if order.command != 192 or order.param2]  # fmt: skip


def assert_kept(steered, mode, pilot_at: float, status: str, loss: float = 0.0) -> None:
    """The pilot's mode flies, and the status does not say anything else."""
    steered.run(1.5)
    ages = windows(steered, pilot_at)
    came_too_late = any(time - pilot_at <= window for time, window in ages)
    # PX4 tells of a mode once a second: of one that is undone within some milliseconds it tells never. ArduPilot tells
    # at once, but a line that loses may swallow that.
    if came_too_late and not hasattr(steered.autopilot, "kind"):
        return
    if loss and steered.mode != mode and any(time - pilot_at <= WINDOW_S for time, _ in ages):
        return
    assert steered.mode == mode, (status, steered.autopilot.modes_flown[-4:], pilot_at)
    assert steered.undone_s(mode, pilot_at) < GIVEN_BACK_AT_S[loss]
    assert not steered.may_steer
    ended_before = status == "Done"
    assert ended_before or status == ("PilotHasIt" if mode in PILOT.values() else "FailsafeHasIt")


@MOMENT
@pytest.mark.parametrize("begins_in", ["own", "Auto"])
@pytest.mark.parametrize("order", ORDERS)
def test_mode_that_is_set_around_an_order_is_kept(steered, personality, order, begins_in):
    in_the_air(steered, personality)
    own = OURS[personality] if begins_in == "own" else "Auto"
    take_back(steered, own)
    for number, after_ms in enumerate(range(0, 72, 6)):
        mode = others(order)[number % 2][personality]
        since = steered.now
        pilot_at = steered.pilot_sets_in(after_ms / 1000, mode)
        ORDERS[order](steered)
        status = steered.done(limit_s=12)
        steered.run(max(0.0, pilot_at - steered.now))
        assert_kept(steered, mode, pilot_at, status)
        assert all(window < WINDOW_S for _, window in windows(steered, since))
        take_back(steered, own)


@MOMENT
def test_mode_that_an_order_has_undone_is_set_again_and_told(build_steered):
    """ArduPilot's heartbeat tells of both."""
    steered = build_steered("ArduPilot")
    in_the_air(steered, "ArduPilot")
    for mode, status in (("RTL", "FailsafeHasIt"), ("LOITER", "PilotHasIt")):
        take_back(steered, "Auto")
        steered.wire.delay(">", 0.05, name="COMMAND_INT")
        since = steered.now
        ORDERS["goTo"](steered)
        while not steered.wire.frames(">", "COMMAND_INT") or steered.wire.frames(">", "COMMAND_INT")[-1].time < since:
            steered.run(0.002)
        pilot_at = steered.pilot_sets_in(0.01, mode)
        assert steered.done(limit_s=5) == status
        assert steered.step == "GiveBack"
        assert [flown for time, flown in steered.autopilot.modes_flown if time >= pilot_at] == [mode, "GUIDED", mode]
        assert 0 < steered.undone_s(mode, pilot_at) < GIVEN_BACK_S
        steered.run(2.0)
        assert steered.mode == mode and not steered.may_steer


@MOMENT
@pytest.mark.slow
@pytest.mark.parametrize("seed", range(6))
def test_mode_that_is_set_at_random_is_kept(make_steered, personality, seed):
    """A thousand flights at random: which order, in whose mode it begins, who sets another mode, and when."""
    steered = make_steered(wire=Wire(seed))
    chance = random.Random(seed)
    loss = (0.0, 1.0, 3.0)[seed % 3]
    in_the_air(steered, personality)
    for _ in range(25):
        own = chance.choice((OURS[personality], "Auto"))
        take_back(steered, own)
        order = chance.choice(list(ORDERS))
        mode = chance.choice(others(order))[personality]
        for direction in "><":
            steered.wire.damage_bytes(direction, lose=loss)
        steered.run(chance.random())
        pilot_at = steered.pilot_sets_in(chance.random() * 0.6, mode)
        ORDERS[order](steered)
        status = steered.done(limit_s=30)
        for direction in "><":
            steered.wire.damage_bytes(direction)
        steered.run(max(0.0, pilot_at - steered.now))
        assert_kept(steered, mode, pilot_at, status, loss)
