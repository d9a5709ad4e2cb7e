"""What an upload says when its final answer is lost: Accepted exactly when the plan is aboard."""

from __future__ import annotations

import pytest

from disorders import latency_of
from plans import OLD_PLAN, SURVEY, on_the_wire, waypoint
from simulation.bench import same_bits
from simulation.fake_autopilot import mavlink
from simulation.wire import Wire

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
@pytest.mark.parametrize("proof", ["InDoubt", "Always"])
def test_lost_final_ack_ends_in_accepted_when_the_plan_is_aboard(service, personality, proof):
    service.autopilot.load(OLD_PLAN)
    service.autopilot.faults.swallow_final_ack()
    service.upload(SURVEY, proof=proof)
    assert service.done(limit_s=30) == "Accepted"
    assert is_aboard(service, SURVEY, personality)
    state = service.state
    assert (state.aboard, state.done, state.total) == ("OurPlan", 5, 5)
    assert service.progress == [(done, 5) for done in range(1, 6)]


@LOST
def test_px4_answers_a_repeated_last_item(build_service):
    service = build_service("PX4")
    service.autopilot.faults.swallow_final_ack()
    service.upload(SURVEY)
    assert service.done(limit_s=5) == "Accepted"
    assert service.heard("MISSION_REQUEST_LIST") == []
    assert len([one for one in service.heard("MISSION_ITEM_INT") if one.seq == 4]) == 2


@LOST
def test_ardupilot_is_asked_what_is_aboard(build_service):
    service = build_service("ArduPilot")
    service.autopilot.faults.swallow_final_ack()
    service.upload(SURVEY, proof="InDoubt")
    assert service.done(limit_s=30) == "Accepted"
    assert len(service.heard("MISSION_REQUEST_LIST")) == 1
    assert len(service.heard("MISSION_REQUEST_INT")) == 6


@LOST
def test_without_a_proof_ardupilots_lost_ack_stays_unconfirmed(build_service):
    service = build_service("ArduPilot")
    service.autopilot.faults.swallow_final_ack()
    service.upload(SURVEY)
    assert service.done(limit_s=30) == "Unconfirmed"
    assert service.state.aboard == "NotKnown"
    assert service.heard("MISSION_REQUEST_LIST") == []
    service.verify()
    assert service.done() == "Verified"
    assert service.state.aboard == "OurPlan"


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
def test_lost_last_item_is_asked_for_again_and_all_is_well(service, personality):
    last = len(on_the_wire(SURVEY, personality)) - 1
    service.wire.lose(">", name="MISSION_ITEM_INT", seq=last)
    service.autopilot.faults.swallow_final_ack()
    service.upload(SURVEY, proof="InDoubt")
    assert service.done(limit_s=30) == "Accepted"
    assert is_aboard(service, SURVEY, personality)


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
def test_plan_that_another_ground_station_changed_meanwhile_is_not_accepted(build_service):
    service = build_service("ArduPilot")
    service.autopilot.faults.swallow_final_ack()
    service.upload(SURVEY, proof="InDoubt")
    service.run_until_sent("MISSION_ITEM_INT", 6)
    service.run(0.5)
    service.autopilot.load(on_the_wire([*SURVEY[:3], waypoint(1, 2), SURVEY[4]], "ArduPilot"))
    assert service.done(limit_s=30) == "Differs"
    state = service.state
    assert (state.failed_item, state.field, state.aboard) == (3, "Latitude", "Mixture")


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
def test_proof_that_is_cancelled_leaves_nothing_known(service):
    service.upload(SURVEY)
    assert service.done() == "Accepted"
    service.upload([waypoint(), *SURVEY], proof="Always")
    service.run_until_sent("MISSION_REQUEST_LIST")
    service.order_of("cancel")
    service.done()
    assert (service.state.status, service.state.aboard) == ("Cancelled", "NotKnown")


@LOST
def test_proof_has_the_transfers_time_limit(service):
    service.tell("limit", 3)
    service.autopilot.faults.swallow_final_ack()
    service.wire.lose("<", name="MISSION_ACK", times=None)
    service.upload(SURVEY, proof="InDoubt")
    assert service.done(limit_s=10) in ("TookTooLong", "Unconfirmed")
    assert service.now < 8


