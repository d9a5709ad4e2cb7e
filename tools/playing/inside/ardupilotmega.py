"""In the browser, in the place of pymavlink's module of this name: of its enumerations MAV_CMD, from a table."""

from __future__ import annotations

import json
from pathlib import Path
from types import SimpleNamespace

_TABLE = Path(__file__).resolve().parents[3] / "commands.json"

MAV_CMD_ENUM_END = -1


def _entry(values: dict) -> SimpleNamespace:
    by_number = {key: {int(number): text for number, text in values[key].items()} for key in ("param", "label")}
    return SimpleNamespace(name=values["name"], has_location=values["has_location"], **by_number)


enums = {"MAV_CMD": {int(command): _entry(values)
                     for command, values in json.loads(_TABLE.read_text())["entries"].items()}}  # fmt: skip
