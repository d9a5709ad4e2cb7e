"""What is played to a board: uploads on a line that loses, repeats, delays and damages, and how each must end."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, field

from simulation.bench import status_names
from simulation.fake_autopilot import ArduPilot, FakeAutopilot, Item, Px4, mavlink
from simulation.wire import Wire

from .player import Player

AUTOPILOTS: dict[str, type[FakeAutopilot]] = {"ArduPilot": ArduPilot, "PX4": Px4}
UPTIME_S = 100.0
COUNTED = ("bytes", "skipped", "frames", "bad", "lost")  # by the board, since its start
ENDED = re.compile(r"ended (\d+) ")
FOUND_S = 5.0  # within which the autopilot has sent heartbeats
SETTLED_S = 0.5  # and the board has heard them


@dataclass(frozen=True)
class Scenario:
    """`prepare` is given the wire and the autopilot before the board hears anything of them."""

    name: str
    items: int
    ends: tuple[str, ...]  # the statuses that are right; the first is the one to be expected
    prepare: Callable[[Wire, FakeAutopilot], None]
    limit_s: float = 30.0


@dataclass
class Result:
    scenario: str
    autopilot: str
    status: str = "-"
    is_on_good_line: bool = False
    seconds: float = 0.0
    struck: int = 0  # frames that the tool has lost, repeated, delayed or damaged
    wrong: list[str] = field(default_factory=list)
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


def lost_count(wire: Wire, autopilot: FakeAutopilot) -> None:
    wire.lose(">", name="MISSION_COUNT")


def lost_request(wire: Wire, autopilot: FakeAutopilot) -> None:
    wire.lose("<", name="MISSION_REQUEST*", seq=4)


def lost_item(wire: Wire, autopilot: FakeAutopilot) -> None:
    wire.lose(">", name="MISSION_ITEM_INT", seq=3)


def lost_acknowledgement(wire: Wire, autopilot: FakeAutopilot) -> None:
    wire.lose("<", name="MISSION_ACK")


def repeated(wire: Wire, autopilot: FakeAutopilot) -> None:
    wire.repeat(">", name="MISSION_ITEM_INT", times=None)
    wire.repeat("<", name="MISSION_REQUEST*", times=None)


def damaged_frame(wire: Wire, autopilot: FakeAutopilot) -> None:
    wire.corrupt("<", name="MISSION_REQUEST*", seq=2)
    wire.corrupt(">", name="MISSION_ITEM_INT", seq=5)


def frames_lost(wire: Wire, autopilot: FakeAutopilot) -> None:
    for direction in "><":
        wire.at_random(direction, lose=3)


def bytes_lost(wire: Wire, autopilot: FakeAutopilot) -> None:
    wire.damage_bytes(lose=0.1, alter=0.1)


def late(wire: Wire, autopilot: FakeAutopilot) -> None:
    wire.set_latency(0.15)


def denied(wire: Wire, autopilot: FakeAutopilot) -> None:
    autopilot.faults.refuse(mavlink.MAV_MISSION_DENIED, 0)


def armed(wire: Wire, autopilot: FakeAutopilot) -> None:
    autopilot.armed = True


def cut(wire: Wire, autopilot: FakeAutopilot) -> None:
    wire.lose(">", name="MISSION_*", times=None)


SCENARIOS = (
    Scenario("nothing is lost", 10, ("Accepted",), nothing),
    Scenario("nothing is lost, 100 items", 100, ("Accepted",), nothing, 60.0),
    Scenario("the count is lost", 10, ("Accepted",), lost_count),
    Scenario("a request is lost", 10, ("Accepted",), lost_request),
    Scenario("an item is lost", 10, ("Accepted",), lost_item),
    Scenario("the acknowledgement is lost", 10, ("Accepted",), lost_acknowledgement),
    Scenario("requests and items come twice", 10, ("Accepted",), repeated),
    Scenario("two frames are damaged", 10, ("Accepted",), damaged_frame),
    Scenario("3 of 100 frames are lost", 30, ("Accepted",), frames_lost, 60.0),
    Scenario("2 of 1000 bytes are lost or altered", 30, ("Accepted",), bytes_lost, 60.0),
    Scenario("each way takes 150 ms", 10, ("Accepted",), late),
    Scenario("the autopilot denies item 0", 10, ("Denied",), denied),
    Scenario("the autopilot is armed", 10, ("Armed",), armed),
    Scenario("no mission message arrives", 10, ("NoAnswer", "TimedOut"), cut, 60.0),
)  # fmt: skip


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
    before = counters(player)
    said, began = len(player.lines), player.now
    player.tell(f"upload {scenario.items}")

    def end() -> re.Match | None:
        return next((found for line in player.lines[said:] if (found := ENDED.match(line))), None)

    if player.until(lambda: end() is not None, scenario.limit_s):
        found = end()
        assert found is not None
        result.status = status_names()[int(found[1])]
    else:
        result.wrong.append(f"it has not ended within {scenario.limit_s:.0f} s")
        player.tell("cancel")
        player.run(0.5)
    result.seconds = player.now - began
    wire.spare()
    result.counters = {key: value - (before[key] if key in COUNTED else 0) for key, value in counters(player).items()}
    result.struck = sum(bool(entry.fate) for entry in wire.entries)
    result.round_trips_ms = round_trips(wire)
    judge(result, scenario, autopilot)
    return result


def judge(result: Result, scenario: Scenario, autopilot: FakeAutopilot) -> None:
    if result.status not in scenario.ends and not result.wrong:
        result.wrong.append(f"{scenario.ends[0]} was expected")
    held = [(one.command, one.x, one.y, one.z) for one in autopilot.received()][-scenario.items :]
    wanted = [(one.command, one.x, one.y, one.z) for one in map(item_of, range(scenario.items))]
    if result.status == "Accepted" and held != wanted:
        result.wrong.append("Accepted, and the plan is not aboard")
    if scenario.ends[0] != "Accepted" and held == wanted:
        result.wrong.append("the plan is aboard")


def counters(player: Player) -> dict[str, int]:
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
