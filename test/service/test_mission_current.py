"""Where the autopilot's port does not send MISSION_CURRENT unasked, a MissionFollower asks for it, and is no burden."""

from __future__ import annotations

from itertools import pairwise

import pytest

from plans import OLD_PLAN, SURVEY
from simulation.fake_autopilot import mavlink
from simulation.service import is_followers

ASKED = pytest.mark.scenario(51, "MISSION_CURRENT is asked for where it does not come by itself")
SET_INTERVAL, MISSION_CURRENT, ATTITUDE = 511, 42, 30
ITEMS = len(OLD_PLAN) - 1  # of the sketch's: without home


def intervals(service) -> list[tuple[float, int]]:
    """(when [s], message) of each SET_MESSAGE_INTERVAL that has left."""
    return [(entry.time, int(entry.message.param1)) for entry in service.wire.frames(">", "COMMAND_LONG")
            if entry.message.command == SET_INTERVAL]  # fmt: skip


def asked(service) -> list[float]:
    """When MISSION_CURRENT was asked for [s]."""
    return [time for time, message in intervals(service) if message == MISSION_CURRENT]


def times(service, name: str) -> list[float]:
    return [entry.time for entry in service.wire.frames("<", name)]


def on_a_default_port(build_service, **options):
    """An ArduPilot with a plan aboard, of whose port nothing was set but that it speaks MAVLink."""
    service = build_service("ArduPilot", **options)
    service.autopilot.load(OLD_PLAN)
    service.autopilot.current = 3
    return service


@ASKED
def test_current_item_and_total_are_known_soon_on_a_default_port(build_service):
    service = on_a_default_port(build_service)
    service.run(3.5)
    assert (service.followed.current, service.followed.total) == (2, ITEMS)
    service.autopilot.current = 5
    service.run(1.5)
    assert service.followed.current == 4
    assert service.currents == [2, 4]


@ASKED
@pytest.mark.parametrize(
    "personality, options",
    [
        ("PX4", {}),
        ("PX4", {"tells_at_s": 1.04}),
        ("ArduPilot", {"vehicle": "rover", "streams": {MISSION_CURRENT: 1.0}}),
    ],
    ids=["PX4", "PX4 later", "rover with streams"],
)
def test_autopilot_that_sends_it_by_itself_is_not_asked(build_service, personality, options):
    service = build_service(personality, **options)
    service.run(20.0)
    assert len(times(service, "MISSION_CURRENT")) >= 18
    assert asked(service) == []


@ASKED
def test_autopilot_that_has_restarted_is_asked_again(build_service):
    service = on_a_default_port(build_service)
    service.run(5.0)
    service.autopilot.reboot(service.now)
    service.autopilot.current = 6
    # The first heartbeat has an earlier number than the last one before it, like one that came late: the second counts.
    service.run(3.0 + 4.5)
    assert len(asked(service)) == 2
    assert service.followed.current == 5


@ASKED
@pytest.mark.parametrize("direction, lost", [(">", 1), (">", 2), ("<", 1)])
def test_lost_commands_are_repeated_and_lost_answers_need_not_be(build_service, direction, lost):
    service = on_a_default_port(build_service)
    service.wire.lose(direction, name="COMMAND_LONG" if direction == ">" else "COMMAND_ACK", times=lost)
    service.run(10.0)
    assert service.followed.total == ITEMS
    assert len(asked(service)) == (lost + 1 if direction == ">" else 1)


@ASKED
@pytest.mark.slow
def test_autopilot_that_never_sends_it_is_asked_less_and_less(build_service):
    service = on_a_default_port(build_service)
    service.wire.lose(">", times=None, where=is_followers)
    service.run(200.0)
    began = asked(service)
    pauses = [round(later - sooner) for sooner, later in pairwise(began)]
    assert pauses == [2, 4, 8, 16, 32, 64, 64]


@ASKED
def test_px4_that_refuses_is_asked_less_and_less_too_and_nothing_comes_of_its_refusals(build_service):
    service = build_service("PX4", tells_at_s=600.0)
    service.run(20.0)
    began = asked(service)
    assert [round(later - sooner) for sooner, later in pairwise(began)] == [2, 4, 8]
    refusals = [message.result for message in service.autopilot.messages("<", "COMMAND_ACK")]
    assert refusals == [mavlink.MAV_RESULT_FAILED] * 4
    assert service.ends == [] and service.status == "Idle"


@ASKED
def test_nobody_is_asked_before_an_autopilot_is_found_nor_while_there_are_several(build_service):
    service = build_service(None)
    for second in range(8):
        if second >= 2:
            for system in (1, 2):
                heartbeat = mavlink.MAVLink_heartbeat_message(2, 3, 81, 0, 3, 3)
                service.say(heartbeat, (system, 1))
        service.run(1.0)
    assert service.wire.frames(">", "COMMAND_LONG") == []


# Beside the client's own ------------------------------------------------------------


@ASKED
def test_it_is_asked_for_between_commands_and_never_beside_one(build_service):
    """A COMMAND_ACK of the one would be taken for an answer to the other."""
    service = on_a_default_port(build_service)
    service.autopilot.faults.keep_back("COMMAND_ACK")
    service.run(1.5)
    service.order_of("interval", ATTITUDE, 200000)
    assert service.done(limit_s=12) == "NoAnswer"
    ended = service.now
    assert asked(service) == []
    service.run(1.2)
    assert len(asked(service)) == 1 and asked(service)[0] >= ended


@ASKED
@pytest.mark.parametrize("loss", [0, pytest.param(15, marks=pytest.mark.slow)])
def test_beside_quiet_transfers_one_command_is_under_way_at_a_time(build_service, loss):
    """Quiet transfers would take the answer to the one for an answer to the other."""
    service = build_service("ArduPilot", defines={"BENCH_QUIET": 1}, telemetry=5000.0)
    service.autopilot.load(OLD_PLAN)
    service.wire.at_random(">", lose=loss)
    service.wire.at_random("<", lose=loss)
    service.run(2.0)
    for _ in range(4):
        service.upload(SURVEY, proof="Always")
        service.done(limit_s=60)
        service.run(1.0)
        service.autopilot.reboot(service.now, silent_for_s=0.0)  # it is to be asked again
        service.run(4.0 + 2 * loss)
    sent = intervals(service)
    answered = times(service, "COMMAND_ACK")
    assert len(asked(service)) >= 3 and len(sent) > 40
    for (time, message), (later, next_message) in pairwise(sent):
        if MISSION_CURRENT not in (message, next_message) or message == next_message or later - time >= 1.5:
            continue
        assert next_message == MISSION_CURRENT, "Quiet transfers hear no answer to the asking"
        assert any(time < answer < later for answer in answered)
