"""Armed or not: what isArmed() says is what the aircraft is, and no late answer is taken for another command's."""

from __future__ import annotations

import pytest

from plans import SURVEY
from simulation.fake_autopilot import mavlink
from simulation.service import is_followers
from simulation.steered import Steered
from starts import ARM, SET_MODE, hops, upload

ARMING = pytest.mark.scenario(54, "Armed or not: as a heartbeat shows it, which is asked for")
LATE = pytest.mark.scenario(54, "A late answer to a command is not taken for one to the next")


@ARMING
def test_armed_aircraft_starts_its_mission_at_once(service, personality):
    vehicle = "copter" if personality == "ArduPilot" else "px4"
    upload(service, hops(vehicle, 4))
    service.order_of("arm")
    assert service.done() == "Done"
    assert service.state.armed
    service.order_of("startmission")
    assert service.done() == "Done"
    assert service.autopilot.flight.index is not None


@ARMING
@pytest.mark.parametrize("personality", ["ArduPilot"])
def test_armed_rover_goes_to_a_place_at_once(personality):
    steered = Steered(personality, vehicle="rover", uptime_s=120.0)
    steered.run(2.0)
    steered.set_mode("Guided")
    assert steered.done() == "Done"
    steered.order_of("arm")
    assert steered.done() == "Done"
    steered.go_to(steered.place(20, 0), 0.0)
    assert steered.done() == "Done"


@ARMING
def test_disarmed_aircraft_gets_a_plan_at_once(service):
    service.order_of("arm")
    assert service.done() == "Done"
    service.run(2.0)
    service.order_of("disarm")
    assert service.done() == "Done"
    assert not service.autopilot.armed and not service.state.armed
    service.upload(SURVEY)
    assert service.done() == "Accepted"


@ARMING
@pytest.mark.parametrize("loss", [0.0, 3.0])
def test_arming_that_no_heartbeat_shows_is_unconfirmed(service, loss):
    service.wire.damage_bytes(lose=loss)
    service.run(2.0)
    react = service.autopilot._hears["COMMAND_LONG"]

    def hear(message, sender, now) -> None:
        if message.command == ARM:
            service.autopilot.answer(mavlink.MAVLink_command_ack_message(ARM, 0, 0, 0, *sender), now)
        else:
            react(message, sender, now)

    service.autopilot._hears["COMMAND_LONG"] = hear
    service.order_of("arm")
    assert service.done(limit_s=35 if loss else 15) == "Unconfirmed"
    assert not service.state.armed


@ARMING
def test_aircraft_in_the_air_stays_armed_while_it_is_not_heard(service):
    service.order_of("arm")
    assert service.done() == "Done"
    service.wire.pull("<")
    service.run(8.0)
    assert service.state.firmware == "Unknown" and service.state.armed


@LATE
def test_disarming_is_not_done_by_a_late_answer_to_arming(build_service):
    """A follower has asked in between."""
    service = build_service("ArduPilot")
    service.autopilot.kind = service.autopilot.kind._replace(disarms_idle_s=None)
    service.wire.delay("<", 3.3, name="COMMAND_ACK", where=lambda message: message.command == ARM)
    service.order_of("arm")
    assert service.done() == "Done"
    service.run(3.0)
    assert [1 for entry in service.wire.frames(">", "COMMAND_LONG") if is_followers(entry.message)]
    service.wire.lose(">", name="COMMAND_LONG", where=lambda message: message.command == ARM and message.param1 == 0)
    service.order_of("disarm")
    assert service.done() == "Done"
    assert not service.autopilot.armed and not service.state.armed


@LATE
def test_interval_is_not_taken_for_set_by_the_answer_to_a_listener(build_service):
    """The follower asks for MISSION_CURRENT while a plan is uploaded, and is answered late."""
    service = build_service("ArduPilot")
    asks = []
    react = service.autopilot._hears["COMMAND_LONG"]

    def hear(message, sender, now) -> None:
        if is_followers(message):
            asks.append(now)
            return service.autopilot.answer(mavlink.MAVLink_command_ack_message(511, 0, 0, 0, *sender), now, 0.8)
        return react(message, sender, now)

    service.autopilot._hears["COMMAND_LONG"] = hear
    service.upload(SURVEY * 12)
    while not asks:
        service.run(0.005)
        assert service.state.busy
    service.tell("cancel")
    assert service.done() == "Cancelled"
    service.order_of("interval", 9999, 500000)
    assert service.done() == "CommandFailed"
    assert service.now - asks[0] > 0.8


@LATE
def test_listener_does_not_take_the_late_answer_to_an_interval_of_the_sketch(build_service):
    service = build_service("ArduPilot")
    service.run(2.5)  # the follower asks at the third heartbeat
    service.wire.delay("<", 1.6, name="COMMAND_ACK", times=2, where=lambda message: message.command == 511)
    service.order_of("interval", 9999, 500000)
    assert service.done() == "CommandFailed"
    sent = [entry.time for entry in service.wire.frames(">", "COMMAND_LONG") if entry.message.command == 511]
    ended = service.now
    service.run(3.0)
    asked = [entry.time for entry in service.wire.frames(">", "COMMAND_LONG") if is_followers(entry.message)]
    answered = [entry.time for entry in service.wire.frames("<", "COMMAND_ACK") if entry.message.command == 511]
    assert len(sent) >= 2 and asked
    late = [time for time in answered if time > ended]
    assert all(time > late[0] for time in asked if time > ended)


@LATE
def test_listener_does_not_take_the_answer_to_an_interval_that_the_sketch_has_cancelled(build_service):
    service = build_service("ArduPilot")
    service.run(1.5)  # the follower asks at the third heartbeat
    service.wire.delay("<", 1.2, name="COMMAND_ACK", where=lambda message: message.command == 511)
    service.order_of("interval", 9999, 500000)
    service.run(0.05)
    service.tell("cancel")
    assert service.done() == "Cancelled"
    service.run(3.0)
    asked = [entry.time for entry in service.wire.frames(">", "COMMAND_LONG") if is_followers(entry.message)]
    answered = [entry.time for entry in service.wire.frames("<", "COMMAND_ACK") if entry.message.command == 511]
    assert asked and answered
    assert min(asked) > min(answered) + 1.2


@LATE
def test_start_is_not_refused_by_a_late_answer_to_a_mode_that_was_refused(build_service):
    service = build_service("ArduPilot", vehicle="copter", uptime_s=120.0)
    upload(service, hops("copter", 4))
    react = service.autopilot._hears["COMMAND_LONG"]

    def hear(message, sender, now) -> None:
        if message.command == SET_MODE and message.param2 == 6:  # RTL
            return service.autopilot.answer(mavlink.MAVLink_command_ack_message(SET_MODE, 4, 0, 0, *sender), now, 1.6)
        return react(message, sender, now)

    service.autopilot._hears["COMMAND_LONG"] = hear
    service.set_mode("ReturnToLaunch")
    assert service.done() == "CommandFailed"
    service.wire.lose(">", name="COMMAND_LONG", where=lambda message: message.command == SET_MODE)
    service.order_of("start", 0)
    assert service.done(limit_s=30) == "Done"
