"""Which of the generated things are stale, and writing those."""

from __future__ import annotations

import difflib
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path

from building import ROOT, made_with
from measuring import record

from .inputs import digest
from .things import MADE_FROM, SAMPLES, THINGS, Thing, in_order

MOST_LINES = 40  # that are told of a file's changes
Say = Callable[[str], None]


def chosen(names: Iterable[str]) -> list[Thing]:
    return [thing for thing in THINGS if not names or thing.name in names]


def inputs_of(thing: Thing) -> str:
    return digest(ROOT, thing.inputs, made_with())


def made_from(thing: Thing, inputs: str) -> str:
    """What is noted of it: of a section of the record its figures, too, so that none stands there unmeasured."""
    return f"{inputs} {digest(ROOT, (), repr(record.section(thing.name)))}" if thing.measure else inputs


def is_stale(thing: Thing) -> bool:
    """Of what names its inputs: whether they, or its figures, are others than when it was made last."""
    return record.load().get(MADE_FROM, {}).get(thing.name) != made_from(thing, inputs_of(thing))


def is_as_before(thing: Thing, sampled: record.Section) -> bool:
    known = record.load().get(SAMPLES, {}).get(thing.name, {})
    return all(old is not None and new is not None and abs(new - old) <= thing.share * abs(old)
               for _, old, new in record.pairs(known, sampled))  # fmt: skip


def check(things: Sequence[Thing], say: Say) -> bool:
    """Says what is stale; whether nothing is."""
    said = beyond_bounds(things)
    for thing in things:
        if thing.inputs and is_stale(thing):
            said.append(f"{thing.name}: what it is made of has changed")
        elif not thing.inputs:
            stale = [str(file.relative_to(ROOT)) for file in thing.stale_files()]
            said += [f"{thing.name}: {file} is not as it would be made" for file in stale]
    for line in said:
        say(line)
    return not said


def refresh(things: Iterable[Thing], say: Say, *, anyway: bool = False) -> None:
    """Makes what is stale, or all of it, and says what has changed."""
    record.refuse_other_tools(record.load())
    for thing in things:
        if not thing.inputs:
            write(thing, say)
        elif anyway or is_stale(thing):
            say(f"{thing.name}: what it is made of has changed")
            renew(thing, say, anyway=anyway)


def beyond_bounds(things: Iterable[Thing]) -> list[str]:
    return [f"{thing.name}: {line}" for thing in things if thing.measure for line in thing.broken()]


def raise_bounds(things: Iterable[Thing]) -> None:
    """Those that are broken, to 1 % beyond what is recorded."""
    whole = record.load()
    for thing in things:
        if thing.measure and thing.broken():
            whole[thing.name] = record.with_bounds(record.section(thing.name), whole[thing.name],
                                                   more_is_better=thing.more_is_better, may_raise=True)  # fmt: skip
    record.FILE.write_text(in_order(whole))


def renew(thing: Thing, say: Say, *, anyway: bool) -> None:
    inputs = inputs_of(thing)
    sampled = thing.sample() if thing.sample else {}
    if anyway or not sampled or not is_as_before(thing, sampled):
        write(thing, say)
        note(SAMPLES, thing.name, sampled)
    else:
        say(f"{thing.name}: its sample came out as before")
    note(MADE_FROM, thing.name, made_from(thing, inputs))


def note(part: str, name: str, value: object) -> None:
    """Keeps it in the record."""
    whole = {record.MADE_WITH: made_with(), **record.load()}
    noted = {**whole.get(part, {}), **({name: value} if value else {})}
    whole[part] = {thing.name: noted[thing.name] for thing in THINGS if thing.name in noted}
    record.FILE.write_text(in_order(whole))


def write(thing: Thing, say: Say) -> None:
    for file, data in thing.stale_files().items():
        before = file.read_bytes() if file.exists() else b""
        file.write_bytes(data)
        say(f"{thing.name}: {file.relative_to(ROOT)} is written anew")
        for line in changes(before, data, file):
            say(f"  {line}")


def changes(before: bytes, after: bytes, file: Path) -> list[str]:
    """The lines that have gone, and those that have come; nothing of a picture."""
    if file.suffix in (".svg", ".png"):
        return []
    lines = difflib.unified_diff(before.decode().splitlines(), after.decode().splitlines(), lineterm="", n=0)
    found = [line for line in lines if not line.startswith(("---", "+++", "@@"))]
    more = [f"... and {len(found) - MOST_LINES} lines more"] if len(found) > MOST_LINES else []
    return [*found[:MOST_LINES], *more]
