"""A Cortex-M0 that QEMU emulates, with firmware, in lock step with the test: a micro:bit's nRF51822.

    board = Microbit(build_cortex_m0("service", [SOURCES / "service.cpp"]))
    board.serial(0).send(b"state\n")
    board.run_until(board.cycle + board.hz)   # a second of the board's time

It has what mega.Mega has of this, so that a Bench runs on it. QEMU counts instructions for its clock; each millisecond
of it the core of the tests (cortex_m0/core) exchanges over the emulated UART what its ports have sent and received,
while its timer stands still. So a run is the same each time, and nothing waits for the clock on the wall.
"""

from __future__ import annotations

import functools
import os
import subprocess
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path

from simulation import firmware, together
from simulation.firmware import (
    LIBRARY,
    ROOT,
    defined,
    digest,
    exclusive,
    headers_digests,
    library_names,
    library_sources,
)
from simulation.mega import Sent
from simulation.precompiled import with_mavlink

OUTPUT = ROOT / "build" / "cortex_m0"
CORE = ROOT / "simulation" / "cortex_m0" / "core"
COMPILER = "arm-none-eabi-g++"
CPU = ["-mcpu=cortex-m0", "-mthumb"]
# -fno-... as all cores for ARM have it.
FLAGS = [*CPU, "-c", "-Os", "-ffunction-sections", "-fdata-sections", "-fno-exceptions", "-fno-rtti",
         "-fno-threadsafe-statics", "-DARDUINO=10819", "-DARDUINO_ARCH_CORTEX_M0"]  # fmt: skip
STRICT = ["-Wall", "-Wextra", "-Werror"]
STANDARD = "-std=gnu++11"
LINK = [*CPU, "-nostartfiles", "--specs=nano.specs", "-Wl,--gc-sections", f"-T{CORE / 'microbit.ld'}"]

HZ = 16_000_000
TICK = HZ // 1000


class BoardFailed(Exception):
    """The processor met what it cannot do, or QEMU has ended."""


def build_cortex_m0(
    name: str,
    sources: Sequence[str | Path],
    defines: Mapping[str, object] | None = None,
    include_dirs: Iterable[str | Path] = (),
) -> Path:
    """The ELF of `sources`, which define setup() and loop(), with the library. Warnings are errors."""
    places = [CORE, LIBRARY, *(Path(folder) for folder in include_dirs)]
    more = [STANDARD, *defined(defines or {})]
    # The library's objects are the same for all that it does not name.
    its_own = [STANDARD, *defined({name: value for name, value in (defines or {}).items() if library_names(name)})]
    headers = headers_digests(places)
    objects = [cortex_m0_object(unit, its_own, places, headers) for unit in together.together(library_sources())]
    objects += [cortex_m0_object(Path(unit), more, places) for unit in (*sources, *sorted(CORE.glob("*.cpp")))]
    key = digest("elf", *LINK, (CORE / "microbit.ld").read_bytes(), *map(str, objects))
    elf = OUTPUT / f"{name}-{key[:12]}" / f"{name}.elf"
    with exclusive(elf):
        if not elf.exists():
            fresh = elf.with_suffix(".new")
            firmware.run([COMPILER, *LINK, *objects, "-o", fresh])
            fresh.replace(elf)
    return elf


def cortex_m0_object(source: Path, flags: Sequence[str], places: Sequence[Path], headers: str | None = None) -> Path:
    """`headers`: the headers_digests() of places, of which the source's own folder is in one."""
    command = [COMPILER, *FLAGS, *STRICT, *flags, *(f"-I{place}" for place in places)]
    headers = headers or headers_digests([*places, source.parent])
    key = digest(compiler_version(), headers, source.read_bytes(), str(source), *command)
    target = OUTPUT / "objects" / key[:2] / f"{source.stem}-{key[2:16]}.o"
    with exclusive(target):
        if not target.exists():
            fresh = target.with_suffix(".new")
            is_librarys = {LIBRARY, together.OUTPUT} & {*source.parents}
            quick = with_mavlink(command, compiler_version()) if is_librarys else []
            firmware.run([*command, *quick, source, "-o", fresh])
            fresh.replace(target)
    return target


@functools.cache
def compiler_version() -> str:
    return subprocess.run([COMPILER, "--version"], capture_output=True, text=True, check=True).stdout


@functools.cache
def symbols_of(elf: Path) -> dict[str, int]:
    listed = subprocess.run(["arm-none-eabi-nm", elf], capture_output=True, text=True, check=True).stdout
    rows = (line.split() for line in listed.splitlines())
    return {row[2]: int(row[0], 16) for row in rows if len(row) == 3}


