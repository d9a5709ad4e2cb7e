"""The constants of src/mavmission/base/RetryRules.h, which docs/design/retries.md has in words."""

from __future__ import annotations

import re

from simulation.firmware import library_file


def constants() -> dict[str, str]:
    """Struct::name -> value of each rule, as it is written there."""
    found: dict[str, str] = {}
    text = re.sub(r"//.*", "", library_file("RetryRules.h").read_text())
    for struct, code in re.findall(r"^struct (\w+) \{\n(.*?)^\};", text, re.M | re.S):
        for line in re.findall(r"static constexpr \w+ (.*?);", code):
            found |= {f"{struct}::{name}": value for name, value in re.findall(r"(k\w+) = ([^,]+)", line)}
        found |= {f"{struct}::{name}": value for name, value in
                  re.findall(r"static \w+ (\w+)\(\w+ count\) \{ return .*? \? (.*?) :", code)}  # fmt: skip
    return found


def number(name: str) -> int:
    """What a constant comes to: its value may name others, and be a sum."""
    known = constants()
    struct = name.partition("::")[0]

    def worth(part: str) -> int:
        return int(part) if part.isdigit() else number(part if part in known else f"{struct}::{part}")

    return sum(worth(part) for part in known[name].split(" + "))
