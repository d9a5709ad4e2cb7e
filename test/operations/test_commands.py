"""Commands: each confirmed by COMMAND_ACK, with its own tries."""

from __future__ import annotations

import math
from itertools import pairwise

import pytest

import modes_document
from downloads import loaded
from plans import SURVEY, on_the_wire
from simulation.fake_autopilot import mavlink
from simulation.service import MODES
from starts import ASK_VEHICLE, current_on_the_wire

COMMANDS = pytest.mark.scenario(54, "Commands: acknowledged, lost, in progress, refused")
SERVO, RELAY, GRIPPER, CHANGE_SPEED, REPOSITION = 183, 181, 211, 178, 192
ARM, SET_MODE, MISSION_START, SET_CURRENT, INTERVAL = 400, 176, 300, 224, 511
RESULTS = {0: "Done", 1: "CommandRejected", 2: "CommandDenied", 3: "CommandUnsupported", 4: "CommandFailed",
           6: "CommandRefused", 7: "CommandLongOnly", 8: "CommandIntOnly", 9: "CommandFrame", 10: "NotInControl",
           11: "CommandRefused", 77: "CommandRefused"}  # fmt: skip


def deafen(service) -> None:
    """None of the autopilot's own acknowledgements arrives: the test says what does."""
    autopilot = service.autopilot
    push = autopilot._push

    def without_acks(time, message) -> None:
        if isinstance(message, bytes) or message.get_type() != "COMMAND_ACK":
            push(time, message)

    autopilot._push = without_acks


def acknowledge(service, command: int, result: int, target: tuple[int, int] = (1, 191), sender=None) -> None:
    service.say(mavlink.MAVLink_command_ack_message(command, result, 0, 0, *target), sender)


@COMMANDS
def test_each_result_has_its_status(service):
    deafen(service)
    for number, (result, status) in enumerate(RESULTS.items(), start=1):
        # Half a metre as a number: there is no other form to send it in.
        assert service.send_command(CHANGE_SPEED, 1.0, 5.0, 0.0, 0.0, 0.5) == "WaitingForAutopilot"
        service.run_until_sent("COMMAND_LONG", number)
        acknowledge(service, CHANGE_SPEED, result)
        assert service.done(limit_s=1) == status
        assert service.state.last_result == result
    service.run(4.0)
    assert len(service.heard("COMMAND_LONG")) == len(RESULTS)


LONG_ONLY, INT_ONLY = 7, 8


def sent_numbers(message) -> list[float]:
    """All seven, of either form."""
    names = ("param1", "param2", "param3", "param4", "param5", "param6", "param7")
    if message.get_type() == "COMMAND_INT":
        names = (*names[:4], "x", "y", "z")
    return [getattr(message, name) for name in names]


@COMMANDS
@pytest.mark.parametrize(
    "numbers", [(1.5, -2.25, 0.0, 4.0, 0.0, 0.0, 7.125), (1.0, 2.0, 3.0, 4.0, -9.0, 123456.0, 0.0)]
)
def test_command_that_is_taken_as_command_int_only_is_sent_as_one(service, numbers):
    deafen(service)
    service.send_command(CHANGE_SPEED, *numbers)
    service.run_until_sent("COMMAND_LONG")
    acknowledge(service, CHANGE_SPEED, INT_ONLY)
    service.run_until_sent("COMMAND_INT")
    (message,) = service.heard("COMMAND_INT")
    assert sent_numbers(message) == [*numbers] and message.frame == mavlink.MAV_FRAME_MISSION
    acknowledge(service, CHANGE_SPEED, 0)
    assert service.done(limit_s=1) == "Done"
    assert len(service.heard("COMMAND_LONG")) == 1


@COMMANDS
def test_command_that_is_taken_as_command_long_only_is_sent_as_one(service):
    deafen(service)
    service.send_command(31000, 1.5, 2.0, 3.0, 4.0, 0.0, 0.0, 7.0, place=(-9, 16777216), frame=2)
    service.run_until_sent("COMMAND_INT")
    acknowledge(service, 31000, LONG_ONLY)
    service.run_until_sent("COMMAND_LONG")
    (message,) = service.heard("COMMAND_LONG")
    assert sent_numbers(message) == [1.5, 2.0, 3.0, 4.0, -9.0, 16777216.0, 7.0]
    acknowledge(service, 31000, 0)
    assert service.done(limit_s=1) == "Done"


