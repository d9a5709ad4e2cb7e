"""The fake ArduPilot answers MAVLink FTP as the real one did in the recordings: each answer, byte by byte.

The client's frames come at their recorded times. Which milliseconds an answer takes is not compared. What a recording
does not tell is which plan was aboard at its beginning: what is read is compared from the first write on, or, where
nothing is written, with the plan that was read first.
"""

from __future__ import annotations

import zlib

import pytest

from simulation import recordings
from simulation.fake_autopilot import ArduPilot, mavlink
from simulation.fake_autopilot.ftp import BURST, CRC, HEADER, ITEM_SIZE, LIST, READ, WRITE, Request, file_of, item_in

FTP = pytest.mark.scenario(59, "Plans as files, as ArduPilot takes and gives them")
KIND = "FILE_TRANSFER_PROTOCOL"
# Seconds at which ftp_crc_and_read begins with another plan, or another home, aboard than before.
OTHERWISE_FROM_S = (0.0, 1.5, 4.8)
# Answers that something else than the client has changed: another client on another port had closed its file; the
# autopilot's home, item 0, was not set yet.
SPARED = {"arducopter/ftp_upload_vanish": {40}, "arducopter/ftp_upload_clean": {27}}
WRITTEN = [name for name in recordings.ftp() if not name.endswith(("ftp_crc_and_read", "ftp_disabled"))]


def spoken(name: str, from_s: float = 0.0, to_s: float = 1e9) -> list:
    return [one for one in recordings.heard(name) if from_s <= one.time < to_s]


def requests(heard, direction: str) -> list[Request]:
    """Those of one direction, '<' for the answers, without what lies behind their data."""
    return [trimmed(Request.of(one.message)) for one in heard
            if one.direction == direction and one.message.get_type() == KIND]  # fmt: skip


def trimmed(request: Request) -> Request:
    return request._replace(data=request.data[: request.size])


def played(heard, fake: ArduPilot) -> list[Request]:
    """What the fake answers to the client's side."""
    for one in heard:
        if one.direction == ">":
            fake.receive(one.frame, one.time)
            fake.run(one.time)
    fake.run(heard[-1].time + 1.0)
    return [trimmed(Request.of(message)) for message in fake.messages("<", KIND)]


def made(**options) -> ArduPilot:
    return ArduPilot(uptime_s=100.0, response_delay_s=0.0, **options)


@FTP
@pytest.mark.parametrize("name", WRITTEN)
def test_each_answer_is_that_of_the_recording(name):
    heard = spoken(name)
    real, said = requests(heard, "<"), played(heard, made())
    first_write = next(answer.seq for answer in real if answer.req_opcode == WRITE)
    reads = {answer.seq for answer in real if answer.seq < first_write and answer.req_opcode in (READ, CRC, LIST)}
    spared = reads | SPARED.get(name, set())
    assert len([answer for answer in real if answer.seq not in spared]) >= 4
    if name.endswith("ftp_duplicates"):  # some requests were lost, and so have no answer there
        assert is_within(real, said)
        return
    assert len(said) == len(real)
    for theirs, ours in zip(real, said, strict=True):
        assert ours == theirs or theirs.seq in spared


def is_within(few: list, many: list) -> bool:
    """Whether all of `few` are in `many`, in their order."""
    rest = iter(many)
    return all(any(one == other for other in rest) for one in few)


@FTP
def test_ftp_that_is_switched_off_is_silent_and_says_why_in_a_text():
    heard = spoken("arducopter/ftp_disabled")
    assert requests(heard, ">") != [] and requests(heard, "<") == []
    fake = made(ftp=False)
    assert played(heard, fake) == []
    real = [one.message.text for one in heard if one.direction == "<" and one.message.get_type() == "STATUSTEXT"]
    assert {message.text for message in fake.messages("<", "STATUSTEXT")} == {"failed to initialize MAVFTP"}
    assert "failed to initialize MAVFTP" in real


