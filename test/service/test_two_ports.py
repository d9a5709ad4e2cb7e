"""More than one at once: two clients on two ports, and another MAVLink library in the same sketch."""

from __future__ import annotations

import pytest

from simulation.bench import fake
from simulation.fake_autopilot import mavlink
from simulation.firmware import LIBRARY, ROOT, build_firmware
from simulation.mega import Mega

SKETCHES = ROOT / "simulation" / "sketches"
TWO = pytest.mark.scenario(47, "Two clients on two ports at once; another MAVLink library in the same sketch")
SLICE_S = 0.0005


class Ports:
    """Firmware on a Mega with an autopilot, or nobody, on each of its ports."""

    def __init__(self, source: str, autopilots: dict[int, object], **build) -> None:
        self.mega = Mega(build_firmware(source, [SKETCHES / f"{source}.cpp"], **build))
        self.autopilots = autopilots
        self._said = b""

    def run(self, seconds: float) -> list[str]:
        """Go on for so long; all the lines that the firmware has said until then."""
        until = self.mega.cycle + int(seconds * self.mega.hz)
        while self.mega.cycle < until:
            self.mega.run_until(self.mega.cycle + int(SLICE_S * self.mega.hz))
            now = self.mega.cycle / self.mega.hz
            for number, autopilot in self.autopilots.items():
                port = self.mega.serial(number)
                autopilot.receive(port.sent_bytes(), now)
                arriving = autopilot.run(now)
                if arriving:
                    port.send(arriving)
            self._said += self.mega.serial(0).sent_bytes()
        return self._said.decode().splitlines()


@TWO
def test_two_clients_serve_two_autopilots_at_once():
    kinds = ("ArduPilot", "PX4")
    autopilots = {number: fake(kind, 57600, system_id=number) for number, kind in enumerate(kinds, start=1)}
    ports = Ports("two_ports", autopilots)
    assert sorted(ports.run(6.0)) == ["first accepted: the plan is aboard", "second accepted: the plan is aboard"]
    for number, commands in ((1, [112, 22, 16, 16, 20]), (2, [16, 16, 21])):  # 112 goes in the place of home
        assert [one.command for one in autopilots[number].received()] == commands
        sent = autopilots[number].messages(">", "MISSION_COUNT", "MISSION_ITEM_INT")
        assert {message.target_system for message in sent} == {number}


@TWO
def test_one_client_goes_on_while_the_other_has_nobody():
    assert Ports("two_ports", {1: fake("PX4", 57600)}).run(6.0) == ["first accepted: the plan is aboard"]


@TWO
@pytest.mark.slow
def test_stock_headers_in_the_same_sketch(personality):
    autopilot = fake(personality, 57600)
    ports = Ports("beside_mavlink", {1: autopilot}, include_dirs=[LIBRARY / "mavmission" / "mavlink"])
    ports.run(4.0)
    gps = mavlink.MAVLink_gps_raw_int_message(1, 3, -353632621, 1491652374, 584090, 1, 2, 3, 4, 14)
    packer = mavlink.MAVLink(None, 1, 1)
    ports.mega.serial(1).send(gps.pack(packer))
    ports.mega.serial(2).send(gps.pack(mavlink.MAVLink(None, 7, 7)))
    said = ports.run(1.0)
    assert "accepted: the plan is aboard" in said
    assert "gps -353632621 14" in said
    assert "stock 24" in said
    (request,) = autopilot.messages(">", "REQUEST_DATA_STREAM")
    assert (request.req_message_rate, request.req_stream_id, request.start_stop) == (4, 6, 1)
