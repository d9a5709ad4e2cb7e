"""The rows of simulation/recordings/readback_random_*.csv: what a real autopilot was sent, said, and gave back.

A row of None in `read` was refused, or accepted and could not be read.
"""

from __future__ import annotations

import csv
import functools
from dataclasses import dataclass

from simulation import recordings
from simulation.fake_autopilot import FENCE, MISSION, RALLY, Item, ardupilot_rewriting, mavlink, px4_rewriting
from simulation.fake_autopilot.items import f32

VEHICLES = {"arducopter": "copter", "ardurover": "rover", "arduplane": "plane", "px4": "px4"}
RESULTS = {
    name.removeprefix("MAV_MISSION_"): number
    for number, name in ((number, entry.name) for number, entry in mavlink.enums["MAV_MISSION_RESULT"].items())
}
ACCEPTED = mavlink.MAV_MISSION_ACCEPTED


@dataclass(frozen=True)
class Row:
    line: int  # of the file
    plan: int  # rows with the same number went up together
    mission_type: int
    sent: Item
    result: int  # MAV_MISSION_RESULT; of a fence, that of the whole plan
    read: Item | None


def _item(cells: dict[str, str], side: str) -> Item | None:
    if cells[f"{side}_frame"] == "":
        return None

    def number(column: str, default: str = "") -> int:
        return int(cells.get(f"{side}_{column}", default))

    params = (f32(float(cells[f"{side}_p{index}"])) for index in (1, 2, 3, 4))
    command = int(cells["command"]) if side == "sent" else number("command")
    return Item(
        number("frame"),
        command,
        number("current", "0"),
        number("autocontinue", "1"),
        *params,
        number("x"),
        number("y"),
        f32(float(cells[f"{side}_z"])),
    )


@functools.cache
def rows(recording: str) -> tuple[Row, ...]:
    """Of "arducopter", "ardurover", "arduplane" or "px4"."""
    types = {"type 1": FENCE, "type 2": RALLY}
    with open(recordings.FOLDER / f"readback_random_{recording}.csv", newline="") as file:
        return tuple(
            Row(
                line,
                int(cells["plan"]),
                types.get(cells["name"], MISSION),
                _item(cells, "sent"),
                RESULTS[cells["result"]],
                _item(cells, "read"),
            )
            for line, cells in enumerate(csv.DictReader(file), start=2)
        )


def kept(recording: str, mission_type: int, item: Item) -> tuple[int, Item | None]:
    """(MAV_MISSION_RESULT, the item as it is read back or None), as the fake autopilots have it."""
    if recording == "px4":
        return px4_rewriting.item_as_held(item, mission_type, float_mode=False)
    if mission_type == FENCE:
        return ardupilot_rewriting.fence_item(item)
    if mission_type == RALLY:
        return ardupilot_rewriting.rally_item(item)
    return ardupilot_rewriting.mission_item(item, VEHICLES[recording])
