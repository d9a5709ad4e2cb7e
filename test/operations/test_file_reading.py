"""Plans are read as files from ArduPilot, and item by item where there are no files, or where that is quicker."""

from __future__ import annotations

import pytest

from areas import FIELD, POINTS
from disorders import latency_of
from downloads import WRITTEN, loaded, same
from files import by_items, is_by_file, open_file, other_opens, requests, with_files
from plans import NAN, SURVEY, waypoint
from simulation.fake_autopilot.ftp import BURST, OPEN_RO, READ, TERMINATE, WRITE
from simulation.service import FENCE, HOME_INDEX, MISSION, RALLY
from simulation.wire import Wire

BY_FILE = pytest.mark.scenario(60, "Plans are read as files", "ArduPilot")
LIMIT_S = 20
LONG = [waypoint(x=470000000 + 7 * n, z=n + 1.0, param4=NAN) for n in range(60)]


def verifying(service, plan=None, mission_type=MISSION) -> str:
    if plan is not None:
        service.use(plan)
    return service.order_of("fileverify", mission_type)


def downloading(service, mission_type=MISSION, limit=HOME_INDEX - 1, refused=HOME_INDEX - 1) -> str:
    return service.order_of("filedownload", mission_type, limit, refused)


@BY_FILE
def test_plan_that_is_aboard_is_verified_by_one_burst(build_service):
    service = with_files(build_service)
    loaded(service, WRITTEN)
    assert verifying(service, WRITTEN) == "WaitingForAutopilot"
    assert service.done(LIMIT_S) == "Verified"
    assert requests(service) == [OPEN_RO, READ, BURST, TERMINATE]
    assert by_items(service) == []
    state = service.state
    assert (state.done, state.total, state.aboard, state.failed_item, state.field) == (8, 8, "OurPlan", None, "None")
    assert is_by_file(service)
    assert open_file(service) is None


@BY_FILE
def test_download_gives_what_the_mission_protocol_gives(build_service):
    service = with_files(build_service)
    loaded(service, WRITTEN)
    assert service.download() == "WaitingForAutopilot"
    assert service.done(LIMIT_S) == "Downloaded"
    by_protocol, home = service.sink(len(WRITTEN)), service.home
    assert not same(by_protocol, LONG[: len(WRITTEN)])
    service.reset()
    before = len(by_items(service))
    downloading(service)
    assert service.done(LIMIT_S) == "Downloaded"
    assert service.sunk == [HOME_INDEX, *range(8)] * 2
    assert same(service.sink(len(WRITTEN)), by_protocol) and same([service.home], [home])
    assert same(by_protocol, WRITTEN)
    assert len(by_items(service)) == before


CHANGES = [
    ("Command", {"command": 17}),
    ("Reference", {"frame": 0}),
    ("Param1", {"param1": 4.0}),
    ("Latitude", {"x": 473979421}),
    ("Longitude", {"y": 85455969}),
    ("Height", {"z": 20.26}),
]


@BY_FILE
@pytest.mark.parametrize("field, change", CHANGES, ids=[name for name, _ in CHANGES])
def test_item_that_differs_is_named_with_its_field(build_service, field, change):
    service = with_files(build_service)
    loaded(service, [one._replace(**change) if index == 1 else one for index, one in enumerate(WRITTEN)])
    verifying(service, WRITTEN)
    assert service.done(LIMIT_S) == "Differs"
    state = service.state
    assert (state.failed_item, state.field, state.aboard) == (1, field, "NotKnown")
    assert is_by_file(service)
    service.run(1.5)
    assert open_file(service) is None


@BY_FILE
@pytest.mark.parametrize("mission_type, plan", [(FENCE, FIELD), (RALLY, POINTS)], ids=["fence", "rally"])
def test_fence_and_rally_points_are_read_from_files_of_their_own(build_service, mission_type, plan):
    service = with_files(build_service)
    service.upload(plan, mission_type)
    assert service.done(LIMIT_S) == "Accepted"
    service.reset()
    verifying(service, plan, mission_type)
    assert service.done(LIMIT_S) == "Verified"
    assert is_by_file(service)
    assert (service.state.aboard_fence if mission_type == FENCE else service.state.aboard_rally) == "OurPlan"


# -- where there are no files


@pytest.mark.scenario(61, "Where there are no files, plans are transferred item by item")
@pytest.mark.parametrize("word, end", [("fileverify", "Verified"), ("filedownload", "Downloaded")])
@pytest.mark.parametrize("case", ["PX4", "MAVLink 1", "switched off", "held by another"])
def test_without_a_file_the_mission_protocol_is_used(build_service, case, word, end):
    personality = "PX4" if case == "PX4" else "ArduPilot"
    options = {"MAVLink 1": {"mavlink_version": 1}, "switched off": {"ftp": False}}.get(case, {})
    service = with_files(build_service, personality, **options)
    loaded(service, SURVEY)
    service.use(SURVEY)
    if case == "held by another":
        service.run(1.0)
        other_opens(service)
    service.order_of(word, MISSION, 60, HOME_INDEX - 1)
    assert service.done(LIMIT_S) == end
    assert not is_by_file(service)
    assert "MISSION_REQUEST_LIST" in by_items(service)
    tried = {"switched off": [OPEN_RO] * 12, "held by another": [WRITE, OPEN_RO]}.get(case, [])
    assert requests(service)[: len(tried)] == tried
    if case == "held by another":
        service.run(3.0)
        assert open_file(service) is not None, "the other's file was closed"
        assert TERMINATE not in requests(service)


