"""One row for each trouble that an upload may have, on the simulated Mega, with both autopilots: what happens, how the
upload ends, and what is aboard then. Every moment, every loss and every order of these: test/explorer, test/host/units.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import pytest

from plain_client import PlainClient
from plans import NAN, OLD_PLAN, SURVEY, on_the_wire, smooth_steps, steps, waypoint
from simulation.bench import FunctionPlan
from simulation.fake_autopilot import mavlink
from simulation.fake_autopilot.items import item_int_message
from simulation.peer import US, ack, find, heartbeat, request, request_int
from truth import expect_truth

ERROR, NO_SPACE, INVALID_SEQUENCE = (
    mavlink.MAV_MISSION_ERROR,
    mavlink.MAV_MISSION_NO_SPACE,
    mavlink.MAV_MISSION_INVALID_SEQUENCE,
)
BOTH = ("ArduPilot", "PX4")
CUT_SHORT = ("Mixture", "AsBefore")  # ArduPilot writes each item as it comes, PX4 all of them at the end
LAST = 99  # the last item has left
STRANGERS = ((2, 1), (1, 2), (255, 190), US)
OTHERS = ((255, 190), (1, 192), (2, 191), (2, 0))  # targets
Act = Callable[[Any], Any]


def nothing(bench) -> None:
    pass


class Trouble(NamedTuple):
    """`ended` and `aboard`: of ArduPilot and of PX4, where these differ. `before` is done before the upload begins,
    `then` when so many items have left; -1: when COUNT has."""

    number: int
    title: str
    ended: str | tuple[str, str]
    aboard: str | tuple[str, str]
    before: Act = nothing
    items: int = -1
    then: Act = nothing
    plan: Sequence | FunctionPlan = SURVEY
    proof: str = "ByAnswer"
    failed_item: tuple[int | None, int | None] = (None, None)
    options: dict = {}
    is_silent: bool = False  # nothing is sent
    autopilots: Sequence[str] = BOTH


def each(*acts: Act) -> Act:
    return lambda bench: [act(bench) for act in acts]


def lose(way: str, name: str, times: int | None = 1, **which) -> Act:
    return lambda bench: bench.wire.lose(way, name=name, times=times, **which)


def faults(name: str, *arguments, **options) -> Act:
    return lambda bench: getattr(bench.autopilot.faults, name)(*arguments, **options)


def tell(*words) -> Act:
    return lambda bench: bench.tell(*words)


def pulled(seconds: float, way: str | None = None) -> Act:
    return lambda bench: (bench.wire.pull(way), bench.run(seconds), bench.wire.plug(way))


def say(*messages, sender=None) -> Act:
    return lambda bench: [bench.say(message, sender) for message in messages]


def confusing(seq: int, to: tuple[int, int] = US, mission_type: int = 0) -> list:
    """All that could move a transfer at this item, if it came from the autopilot to us, about this plan."""
    return [*(ack(result, to, mission_type) for result in (ERROR, 0)), request_int(seq, to, mission_type),
            request(0, to, mission_type), ack(mavlink.MAV_MISSION_OPERATION_CANCELLED, to, mission_type)]  # fmt: skip


UNASKED = (request_int(3), request(3), item_int_message(waypoint(), US, 2), ack(INVALID_SEQUENCE),
           mavlink.MAVLink_mission_count_message(*US, 9, 0), mavlink.MAVLink_mission_request_list_message(*US, 0),
           mavlink.MAVLink_mission_clear_all_message(*US, 0))  # fmt: skip


def noise_after_each_item(bench) -> None:
    for sent in range(1, 6):
        bench.run_until_sent("MISSION_ITEM_INT", sent)
        bench.say(ack(INVALID_SEQUENCE))


def other_station(bench) -> None:
    """It has announced a plan, and does not go on."""
    other = PlainClient(bench.autopilot, now=bench.now)
    other.send(other.count(30))


def cancelled_upload(bench) -> None:
    bench.upload(SURVEY[1:])
    bench.run_until_sent("MISSION_ITEM_INT", 2)
    bench.cancel()
    bench.run_until_ended(limit_s=0.1)


def line_dies(bench) -> None:
    """Within the next frame to us."""
    bench.run(0.0005)
    bench.wire.drop_bytes("<", sum(len(one.data) for one in bench.wire.entries if one.direction == "<") + 5, 10**9)


def later(bench) -> None:
    """No answer to an earlier transfer is thought possible any more."""
    bench.run(11.0)


def is_refused_meanwhile(bench) -> None:
    assert [bench.upload() for _ in range(3)] == ["Busy"] * 3


ACCEPTED = ("Accepted", "OurPlan")
TROUBLES = [
    Trouble(9, "The first COUNT is lost", *ACCEPTED, lose(">", "MISSION_COUNT", 2)),
    Trouble(10, "An item and a request are lost", *ACCEPTED,
            each(lose(">", "MISSION_ITEM_INT", seq=2), lose("<", "MISSION_REQUEST*", seq=4))),
    Trouble(11, "Silence in mid-transfer", "TimedOut", CUT_SHORT, faults("fall_silent", step=2), failed_item=(1, 2)),
    Trouble(12, "The final ACK is lost", *ACCEPTED, lose("<", "MISSION_ACK"), proof="InDoubt"),
    Trouble(49, "What is aboard is not known where nothing answers after the last item", "Unconfirmed", "NotKnown",
            proof="InDoubt", items=LAST, then=lambda bench: bench.wire.pull("<")),
    Trouble(12, "PX4 did not store the plan, its error is lost, and it accepts the last item", "Differs", "NotKnown",
            each(faults("refuse", ERROR, "end"), lose("<", "MISSION_ACK")), proof="Always", autopilots=["PX4"]),
    Trouble(13, "The final ACK comes late", *ACCEPTED, faults("delay_final_ack", 1.4)),
    Trouble(14, "A fifth of the frames is lost at random", *ACCEPTED,
            lambda bench: [bench.wire.at_random(way, lose=20) for way in "<>"], proof="InDoubt"),
    Trouble(15, "Every frame comes twice", *ACCEPTED,
            lambda bench: [bench.wire.repeat(way, times=None) for way in "<>"]),
    Trouble(17, "An overall limit holds though the transfer goes on", "TookTooLong", CUT_SHORT,
            each(tell("limit", 3), lambda bench: bench.wire.delay("<", 0.9, name="MISSION_REQUEST*", times=None))),
    Trouble(19, "COUNT is refused", "NoSpace", "AsBefore", each(later, faults("refuse", NO_SPACE))),
    Trouble(19, "An item is refused", "NoSpace", CUT_SHORT, faults("refuse", NO_SPACE, 3), failed_item=(2, 3)),
    Trouble(19, "The plan is refused at its end", "NoSpace", CUT_SHORT, faults("refuse", NO_SPACE, "end"),
            failed_item=(4, 4)),
    Trouble(20, "INVALID_SEQUENCE in motion is noise", *ACCEPTED, items=1, then=noise_after_each_item),
    Trouble(21, "The autopilot gives up", ("CancelledByAutopilot", "TimedOut"), CUT_SHORT,
            lose(">", "MISSION_ITEM_INT", None, seq=2), failed_item=(1, 2)),
    Trouble(22, "Another ground station is transferring", ("Denied", "Error"), "AsBefore", each(later, other_station)),
    Trouble(22, "Another ground station is transferring, and a retry succeeds", *ACCEPTED,
            each(later, tell("backoff", 60), other_station)),
    Trouble(24, "Requests beyond the plan", *ACCEPTED, faults("request_instead", 2, 5, 6, 700, 65535), proof="InDoubt"),
    Trouble(25, "Frames from strangers, or for others, are ignored", *ACCEPTED, items=2, then=each(
        *(say(*confusing(3), sender=stranger) for stranger in STRANGERS),
        *(say(*confusing(3, target)) for target in OTHERS))),
    Trouble(7, "Frames of other types of plan are ignored", *ACCEPTED, items=2,
            then=each(*(say(*confusing(3, mission_type=kind)) for kind in (1, 2, 255)))),
    Trouble(26, "Spurious messages change nothing", *ACCEPTED, lose("<", "MISSION_REQUEST*", seq=3), 2,
            say(*UNASKED * 4), proof="InDoubt"),
    Trouble(27, "Late answers to a cancelled upload", *ACCEPTED,
            each(lambda bench: bench.wire.delay("<", 0.6, name="MISSION_*", times=4), cancelled_upload)),
    Trouble(28, "A frame is damaged, another one cut short", *ACCEPTED,
            lambda bench: (bench.wire.corrupt(">", name="MISSION_ITEM_INT", seq=1),
                           bench.wire.truncate("<", 9, name="MISSION_REQUEST*", seq=3))),
    Trouble(28, "The line goes dead", "TimedOut", CUT_SHORT, items=3, failed_item=(1, 3), then=line_dies),
    Trouble(30, "A server that acknowledges every item", "AcceptedEarly", "NotKnown",
            each(later, faults("ack_every_item")), failed_item=(None, 0)),
    Trouble(31, "Starting while busy", *ACCEPTED, items=3, then=is_refused_meanwhile),
    Trouble(32, "Cancelled in the middle", "Cancelled", CUT_SHORT, items=3, then=lambda bench: bench.cancel()),
    Trouble(34, "The item source refuses in mid-transfer", "SourceRefused", CUT_SHORT,
            plan=FunctionPlan(20, refused_item=7, given_before=1), failed_item=(7, 7)),
    Trouble(35, "Arguments are checked before the first byte", "BadLatitude", "NotKnown", is_silent=True,
            plan=[*SURVEY[:2], waypoint(x=900000001)], failed_item=(2, 2)),
    Trouble(36, "The transmit ring is small", *ACCEPTED, tell("room", 1)),
    Trouble(38, "Devices that are no autopilot speak first", *ACCEPTED, then=each(
        say(heartbeat(mavlink.MAV_AUTOPILOT_INVALID, mavlink.MAV_TYPE_GCS), sender=(255, 190)),
        say(heartbeat(mavlink.MAV_AUTOPILOT_PX4, mavlink.MAV_TYPE_CAMERA), sender=(1, 100)))),
    Trouble(39, "The autopilot reboots in mid-transfer", "TimedOut", CUT_SHORT, items=2, failed_item=(0, 1),
            then=lambda bench: bench.autopilot.reboot(bench.now, silent_for_s=3.0)),
    Trouble(39, "The cable is pulled for 2 s", *ACCEPTED, items=2, then=pulled(2.0)),
    Trouble(39, "Heartbeats are lost, and the autopilot still asks", *ACCEPTED, plan=FunctionPlan(60), items=5,
            before=lambda bench: bench.wire.delay("<", 0.24, name="MISSION_REQUEST*", times=None),
            then=lose("<", "HEARTBEAT", None)),
    Trouble(39, "The autopilot starts 30 s late, with a text", *ACCEPTED, options={
        "heartbeat_at_s": 30.0, "uptime_s": 0.0,
        "boot_text": b"\r\n\r\nInit ArduCopter V4.6.3\r\nFree RAM: 262144\r\n"}),
    Trouble(48, "Upload while armed", "Armed", "NotKnown", options={"armed": True}, is_silent=True),
    Trouble(52, "NaN only as a yaw", "NotANumber", "NotKnown", plan=[waypoint(), waypoint(z=NAN)], failed_item=(1, 1),
            is_silent=True),
]  # fmt: skip


@pytest.mark.parametrize(
    "personality, trouble",
    [pytest.param(personality, trouble, id=f"{trouble.title}-{personality}",
                  marks=pytest.mark.scenario(trouble.number, trouble.title))
     for trouble in TROUBLES for personality in trouble.autopilots])  # fmt: skip
def test_upload_ends_as_it_should_and_truthfully(build_bench, personality, trouble):
    bench = build_bench(personality, **trouble.options)
    wire_count = len(on_the_wire(trouble.plan, personality))
    bench.autopilot.load(OLD_PLAN)
    trouble.before(bench)
    before = len(bench.sent_at("MISSION_COUNT"))
    bench.upload(trouble.plan, proof=trouble.proof)
    if trouble.then is not nothing:
        bench.run_until_sent("MISSION_COUNT", before + 1)
        if trouble.items > 0:
            bench.run_until_sent("MISSION_ITEM_INT", min(trouble.items, wire_count))
        trouble.then(bench)
    bench.run_until_ended(limit_s=120)
    status = expect_truth(bench, trouble.plan, personality)
    state, index = bench.state, BOTH.index(personality)
    expected = [one if isinstance(one, str) else one[index] for one in (trouble.ended, trouble.aboard)]
    assert [status, state.aboard, state.failed_item] == [*expected, trouble.failed_item[index]]
    assert (bench.mission_messages() == []) == trouble.is_silent
    assert bench.blocked() == 0 and all(fault.struck for fault in bench.wire._faults)


@pytest.mark.scenario(41, "An altered item is found by PX4's checksum, or by reading back")
def test_item_that_is_altered_under_a_right_checksum_is_found_on_a_line_that_loses(service, personality):
    """Of 65,536 broken frames one is taken for a good one."""
    react = service.autopilot._hears["MISSION_ITEM_INT"]

    def hear(message, sender, now) -> None:
        message.z += 64.0 * (message.seq == 2)
        react(message, sender, now)

    service.autopilot._hears["MISSION_ITEM_INT"] = hear
    service.run(1.2)
    service.wire.lose("<", name="HEARTBEAT")  # the next one shows it
    service.run(2.0)
    service.upload(SURVEY, proof="InDoubt")
    assert service.done(limit_s=30) == ("Differs" if personality == "ArduPilot" else "OtherPlanAboard")
    assert service.state.aboard == "NotKnown"
    if personality == "ArduPilot":
        assert (service.state.failed_item, service.state.field) == (1, "Height")


@pytest.mark.scenario(33, "Restarting from within the callback")
def test_upload_may_begin_in_the_callback_that_reports_the_end(bench, personality):
    bench.tell("again", 3)
    bench.upload(SURVEY)
    assert [bench.run_until_ended(limit_s=5) for _ in range(4)] == ["Accepted"] * 4
    assert bench.restarts == ["WaitingForAutopilot"] * 3
    assert steps(bench) == 4 * smooth_steps(len(on_the_wire(SURVEY, personality)))
    bench.run(5)
    assert len(bench.ends) == 4 and not bench.state.busy


@pytest.mark.scenario(18, "ACCEPTED too early")
def test_acceptance_before_every_item_was_asked_for_is_an_error(line):
    later(line)
    line.upload(SURVEY)
    find(line)
    line.say(request_int(0))
    line.run(0.03)
    line.say(ack())
    assert line.run_until_ended(limit_s=1) == "AcceptedEarly"
    assert line.state.aboard == "NotKnown"
