"""The fake autopilots behave as the real ones do, where no recording shows it.

What the recordings show is in test_recordings.py.
"""
import itertools
import math
import random

import pytest

import recordings
from fake_autopilot import ALL, FENCE, MISSION, RALLY, ArduPilot, Item, Px4, item, mavlink
from fake_autopilot.ardupilot import BOOT_TEXT
from fake_autopilot.frames import FrameSplitter
from fake_autopilot.px4_rewriting import checksum
from plain_client import PlainClient

ACCEPTED = mavlink.MAV_MISSION_ACCEPTED
ERROR = mavlink.MAV_MISSION_ERROR
UNSUPPORTED_FRAME = mavlink.MAV_MISSION_UNSUPPORTED_FRAME
UNSUPPORTED = mavlink.MAV_MISSION_UNSUPPORTED
NO_SPACE = mavlink.MAV_MISSION_NO_SPACE
INVALID_SEQUENCE = mavlink.MAV_MISSION_INVALID_SEQUENCE
DENIED = mavlink.MAV_MISSION_DENIED
CANCELLED = mavlink.MAV_MISSION_OPERATION_CANCELLED

NAN = math.nan
RTL = 20
START = mavlink.MAV_CMD_MISSION_START
ARM = mavlink.MAV_CMD_COMPONENT_ARM_DISARM
SET_MODE = mavlink.MAV_CMD_DO_SET_MODE
SET_CURRENT = mavlink.MAV_CMD_DO_SET_MISSION_CURRENT

BOTH = pytest.mark.parametrize("autopilot", [ArduPilot, Px4])


def waypoints(count: int, first: int = 0) -> list[Item]:
    """Waypoints that differ from each other, numbered from `first`."""
    return [item(16, frame=3, x=-353632620 + 1000 * (first + n), y=1491652370, z=20.0)
            for n in range(count)]


def places(items) -> list[tuple[int, int]]:
    return [(one.x, one.y) for one in items]


def words(answers) -> list[str]:
    return [answer.text.strip() for answer in answers if answer.get_type() == "STATUSTEXT"]


def missions(answers) -> list[tuple]:
    """The mission messages among answers: (name without MISSION_, what matters of it)."""
    result = []
    for answer in answers:
        name = answer.get_type()
        if name == "MISSION_ACK":
            result.append(("ACK", answer.type))
        elif name.startswith("MISSION_REQUEST"):
            result.append((name[len("MISSION_"):], answer.seq))
        elif name == "MISSION_COUNT":
            result.append(("COUNT", answer.count))
        elif name.startswith("MISSION_ITEM"):
            result.append(("ITEM", answer.seq))
    return result


def command_results(answers) -> list[tuple[int, int]]:
    return [(answer.command, answer.result) for answer in answers
            if answer.get_type() == "COMMAND_ACK"]


def client_of(fake, **options) -> PlainClient:
    return PlainClient(fake, **options)


# -- the link -----------------------------------------------------------------------------


@BOTH
def test_heartbeats_come_once_a_second(autopilot):
    fake = autopilot()
    fake.run(10.5)
    times = [time for time, _, message in fake.log if message.get_type() == "HEARTBEAT"]
    assert times == [float(second) for second in range(11)]


@BOTH
def test_output_is_the_same_however_often_the_autopilot_is_run(autopilot):
    seldom, often = autopilot(telemetry=500), autopilot(telemetry=500)
    frames_of_often = []
    for millisecond in range(5001):
        often.run(millisecond / 1000)
        frames_of_often += often.outbox
    seldom.run(5.0)
    assert frames_of_often == seldom.outbox
    assert len(seldom.outbox) > 50


@BOTH
def test_next_event_leads_from_frame_to_frame(autopilot):
    fake = autopilot()
    now, times = 0.0, []
    while now < 5.0:
        now = fake.next_event(now)
        fake.run(now)
        times += [time for time, _ in fake.outbox]
        assert all(time == now for time, _ in fake.outbox)
    reference = autopilot()
    reference.run(now)
    assert times == [time for time, _ in reference.outbox]


@pytest.mark.parametrize("version, magic", [(1, 0xFE), (2, 0xFD)])
def test_ardupilot_speaks_its_own_version_whatever_the_client_speaks(version, magic):
    for client_version in (1, 2):
        fake = ArduPilot(mavlink_version=version)
        client = client_of(fake, mavlink_version=client_version)
        assert client.upload(waypoints(3)) == ACCEPTED
        assert {message.get_msgbuf()[0] for message in fake.messages("<")} == {magic}


@pytest.mark.parametrize("client_version", [1, 2])
def test_px4_sends_version_2_and_understands_both(client_version):
    fake = Px4()
    assert fake.run(0.0)[0] == 0xFD
    client = client_of(fake, mavlink_version=client_version)
    assert client.upload(waypoints(3)) == ACCEPTED
    with pytest.raises(ValueError, match="MAVLink 2"):
        Px4(mavlink_version=1)


@BOTH
def test_a_frame_may_arrive_byte_by_byte(autopilot):
    fake = autopilot()
    client = client_of(fake)
    for byte in client.count(2).pack(mavlink.MAVLink(None, 255, 190)):
        fake.receive(bytes((byte,)), 1.0)
    assert missions(client.wait(0.05))[0][1] == 0


def test_the_splitter_tells_frames_from_damage_and_from_noise():
    frame = bytes(mavlink.MAVLink_mission_request_list_message(1, 1).pack(
        mavlink.MAVLink(None, 255, 190)))
    damaged = frame[:-1] + bytes((frame[-1] ^ 1,))
    unknown_flag = frame[:2] + b"\x02" + frame[3:]
    splitter = FrameSplitter()
    assert splitter.feed(b"ab" + frame + damaged) \
        == [(b"ab", False), (frame, True), (damaged, False)]
    pieces = splitter.feed(unknown_flag)
    assert b"".join(piece for piece, _ in pieces) == unknown_flag
    assert not [piece for piece, intact in pieces if intact]
    assert splitter.feed(frame[:5]) == [] and splitter.feed(frame[5:]) == [(frame, True)]


@BOTH
def test_a_damaged_frame_is_not_heard(autopilot):
    fake = autopilot()
    client = client_of(fake)
    frame = bytearray(client.count(2).pack(mavlink.MAVLink(None, 255, 190)))
    for position in range(1, len(frame)):
        damaged = bytes(byte ^ 0x40 * (n == position) for n, byte in enumerate(frame))
        fake.receive(damaged + b"\0" * 300, client.now)  # zeros fill a longer length
        assert missions(client.wait(0.02)) == [], position


@BOTH
def test_telemetry_is_sent_at_the_rate_asked_for(autopilot):
    fake = autopilot(telemetry=1000)
    assert 9_500 < len(fake.run(10.0)) < 11_000


def test_ardupilot_says_almost_nothing_unasked():
    fake = ArduPilot(uptime_s=60)
    assert len(fake.run(60.0)) < 33 * 60
    assert {message.get_type() for message in fake.messages()} \
        == {"HEARTBEAT", "TIMESYNC", "PARAM_VALUE"}


def test_boot_text_comes_before_the_first_frame():
    fake = ArduPilot(boot_text=BOOT_TEXT)
    out = fake.run(0.0)
    assert out.startswith(BOOT_TEXT)
    assert len(out) == len(BOOT_TEXT) + 21


@pytest.mark.parametrize("name", ["px4/clean_with_streams",
                                  "arducopter/clean_then_streams_10hz"])
