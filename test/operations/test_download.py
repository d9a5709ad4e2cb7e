"""Reading the autopilot's plan into a sink."""

from __future__ import annotations

from itertools import pairwise

import pytest

from disorders import latency_of
from downloads import WRITTEN, is_ardupilot, loaded, same
from plans import HOME, NAN, OLD_PLAN, SURVEY, steps, waypoint
from simulation.bench import status_names
from simulation.fake_autopilot import RALLY, mavlink
from simulation.service import HOME_INDEX, SINK_ITEMS


def test_what_was_uploaded_is_downloaded_again(service):
    service.upload(WRITTEN)
    assert service.done() == "Accepted"
    assert service.download() == "WaitingForAutopilot"
    assert service.done() == "Downloaded"
    assert same(service.sink(len(WRITTEN)), WRITTEN)


def test_download_into_an_array_holds_the_plan(service):
    loaded(service, WRITTEN)
    service.order_of("downloadtoram", 0)
    assert service.done() == "Downloaded"
    state = service.state
    assert (state.done, state.total, state.failed_item) == (8, 8, None)
    assert same(service.sink(8), WRITTEN)


def test_download_asks_for_each_item_once_and_closes_with_an_ack(service, personality):
    loaded(service, SURVEY)
    service.download()
    assert service.done() == "Downloaded"
    count = len(SURVEY) + (personality == "ArduPilot")
    service.run(0.1)
    assert steps(service) == [("REQUEST_LIST", None), *(("REQUEST_INT", seq) for seq in range(count)), ("ACK", 0)]
    assert service.progress == [(done, 5) for done in range(1, 6)]


def test_home_is_kept_apart_from_the_plan(service, personality):
    loaded(service, SURVEY)
    service.download()
    assert service.done() == "Downloaded"
    if personality == "ArduPilot":
        assert service.sunk == [HOME_INDEX, 0, 1, 2, 3, 4]
        assert service.home.same_as(service.autopilot.home_item()._replace(param4=NAN))
    else:
        assert service.sunk == [0, 1, 2, 3, 4]


def test_raw_numbering_gives_home_as_item_0(service):
    loaded(service, WRITTEN)
    service.tell("raw", 1)
    service.download()
    assert service.done() == "Downloaded"
    aboard = service.autopilot.plan()
    assert service.sunk == list(range(len(aboard)))
    assert same([one._replace(current=0) for one in service.sink(len(aboard))],
                [one._replace(current=0) for one in aboard])  # fmt: skip


@pytest.mark.scenario(42, "REQUEST_LIST lost, unanswered, answered with 0 or for another type")
def test_autopilot_without_a_plan_gives_none(service):
    service.download()
    assert service.done() == "Downloaded"
    assert service.sunk == [] and service.state.total == 0
    assert steps(service) == [("REQUEST_LIST", None), ("ACK", 0)]


@pytest.mark.scenario(42, "REQUEST_LIST lost, unanswered, answered with 0 or for another type")
def test_autopilot_with_only_home_gives_none(build_service):
    service = build_service("ArduPilot")
    service.autopilot.load([HOME])
    service.download()
    assert service.done() == "Downloaded"
    assert service.sunk == [HOME_INDEX] and service.state.total == 0


@pytest.mark.scenario(42, "REQUEST_LIST lost, unanswered, answered with 0 or for another type")
def test_lost_request_list_is_sent_again_after_1500_ms(service):
    loaded(service, SURVEY)
    service.wire.lose(">", name="MISSION_REQUEST_LIST", times=2)
    service.download()
    assert service.done() == "Downloaded"
    first, second, third = service.sent_at("MISSION_REQUEST_LIST")
    assert second - first == pytest.approx(1.5, abs=0.01) and third - second == pytest.approx(1.5, abs=0.01)


@pytest.mark.scenario(42, "REQUEST_LIST lost, unanswered, answered with 0 or for another type")
def test_unanswered_request_list_ends_after_5_tries(service):
    service.wire.lose(">", name="MISSION_REQUEST_LIST", times=None)
    service.download()
    assert service.done(limit_s=12) == "NoAnswer"
    times = service.sent_at("MISSION_REQUEST_LIST")
    assert len(times) == 5
    assert service.now - times[0] == pytest.approx(7.5, abs=0.05)


@pytest.mark.scenario(42, "REQUEST_LIST lost, unanswered, answered with 0 or for another type")
def test_autopilot_that_dies_before_it_answers_ends_the_download_in_bounded_time(service):
    service.run(2.0)
    service.autopilot.faults.fall_silent(step="list")
    service.download()
    assert service.done(limit_s=12) == "NoAnswer"


