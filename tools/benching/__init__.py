"""tools/bench: a real board, played against the simulated autopilots in real time.

`player` carries the bytes between the board's two ports and an autopilot, `scenarios` says what happens on the line,
`report` writes what came of it, `sketch` the board's sketch.
"""

from .player import NoBoard, Player
from .report import report
from .scenarios import SCENARIOS, Result, Scenario, play
from .sketch import write_sketch

__all__ = ["SCENARIOS", "NoBoard", "Player", "Result", "Scenario", "play", "report", "write_sketch"]
