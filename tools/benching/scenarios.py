"""What is played to a board and to a simulator: one table, of uploads on a line that loses, repeats, delays and
damages, of what goes wrong meanwhile, of random items, and of flights; and how each must end.

tools/bench plays SCENARIOS, tools/field all but those that need what only a fake autopilot does.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any

from simulation.bench import aboard_names
from simulation.fake_autopilot import ArduPilot, FakeAutopilot, Item, Px4, mavlink
from simulation.wire import Wire
from trial_names import GRID

from .player import Player, Talk

AUTOPILOTS: dict[str, type[FakeAutopilot]] = {"ArduPilot": ArduPilot, "PX4": Px4}
UPTIME_S = 100.0
COUNTED = ("bytes", "skipped", "frames", "bad", "lost")  # by the board, since its start
SAYS_ABOARD = ("Accepted", "Verified", "AlreadyAboard")
FOUND_S = 5.0  # within which the autopilot has sent heartbeats
SETTLED_S = 0.5  # and the board has heard them


@dataclass(frozen=True)
class Scenario:
    """`prepare` is given the wire and the autopilot before the board hears anything of them.

    `steps`: what the board is told, line by line; "=Accepted|Denied": wait for the end, which must be one of these;
    "~2": let a random time of up to 2 s pass; a function is called with the talk, the holder and a random.Random.
    Without steps the board uploads its plan. `is_for`: "both", or "board".
    """

    name: str
    items: int
    ends: tuple[str, ...]  # the statuses that are right; the first is the one to be expected
    prepare: Callable[[Wire, Any], object]
    limit_s: float = 30.0
    steps: tuple[Any, ...] = ()
    is_for: str = "both"
    to_fly: bool = False  # the aircraft must be fit to arm

    @property
    def all_steps(self) -> tuple[Any, ...]:
        return self.steps or (f"upload {self.items}", "=" + "|".join(self.ends))


@dataclass
class Result:
    scenario: str
    autopilot: str
    status: str = "-"
    is_on_good_line: bool = False
    seconds: float = 0.0
    struck: int = 0  # frames that the tool has lost, repeated, delayed or damaged
    wrong: list[str] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    round_trips_ms: list[float] = field(default_factory=list)  # from an item's request to the item
    counters: dict[str, int] = field(default_factory=dict)  # what the board has counted, in this scenario

    @property
    def is_right(self) -> bool:
        return not self.wrong


def item_of(index: int) -> Item:
    """As itemOfPlan() in simulation/sketches/on_board.cpp."""
    return Item(frame=3, command=16, current=0, autocontinue=1, param1=0.0, param2=0.0, param3=0.0,
                param4=float("nan"), x=473977420 + 100 * index, y=85455970, z=20.0)  # fmt: skip


def nothing(wire: Wire, autopilot: FakeAutopilot) -> None:
    pass


def repeated(wire: Wire, autopilot: FakeAutopilot) -> None:
    wire.repeat(">", name="MISSION_ITEM_INT", times=None)
    wire.repeat("<", name="MISSION_REQUEST*", times=None)


def damaged_frame(wire: Wire, autopilot: FakeAutopilot) -> None:
    wire.corrupt("<", name="MISSION_REQUEST*", seq=2)
    wire.corrupt(">", name="MISSION_ITEM_INT", seq=5)


def frames_lost(wire: Wire, autopilot: FakeAutopilot) -> None:
    for direction in "><":
        wire.at_random(direction, lose=3)


def late(wire: Wire, autopilot: FakeAutopilot) -> None:
    wire.set_latency(0.15)


def denied(wire: Wire, autopilot: FakeAutopilot) -> None:
    autopilot.faults.refuse(mavlink.MAV_MISSION_DENIED, 0)


def armed(wire: Wire, autopilot: FakeAutopilot) -> None:
    autopilot.armed = True


def damage(percent: float, ms: float) -> Callable[[Wire, Any], None]:
    """So many percent of the bytes are lost, and each way takes so long."""

    def prepare(wire: Wire, autopilot: Any) -> None:
        wire.damage_bytes(lose=percent)
        wire.set_latency(ms / 1000)

    return prepare


def pulled(seconds: float) -> Callable[[Talk, Any, random.Random], None]:
    """The cable is out for so long."""

    def act(talk: Any, holder: Any, chance: random.Random) -> None:
        talk.wire.pull()
        talk.run(seconds)
        talk.wire.plug()

    return act


def reset(talk: Any, holder: Any, chance: random.Random) -> None:
    talk.reset()


def cancelled(talk: Talk, holder: Any, chance: random.Random) -> None:
    talk.tell("cancel")
    talk.run(0.05)


def stalled(seconds: float) -> Callable[[Talk, Any, random.Random], None]:
    """loop() stands still for so long."""

    def act(talk: Talk, holder: Any, chance: random.Random) -> None:
        talk.tell(f"stall {1000 * seconds:.0f}")
        talk.run(seconds)

    return act


def station(talk: Any, holder: Any, chance: random.Random) -> None:
    """A second station puts a plan of its own aboard, on its own port."""
    holder.upload_beside([item_of(700 + index) for index in range(chance.choice((2, 7, 30)))])


# How an upload may end that was much disturbed; whether it is true is asked each time.
MAY_FAIL = ("Accepted", "Unconfirmed", "Differs", "NoAnswer", "TimedOut", "TookTooLong", "Denied", "Error",
            "CancelledByAutopilot", "InvalidSequence")  # fmt: skip
FAILS = "=" + "|".join(MAY_FAIL)

SCENARIOS = (
    Scenario("nothing is lost", 10, ("Accepted",), nothing),
    Scenario("nothing is lost, 100 items", 100, ("Accepted",), nothing, 60.0),
    Scenario("the count is lost", 10, ("Accepted",), lambda wire, _: wire.lose(">", name="MISSION_COUNT")),
    Scenario("a request is lost", 10, ("Accepted",), lambda wire, _: wire.lose("<", name="MISSION_REQUEST*", seq=4)),
    Scenario("an item is lost", 10, ("Accepted",), lambda wire, _: wire.lose(">", name="MISSION_ITEM_INT", seq=3)),
    Scenario("the acknowledgement is lost", 10, ("Accepted",), lambda wire, _: wire.lose("<", name="MISSION_ACK")),
    Scenario("requests and items come twice", 10, ("Accepted",), repeated),
    Scenario("two frames are damaged", 10, ("Accepted",), damaged_frame),
    Scenario("3 of 100 frames are lost", 30, ("Accepted",), frames_lost, 60.0),
    Scenario("2 of 1000 bytes are lost or altered", 30, ("Accepted",),
             lambda wire, _: wire.damage_bytes(lose=0.1, alter=0.1), 60.0),
    Scenario("each way takes 150 ms", 10, ("Accepted",), late),
    Scenario("the autopilot denies item 0", 10, ("Denied",), denied, is_for="board"),
    Scenario("the autopilot is armed", 10, ("Armed",), armed, to_fly=True),
    Scenario("no mission message arrives", 10, ("NoAnswer", "TimedOut"),
             lambda wire, _: wire.lose(">", name="MISSION_*", times=None), 60.0),
)  # fmt: skip

SIMULATED = (
    Scenario("one operation right behind another", 30, ("Verified",), nothing, 60.0, (
        "upload 30", "=Accepted", "verify 30", "=Verified", "clear", "=Cleared", "ensure 30", "=Accepted", "ensure 30",
        "=AlreadyAboard", "verify 30", "=Verified")),
    Scenario("cancelled, and another right behind it, each way takes 150 ms", 12, ("Verified",), late, 60.0, (
        "upload 60", "~3", cancelled, "upload 12", "=Accepted", "verify 12", "=Verified")),
    Scenario("loop() stands still for 3 s in an upload", 60, MAY_FAIL, nothing, 60.0, (
        "upload 60", "~1", stalled(3.0), FAILS)),
    Scenario("loop() stands still for 12 s in an upload", 60, MAY_FAIL, nothing, 60.0, (
        "upload 60", "~1", stalled(12.0), FAILS)),
    Scenario("the cable is out for 3 s", 60, MAY_FAIL, nothing, 60.0, (
        "upload 60", "~1", pulled(3.0), FAILS)),
    Scenario("the cable is out for 12 s, and an upload follows", 60, ("Accepted",), nothing, 60.0, (
        "upload 60", "~1", pulled(12.0), FAILS, "upload 60", "=Accepted")),
    Scenario("the board is reset, and uploads again", 30, ("Verified",), nothing, 60.0, (
        "upload 60", "~1", reset, "upload 30", "=Accepted", "verify 30", "=Verified")),
    Scenario("a second station uploads meanwhile", 60, MAY_FAIL, nothing, 60.0, (
        "upload 60", "~1", station, FAILS)),
    Scenario("a second station uploads behind it", 12, ("Differs",), nothing, 60.0, (
        "upload 12", "=Accepted", "~1", station, "verify 12", "=Differs")),
)  # fmt: skip
GRIDDED = tuple(Scenario(one.name, one.items, MAY_FAIL if one.percent else ("Accepted",), damage(one.percent, one.ms),
                         150.0 + 3 * one.items) for one in GRID)  # fmt: skip


def play(player: Player, scenario: Scenario, name: str, seed: int = 1) -> Result:
    """One upload of the board's to an autopilot of this name."""
    result = Result(scenario.name, name, is_on_good_line=scenario.prepare is nothing)
    wire = Wire(seed)
    autopilot = AUTOPILOTS[name](uptime_s=UPTIME_S)
    scenario.prepare(wire, autopilot)
    player.connect(autopilot, wire)
    # It is another autopilot than the last one: the board must have heard it. Two heartbeats that nothing befell, since
    # the number of the first may be one that the last autopilot's frames have just passed: then it is taken for late.
    player.until(lambda: sum(not entry.fate for entry in wire.frames("<", "HEARTBEAT")) >= 2, FOUND_S)
    player.run(SETTLED_S)
    perform(player, scenario, autopilot, result, random.Random(seed))
    wire.spare()
    return result


