"""A serial line that has no memory, for a peer that does not know how fast it is.

An autopilot that sends through a serial port of its own sends what the line takes: where that is too little it thins
out its telemetry, and answers all the same. One that sends over a network, or over USB, knows nothing of the line, and
the frames that wait for it in this computer may be seconds old. Here they are dropped as the autopilot would have left
them out: whole, telemetry before answers, the oldest first.
"""

from __future__ import annotations

from collections import deque

MEMORY_S = 0.1  # nothing that has waited for longer goes on the line

# What an autopilot sends because somebody asked, or once; all else is a stream, and comes again.
_ANSWERS = frozenset(
    {
        0,  # HEARTBEAT
        22,  # PARAM_VALUE
        *range(37, 48),  # MISSION_REQUEST_PARTIAL_LIST to MISSION_ACK
        51,  # MISSION_REQUEST_INT
        73,  # MISSION_ITEM_INT
        75,  # COMMAND_INT
        76,  # COMMAND_LONG
        77,  # COMMAND_ACK
        110,  # FILE_TRANSFER_PROTOCOL
        148,  # AUTOPILOT_VERSION
        244,  # MESSAGE_INTERVAL
        253,  # STATUSTEXT
        256,  # SETUP_SIGNING
        300,  # PROTOCOL_VERSION
    }
)

_STRAY_BYTES = 16  # what is no frame is dropped in pieces of so many
_V1, _V2 = 0xFE, 0xFD
_SIGNED = 1  # of a MAVLink 2 frame's incompatibility flags


class _Piece:
    """A frame, or bytes between frames."""

    def __init__(self, came_s: float, is_frame: bool) -> None:
        self.came_s = came_s  # its first byte
        self.is_frame = is_frame
        self.data = bytearray()
        self.taken = 0  # so many bytes of it are on the line

    @property
    def waiting(self) -> int:
        return len(self.data) - self.taken

    @property
    def missing(self) -> int:
        """Bytes that are still to come before it is whole, as far as can be said."""
        data = self.data
        if not self.is_frame:
            return 0
        if data[0] == _V1:
            return 2 - len(data) if len(data) < 2 else data[1] + 8 - len(data)
        if len(data) < 3:
            return 3 - len(data)
        return data[1] + 12 + 13 * (data[2] & _SIGNED) - len(data)

    @property
    def is_answer(self) -> bool:
        if not self.is_frame:
            return False
        identity = self.data[5] if self.data[0] == _V1 else int.from_bytes(self.data[7:10], "little")
        return identity in _ANSWERS

    @property
    def may_go(self) -> bool:
        """Whether it can be dropped whole."""
        return self.taken == 0 and self.missing <= 0


class Line:
    """What has come for a port, and is not on its line yet.

        line.hear(data, now_s)
        line.forget(now_s, bytes_per_s)
        port.send(line.take(room))
    """

    def __init__(self, peer: str) -> None:
        self.peer = peer  # who sends it, in words
        self._pieces: deque[_Piece] = deque()
        self._waiting = 0
        self.heard = 0  # bytes
        self.dropped = 0  # bytes
        self.dropped_frames = 0

    def hear(self, data: bytes, now_s: float) -> None:
        self.heard += len(data)
        self._waiting += len(data)
        at = 0
        while at < len(data):
            piece = self._pieces[-1] if self._pieces else None
            if piece is not None and piece.missing > 0:
                end = at + piece.missing
            else:
                is_frame = data[at] in (_V1, _V2)
                end = at + 1 if is_frame else min(_next_frame(data, at), at + _STRAY_BYTES)
                piece = _Piece(now_s, is_frame)
                self._pieces.append(piece)
            piece.data += data[at:end]
            at = end

    def forget(self, now_s: float, bytes_per_s: float) -> None:
        """Drop what cannot be on the line in time."""
        most = MEMORY_S * bytes_per_s
        self._drop(lambda piece: now_s - piece.came_s > MEMORY_S)
        if self._waiting > most:
            self._drop(lambda piece: self._waiting > most and not piece.is_answer)
        if self._waiting > most:
            self._drop(lambda piece: self._waiting > most)

    def take(self, most: int) -> bytes:
        """The next bytes for the line."""
        taken = bytearray()
        while self._pieces and len(taken) < most:
            piece = self._pieces[0]
            part = piece.data[piece.taken : piece.taken + most - len(taken)]
            piece.taken += len(part)
            taken += part
            if piece.waiting or piece.missing > 0:
                break
            self._pieces.popleft()
        self._waiting -= len(taken)
        return bytes(taken)

    def _drop(self, is_wanted) -> None:
        kept: deque[_Piece] = deque()
        for piece in self._pieces:
            if not piece.may_go or not is_wanted(piece):
                kept.append(piece)
                continue
            self._waiting -= len(piece.data)
            self.dropped += len(piece.data)
            self.dropped_frames += piece.is_frame
        self._pieces = kept


def _next_frame(data: bytes, begin: int) -> int:
    """Where the next frame begins, or the data end."""
    found = [place for magic in (_V1, _V2) if (place := data.find(magic, begin)) >= 0]
    return min(found, default=len(data))
