"""Keeps to ArduPilot's words, ports and physics (SIM_JSON) as tools/field uses them, with a fake behind."""

from __future__ import annotations

import json
import socket
import struct
import sys

from stand_in import StandIn

RESENDS_S = 1.0
SERVOS = struct.Struct("<HHI16H")
MAGIC = 18458
RATE_HZ = 800

words = dict(zip(sys.argv[1::1], sys.argv[2::1], strict=False))
assert words["--model"] == "JSON:127.0.0.1"
servers = [
    socket.create_server(("127.0.0.1", int(words[name].removeprefix("tcp:")))) for name in ("--serial0", "--serial1")
]
ends: list[socket.socket | None] = [None, None]
for server in servers:
    server.setblocking(False)
physics = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
physics.settimeout(RESENDS_S)
fake = StandIn()
frame = 0
was = 0.0


def exchange(number: int, out: bytes) -> bytes:
    """Over the port of this number, as soon as somebody has connected to it."""
    try:
        if ends[number] is None:
            ends[number], _ = servers[number].accept()
            ends[number].setblocking(False)
        ends[number].sendall(out)
        return ends[number].recv(65536)
    except BlockingIOError:
        return b""


while True:
    physics.sendto(SERVOS.pack(MAGIC, RATE_HZ, frame, *[1000] * 16), ("127.0.0.1", int(words["--sim-port-out"])))
    try:
        told = json.loads(physics.recv(4096))
    except TimeoutError:
        continue  # and says the same again
    assert len(told["imu"]["gyro"]) == len(told["imu"]["accel_body"]) == 3 and told["rc"]["rc_3"] == 1000
    assert told["timestamp"] > was and len(told["quaternion"]) == 4
    was = told["timestamp"]
    fake.advance(was)
    fake.truth.write(exchange(0, fake.truth.read()))
    fake.line.write(exchange(1, fake.line.read()))
    frame += 1
