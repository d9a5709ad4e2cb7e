"""Each example, as it is, on a simulated Mega beside a fake autopilot: what it prints, and what is aboard then."""

from __future__ import annotations

import pytest

from example_runs import SLICE_S, Run, commands, is_ardupilot
from plans import HOME, NAN, jump, waypoint
from simulation.fake_autopilot import FENCE, MISSION, RALLY, mavlink

QUIET = "all is well; the autopilot sends little unasked: setMessageInterval() asks for more"


@pytest.fixture
def run(personality):
    return lambda example, **options: Run(example, personality, **options)


@pytest.fixture
def make_run_on_rover():
    return lambda example: Run(example, "ArduPilot", vehicle="rover", uptime_s=120.0)


LED = 0x25, 1 << 7  # pin 13 of a Mega: PORTB, bit 7


def blinks(example: Run, seconds: float) -> int:
    """How often the board's LED is switched on."""
    until, was_on, found = example.now + seconds, False, 0
    while example.now < until:
        example.run(SLICE_S)
        is_on = bool(example.mega.peek_int(LED[0]) & LED[1])
        found += is_on and not was_on
        was_on = is_on
    return found


def test_upload_mission_blinks_slowly_when_the_plan_is_aboard(run):
    example = run("UploadMission")
    example.is_heard = False
    assert blinks(example, 3.0) == 0  # nobody answers: it has not ended
    example.is_heard = True
    example.run(4.0)
    assert commands(example) == [22, 16, 16, 20]
    assert blinks(example, 8.192) == 4


def test_upload_mission_blinks_fast_when_it_fails(run):
    example = run("UploadMission", armed=True)
    example.run(3.0)
    assert commands(example) == []
    assert 30 <= blinks(example, 8.192) <= 33


PIN_4 = 0x34, 1 << 5  # of a Mega: PORTG, bit 5


def lit(example: Run, seconds: float) -> list[bool]:
    """Whether the LED on pin 4 is lit, every 2 ms."""
    until, found = example.now + seconds, []
    while example.now < until:
        example.run(SLICE_S)
        found.append(bool(example.mega.peek_int(PIN_4[0]) & PIN_4[1]))
    return found


def rises(levels: list[bool]) -> int:
    return sum(now and not before for before, now in zip(levels, levels[1:], strict=False))


def test_fit_light_tells_whether_the_aircraft_is_fit(run):
    example = run("FitLight")
    example.is_plugged = False
    assert not any(lit(example, 2.0))
    example.is_plugged = True
    example.run(6.0)
    assert all(lit(example, 2.0))
    instruments = example.autopilot.instruments
    instruments.flags = 0x00A7
    example.run(2.0)
    assert 3 <= rises(lit(example, 4.0)) <= 4
    instruments.vibration = [50.0, 50.0, 50.0]
    example.run(2.0)
    assert 15 <= rises(lit(example, 4.0)) <= 17
    example.autopilot.send_raw(
        mavlink.MAVLink_statustext_message(4, b"PreArm: Compass not healthy").pack(example.autopilot._packer),
        example.now)  # fmt: skip
    example.run(0.2)
    told = [line for line in example.lines if not line.startswith("autopilot: ")]
    assert told[-3:] == ["fit: all is well", "not yet fit: no position yet", "unfit: strong vibration"]
    assert "autopilot: PreArm: Compass not healthy" in example.lines


def test_upload_with_progress(run):
    example = run("UploadWithProgress")
    lines = example.until("aboard: our plan, whole", 5.0)
    assert lines[:8] == ["upload, try 1", "1/6", "2/6", "3/6", "4/6", "5/6", "6/6", "accepted: the plan is aboard"]
    example.run(0.2)
    assert example.lines[-1].startswith("bytes ") and ", bad checksums 0, frames lost 0," in example.lines[-1]
    assert commands(example) == [22, 16, 93, 16, 177, 20]


@pytest.mark.slow
def test_grid_from_function(run):
    example = run("GridFromFunction")
    example.run(12.0)
    assert commands(example) == [22, *[16] * 300, 20]
    lanes = [one for one in example.autopilot.received() if one.command == 16][-300:]
    assert len({(one.x, one.y) for one in lanes}) == 300
    assert {one.y for one in lanes} == {1491652374, 1491652374 + 11003}  # 100 m at this latitude, on WGS 84


