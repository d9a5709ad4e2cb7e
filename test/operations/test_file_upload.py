"""A plan is written to ArduPilot as a file, which takes the place of the old plan at once, or not at all."""

from __future__ import annotations

import pytest

from areas import FIELD, POINTS
from disorders import latency_of
from downloads import WRITTEN, as_ardupilot_has_it, loaded
from files import by_items, is_by_file, open_file, other_asks, other_opens, requests, spoken, with_files
from plans import HOME, OLD_PLAN, SURVEY, on_the_wire, waypoint
from simulation.bench import FunctionPlan, same_bits
from simulation.fake_autopilot import item
from simulation.fake_autopilot.ftp import BURST, CREATE, HEADER, OPEN_RO, READ, TERMINATE, WRITE, file_of
from simulation.service import FENCE, MISSION, RALLY
from simulation.wire import Wire

BY_FILE = pytest.mark.scenario(62, "A plan is uploaded as a file", "ArduPilot")
BY_ITEMS = pytest.mark.scenario(63, "A plan that no file can carry is uploaded item by item")
NO_MIXTURE = pytest.mark.scenario(64, "An upload by file leaves the old plan or the new one, or says neither",
                                   "ArduPilot")  # fmt: skip
LIMIT_S = 30
FTP = "FILE_TRANSFER_PROTOCOL"
LONG = [waypoint(x=470000000 + 7 * n, z=n + 1.0) for n in range(20)]
SMALL_FENCE = [item(5003, x=473977420, y=85455970, param1=50.0, frame=0)]


def uploading(service, plan=None, mission_type=MISSION) -> str:
    if plan is not None:
        service.use(plan)
    return service.order_of("fileupload", mission_type)


def meant(plan) -> list:
    return [HOME, *as_ardupilot_has_it(plan)] if plan else []


def holds(service, plan) -> bool:
    """Whether this is what was last put aboard, to the bit."""
    return same_bits(service.autopilot.received(), meant(plan))


def go_to(service, count: int, opcode: int | None = None) -> None:
    """Go on until so many requests have left, or so many of one kind."""
    limit = service.now + 10
    while len([one for one in requests(service) if opcode in (None, one)]) < count:
        assert service.now < limit
        service.run(0.001)


# -- the way it goes


@BY_FILE
def test_plan_is_written_and_read_back(build_service):
    service = with_files(build_service)
    service.autopilot.load(OLD_PLAN)
    assert uploading(service, WRITTEN) == "WaitingForAutopilot"
    assert service.done(LIMIT_S) == "Accepted"
    assert holds(service, [one._replace(param4=0.0 if one.param4 != one.param4 else one.param4) for one in WRITTEN])
    assert requests(service) == [CREATE, WRITE, WRITE, WRITE, TERMINATE, OPEN_RO, READ, BURST, TERMINATE]
    assert by_items(service) == []
    state = service.state
    assert (state.aboard, state.done, state.total, state.failed_item, state.field) == ("OurPlan", 8, 8, None, "None")
    assert is_by_file(service)
    assert open_file(service) is None


@BY_FILE
def test_ardupilot_that_is_still_starting_has_no_room_and_takes_the_plan_later(build_service):
    """Nor does it open the file; what it says then is said of the items."""
    service = with_files(build_service, storage_s=4.0, uptime_s=0.0)
    uploading(service, SURVEY)
    assert service.done(LIMIT_S) == "NoSpace"
    assert (service.state.aboard, service.now < 4.0) == ("AsBefore", True)
    service.run_until(4.5)
    uploading(service)
    assert service.done(LIMIT_S) == "Accepted"
    assert is_by_file(service) and holds(service, SURVEY)


def reset_before_the_closing(build_service):
    """A board that a reset has restarted behind a whole file, which is still open: the closing was lost."""
    service = with_files(build_service)
    service.autopilot.load(OLD_PLAN)
    service.wire.lose(">", name=FTP, index=6)  # the closing
    uploading(service, LONG)
    go_to(service, 7)
    service.reset()
    return service


@NO_MIXTURE
@pytest.mark.parametrize("then", ["fileverify", "fileensure", "fileupload"])
def test_reset_between_a_files_header_and_its_closing_leaves_the_old_plan(build_service, then):
    """ArduPilot would store the file when one is opened next. Its header is taken away with the first heartbeat."""
    service = reset_before_the_closing(build_service)
    service.run(4.0)
    assert same_bits(service.autopilot.received(), OLD_PLAN) and open_file(service) is None
    service.use(LONG)
    service.order_of(then, MISSION)
    assert service.done(LIMIT_S) == ("Differs" if then == "fileverify" else "Accepted")
    assert is_by_file(service) and open_file(service) is None
    if then != "fileverify":
        assert holds(service, LONG) and service.state.aboard == "OurPlan"


