"""The parameters that a fake autopilot has: a few of the real one's, and how it tells and takes them."""
import math
import struct
from collections.abc import Iterable
from dataclasses import dataclass

from .dialect import mavlink
from .items import f32

INT8, INT16, INT32 = mavlink.MAV_PARAM_TYPE_INT8, mavlink.MAV_PARAM_TYPE_INT16, mavlink.MAV_PARAM_TYPE_INT32
REAL32 = mavlink.MAV_PARAM_TYPE_REAL32
_BITS = {INT8: 8, INT16: 16, INT32: 32}
NO_INDEX = 65535


@dataclass
class Parameter:
    """read_only: what is set is refused, and the value is told."""

    name: str
    kind: int  # MAV_PARAM_TYPE
    value: float
    index: int
    read_only: bool = False


class Parameters:
    """all of them: (name, MAV_PARAM_TYPE, value, index). count: as PARAM_VALUE tells it."""

    def __init__(self, count: int, rows: Iterable[tuple[str, int, float, int]], *, integers_as_bits: bool) -> None:
        self.count = count
        self.integers_as_bits = integers_as_bits
        self.all = {name: Parameter(name, kind, value, index) for name, kind, value, index in rows}

    def value(self, name: str) -> float:
        return self.all[name].value

    def asked_for(self, message) -> Parameter | None:
        """The one that a PARAM_REQUEST_READ names, by its index or its name."""
        if message.param_index >= 0:
            return next((one for one in self.all.values() if one.index == message.param_index), None)
        return self.all.get(message.param_id)

    def on_the_wire(self, parameter: Parameter) -> float:
        if self.integers_as_bits and parameter.kind != REAL32:
            return struct.unpack("<f", struct.pack("<i", int(parameter.value)))[0]
        return parameter.value

    def told(self, parameter: Parameter, index: int | None = None):
        """Its PARAM_VALUE."""
        return mavlink.MAVLink_param_value_message(
            parameter.name.encode(), self.on_the_wire(parameter), parameter.kind, self.count,
            parameter.index if index is None else index)

    def from_the_wire(self, parameter: Parameter, number: float) -> float:
        """What a number that is set makes of it."""
        if parameter.kind == REAL32:
            return f32(number)
        if self.integers_as_bits:
            return float(struct.unpack("<i", struct.pack("<f", number))[0])
        most = 2 ** (_BITS[parameter.kind] - 1)
        return float(max(-most, min(most - 1, math.floor(number + 0.5))))


def of_ardupilot(vehicle: str) -> Parameters:
    """Values and types as recorded or, for those that no recording has, by source."""
    rover = vehicle == "rover"
    rows = [("MIS_OPTIONS", INT16, 0.0, 1000), ("MIS_RESTART", INT8, 0.0, 1001), ("FENCE_ENABLE", INT8, 0.0, 1002),
            ("SERIAL1_BAUD", INT32, 57.0, 1003), ("AUTO_OPTIONS", INT32, 0.0, 1004),
            ("BARO1_GND_PRESS", REAL32, f32(101326.8), 1005), ("SERIAL1_PROTOCOL", INT8, 2.0, 1007),
            ("SERIAL2_PROTOCOL", INT8, 2.0, 1008), ("SERIAL2_BAUD", INT32, 57.0, 1009)]  # fmt: skip
    rows += [("WP_RADIUS", REAL32, 3.0, 1006), ("SYSID_MYGCS", INT16, 255.0, 5)] if rover else \
            [("WPNAV_SPEED", REAL32, 1000.0, 1006), ("PILOT_THR_BHV", INT16, 0.0, 5)]  # fmt: skip
    found = Parameters(1263 if rover else 1375, rows, integers_as_bits=False)
    found.all["BARO1_GND_PRESS"].read_only = True
    return found


def of_px4() -> Parameters:
    rows = [("MIS_TAKEOFF_ALT", REAL32, 2.5, 561), ("BAT1_V_CHARGED", REAL32, f32(4.05), 5),
            ("MAV_SYS_ID", INT32, 1.0, 507), ("SER_TEL1_BAUD", INT32, 57600.0, 700),
            ("GF_ACTION", INT32, 2.0, 300), ("MAV_0_FORWARD", INT32, 1.0, 501)]  # fmt: skip
    return Parameters(873, rows, integers_as_bits=True)
