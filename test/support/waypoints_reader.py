"""The library's reading of .waypoints texts, on this computer.

    reader = WaypointsReader()
    read = reader.read("QGC WPL 110\\n0 1 0 16 ...")
    read.good, read.items, read.error, read.line, read.field
"""

from __future__ import annotations

import struct
import subprocess
from pathlib import Path
from typing import NamedTuple

from simulation.enumerators import texts_of
from simulation.firmware import LIBRARY
from simulation.host_build import build_host

SOURCE = Path(__file__).resolve().parents[1] / "waypoints" / "read_texts.cpp"

# The text's own folder, and what it uses.
PARTS = [file for folder in ("autopilot", "base", "item", "plan", "text")
         for file in sorted((LIBRARY / "mavmission" / folder).glob("*.cpp"))]  # fmt: skip
KINDS = ("mission", "fence", "rally")  # mavmission::PlanType


class ReadItem(NamedTuple):
    """An item as the library gives it; the numbers as the bits of floats."""

    params: tuple[bytes, bytes, bytes, bytes]
    x: int
    y: int
    z: bytes
    command: int
    frame: int
    current: int
    autocontinue: int


class Read(NamedTuple):
    good: bool
    error: str  # of TextError
    line: int
    field: int
    kind: str  # of KINDS, where it is good
    items: list[ReadItem | None]  # None: it was refused


class WaypointsReader:
    def __init__(self) -> None:
        program = build_host("read_texts", [SOURCE], "clang++", library=PARTS)
        self._program = subprocess.Popen([program], stdin=subprocess.PIPE, stdout=subprocess.PIPE)

    def close(self) -> None:
        self._program.stdin.close()
        self._program.stdout.close()
        assert self._program.wait() == 0

    def read(self, text: str | bytes) -> Read:
        data = text if isinstance(text, bytes) else text.encode()
        self._program.stdin.write(struct.pack("<I", len(data)) + data)
        self._program.stdin.flush()
        state, error, line, field, kind, count = struct.unpack("<BBHBBH", self._take(8))
        assert state in (1, 2)
        items = [self._item() for _ in range(count)]
        errors = list(texts_of("TextError.h", "MAVMISSION_TEXT_ERRORS"))
        return Read(state == 1, errors[error], line, field, KINDS[kind], items)

    def _item(self) -> ReadItem | None:
        data = self._take(34)
        params = tuple(data[at : at + 4] for at in (1, 5, 9, 13))
        x, y = struct.unpack_from("<ii", data, 17)
        return ReadItem(params, x, y, data[25:29], *struct.unpack_from("<HBBB", data, 29)) if data[0] else None

    def _take(self, size: int) -> bytes:
        data = self._program.stdout.read(size)
        assert len(data) == size, f"the reader ended with {self._program.wait()}"
        return data
