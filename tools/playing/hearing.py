"""simulation/hearing, the autopilots' own parser, and the library's reader of .waypoints, compiled to WebAssembly for
the browser."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

from building import BUILD, ROOT
from simulation.firmware import LIBRARY, digest, exclusive, headers_digests, library_file

SOURCES = (
    ROOT / "simulation" / "hearing" / "Hearing.cpp",
    ROOT / "simulation" / "hearing" / "library.cpp",
    Path(__file__).resolve().parent / "hearing_wasm.cpp",
    *(library_file(f"{part}.cpp") for part in ("Commands", "DecimalText", "FloatBits", "LongNumber", "WaypointsText",
                                               "WirePlan")),
)  # fmt: skip
EXPORTS = (
    "hearing_new", "hearing_free", "hearing_take", "room_for_bytes", "size_of_room", "room_for_frame",
    "room_for_length", "text_begin", "text_take", "text_event", "text_line", "text_field", "text_error", "text_type",
    "text_item",
)  # fmt: skip


class NotCompiled(Exception):
    """The text is what the compiler said."""


def compile_hearing(target: Path) -> None:
    """Kept until the compiler, its flags or what it reads change."""
    command = [
        "clang++", "--target=wasm32-wasi", "-std=c++11", "-O2", "-Wall", "-Wextra", "-Werror", "-fno-exceptions",
        "-fno-rtti", "-mexec-model=reactor", "-nostdlib++", f"-I{ROOT / 'src'}",
        # MAVLink's headers include it where structures are packed, and so would pack the C library's.
        "-include", "stdio.h",
        *map(str, SOURCES), "-Wl,--strip-all", *(f"-Wl,--export={name}" for name in EXPORTS),
    ]  # fmt: skip
    sources = (source.read_bytes() for source in SOURCES)
    headers = headers_digests([LIBRARY, ROOT / "simulation" / "hearing"])
    kept = BUILD / "playground" / f"hearing-{digest(ran(['clang++', '--version']), *command, *sources, headers)[:16]}"
    with exclusive(kept):
        if not kept.exists():
            fresh = kept.with_suffix(".new")
            ran([*command, "-o", str(fresh)])
            fresh.replace(kept)
    shutil.copyfile(kept, target)


def ran(command: list[str]) -> str:
    """What it says. Raises NotCompiled."""
    try:
        said = subprocess.run(command, capture_output=True, text=True, check=False)
    except OSError as error:
        raise NotCompiled("clang++ does not start: run tools/setup playground") from error
    if said.returncode != 0:
        raise NotCompiled(said.stderr)
    return said.stdout
