"""Where the flash of the smallest sketch with an upload goes, as the linker has it."""

from __future__ import annotations

import re
from collections import defaultdict
from pathlib import Path

from elftools.elf.elffile import ELFFile

from building import build_sketch
from simulation.mega.image import demangle

from .firmware import EXAMPLE
from .record import Section
from .report import aligned

NAMED_FROM = 100  # a function as large as that is named [bytes]
TABLES, OTHERS = "tables and free functions", "the core's, the compiler's and the sketch's"


def in_flash(elf: Path) -> list[tuple[str, int]]:
    """(name, size [bytes]) of each function and table that the linker put into flash."""
    with elf.open("rb") as file:
        image = ELFFile(file)
        text = next(number for number, section in enumerate(image.iter_sections()) if section.name == ".text")
        symbols = [(symbol.name, symbol["st_size"]) for symbol in image.get_section_by_name(".symtab").iter_symbols()
                   if symbol["st_shndx"] == text and symbol["st_size"]]  # fmt: skip
    return list(zip(demangle([name for name, _ in symbols]), (size for _, size in symbols), strict=True))


def owner_of(name: str) -> tuple[str, str]:
    """The library's class and the function in it; what is in none has the other two owners."""
    bare = re.sub(r"\(.*", "", name.replace("(anonymous namespace)::", ""))
    if not bare.startswith("mavmission::"):
        return OTHERS, bare
    parts = [part for part in bare.split("::")[1:] if part != "detail"]
    return (parts[0], parts[-1]) if len(parts) > 1 else (TABLES, parts[0])


def parts(elf: Path) -> dict[str, list[tuple[int, str]]]:
    """Owner -> (size [bytes], function), the largest first."""
    found: dict[str, list[tuple[int, str]]] = defaultdict(list)
    for name, size in in_flash(elf):
        owner, function = owner_of(name)
        found[owner].append((size, function))
    return {owner: sorted(functions, reverse=True) for owner, functions in found.items()}


def whole() -> tuple[int, dict[str, list[tuple[int, str]]]]:
    """All the flash [bytes], and its parts: our classes, the largest first, then the others."""
    built = build_sketch(EXAMPLE, "mega")
    found = parts(built.elf)
    order = sorted(found, key=lambda one: (one in (TABLES, OTHERS), -sum(size for size, _ in found[one])))
    return built.flash, {owner if owner in (TABLES, OTHERS) else f"`{owner}`": found[owner] for owner in order}


def sizes() -> Section:
    """The budget as it is recorded."""
    flash, found = whole()
    sums = {owner: sum(size for size, _ in functions) for owner, functions in found.items()}
    return {**sums, "vectors, and what RAM begins with": flash - sum(sums.values()), "all": flash}


def table() -> str:
    """With the larger functions of each class."""
    _, found = whole()
    lines = [["UploadMission on a Mega", "bytes", f"of which, from {NAMED_FROM} bytes on"]]
    for owner, size in sizes().items():
        named = ", ".join(f"{function} {taken:,}" for taken, function in found.get(owner, ())
                          if taken >= NAMED_FROM and (owner != OTHERS or function == "main"))  # fmt: skip
        lines.append([owner, f"{size:,}", named])
    return aligned(lines, left=1)
