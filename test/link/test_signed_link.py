"""A signed link: the firmware with MAVMISSION_SIGNING against an autopilot that signs and hears nothing unsigned."""

from __future__ import annotations

import functools
import random
from itertools import pairwise

import pytest

from plans import SURVEY, on_the_wire
from simulation import peer
from simulation.bench import FunctionPlan, same_bits
from simulation.fake_autopilot import mavlink
from simulation.fake_autopilot.frames import packed
from simulation.signing_program import KEY, MINUTE, OTHER_KEY, signer

DEFINES = {"MAVMISSION_SIGNING": 1}
LINK = 7
SINCE_2015_S = 375_000_000.0  # the autopilot's clock at the start
NOW = round(SINCE_2015_S * 100_000)  # [10 us]
RADIO = mavlink.MAVLink_radio_status_message(100, 90, 80, 20, 19, 0, 0)


def counters(bench) -> dict[str, int]:
    """SigningCounters."""
    (line,) = bench.tell("signing")
    return {key: int(number) for key, _, number in (word.partition("=") for word in line.split(" ")[3:])}


def sent_frames(bench) -> list[bytes]:
    """What the firmware has sent; all of it is signed."""
    frames = [entry.data for entry in bench.wire.frames(">")]
    assert frames and all(frame[0] == 0xFD and frame[2] == 1 for frame in frames)
    return frames


def signature(frame: bytes) -> tuple[int, int]:
    """(link id, timestamp)"""
    return frame[-13], int.from_bytes(frame[-12:-6], "little")


def verified(frames: list[bytes]) -> list[bytes]:
    """Those that pymavlink accepts, each by itself."""
    good = []
    for frame in frames:
        try:
            signer().decode(bytearray(frame))
        except mavlink.MAVError:
            continue
        good.append(frame)
    return good


def assert_all_verify(bench) -> None:
    """pymavlink, which has the key, accepts all that the firmware has sent, in its order."""
    receiver = signer()
    frames = sent_frames(bench)
    for frame in frames:
        receiver.decode(bytearray(frame))
    assert receiver.signing.goodsig_count == len(frames)


def assert_times_rise(bench, resets: int) -> list[int]:
    """From frame to frame. A reset may have cut one frame short, which is glued to the next one then."""
    frames = sent_frames(bench)
    good = verified(frames)
    assert len(frames) - len(good) <= resets
    times = [time for _, time in map(signature, good)]
    assert all(earlier < later for earlier, later in pairwise(times))
    return times


def signing(make, *arguments, **options):
    """A Bench whose both ends sign."""
    bench = make(*arguments, **{"defines": DEFINES, "signing_key": KEY, "signing_time_s": SINCE_2015_S, **options})
    bench.tell("sign", LINK)
    return bench


@pytest.fixture
def make_signed(make_bench):
    return functools.partial(signing, make_bench)


@pytest.fixture
def signed(make_signed):
    return make_signed()


class Line:
    """The firmware alone, its signed autopilot in the hands of the test."""

    def __init__(self, build_bench) -> None:
        self.bench = build_bench(None, defines=DEFINES)
        self.bench.tell("sign", LINK)
        self.autopilot = signer(peer.AUTOPILOT, time=NOW)

    def frame(self, message, by: mavlink.MAVLink | None = None) -> bytes:
        by = by or self.autopilot
        frame = bytes(message.pack(by))
        by.seq = (by.seq + 1) % 256
        return frame

    def say(self, message, by: mavlink.MAVLink | None = None) -> bytes:
        frame = self.frame(message, by)
        self.bench.say_bytes(frame)
        return frame

    def upload(self, plan=SURVEY) -> None:
        """As far as COUNT."""
        self.bench.upload(plan)
        for _ in range(2):
            self.say(peer.heartbeat())
            self.bench.run(0.7)
        self.say(peer.heartbeat())
        self.bench.run_until_sent("MISSION_COUNT")
        self.bench.run(0.02)

    def items(self) -> list[int]:
        """Of the items sent so far."""
        return [message.seq for message in self.bench.heard("MISSION_ITEM_INT")]


@pytest.fixture
def signed_line(build_bench):
    return Line(build_bench)


# What is right


def test_plan_comes_aboard_an_autopilot_that_hears_only_what_is_signed(signed, personality):
    signed.upload(SURVEY)
    assert signed.run_until_ended(limit_s=10) == "Accepted"
    assert same_bits(signed.autopilot.received(), on_the_wire(SURVEY, personality))
    assert signed.autopilot.signing.badsig_count == 0
    seen = counters(signed)
    assert seen["accepted"] > len(SURVEY) and sum(seen.values()) == seen["accepted"]
    assert_all_verify(signed)


