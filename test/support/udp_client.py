"""A MissionClient over UdpLink, compiled for this computer, in a network with a fake autopilot, and with others.

    client = UdpClient("PX4", Network(seed, lose=3))
    client.add("PX4", Place(3, 14550))    # another aircraft in the same network
    client.upload(plan)
    assert client.run_until_ended(limit_s=60) == "Accepted"

The autopilot is behind a telemetry bridge at BRIDGE, which sends all frames that leave together in one datagram.
"""

from __future__ import annotations

import functools
import math
from pathlib import Path

from datagrams import Network, Place, frames_in
from host_client import HostClient
from simulation.bench import PERSONALITIES, status_names
from simulation.fake_autopilot import FakeAutopilot
from simulation.fake_autopilot.frames import decode
from simulation.firmware import ROOT
from simulation.host_build import FAST, build_host

US, BRIDGE = Place(1, 14550), Place(2, 14555)


@functools.cache
def udp_program() -> Path:
    own = ['-DCLIENT_LINE="UdpLine.h"', "-DCLIENT_OVER_UDP", "-fno-access-control"]
    client = [ROOT / "test" / "day" / "client.cpp"]
    return build_host("udp_client", client, "g++", FAST, own_flags=own)


class UdpClient(HostClient):
    def __init__(self, personality: str, network: Network | None = None, *, first_millis: int = 0, **options) -> None:
        self.network = network or Network()
        self.others: dict[Place, FakeAutopilot] = {}
        self.targets: list[tuple[Place, bytes]] = []  # of each datagram that the client has sent, and its bytes
        super().__init__(personality, first_millis, **options)

    def _program(self) -> Path:
        return udp_program()

    def add(self, personality: str, place: Place, **options) -> FakeAutopilot:
        """Another aircraft in the network, which sends all that it says to us."""
        kind = PERSONALITIES[personality]
        self.others[place] = kind(**{"heartbeat_at_s": 0.3, "uptime_s": 60.0, **options})
        self.others[place].run(self.now)  # what it would have said before is not there
        return self.others[place]

    def bring(self, data: bytes, source: Place) -> None:
        """A datagram of anybody's, sent to us now."""
        self.network.send(source, US, data, self.now)

    @property
    def peer(self) -> dict[str, int]:
        return self._values("peer")

    def _step(self, until: float) -> None:
        speakers = {BRIDGE: self.autopilot, **self.others}
        due = [until, self.network.next_event(), *(one.next_event(self.now) for one in speakers.values())]
        arriving = []
        for datagram in self.network.arrived(self.now):
            if datagram.target == US:
                arriving.append(f"{datagram.source.host}:{datagram.source.port}:{datagram.data.hex()}")
            elif datagram.target in speakers:
                speakers[datagram.target].receive(datagram.data, self.now)
        next_s = min(time for time in due if time is not None)
        until_ms = max(math.ceil(next_s * 1000 - 1e-6), self.now_ms + 1)
        now_ms, *left, last, end = self.ask("run", until_ms, *arriving, "-").split()
        assert last == "-"
        self.now_ms = int(now_ms)
        for word in left:
            host, port, text = word.split(":")
            target, data = Place(int(host), int(port)), bytes.fromhex(text)
            self.targets.append((target, data))
            self.sent += [(self.now, decode(frame)) for frame in frames_in(data)]
            self.network.send(US, target, data, self.now)
        if int(end) >= 0:
            self.ends.append(status_names()[int(end)])
        for place, one in speakers.items():
            together = one.run(self.now)
            if together:
                self.network.send(place, US, together, self.now)
