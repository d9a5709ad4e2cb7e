"""What a demonstration is asked for, and is looked at before anything is installed for it."""

from __future__ import annotations

from pathlib import Path

from examples import example_folders
from near import did_you_mean


class NoDemonstration(Exception):
    """It cannot be shown; the text says why and what to do."""


def sketch(example: str) -> Path:
    """The folder of an example by its name, or any sketch by its path."""
    named = example_folders()
    if example in named:
        return named[example]
    if Path(example).exists():
        return Path(example)
    raise NoDemonstration(f"there is no example {example}{did_you_mean(example, sorted(named))}")


def expect_place(file: Path | None) -> None:
    """Of what is to be written."""
    if file is not None and not file.parent.is_dir():
        raise NoDemonstration(f"cannot write {file}: there is no folder {file.parent}")
    if file is not None and file.is_dir():
        raise NoDemonstration(f"cannot write {file}: it is a folder")
