"""An example run on the simulated Mega against a simulated autopilot, for a person to watch.

from demonstration import Demonstration, Settings
Demonstration(Settings("UploadMission", autopilot="px4", loss_percent=10)).run()
"""

from .demonstration import Demonstration, NoDemonstration, Settings, Verdict
from .named_frames import BadName, NamedFrame

__all__ = ["BadName", "Demonstration", "NamedFrame", "NoDemonstration", "Settings", "Verdict"]
