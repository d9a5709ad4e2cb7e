"""ArduPilot 4.6.3 and PX4 1.17.0 as a client on a serial line sees them, in simulated time.

    autopilot = ArduPilot()
    autopilot.receive(bytes_from_the_client, now)
    bytes_for_the_client = autopilot.run(now)

They judge nothing: what a test wants to know is in plan(), received() and log. What is to go
wrong inside them is ordered through their `faults`; what is to go wrong on the way is the
business of wire.py.

Where a comment says "by source", the behaviour was read in the autopilot's source and never
observed; everything else was observed, most of it in simulation/recordings.
"""
from .ardupilot import ArduPilot
from .autopilot import FakeAutopilot, LogEntry
from .dialect import mavlink
from .items import ALL, FENCE, MISSION, RALLY, Item, item
from .px4 import Px4

__all__ = ["ALL", "FENCE", "MISSION", "RALLY", "ArduPilot", "FakeAutopilot", "Item",
           "LogEntry", "Px4", "item", "mavlink"]
