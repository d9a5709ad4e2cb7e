"""Message signing by itself, against Python's SHA-256 and pymavlink's signing."""

from __future__ import annotations

import hashlib
import random

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from simulation.fake_autopilot import mavlink
from simulation.signing_program import KEY, MINUTE, OTHER_KEY, UNIT, SigningProgram, signer, unsigned_frame

ACK = mavlink.MAVLink_mission_ack_message(1, 191, 0, 0, 0)
REQUEST = mavlink.MAVLink_mission_request_int_message(1, 191, 3, 0)
ITEM = mavlink.MAVLink_mission_item_int_message(1, 1, 3, 3, 16, 0, 1, 0.5, 1.5, 2.5, 3.5, 473977880, 85456280, 20.25, 0)
TUNNEL = mavlink.MAVLink_tunnel_message(1, 1, 1, 128, list(range(1, 129)))
YEARS = 12 * 365 * 86400 * 100_000  # about now [10 us]


@pytest.fixture(scope="module", params=[pytest.param("g++", marks=pytest.mark.slow), "clang++"])
def running(request):
    program = SigningProgram(request.param)
    yield program
    program.close()


@pytest.fixture
def signing(running):
    """Fresh, its store empty and quick."""
    running.ask("slow", 1)
    running.ask("rounds", 8)
    running.begin(kept=0)
    return running


# Hashing


def test_every_length_up_to_300_is_hashed_right(signing):
    for length in range(301):
        data = random.Random(length).randbytes(length)
        assert signing.ask("hash", data.hex() or "-", 300) == hashlib.sha256(data).hexdigest(), length


