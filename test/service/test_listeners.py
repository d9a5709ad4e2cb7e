"""Frames for the sketch, and frames of the sketch's own, to the byte, beside an upload."""

from __future__ import annotations

import random

import pytest

from plans import on_the_wire, waypoint
from simulation.bench import same_bits
from simulation.fake_autopilot import mavlink
from simulation.fake_autopilot.frames import packed

OWN = pytest.mark.scenario(55, "Messages that a sketch asked for, and its own, to the byte")
GPS_RAW_INT = 24
# With its extensions, which end in bytes that are not 0.
GPS = mavlink.MAVLink_gps_raw_int_message(
    2**60 + 1, 3, -353632621, 1491652374, 584090, 121, 65535, 7, 35999, 14, 603210, 1, 2, 3, 4, 9000)  # fmt: skip


def frame_of(version: int, sequence: int, identity: int, crc_extra: int, payload: bytes) -> bytes:
    """A frame of ours, system 1, component 191."""
    if version == 1:
        head = bytes((0xFE, len(payload), sequence, 1, 191, identity))
    else:
        head = bytes((0xFD, len(payload), 0, 0, sequence, 1, 191)) + identity.to_bytes(3, "little")
    return head + payload + mavlink.x25crc((head + payload)[1:] + bytes((crc_extra,))).crc.to_bytes(2, "little")


@OWN
@pytest.mark.parametrize("version", [1, 2])
def test_message_arrives_to_the_byte_and_its_sender_is_named(build_service, version):
    service = build_service("ArduPilot", mavlink_version=version)
    service.run(2.0)
    senders = [(1, 1), (1, 220), (42, 7), (255, 190)]
    for sender in senders:
        service.say(GPS, sender, version)
    service.run(0.2)
    whole = packed(GPS, mavlink.MAVLink(None, 1, 1), version)[6 if version == 1 else 10 : -2].ljust(52, b"\0")
    heard = [(one.id, one.sender, one.version, one.payload) for one in service.listened]
    assert heard == [(GPS_RAW_INT, sender, version, whole) for sender in senders]


@OWN
@pytest.mark.parametrize("version", [1, 2])
@pytest.mark.parametrize("room", [63, 5])
def test_message_of_any_length_leaves_to_the_byte_between_those_of_an_upload(build_service, version, room):
    service = build_service("ArduPilot", mavlink_version=version)
    service.run(2.0)
    service.tell("room", room)
    plan = [waypoint(z=float(n)) for n in range(1, 31)]
    service.upload(plan)
    service.run_until_sent("MISSION_COUNT")
    rng = random.Random(room)
    sent = [rng.randbytes(length - 1) + b"\1" for length in (1, 2, 3, 30, 63, 64, 128, 253, 254, 255)]
    for payload in sent:
        service.post(180, 77, payload)  # no message of the common dialect has this id
        service.run(0.06)  # the payload must stay until it has left
        service.say(GPS, version=version)
    assert service.done(limit_s=60) == "Accepted"
    assert same_bits(service.autopilot.received(), on_the_wire(plan, "ArduPilot"))
    left = [entry.data for entry in service.wire.frames(">")]
    sequence_at, id_at = (2, 5) if version == 1 else (4, 7)
    assert [data[sequence_at] for data in left] == [number % 256 for number in range(len(left))]
    own = [data for data in left if data[id_at] == 180]
    wanted = [frame_of(version, data[sequence_at], 180, 77, payload) for data, payload in zip(own, sent, strict=True)]
    assert own == wanted
    assert [one.id for one in service.listened] == [GPS_RAW_INT] * len(sent)  # what comes is heard meanwhile
    assert service.blocked() == 0
