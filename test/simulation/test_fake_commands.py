"""How the fake autopilots answer commands."""

from __future__ import annotations

from fake_talk import ARM, BOTH, SET_MODE, START, client_of, command_results, waypoints, words
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


def test_mission_start_is_accepted_disarmed_by_ardupilot_but_not_with_parameters():
    fake = ArduPilot()
    fake.load(waypoints(3))
    client = client_of(fake)
    assert command_results(client.say(client.command(START))) == [(START, 0)]
    assert fake.mode == "AUTO" and not fake.armed
    assert command_results(client.say(client.command(START, 1))) == [(START, 2)]


def currents(fake) -> list[int]:
    return [message.seq for message in fake.messages("<", "MISSION_CURRENT")]


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
