"""What a line and a loop do badly, for the tests to do."""

from __future__ import annotations

STREAMS = {"ArduPilot": "arducopter/clean_then_streams_10hz", "PX4": "px4/clean_with_streams"}

# Each so long [ms] the loop takes so much longer [ms].
STALLS = {5: (60, 5), 20: (110, 20), 100: (400, 100), 500: (1300, 500)}


DISORDERS = {
    "a third repeated": {"repeat": 33},
    "a third delayed": {"delay": 33},
    "a fifth overtaken": {"hold_past_next": 20},
    "all of these, and damage": {
        "repeat": 15,
        "delay": 15,
        "hold_past_next": 10,
        "corrupt": 5,
        "truncate": 5,
        "lose": 5,
    },  # fmt: skip
}
