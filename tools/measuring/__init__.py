"""Sizes, cycles and times of the library, beside those of the baseline.

All of it is counted by the linker or by the simulated Mega, to the byte and to the cycle:
two runs give the same figures.
"""

import sys
from pathlib import Path

_ROOT = Path(__file__).resolve().parent.parent.parent
# The recordings and the firmware's builder are those of the tests.
for _folder in ("build/dialect", "test", "tools"):
    if str(_ROOT / _folder) not in sys.path:
        sys.path.append(str(_ROOT / _folder))
