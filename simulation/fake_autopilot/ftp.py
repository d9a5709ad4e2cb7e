"""ArduPilot's MAVLink FTP, as far as plans go: @MISSION/mission.dat, fence.dat and rally.dat, as files.

One file is open at a time, for all clients together. What was written is stored when the file
is closed, and the answer to that is ACK whatever becomes of it. Not imitated: other files, and
the queue of requests, of which a sixth is dropped.
"""
import math
import struct
import zlib
from typing import NamedTuple

from .dialect import mavlink
from .items import FENCE, MISSION, RALLY, Item

TERMINATE, RESET, LIST, OPEN_RO, READ, CREATE, WRITE, OPEN_WO, CRC, BURST = 1, 2, 3, 4, 5, 6, 7, 11, 14, 15
ACK, NAK = 128, 129
FAIL, FAIL_ERRNO, INVALID_SESSION, END_OF_FILE, FILE_NOT_FOUND = 1, 2, 4, 6, 10
FILES = {"@MISSION/mission.dat": MISSION, "@MISSION/fence.dat": FENCE, "@MISSION/rally.dat": RALLY}
MAGIC = 0x763D
NO_CLEAR = 1
HEADER = struct.Struct("<5H")  # magic, mission type, options, start, number of items
ITEM = struct.Struct("<4f2if2H5B")  # the payload of MISSION_ITEM_INT, and its mission_type
SIZE_TOLD = 1048576  # by OpenFileRO, whatever the length
MOST_DATA = 239
SLOWED_S = 1.0  # so long after a reply streams are slower
IDLE_S = 3.0  # so long after the last reply another session may take over

_NAMES = {TERMINATE: "TERMINATE", RESET: "RESET", LIST: "LIST", OPEN_RO: "OPEN_RO", READ: "READ", CREATE: "CREATE",
          WRITE: "WRITE", OPEN_WO: "OPEN_WO", CRC: "CRC", BURST: "BURST", ACK: "ACK", NAK: "NAK"}
_FRAME = struct.Struct("<HBBBBBxI")  # seq, session, opcode, size, req_opcode, burst_complete, offset
_PAYLOAD = 251


class Request(NamedTuple):
    """What is in the payload of FILE_TRANSFER_PROTOCOL."""

    seq: int
    session: int
    opcode: int
    size: int
    req_opcode: int
    burst_complete: int
    offset: int
    data: bytes

    @classmethod
    def of(cls, message) -> "Request":
        payload = bytes(message.payload)
        seq, session, opcode, size, req_opcode, burst_complete, offset = _FRAME.unpack_from(payload)
        return cls(seq, session, opcode, size, req_opcode, burst_complete, offset, payload[_FRAME.size :])

    def __str__(self) -> str:
        """In few words: OPEN_RO "@MISSION/mission.dat" #1, or ACK of READ at 10, 38 bytes #2."""
        of = f" of {_NAMES.get(self.req_opcode, self.req_opcode)}" if self.opcode in (ACK, NAK) else ""
        data = self.data[: self.size]
        if self.opcode == NAK:
            what = f" error {data[0] if data else 0}"
        elif self.opcode in (OPEN_RO, CREATE, OPEN_WO):
            what = f' "{data.decode(errors="replace")}"'
        else:
            what = f" at {self.offset}, {self.size} bytes"
        return f"{_NAMES.get(self.opcode, self.opcode)}{of}{what} #{self.seq} of session {self.session}"

    def packed(self) -> bytes:
        head = _FRAME.pack(self.seq % 65536, *self[1:7])
        return (head + self.data[: self.size]).ljust(_PAYLOAD, b"\0")


