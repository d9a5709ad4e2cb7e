"""The faulty wire does to each frame what it is told, and to no other."""
import pytest

from simulation.fake_autopilot import ArduPilot, Px4, item, mavlink
from simulation.wire import Wire, result_name, summary


def frames(count: int) -> list[bytes]:
    """MISSION_REQUEST_INT for items 0, 1, 2 ... as a client sends them."""
    packer = mavlink.MAVLink(None, 255, 190)
    return [bytes(mavlink.MAVLink_mission_request_int_message(1, 1, seq).pack(packer))
            for seq in range(count)]


def carried(wire: Wire, sent: list[bytes], direction: str = ">") -> bytes:
    """What comes out in the end if a frame goes in each second."""
    out = b""
    for now, frame in enumerate(sent):
        wire.send(direction, frame, float(now))
        out += wire.deliver(direction, float(now))
    return out + wire.deliver(direction, 1000.0)


def test_a_wire_without_faults_carries_every_byte():
    sent = frames(5)
    wire = Wire()
    assert carried(wire, sent) == b"".join(sent)
    assert [entry.fate for entry in wire.entries] == [""] * 5


def test_bytes_between_frames_are_carried_too():
    wire = Wire()
    sent = [b"boot text\r\n", *frames(1), b"\x00\x01"]
    assert carried(wire, sent) == b"".join(sent)
    assert [entry.number for entry in wire.entries] == [None, 0, None]


def test_a_frame_moves_on_when_its_last_byte_is_in():
    wire = Wire()
    frame = frames(1)[0]
    wire.send(">", frame[:-1], 0.0)
    assert wire.deliver(">", 1.0) == b"" and wire.next_event() is None
    wire.send(">", frame[-1:], 2.0)
    assert wire.next_event() == 2.0 and wire.deliver(">", 2.0) == frame


@pytest.mark.parametrize("index", range(5))
def test_each_frame_can_be_lost(index):
    sent = frames(5)
    wire = Wire()
    wire.lose(">", index=index)
    assert carried(wire, sent) == b"".join(sent[:index] + sent[index + 1:])
    assert [entry.fate for entry in wire.entries if entry.fate] == ["lost"]


@pytest.mark.parametrize("which, lost", [
    (dict(seq=2), [2]), (dict(name="MISSION_REQUEST_*"), [0]), (dict(name="HEARTBEAT"), []),
    (dict(name="MISSION_*", times=None), [0, 1, 2, 3]), (dict(times=2), [0, 1]),
    (dict(where=lambda message: message.seq % 2, times=None), [1, 3]),
    (dict(where=lambda message: message.seq % 2, index=1), [3])])
def test_a_fault_strikes_the_frames_that_it_names(which, lost):
    sent = frames(4)
    wire = Wire()
    fault = wire.lose(">", **which)
    assert carried(wire, sent) == b"".join(
        frame for number, frame in enumerate(sent) if number not in lost)
    assert fault.struck == len(lost)


def test_one_direction_does_not_suffer_from_the_faults_of_the_other():
    sent = frames(3)
    wire = Wire()
    wire.lose("<", times=None)
    assert carried(wire, sent) == b"".join(sent)
    assert carried(wire, sent, "<") == b""


def test_a_frame_can_be_repeated_at_once_or_later():
    sent = frames(2)
    wire = Wire()
    wire.repeat(">", copies=2, seq=0)
    assert carried(wire, sent) == sent[0] * 3 + sent[1]
    wire = Wire()
    wire.repeat(">", after_s=5.0, seq=0)
    assert carried(wire, sent) == sent[0] + sent[1] + sent[0]


def test_a_frame_can_be_delayed_and_overtaken():
    sent = frames(3)
    wire = Wire()
    wire.delay(">", 1.5, seq=0)
    assert carried(wire, sent) == sent[1] + sent[0] + sent[2]


def test_a_line_with_latency_keeps_each_frame_and_their_order():
    wire = Wire()
    wire.set_latency(0.15)
    first, second, third = frames(3)
    wire.send(">", first, 1.0)
    wire.send(">", second, 1.1)
    wire.send("<", third, 1.0)
    assert wire.next_event() == 1.15 and wire.deliver(">", 1.149) == b""
    assert wire.deliver(">", 1.15) == first and wire.deliver("<", 1.15) == third
    assert wire.deliver(">", 1.25) == second
    wire.set_latency(0, "<")
    wire.send("<", third, 2.0)
    wire.send(">", first, 2.0)
    assert wire.deliver("<", 2.0) == third and wire.deliver(">", 2.0) == b""


