"""The table's rows as trials of one simulator each, and what is kept of them."""

from __future__ import annotations

import json
import random
import re
import shutil
import tempfile
import time
import zlib
from collections.abc import Callable, Iterator
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any, NamedTuple

from benching.flights import Flight, play_printed
from benching.items import Row, fakes_differ, keep_rows, play_items
from benching.scenarios import GRIDDED, SCENARIOS, SIMULATED, Result, perform
from benching.sketch import SOURCE
from simulation.firmware import build_firmware
from trial_names import FLIGHTS, PRINTED, RANDOM_ITEMS, is_for

from .simulator import Simulator
from .world import World

ROUNDS = 40  # of random items in a trial
FOUND_S = 4.0  # within which the board has heard the simulator
RESULTS = "trials.jsonl"


class Trial(NamedTuple):
    name: str
    kind: str
    row: Any  # of the table
    vehicle: str


@dataclass
class Outcome:
    """What is kept of a trial, as a line of JSON."""

    name: str
    kind: str
    vehicle: str
    seed: int
    status: str = ""
    contradictions: list[str] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    fakes_differ: list[str] = field(default_factory=list)
    simulated_s: float = 0.0
    took_s: float = 0.0
    frames: str = ""  # the file
    version: str = ""  # of the simulator
    clock: str = ""  # how its time was held
    broke: str = ""  # why it is no trial: what stood still, or did not come up

    @property
    def key(self) -> tuple[str, str, int]:
        return self.vehicle, self.name, self.seed


def table(vehicle: str = "arducopter") -> list[Trial]:
    """Every trial of it, in the order of simulator_names()."""
    uploads = [*(one for one in SCENARIOS if one.is_for != "board"), *SIMULATED, *GRIDDED]
    rows: list[tuple[str, str, Any]] = [(one.name, "uploads", one) for one in uploads]
    rows += [(RANDOM_ITEMS, "random items", None)]
    rows += [(f"example {one}", "examples", one) for one in PRINTED]
    rows += [(one.name, "flights", one) for one in FLIGHTS]
    return [Trial(*row, vehicle) for row in rows if is_for(vehicle, row[2])]


class Kept:
    """A folder with the outcomes of the trials so far, which a run that is begun again goes on with."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        folder.mkdir(parents=True, exist_ok=True)
        self._file = folder / RESULTS
        lines = self._file.read_text().splitlines() if self._file.exists() else []
        self.outcomes = [Outcome(**json.loads(line)) for line in lines]

    def has(self, trial: Trial, seed: int) -> bool:
        return any(one.key == (trial.vehicle, trial.name, seed) and not one.broke for one in self.outcomes)

    def add(self, outcome: Outcome, recording: str, rows: list[Row]) -> None:
        if recording:
            name = re.sub(r"[^a-z0-9]+", "_", f"{outcome.vehicle} {outcome.name} {outcome.seed}".lower())
            outcome.frames = f"recordings/{'lossy_' * (' >> ' in recording)}{name}.txt"
            (self.folder / "recordings").mkdir(exist_ok=True)
            (self.folder / outcome.frames).write_text(recording)
        if rows:
            keep_rows(rows, self.folder / f"readback_random_{outcome.vehicle}.csv")
        self.outcomes = [*(one for one in self.outcomes if one.key != outcome.key), outcome]
        with open(self._file, "a") as file:
            file.write(json.dumps(asdict(outcome)) + "\n")


class Runner:
    """Runs trials; `start(vehicle, folder)` gives a simulator, which has a folder for itself."""

    def __init__(self, start: Callable[[str, Path], Simulator], kept: Kept, clock: Any = time.monotonic) -> None:
        self._start, self.kept, self._clock = start, kept, clock

    def run(self, trials: list[Trial], seeds: list[int], minutes: float | None) -> Iterator[tuple[Outcome, int, int]]:
        """Each outcome, how many trials are done, and of how many; those that are kept already are left out."""
        todo = [(trial, seed) for seed in seeds for trial in trials if not self.kept.has(trial, seed)]
        total, until = len(seeds) * len(trials), self._clock() + 60 * (minutes or float("inf"))
        for number, (trial, seed) in enumerate(todo, start=total - len(todo) + 1):
            if self._clock() >= until:
                return
            yield self._one(trial, seed), number, total

    def _one(self, trial: Trial, seed: int) -> Outcome:
        outcome = Outcome(trial.name, trial.kind, trial.vehicle, seed)
        began, folder = self._clock(), Path(tempfile.mkdtemp(prefix="field_"))
        recording, rows, world = "", [], None
        try:
            world = World(self._start(trial.vehicle, folder), zlib.crc32(f"{trial.name} {seed}".encode()))
            world.begin(trial.kind in ("flights", "examples") or getattr(trial.row, "to_fly", False))
            outcome.version, outcome.clock = f"{trial.vehicle} {world.truth.version()}", world.simulator.clock
            result = Result(trial.name, trial.vehicle)
            rows = self._play(world, trial, result, random.Random(f"{trial.name} {seed}"))
            outcome.status, outcome.contradictions, outcome.notes = result.status, result.wrong, result.notes
            outcome.fakes_differ = list(fakes_differ(rows, trial.vehicle, outcome.version))
        except Exception as error:  # whatever breaks one trial must not end the others: the report tells of it
            outcome.broke = f"{type(error).__name__}: {error}"
        finally:
            if world is not None:
                outcome.simulated_s = round(world.now, 1)
                recording = world.recording()
                world.simulator.close()
            shutil.rmtree(folder, ignore_errors=True)
        outcome.took_s = round(self._clock() - began, 1)
        self.kept.add(outcome, recording, rows)
        return outcome

    @staticmethod
    def _play(world: World, trial: Trial, result: Result, chance: random.Random) -> list[Row]:
        row = trial.row
        if trial.kind in ("flights", "examples"):
            Flight(world, row, result, chance).fly() if trial.kind == "flights" else play_printed(world, row, result)
            return []
        if row is not None:
            row.prepare(world.wire, world.truth)
        world.power_on(build_firmware(SOURCE.stem, [SOURCE]))
        world.run(FOUND_S)
        if row is None:
            return play_items(world, world.truth, chance, result, ROUNDS)
        perform(world, row, world.truth, result, chance)
        return []