@LOST
def test_verified_upload_reads_back_in_any_case(service, personality):
    service.upload(SURVEY, proof="Always")
    assert service.done() == "Accepted"
    assert len(service.heard("MISSION_REQUEST_LIST")) == 1
    assert len(service.heard("MISSION_REQUEST_INT")) == len(on_the_wire(SURVEY, personality))
    assert service.progress == [(done, 5) for done in range(1, 6)]
    assert service.ends_called_back == ["Accepted"]


@LOST
def test_verified_upload_of_what_the_autopilot_stored_wrongly_differs(service):
    autopilot = service.autopilot
    service.upload(SURVEY, proof="Always")
    service.run_until_sent("MISSION_REQUEST_LIST")
    held = autopilot.missions.held[0] if hasattr(autopilot, "main_mode") else autopilot.missions[0].held
    held[-1] = held[-1]._replace(x=held[-1].x + 1)
    assert service.done() == "Differs"
    assert (service.state.failed_item, service.state.field) == (4, "Latitude")
    assert service.state.aboard != "OurPlan"


@LOST
def test_verified_empty_plan(service):
    service.autopilot.load(OLD_PLAN)
    service.upload("empty", proof="Always")
    assert service.done() == "Accepted"
    assert service.autopilot.plan() == []


@LATE
@pytest.mark.parametrize("late_ms", [500, 750, 1000, 1400])
def test_late_final_ack_is_waited_for(service, personality, late_ms):
    service.autopilot.faults.delay_final_ack(late_ms / 1000)
    service.upload(SURVEY)
    assert service.done() == "Accepted"
    assert len(service.heard("MISSION_ITEM_INT")) == len(on_the_wire(SURVEY, personality))


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


@LATE
def test_invalid_sequence_while_the_final_ack_is_missing_is_no_failure(service, personality):
    service.autopilot.faults.delay_final_ack(1.0)
    service.upload(SURVEY)
    service.run_until_sent("MISSION_ITEM_INT", len(on_the_wire(SURVEY, personality)))
    for _ in range(3):
        service.run(0.2)
        service.say(mavlink.MAVLink_mission_ack_message(1, 191, mavlink.MAV_MISSION_INVALID_SEQUENCE, 0))
    assert service.done() == "Accepted"


@LOST
@pytest.mark.slow
@pytest.mark.parametrize("seed", range(12))
def test_random_loss_never_ends_in_a_false_word(make_service, personality, seed):
    wire = Wire(seed=seed)
    for way in "<>":
        wire.at_random(way, lose=30, repeat=5, delay=5, where=lambda message: message.get_type() != "HEARTBEAT")
    wire.set_latency(latency_of(seed))
    service = make_service(wire=wire)
    service.autopilot.load(OLD_PLAN)
    service.upload(SURVEY, proof="InDoubt")
    status = service.done(limit_s=150)
    state = service.state
    if status == "Accepted":
        assert is_aboard(service, SURVEY, personality)
    if state.aboard == "OurPlan":
        assert is_aboard(service, SURVEY, personality)
    if state.aboard == "AsBefore":
        assert same_bits(service.autopilot.received(), OLD_PLAN)


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
def test_mixture_is_mended_by_clearing(build_service):
    service = build_service("ArduPilot")
    service.autopilot.load(OLD_PLAN)
    service.autopilot.faults.refuse(mavlink.MAV_MISSION_ERROR, 3)
    service.upload(SURVEY)
    assert service.done() == "Error"
    service.order_of("clear", 0)
    assert service.done() == "Cleared"
    assert service.state.aboard == "Nothing" and service.autopilot.plan() == []


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


@AFTER
def test_uploading_again_what_never_was_uploaded_changes_nothing(service):
    service.autopilot.load(OLD_PLAN)
    before = service.autopilot.plan()
    service.order_of("uploadagain")
    assert service.done() == "SourceRefused"
    service.run(2)
    assert service.autopilot.plan() == before
    assert service.heard("MISSION_COUNT") == []
