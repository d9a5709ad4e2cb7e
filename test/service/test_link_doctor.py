"""LinkDoctor on a Mega: its port, its baud rates, a late loop. host/units/link_doctor.cpp has every verdict."""

from __future__ import annotations

import pytest

from simulation.doctor import Doctor
from simulation.fake_autopilot import mavlink

GOOD = ("Listening", "Quiet", "Well")


def slow(*values):
    return pytest.param(*values, marks=pytest.mark.slow)


@pytest.fixture
def build_doctor(request):
    """Makes a Doctor whose transcript is shown when the test fails."""
    from bench_fixtures import BENCHES

    def build(*arguments, **options) -> Doctor:
        made = Doctor(*arguments, **options)
        request.node.stash.setdefault(BENCHES, []).append(made)
        return made

    return build


@pytest.fixture
def make_doctor(build_doctor, personality):
    return lambda **options: build_doctor(personality, **options)


# A link that is in order ----------------------------------------------------------


def test_idle_link_is_well_within_seven_seconds_and_stays_so(make_doctor):
    bench = make_doctor()
    bench.run(7.0)
    assert bench.verdict in ("Quiet", "Well")
    bench.run(25.0)
    assert len(bench.verdicts) == 1


def test_ardupilot_that_nobody_asked_is_quiet_and_well_once_it_sends_telemetry(build_doctor):
    bench = build_doctor("ArduPilot")
    bench.run_until_verdict("Quiet")
    bench.autopilot.stream(mavlink.MAVLINK_MSG_ID_GLOBAL_POSITION_INT, 0.1, bench.now)
    bench.run_until_verdict("Well")
    assert bench.verdicts == ["Quiet", "Well"]


@pytest.mark.parametrize("baud", [57600, slow(115200)])
def test_saturated_link_is_well(make_doctor, baud):
    bench = make_doctor(baud=baud, peer_baud=baud, telemetry=baud / 10)
    bench.tell("bauds")
    bench.run(20.0)
    assert bench.verdicts == ["Well"]
    assert bench.opened == []


def test_upload_beside_the_doctor_ends_as_ever_and_is_no_fault(make_doctor):
    bench = make_doctor(telemetry=2000.0)
    bench.tell("upload")
    assert bench.run_until_ended(limit_s=10) == "Accepted"
    bench.run(10.0)
    assert set(bench.verdicts) <= set(GOOD) and bench.verdict == "Well"


def test_harmless_questions_only(make_doctor):
    bench = make_doctor()
    bench.run(12.0)
    said = bench.heard()
    assert {message.get_type() for message in said} == {"HEARTBEAT", "COMMAND_LONG"}
    asked = [message for message in said if message.get_type() == "COMMAND_LONG"]
    assert {(message.command, message.param1) for message in asked} == {
        (mavlink.MAV_CMD_REQUEST_MESSAGE, mavlink.MAVLINK_MSG_ID_AUTOPILOT_VERSION)
    }
    assert len(asked) <= 3


# No bytes -------------------------------------------------------------------------


def test_no_bytes_when_the_autopilot_is_switched_off_and_well_when_it_is_on_again(make_doctor):
    bench = make_doctor()
    bench.run(7.0)
    well = bench.verdict
    bench.wire.pull()
    bench.run_until_verdict("NoBytes", 6.0)
    bench.wire.plug()
    bench.run_until_verdict(well, 8.0)
    assert bench.verdicts == [well, "NoBytes", "Listening", well]


@pytest.mark.parametrize("tries", [False, True])
@pytest.mark.parametrize("silent_s", [slow(1.0), 3.0, slow(12.0)])
def test_autopilot_that_restarts_is_never_at_another_baud_rate(make_doctor, silent_s, tries):
    bench = make_doctor(telemetry=1000.0, boot_text=b"Init ArduCopter V4.6.3\n\nFree RAM: 196000\r\n")
    if tries:
        bench.tell("bauds")
    bench.run_until_verdict("Well")
    bench.autopilot.reboot(bench.now, silent_s)
    bench.run(silent_s + 10.0)
    assert bench.verdict == "Well" and bench.opened == []
    assert set(bench.verdicts) <= {*GOOD, "NoBytes"}


# Bytes, and no frames ----------------------------------------------------------------


@pytest.mark.parametrize("peer_baud", [slow(9600), slow(38400), 115200, slow(460800)])
def test_no_frames_at_another_baud_rate_when_it_cannot_be_changed(make_doctor, peer_baud):
    bench = make_doctor(peer_baud=peer_baud)
    bench.run_until_verdict("NoFrames")
    bench.run(10.0)
    assert bench.verdicts == ["NoFrames"]


@pytest.mark.parametrize("ours, its", [(57600, 115200), slow(57600, 38400), slow(57600, 9600),
                                       slow(57600, 500000), (115200, 57600), slow(9600, 57600)])  # fmt: skip
def test_another_baud_rate_is_found_and_said(make_doctor, ours, its):
    bench = make_doctor(baud=ours, peer_baud=its)
    bench.tell("bauds")
    bench.run_until_verdict("WrongBaud", 45.0)
    assert bench.verdicts == ["TryingBauds", "WrongBaud"]
    assert bench.findings.baud == its == bench.opened[-1]


def test_rate_that_the_board_cannot_do_is_not_tried(make_doctor):
    bench = make_doctor(peer_baud=921600, telemetry=3000.0)
    bench.tell("bauds")
    bench.run_until_verdict("NoFramesAtAnyBaud", 45.0)
    assert 921600 not in bench.opened and 460800 not in bench.opened


# Damage -------------------------------------------------------------------------------------


def test_loop_that_comes_too_late(make_doctor):
    bench = make_doctor(telemetry=5000.0)
    bench.run_until_verdict("Well")
    bench.tell("stall", 100, 60)
    bench.run_until_verdict("LoopLate", 12.0)
    bench.tell("stall", 0, 0)
    bench.run_until_verdict("Well", 12.0)
    assert bench.verdicts == ["Well", "LoopLate", "Well"]


def test_loop_that_is_so_late_that_hardly_a_frame_comes_whole(make_doctor):
    bench = make_doctor(telemetry=5000.0)
    bench.tell("bauds")
    bench.tell("stall", 1, 700)
    bench.run_until_verdict("LoopLate", 12.0)
    assert bench.opened == []


# Cost -------------------------------------------------------------------------------------------


def test_doctor_takes_a_call_less_than_a_third_of_a_millisecond(make_doctor):
    bench = make_doctor(telemetry=5000.0)
    watch = bench.mega.watch("updateDoctor")
    bench.run(12.0)
    assert bench.verdict == "Well"
    assert watch.calls.longest < bench.mega.hz / 1000 / 3