def test_a_radio_takes_turns_batches_and_halves_the_line():
    wire = Wire()
    wire.set_radio(0.06)
    first, second, third = frames(3)
    wire.send(">", first, 0.01)
    wire.send(">", second, 0.02)
    wire.send("<", third, 0.01)
    assert wire.deliver(">", 0.059) == b"" and wire.deliver(">", 0.06) == first + second
    assert wire.deliver("<", 0.119) == b"" and wire.deliver("<", 0.12) == third
    for frame in frames(100):
        wire.send(">", frame, 0.12)
    came, now = 0, 0.12
    while came < 100 * len(first):
        now += 0.001
        came += len(wire.deliver(">", now))
    assert 0.9 < (now - 0.12) / (2 * 100 * len(first) * 10 / 57600) < 1.2
    wire.send(">", second, now - 0.01)
    wire.set_radio(0)
    wire.send(">", third, now)
    assert wire.deliver(">", now + 0.2) == second + third


def test_a_frame_can_be_held_past_the_next():
    sent = frames(3)
    wire = Wire()
    wire.hold_past_next(">", seq=0)
    assert carried(wire, sent) == sent[1] + sent[0] + sent[2]


@pytest.mark.parametrize("byte", range(-3, 12))
def test_a_byte_of_a_frame_can_be_corrupted(byte):
    frame = frames(1)[0]
    wire = Wire()
    wire.corrupt(">", byte=byte, flip=0x80)
    out = carried(wire, [frame])
    assert [a ^ b for a, b in zip(out, frame, strict=True)] \
        == [0x80 * (number == byte % len(frame)) for number in range(len(frame))]


@pytest.mark.parametrize("keep", range(14))
def test_a_frame_can_be_cut_short(keep):
    sent = frames(2)
    wire = Wire()
    wire.truncate(">", keep, seq=0)
    assert carried(wire, sent) == sent[0][:keep] + sent[1]


@pytest.mark.parametrize("first, last", [(0, 0), (3, 20), (13, 14), (5, 999)])
def test_bytes_can_be_dropped_wherever_they_are(first, last):
    sent = frames(4)
    wire = Wire()
    wire.drop_bytes(">", first, last)
    whole = b"".join(sent)
    assert carried(wire, sent) == whole[:first] + whole[last + 1:]


def test_a_pulled_cable_carries_nothing_until_it_is_put_back():
    sent = frames(3)
    wire = Wire()
    wire.pull()
    assert carried(wire, sent[:1]) == b"" == carried(wire, sent[:1], "<")
    wire.plug()
    assert carried(wire, sent[1:]) == b"".join(sent[1:])
    assert wire.entries[0].fate == "no wire"


def test_chance_depends_on_the_seed_alone_and_keeps_its_percentage():
    sent = frames(200) * 10
    outs = []
    for seed in (1, 1, 2):
        wire = Wire(seed)
        wire.at_random(">", lose=25)
        outs.append(carried(wire, sent))
        lost = [entry for entry in wire.entries if entry.fate]
        assert 0.2 < len(lost) / len(sent) < 0.3
    assert outs[0] == outs[1] != outs[2]


def test_every_kind_of_chance_strikes():
    wire = Wire(7)
    wire.at_random(">", lose=10, repeat=10, delay=10, hold_past_next=10, corrupt=10, truncate=10)
    carried(wire, frames(200))
    assert {entry.fate for entry in wire.entries} == {
        "", "lost by chance", "repeated by chance", "delayed by chance",
        "held past the next by chance", "corrupted by chance", "truncated by chance"}


def test_chance_can_be_kept_to_some_messages():
    wire = Wire(7)
    wire.at_random(">", lose=50, where=lambda message: message.seq < 10)
    carried(wire, frames(50))
    lost = [entry.message.seq for entry in wire.entries if entry.fate]
    assert lost and max(lost) < 10


