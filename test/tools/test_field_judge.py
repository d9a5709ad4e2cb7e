"""The judge of tools/field and tools/bench on flights and uploads made by hand: each contradiction that it can name."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace

import pytest

from benching import flights
from benching.flights import CREWS, Flight, play_printed
from benching.player import Talk
from benching.scenarios import Result, Scenario, item_of, judge, nothing, placed
from simulation.bench import aboard_names
from simulation.fake_autopilot import mavlink
from simulation.fake_autopilot.frames import packed
from simulation.fake_autopilot.items import item_int_message
from simulation.wire import Wire
from trial_names import Flown

PLAN = [item_of(index) for index in range(3)]
CHANCE = SimpleNamespace(uniform=lambda low, high: low + 1.0, choice=lambda of: of[0], randint=lambda low, high: low)
HIGH_M, LOW_M = 10.0, 3.0
STEP_S = 0.1


class ByHand(Talk):
    """A copter's world, and the truth in it. `happens`: what, at which second."""

    homes = 1

    def __init__(self, happens: dict[float, str]) -> None:
        super().__init__()
        self.truth, self.simulator = self, SimpleNamespace(name="arducopter", has_remote=True)
        self.mega = SimpleNamespace(reset=lambda: None, poke_int=lambda *_: None, peek_int=lambda *_: 0)
        self.wire, self.watches, self.said, self.crossed = Wire(), [], [], []
        self.modes: list[tuple[float, int, bool]] = []
        self.mode, self.armed, self.height = 0, False, HIGH_M
        self.latest = {"GLOBAL_POSITION_INT": SimpleNamespace(lat=0, lon=0, vx=0, vy=0, vz=0)}
        self.aboard, self.placed_beside = list(PLAN), None
        self.answers = mavlink.MAV_RESULT_ACCEPTED
        self._packer, self._time, self._happens = mavlink.MAVLink(None, 1, 1), 0.0, dict(happens)

    @property
    def now(self) -> float:
        return self._time

    def step(self) -> None:
        self._time = round(self._time + STEP_S, 1)
        for second in [one for one in self._happens if one <= self._time]:
            self.happen(self._happens.pop(second))
        for watch in self.watches:
            watch()

    def happen(self, what: str) -> None:
        if what in CREWS["arducopter"].modes:
            self.set_mode(CREWS["arducopter"].modes[what])
        elif what in ("armed", "disarmed"):
            self.arm(what == "armed")
        elif what == "an order":
            self.leaves(mavlink.MAVLink_set_mode_message(1, 1, 3))
        elif what == "low":
            self.height = LOW_M
        elif what == "deaf":
            self.answers = mavlink.MAV_RESULT_DENIED
        elif what == "another plan":
            self.aboard = self.aboard[:-1]
        else:
            self.said.append((self._time, what))
            self.lines.append(what)

    def leaves(self, message) -> None:
        self.wire.send(">", packed(message, self._packer, 2), self._time)

    def power_on(self, firmware) -> None:
        self.leaves(mavlink.MAVLink_mission_count_message(1, 1, len(PLAN)))
        for seq, item in enumerate(PLAN):
            self.leaves(item_int_message(item, (1, 1), seq))

    def arm(self, on: bool) -> None:
        self.armed = on
        self.modes.append((self._time, self.mode, on))

    def set_mode(self, number: int) -> None:
        self.mode = number
        self.modes.append((self._time, number, self.armed))

    def received(self, kind: int = 0) -> list:
        return self.aboard

    def upload_beside(self, plan) -> None:
        self.aboard, self.placed_beside = [plan[0], *plan], placed(plan)

    def command(self, *_) -> int:
        return self.answers

    def set_current(self, seq: int) -> None:
        pass

    def set_parameter(self, name: str, value: float) -> None:
        pass


