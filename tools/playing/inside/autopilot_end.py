"""The autopilot's end of the Mega's line as the page's worker runs it: the wire, the autopilot, and what to show.

JavaScript calls it in simulated time, slice by slice: step() takes the bytes that the Mega has sent and gives those
that arrive there; news() says in JSON what there is to show. It draws nothing and knows no page.
"""

from __future__ import annotations

import functools
import json
import math
import re
import tempfile
import traceback
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from demonstration.autopilots import KINDS, NAMES, an_autopilot, one_to_fly
from demonstration.conversation import NOT_SHOWN, SHOWN, Conversation, file_created
from demonstration.line import Line
from demonstration.timeline import label
from demonstration.words import item_in_words, message_in_words
from simulation.fake_autopilot import FENCE, MISSION, RALLY, Item
from simulation.fake_autopilot.vehicles import VEHICLES
from simulation.wire import Entry

from .interference import (
    battery_is_low,
    is_pilots,
    other_station_uploads,
    pilot_lands,
    pilot_turns_the_switch,
    station_orders,
)

UPTIME_S = 60.0  # the autopilot has been on for so long: it can be armed
VEHICLE_EVERY_S = 0.1
SILENCE_S = 3.0  # of an autopilot that is restarted
NEXT = {">": "the Mega", "<": "the autopilot"}
INTERFERENCES = {"pilot": pilot_turns_the_switch, "lands": pilot_lands, "battery": battery_is_low,
         "station": other_station_uploads, "order": station_orders}  # fmt: skip
# What a message of tools/plan says of its own options, which the page has not.
OPTION = re.compile(r"[,;] (or say )?--[a-z].*$")

# custom_mode's main and sub mode of PX4, by the names in its own list.
PX4_MODES = {1: "MANUAL", 2: "ALTCTL", 3: "POSCTL", (4, 2): "TAKEOFF", (4, 3): "HOLD", (4, 4): "MISSION", (4, 5): "RTL",
             (4, 6): "LAND", 5: "ACRO", 6: "OFFBOARD", 7: "STABILIZED"}  # fmt: skip

PX4 = 12  # HEARTBEAT.autopilot
# HEARTBEAT.type, by the names of the imitated vehicles.
KIND_OF = {1: "plane", 10: "rover", 11: "rover"}


class Sent(NamedTuple):
    """A byte from the Mega, and the cycle at which its stop bit was over."""

    left: int
    byte: int


class Port(NamedTuple):
    """What the line asks of the Mega's port."""

    hz: int
    baud: float


class Outside:
    """In the place of the autopilot: one that is not the tests' own, behind a serial port or in the browser."""

    def __init__(self) -> None:
        self.said: dict[str, Any] = {}  # the latest message of each type
        self.outbox: list[tuple[float, bytes]] = []
        self.log: list = []
        self.to_port = bytearray()
        self._from_port = bytearray()

    def hear(self, data: bytes) -> None:
        """Bytes that the port has received."""
        self._from_port += data

    def receive(self, data: bytes, now: float) -> None:
        self.to_port += data

    def vehicle(self) -> dict | None:
        """The aircraft as it was told; None if that is not known yet."""
        beat, place = self.said.get("HEARTBEAT"), self.said.get("GLOBAL_POSITION_INT")
        if beat is None or place is None:
            return None
        current = self.said.get("MISSION_CURRENT")
        return {"lat": place.lat, "lon": place.lon, "height": round(place.relative_alt / 1000, 2),
                "armed": bool(beat.base_mode & 128), "mode": self._mode(beat),
                "item": current and current.seq}  # fmt: skip

    @staticmethod
    def _mode(beat: Any) -> str:
        if beat.autopilot == PX4:
            main, sub = beat.custom_mode >> 16 & 255, beat.custom_mode >> 24
            return PX4_MODES.get((main, sub)) or PX4_MODES.get(main, "other")
        modes = VEHICLES[KIND_OF.get(beat.type, "copter")].modes
        return next((name for name, mode in modes.items() if mode == beat.custom_mode), f"mode {beat.custom_mode}")

    def run(self, now: float) -> bytes:
        data = bytes(self._from_port)
        self._from_port.clear()
        self.outbox = [(now, data)] if data else []
        return data


