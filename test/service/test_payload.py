"""The Arduino as a payload: commands that are for it, their answers, and what it tells by itself."""

from __future__ import annotations

import pytest

from disorders import latency_of
from simulation.fake_autopilot import mavlink
from simulation.payload import PayloadBench
from simulation.wire import Wire

WINCH, GRIPPER, USER = 42600, 211, 31000
ACCEPTED, REJECTED, DENIED, UNSUPPORTED, FAILED, IN_PROGRESS = range(6)
AUTOPILOT = (1, 1)
STATION = (255, 190)


@pytest.fixture
def make(personality):
    def build(**options) -> PayloadBench:
        bench = PayloadBench(personality, **options)
        bench.run(2.0)
        return bench

    return build


@pytest.fixture
def payload(make):
    return make()


@pytest.mark.parametrize("identity", [WINCH, GRIPPER, USER, 187])
@pytest.mark.parametrize("answer", [ACCEPTED, REJECTED, DENIED, UNSUPPORTED, FAILED])
def test_command_is_handed_over_and_answered_as_the_sketch_says(payload, identity, answer):
    payload.tell("answer", answer)
    payload.command(identity, 1.0, -2.5, 3.25, 4.0, 5.0, 6.0, 7.0)
    (done,) = payload.carried_out
    assert (done.id, done.params) == (identity, (1.0, -2.5, 3.25, 4.0, 5.0, 6.0, 7.0))
    assert (done.sender, done.for_all, done.context) == (AUTOPILOT, False, 77)
    assert payload.answers_sent == [(identity, answer, AUTOPILOT, 0)]


def test_answer_goes_to_the_station_that_has_sent_the_command(payload):
    payload.command(WINCH, sender=STATION)
    assert payload.carried_out[0].sender == STATION
    assert payload.answers_sent == [(WINCH, ACCEPTED, STATION, 0)]


def test_command_for_another_component_or_system_is_left_alone(payload):
    for target in ((1, 1), (1, 192), (2, 191), (2, 0)):
        payload.command(WINCH, target=target)
    assert payload.carried_out == [] and payload.answers_sent == []


def test_command_for_the_autopilot_is_left_alone_beside_a_listener_that_hears_it_too(make):
    payload = make(defines={"BENCH_LISTENER": True})
    for target in ((1, 1), (1, 192), (2, 191)):
        payload.command(WINCH, target=target)
    assert payload.carried_out == [] and payload.answers_sent == []
    payload.command(WINCH)
    assert len(payload.carried_out) == 1
    assert payload.answers_sent == [(WINCH, ACCEPTED, AUTOPILOT, 0)]
    assert payload.commands_heard == 4


def test_command_for_all_is_answered_unless_it_is_not_ours(payload):
    payload.command(WINCH, target=(1, 0))
    assert payload.carried_out[0].for_all
    assert payload.answers_sent == [(WINCH, ACCEPTED, AUTOPILOT, 0)]
    payload.tell("answer", UNSUPPORTED)
    payload.command(GRIPPER, target=(1, 0))
    payload.command(GRIPPER, target=(0, 0))
    assert len(payload.carried_out) == 3
    assert len(payload.answers_sent) == 1


def test_repeated_command_is_carried_out_once_and_answered_each_time(payload):
    for confirmation in range(4):
        payload.command(WINCH, 1.0, confirmation=confirmation, wait_s=0.5)
    assert len(payload.carried_out) == 1
    assert payload.answers_sent == [(WINCH, ACCEPTED, AUTOPILOT, 0)] * 4


def test_same_command_given_anew_is_carried_out_again(payload):
    for _ in range(2):
        payload.command(WINCH, 1.0)
    payload.command(WINCH, 2.0, confirmation=1)  # the first of this one was lost
    payload.command(WINCH, 2.0, confirmation=1, sender=STATION)
    payload.run(6.0)
    payload.command(WINCH, 2.0, confirmation=1, sender=STATION)  # long ago: another one, whose first was lost
    assert len(payload.carried_out) == 5
    assert len(payload.answers_sent) == 5


def test_command_in_progress_is_told_each_second_until_it_ends(payload):
    payload.tell("answer", IN_PROGRESS)
    payload.command(WINCH, 1.0)
    assert payload.is_busy
    payload.tell("progress", 40)
    payload.run(2.0)
    payload.tell("finish", FAILED)
    payload.run(0.2)
    assert not payload.is_busy
    results = [result for _, result, _, _ in payload.answers_sent]
    assert results == [IN_PROGRESS, IN_PROGRESS, IN_PROGRESS, FAILED]
    assert [progress for *_, progress in payload.answers_sent] == [0, 40, 40, 0]
    payload.command(WINCH, 1.0, confirmation=1)
    assert payload.answers_sent[-1] == (WINCH, FAILED, AUTOPILOT, 0)
    payload.run(3.0)
    assert len(payload.answers_sent) == 5 and len(payload.carried_out) == 1


