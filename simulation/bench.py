"""A bench: the library's firmware on a simulated Mega, a faulty wire, a fake autopilot, in lock step.

    bench = Bench("PX4")
    bench.upload(plan)                    # a list of fake_autopilot.Item
    bench.run_until_ended(limit_s=10)
    assert bench.status == "Accepted"
    assert bench.autopilot.received() == plan
    print(bench.transcript())

Time is simulated, in seconds since the Mega's power-on. A run is equal to the cycle each time.
"""

from __future__ import annotations

import math
import struct
from collections.abc import Iterable, Sequence
from functools import cache
from pathlib import Path
from typing import NamedTuple

from simulation.enumerators import texts_of
from simulation.fake_autopilot import ArduPilot, FakeAutopilot, Item, Px4, mavlink
from simulation.fake_autopilot.frames import packed as frame_of
from simulation.fake_autopilot.items import f32
from simulation.firmware import build_firmware
from simulation.mega import Image, Mega
from simulation.wire import Wire

SOURCE = Path(__file__).resolve().parent / "sketches" / "bench.cpp"

PERSONALITIES: dict[str, type[FakeAutopilot]] = {"ArduPilot": ArduPilot, "PX4": Px4}

SERIAL, AUTOPILOT_PORT = 0, 1
PROOFS = ("ByAnswer", "InDoubt", "Always")  # mavmission::Readback
PLAN_ITEMS = 60  # room in benchPlan
NO_ITEM = 0xFFFF
NO_RESULT = 255
# The firmware is looked at this often, while bytes move, if the autopilot's delay allows [s].
LONGEST_SLICE_S = 0.001
SHORTEST_SLICE_S = 0.0002
# What the firmware says on Serial is read this often, at the least, where it is waited for [s].
LISTENING_S = 0.02

_ITEM = struct.Struct("<4fiifHBBB")  # mavmission::MissionItem on AVR


@cache
def firmware_image(baud: int, *defines: tuple[str, object], source: Path = SOURCE) -> Image:
    return Image.load(build_firmware(source.stem, [source], {"BENCH_BAUD": baud, **dict(defines)}))


@cache
def status_names() -> tuple[str, ...]:
    return tuple(texts_of("Status.h", "MAVMISSION_STATUSES"))


@cache
def aboard_names() -> tuple[str, ...]:
    return tuple(texts_of("Status.h", "MAVMISSION_ABOARD"))


def is_end(status: str) -> bool:
    """As mavmission::isEnd()."""
    return status_names().index(status) > status_names().index("Transferring")


_EVENTS = ("began", "returned", "progress", "end", "restarted", "nested", "heard")


class Event(NamedTuple):
    """A line that the firmware said on Serial."""

    ms: int  # millis() on board
    word: str  # began, returned, progress, end, restarted
    numbers: tuple[int, ...]


class State(NamedTuple):
    """What the client's queries answer."""

    status: str
    busy: bool
    failed_item: int | None
    done: int
    total: int
    aboard: str
    last_result: int | None
    found: bool
    firmware: str
    address: tuple[int, int]
    armed: bool


class FunctionPlan(NamedTuple):
    """A plan that the firmware computes; see item_of_function_plan()."""

    count: int  # type: ignore[assignment]  # a tuple has a method of this name, which nobody calls here
    refused_item: int = NO_ITEM
    given_before: int = 0  # how often the refused item is given before it is refused


def item_of_function_plan(index: int) -> Item:
    """The same as itemOfFunctionPlan() in sketches/bench.cpp."""
    return Item(
        frame=3, command=16, current=0, autocontinue=int(index % 3 != 0),
        param1=float(index % 7), param2=f32(index * 0.25), param3=0.0, param4=float(10 + index % 350),
        x=473977880 + 37 * index, y=85456280 - 41 * index, z=f32(20.125 + index % 100),
    )  # fmt: skip


class Nobody:
    """Nothing at the other end of the line: what is said there, the test says with Bench.say()."""

    response_delay_s = 1.0
    address = (1, 1)

    def receive(self, data: bytes, now: float) -> None:
        pass

    def run(self, now: float) -> bytes:
        self.outbox: list[tuple[float, bytes]] = []
        return b""

    def next_event(self, now: float) -> float | None:
        return None


