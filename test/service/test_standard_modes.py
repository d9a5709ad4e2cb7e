"""Modes by their standard names, and the autopilot's list of modes."""

from __future__ import annotations

import pytest

from simulation.fake_autopilot import mavlink
from simulation.fake_autopilot.px4 import AUTO, MODES, STANDARD_MODES, SUB_LAND, SUB_RTL, custom_mode
from simulation.modes import ModeBench

LAND, SAFE_RECOVERY, CRUISE = 7, 5, 3
SET = mavlink.MAV_CMD_DO_SET_STANDARD_MODE
ASK = mavlink.MAV_CMD_REQUEST_MESSAGE


@pytest.fixture
def px4():
    return ModeBench("PX4")


def commands(bench: ModeBench, identity: int) -> list:
    return [message for message in bench.heard("COMMAND_LONG") if message.command == identity]


@pytest.mark.parametrize("mode", STANDARD_MODES)
def test_each_standard_mode_is_set_and_shown(px4, mode):
    assert px4.order("set", mode) == "Done"
    assert (px4.autopilot.main_mode, px4.autopilot.sub_mode) == STANDARD_MODES[mode]
    assert px4.entry.current == mode
    (order,) = commands(px4, SET)
    assert order.param1 == mode


def test_mode_that_this_aircraft_does_not_have_is_refused(px4):
    before = (px4.autopilot.main_mode, px4.autopilot.sub_mode)
    assert px4.order("set", CRUISE) == "CommandFailed"
    assert (px4.autopilot.main_mode, px4.autopilot.sub_mode) == before


def test_mode_that_cannot_be_set_now_is_rejected(px4):
    px4.autopilot.armed = True  # and there is no plan
    assert px4.order("set", mavlink.MAV_STANDARD_MODE_MISSION) == "CommandRejected"


def test_mode_is_not_done_before_the_autopilot_shows_it(px4):
    px4.run(2.0)
    px4.wire.delay("<", 1.0, name="CURRENT_MODE")
    begun = px4.now
    assert px4.order("set", LAND) == "Done"
    assert px4.now - begun > 1.0


def test_mode_that_was_left_at_once_is_not_called_set(px4):
    px4.run(2.0)
    px4.begin("set", LAND)
    while not commands(px4, SET):
        px4.run(0.005)
    while px4.autopilot.sub_mode != SUB_LAND:
        px4.run(0.001)
    px4.autopilot._set_mode(AUTO, SUB_RTL, px4.now)  # a pilot, or a failsafe
    begun = px4.now
    assert px4.run_until_ended(limit_s=20) == "Unconfirmed"
    assert 4.0 < px4.now - begun < 6.5
    assert px4.entry.current == SAFE_RECOVERY


def test_mode_is_unconfirmed_where_a_board_does_not_tell_its_mode(px4):
    px4.autopilot.has_standard_messages = False
    assert px4.order("set", LAND) == "Unconfirmed"
    assert px4.autopilot.sub_mode == SUB_LAND


@pytest.mark.parametrize("name", ["COMMAND_LONG", "COMMAND_ACK", "CURRENT_MODE"])
@pytest.mark.parametrize("which", [0, 1])
def test_lost_frame_is_made_up_for(px4, name, which):
    px4.run(2.0)
    px4.wire.lose(">" if name == "COMMAND_LONG" else "<", name=name, index=which)
    assert px4.order("set", LAND) == "Done"
    assert px4.autopilot.sub_mode == SUB_LAND


def test_list_of_modes_is_read(px4):
    for number, (mode, name, can_be_set) in enumerate(MODES, 1):
        assert px4.order("read", number) == "Done"
        standard = {value: key for key, value in STANDARD_MODES.items()}.get(mode, 0)
        assert px4.entry == (standard, len(MODES), custom_mode(*mode), can_be_set, 0, name)


def test_mode_of_the_list_can_be_set(px4):
    number = [name for _, name, _ in MODES].index("Hold") + 1
    assert px4.order("read", number) == "Done"
    assert px4.order("custom") == "Done"
    assert (px4.autopilot.main_mode, px4.autopilot.sub_mode) == MODES[number - 1][0]


@pytest.mark.parametrize("number", [0, len(MODES) + 1, 255])
def test_list_has_an_end(px4, number):
    assert px4.order("read", number) == "CommandDenied"
    assert px4.entry.count == 0


