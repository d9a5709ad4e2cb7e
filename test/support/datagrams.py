"""A network that loses, repeats, delays and reorders datagrams, in simulated time, by a seed."""

from __future__ import annotations

import heapq
import random
from typing import NamedTuple


class Place(NamedTuple):
    """A host of the network 10.0.0.0, and a port."""

    host: int
    port: int


class Datagram(NamedTuple):
    time: float  # of its arrival [s]
    number: int
    source: Place
    target: Place
    data: bytes


class Network:
    """lose, repeat, reorder: percent of the datagrams. latency_s: each way [s].

    What is reordered takes up to jitter_s [s] more.
    """

    def __init__(self, seed: int = 0, *, lose: float = 0, repeat: float = 0, reorder: float = 0,
                 latency_s: float = 0.005, jitter_s: float = 0.1) -> None:  # fmt: skip
        self.lose, self.repeat, self.reorder = lose / 100, repeat / 100, reorder / 100
        self.latency_s, self.jitter_s = latency_s, jitter_s
        self.lost = self.repeated = self.reordered = 0
        self._random = random.Random(seed)
        self._under_way: list[Datagram] = []
        self._number = 0

    def send(self, source: Place, target: Place, data: bytes, now: float) -> None:
        if self._random.random() < self.lose:
            self.lost += 1
            return
        copies = 1 + (self._random.random() < self.repeat)
        self.repeated += copies - 1
        for _ in range(copies):
            late = self._random.random() < self.reorder
            self.reordered += late
            time = now + self.latency_s + late * self._random.uniform(0, self.jitter_s)
            self._number += 1
            heapq.heappush(self._under_way, Datagram(time, self._number, source, target, data))

    def arrived(self, now: float) -> list[Datagram]:
        there = []
        while self._under_way and self._under_way[0].time <= now:
            there.append(heapq.heappop(self._under_way))
        return there

    def next_event(self) -> float | None:
        return self._under_way[0].time if self._under_way else None


def frames_in(data: bytes) -> list[bytes]:
    """The frames of a datagram; a ValueError if it is anything but whole frames."""
    frames = []
    while data:
        if data[0] not in (0xFD, 0xFE) or len(data) < 8:
            raise ValueError(f"no frame begins with {data.hex()}")
        signature = 13 * (data[0] == 0xFD and data[2] & 1)
        length = (12 if data[0] == 0xFD else 8) + data[1] + signature
        if length > len(data):
            raise ValueError(f"a frame of {length} bytes in {len(data)}")
        frames.append(data[:length])
        data = data[length:]
    return frames
