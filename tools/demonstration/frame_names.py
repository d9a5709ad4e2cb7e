"""The name of a frame that is to be lost, as it is typed: MISSION_ACK:1 is the first MISSION_ACK that anyone sends."""

from __future__ import annotations

import fnmatch
from collections.abc import Iterable


class BadName(ValueError):
    """No frame is called so; the text says what is."""


def frame_of(text: str, messages: Iterable[str]) -> tuple[str, int]:
    """The name, in which * and ? stand for any letters, and the number, 1 where there is none. Raises BadName."""
    name, colon, number = text.partition(":")
    if colon and not (number.isdigit() and int(number) > 0):
        raise BadName(f"{text}: the number behind the colon is 1 for the first such frame, 2 for the second")
    known = sorted(messages)
    if not fnmatch.filter(known, name):
        near = [other for other in known if other.startswith("MISSION_")]
        raise BadName(f"{text}: MAVLink has no message {name}; those of a mission are {', '.join(near)}")
    return name, int(number) if colon else 1
