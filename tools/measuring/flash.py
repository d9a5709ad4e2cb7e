"""Where the flash of the smallest sketch with an upload goes, as the linker has it."""

from __future__ import annotations

import re
from collections import defaultdict
from pathlib import Path

from elftools.elf.elffile import ELFFile

from building import build_sketch
from simulation.mega.image import demangle

from .firmware import EXAMPLE

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


def table() -> str:
    """As the documents have it."""
    built = build_sketch(EXAMPLE, "mega")
    found = parts(built.elf)
    sums = {owner: sum(size for size, _ in functions) for owner, functions in found.items()}
    lines = [["UploadMission on a Mega", "bytes", f"of which, from {NAMED_FROM} bytes on"]]
    for owner in sorted(sums, key=lambda one: (one in (TABLES, OTHERS), -sums[one])):
        named = ", ".join(f"{function} {size:,}" for size, function in found[owner]
                          if size >= NAMED_FROM and (owner != OTHERS or function == "main"))  # fmt: skip
        lines.append([owner if owner in (TABLES, OTHERS) else f"`{owner}`", f"{sums[owner]:,}", named])
    lines.append(["vectors, and what RAM begins with", f"{built.flash - sum(sums.values()):,}", ""])
    lines.append(["**all**", f"**{built.flash:,}**", ""])
    return "\n".join(["| {} | {} | {} |".format(*lines[0]), "|---|---:|---|",
                      *("| {} | {} | {} |".format(*line) for line in lines[1:])])  # fmt: skip
