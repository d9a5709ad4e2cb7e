"""Everything else on the wire: frames for the sketch, and frames of the sketch's own."""

from __future__ import annotations

import random
import struct

import pytest

from plans import on_the_wire, waypoint
from simulation.bench import same_bits
from simulation.fake_autopilot import mavlink
from simulation.fake_autopilot.frames import packed

LISTEN = pytest.mark.scenario(55, "Messages that a sketch asked for, to the byte")
SEND = pytest.mark.scenario(55, "Messages of a sketch's own, to the byte")
GPS_RAW_INT, POSITION, ATTITUDE, HEARTBEAT = 24, 33, 30, 0


def gps(**more):
    """GPS_RAW_INT with its extensions, which end in bytes that are not 0."""
    values = dict(time_usec=1234567890123456789, fix_type=3, lat=-353632621, lon=1491652374, alt=584090, eph=121,
                  epv=65535, vel=7, cog=35999, satellites_visible=14, alt_ellipsoid=603210, h_acc=1, v_acc=2, vel_acc=3,
                  hdg_acc=4, yaw=9000)  # fmt: skip
    return mavlink.MAVLink_gps_raw_int_message(**{**values, **more})


def payload_of(message, version: int = 2) -> bytes:
    """All the fields as they lie on the wire, extensions too, zeros included."""
    frame = packed(message, mavlink.MAVLink(None, 1, 1), version)
    header = 6 if version == 1 else 10
    return frame[header:-2]


@LISTEN
def test_message_arrives_to_the_byte(service):
    service.run(2.0)
    message = gps()
    service.say(message)
    service.run(0.1)
    (heard,) = service.listened
    assert (heard.id, heard.sender, heard.version) == (GPS_RAW_INT, (1, 1), 2)
    assert heard.payload == payload_of(message).ljust(52, b"\0")


@LISTEN
def test_mavlink_1_message_has_no_extensions(build_service):
    service = build_service("ArduPilot", mavlink_version=1)
    service.run(2.0)
    service.say(gps(), version=1)
    service.run(0.1)
    (heard,) = service.listened
    assert heard.version == 1
    assert heard.payload == payload_of(gps(), 1).ljust(52, b"\0")


@LISTEN
def test_any_sender_is_heard_and_named(service):
    service.run(2.0)
    for sender in ((1, 1), (1, 220), (42, 7), (255, 190)):
        service.say(gps(), sender)
    service.run(0.2)
    assert [heard.sender for heard in service.listened] == [(1, 1), (1, 220), (42, 7), (255, 190)]


@LISTEN
@pytest.mark.slow
def test_each_listener_hears_what_it_asked_for(make_service):
    service = make_service(defines={"BENCH_TWO_LISTENERS": True})
    service.run(2.3)
    before = len(service.listened)
    service.say(gps())
    service.say(mavlink.MAVLink_attitude_message(5, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6))
    service.say(mavlink.MAVLink_global_position_int_message(5, 1, 2, 3, 4, 5, 6, 7, 8))
    service.run(0.2)
    assert sorted((heard.id, heard.listener) for heard in service.listened[before:] if heard.id) == [
        (GPS_RAW_INT, "A"), (GPS_RAW_INT, "B"), (ATTITUDE, "B"), (POSITION, "A")]  # fmt: skip
    assert [heard.listener for heard in service.listened[:before]] == ["B"] * before and before >= 2
    assert {heard.id for heard in service.listened[:before]} == {HEARTBEAT}


@LISTEN
def test_unknown_messages_are_counted_as_unknown_and_not_as_damage(service):
    service.run(2.0)
    before = service.counters
    for _ in range(5):
        service.say(mavlink.MAVLink_attitude_message(5, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6))
        service.run(0.05)
    after = service.counters
    assert after["unknown"] - before["unknown"] >= 5
    assert [after[key] for key in ("bad", "broken", "skipped")] == [before[key] for key in ("bad", "broken", "skipped")]
    assert service.listened == []


@LISTEN
def test_messages_keep_coming_during_a_transfer(make_service, personality):
    service = make_service(telemetry=1500.0)
    service.order_of("interval", POSITION, 100000)
    assert service.done() == "Done"
    plan = [waypoint(z=float(n)) for n in range(1, 41)]
    before = len(service.listened)
    service.upload(plan)
    assert service.done(limit_s=30) == "Accepted"
    assert same_bits(service.autopilot.received(), on_the_wire(plan, personality))
    assert len(service.listened) > before
    assert all(heard.id == POSITION for heard in service.listened)