def test_orders_that_make_no_sense_are_refused_in_words():
    wire = Wire()
    with pytest.raises(ValueError, match="'>' or '<'"):
        wire.lose("up")
    with pytest.raises(ValueError, match="more than 100"):
        wire.at_random(">", lose=60, repeat=60)
    with pytest.raises(ValueError, match="no range"):
        wire.drop_bytes(">", 5, 4)
    with pytest.raises(ValueError, match="1 to 255"):
        wire.corrupt(">", flip=0)


def test_the_transcript_has_one_line_per_frame_for_people_to_read():
    wire = Wire()
    wire.lose(">", name="MISSION_REQUEST_INT", seq=1)
    carried(wire, frames(2))
    packer = mavlink.MAVLink(None, 1, 1)
    carried(wire, [bytes(mavlink.MAVLink_mission_ack_message(255, 190, 13, 1).pack(packer)),
                   bytes(mavlink.MAVLink_statustext_message(6, b"hello\t").pack(packer))], "<")
    lines = wire.transcript().splitlines()
    assert lines[0] == "    0.0000 > MISSION_REQUEST_INT seq=0"
    assert lines[1].endswith("[lost]") and "MISSION_REQUEST_INT seq=1" in lines[1]
    assert lines[2].endswith("< MISSION_ACK INVALID_SEQUENCE fence")
    assert lines[3].endswith('< STATUSTEXT "hello"')
    assert wire.transcript(faults_only=True) == lines[1]
    assert wire.transcript("MISSION_ACK") == lines[2]
    assert [entry.message.seq for entry in wire.frames(">", "MISSION_REQUEST_INT")] == [0, 1]


def test_a_message_is_summed_up_in_a_few_words():
    assert summary(mavlink.MAVLink_mission_item_int_message(
        1, 1, 4, 3, 16, 0, 1, 0, 0, 0, 0, 10, 20, 7.5, 2), b"") \
        == "MISSION_ITEM_INT seq=4 command=16 frame=3 x=10 y=20 z=7.5"
    assert summary(None, b"\x01\x02") == "2 bytes 01 02"
    assert result_name(15) == "OPERATION_CANCELLED" and result_name(200) == "result 200"


@pytest.mark.parametrize("autopilot", [ArduPilot, Px4])
def test_an_autopilot_hears_nothing_of_a_frame_damaged_on_the_wire(autopilot):
    fake = autopilot()
    fake.load([item(16, x=1, y=1, z=5.0)])
    for byte in range(1, 14):
        wire = Wire()
        wire.corrupt(">", byte=byte)
        packer = mavlink.MAVLink(None, 255, 190)
        wire.send(">", mavlink.MAVLink_mission_request_list_message(1, 1).pack(packer), 1.0)
        fake.receive(wire.deliver(">", 1.0) + b"\0" * 280, 1.0)
    fake.run(2.0)
    assert fake.messages("<", "MISSION_COUNT") == []


@pytest.mark.parametrize("fate", ["lose", "alter", "insert"])
def test_bytes_are_damaged_at_the_percentage_asked_for_and_by_the_seed_alone(fate):
    def run(seed: int) -> Wire:
        wire = Wire(seed)
        wire.damage_bytes(**{fate: 3})
        wire.arrived = {direction: carried(wire, frames(500), direction) for direction in "><"}
        return wire

    one, again, other = run(5), run(5), run(6)
    assert one.arrived == again.arrived != other.arrived
    sent = b"".join(frames(500))
    for arrived in one.arrived.values():
        if fate == "alter":
            damaged = sum(left != right for left, right in zip(arrived, sent, strict=True))
        else:
            damaged = abs(len(arrived) - len(sent))
        assert 0.02 < damaged / len(sent) < 0.04
    assert one.arrived[">"] != one.arrived["<"]


def test_damaged_bytes_are_told_of_in_the_transcript_and_end_when_told_to():
    wire = Wire(1)
    wire.damage_bytes(">", lose=100)
    assert carried(wire, frames(1)) == b"" and wire.entries[-1].fate == "16 bytes lost"
    assert carried(wire, frames(1), "<") == frames(1)[0]
    wire.damage_bytes()
    assert carried(wire, frames(1)) == frames(1)[0] and wire.entries[-1].fate == ""
    with pytest.raises(ValueError, match="percent"):
        wire.damage_bytes(lose=60, alter=50)
