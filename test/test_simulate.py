"""The simulated Mega in real time: its pace, its ends, and tools/simulate itself."""

from __future__ import annotations

import contextlib
import os
import queue
import re
import signal
import socket
import subprocess
import sys
import threading
from collections.abc import Callable
from pathlib import Path

import pytest
from bench import firmware_image, status_names
from firmware import build_firmware
from mega import Mega
from mega.ends import BadEnd, Pty, TcpServer, open_end
from mega.realtime import RealTime

ROOT = Path(__file__).resolve().parent.parent
SOURCES = Path(__file__).resolve().parent / "machine"
AUTOPILOT = Path(__file__).resolve().parent / "autopilot_process.py"


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


def test_a_short_delay_is_caught_up(world, clock):
    world.run(seconds=0.1)
    clock.now += 0.2
    slept = clock.slept
    world.run(seconds=0.2)
    assert clock.slept - slept == pytest.approx(0, abs=0.002)
    assert world.skipped_s == 0


def test_a_long_delay_is_given_up_and_said(world, clock):
    world.run(seconds=0.1)
    clock.now += 60
    world.run(seconds=0.1)
    assert world.skipped_s == pytest.approx(60, abs=0.01)
    assert clock.slept == pytest.approx(0.2, abs=0.005)


# Ends ---------------------------------------------------------------------------


def test_a_program_reaches_serial1_over_the_pty_and_may_come_again(world):
    end = Pty()
    world.connect(1, end)
    world.run(seconds=0.005)
    for text in (b"ABC", b"\x00\x11\x13\xff"):
        device = os.open(end.name, os.O_RDWR | os.O_NOCTTY)
        os.write(device, text)
        world.run(seconds=0.01)
        assert os.read(device, 100) == bytes((byte + 1) & 0xFF for byte in text)
        os.close(device)


def test_a_pty_that_nobody_reads_does_not_stop_the_mega(world):
    end = Pty()
    world.connect(1, end)
    world.run(seconds=0.005)
    device = os.open(end.name, os.O_RDWR | os.O_NOCTTY)
    for _ in range(100):
        os.write(device, bytes(100))
        world.run(seconds=0.01)
    os.close(device)
    assert world.mega.now_ms == pytest.approx(1005, abs=1)


def test_a_tcp_client_finds_its_peer_again_after_the_peer_restarts(world, clock):
    listener = socket.create_server(("127.0.0.1", 0))
    port = listener.getsockname()[1]
    end = open_end(f"tcp:127.0.0.1:{port}", clock, quiet)
    world.connect(1, end)
    for _ in range(2):
        slices_until(world, lambda: end.connected)
        peer, _ = listener.accept()
        listener.close()
        peer.sendall(b"hello")
        peer.setblocking(False)
        assert answer_of(world, lambda: peer.recv(100), 5) == b"ifmmp"
        peer.close()
        slices_until(world, lambda: not end.connected)
        world.run(seconds=2)
        assert not end.connected
        listener = socket.create_server(("127.0.0.1", port))
    listener.close()


def test_a_tcp_server_takes_the_next_client_when_one_has_gone(world, clock):
    # Port 0: the system chooses one that is free.
    end = TcpServer(0, clock, quiet)
    world.connect(1, end)
    for text in (b"one", b"two"):
        client = socket.create_connection(("127.0.0.1", end.port))
        client.sendall(text)
        client.setblocking(False)
        assert answer_of(world, lambda: client.recv(100), len(text)) == bytes(byte + 1 for byte in text)
        client.close()
        slices_until(world, lambda: not end.connected)


def test_a_tcp_client_tries_every_address_of_its_peer(world, clock, monkeypatch):
    listener = socket.create_server(("127.0.0.1", 0))
    port = listener.getsockname()[1]
    real = socket.getaddrinfo

    def with_another_first(*arguments, **options):
        here = real(*arguments, **options)
        return [(*here[0][:4], ("127.0.0.2", port)), *here]  # nobody listens there

    monkeypatch.setattr(socket, "getaddrinfo", with_another_first)
    end = open_end(f"tcp:127.0.0.1:{port}", clock, quiet)
    world.connect(1, end)
    slices_until(world, lambda: end.connected)
    listener.close()


def test_udp_answers_whoever_sent_and_survives_a_peer_that_is_away(world):
    peer = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    peer.bind(("127.0.0.1", 0))
    peer.setblocking(False)
    port = peer.getsockname()[1]
    end = open_end(f"udp:127.0.0.1:{port}")
    world.connect(1, end)
    world.run(seconds=0.005)
    end.write(b"x")
    data, mega_address = None, None

    def heard():
        nonlocal data, mega_address
        try:
            data, mega_address = peer.recvfrom(100)
        except BlockingIOError:
            return False
        return True

    slices_until(world, heard)
    assert data == b"x"
    peer.sendto(b"A", mega_address)
    slices_until(world, heard)
    assert data == b"B"
    peer.close()
    for _ in range(5):
        end.write(b"y")
        world.slice()
    peer = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    peer.bind(("127.0.0.1", port))
    peer.setblocking(False)
    peer.sendto(b"K", mega_address)
    slices_until(world, heard)
    assert data == b"L"
    peer.close()