def test_download_mission(run):
    example = run("DownloadMission")
    plan = [waypoint(-353632621, 1491652374, 20.0, param4=NAN), waypoint(-5, -1799999999, 20.5, frame=0, param4=NAN),
            jump(0 + is_ardupilot(example), 3)]  # fmt: skip
    example.autopilot.load([HOME, *plan] if is_ardupilot(example) else plan)
    lines = example.until("downloaded: the plan has been read", 5.0)
    home = ["home: command 16 at -35.3632621 149.1652374 584.00 m above sea level"] if is_ardupilot(example) else []
    assert lines == [
        *home,
        "0: command 16 at -35.3632621 149.1652374 20.00 m above home",
        "1: command 16 at -0.0000005 -179.9999999 20.50 m above sea level",
        "2: command 177, param1 0.00, param2 3.00",
        "downloaded: the plan has been read",
    ]


def test_verify_upload(run):
    example = run("VerifyUpload")
    lines = example.until("aboard: our plan, whole", 5.0)
    assert lines == ["accepted: the plan is aboard", "aboard: our plan, whole"]
    assert commands(example) == [22, 16, 178, 16, 21]
    assert len(example.autopilot.messages(">", "MISSION_REQUEST_LIST")) == 1


def test_upload_by_file(run, personality):
    example = run("UploadByFile")
    lines = example.until("aboard: our plan, whole", 6.0)
    way = "by file" if is_ardupilot(example) else "item by item"
    assert lines == ["accepted: the plan is aboard", way, "aboard: our plan, whole"]
    assert commands(example) == [22, 16, 178, 16, 21]


@pytest.mark.slow
def test_verify_upload_says_what_differs(run):
    example = run("VerifyUpload")
    while not example.autopilot.messages(">", "MISSION_REQUEST_LIST"):
        example.run(SLICE_S)
        assert example.now < 5
    missions = example.autopilot.missions
    held = missions[MISSION].held if is_ardupilot(example) else missions.held[MISSION]
    held[-2] = held[-2]._replace(y=held[-2].y + 1)
    example.until("item 3: y (longitude)", 5.0)
    assert example.lines[0] == "what is aboard is not the plan"


def test_ensure_mission_uploads_once_and_looks_at_the_next_power_on(run, personality):
    example = run("EnsureMission")
    lines = example.until("aboard: our plan, whole", 5.0)
    assert lines == ["accepted: the plan is aboard", "aboard: our plan, whole"]
    assert commands(example) == [22, 16, 16, 20]
    held = example.autopilot.received()
    again = run("EnsureMission")
    again.autopilot.load(held)
    lines = again.until("aboard: our plan, whole", 5.0)
    assert lines == ["already aboard: nothing was uploaded", "aboard: our plan, whole"]
    assert again.autopilot.messages(">", "MISSION_COUNT") == []


def test_ensure_mission_says_early_what_is_missing():
    """A cable that is cut at power-on, then one of which only our TX is cut."""
    example = Run("EnsureMission", "ArduPilot")
    example.is_plugged = False
    example.until("no bytes come: look at the wire from its TX to our RX, and at GND", 6.0)
    example.is_plugged = True
    example.is_heard = False
    example.until("waiting: if this stays, look at the wire from our TX to its RX", 7.0)
    assert not any(line.startswith("aboard: our plan") for line in example.lines)


def test_ensure_mission_changes_nothing_in_flight(run):
    example = run("EnsureMission", armed=True)
    example.autopilot.load([waypoint(), waypoint(), waypoint(z=30.0)])
    held = example.autopilot.received()
    example.until("aboard: not known", 5.0)
    assert example.lines[0] == "refused: the autopilot is armed"
    example.run(10.0)
    assert example.autopilot.received() == held
    assert example.autopilot.messages(">", "MISSION_COUNT") == []


@pytest.mark.slow
def test_start_mission(run):
    example = run("StartMission")
    lines = example.until("landed", 240.0)
    own = [line for line in lines if not line.startswith("autopilot: ")]
    assert [line for line in own if line != "reached 3"] == [
        "accepted: the plan is aboard", "done: the autopilot confirmed it", "reached 0", "reached 1", "reached 2",
        "landed"]  # fmt: skip
    assert commands(example) == [22, 16, 16, 21]
    assert not example.autopilot.armed
    assert len(example.autopilot.messages(">", "MISSION_COUNT")) == 1


@pytest.mark.slow
def test_start_mission_ends_on_a_rover_which_stays_armed(make_run_on_rover):
    example = make_run_on_rover("StartMission")
    example.until("arrived: disarm", 240.0)
    example.run(2.0)
    own = [line for line in example.lines if not line.startswith("autopilot: ")]
    assert "autopilot: Mission Complete" in example.lines
    assert own[0] == "accepted: the plan is aboard" and own.count("done: the autopilot confirmed it") == 2
    assert own[-2:] == ["arrived: disarm", "done: the autopilot confirmed it"]
    assert not example.autopilot.armed


