"""The simulated board."""

from __future__ import annotations

import ctypes
import os
import re
from pathlib import Path

from . import library as simulator
from .image import Image
from .library import library
from .measured import Profile, Watch
from .serial import SerialPort


def plain(complaint: bytes) -> str:
    """simavr's words without the colours."""
    return re.sub(r"\x1b\[\d*m", "", complaint.decode(errors="replace")).strip()


class Crashed(Exception):
    """The firmware did what no AVR can: a jump out of flash, an access out of RAM."""


class Mega:
    """An Arduino Mega 2560 (or, by `mcu`, the chip of an Uno or a Leonardo) with firmware.

    Every way to the firmware is here or on a SerialPort. Time stands still
    between the calls of run_...().
    """

    def __init__(self, firmware: str | os.PathLike | Image, mcu: str | None = None, hz: int = 16_000_000) -> None:
        self.image = firmware if isinstance(firmware, Image) else Image.load(Path(firmware))
        self.mcu = mcu or self.image.mcu or "atmega2560"
        self.hz = hz
        self._handle = library().mega_new(self.mcu.encode(), hz)
        if not self._handle:
            raise ValueError(f"no {self.mcu} to simulate: choose atmega2560, atmega328p or atmega32u4")
        for address, data in self.image.flash:
            if library().mega_load(self._handle, data, len(data), address) < 0:
                raise ValueError(f"{self.image.path} does not fit the flash of an {self.mcu}")
        for address, data in self.image.eeprom:
            self.write_eeprom(address, data)
        self._clock = ctypes.c_uint64.from_address(library().mega_clock(self._handle))
        self._run = library().mega_run
        self._ports: dict[int, SerialPort] = {}
        self._profile_began = 0

    def __del__(self) -> None:
        if getattr(self, "_handle", None):
            library().mega_free(self._handle)
            self._handle = None

    # Time

    @property
    def cycle(self) -> int:
        """CPU cycles since power-on."""
        return self._clock.value

    @property
    def now_us(self) -> float:
        """Microseconds since power-on."""
        return self.cycle * 1_000_000 / self.hz

    @property
    def now_ms(self) -> float:
        """Milliseconds since power-on."""
        return self.cycle * 1_000 / self.hz

    def run_until(self, cycle: int, stop_on: int | None = None) -> bool:
        """Run to a cycle, a few more if the last instruction takes them.

        With `stop_on`, the number of a serial port, it returns True as soon as
        a byte has left that port, and False if none did.
        """
        mask = 0 if stop_on is None else 1 << self.serial(stop_on).number
        why = self._run(self._handle, max(0, int(cycle)), mask)
        if why == simulator.CRASHED:
            address = library().mega_pc(self._handle)
            said = plain(library().mega_error(self._handle))
            raise Crashed(
                f"{self.image.path} crashed in {self.image.function_at(address)} (flash address {address:#x}) "
                f"at {self.now_ms:.3f} ms: {said or 'no reason given'}"
            )
        return why == simulator.SENT

    def run_cycles(self, cycles: int, stop_on: int | None = None) -> bool:
        return self.run_until(self.cycle + cycles, stop_on)

    def run_us(self, us: float, stop_on: int | None = None) -> bool:
        return self.run_cycles(round(us * self.hz / 1_000_000), stop_on)

    def run_ms(self, ms: float, stop_on: int | None = None) -> bool:
        return self.run_us(ms * 1_000, stop_on)

    def leave_all_to_simavr(self) -> None:
        """Run every instruction by simavr's own decoder: a tenth of the speed, the same result."""
        library().mega_set_plain(self._handle, True)

    @property
    def slept(self) -> int:
        """Cycles spent asleep since power-on."""
        return library().mega_slept(self._handle)

    # The reset button

    def reset(self) -> None:
        """Press reset. EEPROM, .noinit and the clock of the simulation go on."""
        library().mega_reset(self._handle)

    @property
    def resets(self) -> int:
        """Resets since power-on, by button or by watchdog."""
        return library().mega_resets(self._handle)

    # Serial ports

    def serial(self, number: int) -> SerialPort:
        """The peer's end of Serial (0), Serial1, Serial2 or Serial3."""
        if number not in self._ports:
            if not library().mega_has_port(self._handle, number):
                raise ValueError(f"an {self.mcu} has no Serial{number or ''}")
            self._ports[number] = SerialPort(self, number)
        return self._ports[number]

    # Memory

    @property
    def globals_bytes(self) -> int:
        """RAM that is taken before setup() runs: .data, .bss and .noinit."""
        return self.image.globals_bytes

    @property
    def deepest_stack(self) -> int:
        """The most bytes of stack in use after any instruction since power-on."""
        return library().mega_deepest_stack(self._handle)

    def forget_stack(self) -> None:
        """Let deepest_stack begin anew, at the present depth."""
        library().mega_forget_stack(self._handle)

    @property
    def ram_end(self) -> int:
        """The last address of RAM."""
        return library().mega_ram_end(self._handle)

    def address(self, what: str | int) -> int:
        """The data address of a variable; an int is taken as it is."""
        if isinstance(what, int):
            return what
        symbol = self.image.symbol(what)
        if not symbol.in_ram:
            raise ValueError(f"{what} is in flash, not in RAM")
        return symbol.address

    def peek(self, what: str | int, size: int | None = None) -> bytes:
        """Read a variable, or `size` bytes at a symbol or data address."""
        if size is None:
            size = 1 if isinstance(what, int) else self.image.symbol(what).size
        into = ctypes.create_string_buffer(size)
        if library().mega_read(self._handle, self.address(what), size, into) < 0:
            raise ValueError(f"{size} bytes at {what} reach beyond RAM")
        return into.raw

    def poke(self, what: str | int, data: bytes) -> None:
        """Write bytes at a symbol or data address; a register is written without its effects."""
        if library().mega_write(self._handle, self.address(what), len(data), bytes(data)) < 0:
            raise ValueError(f"{len(data)} bytes at {what} reach beyond RAM")

    def peek_int(self, what: str | int, size: int | None = None, signed: bool = False) -> int:
        return int.from_bytes(self.peek(what, size), "little", signed=signed)

    def poke_int(self, what: str | int, value: int, size: int | None = None) -> None:
        if size is None:
            size = 1 if isinstance(what, int) else self.image.symbol(what).size
        self.poke(what, value.to_bytes(size, "little", signed=value < 0))

    def read_eeprom(self, address: int, size: int) -> bytes:
        into = ctypes.create_string_buffer(size)
        if library().mega_eeprom_read(self._handle, address, size, into) < 0:
            raise ValueError(f"{size} bytes at {address} reach beyond the EEPROM")
        return into.raw

    def write_eeprom(self, address: int, data: bytes) -> None:
        if library().mega_eeprom_write(self._handle, address, len(data), bytes(data)) < 0:
            raise ValueError(f"{len(data)} bytes at {address} reach beyond the EEPROM")

    @property
    def eeprom_writing(self) -> int | None:
        """The address of the EEPROM byte that is being written, which takes 3.4 ms; None: none is."""
        address = library().mega_eeprom_writing(self._handle)
        return None if address < 0 else address

    # Cycles

    def watch(self, function: str) -> Watch:
        """Count the calls of a function and their cycles from now on; slows the run."""
        symbol = self.image.symbol(function)
        if symbol.in_ram:
            raise ValueError(f"{function} is a variable, not a function")
        number = library().mega_watch(self._handle, symbol.address)
        if number < 0:
            raise ValueError("255 functions are watched already")
        return Watch(self, symbol.name, number)

    def start_profile(self) -> None:
        """Count cycles by function from now on; slows the run."""
        library().mega_profile(self._handle)
        self._profile_began = self.slept

    def profile(self) -> Profile:
        """The cycles by function since start_profile()."""
        words = library().mega_flash_words(self._handle)
        by_word = (ctypes.c_uint64 * words)()
        library().mega_take_profile(self._handle, by_word)
        cycles: dict[str, int] = {}
        for word, spent in enumerate(by_word):
            if spent:
                name = self.image.function_at(2 * word)
                cycles[name] = cycles.get(name, 0) + spent
        ordered = dict(sorted(cycles.items(), key=lambda item: -item[1]))
        return Profile(ordered, self.slept - self._profile_began)
