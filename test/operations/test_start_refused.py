"""start() that cannot fly what it has armed: it disarms it, unless the aircraft is somebody else's by then."""

from __future__ import annotations

import pytest

from disorders import latency_of
from simulation.service import asks_for_heartbeat, is_followers
from simulation.wire import Wire
from starts import (
    ARM,
    MISSION_START,
    ON_VEHICLES,
    SET_MODE,
    hops,
    made,
    start,
    told,
    upload,
)

REFUSED = pytest.mark.scenario(49, "start() disarms what it has armed and cannot fly, and says so")
LOST = pytest.mark.scenario(49, "start(): every frame may be lost")


def without_takeoff(vehicle: str) -> list:
    return hops(vehicle, 4)[1:]


@REFUSED
def test_copter_that_refuses_auto_is_disarmed_and_it_is_said(build_service):
    service = made(build_service, "copter")
    upload(service, without_takeoff("copter"))
    began = service.now
    assert start(service) == "CommandFailed"
    state = service.state
    assert (state.step, state.arming, state.last_result) == ("Begin", "Disarmed", 0)
    assert not service.autopilot.armed and service.now - began < 4.0
    assert told(service) == [(SET_MODE, 1, 4), (ARM, 1, 0), (MISSION_START, 0, 0), (ARM, 0, 0)]
    assert {one.param2 for one in service.heard("COMMAND_LONG") if one.command == ARM} == {0.0}
    assert (2, "Auto: Missing Takeoff Cmd") in service.texts
    service.run(1.2)
    assert not service.state.armed


@REFUSED
def test_rover_that_gets_no_auto_in_15_s_is_disarmed(build_service):
    service = made(build_service, "rover", uptime_s=31.0, position_s=60.0)
    upload(service, hops("rover", 4))
    assert start(service, limit_s=40) == "CommandFailed"
    sent = [entry for entry in service.wire.frames(">", "COMMAND_LONG") if entry.message.command in (ARM, SET_MODE)]
    tries = [entry.time for entry in sent if (entry.message.command, entry.message.param2) == (SET_MODE, 10)]
    assert 14.5 < tries[-1] - tries[0] < 16.0
    assert all(0.99 < later - before < 1.1 for before, later in zip(tries, tries[1:], strict=False))
    assert (sent[-1].message.command, sent[-1].message.param1) == (ARM, 0)
    assert sent[-1].time - tries[-1] < 1.2  # behind the next heartbeat
    assert (service.state.step, service.state.arming) == ("AutoMode", "Disarmed")
    assert not service.autopilot.armed


def before_next(service, command: int, param1: float, param2: float | None, do) -> None:
    """When the autopilot hears this the first time, `do` it first; "swallowed" is all that becomes of it then."""
    react = service.autopilot._hears["COMMAND_LONG"]
    done = []

    def hear(message, sender, now) -> None:
        hit = (message.command, message.param1) == (command, param1) and param2 in (None, message.param2)
        if hit and not done:
            done.append(True)
            if do(now) == "swallowed":
                return
        react(message, sender, now)

    service.autopilot._hears["COMMAND_LONG"] = hear


AT_STEPS = [("copter", 5, "ReadyMode"), ("copter", 5, "Arm"), ("copter", 5, "Begin"), ("copter", 5, "Confirm"),
            ("rover", 4, "Arm"), ("rover", 4, "AutoMode"), ("rover", 4, "Confirm"),
            # The mode in which start() has put it before: behind AUTO it is somebody else's too.
            ("copter", 4, "Confirm"), ("rover", 0, "Confirm")]  # fmt: skip


