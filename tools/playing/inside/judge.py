"""In the browser, in the place of tools/planning/judge.py: what the compiled library says of the commands, as a table,
and its reader of .waypoints as WebAssembly.

The library itself judges a plan there too: on the emulated Mega, when it is to be uploaded.
"""

from __future__ import annotations

import functools
import json
import struct
from pathlib import Path

from planning.plan import KINDS, Item, ReadText

TABLE = Path(__file__).resolve().parent.parent / "known.json"
ERRORS = TABLE.with_name("errors.json")
ITEM, HOME, BAD, END = 1, 2, 3, 4  # TextReading::Event
LAYOUT = struct.Struct("<4f2if H3B")  # mavmission::MissionItem


@functools.cache
def known() -> dict[int, int]:
    """The commands in the library's table, as tools/planning/judge.py gives them."""
    return {int(command): flag for command, flag in json.loads(TABLE.read_text()).items()}


def text(lines: str) -> ReadText:
    """What the library's reader makes of a .waypoints text, whose characters are its bytes."""
    from hearing import exports  # type: ignore[import-not-found]  # only in the page's worker

    data, at = lines.encode("latin-1"), 0
    home: Item | None = None
    items: list[tuple[int, Item]] = []
    exports.text_begin()
    while True:
        piece = data[at : at + exports.size_of_room()]
        exports.put(piece)
        at += exports.text_take(len(piece))
        event, line = exports.text_event(), exports.text_line()
        if event in (ITEM, HOME):
            packed = exports.bytes_at(exports.text_item(), LAYOUT.size).to_bytes()
            *numbers, command, frame, current, autocontinue = LAYOUT.unpack(packed)
            item = Item._make((frame, command, current, autocontinue, *numbers))
            if event == HOME:
                home = item
            else:
                items.append((line - 1, item))
        elif event == BAD:
            name, words = list(json.loads(ERRORS.read_text()).items())[exports.text_error()]
            return ReadText(home, items, "mission", name, words, line, exports.text_field())
        elif event == END:
            return ReadText(home, items, KINDS[exports.text_type()])
