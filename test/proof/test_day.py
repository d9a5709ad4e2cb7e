"""A simulated day of transfers: 24 hours of every operation, one after the other, with idle stretches and losses; with
PX4 six hours, since what could grow is the same.

The library's own MissionClient, compiled for this computer, update() each millisecond, on a wire to the fake
autopilots. millis() wraps within the day. What must hold: every operation ends; what it says is so; without a loss it
ends as it should; nothing is allocated; the counters count what went over the line, and wrap as they are said to; and
at the end of the day the client is what it was after its first hour, in its bytes and in what it does.

    build/venv/bin/python -m pytest -q test/proof/test_day.py     # prints how many operations of each kind there were
"""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Callable, Sequence

import pytest

from areas import FIELD, POINTS
from host_client import HostClient
from plans import SURVEY, on_the_wire, waypoint
from simulation.bench import same_bits
from simulation.fake_autopilot import Item
from simulation.service import FENCE, MISSION, RALLY
from simulation.wire import Entry, Wire
from starts import HOPS

DAY_S = {"ArduPilot": 24 * 3600, "PX4": 6 * 3600}
WRAP_S = 4 * 3600.5  # when millis() wraps
LONGEST_S = 150.0  # that an operation may take: the default limit of the longest plan here
LEFTOVERS_S = 12.0  # after which nothing of an earlier operation is answered any more
GONE_S = 5.0  # without a heartbeat, an answer or what a follower listens to: AutopilotFinder::kLostMs
ANSWERS = {"MISSION_ACK", "MISSION_COUNT", "MISSION_ITEM_INT", "MISSION_REQUEST", "MISSION_REQUEST_INT", "COMMAND_ACK",
           "MISSION_CURRENT", "MISSION_ITEM_REACHED", "STATUSTEXT"}  # fmt: skip
SAME_S = 0.02  # seconds, heartbeats and the autopilot's turn fall a little differently
RADIO_TURN_S = 0.06  # of a SiK radio, each way in turn
SLOT_S = 40.0  # for each operation of those that are watched
STEP_S = 0.001  # from one update() to the next
LONG = [waypoint(473977420 + 100 * n, 85455970, 20.0 + n) for n in range(12)]
PART_FIRST, PART_COUNT = 3, 5
MOVED = [*LONG[:PART_FIRST],
         *(one._replace(y=85465970) for one in LONG[PART_FIRST : PART_FIRST + PART_COUNT]),
         *LONG[PART_FIRST + PART_COUNT :]]  # fmt: skip
MISSIONS = [SURVEY, LONG, LONG[:1], LONG[2:9], []]
ONCE_ONLY = 183  # DO_SET_SERVO: neither fake has a servo
GUIDED, HOLD = 1, 3
REQUEST_MESSAGE, SET_MESSAGE_INTERVAL, MISSION_CURRENT = 512, 511, 42
REFUSED = {"CommandUnsupported", "CommandFailed", "CommandDenied", "CommandRejected"}