def test_recorded_telemetry_is_renumbered_and_intact(name):
    fake = Px4(telemetry=recordings.telemetry(name), system_id=7)
    fake.run(30.0)
    frames = [frame for _, frame in fake.outbox]
    assert len(frames) > 300
    for number, frame in enumerate(frames):
        assert frame[4] == number % 256 and frame[5] == 7
    known = mavlink.MAVLink(None)
    known.robust_parsing = True
    parsed = known.parse_buffer(b"".join(frames))
    assert len(parsed) == len(frames)
    assert not [message for message in parsed if message.get_type() == "BAD_DATA"]


@pytest.mark.parametrize("baud", [57600, 115200])
def test_a_saturated_line_is_full_and_still_carries_the_answers(baud):
    fake = ArduPilot(telemetry=recordings.saturated("arducopter/clean_then_streams_10hz", baud),
                     baud=baud)
    client = client_of(fake)
    assert client.upload(waypoints(20)) == ACCEPTED
    start = client.now
    fake.run(start)
    assert len(fake.run(start + 10.0)) == pytest.approx(baud, rel=0.01)
    ends = [time + 10 * len(frame) / baud for time, frame in fake.outbox]
    assert all(later >= earlier - 1e-9 for earlier, later in
               zip(ends, (time for time, _ in fake.outbox[1:])))


def test_a_repeated_recording_goes_on_for_ever():
    fake = Px4(telemetry=recordings.repeated("px4/item_lost"))
    fake.run(60.0)
    late = [time for time, _ in fake.outbox if time > 55.0]
    assert len(late) > 50


# -- who is heard ----------------------------------------------------------------------------


@pytest.mark.parametrize("autopilot, target, heard", [
    (ArduPilot, (1, 1), True), (ArduPilot, (1, 0), True), (ArduPilot, (1, 190), True),
    (ArduPilot, (1, 42), True), (ArduPilot, (0, 0), True), (ArduPilot, (0, 1), True),
    (ArduPilot, (2, 1), False),
    (Px4, (1, 1), True), (Px4, (1, 0), True), (Px4, (1, 190), True),
    (Px4, (1, 42), False), (Px4, (0, 0), False), (Px4, (0, 1), False), (Px4, (2, 1), False),
])
def test_it_hears_what_is_addressed_to_it(autopilot, target, heard):
    client = client_of(autopilot(), target=target)
    assert bool(missions(client.say(client.count(1)))) == heard


def test_ardupilot_leaves_a_component_that_it_has_seen_its_messages():
    fake = ArduPilot()
    client = client_of(fake, address=(1, 191), target=(1, 191))
    client.say(mavlink.MAVLink_heartbeat_message(18, 8, 0, 0, 4, 3))
    assert missions(client.say(client.count(1))) == []


@pytest.mark.parametrize("autopilot, served", [(ArduPilot, False), (Px4, True)])
def test_a_client_that_uses_the_autopilots_own_ids(autopilot, served):
    client = client_of(autopilot(), address=(1, 1))
    assert bool(missions(client.say(client.count(1)))) == served


@BOTH
def test_other_ids_of_its_own(autopilot):
    fake = autopilot(system_id=9, component_id=1)
    client = client_of(fake, target=(9, 1))
    assert client.upload(waypoints(2)) == ACCEPTED
    assert {message.get_srcSystem() for message in fake.messages("<")} == {9}


# -- upload ----------------------------------------------------------------------------------


@BOTH
@pytest.mark.parametrize("count", [1, 2, 10, 255, 256, 257])
def test_plans_of_any_length_come_aboard_whole(autopilot, count):
    fake = autopilot()
    client = client_of(fake)
    plan = waypoints(count)
    assert client.upload(plan) == ACCEPTED
    assert fake.received() == plan
    assert client.download() == fake.plan()
    assert len(fake.plan()) == count


def test_answers_take_17_and_10_milliseconds():
    for autopilot, delay_s in ((ArduPilot, 0.017), (Px4, 0.010)):
        fake = autopilot()
        client = client_of(fake)
        client.say(client.count(1))
        assert [time for time, direction, message in fake.log if direction == "<"
                and message.get_type().startswith("MISSION_REQUEST")] == [1.0 + delay_s]
        fake = autopilot(response_delay_s=0.001)
        client = client_of(fake)
        client.say(client.count(1))
        assert fake.log[-1].time == pytest.approx(1.001)


def test_ardupilot_asks_with_the_deprecated_request_in_every_type():
    for mission_type in (MISSION, FENCE, RALLY):
        client = client_of(ArduPilot())
        assert client.ask(client.count(1, mission_type)).get_type() == "MISSION_REQUEST"


def test_px4_asks_in_floats_after_any_float_message_until_an_integer_one():
    fake = Px4()
    client = client_of(fake)
    assert client.ask(client.count(4)).get_type() == "MISSION_REQUEST_INT"
    degrees = item(16, x=47.0, y=8.5, z=20.0)
    assert client.ask(client.float_item(degrees, 0)).get_type() == "MISSION_REQUEST"
    assert client.ask(client.item(waypoints(1)[0], 1)).get_type() == "MISSION_REQUEST_INT"
    assert client.ask(client.float_item(degrees, 2)).get_type() == "MISSION_REQUEST"
    assert client.ask(client.float_item(degrees, 3)).get_type() == "MISSION_ACK"
    assert client.ask(client.count(1)).get_type() == "MISSION_REQUEST"


def test_px4_turns_to_floats_when_integers_are_unsupported():
    client = client_of(Px4())
    client.say(client.count(1))
    assert client.ask(client.ack(UNSUPPORTED)).get_type() == "MISSION_REQUEST"


def test_px4_takes_no_integer_frame_in_a_float_item():
    for frame in (5, 6):
        client = client_of(Px4())
        client.say(client.count(1))
        answer = client.ask(client.float_item(item(16, frame=frame, x=47.0, y=8.0, z=20.0), 0))
        assert answer.type == UNSUPPORTED_FRAME


def test_float_items_come_aboard_coarser_on_ardupilot():
    fake = ArduPilot()
    client = client_of(fake)
    client.say(client.count(2))
    degrees = item(16, x=-35.3632621, y=149.1652374, z=20.0)
    client.say(client.float_item(degrees, 0))
    assert client.ask(client.float_item(degrees, 1)).type == ACCEPTED
    held = fake.plan()[1]
    assert 0 < abs(held.y - 1491652374) * 0.0111 < 1.8


def test_it_asks_again_at_its_own_pace_and_gives_up():
    for autopilot, period, end in ((ArduPilot, 1.0, 8.0), (Px4, 0.265, 5.08)):
        fake = autopilot()
        client = client_of(fake)
        client.say(client.count(2))
        client.wait(20.0)
        requests = [time for time, direction, message in fake.log if direction == "<"
                    and message.get_type().startswith("MISSION_REQUEST")]
        intervals = [b - a for a, b in itertools.pairwise(requests)]
        assert intervals == pytest.approx([period] * len(intervals))
        assert len(requests) == math.ceil((end - fake.response_delay_s) / period)
        texts = [(time, message.text.strip()) for time, direction, message in fake.log
                 if message.get_type() == "STATUSTEXT"]
        assert len(texts) == 1
        assert texts[0][0] - 1.0 == pytest.approx(end, abs=0.02)


def test_a_radio_slows_ardupilot_down():
    fake = ArduPilot(radio_slowdown_s=0.5)
    client = client_of(fake)
    client.say(client.count(2))
    assert missions(client.wait(1.4)) == []
    assert missions(client.wait(0.2)) == [("REQUEST", 0)]


