"""tools/field: the library beside an autopilot's own simulator.

`ardupilot` and `px4` start theirs and are its physics, with a vehicle of `vehicles`; `world` keeps Mega, line and
simulator in step; `truth` is a ground station on a second port; `trials` plays the table of tools/benching.
"""

from .ardupilot import ArduPilot
from .px4 import Px4
from .report import report
from .trials import Kept, Outcome, Runner, Trial, table

__all__ = ["ArduPilot", "Kept", "Outcome", "Px4", "Runner", "Trial", "report", "table"]
