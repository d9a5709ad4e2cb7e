"""What TelemetryPause is worth: the time of an upload, and of reading back, on a full line, as it is and quiet."""

from __future__ import annotations

from collections.abc import Iterable

from simulation.quiet import RECORDED, Quiet, as_recorded, default_list

from .report import aligned

PLANS = (50, 200)


def bench(personality: str) -> Quiet:
    return Quiet(personality, **as_recorded(personality))


def upload(personality: str, items: int) -> str:
    """[s]"""
    return loud_and_quiet(bench(personality).transfer_s(used, items) for used in (False, True))


def reading_back(personality: str, items: int) -> str:
    """[s]"""
    return loud_and_quiet(bench(personality).read_back_s(used, items) for used in (False, True))


def loud_and_quiet(seconds: Iterable[float]) -> str:
    return " / ".join(f"{one:.2f}" for one in seconds)


def hushing_s(personality: str) -> float:
    """From the first command to the last answer that the messages of the list need to be silent [s]."""
    on = bench(personality)
    on.run_until_idle()
    on.run_until(3.0)
    on.tell("upload", PLANS[-1])
    on.run_until_quiet()
    asked = on.asked_since(3.0, -1)
    if asked != default_list(personality):
        raise RuntimeError(f"{personality} was asked for {asked}")
    began = next(when for when, _, interval in on.asked if when >= 3.0 and interval == -1)
    return on.now - began


def table() -> str:
    """As the documents have it."""
    lines = [["57600 baud, full line; seconds, as it is / quiet", *RECORDED]]
    for items in PLANS:
        took = [upload(name, items) for name in RECORDED]
        lines.append([f"upload of {items} items", *took])
    for items in PLANS:
        took = [reading_back(name, items) for name in RECORDED]
        lines.append([f"reading back {items} items", *took])
    lines.append(["switching off", *(f"{hushing_s(name):.2f}" for name in RECORDED)])
    return aligned(lines, left=1)
