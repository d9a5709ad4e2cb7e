"""tools/bench: a simulated Mega with the board's sketch behind two pseudo-terminals, in simulated time."""

from __future__ import annotations

import re
import subprocess
from itertools import cycle

import pytest

import benching
from benching import SCENARIOS, NoBoard, Player, Scenario, play, report, scenarios, write_sketch
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


class Board:
    """A Mega with the board's sketch, whose console and line are pseudo-terminals, and a player at their other ends."""

    def __init__(self, has_sketch: bool = True) -> None:
        clock = Stopped()
        source = SKETCH if has_sketch else ROOT / "test" / "machine" / "sleeper.cpp"
        mega = Mega(build_firmware(source.stem, [source], library=has_sketch))
        self.world = RealTime(mega, clock, clock.sleep)
        ends = [Pty(), Pty()]
        for number, end in enumerate(ends):
            self.world.connect(number, end)
        self.ports = [open_end(f"{end.name}@{baud}", say=lambda text: None)
                      for end, baud in zip(ends, (115200, 57600), strict=True)]  # fmt: skip
        self.player = Player(*self.ports, clock=lambda: mega.now_us / 1e6, sleep=self._pass)

    def _pass(self, seconds: float) -> None:
        until = self.world.mega.now_us + 1e6 * seconds
        while self.world.mega.now_us < until:
            self.world.slice()

    def close(self) -> None:
        for port in self.ports:
            port.close()
        self.world.close()


@pytest.fixture(scope="module")
def board():
    made = Board()
    yield made
    made.close()


def test_board_says_what_it_is(board):
    assert re.fullmatch(
        r"MavMission [\d.]+, Arduino \d+, compiler [\d.]+, board AVR_MEGA2560, clock 16000000, receive buffer 64",
        board.player.find(),
    )


# Beside one in turn: tools/field plays most of them beside the other (test_field.py).
@pytest.mark.slow
@pytest.mark.parametrize(
    ("scenario", "name"), [*zip(SCENARIOS, cycle(("ArduPilot", "PX4")))],
    ids=lambda one: getattr(one, "name", one).replace(" ", "-"),
)  # fmt: skip
def test_scenario_ends_as_it_must_on_a_mega(board, scenario, name):
    result = play(board.player, scenario, name)
    assert result.wrong == []
    assert (result.struck > 0) == (scenario.prepare not in (scenarios.nothing, scenarios.late, scenarios.denied,
                                                            scenarios.armed))  # fmt: skip
    if result.struck == 0:
        assert (result.counters["skipped"], result.counters["bad"], result.counters["lost"]) == (0, 0, 0)


def test_request_is_answered_in_the_time_that_the_line_takes(board):
    """A request of 21 bytes or less and an item of 48 at 5,760 bytes/s, and the Mega's own time."""
    result = play(board.player, SCENARIOS[0], "ArduPilot")
    assert len(result.round_trips_ms) >= 10
    assert all(8 < ms < 25 for ms in result.round_trips_ms)
    assert result.counters["bytes"] > 200 and result.counters["loop"] < 20_000


def test_wrong_end_and_a_plan_that_is_not_aboard_are_told(board):
    denied = Scenario("denied", 5, ("Accepted",), scenarios.denied)
    result = play(board.player, denied, "ArduPilot")
    assert (result.is_right, result.wrong) == (False, ["Accepted was expected"])

    def forgets(wire, autopilot):
        autopilot.received = lambda: []

    result = play(board.player, Scenario("forgets", 5, ("Accepted",), forgets), "PX4")
    assert result.wrong == ["Accepted, and the plan is not aboard"]
    refused = Scenario("aboard all the same", 5, ("Denied",), scenarios.nothing)
    assert play(board.player, refused, "PX4").wrong == ["Denied was expected", "the plan is aboard"]


def test_upload_that_does_not_end_is_cancelled(board):
    silent = Scenario("silent", 5, ("Accepted",), lambda wire, autopilot: wire.pull(), 2.0)
    result = play(board.player, silent, "ArduPilot")
    assert result.wrong == ["it has not ended within 2 s"]
    assert play(board.player, SCENARIOS[0], "ArduPilot").is_right


def test_line_that_is_not_connected_is_seen(board):
    """The board hears no autopilot: the upload waits for one."""
    player = board.player
    line, player._line = player._line, open_end("none")
    try:
        result = play(player, Scenario("no line", 5, ("Accepted",), scenarios.nothing, 3.0), "ArduPilot")
    finally:
        player._line = line
    assert result.wrong == ["it has not ended within 3 s"]
    assert result.counters["bytes"] == 0


def test_report_can_be_pasted(board):
    results = [play(board.player, one, "PX4") for one in (SCENARIOS[0], SCENARIOS[2])]
    text = report("a board", "console x, line y", results)
    lines = text.splitlines()
    assert lines[0] == "tools/bench: 2 of 2 as expected"
    assert lines[2:4] == ["- board: a board", "- ports: console x, line y"]
    assert re.fullmatch(r"- request to item: [\d.]+ ms in the median, [\d.]+ ms at the most, of 10 .*", lines[4])
    assert re.fullmatch(r"- on a good line the board has received [\d,]+ bytes, of them 0 outside frames, 0 frames .*",
                        lines[5])  # fmt: skip
    assert re.fullmatch(r"\| nothing is lost \| PX4 \| `Accepted` \| \d+\.\d \| 0 \| right \|", lines[-5])
    assert re.fullmatch(r"\| the count is lost \| PX4 \| `Accepted` \| \d+\.\d \| 1 \| right \|", lines[-4])
    assert re.fullmatch(r"\| a board \| simulated PX4 \| 2 of 2 as expected; request to item: .* \| \|", lines[-1])
    columns = (ROOT / "docs" / "boards.md").read_text().partition("\n| board, library, core |")[2].partition("\n")[0]
    assert columns.count("|") + 2 == lines[-1].count("|")
    results[0].wrong.append("it is not so")
    assert report("a board", "x", results).splitlines()[0] == "tools/bench: 1 of 2 as expected"


def test_board_without_the_sketch_is_told():
    other = Board(has_sketch=False)
    try:
        with pytest.raises(NoBoard, match="has it the sketch of tools/bench --sketch"):
            other.player.find()
    finally:
        other.close()


@pytest.mark.slow
def test_sketch_compiles_as_the_arduino_ide_makes_it_and_for_an_uno(tmp_path):
    sketch = write_sketch(tmp_path)
    assert sketch == tmp_path / "MavMissionBench" / "MavMissionBench.ino"
    assert build_sketch(sketch).flash > 10_000
    assert firmware_of(sketch, "atmega328p").is_file()


def run_tool(*words: str) -> subprocess.CompletedProcess:
    return subprocess.run([ROOT / "tools" / "bench", *words], capture_output=True, text=True)


def test_tool_lists_its_scenarios():
    assert run_tool("--list").stdout.splitlines() == [one.name for one in benching.SCENARIOS]
    assert run_tool("--list", "--only", "item").stdout.splitlines() == [
        one.name for one in benching.SCENARIOS if "item" in one.name
    ]
