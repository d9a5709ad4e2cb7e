"""Each example, as it is, on a simulated Mega beside a fake autopilot: what it prints, and what is aboard then."""

from __future__ import annotations

import random
import re

import pytest

from building import ROOT
from example_runs import SLICE_S, Run, commands, is_ardupilot
from plans import HOME, NAN, jump, waypoint
from simulation.fake_autopilot import FENCE, MISSION, RALLY, mavlink

QUIET = "all is well; the autopilot sends little unasked: setMessageInterval() asks for more"
NOT_HEARD = "if this stays, look at the wire from our TX to its RX"


@pytest.fixture
def run(personality):
    return lambda example, **options: Run(example, personality, **options)


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
    lines = example.until(NOT_HEARD, 10.0)
    assert lines[1:3] == ["transferring, items done: 0", "the autopilot did not answer"]
    assert not any(line.startswith("aboard: our plan") for line in example.lines)


@pytest.mark.parametrize("seed", range(4))
def test_ensure_mission_does_not_blame_the_wire_while_the_autopilot_answers(personality, seed):
    """Of the bytes 3 % are lost, each way."""
    example = Run("EnsureMission", personality)
    chance = random.Random(seed)
    hear, speak = example.autopilot.receive, example.autopilot.run

    def worn(data: bytes) -> bytes:
        return bytes(byte for byte in data if chance.random() >= 0.03)

    example.autopilot.receive = lambda data, now: hear(worn(data), now)
    example.autopilot.run = lambda now: worn(speak(now))
    lines = example.until("aboard: our plan, whole", 60.0)
    assert NOT_HEARD not in lines
    assert not any("wire" in line or "baud" in line for line in lines)


def test_ensure_mission_changes_nothing_in_flight(run):
    example = run("EnsureMission", armed=True)
    example.autopilot.load([waypoint(), waypoint(), waypoint(z=30.0)])
    held = example.autopilot.received()
    example.until("aboard: not known", 5.0)
    assert example.lines[0] == "the autopilot is armed"
    example.run(10.0)
    assert example.autopilot.received() == held
    assert example.autopilot.messages(">", "MISSION_COUNT") == []


def test_fence_and_rally(run):
    example = run("FenceAndRally")
    lines = example.until("rally: aboard, as it was meant", 6.0)
    assert lines == ["fence: aboard, as it was meant", "rally: aboard, as it was meant"]
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
    assert example.lines.count("fix, satellites: 10") == 2


def test_check_parameters():
    example = Run("CheckParameters", "ArduPilot")
    lines = example.until("MIS_RESTART: 1.00 done: the autopilot confirmed it", 10.0)
    assert lines == ["SERIAL1_BAUD: 57.00 done: the autopilot confirmed it",
                     "FENCE_ENABLE: 0.00 done: the autopilot confirmed it",
                     "MIS_RESTART: 1.00 done: the autopilot confirmed it"]  # fmt: skip
    assert example.autopilot.parameters.value("MIS_RESTART") == 1


def test_payload_winch_lowers_by_a_length_and_does_nothing_else(run):
    example = run("PayloadWinch")
    example.run(2.0)

    def winch(instance: int, action: int, metres: float) -> None:
        order = mavlink.MAVLink_command_long_message(1, 0, 42600, 0, instance, action, metres, 0.5, 0, 0, 0)
        example.autopilot.send_now(order, example.now)
        example.run(0.3)

    for action in (0, 2, 3, 4, 6):  # relax, by rate, lock, deliver, retract
        winch(1, action, 3.5)
    assert example.lines == []
    winch(1, 1, 3.5)
    began = example.now
    example.run(4.0)
    winch(2, 1, 9.0)  # it is busy
    assert example.until("lowered", 8.0) == ["lowering 3.50 m of rope", "lowered"]
    assert example.now - began < 5.5
    example.run(0.2)
    answers = [(one.result, one.progress) for one in example.autopilot.messages(">", "COMMAND_ACK")]
    assert [result for result, _ in answers[:5]] == [mavlink.MAV_RESULT_DENIED] * 5
    assert (mavlink.MAV_RESULT_TEMPORARILY_REJECTED, 0) in answers
    assert answers[-1] == (mavlink.MAV_RESULT_ACCEPTED, 0)
    told = [progress for result, progress in answers if result == mavlink.MAV_RESULT_IN_PROGRESS]
    assert len(told) >= 4 and told == sorted(told)
    weights = example.autopilot.messages(">", "NAMED_VALUE_FLOAT")
    assert len(weights) >= 5 and {one.name for one in weights} == {"weight"}


def test_link_doctor(run):
    assert run("LinkDoctor").until(QUIET, 8.0)[0] == QUIET
    assert run("LinkDoctor", telemetry=1000.0).until("all is well", 8.0)[0] == "all is well"


def test_first_hour_of_the_readme_is_what_its_examples_print():
    block = re.search(r"^```text\n(.*?)^```$", (ROOT / "README.md").read_text(), re.M | re.S)[1]
    upload = Run("UploadWithProgress", "ArduPilot")
    flight = Run("StartMission", "ArduPilot", vehicle="copter", uptime_s=0.0, ready_s=20.0, position_s=0.0)
    upload.run(4.0)
    flight.until("flying", 60.0)
    flight.autopilot._set_mode(5, flight.now)  # LOITER, by a pilot
    flight.run(3.0)
    for run, part in zip((upload, flight), re.split(r"^\w.*\n", block, flags=re.M)[1:], strict=True):
        printed = iter(run.lines)
        assert [line for line in part.splitlines() if line.removeprefix("  ") not in printed] == [], run.lines
