"""A bench for a Vehicle and its listeners: simulation/sketches/vehicle.cpp beside a fake autopilot.

bench = VehicleBench("PX4")
bench.told("estimator")["reason"]    # the first time the listener is made: the message comes later
bench.words()                        # the mode's name, the fitness, the reason, as printed
bench.texts                          # (severity, text) of each text
"""

from __future__ import annotations

import re
from pathlib import Path

from simulation.enumerators import texts_of
from simulation.fake_autopilot import ardupilot_dialect, mavlink
from simulation.telemetry import Telemetry

_TEXT = re.compile(r"\d+ text (\d+) (.*)", re.DOTALL)

# The message of each listener, by autopilot.
MESSAGES = {
    "ArduPilot": {"health": mavlink.MAVLINK_MSG_ID_SYS_STATUS, "estimator": ardupilot_dialect.EKF_STATUS_REPORT,
                  "vibration": mavlink.MAVLINK_MSG_ID_VIBRATION, "wind": ardupilot_dialect.WIND},
    "PX4": {"health": mavlink.MAVLINK_MSG_ID_SYS_STATUS, "estimator": mavlink.MAVLINK_MSG_ID_ESTIMATOR_STATUS,
            "vibration": mavlink.MAVLINK_MSG_ID_VIBRATION, "wind": mavlink.MAVLINK_MSG_ID_WIND_COV},
}  # fmt: skip


class VehicleBench(Telemetry):
    source = Path(__file__).resolve().parent / "sketches" / "vehicle.cpp"

    def __init__(self, *arguments, **options) -> None:
        self.texts: list[tuple[int, str]] = []
        super().__init__(*arguments, **options)

    def _take_line(self, line: str) -> None:
        match = _TEXT.fullmatch(line)
        if match:
            self.texts.append((int(match[1]), match[2]))
        else:
            super()._take_line(line)

    def reason(self, listener: str) -> str:
        """Why it is not fit, by the enumerator's name; by "vehicle" the worst of all."""
        return reasons()[self.told(listener)["reason"]]

    def words(self) -> list[str]:
        """The mode's name, the fitness and its reason, as they are printed."""
        (line,) = self.tell("words")
        return line.split(" ", 3)[3].split("|")

    def intervals_asked(self) -> list[int]:
        """The message of each request for an interval."""
        return [int(entry.message.param1) for entry in self.wire.frames(">", "COMMAND_LONG")
                if entry.message.command == mavlink.MAV_CMD_SET_MESSAGE_INTERVAL]  # fmt: skip


def reasons() -> list[str]:
    return list(texts_of("Fitness.h", "MAVMISSION_FIT_REASONS"))
