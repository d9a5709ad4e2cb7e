"""The autopilots' parser in the browser: the same C as here, compiled to WebAssembly, finds the same frames."""

from __future__ import annotations

import json
import random
import subprocess
from pathlib import Path

import pytest

from simulation import recordings
from simulation.fake_autopilot.hearing import ARDUPILOT, PX4, Hearing

HEAR = Path(__file__).with_name("hear.mjs")


def damaged(recording: str, seed: int) -> bytes:
    """What a client said, some bytes lost, altered, or inserted."""
    chance = random.Random(seed)
    out = bytearray()
    for _, data in recordings.raw(recording, ">"):
        for byte in data:
            drawn = chance.random()
            if drawn < 0.01:
                continue
            if drawn < 0.02:
                out.append(chance.randrange(256))
            out.append(byte ^ 0x40 if drawn > 0.99 else byte)
    return bytes(out)


@pytest.mark.parametrize("by", [ARDUPILOT, PX4])
def test_the_parser_in_the_browser_finds_the_frames_that_it_finds_here(folder, by):
    heard = 0
    for seed, recording in enumerate(recordings.names()[::3]):
        data = damaged(recording, seed) + random.Random(seed).randbytes(5000) + damaged(recording, seed + 100)
        here = Hearing(by).feed(data)
        said = subprocess.run(
            ["node", HEAR, folder / "hearing.wasm", str(by)], input=data, capture_output=True, check=True, timeout=60
        ).stdout
        assert [bytes.fromhex(frame) for frame in json.loads(said)] == here
        heard += len(here)
    assert heard > 100