class Day:
    def __init__(self, personality: str, seed: int) -> None:
        self.random = random.Random(seed)
        self.is_lossy = False
        wire = Wire(seed)
        for way in "<>":
            wire.at_random(way, lose=15, where=lambda message: self.is_lossy)
        self.client = HostClient(personality, first_millis=2**32 - round(WRAP_S * 1000), wire=wire)
        self.personality = personality
        self.ours: dict[int, Sequence[Item]] = {}  # what was accepted or verified last, by type
        self.ended: Counter[tuple[str, str]] = Counter()  # (operation, status)
        self.frames_to_us = 0  # that arrived
        self.lost_to_us = 0  # and those that came before a heartbeat when the autopilot had been taken for gone
        self.at_the_limit = 0  # frames that were arriving when it was taken for gone: they may be given up
        self._losses_before = 0
        self._heartbeat_s = 0.0  # when the last one came, or an answer

    # -- one operation

    def do(self, name: str, begin: Callable[[], str], expected: set[str], plan: Sequence[Item] | None = None,
           mission_type: int = MISSION) -> str:  # fmt: skip
        """Begin it, wait for its end, and look at what it says. plan: of an upload or a verification."""
        client = self.client
        losses = self._losses()
        begun = begin()
        assert begun != "Busy", name
        status = client.run_until_ended(LONGEST_S)
        self.ended[name, status] += 1
        assert client.state["busy"] == 0
        if self._losses() == losses and not client.wire._ways[">"].cut:
            assert status in expected, f"{name} ended {status} at {client.now:.3f} s, and nothing was lost"
        if status in ("Accepted", "AlreadyAboard", "Verified"):
            self.ours[mission_type] = plan
            assert client.aboard(mission_type) == "OurPlan"
        self.expect_truth(name, status)
        self._tidy()
        return status

    def expect_truth(self, name: str, status: str) -> None:
        autopilot = self.client.autopilot
        for mission_type in (MISSION, FENCE, RALLY):
            aboard = self.client.aboard(mission_type)
            held = autopilot.received(mission_type)
            if aboard == "OurPlan":
                assert same_bits(held, self.wired(self.ours[mission_type], mission_type)), f"{name}: {status}"
            elif aboard == "Nothing":
                assert len(autopilot.plan(mission_type)) <= 1, f"{name}: {status}"  # ArduPilot keeps home

    def wired(self, plan: Sequence[Item], mission_type: int = MISSION) -> Sequence[Item]:
        return on_the_wire(plan, self.personality) if mission_type == MISSION else plan

    def _losses(self) -> int:
        return sum(bool(entry.fate) for entry in self.client.wire.entries) + self._losses_before

    def _tidy(self) -> None:
        """Forget what went over the line, but for its numbers."""
        entries = self.client.wire.entries
        self._losses_before += sum(bool(entry.fate) for entry in entries)
        for entry in entries:
            if entry.direction == "<":
                self._note_to_us(entry)
        entries.clear()
        self.client.sent.clear()
        self.client.autopilot.log.clear()

    def _note_to_us(self, entry: Entry) -> None:
        if entry.fate:
            self.lost_to_us += 1
            return
        self.frames_to_us += 1
        silent_s = entry.time - self._heartbeat_s
        if entry.message.get_type() == "HEARTBEAT":
            self._heartbeat_s = entry.time
        elif abs(silent_s - GONE_S) < SAME_S:
            self.at_the_limit += 1
        elif silent_s > GONE_S:
            self.lost_to_us += 1
        elif entry.message.get_type() in ANSWERS:
            self._heartbeat_s = entry.time

    # -- the operations, each by its name

    def upload(self, plan: Sequence[Item] | None = None, mission_type: int = MISSION, proof: str = "InDoubt") -> str:
        plan = self.random.choice(MISSIONS) if plan is None else plan
        kind = ("upload", "fence", "rally")[mission_type]
        # An acceptance of an empty plan may be that of the operation before, and it is not read back.
        expected = {"Accepted"} if plan or proof != "ByAnswer" else {"Accepted", "Unconfirmed"}
        return self.do(f"{kind}, {proof}", lambda: self.client.upload(plan, mission_type, proof), expected, plan,
                       mission_type)  # fmt: skip

    def upload_by_answer(self) -> None:
        self.upload(proof="ByAnswer")

    def upload_verified(self) -> None:
        self.upload(proof="Always")

    def upload_again(self) -> None:
        self.upload(LONG)
        self.do("upload again", lambda: self.client.order("again"), {"Accepted"}, LONG)

    def part(self) -> None:
        if self.upload(LONG) != "Accepted":
            return
        expected = {"Accepted"} if self.personality == "ArduPilot" else {"WholePlansOnly"}
        self.do("part", lambda: self.client.upload_part(MOVED, PART_FIRST, PART_COUNT), expected, MOVED)

    def verify(self) -> None:
        held = self.client.autopilot.received()
        plan = self.random.choice(MISSIONS)
        home = self.personality == "ArduPilot" and len(held) == 1
        is_same = same_bits(held, self.wired(plan)) or (home and not plan)
        ended = self.do("verify", lambda: self.client.verify(plan), {"Verified"} if is_same else {"Differs"}, plan)
        assert ended != ("Differs" if is_same else "Verified")

    def ensure(self) -> None:
        plan = self.random.choice(MISSIONS)
        held = self.client.autopilot.received()
        is_same = same_bits(held, self.wired(plan))
        ended = self.do("ensure", lambda: self.client.ensure(plan), {"AlreadyAboard", "Accepted"}, plan)
        if ended == "AlreadyAboard":
            assert is_same or (not plan and len(held) <= 1)
            assert same_bits(self.client.autopilot.received(), held)

    def download(self) -> None:
        if self.upload(LONG) != "Accepted":
            return
        if self.do("download", lambda: self.client.order("download", MISSION), {"Downloaded"}) == "Downloaded":
            assert [item[:2] + item[8:] for item in self.client.sunk] == [item[:2] + item[8:] for item in LONG]

    def clear(self) -> None:
        mission_type = self.random.choice((MISSION, FENCE, RALLY, 255))
        self.do("clear", lambda: self.client.order("clear", mission_type), {"Cleared"})

    def fence(self) -> None:
        self.upload(FIELD, FENCE, self.random.choice(("InDoubt", "Always")))
        expected = {"Verified"} if same_bits(self.client.autopilot.received(FENCE), FIELD) else {"Differs"}
        self.do("fence, verified", lambda: self.client.verify(FIELD, FENCE), expected, FIELD, FENCE)

    def rally(self) -> None:
        self.upload(POINTS, RALLY, self.random.choice(("InDoubt", "Always")))
        self.do("rally, downloaded", lambda: self.client.order("download", RALLY), {"Downloaded"})

    def set_current(self) -> None:
        if self.upload(LONG) == "Accepted":
            self.do("set current", lambda: self.client.order("setcurrent", self.random.randrange(12)), {"Done"})

    def cancel(self) -> None:
        def begin() -> str:
            begun = self.client.upload(SURVEY)
            self.client.run(self.random.uniform(0.0, 0.4))
            self.client.order("cancel")
            return begun

        self.do("upload, cancelled", begin, {"Cancelled", "Accepted"}, SURVEY)

    def commands(self) -> None:
        for order in (("mode", GUIDED), ("arm",), ("interval", 1000000)):
            self.do(order[0], lambda order=order: self.client.order(*order), {"Done"})
        self.client.run(1.2)  # its heartbeat says so
        expected = {"Armed"} if self.client.state["armed"] else {"Accepted"}
        self.do("upload while armed", lambda: self.client.upload(SURVEY), expected, SURVEY)
        self.disarm()
        ordered = self.client.frames_sent
        self.do("a command that must not happen twice", lambda: self.client.order("order", ONCE_ONLY), REFUSED)
        sent = [message for _, message in self.client.sent if getattr(message, "command", None) == ONCE_ONLY]
        assert len(sent) <= 1 and self.client.frames_sent > ordered

    def disarm(self) -> None:
        """On the ground; until it is, and its heartbeat has said so."""
        while self.client.autopilot.armed or self.client.state["armed"]:
            self.do("disarm", lambda: self.client.order("disarm"), {"Done"})
            self.client.run(1.2)

    def start(self) -> None:
        if self.upload(HOPS[self.personality]) != "Accepted":
            return
        flown = self.client.state["reached"]
        if self.do("start", lambda: self.client.order("start"), {"Done"}) == "Done":
            assert self.client.autopilot.armed
            self.client.run(10.0)
            assert self.client.autopilot.flight.index is not None or self.client.state["reached"] != flown
        limit = self.client.now + 200.0
        # (A copter that has landed waits at its first item, disarmed.)
        while self.client.autopilot.armed and self.client.autopilot.flight.index is not None:
            assert self.client.now < limit, "it flies on and on"
            self.client.run(1.0)
        self.client.run(3.0)
        self.disarm()

    # -- the day

    ALL = (upload, upload_by_answer, upload_verified, upload_again, part, verify, ensure, download, clear, fence,
           rally, set_current, cancel, commands, start)  # fmt: skip

    def one(self) -> None:
        """Any of them; each third on a line that loses 15 of 100 frames, each tenth over a radio, each twentieth with
        the cable pulled."""
        drawn = self.random.random()
        operation = self.random.choice(self.ALL)
        if drawn < 0.05:
            self.pulled()
        else:
            self.is_lossy = drawn < 0.38
            is_by_radio = drawn > 0.9
            self.client.wire.set_radio(RADIO_TURN_S if is_by_radio else 0.0)
            operation(self)
            if self.is_lossy or is_by_radio:
                self.is_lossy = False
                self.client.run(LEFTOVERS_S)
                self.client.wire.set_radio(0.0)
                self.disarm()
        self.client.run(self.random.uniform(1.0, 60.0))

    def pulled(self) -> None:
        """The cable is pulled in the middle of an upload, and put back while its end is waited for, or later."""

        def begin() -> str:
            begun = self.client.upload(LONG)
            self.client.run(self.random.uniform(1.0, 1.8))
            self.client.wire.pull()
            self.client.run(self.random.uniform(1.0, 30.0))
            self.client.wire.plug()
            return begun

        self.do("upload, cable pulled", begin, {"Accepted"}, LONG)
        self.client.run(LEFTOVERS_S)

    def watched(self) -> tuple[list, str, bytes]:
        """Every operation once, undisturbed, at the same moment of the client's second.

        What was sent, but for heartbeats, and when [s]; whether anything is still going on; the client's bytes.
        """
        self.do("mode", lambda: self.client.order("mode", HOLD), {"Done"})
        self.client.run_until(2 * (self.client.now // 2) + 2.0)
        seen: list[tuple[float, str, str]] = []
        drawn, self.random = self.random, random.Random(1)
        began = self.client.now
        for number, operation in enumerate(self.ALL, 1):
            before, self._tidy = self._tidy, lambda: None
            self.client.sent.clear()
            operation(self)
            seen += [(time - began, str(message), operation.__name__) for time, message in self.client.sent
                     if not is_by_the_clock(message, operation.__name__)]  # fmt: skip
            self._tidy = before
            self._tidy()
            assert self.client.now < began + number * SLOT_S - 1.0
            self.client.run_until(began + number * SLOT_S)
        self.random = drawn
        self.client.run_until(self.client.now + 0.5)
        return seen, *self.client.idle

    def expect_counted(self) -> None:
        """The client's counters are what went over the line, in their 16 and 32 bits."""
        self.client.run_until(int(self.client.now) + 1.5)
        self._tidy()
        counters = self.client.counters
        assert counters["sent"] == self.client.frames_sent % 2**16
        assert counters["bytes"] == self.client.bytes_heard % 2**32
        given_up = (counters["lost"] - self.lost_to_us) % 2**16
        assert given_up <= self.at_the_limit
        assert (counters["frames"] + counters["unknown"] + given_up) % 2**16 == self.frames_to_us % 2**16


def is_by_the_clock(message, operation: str) -> bool:
    """Our heartbeat; what start() requests as often as the autopilot's does not come by itself meanwhile; and what the
    follower asks for when MISSION_CURRENT has not come for a second."""
    command = getattr(message, "command", None)
    is_follower = command == SET_MESSAGE_INTERVAL and message.param1 == MISSION_CURRENT
    return message.get_type() == "HEARTBEAT" or is_follower or (operation == "start" and command == REQUEST_MESSAGE)


def live_through(day: Day, until_s: float) -> None:
    while day.client.now < until_s:
        day.one()
    day.expect_counted()


def rows(day: Day) -> list[list[str]]:
    """How often each operation ended how."""
    lines = [["operation", "how often", "ends"]]
    for name in dict.fromkeys(name for name, _ in sorted(day.ended)):
        ends = {status: times for (other, status), times in day.ended.items() if other == name}
        said = ", ".join(f"{status} {times}" for status, times in sorted(ends.items(), key=lambda pair: -pair[1]))
        lines.append([name, str(sum(ends.values())), said])
    return [*lines, ["all", str(day.ended.total()), ""]]


@pytest.mark.slow
def test_nothing_grows_in_a_day_of_transfers(personality, record_property):
    day = Day(personality, seed=24)
    with day.client:
        live_through(day, 3600.0)
        first = day.watched()
        live_through(day, DAY_S[personality])
        last = day.watched()
        tally = day.client.tally
        assert day.client.now > DAY_S[personality] > WRAP_S
    assert first[1] == "busy=0 parser=0 outbox=0"
    assert [what for _, what, _ in last[0]] == [what for _, what, _ in first[0]]
    for (then, what, operation), (now, _, _) in zip(first[0], last[0], strict=True):
        # start() waits for what the autopilot says once a second, at moments of its own, and for the flight's end.
        assert now == pytest.approx(then, abs=1.0 if operation == "start" else SAME_S + STEP_S), (operation, what)
    assert last[1:] == first[1:]
    assert tally["allocations"] == 0
    assert tally["ends"] == day.ended.total() > DAY_S[personality] / 29
    assert tally["updates"] == day.client.now_ms
    assert personality == "PX4" or day.client.frames_sent > 2**16, "no counter has wrapped"
    record_property("table", [f"a day of transfers, {personality}: {tally['updates']:,} update()s", rows(day)])