@pytest.mark.scenario(61, "Where there are no files, plans are transferred item by item")
def test_ftp_that_is_silent_costs_seven_seconds(build_service):
    service = with_files(build_service, ftp=False)
    loaded(service, SURVEY)
    verifying(service, SURVEY)
    assert service.done(LIMIT_S) == "Verified"
    (listed_s,) = service.sent_at("MISSION_REQUEST_LIST")
    assert listed_s - service.sent_at("FILE_TRANSFER_PROTOCOL")[0] < 7.3


# -- what the line loses


@BY_FILE
@pytest.mark.parametrize("word, end", [("fileverify", "Verified"), ("filedownload", "Downloaded")])
@pytest.mark.parametrize("direction, index", [
    *[pytest.param(">", index, id=f"request {index}") for index in range(4)],
    *[pytest.param("<", index, id=f"answer {index}") for index in range(13)],
])  # fmt: skip
def test_each_lost_frame_costs_time_alone(build_service, word, end, direction, index):
    service = with_files(build_service)
    loaded(service, WRITTEN)
    service.use(WRITTEN)
    service.wire.lose(direction, name="FILE_TRANSFER_PROTOCOL", index=index)
    service.order_of(word, MISSION, 60, HOME_INDEX - 1)
    assert service.done(LIMIT_S) == end
    assert is_by_file(service) and by_items(service) == []
    if word == "filedownload":
        assert service.sunk == [HOME_INDEX, *range(8)], "an item was given twice, or not at all"
        assert same(service.sink(8), WRITTEN)
    service.run(1.5)
    assert open_file(service) is None


@BY_FILE
@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("word", ["fileverify", "filedownload"])
@pytest.mark.parametrize("loss", [5, 25])
def test_what_it_says_is_true_on_a_bad_line(build_service, seed, word, loss):
    service = with_files(build_service, wire=Wire(seed=seed))
    loaded(service, LONG)
    service.run(1.2)
    for direction in "<>":
        service.wire.at_random(direction, lose=loss, repeat=3, delay=3)
    service.wire.set_latency(latency_of(seed))
    service.use(LONG)
    service.order_of(word, MISSION, 60, HOME_INDEX - 1)
    ended = service.done(120)
    if ended == "Downloaded":
        assert service.sunk == [HOME_INDEX, *range(60)]
        assert same(service.sink(60), LONG)
    elif ended == "Verified":
        assert service.state.aboard == "OurPlan"
    else:
        assert ended in ("NoAnswer", "TimedOut"), ended


# -- what happens meanwhile


def go_to_the_burst(service, answers: int = 20) -> None:
    limit = service.now + 5
    while len(service.wire.frames("<", "FILE_TRANSFER_PROTOCOL")) < answers:
        assert service.now < limit
        service.run(0.002)


@BY_FILE
def test_download_goes_on_item_by_item_where_the_file_has_left_off(build_service):
    service = with_files(build_service)
    loaded(service, LONG)
    downloading(service)
    service.wire.lose("<", name="FILE_TRANSFER_PROTOCOL", index=30)
    go_to_the_burst(service, 45)
    service.autopilot.ftp.forget()
    assert service.done(LIMIT_S) == "Downloaded"
    assert not is_by_file(service)
    assert service.sunk == [HOME_INDEX, *range(60)]
    assert same(service.sink(60), LONG)
    asked = [message.seq for message in service.heard("MISSION_REQUEST_INT")]
    assert asked == list(range(28, 61))


@BY_FILE
def test_autopilot_that_falls_silent_is_said(build_service):
    service = with_files(build_service)
    loaded(service, LONG)
    verifying(service, LONG)
    service.run_until_sent("FILE_TRANSFER_PROTOCOL", 3)
    service.wire.pull()
    began = service.now
    assert service.done(LIMIT_S) == "TimedOut"
    assert service.now - began < 3.0
    assert service.state.aboard == "NotKnown"


@BY_FILE
def test_operation_of_the_client_is_not_interrupted(build_service):
    service = with_files(build_service)
    loaded(service, WRITTEN)
    service.use(WRITTEN)
    service.order_of("verify", MISSION)
    assert verifying(service) == "Busy"
    assert downloading(service) == "Busy"
    assert service.done(LIMIT_S) == "Verified"
