"""The library with a defect planted in it."""

from __future__ import annotations

import os
from pathlib import Path

from simulation.firmware import ROOT, digest, library_file, library_sources


def with_defect(file: str, right: str, wrong: str) -> tuple[Path, ...]:
    """The library's sources, the one of this name a copy in which `right`, which must be there once, is `wrong`."""
    source = library_file(file)
    text = source.read_text()
    assert text.count(right) == 1, f"{source}: the line that the defect is planted in has changed: {right}"
    changed = text.replace(right, wrong).replace('#include "', f'#include "{source.parent}/')
    copy = ROOT / "build" / "planted" / digest(changed)[:12] / file
    if not copy.exists():
        copy.parent.mkdir(parents=True, exist_ok=True)
        fresh = copy.with_suffix(f".{os.getpid()}")
        fresh.write_text(changed)
        fresh.replace(copy)
    return tuple(copy if path == source else path for path in library_sources())
