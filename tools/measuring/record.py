"""test/figures/measured.toml: each figure as it was measured last, to the byte and the cycle, and what it may become.

    [stack]
    "upload()" = [6, 7]    # 6 bytes were measured, 7 are its bound

A figure without a bound stands alone. Bounds are 1 % beyond what was measured, at least one byte or cycle, and only
tighten, but for tools/refresh --raise.
"""

from __future__ import annotations

import json
import math
import re
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from building import ROOT, made_with

FILE = ROOT / "test" / "figures" / "measured.toml"
SHARE = 0.01  # of a figure: what a bound leaves, and how far off what is recorded may be
MADE_WITH = "made_with"  # the key of the compiler, the core and the flags that all of it was measured with
HEAD = """\
# Each figure as it was last measured, and its bound, by tools/refresh. CONTRIBUTING.md has more: "What is generated".
"""

# A number, or several by name. Of a record some are pairs: the figure and its bound.
Section = dict[str, Any]


class BadRecord(Exception):
    """The file is not as it should be; the text says what to do."""


def load(file: Path | None = None) -> dict[str, Any]:
    file = file or FILE
    try:
        return tomllib.loads(file.read_text()) if file.exists() else {}
    except tomllib.TOMLDecodeError as error:
        raise BadRecord(f"{file}: {error}; take the faulty lines away, and run tools/refresh") from error


def section(name: str) -> Section:
    """As measured, without its bounds."""
    return measured(load().get(name, {}))


def measured(entry: Any) -> Any:
    if isinstance(entry, dict):
        return {name: measured(value) for name, value in entry.items()}
    return entry[0] if isinstance(entry, list) else entry


def refuse_other_tools(record: dict[str, Any]) -> None:
    """Raises BadRecord where it was measured with another compiler, core or flags than are here."""
    theirs, ours = record.get(MADE_WITH), made_with()
    if theirs not in (None, ours):
        raise BadRecord(f"{FILE.name} was measured with {theirs}, and this would be {ours}: they cannot be compared;"
                        f" to measure all of it anew, take away its line {MADE_WITH} and its bounds")  # fmt: skip


def three_digits(value: float) -> float:
    """As the documents have it: the rest changes with every line of the library."""
    return round(value, 3 - len(str(int(abs(value))))) if abs(value) >= 1000 else value


def bound_of(value: float, *, more_is_better: bool = False) -> float:
    """1 % beyond it, in steps of its last digit, at least one step; 0 is to stay 0."""
    step = 10 ** -len(repr(value).partition(".")[2]) if isinstance(value, float) else 1
    steps = math.ceil(round(abs(value) * SHARE / step, 6)) * (-1 if more_is_better else 1)
    return round(value + steps * step, 6)


def with_bounds(fresh: Any, old: Any, *, more_is_better: tuple[str, ...] = (), may_raise: bool = False,
                name: str = "") -> Any:  # fmt: skip
    """What to record of a figure, or of several: those measured now, and for each the tighter of both bounds.
    `may_raise`: where the old bound is broken, the new one."""
    if isinstance(fresh, dict):
        known = old if isinstance(old, dict) else {}
        return {part: with_bounds(value, known.get(part), more_is_better=more_is_better, may_raise=may_raise, name=part)
                for part, value in fresh.items()}  # fmt: skip
    is_more = name in more_is_better
    bound = bound_of(fresh, more_is_better=is_more)
    if not isinstance(old, list) or (may_raise and is_broken(fresh, old[1], is_more)):
        return [fresh, bound]
    return [fresh, max(bound, old[1]) if is_more else min(bound, old[1])]


def is_broken(value: float, bound: float, more_is_better: bool) -> bool:
    return value < bound if more_is_better else value > bound


def pairs(recorded: Section, fresh: Section, before: str = "") -> Iterator[tuple[str, Any, Any]]:
    """(name, what the record says, what was measured); None where one has no such figure."""
    for name in dict.fromkeys([*recorded, *fresh]):
        old, new = recorded.get(name), fresh.get(name)
        if isinstance(old, dict) and isinstance(new, dict):
            yield from pairs(old, new, f"{before}{name}, ")
        else:
            yield f"{before}{name}", old, new


def beyond(recorded: Section, fresh: Section, *, more_is_better: tuple[str, ...] = ()) -> list[str]:
    """In words, each figure that has passed its bound, or is more than 1 % away from what is recorded, so that a reader
    would call the record wrong."""
    found = []
    for name, old, new in pairs(recorded, fresh):
        was, bound = measured(old), old[1] if isinstance(old, list) else None
        is_missing = was is None or new is None
        if not is_missing and bound is not None and is_broken(new, bound, name.rpartition(", ")[2] in more_is_better):
            found.append(f"{name}: {new} is beyond its bound {bound}")
        elif is_missing or abs(new - was) > bound_of(abs(was)) - abs(was):
            found.append(f"{name}: {was} is recorded, and {new} was measured: run tools/refresh")
    return found


def text_of(record: dict[str, Any]) -> str:
    """The file."""
    lines = [HEAD]
    for name, entry in record.items():
        if isinstance(entry, dict):
            lines += [f"\n[{key_of(name)}]\n", *(f"{key_of(key)} = {written(part)}\n" for key, part in entry.items())]
        else:
            lines.append(f"{key_of(name)} = {written(entry)}\n")
    return "".join(lines)


def written(value: Any) -> str:
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key_of(name)} = {written(part)}" for name, part in value.items()) + " }"
    if isinstance(value, list):
        return f"[{', '.join(map(written, value))}]"
    return json.dumps(value, ensure_ascii=False) if isinstance(value, str) else repr(value)


def key_of(name: str) -> str:
    return name if re.fullmatch(r"[A-Za-z0-9_-]+", name) else json.dumps(name, ensure_ascii=False)
