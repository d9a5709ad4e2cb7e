"""Every byte that is sent, against pymavlink's packing; and every short frame that is received."""

from __future__ import annotations

import struct

import pytest
from pymavlink.dialects.v10 import common as mavlink1

from plans import HOME, NO_PLACE, OLD_PLAN, SURVEY, on_the_wire, sent, smooth_steps, steps, waypoint
from simulation.bench import same_bits
from simulation.fake_autopilot import Item, item, mavlink
from simulation.fake_autopilot.items import f32, item_float_message, item_int_message
from simulation.fake_autopilot.px4_rewriting import checksum
from simulation.peer import AUTOPILOT, US, ack, find, request, request_int

# Fields that are zero at the end, in the middle and at the beginning; extensions are always zero.
PLAN = [
    waypoint(-353632621, 1491652374, 20.5, param1=7.0, param2=3.0, param3=5.0, param4=45.0),
    item(16, x=0, y=0, z=0.0, autocontinue=0),
    item(16, x=0, y=0, z=0.0, param1=-0.0, current=1),
    item(178, frame=NO_PLACE, param1=1.0, param2=5.0, param3=-1.0),
]


def our_heartbeat():
    return mavlink.MAVLink_heartbeat_message(
        mavlink.MAV_TYPE_ONBOARD_CONTROLLER, mavlink.MAV_AUTOPILOT_INVALID, 0, 0, mavlink.MAV_STATE_ACTIVE, 3
    )


def all_bytes(line) -> bytes:
    return b"".join(entry.data for entry in line.wire.entries if entry.direction == ">")


def packed_by_pymavlink(messages, version: int, sender: tuple[int, int] = US) -> bytes:
    dialect = {1: mavlink1, 2: mavlink}[version]
    packer = dialect.MAVLink(None, *sender)
    stream = b""
    for message in messages:
        kind = getattr(dialect, f"MAVLink_{message.get_type().lower()}_message")
        fields = {name: getattr(message, name) for name in kind.fieldnames if name != "mavlink_version"}
        if message.get_type() == "HEARTBEAT":
            fields["mavlink_version"] = 3
        stream += bytes(kind(**fields).pack(packer))
        packer.seq = (packer.seq + 1) % 256
    return stream


EXACT = pytest.mark.scenario(2, "The exact bytes of every message")


def expected_message(heard, plan: list[Item]):
    """The message that this one ought to be."""
    return {
        "HEARTBEAT": our_heartbeat,
        "MISSION_COUNT": lambda: mavlink.MAVLink_mission_count_message(*AUTOPILOT, len(plan), 0, 0),
        "MISSION_ITEM_INT": lambda: item_int_message(plan[heard.seq], AUTOPILOT, heard.seq),
        "MISSION_ACK": lambda: mavlink.MAVLink_mission_ack_message(
            *AUTOPILOT, mavlink.MAV_MISSION_OPERATION_CANCELLED, 0, 0
        ),
    }[heard.get_type()]()


@EXACT
@pytest.mark.parametrize("version", [1, 2])
@pytest.mark.parametrize("chosen", ["by the sketch", "as the autopilot does"])
def test_bytes_of_count_items_cancellation_and_heartbeats_are_pymavlinks(line, version, chosen):
    if chosen == "by the sketch":
        line.tell("speak", version)
    line.upload(PLAN)
    find(line, version=version if chosen != "by the sketch" else 3 - version)
    for seq in range(4):
        line.say(request_int(seq), AUTOPILOT, version)
        line.run(0.03)
    line.run(1.0)
    line.cancel()
    line.run(0.1)
    heard = line.heard()
    assert steps(line) == [*smooth_steps(4), ("ACK", mavlink.MAV_MISSION_OPERATION_CANCELLED)]
    assert [message.get_type() for message in heard].count("HEARTBEAT") >= 2
    expected = packed_by_pymavlink([expected_message(message, PLAN) for message in heard], version)
    assert all_bytes(line) == expected
    assert all(entry.data[0] == (0xFE if version == 1 else 0xFD) for entry in line.wire.frames(">"))


