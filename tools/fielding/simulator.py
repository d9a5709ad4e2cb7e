"""What each simulator is: a binary's process in a folder of its own, whose physics and clock we are."""

from __future__ import annotations

import os
import signal
import socket
import subprocess
import time
from collections.abc import Callable, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any

from .vehicles import VEHICLES

HOME = (-35.3632621, 149.1652374, 584.0)  # where the examples fly [degrees, m]
GONE_S = 60.0  # by the computer's clock: what says nothing for so long stands still


class Gone(Exception):
    """The simulator has ended, stands still, or does not come up; the text says what it said last."""


class Port:
    """A connected socket, for MAVLink: neither read() nor write() waits."""

    def __init__(self, end: socket.socket) -> None:
        end.setblocking(False)
        self._end, self.close = end, end.close

    def write(self, data: bytes) -> None:
        with suppress(ConnectionRefusedError):  # of UDP: it is not there yet
            self._end.sendall(data)

    def read(self) -> bytes:
        data = b""
        try:
            while more := self._end.recv(65536):
                data += more
        except (BlockingIOError, ConnectionRefusedError):
            return data
        raise Gone("the simulator has closed its port")


def free_port(kind: socket.SocketKind) -> int:
    with socket.socket(socket.AF_INET, kind) as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


class Simulator:
    """At rest at home, with two ports: `line` for the Mega, `truth` for a ground station.

    Its time goes on by step(), which is answered when it has done all that there was to do.
    """

    firmware = ""
    clock = ""  # how its time is held, in words
    slice_s = 0.0025  # in such steps the Mega and it go on
    line: Port
    truth: Port

    def __init__(self, name: str, binary: Path, folder: Path) -> None:
        self.name, self.vehicle, self.folder = name, VEHICLES[name](), folder
        self.has_remote = True  # a remote control in somebody's hand; False: it has failed
        self._log = open(folder / "simulator.log", "wb")
        self._process: Any = None
        try:
            self.start(binary)
        except BaseException:
            self.close()
            raise

    def start(self, binary: Path) -> None:
        raise NotImplementedError

    def step(self) -> None:
        raise NotImplementedError

    def run(self, words: Sequence[str | Path], **environment: str) -> None:
        self._process = subprocess.Popen(
            words, cwd=self.folder, env={**os.environ, **environment}, start_new_session=True,
            stdin=subprocess.DEVNULL, stdout=self._log, stderr=self._log)  # fmt: skip

    @property
    def now(self) -> float:
        return self.vehicle.time

    def advance(self, until: float) -> None:
        while self.now < until - 1e-9:
            self.step()

    def awaited(self, found: Callable[[], Any], patience_s: float = GONE_S) -> Any:
        """What found() gives that is not None. It may take so long at most, by the computer's clock."""
        until = time.monotonic() + patience_s
        while time.monotonic() < until and (self._process is None or self._process.poll() is None):
            if (given := found()) is not None:
                return given
        said = (self.folder / "simulator.log").read_bytes()[-400:].decode(errors="replace").strip()
        raise Gone(f"{self.name} has {'ended' if self._process.poll() is not None else 'stood still'}: {said}")

    def close(self) -> None:
        if self._process is not None:  # it would end by itself only when its physics goes on
            with suppress(ProcessLookupError):
                os.killpg(self._process.pid, signal.SIGKILL)  # and what it has started
            self._process.wait()
        for one in (self._log, getattr(self, "line", None), getattr(self, "truth", None)):
            if one is not None:
                one.close()
