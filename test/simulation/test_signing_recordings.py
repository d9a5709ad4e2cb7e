"""The fake autopilots take a key for signing, and answer signed and unsigned frames, as the real ones recorded did."""

from __future__ import annotations

import pytest

from recorded import fake_for, fields, play, said_by, said_in_recording
from simulation import recordings

ANSWERS = ("MISSION_REQUEST", "MISSION_REQUEST_INT", "MISSION_ACK", "MISSION_COUNT", "MISSION_ITEM_INT", "COMMAND_ACK")
SIGNED = 1  # of a MAVLink 2 frame's incompatibility flags


def is_signed(frame: bytes) -> bool:
    return bool(frame[2] & SIGNED)


def answers(said) -> list[tuple]:
    return [fields(message) for _, message in said if message.get_type() in ANSWERS]


def played(name: str):
    """(the fake, whether each of its answers was signed)."""
    fake = fake_for(name)
    release, signs = fake._release, []

    def note(data: bytes, now: float) -> None:
        if recordings.frames.decode(data).get_type() in ANSWERS:
            signs.append(is_signed(data))
        release(data, now)

    fake._release = note
    play(name, fake)
    return fake, signs


@pytest.mark.parametrize("name", recordings.signing())
def test_it_answers_what_the_real_one_answered_and_signs_what_the_real_one_signed(name):
    fake, signs = played(name)
    assert answers(said_by(fake)) == answers(said_in_recording(name))
    real = [is_signed(one.frame) for one in recordings.heard(name)
            if one.direction == "<" and one.message.get_type() in ANSWERS]  # fmt: skip
    assert signs == real
    assert any(real) != name.endswith("port_off") and not all(real)


def test_there_is_a_recording_of_each_version_that_was_met():
    assert recordings.signing() == ["arducopter_4_8/signing", "arducopter_4_8/signing_port_off", "px4_1_18/signing"]
