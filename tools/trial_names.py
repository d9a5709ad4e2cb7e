"""The trials of tools/bench and tools/field by name. Nothing need be installed to know them: what each does is in
tools/benching, and this is the one list of those that differ by two or three words only."""

from __future__ import annotations

import re
from pathlib import Path
from typing import NamedTuple

SCENARIOS = Path(__file__).resolve().parent / "benching" / "scenarios.py"
SIMULATED = "SIMULATED = ("  # the rows of SCENARIOS from here on are for a simulator alone
_ROW = re.compile(r'^    Scenario\("([^"]*)"(.*)', re.M)


class Grid(NamedTuple):
    """An upload on a line that loses so many percent of its bytes, each way taking so long."""

    items: int
    percent: int
    ms: int

    @property
    def name(self) -> str:
        return f"{self.items} items, {self.percent} % of bytes, {self.ms} ms"


class Flown(NamedTuple):
    """An example, flown to its end, and what befalls it."""

    example: str
    befalls: str

    @property
    def name(self) -> str:
        return f"{self.example}, {self.befalls}"


GRID = tuple(Grid(items, percent, ms) for items in (5, 60, 300) for percent in (0, 1, 3) for ms in (0, 150))
RANDOM_ITEMS = "random items against the read-back rules"
# What an example that does not arm prints when it has done its work; "": it prints nothing.
PRINTED = {
    "UploadMission": "",
    "UploadWithProgress": "aboard: our plan, whole",
    "EnsureMission": "aboard: our plan, whole",
    "VerifyUpload": "aboard: our plan, whole",
    "DownloadMission": "downloaded: the plan has been read",
    "GridFromFunction": "",
    "FenceAndRally": "rally: aboard, as it was meant",
    "UploadByFile": "accepted: the plan is aboard",
    "LinkDoctor": "all is well",
    "ReadTelemetry": "-353632",
    "FitLight": "fit: all is well",
    "CheckParameters": "MIS_RESTART: 1.00 done: the autopilot confirmed it",
}
FLYING = ("StartMission", "StartButton", "WorkAtWaypoints", "NextWaypoint", "GoToPlaces", "FollowBeacon",
          "FlyByButtons")  # fmt: skip
PLANNED = FLYING[:4]
SOME = ("StartMission", "NextWaypoint", "GoToPlaces", "FollowBeacon")
PAUSED = "a station pauses it"
FAILSAFES = ("the battery is low", "the ground station is lost", "the fence is breached")
# What befalls a flight, and of which examples.
BEFALLS = {
    **dict.fromkeys(("undisturbed", "3 % of bytes", "a pilot lands", "a pilot disarms", "a pilot gives back",
                     "a pilot comes while loop() stands still", "a failsafe", "the cable is out",
                     "the board is reset", "loop() stands still"), FLYING),
    "a station orders the return": FLYING,
    **dict.fromkeys(("a station uploads another plan", "a station sets the current item", PAUSED), PLANNED),
    **dict.fromkeys(FAILSAFES, SOME),
}  # fmt: skip
FLIGHTS = tuple(Flown(example, befalls) for befalls, examples in BEFALLS.items() for example in examples)


# What is flown of which vehicle, what it refuses to fly, and which examples are not for it: a plane does not keep the
# plan of its two.
VEHICLES: dict[str, tuple[str, ...]] = {
    "arducopter": FLYING, "px4": FLYING, "ardurover": PLANNED,
    "arduplane": ("StartMission", "StartButton", "NextWaypoint"),
    "quadplane": ("StartMission", "StartButton", "GoToPlaces"), "ardusub": ()}  # fmt: skip
REFUSES = {"ardurover": ("GoToPlaces", "FollowBeacon"), "arduplane": ("WorkAtWaypoints", "GoToPlaces", "FollowBeacon"),
           "quadplane": ("WorkAtWaypoints", "NextWaypoint"), "ardusub": ("GoToPlaces", "FollowBeacon")}  # fmt: skip
NOT_FOR = {"px4": ("UploadByFile", "CheckParameters"),
           **dict.fromkeys(("arduplane", "quadplane"), ("VerifyUpload", "UploadByFile"))}  # fmt: skip
PRINTED |= {example: "ended by a refusal: " for example in ("WorkAtWaypoints", "GoToPlaces", "FollowBeacon")}
PRINTED["NextWaypoint"] = "not ready: Arm: VTOL land too short, min "  # of a quadplane, which flies no such short way


def board_names() -> list[str]:
    return [name for name, _ in _ROW.findall(SCENARIOS.read_text().partition(SIMULATED)[0])]


def is_for(vehicle: str, row: object) -> bool:
    """Whether this row of the table is played to it."""
    if isinstance(row, Flown):
        return row.example in VEHICLES[vehicle] and (row.befalls != PAUSED or vehicle == "arducopter")
    return row in REFUSES.get(vehicle, ()) if row in FLYING else row not in NOT_FOR.get(vehicle, ())


def simulator_names(vehicle: str = "arducopter") -> list[str]:
    rows = [name for name, rest in _ROW.findall(SCENARIOS.read_text()) if 'is_for="board"' not in rest]
    examples = [f"example {name}" for name in PRINTED if is_for(vehicle, name)]
    flights = [one.name for one in FLIGHTS if is_for(vehicle, one)]
    return [*rows, *(one.name for one in GRID), RANDOM_ITEMS, *examples, *flights]