class AutopilotEnd:
    """One run: from the Mega's power-on."""

    def __init__(self, settings: str) -> None:
        """settings: JSON with autopilot ("ardupilot", "px4" or "outside"), loss and bytes [percent], seed, arms (the
        sketch does) and, if there is a plan to hold or a place to stand at, held (a list of items) and home [1e-7
        degrees, m]."""
        wanted = json.loads(settings)
        self.name: str = wanted["autopilot"]
        self.autopilot: Any = self._made(wanted)
        if wanted.get("held"):
            self.autopilot.load([item_of(values) for values in wanted["held"]])
        port = Port(wanted["hz"], 57600.0)
        late_ms = wanted.get("latency", 0)
        self._line = Line(self.autopilot, port, seed=wanted["seed"], latency_ms=late_ms)  # type: ignore[arg-type]
        self._now = 0.0
        self._events: list[dict] = []  # what was done to the line or to an end of it
        self.shown_crossed = 0  # frames that are shown, and have crossed the line
        self.lose(wanted["loss"], wanted["bytes"])
        self._conversation = Conversation()
        self._frames: list[tuple[Entry, dict]] = []  # frames of which some bytes are still on the line
        self._crossed: list[dict] = []
        self._plans: dict[int, list] = {}
        self._progress: dict[str, Any] = {}
        self._told_items: dict[int, int] = {}  # by kind: how many of the items that were sent are known to the page
        self._vehicle_at = -math.inf
        self._vehicle: dict | None = None
        self._told_read = False

    def _made(self, wanted: dict) -> Any:
        if self.name == "outside":
            return Outside()
        options: dict[str, Any] = {"uptime_s": UPTIME_S}
        if wanted.get("home"):
            lat, lon, altitude = wanted["home"]
            options["home"] = (int(lat), int(lon), float(altitude))
        # What was recorded on the ground would say so of one that flies.
        return one_to_fly(self.name, **options) if wanted.get("arms") else an_autopilot(self.name, **options)

    # Driven by the page

    def step(self, now: float, data: bytes, left: Sequence[int], baud: float) -> bytes:
        """The Mega has run until now [s] and has sent these bytes; what arrives there next."""
        if baud != self._line._port.baud:
            self._line._port = self._line._port._replace(baud=baud)  # type: ignore[attr-defined]
        self._now = now
        sent = [Sent(int(cycle), byte) for cycle, byte in zip(left, bytes(data), strict=True)]
        self._line.hear(sent)  # type: ignore[arg-type]
        self._line.step(now)
        arriving = self._line.read(1 << 20)
        self._note()
        if now >= self._vehicle_at + VEHICLE_EVERY_S:
            self._vehicle_at = now
            self._look(now)
        return arriving

    def lose(self, frames: float, some_bytes: float) -> None:
        """From now on so many percent of the frames and of the bytes, each way."""
        wire = self._line.wire
        wire.spare()
        for direction in "><":
            wire.at_random(direction, lose=frames)
        wire.damage_bytes(lose=some_bytes)

    def cable(self, joined: bool) -> None:
        if joined:
            self._line.wire.plug()
        else:
            self._line.wire.pull()
        self._note_event("the cable is joined" if joined else "the cable is pulled", cut=not joined)

    def _note_event(self, words: str, **more: bool | str) -> None:
        self._events.append({"at": self._now, "words": words, **more})

    def lose_next(self, name: str) -> None:
        """The next frame of this name from the autopilot does not arrive; of ">" or "<", the next that is shown."""
        if name in NEXT:
            self._line.wire.lose(name, where=self._is_next_shown)
            self._note_event(f"the next frame of {NEXT[name]} will be lost", awaits=name)
        else:
            self._line.wire.lose("<", name=name)
            shown = name.rstrip("*")
            self._note_event(f"the next {shown} of the autopilot will be lost", awaits=shown)

    @staticmethod
    def _is_next_shown(message: Any) -> bool:
        return message is not None and message.get_type().startswith(SHOWN) and message.get_type() not in NOT_SHOWN

    def latency(self, milliseconds: float) -> None:
        """From now on all takes so much longer, each way."""
        self._line.wire.set_latency(milliseconds / 1000)
        self._note_event(f"from now on all takes {milliseconds:g} ms longer")

    def interfere(self, who: str) -> None:
        """Somebody else has a hand in it, by its name in INTERFERENCES."""
        if self.name != "outside":
            self._note_event(INTERFERENCES[who](self.autopilot, self._now))

    def mega_restarts(self) -> None:
        self.forget_talk()
        self._note_event("the Mega is restarted")

    def restart(self, now: float) -> None:
        """Switch the autopilot off and on: what was being transferred is forgotten, the stored plan is kept."""
        if self.name != "outside":
            self.autopilot.reboot(now, SILENCE_S)
            self._note_event("the autopilot is restarted")

    def forget_talk(self) -> None:
        """The Mega was restarted: what it transfers from now on is another transfer."""
        self._conversation = Conversation()
        self._progress.clear()
        self._told_items.clear()
        self._told_read = False

    def hear_outside(self, data: bytes) -> None:
        self.autopilot.hear(bytes(data))

    def take_for_outside(self) -> bytes:
        data = bytes(self.autopilot.to_port)
        self.autopilot.to_port.clear()
        return data

    # What there is to show

    def _note(self) -> None:
        for entry in self._line.seen():
            if self.name == "outside" and entry.direction == "<" and entry.message is not None:
                self.autopilot.said[entry.message.get_type()] = entry.message
            self._begin_anew(entry)
            again = self._conversation.add(entry)
            shown = self._conversation.is_shown(entry)
            self._frames.append((entry, {
                "at": entry.time, "way": entry.direction, "lost": entry.fate, "again": again,
                "text": message_in_words(entry.message, entry.data) if shown else "",
                "label": label(entry.message, entry.data) if shown else "", "hex": entry.data.hex(),
            }))  # fmt: skip
        times = {id(crossed.entry): crossed for crossed in self._line.crossed}
        waiting = []
        for entry, frame in self._frames:
            crossed = times.get(id(entry))
            if crossed is None:
                waiting.append((entry, frame))
            else:
                self._crossed.append({**frame, "began": crossed.began, "ended": crossed.ended})
                self.shown_crossed += bool(frame["text"])
        self._frames = waiting
        self._line.forget()
        self.autopilot.log.clear()

    def _begin_anew(self, entry: Entry) -> None:
        """Of a plan that is aboard, and is now sent again or changed, the items are those that are sent from now on."""
        message, talk = entry.message, self._conversation
        file = file_created(message) if message is not None else None
        kind = getattr(message, "mission_type", MISSION) if file is None else file
        if entry.direction != ">" or message is None or kind not in talk.told:
            return
        if message.get_type() == "MISSION_COUNT" or file is not None:
            first, last = 0, 1 << 16
            talk.aboard[kind] = 0
        elif message.get_type() == "MISSION_WRITE_PARTIAL_LIST":
            first, last = message.start_index, message.end_index
        else:
            return
        talk.told.discard(kind)
        talk.items = {key: item for key, item in talk.items.items() if key[0] != kind or not first <= key[1] <= last}
        self._told_items[kind] = min(first, self._told_items.get(kind, 0))

    def _look(self, now: float) -> None:
        talk = self._conversation
        for kind, count in talk.counts.items():
            if kind in KINDS:
                self._progress[KINDS[kind]] = self._progress_of(kind, count)
        if self.name == "outside":
            self._vehicle = self.autopilot.vehicle()
            return
        place = self.autopilot.flight.where(now)
        self._vehicle = {
            "lat": place.lat_e7, "lon": place.lon_e7, "height": round(place.height, 2), "armed": self.autopilot.armed,
            "mode": self._mode(), "item": self.autopilot.flight.index, "pilots": is_pilots(self.autopilot),
        }  # fmt: skip

    def _progress_of(self, kind: int, count: int) -> dict:
        """How far a transfer has come; of the items that the Mega has sent only those that the page does not know."""
        talk = self._conversation
        before = self._progress.get(KINDS[kind], {}).get("sent", [])
        known = self._told_items.get(kind, 0)
        new = []
        while (kind, known) in talk.items and known < count:
            new.append(shown_item(known, talk.items[kind, known]))
            known += 1
        self._told_items[kind] = known
        return {"announced": count, "arrived": min(talk.aboard[kind], count), "told": kind in talk.told,
                "sent": before + new}  # fmt: skip

    def _mode(self) -> str:
        autopilot = self.autopilot
        if self.name == "ardupilot":
            return autopilot.mode
        return PX4_MODES.get((autopilot.main_mode, autopilot.sub_mode)) or PX4_MODES.get(autopilot.main_mode, "other")

    def news(self) -> str:
        """What is new since the last call, in JSON; "" if nothing is."""
        new: dict[str, Any] = {}
        if self._crossed:
            new["frames"], self._crossed = self._crossed, []
        if self._vehicle is not None and self.name != "outside":  # as often as the vehicle is looked at
            for kind in (MISSION, FENCE, RALLY):
                held = [shown_item(seq, item) for seq, item in enumerate(self.autopilot.plan(kind))]
                if held != self._plans.get(kind, []):
                    self._plans[kind] = held
                    new.setdefault("held", {})[KINDS[kind]] = held
        if self._vehicle is not None:
            new["vehicle"], self._vehicle = self._vehicle, None
        if self._progress:
            new["progress"], self._progress = self._progress, {}
        if self._events:
            new["events"], self._events = self._events, []
        talk = self._conversation  # of a plan that the Mega reads
        if talk.thanked and not talk.counts and not self._told_read:
            new["read"] = self._told_read = True
        return json.dumps(plain(new)) if new else ""

    def verdict(self, meant: str) -> str:
        """Whether what is aboard is what was meant: JSON of {good, sentence}, and replaced if what the Mega put aboard
        is not there any more. meant: JSON, kind -> its items on the wire and their words; of a kind that is not in it,
        what was sent is what was meant."""
        name = NAMES.get(self.name, "the autopilot")
        talk = self._conversation
        if not talk.counts:
            return json.dumps({"good": False, "sentence": ""})
        if self.name == "outside":
            good = talk.told >= set(talk.counts)
            accepted = f"The autopilot has accepted all {sum(talk.counts.values())} items."
            return json.dumps({"good": good, "knows": good, "sentence": accepted if good else talk.last_word()})
        wanted = {int(kind): [item_of(values) for values, _ in items] for kind, items in json.loads(meant).items()}
        total = 0
        for kind in wanted.keys() | talk.counts.keys():
            if kind not in talk.counts:
                return json.dumps({"good": False, "sentence": ""})
            sent = [talk.items[kind, seq] for seq in range(talk.counts[kind]) if (kind, seq) in talk.items]
            items = wanted.get(kind, sent)
            total += len(items)
            aboard = self.autopilot.received(kind)
            differing = sum(not a.same_as(b) for a, b in zip(items, aboard, strict=False))
            differing += abs(len(items) - len(aboard))
            if kind in talk.told and len(sent) == talk.counts[kind] and not same(sent, aboard):
                return json.dumps({"good": False, "replaced": True, "sentence": self._in_its_place(kind, len(aboard))})
            if len(sent) < talk.counts[kind] or differing or talk.aboard[kind] < talk.counts[kind]:
                return json.dumps({"good": False, "sentence": talk.last_word()})
        knows = talk.told >= set(talk.counts) or talk.thanked
        told = "and the Mega knows it" if knows else "which the Mega has not been told yet"
        sentence = f"All {self._counted(total, MISSION in talk.counts)} are aboard {name} as they were meant, {told}."
        return json.dumps({"good": True, "knows": knows, "sentence": sentence})

    def _in_its_place(self, kind: int, count: int) -> str:
        name = NAMES.get(self.name, "the autopilot")
        if not count:
            return f"What the Mega put aboard {name} is not there any more."
        plan = "Another plan" if kind == MISSION else f"Another {KINDS[kind]}"
        items = self._counted(count, kind == MISSION)
        return f"{plan} is aboard {name} now: {items}, which are not those that the Mega put there."

    def _counted(self, count: int, is_plan: bool) -> str:
        """Items as the sketch counts them: ArduPilot's plan has home in front."""
        return f"{count - 1} items and home" if is_plan and self.name == "ardupilot" else f"{count} items"


