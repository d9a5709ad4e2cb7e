"""What a demonstration is asked for, and is looked at before anything is installed for it."""

from __future__ import annotations

from pathlib import Path

from building import BuildFailed, expect_sketch
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
        try:
            return expect_sketch(example)
        except BuildFailed as error:
            raise NoDemonstration(str(error)) from None
    raise NoDemonstration(f"there is no example {example}{did_you_mean(example, sorted(named))}")