def test_px4_1_18_signs_once_a_ground_station_has_given_it_the_key(build_bench):
    bench = build_bench("PX4", is_1_18=True, defines=DEFINES, signing_time_s=SINCE_2015_S)
    bench.tell("sign", LINK)
    bench.upload(SURVEY, proof="Always")
    bench.run(3.0)
    assert bench.heard("MISSION_COUNT") == []  # PX4 does not sign yet, and is not heard
    by_usb = mavlink.MAVLink(None, 255, 190)
    bench.autopilot.receive(packed(mavlink.MAVLink_setup_signing_message(1, 1, list(KEY), NOW), by_usb, 2), bench.now,
                            elsewhere=True)  # fmt: skip
    assert bench.run_until_ended(limit_s=10) == "Accepted"
    assert same_bits(bench.autopilot.received(), on_the_wire(SURVEY, "PX4"))
    assert_all_verify(bench)


@pytest.mark.parametrize("is_signed", [False, True], ids=["a sketch that does not sign", "a sketch that signs"])
def test_ardupilot_4_7_does_not_sign_on_a_port_that_is_set_so(build_bench, is_signed):
    """Bit 0 of MAVn_OPTIONS: whoever signs there waits for ever, and who does not sign is heard."""
    bench = build_bench("ArduPilot", port_signs=False, defines=DEFINES, signing_time_s=SINCE_2015_S)
    by_usb = mavlink.MAVLink(None, 255, 190)
    bench.autopilot.receive(packed(mavlink.MAVLink_setup_signing_message(1, 1, list(KEY), NOW), by_usb, 2), bench.now,
                            elsewhere=True)  # fmt: skip
    if is_signed:
        bench.tell("sign", LINK)
        bench.tell("waiting", 3)
    bench.upload(SURVEY)
    assert bench.run_until_ended(limit_s=10) == ("NoAutopilot" if is_signed else "Accepted")
    assert (bench.heard("MISSION_COUNT") == []) == is_signed
    assert (counters(bench)["unsigned"] > 0) == is_signed


def test_autopilot_hears_nothing_from_a_sketch_that_does_not_sign(make_bench):
    bench = make_bench(signing_key=KEY, signing_time_s=SINCE_2015_S)
    bench.upload(SURVEY)
    assert bench.run_until_ended(limit_s=10) == "NoAnswer"
    assert bench.autopilot.received() == []


@pytest.mark.parametrize("key", [OTHER_KEY, None], ids=["another key", "no key"])
def test_autopilot_without_the_key_is_no_autopilot(make_signed, key):
    bench = make_signed(signing_key=key)
    bench.tell("waiting", 3)
    bench.upload(SURVEY)
    assert bench.run_until_ended(limit_s=5) == "NoAutopilot"
    assert bench.heard() == [] and not bench.state.found
    seen = counters(bench)
    assert seen["wrong" if key else "unsigned"] >= 3 and seen["accepted"] == 0


def test_mavlink_1_is_not_spoken_where_all_is_signed(signed):
    signed.tell("speak", 1)
    signed.upload(SURVEY)
    assert signed.run_until_ended(limit_s=10) == "Accepted"
    assert_all_verify(signed)


# What is not


def unsigned(line: Line, message) -> bytes:
    return bytes(message.pack(mavlink.MAVLink(None, *peer.AUTOPILOT)))


def unsigned_v1(line: Line, message) -> bytes:
    return packed(message, mavlink.MAVLink(None, *peer.AUTOPILOT), 1)


def with_another_key(line: Line, message) -> bytes:
    return bytes(message.pack(signer(peer.AUTOPILOT, key=OTHER_KEY, time=NOW + MINUTE)))


def with_the_flag_alone(line: Line, message) -> bytes:
    return with_another_key(line, message)[:-13] + bytes(13)


def with_an_old_time(line: Line, message) -> bytes:
    return bytes(message.pack(signer(peer.AUTOPILOT, time=NOW - 1)))


def of_an_old_stream(line: Line, message) -> bytes:
    return bytes(message.pack(signer(peer.AUTOPILOT, link=1, time=NOW - 2 * MINUTE)))


FORGERIES = {
    unsigned: "unsigned",
    unsigned_v1: "unsigned",
    with_another_key: "wrong",
    with_the_flag_alone: "replayed",  # its time is 0
    with_an_old_time: "replayed",
    of_an_old_stream: "old",
}


