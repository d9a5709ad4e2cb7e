"""What is wrong with a plan, and where."""

from __future__ import annotations

from pathlib import Path


def cut(text: str, quote: str = "'") -> str:
    """A text of a file as a message shows it: its beginning, if it is long, and nothing that upsets a terminal."""
    shown = "".join(letter if letter.isprintable() else "?" for letter in text[:40])
    return f"{quote}{shown}{'...' if len(text) > 40 else ''}{quote}"


def shown_name(file: Path | str) -> str:
    """A file's name for a title or a comment: on one line, and as text that can be written."""
    name = Path(file).name
    return "".join(letter if letter.isprintable() else "?" for letter in name)


def shown(file: Path | str) -> str:
    """A file's path for a message."""
    return "".join(letter if letter.isprintable() else "?" for letter in str(file))


class BadPlan(Exception):
    """A file is no plan, or its plan cannot be used; the text is for a person, and says what to do.

    `line` counts from 1; None where the trouble has no line.
    """

    def __init__(self, file: Path | str, line: int | None, text: str) -> None:
        where = shown(file) if line is None else f"{shown(file)}:{line}"
        super().__init__(f"{where}: {text}")
        self.line = line
