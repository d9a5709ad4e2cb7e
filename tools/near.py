"""What somebody meant who mistyped a name, and numbers of a command line that are told apart from words."""

from __future__ import annotations

import argparse
import difflib
from collections.abc import Callable, Iterable

NEAR = 0.6  # of difflib's ratios, which are 1 for the same word
SHORTEST_BEGINNING = 3
LAST_PORT = 65535


def nearest(word: str, names: Iterable[str]) -> str:
    """The name that was meant, or "" where none is near. A word may be the beginning of a name: Uplad."""

    def nearness(name: str) -> tuple[float, float]:
        whole, beginning = (
            difflib.SequenceMatcher(None, word.lower(), part.lower()).ratio() for part in (name, name[: len(word)])
        )
        return max(whole, beginning if len(word) >= SHORTEST_BEGINNING else 0), whole

    best = max(names, key=nearness, default="")
    return best if best and nearness(best)[0] >= NEAR else ""


def did_you_mean(word: str, names: Iterable[str]) -> str:
    """; did you mean UploadMission? There are DownloadMission, UploadMission"""
    known = list(names)
    near = nearest(word, known)
    every = ", ".join(known)
    return f"; did you mean {near}? There are {every}" if near else f"; there are {every}"


def one_of(names: Iterable[str]) -> Callable[[str], str]:
    """For `type` of an argument: one of these names, and the nearest for another."""
    known = list(names)

    def checked(word: str) -> str:
        if word not in known:
            raise argparse.ArgumentTypeError(f"there is no {word}{did_you_mean(word, known)}")
        return word

    return checked


def number(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} is not a number") from None


def percent(text: str) -> float:
    value = number(text)
    if not 0 <= value <= 100:
        raise argparse.ArgumentTypeError(f"{text} is not a number from 0 to 100")
    return value


def count(text: str) -> int:
    if not text.isdecimal() or int(text) == 0:
        raise argparse.ArgumentTypeError(f"{text!r} is not a number from 1 on")
    return int(text)


def port_number(text: str) -> int:
    """Of a server at the loopback address."""
    if not text.isdecimal() or int(text) > LAST_PORT:
        raise argparse.ArgumentTypeError(f"{text!r} is not a number from 0 to {LAST_PORT}")
    return int(text)


def positive(text: str) -> float:
    value = number(text)
    if not 0 < value < float("inf"):
        raise argparse.ArgumentTypeError(f"{text} is not a number above 0")
    return value
