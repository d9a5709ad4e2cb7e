"""On a line that loses bytes the fake autopilots hear what the real ones heard, by the real ones' parsers.

A recording of such a line has what left each end and what arrived there. The bytes that arrived at the real autopilot
are fed to the fake at their times; the mission frames that the real one sent must be those that the fake sends, in
their order, with the same payloads. Telemetry, running numbers and the milliseconds of an answer are not compared.
"""

from __future__ import annotations

import pytest

from simulation import recordings
from simulation.fake_autopilot import ArduPilot, Px4, mavlink
from simulation.fake_autopilot.betaflight import Betaflight
from simulation.fake_autopilot.frames import FrameSplitter, decode, packed
from simulation.fake_autopilot.hearing import ARDUPILOT, PX4, Hearing

TELLS_OF_ITSELF = ("MISSION_CURRENT", "MISSION_ITEM_REACHED")
PAYLOAD_AT = 10  # in a MAVLink 2 frame
LONGEST_PAUSE_S = 9.0  # of an autopilot that has a transfer open
LONGEST_LAG_S = 60.0  # of the fake behind the real one, by all its milliseconds
FAKES = {
    "arducopter": lambda: ArduPilot(uptime_s=100.0),
    "betaflight": lambda: Betaflight(uptime_s=100.0),
    "px4": lambda: Px4(uptime_s=100.0, system_id=7),
}
# Its first COUNT arrived whole and was not heard: the parser was still in a frame from before.
BEGINS_BEHIND_A_BROKEN_FRAME = ("arducopter/lossy_3_percent_1",)


def frame_of(message) -> bytes:
    return packed(message, mavlink.MAVLink(None, 255, 190), 2)


LIST = frame_of(mavlink.MAVLink_mission_request_list_message(1, 1))
CLEAR = frame_of(mavlink.MAVLink_mission_clear_all_message(1, 1))


def mission_payloads(frames: list[bytes]) -> list[tuple[str, bytes]]:
    """The mission messages of these frames but for those that come by a clock, with their payloads as sent."""
    found = []
    for frame in frames:
        name = decode(frame).get_type()
        if name.startswith("MISSION_") and name not in TELLS_OF_ITSELF:
            found.append((name, frame[PAYLOAD_AT:-2]))
    return found


def sent_by_the_real_one(name: str) -> list[tuple[float, bytes]]:
    """(when its last byte left [s], frame) of all undamaged frames."""
    splitter = FrameSplitter()
    pieces = [(time, *piece) for time, data in recordings.raw(name, "<<") for piece in splitter.feed(data)]
    return [(time, piece) for time, piece, intact in pieces if intact]


def replayed(name: str) -> list[bytes]:
    """What the fake sends when it hears the bytes that the real one heard.

    Bytes that arrived behind the n-th mission frame of the real one arrive as long behind the n-th of the fake: the two
    do not ask again at the same millisecond, and after forty questions that is one more or less.
    """
    fake = FAKES[name.split("/")[0]]()
    if name in BEGINS_BEHIND_A_BROKEN_FRAME:
        fake.receive(CLEAR[:-2], 0.0)
    real = [time for time, frame in sent_by_the_real_one(name) if mission_payloads([frame])]
    sent: list[tuple[float, bytes]] = []
    now = 0.0

    def run(time: float) -> None:
        nonlocal now
        now = max(now, time)
        fake.run(now)
        sent.extend(entry for entry in fake.outbox if mission_payloads([entry[1]]))

    for time, data in recordings.raw(name, ">>"):
        said = sum(one <= time for one in real)
        while len(sent) < said and fake.next_event(now) < min(now + LONGEST_PAUSE_S, time + LONGEST_LAG_S):
            run(fake.next_event(now))
        behind = min(said, len(sent))
        run(sent[behind - 1][0] + time - real[behind - 1] if behind else time)
        fake.receive(data, now)
    run(now + recordings.raw(name, "<<")[-1][0] - recordings.raw(name, ">>")[-1][0] + 0.1)
    return [frame for _, frame in sent]


def test_there_are_lossy_recordings_of_each_autopilot():
    assert [name.split("/")[0] for name in recordings.lossy()] == [name for name in sorted(FAKES) for _ in range(2)]


@pytest.mark.parametrize("name", recordings.lossy())
def test_the_fake_answers_lost_bytes_as_the_real_autopilot_did(name):
    real = mission_payloads([frame for _, frame in sent_by_the_real_one(name)])
    assert len(real) > 5
    assert mission_payloads(replayed(name)) == real


# Betaflight asks too seldom for two frames to meet.
@pytest.mark.parametrize("name", [name for name in recordings.lossy() if not name.startswith("betaflight/")])
def test_frames_arrived_whole_that_the_real_autopilot_did_not_hear(name):
    """What makes filling with zeros worth its bytes: the parser still waits for the rest of a broken frame."""
    arrived = b"".join(data for _, data in recordings.raw(name, ">>"))
    left = b"".join(data for _, data in recordings.raw(name, ">"))
    splitter = FrameSplitter()
    whole = [frame for frame, intact in splitter.feed(left) if intact and frame in arrived]
    heard = Hearing(ARDUPILOT if name.startswith("arducopter/") else PX4).feed(arrived)
    assert len(heard) < len(whole)


@pytest.mark.parametrize("by", [ARDUPILOT, PX4])
def test_a_frame_behind_one_that_lost_two_bytes_is_not_heard_unless_zeros_come_between(by):
    broken = CLEAR[:10] + CLEAR[12:]
    assert Hearing(by).feed(broken + LIST + LIST) == [LIST]
    assert Hearing(by).feed(broken + bytes(2) + LIST + LIST) == [LIST, LIST]


def test_px4_takes_the_byte_that_ends_a_broken_frame_for_a_start_and_ardupilot_does_not():
    """One lost byte: the start of the next frame stands where the checksum's last byte should."""
    broken = CLEAR[:-1]
    assert Hearing(PX4).feed(broken + LIST) == [LIST]
    assert Hearing(ARDUPILOT).feed(broken + LIST) == []


@pytest.mark.parametrize("by", [ARDUPILOT, PX4])
def test_both_versions_of_mavlink_and_signed_frames_are_heard_as_they_were_sent(by):
    older = packed(mavlink.MAVLink_mission_count_message(1, 1, 5), mavlink.MAVLink(None, 255, 190), 1)
    signer = mavlink.MAVLink(None, 255, 190)
    signer.signing.secret_key, signer.signing.sign_outgoing = bytes(32), True
    signed = bytes(mavlink.MAVLink_mission_count_message(1, 1, 5).pack(signer))
    assert len(signed) > len(LIST) + 13
    assert Hearing(by).feed(older + signed + LIST) == [older, signed, LIST]


@pytest.mark.parametrize("by", [ARDUPILOT, PX4])
def test_two_parsers_do_not_know_of_each_other(by):
    one, other = Hearing(by), Hearing(by)
    assert one.feed(LIST[:7]) == [] and other.feed(CLEAR[:5]) == []
    assert one.feed(LIST[7:]) == [LIST] and other.feed(CLEAR[5:]) == [CLEAR]
