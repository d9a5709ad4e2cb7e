"""The baseline is a fair one: it does the job, with MAVLink's headers as they come."""

from __future__ import annotations

import mavmission_dialect as mavlink
import pytest

from baseline import SOURCE, build_baseline
from building import ROOT, dependencies
from simulation.mega import Mega

WIRES = [1, 2]


class Peer:
    """The other end of Serial1: an autopilot that says what the test tells it to."""

    def __init__(self, mega: Mega, wire: int) -> None:
        self.mega = mega
        self.wire = wire
        self.talks = mavlink.MAVLink(None, srcSystem=1, srcComponent=mavlink.MAV_COMP_ID_AUTOPILOT1)
        self.hears = mavlink.MAVLink(None)
        self.heard_within_ms(10)  # until Serial1 is open

    def says(self, message) -> int:
        """Send a message; returns the length of its frame [bytes]."""
        frame = message.pack(self.talks, force_mavlink1=self.wire == 1)
        self.mega.serial(1).send(frame)
        return len(frame)

    def heard_within_ms(self, ms: float) -> list:
        """What the firmware has sent since the last call, `ms` from now."""
        self.mega.run_ms(ms)
        sent = bytes(entry.byte for entry in self.mega.serial(1).sent())
        return self.hears.parse_buffer(sent) or []


def request(kind: str, seq: int):
    return getattr(mavlink, f"MAVLink_mission_request{kind}_message")(1, mavlink.MAV_COMP_ID_ONBOARD_COMPUTER, seq, 0)


def heartbeat():
    return mavlink.MAVLink_heartbeat_message(
        mavlink.MAV_TYPE_QUADROTOR, mavlink.MAV_AUTOPILOT_ARDUPILOTMEGA, 0, 0, mavlink.MAV_STATE_STANDBY, 3
    )


@pytest.mark.parametrize("wire", WIRES)
@pytest.mark.parametrize("kind", ["", "_int"])
def test_baseline_uploads_its_two_items(wire, kind):
    mega = Mega(build_baseline(wire).elf)
    peer = Peer(mega, wire)
    peer.says(heartbeat())
    (count,) = peer.heard_within_ms(50)
    assert (count.get_type(), count.count) == ("MISSION_COUNT", 2)
    for seq, command in enumerate([mavlink.MAV_CMD_NAV_TAKEOFF, mavlink.MAV_CMD_NAV_WAYPOINT]):
        peer.says(request(kind, seq))
        (item,) = peer.heard_within_ms(50)
        assert (item.get_type(), item.seq, item.command) == ("MISSION_ITEM_INT", seq, command)
        # In floating point on AVR a coordinate is right to some metres only.
        assert item.y == pytest.approx(1491652374, abs=80)
        assert item.get_msgbuf()[0] == (0xFE if wire == 1 else 0xFD)
    assert mega.peek_int("accepted") == 0
    peer.says(mavlink.MAVLink_mission_ack_message(1, mavlink.MAV_COMP_ID_ONBOARD_COMPUTER, 0, 0))
    assert peer.heard_within_ms(50) == []
    assert mega.peek_int("accepted") == 1


@pytest.mark.parametrize("wire", WIRES)
def test_baseline_sends_a_heartbeat_each_second(wire):
    peer = Peer(Mega(build_baseline(wire).elf), wire)
    heard = peer.heard_within_ms(5500)
    assert [message.get_type() for message in heard] == ["HEARTBEAT"] * 5


@pytest.mark.parametrize(("wire", "ram"), [(2, 4082), (1, 1642)])
def test_baseline_takes_the_ram_that_the_stock_headers_take(wire, ram):
    assert build_baseline(wire).ram == ram


@pytest.mark.parametrize("wire", WIRES)
def test_functions_that_the_measurements_watch_are_called(wire):
    mega = Mega(build_baseline(wire).elf)
    parse, pack = mega.watch("baseline_parse"), mega.watch("baseline_pack")
    peer = Peer(mega, wire)
    sent = peer.says(heartbeat()) + peer.says(request("_int", 0))
    peer.heard_within_ms(100)
    assert parse.calls.count == sent
    assert pack.calls.count == 1


def test_baseline_is_not_linked_with_this_library():
    read = dependencies(build_baseline(2).elf.parent)
    assert SOURCE in read
    ours = [f.relative_to(ROOT / "src") for f in read if f.is_relative_to(ROOT / "src")]
    assert ours
    assert {f.parts[:2] for f in ours} == {("mavmission", "mavlink")}