@NO_MIXTURE
def test_file_of_before_a_reset_is_left_alone_in_flight_and_closed_on_the_ground(build_service):
    """To look for it closes what somebody else has left open, which may store a plan."""
    service = reset_before_the_closing(build_service)
    service.autopilot.armed = True
    sent = len(requests(service))
    service.run(8.0)
    assert len(requests(service)) == sent and open_file(service) is not None
    service.autopilot.armed = False
    service.run(4.0)
    assert open_file(service) is None
    assert same_bits(service.autopilot.received(), OLD_PLAN)


@NO_MIXTURE
@pytest.mark.parametrize("lost", [None, ">", "<"])
@pytest.mark.parametrize("begins_s", [0.0, 6.0])
def test_file_that_was_left_open_before_a_reset_is_never_stored_over_the_next_plan(build_service, begins_s, lost):
    """It is complete but for its closing. Then a plan is uploaded item by item, and somebody opens a file."""
    service = reset_before_the_closing(build_service)
    if lost is not None:
        service.wire.lose(lost, name=FTP)
    service.run(begins_s)
    service.upload(SURVEY, proof="InDoubt")
    assert service.done(LIMIT_S) == "Accepted"
    service.run(4.0)
    assert open_file(service) is None, "the file was left open"
    assert holds(service, SURVEY) and service.state.aboard == "OurPlan"


@BY_FILE
def test_file_is_as_other_clients_write_it(build_service):
    service = with_files(build_service)
    service.wire.lose(">", name=FTP, index=6)  # the closing
    uploading(service, LONG)
    go_to(service, 7)
    assert open_file(service) == file_of(meant(LONG))
    assert service.done(LIMIT_S) == "Accepted"


@BY_FILE
def test_progress_stands_still_before_the_last_item_until_the_plan_is_proven(build_service):
    service = with_files(build_service)
    uploading(service, LONG)
    go_to(service, 1, BURST)
    assert service.progress[-1] == (19, 20)
    assert service.done(LIMIT_S) == "Accepted"
    assert service.progress[-1] == (20, 20)
    assert service.progress == sorted(service.progress)


@BY_FILE
@pytest.mark.parametrize("mission_type, plan", [(FENCE, FIELD), (RALLY, POINTS)], ids=["fence", "rally"])
def test_fence_and_rally_points_are_written_to_files_of_their_own(build_service, mission_type, plan):
    service = with_files(build_service)
    uploading(service, plan, mission_type)
    assert service.done(LIMIT_S) == "Accepted"
    assert is_by_file(service) and by_items(service) == []
    assert same_bits(service.autopilot.missions[mission_type].received, plan)
    assert (service.state.aboard_fence if mission_type == FENCE else service.state.aboard_rally) == "OurPlan"
    assert service.state.aboard == "NotKnown"


# -- where there are no files, or none for this plan


@BY_ITEMS
@pytest.mark.parametrize("case", ["PX4", "MAVLink 1", "switched off", "held by another"])
def test_without_a_file_the_mission_protocol_is_used(build_service, case):
    personality = "PX4" if case == "PX4" else "ArduPilot"
    options = {"MAVLink 1": {"mavlink_version": 1}, "switched off": {"ftp": False}}.get(case, {})
    service = with_files(build_service, personality, **options)
    if case == "held by another":
        service.run(1.0)
        other_opens(service)
    uploading(service, SURVEY)
    assert service.done(LIMIT_S) == "Accepted"
    assert service.autopilot.received() == on_the_wire(SURVEY, personality)
    assert not is_by_file(service)
    assert service.state.aboard == "OurPlan"
    if case == "held by another":
        service.run(3.0)
        assert open_file(service) is not None, "the other's file was closed"


@BY_ITEMS
def test_command_that_is_not_known_is_refused_by_the_autopilot_in_words(build_service):
    """In a file it would have left the items before it aboard, without a word."""
    service = with_files(build_service)
    service.autopilot.load(OLD_PLAN)
    uploading(service, [SURVEY[0], item(31010, frame=2), SURVEY[1]])
    assert service.done(LIMIT_S) == "Unsupported"
    assert requests(service) == []
    assert service.state.failed_item == 1


@BY_ITEMS
def test_short_fence_is_read_back_after_it_has_settled(build_service):
    service = with_files(build_service)
    uploading(service, SMALL_FENCE, FENCE)
    assert service.done(LIMIT_S) == "Accepted"
    assert requests(service) == [WRITE] and not is_by_file(service)  # the look for a file of before
    assert service.state.aboard_fence == "OurPlan"


# -- in flight


@BY_FILE
@pytest.mark.parametrize("aboard, is_file", [(3, True), (5, True), (6, False)], ids=["longer", "as long", "shorter"])
def test_plan_in_flight_goes_by_file_unless_it_is_shorter_than_the_one_aboard(build_service, aboard, is_file):
    service = with_files(build_service, armed=True)
    loaded(service, LONG[:aboard])
    service.tell("armed", True)
    uploading(service, SURVEY)
    assert service.done(LIMIT_S) == "Accepted"
    assert is_by_file(service) == is_file
    assert (CREATE in requests(service)) == is_file
    assert holds(service, SURVEY)


# -- what the line loses


