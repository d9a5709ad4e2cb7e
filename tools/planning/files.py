"""A plan from a file and into one, by the file's suffix."""

from __future__ import annotations

from pathlib import Path

from . import qgc_plan, waypoints
from .bad_plan import BadPlan
from .exact import DoesNotFit
from .plan import Plan

READERS = {".plan": qgc_plan.read, ".waypoints": waypoints.read, ".txt": waypoints.read}
LARGEST = 20_000_000  # bytes; 65,535 items are some 15 MB


def read_plan(file: Path, unset_as_zero: bool = False) -> Plan:
    """The plan in a .plan, .waypoints or .txt file. `unset_as_zero`: null and NaN are 0. Raises BadPlan."""
    reader = READERS.get(file.suffix.lower())
    if reader is None:
        raise BadPlan(file, None, f"what kind of file is it? The suffixes known are {', '.join(READERS)}")
    return reader(file, text_of(file), unset_as_zero)


def text_of(file: Path) -> str:
    try:
        data = file.read_bytes()
    except OSError as error:
        raise BadPlan(file, None, f"cannot be read: {error.strerror}") from None
    if len(data) > LARGEST:
        raise BadPlan(file, None, f"is larger than {LARGEST // 1_000_000} MB: this is no plan")
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        raise BadPlan(file, line, "is no UTF-8 text") from None


def write_plan(plan: Plan, file: Path, part: str = "mission") -> list[str]:
    """Writes a plan; what the file does not carry. `part`: the kind of items in a .waypoints file. Raises BadPlan."""
    suffix = file.suffix.lower()
    if suffix not in READERS:
        raise BadPlan(file, None, f"what kind of file is it to be? The suffixes known are {', '.join(READERS)}")
    try:
        text, notes = qgc_plan.write(plan) if suffix == ".plan" else waypoints.write(plan, part)
    except DoesNotFit as error:
        raise BadPlan(plan.file, None, f"cannot be written as {file.name}: {error}") from None
    write_text(file, text)
    return notes


def write_text(file: Path, text: str) -> None:
    try:
        file.write_text(text, newline="\n")
    except OSError as error:
        raise BadPlan(file, None, f"cannot be written: {error.strerror}") from None
