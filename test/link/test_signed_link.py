"""A signed link on the simulated Mega: the firmware with MAVMISSION_SIGNING against an autopilot that signs and hears
nothing unsigned; the times that it reserves in its EEPROM. (What is judged by which rule: test_signing.py. Cycles and
frames in a second: docs/measurements.md.)"""

from __future__ import annotations

from itertools import pairwise

import pytest

from plans import SURVEY, on_the_wire
from simulation import peer
from simulation.bench import FunctionPlan, same_bits
from simulation.fake_autopilot import mavlink
from simulation.fake_autopilot.frames import packed
from simulation.signing_program import KEY, MINUTE, OTHER_KEY, signer

DEFINES = {"MAVMISSION_SIGNING": 1}
SINCE_2015_S = 375_000_000.0  # the autopilot's clock at the start
NOW = round(SINCE_2015_S * 100_000)  # [10 us]


def counters(bench) -> dict[str, int]:
    """SigningCounters."""
    (line,) = bench.tell("signing")
    return {key: int(number) for key, _, number in (word.partition("=") for word in line.split(" ")[3:])}


def sent_frames(bench) -> list[bytes]:
    """What the firmware has sent; all of it is signed."""
    frames = [entry.data for entry in bench.wire.frames(">")]
    assert frames and all(frame[0] == 0xFD and frame[2] == 1 for frame in frames)
    return frames


def is_good(frame: bytes) -> bool:
    """To pymavlink, by itself."""
    try:
        return signer().decode(bytearray(frame)) is not None
    except mavlink.MAVError:
        return False


def assert_times_rise(bench, resets: int, least: int) -> None:
    """From frame to frame. A reset may have cut one frame short, which is glued to the next one then."""
    frames = sent_frames(bench)
    good = [frame for frame in frames if is_good(frame)]
    assert len(frames) - len(good) <= resets and len(good) > least
    times = [int.from_bytes(frame[-12:-6], "little") for frame in good]
    assert all(earlier < later for earlier, later in pairwise(times))


def signing(build, *arguments, **options):
    """A Bench that signs, and its autopilot as well unless that is told otherwise."""
    bench = build(*arguments, defines=DEFINES, **options)
    bench.tell("sign", 7)
    return bench


@pytest.mark.slow
@pytest.mark.parametrize("version", [1, 2])
def test_plan_comes_aboard_an_autopilot_that_hears_only_what_is_signed(make_bench, personality, version):
    """Signed frames are MAVLink 2, whatever the sketch wants to speak."""
    bench = signing(make_bench, signing_key=KEY, signing_time_s=SINCE_2015_S)
    bench.tell("speak", version)
    bench.upload(SURVEY)
    assert bench.run_until_ended(limit_s=10) == "Accepted"
    assert same_bits(bench.autopilot.received(), on_the_wire(SURVEY, personality))
    assert bench.autopilot.signing.badsig_count == 0
    seen = counters(bench)
    assert seen["accepted"] > len(SURVEY) and sum(seen.values()) == seen["accepted"]
    receiver, frames = signer(), sent_frames(bench)
    assert all(receiver.decode(bytearray(frame)) for frame in frames)
    assert receiver.signing.goodsig_count == len(frames)


def test_px4_1_18_signs_once_a_ground_station_has_given_it_the_key(build_bench):
    bench = signing(build_bench, "PX4", is_1_18=True, signing_time_s=SINCE_2015_S)
    bench.upload(SURVEY, proof="Always")
    bench.run(3.0)
    assert bench.heard("MISSION_COUNT") == []  # PX4 does not sign yet, and is not heard
    setup = mavlink.MAVLink_setup_signing_message(1, 1, list(KEY), NOW)
    bench.autopilot.receive(packed(setup, mavlink.MAVLink(None, 255, 190), 2), bench.now, elsewhere=True)  # by USB
    assert bench.run_until_ended(limit_s=10) == "Accepted"
    assert same_bits(bench.autopilot.received(), on_the_wire(SURVEY, "PX4"))


@pytest.mark.parametrize("key, why", [(OTHER_KEY, "wrong"), (None, "unsigned")], ids=["another key", "no key"])
def test_autopilot_without_the_key_is_no_autopilot(make_bench, key, why):
    bench = signing(make_bench, signing_key=key, signing_time_s=SINCE_2015_S)
    bench.tell("waiting", 3)
    bench.upload(SURVEY)
    assert bench.run_until_ended(limit_s=5) == "NoAutopilot"
    assert bench.heard() == [] and not bench.state.found
    seen = counters(bench)
    assert seen[why] >= 3 and seen["accepted"] == 0


class Line:
    """The firmware alone, its signed autopilot in the hands of the test."""

    def __init__(self, build_bench) -> None:
        self.bench = signing(build_bench, None)
        self.autopilot = signer(peer.AUTOPILOT, time=NOW)

    def say(self, message, by: mavlink.MAVLink | None = None) -> bytes:
        by = by or self.autopilot
        frame = bytes(message.pack(by))
        by.seq = (by.seq + 1) % 256
        self.bench.say_bytes(frame)
        return frame

    def upload(self) -> None:
        """As far as COUNT."""
        self.bench.upload(SURVEY)
        for _ in range(2):
            self.say(peer.heartbeat())
            self.bench.run(0.7)
        self.say(peer.heartbeat())
        self.bench.run_until_sent("MISSION_COUNT")
        self.bench.run(0.02)