@pytest.mark.scenario(42, "REQUEST_LIST lost, unanswered, answered with 0 or for another type")
def test_count_of_another_type_begins_nothing(service):
    service.autopilot.faults.keep_back("MISSION_COUNT", times=1)
    loaded(service, SURVEY)
    service.download()
    service.run_until_sent("MISSION_REQUEST_LIST")
    service.run(0.2)
    service.say(mavlink.MAVLink_mission_count_message(1, 191, 2, RALLY))
    service.run(0.5)
    assert service.heard("MISSION_REQUEST_INT") == []
    assert service.done() == "Downloaded"
    assert service.state.total == 5


LOST = pytest.mark.scenario(43, "Items lost, repeated, wrong; error ACKs; a full sink")


@LOST
@pytest.mark.parametrize("direction, name", [(">", "MISSION_REQUEST_INT"), ("<", "MISSION_ITEM_INT")])
def test_each_item_or_its_request_may_be_lost_once(service, direction, name):
    loaded(service, WRITTEN)
    for seq in range(9):
        service.wire.lose(direction, name=name, seq=seq)
    service.download()
    assert service.done() == "Downloaded"
    assert same(service.sink(8), WRITTEN)
    assert sorted(service.sunk) == sorted(set(service.sunk))


@LOST
def test_lost_item_is_asked_for_again_after_250_ms_and_8_times_in_all(service):
    loaded(service, SURVEY)
    service.autopilot.faults.keep_back("MISSION_ITEM_INT", where=lambda message: message.seq == 2)
    service.download()
    assert service.done() == "TimedOut"
    service.run(0.1)
    times = [entry.time for entry in service.wire.frames(">", "MISSION_REQUEST_INT") if entry.message.seq == 2]
    assert len(times) == 8
    assert [later - sooner for sooner, later in pairwise(times)] == [pytest.approx(0.25, abs=0.01)] * 7
    assert steps(service)[-1] == ("ACK", 15), "the autopilot is told, or it would wait for us"


@LOST
def test_item_that_is_always_lost_ends_the_download_within_250_requests(service):
    loaded(service, SURVEY)
    service.wire.lose("<", name="MISSION_ITEM_INT", seq=2, times=None)
    service.download()
    assert service.done(limit_s=20) == "TimedOut"
    service.run(0.1)
    times = [entry.time for entry in service.wire.frames(">", "MISSION_REQUEST_INT") if entry.message.seq == 2]
    assert 5 <= len(times) <= 250
    assert steps(service)[-1] == ("ACK", 15), "the autopilot is told, or it would wait for us"


@LOST
def test_tries_are_renewed_by_each_item(service):
    loaded(service, SURVEY)
    for seq in range(6):
        service.wire.lose("<", name="MISSION_ITEM_INT", seq=seq, times=4)
    service.download()
    assert service.done(limit_s=20) == "Downloaded"
    assert same([one._replace(param4=0) for one in service.sink(5)], [one._replace(param4=0) for one in SURVEY])


@LOST
def test_items_that_come_twice_are_taken_once(service, personality):
    loaded(service, WRITTEN)
    service.wire.repeat("<", name="MISSION_ITEM_INT", after_s=0.02, times=None)
    service.download()
    assert service.done() == "Downloaded"
    assert service.sunk == [*([HOME_INDEX] if personality == "ArduPilot" else []), *range(8)]


@LOST
def test_item_of_another_number_or_type_is_not_taken(service):
    loaded(service, SURVEY)
    service.wire.lose("<", name="MISSION_ITEM_INT", seq=1, times=2)
    service.download()
    service.run_until_sent("MISSION_REQUEST_INT", 2)
    service.run(0.05)
    for seq, mission_type in ((0, 0), (2, 0), (9, 0), (1, RALLY)):
        service.say(mavlink.MAVLink_mission_item_int_message(
            1, 191, seq, 3, 17, 0, 1, 0, 0, 0, 0, 11, 22, 3.0, mission_type))  # fmt: skip
    assert service.done() == "Downloaded"
    assert all(one.command != 17 for one in service.sink(5))
    assert len(service.sunk) == len(set(service.sunk))


@LOST
@pytest.mark.parametrize("step", ["list", ("read", 0), ("read", 2)], ids=str)
def test_each_refusal_ends_the_download_with_its_own_status(service, step):
    loaded(service, SURVEY)
    service.run(12)  # until no answer to what was sent before the reset is reckoned with any more
    for result in range(1, 16):
        if result == mavlink.MAV_MISSION_INVALID_SEQUENCE:
            continue  # noise: see the next test
        service.autopilot.faults.refuse(result, step)
        service.download()
        assert service.done() == status_names()[status_names().index("Error") + result - 1]
        assert service.state.last_result == result


@LOST
def test_invalid_sequence_is_noise(service):
    loaded(service, SURVEY)
    service.autopilot.faults.refuse(mavlink.MAV_MISSION_INVALID_SEQUENCE, "list")
    if is_ardupilot(service):  # PX4 ends its side with any refusal of an item
        service.autopilot.faults.refuse(mavlink.MAV_MISSION_INVALID_SEQUENCE, ("read", 2))
    service.download()
    assert service.done() == "Downloaded"