def read_first(heard) -> bytes:
    """The file that the client read first, from its beginning to its end."""
    whole = b""
    for answer in requests(heard, "<"):
        if answer.req_opcode == READ and answer.offset == len(whole):
            whole += answer.data
        if len(whole) >= HEADER.size and len(whole) == HEADER.size + ITEM_SIZE * HEADER.unpack_from(whole)[4]:
            return whole
    raise AssertionError("nothing is read to its end")


def comparable(answer: Request) -> Request:
    """Without the last byte of each item, mission_type: ReadFile gives there what lay in memory, now and then."""
    if answer.req_opcode not in (READ, BURST) or answer.opcode != 128:
        return answer
    types = range((HEADER.size - 1 - answer.offset) % ITEM_SIZE, len(answer.data), ITEM_SIZE)
    data = bytearray(answer.data)
    for at in types:
        if answer.offset + at >= HEADER.size:
            data[at] = 0
    return answer._replace(data=bytes(data))


@FTP
@pytest.mark.parametrize("part", range(3))
def test_what_is_read_and_its_checksums_are_those_of_the_recording(part):
    from_s, to_s = OTHERWISE_FROM_S[part], (*OTHERWISE_FROM_S, 1e9)[part + 1]
    heard = spoken("arducopter/ftp_crc_and_read", from_s, to_s)
    whole = read_first(heard)
    items = [item_in(whole[at : at + ITEM_SIZE]) for at in range(HEADER.size, len(whole), ITEM_SIZE)]
    fake = made(home=(items[0].x, items[0].y, items[0].z))
    fake.load(items)
    real, said = requests(heard, "<"), played(heard, fake)
    assert len(real) > 10 and [comparable(one) for one in said] == [comparable(one) for one in real]
    sums = [int.from_bytes(answer.data, "little") for answer in real if answer.req_opcode == CRC]
    assert sums[-1] == zlib.crc32(whole, 0xFFFFFFFF) ^ 0xFFFFFFFF
    if part == 2:
        assert any(answer.req_opcode == BURST for answer in real)


@FTP
def test_texts_about_fences_are_those_of_the_recording():
    heard = spoken("arducopter/ftp_fence_rally")
    fake = made()
    played(heard, fake)
    real = [one.message.text for one in heard if one.direction == "<" and one.message.get_type() == "STATUSTEXT"]
    assert [message.text for message in fake.messages("<", "STATUSTEXT")] == real


@FTP
def test_totals_after_an_upload_as_a_file_are_those_of_the_recording():
    heard = spoken("arducopter/ftp_mission_current")
    fake = made(streams={mavlink.MAVLINK_MSG_ID_MISSION_CURRENT: 0.2})
    played(heard, fake)
    real = [one.message.total for one in heard if one.direction == "<" and one.message.get_type() == "MISSION_CURRENT"]
    assert real[-1] == fake.messages("<", "MISSION_CURRENT")[-1].total
    assert max(real) == max(message.total for message in fake.messages("<", "MISSION_CURRENT"))


# What becomes of the plan, which is told by no answer ---------------------------------


class Client:
    """Writes files by hand."""

    def __init__(self, fake: ArduPilot, session: int = 7) -> None:
        self.fake, self.session, self.seq, self.now = fake, session, 100, 1.0
        self.packer = mavlink.MAVLink(None, 255, 190)

    def ask(self, opcode: int, data: bytes = b"", offset: int = 0, session: int | None = None) -> Request:
        request = Request(self.seq, self.session if session is None else session, opcode, len(data), 0, 0, offset, data)
        message = mavlink.MAVLink_file_transfer_protocol_message(0, 1, 1, list(request.packed()))
        self.fake.receive(message.pack(self.packer), self.now)
        self.fake.run(self.now)
        self.seq += 1
        self.now += 0.02
        return trimmed(Request.of(self.fake.messages("<", KIND)[-1]))

    def write(self, data: bytes, name: bytes = b"@MISSION/mission.dat", closes: bool = True) -> None:
        assert self.ask(6, name).opcode == 128
        for at in range(0, len(data), 239):
            assert self.ask(7, data[at : at + 239], at).opcode == 128
        if closes:
            assert self.ask(1).opcode == 128