@NO_MIXTURE
@pytest.mark.parametrize("direction, index", [
    *[pytest.param(">", index, id=f"request {index}") for index in range(7)],
    *[pytest.param("<", index, id=f"answer {index}") for index in range(7)],
])  # fmt: skip
def test_each_lost_frame_costs_time_alone(build_service, direction, index):
    service = with_files(build_service)
    service.autopilot.load(OLD_PLAN)
    service.wire.lose(direction, name=FTP, index=index)
    uploading(service, LONG)
    assert service.done(LIMIT_S) == "Accepted"
    assert holds(service, LONG) and service.state.aboard == "OurPlan"
    said = [request for request in spoken(service) if request.opcode != BURST]
    for request in said:
        alike = [one for one in said if one.seq == request.seq]
        assert all(one == request for one in alike), "a repeat is another request"
    assert is_by_file(service) and "MISSION_ITEM_INT" not in by_items(service)


@NO_MIXTURE
@pytest.mark.parametrize("seed", range(8))
@pytest.mark.parametrize("loss", [5, 25])
def test_what_it_says_is_true_on_a_bad_line(build_service, seed, loss):
    service = with_files(build_service, wire=Wire(seed=seed))
    service.autopilot.load(OLD_PLAN)
    service.run(1.2)
    for direction in "<>":
        service.wire.at_random(direction, lose=loss, repeat=3, delay=3)
    service.wire.set_latency(latency_of(seed))
    uploading(service, LONG)
    expect_truth(service, service.done(150))


def expect_truth(service, ended: str) -> None:
    """What is aboard is the old plan or the new one, or is said to be neither."""
    is_old, is_new = same_bits(service.autopilot.received(), OLD_PLAN), holds(service, LONG)
    aboard = service.state.aboard
    assert (ended == "Accepted") == (aboard == "OurPlan")
    assert aboard != "OurPlan" or is_new
    assert aboard != "AsBefore" or is_old
    assert is_old or is_new or aboard in ("NotKnown", "Mixture")
    assert aboard != "Mixture" or not is_by_file(service)


# -- what happens meanwhile


@NO_MIXTURE
@pytest.mark.parametrize("sent", range(1, 7))
def test_another_client_that_takes_the_file_over_does_not_spoil_the_plan(build_service, sent):
    """It ends a session of its own, and opens the file at once."""
    service = with_files(build_service)
    service.autopilot.load(OLD_PLAN)
    uploading(service, LONG)
    go_to(service, sent)
    other_asks(service, TERMINATE, 7, 1)
    other_opens(service, 7)
    ended = service.done(LIMIT_S)
    assert ended == "Accepted" and holds(service, LONG)
    expect_truth(service, ended)


@NO_MIXTURE
@pytest.mark.parametrize("is_lossy", [False, True], ids=["quiet", "lossy"])
@pytest.mark.parametrize("at, put", [(30, 0x4B), (18, 0x01)], ids=["command", "place"])
def test_item_that_the_line_has_altered_unnoticed_is_put_right_where_the_line_loses(build_service, is_lossy, at, put):
    """A frame that has lost bytes has the right checksum by chance: ArduPilot refuses the item, or keeps another."""
    service = with_files(build_service)
    service.autopilot.load(OLD_PLAN)
    service.run(0.5)
    if is_lossy:
        service.say_bytes(b"\x55" * 5)
    uploading(service, LONG)
    begun = len(requests(service))  # it has looked for a file of before
    while HEADER.size not in (request.size for request in spoken(service)[begun:] if request.opcode == WRITE):
        service.run(0.001)
    service.autopilot.ftp._data[HEADER.size + 8 * 38 + at] ^= put
    ended = service.done(LIMIT_S)
    assert ended == ("Accepted" if is_lossy else "Differs")
    assert (service.state.aboard, holds(service, LONG)) == (("OurPlan", True) if is_lossy else ("NotKnown", False))
    assert is_by_file(service) == (not is_lossy)
    if is_lossy:
        assert by_items(service)[-1] == "MISSION_REQUEST_INT", "it was not read back"


@BY_FILE
@pytest.mark.parametrize("count", [50, 200])
def test_plan_is_written_in_little_more_than_the_time_of_its_bytes(build_bench, count):
    """The goal is 1.25 times that, from CreateFile to the answer to TerminateSession."""
    bench = build_bench("ArduPilot", defines={"BENCH_FILES": 1})
    bench.use(FunctionPlan(count))
    bench.tell("fileupload")
    assert bench.run_until_ended(LIMIT_S) == "Accepted"
    said, answered = (bench.wire.frames(direction, FTP) for direction in "><")
    closed = next(entry.time for entry, answer in zip(answered, spoken(bench, "<"), strict=True)
                  if answer.req_opcode == TERMINATE)  # fmt: skip
    took, bytes_s = closed - said[0].time, (HEADER.size + 38 * (count + 1)) / 5760
    print(f"{count} items: {took:.2f} s, the bytes of the file alone {bytes_s:.2f} s")
    assert took < 1.25 * bytes_s