@COMMANDS
@pytest.mark.parametrize("frame, place", [(6, (-353632621, 1491652374)), (0, (1, 2)), (2, (16777217, 0))])
def test_place_is_not_squeezed_into_a_command_long(service, frame, place):
    deafen(service)
    service.send_command(REPOSITION, -1.0, 1.0, place=place, frame=frame)
    service.run_until_sent("COMMAND_INT")
    acknowledge(service, REPOSITION, LONG_ONLY)
    assert service.done(limit_s=1) == "CommandLongOnly"
    service.run(2.0)
    assert service.heard("COMMAND_LONG") == []


@COMMANDS
@pytest.mark.parametrize("number", [0.5, math.nan, math.inf, 3e9])
def test_number_that_is_not_whole_is_not_squeezed_into_a_command_int(service, number):
    deafen(service)
    service.send_command(31000, 0.0, 0.0, 0.0, 0.0, 0.0, number)
    service.run_until_sent("COMMAND_LONG")
    acknowledge(service, 31000, INT_ONLY)
    assert service.done(limit_s=1) == "CommandIntOnly"
    assert service.heard("COMMAND_INT") == []


@COMMANDS
def test_changed_form_is_made_up_for_when_it_is_lost_and_still_goes_out_once_where_once_is_meant(service):
    deafen(service)
    service.send_command(CHANGE_SPEED, 1.0, 5.0)
    service.run_until_sent("COMMAND_LONG")
    service.wire.lose(">", name="COMMAND_INT")
    acknowledge(service, CHANGE_SPEED, INT_ONLY)
    service.run_until_sent("COMMAND_INT", 2)
    acknowledge(service, CHANGE_SPEED, 0)
    assert service.done(limit_s=1) == "Done"
    service.send_command(SERVO, 9.0, 1500.0)
    service.run_until_sent("COMMAND_LONG", 2)
    before = len(service.sent_at("COMMAND_INT"))
    acknowledge(service, SERVO, INT_ONLY)
    assert service.done(limit_s=10) == "Unconfirmed"
    assert len(service.sent_at("COMMAND_INT")) == before + 1


@COMMANDS
def test_command_goes_out_as_it_was_meant(service):
    deafen(service)
    numbers = (1.5, -2.25, 1e-20, math.nan, 3.4e38, -0.0, 7.125)
    service.send_command(31000, *numbers)
    service.run_until_sent("COMMAND_LONG")
    (message,) = service.heard("COMMAND_LONG")
    sent = [getattr(message, f"param{number}") for number in range(1, 8)]
    assert [math.isnan(one) for one in sent] == [math.isnan(one) for one in numbers]
    assert sent[0] == 1.5 and sent[1] == -2.25 and sent[4] == pytest.approx(3.4e38) and sent[6] == 7.125
    assert math.copysign(1, sent[5]) == -1
    assert (message.target_system, message.target_component, message.command) == (1, 1, 31000)


@COMMANDS
def test_command_with_a_place_goes_out_with_all_its_digits(service):
    deafen(service)
    service.send_command(REPOSITION, -1.0, 1.0, 0.0, math.nan, 0.0, 0.0, 25.5, place=(-353632621, 1491652374), frame=6)
    service.run_until_sent("COMMAND_INT")
    (message,) = service.heard("COMMAND_INT")
    assert (message.x, message.y, message.z, message.frame) == (-353632621, 1491652374, 25.5, 6)
    assert (message.param1, message.param2) == (-1.0, 1.0)
    acknowledge(service, REPOSITION, 0)
    assert service.done(limit_s=1) == "Done"


@COMMANDS
@pytest.mark.parametrize("direction, name", [(">", "COMMAND_LONG"), ("<", "COMMAND_ACK")])
def test_lost_command_or_answer_is_made_up_for(service, direction, name):
    service.wire.lose(direction, name=name, times=4)
    service.order_of("interval", 33, 500000)
    assert service.done() == "Done"
    assert [message.confirmation for message in service.heard("COMMAND_LONG")] == [0, 1, 2, 3, 4]
    times = service.sent_at("COMMAND_LONG")
    # Every 1500 ms, and sooner once it is seen that the line loses.
    assert all(0.015 < later - sooner < 1.51 for sooner, later in pairwise(times))