class Port:
    """The other end of Serial or Serial1. What it sends arrives at its baud rate."""

    def __init__(self, baud: int) -> None:
        self.baud = baud
        self.hz = HZ
        self._queue = bytearray()
        self._credit = 0.0  # bytes that the line would have let pass by now
        self._sent: list[Sent] = []

    def send(self, data: bytes) -> None:
        self._queue += data

    def sent(self) -> list[Sent]:
        sent, self._sent = self._sent, []
        return sent

    def sent_bytes(self) -> bytes:
        return bytes(entry.byte for entry in self.sent())

    def arriving(self) -> bytes:
        """In the next millisecond."""
        self._credit += self.baud / 10 / 1000
        count = min(int(self._credit), len(self._queue), 255)
        data = bytes(self._queue[:count])
        del self._queue[:count]
        self._credit = min(self._credit - count, 1.0) if not self._queue else self._credit - count
        return data

    def left(self, data: bytes, tick: int) -> None:
        """In the millisecond that ends with this tick, each a byte's time behind the one before."""
        byte_cycles = HZ * 10 // self.baud
        first = tick * TICK - len(data) * byte_cycles
        self._sent += [Sent(first + (at + 1) * byte_cycles, byte, first) for at, byte in enumerate(data)]


class Microbit:
    def __init__(self, elf: Path, bauds: Sequence[int] = (500000, 57600)) -> None:
        self.elf = elf
        self.hz = HZ
        self.tick = 0  # milliseconds of the board since power-on
        self._ports = [Port(baud) for baud in bauds]
        # 2^6 ns for an instruction: 15.6 MHz, of which each does one. `sleep=off`: idle time passes at once.
        self._qemu = subprocess.Popen(
            ["qemu-system-arm", "-M", "microbit", "-icount", "shift=6,align=off,sleep=off", "-display", "none",
             "-monitor", "none", "-chardev", "stdio,id=line,signal=off", "-serial", "chardev:line", "-kernel", elf],
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, bufsize=0,
        )  # fmt: skip
        assert self._qemu.stdin and self._qemu.stdout
        self._to, self._from = self._qemu.stdin, self._qemu.stdout
        self._answers = b""
        self._await_tick()

    def close(self) -> None:
        self._qemu.kill()
        self._qemu.wait()
        self._to.close()
        self._from.close()

    def __del__(self) -> None:
        if hasattr(self, "_from") and self._qemu.returncode is None:
            self.close()

    # The line to the board

    def _hear(self, count: int) -> bytes:
        while len(self._answers) < count:
            more = os.read(self._from.fileno(), 65536)
            if not more:
                raise BoardFailed("QEMU has ended")
            self._answers += more
        data, self._answers = self._answers[:count], self._answers[count:]
        return data

    def _say(self, data: bytes) -> None:
        while data:
            data = data[os.write(self._to.fileno(), data) :]

    def _await_tick(self) -> None:
        kind = self._hear(1)
        if kind != b"T":
            raise BoardFailed(f"after {self.tick} ms the processor could not go on")
        self.tick += 1
        for port in self._ports:
            port.left(self._hear(self._hear(1)[0]), self.tick)

    # Time

    @property
    def cycle(self) -> int:
        return self.tick * TICK

    def run_until(self, cycle: int, stop_on: int | None = None) -> bool:
        """Whole milliseconds; True as soon as the port `stop_on` has sent something."""
        while self.cycle < cycle:
            arriving = [port.arriving() for port in self._ports]
            self._say(b"R" + b"".join(bytes((len(data),)) + data for data in arriving))
            self._await_tick()
            if stop_on is not None and self._ports[stop_on]._sent:
                return True
        return False

    # Its memory

    def serial(self, number: int) -> Port:
        return self._ports[number]

    def address(self, name: str) -> int:
        return symbols_of(self.elf)[name]

    def poke(self, place: int | str, data: bytes) -> None:
        at = self.address(place) if isinstance(place, str) else place
        self._say(b"P" + at.to_bytes(4, "little") + len(data).to_bytes(2, "little") + data)

    def peek(self, place: int | str, count: int) -> bytes:
        at = self.address(place) if isinstance(place, str) else place
        self._say(b"G" + at.to_bytes(4, "little") + count.to_bytes(2, "little"))
        return self._hear(count)

    def poke_int(self, place: int | str, value: int, size: int) -> None:
        self.poke(place, value.to_bytes(size, "little"))

    def peek_int(self, place: int | str, size: int) -> int:
        return int.from_bytes(self.peek(place, size), "little")