@EXACT
def test_trailing_zeros_of_a_mavlink_2_payload_are_left_out(line):
    line.upload(PLAN)
    find(line)
    for seq in range(4):
        line.say(request_int(seq), AUTOPILOT)
        line.run(0.03)
    lengths = {(entry.message.get_type(), getattr(entry.message, "seq", None)): entry.data[1]
               for entry in line.wire.frames(">")}  # fmt: skip
    assert lengths["MISSION_COUNT", None] == 4  # mission_type and opaque_id are zero
    assert lengths["MISSION_ITEM_INT", 0] == 37  # autocontinue 1, mission_type 0
    assert lengths["MISSION_ITEM_INT", 1] == 35  # current 0 and autocontinue 0 too
    assert lengths["HEARTBEAT", None] == 9


@EXACT
@pytest.mark.parametrize("version", [1, 2])
def test_bytes_of_float_items_are_pymavlinks(line, version):
    line.tell("floats", 1)
    line.upload(PLAN)
    find(line, version=version)
    for seq in range(4):
        line.say(request(seq), AUTOPILOT, version)
        line.run(0.03)
    expected = []
    for message in line.heard():
        if message.get_type() == "MISSION_ITEM":
            one = PLAN[message.seq]
            if one.frame != NO_PLACE:
                one = one._replace(x=f32(one.x / 1e7), y=f32(one.y / 1e7))
            expected.append(item_float_message(one, AUTOPILOT, message.seq))
        else:
            expected.append(expected_message(message, PLAN))
    assert steps(line) == [("COUNT", 4), *(("ITEM", seq) for seq in range(4))]
    assert all_bytes(line) == packed_by_pymavlink(expected, version)


@EXACT
def test_every_bit_of_a_nan_yaw_is_kept_where_nan_is_meant(line):
    line.use([waypoint()])
    line.mega.poke(line.mega.address("benchPlan") + 12, struct.pack("<I", 0xFFC12345))
    line.upload()
    find(line)
    line.say(request_int(0), AUTOPILOT)
    line.run(0.03)
    payload = line.wire.frames(">", "MISSION_ITEM_INT")[0].data[10:]
    assert payload[12:16] == struct.pack("<I", 0xFFC12345)


SHORT = pytest.mark.scenario(3, "Truncated MAVLink 2 frames")


@SHORT
@pytest.mark.parametrize(
    ("to", "length"), [(US, 4), ((1, 0), 3), ((0, 0), 1)], ids=["to us", "to our system", "to everyone"]
)
@pytest.mark.parametrize("kind", [request, request_int], ids=["REQUEST", "REQUEST_INT"])
def test_request_for_item_0_of_1_to_4_bytes_is_answered(line, kind, to, length):
    line.upload([waypoint()])
    find(line)
    line.say(kind(0, to), AUTOPILOT)
    assert line.wire.entries[-1].data[1] == length
    line.run(0.03)
    assert steps(line) == smooth_steps(1)


@SHORT
def test_untruncated_frames_with_every_extension_are_understood(line):
    """Zero bytes that a MAVLink 2 sender need not have sent."""
    line.upload(SURVEY)
    find(line)
    for seq in range(5):
        line.say_bytes(whole(request_int(seq)))
        line.run(0.03)
    opaque = 0
    for one in SURVEY:
        opaque = checksum(one, opaque)
    line.say_bytes(whole(ack(opaque_id=opaque)))
    assert line.run_until_ended(limit_s=0.1) == "Accepted"
    assert same_bits(sent(line), SURVEY)


def whole(message) -> bytes:
    """The frame of a message from the autopilot, with its trailing zeros."""
    packer = mavlink.MAVLink(None, *AUTOPILOT)
    message.pack(packer)
    length = {"MISSION_REQUEST_INT": 5, "MISSION_ACK": 8}[message.get_type()]
    body = bytes(message.get_msgbuf())[1:-2]
    payload = body[9:].ljust(length, b"\0")
    body = bytes([length]) + body[1:9] + payload
    crc = mavlink.x25crc(body + bytes([message.crc_extra])).crc
    return b"\xfd" + body + struct.pack("<H", crc)


BOTH_KINDS = pytest.mark.scenario(4, "MISSION_REQUEST and MISSION_REQUEST_INT; float items")


@BOTH_KINDS
def test_autopilot_that_refuses_item_int_is_served_float_items_where_the_sketch_allows(make_bench, personality):
    bench = make_bench()
    # One that is neither of the two that are known to take MISSION_ITEM_INT.
    bench.autopilot.autopilot_type = mavlink.MAV_AUTOPILOT_GENERIC_MISSION_FULL
    bench.autopilot.faults.take_only_float_items()
    bench.tell("floats", 0)
    plan = [OLD_PLAN[0], *SURVEY]
    bench.upload(plan)
    assert bench.run_until_ended(limit_s=10) == "Accepted"
    as_floats = [one._replace(x=f32(one.x / 1e7), y=f32(one.y / 1e7)) for one in plan]
    assert [one[:8] + one[8:] for one in bench.autopilot.received()] == as_floats
    assert [what for what, _ in steps(bench)] == ["COUNT", "ITEM_INT", "COUNT", *["ITEM"] * 6]
    assert bench.ends == ["Accepted"]