@COMMANDS
def test_command_that_is_never_answered_ends_after_5_tries(service):
    deafen(service)
    service.send_command(CHANGE_SPEED, 1.0, 5.0)
    assert service.done(limit_s=12) == "NoAnswer"
    times = service.sent_at("COMMAND_LONG")
    assert len(times) == 5 and service.now - times[0] == pytest.approx(7.5, abs=0.1)  # behind heartbeats


@COMMANDS
def test_in_progress_extends_the_wait(service):
    deafen(service)
    service.send_command(CHANGE_SPEED, 1.0, 5.0)
    service.run_until_sent("COMMAND_LONG")
    for _ in range(3):
        acknowledge(service, CHANGE_SPEED, 5)
        service.run(4.0)
    assert len(service.heard("COMMAND_LONG")) == 1
    acknowledge(service, CHANGE_SPEED, 0)
    assert service.done(limit_s=1) == "Done"


@COMMANDS
def test_autopilot_that_is_in_progress_for_ever_ends_the_command_at_its_limit(service):
    deafen(service)
    service.send_command(CHANGE_SPEED, 1.0, 5.0)
    began = service.run_until_sent("COMMAND_LONG")
    for _ in range(29):
        acknowledge(service, CHANGE_SPEED, 5)
        service.run(4.0)
    assert not service.ends
    acknowledge(service, CHANGE_SPEED, 5)
    assert service.done(limit_s=10) == "TookTooLong"
    assert service.now - began < 121.5


@COMMANDS
def test_answer_to_another_command_or_for_another_one_is_no_answer(service):
    deafen(service)
    service.send_command(CHANGE_SPEED, 1.0, 5.0)
    service.run_until_sent("COMMAND_LONG")
    acknowledge(service, ARM, 0)
    acknowledge(service, CHANGE_SPEED, 4, target=(255, 190))
    acknowledge(service, CHANGE_SPEED, 4, target=(1, 190))
    acknowledge(service, CHANGE_SPEED, 4, sender=(2, 1))
    acknowledge(service, CHANGE_SPEED, 4, sender=(1, 154))
    service.run(0.2)
    assert service.state.busy
    acknowledge(service, CHANGE_SPEED, 0, target=(0, 0))
    assert service.done(limit_s=1) == "Done"


ONCE = pytest.mark.scenario(51, "An item is reached once; a command that must not happen twice is not repeated")


@ONCE
def test_commands_that_must_not_happen_twice_are_sent_once(service):
    deafen(service)
    commands = (SERVO, 184, RELAY, 182, GRIPPER, 208, 42600, 203, 2000, 185, 187, 209, 246)
    for number, command in enumerate(commands, start=1):
        service.send_command(command, 9.0, 1500.0)
        assert service.done(limit_s=10) == "Unconfirmed"
        assert len(service.heard("COMMAND_LONG")) == number
        assert service.now - service.sent_at("COMMAND_LONG")[-1] == pytest.approx(5.0, abs=0.05)


ARMING = pytest.mark.scenario(54, "Arming: by arm() and start() alone, and never forced")


@ARMING
def test_arm_and_disarm(service):
    service.order_of("arm")
    assert service.done() == "Done"
    assert service.autopilot.armed and service.state.armed
    service.order_of("disarm")
    assert service.done() == "Done"
    assert not service.autopilot.armed and not service.state.armed
    assert [(one.command, one.param1, one.param2) for one in service.heard("COMMAND_LONG")] == [
        (ARM, 1.0, 0.0), (ARM, 0.0, 0.0)]  # fmt: skip


@ARMING
def test_refused_arming_is_said_with_the_words(build_service):
    service = build_service("ArduPilot", uptime_s=0.0)
    service.order_of("arm")
    assert service.done() == "CommandFailed"
    service.run(0.1)
    assert (2, "Arm: AHRS: waiting for home") in service.texts
    assert not service.autopilot.armed


@ARMING
@pytest.mark.parametrize("magic", [21196.0, 2989.0, 1.0])
def test_arming_is_never_forced_not_even_by_any_command(service, magic):
    service.send_command(ARM, 1.0, magic)
    service.done()
    service.send_command(ARM, 1.0, magic, place=(0, 0))
    service.done()
    assert {one.param2 for one in service.heard("COMMAND_LONG", "COMMAND_INT") if one.command == ARM} == {0.0}


