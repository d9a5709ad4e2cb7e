"""Keeps to PX4's words, start-up pieces, ports and lockstep as tools/field uses them, with a fake behind."""

from __future__ import annotations

import os
import re
import socket
import sys
from pathlib import Path

from simulation.fake_autopilot import mavlink
from stand_in import StandIn

words = dict(zip(sys.argv[1::1], sys.argv[2::1], strict=False))
assert (Path(sys.argv[-1]) / "init.d-posix" / "rcS").is_file() and os.environ["PX4_SIM_MODEL"] == "none_iris"


def piece(name: str) -> str:
    """As the shell finds it by its PATH, before PX4's own."""
    return next(file.read_text() for folder in os.environ["PATH"].split(":") if (file := Path(folder) / name).exists())


begin = piece("px4-rc.simulator")
assert "param set MAV_SYS_ID 1\n" in begin and begin.endswith(f"simulator_mavlink start -c {words['-i']}\n")
ends = []
for own, other in re.findall(
    r"mavlink start -x -u (\d+) -o (\d+) -t 127.0.0.1 -m \w+ -r \d+\n", piece("px4-rc.mavlink")
):
    ends.append(socket.socket(socket.AF_INET, socket.SOCK_DGRAM))
    ends[-1].bind(("127.0.0.1", int(own)))
    ends[-1].connect(("127.0.0.1", int(other)))
    ends[-1].setblocking(False)
line, truth = ends
physics = socket.create_connection(("127.0.0.1", int(words["-i"])))
fake = StandIn("px4")
mav = mavlink.MAVLink(None, 1, 1)
began = 0
placed = False


def exchange(end: socket.socket, out: bytes) -> bytes:
    if out:
        end.send(out)
    try:
        return end.recv(65536)
    except BlockingIOError:
        return b""


while data := physics.recv(65536):
    for told in mav.parse_buffer(data) or ():
        placed = placed or told.get_type() == "HIL_GPS" and told.fix_type == 3
        if told.get_type() != "HIL_SENSOR":
            continue
        assert -10.5 < told.zacc < -9.0 and abs(told.xgyro) < 0.1 and 900 < told.abs_pressure < 1000
        began = began or told.time_usec - 4000
        now = (told.time_usec - began) / 1e6
        assert fake.now < now < fake.now + 0.0041
        fake.advance(now)
        fake.truth.write(exchange(truth, fake.truth.read()))
        fake.line.write(exchange(line, fake.line.read()))
        assert placed or now < 1.0
        controls = mavlink.MAVLink_hil_actuator_controls_message(told.time_usec, [0.0] * 16, 1, 1)
        physics.sendall(controls.pack(mav))