@pytest.mark.slow
def test_start_mission_that_is_refused_auto_says_that_it_is_disarmed():
    example = Run("StartMission", "ArduPilot")
    example.autopilot._begins_with_takeoff = lambda: False
    lines = example.until("the mission could not begin: disarmed again", 30.0)
    assert "autopilot: Auto: Missing Takeoff Cmd" in lines
    assert not example.autopilot.armed


@pytest.mark.slow
def test_start_mission_waits_until_arming_is_allowed(personality):
    if personality == "PX4":
        example = Run("StartMission", personality)
        example.until("reached 0", 60.0)
        return
    example = Run("StartMission", personality, uptime_s=0.0)
    lines = example.until("done: the autopilot confirmed it", 60.0)
    assert "autopilot: Arm: AHRS: waiting for home" in lines
    assert lines.count("autopilot: failed") >= 3


@pytest.mark.slow
@pytest.mark.scenario(48, "Changing the plan while armed is refused unless allowed")
def test_start_mission_that_resets_in_flight_changes_nothing(run):
    example = run("StartMission")
    example.until("reached 0", 60.0)
    plan = example.autopilot.received()
    said = len(example.autopilot.messages(">"))
    example.mega.reset()
    example.until("refused: the autopilot is armed", 5.0)
    example.run(10.0)
    after = example.autopilot.messages(">")[said:]
    assert {message.get_type() for message in after} == {"HEARTBEAT"}
    assert example.autopilot.received() == plan and example.autopilot.armed


BUTTON = 0x2C, 1 << 4  # pin 2 of a Mega: PINE, bit 4


def press(example: Run, *, button: tuple[int, int] = BUTTON, is_down: bool = True) -> None:
    place, bit = button
    pins = example.mega.peek_int(place)
    example.mega.poke_int(place, pins & ~bit if is_down else pins | bit)


def test_start_button_that_is_held_for_two_seconds_starts_the_mission(run):
    example = run("StartButton")
    example.until("accepted: the plan is aboard", 6.0)
    example.run(4.0)
    press(example)
    example.run(1.8)
    assert "start" not in example.lines and not example.autopilot.armed
    press(example, is_down=False)
    example.run(0.1)
    press(example)
    example.run(1.8)
    assert "start" not in example.lines and not example.autopilot.armed
    example.until("done: the autopilot confirmed it", 20.0)
    assert example.lines.count("start") == 1 and example.autopilot.armed


def test_start_button_that_is_stuck_or_pressed_in_flight_after_a_reset_starts_nothing(run):
    example = run("StartButton")
    for _ in range(1000):  # also after pinMode(), whose pull-up the simulated pin follows
        example.mega.run_until(example.mega.cycle + 64)
        press(example)
    example.run(8.0)
    assert "start" not in example.lines
    press(example, is_down=False)
    example.run(0.1)
    press(example)
    example.until("done: the autopilot confirmed it", 20.0)
    plan = example.autopilot.received()
    example.mega.reset()
    example.until("refused: the autopilot is armed", 6.0)
    press(example, is_down=False)
    example.run(0.1)
    press(example)
    example.run(6.0)
    assert example.lines.count("start") == 2
    assert example.lines.count("refused: the autopilot is armed") + example.lines.count(
        "refused: the plan aboard may not be ours") == 2  # fmt: skip
    assert example.lines.count("done: the autopilot confirmed it") == 1
    assert example.autopilot.received() == plan


@pytest.mark.slow
def test_next_waypoint(run):
    example = run("NextWaypoint")
    lines = example.until("all fields sampled", 400.0)
    own = [line for line in lines if not line.startswith("autopilot: ")]
    leg = ["accepted: the plan is aboard", "done: the autopilot confirmed it", "landed: sampling"]
    assert own == [*leg, *leg, "all fields sampled"]
    assert not example.autopilot.armed
    here = example.autopilot.flight.where(example.now)
    assert (here.lat_e7, here.lon_e7) == (-353631000, 1491654000)


def test_fence_and_rally(run):
    example = run("FenceAndRally")
    lines = example.until("rally: accepted: the plan is aboard", 6.0)
    assert lines == ["fence: accepted: the plan is aboard", "rally: accepted: the plan is aboard"]
    assert commands(example, FENCE) == [5001] * 4 + [5004]
    assert commands(example, RALLY) == [5100] * 2
    assert commands(example) == []


