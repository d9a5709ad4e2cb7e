"""The peer's end of one of the Mega's serial lines."""

from __future__ import annotations

import ctypes
from collections.abc import Iterable
from typing import NamedTuple

from .library import SentByte, library


class Sent(NamedTuple):
    """A byte from the firmware, and when [cycles since power-on]."""

    left: int  # the end of its stop bit: the peer has it
    byte: int
    written: int  # the firmware's store to UDR


class SerialPort:
    """Serial, Serial1, Serial2 or Serial3, seen from the other end of the cable.

    The receiver holds two bytes beside the arriving one, as the ATmega's does.
    What the firmware fetches too late is gone, and counted in `lost`.
    """

    def __init__(self, mega, number: int) -> None:
        self._mega = mega
        self._handle = mega._handle
        self._peer_baud: int | None = None
        self._waiting = ctypes.c_uint32.from_address(library().mega_sent_count(self._handle, number))
        self.number = number
        self.hz: int = mega.hz

    def send(self, data: bytes, at_cycle: int | None = None) -> None:
        """Queue bytes at the peer's line rate.

        The first start bit goes out at `at_cycle`, or now, or when the bytes
        queued before have gone, whichever is latest.
        """
        data = bytes(data)
        library().mega_send(self._handle, self.number, data, len(data), at_cycle or 0)

    def sent(self) -> list[Sent]:
        """What the firmware has sent since the last call; each byte once its stop bit is over."""
        return [Sent(entry.left, entry.byte, entry.written) for entry in self._taken()]

    def sent_bytes(self) -> bytes:
        """Like sent(), without the times."""
        return bytes([entry.byte for entry in self._taken()])

    def _taken(self) -> Iterable[SentByte]:
        count = self._waiting.value
        if count == 0:
            return ()
        log = (SentByte * count)()
        library().mega_take_sent(self._handle, self.number, log)
        return log

    @property
    def unsent(self) -> int:
        """Bytes queued by send() that have not arrived whole."""
        return library().mega_unsent(self._handle, self.number)

    @property
    def lost(self) -> int:
        """Bytes that a full receiver lost since power-on."""
        return library().mega_lost(self._handle, self.number)

    @property
    def unheard(self) -> int:
        """Bytes that came while the firmware had the receiver off, since power-on."""
        return library().mega_unheard(self._handle, self.number)

    @property
    def listening(self) -> bool:
        """Whether the firmware has the receiver on."""
        return library().mega_listens(self._handle, self.number)

    @property
    def baud(self) -> float:
        """The rate that the firmware has set, as the chip's divider makes it [bit/s]."""
        return self._mega.hz / library().mega_bit_cycles(self._handle, self.number)

    @property
    def peer_baud(self) -> int | None:
        """The peer's own rate [bit/s]; None follows the Mega's exactly.

        A few percent of difference do no harm; beyond 5 % both hear what a real receiver would make of the line:
        other bytes, more of them or fewer.
        """
        return self._peer_baud

    @peer_baud.setter
    def peer_baud(self, baud: int | None) -> None:
        if baud is not None and not 50 <= baud <= 4_000_000:
            raise ValueError(f"peer_baud is a rate from 50 to 4000000 bit/s, or None; not {baud}")
        self._peer_baud = baud
        library().mega_set_peer_baud(self._handle, self.number, baud or 0)