BEGINS = {1.0: "AUTO", 1.1: "armed"}
# What befalls it, at 2.1 s; and what is right to happen then.
RIGHT = {
    "undisturbed": {10.0: "disarmed", 10.5: "landed"},
    "a pilot lands": {2.5: "ended by a pilot", 10.0: "disarmed"},
    "a pilot gives back": {2.5: "ended by a pilot", 20.0: "disarmed"},
    "a pilot disarms": {2.5: "ended by a pilot"},
    "a failsafe": {3.0: "RTL", 3.5: "ended by a failsafe", 10.0: "disarmed"},
    "the battery is low": {3.0: "RTL", 3.5: "ended by a failsafe", 10.0: "disarmed"},
    "a station orders the return": {2.5: "ended by a failsafe", 10.0: "disarmed"},
    "a station pauses it": {10.0: "disarmed", 10.5: "landed"},
    "a station sets the current item": {10.0: "disarmed", 10.5: "landed"},
    "a station uploads another plan": {3.0: "ended by another station's plan", 10.0: "disarmed"},
    "the board is reset": {10.0: "disarmed"},
    "the cable is out": {4.0: "ended by silence", 20.0: "disarmed"},
    "loop() stands still": {10.0: "disarmed", 10.5: "landed"},
}
# What happens as well or instead, and what is said of it.
WRONG = [
    ("undisturbed", {1.1: "idle", 10.5: "idle"}, "never armed; the console's last state is 'idle'"),
    ("undisturbed", {10.5: "ended by a pilot"}, "nobody was there, and the console's last state is 'ended by a pilot'"),
    ("undisturbed", {10.0: "flying"}, "it is armed at the end"),
    ("undisturbed", {10.0: "flying"}, "'landed' at 10.5 s, and it is armed"),
    ("undisturbed", {12.0: "armed", 14.0: "disarmed"}, "it has landed 2 times"),
    ("undisturbed", {STEP_S: "low"}, "it has flown no higher than 3.0 m"),
    ("undisturbed", {5.0: "another plan"}, "the plan aboard is not what was sent: 1 items, and 2 were sent"),
    ("a pilot lands", {12.0: "armed"}, "it was armed again behind it"),
    ("a pilot lands", {5.0: "AUTO"}, "other modes came behind it: ['AUTO']"),
    ("a pilot lands", {5.0: "an order"}, "it sent 1 orders behind it, the first SET_MODE"),
    ("a pilot lands", {1.5: "ended by silence"}, "nobody was there yet, and the console says 'ended by silence'"),
    ("a pilot lands", {2.5: "flying"}, "the console never said 'ended' behind it; its last state is 'flying'"),
    ("a pilot gives back", {13.0: "an order"}, "it sent 1 orders behind it, the first SET_MODE"),
    ("a pilot disarms", {5.0: "armed"}, "it was armed again behind it"),
    ("a failsafe", {3.5: "ended by a pilot"}, "the console says 'ended by a pilot', and none was there"),
    ("a failsafe", {6.0: "AUTO"}, "other modes came behind it: ['AUTO']"),
    ("the battery is low", {12.0: "armed"}, "it was armed again behind it"),
    ("a station pauses it", {0.5: "deaf"}, "it could not be paused"),
    ("a station pauses it", {2.8: "an order"}, "it sent 1 orders while it was paused, the first SET_MODE"),
    ("a station sets the current item", {5.0: "an order"}, "it sent 1 orders behind the station, the first SET_MODE"),
    ("a station sets the current item", {12.0: "armed"}, "it was armed again behind its landing"),
    ("a station uploads another plan", {8.0: "an order"}, "it sent 1 orders behind another station's plan"),
    ("a station uploads another plan", {12.0: "armed"}, "it was armed again behind another station's plan"),
    ("a station uploads another plan", {3.0: "flying"}, "was flown, and the console's last state is 'flying'"),
    ("a station uploads another plan", {6.0: "another plan"}, "another station's plan was replaced"),
    ("the board is reset", {5.0: "an order"}, "it sent 1 orders behind the reset, the first SET_MODE"),
    ("the board is reset", {12.0: "armed"}, "it was armed again behind the reset"),
    ("the board is reset", {10.0: "flying"}, "the plan was not flown to its end behind the reset"),
    ("the cable is out", {8.0: "an order"}, "it sent 1 orders behind 'ended by silence', the first SET_MODE"),
    ("the cable is out", {20.0: "flying"}, "it could not be brought down"),
    ("loop() stands still", {10.5: "flying"}, "nobody was there, and the console's last state is 'flying'"),
]  # fmt: skip


@pytest.fixture(autouse=True)
def no_firmware(monkeypatch):
    monkeypatch.setattr(flights, "firmware", Path)


def contradictions(befalls: str, happens: dict[float, str]) -> list[str]:
    result = Result("by hand", "arducopter")
    Flight(ByHand({**BEGINS, **RIGHT[befalls], **happens}), Flown("StartMission", befalls), result, CHANCE).fly()
    return result.wrong


@pytest.mark.parametrize("befalls", RIGHT)
def test_flight_as_it_must_be_is_not_contradicted(befalls):
    assert contradictions(befalls, {}) == []


@pytest.mark.parametrize(("befalls", "happens", "words"), WRONG)
def test_what_a_flight_does_wrong_is_named(befalls, happens, words):
    assert any(words in one for one in contradictions(befalls, happens))


def test_example_that_does_not_arm_is_judged_by_its_words_and_by_what_is_aboard():
    def wrong(happens: dict[float, str], example: str = "EnsureMission") -> list[str]:
        result = Result("by hand", "arducopter")
        play_printed(ByHand(happens), example, result)
        return result.wrong

    right = {2.0: "aboard: our plan, whole"}
    assert wrong(right) == wrong({}, "UploadMission") == []
    assert wrong({}) == ["'aboard: our plan, whole' was not printed within 90 s: []"]
    assert wrong({1.0: "armed", **right}) == ["it is armed"]
    other = "the plan aboard is not what was sent: 1 items, and 2 were sent"
    assert wrong({1.0: "another plan", **right}) == wrong({1.0: "another plan"}, "UploadMission") == [other]


UNKNOWN, OURS = map(aboard_names().index, ("NotKnown", "OurPlan"))


@pytest.mark.parametrize(("expected", "status", "aboard", "is_ours", "words"), [
    ("Accepted", "Accepted", OURS, True, []),
    ("Accepted", "Accepted", OURS, False, ["Accepted, and the plan is not aboard"]),
    ("Accepted", "Denied", OURS, False, ["Denied, aboard() says OurPlan, and it is not"]),
    ("Differs", "Differs", UNKNOWN, False, []),
    ("Differs", "Differs", UNKNOWN, True, ["Differs, and the plan is aboard"]),
    ("Denied", "Denied", UNKNOWN, False, []),
    ("Denied", "Denied", UNKNOWN, True, ["the plan is aboard"]),
])  # fmt: skip
def test_what_an_upload_says_is_compared_with_what_is_aboard(expected, status, aboard, is_ours, words):
    result = Result("by hand", "ArduPilot", status, counters={"aboard": aboard})
    held = PLAN if is_ours else PLAN[::-1]
    judge(result, Scenario("by hand", len(PLAN), (expected,), nothing), SimpleNamespace(received=lambda: held))
    assert result.wrong == words