@ARMING
def test_mission_start_is_not_sent_to_a_disarmed_px4_by_any_command(build_service):
    service = build_service("PX4")
    service.upload(SURVEY)
    assert service.done() == "Accepted"
    service.send_command(MISSION_START)
    assert service.done() == "NotArmed"
    service.order_of("startmission")
    assert service.done() == "NotArmed"
    assert service.heard("COMMAND_LONG") == [] and not service.autopilot.armed


MODE = pytest.mark.scenario(54, "Modes by one name on every vehicle")


@MODE
@pytest.mark.parametrize("name", MODES)
@pytest.mark.parametrize("vehicle", modes_document.modes())
def test_mode_is_the_vehicles_own(build_service, vehicle, name):
    """By the table of docs/modes.md."""
    personality = "PX4" if vehicle == "PX4" else "ArduPilot"
    service = build_service(personality, **modes_document.fake_of(vehicle))
    service.autopilot.load(on_the_wire(SURVEY, personality))
    service.set_mode(name)
    number = modes_document.modes()[vehicle].get(name)
    if number is None:
        assert service.done() == "NoSuchMode"
        assert service.heard("COMMAND_LONG") == []
        return
    assert service.done() == "Done"
    main, sub = number
    was_there = name == ("Manual" if personality == "ArduPilot" else "Hold")  # its first mode: nothing is ordered
    assert [(one.command, one.param1, one.param2, one.param3) for one in service.heard("COMMAND_LONG")
            if one.command != ASK_VEHICLE] == [(SET_MODE, 1.0, main, sub)] * (not was_there)  # fmt: skip
    service.run(1.1)
    state = service.state
    assert state.modes == [name]
    assert state.custom_mode == (main << 16 | sub << 24 if personality == "PX4" else main)


@MODE
def test_autopilots_own_number_of_a_mode(service, personality):
    number = 6 if personality == "ArduPilot" else 4 << 16 | 5 << 24
    service.order_of("custommode", number)
    assert service.done() == "Done"
    service.run(1.1)
    assert service.state.custom_mode == number
    assert service.state.modes == ["ReturnToLaunch"]


def test_number_that_is_none_of_ardupilots_modes_is_refused_and_not_cut(build_service):
    service = build_service("ArduPilot")
    service.order_of("custommode", 77777)
    assert service.done() == "NoSuchMode"
    assert service.heard("COMMAND_LONG") == []


SHOWN = pytest.mark.scenario(54, "A mode is set when a heartbeat shows it")


@SHOWN
def test_px4_that_accepts_a_mode_and_then_refuses_it_has_refused_it(build_service):
    """OFFBOARD without setpoints, and the mission mode without a plan, of an armed aircraft: two answers."""
    service = build_service("PX4")
    service.order_of("arm")
    assert service.done() == "Done"
    for name in ("Guided", "Auto"):
        service.set_mode(name)
        assert service.done(limit_s=3) == "CommandRejected"
        answers = [entry.message for entry in service.wire.frames("<", "COMMAND_ACK")]
        assert [one.result for one in answers if one.command == SET_MODE][-2:] == [0, 1]


@SHOWN
def test_mode_that_was_accepted_and_is_never_shown_is_unconfirmed(service, personality):
    service.set_mode("Manual")  # by which it is known which vehicle it is
    assert service.done() == "Done"
    deafen(service)
    service.run(2.0)
    service.autopilot._hears["COMMAND_LONG"] = lambda message, sender, now: None
    service.run_until(math.ceil(service.now) - 0.1)  # a heartbeat comes
    before = service.now
    service.set_mode("ReturnToLaunch")
    service.run(0.2)
    acknowledge(service, SET_MODE, 0)
    assert service.done() == "Unconfirmed"
    assert 1.5 < service.now - before < 2.7  # the first heartbeat behind the wait still shows the mode before
    service.order_of("custommode", 6 if personality == "ArduPilot" else 4 << 16 | 5 << 24)
    assert service.done(limit_s=13) == "NoAnswer"  # and this one was not accepted either


@SHOWN
def test_mode_whose_answers_are_lost_is_seen_in_the_heartbeat(service):
    service.wire.lose("<", name="COMMAND_ACK", times=None, where=lambda message: message.command == SET_MODE)
    service.set_mode("ReturnToLaunch")
    assert service.done(limit_s=4) == "Done"
    assert service.state.modes == ["ReturnToLaunch"]


