"""The values in the table of docs/design/retries.md are those of src/mavmission/base/RetryRules.h."""

from __future__ import annotations

import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
DOCUMENT = ROOT / "docs" / "design" / "retries.md"
SOURCE = ROOT / "src" / "mavmission" / "base" / "RetryRules.h"
CONSTANT = re.compile(r"`(\w+::\w+)` = ([^,|]+?)(?=,| \|)")


def values(code: str) -> dict[str, str]:
    """Struct::name -> value of each rule."""
    found: dict[str, str] = {}
    for struct, body in re.findall(r"^struct (\w+) \{\n(.*?)^\};", code, re.M | re.S):
        constants = re.sub(r"//.*", "", body)
        for line in re.findall(r"static constexpr \w+ (.*?);", constants):
            found |= {f"{struct}::{name}": value for name, value in re.findall(r"(k\w+) = ([^,]+)", line)}
        found |= {f"{struct}::{name}": value for name, value in
                  re.findall(r"static \w+ (\w+)\(\w+ count\) \{ return .*? \? (.*?) :", constants)}  # fmt: skip
    return found


def with_values(text: str, known: dict[str, str]) -> str:
    """The document with the code's value behind each constant. Raises KeyError for one that the code has not."""
    return CONSTANT.sub(lambda found: f"`{found[1]}` = {known[found[1]]}", text)


def documented_s(rule: str) -> float:
    """What the document says of a rule whose name ends in Ms [s]. Raises StopIteration if it does not name it."""
    return next(int(value) for name, value in CONSTANT.findall(DOCUMENT.read_text()) if name == rule) / 1000


def document() -> str:
    """As it is to be."""
    return with_values(DOCUMENT.read_text(), values(SOURCE.read_text()))
