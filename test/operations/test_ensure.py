"""ensure(): a plan is put aboard only if it is not there already, and never while the aircraft is armed."""

from __future__ import annotations

import pytest

from disorders import latency_of
from downloads import WRITTEN, loaded
from plans import SURVEY, on_the_wire, waypoint
from simulation.bench import FunctionPlan, item_of_function_plan
from simulation.fake_autopilot import mavlink
from simulation.wire import Wire

ENSURE = pytest.mark.scenario(56, "A plan is put aboard only if it is not there already")
IN_FLIGHT = pytest.mark.scenario(57, "ensure() in flight looks, and changes nothing")
LIMIT_S = 20

CHANGES_A_PLAN = ("MISSION_COUNT", "MISSION_ITEM_INT", "MISSION_ITEM", "MISSION_CLEAR_ALL",
                  "MISSION_WRITE_PARTIAL_LIST")  # fmt: skip
OTHER = [waypoint(z=n + 1.0) for n in range(3)]


def changing(service) -> list[str]:
    """The names of what was sent that would change a plan."""
    return [message.get_type() for message in service.heard(*CHANGES_A_PLAN)]


@ENSURE
def test_plan_that_is_not_there_is_uploaded(service, personality):
    assert service.ensure(SURVEY) == "WaitingForAutopilot"
    assert service.done(LIMIT_S) == "Accepted"
    assert service.state.aboard == "OurPlan"
    assert service.autopilot.received() == on_the_wire(SURVEY, personality)
    assert (service.state.done, service.state.total) == (5, 5)


@ENSURE
def test_plan_that_is_there_is_not_uploaded_again(service):
    service.upload(SURVEY)
    assert service.done() == "Accepted"
    service.reset()
    before = len(changing(service))
    service.ensure(SURVEY)
    assert service.done(LIMIT_S) == "AlreadyAboard"
    assert len(changing(service)) == before
    state = service.state
    assert (state.aboard, state.failed_item, state.field, state.done) == ("OurPlan", None, "None", 5)


@ENSURE
@pytest.mark.parametrize("held", [
    OTHER,
    [*SURVEY[:4], SURVEY[4]._replace(y=85455971)],
    [SURVEY[0]._replace(z=21.0), *SURVEY[1:]],
    [*SURVEY, waypoint()],
    SURVEY[:4],
    [],
], ids=["another", "last item", "first item", "longer", "shorter", "none"])  # fmt: skip
def test_another_plan_is_replaced(service, personality, held):
    if held:
        loaded(service, held)
    service.ensure(SURVEY)
    assert service.done(LIMIT_S) == "Accepted"
    assert service.autopilot.received() == on_the_wire(SURVEY, personality)
    state = service.state
    assert (state.aboard, state.failed_item, state.field) == ("OurPlan", None, "None")


@ENSURE
@pytest.mark.parametrize("count", [10, 200, 600])
def test_px4_is_asked_for_its_checksum_alone_whatever_the_length(build_bench, count):
    """The goal is 0.3 s from REQUEST_LIST to the status."""
    bench = build_bench("PX4", defines={"BENCH_ENSURE": 1})
    plan = FunctionPlan(count)
    bench.autopilot.load([item_of_function_plan(index) for index in range(count)])
    bench.ensure(plan)
    assert bench.run_until_ended(limit_s=30) == "AlreadyAboard"
    (asked_s,) = bench.sent_at("MISSION_REQUEST_LIST")
    ended_s = next(event.ms for event in bench.events if event.word == "end") / 1000
    print(f"PX4, {count} items: {1000 * (ended_s - asked_s):.0f} ms from REQUEST_LIST to the status")
    assert ended_s - asked_s < 0.3
    assert bench.heard("MISSION_REQUEST_INT", "MISSION_COUNT", "MISSION_ITEM_INT") == []
    assert len(bench.heard("MISSION_REQUEST_LIST")) == 1
    bench.run(1.0)
    assert bench.autopilot.missions.state.value == "idle", "PX4 still waits for our requests"