@pytest.fixture
def client():
    from plans import OLD_PLAN

    fake = made()
    fake.load(OLD_PLAN)
    return Client(fake)


def new_plan(count: int = 3):
    from plans import HOME, waypoint

    return [HOME, *[waypoint(z=10.0 + number) for number in range(count)]]


def heights(client: Client) -> list[float]:
    return [item.z for item in client.fake.received()[1:]]


OLD_HEIGHTS = [100.0 + n for n in range(8)]


@FTP
def test_nothing_changes_before_the_file_is_closed(client):
    client.write(file_of(new_plan()), closes=False)
    assert heights(client) == OLD_HEIGHTS
    client.ask(1)
    assert heights(client) == [10.0, 11.0, 12.0]


@FTP
@pytest.mark.parametrize("fault", ["magic", "count too large", "count too small", "an item of zeros"])
def test_wrong_file_leaves_the_old_plan_and_is_answered_as_a_right_one(client, fault):
    data = bytearray(file_of(new_plan()))
    if fault == "magic":
        data[0] ^= 1
    elif fault == "an item of zeros":
        data[HEADER.size + ITEM_SIZE : HEADER.size + 2 * ITEM_SIZE] = bytes(ITEM_SIZE)
    else:
        data = bytearray(file_of(new_plan(), count=5 if fault == "count too large" else 3))
    client.write(bytes(data))
    assert heights(client) == OLD_HEIGHTS


@FTP
def test_refused_item_destroys_the_old_plan_behind_those_that_were_taken(client):
    from plans import waypoint

    client.write(file_of([*new_plan(2), waypoint(x=950000000), waypoint()]))
    assert heights(client) == [10.0, 11.0]


@FTP
def test_hole_that_covers_no_whole_item_is_stored_as_zeros(client):
    data = file_of(new_plan())
    hole = HEADER.size + 2 * ITEM_SIZE + 8
    assert client.ask(6, b"@MISSION/mission.dat").opcode == 128
    client.ask(7, data[:hole], 0)
    client.ask(7, data[hole + 20 :], hole + 20)
    client.ask(1)
    assert heights(client) == [10.0, 0.0, 12.0]


@FTP
def test_shorter_plan_while_auto_flies_is_a_mixture(client):
    fake = client.fake
    fake.armed, fake.mode = True, "AUTO"
    fake.flight.begin(1, 0.5)
    client.write(file_of(new_plan()))
    assert heights(client) == [10.0, 11.0, 12.0, *OLD_HEIGHTS[3:]]


@FTP
def test_other_client_with_the_same_session_number_closes_our_file_and_another_one_does_not(client):
    client.write(file_of(new_plan()), closes=False)
    client.ask(1, session=8)
    assert heights(client) == OLD_HEIGHTS
    other = Client(client.fake, session=7)
    other.seq, other.now = 500, client.now
    other.ask(1)
    assert heights(client) == [10.0, 11.0, 12.0]


@FTP
def test_complete_file_that_is_left_open_is_stored_by_the_next_client_that_opens_one(client):
    client.write(file_of(new_plan()), closes=False)
    other = Client(client.fake, session=9)
    other.seq, other.now = 500, client.now + 1.0
    assert other.ask(4, b"@MISSION/fence.dat").data == b"\x04"  # of a session that is not idle
    other.now += 3.1
    assert other.ask(4, b"@MISSION/fence.dat").opcode == 128
    assert heights(client) == [10.0, 11.0, 12.0]


@FTP
def test_ftp_shows_among_the_capabilities():
    for is_enabled in (True, False):
        fake = made(ftp=is_enabled)
        version = fake.message_of(mavlink.MAVLINK_MSG_ID_AUTOPILOT_VERSION, 1.0)
        assert bool(version.capabilities & mavlink.MAV_PROTOCOL_CAPABILITY_FTP) == is_enabled
