"""Reading and writing what autopilots said (see README.md beside this file)."""
import csv
import itertools
from collections.abc import Iterator, Sequence
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

from simulation.fake_autopilot import frames

FOLDER = Path(__file__).resolve().parent

# Messages that a fake autopilot makes itself: its telemetry must not hold them twice.
_ITS_OWN = {"HEARTBEAT", "TIMESYNC", "PARAM_VALUE", "STATUSTEXT", "COMMAND_ACK"}

# While an autopilot sent its telemetry at the usual rates.
WITH_STREAMS = {"ArduPilot": "arducopter/clean_then_streams_10hz", "PX4": "px4/clean_with_streams"}

BITS_PER_BYTE = 10  # on an asynchronous serial line: start, eight, stop


class Heard(NamedTuple):
    """One frame of a recording."""

    time: float  # [s], when its last byte was read
    direction: str  # '>' to the autopilot, '<' from it
    message: Any
    frame: bytes


_LOSSY = "lossy_"
_FTP = "ftp_"
_GUIDED = "guided_"
_PARAMETERS = "params"
_MODES = "modes"
_SIGNING = "signing"
_OF_STARTS = ("start_", "mission_", "set_current_", "auto_and_arming", "request_messages")


def names() -> list[str]:
    """All recordings of transfers, as "px4/item_lost"."""
    of_others = (*_OF_STARTS, _LOSSY, _FTP, _GUIDED, _PARAMETERS, _MODES, _SIGNING)
    return [name for name in _all() if not name.split("/")[1].startswith(of_others)]


def starts() -> list[str]:
    """All recordings of how a mission is started, changed and ended, as "px4/mission_end"."""
    return [name for name in _all() if name.split("/")[1].startswith(_OF_STARTS)]


def guided() -> list[str]:
    """All recordings of commands that fly an aircraft without a plan, as "px4/guided_flight"."""
    return [name for name in _all() if name.split("/")[1].startswith(_GUIDED)]


def ftp() -> list[str]:
    """All recordings of plans as files, as "arducopter/ftp_upload_clean"."""
    return [name for name in _all() if name.split("/")[1].startswith(_FTP)]


def parameters() -> list[str]:
    """All recordings of parameters read and set, as "px4/params"."""
    return [name for name in _all() if name.split("/")[1].startswith(_PARAMETERS)]


def modes() -> list[str]:
    """All recordings of a list of modes, as "arducopter_4_8/modes"."""
    return [name for name in _all() if name.split("/")[1].startswith(_MODES)]


def signing() -> list[str]:
    """All recordings of signing that is switched on and off, as "arducopter_4_8/signing"."""
    return [name for name in _all() if name.split("/")[1].startswith(_SIGNING)]


def lossy() -> list[str]:
    """All recordings of a line that loses bytes, as "px4/lossy_3_percent_0"."""
    return [name for name in _all() if name.split("/")[1].startswith(_LOSSY)]


def raw(name: str, direction: str) -> list[tuple[float, bytes]]:
    """(time [s], bytes) of each line with this mark: '>', '<', and of a lossy one '>>' and '<<' too."""
    lines = (line.split() for line in (FOLDER / f"{name}.txt").read_text().splitlines())
    return [(float(time), bytes.fromhex(data)) for time, which, data in lines if which == direction]


def _all() -> list[str]:
    return sorted(f"{path.parent.name}/{path.stem}" for path in FOLDER.glob("*/*.txt"))


@cache
def heard(name: str) -> tuple[Heard, ...]:
    """Every intact frame of a recording, in order."""
    path = FOLDER / f"{name}.txt"
    if not path.exists():
        raise ValueError(f"there is no recording {name}: it is one of {', '.join(_all())}")
    lines = [line.split() for line in path.read_text().splitlines()]
    splitters, skipped = {}, {}
    for direction in "><":
        splitters[direction] = frames.FrameSplitter()
        skipped[direction] = _before_first_frame(
            b"".join(bytes.fromhex(data) for _, which, data in lines if which == direction))
    result = []
    for time, direction, data in lines:
        raw = bytes.fromhex(data)
        cut = min(skipped[direction], len(raw))
        skipped[direction] -= cut
        for frame, intact in splitters[direction].feed(raw[cut:]):
            if intact:
                result.append(Heard(float(time), direction, frames.decode(frame), frame))
    return tuple(result)


def _before_first_frame(stream: bytes) -> int:
    """How many bytes belong to a frame that began before the recording did."""
    for start in range(len(stream)):
        pieces = frames.FrameSplitter().feed(stream[start:start + 300])
        if pieces and pieces[0][1] and frames.crc_extra_of(pieces[0][0]) is not None:
            return start
    return 0


def telemetry(name: str) -> list[tuple[float, bytes]]:
    """(time [s], frame) of all that the autopilot sent beside missions, commands and texts."""
    return [(one.time, one.frame) for one in heard(name)
            if one.direction == "<" and one.message.get_type() not in _ITS_OWN
            and not one.message.get_type().startswith("MISSION_")]


def repeated(name: str, from_time: float = 0.0) -> Iterator[tuple[float, bytes]]:
    """A recording's telemetry at its own pace, over and over, for ever."""
    once = telemetry(name)
    length = once[-1][0] - once[0][0]
    for round_number in itertools.count():
        for time, frame in once:
            yield from_time + time - once[0][0] + round_number * length, frame


def saturated(name: str, baud: int, share: float = 1.0,
              from_time: float = 0.0) -> Iterator[tuple[float, bytes]]:
    """A recording's telemetry as fast as a line takes it, for ever.

    share: how much of the line is filled, 0 to 1. Give the autopilot the same baud, so that
    its answers take their turn on the full line.
    """
    time = from_time
    for _, frame in itertools.cycle(telemetry(name)):
        yield time, frame
        time += BITS_PER_BYTE * len(frame) / baud / share


def readback(vehicle: str) -> list[dict[str, str]]:
    """The rows of readback_<vehicle>.csv."""
    with open(FOLDER / f"readback_{vehicle}.csv", newline="") as file:
        return list(csv.DictReader(file))


def written(crossed: Sequence[tuple[float, str, bytes]]) -> str:
    """(time [s], mark, bytes) of all that crossed a line, with the four marks of a lossy one, as a recording's text.

    Two marks will do for a line that has damaged nothing; what goes by the autopilot from others is then left out.
    """
    whole = {mark: b"".join(data for _, one, data in crossed if one == mark) for mark in (">", ">>", "<", "<<")}
    is_lossy = whole[">"] != whole[">>"] or not whole["<<"].endswith(whole["<"])
    splitter, lines = frames.FrameSplitter(), []
    for time, mark, data in crossed:
        if mark == "<" and not is_lossy:
            data = b"".join(piece for piece, _ in splitter.feed(data) if not _is_anothers(piece))
        if data and (is_lossy or len(mark) == 1):
            lines.append(f"{time:.4f} {mark} {data.hex()}\n")
    return "".join(lines)


def _is_anothers(frame: bytes) -> bool:
    """Whether a MAVLink 2 frame was sent by another system than the autopilot's."""
    return frame[0] == 0xFD and len(frame) > 5 and frame[5] != 1