@settings(
    max_examples=150, deadline=None, derandomize=True, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
@given(data=st.binary(max_size=400), slices=st.lists(st.integers(1, 130), min_size=1, max_size=9))
def test_slicing_changes_nothing(signing, data, slices):
    assert signing.ask("hash", data.hex() or "-", *slices) == hashlib.sha256(data).hexdigest()


def test_key_of_a_passphrase_is_its_sha256(signing):
    for passphrase in ("", "a", "correct horse battery staple", "x" * 64):
        assert signing.ask("passphrase", passphrase) == hashlib.sha256(passphrase.encode()).hexdigest()


# Signing


def test_pymavlink_accepts_what_is_signed_and_not_with_another_key(signing):
    receiver = signer(time=0)
    for message in (ACK, REQUEST, ITEM, TUNNEL):
        frame = unsigned_frame(message)
        for cut in (0, 1, 10, len(frame) - 2, len(frame) - 1):
            decoded = receiver.decode(bytearray(signing.sign(frame, cut)))
            assert decoded.get_type() == message.get_type() and decoded.get_signed() and decoded.get_link_id() == 7
    assert receiver.signing.goodsig_count == 20
    with pytest.raises(mavlink.MAVError, match="Invalid signature"):
        signer(key=OTHER_KEY).decode(bytearray(signing.sign(unsigned_frame(ACK))))


def test_work_is_cut_as_asked(signing):
    for rounds in (8, 16, 24, 64):
        signing.ask("rounds", rounds)
        calls = int(signing.ask("sign", unsigned_frame(ITEM).hex(), 0).split()[1])
        assert calls == 2 * -(-64 // rounds)  # two blocks


# Checking


def test_what_pymavlink_signs_is_accepted(signing):
    sender = signer(time=5 * MINUTE)
    for message in (ACK, REQUEST, ITEM, TUNNEL) * 5:
        assert signing.accepts(message.pack(sender))
    assert signing.counters == {"accepted": 20, "wrong": 0, "replayed": 0, "old": 0, "too many streams": 0}


def test_any_single_bit_changed_is_refused(signing):
    frame = bytes(ITEM.pack(signer(time=YEARS)))
    for bit in range(8 * len(frame)):  # the length's and the flags' among them
        changed = bytearray(frame)
        changed[bit // 8] ^= 1 << bit % 8
        assert not signing.accepts(changed), f"bit {bit % 8} of byte {bit // 8}"
    assert signing.counters["accepted"] == 0
    assert signing.accepts(frame)


def test_each_refusal_is_counted_for_its_reason(signing):
    """A frame that comes again; the first frame of a stream more than a minute behind; a fifth stream."""
    for behind, accepted in ((MINUTE, True), (MINUTE + 1, False), (YEARS, False), (0, True)):
        signing.begin(kept=0)
        frame = ACK.pack(signer(time=YEARS))
        assert signing.accepts(frame) and not signing.accepts(frame)
        assert signing.accepts(ACK.pack(signer(link=1, time=YEARS - behind))) == accepted, behind
        assert signing.counters == {"accepted": 1 + accepted, "wrong": 0, "replayed": 1, "old": 1 - accepted,
                                    "too many streams": 0}  # fmt: skip
    for sender in ((1, 2), (2, 1)):
        assert signing.accepts(ACK.pack(signer(sender, time=YEARS)))
    assert not signing.accepts(ACK.pack(signer((3, 1), time=YEARS)))
    assert signing.counters["too many streams"] == 1


def test_after_a_reset_what_was_recorded_long_before_is_refused(signing):
    old = [ACK.pack(signer(time=YEARS + n)) for n in range(3)]
    assert all(signing.accepts(frame) for frame in old)
    assert signing.accepts(ACK.pack(signer(time=YEARS + 2 * MINUTE)))
    signing.sign(unsigned_frame(ACK))  # time is reserved when something is signed
    signing.begin()
    assert not any(signing.accepts(frame) for frame in old)
    assert signing.counters["old"] == 3


def test_very_first_timestamp_is_no_time(signing):
    frame = ACK.pack(signer(time=0))
    assert not signing.accepts(frame) and not signing.accepts(frame)
    assert signing.accepts(ACK.pack(signer(time=1)))


@settings(max_examples=60, deadline=None, derandomize=True, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(
    st.lists(
        st.tuples(st.integers(1, 3), st.integers(0, 2), st.integers(-2 * MINUTE, 2 * MINUTE), st.booleans()),
        max_size=25,
    )
)
def test_it_judges_as_the_rules_of_the_guide_do(signing, frames):
    """Beside a model in Python: a stream's time rises, and begins no more than a minute behind ours."""
    signing.begin(kept=0)
    ours, streams = 0, {}
    for component, link, offset, is_right in frames:
        time = YEARS + offset
        stream = (component, link)
        fresh = time > streams[stream] if stream in streams else time + MINUTE >= ours
        room = stream in streams or sum(last + MINUTE >= ours for last in streams.values()) < 4
        expected = fresh and room and is_right
        frame = ACK.pack(signer((1, component), link=link, time=time, key=KEY if is_right else OTHER_KEY))
        assert signing.accepts(frame) == expected
        if expected:
            if stream not in streams and len(streams) == 4:
                gone = next(old for old, last in streams.items() if last + MINUTE < ours)
                del streams[gone]
            streams[stream] = time
            ours = max(ours, time)
    assert signing.time == ours


# Time


def test_clock_moves_time_forward_only(signing):
    for unix, expected in ((0, 0), (1420070400, 0), (1420070401, 100_000), (1700000000, 27992960000000),
                           (1600000000, 27992960000000)):  # fmt: skip
        signing.ask("clock", unix)
        assert signing.time == expected, unix


def test_unix_time_is_converted_exactly(signing):
    for seconds in (65535, 65536, 2**31, 2_814_749_766):
        signing.ask("clock", 1420070400 + seconds)
        assert signing.time == seconds * 100_000


def test_no_timestamp_is_used_before_it_is_reserved(signing):
    signing.ask("slow", 7)
    signing.begin(kept=0)
    for _ in range(3):
        signed = int.from_bytes(signing.sign(unsigned_frame(ACK))[-12:-6], "little")
        assert signed < signing.kept * UNIT
        assert signing.accepts(ACK.pack(signer(time=signed + 10 * MINUTE)))


def test_time_rises_across_resets(signing):
    """Whatever happened before them: a reset at any point, an autopilot that is ahead, nothing at all."""
    random_source, latest = random.Random(7), 0
    autopilot = signer(time=YEARS)
    for _ in range(300):
        signing.begin()
        for _ in range(random_source.randrange(4)):
            if random_source.random() < 0.5:
                autopilot.signing.timestamp = max(autopilot.signing.timestamp, latest) + random_source.randrange(
                    1, MINUTE // 2
                )
                assert signing.accepts(ACK.pack(autopilot))
            else:
                signed = int.from_bytes(signing.sign(unsigned_frame(ACK))[-12:-6], "little")
                assert signed > latest
                latest = signed


def test_autopilot_is_heard_after_a_reset_at_the_worst_moment(signing):
    """When all has just been reserved, our time is ahead by that: less than the minute that is granted."""
    autopilot = signer(time=YEARS)
    for _ in range(200):
        autopilot.signing.timestamp += UNIT * 2
        assert signing.accepts(ACK.pack(autopilot))
        signing.sign(unsigned_frame(ACK))
        before = signing.saves
        heard = autopilot.signing.timestamp
        signing.begin()
        assert signing.time - heard < MINUTE
        assert signing.accepts(ACK.pack(signer(time=heard)))
        autopilot.signing.timestamp = max(autopilot.signing.timestamp, signing.time)
        assert signing.saves == before


def test_store_is_written_once_in_39_s_while_the_autopilots_clock_runs(signing):
    autopilot = signer(time=YEARS)
    signing.accepts(ACK.pack(autopilot))
    signing.sign(unsigned_frame(ACK))
    before = signing.saves
    hour = 3600
    for _ in range(hour):
        autopilot.signing.timestamp += 100_000
        assert signing.accepts(ACK.pack(autopilot))
        signing.sign(unsigned_frame(ACK))
    assert 3600 / 40 <= signing.saves - before <= 3600 / 38


def test_resets_that_nobody_hears_of_do_not_run_ahead_either(signing):
    """Each signs something; the autopilot's time stands."""
    for _ in range(25):
        signing.begin()
        assert signing.accepts(ACK.pack(signer(time=YEARS)))
        signing.sign(unsigned_frame(ACK))


def test_store_is_not_written_while_time_stands(signing):
    before = signing.saves
    for _ in range(500):
        signing.sign(unsigned_frame(ACK))
    assert signing.saves - before == 1
