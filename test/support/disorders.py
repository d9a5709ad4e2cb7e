"""What a line and a loop do badly, for the tests to do."""

from __future__ import annotations

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
    },
}


# A line's latency each way [s]: a cable, WiFi, a telemetry radio, a modem. A random test takes one by its seed.
LATENCIES_S = (0.0, 0.03, 0.15, 0.5)


def latency_of(seed: int) -> float:
    return LATENCIES_S[seed % len(LATENCIES_S)]
