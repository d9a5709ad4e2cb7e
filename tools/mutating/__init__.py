"""Defects planted in the library one at a time, and the tests of this computer that must find each."""

import sys
from pathlib import Path

_ROOT = Path(__file__).resolve().parent.parent.parent
# The programs that find the defects are made of the tests' sources, by the simulated world's package.
for _folder in ("", "build/dialect", "tools"):
    if str(_ROOT / _folder) not in sys.path:
        sys.path.append(str(_ROOT / _folder))