def test_read_telemetry(run):
    example = run("ReadTelemetry")
    example.run(11.0)
    positions = [line for line in example.lines if "1e-7 deg" in line]
    assert 9 <= len(positions) <= 11
    assert set(positions) == {"-353632621 1491652374 (1e-7 deg), 0 m above home, 0 cm/s"}
    volts = example.autopilot.instruments.volts
    assert example.lines.count(f"{round(1000 * volts)} mV, 100 % left") == 2
    assert example.lines.count("10 satellites") == 2


def test_check_parameters():
    example = Run("CheckParameters", "ArduPilot")
    lines = example.until("MIS_RESTART: 1.00 done: the autopilot confirmed it", 10.0)
    assert lines == ["SERIAL1_BAUD: 57.00 done: the autopilot confirmed it",
                     "FENCE_ENABLE: 0.00 done: the autopilot confirmed it",
                     "MIS_RESTART: 1.00 done: the autopilot confirmed it"]  # fmt: skip
    assert example.autopilot.parameters.value("MIS_RESTART") == 1


def test_payload_winch(run):
    example = run("PayloadWinch")
    example.run(2.0)
    winch = mavlink.MAVLink_command_long_message(1, 0, 42600, 0, 1, 1, 3.5, 0.5, 0, 0, 0)
    example.autopilot.send_now(winch, example.now)
    assert example.until("lowered", 8.0) == ["lowering 3.50 m of rope", "lowered"]
    example.run(0.2)
    answers = [(one.result, one.progress) for one in example.autopilot.messages(">", "COMMAND_ACK")]
    *told, last = answers
    assert last == (mavlink.MAV_RESULT_ACCEPTED, 0)
    assert len(told) >= 4 and {result for result, _ in told} == {mavlink.MAV_RESULT_IN_PROGRESS}
    assert [progress for _, progress in told] == sorted(progress for _, progress in told)
    weights = example.autopilot.messages(">", "NAMED_VALUE_FLOAT")
    assert len(weights) >= 5 and {one.name for one in weights} == {"weight"}


def test_link_doctor(run):
    assert run("LinkDoctor").until(QUIET, 8.0)[0] == QUIET
    assert run("LinkDoctor", telemetry=1000.0).until("all is well", 8.0)[0] == "all is well"


def test_go_to_places_flies_to_three_places_and_comes_home(run):
    example = run("GoToPlaces")
    flight, places = example.autopilot.flight, []
    while "home" not in example.lines:
        assert example.now < 200, example.lines
        example.run(0.5)
        if flight.target is not None and flight.target[:2] != flight.home[:2] and flight.target not in places:
            places.append(flight.target)
    # An unconnected sensor of the simulated Mega reads 0: each place is 30 m north of the one before.
    assert [round((place.lat_e7 - flight.home.lat_e7) * 0.0111) for place in places] == [30, 60, 90]
    assert [round(place.height, 1) for place in places] == [10.0] * 3
    assert example.lines.count("working") == 3
    assert flight.where(example.now).distance(flight.home) < 0.5 and not example.autopilot.armed


def test_go_to_places_leaves_the_aircraft_to_a_pilot_who_takes_it(run, personality):
    example = run("GoToPlaces")
    example.until("working", 120.0)
    mode = "LOITER" if is_ardupilot(example) else (3, 0)
    if is_ardupilot(example):
        example.autopilot._set_mode(5, example.now)
    else:
        example.autopilot._set_mode(*mode, example.now)
    example.until("taken over", 60.0)
    example.run(20.0)
    autopilot = example.autopilot
    assert (autopilot.mode if is_ardupilot(example) else (autopilot.main_mode, autopilot.sub_mode)) == mode
    assert autopilot.armed and "to 3" not in example.lines and "home" not in example.lines


TARGET, VELOCITY = "SET_POSITION_TARGET_GLOBAL_INT", "SET_POSITION_TARGET_LOCAL_NED"


def test_follow_beacon_is_behind_its_target_holds_and_comes_home(run):
    example = run("FollowBeacon")
    flight, away = example.autopilot.flight, []
    while "home" not in example.lines:
        assert example.now < 240, example.lines
        example.run(0.5)
        ended = example.lines.count("done: the autopilot confirmed it")
        targets = example.autopilot.messages(">", TARGET)
        if targets and ended == 2:
            here = flight.where(example.now)
            away.append(here.distance(here._replace(lat_e7=targets[-1].lat_int, lon_e7=targets[-1].lon_int)))
    assert len(targets) > 290 and max(away[20:]) < 5.0
    assert flight.where(example.now).distance(flight.home) < 0.5 and not example.autopilot.armed


