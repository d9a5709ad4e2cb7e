"""The run itself: build, simulate, show, compare, judge."""

from __future__ import annotations

import itertools
import math
import time
import tomllib
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from _command import explained
from building import BuildFailed, build_sketch
from planning import judge
from simulation.enumerators import texts_of
from simulation.fake_autopilot import FENCE, MISSION, RALLY, Item, Px4
from simulation.fake_autopilot.flight import Place
from simulation.fake_autopilot.px4 import AUTO, SUB_RTL
from simulation.mega import Mega
from simulation.mega import library as mega_library
from simulation.mega.realtime import RealTime
from simulation.wire import Entry

from .asked import NoDemonstration, sketch
from .autopilots import HELD, KINDS, NAMES, an_autopilot, one_to_fly
from .conversation import Conversation
from .line import Line as SerialLine
from .named_frames import NamedFrame
from .picture import draw
from .plan_in_firmware import NotOnePlan, Plan, plan_in
from .screen import Line, Row
from .telemetry_log import TelemetryLog
from .timeline import joined, laid_out, mark_of
from .wire_form import on_the_wire
from .words import item_in_words, message_in_words

# The commands of a plan that lead to a place, and all that are flown.
PLACES = (16, 17, 18, 19, 31, 82)
FLOWN = range(16, 93)
RETURN = 20

DESCRIPTIONS = Path(__file__).resolve().parent / "examples.toml"

LIMIT_S = 120.0
# What a sketch says of an upload that the library refuses, and how long it may take to say which item it is.
REFUSALS = tuple(text for text in texts_of("Status.h", "MAVMISSION_STATUSES").values() if text.startswith("refused: "))
REFUSED_AFTER_S = 0.3
FLIGHT_LIMIT_S = 300.0
LANDED_S = 15.0  # how long a flight of an example goes on behind a landing: another leg may follow
OWN_LANDED_S = 60.0  # and that of a sketch, whose work there may take longer
MOVED_M = NEAR_HOME_M = 1.0
MOST_PLACES = 12  # that are listed; one that follows a target is told a place five times a second


@dataclass(frozen=True)
class Settings:
    """What to show, and how."""

    example: str = "UploadMission"  # of examples/, or the path of a sketch
    autopilot: str = "ardupilot"  # or "px4"
    loss_percent: float = 0.0  # of the frames, in each direction
    byte_loss_percent: float = 0.0  # of the bytes, in each direction
    latency_ms: float = 0.0  # of the line, in each direction
    seed: int = 0
    lose: tuple[NamedFrame, ...] = ()
    log: Path | None = None
    timeline: Path | None = None  # an SVG
    fast: bool = False  # as fast as can be, instead of in real time
    vehicle: str = "copter"  # or "plane", "quadplane" or "rover", on ArduPilot
    fly_s: float | None = None  # it is judged by what the vehicle does in this time [simulated s]; 0: the usual one
    described: dict | None = None  # what examples.toml would say of the sketch


@dataclass(frozen=True)
class Verdict:
    """How it ended. `good` only when every item aboard is the plan that was meant; of a flight, when it has landed."""

    good: bool
    sentence: str


