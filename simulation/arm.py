"""The library as ARM's compiler makes it: for a Cortex-M0 in the shape of today's cores, which is only compiled, and as
a program that QEMU runs here.

    compiled(source_of(sketch, folder), "gnu++20")    the object of a sketch, or of a source of the library
    run([program, "--no-version"])                    on an ARM with 32-bit words, whose char has no sign

The program is in Thumb code, as a Cortex-M0's. A word that is not aligned, on which that one faults, ends it:
the compiler's check of it is compiled in. (QEMU runs no program of a Cortex-M without a board around it.)
"""

from __future__ import annotations

import subprocess
from collections.abc import Iterable, Sequence
from pathlib import Path

from simulation.firmware import LIBRARY, ROOT
from simulation.host_build import make_object

CORE = ROOT / "simulation" / "arm_core"
COMPILER = "arm-none-eabi-g++"
STANDARDS = ["gnu++11", "gnu++20"]  # the oldest and the newest that the cores of today choose: AVR, ESP32
# -fno-... as all cores for ARM have it.
BOARD = ["-c", "-mcpu=cortex-m0", "-mthumb", "-Os", "-ffunction-sections", "-fno-exceptions", "-fno-rtti",
         "-fno-threadsafe-statics", "-DARDUINO=10819", "-Wall", "-Wextra", "-Werror"]  # fmt: skip
# Debian's doctest lies beside the headers of this computer, which come after those of the compiler's own library.
PROGRAM = ["-std=gnu++17", "-g0", "-march=armv6", "-mthumb", "-mfloat-abi=soft", "-Os", "--specs=rdimon.specs",
           "-fsanitize=alignment", "-fsanitize-undefined-trap-on-error", "-idirafter/usr/include"]  # fmt: skip


def compiled(source: Path, standard: str, places: Iterable[Path] = (), more: Sequence[str] = ()) -> Path:
    """The object; what the compiler says as an exception, if it says anything."""
    folders = [f"-I{place}" for place in (CORE, LIBRARY, *places)]
    return make_object(source, [COMPILER, *BOARD, f"-std={standard}", *more, *folders])


def source_of(sketch: Path, folder: Path) -> Path:
    """Not a .cpp: those find MAVLink's headers precompiled, and a sketch reads them after the core's."""
    source = folder / f"{sketch.stem}.cc"
    source.write_text(f'#include <Arduino.h>\n#line 1 "{sketch}"\n{sketch.read_text()}')
    return source


def run(command: Sequence[str | Path]) -> subprocess.CompletedProcess[str]:
    return subprocess.run(["qemu-arm", *command], capture_output=True, text=True, check=False)
