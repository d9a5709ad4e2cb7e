"""The simulated Mega in real time: its pace, its ends, and tools/simulate itself."""

from __future__ import annotations

import contextlib
import functools
import os
import signal
import socket
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

from building import ROOT
from simulation import recordings
from simulation.bench import PERSONALITIES, firmware_image, status_names
from simulation.firmware import build_firmware
from simulation.mega import Mega
from simulation.mega.ends import BadEnd, Pty, TcpServer, Terminal, open_end
from simulation.mega.realtime import RealTime

SOURCES = Path(__file__).resolve().parents[1] / "machine"
# A shell that starts the tests in the background makes them, and all that they start, ignore interrupts.
HEARS_INTERRUPTS = functools.partial(signal.signal, signal.SIGINT, signal.SIG_DFL)


class Clock:
    """A clock that stands still but for what is slept, or added by the test."""

    def __init__(self) -> None:
        self.now = 1000.0
        self.slept = 0.0

    def __call__(self) -> float:
        return self.now

    def sleep(self, seconds: float) -> None:
        self.now += seconds
        self.slept += seconds


def quiet(text: str) -> None:
    pass


@pytest.fixture
def clock() -> Clock:
    return Clock()


@pytest.fixture
def world(clock):
    """The firmware answers each byte on Serial1 by the next one, at 115200 baud."""
    mega = Mega(build_firmware("sleeper", [SOURCES / "sleeper.cpp"], library=False))
    world = RealTime(mega, clock, clock.sleep)
    yield world
    world.close()


def slices_until(world: RealTime, done) -> int:
    for count in range(20_000):
        if done():
            return count
        world.slice()
    pytest.fail("20 s of simulated time were not enough")


def answer_of(world: RealTime, read: Callable[[], bytes], length: int) -> bytes:
    """What comes back through read(), which must not block, until it is so long or more."""
    answer = b""

    def is_whole() -> bool:
        nonlocal answer
        with contextlib.suppress(BlockingIOError):
            answer += read()
        return len(answer) >= length

    slices_until(world, is_whole)
    return answer


# Pace ---------------------------------------------------------------------------


def test_simulated_time_keeps_abreast_of_the_clock(world, clock):
    world.run(seconds=0.5)
    assert clock.slept == pytest.approx(0.5, abs=0.002)
    assert world.mega.now_ms == pytest.approx(500, abs=0.1)


# Ends ---------------------------------------------------------------------------


def by_pty(end: Pty) -> tuple:
    device = os.open(end.name, os.O_RDWR | os.O_NOCTTY)
    os.set_blocking(device, False)
    return functools.partial(os.write, device), functools.partial(os.read, device, 100), lambda: os.close(device)


def by_tcp(end: TcpServer) -> tuple:
    client = socket.create_connection(("127.0.0.1", end.port))
    client.setblocking(False)
    return client.sendall, functools.partial(client.recv, 100), client.close


def by_udp(end) -> tuple:
    peer = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    peer.connect(("127.0.0.1", int(end.name.removeprefix("udp-listen:"))))
    peer.setblocking(False)
    return peer.send, functools.partial(peer.recv, 100), peer.close


# (Port 0: the system chooses one that is free.)
@pytest.mark.parametrize(("make", "connect"), [
    (Pty, by_pty),
    (lambda: TcpServer(0, Clock(), quiet), by_tcp),
    (lambda: open_end(f"udp-listen:{free_port()}"), by_udp),
], ids=["pty", "tcp", "udp"])  # fmt: skip
def test_a_program_reaches_serial1_and_may_come_again(world, make, connect):
    end = make()
    world.connect(1, end)
    world.run(seconds=0.005)
    for text in (b"ABC", b"\x00\x11\x13\xff"):
        send, read, close = connect(end)
        send(text)
        assert answer_of(world, read, len(text)) == bytes((byte + 1) & 0xFF for byte in text)
        close()
        world.run(seconds=0.01)


def test_a_tcp_client_finds_its_peer_again_after_the_peer_restarts(world, clock):
    listener = socket.create_server(("127.0.0.1", 0))
    port = listener.getsockname()[1]
    said = []
    end = open_end(f"tcp:127.0.0.1:{port}", clock, said.append)
    world.connect(1, end)
    for _ in range(2):
        slices_until(world, lambda: end.connected)
        peer, _ = listener.accept()
        listener.close()
        peer.sendall(b"hello")
        peer.setblocking(False)
        assert answer_of(world, functools.partial(peer.recv, 100), 5) == b"ifmmp"
        peer.close()
        slices_until(world, lambda: not end.connected)
        world.run(seconds=2)
        assert said == [f"{end.name}: connected", f"{end.name}: connection lost"]
        said.clear()
        listener = socket.create_server(("127.0.0.1", port))
    listener.close()


def test_udp_answers_whoever_sent(world):
    peer = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    peer.bind(("127.0.0.1", 0))
    peer.setblocking(False)
    end = open_end(f"udp:127.0.0.1:{peer.getsockname()[1]}", say=quiet)
    world.connect(1, end)
    world.run(seconds=0.005)
    end.write(b"x")
    data, mega_address = peer.recvfrom(100)
    assert data == b"x"
    peer.sendto(b"A", mega_address)
    assert answer_of(world, functools.partial(peer.recv, 100), 1) == b"B"
    peer.close()


