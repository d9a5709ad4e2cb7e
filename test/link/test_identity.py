"""Who we are, whom we talk to, and to whom we do not listen."""

from __future__ import annotations

import pytest

from plans import OLD_PLAN, SURVEY, on_the_wire, smooth_steps, steps
from simulation.bench import FunctionPlan, same_bits
from simulation.fake_autopilot import mavlink
from simulation.fake_autopilot.items import item_int_message
from simulation.peer import AUTOPILOT, US, ack, find, heartbeat, request, request_int

ONBOARD_COMPUTER = mavlink.MAV_COMP_ID_ONBOARD_COMPUTER  # 191
ARDUPILOT, PX4, NO_AUTOPILOT = (
    mavlink.MAV_AUTOPILOT_ARDUPILOTMEGA,
    mavlink.MAV_AUTOPILOT_PX4,
    mavlink.MAV_AUTOPILOT_INVALID,
)
# A frame is put off while another is on the line: MISSION_ITEM_INT takes 8.5 ms at 57600 baud.
HEARTBEAT_JITTER_S = 0.011

HEARTBEATS = pytest.mark.scenario(38, "Heartbeats, and finding the autopilot")


def senders(bench) -> set[tuple[int, int]]:
    return {(message.get_srcSystem(), message.get_srcComponent()) for message in bench.heard()}


@HEARTBEATS
def test_heartbeat_goes_out_each_second_throughout_a_transfer(bench):
    bench.run(2.0)
    bench.upload(FunctionPlan(250))
    bench.run(18.0)
    assert bench.ends == ["Accepted"]
    times = bench.sent_at("HEARTBEAT")
    assert len(times) == 20
    for count, time in enumerate(times):
        assert time == pytest.approx(times[0] + count, abs=HEARTBEAT_JITTER_S)


@HEARTBEATS
def test_heartbeat_says_that_we_are_an_onboard_computer_and_no_autopilot(bench):
    bench.run(1.0)
    message = bench.heard("HEARTBEAT")[0]
    assert (message.type, message.autopilot) == (mavlink.MAV_TYPE_ONBOARD_CONTROLLER, NO_AUTOPILOT)
    assert (message.base_mode, message.custom_mode, message.mavlink_version) == (0, 0, 3)
    assert message.system_status == mavlink.MAV_STATE_ACTIVE


@HEARTBEATS
def test_heartbeats_go_out_before_an_autopilot_is_heard_when_the_ids_are_set(line):
    line.tell("ids", 7, 100)
    line.upload(SURVEY)
    line.run(10)
    assert [message.get_type() for message in line.heard()] == ["HEARTBEAT"] * 10
    assert senders(line) == {(7, 100)}
    times = line.sent_at("HEARTBEAT")
    for count, time in enumerate(times):
        assert time == pytest.approx(times[0] + count, abs=0.003)


@HEARTBEATS
@pytest.mark.parametrize("address", [(1, 1), (42, 1), (255, 200)])
def test_own_ids_are_those_of_a_companion_of_the_autopilot(make_bench, personality, address):
    bench = make_bench(system_id=address[0], component_id=address[1])
    bench.upload(SURVEY)
    if personality == "PX4" and address[1] not in (0, 1, 190):
        bench.autopilot.address = address
    assert bench.run_until_ended(limit_s=5) == "Accepted"
    assert senders(bench) == {(address[0], ONBOARD_COMPUTER)}
    assert {(m.target_system, m.target_component) for m in bench.mission_messages()} == {address}
    assert bench.state.address == address


@HEARTBEATS
def test_own_ids_that_are_the_autopilots_are_refused(bench):
    bench.autopilot.load(OLD_PLAN)
    bench.tell("ids", 1, 1)
    bench.upload(SURVEY)
    assert bench.run_until_ended(limit_s=5) == "SameIdsAsAutopilot"
    bench.run(3)
    assert bench.mission_messages() == []
    assert same_bits(bench.autopilot.received(), OLD_PLAN)


NO_AUTOPILOTS = {
    "ground station": ((255, 190), NO_AUTOPILOT, mavlink.MAV_TYPE_GCS),
    "gimbal": ((1, 154), NO_AUTOPILOT, mavlink.MAV_TYPE_GIMBAL),
    "gimbal with its autopilot's name": ((1, 154), ARDUPILOT, mavlink.MAV_TYPE_GIMBAL),
    "camera": ((1, 100), NO_AUTOPILOT, mavlink.MAV_TYPE_CAMERA),
    "camera with its autopilot's name": ((1, 100), PX4, mavlink.MAV_TYPE_CAMERA),
    "another companion": ((1, 192), NO_AUTOPILOT, mavlink.MAV_TYPE_ONBOARD_CONTROLLER),
    "adsb": ((1, 156), ARDUPILOT, mavlink.MAV_TYPE_ADSB),
    "antenna tracker": ((2, 1), ARDUPILOT, mavlink.MAV_TYPE_ANTENNA_TRACKER),
}


