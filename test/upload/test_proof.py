"""What an upload says when its final answer is lost: Accepted exactly when the plan is aboard."""

from __future__ import annotations

import pytest

from plans import OLD_PLAN, SURVEY, on_the_wire, waypoint
from simulation.bench import same_bits
from simulation.fake_autopilot import mavlink

LOST = pytest.mark.scenario(12, "The final ACK is lost")
LATE = pytest.mark.scenario(13, "The final ACK comes late")


def is_aboard(service, plan, personality) -> bool:
    return same_bits(service.autopilot.received(), on_the_wire(plan, personality))


def forged(service, seq: int):
    """The item with this number reaches the autopilot with another altitude, and with a checksum that is right."""
    react = service.autopilot._hears["MISSION_ITEM_INT"]

    def hear(message, sender, now) -> None:
        if message.seq == seq:
            message.z += 64.0
        react(message, sender, now)

    service.autopilot._hears["MISSION_ITEM_INT"] = hear


def made_lossy(service) -> None:
    """A heartbeat is lost, and the next one shows it."""
    service.run(1.2)
    service.wire.lose("<", name="HEARTBEAT")
    service.run(2.0)


@LOST
@pytest.mark.parametrize("proof", ["InDoubt", "Always"])
def test_broken_item_whose_checksum_is_right_is_found_on_a_line_that_loses(service, personality, proof):
    """Of 65,536 broken frames one is taken for a good one. PX4 names the checksum of its plan, ArduPilot is read."""
    service.autopilot.load(OLD_PLAN)
    made_lossy(service)
    forged(service, 2)
    service.upload(SURVEY, proof=proof)
    assert service.done(limit_s=30) == ("Differs" if personality == "ArduPilot" else "OtherPlanAboard")
    assert not is_aboard(service, SURVEY, personality)
    assert service.state.aboard == "NotKnown"
    if personality == "ArduPilot":
        assert (service.state.failed_item, service.state.field) == (1, "Height")


@LOST
@pytest.mark.parametrize("old", [[], OLD_PLAN], ids=["no plan before", "a longer plan before"])
def test_lost_last_item_and_lost_answers_never_end_in_accepted(make_service, personality, old):
    service = make_service()
    service.autopilot.load(old)
    last = len(on_the_wire(SURVEY, personality)) - 1
    service.wire.lose(">", name="MISSION_ITEM_INT", seq=last, times=None)
    service.wire.lose("<", name="MISSION_ACK", times=None)
    service.upload(SURVEY, proof="InDoubt")
    status = service.done(limit_s=60)
    assert status in ("Unconfirmed", "Differs", "TimedOut")
    assert not is_aboard(service, SURVEY, personality)
    assert service.state.aboard == ("Mixture" if personality == "ArduPilot" else
                                    "NotKnown" if status != "TimedOut" else "AsBefore")  # fmt: skip


@LOST
def test_without_any_answer_it_stays_unconfirmed(service, personality):
    last = len(on_the_wire(SURVEY, personality)) - 1
    service.upload(SURVEY, proof="InDoubt")
    service.run_until_sent("MISSION_ITEM_INT", last + 1)
    service.wire.pull("<")
    assert service.done(limit_s=60) == "Unconfirmed"
    assert service.state.aboard == "NotKnown"
    service.order_of("start")
    service.wire.plug("<")
    assert service.done(limit_s=10) == "Unproven"


@LOST
def test_proof_survives_loss_while_it_reads(make_service, personality):
    service = make_service()
    service.autopilot.faults.swallow_final_ack()
    service.wire.lose(">", name="MISSION_REQUEST_LIST")
    service.wire.lose("<", name="MISSION_COUNT")
    for seq in range(6):
        service.wire.lose("<", name="MISSION_ITEM_INT", seq=seq)
    service.upload(SURVEY, proof="Always")
    assert service.done(limit_s=40) == "Accepted"
    assert is_aboard(service, SURVEY, personality)


@LOST
def test_verified_empty_plan(service):
    service.autopilot.load(OLD_PLAN)
    service.upload("empty", proof="Always")
    assert service.done() == "Accepted"
    assert service.autopilot.plan() == []


@LATE
@pytest.mark.parametrize("late_s", [1.6, 2.0, 2.5])
def test_final_ack_later_than_a_repeated_last_item_is_no_failure(service, personality, late_s):
    service.autopilot.faults.delay_final_ack(late_s)
    service.upload(SURVEY, proof="InDoubt")
    assert service.done(limit_s=20) == "Accepted"
    assert is_aboard(service, SURVEY, personality)
    service.run(3.0)
    service.upload([waypoint(), *SURVEY], proof="InDoubt")
    assert service.done(limit_s=20) == "Accepted"
    assert is_aboard(service, [waypoint(), *SURVEY], personality)


@LOST
@pytest.mark.parametrize("proof, end, aboard", [("ByAnswer", "Error", "NotKnown"), ("InDoubt", "Accepted", "OurPlan"),
                                                ("Always", "Accepted", "OurPlan")])  # fmt: skip
def test_error_to_a_last_item_that_the_line_repeats_is_no_refusal(build_service, proof, end, aboard):
    """The acceptance is lost, and an ArduPilot that is idle by then says error to the item's second coming."""
    service = build_service("ArduPilot")
    service.autopilot.load(OLD_PLAN)
    service.wire.repeat(">", name="MISSION_ITEM_INT", seq=len(SURVEY))
    service.wire.lose("<", name="MISSION_ACK", where=lambda message: message.type == mavlink.MAV_MISSION_ACCEPTED)
    service.upload(SURVEY, proof=proof)
    assert service.done(limit_s=30) == end
    assert is_aboard(service, SURVEY, "ArduPilot")
    assert service.state.aboard == aboard


@LOST
@pytest.mark.parametrize("old", [OLD_PLAN, []], ids=["a plan before", "no plan before"])
def test_error_to_a_last_item_that_is_a_refusal_is_found_out_by_reading_back(build_service, old):
    service = build_service("ArduPilot")
    service.autopilot.load(old)
    service.autopilot.faults.refuse(mavlink.MAV_MISSION_ERROR, len(SURVEY))
    service.upload(SURVEY, proof="InDoubt")
    assert service.done(limit_s=30) == "Error"
    state = service.state
    assert (state.aboard, state.last_result) == ("Mixture", mavlink.MAV_MISSION_ERROR)
    assert state.failed_item == len(SURVEY) - 1


AFTER = pytest.mark.scenario(12, "A failure that left a mixture is mended by one call")


@AFTER
def test_mixture_is_mended_by_uploading_again(build_service):
    service = build_service("ArduPilot")
    service.autopilot.load(OLD_PLAN)
    service.autopilot.faults.refuse(mavlink.MAV_MISSION_ERROR, 3)
    service.upload(SURVEY)
    assert service.done() == "Error"
    assert service.state.aboard == "Mixture"
    service.order_of("start")
    assert service.done() == "Unproven"
    service.order_of("uploadagain")
    assert service.done(limit_s=20) == "Accepted"
    assert is_aboard(service, SURVEY, "ArduPilot")
    assert service.state.aboard == "OurPlan"


@AFTER
def test_uploading_again_takes_the_plan_and_its_type_whatever_was_done_meanwhile(service, personality):
    service.upload(SURVEY)
    assert service.done() == "Accepted"
    service.download(mission_type=1)
    assert service.done() == "Downloaded"
    service.order_of("clear", 255)
    assert service.done() == "Cleared"
    service.order_of("uploadagain")
    assert service.done() == "Accepted"
    assert is_aboard(service, SURVEY, personality)