@REFUSED
@pytest.mark.parametrize("vehicle, other, step", AT_STEPS)
def test_mode_that_somebody_else_sets_meanwhile_is_left_alone(build_service, vehicle, other, step):
    """Just before the autopilot hears the order: an order that then undoes that mode is undone itself."""
    service = made(build_service, vehicle)
    upload(service, hops(vehicle, 4))
    when = {"ReadyMode": (SET_MODE, 1, 4), "Arm": (ARM, 1, 0), "AutoMode": (SET_MODE, 1, 10),
            "Begin": (MISSION_START, 0, 0), "Confirm": (512, 42, 0)}[step]  # fmt: skip
    taken = []

    def take(now) -> None:
        if step == "Confirm" and not service.autopilot.armed:
            return before_next(service, *when, take)  # it is asked before it is armed, too
        taken.append(now)
        service.autopilot._set_mode(other, now)

    before_next(service, *when, take)
    assert start(service) == "TakenOver"
    autopilot = service.autopilot
    assert taken and autopilot.kind.modes[autopilot.mode] == other
    number = len(told(service))
    service.run(5.0)
    assert len(told(service)) == number
    assert autopilot.kind.modes[autopilot.mode] == other
    # The mode was there before the arming, and a heartbeat has shown that: nobody but start() has armed it.
    is_too_late = step == "Arm"
    was_armed = (ARM, 1, 0) in told(service)
    assert ((ARM, 0, 0) in told(service)) == is_too_late
    assert service.state.arming == ("Disarmed" if is_too_late else "Armed" if was_armed else "Untouched")
    assert autopilot.armed == (was_armed and not is_too_late)


@REFUSED
@pytest.mark.parametrize("direction, name", [(">", "COMMAND_LONG"), ("<", "COMMAND_ACK"), ("<", "HEARTBEAT")])
def test_disarming_is_repeated_until_a_heartbeat_shows_it(build_service, direction, name):
    service = made(build_service, "copter")
    service.autopilot.kind = service.autopilot.kind._replace(disarms_idle_s=None)
    upload(service, without_takeoff("copter"))
    disarmed = [False]
    before_next(service, ARM, 0, 0, lambda now: disarmed.__setitem__(0, True))
    if name == "HEARTBEAT":
        service.wire.lose(direction, name=name, times=3, where=lambda message: disarmed[0])
    else:
        service.wire.lose(direction, name=name, times=3,
                          where=lambda message: message.command == ARM and getattr(message, "param1", 0) == 0
                          and (direction == ">" or disarmed[0]))  # fmt: skip
    assert start(service, limit_s=30) == "CommandFailed"
    assert service.state.arming == "Disarmed" and not service.autopilot.armed


@REFUSED
@ON_VEHICLES
def test_cancelled_anywhere_it_goes_no_further_and_another_start_flies(build_service, vehicle):
    for at in range(1, 7):
        service = made(build_service, vehicle)
        upload(service, hops(vehicle, 4))
        sent = said(service, "COMMAND_LONG")
        service.order_of("start")
        if not reaches(service, sent + at):
            break
        service.tell("cancel")
        assert service.done(limit_s=0.1) == "Cancelled"
        sent = said(service, "COMMAND_LONG", "MISSION_SET_CURRENT")
        service.run(3.0)
        assert said(service, "COMMAND_LONG", "MISSION_SET_CURRENT") == sent
        service.tell("armed", 1)
        assert start(service) == "Done"
    assert at > {"px4": 1, "rover": 4, "copter": 5}[vehicle]


def said(service, *names: str) -> int:
    """How many of these messages have left, without what a follower asks for."""
    return sum(not is_followers(entry.message) and not asks_for_heartbeat(entry.message)
               for entry in service.wire.frames(">", *names))  # fmt: skip


def reaches(service, commands: int) -> bool:
    """Go on until so many COMMAND_LONG have left; false if it ends before."""
    before = len(service.ends)
    while said(service, "COMMAND_LONG") < commands:
        if len(service.ends) > before:
            return False
        service.run(0.002)
    return True


@LOST
@ON_VEHICLES
def test_on_a_bad_line_it_never_says_done_falsely_and_ends(build_service, vehicle):
    ends = []
    for seed in range(8):
        service = made(build_service, vehicle, wire=Wire(seed))
        upload(service, hops(vehicle, 5))
        service.order_of("setcurrent", 3)
        assert service.done() == "Done"
        for direction in "<>":
            service.wire.at_random(direction, lose=25, repeat=8, delay=8, hold_past_next=4)
        service.wire.set_latency(latency_of(seed))
        ends.append(start(service, limit_s=90))
        if ends[-1] == "Done":
            assert service.begun[0] == 0 and service.autopilot.armed
        elif service.state.arming == "Disarmed":
            assert not service.autopilot.armed
    assert ends.count("Done") >= 4, ends
