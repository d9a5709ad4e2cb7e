"""The plan that an example means to upload, read from its firmware.

A plan in flash or in RAM is an array of mavmission::MissionItem, and so a variable whose
size is a multiple of theirs and whose bytes make sense as items. A plan that a function
computes is no variable: none is found then.
"""

from __future__ import annotations

import math
import struct
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from elftools.elf.elffile import ELFFile
from elftools.elf.sections import SymbolTableSection

from simulation.fake_autopilot import Item, mavlink
from simulation.mega.image import EEPROM, OBJECT, RAM, SPECIAL, Entry, demangle

# src/mavmission/item/MissionItem.h, packed as avr-gcc packs everything:
# param1 to param4, x, y, z, command, frame, current, autocontinue.
LAYOUT = struct.Struct("<4f2if H3B")
FRAMES = (0, 2, 3, 5, 6, 10, 11)


class NotOnePlan(Exception):
    """Several arrays could be the plan; the text says what to do."""


@dataclass(frozen=True)
class Plan:
    """An array of items somewhere in the firmware."""

    name: str
    address: int  # in flash, or in RAM [bytes]
    size: int  # [bytes]
    in_ram: bool
    contents: bytes  # as the linker left them; a plan in RAM may still change

    @property
    def count(self) -> int:
        return self.size // LAYOUT.size

    def items(self, read_ram: Callable[[int, int], bytes]) -> list[Item]:
        """The items as they are now. `read_ram` reads (address, size) of the running firmware."""
        return unpacked(read_ram(self.address, self.size) if self.in_ram else self.contents)


def plan_in(elf: Path, name: str | None = None) -> Plan | None:
    """The one plan in the firmware, or the one of that name; None if there is none."""
    plans = {plan.name: plan for plan in plans_in(elf, name)}
    if name is not None:
        if name not in plans:
            raise NotOnePlan(f"{elf.name} holds no plan called {name}; it holds {listed(plans)}")
        return plans[name]
    if len(plans) > 1:
        raise NotOnePlan(
            f"{elf.name} holds several plans: {listed(plans)}; say in tools/demonstration/examples.toml "
            "which one is uploaded"
        )
    return next(iter(plans.values()), None)


def listed(plans: dict[str, Plan]) -> str:
    return ", ".join(sorted(plans)) or "none"


def plans_in(elf: Path, named: str | None = None) -> list[Plan]:
    """Every variable that can be an array of items; the one of that name may have any commands."""
    found = []
    with elf.open("rb") as file:
        image = ELFFile(file)
        for section in image.iter_sections():
            if not isinstance(section, SymbolTableSection):
                continue
            for symbol, value, size, kind, number in Entry.all_of(section):
                if kind != OBJECT or not 0 < number < SPECIAL:
                    continue
                if size == 0 or size % LAYOUT.size:
                    continue
                place = image.get_section(number)
                if place["sh_type"] != "SHT_PROGBITS":  # .bss: zeros are no plan
                    continue
                start = value - place["sh_addr"]
                contents = place.data()[start : start + size]
                name = demangle([symbol])[0].rpartition("::")[2]
                if not all(is_plausible(item, name == named) for item in unpacked(contents)):
                    continue
                in_ram = RAM <= value < EEPROM
                address = value - (RAM if in_ram else 0)
                found.append(Plan(name, address, size, in_ram, contents))
    return found


def unpacked(contents: bytes) -> list[Item]:
    return [
        Item(frame, command, current, autocontinue, param1, param2, param3, param4, x, y, z)
        for param1, param2, param3, param4, x, y, z, command, frame, current, autocontinue in LAYOUT.iter_unpack(
            contents
        )
    ]


def is_plausible(item: Item, is_named: bool = False) -> bool:
    """Whether bytes that were taken for an item can have been meant as one."""
    numbers = (item.param1, item.param2, item.param3, item.z)
    return (
        (is_named or item.command in mavlink.enums["MAV_CMD"])
        and item.frame in FRAMES
        and item.current <= 1
        and item.autocontinue <= 1
        and all(math.isfinite(number) for number in numbers)
        and not math.isinf(item.param4)
    )