def fake(personality: str | None, baud: int, **options) -> FakeAutopilot | Nobody:
    """The autopilot at the end of a line of that speed, which the bench simulates too."""
    if personality is None:
        return Nobody()
    kind = PERSONALITIES[personality]
    filled = {"baud": baud, "response_delay_s": kind.response_delay_on_line_s, "heartbeat_at_s": 0.05,
              "uptime_s": 60.0, **options}  # fmt: skip
    return kind(**filled)


class Bench:
    """The three, joined.

    personality: "ArduPilot", "PX4", or None for a line where only say() speaks; or an
    autopilot that has been made already (fake() makes one). options: of the fake autopilot.
    defines: for the firmware. mega: a Mega that runs already.
    """

    source = SOURCE  # of the firmware

    def __init__(self, personality: str | FakeAutopilot | Nobody | None = "ArduPilot", *, baud: int = 57600,
                 defines: dict | None = None, wire: Wire | None = None, **options) -> None:  # fmt: skip
        self.mega = self._board(baud, defines or {})
        self.wire = wire or Wire()
        if personality is None or isinstance(personality, str):
            personality = fake(personality, baud, **options)
        self.autopilot: FakeAutopilot | Nobody = personality
        self.events: list[Event] = []
        self.ends: list[str] = []  # those that update() returned
        self.answers: list[str] = []
        self._text = b""
        self._packers: dict[tuple[int, int], mavlink.MAVLink] = {}
        self._slice_s = max(SHORTEST_SLICE_S, min(LONGEST_SLICE_S, 0.9 * self.autopilot.response_delay_s))
        self._ends_seen = 0
        self._run_until_answered("ready", limit_s=0.1)

    def _board(self, baud: int, defines: dict):
        return Mega(firmware_image(baud, *defines.items(), source=self.source))

    # Time

    @property
    def now(self) -> float:
        """[s] since power-on."""
        return self.mega.cycle / self.mega.hz

    def run(self, seconds: float) -> None:
        self.run_until(self.now + seconds)

    def run_until(self, time: float) -> None:
        while self.now < time:
            self._step(time)

    def run_until_ended(self, limit_s: float) -> str:
        """Go on until update() has returned how an operation has ended; the name of that status.

        Each end is waited for once: a second call waits for the next one.
        """
        limit = self.now + limit_s
        while len(self.ends) <= self._ends_seen:
            if self.now >= limit:
                raise AssertionError(f"nothing ended within {limit_s} s: it is {self.state}")
            self._step(min(limit, self.now + LISTENING_S))
        self._ends_seen += 1
        return self.ends[self._ends_seen - 1]

    def run_until_sent(self, name: str, count: int = 1, limit_s: float = 10.0) -> float:
        """Go on until so many messages of this name have left since power-on; when the last did [s]."""
        limit = self.now + limit_s
        while len(self._sent(name)) < count:
            assert self.now < limit, f"no {count} {name} within {limit_s} s"
            self._step(limit)
        return self._sent(name)[count - 1].time

    def _step(self, until: float) -> None:
        """Run to the next thing that happens, at most to `until` [s]."""
        mega = self.mega
        cycle = mega.cycle
        for time in (self.autopilot.next_event(cycle / mega.hz), self.wire.next_event()):
            if time is not None and time < until:
                until = time
        target = max(self._cycle(until), cycle + 1)
        if mega.run_until(target, stop_on=AUTOPILOT_PORT):
            # No answer can come within the autopilot's delay: gather what leaves meanwhile.
            mega.run_until(min(target, mega.cycle + self._cycle(self._slice_s)))
        self._exchange()

    def _cycle(self, time: float) -> int:
        return math.ceil(time * self.mega.hz)

    def _exchange(self) -> None:
        mega, wire, autopilot = self.mega, self.wire, self.autopilot
        for sent in mega.serial(AUTOPILOT_PORT).sent():
            time = sent.left / mega.hz
            wire.send(">", bytes((sent.byte,)), time)
            arriving = wire.deliver(">", time)
            if arriving:
                autopilot.receive(arriving, time)
        now = mega.cycle / mega.hz
        arriving = wire.deliver(">", now)
        if arriving:
            autopilot.receive(arriving, now)
        autopilot.run(now)
        for time, frame in autopilot.outbox:
            wire.send("<", frame, time)
        arriving = wire.deliver("<", now)
        if arriving:
            mega.serial(AUTOPILOT_PORT).send(arriving)
        self._read_lines()

    def _read_lines(self) -> None:
        said = self.mega.serial(SERIAL).sent_bytes()
        if not said:
            return
        self._text += said
        *lines, self._text = self._text.split(b"\r\n")
        for line in lines:
            words = line.decode().split(" ")
            if words[0].isdigit() and words[1] in _EVENTS:
                self._note(Event(int(words[0]), words[1], tuple(int(word) for word in words[2:])))
            else:
                self._take_line(line.decode())

    def _take_line(self, line: str) -> None:
        """One that is none of the events. What a sketch says unasked, its bench takes out here."""
        self.answers.append(line)

    def _note(self, event: Event) -> None:
        self.events.append(event)
        if event.word == "returned" and is_end(status_names()[event.numbers[0]]):
            self.ends.append(status_names()[event.numbers[0]])

    # Telling the firmware what to do

    def tell(self, *words) -> list[str]:
        """Say a line to the firmware, wait until it is done, and return what it answered."""
        before = len(self.answers)
        line = " ".join(str(int(word) if isinstance(word, bool) else word) for word in words)
        self.mega.serial(SERIAL).send(line.encode() + b"\n")
        self._run_until_answered("ok", limit_s=2.0)
        return self.answers[before:-1]

    def _run_until_answered(self, word: str, limit_s: float) -> None:
        before, limit = len(self.answers), self.now + limit_s
        while not self.answers[before:] or self.answers[-1] != word:
            assert "what?" not in self.answers[before:], "the firmware does not know this line"
            assert self.now < limit, f"the firmware did not say {word!r}"
            self.run(0.0002)

    def use(self, plan: Sequence[Item] | FunctionPlan | str) -> None:
        """Set the plan of the next upload: items for RAM, a FunctionPlan, "flash" or "empty"."""
        if isinstance(plan, FunctionPlan):
            self.tell("function", *plan)
        elif isinstance(plan, str):
            self.tell(plan)
        else:
            self.write_plan(plan)
            self.tell("ram", len(plan))

    def write_plan(self, plan: Sequence[Item]) -> None:
        """Put items into benchPlan, to the bit."""
        if len(plan) > PLAN_ITEMS:
            raise ValueError(f"benchPlan has room for {PLAN_ITEMS} items, not {len(plan)}: use a FunctionPlan")
        data = b"".join(packed(item) for item in plan)
        if data:
            self.mega.poke(self.mega.address("benchPlan"), data)

    def upload(self, plan: Sequence[Item] | FunctionPlan | str | None = None, proof: str = "ByAnswer") -> str:
        """Begin an upload (None: of the same plan again); the name of what upload() returned.

        proof: one of PROOFS; all but the first read the plan back.
        """
        if plan is not None:
            self.use(plan)
        self.tell("upload", PROOFS.index(proof))
        return status_names()[self._numbers("began")[-1][0]]

    def ensure(self, plan: Sequence[Item] | FunctionPlan | str) -> str:
        """Begin an ensure() of this plan, with BENCH_ENSURE; the name of what ensure() returned."""
        self.use(plan)
        self.tell("ensure")
        return status_names()[self._numbers("began")[-1][0]]

    def cancel(self) -> None:
        self.tell("cancel")

    def reset(self) -> None:
        """Press the Mega's reset button: all that it was told is forgotten, setup() has run. The line goes on.

        What had ended before is not waited for any more.
        """
        self.mega.reset()
        self._text = b""
        self._ends_seen = len(self.ends)
        self._run_until_answered("ready", limit_s=0.1)

    def set_millis(self, value: int) -> None:
        """Let millis() go on from there."""
        self.mega.poke_int("timer0_millis", value % 2**32, 4)

    # What the firmware said

    def _numbers(self, word: str) -> list[tuple[int, ...]]:
        return [event.numbers for event in self.events if event.word == word]

    @property
    def returned(self) -> list[str]:
        """What update() returned, each time that it changed, and each end."""
        return [status_names()[number] for (number,) in self._numbers("returned")]

    @property
    def ends_called_back(self) -> list[str]:
        return [status_names()[number] for (number,) in self._numbers("end")]

    @property
    def restarts(self) -> list[str]:
        """What upload() returned within the callback."""
        return [status_names()[number] for (number,) in self._numbers("restarted")]

    @property
    def progress(self) -> list[tuple[int, int]]:
        """(done, total) of each progress callback."""
        return [(done, total) for done, total in self._numbers("progress")]

    @property
    def state(self) -> State:
        (line,) = self.tell("state")
        words = line.split(" ")
        value = {key: int(number) for key, _, number in (word.partition("=") for word in words[3:])}
        return State(
            status=status_names()[int(words[2])],
            busy=bool(value["busy"]),
            failed_item=None if value["failed"] == NO_ITEM else value["failed"],
            done=value["done"],
            total=value["total"],
            aboard=aboard_names()[value["aboard"]],
            last_result=None if value["result"] == NO_RESULT else value["result"],
            found=bool(value["found"]),
            firmware=list(texts_of("Firmware.h", "MAVMISSION_FIRMWARES"))[value["firmware"]],
            address=(value["system"], value["component"]),
            armed=bool(value["armed"]),
        )

    @property
    def status(self) -> str:
        return self.state.status

    @property
    def counters(self) -> dict[str, int]:
        """LinkCounters."""
        (line,) = self.tell("counters")
        return {key: int(number) for key, _, number in (word.partition("=") for word in line.split(" ")[3:])}

    def blocked(self) -> int:
        """Bytes that were written though there was no room: the sketch would have been made to wait."""
        (line,) = self.tell("blocked")
        return int(line.split(" ")[2])

    # The line

    def say(self, message, sender: tuple[int, int] | None = None, version: int = 2) -> None:
        """Put a message on the line to the firmware, beside what the autopilot says.

        In the autopilot's name it has the autopilot's next sequence number: no frame seems to be lost.
        """
        sender = sender or self.autopilot.address
        packer = self._packers.setdefault(sender, mavlink.MAVLink(None, *sender))
        if sender == self.autopilot.address and isinstance(self.autopilot, FakeAutopilot):
            packer.seq = self.autopilot.next_sequence()
        self.say_bytes(frame_of(message, packer, version))
        packer.seq = (packer.seq + 1) % 256

    def say_bytes(self, data: bytes) -> None:
        self.wire.send("<", data, self.now)
        self._exchange()

    def heard(self, *names: str) -> list:
        """The messages that the firmware has sent, in order; of these names only, if any."""
        return [entry.message for entry in self._sent(*names)]

    def sent_at(self, *names: str) -> list[float]:
        """When the last byte of each of them left [s]."""
        return [entry.time for entry in self._sent(*names)]

    def _sent(self, *names: str) -> list:
        """What the client has sent, as the wire noted it."""
        return self.wire.frames(">", *names)

    def mission_messages(self) -> list:
        """All that the client has sent but heartbeats, and a frame that a reset has cut short."""
        frames = self._sent()
        return [entry.message for entry in frames if entry.message and entry.message.get_type() != "HEARTBEAT"]

    def transcript(self) -> str:
        """What went over the line, and what the firmware said of it."""
        said = [f"  {event.ms / 1000:8.3f} ! {self._in_words(event)}" for event in self.events]
        return "\n".join([self.wire.transcript(), *said])

    @staticmethod
    def _in_words(event: Event) -> str:
        if event.word in ("began", "returned", "end", "restarted"):
            return f"{event.word} {status_names()[event.numbers[0]]}"
        return f"{event.word} {' '.join(map(str, event.numbers))}"


def packed(item: Item) -> bytes:
    """The item as mavmission::MissionItem lies in RAM; two are equal to the bit if these are."""
    return _ITEM.pack(*item[4:11], item.command, item.frame, item.current, item.autocontinue)


def same_bits(ones: Iterable[Item], others: Iterable[Item]) -> bool:
    return [packed(item) for item in ones] == [packed(item) for item in others]
