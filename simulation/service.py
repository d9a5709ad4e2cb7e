"""A bench for the whole mission service: simulation/sketches/service.cpp beside a fake autopilot.

service = Service("PX4")
service.upload(plan, proof="Always")
service.run_until_ended(limit_s=10)
service.order_of("start")             # any word of the firmware: the status that it begins with
service.run_until_ended(limit_s=10)
service.reached                       # [0, 1, ...]
"""

from __future__ import annotations

import re
import struct
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from simulation.bench import _ITEM, NO_ITEM, NO_RESULT, Bench, aboard_names, packed, status_names
from simulation.enumerators import texts_of
from simulation.fake_autopilot import Item, mavlink

SOURCE = Path(__file__).resolve().parent / "sketches" / "service.cpp"

MISSION, FENCE, RALLY, ALL = 0, 1, 2, 255
HOME_INDEX = 0xFFFF
MODES = ("Auto", "Guided", "ReturnToLaunch", "Hold", "Land", "Brake", "Manual")
PROOFS = ("ByAnswer", "InDoubt", "Always")
STEPS = ("None", "ReadyMode", "FirstItem", "Arm", "AutoMode", "Begin", "Confirm")
ARMING = ("Untouched", "Armed", "Disarmed")
ASKED_FOR = (mavlink.MAV_CMD_SET_MESSAGE_INTERVAL, mavlink.MAVLINK_MSG_ID_MISSION_CURRENT, 1e6)

_COMMAND = struct.Struct("<7fiiHBB")  # mavmission::FlightCommand on AVR
_TOLD = re.compile(r"(\d+) (current|reached|text|message|item|posted) (\d+) ?(.*)", re.DOTALL)


def field_texts() -> dict[str, str]:
    return texts_of("ItemField.h", "MAVMISSION_FIELDS")


def field_names() -> list[str]:
    return list(field_texts())


class ServiceState(NamedTuple):
    """What the client's queries answer."""

    status: str
    busy: bool
    failed_item: int | None
    done: int
    total: int
    aboard: str
    aboard_fence: str
    aboard_rally: str
    field: str
    step: str
    arming: str
    last_result: int | None
    firmware: str
    armed: bool
    custom_mode: int
    modes: list[str]  # in which it is, by name


class Followed(NamedTuple):
    """What the follower's queries answer."""

    current: int | None
    reached: int | None
    total: int
    state: int  # MISSION_STATE
    ours: bool


class Told(NamedTuple):
    """A line of the firmware's follower, listeners or sink."""

    ms: int
    word: str
    number: int
    rest: str


class Heard(NamedTuple):
    """A message as a MessageListener had it."""

    id: int
    sender: tuple[int, int]
    version: int
    payload: bytes


