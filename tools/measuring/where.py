"""Where the RAM, the flash and the cycles of the first example go."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterator
from itertools import groupby
from pathlib import Path
from typing import NamedTuple

from elftools.dwarf.die import DIE
from elftools.elf.elffile import ELFFile

from building import BUILD
from simulation.firmware import LIBRARY, compiled, exclusive, run
from simulation.mega.image import demangle

from .documents import aligned
from .firmware import ours
from .peer import KINDS, Peer
from .runs import MS, SECOND

CLIENT, OBJECT = "MissionClient", "autopilot"
NAMED_FROM = 100  # what is as large as that is named by itself [bytes]
TABLES, OTHERS = "tables and free functions", "the core's, the compiler's and the sketch's"


def linked(elf: Path, *sections: str) -> list[tuple[str, int]]:
    """(name, size [bytes]) of each thing that the linker put into these."""
    with elf.open("rb") as file:
        image = ELFFile(file)
        numbers = {number for number, section in enumerate(image.iter_sections()) if section.name in sections}
        symbols = [(symbol.name, symbol["st_size"]) for symbol in image.get_section_by_name(".symtab").iter_symbols()
                   if symbol["st_shndx"] in numbers and symbol["st_size"]]  # fmt: skip
    return list(zip(demangle([name for name, _ in symbols]), (size for _, size in symbols), strict=True))


# RAM --------------------------------------------------------------------------------


class Part(NamedTuple):
    """A member of an object, or all those of one place."""

    name: str
    size: int  # [bytes]
    parts: tuple[Part, ...] = ()  # of a large one, what it is made of


def client() -> Part:
    """A MissionClient and what it is made of."""
    with records_of_client().open("rb") as file:
        for unit in ELFFile(file).get_dwarf_info().iter_CUs():
            for die in unit.iter_DIEs():
                if die.tag == "DW_TAG_class_type" and name_of(die) == CLIENT and "DW_AT_byte_size" in die.attributes:
                    return Part(CLIENT, die.attributes["DW_AT_byte_size"].value, parts_of(die))
    raise LookupError(f"the compiler says nothing of {CLIENT}")


def records_of_client() -> Path:
    """A file with the compiler's DWARF for a MissionClient.

    The layout is that of any sketch, whose own file has none: link-time optimisation drops it.
    """
    source = BUILD / "budget" / "client.cpp"
    text = "#include <MavMission.h>\nmavmission::MissionClient client(*static_cast<Stream*>(nullptr));\n"
    if not source.exists() or source.read_text() != text:
        source.parent.mkdir(parents=True, exist_ok=True)
        source.write_text(text)
    unit = compiled(source, "atmega2560", ["-gdwarf-2", "-fno-lto"], [LIBRARY])
    elf = unit.with_suffix(".elf")
    with exclusive(elf):
        if not elf.exists():
            fresh = elf.with_suffix(".new")
            run(["avr-gcc", "-mmcu=atmega2560", "-nostdlib", "-Wl,--unresolved-symbols=ignore-all", "-o", fresh, unit])
            fresh.replace(elf)
    return elf


def members_of(owner: DIE) -> Iterator[DIE]:
    """Those of its bases, which all lie at its beginning, and its own."""
    for die in owner.iter_children():
        if die.tag == "DW_TAG_inheritance":
            yield from members_of(kind_of(die))
        elif die.tag == "DW_TAG_member" and "DW_AT_external" not in die.attributes:
            yield die


def parts_of(owner: DIE) -> tuple[Part, ...]:
    """Its members by their places: each reaches to the next place, the last one to the owner's end.

    Those of one place, such as the bits of a byte or what is in a union, are one part.
    """
    places = [(place, list(there)) for place, there in groupby(members_of(owner), place_of)]
    if not places:  # a number, an enumeration or an array
        return ()
    ends = [*(place for place, _ in places[1:]), owner.attributes["DW_AT_byte_size"].value]
    return tuple(
        Part("/".join(name_of(member) or "one of" for member in there), end - place,
             parts_of(kind_of(there[0])) if len(there) == 1 else ())
        for (place, there), end in zip(places, ends, strict=True)
    )  # fmt: skip


def place_of(member: DIE) -> int:
    """Its first byte in the owner: the compiler says it as an operation, with a number in LEB128."""
    location = member.attributes.get("DW_AT_data_member_location")
    return sum((byte & 127) << 7 * n for n, byte in enumerate(location.value[1:])) if location else 0


def kind_of(member: DIE) -> DIE:
    """The type of a member, names of types seen through."""
    kind = member.get_DIE_from_attribute("DW_AT_type")
    while kind.tag in ("DW_TAG_typedef", "DW_TAG_const_type", "DW_TAG_volatile_type"):
        kind = kind.get_DIE_from_attribute("DW_AT_type")
    return kind


def name_of(die: DIE) -> str:
    return die.attributes["DW_AT_name"].value.decode() if "DW_AT_name" in die.attributes else ""


def rows_of(part: Part, path: str) -> list[list[str]]:
    if part.size >= NAMED_FROM and part.parts:
        return [row for inner in part.parts for row in rows_of(inner, f"{path}.{inner.name}")]
    return [[f"`{path}`", str(part.size), ", ".join(f"{inner.name} {inner.size}" for inner in part.parts)]]


def ram() -> str:
    """By member of the client, and by what is beside it. Raises ValueError where compiler and linker differ."""
    others = dict(linked(ours().built.elf, ".data", ".bss", ".noinit"))
    whole = client()
    if others.pop(OBJECT) != whole.size:
        raise ValueError(f"the linker and the compiler differ about the size of a {CLIENT}")
    rows = [row for part in whole.parts for row in rows_of(part, part.name)]
    rows += [[f"{name} (the core's)", str(size), ""] for name, size in sorted(others.items(), key=lambda one: -one[1])]
    return aligned([["UploadMission on a Mega", "bytes", "of which"], *rows, ["all", str(ours().built.ram), ""]], 1)


# Flash ------------------------------------------------------------------------------


def owner_of(name: str) -> tuple[str, str]:
    """The library's class and the function in it; what is in none has the other two owners."""
    bare = re.sub(r"\(.*", "", name.replace("(anonymous namespace)::", ""))
    if not bare.startswith("mavmission::"):
        return OTHERS, bare
    parts = [part for part in bare.split("::")[1:] if part != "detail"]
    return (parts[0], parts[-1]) if len(parts) > 1 else (TABLES, parts[0])


