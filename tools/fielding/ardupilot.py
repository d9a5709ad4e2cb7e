"""An ArduPilot that a person has built, in step: we are its physics, and its clock is ours.

ArduPilot's own binary sends its servos by UDP, and then waits until it is told where it is and what time it is
(SIM_JSON).
"""

from __future__ import annotations

import socket
import struct
from functools import partial
from pathlib import Path

from .simulator import HOME, Port, Simulator, free_port
from .vehicles import Copter, Vehicle

STEP_S = 0.00125  # two to a turn of its main loop: fewer, and it finds its gyroscopes too slow
WHOLE_US = 1 + 2e-6  # it cuts each step to whole microseconds: none is to be cut
SERVOS = {18458: struct.Struct("<HHI16H"), 29569: struct.Struct("<HHI32H")}  # by their magic number

# What a simulator needs to move a vehicle as simple as ours, and why.
PARAMETERS = {
    # MAVLink 2 on the truth's port and on the line, which are no quicker than their rates.
    "SERIAL0_PROTOCOL": 2, "SERIAL1_PROTOCOL": 2, "SERIAL0_BAUD": 921, "SERIAL1_BAUD": 57, "SIM_BAUDLIMIT_EN": 1,
    "LOG_BACKEND_TYPE": 0, "BATT_MONITOR": 4,  # no card to log to, and a battery
    "FS_GCS_ENABLE": 0, "FS_THR_ENABLE": 1,  # the truth is no pilot's station; without a remote control it returns
    # Calibrated, as an aircraft is that somebody has set up: without it nothing arms.
    **{f"COMPASS_OFS{which}_{axis}": value
       for which in ("", "2", "3") for axis, value in zip("XYZ", (5, 13, -18), strict=True)},
    **{f"INS_ACC{which}{name}_{axis}": value for which in ("", "2") for axis in "XYZ"
       for name, value in (("OFFS", 0.001), ("SCAL", 1.001))},
    **{f"RC{number}_{end}": value
       for number in range(1, 9) for end, value in (("MIN", 1000), ("TRIM", 1500), ("MAX", 2000))},
}  # fmt: skip
# Its places are near one another, and it returns only when the remote control has been lost for longer.
PLANE: dict[str, float] = {"TRIM_THROTTLE": 25, "WP_RADIUS": 20, "WP_LOITER_RAD": 40, "RTL_ALTITUDE": 30,
                           "FS_SHORT_ACTN": 3, "FS_LONG_ACTN": 1}  # fmt: skip
PARAMETERS_OF: dict[str, dict[str, float]] = {
    # Four motors in an X, whose thrust is linear; it arms in AUTO, takes off without a stick, and turns slowly.
    "arducopter": {"FRAME_CLASS": 1, "FRAME_TYPE": 1, "MOT_THST_EXPO": 0, "MOT_THST_HOVER": Copter.HOVERS,
                   "AUTO_OPTIONS": 3, "ATC_RAT_YAW_P": 0.3},
    "ardurover": {"FRAME_CLASS": 1, "SERVO1_FUNCTION": 26, "SERVO3_FUNCTION": 70, "FS_ACTION": 1},  # as ours is driven
    "arduplane": PLANE, "ardusub": {"FS_THR_ENABLE": 0},  # its throttle is a station's
    "quadplane": {**PLANE, "SCHED_LOOP_RATE": 400, "Q_ENABLE": 1, "Q_FRAME_CLASS": 1, "Q_FRAME_TYPE": 1,
                  "Q_M_THST_EXPO": 0, "Q_M_THST_HOVER": Copter.HOVERS, "Q_M_PWM_MIN": 1000, "Q_M_PWM_MAX": 2000,
                  "Q_ASSIST_SPEED": -1, "Q_GUIDED_MODE": 1, "Q_RTL_MODE": 1},
}  # fmt: skip


def sensors(vehicle: Vehicle) -> str:
    """As its JSON interface wants it."""
    vectors = (("position", vehicle.position), ("velocity", vehicle.velocity), ("quaternion", vehicle.quaternion))
    body = (("gyro", vehicle.turning), ("accel_body", vehicle.force))
    imu, rest = (",".join(f'"{name}":[{",".join(f"{one:.9g}" for one in values)}]' for name, values in part)
                 for part in (body, vectors))  # fmt: skip
    return f'"timestamp":{vehicle.time * WHOLE_US:.9f},"imu":{{{imu}}},{rest}'


class ArduPilot(Simulator):
    firmware = "ArduPilot"
    clock = "in step: our physics hands it each moment (SIM_JSON)"

    def start(self, binary: Path) -> None:
        given = {**PARAMETERS, **PARAMETERS_OF.get(self.name, {})}
        parameters = self.folder / "field.parm"
        parameters.write_text("".join(f"{name} {value}\n" for name, value in given.items()))
        self._physics = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._physics.bind(("127.0.0.1", 0))
        self._physics.settimeout(0.5)
        self._frame, self._peer = -1, ("127.0.0.1", 0)
        ports = [free_port(socket.SOCK_STREAM) for _ in range(2)]
        self.run(
            [binary, "--model", "JSON:127.0.0.1", "--speedup", "1000", "--wipe", "--defaults", parameters,
             "--home", ",".join(map(str, (*HOME, 0))), "--sim-port-out", str(self._physics.getsockname()[1]),
             "--sim-port-in", str(free_port(socket.SOCK_DGRAM)), "--rc-in-port", str(free_port(socket.SOCK_DGRAM)),
             "--serial0", f"tcp:{ports[0]}", "--serial1", f"tcp:{ports[1]}", "--serial2", "none:"])  # fmt: skip
        self._pulses = self.awaited(self._servos)
        self.truth, self.line = (self.awaited(partial(self._connected, port)) for port in ports)

    def step(self) -> None:
        self.vehicle.step(self._pulses, STEP_S)
        throttle = self.vehicle.throttle_stick() if self.has_remote else 900
        rc = ",".join(f'"rc_{number}":{throttle if number == 3 else 1500}' for number in range(1, 9))
        self._physics.sendto(f'\n{{{sensors(self.vehicle)},"rc":{{{rc}}}}}\n'.encode(), self._peer)
        self._pulses = self.awaited(self._servos)

    def _servos(self) -> tuple[int, ...] | None:
        """What it answers to the last step."""
        try:
            data, self._peer = self._physics.recvfrom(256)
        except TimeoutError:
            return None
        form = SERVOS.get(int.from_bytes(data[:2], "little"))
        if form is None or len(data) != form.size:
            return None
        _, _, frame, *pulses = form.unpack(data)
        if frame <= self._frame:  # it says again what we have heard
            return None
        self._frame = frame
        return tuple(pulses)

    def _connected(self, port: int) -> Port | None:
        try:
            made = socket.create_connection(("127.0.0.1", port), timeout=1)
        except OSError:
            self.step()
            return None
        made.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        return Port(made)

    def close(self) -> None:
        super().close()
        self._physics.close()
