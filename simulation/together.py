"""Many sources compiled as one, which includes them all, where nobody asks for the object of each.

    for source in together(library_sources()):   # five files instead of 122

What each includes is read once, which is most of the time that compiling one takes. (A program in which one source is
replaced, by a mutant or a planted defect, is of single objects.)
"""

from __future__ import annotations

import os
import subprocess
from collections.abc import Sequence
from pathlib import Path

from simulation.firmware import LIBRARY, ROOT, digest, headers_digest

OUTPUT = ROOT / "build" / "together"
HOST = ROOT / "test" / "host"
CHECKED = ["clang++", "-fsyntax-only", "-w", "-x", "c++", "-std=c++11", "-DMAVMISSION_SIGNING=1",
           f"-I{LIBRARY}", f"-I{HOST / 'arduino'}", f"-I{HOST}"]  # fmt: skip
# That several sources have, each for itself.
SAME_NAMES = (
    "kListened", "Row", "kRows", "kCommands", "fromBits", "bitsOf", "kIntervalUs", "kModes", "kMostSpeed", "kLimit",
    "kPx4",
)  # fmt: skip
# That a source has for itself, and a class of a header too.
OWN_NAMES = {
    "VelocityTarget.cpp": ("Message", "sizeOf"),
    "EstimatorListener.cpp": ("kBeyond",),
    "VibrationListener.cpp": ("kBeyond",),
}
MOST = 30  # sources; of up to 64 nothing collides, but gcov counts otherwise in larger pieces


def together(sources: Sequence[Path]) -> list[Path]:
    """Files that include them. What is no C++ stays as it is."""
    grouped = [source for source in sources if source.suffix == ".cpp"]
    return [as_one(group) for group in groups(grouped)] + [source for source in sources if source not in grouped]


def groups(sources: Sequence[Path], most: int = MOST) -> list[list[Path]]:
    """The sources in groups that compile as one."""
    return [group for at in range(0, len(sources), most) for group in fitting(sources[at : at + most])]


def fitting(sources: Sequence[Path]) -> list[list[Path]]:
    """These in as few as will do: a source whose names another has too is in one of its own if need be."""
    if len(sources) > 1:
        file = as_one(sources)
        fits = OUTPUT / f"{digest(file.name, headers_digest(LIBRARY))[:16]}.fits"
        if not fits.exists():
            if subprocess.run([*CHECKED, file], capture_output=True, check=False).returncode != 0:
                middle = len(sources) // 2
                return [*fitting(sources[:middle]), *fitting(sources[middle:])]
            fits.touch()
    return [[*sources]]


def as_one(sources: Sequence[Path]) -> Path:
    """A source that includes all of them. Its text is another one when theirs is."""
    lines = []
    for number, source in enumerate(sources):
        own = OWN_NAMES.get(source.name, ())
        lines += [f"#undef {name}\n#define {name} {name}_{number}" for name in (*SAME_NAMES, *own)]
        lines.append(f'#include "{source}"  // NOLINT(bugprone-suspicious-include) {digest(source.read_bytes())[:16]}')
        lines += [f"#undef {name}" for name in own]
    text = "\n".join([*lines, ""])
    file = OUTPUT / f"together-{digest(text)[:16]}.cpp"
    if not file.exists():
        OUTPUT.mkdir(parents=True, exist_ok=True)
        fresh = file.with_suffix(f".{os.getpid()}")
        fresh.write_text(text)
        fresh.replace(file)
    return file