@LOST
def test_plan_that_is_longer_than_the_array_is_not_begun_with(service):
    loaded(service, SURVEY)
    service.order_of("downloadtosmall", 0)
    assert service.done() == "SinkFull"
    assert service.state.total == 5
    assert service.heard("MISSION_REQUEST_INT") == []
    assert steps(service)[-1] == ("ACK", 15)
    service.order_of("downloadtoram", 0)
    assert service.done() == "Downloaded"


@LOST
def test_function_that_refuses_an_item_ends_the_download_there(service):
    loaded(service, SURVEY)
    service.download(refused=2)
    assert service.done() == "SinkFull"
    service.run(0.1)
    assert service.state.failed_item == 2
    assert service.sunk[-1] == 2 and 3 not in service.sunk
    assert steps(service)[-1] == ("ACK", 15)


@LOST
def test_plan_of_exactly_the_arrays_length_fits(service):
    plan = [waypoint(473977420 + n, z=float(n + 1)) for n in range(SINK_ITEMS)]
    loaded(service, plan)
    service.order_of("downloadtoram", 0)
    assert service.done(limit_s=20) == "Downloaded"
    assert [one.x for one in service.sink(SINK_ITEMS)] == [one.x for one in plan]


@pytest.mark.scenario(44, "Our final ACK is lost, and the next operation still works")
@pytest.mark.parametrize("following", ["download", "upload", "clear"])
def test_lost_final_ack_of_ours_does_not_hinder_the_next_operation(service, following):
    loaded(service, SURVEY)
    service.wire.lose(">", name="MISSION_ACK")
    service.download()
    assert service.done() == "Downloaded"
    if following == "download":
        service.download()
        assert service.done() == "Downloaded"
    elif following == "upload":
        service.upload(SURVEY)
        assert service.done(limit_s=15) == "Accepted"
    else:
        service.order_of("clear", 0)
        assert service.done() == "Cleared"
        assert service.autopilot.plan() == []


def test_autopilot_that_gives_only_float_items_is_understood(service):
    loaded(service, SURVEY)
    as_floats(service)
    service.download()
    assert service.done() == "Downloaded"
    for read, meant in zip(service.sink(5), SURVEY, strict=True):
        assert abs(read.x - meant.x) < 25 and abs(read.y - meant.y) < 10, "a float has 24 bits"
        assert (read.command, read.z) == (meant.command, meant.z)


def as_floats(service) -> None:
    """From now on each MISSION_ITEM_INT of the autopilot becomes a MISSION_ITEM."""
    autopilot = service.autopilot
    push = autopilot._push

    def as_float(time, message) -> None:
        if not isinstance(message, bytes) and message.get_type() == "MISSION_ITEM_INT":
            divisor = 1 if message.frame == 2 else 1e7
            message = mavlink.MAVLink_mission_item_message(
                message.target_system, message.target_component, message.seq, message.frame, message.command,
                message.current, message.autocontinue, message.param1, message.param2, message.param3, message.param4,
                message.x / divisor, message.y / divisor, message.z, message.mission_type)  # fmt: skip
        push(time, message)

    autopilot._push = as_float


def test_download_while_another_ground_station_uploads_is_said_as_such(build_service):
    service = build_service("ArduPilot")
    service.autopilot.load(OLD_PLAN)
    service.run(2.0)
    service.autopilot.receive(
        gcs_frame(mavlink.MAVLink_mission_count_message(1, 1, 3, 0)), service.now)
    service.download()
    assert service.done() == "Denied"


def gcs_frame(message) -> bytes:
    return message.pack(mavlink.MAVLink(None, 255, 190))


def test_download_works_while_the_aircraft_is_armed(make_service):
    service = make_service(armed=True)
    loaded(service, SURVEY)
    service.download()
    assert service.done() == "Downloaded"


def test_download_survives_random_loss_or_says_that_it_did_not(make_service):
    from simulation.wire import Wire

    for seed in range(4):
        wire = Wire(seed=seed)
        for way in "<>":
            wire.at_random(way, lose=20, repeat=5, delay=10, where=lambda message: message.get_type() != "HEARTBEAT")
        wire.set_latency(latency_of(seed))
        service = make_service(wire=wire)
        loaded(service, WRITTEN)
        service.download()
        if service.done(limit_s=40) == "Downloaded":
            assert same(service.sink(8), WRITTEN)


def test_download_after_an_upload_that_waited_for_its_turn_has_its_whole_time(make_service):
    service = make_service()
    service.tell("backoff", 60)
    service.autopilot.faults.refuse(mavlink.MAV_MISSION_DENIED, times=2)
    service.upload(SURVEY)
    assert service.done(limit_s=20) == "Accepted"
    service.download()
    assert service.done() == "Downloaded"
