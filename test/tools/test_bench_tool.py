"""tools/bench: a simulated Mega with the board's sketch behind two pseudo-terminals, in simulated time."""

from __future__ import annotations

import pytest

from benching import SCENARIOS, Player, Scenario, play, report, scenarios, write_sketch
from building import ROOT, build_sketch
from example_runs import firmware_of
from simulation.firmware import build_firmware
from simulation.mega import Mega
from simulation.mega.ends import Pty, open_end
from simulation.mega.realtime import RealTime

SKETCH = ROOT / "simulation" / "sketches" / "on_board.cpp"


class Stopped:
    """The computer's clock, which is not looked at: it goes as the Mega's does."""

    def __init__(self) -> None:
        self.now = 0.0

    def __call__(self) -> float:
        return self.now

    def sleep(self, seconds: float) -> None:
        self.now += seconds


@pytest.fixture
def player():
    """At the other ends of the pseudo-terminals that are the board's console and its line."""
    clock = Stopped()
    mega = Mega(build_firmware(SKETCH.stem, [SKETCH]))
    world = RealTime(mega, clock, clock.sleep)
    ends = [Pty(), Pty()]
    for number, end in enumerate(ends):
        world.connect(number, end)
    ports = [open_end(f"{end.name}@{baud}", say=lambda text: None)
             for end, baud in zip(ends, (115200, 57600), strict=True)]  # fmt: skip

    def let_pass(seconds: float) -> None:
        until = mega.now_us + 1e6 * seconds
        while mega.now_us < until:
            world.slice()

    yield Player(*ports, clock=lambda: mega.now_us / 1e6, sleep=let_pass)
    for one in (*ports, world):
        one.close()


def test_board_plays_scenarios_with_each_autopilot_and_the_report_can_be_pasted(player):
    board = player.find()
    assert board.startswith("MavMission ") and board.endswith("board AVR_MEGA2560, clock 16000000, receive buffer 64")
    results = [play(player, one, name) for one, name in zip(SCENARIOS[:3], ("ArduPilot", "PX4", "PX4"), strict=True)]
    assert [result.wrong for result in results] == [[], [], []]
    assert all(8 < ms < 25 for ms in results[0].round_trips_ms)  # what the line takes, and the Mega's own time
    lines = report(board, "console x, line y", results).splitlines()
    assert lines[0] == "tools/bench: 3 of 3 as expected"
    columns = (ROOT / "docs" / "boards.md").read_text().partition("\n| board, library, core |")[2].partition("\n")[0]
    assert columns.count("|") + 2 == lines[-1].count("|")


def test_plan_that_is_not_aboard_is_told(player):
    def forgets(wire, autopilot):
        autopilot.received = lambda: []

    result = play(player, Scenario("forgets", 5, ("Accepted",), forgets), "PX4")
    assert result.wrong == ["Accepted, and the plan is not aboard"]
    assert report("a board", "x", [result]).startswith("tools/bench: 0 of 1 as expected")
    denied = play(player, Scenario("denied", 5, ("Accepted",), scenarios.denied), "ArduPilot")
    assert denied.wrong == ["Accepted was expected"]


@pytest.mark.slow
def test_sketch_compiles_as_the_arduino_ide_makes_it_and_for_an_uno(tmp_path):
    sketch = write_sketch(tmp_path)
    assert sketch == tmp_path / "MavMissionBench" / "MavMissionBench.ino"
    assert build_sketch(sketch).flash > 10_000
    assert firmware_of(sketch, "atmega328p").is_file()