class Demonstration:
    """One run of one example."""

    def __init__(self, settings: Settings, screen) -> None:
        self.settings = settings
        self._screen = screen
        described = settings.described or description(settings.example)
        self._flies: bool = settings.fly_s is not None or described.get("flies", False)
        self._limit_s: float = settings.fly_s or (
            FLIGHT_LIMIT_S if self._flies else described.get("runs_s") or described.get("limit_s", LIMIT_S)
        )
        self._landed_s = LANDED_S if settings.fly_s is None else math.inf if settings.fly_s else OWN_LANDED_S
        self._visited: list[Place] = []
        self._disarmed_at: float | None = None
        self._was_armed = self._has_moved = False
        self._item: int | None = None  # of the plan, being flown
        self._left_out = 0  # items of the plan that were not flown
        self._uploads = not self._flies and not described.keys() & {"runs_s", "reads"}
        self._reads: bool = described.get("reads", False)
        folder = sketch(settings.example)
        try:
            with compiled_meanwhile():
                built = build_sketch(folder, strict=False)
            self._plans = plans_of(built.elf, described) if self._uploads else {}
        except (BuildFailed, NotOnePlan) as error:
            raise NoDemonstration(str(error)) from error
        for line in built.warnings:
            screen.say(line)
        if self._flies:
            self.autopilot = one_to_fly(settings.autopilot, settings.vehicle)
        else:
            self.autopilot = an_autopilot(settings.autopilot, settings.vehicle)
        if self._reads:
            self.autopilot.load(on_the_wire(HELD, settings.autopilot))
        self._mega = Mega(built.elf)
        self._line = SerialLine(
            self.autopilot, self._mega.serial(1), settings.loss_percent, settings.seed, settings.lose,
            settings.byte_loss_percent, settings.latency_ms,
        )  # fmt: skip
        self._remarks: dict[int, tuple[bool, bool]] = {}  # by the entry's id(): is it shown, was it said before
        self._console = Console(self)
        self.said: list[str] = []  # the lines of the sketch's Serial
        self._refused_at: float | None = None
        self._conversation = Conversation()
        self._meant: dict[int, list[Item]] = {}  # by mission type, as the sketch has them
        self._log: TelemetryLog | None = None

    @property
    def now(self) -> float:
        """Since the Mega was switched on [simulated s]."""
        return self._mega.now_us / 1_000_000

    def run(self) -> Verdict:
        """Show it all, until the upload has ended."""
        self._introduce()
        began_at = time.time()
        if self.settings.log is not None:
            try:
                self._log = TelemetryLog(self.settings.log, began_at)
            except OSError as error:
                raise NoDemonstration(f"cannot write {self.settings.log}: {error.strerror}") from error
        world = RealTime(self._mega, **self._pace())
        world.connect(0, self._console)
        world.connect(1, self._line, tap=self._line.hear)
        try:
            while not self._is_over():
                self._line.step(self.now)
                self._show()
                self._watch()
                world.slice()
            self._line.step(self.now)
            self._show()
        finally:
            world.close()
            if self._log is not None:
                self._log.close()
        self._console.flush()
        verdict = self._conclude()
        for named in self.settings.lose:
            if not named.was_lost:
                self._screen.say(f"--lose {named.text}: no such frame was sent, and so none was lost")
        if self.settings.timeline is not None:
            self._draw(self.settings.timeline, verdict)
        return verdict

    # -- before ---------------------------------------------------------------------------

    def _introduce(self) -> None:
        name = Path(self.settings.example).stem
        self._screen.say(
            f"{name} on a simulated Mega, Serial1 to a simulated {NAMES[self.settings.autopilot]}{self._losses()}"
        )
        for kind, plan in self._plans.items():
            where = "RAM" if plan.in_ram else "flash"
            self._screen.say(f"its {KINDS[kind]}: {plan.name}, {plan.count} items in {where}")
        if self._uploads and not self._plans:
            self._screen.say("its plan comes from a function: what it sends is what it means")

    def _losses(self) -> str:
        loss = f", {self.settings.loss_percent:g} % of the frames lost each way" if self.settings.loss_percent else ""
        if self.settings.byte_loss_percent:
            loss += f", {self.settings.byte_loss_percent:g} % of the bytes lost each way"
        if self.settings.latency_ms:
            loss += f", {self.settings.latency_ms:g} ms each way"
        return loss + "".join(f", {named.text} lost" for named in self.settings.lose)

    def _pace(self) -> dict:
        if not self.settings.fast:
            return {}
        return {"clock": lambda: self.now, "sleep": lambda seconds: None}

    # -- meanwhile ------------------------------------------------------------------------

    def _show(self) -> None:
        for entry in self._line.seen():
            if self._log is not None and not entry.fate and entry.number is not None:
                self._log.add(entry.data, entry.time)
            self._hear(entry)

    def _hear(self, entry: Entry) -> None:
        talk = self._conversation
        again = talk.add(entry)
        for kind in talk.counts.keys() & self._plans.keys() - self._meant.keys():
            self._meant[kind] = self._plans[kind].items(self._mega.peek)
        shown = talk.is_shown(entry)
        self._remarks[id(entry)] = shown, again
        if shown:
            where = "Mega -> autopilot" if entry.direction == ">" else "autopilot -> Mega"
            mark = "lost" if entry.fate else "again" if again else ""
            text = message_in_words(entry.message, entry.data)
            self._screen.happened(Line(entry.time, where, text, mark))
        if total := sum(talk.counts.values()):
            self._screen.progress(sum(talk.aboard.values()), total)

    def _watch(self) -> None:
        """What the vehicle does, for a flight: whoever flies it, and whatever the sketch says of it."""
        if not self._flies:
            return
        flight, now = self.autopilot.flight, self.now
        here = flight.where(now)
        self._has_moved |= here.distance(flight.home) > MOVED_M
        if flight.target is not None and here.distance(flight.target) < 0.1:
            self._visit(here)
        if self.autopilot.armed:
            self._was_armed, self._disarmed_at = True, None
            if flight.index is not None and flight.index != self._item:
                plan = self.autopilot.plan()
                if self._item is not None and self._item < len(plan) and plan[self._item].command in PLACES:
                    self._visit(here)
                self._item = flight.index
            elif flight.index is None and self._is_returning():
                self._item = self._return_behind(self._item)
        elif self._was_armed and self._disarmed_at is None:
            self._disarmed_at = now
            self._left_out += self._items_behind(self._item)
            self._item = None

    def _visit(self, here: Place) -> None:
        home = self.autopilot.flight.home
        is_elsewhere = here._replace(height=home.height).distance(home) > MOVED_M  # not above home
        if is_elsewhere and (not self._visited or self._visited[-1].distance(here) > MOVED_M):
            self._visited.append(here)

    def _is_returning(self) -> bool:
        """PX4 and a plane carry out a plan's return by their mode."""
        if isinstance(self.autopilot, Px4):
            return (self.autopilot.main_mode, self.autopilot.sub_mode) == (AUTO, SUB_RTL)
        return getattr(self.autopilot, "mode", "") == "RTL"

    def _return_behind(self, last: int | None) -> int | None:
        """The next item that is flown behind this one, if it is a return; else this one."""
        plan = self.autopilot.plan()
        behind = [] if last is None else [at for at in range(last + 1, len(plan)) if plan[at].command in FLOWN]
        return behind[0] if behind and plan[behind[0]].command == RETURN else last

    def _items_behind(self, last: int | None) -> int:
        """How many items that are flown lie behind this one of the plan."""
        return 0 if last is None else sum(item.command in FLOWN for item in self.autopilot.plan()[last + 1 :])

    def console_line(self, text: str) -> None:
        self.said.append(text)
        if text.strip() in REFUSALS and self._refused_at is None:
            self._refused_at = self.now
        self._screen.happened(Line(self.now, "Serial", text))

    def _is_over(self) -> bool:
        is_refused = self._refused_at is not None and self.now >= self._refused_at + REFUSED_AFTER_S
        if self._flies:
            has_landed = self._disarmed_at is not None and self.now >= self._disarmed_at + self._landed_s
            return has_landed or self.now >= self._limit_s
        return is_refused or self.now >= self._limit_s or self._conversation.is_over(self.now)

    @property
    def refusal(self) -> str:
        """Why the library did not send what the sketch asked it to, and of which item, as the sketch said it; or ""."""
        for number, line in enumerate(self.said):
            if line.strip() in REFUSALS:
                behind = self.said[number + 1].strip() if number + 1 < len(self.said) else ""
                return line.strip() + (f" ({behind})" if behind.startswith("item ") else "")
        return ""

    # -- after ----------------------------------------------------------------------------

    def _conclude(self) -> Verdict:
        talk = self._conversation
        self._screen.say(f"beside these: {talk.others['HEARTBEAT']} heartbeats, {talk.telemetry} frames of telemetry")
        name = NAMES[self.settings.autopilot]
        if self._flies:
            return self._conclude_flying(name)
        if self._reads:
            return self._conclude_reading(name)
        if self._uploads and self.refusal:
            return Verdict(False, f"FAILED: the library did not send the plan to {name}. {self.refusal}.")
        if not self._uploads:
            return Verdict(True, f"The sketch ran for {self.now:.0f} s; there was nothing to upload.")
        kinds = sorted(self._plans) or sorted(talk.counts)
        if not kinds or not talk.counts.keys() >= set(kinds):
            return Verdict(False, f"FAILED: in {self.now:.0f} s the sketch began no upload{of_kinds(kinds, talk)}.")
        items = 0
        for kind in kinds:
            meant = self._meant_on_the_wire(kind)
            items += len(meant)
            were, them = ("were", "them") if kind == RALLY else ("was", "it")
            self._screen.say(f"the {KINDS[kind]} that {were} meant, as {name} must get {them}, and what it holds:")
            rows = compared(meant, self.autopilot.received(kind))
            self._screen.compare(rows)
            held = len(self.autopilot.plan(kind))
            if wrong := sum(row.differs for row in rows):
                return Verdict(False, f"FAILED: {wrong} of {len(rows)} items differ. {talk.last_word()}")
            if held != len(meant):
                return Verdict(False, f"FAILED: {name} says that it holds {held} items, not {len(meant)}.")
        if talk.contradictions:
            return Verdict(False, f"FAILED: {talk.contradictions[0]}")
        aboard = f"The plan is aboard: all {items} items as they were meant"
        if talk.told >= set(kinds):
            return Verdict(True, f"{aboard}, and the Mega was told so.")
        return Verdict(True, f"{aboard}. {talk.last_word()}")

    def _conclude_reading(self, name: str) -> Verdict:
        talk = self._conversation
        held = len(self.autopilot.plan())
        if talk.delivered == set(range(held)) and talk.thanked:
            return Verdict(True, f"The Mega has read all {held} items that {name} holds.")
        return Verdict(False, f"FAILED: the Mega has read {len(talk.delivered)} of the {held} items that {name} holds.")

    def _conclude_flying(self, name: str) -> Verdict:
        flight, last = self.autopilot.flight, f' Its last words: "{self.said[-1]}".' if self.said else ""
        legs = [flight.home, *self._visited]
        for number, (one, other) in enumerate(itertools.pairwise(legs[: MOST_PLACES + 1]), start=1):
            away_m = one.distance(other)
            self._screen.say(f"place {number}: {away_m:.0f} m from the one before, {other.height:.1f} m up")
        if len(self._visited) > MOST_PLACES:
            self._screen.say(f"and {len(self._visited) - MOST_PLACES} more")
        here = flight.where(self.now)
        if not self._was_armed:
            return Verdict(False, f"FAILED: in {self.now:.0f} s the sketch has not armed {name}.{last}")
        if self.autopilot.armed or here.height > 0.1:
            armed = "armed" if self.autopilot.armed else "disarmed"
            return Verdict(
                False, f"FAILED: after {self.now:.0f} s {name} is still {armed}, {here.height:.1f} m up.{last}"
            )
        if not self._has_moved:
            return Verdict(False, f"FAILED: {name} was armed and disarmed again, and has not moved.{last}")
        if self._left_out:
            return Verdict(
                False, f"FAILED: {name} was disarmed before {self._left_out} items of its plan were flown.{last}"
            )
        home_m = here.distance(flight.home)
        where = "at home" if home_m < NEAR_HOME_M else f"{home_m:.0f} m from home"
        places = "1 place" if len(self._visited) == 1 else f"{len(self._visited)} places"
        return Verdict(True, f"{name} has been at {places}, and is disarmed on the ground {where}.")

    def _draw(self, file: Path, verdict: Verdict) -> None:
        """The run as a picture."""
        silent = (False, False)
        crossed = joined(self._line.crossed)
        marks = [mark_of(crossing, *self._remarks.get(id(crossing.entry), silent)) for crossing in crossed]
        title = f"{Path(self.settings.example).stem} to {NAMES[self.settings.autopilot]}{self._losses()}"
        try:
            draw(laid_out(marks), file, title, verdict.sentence)
        except OSError as error:
            raise NoDemonstration(f"the picture: {explained(error)}") from error
        except ValueError as error:
            raise NoDemonstration(f"cannot draw {file}: {error}") from error
        self._screen.say(f"drawn: {file}")

    def _meant_on_the_wire(self, kind: int) -> list[Item]:
        if kind not in self._plans:
            sent = self._conversation.items
            return [sent[kind, seq] for seq in range(self._conversation.counts[kind]) if (kind, seq) in sent]
        meant = self._meant.get(kind, [])
        if kind != MISSION:
            return meant
        return on_the_wire(meant, self.settings.autopilot, self.autopilot.vehicle_types[self.autopilot.vehicle])


