"""The fake autopilots answer for their modes as the real ones in the recordings did.

The lists themselves are not the fakes': a board has as many modes as it was built with. Compared are the answers to
each command, and which entries come.
"""

from __future__ import annotations

import pytest

from recorded import fake_for, play
from simulation import recordings
from simulation.fake_autopilot import mavlink

REQUEST_MESSAGE, AVAILABLE_MODES = 512, mavlink.MAVLINK_MSG_ID_AVAILABLE_MODES
NOT_IMITATED = 194  # a message that the fakes do not have


def exchanges(told) -> list[tuple]:
    """(command, its first two parameters, result, which entries of the list came), from (direction, message)."""
    result: list[tuple] = []
    for direction, message in told:
        kind = message.get_type()
        if direction == ">" and kind == "COMMAND_LONG":
            result.append(((message.command, message.param1, message.param2), [], []))
        elif result and kind == "COMMAND_ACK":
            result[-1][1].append(message.result)
        elif result and kind == "AVAILABLE_MODES":
            result[-1][2].append(message.mode_index)
    return result


def is_of_both(exchange: tuple) -> bool:
    """An entry that both lists have, one beyond their ends, or another command; no other message."""
    (command, first, second), _, _ = exchange
    if (command, first) == (REQUEST_MESSAGE, AVAILABLE_MODES):
        return 0 < second <= 3 or second == 99
    return (command, first) != (REQUEST_MESSAGE, NOT_IMITATED)


@pytest.mark.parametrize("name", recordings.modes())
def test_it_answers_each_question_about_modes_as_the_real_one(name):
    fake = fake_for(name)
    play(name, fake)
    real = exchanges((one.direction, one.message) for one in recordings.heard(name))
    said = exchanges((direction, message) for _, direction, message in fake.log)
    assert len(said) == len(real) >= 7
    for mine, theirs in zip(said, real, strict=True):
        if is_of_both(theirs):
            assert mine == theirs