def test_follow_beacon_leaves_the_aircraft_to_a_pilot_who_takes_it(run):
    example = run("FollowBeacon")
    while example.lines.count("done: the autopilot confirmed it") < 2:
        assert example.now < 100, example.lines
        example.run(0.5)
    example.run(5.0)
    mode = (5,) if is_ardupilot(example) else (3, 0)
    example.autopilot._set_mode(*mode, example.now)
    example.until("a pilot or another station is in control", 5.0)
    sent = len(example.autopilot.messages(">", TARGET))
    example.run(10.0)
    assert sent > 0 and len(example.autopilot.messages(">", TARGET)) == sent
    assert example.autopilot.armed and "home" not in example.lines


FORWARD, LEFT, RIGHT = (0x2C, 1 << 5), (0x32, 1 << 5), (0x2C, 1 << 3)  # pins 3, 4 and 5 of a Mega: PE5, PG5, PE3


def aloft(run) -> Run:
    """FlyByButtons at its height, and no button is held."""
    example = run("FlyByButtons")
    example.run(3.0)
    press(example)
    example.run(0.2)
    press(example, is_down=False)
    while example.lines.count("done: the autopilot confirmed it") < 2:
        assert example.now < 100, example.lines
        example.run(0.5)
    return example


def test_fly_by_buttons_flies_as_long_as_a_button_is_held_and_lands(run):
    example = aloft(run)
    flight = example.autopilot.flight
    ground = flight.home._replace(height=flight.where(example.now).height)
    example.run(2.0)
    assert flight.where(example.now).distance(ground) < 0.5
    press(example, button=FORWARD)
    example.run(5.0)
    press(example, button=FORWARD, is_down=False)
    example.run(4.0)
    there = flight.where(example.now)
    assert 7.0 < there.distance(ground) < 14.0
    heading = flight.heading(example.now)
    press(example, button=LEFT)
    example.run(3.0)
    press(example, button=LEFT, is_down=False)
    example.run(2.0)
    turned = (flight.heading(example.now) - heading + 180) % 360 - 180
    assert -80 < turned < -40 and flight.where(example.now).distance(there) < 0.5
    press(example)
    example.until("landed", 60.0)
    assert not example.autopilot.armed and example.lines[-2:] == ["done: the autopilot confirmed it", "landed"]


def test_fly_by_buttons_leaves_the_aircraft_to_a_pilot_who_takes_it(run):
    example = aloft(run)
    press(example, button=FORWARD)
    example.run(1.0)
    example.autopilot._set_mode(*((5,) if is_ardupilot(example) else (3, 0)), example.now)
    example.until("a pilot or another station is in control", 5.0)
    sent = len(example.autopilot.messages(">", VELOCITY))
    press(example)
    example.run(10.0)
    assert sent > 0 and len(example.autopilot.messages(">", VELOCITY)) == sent
    assert example.autopilot.armed and "landed" not in example.lines


def test_work_at_waypoints_holds_the_mission_at_each_and_goes_on(run):
    example = run("WorkAtWaypoints")
    flight = example.autopilot.flight
    held = []
    while "landed" not in example.lines:
        assert example.now < 200, example.lines
        working = len([line for line in example.lines if line.startswith(("servo", "sensor"))])
        resumed = example.lines.count("going on")
        if working > resumed:
            held.append((working, flight.where(example.now)))
        example.run(0.25)
    lines = [line for line in example.lines if not line.startswith("accepted")]
    assert [line for line in lines if line not in ("reached 0", "reached 3")] == [
        "reached 1", "servo open", "going on", "reached 2", "sensor: 0", "going on", "landed"]  # fmt: skip
    for number in (1, 2):
        stays = [place for which, place in held if which == number]
        assert len(stays) >= 11  # 3 s
        assert max(place.distance(stays[-1]) for place in stays) < 0.1
    assert not example.autopilot.armed


def test_work_at_waypoints_leaves_the_aircraft_to_a_pilot(run):
    example = run("WorkAtWaypoints")
    example.until("servo open", 100.0)
    autopilot = example.autopilot
    if is_ardupilot(example):
        autopilot._set_mode(5, example.now)
    else:
        autopilot._set_mode(3, 0, example.now)
    example.until("a pilot or another station is in control", 20.0)
    example.run(10.0)
    assert (autopilot.mode == "LOITER") if is_ardupilot(example) else (autopilot.main_mode == 3)
    assert "reached 2" not in example.lines
