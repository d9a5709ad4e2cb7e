"""What damage on the line costs beyond the frames that it strikes: our parser beside the one in MAVLink's headers.

Recorded autopilot streams are damaged at each of their bytes in turn; see resynchronisation/measure.cpp for what is
counted. Run with -s, or read the tables at the end of the run.
"""

from __future__ import annotations

import struct
import subprocess
from functools import cache
from pathlib import Path
from typing import NamedTuple

import pytest

from simulation import recordings
from simulation.fake_autopilot import mavlink
from simulation.firmware import ROOT, digest, exclusive, library_file
from simulation.host_build import FAST, OUTPUT, build_host

# A frame of the mission service after so many others: there is always a next one that damage could cost.
EVERY = 4

STREAMS = {
    "PX4 in its default streams": "px4/clean_with_streams",
    "ArduCopter with all streams at 10 Hz": "arducopter/clean_then_streams_10hz",
}

TITLES = [pytest.param(title, marks=() if title.startswith("PX4") else pytest.mark.slow) for title in STREAMS]

BURSTS = [f"{count} byte{'s' if count > 1 else ''} lost" for count in (1, 2, 3, 5, 8, 16, 32, 63)]
FLIPS = ["lowest bit flipped", "bit 4 flipped", "highest bit flipped", "all bits flipped"]
CUT = "frame cut short, then silence"


class Loss(NamedTuple):
    positions: int  # where the damage was done, once each
    frames: int  # undamaged frames that were lost, over all positions
    struck: int  # positions with at least one such loss
    false: int  # frames given that nobody had sent


def mission_frame(number: int) -> bytes:
    """What an autopilot says in an upload to client 1/191, and no two alike."""
    packer = mavlink.MAVLink(None, 1, 1)
    packer.seq = number % 256
    if number % 5 == 4:
        message = mavlink.MAVLink_mission_ack_message(1, 191, 0, 0, number)
    elif number % 2:
        message = mavlink.MAVLink_mission_request_message(1, 191, number)
    else:
        message = mavlink.MAVLink_mission_request_int_message(1, 191, number)
    return bytes(message.pack(packer))


def mixed(telemetry: list[bytes]) -> list[bytes]:
    """The frames with one of the mission service after each EVERY."""
    frames = []
    for index, frame in enumerate(telemetry):
        frames.append(frame)
        if index % EVERY == EVERY - 1:
            frames.append(mission_frame(index // EVERY))
    return frames


def recorded(name: str) -> list[bytes]:
    return [one.frame for one in recordings.heard(name) if one.direction == "<"]


def losses(frames: list[bytes], folder: Path) -> dict[tuple[str, str], Loss]:
    """(kind of damage, parser) -> what it cost."""
    stream = folder / "stream"
    stream.write_bytes(b"".join(struct.pack("<H", len(frame)) + frame for frame in frames))
    parser = [library_file(name) for name in ("Checksum.cpp", "FrameParser.cpp", "Messages.cpp")]
    program = build_host("resynchronisation", [ROOT / "test/resynchronisation/measure.cpp"], flags=FAST, library=parser)
    figures = folder / f"{digest(str(program), stream.read_bytes())[:16]}.txt"  # another test may have measured it
    with exclusive(figures):
        if not figures.exists():
            ran = subprocess.run([program, stream], capture_output=True, text=True, check=False)
            assert ran.returncode == 0, ran.stderr
            figures.write_text(ran.stdout)
    found = {}
    for line in figures.read_text().splitlines():
        kind, parser_name, *numbers, where = line.split("|")
        found[kind, parser_name] = Loss(*map(int, numbers))
        if parser_name == "ours" and where:
            print(f"{kind}: ours loses frames at {where}")
    return found


@cache
def measured(name: str) -> dict[tuple[str, str], Loss]:
    folder = OUTPUT / "streams" / name.replace("/", "-")
    folder.mkdir(parents=True, exist_ok=True)
    return losses(mixed(recorded(name)), folder)


def table(found: dict[tuple[str, str], Loss]) -> list[list[str]]:
    rows = [
        ["damage", "positions", "lost by the stock parser", "lost by ours", "positions where the stock parser loses"]
    ]
    for kind in [*BURSTS, *FLIPS, CUT]:
        stock, ours = found[kind, "stock"], found[kind, "ours"]
        share = f"{100 * stock.struck / stock.positions:.1f} %"
        rows.append([kind, f"{ours.positions:,}", f"{stock.frames:,}", f"{ours.frames:,}", share])
    return rows


@pytest.mark.scenario(28, "Damage at each position costs no other frame")
@pytest.mark.parametrize("title", TITLES)
def test_no_undamaged_frame_is_lost_whatever_is_damaged_before_it(title, record_property):
    found = measured(STREAMS[title])
    record_property("table", [f"undamaged frames lost after damage: {title}", table(found)])
    assert found["none", "ours"].frames == 0
    assert {kind: found[kind, "ours"] for kind in [*BURSTS, *FLIPS, CUT] if found[kind, "ours"].frames} == {}


@pytest.mark.parametrize("title", TITLES)
def test_frames_that_nobody_sent_are_as_rare_as_a_16_bit_checksum_makes_them(title):
    found = measured(STREAMS[title])
    false = sum(loss.false for (_, parser), loss in found.items() if parser == "ours")
    positions = sum(loss.positions for (_, parser), loss in found.items() if parser == "ours")
    # Damage makes a handful of candidates; each is right by chance once in 65,536 times.
    assert false <= 8 * positions / 65536


@pytest.mark.parametrize("title", TITLES)
def test_the_figures_are_of_damage_that_does_cost_frames(title):
    # The counting is blind if a parser that is known to lose frames loses none.
    found = measured(STREAMS[title])
    for kind in [*BURSTS, *FLIPS, CUT]:
        assert found[kind, "stock"].frames > 0, kind
    assert found["2 bytes lost", "stock"].struck > 0.3 * found["2 bytes lost", "stock"].positions