def flash() -> str:
    """By class, the largest first, with its larger functions; then what is of no class."""
    owners: dict[str, list[tuple[int, str]]] = defaultdict(list)
    for name, size in linked(ours().built.elf, ".text"):
        owner, function = owner_of(name)
        owners[owner].append((size, function))
    sums = {owner: sum(size for size, _ in functions) for owner, functions in owners.items()}
    lines = [["UploadMission on a Mega", "bytes", f"of which, from {NAMED_FROM} bytes on"]]
    for owner in sorted(owners, key=lambda one: (one in (TABLES, OTHERS), -sums[one])):
        named = ", ".join(f"{function} {size:,}" for size, function in sorted(owners[owner], reverse=True)
                          if size >= NAMED_FROM and (owner != OTHERS or function == "main"))  # fmt: skip
        lines.append([owner, f"{sums[owner]:,}", named])
    lines.append(["vectors, and what RAM begins with", f"{ours().built.flash - sum(sums.values()):,}", ""])
    return aligned([*lines, ["all", f"{ours().built.flash:,}", ""]], 1)


# Cycles -----------------------------------------------------------------------------


def profile(kind: str) -> str:
    """By function, from the first COUNT to the final answer, the line to the Mega full."""
    peer = Peer(ours().built.elf, kind, saturate=True)
    mega = peer.mega
    peer.heartbeat()
    peer.run_until_heard("MISSION_COUNT")
    mega.start_profile()
    begun = mega.cycle
    peer.run_until_accepted(10 * SECOND)
    took = mega.cycle - begun
    head = f"UploadMission, {kind}: {took / MS:.1f} ms from COUNT to the final answer, {took:,} cycles"
    return f"{head}\n{mega.profile()}"


def cycles() -> str:
    return "\n\n".join(map(profile, KINDS))