@pytest.mark.parametrize("forge", FORGERIES, ids=lambda forge: forge.__name__)
def test_forged_answer_does_not_end_an_upload(signed_line, forge):
    signed_line.upload()
    for result in (mavlink.MAV_MISSION_ACCEPTED, mavlink.MAV_MISSION_DENIED, mavlink.MAV_MISSION_NO_SPACE):
        signed_line.bench.say_bytes(forge(signed_line, peer.ack(result)))
        signed_line.bench.run(0.1)
    seen = counters(signed_line.bench)
    assert seen[FORGERIES[forge]] == 3 and seen["accepted"] == 3
    assert signed_line.bench.status == "Transferring"
    signed_line.say(peer.ack(mavlink.MAV_MISSION_NO_SPACE))
    assert signed_line.bench.run_until_ended(limit_s=0.1) == "NoSpace"


@pytest.mark.parametrize("forge", FORGERIES, ids=lambda forge: forge.__name__)
def test_forged_heartbeat_is_no_autopilot_and_hides_none(signed_line, forge):
    bench = signed_line.bench
    bench.tell("time", round(NOW / 100_000) + 1420070400)  # else one who has heard nothing yet knows no old time
    for _ in range(3):
        bench.say_bytes(forge(signed_line, peer.heartbeat()))
        bench.run(0.5)
    assert not bench.state.found or forge is with_an_old_time  # not old, to one who has heard nothing yet
    signed_line.upload()
    assert bench.state.found


def test_request_that_is_replayed_draws_its_item_once(signed_line):
    signed_line.upload()
    recorded = signed_line.say(peer.request_int(0))
    signed_line.bench.run(0.2)
    for _ in range(3):
        signed_line.bench.say_bytes(recorded)
        signed_line.bench.run(0.2)
    # (And once more, two round trips later, because the sequence numbers of the replayed ones look like a loss.)
    assert signed_line.items() in ([0], [0, 0])
    assert counters(signed_line.bench)["replayed"] == 3


