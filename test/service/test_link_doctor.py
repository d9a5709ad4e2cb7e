"""LinkDoctor on a Mega: its port, its baud rates, a late loop. host/units/link_doctor.cpp has every verdict."""

from __future__ import annotations

import pytest

from simulation.doctor import Doctor


def build(personality: str = "ArduPilot", **options) -> Doctor:
    return Doctor(personality, **options)


def test_no_frames_at_another_baud_rate_when_it_cannot_be_changed():
    bench = build(peer_baud=115200)
    bench.run_until_verdict("NoFrames")
    bench.run(10.0)
    assert bench.verdicts == ["NoFrames"]


@pytest.mark.parametrize("ours, its", [(57600, 115200), (115200, 57600), (57600, 9600)])
def test_another_baud_rate_is_found_and_said(ours, its):
    bench = build("PX4", baud=ours, peer_baud=its)
    bench.tell("bauds")
    bench.run_until_verdict("WrongBaud", 45.0)
    assert bench.verdicts == ["TryingBauds", "WrongBaud"]
    assert bench.found_baud == its == bench.opened[-1]


@pytest.mark.slow
def test_rate_that_the_board_cannot_do_is_not_tried():
    bench = build(peer_baud=921600, telemetry=3000.0)
    bench.tell("bauds")
    bench.run_until_verdict("NoFramesAtAnyBaud", 45.0)
    assert 921600 not in bench.opened and 460800 not in bench.opened


@pytest.mark.slow
@pytest.mark.parametrize("personality", ["ArduPilot", "PX4"])
def test_full_line_is_well_also_behind_a_restart_and_a_loop_that_comes_too_late_is_not(personality):
    bench = build(personality, telemetry=5760.0, boot_text=b"Init ArduCopter V4.6.3\n\nFree RAM: 196000\r\n")
    bench.tell("bauds")
    watch = bench.mega.watch("updateDoctor")
    bench.run_until_verdict("Well")
    bench.run(10.0)
    bench.autopilot.reboot(bench.now, 3.0)
    bench.run(13.0)
    assert bench.verdict == "Well" and set(bench.verdicts) <= {"Listening", "NoBytes", "Quiet", "Well"}
    assert watch.calls.longest < bench.mega.hz / 1000 / 3
    bench.tell("stall", 100, 60)
    bench.run_until_verdict("LoopLate", 12.0)
    bench.tell("stall", 0, 0)
    bench.run_until_verdict("Well", 12.0)
    bench.tell("stall", 1, 700)  # hardly a frame comes whole
    bench.run_until_verdict("LoopLate", 12.0)
    assert bench.opened == []