def perform(talk: Any, scenario: Scenario, holder: Any, result: Result, chance: random.Random) -> None:
    """The scenario's steps, and what is to be said of their end. `holder`: says by received() what is aboard."""
    before = counters(talk)
    said, began = len(talk.lines), talk.now
    for step in scenario.all_steps:
        if callable(step):
            step(talk, holder, chance)
        elif step.startswith("~"):
            talk.run(chance.uniform(0, float(step[1:])))
        elif not step.startswith("="):
            said = len(talk.lines)
            talk.tell(step)
        elif status := talk.ended(said, scenario.limit_s):
            result.status = status
            ends = step[1:].split("|")
            if result.status not in ends:
                result.wrong.append(
                    f"{ends[0]} was expected" + f", and not {result.status}" * (step != scenario.all_steps[-1])
                )
        else:
            result.wrong.append(f"it has not ended within {scenario.limit_s:.0f} s")
            talk.tell("cancel")
            talk.run(0.5)
            break
    result.seconds = talk.now - began
    result.counters = {key: value - (before[key] if key in COUNTED else 0) for key, value in counters(talk).items()}
    result.struck = sum(bool(entry.fate) for entry in talk.wire.entries)
    result.round_trips_ms = round_trips(talk.wire)
    judge(result, scenario, holder)


