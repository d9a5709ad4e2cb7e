"""Every byte that the simulated Mega sends, against pymavlink's packing; and short frames that it receives. (Every
message, byte for byte: test/host/units/outbox.cpp; every length: frame_parser.cpp.)"""

from __future__ import annotations

import struct

import pytest
from pymavlink.dialects.v10 import common as mavlink1

from plans import NO_PLACE, SURVEY, on_the_wire, sent, smooth_steps, steps, waypoint
from simulation.bench import same_bits
from simulation.fake_autopilot import item, mavlink
from simulation.fake_autopilot.items import f32, item_float_message, item_int_message
from simulation.fake_autopilot.px4_rewriting import checksum
from simulation.peer import AUTOPILOT, US, ack, find, request, request_int

# Fields that are zero at the end, in the middle and at the beginning; extensions are always zero.
PLAN = [
    waypoint(-353632621, 1491652374, 20.5, param1=7.0, param2=3.0, param4=45.0),
    item(16, x=0, y=0, z=0.0, autocontinue=0),
    item(16, x=0, y=0, z=0.0, param1=-0.0, current=1),
    item(178, frame=NO_PLACE, param1=1.0, param2=5.0, param3=-1.0),
]
CANCELLED = mavlink.MAV_MISSION_OPERATION_CANCELLED
EXACT = pytest.mark.scenario(2, "The exact bytes of every message")


def packed_by_pymavlink(messages, version: int) -> bytes:
    dialect = {1: mavlink1, 2: mavlink}[version]
    packer, stream = dialect.MAVLink(None, *US), b""
    for message in messages:
        kind = getattr(dialect, f"MAVLink_{message.get_type().lower()}_message")
        fields = {name: getattr(message, name) for name in kind.fieldnames if name != "mavlink_version"}
        if message.get_type() == "HEARTBEAT":
            fields["mavlink_version"] = 3
        stream += bytes(kind(**fields).pack(packer))
        packer.seq = (packer.seq + 1) % 256
    return stream


def as_float(one):
    return one if one.frame == NO_PLACE else one._replace(x=f32(one.x / 1e7), y=f32(one.y / 1e7))


def expected_message(heard):
    """The message that this one ought to be."""
    return {
        "HEARTBEAT": lambda: mavlink.MAVLink_heartbeat_message(
            mavlink.MAV_TYPE_ONBOARD_CONTROLLER, mavlink.MAV_AUTOPILOT_INVALID, 0, 0, mavlink.MAV_STATE_ACTIVE, 3
        ),
        "MISSION_COUNT": lambda: mavlink.MAVLink_mission_count_message(*AUTOPILOT, len(PLAN), 0, 0),
        "MISSION_ITEM_INT": lambda: item_int_message(PLAN[heard.seq], AUTOPILOT, heard.seq),
        "MISSION_ITEM": lambda: item_float_message(as_float(PLAN[heard.seq]), AUTOPILOT, heard.seq),
        "MISSION_ACK": lambda: mavlink.MAVLink_mission_ack_message(*AUTOPILOT, CANCELLED, 0, 0),
    }[heard.get_type()]()


@EXACT
@pytest.mark.parametrize("version", [1, 2])
@pytest.mark.parametrize("is_float", [False, True], ids=["as integers", "as floats, the version set by the sketch"])
def test_bytes_of_a_cancelled_upload_are_pymavlinks(line, version, is_float):
    if is_float:
        line.tell("floats", 1)
        line.tell("speak", version)
    line.upload(PLAN)
    find(line, version=3 - version if is_float else version)
    for seq in range(4):
        line.say((request if is_float else request_int)(seq), AUTOPILOT, version)
        line.run(0.03)
    line.run(1.0)
    line.cancel()
    line.run(0.1)
    heard = line.heard()
    items = [("ITEM" if is_float else "ITEM_INT", seq) for seq in range(4)]
    assert steps(line) == [("COUNT", 4), *items, ("ACK", CANCELLED)]
    assert [message.get_type() for message in heard].count("HEARTBEAT") >= 2
    data = b"".join(entry.data for entry in line.wire.entries if entry.direction == ">")
    assert data == packed_by_pymavlink(map(expected_message, heard), version)
    assert all(entry.data[0] == (0xFE if version == 1 else 0xFD) for entry in line.wire.frames(">"))


