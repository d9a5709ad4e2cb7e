"""Firmware as the compiler left it: what goes to flash, and where its names are."""

from __future__ import annotations

import bisect
import difflib
import re
import struct
import subprocess
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple

from elftools.common.exceptions import ELFError
from elftools.elf.elffile import ELFFile
from elftools.elf.sections import SymbolTableSection

# avr-gcc puts the address spaces of an AVR side by side in one ELF.
RAM = 0x800000
EEPROM = 0x810000
FUSES = 0x820000

# As elf.h has them, of 32 bits, little-endian.
ENTRY = struct.Struct("<IIIBBH")
OBJECT, SECTION, FILE = 1, 3, 4
SPECIAL, ABSOLUTE = 0xFF00, 0xFFF1

MCUS = ("atmega2560", "atmega328p", "atmega32u4")


class BadImage(Exception):
    """The file is not firmware that the simulated board can run."""


class NoSuchSymbol(Exception):
    """The firmware has no such name, or several."""


@dataclass(frozen=True, order=True)
class Symbol:
    """A function (address in flash) or a variable (address in RAM) [bytes]."""

    address: int
    size: int
    name: str
    mangled: str
    in_ram: bool

    def is_called(self, name: str) -> bool:
        return name in (self.name, self.mangled, without_parameters(self.name))


@dataclass
class Image:
    """Firmware: pieces of flash, the EEPROM's first contents, and the symbols."""

    path: Path
    flash: list[tuple[int, bytes]] = field(default_factory=list)
    eeprom: list[tuple[int, bytes]] = field(default_factory=list)
    symbols: list[Symbol] = field(default_factory=list)
    globals_bytes: int = 0  # .data, .bss and .noinit
    mcu: str | None = None
    _found: dict[str, Symbol] = field(default_factory=dict, repr=False, compare=False)  # by what it was asked for

    @classmethod
    def load(cls, path: str | Path) -> Image:
        path = Path(path)
        try:
            start = path.open("rb").read(4)
        except OSError as error:
            raise BadImage(f"cannot read {path}: {error.strerror}") from error
        if start == b"\x7fELF":
            return load_elf(path)
        if start[:1] == b":":
            return load_hex(path)
        raise BadImage(f"{path} is neither an ELF nor an Intel HEX file; tools/build prints where it puts both")

    def symbol(self, name: str) -> Symbol:
        """A symbol by its mangled name, or its C++ name with or without the parameters."""
        if name in self._found:
            return self._found[name]
        found = [s for s in self.symbols if s.is_called(name)]
        if len({s.address for s in found}) == 1:
            self._found[name] = found[0]
            return found[0]
        if found:
            several = ", ".join(sorted(s.name for s in found))
            raise NoSuchSymbol(f"{name} could be any of: {several}")
        raise NoSuchSymbol(self._why_not(name))

    def _why_not(self, name: str) -> str:
        if not self.symbols:
            return f"{self.path} holds no names: load the .elf instead of the .hex to use {name}"
        known = {without_parameters(s.name) for s in self.symbols}
        close = difflib.get_close_matches(name, known, n=5)
        hint = f"; near it: {', '.join(close)}" if close else ""
        return f"no {name} in {self.path}: it may be misspelt, inlined, or unused and left out{hint}"

    def function_at(self, address: int) -> str:
        """The name of the function that holds a flash address [bytes]."""
        functions = self._functions()
        at = bisect.bisect_right(functions, address, key=lambda s: s.address) - 1
        if at < 0:
            return f"{address:#x}"
        return functions[at].name

    def _functions(self) -> list[Symbol]:
        return [s for s in self.symbols if not s.in_ram]


def without_parameters(name: str) -> str:
    """`a::f(int)` -> `a::f`; `(anonymous namespace)::f(int)` -> the same without `(int)`."""
    if not name.endswith((")", ") const")):
        return name
    depth = 0
    for at in range(name.rindex(")"), -1, -1):
        depth += {")": 1, "(": -1}.get(name[at], 0)
        if depth == 0:
            return name[:at]
    return name


