"""docs/compiling.md quotes what the compilers print: each message is one that a must-not-compile test demands."""

from __future__ import annotations

import re
import tomllib

from building import ROOT
from refreshing.keywords import public_headers

PAGE = ROOT / "docs" / "compiling.md"
MISTAKES = tomllib.loads((ROOT / "test" / "proof" / "mistakes.toml").read_text())


def test_each_quoted_message_is_demanded_by_a_test():
    quoted = re.findall(r"^\| `([^`]+)` \|", PAGE.read_text(), re.M)
    demanded = {text for mistake in MISTAKES.values() for key, text in mistake.items() if key.startswith("expect")}
    on_other_boards = (ROOT / "test" / "boards" / "test_arm.py").read_text()
    assert len(quoted) > 10
    assert [message for message in quoted if message not in demanded and message not in on_other_boards] == []


def test_each_message_of_the_library_is_on_the_page():
    headers = "\n".join(file.read_text() for file in public_headers())
    impossible = r"(?:N == 0|sizeof\(Other\) == 0|!?literal::\w[^,]*)"
    templates = re.findall(rf'static_assert\(\s*{impossible},\s*((?:"[^"]*"\s*)+)\)', headers)
    said = ["".join(re.findall(r'"([^"]*)"', text)) for text in templates]
    assert len(said) > 6
    page = PAGE.read_text()
    quoted = re.findall(r"^\| `([^`]+)` \|", page, re.M)
    assert [text for text in said if not any(part in text for part in quoted)] == []
