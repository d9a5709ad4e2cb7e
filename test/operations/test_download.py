"""Reading the autopilot's plan into a sink."""

from __future__ import annotations

import pytest

from downloads import WRITTEN, loaded, same
from plans import NAN, OLD_PLAN, SURVEY, steps
from simulation.bench import status_names
from simulation.fake_autopilot import RALLY, mavlink
from simulation.service import HOME_INDEX


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
