"""JSON that remembers the line of each value, and keeps numbers as they are written.

document = parse(Path("farm.plan"), text)
document.need("mission").need("items").array()[3].line
"""

from __future__ import annotations

import re
from decimal import Decimal
from json.decoder import JSONDecodeError, scanstring  # type: ignore[attr-defined]  # typeshed leaves it out
from pathlib import Path
from typing import Any

from .bad_plan import BadPlan, cut
from .exact import MOST_CHARACTERS
from .progress import Progress

_SPACE = re.compile(r"[ \t\r\n]*")
_NUMBER = re.compile(r"-?(?:0|[1-9][0-9]*)(?:\.[0-9]+)?(?:[eE][-+]?[0-9]+)?")
_WORDS = {"true": True, "false": False, "null": None}
DEEPEST = 60  # a plan has ten levels

KINDS = {
    dict: "an object {...}",
    list: "a list [...]",
    str: "a text",
    Decimal: "a number",
    bool: "true or false",
    type(None): "null",
}


class Value:
    """A value, where it stands, and how a person would call it."""

    def __init__(self, file: Path, line: int, raw: Any, name: str = "the file") -> None:
        self.file, self.line, self.raw, self.name = file, line, raw, name

    def bad(self, text: str) -> BadPlan:
        return BadPlan(self.file, self.line, text)

    def _as(self, kind: type) -> Any:
        if not isinstance(self.raw, kind):
            raise self.bad(f"{self.name} must be {KINDS[kind]}, and is {KINDS[type(self.raw)]}")
        return self.raw

    def get(self, key: str) -> Value | None:
        """The member of an object, if it is there."""
        return self._as(dict).get(key)

    def need(self, key: str) -> Value:
        if (member := self.get(key)) is None:
            raise self.bad(f'{self.name} has no "{key}"')
        return member

    def called(self, name: str) -> Value:
        self.name = name
        return self

    def members(self) -> dict[str, Value]:
        return self._as(dict)

    def array(self) -> list[Value]:
        return self._as(list)

    def text(self) -> str:
        return self._as(str)

    def flag(self) -> bool:
        return self._as(bool)

    def number(self) -> Decimal:
        return self._as(Decimal)

    def number_or_null(self) -> Decimal | None:
        return None if self.raw is None else self.number()

    def whole(self, among: range) -> int:
        number = self.number()
        if number.adjusted() > 18 or number % 1 != 0 or int(number) not in among:
            raise self.bad(f"{self.name} must be a whole number from {among[0]} to {among[-1]}, and is {number}")
        return int(number)


def parse(file: Path, text: str) -> Value:
    """The value of a whole text; BadPlan, with the line, for what is no JSON."""
    return _Reader(file, text).document()


class _Reader:
    def __init__(self, file: Path, text: str) -> None:
        self._file, self._text, self._at, self._depth = file, text, 0, 0
        self._counted, self._line = 0, 1

    def document(self) -> Value:
        self._skip()
        with Progress("values read") as self._progress:
            value = self._value("the file")
        self._skip()
        if self._at != len(self._text):
            raise self._bad("there is more behind the end of the plan")
        return value

    def _here(self) -> int:
        """The line of the place that is read."""
        self._line += self._text.count("\n", self._counted, self._at)
        self._counted = self._at
        return self._line

    def _bad(self, text: str) -> BadPlan:
        if self._at >= len(self._text):
            text = "the file ends in the middle: it was cut off" if self._text.strip() else "the file is empty"
        return BadPlan(self._file, self._here(), text)

    def _skip(self) -> None:
        space = _SPACE.match(self._text, self._at)
        assert space is not None, "it matches nothing as well"
        self._at = space.end()

    def _next(self) -> str:
        self._skip()
        return self._text[self._at : self._at + 1]

    def _take(self, character: str, what: str) -> None:
        if self._next() != character:
            raise self._bad(f"this is no JSON: {what} is missing before {self._seen()}")
        self._at += 1

    def _seen(self) -> str:
        return repr(self._text[self._at : self._at + 12].split("\n")[0])

    def _value(self, name: str) -> Value:
        self._progress.step()
        first, line = self._next(), self._here()
        if first in "{[" and first:
            self._depth += 1
            if self._depth > DEEPEST:
                raise self._bad(f"lists and objects are nested more than {DEEPEST} deep: this is no plan")
            raw: Any = self._object() if first == "{" else self._array(name)
            self._depth -= 1
        elif first == '"':
            raw = self._string()
        else:
            raw = self._plain()
        return Value(self._file, line, raw, name)

    def _object(self) -> dict[str, Value]:
        self._at += 1
        members: dict[str, Value] = {}
        while self._next() != "}":
            if members:
                self._take(",", "a comma")
            if self._next() != '"':
                raise self._bad(f"this is no JSON: a name in quotes must stand before {self._seen()}")
            key = self._string()
            if key in members:
                raise self._bad(f"{cut(key, chr(34))} is there twice")
            self._take(":", "a colon")
            members[key] = self._value(cut(key, '"'))
        self._at += 1
        return members

    def _array(self, name: str) -> list[Value]:
        self._at += 1
        values: list[Value] = []
        while self._next() != "]":
            if values:
                self._take(",", "a comma")
            values.append(self._value(f"{name}, entry {len(values) + 1},"))
        self._at += 1
        return values

    def _string(self) -> str:
        try:
            text, self._at = scanstring(self._text, self._at + 1, True)
        except JSONDecodeError as error:
            self._at = len(self._text) if error.msg.startswith("Unterminated") else error.pos
            raise self._bad(f"this is no JSON: {error.msg}") from None
        return text

    def _plain(self) -> Any:
        for word, value in _WORDS.items():
            if self._text.startswith(word, self._at):
                self._at += len(word)
                return value
        match = _NUMBER.match(self._text, self._at)
        if not match:
            raise self._bad(f"this is no JSON: {self._seen()} is no value")
        if len(match[0]) > MOST_CHARACTERS:
            raise self._bad(f"a number of {len(match[0]):,} characters: none of more than {MOST_CHARACTERS} is read")
        self._at = match.end()
        return Decimal(match[0])
