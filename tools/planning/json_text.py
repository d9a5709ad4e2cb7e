"""JSON as QGroundControl writes it: names in order, four spaces, numbers to the digit."""

from __future__ import annotations

import json
from decimal import Decimal
from typing import Any

STEP = "    "


def json_text(value: Any) -> str:
    """The text of a document of objects, lists, texts, flags, whole numbers, Decimals and None."""
    return _text(value, "\n") + "\n"


def _text(value: Any, line: str) -> str:
    inner = line + STEP
    if isinstance(value, dict):
        members = [f"{json.dumps(key)}: {_text(value[key], inner)}" for key in sorted(value)]
        return _enclosed("{", members, "}", line)
    if isinstance(value, list):
        return _enclosed("[", [_text(entry, inner) for entry in value], "]", line)
    return f"{value:f}" if isinstance(value, Decimal) else json.dumps(value)


def _enclosed(first: str, parts: list[str], last: str, line: str) -> str:
    if not parts:
        return f"{first}{line}{last}"
    return f"{first}{line}{STEP}" + f",{line}{STEP}".join(parts) + f"{line}{last}"
