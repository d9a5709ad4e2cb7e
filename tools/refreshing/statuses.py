"""What is printed for a status, behind its name, in the pages that explain it: `Accepted` ("accepted: ...")."""

from __future__ import annotations

import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGES = ("README.md", "docs/troubleshooting.md")
EXPLAINED = re.compile(r'`(\w+)` \("[^"]*"\)')


def pages() -> dict[Path, bytes]:
    """Each page with the present texts."""
    # Imported here, since `tools/refresh --list` works where the packages of the simulation are not installed.
    from simulation.enumerators import texts_of

    texts = texts_of("Status.h", "MAVMISSION_STATUSES")
    return {
        ROOT / page: EXPLAINED.sub(lambda name: f'`{name[1]}` ("{texts[name[1]]}")', (ROOT / page).read_text()).encode()
        for page in PAGES
    }