class Console:
    """The sketch's Serial, line by line."""

    name = "the console"

    def __init__(self, demonstration: Demonstration) -> None:
        self._demonstration = demonstration
        self._line = bytearray()

    def read(self, most: int) -> bytes:
        return b""

    def write(self, data: bytes) -> None:
        self._line += data
        while b"\n" in self._line:
            line, _, self._line = self._line.partition(b"\n")
            self._demonstration.console_line(line.decode(errors="replace").rstrip("\r"))

    def flush(self) -> None:
        """Show a line that was begun and not ended."""
        if self._line:
            self.write(b"\n")

    def close(self) -> None:
        pass


@contextmanager
def compiled_meanwhile() -> Iterator[None]:
    """The simulator and the library's checks are compiled beside what is done within, where they are not yet; what is
    wrong with them is said when they are used."""
    with ThreadPoolExecutor() as workers:
        workers.submit(mega_library.compiled)
        workers.submit(judge.program)
        yield


def plans_of(elf: Path, described: dict) -> dict[int, Plan]:
    """What an example uploads, by mission type; nothing where it comes from a function."""
    named = {FENCE: described.get("fence"), RALLY: described.get("rally")}
    found = {kind: plan_in(elf, name) for kind, name in named.items() if name is not None}
    if not found or "plan" in described:
        found[MISSION] = plan_in(elf, described.get("plan"))
    return {kind: plan for kind, plan in found.items() if plan is not None}


def of_kinds(kinds: list[int], talk: Conversation) -> str:
    missing = [KINDS[kind] for kind in kinds if kind not in talk.counts]
    return f" of its {' and '.join(missing)}" if missing else ""


def description(example: str) -> dict:
    return tomllib.loads(DESCRIPTIONS.read_text()).get(Path(example).stem, {})


def compared(meant: list[Item], aboard: list[Item]) -> list[Row]:
    rows = []
    for number, (ours, theirs) in enumerate(itertools.zip_longest(meant, aboard)):
        left = item_in_words(ours) if ours else "(nothing)"
        right = item_in_words(theirs) if theirs else "(nothing)"
        same = ours is not None and theirs is not None and ours.same_as(theirs)
        if not same and left == right:  # words hide the last bits
            left, right = repr(ours), repr(theirs)
        rows.append(Row(number, left, left if same else right))
    return rows
