"""An ArduPilot that a person has built, in step: we are its physics, and its clock is ours.

ArduPilot's own binary sends its servos by UDP, and then waits until it is told where it is and what time it is
(SIM_JSON). It has two serial ports, one for the Mega's line and one for the truth.
"""

from __future__ import annotations

import socket
import struct
import subprocess
import time
from pathlib import Path

from .vehicles import Copter, Vehicle

HOME = (-35.3632621, 149.1652374, 584.0)  # where the examples fly [degrees, m]
STEP_S = 0.00125  # two to a turn of its main loop: fewer, and it finds its gyroscopes too slow
SERVOS = {18458: struct.Struct("<HHI16H"), 29569: struct.Struct("<HHI32H")}  # by their magic number
GONE_S = 60.0  # by the computer's clock: what says nothing for so long stands still
VEHICLES: dict[str, type[Vehicle]] = {"arducopter": Copter}

# What a simulator needs to fly a vehicle as simple as ours, and why.
PARAMETERS = {
    "SERIAL0_PROTOCOL": 2,  # the truth speaks MAVLink 2
    "SERIAL1_PROTOCOL": 2,  # and so does the line, at the Mega's rate
    "SERIAL0_BAUD": 921,
    "SERIAL1_BAUD": 57,
    "SIM_BAUDLIMIT_EN": 1,  # a port is no quicker than its rate
    "LOG_BACKEND_TYPE": 0,  # no card to log to
    "FS_GCS_ENABLE": 0,  # the truth comes and goes, and is no pilot's station
    # Calibrated, as an aircraft is that somebody has set up: without it nothing arms.
    **{f"COMPASS_OFS{which}_{axis}": value
       for which in ("", "2", "3") for axis, value in zip("XYZ", (5, 13, -18), strict=True)},
    **{f"INS_ACC{which}OFFS_{axis}": 0.001 for which in ("", "2") for axis in "XYZ"},
    **{f"INS_ACC{which}SCAL_{axis}": 1.001 for which in ("", "2") for axis in "XYZ"},
    **{f"RC{number}_{end}": value
       for number in range(1, 9) for end, value in (("MIN", 1000), ("TRIM", 1500), ("MAX", 2000))},
}  # fmt: skip
PARAMETERS_OF = {
    "arducopter": {
        "FRAME_CLASS": 1,  # four motors
        "FRAME_TYPE": 1,  # in an X
        "MOT_THST_EXPO": 0,  # the thrust of ours is linear
        "MOT_THST_HOVER": Copter.HOVERS,
        "FS_THR_ENABLE": 1,  # a lost remote control: it returns
        "AUTO_OPTIONS": 3,  # arms in AUTO, and takes off without a stick
        "ATC_RAT_YAW_P": 0.3,  # ours turns slowly
    },
}


class Gone(Exception):
    """The simulator has ended, or stands still; the text says what it said last."""


def free_port(kind: socket.SocketKind) -> int:
    with socket.socket(socket.AF_INET, kind) as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


class ArduPilot:
    """A process of this binary, at rest at home, in a folder of its own."""

    firmware = "ArduPilot"
    clock = "in step: our physics hands it each moment (SIM_JSON)"

    def __init__(self, binary: Path, folder: Path) -> None:
        self.name = binary.name
        self.vehicle = VEHICLES[self.name]()
        self._folder = folder
        given = {**PARAMETERS, **PARAMETERS_OF[self.name]}
        parameters = folder / "field.parm"
        parameters.write_text("".join(f"{name} {value}\n" for name, value in given.items()))
        self._physics = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._physics.bind(("127.0.0.1", 0))
        self._physics.settimeout(0.5)
        ports = [free_port(socket.SOCK_STREAM) for _ in range(2)]
        self._log = open(folder / "simulator.log", "wb")
        self._process = subprocess.Popen(
            [binary, "--model", "JSON:127.0.0.1", "--speedup", "1000", "--wipe", "--defaults", parameters,
             "--home", ",".join(map(str, (*HOME, 0))), "--sim-port-out", str(self._physics.getsockname()[1]),
             "--sim-port-in", str(free_port(socket.SOCK_DGRAM)), "--rc-in-port", str(free_port(socket.SOCK_DGRAM)),
             "--serial0", f"tcp:{ports[0]}", "--serial1", f"tcp:{ports[1]}", "--serial2", "none:"],
            cwd=folder, stdin=subprocess.DEVNULL, stdout=self._log, stderr=self._log)  # fmt: skip
        self._frame, self._throttle = -1, 1000
        self._peer = ("127.0.0.1", 0)
        try:
            self._pulses = self._next_servos()
            self.truth, self.line = (self._connected(port) for port in ports)
        except Exception:
            self.close()
            raise

    @property
    def now(self) -> float:
        return self.vehicle.time

    def advance(self, until: float) -> None:
        while self.vehicle.time < until - 1e-9:
            self._step()

    def _step(self) -> None:
        self.vehicle.step(self._pulses, STEP_S)
        rc = ",".join(f'"rc_{number}":{self._throttle if number == 3 else 1500}' for number in range(1, 9))
        line = f'\n{{{self.vehicle.sensors()},"rc":{{{rc}}}}}\n'
        self._physics.sendto(line.encode(), self._peer)
        self._pulses = self._next_servos()

    def _next_servos(self) -> tuple[int, ...]:
        """What it answers to the last step: then it has done all that there was to do."""
        until = time.monotonic() + GONE_S
        while time.monotonic() < until:
            try:
                data, self._peer = self._physics.recvfrom(256)
            except TimeoutError:
                if self._process.poll() is not None:
                    break
                continue
            form = SERVOS.get(int.from_bytes(data[:2], "little"))
            if form is None or len(data) != form.size:
                continue
            _, _, frame, *pulses = form.unpack(data)
            if frame > self._frame:  # else it says again what we have heard
                self._frame = frame
                return tuple(pulses)
        said = (self._folder / "simulator.log").read_bytes()[-400:].decode(errors="replace").strip()
        raise Gone(f"{self.name} has {'ended' if self._process.poll() is not None else 'stood still'}: {said}")

    def _connected(self, port: int) -> socket.socket:
        until = time.monotonic() + GONE_S
        while True:
            try:
                made = socket.create_connection(("127.0.0.1", port), timeout=1)
                break
            except OSError:
                if time.monotonic() > until:
                    raise Gone(f"{self.name} does not open its port {port}") from None
                self._step()
        made.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        made.setblocking(False)
        return made

    @staticmethod
    def _read(end: socket.socket) -> bytes:
        data = b""
        try:
            while more := end.recv(65536):
                data += more
        except BlockingIOError:
            return data
        raise Gone("the simulator has closed its port")

    def sticks(self, throttle: int) -> None:
        self._throttle = throttle

    def line_read(self) -> bytes:
        return self._read(self.line)

    def line_write(self, data: bytes) -> None:
        self.line.sendall(data)

    def truth_read(self) -> bytes:
        return self._read(self.truth)

    def truth_write(self, data: bytes) -> None:
        self.truth.sendall(data)

    def close(self) -> None:
        self._process.kill()  # it would end by itself only when its physics goes on
        self._process.wait()
        for one in (self._physics, self._log, getattr(self, "line", None), getattr(self, "truth", None)):
            if one is not None:
                one.close()