def test_repeat_of_a_command_in_progress_hears_that_it_is(payload):
    payload.tell("answer", IN_PROGRESS)
    payload.command(WINCH, 1.0)
    payload.command(WINCH, 1.0, confirmation=1)
    assert [result for _, result, _, _ in payload.answers_sent] == [IN_PROGRESS, IN_PROGRESS]
    assert len(payload.carried_out) == 1


def test_second_command_in_progress_is_rejected_for_now(payload):
    payload.tell("answer", IN_PROGRESS)
    payload.command(WINCH, 1.0)
    payload.command(GRIPPER, 1.0, sender=STATION)
    assert payload.answers_sent == [(WINCH, IN_PROGRESS, AUTOPILOT, 0), (GRIPPER, REJECTED, STATION, 0)]
    payload.tell("finish", ACCEPTED)
    payload.tell("answer", ACCEPTED)
    payload.run(0.1)
    payload.command(GRIPPER, 1.0, sender=STATION)
    assert payload.answers_sent[-2:] == [(WINCH, ACCEPTED, AUTOPILOT, 0), (GRIPPER, ACCEPTED, STATION, 0)]


def test_end_of_nothing_is_not_told(payload):
    payload.tell("finish", FAILED)
    payload.run(0.5)
    assert payload.answers_sent == []


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(6))
def test_sender_that_repeats_hears_its_answer_on_a_bad_line_and_the_winch_runs_once(make, seed):
    payload = make(wire=Wire(seed))
    payload.wire.at_random(">", lose=40)
    payload.wire.at_random("<", lose=40)
    payload.wire.set_latency(latency_of(seed))
    for confirmation in range(40):
        payload.command(WINCH, 5.0, confirmation=confirmation, wait_s=0.5)
        arrived = [entry for entry in payload.autopilot.messages(">", "COMMAND_ACK") if entry.command == WINCH]
        if arrived:
            break
    assert arrived and arrived[0].result == ACCEPTED
    assert len(payload.carried_out) == 1


def sent(payload, word: str, name: str):
    payload.tell(word)
    payload.run(0.1)
    (message,) = payload.autopilot.messages(">", name)
    assert message.get_srcComponent() == 191
    return message


def test_distance_is_told(payload):
    payload.tell("distance", 345)
    payload.run(0.1)
    (message,) = payload.autopilot.messages(">", "DISTANCE_SENSOR")
    assert (message.min_distance, message.max_distance, message.current_distance) == (20, 700, 345)
    assert (message.orientation, message.id, message.type, message.covariance) == (25, 3, 1, 255)
    assert message.time_boot_ms == pytest.approx(payload.now * 1000, abs=200)


def test_landing_target_is_told(payload):
    message = sent(payload, "target", "LANDING_TARGET")
    assert (message.angle_x, message.angle_y, message.distance) == (0.25, -0.5, 3.0)
    assert (message.target_num, message.frame) == (2, mavlink.MAV_FRAME_BODY_FRD)
    assert message.time_usec == pytest.approx(payload.now * 1e6, abs=200_000)


def test_position_of_a_landing_target_is_told_as_seen_from_the_aircraft(payload):
    message = sent(payload, "seen", "LANDING_TARGET")
    assert (message.x, message.y, message.z, message.distance) == (-1.5, 2.0, 6.0, 6.5)
    assert (message.position_valid, message.frame, message.target_num) == (1, mavlink.MAV_FRAME_BODY_FRD, 3)
    assert message.q == [1.0, 0.0, 0.0, 0.0]
    assert message.time_usec == pytest.approx(payload.now * 1e6, abs=200_000)


def test_position_of_a_landing_target_is_told_as_seen_from_the_origin(payload):
    message = sent(payload, "origin", "LANDING_TARGET")
    assert (message.x, message.y, message.z) == (-30.25, 12.0, -0.5)
    assert (message.position_valid, message.frame) == (1, mavlink.MAV_FRAME_LOCAL_NED)


def test_position_of_a_landing_target_is_not_sent_where_mavlink_1_would_cut_it_off():
    payload = PayloadBench("ArduPilot", mavlink_version=1)
    payload.run(2.0)
    for word in ("seen", "origin"):
        (line,) = payload.tell(word)
        assert line.split(" ")[1:3] == ["sent", "0"]
    payload.run(0.1)
    assert payload.autopilot.messages(">", "LANDING_TARGET") == []


def test_value_with_a_name_is_told(payload):
    message = sent(payload, "value", "NAMED_VALUE_FLOAT")
    assert (message.name, message.value) == ("ten_letter", -1.5)
    assert message.time_boot_ms == pytest.approx(payload.now * 1000, abs=200)


def test_name_that_is_too_long_is_cut_off(payload):
    assert sent(payload, "cut", "NAMED_VALUE_FLOAT").name == "more than "


def test_text_is_told(payload):
    message = sent(payload, "text", "STATUSTEXT")
    assert (message.severity, message.text) == (4, "rope torn")


def test_text_that_is_too_long_is_cut_off(payload):
    message = sent(payload, "longtext", "STATUSTEXT")
    assert message.text == "a text of more than fifty characters, which are the most"[:50]
