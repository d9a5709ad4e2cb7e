"""What QuietTransfers is worth: the time of an upload on a full line, as it is and quiet."""

from __future__ import annotations

from quiet import RECORDED, Quiet, default_list, recorded

from .report import aligned

PLANS = (10, 50, 200)


def bench(personality: str) -> Quiet:
    return Quiet(personality, telemetry=recorded(personality))


def transfer(personality: str, items: int) -> str:
    """[s]"""
    loud, quiet = (bench(personality).transfer_s(used, items) for used in (False, True))
    return f"{loud:.2f} / {quiet:.2f}"


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
        lines.append([f"upload of {items} items, from COUNT to the acceptance", *(transfer(name, items) for name in RECORDED)])
    lines.append(["switching off, beside the first items", *(f"{hushing_s(name):.2f}" for name in RECORDED)])
    return aligned(lines, left=1)