def test_a_serial_device_is_opened_again_when_it_comes_back(world, clock, tmp_path):
    device = tmp_path / "ttyACM0"
    said = []
    end = open_end(f"{device}@115200", clock, said.append)
    world.connect(1, end)
    world.run(seconds=1)
    assert said == []
    for _ in range(2):
        said.clear()
        master, slave = os.openpty()
        device.unlink(missing_ok=True)
        device.symlink_to(os.ttyname(slave))
        os.set_blocking(master, False)
        slices_until(world, lambda: said)
        os.write(master, b"A")
        assert answer_of(world, functools.partial(os.read, master, 10), 1) == b"B"
        device.unlink()
        os.close(master)
        os.close(slave)
        slices_until(world, lambda: len(said) == 2)
        assert said == [f"{device}@115200: open", f"{device}@115200: gone; waiting for it"]


def free_port() -> int:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as chosen:
        chosen.bind(("127.0.0.1", 0))
        return chosen.getsockname()[1]


# More than the line takes -----------------------------------------------------------


class Peer:
    """Another program, at the far end of UDP. What the way does not take is kept, as a SITL keeps it."""

    def __init__(self) -> None:
        port = free_port()
        self.form = f"udp-listen:{port}"
        self._kept = b""
        self._way = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._way.connect(("127.0.0.1", port))
        self._way.setblocking(False)

    def send(self, data: bytes) -> None:
        self._kept += data
        with contextlib.suppress(BlockingIOError):
            self._kept = self._kept[self._way.send(self._kept) :]

    def heard(self) -> bytes:
        data = b""
        with contextlib.suppress(BlockingIOError):
            while piece := self._way.recv(4096):
                data += piece
        return data

    def close(self) -> None:
        self._way.close()


class Talk(Terminal):
    """The console: what the firmware prints, and what it is told."""

    def __init__(self) -> None:
        self.text = b""
        self.typed = b""

    def read(self, most: int) -> bytes:
        data, self.typed = self.typed[:most], self.typed[most:]
        return data

    def write(self, data: bytes) -> None:
        self.text += data


FLOOD_BYTES_PER_S = 24_000


def test_ten_items_go_aboard_within_two_seconds_beside_a_flood(clock, personality):
    """The autopilot on Serial1 sends more than the line takes."""
    mega = Mega(firmware_image(57600))
    telemetry = recordings.saturated(recordings.WITH_STREAMS[personality], 10 * FLOOD_BYTES_PER_S)
    autopilot = PERSONALITIES[personality](telemetry=telemetry, uptime_s=60.0)
    said: list[str] = []
    console, peer = Talk(), Peer()
    world = RealTime(mega, clock, clock.sleep, said.append)
    world.connect(0, console)
    world.connect(1, open_end(peer.form, clock, quiet))
    slice_alone = world.slice

    def slice_both() -> None:
        now = mega.now_us / 1_000_000
        autopilot.receive(peer.heard(), now)
        autopilot.run(now)
        for _, frame in autopilot.outbox:
            peer.send(frame)
        slice_alone()

    world.slice = slice_both
    accepted = b"returned %d\n" % status_names().index("Accepted")
    slices_until(world, lambda: b"ready" in console.text)
    console.typed = b"function 10 65535\n"
    world.run(3.0)  # the flood is as old as it gets
    began_ms = world.mega.now_ms
    console.typed = b"upload 0\n"
    slices_until(world, lambda: accepted in console.text.replace(b"\r", b""))
    assert world.mega.now_ms - began_ms < 2000
    assert len(autopilot.received()) == 10 + (personality == "ArduPilot")
    assert world.mega.serial(1).lost == 0
    assert said[0].endswith("telemetry first: more come than the 5,882 bytes/s of the line")
    for one in (world, peer):
        one.close()


@pytest.mark.parametrize("form", ["", "tcp:host", "tcp:host:70000", "udp-listen:0", "/dev/ttyACM0@fast", "com1"])
def test_a_wrong_end_is_refused_with_what_it_may_be(form):
    with pytest.raises(BadEnd, match="not a number from 1|must be one of"):
        open_end(form)


# The command ----------------------------------------------------------------------


def simulate(*arguments: object, text: bytes = b"") -> subprocess.CompletedProcess:
    command = [ROOT / "tools" / "simulate", *map(str, arguments)]
    return subprocess.run(command, input=text, capture_output=True, timeout=60, check=False)


def test_simulate_shows_serial_and_sends_it_what_is_typed():
    elf = build_firmware("echo", [SOURCES / "echo.cpp"], library=False)
    ran = simulate(elf, "--for", 0.2, text=b"hello\n")
    assert ran.returncode == 0
    first, _, rest = ran.stdout.partition(b"\n")
    assert first.startswith(b"Serial1 is /dev/pts/")
    assert rest == b"ready\r\nhello\n"
    assert ran.stderr.startswith(b"0.200 s simulated, deepest stack ")


def test_simulate_that_is_interrupted_says_its_last_words():
    command = [ROOT / "tools" / "simulate", build_firmware("echo", [SOURCES / "echo.cpp"], library=False)]
    with subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          preexec_fn=HEARS_INTERRUPTS) as running:  # fmt: skip
        assert next(line for line in running.stdout if line.startswith(b"ready"))
        running.send_signal(signal.SIGINT)
        assert b" s simulated, deepest stack " in running.stderr.read()
    assert running.returncode == 0


def test_simulate_connects_serial_to_something_else_too():
    elf = build_firmware("echo", [SOURCES / "echo.cpp"], library=False)
    ran = simulate(elf, "--for", 0.05, "--serial0", "none", "--serial1", "none", text=b"hello\n")
    assert ran.stdout == b"Serial is not connected\nSerial1 is not connected\n"
    assert simulate(elf, "--console", "--serial0", "none").returncode == 2
