"""tools/field: the library beside an autopilot's own simulator.

`simulator` is what `ardupilot` and `px4` share, which start theirs and are its physics, with the vehicles of
`vehicles`; `world` keeps Mega, line and simulator in step; `truth` is a ground station on a second port; `trials` plays
the table of tools/benching, `flights` the part of it that flies; `report` writes what came of it.
"""

from .ardupilot import ArduPilot
from .px4 import Px4
from .report import report
from .trials import Kept, Outcome, Runner, Trial, table

__all__ = ["ArduPilot", "Kept", "Outcome", "Px4", "Runner", "Trial", "report", "table"]