@EXACT
def test_every_bit_of_a_nan_yaw_is_kept_where_nan_is_meant(line):
    line.use([waypoint()])
    line.mega.poke(line.mega.address("benchPlan") + 12, struct.pack("<I", 0xFFC12345))
    line.upload()
    find(line)
    line.say(request_int(0), AUTOPILOT)
    line.run(0.03)
    assert line.wire.frames(">", "MISSION_ITEM_INT")[0].data[22:26] == struct.pack("<I", 0xFFC12345)


SHORT = pytest.mark.scenario(3, "Truncated MAVLink 2 frames, and whole ones with every extension")


@SHORT
@pytest.mark.parametrize("to, length", [(US, 4), ((1, 0), 3), ((0, 0), 1)], ids=["us", "our system", "everyone"])
def test_request_for_item_0_of_1_to_4_bytes_is_answered(line, to, length):
    line.upload([waypoint()])
    find(line)
    line.say(request_int(0, to), AUTOPILOT)
    assert line.wire.entries[-1].data[1] == length
    line.run(0.03)
    assert steps(line) == smooth_steps(1)


@SHORT
@pytest.mark.scenario(5, "The kind of request changes in mid-transfer")
def test_untruncated_frames_with_every_extension_are_understood(line):
    """Zero bytes that a MAVLink 2 sender need not have sent."""
    line.upload(SURVEY)
    find(line)
    opaque = 0
    for seq, one in enumerate(SURVEY):
        line.say_bytes(whole((request, request_int)[seq % 2](seq), 5))
        line.run(0.03)
        opaque = checksum(one, opaque)
    line.say_bytes(whole(ack(opaque_id=opaque), 8))
    assert line.run_until_ended(limit_s=0.1) == "Accepted"
    assert same_bits(sent(line), SURVEY) and steps(line) == smooth_steps(5)


def whole(message, length: int) -> bytes:
    """The frame of a message from the autopilot, with its trailing zeros."""
    message.pack(mavlink.MAVLink(None, *AUTOPILOT))
    body = bytes(message.get_msgbuf())[1:-2]
    body = bytes([length]) + body[1:9] + body[9:].ljust(length, b"\0")
    return b"\xfd" + body + struct.pack("<H", mavlink.x25crc(body + bytes([message.crc_extra])).crc)


@pytest.mark.scenario(4, "MISSION_REQUEST and MISSION_REQUEST_INT; float items")
def test_autopilot_that_refuses_item_int_is_served_float_items_where_the_sketch_allows(bench, personality):
    # One that is neither of the two that are known to take MISSION_ITEM_INT.
    bench.autopilot.autopilot_type = mavlink.MAV_AUTOPILOT_GENERIC_MISSION_FULL
    bench.autopilot.faults.take_only_float_items()
    bench.tell("floats", 0)
    bench.upload(SURVEY)
    assert bench.run_until_ended(limit_s=10) == "Accepted"
    assert bench.autopilot.received() == [as_float(one) for one in SURVEY]
    assert [what for what, _ in steps(bench)] == ["COUNT", "ITEM_INT", "COUNT", *["ITEM"] * 5]


@pytest.mark.scenario(5, "The kind of request changes in mid-transfer", "PX4")
def test_px4_switches_when_another_ground_station_asks_in_floats(build_bench):
    bench = build_bench("PX4")
    bench.wire.lose(">", name="MISSION_ITEM_INT", seq=2)
    bench.upload(SURVEY)
    bench.run_until_sent("MISSION_ITEM_INT", 3)
    bench.autopilot.receive(bytes(request(0, to=AUTOPILOT).pack(mavlink.MAVLink(None, 255, 190))), bench.now)
    assert bench.run_until_ended(limit_s=5) == "Accepted"
    assert bench.wire.frames("<", "MISSION_REQUEST") and bench.wire.frames("<", "MISSION_REQUEST_INT")
    assert same_bits(bench.autopilot.received(), SURVEY)


@EXACT
def test_ardupilot_of_mavlink_1_gets_its_own(build_bench):
    bench = build_bench("ArduPilot", mavlink_version=1)
    bench.upload(SURVEY)
    assert bench.run_until_ended(limit_s=5) == "Accepted"
    assert {entry.data[0] for entry in bench.wire.frames(">")} == {0xFE}
    assert same_bits(bench.autopilot.received(), on_the_wire(SURVEY, "ArduPilot"))
