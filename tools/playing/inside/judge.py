"""In the browser, in the place of tools/planning/judge.py: what the compiled library says of the commands, as a table.

The library itself judges a plan there too: on the emulated Mega, when it is to be uploaded.
"""

from __future__ import annotations

import functools
import json
from pathlib import Path

TABLE = Path(__file__).resolve().parent.parent / "known.json"


@functools.cache
def known() -> dict[int, bool]:
    """The commands in the library's table, and whether their items have neither a place nor an altitude."""
    return {int(command): flag for command, flag in json.loads(TABLE.read_text()).items()}
