"""The tests of host/units, run from here."""

from __future__ import annotations

import os
import re
import struct
import subprocess
from pathlib import Path

from simulation import recordings
from simulation.host_build import HOST


def recorded_uploads() -> bytes:
    """What host/units/opaque_id.cpp reads: each upload that a recorded PX4 accepted and gave an id."""
    uploads = []
    for name in recordings.names():
        items = {}
        for one in recordings.heard(name) if name.startswith("px4/") else ():
            message, kind = one.message, one.message.get_type()
            if kind == "MISSION_COUNT" and one.direction == ">":
                items = {}
            elif kind == "MISSION_ITEM_INT" and one.direction == ">" and message.mission_type == 0:
                items[message.seq] = message
            elif kind == "MISSION_ACK" and one.direction == "<" and message.type == 0 and message.mission_type == 0:
                if message.opaque_id and sorted(items) == list(range(len(items))) and items:
                    uploads.append((message.opaque_id, [items[seq] for seq in sorted(items)]))
                items = {}
    packed = struct.pack("<H", len(uploads))
    for opaque_id, plan in uploads:
        packed += struct.pack("<IH", opaque_id, len(plan))
        for m in plan:
            place = struct.pack("<4f2if", m.param1, m.param2, m.param3, m.param4, m.x, m.y, m.z)
            packed += struct.pack("<BHB", m.frame, m.command, m.autocontinue) + place
    return packed


def cases_of(unit: str) -> int:
    """As many as the file of host/units has."""
    return (HOST / "units" / f"{unit}.cpp").read_text().count("TEST_CASE(")


def run_unit(program: Path, unit: str, folder: Path) -> tuple[int, int]:
    """Runs the tests of one file of host/units: the program's exit code, 0 if all passed, and how many cases it ran."""
    uploads = folder / "uploads"
    uploads.write_bytes(recorded_uploads())
    ran = subprocess.run(
        [program, f"--source-file=*/units/{unit}.cpp", "--no-version"],
        capture_output=True, text=True, check=False, env={**os.environ, "MAVMISSION_UPLOADS": str(uploads)},
    )  # fmt: skip
    print(ran.stdout, ran.stderr)
    cases = re.search(r"test cases: *(\d+)", ran.stdout)
    return ran.returncode, int(cases[1]) if cases else 0