class Ftp:
    """The server of an ArduPilot. is_enabled: BRD_OPTIONS' bit 1 is not set.

    opening_waits_s: for room behind telemetry; seen: 2.85 s on a full line, where later answers came at once.
    """

    def __init__(self, autopilot, is_enabled: bool = True) -> None:
        self.autopilot = autopilot
        self.is_enabled = is_enabled
        self.opening_waits_s = 0.0
        self.forget()

    def forget(self) -> None:
        """As after a restart."""
        self._session = 0
        self._type: int | None = None  # of the file that is open
        self._writes = False
        self._data = bytearray()
        self._replied_at = -math.inf
        self._opened_at = -math.inf
        self._last: tuple | None = None  # whose request, and its reply

    def hear(self, message, sender, now: float) -> None:
        if not self.is_enabled:
            self.autopilot.text(mavlink.MAV_SEVERITY_ERROR, "failed to initialize MAVFTP", now)
            return
        request = Request.of(message)
        asked = (sender, request.session, request.seq)
        if self._last is not None and self._last[0] == asked and request.opcode != BURST:
            self._send(self._last[1], sender, now)  # not done again
            return
        replies = self._burst(request) if request.opcode == BURST and self._is_ours(request, now) \
            else [self._done(request, now)]
        for number, reply in enumerate(replies):
            self._send(reply, sender, now, later_s=number * 0.0001)
        self._last = (asked, replies[-1])
        if request.opcode != TERMINATE:
            self._replied_at = now

    def is_answering(self, now: float) -> bool:
        """Whether a reply went out within the last second, and no session was ended since."""
        return now - self._replied_at < SLOWED_S

    def _send(self, reply: Request, sender, now: float, later_s: float = 0.0) -> None:
        if reply.req_opcode in (OPEN_RO, CREATE, OPEN_WO):
            later_s += max(0.0, self._opened_at + self.opening_waits_s - now)
        self.autopilot.answer(
            mavlink.MAVLink_file_transfer_protocol_message(0, *sender, list(reply.packed())), now, later_s)

    def _is_ours(self, request: Request, now: float) -> bool:
        """Whether the session may speak: it is that of the open file, or none is open, or that one is idle."""
        if self._type is None or request.session == self._session:
            return True
        return now - self._replied_at > IDLE_S

    def _done(self, request: Request, now: float) -> Request:
        opens = request.opcode in (OPEN_RO, CREATE, OPEN_WO)
        if request.opcode in (TERMINATE, RESET):
            if request.session == self._session:
                self._close(now)
            if request.opcode == TERMINATE:
                self._replied_at = -math.inf
            return self._ack(request)
        if not self._is_ours(request, now):
            return self._nak(request, INVALID_SESSION)
        if self._type is not None and request.session != self._session:
            self._close(now)  # taken over
        self._session = request.session
        if opens:
            self._opened_at = now
            return self._open(request) if self.autopilot.has_storage(now) else self._nak(request, FAIL)
        act = {READ: self._read, WRITE: self._write, CRC: self._crc}.get(request.opcode)
        if act is not None:
            return act(request)
        if request.opcode == LIST:
            return self._nak(request, FAIL_ERRNO)
        self.autopilot.text(mavlink.MAV_SEVERITY_DEBUG, f"Unsupported FTP: {request.opcode}", now)
        return self._nak(request, FAIL)

    @staticmethod
    def _ack(request: Request, data: bytes = b"", offset: int = 0) -> Request:
        return Request(request.seq + 1, request.session, ACK, len(data), request.opcode, 0, offset, data)

    @staticmethod
    def _nak(request: Request, error: int, offset: int = 0) -> Request:
        data = bytes((error, 0)) if error == FAIL_ERRNO else bytes((error,))
        return Request(request.seq + 1, request.session, NAK, len(data), request.opcode, 0, offset, data)

    @staticmethod
    def _type_named(request: Request) -> int | None:
        name = request.data[: request.size].decode(errors="replace").removeprefix("/")
        return FILES.get(name)

    def _open(self, request: Request) -> Request:
        if self._type is not None:
            return self._nak(request, FAIL)
        self._type = self._type_named(request)
        if self._type is None:
            return self._nak(request, FILE_NOT_FOUND)
        self._writes = request.opcode != OPEN_RO
        self._data = bytearray()
        if self._writes:
            return self._ack(request)
        return self._ack(request, struct.pack("<I", SIZE_TOLD))

    # -- reading --------------------------------------------------------------------------

    def file(self, mission_type: int) -> bytes:
        """The plan of this type as a file, as ReadFile gives it."""
        missions = self.autopilot.missions[mission_type]
        items = missions.as_read()
        data = HEADER.pack(MAGIC, mission_type, 0, 0, len(items))
        left_over = (0, 0, 0.0)
        for seq, item in enumerate(items):
            place = (item.x, item.y, item.z)
            if mission_type == MISSION and seq and not any(place):
                place = left_over  # an item without a place has that of the item before
            left_over = place
            is_current = mission_type == MISSION and item.command == self.autopilot.current
            # A fence's items and rally points have neither numbers nor targets.
            number, target = (seq, self.autopilot.address) if mission_type == MISSION else (0, (0, 0))
            data += ITEM.pack(item.param1, item.param2, item.param3, item.param4, *place, number, item.command,
                              *target, item.frame, int(is_current), item.autocontinue) + bytes((mission_type,))
        return data

    def _read(self, request: Request) -> Request:
        if self._type is None:
            return self._nak(request, FILE_NOT_FOUND)
        if self._writes:
            return self._nak(request, FAIL)
        data = self.file(self._type)[request.offset : request.offset + min(request.size, MOST_DATA)]
        if not data:
            return self._nak(request, END_OF_FILE)
        return self._ack(request, data, request.offset)

    def _burst(self, request: Request) -> list[Request]:
        if self._type is None:
            return [self._nak(request, FILE_NOT_FOUND)]
        if self._writes:
            return [self._nak(request, FAIL)]
        whole = self.file(self._type)
        size = request.size or MOST_DATA
        replies, offset, seq, last = [], request.offset, request.seq, request.offset
        while offset < len(whole):
            data = whole[offset : offset + size]
            seq += 1
            replies.append(Request(seq, request.session, ACK, len(data), BURST, 0, offset, data))
            last = offset if len(data) == size else len(whole)
            offset += len(data)
        end = self._nak(request, END_OF_FILE, last)
        return [*replies, end._replace(seq=seq + 1)]

    def _crc(self, request: Request) -> Request:
        mission_type = self._type_named(request)
        if mission_type is None:
            return self._nak(request, FILE_NOT_FOUND)
        return self._ack(request, struct.pack("<I", zlib.crc32(self.file(mission_type), 0xFFFFFFFF) ^ 0xFFFFFFFF))

    # -- writing --------------------------------------------------------------------------

    def _write(self, request: Request) -> Request:
        if self._type is None or not self._writes:
            return self._nak(request, FILE_NOT_FOUND)
        data = request.data[: request.size]
        self._extend(request.offset + len(data))
        self._data[request.offset : request.offset + len(data)] = data
        if request.offset == 0 and len(data) >= HEADER.size:
            *_, count = HEADER.unpack_from(data)
            self._extend(HEADER.size + ITEM_SIZE * count)
        return self._ack(request, offset=request.offset)

    def _extend(self, length: int) -> None:
        self._data.extend(bytes(max(0, length - len(self._data))))

    def _close(self, now: float) -> None:
        mission_type, data, writes = self._type, bytes(self._data), self._writes
        self._type, self._writes, self._data = None, False, bytearray()
        if mission_type is not None and writes:
            self._store(mission_type, data, now)

    def _store(self, mission_type: int, data: bytes, now: float) -> None:
        """Nobody learns what comes of it but by looking."""
        if len(data) < HEADER.size:
            return
        magic, kind, options, start, count = HEADER.unpack_from(data)
        pieces = [data[at : at + ITEM_SIZE] for at in range(HEADER.size, HEADER.size + ITEM_SIZE * count, ITEM_SIZE)]
        is_right = magic == MAGIC and (len(data) - HEADER.size) // ITEM_SIZE == count
        if not is_right or any(not any(piece) for piece in pieces):
            return
        keeps_rest = bool(options & NO_CLEAR)
        if keeps_rest and mission_type != MISSION:
            return
        items = [item_in(piece) for piece in pieces]
        self.autopilot.missions[mission_type].store_file(items, start, keeps_rest, now)


ITEM_SIZE = ITEM.size + 1


def item_in(piece: bytes) -> Item:
    """The item in 38 bytes of a file."""
    p1, p2, p3, p4, x, y, z, _, command, _, _, frame, current, autocontinue = ITEM.unpack_from(piece)
    return Item(frame, command, current, autocontinue, p1, p2, p3, p4, x, y, z)


def file_of(items, mission_type: int = MISSION, options: int = 0, start: int = 0, count: int | None = None) -> bytes:
    """What a client writes to put these items aboard."""
    data = HEADER.pack(MAGIC, mission_type, options, start, len(items) if count is None else count)
    for seq, item in enumerate(items):
        data += ITEM.pack(item.param1, item.param2, item.param3, item.param4, item.x, item.y, item.z, seq,
                          item.command, 1, 1, item.frame, item.current, item.autocontinue) + bytes((mission_type,))
    return data