@pytest.mark.parametrize("mission_type, words_said", [
    (MISSION, "Mission upload timeout"), (FENCE, "Fence upload timeout"),
    (RALLY, "Rally upload timeout")])
def test_ardupilot_gives_up_with_an_ack_and_in_words(mission_type, words_said):
    client = client_of(ArduPilot())
    client.say(client.count(2, mission_type))
    answers = client.wait(9.0)
    assert ("ACK", CANCELLED) in missions(answers) and words(answers) == [words_said]
    assert [answer.mission_type for answer in answers
            if answer.get_type() == "MISSION_ACK"] == [mission_type]


def test_px4_gives_up_without_an_ack():
    client = client_of(Px4())
    client.say(client.count(2))
    answers = client.wait(9.0)
    assert not [kind for kind, _ in missions(answers) if kind == "ACK"]
    assert words(answers) == ["Operation timeout"]


def test_a_wrong_item_makes_px4_wait_5_seconds_more():
    client = client_of(Px4())
    client.say(client.count(3))
    client.wait(4.0)
    client.say(client.item(waypoints(1)[0], 2))
    assert words(client.wait(4.9)) == []
    assert words(client.wait(0.2)) == ["Operation timeout"]


def test_a_wrong_item_wins_no_time_on_ardupilot():
    client = client_of(ArduPilot())
    client.say(client.count(3))
    client.wait(4.0)
    assert missions(client.say(client.item(waypoints(1)[0], 2)))[0] == ("ACK", INVALID_SEQUENCE)
    assert words(client.wait(4.0)) == ["Mission upload timeout"]


@pytest.mark.parametrize("taken", range(4))
def test_a_broken_off_upload_leaves_a_mixture_on_ardupilot(taken):
    fake = ArduPilot()
    old, new = waypoints(6), waypoints(4, first=100)
    fake.load(old)
    client = client_of(fake)
    client.say(client.count(4))
    for seq in range(taken):
        client.say(client.item(new[seq], seq))
    client.wait(10.0)
    assert fake.received() == new[:taken] + old[taken:4]
    assert places(fake.plan()[1:]) == places((new[:taken] + old[taken:4])[1:])


@pytest.mark.parametrize("taken", range(4))
def test_a_broken_off_upload_leaves_the_old_plan_on_px4(taken):
    fake = Px4()
    old, new = waypoints(6), waypoints(4, first=100)
    fake.load(old)
    client = client_of(fake)
    client.say(client.count(4))
    for seq in range(taken):
        client.say(client.item(new[seq], seq))
    client.wait(10.0)
    assert fake.received() == old


def test_a_refused_item_leaves_a_mixture_on_ardupilot_and_the_old_plan_on_px4():
    old, new = waypoints(3), waypoints(3, first=50)
    new[2] = new[2]._replace(frame=1)
    for autopilot, aboard in ((ArduPilot, new[:2] + old[2:]), (Px4, old)):
        fake = autopilot()
        fake.load(old)
        assert client_of(fake).upload(new) == UNSUPPORTED_FRAME
        assert fake.received() == aboard


def test_ardupilot_keeps_its_old_fence_when_a_new_one_breaks_off():
    fake = ArduPilot()
    square = [item(5001, frame=0, param1=4, x=n * 1000, y=n * n * 500) for n in range(4)]
    fake.load(square, FENCE)
    client = client_of(fake)
    client.say(client.count(2, FENCE))
    client.say(client.item(item(5003, frame=0, param1=50), 0, FENCE))
    client.wait(10.0)
    assert fake.received(FENCE) == square


def test_ardupilot_refuses_a_fence_whose_corners_do_not_add_up():
    client = client_of(ArduPilot())
    corner = item(5001, frame=0, param1=3, x=1, y=2)
    assert client.upload([corner, corner], FENCE) == ERROR


@pytest.mark.parametrize("frame", range(12))
def test_frames_taken(frame):
    for autopilot, taken in ((ArduPilot, {0, 2, 3, 5, 6, 10, 11}), (Px4, {0, 3, 5, 6})):
        plan = waypoints(1) + [waypoints(1)[0]._replace(frame=frame)]
        expected = ACCEPTED if frame in taken else UNSUPPORTED_FRAME
        if autopilot is Px4 and frame == 2:
            expected = UNSUPPORTED
        assert client_of(autopilot()).upload(plan) == expected


@pytest.mark.parametrize("sent, read", [(2, 0), (5, 0), (6, 3), (10, 10), (11, 10)])
def test_ardupilot_reads_frames_back_in_their_old_form(sent, read):
    fake = ArduPilot()
    client_of(fake).upload([waypoints(1)[0]._replace(frame=sent)] * 2)
    assert fake.plan()[1].frame == read


@pytest.mark.parametrize("number", range(1, 5))
def test_ardupilot_refuses_nan_and_infinity_by_parameter(number):
    for value, command in ((NAN, 178), (math.inf, 16), (-math.inf, 16)):
        bad = item(command, frame=3, x=1, y=1, z=20.0, **{f"param{number}": value})
        assert client_of(ArduPilot()).upload([*waypoints(1), bad]) \
            == mavlink.MAV_MISSION_INVALID_PARAM1 + number - 1


@pytest.mark.parametrize("command", [16, 17, 21, 22])
def test_a_yaw_may_be_unset_on_both(command):
    unset = item(command, frame=3, x=1, y=1, z=20.0, param4=NAN)
    for autopilot in (ArduPilot, Px4):
        assert client_of(autopilot()).upload([*waypoints(1), unset]) == ACCEPTED


@pytest.mark.parametrize("change, result", [
    (dict(x=900000001), mavlink.MAV_MISSION_INVALID_PARAM5_X),
    (dict(x=-900000001), mavlink.MAV_MISSION_INVALID_PARAM5_X),
    (dict(y=1800000001), mavlink.MAV_MISSION_INVALID_PARAM6_Y),
    (dict(z=NAN), mavlink.MAV_MISSION_INVALID_PARAM7),
    (dict(z=90000.0), mavlink.MAV_MISSION_INVALID_PARAM7)])
def test_ardupilot_checks_the_place_and_px4_does_not(change, result):
    plan = [*waypoints(1), waypoints(1)[0]._replace(**change)]
    assert client_of(ArduPilot()).upload(plan) == result
    assert client_of(Px4()).upload(plan) == ACCEPTED


@pytest.mark.parametrize("target, result", [(0, ERROR), (1, ACCEPTED), (3, ACCEPTED),
                                            (4, ERROR)])
def test_ardupilot_refuses_a_jump_out_of_the_plan(target, result):
    jump = item(177, frame=2, param1=target, param2=1)
    plan = [*waypoints(2), jump, *waypoints(1)]
    assert client_of(ArduPilot()).upload(plan) == result
    assert client_of(Px4()).upload(plan) == ACCEPTED


def test_item_0_is_home_on_ardupilot_and_an_item_on_px4():
    plan = [item(22, x=5, y=6, z=30.0), *waypoints(2)]
    fake = ArduPilot(home=(10, 20, 100.0))
    client = client_of(fake)
    assert client.upload(plan) == ACCEPTED
    first = client.download()[0]
    assert (first.command, first.frame, first.x, first.y) == (16, 0, 10, 20)
    assert first.z == pytest.approx(100.0)
    homeless = ArduPilot(home=None)
    client_of(homeless).upload(plan)
    assert homeless.plan()[0][8:] == (0, 0, 0.0)
    px4 = Px4()
    client_of(px4).upload(plan)
    assert px4.plan()[0].command == 22


