"""A client over UDP: in a network that loses, repeats, reorders and delays datagrams, and where others speak too. (Who
the peer is: test/host/units/udp_link.cpp.)"""

from __future__ import annotations

import pytest

from datagrams import Place, frames_in
from plans import SURVEY, on_the_wire
from simulation.fake_autopilot import mavlink
from udp_client import BRIDGE, UdpClient
from udp_rates import LATENCY_MS, LOSS, in_the_page, network, row

OTHER = Place(3, BRIDGE.port)


@pytest.fixture
def make(personality):
    made = []

    def made_of(*arguments, **options) -> UdpClient:
        made.append(UdpClient(personality, *arguments, **options))
        return made[-1]

    yield made_of
    for client in made:
        client.close()


def assert_whole_frames(client: UdpClient) -> None:
    """What has left went to the bridge alone. (That each datagram is whole frames is looked at as it leaves.)"""
    assert {target for target, _ in client.targets} == {BRIDGE}


@pytest.mark.parametrize("lose", LOSS)
@pytest.mark.parametrize("latency_ms", LATENCY_MS)
def test_upload_with_read_back_is_accepted_and_true_and_each_datagram_is_one_whole_frame(
    make, personality, latency_ms, lose
):
    for seed in range(3):
        client = make(network(seed, lose, latency_ms))
        client.upload(SURVEY, proof="Always")
        assert client.peer["port"] == 0  # nothing is sent before an autopilot is heard
        assert client.run_until_ended(limit_s=300) == "Accepted"
        assert client.autopilot.received() == on_the_wire(SURVEY, personality)
        assert_whole_frames(client)
        assert {len(frames_in(data)) for _, data in client.targets} == {1}
        assert client.counters["sent"] - len(client.targets) in (0, 1)  # the last one may not have left yet
        assert client.peer["packets"] == len(client.targets) and client.peer["unsent"] == 0
        assert client.tally["allocations"] == 0
        assert (client.network.lost > 0) >= (lose > 5)


@pytest.mark.parametrize("lose", LOSS)
@pytest.mark.parametrize("latency_ms", (5, 150))
def test_plan_is_started(make, lose, latency_ms):
    """A heartbeat that another one has overtaken looks like a mode, or a disarming, of somebody else's."""
    ends = []
    for seed in range(1, 9):
        client = make(network(seed, lose, latency_ms))
        client.upload(SURVEY)
        if client.run_until_ended(limit_s=120) != "Accepted":
            continue
        client.order("start")
        ends.append(client.run_until_ended(limit_s=120))
        assert client.autopilot.armed or ends[-1] != "Done"
    assert len(ends) >= 7 and ends.count("Done") >= len(ends) - 1
    assert set(ends) <= {"Done", "TakenOver", "NotArmed"}


def test_page_has_what_is_measured_and_no_false_acceptance():
    rows = in_the_page()
    assert [(cells[0], cells[1]) for cells in rows] == [
        (f"{late} ms", f"{lose} %") for late in LATENCY_MS for lose in LOSS
    ]
    assert row(LATENCY_MS[0], LOSS[1]) == rows[1]


def test_upload_beside_another_aircraft_with_the_same_ids_is_accepted(make):
    """An upload while another aircraft with the same ids speaks in the same network, and says that it refuses."""
    client = make()
    client.run(5.0)
    other = client.add(client.personality, OTHER, heartbeat_at_s=5.2, telemetry=600.0)
    client.upload(SURVEY, proof="Always")
    refusing = mavlink.MAVLink_mission_ack_message(1, 191, mavlink.MAV_MISSION_INVALID, 0)
    packer = mavlink.MAVLink(None, 1, 1)
    for _ in range(40):
        client.bring(bytes(refusing.pack(packer)), OTHER)
        client.run(0.05)
        if client.ends:
            break
    assert client.run_until_ended(limit_s=120) == "Accepted"
    assert client.autopilot.received() == on_the_wire(SURVEY, client.personality)
    assert client.peer["strangers"] > 10
    assert other.log == [entry for entry in other.log if entry.direction == "<"]
    assert_whole_frames(client)