def test_udp_that_listens_answers_whoever_sent_last(world):
    chosen = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    chosen.bind(("127.0.0.1", 0))
    port = chosen.getsockname()[1]
    chosen.close()
    end = open_end(f"udp-listen:{port}")
    world.connect(1, end)
    end.write(b"nobody is there yet")
    world.run(seconds=0.005)
    for text in (b"one", b"two"):  # the second is the first, restarted at another port
        peer = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        peer.setblocking(False)
        peer.sendto(text, ("127.0.0.1", port))
        assert answer_of(world, lambda: peer.recv(100), len(text)) == bytes(byte + 1 for byte in text)
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
        assert answer_of(world, lambda: os.read(master, 10), 1) == b"B"
        device.unlink()
        os.close(master)
        os.close(slave)
        slices_until(world, lambda: len(said) == 2)
        assert said == [f"{device}@115200: open", f"{device}@115200: gone; waiting for it"]


def test_a_peer_that_sends_faster_than_the_line_is_held_back(world, clock):
    end = TcpServer(0, clock, quiet)
    world.connect(1, end)
    client = socket.create_connection(("127.0.0.1", end.port))
    client.sendall(bytes(5000))
    slices_until(world, lambda: end.connected)
    for _ in range(100):
        world.slice()
        assert world.mega.serial(1).unsent <= 40
    assert world.mega.serial(1).lost == 0
    client.close()


@pytest.mark.parametrize(
    "form", ["", "tcp", "tcp:host", "tcp:host:x", "tcp:host:70000", "udp-listen:0", "/dev/ttyACM0@fast", "com1"]
)
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


def test_simulate_sends_nothing_without_input():
    elf = build_firmware("echo", [SOURCES / "echo.cpp"], library=False)
    ran = simulate(elf, "--for", 0.1, "--no-input", "--serial1", "none", text=b"hello\n")
    assert ran.stdout == b"Serial1 is not connected\nready\r\n"


def test_simulate_says_what_is_wrong_in_one_line(tmp_path):
    ran = simulate(tmp_path / "missing.elf")
    assert ran.returncode == 1
    assert ran.stdout == b""
    assert ran.stderr.decode() == f"tools/simulate: cannot read {tmp_path}/missing.elf: No such file or directory\n"


def test_simulate_connects_serial_to_something_else_too():
    elf = build_firmware("echo", [SOURCES / "echo.cpp"], library=False)
    ran = simulate(elf, "--for", 0.05, "--serial0", "none", "--serial1", "none", text=b"hello\n")
    assert ran.stdout == b"Serial is not connected\nSerial1 is not connected\n"
    assert simulate(elf, "--console", "--serial0", "none").returncode == 2


# A peer that is a process -----------------------------------------------------------


class Process:
    """A program whose lines, of stdout and stderr, are waited for."""

    LIMIT_S = 60.0  # of real time, for a computer that is busy with other things

    def __init__(self, *command: object) -> None:
        self._process = subprocess.Popen(
            list(map(str, command)), stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
        )
        self._lines: queue.Queue[str | None] = queue.Queue()
        self._said: list[str] = []
        threading.Thread(target=self._listen, daemon=True).start()

    def _listen(self) -> None:
        for line in self._process.stdout:
            self._lines.put(line.rstrip("\n"))
        self._lines.put(None)

    def wait_for(self, pattern: str) -> re.Match:
        """Read on to the first line that has this in it."""
        while True:
            try:
                line = self._lines.get(timeout=self.LIMIT_S)
            except queue.Empty:
                line = None
            assert line is not None, f"no {pattern!r} in:\n" + "\n".join(self._said)
            self._said.append(line)
            match = re.search(pattern, line)
            if match:
                return match

    def say(self, text: str) -> None:
        self._process.stdin.write(text)
        self._process.stdin.flush()

    def stop(self, how: signal.Signals = signal.SIGKILL) -> int:
        self._process.send_signal(how)
        code = self._process.wait(self.LIMIT_S)
        self._process.stdin.close()
        return code


@pytest.fixture
def start():
    """Starts a Process, which is killed in the end."""
    started = []

    def begin(*command) -> Process:
        started.append(Process(*command))
        return started[-1]

    yield begin
    for process in started:
        if process._process.poll() is None:
            process.stop()


@pytest.mark.slow
def test_mega_uploads_over_tcp_to_a_process_survives_its_restart_and_uploads_again(start, personality):
    accepted = rf"returned {status_names().index('Accepted')}$"
    items = 5 if personality == "ArduPilot" else 4  # with home
    peer = start(sys.executable, AUTOPILOT, personality)
    port = peer.wait_for(r"listening on (\d+)")[1]
    mega = start(
        ROOT / "tools" / "simulate", firmware_image(57600).path, "--console", "--serial1", f"tcp:127.0.0.1:{port}"
    )
    mega.wait_for("ready")
    for _ in range(2):
        mega.say("flash\nupload 0\n")
        mega.wait_for(accepted)
        peer.wait_for(f"aboard: {items} items")
        peer.stop()
        mega.wait_for("connection lost")
        peer = start(sys.executable, AUTOPILOT, personality, "--port", port)
        mega.wait_for("127.0.0.1:.*: connected")
    assert mega.stop(signal.SIGINT) == 0
    mega.wait_for("s simulated, deepest stack")