def test_a_bad_item_0_is_refused_by_ardupilot_though_it_is_not_flown():
    plan = [item(31000), *waypoints(2)]
    assert client_of(ArduPilot()).upload(plan) == UNSUPPORTED


@BOTH
def test_count_0_is_accepted_and_empties_the_plan(autopilot):
    fake = autopilot()
    fake.load(waypoints(3))
    client = client_of(fake)
    assert client.ask(client.count(0)).type == ACCEPTED
    assert fake.plan() == []
    assert client.ask(client.request_list()).count == 0


def test_a_count_too_large_is_refused():
    fake = ArduPilot()
    client = client_of(fake)
    answers = client.say(client.count(651))
    assert missions(answers) == [("ACK", NO_SPACE)]
    assert words(answers) == ["Only 650 items are supported"]
    assert missions(client.say(client.count(650))) == [("REQUEST", 0)]
    client = client_of(Px4(item_limit=10))
    answers = client.say(client.count(11))
    assert missions(answers) == [("ACK", NO_SPACE)] and words(answers) == []
    roomy = client_of(ArduPilot(item_limit=700))
    assert missions(roomy.say(roomy.count(700))) == [("REQUEST", 0)]


def test_the_last_item_again_is_an_error_on_ardupilot_and_accepted_again_on_px4():
    for autopilot, result in ((ArduPilot, ERROR), (Px4, ACCEPTED)):
        fake = autopilot()
        client = client_of(fake)
        plan = waypoints(3)
        client.upload(plan)
        client.wait(2.0)
        again = client.ask(client.item(plan[2], 2))
        assert again.type == result
        assert fake.received() == plan
        earlier = client.ask(client.item(plan[1], 1))
        assert earlier.type == ERROR


def test_px4_acknowledges_the_repeated_last_item_of_an_upload_that_broke_off():
    client = client_of(Px4())
    client.say(client.count(3))
    client.say(client.item(waypoints(1)[0], 0))
    client.wait(10.0)
    assert client.ask(client.item(waypoints(1)[0], 0)).type == ACCEPTED


def test_the_final_ack_is_sent_once():
    for autopilot in (ArduPilot, Px4):
        client = client_of(autopilot())
        client.upload(waypoints(2))
        assert missions(client.wait(20.0)) == []


def test_count_again_in_mid_transfer_starts_again_on_ardupilot():
    fake = ArduPilot()
    client = client_of(fake)
    plan = waypoints(3)
    client.say(client.count(3))
    client.say(client.item(plan[0], 0))
    assert missions(client.say(client.count(3))) == [("REQUEST", 0)]
    assert client.upload(plan) == ACCEPTED


def test_count_again_in_mid_transfer_is_an_error_on_px4_and_the_transfer_goes_on():
    fake = Px4()
    client = client_of(fake)
    plan = waypoints(3)
    client.say(client.count(3))
    client.say(client.item(plan[0], 0))
    answers = client.say(client.count(3))
    assert missions(answers) == [("ACK", ERROR)] and words(answers) == ["WPM: REJ. CMD: Busy"]
    assert missions(client.say(client.item(plan[1], 1))) == [("REQUEST_INT", 2)]
    assert missions(client.say(client.item(plan[2], 2))) == [("ACK", ACCEPTED)]
    assert fake.received() == plan


def test_cancelling_frees_px4_and_not_ardupilot():
    for autopilot, freed in ((ArduPilot, False), (Px4, True)):
        client = client_of(autopilot())
        client.say(client.count(3))
        client.say(client.item(waypoints(1)[0], 0))
        assert missions(client.say(client.ack(CANCELLED))) == []
        assert (missions(client.wait(3.0)) == []) == freed
        again = missions(client.say(client.count(2)))
        assert [seq for _, seq in again] == [0]


def test_ardupilot_takes_a_mission_and_a_fence_side_by_side():
    fake = ArduPilot()
    client = client_of(fake)
    plan = waypoints(2)
    circle = item(5003, frame=0, param1=50.0, x=1, y=2)
    client.say(client.count(2))
    client.say(client.count(1, FENCE))
    assert missions(client.say(client.item(plan[0], 0))) == [("REQUEST", 1)]
    assert missions(client.say(client.item(circle, 0, FENCE))) == [("ACK", ACCEPTED)]
    assert missions(client.say(client.item(plan[1], 1))) == [("ACK", ACCEPTED)]
    assert (fake.received(), fake.received(FENCE)) == (plan, [circle])


@pytest.mark.parametrize("taken", [0, 1])
def test_px4_refuses_a_fence_during_a_mission_with_the_missions_type(taken):
    client = client_of(Px4())
    client.say(client.count(2))
    for seq in range(taken):
        client.say(client.item(waypoints(1)[0], seq))
    answer = client.ask(client.count(1, FENCE))
    assert (answer.get_type(), answer.type, answer.mission_type) == ("MISSION_ACK", ERROR,
                                                                     MISSION)


def test_another_clients_count_is_denied_or_an_error():
    for autopilot, result in ((ArduPilot, DENIED), (Px4, ERROR)):
        fake = autopilot()
        client = client_of(fake)
        plan = waypoints(2)
        client.say(client.count(2))
        other = client_of(fake, address=(254, 190), now=client.now)
        answer = other.ask(other.count(2))
        assert (answer.type, answer.target_system) == (result, 254)
        client.now = other.now
        client.say(client.item(plan[0], 0))
        assert missions(client.say(client.item(plan[1], 1))) == [("ACK", ACCEPTED)]


def test_an_item_from_another_client_does_not_come_aboard():
    for autopilot, said in ((ArduPilot, [("ACK", DENIED)]), (Px4, [])):
        fake = autopilot()
        client = client_of(fake)
        client.say(client.count(1))
        other = client_of(fake, address=(254, 190), now=client.now)
        assert missions(other.say(other.item(waypoints(1)[0], 0))) == said
        assert fake.received() == []


def test_request_list_during_our_own_upload():
    client = client_of(ArduPilot())
    client.say(client.count(3))
    assert missions(client.say(client.request_list())) == [("ACK", DENIED)]
    assert missions(client.say(client.item(waypoints(1)[0], 0))) == [("REQUEST", 1)]

    fake = Px4()
    fake.load(waypoints(5))
    client = client_of(fake)
    client.say(client.count(3))
    answers = client.say(client.request_list())
    assert missions(answers) == []
    assert words(answers) == ["Mission download request ignored, already active"]
    assert missions(client.say(client.item(waypoints(1)[0], 0))) == [("REQUEST_INT", 1)]


def test_in_one_corner_request_list_drops_px4s_upload():
    fake = Px4()
    fake.load(waypoints(1))
    client = client_of(fake)
    client.say(client.count(3))
    client.say(client.item(waypoints(1, first=9)[0], 0))  # as far as the old plan is long
    assert missions(client.say(client.request_list())) == [("COUNT", 1)]
    assert missions(client.wait(1.0)) == []
    client.say(client.request_int(0))
    client.say(client.ack(ACCEPTED))
    assert missions(client.say(client.count(3))) == [("ACK", ERROR)]


def test_px4_stays_busy_until_a_download_is_acknowledged_or_times_out():
    fake = Px4()
    fake.load(waypoints(2))
    client = client_of(fake)
    client.say(client.request_list())
    client.say(client.request_int(0))
    answers = client.say(client.count(1))
    assert missions(answers) == [("ACK", ERROR)]
    assert words(answers) == ["WPM: IGN MISSION_COUNT: Busy"]
    client.wait(6.0)
    assert missions(client.say(client.count(1))) == [("REQUEST_INT", 0)]


