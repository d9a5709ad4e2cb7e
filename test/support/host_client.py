"""A MissionClient compiled for this computer, a faulty wire and a fake autopilot, for runs too long for firmware.

    client = HostClient("PX4", first_millis=2**32 - 9 * 3600 * 1000)
    client.upload(plan, proof="Always")
    assert client.run_until_ended(limit_s=10) == "Accepted"
    client.run(3600)                      # update() each millisecond

Its other end is day/client.cpp. Time is simulated, in seconds since begin().
"""

from __future__ import annotations

import functools
import math
import subprocess
from collections.abc import Sequence
from pathlib import Path

from simulation.bench import _ITEM, PERSONALITIES, aboard_names, packed, status_names
from simulation.fake_autopilot import Item
from simulation.firmware import ROOT
from simulation.host_build import FAST, build_host
from simulation.service import ALL, MISSION, PROOFS, unpacked
from simulation.wire import Wire

FILLED = 36  # bytes of a MissionItem on this computer, where it is aligned
PLAN_ITEMS = 60  # room in the program


@functools.cache
def program() -> Path:
    sources = [ROOT / "test" / "day" / "client.cpp"]
    own = ['-DCLIENT_LINE="SerialLine.h"', "-fno-access-control"]
    return build_host("client", sources, "g++", FAST, own_flags=own)


class HostClient:
    """options: of the fake autopilot."""

    def __init__(self, personality: str, first_millis: int = 0, wire: Wire | None = None, **options) -> None:
        self.personality = personality
        kind = PERSONALITIES[personality]
        self.autopilot = kind(**{"heartbeat_at_s": 0.05, "uptime_s": 60.0, **options})
        self.wire = wire or Wire()
        self.now_ms = 0
        self.ends: list[str] = []
        self.sent: list = []  # (time [s], message), until it is emptied
        self.frames_sent = 0  # by the client
        self.bytes_heard = 0  # by the client
        self._ends_seen = 0
        self._running = subprocess.Popen([self._program()], stdin=subprocess.PIPE, stdout=subprocess.PIPE, bufsize=0)
        self._answers = open(self._running.stdout.fileno(), "rb", closefd=False)
        self.ask("begin", first_millis % 2**32)

    def _program(self) -> Path:
        return program()

    def close(self) -> None:
        self._running.stdin.close()
        assert self._running.wait() == 0
        self._answers.close()
        self._running.stdout.close()

    def __enter__(self) -> HostClient:
        return self

    def __exit__(self, *_) -> None:
        self.close()

    def ask(self, *words: object) -> str:
        self._running.stdin.write(" ".join(map(str, words)).encode() + b"\n")
        answer = self._answers.readline().decode().rstrip("\n")
        assert answer and not answer.startswith(("what?", "too many")), f"{words[0]}: {answer or 'it has ended'}"
        return answer

    # -- time

    @property
    def now(self) -> float:
        return self.now_ms / 1000

    def run(self, seconds: float) -> None:
        self.run_until(self.now + seconds)

    def run_until(self, time: float) -> None:
        while self.now < time:
            self._step(time)

    def run_until_ended(self, limit_s: float) -> str:
        """Each end is waited for once."""
        limit = self.now + limit_s
        while len(self.ends) <= self._ends_seen:
            assert self.now < limit, f"nothing ended within {limit_s} s: {self.state}"
            self._step(limit)
        self._ends_seen += 1
        return self.ends[self._ends_seen - 1]

    def _step(self, until: float) -> None:
        due = [
            time for time in (until, self.autopilot.next_event(self.now), self.wire.next_event()) if time is not None
        ]
        arriving = self.wire.deliver("<", self.now)
        self.bytes_heard += len(arriving)
        until_ms = max(math.ceil(min(due) * 1000 - 1e-6), self.now_ms + 1)
        now_ms, left, end = self.ask("run", until_ms, arriving.hex() or "-").split()
        self.now_ms = int(now_ms)
        if left != "-":
            before = len(self.wire.entries)
            self.wire.send(">", bytes.fromhex(left), self.now)
            fresh = [entry for entry in self.wire.entries[before:] if entry.number is not None]
            self.frames_sent += len(fresh)
            self.sent += [(entry.time, entry.message) for entry in fresh]
        if int(end) >= 0:
            self.ends.append(status_names()[int(end)])
        heard = self.wire.deliver(">", self.now)
        if heard:
            self.autopilot.receive(heard, self.now)
        self.autopilot.run(self.now)
        for time, frame in self.autopilot.outbox:
            self.wire.send("<", frame, time)

    # -- orders: each returns the status that it begins with

    def order(self, *words: object) -> str:
        return status_names()[int(self.ask("order", *words))]

    def use(self, plan: Sequence[Item]) -> int:
        """Put a plan where the orders find it; how many items it has."""
        assert len(plan) <= PLAN_ITEMS
        if plan:
            self.ask("plan", b"".join(packed(item) for item in plan).hex())
        return len(plan)

    def upload(self, plan: Sequence[Item], mission_type: int = MISSION, proof: str = "InDoubt") -> str:
        return self.order("upload", mission_type, self.use(plan), PROOFS.index(proof))

    def upload_part(self, plan: Sequence[Item], first: int, count: int) -> str:
        return self.order("part", self.use(plan), first, count)

    def verify(self, plan: Sequence[Item], mission_type: int = MISSION) -> str:
        return self.order("verify", mission_type, self.use(plan))

    def ensure(self, plan: Sequence[Item], mission_type: int = MISSION) -> str:
        return self.order("ensure", mission_type, self.use(plan))

    # -- what came of it

    def _values(self, word: str) -> dict[str, int]:
        return {key: int(value) for key, _, value in (pair.partition("=") for pair in self.ask(word).split())}

    @property
    def state(self) -> dict[str, int]:
        return self._values("state")

    @property
    def counters(self) -> dict[str, int]:
        """LinkCounters."""
        return self._values("counters")

    @property
    def tally(self) -> dict[str, int]:
        return self._values("tally")

    def aboard(self, mission_type: int) -> str:
        assert mission_type != ALL
        return aboard_names()[self.state[("mission", "fence", "rally")[mission_type]]]

    @property
    def sunk(self) -> list[Item]:
        """The items that the last download gave."""
        text = self.ask("sunk")
        data = b"" if text == "-" else bytes.fromhex(text)
        return [unpacked(data[at : at + _ITEM.size]) for at in range(0, len(data), FILLED)]

    @property
    def idle(self) -> tuple[str, bytes]:
        """Whether anything is going on, and the client's bytes but for times, counters and buffers."""
        *going_on, data = self.ask("idle").split()
        return " ".join(going_on), bytes.fromhex(data)
