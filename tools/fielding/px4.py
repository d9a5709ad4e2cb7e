"""A PX4 that a person has built for its simulators, in lockstep: we are its sensors, and its clock is ours.

PX4 connects to us by TCP, takes the time from each HIL_SENSOR, and answers with HIL_ACTUATOR_CONTROLS. Its start-up
script (rcS) finds two pieces of ours before its own: that of the simulator, and that of its MAVLink ports.
"""

from __future__ import annotations

import math
import os
import random
import socket
from pathlib import Path

from simulation.fake_autopilot import mavlink

from .simulator import HOME, Port, Simulator, free_port
from .vehicles import Copter

STEP_S = 0.004
SLOWLY = 5  # [steps] from one reading of the compass and the barometer to the next; the GPS takes ten times as long
BOOTS_S, ANSWERS_S = 0.005, 1.0  # by the computer's clock: so long it may take to answer a step
EARTH_M = 6371000.0
FIELD = [0.228, 0.050, -0.525]  # of the earth, at home [gauss, to the north, east and down]
IMU, COMPASS, BAROMETER = 0x3F, 0x1C0, 0x1A00  # HIL_SENSOR.fields_updated
NOISE = {"accelerometer": 0.02, "gyroscope": 0.002, "compass": 0.001, "barometer": 0.005}  # without it they are broken
LINE_RATE = 2880  # [bytes/s]: what PX4 makes of a port of 57600 baud for which no rate is set

PARAMETERS = {
    # The remote control is the truth's, which comes and goes; without it it returns, and a failsafe waits for nobody.
    "MAV_SYS_ID": 1, "COM_RC_IN_MODE": 1, "COM_FAIL_ACT_T": 0, "NAV_RCL_ACT": 2, "NAV_DLL_ACT": 0,
    "CBRK_SUPPLY_CHK": 894281, "SDLOG_BACKEND": 0, "SDLOG_MODE": -1,  # no power module, and no card to log to
    "MPC_THR_HOVER": Copter.HOVERS, "EKF2_GPS_DELAY": 10, "IMU_INTEG_RATE": 250, "IMU_GYRO_FFT_EN": 0,
    "EKF2_MULTI_IMU": 0, "SENS_IMU_MODE": 1, "EKF2_MULTI_MAG": 0, "SENS_MAG_MODE": 1,  # one of each
}  # fmt: skip


class Px4(Simulator):
    firmware = "PX4"
    clock = "in step: our sensors hand it each moment (lockstep)"
    slice_s = STEP_S

    def start(self, binary: Path) -> None:
        server = socket.create_server(("127.0.0.1", 0))
        number = server.getsockname()[1]  # of the instance: no other has it
        begin = [*(f"param set {name} {value}" for name, value in PARAMETERS.items()),
                 f"simulator_mavlink start -c {number}"]  # fmt: skip
        links = ["alias replay=true"]  # nothing is to be replayed, and a build may not have it
        ends = []
        for way in (f"onboard -r {LINE_RATE}", "custom -r 100000"):
            ends.append(socket.socket(socket.AF_INET, socket.SOCK_DGRAM))
            ends[-1].bind(("127.0.0.1", 0))
            ends[-1].connect(("127.0.0.1", port := free_port(socket.SOCK_DGRAM)))
            links.append(f"mavlink start -x -u {port} -o {ends[-1].getsockname()[1]} -t 127.0.0.1 -m {way}")
        links.append(f"mavlink stream -u {port} -s HEARTBEAT -r 50")  # the truth's; it takes no request for that
        self.line, self.truth = map(Port, ends)
        for name, lines in (("simulator", begin), ("mavlink", links)):
            (self.folder / f"px4-rc.{name}").write_text("\n".join([*lines, ""]))
        self._random, self._steps, self._is_up = random.Random(1), 0, False
        self._pulses: tuple[int, ...] = (1000,) * 4
        self._mav = mavlink.MAVLink(None, 255, mavlink.MAV_COMP_ID_MISSIONPLANNER)
        self.run([binary, "-d", "-i", str(number), "-w", self.folder, binary.parents[1] / "etc"],
                 PX4_SIM_MODEL="none_iris", PATH=f"{self.folder}:{os.environ['PATH']}")  # fmt: skip
        server.settimeout(0.5)
        with server:
            self._physics: socket.socket = self.awaited(lambda: self._accepted(server))

    @staticmethod
    def _accepted(server: socket.socket) -> socket.socket | None:
        try:
            made = server.accept()[0]
        except TimeoutError:
            return None
        made.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        return made

    def _noisy(self, values: list[float], sensor: str) -> list[float]:
        return [one + self._random.gauss(0, NOISE[sensor]) for one in values]

    def step(self) -> None:
        vehicle = self.vehicle
        vehicle.step(self._pulses, STEP_S)
        self._steps += 1
        data = self._sensors(self._steps % SLOWLY == 0)
        if self._steps % (10 * SLOWLY) == 0:
            data += self._gps()
            if self.has_remote:
                self.truth.write(mavlink.MAVLink_manual_control_message(1, 0, 0, 500, 0, 0).pack(self._mav))
        self._physics.sendall(data)
        self._physics.settimeout(ANSWERS_S if self._is_up else BOOTS_S)
        self._pulses = self.awaited(self._controls)

    def _time_us(self) -> int:
        return 1_000_000 + round(self._steps * STEP_S * 1e6)

    def _sensors(self, is_slow: bool) -> bytes:
        vehicle = self.vehicle
        height = HOME[2] - vehicle.position[2]
        (pressure,) = self._noisy([1013.25 * (1 - 2.25577e-5 * height) ** 5.25588], "barometer")
        return mavlink.MAVLink_hil_sensor_message(
            self._time_us(), *self._noisy(vehicle.force, "accelerometer"), *self._noisy(vehicle.turning, "gyroscope"),
            *self._noisy(vehicle.inside(FIELD), "compass"), pressure, 0.0, height, 25.0,
            IMU | is_slow * (COMPASS | BAROMETER)).pack(self._mav)  # fmt: skip

    def _gps(self) -> bytes:
        north, east, down = self.vehicle.position
        lat = HOME[0] + math.degrees(north / EARTH_M)
        lon = HOME[1] + math.degrees(east / EARTH_M / math.cos(math.radians(HOME[0])))
        speeds = [round(100 * one) for one in self.vehicle.velocity]
        ground = math.hypot(*speeds[:2])
        course = round(100 * math.degrees(math.atan2(speeds[1], speeds[0]))) % 36000
        return mavlink.MAVLink_hil_gps_message(
            self._time_us(), 3, round(lat * 1e7), round(lon * 1e7), round(1000 * (HOME[2] - down)), 50, 80,
            round(ground), *speeds, course, 14).pack(self._mav)  # fmt: skip

    def _controls(self) -> tuple[int, ...] | None:
        """What it answers to the last step. While it starts up, and when it is late, it has no answer."""
        try:
            data = self._physics.recv(65536)
        except TimeoutError:
            return self._pulses
        for message in self._mav.parse_buffer(data) or ():
            if message.get_type() == "HIL_ACTUATOR_CONTROLS":
                self._is_up = True
                if message.time_usec >= self._time_us():
                    return tuple(round(1000 + 1000 * one) for one in message.controls[:4])
        return None

    def close(self) -> None:
        super().close()
        if hasattr(self, "_physics"):
            self._physics.close()