def test_clear_during_our_own_upload():
    fake = ArduPilot()
    fake.load(waypoints(4))
    client = client_of(fake)
    client.say(client.count(3))
    assert missions(client.say(client.clear_all())) == [("ACK", ACCEPTED)]
    assert missions(client.wait(10.0)) == [] and fake.plan() == []

    fake = Px4()
    fake.load(waypoints(4))
    client = client_of(fake)
    client.say(client.count(3))
    answers = client.say(client.clear_all())
    assert missions(answers) == [] and words(answers) == ["WPM: IGN CLEAR CMD: Busy"]
    assert len(fake.plan()) == 4


def test_clear_all_types():
    for autopilot, result in ((ArduPilot, UNSUPPORTED), (Px4, ACCEPTED)):
        fake = autopilot()
        fake.load(waypoints(2))
        client = client_of(fake)
        assert missions(client.say(client.clear_all(ALL), wait_s=0.4)) \
            == ([("ACK", result)] if autopilot is ArduPilot else [])
        answers = client.wait(0.2)
        if autopilot is Px4:
            assert [(answer.type, answer.mission_type) for answer in answers] \
                == [(ACCEPTED, ALL)]
        assert (fake.plan() == []) == (autopilot is Px4)


@BOTH
@pytest.mark.parametrize("mission_type", [MISSION, FENCE, RALLY])
def test_clear_empties_only_the_type_it_names(autopilot, mission_type):
    fake = autopilot()
    plans = {MISSION: waypoints(2), FENCE: [item(5003, frame=0, param1=9.0, x=1, y=1)],
             RALLY: [item(5100, x=1, y=1, z=30.0)]}
    for kind, plan in plans.items():
        fake.load(plan, kind)
    client = client_of(fake)
    assert client.ask(client.clear_all(mission_type)).type == ACCEPTED
    assert [kind for kind in plans if not fake.plan(kind)] == [mission_type]


def test_fence_and_rally_need_a_mavlink_2_link_on_ardupilot():
    for mission_type in (FENCE, RALLY):
        client = client_of(ArduPilot(mavlink_version=1))
        for request in (client.count(1, mission_type), client.request_list(mission_type)):
            out = client.say(request)
            assert missions(out) == [("ACK", UNSUPPORTED)]
            assert words(out) == ["Need mavlink2 for item transfer"]


def test_partial_write_replaces_items_in_the_middle():
    fake = ArduPilot()
    old, new = waypoints(5), waypoints(2, first=70)
    fake.load(old)
    client = client_of(fake)
    partial = mavlink.MAVLink_mission_write_partial_list_message(1, 1, 2, 3)
    assert missions(client.say(partial)) == [("REQUEST", 2)]
    assert missions(client.say(client.item(new[0], 2))) == [("REQUEST", 3)]
    assert missions(client.say(client.item(new[1], 3))) == [("ACK", ACCEPTED)]
    assert fake.received() == old[:2] + new + old[4:]


@pytest.mark.parametrize("first, last", [(3, 2), (6, 6), (0, 9)])
def test_a_partial_write_out_of_the_plan_is_an_error(first, last):
    fake = ArduPilot()
    fake.load(waypoints(5))
    client = client_of(fake)
    answers = client.say(mavlink.MAVLink_mission_write_partial_list_message(1, 1, first, last))
    assert missions(answers) == [("ACK", ERROR)]
    assert words(answers) == ["Flight plan update rejected"]


def test_px4_knows_no_partial_write():
    fake = Px4()
    fake.load(waypoints(5))
    client = client_of(fake)
    assert client.say(mavlink.MAVLink_mission_write_partial_list_message(1, 1, 2, 3)) == []


def test_ardupilot_takes_current_2_and_3_for_orders():
    fake = ArduPilot()
    client = client_of(fake)
    for current in (2, 3):
        there = waypoints(1)[0]._replace(current=current)
        assert missions(client.say(client.item(there, 0))) == [("ACK", ACCEPTED)]
    assert [target.current for _, target in fake.guided_targets] == [2, 3]
    assert fake.plan() == []


def test_px4_proves_what_it_took_by_its_checksum():
    fake = Px4()
    client = client_of(fake)
    plan = waypoints(3)
    expected = 0
    for one in plan:
        expected = checksum(one, expected)
    client.say(client.count(3))
    client.say(client.item(plan[0], 0))
    client.say(client.item(plan[1], 1))
    assert client.ask(client.item(plan[2], 2)).opaque_id == expected != 0
    assert client.ask(client.request_list()).opaque_id == expected
    client.say(client.ack(ACCEPTED))
    client.wait(1.1)
    assert fake.messages("<", "MISSION_CURRENT")[-1].mission_id == expected
    ardupilot = client_of(ArduPilot())
    ardupilot.say(ardupilot.count(1))
    assert ardupilot.ask(ardupilot.item(plan[0], 0)).opaque_id == 0


def test_a_count_of_nine_bytes_is_taken_by_both():
    for autopilot in (ArduPilot, Px4):
        client = client_of(autopilot())
        message = mavlink.MAVLink_mission_count_message(1, 1, 2, MISSION, 0xFFFFFFFF)
        assert [seq for _, seq in missions(client.say(message))] == [0]


def test_an_unread_line_fills_with_repeated_requests():
    """Answering each of them draws INVALID_SEQUENCE on ArduPilot, nothing on PX4."""
    for autopilot, noise in ((ArduPilot, [INVALID_SEQUENCE] * 2), (Px4, [])):
        client = client_of(autopilot())
        plan = waypoints(2)
        client.say(client.count(2))
        client.wait(2.5)
        for _ in range(3):
            client.send(client.item(plan[0], 0))
        answers = missions(client.wait(0.05))
        assert [result for kind, result in answers if kind == "ACK"] == noise
        assert [seq for kind, seq in answers if kind != "ACK"] == [1]


# -- download --------------------------------------------------------------------------------


def test_ardupilot_serves_requests_in_any_order_to_anyone():
    fake = ArduPilot()
    fake.load(waypoints(4))
    client = client_of(fake)
    for seq in (3, 1, 1, 0):
        assert missions(client.say(client.request_int(seq))) == [("ITEM", seq)]
    assert missions(client.say(client.request_int(4))) == [("ACK", ERROR)]


def test_px4_serves_the_next_item_or_the_last_one_again():
    fake = Px4()
    fake.load(waypoints(4))
    client = client_of(fake)
    assert missions(client.say(client.request_int(0))) == []  # no download: silence
    client.say(client.request_list())
    for seq in (0, 0, 1, 1, 2):
        assert missions(client.say(client.request_int(seq))) == [("ITEM", seq)]
    answers = client.say(client.request_int(0))
    assert missions(answers) == [("ACK", ERROR)]
    assert words(answers) == ["WPM: REJ. CMD: Req. WP was unexpected"]


def test_px4_answers_a_request_list_for_an_empty_plan():
    client = client_of(Px4())
    assert missions(client.say(client.request_list())) == [("COUNT", 0)]


def test_px4_flags_its_current_item():
    fake = Px4()
    client = client_of(fake)
    plan = waypoints(3)
    plan[1] = plan[1]._replace(current=1)
    client.upload(plan)
    assert [one.current for one in client.download()] == [0, 1, 0]


# -- faults in the autopilot itself ----------------------------------------------------------