class Service(Bench):
    source = SOURCE

    def __init__(self, *arguments, **options) -> None:
        self.told: list[Told] = []
        super().__init__(*arguments, **options)

    def _take_line(self, line: str) -> None:
        match = _TOLD.fullmatch(line)
        if match and not (match[2] == "text" and match[3] == "0" and self._wants_text):
            self.told.append(Told(int(match[1]), match[2], int(match[3]), match[4]))
        else:
            super()._take_line(line)

    _wants_text = False

    def _sent(self, *names: str) -> list:
        """What the client has sent, and not what it or its follower asks for beside it."""
        return [
            entry
            for entry in super()._sent(*names)
            if not is_followers(entry.message) and not asks_for_heartbeat(entry.message)
        ]

    # Orders

    def order_of(self, *words) -> str:
        """Say a line that begins an operation; the name of the status that it began with."""
        self.tell(*words)
        return status_names()[self._numbers("began")[-1][0]]

    def upload(  # type: ignore[override]  # of plans of all types
        self, plan: Sequence[Item] | str | None = None, mission_type: int = MISSION, proof: str = "ByAnswer"
    ) -> str:
        if plan is not None:
            self.use(plan)
        return self.order_of("upload", mission_type, PROOFS.index(proof))

    def ensure(  # type: ignore[override]  # of plans of all types
        self, plan: Sequence[Item] | str | None = None, mission_type: int = MISSION, proof: str = "InDoubt"
    ) -> str:
        if plan is not None:
            self.use(plan)
        return self.order_of("ensure", mission_type, PROOFS.index(proof))

    def upload_part(self, plan: Sequence[Item], first: int, count: int) -> str:
        self.use(plan)
        return self.order_of("uploadpart", first, count)

    def verify(self, plan: Sequence[Item] | str | None = None, mission_type: int = MISSION) -> str:
        if plan is not None:
            self.use(plan)
        return self.order_of("verify", mission_type)

    def download(self, mission_type: int = MISSION, limit: int = HOME_INDEX - 1, refused: int = HOME_INDEX - 1) -> str:
        """To the function, which takes `limit` items, and refuses item `refused`."""
        return self.order_of("download", mission_type, limit, refused)

    def send_command(self, command: int, *params: float, place: tuple[int, int] | None = None, frame: int = 2,
                     always: bool = False) -> str:  # fmt: skip
        """Any command: COMMAND_LONG, or COMMAND_INT with a place [1e-7 degrees]; param7 is then the altitude."""
        filled = [*params, *[0.0] * (7 - len(params))]
        data = _COMMAND.pack(*filled, *(place or (0, 0)), command, frame, place is not None)
        self.mega.poke(self.mega.address("benchCommand"), data)
        return self.order_of("order", always)

    def set_mode(self, name: str) -> str:
        return self.order_of("mode", MODES.index(name))

    def post(self, identity: int, crc_extra: int, payload: bytes) -> None:
        """Have a message of the sketch's own sent, and wait until it was taken."""
        self.mega.poke(self.mega.address("benchPayload"), payload)
        before = self.count_told("posted")
        self.tell("post", identity, crc_extra, len(payload), len(payload))
        limit = self.now + 2.0
        while self.count_told("posted") == before:
            assert self.now < limit, "the message was not taken within 2 s"
            self.run(0.0005)

    def done(self, limit_s: float = 10.0) -> str:
        return self.run_until_ended(limit_s)

    # What came of it

    def sink(self, count: int) -> list[Item]:
        """The first items of benchSink."""
        data = self.mega.peek("benchSink", count * _ITEM.size)
        return [unpacked(data[at : at + _ITEM.size]) for at in range(0, len(data), _ITEM.size)]

    @property
    def home(self) -> Item:
        """What the sink was given as home."""
        return unpacked(self.mega.peek("benchHome", _ITEM.size))

    def count_told(self, word: str) -> int:
        return sum(told.word == word for told in self.told)

    def _told_numbers(self, word: str) -> list[int]:
        return [told.number for told in self.told if told.word == word]

    @property
    def sunk(self) -> list[int]:
        """The indexes with which the sink was called."""
        return self._told_numbers("item")

    @property
    def currents(self) -> list[int]:
        return self._told_numbers("current")

    @property
    def reached(self) -> list[int]:
        return self._told_numbers("reached")

    @property
    def texts(self) -> list[tuple[int, str]]:
        """(severity, words)."""
        return [(told.number, told.rest) for told in self.told if told.word == "text"]

    @property
    def listened(self) -> list[Heard]:
        heard = []
        for told in self.told:
            if told.word == "message":
                system, component, version, payload = told.rest.split(" ")
                heard.append(Heard(told.number, (int(system), int(component)), int(version), bytes.fromhex(payload)))
        return heard

    def compared(
        self, sent: Item, read: Item, firmware: str, mission_type: int = MISSION, vehicle_type: int = 2
    ) -> str:
        """The name of the Field in which difference() sees one."""
        self.mega.poke("benchPlan", packed(sent))
        self.mega.poke("benchSink", packed(read))
        (line,) = self.tell(
            "compare", ("Unknown", "ArduPilot", "PX4", "Other").index(firmware), mission_type, vehicle_type
        )
        return field_names()[int(line.split(" ")[2])]

    def text_of_field(self, name: str) -> str:
        self._wants_text = True
        (line,) = self.tell("fieldtext", field_names().index(name))
        self._wants_text = False
        return line.split(" ", 3)[3]

    def _values(self, word: str) -> tuple[int, dict[str, int]]:
        (line,) = self.tell(word)
        words = line.split(" ")
        return int(words[2]), {key: int(number) for key, _, number in (pair.partition("=") for pair in words[3:])}

    @property
    def state(self) -> ServiceState:  # type: ignore[override]  # it says more
        status, value = self._values("state")
        return ServiceState(
            status=status_names()[status],
            busy=bool(value["busy"]),
            failed_item=None if value["failed"] == NO_ITEM else value["failed"],
            done=value["done"],
            total=value["total"],
            aboard=aboard_names()[value["aboard"]],
            aboard_fence=aboard_names()[value["fence"]],
            aboard_rally=aboard_names()[value["rally"]],
            field=field_names()[value["field"]],
            step=STEPS[value["step"]],
            arming=ARMING[value["arming"]],
            last_result=None if value["result"] == NO_RESULT else value["result"],
            firmware=list(texts_of("Firmware.h", "MAVMISSION_FIRMWARES"))[value["firmware"]],
            armed=bool(value["armed"]),
            custom_mode=value["mode"],
            modes=[name for bit, name in enumerate(MODES) if value["modes"] >> bit & 1],
        )

    @property
    def followed(self) -> Followed:
        _, value = self._values("followed")
        return Followed(
            current=None if value["current"] == NO_ITEM else value["current"],
            reached=None if value["reached"] == NO_ITEM else value["reached"],
            total=value["total"],
            state=value["state"],
            ours=bool(value["ours"]),
        )


def is_followers(message) -> bool:
    """Whether this asks for MISSION_CURRENT every second, as a follower does that hears none."""
    return (message is not None and message.get_type() == "COMMAND_LONG"
            and (message.command, message.param1, message.param2) == ASKED_FOR)  # fmt: skip


def asks_for_heartbeat(message) -> bool:
    """Whether this asks for a heartbeat, as an order does that is to leave right behind one."""
    return (message is not None and message.get_type() == "COMMAND_LONG"
            and (message.command, message.param1) == (mavlink.MAV_CMD_REQUEST_MESSAGE, 0))  # fmt: skip


def unpacked(data: bytes) -> Item:
    """The opposite of bench.packed()."""
    *numbers, command, frame, current, autocontinue = _ITEM.unpack(data)
    return Item(frame, command, current, autocontinue, *numbers)
