"""The faulty wire does to each frame what it is told, and to no other."""
import pytest

from simulation.fake_autopilot import mavlink
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


FAULTS = [
    (lambda wire: None, [0, 1, 2, 3]),
    (lambda wire: wire.lose(">", index=1), [0, 2, 3]),
    (lambda wire: wire.lose(">", seq=2), [0, 1, 3]),
    (lambda wire: wire.lose(">", name="MISSION_REQUEST_*"), [1, 2, 3]),
    (lambda wire: wire.lose(">", name="HEARTBEAT"), [0, 1, 2, 3]),
    (lambda wire: wire.lose(">", times=None), []),
    (lambda wire: wire.lose(">", times=2), [2, 3]),
    (lambda wire: wire.lose(">", where=lambda message: message.seq % 2, times=None), [0, 2]),
    (lambda wire: wire.lose(">", where=lambda message: message.seq % 2, index=1), [0, 1, 2]),
    (lambda wire: wire.lose("<", times=None), [0, 1, 2, 3]),
    (lambda wire: wire.repeat(">", copies=2, seq=0), [0, 0, 0, 1, 2, 3]),
    (lambda wire: wire.repeat(">", after_s=5.0, seq=0), [0, 1, 2, 3, 0]),
    (lambda wire: wire.delay(">", 1.5, seq=0), [1, 0, 2, 3]),
    (lambda wire: wire.hold_past_next(">", seq=0), [1, 0, 2, 3]),
    (lambda wire: wire.pull(), []),
]


@pytest.mark.parametrize("order, arrived", FAULTS)
def test_a_fault_strikes_the_frames_that_it_names(order, arrived):
    sent = frames(4)
    wire = Wire()
    order(wire)
    assert carried(wire, sent) == b"".join(sent[number] for number in arrived)
    wire.plug()


def test_bytes_are_damaged_cut_and_dropped_where_it_is_said():
    frame, other = frames(2)
    for byte in range(-3, 12):
        wire = Wire()
        wire.corrupt(">", byte=byte, flip=0x80)
        wrong = [a ^ b for a, b in zip(carried(wire, [frame]), frame, strict=True)]
        assert wrong == [0x80 * (number == byte % len(frame)) for number in range(len(frame))]
        wire = Wire()
        wire.truncate(">", max(byte, 0), seq=0)
        assert carried(wire, [frame, other]) == frame[:max(byte, 0)] + other
    for first, last in ((0, 0), (3, 20), (13, 14), (5, 999)):
        wire = Wire()
        wire.drop_bytes(">", first, last)
        assert carried(wire, [frame, other]) == (frame + other)[:first] + (frame + other)[last + 1:]


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
