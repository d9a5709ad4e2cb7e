"""What the tests of host/units read of the recordings."""

from __future__ import annotations

import os
import struct
from pathlib import Path
from typing import Any

from simulation import recordings


def packed() -> bytes:
    """Each upload that a recorded PX4 accepted and gave an id, for host/units/opaque_id.cpp.

    How many, then of each the id, how many items, and those.
    """
    uploads = []
    for name in recordings.names():
        items: dict[int, Any] = {}
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
    data = struct.pack("<H", len(uploads))
    for opaque_id, plan in uploads:
        data += struct.pack("<IH", opaque_id, len(plan))
        for m in plan:
            place = struct.pack("<4f2if", m.param1, m.param2, m.param3, m.param4, m.x, m.y, m.z)
            data += struct.pack("<BHB", m.frame, m.command, m.autocontinue) + place
    return data


def environment(uploads: Path) -> dict[str, str]:
    """With what the units read: the uploads, which are put there, and the recordings."""
    uploads.write_bytes(packed())
    return {**os.environ, "MAVMISSION_UPLOADS": str(uploads), "MAVMISSION_RECORDINGS": str(recordings.FOLDER)}