def same(some: Sequence[Item], others: Sequence[Item]) -> bool:
    return len(some) == len(others) and all(a.same_as(b) for a, b in zip(some, others, strict=True))


def item_of(values: Iterable) -> Item:
    return Item._make(math.nan if value is None else value for value in values)


@functools.lru_cache(maxsize=4096)
def shown_item(seq: int, item: Item) -> dict:
    """As the page has it; the same object for the same item."""
    return {"seq": seq, "command": item.command, "frame": item.frame, "x": item.x, "y": item.y, "z": item.z,
            "param1": item.param1, "words": item_in_words(item)}  # fmt: skip


def plain(value: Any) -> Any:
    """As JSON has it: a number that is none becomes null."""
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    if isinstance(value, dict):
        return {key: plain(one) for key, one in value.items()}
    if isinstance(value, list | tuple):
        return [plain(one) for one in value]
    return value


def plan_of(name: str, data: bytes) -> str:
    """A .plan or .waypoints file, dropped onto the page: JSON of {waypoints, items, places, home, notes, files},
    or of {error}, with files where it is a plan that PlanConsole cannot store. places: where each item stands in the
    file, in words. files: what files_of() gives, and errors in words."""
    with tempfile.TemporaryDirectory() as folder:
        return json.dumps(plain(_plan_in(Path(folder) / (Path(name).name or "dropped"), bytes(data))))