def load_elf(path: Path) -> Image:
    image = Image(path)
    try:
        with path.open("rb") as file:
            elf = ELFFile(file)
            if elf["e_machine"] != "EM_AVR":
                raise BadImage(f"{path} is not for an AVR but for {elf.get_machine_arch()}")
            for segment in elf.iter_segments("PT_LOAD"):
                place(image, segment["p_paddr"], segment.data())
            for section in elf.iter_sections():
                if section.name in (".data", ".bss", ".noinit"):
                    image.globals_bytes += section["sh_size"]
                if section.name == ".note.gnu.avr.deviceinfo":
                    image.mcu = next((m for m in MCUS if m.encode() in section.data()), None)
                if isinstance(section, SymbolTableSection):
                    image.symbols += symbols_in(section)
    except (ELFError, struct.error, ValueError) as error:
        raise BadImage(f"{path} is a damaged ELF: {error}") from error
    image.symbols.sort()
    return image


def place(image: Image, address: int, data: bytes) -> None:
    if not data:
        return
    if address < RAM:
        image.flash.append((address, data))
    elif EEPROM <= address < FUSES:
        image.eeprom.append((address - EEPROM, data))


class Entry(NamedTuple):
    """Of a table of symbols. elftools takes as long for one as this for all."""

    name: str
    value: int
    size: int
    kind: int
    section: int  # its number; 0: none; from SPECIAL on it is of no section

    @classmethod
    def all_of(cls, table: SymbolTableSection) -> Iterator[Entry]:
        names = table.stringtable.data()
        for name, value, size, info, _, section in ENTRY.iter_unpack(table.data()):
            yield cls(names[name : names.index(0, name)].decode(), value, size, info & 0xF, section)


def symbols_in(table: SymbolTableSection) -> list[Symbol]:
    raw = []
    for name, value, size, kind, section in Entry.all_of(table):
        in_ram = RAM <= value < EEPROM
        # Untyped labels in flash are code too: the vectors and avr-libc's assembler.
        if kind == OBJECT and not in_ram or kind in (SECTION, FILE):
            continue
        if not name or section in (0, ABSOLUTE):
            continue
        raw.append((value - RAM if in_ram else value, size, name, in_ram))
    names = demangle([name for _, _, name, _ in raw])
    return [Symbol(at, size, names[n], mangled, in_ram) for n, (at, size, mangled, in_ram) in enumerate(raw)]


def demangle(names: list[str]) -> list[str]:
    """C++ names as they are written; a copy that the compiler made keeps the original's name."""
    bare = [re.sub(r"\.(lto_priv|constprop|isra|part|clone)\.\d+", "", name) for name in names]
    if not bare:
        return []
    try:
        said = subprocess.run(["avr-c++filt"], input="\n".join(bare), capture_output=True, text=True, check=True)
    except (OSError, subprocess.CalledProcessError):
        return bare
    return said.stdout.split("\n")[: len(bare)]


def load_hex(path: Path) -> Image:
    """Intel HEX: data, end, and the two kinds of extended address."""
    image = Image(path)
    base = 0
    for number, line in enumerate(path.read_text(errors="replace").splitlines(), 1):
        record = hex_record(path, number, line)
        count, address, kind, data = record[0], int.from_bytes(record[1:3], "big"), record[3], record[4:-1]
        if count != len(data):
            raise BadImage(f"{path}:{number}: the record says {count} bytes and has {len(data)}")
        if kind == 0:
            image.flash.append((base + address, data))
        elif kind == 1:
            return image
        elif kind in (2, 4):
            base = int.from_bytes(data, "big") << (4 if kind == 2 else 16)
    raise BadImage(f"{path} has no end record: it was cut short")


def hex_record(path: Path, number: int, line: str) -> bytes:
    try:
        record = bytes.fromhex(line.strip().removeprefix(":"))
    except ValueError as error:
        raise BadImage(f"{path}:{number} is not an Intel HEX record") from error
    if len(record) < 5 or sum(record) & 0xFF:
        raise BadImage(f"{path}:{number} is damaged: its checksum does not fit")
    return record
