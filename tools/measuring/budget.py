"""Where the RAM of a sketch with a MissionClient goes, member by member, as the compiler and the linker have it."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from elftools.dwarf.die import DIE
from elftools.elf.elffile import ELFFile

from building import BUILD, build_sketch
from examples import example_folder
from simulation.firmware import LIBRARY, compiled, exclusive, run
from simulation.mega.image import demangle

from .record import Section
from .report import aligned

SKETCH = example_folder("UploadMission")
CLIENT = "MissionClient"
ROWS_FROM = 100  # a member as large as that gets a row for each of its own [bytes]


@dataclass(frozen=True)
class Part:
    name: str
    size: int  # [bytes]
    parts: tuple[Part, ...] = ()  # what it is made of
    is_choice: bool = False  # of which there is one at a time


def globals_of(elf: Path) -> dict[str, int]:
    """Name -> size [bytes] of what the linker put into RAM."""
    with elf.open("rb") as file:
        image = ELFFile(file)
        sections = {number for number, section in enumerate(image.iter_sections())
                    if section.name in (".data", ".bss", ".noinit")}  # fmt: skip
        symbols = [(symbol.name, symbol["st_size"]) for symbol in image.get_section_by_name(".symtab").iter_symbols()
                   if symbol["st_shndx"] in sections and symbol["st_size"]]  # fmt: skip
    return dict(zip(demangle([name for name, _ in symbols]), (size for _, size in symbols), strict=True))


def client() -> Part:
    """A MissionClient and what it is made of."""
    with records_of_client().open("rb") as file:
        for unit in ELFFile(file).get_dwarf_info().iter_CUs():
            for die in unit.iter_DIEs():
                if die.tag == "DW_TAG_class_type" and name_of(die) == CLIENT and "DW_AT_byte_size" in die.attributes:
                    return Part(CLIENT, size_of(die), parts_of(die))
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


def parts_of(owner: DIE) -> tuple[Part, ...]:
    """The members of a struct or a union; those of some bits each that lie together are one."""
    parts: list[Part] = []
    bits: list[str] = []
    width = 0  # of them

    def close() -> None:
        nonlocal width
        if bits:
            parts.append(Part("/".join(bits), (width + 7) // 8))
        bits.clear()
        width = 0

    for member in owner.iter_children():
        if member.tag not in ("DW_TAG_member", "DW_TAG_inheritance") or "DW_AT_external" in member.attributes:
            continue
        kind = kind_of(member)
        if member.tag == "DW_TAG_inheritance":
            parts += parts_of(kind)
            continue
        if "DW_AT_bit_size" in member.attributes:
            bits.append(name_of(member))
            width += member.attributes["DW_AT_bit_size"].value
            continue
        close()
        is_choice = kind.tag == "DW_TAG_union_type"
        within = parts_of(kind) if is_choice or kind.tag in ("DW_TAG_class_type", "DW_TAG_structure_type") else ()
        parts.append(Part(name_of(member) or "one of", size_of(kind), within, is_choice))
    close()
    return tuple(parts)


def kind_of(member: DIE) -> DIE:
    """The type of a member, names of types seen through."""
    kind = member.get_DIE_from_attribute("DW_AT_type")
    while kind.tag in ("DW_TAG_typedef", "DW_TAG_const_type", "DW_TAG_volatile_type"):
        kind = kind.get_DIE_from_attribute("DW_AT_type")
    return kind


def name_of(die: DIE) -> str:
    return die.attributes["DW_AT_name"].value.decode() if "DW_AT_name" in die.attributes else ""


def size_of(kind: DIE) -> int:
    if kind.tag == "DW_TAG_array_type":
        counts = [child.attributes["DW_AT_upper_bound"].value + 1 for child in kind.iter_children()
                  if child.tag == "DW_TAG_subrange_type"]  # fmt: skip
        size = size_of(kind_of(kind))
        for count in counts:
            size *= count
        return size
    if kind.tag in ("DW_TAG_pointer_type", "DW_TAG_reference_type"):
        return 2
    return kind.attributes["DW_AT_byte_size"].value


def whole() -> tuple[Part, dict[str, int]]:
    """The client, and name -> size [bytes] of what is in RAM beside it, the largest first."""
    others = globals_of(build_sketch(SKETCH, "mega").elf)
    ours = client()
    if others.pop("autopilot") != ours.size:
        raise ValueError(f"the linker and the compiler differ about the size of a {CLIENT}")
    return ours, {f"{name} (the core's)": size for name, size in sorted(others.items(), key=lambda one: -one[1])}


def rows() -> list[tuple[str, Part]]:
    """(name, part): the client's, those of a large one each for itself, and the core's."""
    ours, others = whole()
    return [*(row for part in ours.parts for row in rows_of(part, part.name)),
            *((name, Part(name, size)) for name, size in others.items())]  # fmt: skip


def rows_of(part: Part, path: str) -> list[tuple[str, Part]]:
    if part.size >= ROWS_FROM and part.parts:
        return [row for inner in part.parts for row in rows_of(inner, f"{path}.{inner.name}")]
    return [(path if part.is_choice else f"`{path}`", part)]


def sizes() -> Section:
    """The budget as it is recorded."""
    ours, others = whole()
    parts = {name: part.size for name, part in rows() if name not in others}
    return {f"`{CLIENT}`, whose parts follow": ours.size, **parts, **others, "all": ours.size + sum(others.values())}


def table() -> str:
    """With the members of each part."""
    lines = [["UploadMission on a Mega", "bytes", "of which"]]
    for name, part in rows():
        within = (" or " if part.is_choice else ", ").join(f"{inner.name} {inner.size}" for inner in part.parts)
        lines.append([name, str(part.size), within])
    return aligned([*lines, ["all", str(sum(part.size for _, part in rows())), ""]], left=1)
