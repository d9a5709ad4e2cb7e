"""MAVLink's headers, compiled once for each compiler and its flags instead of once for each source of the library.

    [*command, *with_mavlink(command), source, "-o", target]

They are 60,000 lines, and nearly every source of the library includes them: reading them is five sixths of the time
that compiling one takes. What is kept is known by the compiler, its flags and what the headers hold.
"""

from __future__ import annotations

import functools
import os
import subprocess
from collections.abc import Sequence

from simulation.firmware import LIBRARY, ROOT, digest, exclusive, headers_digest, in_one_place

OUTPUT = ROOT / "build" / "precompiled"
HEADERS = LIBRARY / "mavmission" / "base" / "MavlinkHeaders.h"


def with_mavlink(command: Sequence[str], version: str, *more: str) -> list[str]:
    """The further words for a compiler of this version (a g++ or clang++) that is told these.

    `more`: what is precompiled beside MAVLink's headers, as it stands behind #include.
    """
    return list(made(tuple(command), version, more, vendored(), HEADERS.read_bytes()))


@functools.cache
def vendored() -> str:
    """The digest of hundreds of files, which nothing writes while a program runs."""
    return headers_digest(LIBRARY / "mavmission" / "mavlink")


@functools.cache
def made(command: tuple[str, ...], version: str, more: tuple[str, ...], *contents: str | bytes) -> tuple[str, ...]:
    is_clang = "clang" in command[0]
    header = OUTPUT / digest(version, *command, *more, *contents)[:16] / "mavlink.h"
    target = header.with_name("mavlink.h.pch" if is_clang else "mavlink.h.gch")
    with exclusive(target):
        if not target.exists():
            header.write_text("".join(f"#include {name}\n" for name in (f'"{HEADERS}"', *more)))
            fresh = target.with_suffix(".new")
            # (clang would not take it any more when git has written the same headers again.)
            steady = ["-Xclang", "-fno-pch-timestamp"] if is_clang else []
            before = in_one_place() if command[0].startswith("avr") else []
            words = [*(word for word in command if word != "-c"), *steady, "-x", "c++-header", str(header)]
            subprocess.run([*before, *words, "-o", fresh], check=True, env={**os.environ, "LC_ALL": "C"})
            fresh.replace(target)
    return ("-include-pch", str(target)) if is_clang else ("-include", str(header))