@HEARTBEATS
@pytest.mark.parametrize("who", NO_AUTOPILOTS)
def test_autopilot_is_found_among_others(bench, personality, who):
    address, autopilot, kind = NO_AUTOPILOTS[who]
    bench.upload(SURVEY)
    for _ in range(20):
        bench.say(heartbeat(autopilot, kind), address)
        bench.run(0.1)
    assert bench.ends == ["Accepted"]
    assert bench.state.address == AUTOPILOT
    assert same_bits(bench.autopilot.received(), on_the_wire(SURVEY, personality))


def second_autopilot(bench, seconds: float, address: tuple[int, int] = (2, 1)) -> None:
    """Let a second autopilot beat on the same line for a while."""
    for _ in range(round(seconds)):
        bench.say(heartbeat(PX4), address)
        bench.run(1.0)


@HEARTBEATS
@pytest.mark.parametrize("address", [(2, 1), (1, 2)], ids=["another system", "another component"])
def test_nothing_is_sent_while_two_autopilots_are_heard_and_none_is_named(bench, address):
    bench.upload(SURVEY)
    bench.run(0.3)
    bench.say(heartbeat(PX4), address)
    bench.run(0.01)
    sent = len(bench.heard())
    second_autopilot(bench, 15, address)
    assert len(bench.heard()) == sent
    state = bench.state
    assert (state.status, state.found) == ("WaitingForAutopilot", False)
    assert bench.mission_messages() == []


@HEARTBEATS
def test_plan_goes_out_by_itself_when_the_second_autopilot_has_gone(bench, personality):
    bench.upload(SURVEY)
    bench.run(0.3)
    second_autopilot(bench, 4)
    assert bench.mission_messages() == []
    assert bench.run_until_ended(limit_s=8) == "Accepted"
    assert same_bits(bench.autopilot.received(), on_the_wire(SURVEY, personality))


STRANGERS = pytest.mark.scenario(25, "Frames from strangers, or for others, are ignored")

OTHER_SENDERS = {"another system": (2, 1), "another component": (1, 2), "a ground station": (255, 190),
                 "our own ids": US}  # fmt: skip
OTHER_TARGETS = {"a ground station": (255, 190), "another component here": (1, 192), "another system": (2, 191),
                 "another system, all components": (2, 0)}  # fmt: skip


def confusing(seq: int, to: tuple[int, int]) -> list:
    """All that could move a transfer at this item."""
    return [ack(mavlink.MAV_MISSION_ERROR, to), ack(mavlink.MAV_MISSION_ACCEPTED, to), request_int(seq, to),
            request(0, to), ack(mavlink.MAV_MISSION_OPERATION_CANCELLED, to)]  # fmt: skip


@STRANGERS
@pytest.mark.parametrize("sender", OTHER_SENDERS)
def test_frames_of_another_sender_move_nothing(bench, personality, sender):
    bench.wire.lose(">", name="MISSION_COUNT")
    bench.upload(SURVEY)
    bench.run_until_sent("MISSION_COUNT")
    for message in confusing(0, US):
        bench.say(message, OTHER_SENDERS[sender])
    for count in range(1, 5):
        bench.run_until_sent("MISSION_ITEM_INT", count)
        for message in confusing(count, US):
            bench.say(message, OTHER_SENDERS[sender])
    assert bench.run_until_ended(limit_s=5) == "Accepted"
    wire_count = len(on_the_wire(SURVEY, personality))
    assert steps(bench) == [("COUNT", wire_count), *smooth_steps(wire_count)]
    assert same_bits(bench.autopilot.received(), on_the_wire(SURVEY, personality))


@STRANGERS
@pytest.mark.parametrize("target", OTHER_TARGETS)
def test_frames_for_another_target_move_nothing(bench, personality, target):
    bench.wire.lose(">", name="MISSION_COUNT")
    bench.upload(SURVEY)
    bench.run_until_sent("MISSION_COUNT")
    for message in confusing(0, OTHER_TARGETS[target]):
        bench.say(message)
    for count in range(1, 5):
        bench.run_until_sent("MISSION_ITEM_INT", count)
        for message in confusing(count, OTHER_TARGETS[target]):
            bench.say(message)
    assert bench.run_until_ended(limit_s=5) == "Accepted"
    wire_count = len(on_the_wire(SURVEY, personality))
    assert steps(bench) == [("COUNT", wire_count), *smooth_steps(wire_count)]


@STRANGERS
def test_messages_of_a_clients_side_are_not_answered(line):
    """What only another client would say: we are none of its autopilot."""
    line.upload(SURVEY)
    find(line)
    line.say(request_int(0))
    line.run(0.03)
    for message in (
        mavlink.MAVLink_mission_count_message(*US, 3),
        mavlink.MAVLink_mission_request_list_message(*US),
        mavlink.MAVLink_mission_clear_all_message(*US),
        item_int_message(SURVEY[0], US, 0),
    ):
        line.say(message)
        line.run(0.05)
    assert steps(line) == [("COUNT", 5), ("ITEM_INT", 0)]