def placed(items: Sequence[Item]) -> list[tuple]:
    return [(one.command, one.x, one.y, one.z) for one in items]


def judge(result: Result, scenario: Scenario, holder: Any) -> None:
    everything = placed(holder.received())
    held = everything[-scenario.items :]
    wanted = placed([item_of(index) for index in range(scenario.items)])
    is_aboard = held == wanted and len(everything) <= scenario.items + 1  # and home
    if result.status in SAYS_ABOARD and not is_aboard:
        others = getattr(holder, "placed_beside", None)
        if others is None or everything[-len(others) :] != others:
            result.wrong.append(f"{result.status}, and the plan is not aboard")
        else:
            result.notes.append("a second station's plan has come behind it")
    says_ours = result.status not in ("-", *SAYS_ABOARD) and aboard_names()[result.counters["aboard"]] == "OurPlan"
    if says_ours and not is_aboard:
        result.wrong.append(f"{result.status}, aboard() says OurPlan, and it is not")
    if result.status == "Differs" and is_aboard:
        result.wrong.append("Differs, and the plan is aboard")
    if scenario.ends[0] not in (*SAYS_ABOARD, "Differs") and is_aboard:
        result.wrong.append("the plan is aboard")


def counters(player: Any) -> dict[str, int]:
    """What the board has counted since its start."""
    told = next(line for line in player.tell("state") if line.startswith("state "))
    return {key: int(value) for key, _, value in (word.partition("=") for word in told.split()[1:])}


def round_trips(wire: Wire) -> list[float]:
    """[ms] from each request that nothing befell to the item that answers it."""
    asked: dict[int, float] = {}
    found = []
    for entry in wire.entries:
        if entry.message is None:
            continue
        kind = entry.message.get_type()
        if entry.direction == "<" and kind.startswith("MISSION_REQUEST") and not entry.fate:
            asked[entry.message.seq] = entry.time
        elif entry.direction == ">" and kind == "MISSION_ITEM_INT" and entry.message.seq in asked:
            found.append(1000 * (entry.time - asked.pop(entry.message.seq)))
    return found
