"""The baseline is a fair one: it does the job, with MAVLink's headers as they come."""

from __future__ import annotations

import mavmission_dialect as mavlink
import pytest

from baseline import build_baseline
from measuring.peer import KINDS, Peer
from measuring.runs import MS

WIRES = [1, 2]


def heard_within_ms(peer: Peer, ms: int) -> list:
    """What the firmware has sent since the last call, `ms` from now."""
    before = len(peer.heard)
    peer.run(ms * MS)
    return [frame.message for frame in peer.heard[before:]]


@pytest.mark.parametrize("wire", WIRES)
@pytest.mark.parametrize("kind", KINDS)  # One asks by MISSION_REQUEST, one by MISSION_REQUEST_INT.
def test_baseline_uploads_its_two_items(wire, kind):
    peer = Peer(build_baseline(wire).elf, kind, wire, serve=False)
    peer.heartbeat()
    (count,) = heard_within_ms(peer, 50)
    assert (count.get_type(), count.count) == ("MISSION_COUNT", 2)
    for seq, command in enumerate([mavlink.MAV_CMD_NAV_TAKEOFF, mavlink.MAV_CMD_NAV_WAYPOINT]):
        peer.request(seq)
        (item,) = heard_within_ms(peer, 50)
        assert (item.get_type(), item.seq, item.command) == ("MISSION_ITEM_INT", seq, command)
        # In floating point on AVR a coordinate is right to some metres only.
        assert item.y == pytest.approx(1491652374, abs=80)
        assert item.get_msgbuf()[0] == (0xFE if wire == 1 else 0xFD)
    assert peer.mega.peek_int("accepted") == 0
    peer.accept()
    assert heard_within_ms(peer, 50) == []
    assert peer.mega.peek_int("accepted") == 1


@pytest.mark.parametrize("wire", WIRES)
def test_baseline_sends_a_heartbeat_each_second(wire):
    heard = heard_within_ms(Peer(build_baseline(wire).elf, wire=wire, serve=False), 5500)
    assert [message.get_type() for message in heard] == ["HEARTBEAT"] * 5


@pytest.mark.parametrize(("wire", "ram"), [(2, 4082), (1, 1642)])
def test_baseline_takes_the_ram_that_the_stock_headers_take(wire, ram):
    assert build_baseline(wire).ram == ram


@pytest.mark.parametrize("wire", WIRES)
def test_functions_that_the_measurements_watch_are_called(wire):
    peer = Peer(build_baseline(wire).elf, wire=wire, serve=False)
    parse, pack = peer.mega.watch("baseline_parse"), peer.mega.watch("baseline_pack")
    peer.heartbeat()
    peer.request(0)
    heard_within_ms(peer, 100)
    assert parse.calls.count == sum(length for _, length in peer.to_mega)
    assert pack.calls.count == 1
