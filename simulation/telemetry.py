"""A bench for the listeners of telemetry: simulation/sketches/telemetry.cpp beside a fake autopilot.

bench = Telemetry("PX4")
bench.run(8.0)
bench.told("position")["sea"]    # what the listener's queries answer, as signed numbers
"""

from __future__ import annotations

from pathlib import Path

from simulation.bench import Bench
from simulation.fake_autopilot import mavlink

# The listeners, in the order in which they are declared, and their messages.
LISTENERS = {"position": 33, "attitude": 30, "battery": 147, "gps": 24, "rc": 65, "hud": 74}
HOME = {"home": 242}
WAYPOINT = {"waypoint": 62}  # with BENCH_WAYPOINT
NEVER = -1  # an age, as a signed number


class Telemetry(Bench):
    source = Path(__file__).resolve().parent / "sketches" / "telemetry.cpp"

    def told(self, listener: str) -> dict[str, int]:
        """What the listener says, by name: numbers of 32 bits, signed."""
        (line,) = self.tell(listener)
        words = line.split(" ")[3:]
        return {key: signed(int(number)) for key, _, number in (word.partition("=") for word in words)}

    def heard_all(self, *names: str) -> bool:
        return all(self.told(name)["heard"] for name in names)

    def asked(self, listener: str) -> list[tuple[float, float]]:
        """(when [s], interval [us]) of each request for the listener's message."""
        return [(entry.time, entry.message.param2) for entry in self.wire.frames(">", "COMMAND_LONG")
                if (entry.message.command, entry.message.param1)
                == (mavlink.MAV_CMD_SET_MESSAGE_INTERVAL, {**LISTENERS, **HOME, **WAYPOINT}[listener])]  # fmt: skip

    def run_until_confirmed(self, *names: str, limit_s: float = 10.0) -> None:
        limit = self.now + limit_s
        while not all(self.told(name)["confirmed"] for name in names):
            assert self.now < limit, f"nothing ended within {limit_s} s: not confirmed: {names}"
            self.run(0.1)


def signed(number: int) -> int:
    return number - 2**32 if number >= 2**31 else number
