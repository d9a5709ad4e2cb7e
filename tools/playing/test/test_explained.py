"""A chosen frame in words, and both wires as a VCD file."""

from __future__ import annotations

import json
import subprocess

from playing.inside.explained import explained
from simulation.fake_autopilot import mavlink

PACKER = mavlink.MAVLink(None, 1, 191)
TAKEOFF = mavlink.MAVLink_mission_item_int_message(1, 1, 0, 3, 22, 0, 1, 0, 0, 0, 0, -353632621, 1491652374, 20.0, 0)
FRAMES = [
    {"way": ">", "hex": "fd0055aa", "began": 0.5, "ended": 0.5 + 40 / 57600},
    {"way": "<", "hex": "00ff", "began": 0.5001, "ended": 0.5001 + 20 / 57600},
]


def test_each_field_of_a_frame_has_its_value_and_what_it_means():
    frame = json.loads(explained(TAKEOFF.pack(PACKER)))
    assert frame["name"] == "MISSION_ITEM_INT"
    rows = {name: (value, words) for name, value, words in frame["rows"]}
    assert rows["from"][0] == "1/191, number 0"
    assert rows["command"] == ("22", "MAV_CMD_NAV_TAKEOFF")
    assert rows["frame"] == ("3", "MAV_FRAME_GLOBAL_RELATIVE_ALT")
    assert rows["x"] == ("-353632621", "-35.3632621°")
    assert rows["param4"][1] == "Yaw" and rows["z"] == ("20", "Altitude")


def test_bits_of_a_mask_are_named_and_a_damaged_frame_is_called_so():
    beat = mavlink.MAVLink_heartbeat_message(2, 3, 81, 4, 4, 3).pack(PACKER)
    rows = {name: words for name, _, words in json.loads(explained(beat))["rows"]}
    assert "MAV_MODE_FLAG_CUSTOM_MODE_ENABLED" in rows["base_mode"] and ", " in rows["base_mode"]
    damaged = bytearray(TAKEOFF.pack(PACKER))
    damaged[20] ^= 1
    found = json.loads(explained(bytes(damaged)))
    assert found == {"name": f"{len(damaged)} bytes that are no whole message", "rows": []}


def vcd_of(folder, frames: list[dict]) -> str:
    script = f"import {{ vcdOf }} from {json.dumps((folder / 'vcd.js').as_uri())};" \
        f"process.stdout.write(vcdOf({json.dumps(frames)}));"  # fmt: skip
    command = ["node", "--input-type=module", "-e", script]
    return subprocess.run(command, capture_output=True, text=True, check=True, timeout=60).stdout


def bytes_on(vcd: str, wire: str, baud: int = 57600) -> list[int]:
    """What a receiver samples in the middle of each bit."""
    sign = next(line.split()[3] for line in vcd.splitlines() if line.startswith("$var") and line.split()[4] == wire)
    changes, at = [], 0
    for line in vcd.splitlines():
        if line.startswith("#"):
            at = int(line[1:])
        elif line[1:] == sign and line[0] in "01":
            changes.append((at, int(line[0])))
    level = lambda time: next(value for when, value in reversed(changes) if when <= time)  # noqa: E731
    bit = 1e7 / baud
    found, free_at = [], 0.0
    for when, value in changes:
        if value == 0 and when >= free_at:
            found.append(sum(level(when + (turn + 1.5) * bit) << turn for turn in range(8)))
            assert level(when + 9.5 * bit) == 1
            free_at = when + 9.5 * bit
    return found


def test_a_receiver_reads_both_wires_of_the_vcd_as_they_were_sent(folder):
    vcd = vcd_of(folder, FRAMES)
    assert bytes_on(vcd, "mega_tx") == [0xFD, 0x00, 0x55, 0xAA]
    assert bytes_on(vcd, "mega_rx") == [0x00, 0xFF]
    times = [int(line[1:]) for line in vcd.splitlines() if line.startswith("#")]
    assert times == sorted(times) and "$timescale 100 ns $end" in vcd
