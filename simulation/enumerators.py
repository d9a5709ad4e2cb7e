"""The library's enumerations as its headers list them, each enumerator with its text."""

from __future__ import annotations

import re
from functools import cache

from simulation.firmware import library_file


@cache
def texts_of(header: str, list_name: str) -> dict[str, str]:
    """Enumerator -> text, in order, of a list such as MAVMISSION_STATUSES in the library's `header`."""
    text = library_file(header).read_text().partition(f"#define {list_name}(X)")[2].partition("enum class")[0]
    return dict(re.findall(r'X\((\w+),\s*"([^"]*)"', text))
