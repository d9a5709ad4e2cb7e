"""start(): what each autopilot needs, in its order, and when it refuses."""

from __future__ import annotations

import pytest

from plans import OLD_PLAN, SURVEY
from simulation.fake_autopilot import mavlink
from starts import ARM, HOPS, LANDING_FIRST, MISSION_START, SET_MODE, is_flying, told, uploaded

START = pytest.mark.scenario(49, "start(): each step confirmed; refused while what is aboard is unproven")
INFEASIBLE = pytest.mark.scenario(50, "PX4 accepts a plan and then finds it infeasible", "PX4")
ARMED = pytest.mark.scenario(48, "Changing the plan while armed is refused unless allowed")


STEPS = {
    ("ArduPilot", "copter"): [(SET_MODE, 1, 4), (ARM, 1, 0), (MISSION_START, 0, 0)],
    ("ArduPilot", "rover"): [(ARM, 1, 0), (SET_MODE, 1, 10)],  # it stands in MANUAL
    ("ArduPilot", "plane"): [(ARM, 1, 0), (SET_MODE, 1, 10)],
    ("ArduPilot", "quadplane"): [(ARM, 1, 0), (SET_MODE, 1, 10)],
    ("ArduPilot", "sub"): [(ARM, 1, 0), (SET_MODE, 1, 3)],
    ("PX4", "copter"): [(MISSION_START, 0, 0)],
}
KINDS = pytest.mark.parametrize("kind", STEPS, ids=" ".join)


@START
@KINDS
def test_each_vehicle_gets_what_it_needs_in_its_order(build_service, kind):
    personality, vehicle = kind
    service = uploaded(build_service(personality, vehicle=vehicle))
    assert service.order_of("start") == "WaitingForAutopilot"
    assert service.done() == "Done"
    assert told(service) == STEPS[kind]
    assert all(one.param3 == one.param4 == one.param5 == one.param6 == one.param7 == 0
               for one in service.heard("COMMAND_LONG") if one.command != SET_MODE)  # fmt: skip
    assert [one.seq for one in service.heard("MISSION_SET_CURRENT")] == [0]
    assert is_flying(service)


@START
@KINDS
@pytest.mark.parametrize("direction, name", [(">", "COMMAND_LONG"), ("<", "COMMAND_ACK")])
def test_every_step_may_be_lost_once(build_service, kind, direction, name):
    personality, vehicle = kind
    service = uploaded(build_service(personality, vehicle=vehicle))
    for command in (SET_MODE, ARM, MISSION_START):
        service.wire.lose(direction, name=name, where=lambda message, command=command: message.command == command)
    service.order_of("start")
    assert service.done(limit_s=20) == "Done"
    assert is_flying(service)
    assert list(dict.fromkeys(told(service))) == STEPS[kind]


REFUSED = [(("ArduPilot", "copter"), 0, "ReadyMode"), (("ArduPilot", "copter"), 1, "Arm"),
           (("ArduPilot", "copter"), 2, "Begin"),
           (("ArduPilot", "rover"), 0, "Arm"), (("ArduPilot", "plane"), 0, "Arm"),
           (("ArduPilot", "plane"), 1, "AutoMode"),
           (("PX4", "copter"), 0, "Begin")]  # fmt: skip


@START
@pytest.mark.parametrize("kind, number, step", REFUSED, ids=lambda value: str(value))
def test_refused_step_is_named_and_nothing_follows_it(build_service, kind, number, step):
    personality, vehicle = kind
    station = {"hears_station": True} if personality == "PX4" else {}
    service = uploaded(build_service(personality, vehicle=vehicle, **station))
    refused = STEPS[kind][number]
    react = service.autopilot._hears["COMMAND_LONG"]

    def hear(message, sender, now) -> None:
        if (message.command, message.param1, message.param2) != refused:
            return react(message, sender, now)
        service.autopilot.answer(mavlink.MAVLink_command_ack_message(message.command, 1, 0, 0, *sender), now)
        service.autopilot.text(mavlink.MAV_SEVERITY_CRITICAL, "Not like this", now)

    service.autopilot._hears["COMMAND_LONG"] = hear
    service.order_of("start")
    assert service.done() == "CommandRejected"
    assert service.state.step == step
    is_armed_by_then = (ARM, 1, 0) in STEPS[kind][:number]
    assert told(service) == STEPS[kind][: number + 1] + [(ARM, 0, 0)] * is_armed_by_then
    assert service.state.arming == ("Disarmed" if is_armed_by_then else "Untouched")
    assert not service.autopilot.armed
    service.run(0.2)
    assert (2, "Not like this") in service.texts