@pytest.fixture
def signed_line(build_bench):
    return Line(build_bench)


def with_another_key(message) -> bytes:
    return bytes(message.pack(signer(peer.AUTOPILOT, key=OTHER_KEY, time=NOW + MINUTE)))


FORGERIES = {
    "unsigned": [lambda message: packed(message, mavlink.MAVLink(None, *peer.AUTOPILOT), 2),
                 lambda message: packed(message, mavlink.MAVLink(None, *peer.AUTOPILOT), 1)],
    "wrong": [with_another_key],
    "replayed": [lambda message: with_another_key(message)[:-13] + bytes(13),  # the flag alone: its time is 0
                 lambda message: bytes(message.pack(signer(peer.AUTOPILOT, time=NOW - 1)))],
    "old": [lambda message: bytes(message.pack(signer(peer.AUTOPILOT, link=1, time=NOW - 2 * MINUTE)))],
}  # fmt: skip


def test_forged_or_replayed_frame_moves_nothing(signed_line):
    bench = signed_line.bench
    bench.tell("time", round(NOW / 100_000) + 1420070400)  # else one who has heard nothing yet knows no old time
    for why, ways in FORGERIES.items():
        for forge in ways if why != "replayed" else ways[:1]:  # a heartbeat a little old is the first of its stream
            bench.say_bytes(forge(peer.heartbeat()))
            bench.run(0.5)
            assert not bench.state.found
    signed_line.upload()
    for why, ways in FORGERIES.items():
        before = counters(bench)[why]
        for forge in ways:
            for result in (mavlink.MAV_MISSION_ACCEPTED, mavlink.MAV_MISSION_NO_SPACE):
                bench.say_bytes(forge(peer.ack(result)))
                bench.run(0.05)
        assert counters(bench)[why] - before == 2 * len(ways) and bench.status == "Transferring"
    recorded = signed_line.say(peer.request_int(0))
    for _ in range(3):
        bench.run(0.2)
        bench.say_bytes(recorded)
    # (And once more, two round trips later, because the sequence numbers of the replayed ones look like a loss.)
    assert [message.seq for message in bench.heard("MISSION_ITEM_INT")] in ([0], [0, 0])
    signed_line.say(peer.ack(mavlink.MAV_MISSION_NO_SPACE))
    assert bench.run_until_ended(limit_s=0.1) == "NoSpace"


def test_radio_is_heard_though_it_has_no_key(signed_line):
    radio = mavlink.MAVLink_radio_status_message(100, 90, 80, 20, 19, 0, 0)
    for version in (1, 2):
        signed_line.bench.say(radio, sender=(51, 68), version=version)
        signed_line.bench.run(0.1)
    seen = counters(signed_line.bench)
    assert seen["radio"] == 2 and seen["unsigned"] == 0


def test_signature_may_look_like_frames(signed_line):
    """The bytes with which frames begin, at each place of the signature that the sender chooses."""
    signed_line.upload()
    looks = [(link, low) for link in (0xFD, 0xFE) for low in (0xFD, 0xFDFE, 0xFEFDFD, 0xFD0001FE)]
    for item, (link, low) in enumerate(looks):
        by = signer(peer.AUTOPILOT, link=link, time=NOW + MINUTE * 500 & ~0xFFFFFFFF | low)
        by.seq = item
        signed_line.say(peer.heartbeat(), by)
        signed_line.bench.run(0.05)
        by.signing.timestamp += 1 << 32
        signed_line.say(peer.request_int(item % 5), by)
        signed_line.bench.run(0.1)
    assert counters(signed_line.bench)["wrong"] == signed_line.bench.counters["bad"] == 0
    assert signed_line.bench.heard("MISSION_ITEM_INT")[0].seq == 0


def test_timestamps_rise_across_resets_in_mid_transfer(make_bench, personality):
    bench = signing(make_bench, signing_key=KEY, signing_time_s=SINCE_2015_S)
    for reset_in_s in (0.03, 0.1, 0.15, 0.2, 0.3):
        before = len(bench.heard("MISSION_COUNT"))
        bench.upload(FunctionPlan(40))
        bench.run_until_sent("MISSION_COUNT", before + 1)
        bench.run(reset_in_s)
        assert bench.state.busy
        bench.reset()
        bench.tell("sign", 7)
    bench.upload(SURVEY)
    assert bench.run_until_ended(limit_s=30) == "Accepted"
    assert same_bits(bench.autopilot.received(), on_the_wire(SURVEY, personality))
    assert_times_rise(bench, resets=5, least=30)


def test_nothing_is_signed_before_its_time_is_reserved(signed_line):
    """A reset at any moment of the first save; and the autopilot, without a clock, begins anew."""
    bench = signed_line.bench
    for ms in range(0, 40, 2):
        signed_line.autopilot.signing.timestamp = NOW
        signed_line.say(peer.heartbeat())
        bench.run(0.010 + ms / 1000)
        bench.reset()
        bench.tell("sign", 7)
    signed_line.autopilot.signing.timestamp = NOW
    signed_line.upload()
    assert_times_rise(bench, resets=20, least=3)
