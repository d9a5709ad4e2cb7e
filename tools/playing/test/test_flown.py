"""Examples that arm fly in the page to their end: its autopilot's end of the line, beside the tests' own Mega.

Each beside one of the two autopilots, in turn: that it flies beside both is said by test/documents.
"""

from __future__ import annotations

import itertools
import json

import pytest

from building import build_sketch
from demonstration.autopilots import EXAMPLES_FLY_AT
from played import FLOWN
from playing.inside.autopilot_end import AutopilotEnd
from simulation.mega import Mega

SLICE_CYCLES = 80_000  # 5 ms
LIMIT_S = 240
BAUD = 57600.0
PIN_2 = 0x2C, 1 << 4  # of a Mega: PINE, bit 4
ALOFT, LANDED = b"at the stop\r\n", b"landed\r\n"


class Hand:
    """Presses the button at pin 2 as the examples that have one ask for."""

    def __init__(self, example: str, mega: Mega) -> None:
        self.example, self.mega = example, mega
        self.since_s = {"StartButton": 4.0, "FlyByButtons": 3.0}.get(example, LIMIT_S)
        self.held_s = 3.0 if example == "StartButton" else 1.2
        self.lands = example == "FlyByButtons"

    def look(self, now: float, printed: bytes) -> None:
        if self.lands and ALOFT in printed:  # it is at its height
            self.since_s, self.lands = now + 1.0, False
        place, bit = PIN_2
        pins = self.mega.peek_int(place)
        is_down = self.since_s <= now < self.since_s + self.held_s
        self.mega.poke_int(place, pins & ~bit if is_down else pins | bit)


@pytest.mark.slow
@pytest.mark.parametrize(("example", "autopilot"), [*zip(FLOWN, itertools.cycle(["ardupilot", "px4"]))])
def test_example_that_arms_flies_in_the_page_to_its_end(example, autopilot):
    mega = Mega(build_sketch(example).elf)
    settings = {"autopilot": autopilot, "loss": 0, "bytes": 0, "seed": 1, "hz": mega.hz, "arms": True,
                "home": EXAMPLES_FLY_AT}  # fmt: skip
    end = AutopilotEnd(json.dumps(settings))
    hand = Hand(example, mega)
    height_m = FLOWN[example]
    printed, highest_m, legs = b"", 0.0, 2 if example == "NextWaypoint" else 1
    while (end.autopilot.armed or printed.count(LANDED) < legs) and mega.cycle < LIMIT_S * mega.hz:
        hand.look(mega.cycle / mega.hz, printed)
        mega.run_until(mega.cycle + SLICE_CYCLES)
        printed += bytes(one.byte for one in mega.serial(0).sent())
        sent = mega.serial(1).sent()
        data, left = bytes(one.byte for one in sent), [one.left for one in sent]
        arriving = end.step(mega.cycle / mega.hz, data, left, BAUD)
        if arriving:
            mega.serial(1).send(arriving, mega.cycle)
        highest_m = max(highest_m, end.autopilot.flight.where(mega.cycle / mega.hz).height)
    assert printed.endswith(LANDED)
    # FlyByButtons holds the height at which its flight by hand begins: when the takeoff is all but over.
    assert highest_m == pytest.approx(height_m, abs=1.5 if example == "FlyByButtons" else 1e-5)
    assert not end.autopilot.armed
