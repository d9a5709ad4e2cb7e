"""The tables of DESIGN.md that are measured."""

from __future__ import annotations

from building import ROOT

from . import bounds, budget, flash, quieting, signing, work
from .document import with_table

FILE = ROOT / "DESIGN.md"
# By the name in their marks.
TABLES = {
    budget.MARK: budget.table,
    "goals": bounds.goals_missed,
    "flash budget": flash.table,
    "quiet transfers": quieting.table,
    "signing": signing.table,
    "work": work.table,
}


def written(document: str) -> str:
    """The document with every table as it is measured now."""
    for name, table in TABLES.items():
        document = with_table(document, name, table())
    return document
