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
# Of the linker, whose lines say nothing of the sketch's.
NOWHERE = re.compile(r"undefined reference to `(.*?)'")
TOO_LARGE = re.compile(r"region `(data|text)'")
MEMORY = {"data": "RAM", "text": "flash"}
MOST_ERRORS = 20


def compiled(source: str) -> dict[str, Any]:
    """{hex, flash, ram, pass}, or {errors}: [line or None, text] each. pass: 0 if the sketch uses no serial port."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    # One at a time, whoever asks: another request to this server, or another one beside it.
    with (FOLDER.parent / "lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        (FOLDER / f"{NAME}.ino").write_text(source)
        try:
            built = build_sketch(FOLDER, strict=False)
        except BuildFailed as error:
            return {"errors": errors_in(str(error))}
        passes = next((one.address for one in Image.load(built.elf).symbols if one.is_called(PASS)), 0)
        return {"hex": built.hex.read_text(), "flash": built.flash, "ram": built.ram, "pass": passes}


def errors_in(text: str) -> list[list]:
    """Those of the sketch's own lines; if there are none, what is missing or too large, or what the compiler said."""
    found = [[int(line), words] for line, words in AT_LINE.findall(text)]
    found = found or [[None, f"nothing defines {name}"] for name in dict.fromkeys(NOWHERE.findall(text))]
    found = found or [[None, f"more {MEMORY[region]} than a Mega has"] for region in set(TOO_LARGE.findall(text))]
    return found[:MOST_ERRORS] or [[None, line] for line in text.splitlines() if "error" in line][-3:] or [[None, text]]
