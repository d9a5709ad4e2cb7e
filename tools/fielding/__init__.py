"""tools/field: the library beside an autopilot's own simulator.

`ardupilot` starts ArduPilot and is its physics, with the vehicles of `vehicles`; `world` keeps Mega, line and simulator
in step; `truth` is a ground station on a second port; `trials` plays the table of tools/benching, `flights` the part of
it that flies; `report` writes what came of it.
"""

from .ardupilot import ArduPilot
from .report import report
from .trials import Kept, Outcome, Runner, Trial, table

__all__ = ["ArduPilot", "Kept", "Outcome", "Runner", "Trial", "report", "table"]