@START
def test_arming_refused_after_power_on_is_said_with_the_words_and_works_later(build_service):
    service = uploaded(build_service("ArduPilot", uptime_s=0.0))
    service.order_of("start")
    assert service.done() == "CommandFailed"
    assert service.state.step == "Arm"
    service.run(0.1)
    assert (2, "Arm: AHRS: waiting for home") in service.texts
    service.run_until(31.0)
    service.order_of("start")
    assert service.done() == "Done"
    assert is_flying(service)


@START
def test_step_that_is_never_answered_ends_there(service, personality):
    uploaded(service)
    command = ARM if personality == "ArduPilot" else MISSION_START
    service.wire.lose(">", name="COMMAND_LONG", times=None, where=lambda message: message.command == command)
    service.order_of("start")
    assert service.done(limit_s=15) == "NoAnswer"
    assert service.state.step == ("Arm" if personality == "ArduPilot" else "Begin")
    assert service.state.arming == "Untouched"


@START
@pytest.mark.parametrize("after", ["refused", "silent", "cancelled", "cleared"])
def test_it_is_refused_after_what_leaves_another_plan_aboard(service, after):
    uploaded(service)
    service.autopilot.load(OLD_PLAN)
    if after == "refused":
        service.autopilot.faults.refuse(mavlink.MAV_MISSION_INVALID, 2)
        service.upload(SURVEY)
    elif after == "silent":
        service.wire.lose("<", name="MISSION_*", times=None)
        service.upload(SURVEY)
    elif after == "cancelled":
        service.upload(SURVEY)
        service.run_until_sent("MISSION_ITEM_INT", 5)
        service.tell("cancel")
    else:
        service.order_of("clear", 0)
    service.done(limit_s=30)
    service.order_of("start")
    assert service.done() == "Unproven"
    assert service.heard("COMMAND_LONG") == [] and not service.autopilot.armed


@START
def test_pause_and_resume(service):
    uploaded(service)
    service.order_of("start")
    assert service.done() == "Done"
    service.run(6.0)
    service.order_of("pause")
    assert service.done() == "Done"
    service.run(1.1)
    assert service.state.modes == ["Hold"] and not is_flying(service)
    service.order_of("resume")
    assert service.done() == "Done"
    service.run(1.1)
    assert service.state.modes == ["Auto"] and is_flying(service)


@ARMED
def test_start_while_armed_is_refused_unless_allowed(service):
    uploaded(service)
    service.autopilot.armed = True
    service.run(1.1)
    service.order_of("start")
    assert service.done() == "Armed"
    assert service.heard("COMMAND_LONG") == []
    service.tell("armed", 1)
    service.order_of("start")
    assert service.done() == "Done"
    assert ARM not in [command for command, _, _ in told(service)]


@ARMED
def test_arduino_that_resets_in_flight_changes_nothing(service, personality):
    uploaded(service)
    service.order_of("start")
    assert service.done() == "Done"
    service.run(6.0)
    plan = service.autopilot.received()
    service.mega.reset()
    service.run(0.1)
    said = len(service.mission_messages())
    for order in (("upload", 0, 0), ("clear", 0), ("clear", 255), ("uploadpart", 0, 1), ("start",)):
        service.use(HOPS[personality][:2])
        service.order_of(*order)
        assert service.done() in ("Armed", "WholePlansOnly"), order
    assert len(service.mission_messages()) == said
    assert service.autopilot.received() == plan and is_flying(service)


@ARMED
def test_uploading_while_armed_is_refused_unless_allowed(make_service):
    service = make_service(armed=True)
    service.upload(SURVEY)
    assert service.done() == "Armed"
    assert service.mission_messages() == []
    service.tell("armed", 1)
    service.upload(SURVEY)
    assert service.done() == "Accepted"


@INFEASIBLE
@pytest.mark.parametrize("in_words", [True, False], ids=["in words", "by the mission state alone"])
def test_infeasible_plan_has_its_own_status_after_accepted(build_service, in_words):
    service = build_service("PX4", infeasible_text=in_words, hears_station=in_words)
    service.upload(LANDING_FIRST)
    assert service.done() == "Accepted"
    assert service.done(limit_s=3) == "Infeasible"
    assert service.state.status == "Infeasible"
    if in_words:
        assert any(words.strip() == "Mission rejected: starts with landing" for _, words in service.texts)
    else:
        assert service.texts == []  # there is no ground station on this port
    service.run(5.0)
    assert service.ends.count("Infeasible") == 1
    service.order_of("start")
    assert service.done() == "Infeasible"
    assert service.heard("COMMAND_LONG") == []
