"""docs/items.md has every function that makes an item, as the header and the rules are now."""

from __future__ import annotations

import re

from measuring import documents
from refreshing import items

PAGE = items.DOCUMENT.read_text()


def test_page_is_made_of_the_header_and_of_the_rules():
    assert documents.with_table(PAGE, "items", items.tables()) == PAGE, "run tools/refresh items"


def test_every_function_that_makes_an_item_is_on_the_page():
    makers = set(re.findall(r"^constexpr MissionItem (\w+)\(", items.HEADER.read_text(), re.M))
    assert makers and all(f"`{name}(" in PAGE for name in makers)