@BOTH
@pytest.mark.parametrize("result", [*range(1, 16), 200])
@pytest.mark.parametrize("step", ["count", 0, 1, 2, "end"])
def test_any_result_can_be_ordered_at_any_step_of_an_upload(autopilot, result, step):
    fake = autopilot()
    fake.faults.refuse(result, step)
    client = client_of(fake)
    assert client.upload(waypoints(3)) == result
    if autopilot is Px4:
        assert fake.received() == []
    assert client.upload(waypoints(3)) == ACCEPTED


@BOTH
def test_any_result_can_be_ordered_in_a_download_and_a_clear(autopilot):
    fake = autopilot()
    fake.load(waypoints(3))
    fake.faults.refuse(DENIED, "list")
    fake.faults.refuse(ERROR, ("read", 1))
    fake.faults.refuse(NO_SPACE, "clear")
    client = client_of(fake)
    assert missions(client.say(client.request_list())) == [("ACK", DENIED)]
    assert missions(client.say(client.request_list())) == [("COUNT", 3)]
    assert missions(client.say(client.request_int(0))) == [("ITEM", 0)]
    assert missions(client.say(client.request_int(1))) == [("ACK", ERROR)]
    assert missions(client.say(client.clear_all())) == [("ACK", NO_SPACE)]
    assert missions(client.say(client.clear_all())) == [("ACK", ACCEPTED)]


@BOTH
def test_it_falls_silent_from_a_time_on_for_a_while(autopilot):
    fake = autopilot()
    fake.faults.fall_silent(from_time=2.0, for_s=3.0)
    fake.run(10.0)
    times = [time for time, _ in fake.outbox]
    assert not [time for time in times if 2.0 <= time < 5.0]
    assert [time for time in times if time < 2.0] and [time for time in times if time >= 5.0]


@BOTH
@pytest.mark.parametrize("step, heard", [("count", 0), (0, 1), (1, 2)])
def test_it_falls_silent_from_a_step_on(autopilot, step, heard):
    fake = autopilot()
    fake.faults.fall_silent(step=step)
    client = client_of(fake)
    said = missions(client.say(client.count(3)))
    for seq in range(3):
        said += missions(client.say(client.item(waypoints(1)[0], seq)))
    assert len(said) == heard
    assert client.wait(20.0) == []
    with pytest.raises(ValueError, match="say when"):
        fake.faults.fall_silent()


@BOTH
def test_a_reboot_forgets_the_transfer_and_keeps_the_plan(autopilot):
    fake = autopilot(uptime_s=100)
    old = waypoints(3)
    fake.load(old)
    client = client_of(fake)
    client.say(client.count(3))
    fake.reboot(client.now, silent_for_s=4.0)
    assert missions(client.say(client.item(old[0], 0))) == []
    silent_until = fake.booted_at_s
    answers = client.wait(20.0)
    assert missions(answers) == []
    assert not [time for time, direction, _ in fake.log
                if direction == "<" and silent_until - 4.0 < time < silent_until]
    assert fake.received() == old
    assert client.upload(waypoints(2, first=8)) == ACCEPTED


@BOTH
def test_the_final_ack_can_be_swallowed_though_the_plan_is_aboard(autopilot):
    fake = autopilot()
    fake.faults.swallow_final_ack()
    client = client_of(fake)
    plan = waypoints(2)
    client.say(client.count(2))
    client.say(client.item(plan[0], 0))
    assert missions(client.say(client.item(plan[1], 1), wait_s=5.0)) == []
    assert fake.received() == plan
    assert client.upload(plan) == ACCEPTED


@BOTH
def test_the_final_ack_can_be_late(autopilot):
    fake = autopilot()
    fake.faults.delay_final_ack(0.7)
    client = client_of(fake)
    client.say(client.count(1))
    assert missions(client.say(client.item(waypoints(1)[0], 0), wait_s=0.7)) == []
    assert missions(client.wait(0.1)) == [("ACK", ACCEPTED)]


@BOTH
def test_items_can_be_asked_for_out_of_order(autopilot):
    fake = autopilot()
    fake.faults.request_instead(1, 2, 0)
    client = client_of(fake)
    client.say(client.count(3))
    asked = [seq for kind, seq in missions(client.say(client.item(waypoints(1)[0], 0), 4.0))
             if kind != "ACK"]
    assert asked[:3] == [2, 0, 1]


@BOTH
def test_the_same_item_can_be_asked_for_for_ever(autopilot):
    fake = autopilot()
    fake.faults.ask_for_ever(1)
    client = client_of(fake)
    client.say(client.count(3))
    client.say(client.item(waypoints(1)[0], 0))
    for _ in range(200):
        assert [seq for _, seq in missions(client.say(client.item(waypoints(1)[0], 1)))] == [1]


@BOTH
def test_every_item_can_be_acknowledged(autopilot):
    fake = autopilot()
    fake.faults.ack_every_item()
    client = client_of(fake)
    client.say(client.count(2))
    kinds = [kind for kind, _ in missions(client.say(client.item(waypoints(1)[0], 0)))]
    assert sorted(kinds)[0] == "ACK" and len(kinds) == 2


@BOTH
def test_it_can_be_told_to_take_only_float_items(autopilot):
    fake = autopilot()
    fake.faults.take_only_float_items()
    client = client_of(fake)
    client.say(client.count(1))
    assert missions(client.say(client.item(waypoints(1)[0], 0))) == [("ACK", UNSUPPORTED)]
    degrees = item(16, x=47.0, y=8.5, z=20.0)
    assert ("ACK", ACCEPTED) in missions(client.say(client.float_item(degrees, 0)))
    client.say(client.command(mavlink.MAV_CMD_REQUEST_MESSAGE, 148))
    capabilities = fake.messages("<", "AUTOPILOT_VERSION")[0].capabilities
    assert not capabilities & mavlink.MAV_PROTOCOL_CAPABILITY_MISSION_INT


# -- commands --------------------------------------------------------------------------------


@BOTH
def test_an_unknown_command_is_unsupported(autopilot):
    client = client_of(autopilot())
    assert command_results(client.say(client.command(31010))) \
        == [(31010, mavlink.MAV_RESULT_UNSUPPORTED)]


@BOTH
def test_a_command_int_is_answered_as_a_command_long(autopilot):
    fake = autopilot()
    fake.load(waypoints(3))
    client = client_of(fake)
    order = mavlink.MAVLink_command_int_message(1, 1, 0, SET_CURRENT, 0, 0, 2, 0, 0, 0, 0, 0, 0)
    assert command_results(client.say(order)) == [(SET_CURRENT, 0)]


def test_ardupilot_refuses_arming_for_30_seconds_and_says_why():
    fake = ArduPilot()
    client = client_of(fake)
    refused = client.say(client.command(ARM, 1))
    assert command_results(refused) == [(ARM, 4)]
    assert words(refused)[0].startswith("Arm: ")
    client.wait(30.0)
    assert command_results(client.say(client.command(ARM, 1))) == [(ARM, 0)]
    assert fake.armed and fake.heartbeat().base_mode & mavlink.MAV_MODE_FLAG_SAFETY_ARMED


def test_ardupilot_does_not_arm_in_auto():
    fake = ArduPilot(uptime_s=60, mode="AUTO")
    client = client_of(fake)
    answers = client.say(client.command(ARM, 1))
    assert command_results(answers) == [(ARM, 4)]
    assert words(answers) == ["Arm: Mode not armable"]


