"""The compiler beside the page: a sketch that was written there, compiled, or what is wrong with it, at its lines."""

from __future__ import annotations

import fcntl
import re
from typing import Any

from building import BUILD, BuildFailed, build_sketch
from simulation.mega import Image

from .sketches import PASS

LONGEST = 100_000  # of a sketch [bytes]
NAME = "Written"
FOLDER = BUILD / "playground" / "written" / NAME
AT_LINE = re.compile(rf"{NAME}\.ino:(\d+)(?::\d+)?: (?:fatal )?error: (.*)")
MOST_ERRORS = 20


def compiled(source: str) -> dict[str, Any]:
    """{hex, flash, ram, pass}, or {errors}: [line or None, text] each."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    # One at a time, whoever asks: another request to this server, or another one beside it.
    with (FOLDER.parent / "lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        (FOLDER / f"{NAME}.ino").write_text(source)
        try:
            built = build_sketch(FOLDER, strict=False)
        except BuildFailed as error:
            return {"errors": errors_in(str(error))}
        image = Image.load(built.elf)
        made = {"hex": built.hex.read_text(), "flash": built.flash, "ram": built.ram}
        return {**made, "pass": image.symbol(PASS).address}


def errors_in(text: str) -> list[list]:
    """Those of the sketch's own lines; if there are none, the last that the compiler said."""
    found = [[int(line), words] for line, words in AT_LINE.findall(text)]
    return found[:MOST_ERRORS] or [[None, line] for line in text.splitlines() if "error" in line][-3:] or [[None, text]]