def test_entry_for_another_client_is_not_taken(px4):
    px4.run(2.0)
    px4.wire.delay("<", 0.5, name="AVAILABLE_MODES")
    px4.begin("read", 2)
    px4.run(0.2)
    px4.say(mavlink.MAVLink_available_modes_message(9, 3, 0, 77, 0, b"another"))
    px4.run(0.1)
    assert px4.ends == []
    assert px4.run_until_ended(limit_s=5) == "Done"
    assert px4.entry.custom == custom_mode(*MODES[1][0])


def test_mode_of_another_autopilot_is_not_taken(px4):
    px4.run(2.0)
    px4.say(mavlink.MAVLink_current_mode_message(LAND, 1, 1), (1, 200))
    px4.run(0.1)
    assert px4.entry.current == 0


def test_list_of_a_board_that_has_none_is_denied(px4):
    px4.autopilot.has_standard_messages = False
    assert px4.order("read", 1) == "CommandDenied"


def test_lost_entry_is_asked_for_again(px4):
    px4.run(2.0)
    px4.wire.lose("<", name="AVAILABLE_MODES")
    assert px4.order("read", 1) == "Done"
    assert len(commands(px4, ASK)) == 2


def test_ardupilot_has_no_standard_modes():
    bench = ModeBench("ArduPilot")
    mode = bench.autopilot.mode
    assert bench.order("set", LAND) == "CommandUnsupported"
    assert bench.order("read", 1) == "CommandFailed"
    assert bench.autopilot.mode == mode


def test_list_of_a_newer_ardupilot_is_read_and_its_modes_are_no_standard_ones():
    """As ArduCopter 4.8-dev: each has its own number and a name. A number beyond the list is accepted in silence."""
    bench = ModeBench("ArduPilot", lists_modes=True)
    modes = bench.autopilot.kind.modes
    for number, (name, custom) in enumerate(modes.items(), 1):
        assert bench.order("read", number) == "Done"
        assert bench.entry == (0, len(modes), custom, True, 0, name)
    assert bench.order("read", len(modes) + 1) == "Unconfirmed"
    assert bench.order("set", LAND) == "CommandUnsupported"
    assert bench.order("read", list(modes).index("GUIDED") + 1) == "Done"
    assert bench.order("custom") == "Done"
    assert bench.autopilot.mode == "GUIDED"


def test_nothing_is_sent_over_mavlink_1():
    bench = ModeBench("ArduPilot", mavlink_version=1)
    assert bench.order("set", LAND) == "NeedsMavlink2"
    assert bench.order("read", 1) == "NeedsMavlink2"
    assert bench.heard("COMMAND_LONG") == []


def test_standard_mode_is_ordered_right_behind_a_heartbeat_each_time(px4):
    px4.run(2.0)
    px4.wire.lose(">", name="COMMAND_LONG", times=2, where=lambda message: message.command == SET)
    assert px4.order("set", LAND) == "Done"
    sent = [entry.time for entry in px4.wire.frames(">", "COMMAND_LONG") if entry.message.command == SET]
    heartbeats = [entry.time for entry in px4.wire.frames("<", "HEARTBEAT")]
    assert len(sent) == 3
    assert all(any(0 < time - beat < 0.03 for beat in heartbeats) for time in sent)


@pytest.mark.parametrize("at_ms", [1, 3, 5])
def test_standard_mode_does_not_overrule_a_pilot_who_was_sooner(px4, at_ms):
    px4.run(2.0)
    px4.begin("set", LAND)
    px4.run(at_ms / 1000)
    assert not commands(px4, SET)
    px4.autopilot._set_mode(3, 0, px4.now)  # POSITION
    assert px4.run_until_ended(limit_s=20) == "TakenOver"
    assert not commands(px4, SET) and px4.autopilot.main_mode == 3


def test_standard_mode_is_not_ordered_again_when_another_one_is_shown(px4):
    px4.run(2.0)
    px4.wire.lose("<", name="COMMAND_ACK", where=lambda message: message.command == SET)
    px4.begin("set", LAND)
    while px4.autopilot.sub_mode != SUB_LAND:
        px4.run(0.001)
    px4.autopilot._set_mode(3, 0, px4.now)  # POSITION
    assert px4.run_until_ended(limit_s=20) == "Unconfirmed"
    assert len(commands(px4, SET)) == 1 and px4.autopilot.main_mode == 3
