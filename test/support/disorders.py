"""What a line and a loop do badly, for the tests to do."""

from __future__ import annotations

# Each so long [ms] the loop takes so much longer [ms].
STALLS = {5: (60, 5), 20: (110, 20), 100: (400, 100), 500: (1300, 500)}

# A line's latency each way [s]: a cable, WiFi, a telemetry radio, a modem. A random test takes one by its seed.
LATENCIES_S = (0.0, 0.03, 0.15, 0.5)


def latency_of(seed: int) -> float:
    return LATENCIES_S[seed % len(LATENCIES_S)]
