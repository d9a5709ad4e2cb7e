"""Taking plans away: mission, fence, rally, and all three."""

from __future__ import annotations

import pytest

from areas import FIELD, POINTS
from plans import OLD_PLAN, SURVEY, on_the_wire
from service_table import LEFTOVERS_S
from simulation.bench import status_names
from simulation.fake_autopilot import mavlink
from simulation.service import ALL, FENCE, MISSION, RALLY

CLEAR = pytest.mark.scenario(45, "Clear: accepted, refused, ACK lost, no answer")
LOADED = {MISSION: OLD_PLAN, FENCE: FIELD, RALLY: POINTS}
TYPES = {"mission": MISSION, "fence": FENCE, "rally": RALLY}


def load_all(service) -> None:
    for mission_type, plan in LOADED.items():
        service.autopilot.load(plan, mission_type)


def left(service) -> list[str]:
    """The plans that are aboard."""
    return [name for name, mission_type in TYPES.items() if service.autopilot.plan(mission_type)]


def clear(service, mission_type: int) -> str:
    return service.order_of("clear", mission_type)


@CLEAR
@pytest.mark.parametrize("name", TYPES)
def test_one_plan_is_cleared_and_the_others_stay(service, name):
    load_all(service)
    assert clear(service, TYPES[name]) == "WaitingForAutopilot"
    assert service.done() == "Cleared"
    assert left(service) == [other for other in TYPES if other != name]
    assert [message.mission_type for message in service.heard("MISSION_CLEAR_ALL")] == [TYPES[name]]
    state = service.state
    aboard = dict(zip(TYPES, (state.aboard, state.aboard_fence, state.aboard_rally), strict=True))
    assert aboard == {other: "Nothing" if other == name else "NotKnown" for other in TYPES}


@CLEAR
def test_all_three_are_cleared_one_by_one(service):
    load_all(service)
    clear(service, ALL)
    assert service.done() == "Cleared"
    assert left(service) == []
    assert [message.mission_type for message in service.heard("MISSION_CLEAR_ALL")] == [MISSION, FENCE, RALLY]
    state = service.state
    assert (state.aboard, state.aboard_fence, state.aboard_rally) == ("Nothing",) * 3


@CLEAR
def test_each_refusal_has_its_own_status_and_leaves_the_plan(service):
    load_all(service)
    service.run(LEFTOVERS_S)  # before that it may be an upload from before a reset that is given up
    for result in range(1, 16):
        service.autopilot.faults.refuse(result, "clear")
        clear(service, MISSION)
        assert service.done() == status_names()[status_names().index("Error") + result - 1]
        assert left(service) == ["mission", "fence", "rally"]
        assert service.state.aboard == "NotKnown"
        assert service.state.last_result == result


@CLEAR
@pytest.mark.parametrize("mission_type", [MISSION, FENCE, ALL])
def test_ack_that_does_not_come_is_made_up_for_by_asking_again(service, mission_type):
    load_all(service)
    service.autopilot.faults.keep_back("MISSION_ACK", times=1)
    clear(service, mission_type)
    assert service.done() == "Cleared"
    first, second = service.sent_at("MISSION_CLEAR_ALL")[:2]
    assert second - first == pytest.approx(1.5, abs=0.01)


@CLEAR
def test_silence_ends_after_5_tries_and_nothing_is_known(service):
    service.upload(SURVEY)
    assert service.done() == "Accepted"
    service.autopilot.faults.keep_back("MISSION_ACK")
    clear(service, MISSION)
    assert service.done(limit_s=12) == "NoAnswer"
    times = service.sent_at("MISSION_CLEAR_ALL")
    assert len(times) == 5 and service.now - times[0] == pytest.approx(7.5, abs=0.05)
    assert service.state.aboard == "NotKnown"


@CLEAR
def test_px4_that_is_busy_is_asked_until_it_is_free(build_service):
    service = build_service("PX4")
    service.autopilot.load(OLD_PLAN)
    service.run(2.0)
    gcs = mavlink.MAVLink(None, 255, 190)
    service.autopilot.receive(mavlink.MAVLink_mission_count_message(1, 1, 3, 0).pack(gcs), service.now)
    clear(service, MISSION)
    assert service.done(limit_s=12) == "Cleared"
    assert len(service.heard("MISSION_CLEAR_ALL")) > 1


ARMED = pytest.mark.scenario(48, "Changing the plan while armed is refused unless allowed")


@ARMED
@pytest.mark.parametrize("mission_type", [MISSION, FENCE, ALL])
def test_clearing_while_armed_is_refused_unless_allowed(make_service, mission_type):
    service = make_service(armed=True)
    load_all(service)
    clear(service, mission_type)
    assert service.done() == "Armed"
    assert service.heard("MISSION_CLEAR_ALL") == []
    service.tell("armed", 1)
    clear(service, mission_type)
    assert service.done() == "Cleared"


@CLEAR
def test_answer_to_the_upload_before_is_not_taken_for_the_clears(service, personality):
    """The upload is cancelled while its ACCEPTED is on its way, and the first CLEAR_ALL is lost."""
    service.autopilot.faults.delay_final_ack(0.3)
    service.upload(SURVEY)
    service.run_until_sent("MISSION_ITEM_INT", count=len(on_the_wire(SURVEY, personality)))
    service.run(0.02)
    service.tell("cancel")
    assert service.done() == "Cancelled"
    service.wire.lose(">", name="MISSION_CLEAR_ALL")
    clear(service, MISSION)
    assert service.done() == "Cleared"
    assert left(service) == []


@pytest.mark.parametrize("operation", ["upload", "download", "verify"])
def test_all_types_at_once_are_only_for_clearing(service, operation):
    service.use(SURVEY)
    ask = {"upload": service.upload, "download": service.download, "verify": service.verify}[operation]
    assert ask(mission_type=ALL) == "BadPlanType"
    assert service.done() == "BadPlanType"
    service.run(0.5)
    assert not service.heard("MISSION_COUNT") and not service.heard("MISSION_REQUEST_LIST")
