"""Examples that arm fly in the page to their end: its far end of the line, beside the tests' own Mega."""

from __future__ import annotations

import json

import pytest

from building import build_sketch
from demonstration.autopilots import EXAMPLES_FLY_AT
from playing.inside.far_end import FarEnd
from simulation.mega import Mega

SLICE_CYCLES = 80_000  # 5 ms
# What a sketch prints when its flight is over.
ENDS = {"StartMission": b"landed\r\n", "NextWaypoint": b"all fields sampled\r\n", "WorkAtWaypoints": b"landed\r\n",
        "GoToPlaces": b"home\r\n", "FollowBeacon": b"home\r\n"}  # fmt: skip
LIMIT_S = 240
BAUD = 57600.0


@pytest.mark.slow
@pytest.mark.parametrize("autopilot", ["ardupilot", "px4"])
@pytest.mark.parametrize("example", ENDS)
def test_example_that_arms_flies_in_the_page_to_its_end(example, autopilot):
    mega = Mega(build_sketch(example).elf)
    settings = {"autopilot": autopilot, "loss": 0, "bytes": 0, "seed": 1, "hz": mega.hz, "arms": True,
                "home": EXAMPLES_FLY_AT}  # fmt: skip
    far = FarEnd(json.dumps(settings))
    printed, highest_m = b"", 0.0
    while ENDS[example] not in printed and mega.cycle < LIMIT_S * mega.hz:
        mega.run_until(mega.cycle + SLICE_CYCLES)
        printed += bytes(one.byte for one in mega.serial(0).sent())
        sent = mega.serial(1).sent()
        data, left = bytes(one.byte for one in sent), [one.left for one in sent]
        arriving = far.step(mega.cycle / mega.hz, data, left, BAUD)
        if arriving:
            mega.serial(1).send(arriving, mega.cycle)
        highest_m = max(highest_m, far.autopilot.flight.where(mega.cycle / mega.hz).height)
    assert printed.endswith(ENDS[example])
    assert highest_m == pytest.approx(10)
    assert not far.autopilot.armed
