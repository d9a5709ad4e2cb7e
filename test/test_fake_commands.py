"""How the fake autopilots answer commands."""

from __future__ import annotations

from fake_autopilot import ArduPilot, Px4, mavlink
from fake_talk import ARM, BOTH, SET_CURRENT, SET_MODE, START, client_of, command_results, waypoints, words


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