def test_frame_with_any_single_bit_changed_draws_nothing(signed_line):
    signed_line.upload()
    bench = signed_line.bench
    for bit in range(8 * len(signed_line.frame(peer.request_int(0)))):
        damaged = bytearray(signed_line.frame(peer.request_int(0)))
        damaged[bit // 8] ^= 1 << bit % 8
        bench.say_bytes(bytes(damaged))
        bench.run(0.03)
        if bit % 32 == 0:
            signed_line.say(peer.heartbeat())
            bench.run(0.03)
    assert signed_line.items() == []
    assert counters(bench)["wrong"] > 8 * 6  # the signature's own bits at the least
    bench.run(0.05)
    signed_line.say(peer.request_int(0))
    bench.run(0.1)
    assert signed_line.items() == [0]


def test_radio_is_heard_though_it_has_no_key(signed_line):
    signed_line.bench.say(RADIO, sender=(51, 68))
    signed_line.bench.run(0.1)
    signed_line.bench.say(RADIO, sender=(51, 68), version=1)
    signed_line.bench.run(0.1)
    seen = counters(signed_line.bench)
    assert seen["radio"] == 2 and seen["unsigned"] == 0


def test_signature_may_look_like_frames(signed_line):
    """The bytes with which frames begin, at each place of the signature that the sender chooses."""
    signed_line.upload()
    for item, (link, low) in enumerate(
        (link, low) for link in (0xFD, 0xFE) for low in (0xFD, 0xFDFE, 0xFEFDFD, 0xFD0001FE)
    ):
        by = signer(peer.AUTOPILOT, link=link, time=NOW + MINUTE * 500 & ~0xFFFFFFFF | low)
        by.seq = item
        signed_line.say(peer.heartbeat(), by)
        signed_line.bench.run(0.05)
        by.signing.timestamp += 1 << 32
        signed_line.say(peer.request_int(item % 5), by)
        signed_line.bench.run(0.1)
    assert counters(signed_line.bench)["wrong"] == 0
    assert signed_line.items()[0] == 0 and signed_line.bench.counters["bad"] == 0


# Time


def test_timestamps_rise_across_resets_in_mid_transfer(signed, personality):
    for reset_in_s in (0.03, 0.1, 0.15, 0.2, 0.3):
        before = len(signed.heard("MISSION_COUNT"))
        signed.upload(FunctionPlan(40))
        signed.run_until_sent("MISSION_COUNT", before + 1)
        signed.run(reset_in_s)
        assert signed.state.busy
        signed.reset()
        signed.tell("sign", LINK)
    signed.upload(SURVEY)
    assert signed.run_until_ended(limit_s=30) == "Accepted"
    assert same_bits(signed.autopilot.received(), on_the_wire(SURVEY, personality))
    assert len(assert_times_rise(signed, resets=5)) > 30


def test_timestamps_rise_though_the_autopilot_forgets_the_time(signed_line):
    """The store alone must see to it: an autopilot without a clock begins anew, or a forger holds its frames back."""
    bench, latest = signed_line.bench, NOW
    resets = random.Random(3)
    for _ in range(20):
        signed_line.autopilot.signing.timestamp = latest - MINUTE // 2
        for _ in range(2):
            signed_line.say(peer.heartbeat())
            bench.run(resets.uniform(0.005, 0.6))
        bench.reset()
        bench.tell("sign", LINK)
        latest = max(latest, signature(bench.wire.frames(">")[-1].data)[1]) if bench.heard() else latest
    assert len(assert_times_rise(bench, resets=20)) > 10


def test_nothing_is_signed_before_its_time_is_reserved(signed_line):
    """A reset at any moment of the first save: what comes after is later all the same."""
    bench = signed_line.bench
    for ms in range(0, 40, 2):
        signed_line.say(peer.heartbeat())
        bench.run(0.010 + ms / 1000)
        bench.reset()
        bench.tell("sign", LINK)
    signed_line.upload()
    assert len(assert_times_rise(bench, resets=20)) > 3


def test_sketch_with_a_clock_is_ahead_of_an_autopilot_without(make_signed):
    bench = make_signed(signing_time_s=1.0)
    bench.tell("time", 1420070400 + 30)
    bench.upload(SURVEY)
    assert bench.run_until_ended(limit_s=10) == "Accepted"
    assert signature(sent_frames(bench)[0])[1] > 30 * 100_000
    assert bench.autopilot.signing.timestamp > 30 * 100_000


def test_erased_eeprom_holds_no_time(signed_line):
    signed_line.autopilot.signing.timestamp = 1000
    signed_line.upload()
    assert signature(sent_frames(signed_line.bench)[0])[1] < 2000


# Cost


def longest_update(bench) -> int:
    """In uploads on a full line [cycles], as the sketch waits for it; each begins at another phase of the telemetry."""
    bench.tell("callbacks", 0)  # which print
    watch = bench.mega.watch("updateClient")
    for _ in range(6):
        bench.upload(FunctionPlan(10))
        assert bench.run_until_ended(limit_s=10) == "Accepted"
        bench.run(0.0137)
    return watch.calls.longest


def test_longest_update_is_hardly_longer_for_the_hashing(build_bench):
    both = ("ArduPilot", "PX4")
    unsigned = max(longest_update(build_bench(autopilot, telemetry=5000.0)) for autopilot in both)
    signed = max(longest_update(signing(build_bench, autopilot, telemetry=5000.0)) for autopilot in both)
    assert signed < 1.05 * unsigned


def test_hashing_is_cut_into_pieces_of_10000_cycles(make_signed):
    bench = make_signed()
    watch = bench.mega.watch("mavmission::detail::Sha256::work")
    bench.upload(FunctionPlan(3))
    assert bench.run_until_ended(limit_s=10) == "Accepted"
    assert watch.calls.count > 60 and watch.calls.longest_own <= 10_000


@pytest.mark.parametrize(("loop_ms", "frames_per_s"), [(0, 180), (1, 60), (2, 36), (5, 18)])
def test_so_many_frames_in_a_second_are_checked_and_no_byte_is_lost(signed_line, loop_ms, frames_per_s):
    """Of those to be checked, 31 bytes each, at 57600 baud: 180 fill the line. loop() takes so long beside update()."""
    bench = signed_line.bench
    signed_line.say(peer.heartbeat())
    bench.run(0.2)
    bench.tell("nosleep", 1)
    bench.tell("stall", 1 if loop_ms else 0, loop_ms)
    current = mavlink.MAVLink_mission_current_message(3, 10, 2, 1, 0, 0, 0)
    begun, before = bench.now, counters(bench)["accepted"]
    for n in range(frames_per_s):
        bench.run_until(begun + n / frames_per_s)
        signed_line.say(current)
    bench.run(0.2)
    assert counters(bench)["accepted"] - before == frames_per_s
    assert bench.mega.serial(1).lost == 0
