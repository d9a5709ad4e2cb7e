"""How the fake autopilots answer commands."""

from __future__ import annotations

from fake_talk import ARM, BOTH, SET_CURRENT, SET_MODE, START, client_of, command_results, waypoints, words
from simulation.fake_autopilot import ArduPilot, Px4, mavlink


@BOTH
def test_an_unknown_command_is_unsupported(autopilot):
    client = client_of(autopilot())
    assert command_results(client.say(client.command(31010))) \
        == [(31010, mavlink.MAV_RESULT_UNSUPPORTED)]


@BOTH
def test_a_command_int_is_answered_as_a_command_long(autopilot):
    fake = autopilot(uptime_s=60)
    client = client_of(fake)
    order = mavlink.MAVLink_command_int_message(1, 1, 0, ARM, 0, 0, 1, 0, 0, 0, 0, 0, 0)
    assert command_results(client.say(order)) == [(ARM, 0)]
    assert fake.armed


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
    assert words(answers) == ["Arm: AUTO mode not armable"]


def test_a_copter_disarms_itself_after_10_seconds_on_the_ground_and_is_rewound():
    fake = ArduPilot(uptime_s=60, mode="GUIDED")
    fake.load(waypoints(3))
    client = client_of(fake)
    client.say(mavlink.MAVLink_mission_set_current_message(1, 1, 2))
    client.say(client.command(ARM, 1))
    client.wait(9.8)
    assert fake.armed and fake.current == 2
    assert words(client.wait(0.4)) == ["Disarming motors"]
    assert not fake.armed and fake.current == 0


def test_a_rover_is_armed_ten_seconds_before_auto_is_to_be_had():
    fake = ArduPilot(vehicle="rover", uptime_s=30)
    fake.load(waypoints(3))
    client = client_of(fake)
    assert command_results(client.say(client.command(ARM, 1))) == [(ARM, 0)]
    refused = client.say(client.command(SET_MODE, 1, 10))
    assert command_results(refused) == [(SET_MODE, 4)]
    assert words(refused) == ["Flight mode change failed"]
    client.wait(9.0)
    assert command_results(client.say(client.command(SET_MODE, 1, 10))) == [(SET_MODE, 0)]


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
    assert command_results(client.say(client.command(SET_MODE, 1, 4, 5))) == [(SET_MODE, 0)] * 2
    assert fake.heartbeat().custom_mode == 4 << 16 | 5 << 24


def test_px4_accepts_a_mode_first_and_refuses_it_then():
    fake = Px4(armed=True)
    client = client_of(fake)
    answers = client.say(client.command(SET_MODE, 1, 4, 4))
    assert command_results(answers) == [(SET_MODE, 0), (SET_MODE, 1)]
    assert words(answers) == ["Switching to Mission is currently not available"]
    assert fake.heartbeat().custom_mode == 4 << 16 | 3 << 24


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


def currents(fake) -> list[int]:
    return [message.seq for message in fake.messages("<", "MISSION_CURRENT")]


def test_ardupilot_answers_a_set_current_at_once_and_one_beyond_the_plan_never():
    fake = ArduPilot()
    fake.load(waypoints(4))
    client = client_of(fake)
    for asked, told in ((3, [3]), (4, []), (0, [0]), (9, [])):
        before = len(currents(fake))
        assert client.say(mavlink.MAVLink_mission_set_current_message(1, 1, asked)) == []
        assert currents(fake)[before:] == told
    assert fake.current == 1
    for asked, result, told in ((2, 0, [2]), (4, 2, []), (-1, 2, []), (0, 0, [1])):
        before = len(currents(fake))
        assert command_results(client.say(client.command(SET_CURRENT, asked))) == [(SET_CURRENT, result)]
        assert currents(fake)[before:] == told


def test_px4_tells_of_a_set_current_within_its_second_and_knows_no_command_for_it():
    fake = Px4()
    fake.load(waypoints(4))
    client = client_of(fake)
    assert command_results(client.say(client.command(SET_CURRENT, 2))) == [(SET_CURRENT, 3)]
    before = len(currents(fake))
    client.say(mavlink.MAVLink_mission_set_current_message(1, 1, 3), wait_s=0.3)
    assert len(currents(fake)) == before
    client.wait(0.8)
    assert currents(fake)[before:] == [3]
    answers = client.say(mavlink.MAVLink_mission_set_current_message(1, 1, 9))
    assert words(answers) == ["WPM: WP CURR CMD: Not in list"]
    assert fake.missions.current == 3


@BOTH
def test_the_current_item_stays_over_an_upload_and_goes_with_the_plan(autopilot):
    fake = autopilot()
    client = client_of(fake)
    client.upload(waypoints(5))
    client.say(mavlink.MAVLink_mission_set_current_message(1, 1, 3))
    client.upload(waypoints(5, first=10))
    client.wait(1.1)
    ask = mavlink.MAV_CMD_REQUEST_MESSAGE
    client.say(client.command(ask, 42))
    assert currents(fake)[-1] == 3
    client.say(client.clear_all())
    client.wait(1.1)
    client.say(client.command(ask, 42))
    assert currents(fake)[-1] == 0


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
