"""A client over UDP: in a network that loses, repeats, reorders and delays datagrams, and where others speak too."""

from __future__ import annotations

from pathlib import Path

import pytest

from datagrams import Network, Place, frames_in
from plans import SURVEY, on_the_wire
from planted import with_defect
from simulation.fake_autopilot import FakeAutopilot, mavlink
from simulation.firmware import LIBRARY, ROOT, digest
from udp_client import BRIDGE, UdpClient
from udp_rates import LATENCY_MS, LOSS, in_the_page, network, row

OTHER, LATER = Place(3, BRIDGE.port), Place(3, 14600)


@pytest.fixture
def make(personality):
    made = []

    def made_of(*arguments, **options) -> UdpClient:
        made.append(UdpClient(personality, *arguments, **options))
        return made[-1]

    yield made_of
    for client in made:
        client.close()


def assert_whole_frames(client: UdpClient, to: Place = BRIDGE) -> None:
    """What has left went to this place alone. (That each datagram is whole frames is looked at as it leaves.)"""
    assert {target for target, _ in client.targets} == {to}


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
    assert {cells[-1] for cells in rows} == {"0"}
    assert row(LATENCY_MS[0], LOSS[1]) == rows[1]


# The peer


def assert_uploads_beside_another(client: UdpClient) -> None:
    """An upload while another aircraft with the same ids speaks in the same network, and says that it refuses."""
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


def test_upload_beside_another_aircraft_with_the_same_ids_is_accepted(make):
    assert_uploads_beside_another(make())


def meets_two_aircraft(client: UdpClient) -> FakeAutopilot:
    other = client.add(client.personality, OTHER, heartbeat_at_s=0.9)
    client.run(10.0)
    assert client.peer["several"] == 1 and client.peer["port"] == 0
    assert not client.targets
    return other


def test_two_aircraft_that_begin_together_are_told_apart_by_nobody_but_the_sketch(make, personality):
    client = make()
    other = meets_two_aircraft(client)
    client.name_peer(OTHER)
    client.upload(SURVEY)
    assert client.run_until_ended(limit_s=20) == "Accepted"
    assert other.received() == on_the_wire(SURVEY, personality)
    assert_whole_frames(client, OTHER)


def loses_its_peer_beside_another(client: UdpClient) -> FakeAutopilot:
    client.run(4.0)
    client.autopilot.faults.fall_silent(from_time=client.now, for_s=1000)
    other = client.add(client.personality, LATER, heartbeat_at_s=client.now + 0.1)
    client.run(30.0)
    assert (client.peer["host"], client.peer["port"]) == BRIDGE
    assert client.state["found"] == 0
    return other


def test_another_host_never_takes_the_place_of_a_peer_that_is_silent(make, personality):
    client = make()
    other = loses_its_peer_beside_another(client)
    client.forget_peer()
    client.run(5.0)
    assert (client.peer["host"], client.peer["port"]) == LATER
    client.upload(SURVEY)
    assert client.run_until_ended(limit_s=20) == "Accepted"
    assert other.received() == on_the_wire(SURVEY, personality)


def test_peer_that_is_named_is_the_only_one_with_any_port(make):
    client = make(at=Place(BRIDGE.host, 40000))
    client.name_peer(BRIDGE)
    client.run(20.0)
    assert client.state["found"] == 0 and client.peer["strangers"] > 10
    client.name_peer(client.place)
    client.upload(SURVEY)
    assert client.run_until_ended(limit_s=20) == "Accepted"


# Defects, each of which the tests above must find


def header_with_defect(right: str, wrong: str) -> Path:
    """The folder of a MavMissionUdp.h in which `right`, which must be there once, is `wrong`."""
    text = (LIBRARY / "MavMissionUdp.h").read_text()
    assert text.count(right) == 1, f"the line that the defect is planted in has changed: {right}"
    changed = text.replace(right, wrong)
    folder = ROOT / "build" / "planted" / digest(changed)[:12]
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "MavMissionUdp.h").write_text(changed)
    return folder


def uploads(client: UdpClient) -> None:
    client.upload(SURVEY, proof="Always")
    assert client.run_until_ended(limit_s=30) == "Accepted"


IN_PACKETS = {
    "a frame is split": ("} else if (begun == needed) {", "} else if (begun == needed || begun == 20) {"),
    "zeros are sent": ("if (length_ == whole_ && byte !=", "if (false && byte !="),
}
IN_THE_PEER = {
    "a second sender is taken in": (
        assert_uploads_beside_another, "if (isItsAddress && port == port_) return true;",
        "if (port != 0) return true;"),
    "the last sender is answered": (
        assert_uploads_beside_another, "const bool isItsAddress = udp_.remoteIP() == address_;",
        "const bool isItsAddress = udp_.remoteIP() == address_;\n    address_ = udp_.remoteIP();"),
    "two aircraft are not noticed": (meets_two_aircraft, "severalHeard_ = true;", ""),
    "another host takes the place": (
        loses_its_peer_beside_another, "if (!isItsAddress || !isSilent_", "if (!isSilent_"),
    "a stranger's datagram is not read to its end": (assert_uploads_beside_another, "      leaveOut();\n", ""),
}  # fmt: skip


@pytest.mark.parametrize("defect", IN_PACKETS)
def test_defect_in_the_packets_is_found(defect):
    client = UdpClient("PX4", Network(2, lose=10), sources=with_defect("PacketLink.cpp", *IN_PACKETS[defect]))
    with pytest.raises((AssertionError, ValueError)), client:
        uploads(client)


@pytest.mark.parametrize("defect", IN_THE_PEER)
def test_defect_in_the_choice_of_the_peer_is_found(defect):
    scenario, *changed = IN_THE_PEER[defect]
    client = UdpClient("PX4", Network(2), instead=header_with_defect(*changed))
    with pytest.raises((AssertionError, ValueError)), client:
        scenario(client)
