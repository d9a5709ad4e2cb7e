"""Where the tests are: below test/, and beside the two products that have their own, tools/plan and its page."""

from __future__ import annotations

from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PRODUCTS = (ROOT / "tools" / "planning" / "test", ROOT / "tools" / "playing" / "test")
PLACES = (ROOT / "test", *PRODUCTS)


def folder_of(file: Path | str) -> str:
    """By which sample.toml and the budget name it: "upload" of test/upload/test_flow.py, "playing" of what is in
    tools/playing/test."""
    parts = Path(file).parts[:-1]
    return parts[-2] if parts[-1:] == ("test",) and len(parts) > 1 else parts[-1] if parts else str(file)


def files_of_tests() -> list[Path]:
    return sorted(file for place in PLACES for file in place.rglob("test_*.py"))