def _plan_in(file: Path, data: bytes) -> dict:
    from planning import BadPlan, read_plan

    from .drawn import files_of

    def in_words(error: BadPlan) -> str:
        return OPTION.sub("", str(error).replace(str(file), file.name))

    try:
        file.write_bytes(data)
        plan = read_plan(file)
        texts, errors = files_of(plan)
        files = {**texts, "errors": {form: in_words(error) for form, error in errors.items()}}
        if "waypoints" not in texts:
            return {"error": in_words(errors["waypoints"]), "files": files}
        left_out = [kind for kind in plan.kinds if kind != "mission"]
        # That a number which nothing uses is not set is no matter here.
        notes = [
            *(note for note in plan.notes if "unset" not in note),
            *(f"the {kind} is left out" for kind in left_out),
        ]
        items = [shown_item(seq, Item._make(step.item)) for seq, step in enumerate(plan.mission)]
        home = list(plan.home) if plan.home is not None else None
        places = [f"{file.name}:{step.line}: {step.name}" for step in plan.mission]
        return {"waypoints": texts["waypoints"], "items": items, "places": places, "home": home, "notes": notes,
                "files": files}  # fmt: skip
    except BadPlan as error:
        return {"error": in_words(error)}
    except Exception:
        # The page must go on, and whoever drops a strange file must be told something.
        traceback.print_exc()
        return {"error": f"{file.name} cannot be read as a plan"}
