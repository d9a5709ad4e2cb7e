"""What is wrong with a plan, and where."""

from __future__ import annotations

from pathlib import Path


class BadPlan(Exception):
    """A file is no plan, or its plan cannot be used; the text is for a person, and says what to do.

    `line` counts from 1; None where the trouble has no line.
    """

    def __init__(self, file: Path | str, line: int | None, text: str) -> None:
        super().__init__(f"{file}:{line}: {text}" if line is not None else f"{file}: {text}")
        self.line = line
