"""An example run on the simulated Mega against a simulated autopilot, for a person to watch.

    from demonstration import Demonstration, Settings
    Demonstration(Settings("UploadMission", autopilot="px4", loss_percent=10)).run()
"""

import sys
from pathlib import Path

_ROOT = Path(__file__).resolve().parent.parent.parent
# The simulated autopilot and the faulty wire are those of the tests.
for _folder in ("build/dialect", "test", "tools"):
    if str(_ROOT / _folder) not in sys.path:
        sys.path.append(str(_ROOT / _folder))

from .demonstration import Demonstration, NoDemonstration, Settings, Verdict  # noqa: E402
from .named_frames import BadName, NamedFrame  # noqa: E402

__all__ = ["BadName", "Demonstration", "NamedFrame", "NoDemonstration", "Settings", "Verdict"]