@ENSURE
def test_ardupilot_is_read_and_not_written_to(build_service):
    service = build_service("ArduPilot")
    loaded(service, WRITTEN)
    service.ensure(WRITTEN)
    assert service.done(LIMIT_S) == "AlreadyAboard"
    assert changing(service) == []
    assert len(service.heard("MISSION_REQUEST_INT")) == len(WRITTEN) + 1
    service.run(0.1)
    assert [ack.type for ack in service.heard("MISSION_ACK")] == [mavlink.MAV_MISSION_ACCEPTED]


@ENSURE
def test_empty_plan_is_there_where_there_is_none_and_clears_where_there_is_one(service):
    service.ensure("empty")
    assert service.done(LIMIT_S) == "AlreadyAboard"
    assert changing(service) == []
    loaded(service, OTHER)
    service.ensure("empty")
    assert service.done(LIMIT_S) == "Accepted"
    assert service.autopilot.plan() == []


@IN_FLIGHT
@pytest.mark.parametrize("is_allowed", [False, True], ids=["by default", "uploads allowed while armed"])
def test_another_plan_in_flight_stays_and_the_status_says_why(make_service, is_allowed):
    service = make_service(armed=True)
    loaded(service, OTHER)
    held = service.autopilot.received()
    service.tell("armed", is_allowed)
    service.ensure([*OTHER[:2], OTHER[2]._replace(z=7.0)])
    assert service.done(LIMIT_S) == "Armed"
    assert changing(service) == []
    assert service.autopilot.received() == held
    assert service.state.aboard == "NotKnown"
    service.run(2.0)
    assert service.autopilot.received() == held


@IN_FLIGHT
def test_our_plan_is_recognised_in_flight(make_service):
    service = make_service(armed=True)
    loaded(service, OTHER)
    service.ensure(OTHER)
    assert service.done(LIMIT_S) == "AlreadyAboard"
    assert service.state.aboard == "OurPlan"
    assert changing(service) == []


@ENSURE
@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("loss", [5, 25])
@pytest.mark.parametrize("is_there", [True, False], ids=["there", "another is there"])
def test_what_it_says_is_true_on_a_bad_line(make_service, personality, seed, loss, is_there):
    service = make_service(wire=Wire(seed=seed))
    loaded(service, OTHER if is_there else [*OTHER[:2], OTHER[2]._replace(z=7.0)])
    service.wire.at_random("<", lose=loss)
    service.wire.at_random(">", lose=loss)
    service.wire.set_latency(latency_of(seed))
    service.ensure(OTHER)
    ended = service.done(60)
    held = service.autopilot.received() == on_the_wire(OTHER, personality)
    if ended in ("AlreadyAboard", "Accepted"):
        assert held and service.state.aboard == "OurPlan"
        assert (ended == "AlreadyAboard") == is_there
    else:
        assert ended in ("NoAnswer", "TimedOut", "Unconfirmed", "NoAutopilot"), ended
        assert not (service.state.aboard == "OurPlan" and not held)
    if is_there:
        assert changing(service) == [], "it uploaded a plan that was there"


@ENSURE
@pytest.mark.parametrize("is_named", [False, True], ids=["found", "named"])
def test_reset_in_the_middle_of_an_upload_is_made_good_by_the_next_start(service, personality, is_named):
    """After the reset the autopilot still waits for items, and refuses to be read for some seconds."""
    loaded(service, OTHER)
    plan = [waypoint(z=n + 1.0) for n in range(40)]
    service.ensure(plan)
    service.run_until_sent("MISSION_ITEM_INT", 10)
    service.reset()
    if is_named:
        service.tell("talk", 1, 1)
    service.ensure(plan)
    assert service.done(30) == "Accepted"
    assert service.autopilot.received() == on_the_wire(plan, personality)
    assert service.state.aboard == "OurPlan"


@ENSURE
def test_ardupilot_that_another_station_uploads_to_is_left_alone(build_service):
    service = build_service("ArduPilot")
    service.autopilot.faults.refuse(mavlink.MAV_MISSION_DENIED, "list", times=None)
    service.ensure(SURVEY)
    assert service.done(LIMIT_S) == "Denied"
    assert service.state.aboard == "NotKnown" and changing(service) == []