def test_set_mode_has_no_ack_on_ardupilot_and_one_on_px4():
    fake = ArduPilot()
    client = client_of(fake)
    answers = client.say(mavlink.MAVLink_set_mode_message(1, 1, 4))
    assert command_results(answers) == []
    assert fake.messages("<", "HEARTBEAT")[-1].custom_mode == 4
    fake = Px4()
    client = client_of(fake)
    answers = client.say(mavlink.MAVLink_set_mode_message(1, 1, 3 << 16))
    assert command_results(answers) == [(SET_MODE, 0)]
    assert fake.heartbeat().custom_mode == 3 << 16


def test_do_set_mode_takes_the_custom_mode_or_its_two_parts():
    fake = ArduPilot(vehicle="rover")
    client = client_of(fake)
    assert command_results(client.say(client.command(SET_MODE, 1, 15))) == [(SET_MODE, 0)]
    assert fake.mode == "GUIDED"
    assert command_results(client.say(client.command(SET_MODE, 1, 99))) == [(SET_MODE, 4)]
    fake = Px4()
    client = client_of(fake)
    assert command_results(client.say(client.command(SET_MODE, 1, 4, 5))) == [(SET_MODE, 0)]
    assert fake.heartbeat().custom_mode == 4 << 16 | 5 << 24


def test_auto_without_a_plan_is_refused():
    fake = ArduPilot()
    client = client_of(fake)
    answers = client.say(client.command(SET_MODE, 1, 3))
    assert command_results(answers) == [(SET_MODE, 4)] and fake.mode == "STABILIZE"
    client = client_of(Px4())
    assert command_results(client.say(client.command(START)))[0][1] != 0


def test_mission_start_is_accepted_disarmed_by_ardupilot_but_not_with_parameters():
    fake = ArduPilot()
    fake.load(waypoints(3))
    client = client_of(fake)
    assert command_results(client.say(client.command(START))) == [(START, 0)]
    assert fake.mode == "AUTO" and not fake.armed
    assert command_results(client.say(client.command(START, 1))) == [(START, 2)]


def test_set_current():
    for autopilot in (ArduPilot, Px4):
        fake = autopilot()
        fake.load(waypoints(4))
        client = client_of(fake)
        assert command_results(client.say(client.command(SET_CURRENT, 2))) == [(SET_CURRENT, 0)]
        client.wait(1.1)
        assert fake.messages("<", "MISSION_CURRENT")[-1].seq == 2
        assert command_results(client.say(client.command(SET_CURRENT, 4)))[0][1] != 0
        client.say(mavlink.MAVLink_mission_set_current_message(1, 1, 3), wait_s=1.1)
        assert fake.messages("<", "MISSION_CURRENT")[-1].seq == 3
        before = len(fake.messages("<", "MISSION_CURRENT"))
        answers = client.say(mavlink.MAVLink_mission_set_current_message(1, 1, 9))
        assert all(message.seq == 3 for message in
                   fake.messages("<", "MISSION_CURRENT")[before:])
        assert words(answers) == ([] if autopilot is ArduPilot
                                  else ["WPM: WP CURR CMD: Not in list"])


@BOTH
def test_a_message_can_be_asked_for_once_or_at_an_interval(autopilot):
    fake = autopilot()
    client = client_of(fake)
    ask = mavlink.MAV_CMD_REQUEST_MESSAGE
    assert command_results(client.say(client.command(ask, 33))) == [(ask, 0)]
    assert len(fake.messages("<", "GLOBAL_POSITION_INT")) == 1
    assert command_results(client.say(client.command(ask, 60000)))[0][1] != 0
    client.say(client.command(mavlink.MAV_CMD_SET_MESSAGE_INTERVAL, 33, 200_000))
    client.wait(2.0)
    assert 9 <= len(fake.messages("<", "GLOBAL_POSITION_INT")) - 1 <= 11
    client.say(client.command(mavlink.MAV_CMD_SET_MESSAGE_INTERVAL, 33, -1))
    before = len(fake.messages("<", "GLOBAL_POSITION_INT"))
    client.wait(2.0)
    assert len(fake.messages("<", "GLOBAL_POSITION_INT")) == before


# -- flight ----------------------------------------------------------------------------------

HOME_LAT, HOME_LON = -353632620, 1491652370


def square_for(autopilot) -> list[Item]:
    """Up, two waypoints, and back, from each one's home."""
    lat, lon = (HOME_LAT, HOME_LON) if autopilot is ArduPilot else (473977428, 85455937)
    plan = [item(22, x=lat, y=lon, z=8.0), item(16, x=lat + 1000, y=lon, z=8.0),
            item(16, x=lat + 1000, y=lon + 1000, z=8.0), item(RTL, frame=2)]
    return [item(16, frame=0, x=lat, y=lon), *plan] if autopilot is ArduPilot else plan


def flying(autopilot, **options) -> PlainClient:
    """A client of an autopilot that has just begun to fly the square."""
    fake = autopilot(uptime_s=60, **options)
    client = client_of(fake)
    assert client.upload(square_for(autopilot)) == ACCEPTED
    if autopilot is ArduPilot:
        client.say(mavlink.MAVLink_set_mode_message(1, 1, 4))
        client.say(client.command(ARM, 1))
        client.say(client.command(mavlink.MAV_CMD_SET_MESSAGE_INTERVAL, 42, 500_000))
    assert command_results(client.say(client.command(START))) == [(START, 0)]
    return client


@BOTH
def test_a_plan_is_flown_item_by_item_to_its_end(autopilot):
    client = flying(autopilot)
    fake = client.fake
    client.wait(120.0)
    reached = [message.seq for message in fake.messages("<", "MISSION_ITEM_REACHED")]
    once = [seq for seq, _ in itertools.groupby(reached)]
    assert once == ([1, 2, 3, 4] if autopilot is ArduPilot else [0, 1, 2, 3])
    if autopilot is ArduPilot:
        assert reached == once
    else:
        assert len(reached) > len(once)
    assert not fake.armed
    assert fake.messages("<", "MISSION_CURRENT")[-1].mission_state \
        == mavlink.MISSION_STATE_COMPLETE
    assert fake.flight.where(client.now).height == 0


def test_px4_repeats_the_last_item_reached_each_second_at_most_ten_times():
    fake = Px4()
    plan = [square_for(Px4)[0], item(17, x=473977428, y=85455937, z=8.0)]
    client = client_of(fake)
    client.upload(plan)
    client.say(client.command(START))
    client.wait(60.0)
    times = [time for time, _, message in fake.log
             if message.get_type() == "MISSION_ITEM_REACHED"]
    assert len(times) == 1 + 10
    intervals = [b - a for a, b in itertools.pairwise(times[1:])]
    assert intervals == pytest.approx([1.02] * 9)


def test_ardupilot_waits_on_the_ground_for_mission_start():
    fake = ArduPilot(uptime_s=60)
    client = client_of(fake)
    client.upload(square_for(ArduPilot))
    client.say(client.command(ARM, 1))
    client.say(client.command(SET_MODE, 1, 3))
    client.wait(30.0)
    assert not fake.flight.airborne(client.now)
    assert fake.messages("<", "MISSION_ITEM_REACHED") == []
    client.say(client.command(START))
    client.wait(10.0)
    assert [message.seq for message in fake.messages("<", "MISSION_ITEM_REACHED")] == [1]


