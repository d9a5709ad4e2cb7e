"""What the Mega and the autopilot have said to one another, and what it means."""

from __future__ import annotations

import math
from collections import Counter

from simulation.fake_autopilot import MISSION, Item, ftp, mavlink
from simulation.wire import Entry

from .words import FILES, ITEMS

# Each side speaks again sooner than this while it still hopes: the client after
# 1.5 s, or after 8.5 s of waiting in vain; ArduPilot after 1 s, until 8 s are over.
QUIET_AFTER_ANSWER_S = 3.0
QUIET_S = 10.0

SHOWN = ("MISSION_", "COMMAND_", "STATUSTEXT", "SET_MODE", FILES)
NOT_SHOWN = ("MISSION_CURRENT",)  # PX4 says it each second


def file_created(message) -> int | None:
    """The type of plan whose file this opens for writing; None if it opens none."""
    if message.get_type() != FILES:
        return None
    request = ftp.Request.of(message)
    name = request.data[: request.size].decode(errors="replace").rstrip("\0")
    return ftp.FILES.get(name) if request.opcode == ftp.CREATE else None


class Conversation:
    """What the two have said, as an eavesdropper understands it."""

    def __init__(self) -> None:
        self.counts: dict[int, int] = {}  # items that the Mega announced, by mission type
        self.items: dict[tuple[int, int], Item] = {}  # by type and number, as the Mega first sent each
        self.contradictions: list[str] = []
        self.aboard: Counter[int] = Counter()  # items, by mission type
        self.told: set[int] = set()  # types whose acceptance reached the Mega
        self.as_files: set[int] = set()  # types whose plan was written as a file
        self.delivered: set[int] = set()  # items that the Mega got in a download
        self.thanked = False  # the Mega has acknowledged a download
        self.others: Counter[str] = Counter()  # what is not shown, by name
        self._said: set[tuple] = set()
        self._orders: dict[int | None, set[tuple]] = {}  # by command: what was said of it since its last answer
        self._writing: int | None = None  # the type of plan whose file is open for writing
        self._is_headed = False  # and has its head, without which nothing of it is stored
        self._heartbeats: set[str] = set()
        self._last_at = math.inf
        self._last_answer: int | None = None  # MAV_MISSION_RESULT
        self._answered = False

    def add(self, entry: Entry) -> bool:
        """Take note of a frame; True if the same was said before."""
        message = entry.message
        name = message.get_type() if message is not None else "unknown frames"
        if name == FILES:
            return self._file(entry)
        if name == "MISSION_CURRENT" and entry.direction == "<" and not entry.fate:
            # The answer to MISSION_SET_CURRENT: another one is a new order.
            self._said -= {said for said in self._said if said[1:3] == ("MISSION_SET_CURRENT", message.seq)}
        if not name.startswith(("MISSION_", "COMMAND_")) or name in NOT_SHOWN:
            self._count_other(entry, name)
            return False
        self._last_at = entry.time
        if entry.direction == ">":
            self._from_mega(message, name)
        else:
            self._from_autopilot(entry, message, name)
        if name.startswith("COMMAND_"):
            return self._command(entry)
        said = (entry.direction, name, *(getattr(message, what, None) for what in ("seq", "command", "mission_type")))
        again = said in self._said and name != "MISSION_ACK"
        self._said.add(said)
        if name == "MISSION_ACK" and not entry.fate and message.type == mavlink.MAV_MISSION_ACCEPTED:
            # The transfer is over: what is said of this plan from now on belongs to another one.
            self._said -= {said for said in self._said if said[-1] == getattr(message, "mission_type", MISSION)}
        return again

    def _command(self, entry: Entry) -> bool:
        """An order or its answer; True if the same was said before. An order is a new one when the last has been
        answered, or with another parameter."""
        message = entry.message
        values = message.to_dict()
        values.pop("confirmation", None)  # counts how often the order was sent
        words = tuple((name, str(value)) for name, value in values.items())
        talk = self._orders.setdefault(getattr(message, "command", None), set())
        again = (entry.direction, words) in talk
        is_answer = hasattr(message, "result")
        if not is_answer and not again:
            talk.clear()
        talk.add((entry.direction, words))
        if is_answer and not entry.fate and message.result != mavlink.MAV_RESULT_IN_PROGRESS:
            talk -= {said for said in talk if said[0] != entry.direction}
        return again

    def _file(self, entry: Entry) -> bool:
        """A request or a reply of MAVLink FTP; True if the same was said before."""
        self._last_at = entry.time
        self._answered = entry.direction == "<"
        request = ftp.Request.of(entry.message)
        data = request.data[: request.size]
        if entry.direction == ">" and request.opcode == ftp.CREATE:
            self._writing = file_created(entry.message)
            if self._writing is not None:
                self.counts.setdefault(self._writing, 0)
                self.as_files.add(self._writing)
                self._is_headed = False
        if entry.direction == ">" and request.opcode == ftp.WRITE and self._writing is not None:
            self._write(self._writing, request.offset, data)
        is_closed = request.opcode == ftp.ACK and request.req_opcode == ftp.TERMINATE
        if entry.direction == "<" and self._writing is not None and is_closed:
            self.aboard[self._writing] = self.counts[self._writing]
            if self._is_headed and not entry.fate:
                self.told.add(self._writing)
            self._writing = None
        said = (entry.direction, FILES, request.seq, request.opcode)
        again = said in self._said
        self._said.add(said)
        return again

    def _write(self, kind: int, offset: int, data: bytes) -> None:
        """A piece of a plan's file: whole items, or its head, which the Mega writes last."""
        if offset == 0 and len(data) >= ftp.HEADER.size:
            magic, *_, self.counts[kind] = ftp.HEADER.unpack_from(data)
            self._is_headed = magic == ftp.MAGIC
            offset, data = ftp.HEADER.size, data[ftp.HEADER.size :]
        first = (offset - ftp.HEADER.size) // ftp.ITEM_SIZE
        for seq in range(len(data) // ftp.ITEM_SIZE):
            piece = data[seq * ftp.ITEM_SIZE : (seq + 1) * ftp.ITEM_SIZE]
            self.items.setdefault((kind, first + seq), ftp.item_in(piece))

    def _count_other(self, entry: Entry, name: str) -> None:
        if name == "HEARTBEAT" and entry.direction not in self._heartbeats and not entry.fate:
            return
        if name != "STATUSTEXT":
            self.others[name] += 1

    def is_shown(self, entry: Entry) -> bool:
        name = entry.message.get_type() if entry.message is not None else ""
        if name == "HEARTBEAT" and not entry.fate and entry.direction not in self._heartbeats:
            self._heartbeats.add(entry.direction)
            return True
        return name.startswith(SHOWN) and name not in NOT_SHOWN

    def _from_mega(self, message, name: str) -> None:
        self._answered = name == "MISSION_ACK"
        kind = getattr(message, "mission_type", MISSION)
        if name == "MISSION_COUNT":
            self.counts[kind] = message.count
        if name == "MISSION_ACK":
            self.thanked |= message.type == mavlink.MAV_MISSION_ACCEPTED
        if name in ITEMS:
            sent = Item.of(message)
            if not sent.same_as(self.items.setdefault((kind, message.seq), sent)):
                self.contradictions.append(f"item {message.seq} was sent with two contents.")

    def _from_autopilot(self, entry: Entry, message, name: str) -> None:
        kind = getattr(message, "mission_type", MISSION)
        if name in ("MISSION_REQUEST", "MISSION_REQUEST_INT"):
            self.aboard[kind] = max(self.aboard[kind], message.seq)
        if name in ITEMS and not entry.fate:
            self.delivered.add(message.seq)
        if name == "MISSION_ACK":
            self._answered = True
            self._last_answer = message.type
            if message.type == mavlink.MAV_MISSION_ACCEPTED:
                self.aboard[kind] = self.counts.get(kind, 0)
                if not entry.fate:
                    self.told.add(kind)

    @property
    def telemetry(self) -> int:
        """Frames that are neither shown nor heartbeats."""
        return self.others.total() - self.others["HEARTBEAT"]

    def is_over(self, now: float) -> bool:
        """Whether neither side has anything more to say of the upload."""
        if self._last_at == math.inf:
            return False
        return now - self._last_at >= (QUIET_AFTER_ANSWER_S if self._answered else QUIET_S)

    def last_word(self) -> str:
        """What the autopilot said at the end."""
        if self.as_files and self._last_answer is None:
            return "It was written as a file."
        if self._last_answer is None:
            return "The autopilot never answered."
        if self._last_answer == mavlink.MAV_MISSION_ACCEPTED:
            return "The autopilot accepted the plan" + ("." if self.told else ", but the Mega was never told.")
        result = mavlink.enums["MAV_MISSION_RESULT"].get(self._last_answer)
        return f"The autopilot's last word was {result.name if result else self._last_answer}."
