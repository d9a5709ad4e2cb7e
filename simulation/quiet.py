"""A bench for TelemetryPause: simulation/sketches/quiet.cpp beside a fake autopilot that fills the line with telemetry.

    bench = Quiet("PX4")
    bench.run(4.0)
    bench.tell("upload", 50)
    bench.run_until_ended(limit_s=10)
    bench.telemetry(bench.now - 1.0, bench.now)     # {message id: bytes}
"""

from __future__ import annotations

import itertools
import re
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

from simulation import recordings
from simulation.bench import Bench
from simulation.fake_autopilot import ArduPilot, mavlink
from simulation.fake_autopilot.frames import message_id
from simulation.firmware import library_file

SOURCE = library_file("TelemetryPause.cpp")
ASKED_FOR_HZ = 10  # each stream, in ArduPilot's recording
RECORDED = {"ArduPilot": "arducopter/clean_then_streams_10hz", "PX4": "px4/clean_with_streams"}
_NO_STREAM = ("HEARTBEAT", "STATUSTEXT", "TIMESYNC", "PARAM_VALUE", "MISSION_", "COMMAND_")


def default_list(personality: str) -> list[int]:
    """The ids that the library silences, in its order."""
    name = {"ArduPilot": "kArduPilots", "PX4": "kPx4s"}[personality]
    table = SOURCE.read_text().partition(f"{name}[] PROGMEM = {{")[2].partition("};")[0]
    return [int(number) for number in re.findall(r"\{(\d+), 0\}", table)]


def evenly(personality: str, baud: int) -> Iterator[tuple[float, bytes]]:
    """Every recorded message of telemetry at the same rate, as fast as a line takes them, for ever."""
    frames = {message_id(frame): frame for _, frame in recordings.telemetry(RECORDED[personality])}
    time = 0.0
    for frame in itertools.cycle(frames.values()):
        yield time, frame
        time += recordings.BITS_PER_BYTE * len(frame) / baud


def recorded(personality: str, baud: int = 57600) -> Iterator[tuple[float, bytes]]:
    """What the autopilot sent in the recordings, in its proportions, as fast as a line takes it, for ever."""
    return recordings.saturated(RECORDED[personality], baud)


def as_recorded(personality: str) -> dict:
    """Options of a fake autopilot on a line of 57600 baud that it fills as in the recordings.

    An ArduPilot that was asked for each message ten times a second has more to send than the line takes: what is left
    out comes again as soon as there is room, and a transmit buffer full of telemetry stands before each answer. PX4
    sends what its line takes, and answers at once.
    """
    if personality != "ArduPilot":
        return {"telemetry": recorded(personality)}
    sizes = {message_id(frame): len(frame) for _, frame in recordings.telemetry(RECORDED[personality])}
    share = ASKED_FOR_HZ * sum(sizes.values()) * recordings.BITS_PER_BYTE / 57600
    telemetry = recordings.saturated(RECORDED[personality], 57600, share)
    return {"telemetry": telemetry, "transmit_buffer": ArduPilot.transmit_buffer_seen}


class Quiet(Bench):
    """The line is full of telemetry, each message at the same rate, unless `telemetry` says otherwise."""

    source = Path(__file__).resolve().parent / "sketches" / "quiet.cpp"

    def __init__(self, personality: str = "ArduPilot", *, baud: int = 57600, **options) -> None:
        filled = {"telemetry": evenly(personality, baud), **options}
        super().__init__(personality, baud=baud, **filled)

    def telemetry(self, begin: float, end: float) -> Counter[int]:
        """Bytes of each message that the autopilot streamed from `begin` to `end` [s]."""
        counted: Counter[int] = Counter()
        for entry in self.wire.frames("<"):
            name = entry.message.get_type() if entry.message is not None else ""
            if begin <= entry.time < end and not name.startswith(_NO_STREAM):
                counted[message_id(entry.data)] += len(entry.data)
        return counted

    def rates(self, seconds: float = 2.0) -> dict[int, float]:
        """Bytes per second of each message of telemetry, from now on."""
        began = self.now
        self.run(seconds)
        return {identity: count / seconds for identity, count in self.telemetry(began, self.now).items()}

    @property
    def asked(self) -> list[tuple[float, int, float]]:
        """(when [s], message, interval [us]) of each SET_MESSAGE_INTERVAL that has left."""
        return [(entry.time, int(entry.message.param1), entry.message.param2)
                for entry in self.wire.frames(">", "COMMAND_LONG")
                if entry.message.command == mavlink.MAV_CMD_SET_MESSAGE_INTERVAL]  # fmt: skip

    def asked_since(self, time: float, interval_us: float) -> list[int]:
        return [identity for when, identity, interval in self.asked if when >= time and interval == interval_us]

    def _flag(self, name: str) -> bool:
        (line,) = self.tell("quiet")
        words = line.split(" ")
        return bool(int({"quiet": words[2], "idle": words[3].partition("=")[2]}[name]))

    @property
    def is_quiet(self) -> bool:
        return self._flag("quiet")

    @property
    def is_idle(self) -> bool:
        return self._flag("idle")

    def run_until_quiet(self, limit_s: float = 5.0) -> None:
        limit = self.now + limit_s
        while not self.is_quiet:
            assert self.now < limit, f"not quiet within {limit_s} s"
            self.run(0.02)

    def upload_quietly(self, items: int, limit_s: float = 5.0) -> None:
        """Begin an upload, and go on until the line is quiet."""
        self.tell("upload", items)
        self.run_until_quiet(limit_s)

    def transfer_s(self, used: bool, items: int) -> float:
        """From COUNT to the acceptance [s], with the line as quiet as it gets or as it is."""
        if used:
            self.run_until_idle()
        else:
            self.tell("used", 0)
        self.run_until(3.0)
        self.tell("upload", items)
        assert self.run_until_ended(limit_s=20) == "Accepted"
        return self.wire.frames("<", "MISSION_ACK")[-1].time - self.wire.frames(">", "MISSION_COUNT")[-1].time

    def read_back_s(self, used: bool, items: int) -> float:
        """The same of a plan that is read back, from REQUEST_LIST to the last item [s]."""
        self.transfer_s(used, items)
        if used:
            self.run_until_idle(limit_s=10)
        self.run(3.0)
        self.tell("verify", items)
        assert self.run_until_ended(limit_s=60) == "Verified"
        asked, read = self.wire.frames(">", "MISSION_REQUEST_LIST"), self.wire.frames("<", "MISSION_ITEM_INT")
        return read[-1].time - asked[-1].time

    def run_until_idle(self, limit_s: float = 5.0) -> None:
        limit = self.now + limit_s
        while not self.is_idle:
            assert self.now < limit, f"not idle within {limit_s} s"
            self.run(0.05)