def frame_of(version: int, sequence: int, identity: int, crc_extra: int, payload: bytes) -> bytes:
    """A frame of ours, system 1, component 191."""
    if version == 1:
        head = bytes((0xFE, len(payload), sequence, 1, 191, identity))
    else:
        payload = payload.rstrip(b"\0") or payload[:1]
        head = bytes((0xFD, len(payload), 0, 0, sequence, 1, 191)) + identity.to_bytes(3, "little")
    crc = mavlink.x25crc((head + payload)[1:] + bytes((crc_extra,))).crc
    return head + payload + crc.to_bytes(2, "little")


def sequences(service) -> list[int]:
    return [entry.data[2 if entry.data[0] == 0xFE else 4] for entry in service.wire.frames(">")]


def frames_with(service, identity: int, version: int) -> list[bytes]:
    def is_it(data: bytes) -> bool:
        return data[5] == identity if version == 1 else int.from_bytes(data[7:10], "little") == identity

    return [entry.data for entry in service.wire.frames(">") if is_it(entry.data)]


OWN, OWN_CRC_EXTRA = 180, 77  # no message of the common dialect has this id


@SEND
@pytest.mark.parametrize("version", [1, 2])
@pytest.mark.parametrize("room", [63, 5])
@pytest.mark.parametrize("lengths", [range(1, 256, 7), (1, 2, 254, 255)], ids=["many", "the ends"])
def test_message_of_any_length_leaves_to_the_byte(build_service, version, room, lengths):
    service = build_service("ArduPilot", mavlink_version=version)
    service.run(2.0)
    service.tell("room", room)
    rng = random.Random(room)
    sent = []
    for length in lengths:
        payload = rng.randbytes(length - 1) + bytes((rng.randrange(1, 256),))
        service.post(OWN, OWN_CRC_EXTRA, payload)
        service.run(0.1)
        sent.append(payload)
    frames = frames_with(service, OWN, version)
    assert len(frames) == len(sent)
    for frame, payload in zip(frames, sent, strict=True):
        sequence = frame[2] if version == 1 else frame[4]
        assert frame == frame_of(version, sequence, OWN, OWN_CRC_EXTRA, payload)
    assert sequences(service) == [number % 256 for number in range(len(sequences(service)))]
    assert service.blocked() == 0


@SEND
def test_message_id_beyond_a_byte_is_not_sent_in_mavlink_1(build_service):
    service = build_service("ArduPilot", mavlink_version=1)
    service.run(2.0)
    service.tell("post", 300, 1, 4, 4)
    service.run(2.0)
    assert service.count_told("posted") == 0
    assert {message.get_type() for message in service.heard()} == {"HEARTBEAT"}


@SEND
def test_nothing_leaves_before_an_autopilot_is_heard(make_service):
    service = make_service(heartbeat_at_s=3.0)
    service.tell("post", OWN, OWN_CRC_EXTRA, 4, 4)
    service.run(2.5)
    assert service.wire.frames(">") == []
    service.run(1.0)
    assert service.count_told("posted") == 1


@SEND
def test_own_messages_go_between_those_of_a_transfer(service, personality):
    plan = [waypoint(z=float(n)) for n in range(1, 31)]
    service.upload(plan)
    service.run_until_sent("MISSION_COUNT")
    for number in range(10):
        service.post(OWN, OWN_CRC_EXTRA, bytes((number,)) * 40)
    assert service.done(limit_s=30) == "Accepted"
    assert same_bits(service.autopilot.received(), on_the_wire(plan, personality))
    assert len(frames_with(service, OWN, 2)) == 10
    assert sequences(service) == [number % 256 for number in range(len(sequences(service)))]


@SEND
def test_message_of_a_known_kind_is_understood_by_the_autopilot(service):
    """REQUEST_DATA_STREAM, made by hand as a sketch would."""
    service.run(2.0)
    service.post(66, 148, struct.pack("<HBBBB", 4, 1, 1, 6, 1))
    service.run(0.2)
    (message,) = service.heard("REQUEST_DATA_STREAM")
    assert (message.req_message_rate, message.req_stream_id, message.start_stop) == (4, 6, 1)
