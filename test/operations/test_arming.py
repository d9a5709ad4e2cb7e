"""Armed or not: what isArmed() says is what the aircraft is, and no late answer is taken for another command's."""

from __future__ import annotations

import pytest

from plans import SURVEY
from simulation.fake_autopilot import mavlink
from simulation.steered import Steered
from starts import ARM, hops, upload

ARMING = pytest.mark.scenario(54, "Armed or not: as a heartbeat shows it, which is asked for")


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