def test_a_rover_flies_on_wheels():
    fake = ArduPilot(vehicle="rover", uptime_s=60)
    client = client_of(fake)
    client.upload([item(16, frame=0),
                   *(one._replace(z=0.0) for one in square_for(ArduPilot)[2:4])])
    client.say(client.command(ARM, 1))
    client.say(mavlink.MAVLink_set_mode_message(1, 1, 10))
    client.wait(60.0)
    assert [message.seq for message in fake.messages("<", "MISSION_ITEM_REACHED")] == [1, 2]


def test_jumps_are_flown_as_often_as_they_say():
    fake = Px4()
    plan = square_for(Px4)[:3] + [item(177, frame=2, param1=1, param2=2), item(RTL, frame=2)]
    client = client_of(fake)
    client.upload(plan)
    client.say(client.command(START))
    client.wait(200.0)
    reached = [seq for seq, _ in itertools.groupby(
        message.seq for message in fake.messages("<", "MISSION_ITEM_REACHED"))]
    assert reached == [0, 1, 2, 1, 2, 1, 2, 4]


def test_a_new_plan_in_flight():
    """ArduCopter keeps its leg, PX4 begins at the item flagged as current."""
    for autopilot, index in ((ArduPilot, 2), (Px4, 2)):
        client = flying(autopilot)
        fake = client.fake
        while not fake.messages("<", "MISSION_ITEM_REACHED"):
            client.wait(0.5)
        client.wait(1.0)
        plan = square_for(autopilot)
        plan[2] = plan[2]._replace(current=1, z=9.0)
        leg_ends = fake.flight.ends_at
        assert client.upload(plan) == ACCEPTED
        assert fake.flight.index == index
        assert (fake.flight.ends_at == leg_ends) == (autopilot is ArduPilot)


def test_a_rover_begins_its_leg_again_with_a_new_plan():
    fake = ArduPilot(vehicle="rover", uptime_s=60)
    client = client_of(fake)
    plan = [item(16, frame=0), *(one._replace(z=0.0) for one in square_for(ArduPilot)[2:4])]
    client.upload(plan)
    client.say(client.command(ARM, 1))
    client.say(mavlink.MAVLink_set_mode_message(1, 1, 10))
    client.wait(1.0)
    leg_ends = fake.flight.ends_at
    client.upload(plan)
    assert fake.flight.index == 1 and fake.flight.ends_at > leg_ends - 0.5
    assert fake.flight.ends_at != leg_ends


def test_the_same_plan_again_changes_nothing_on_px4():
    client = flying(Px4)
    client.wait(13.0)
    leg = (client.fake.flight.index, client.fake.flight.ends_at)
    assert client.upload(square_for(Px4)) == ACCEPTED
    assert (client.fake.flight.index, client.fake.flight.ends_at) == leg


def test_ardupilot_refuses_to_clear_the_plan_it_is_flying():
    client = flying(ArduPilot)
    assert missions(client.say(client.clear_all())) == [("ACK", ERROR)]
    assert len(client.fake.plan()) == 5


def test_arming_again_in_the_air_is_accepted_and_disarming_is_not():
    for autopilot in (ArduPilot, Px4):
        client = flying(autopilot)
        client.wait(12.0)
        assert command_results(client.say(client.command(ARM, 1))) == [(ARM, 0)]
        assert command_results(client.say(client.command(ARM, 0)))[0][1] != 0
        assert client.fake.armed


def test_another_mode_pauses_the_plan():
    client = flying(Px4)
    client.wait(13.0)
    client.say(client.command(SET_MODE, 1, 4, 3))
    client.wait(2.0)
    current = client.fake.messages("<", "MISSION_CURRENT")[-1]
    assert (current.mission_state, current.mission_mode) \
        == (mavlink.MISSION_STATE_PAUSED, 2)
    assert client.fake.flight.index is None
    client.say(client.command(SET_MODE, 1, 4, 4))
    client.wait(60.0)
    assert client.fake.messages("<", "MISSION_ITEM_REACHED")[-1].seq == 3


@pytest.mark.parametrize("change, why", [
    (lambda plan: [plan[1], plan[0], *plan[2:]],
     "Mission rejected: takeoff not first waypoint item"),
    (lambda plan: [item(21, x=1, y=1), *plan], "Mission rejected: starts with landing"),
    (lambda plan: [plan[0]._replace(z=-5.0), *plan[1:]],
     "Mission rejected: Takeoff altitude below home altitude!")])
def test_px4_accepts_a_plan_and_then_will_not_fly_it(change, why):
    fake = Px4()
    client = client_of(fake)
    assert client.upload(change(square_for(Px4))) == ACCEPTED
    assert words(client.wait(0.1)) == []
    assert [text.text.strip() for text in fake.messages("<", "STATUSTEXT")] == [why]
    client.wait(1.1)
    assert fake.messages("<", "MISSION_CURRENT")[-1].mission_state \
        == mavlink.MISSION_STATE_NO_MISSION
    assert command_results(client.say(client.command(START)))[0][1] != 0
    assert not fake.armed


def test_px4_can_require_a_takeoff():
    fake = Px4(takeoff_required=True)
    client_of(fake).upload(waypoints(2))
    assert fake.objection == "Mission rejected: Takeoff waypoint required."
    relaxed = Px4()
    client_of(relaxed).upload(waypoints(2))
    assert relaxed.objection is None


@BOTH
def test_bad_options_are_refused_in_words(autopilot):
    with pytest.raises(ValueError, match="copter, plane, rover"):
        autopilot(vehicle="submarine")
    with pytest.raises(ValueError, match="1 or 2"):
        autopilot(mavlink_version=3)
    with pytest.raises(ValueError, match="item 1 would be refused"):
        autopilot().load([*waypoints(1), item(31000)])


HEARD = ("mission_count", "mission_item_int", "mission_item", "mission_ack",
         "mission_request_list", "mission_request_int", "mission_request", "mission_clear_all",
         "mission_set_current", "mission_write_partial_list", "command_long", "command_int",
         "set_mode", "request_data_stream")
ODD_FLOATS = (0.0, 1.0, -1.0, 3.0, 33.0, 42.0, NAN, math.inf, -math.inf, 1e30, -1e30)
COMMANDS = (16, 17, 18, 19, 20, 21, 22, 31, 93, 177, 201, 203, 5001, 5003, 5100,
            START, ARM, SET_MODE, SET_CURRENT, 511, 512)


def odd_message(chance: random.Random):
    """A message an autopilot listens to, with anything in it that might go wrong."""
    kind = getattr(mavlink, f"MAVLink_{chance.choice(HEARD)}_message")
    choices = {"target_system": (1,), "target_component": (1,), "command": COMMANDS,
               "mission_type": (MISSION, MISSION, FENCE, RALLY, ALL, 7),
               "seq": (0, 0, 1, 1, 2, 3), "count": (0, 1, 2, 3), "frame": (0, 2, 3, 5, 6)}
    return kind(*(chance.choice(choices.get(
        name, ODD_FLOATS if of_type == "float" else (0, 1, 2, 4)))
        for name, of_type in zip(kind.fieldnames, kind.fieldtypes)))


@BOTH
@pytest.mark.parametrize("seed", range(5))
def test_nothing_a_client_sends_makes_the_autopilot_fail_or_stall(autopilot, seed):
    chance = random.Random(seed)
    for _ in range(100):
        client = client_of(autopilot(uptime_s=60))
        for _ in range(12):
            client.say(odd_message(chance), wait_s=chance.choice((0.02, 0.3, 2.0)))
        for mission_type in (MISSION, FENCE, RALLY):
            client.fake.plan(mission_type)
        assert client.fake.next_event(client.now) <= client.now + 1.02