CURRENT = pytest.mark.scenario(46, "Set current: by command, by the older message, out of range, lost")


@CURRENT
def test_current_item_is_set_in_the_sketchs_numbering(service, personality):
    loaded(service, SURVEY)
    service.order_of("setcurrent", 2)
    assert service.done() == "Done"
    home = personality == "ArduPilot"
    (message,) = service.heard("COMMAND_LONG")
    assert (message.command, message.param1, message.param2) == (SET_CURRENT, 2 + home, 0)
    service.run(1.5)
    assert current_on_the_wire(service) == 2 + home
    assert service.followed.current == 2


@CURRENT
def test_item_beyond_the_plan_that_was_uploaded_is_refused_at_once(service):
    service.upload(SURVEY)
    assert service.done() == "Accepted"
    for item in (5, 9, 65535):
        before = service.now
        service.order_of("setcurrent", item)
        assert service.done() == "NoSuchItem"
        assert service.now - before < 0.1
    assert service.heard("COMMAND_LONG", "MISSION_SET_CURRENT") == []
    service.order_of("setcurrent", 4)
    assert service.done() == "Done"


def older(service) -> None:
    """The autopilot does not know the command: it answers UNSUPPORTED."""
    react = service.autopilot._hears["COMMAND_LONG"]

    def hear(message, sender, now) -> None:
        if message.command != SET_CURRENT:
            return react(message, sender, now)
        service.autopilot.answer(mavlink.MAVLink_command_ack_message(SET_CURRENT, 3, 0, 0, *sender), now)

    service.autopilot._hears["COMMAND_LONG"] = hear


@CURRENT
def test_older_autopilot_gets_the_older_message(service, personality):
    loaded(service, SURVEY)
    older(service)
    service.order_of("setcurrent", 2)
    assert service.done() == "Done"
    home = personality == "ArduPilot"
    assert [message.seq for message in service.heard("MISSION_SET_CURRENT")] == [2 + home]
    assert current_on_the_wire(service) == 2 + home


STREAMS = pytest.mark.scenario(54, "Message intervals")


@STREAMS
def test_message_interval_is_asked_for_and_the_message_comes(service):
    service.order_of("interval", 33, 200000)
    assert service.done() == "Done"
    (message,) = service.heard("COMMAND_LONG")
    assert (message.command, message.param1, message.param2) == (INTERVAL, 33.0, 200000.0)
    service.run(2.1)
    assert len([one for one in service.listened if one.id == 33]) == 10
    service.order_of("interval", 33, -1)
    assert service.done() == "Done"
    assert service.heard("COMMAND_LONG")[-1].param2 == -1.0
    before = len(service.listened)
    service.run(2.0)
    assert len(service.listened) == before


@STREAMS
def test_message_that_the_autopilot_does_not_have(service):
    service.order_of("interval", 60000, 1000000)
    assert service.done() in ("CommandFailed", "CommandDenied")


FIRST_WAIT = pytest.mark.scenario(54, "A command waits for nothing that another operation has left")


@FIRST_WAIT
@pytest.mark.parametrize("operation", ["upload", "verified", "part", "download", "verify", "clear", "refused"])
@pytest.mark.parametrize("order", [("mode", 2), ("arm",), ("interval", 33, 500000), ("setcurrent", 1)])
def test_command_behind_another_operation_is_sent_at_once(service, operation, order):
    service.upload(SURVEY)
    assert service.done() == "Accepted"
    service.order_of("interval", 33, -1)  # a command before it, too
    assert service.done() == "Done"
    begun = {"upload": lambda: service.upload(SURVEY), "verified": lambda: service.upload(SURVEY, proof="Always"),
             "part": lambda: service.upload_part(SURVEY, 1, 2), "download": service.download, "verify": service.verify,
             "clear": lambda: service.order_of("clear", 0),
             "refused": lambda: service.order_of("upload", 255, 0)}  # fmt: skip
    begun[operation]()
    service.done(limit_s=15)
    before = service.now
    sent = len(service.wire.frames(">", "COMMAND_LONG"))
    service.order_of(*order)
    if operation == "clear" and order[0] == "setcurrent":
        return  # to nothing
    service.run_until_sent("COMMAND_LONG", sent + 1)
    assert service.now - before < 0.05