@BOTH_KINDS
def test_autopilot_that_refuses_item_int_is_unsupported_where_the_sketch_does_not_allow_floats(make_bench):
    bench = make_bench()
    bench.autopilot.autopilot_type = mavlink.MAV_AUTOPILOT_GENERIC_MISSION_FULL
    bench.autopilot.faults.take_only_float_items()
    bench.upload(SURVEY)
    assert bench.run_until_ended(limit_s=10) == "Unsupported"
    assert bench.state.failed_item == 0


@BOTH_KINDS
def test_float_items_from_the_first_on_are_taken_by_both_autopilots(bench, personality):
    bench.tell("floats", 1)
    bench.upload(SURVEY)
    assert bench.run_until_ended(limit_s=10) == "Accepted"
    expected = [one._replace(x=f32(one.x / 1e7), y=f32(one.y / 1e7)) for one in on_the_wire(SURVEY, personality)]
    assert bench.autopilot.received() == expected


SWITCHES = 5, "The kind of request changes in mid-transfer"
SWITCH = pytest.mark.scenario(*SWITCHES)


@SWITCH
def test_requests_of_both_kinds_in_turn_are_answered_alike(line):
    line.upload(SURVEY)
    find(line)
    for seq in range(5):
        line.say((request, request_int)[seq % 2](seq), AUTOPILOT)
        line.run(0.03)
    line.say(ack(), AUTOPILOT)
    assert line.run_until_ended(limit_s=0.1) == "Accepted"
    assert steps(line) == smooth_steps(5)


@pytest.mark.scenario(*SWITCHES, "PX4")
def test_px4_switches_when_another_ground_station_asks_in_floats(build_bench):
    bench = build_bench("PX4")
    bench.wire.lose(">", name="MISSION_ITEM_INT", seq=2)
    bench.upload(SURVEY)
    bench.run_until_sent("MISSION_ITEM_INT", 3)
    other = mavlink.MAVLink(None, 255, 190)
    bench.autopilot.receive(bytes(request(0, to=AUTOPILOT).pack(other)), bench.now)
    assert bench.run_until_ended(limit_s=5) == "Accepted"
    assert bench.wire.frames("<", "MISSION_REQUEST") and bench.wire.frames("<", "MISSION_REQUEST_INT")
    assert same_bits(bench.autopilot.received(), SURVEY)


TYPES = pytest.mark.scenario(7, "A frame of another mission type moves nothing")


@TYPES
@pytest.mark.parametrize("mission_type", [mavlink.MAV_MISSION_TYPE_FENCE, mavlink.MAV_MISSION_TYPE_RALLY, 255])
def test_frames_of_another_mission_type_move_nothing(bench, personality, mission_type):
    bench.upload(SURVEY)
    for sent_items in range(1, 5):
        bench.run_until_sent("MISSION_ITEM_INT", sent_items)
        for message in (
            ack(mavlink.MAV_MISSION_ERROR, mission_type=mission_type),
            ack(mavlink.MAV_MISSION_ACCEPTED, mission_type=mission_type),
            request_int(sent_items, mission_type=mission_type),
            request(0, mission_type=mission_type),
        ):
            bench.say(message)
    assert bench.run_until_ended(limit_s=5) == "Accepted"
    assert steps(bench) == smooth_steps(len(on_the_wire(SURVEY, personality)))
    assert same_bits(bench.autopilot.received(), on_the_wire(SURVEY, personality))


@pytest.mark.scenario(2, "The exact bytes of every message")
@pytest.mark.parametrize("version", [1, 2])
def test_autopilot_of_either_mavlink_version_gets_its_own(build_bench, version):
    bench = build_bench("ArduPilot", mavlink_version=version)
    bench.upload(SURVEY)
    assert bench.run_until_ended(limit_s=5) == "Accepted"
    assert {entry.data[0] for entry in bench.wire.frames(">")} == {0xFE if version == 1 else 0xFD}
    assert same_bits(bench.autopilot.received(), [HOME, *SURVEY])
