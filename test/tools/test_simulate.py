"""The simulated Mega in real time: its pace, its ends, and tools/simulate itself."""

from __future__ import annotations

import contextlib
import functools
import os
import re
import signal
import socket
import subprocess
import tty
from collections.abc import Callable
from pathlib import Path

import pytest

from building import ROOT
from interrupts import can_be_interrupted
from simulation import recordings
from simulation.bench import PERSONALITIES, firmware_image, status_names
from simulation.fake_autopilot import FakeAutopilot, mavlink
from simulation.firmware import build_firmware
from simulation.mega import Mega
from simulation.mega.ends import BadEnd, Pty, TcpServer, Terminal, open_end
from simulation.mega.line import MEMORY_S, Line
from simulation.mega.realtime import RealTime
from simulation.mega.words import Words

SOURCES = Path(__file__).resolve().parents[1] / "machine"


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


def test_a_tcp_server_takes_the_next_client_when_one_has_gone(world, clock):
    # Port 0: the system chooses one that is free.
    end = TcpServer(0, clock, quiet)
    world.connect(1, end)
    for text in (b"one", b"two"):
        client = socket.create_connection(("127.0.0.1", end.port))
        client.sendall(text)
        client.setblocking(False)
        assert answer_of(world, functools.partial(client.recv, 100), len(text)) == bytes(byte + 1 for byte in text)
        client.close()
        slices_until(world, lambda: not end.connected)


def test_udp_answers_whoever_sent_and_survives_a_peer_that_is_away(world):
    peer = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    peer.bind(("127.0.0.1", 0))
    peer.setblocking(False)
    port = peer.getsockname()[1]
    end = open_end(f"udp:127.0.0.1:{port}", say=quiet)
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
    port = free_port(socket.SOCK_DGRAM)
    said = []
    end = open_end(f"udp-listen:{port}", say=said.append)
    world.connect(1, end)
    end.write(b"nobody is there yet")
    world.run(seconds=0.005)
    assert said == []
    for text in (b"one", b"two"):  # the second is the first, restarted at another port
        peer = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        peer.setblocking(False)
        peer.sendto(text, ("127.0.0.1", port))
        assert answer_of(world, functools.partial(peer.recv, 100), len(text)) == bytes(byte + 1 for byte in text)
        assert said.pop() == f"udp-listen:{port}: hears 127.0.0.1:{peer.getsockname()[1]}"
        assert said == []
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


def free_port(kind: socket.SocketKind) -> int:
    chosen = socket.socket(socket.AF_INET, kind)
    chosen.bind(("127.0.0.1", 0))
    port = chosen.getsockname()[1]
    chosen.close()
    return port


# More than the line takes -----------------------------------------------------------


def numbered_frame(number: int, identity: int = mavlink.MAVLINK_MSG_ID_ATTITUDE, payload: int = 28) -> bytes:
    """A frame as far as a line looks at it, with a number in it."""
    return bytes((0xFD, payload, 0, 0, number % 256, 1, 1, identity, 0, 0)) + number.to_bytes(payload, "little") + b"ck"


def numbers_in(data: bytes) -> list[int]:
    """The numbers of the frames; whatever is not whole, or no frame, is an error."""
    numbers = []
    while data:
        size = data[1] + 12
        assert data[0] == 0xFD and len(data) >= size, f"{data[:size].hex()} is no frame"
        numbers.append(int.from_bytes(data[10 : size - 2], "little"))
        data = data[size:]
    return numbers


class Feeder:
    """Frames for a Line of 5,760 bytes/s, and what goes on the line of them, in simulated milliseconds."""

    def __init__(self) -> None:
        self.line = Line("a peer")
        self.now_s = 0.0
        self.taken: list[tuple[float, bytes]] = []

    def run_ms(self, data: bytes = b"") -> None:
        self.line.hear(data, self.now_s)
        self.line.forget(self.now_s, 5760)
        millisecond = round(1000 * self.now_s)
        self.taken.append((self.now_s, self.line.take(6 if millisecond % 25 < 19 else 5)))
        self.now_s += 0.001

    def run_dry(self) -> bytes:
        for _ in range(200):
            self.run_ms()
        return b"".join(data for _, data in self.taken)


@pytest.fixture
def feeder() -> Feeder:
    return Feeder()


def test_what_a_line_takes_in_a_tenth_of_a_second_waits_and_is_not_dropped(feeder):
    burst = b"".join(numbered_frame(number) for number in range(14))
    assert 0.9 * MEMORY_S * 5760 < len(burst) < MEMORY_S * 5760
    feeder.run_ms(burst)
    assert feeder.run_dry() == burst
    assert feeder.line.dropped == 0


def test_flood_is_thinned_out_by_whole_frames_none_of_which_is_older_than_a_tenth_of_a_second(feeder):
    sent = 0
    for millisecond in range(3000):  # 24 kB/s
        due = 24 * millisecond // 40
        feeder.run_ms(b"".join(numbered_frame(number) for number in range(sent, due)))
        sent = due
    numbers = numbers_in(feeder.run_dry())
    assert numbers == sorted(set(numbers))
    assert len(numbers) == pytest.approx(3 * 5760 / 40, rel=0.05)
    assert feeder.line.dropped == 40 * (sent - len(numbers))
    assert feeder.line.dropped_frames == sent - len(numbers)
    data = b""
    for now_s, part in feeder.taken:
        before, data = len(data) // 40, data + part
        for number in numbers[before : len(data) // 40]:
            assert now_s - number * 40 / 24000 <= MEMORY_S + 0.008  # until its last byte goes


@pytest.mark.parametrize("cut", [1, 7, 39])
def test_frames_that_come_in_pieces_are_dropped_whole_all_the_same(feeder, cut):
    flood = b"".join(numbered_frame(number) for number in range(600))
    for begin in range(0, len(flood), cut):
        feeder.line.hear(flood[begin : begin + cut], feeder.now_s)
        if begin // 24 != (begin + cut) // 24:
            feeder.run_ms()
    numbers = numbers_in(feeder.run_dry())
    assert 100 < len(numbers) < 300
    assert feeder.line.dropped == len(flood) - 40 * len(numbers)


@pytest.mark.parametrize("name", ["MISSION_REQUEST_INT", "MISSION_ACK", "MISSION_ITEM_INT", "HEARTBEAT", "COMMAND_ACK"])
def test_answer_goes_on_the_line_in_the_midst_of_a_flood(feeder, name):
    identity = getattr(mavlink, f"MAVLINK_MSG_ID_{name}")
    sent = []
    for millisecond in range(1000):
        data = b"".join(numbered_frame(1) for _ in range(millisecond % 2 + 1))
        if millisecond % 100 == 50:
            sent.append(millisecond)
            data += numbered_frame(millisecond, identity, payload=9)
        feeder.run_ms(data)
    assert [number for number in numbers_in(feeder.run_dry()) if number > 1] == sent


class Peer:
    """Another program, at the far end of UDP, TCP or a serial device. What the way does not take is kept, as a SITL
    keeps it."""

    def __init__(self, kind: str) -> None:
        self._kept = b""
        self._listener: socket.socket | None = None
        if kind == "udp":
            port = free_port(socket.SOCK_DGRAM)
            self.form = f"udp-listen:{port}"
            way = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
            way.connect(("127.0.0.1", port))
            self._use(way.detach())
        elif kind == "tcp":
            self._listener = socket.create_server(("127.0.0.1", 0))
            self._listener.setblocking(False)
            self.form = f"tcp:127.0.0.1:{self._listener.getsockname()[1]}"
            self._way = None
        else:
            master, self._slave = os.openpty()
            tty.setraw(self._slave)
            self.form = f"{os.ttyname(self._slave)}@57600"
            self._use(master)

    def _use(self, way: int) -> None:
        os.set_blocking(way, False)
        self._way: int | None = way

    def _is_there(self) -> bool:
        if self._way is None:
            with contextlib.suppress(BlockingIOError):
                connection = self._listener.accept()[0]
                # Or the computer would hold small pieces back, by its own clock.
                connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
                self._use(connection.detach())
        return self._way is not None

    def send(self, data: bytes) -> None:
        if self._is_there():
            self._kept += data
            with contextlib.suppress(BlockingIOError):
                self._kept = self._kept[os.write(self._way, self._kept) :]

    def heard(self) -> bytes:
        data = b""
        with contextlib.suppress(BlockingIOError):
            while self._is_there() and (piece := os.read(self._way, 4096)):
                data += piece
        return data

    def close(self) -> None:
        for one in (self._way, getattr(self, "_slave", None)):
            if one is not None:
                os.close(one)
        if self._listener is not None:
            self._listener.close()


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


@pytest.fixture
def flooded(clock, personality):
    """Makes a world in which a firmware has an autopilot on Serial1 that sends more than the line takes."""
    made = []

    def build(peer) -> tuple[RealTime, Talk, FakeAutopilot, list[str]]:
        mega = Mega(firmware_image(57600))
        telemetry = recordings.saturated(recordings.WITH_STREAMS[personality], 10 * FLOOD_BYTES_PER_S)
        autopilot = PERSONALITIES[personality](telemetry=telemetry, uptime_s=60.0)
        said: list[str] = []
        console = Talk()
        world = RealTime(mega, clock, clock.sleep, said.append)
        made.extend((world, peer))
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
        return world, console, autopilot, said

    yield build
    for one in made:
        one.close()


@pytest.mark.parametrize("peer", ["udp", "tcp", "a serial device"])
def test_ten_items_go_aboard_within_two_seconds_beside_a_flood(flooded, peer):
    world, console, autopilot, said = flooded(Peer(peer))
    accepted = b"returned %d\n" % status_names().index("Accepted")
    slices_until(world, lambda: b"ready" in console.text)
    console.typed = b"function 10 65535\n"
    world.run(3.0)  # the flood is as old as it gets
    began_ms = world.mega.now_ms
    console.typed = b"upload 0\n"
    slices_until(world, lambda: accepted in console.text.replace(b"\r", b""))
    took_ms = world.mega.now_ms - began_ms
    print(f"{took_ms:.0f} ms")
    assert took_ms < 2000
    assert len(autopilot.received()) == 10 + (autopilot.__class__.__name__ == "ArduPilot")
    assert world.mega.serial(1).lost == 0
    assert said[0].endswith("telemetry first: more come than the 5,882 bytes/s of the line")


@pytest.mark.parametrize("personality", ["PX4"])
def test_what_is_dropped_is_told_after_a_second_every_ten_seconds_and_in_the_end(flooded):
    world, _, _, said = flooded(Peer("udp"))
    world.run(0.9)
    assert said == []
    world.run(23.0)
    assert len(said) == 3
    told = [int(re.search(r": ([\d,]+) bytes dropped", text)[1].replace(",", "")) for text in said]
    assert told[1] == pytest.approx(10 * (FLOOD_BYTES_PER_S - 5882), rel=0.05)
    (in_all,) = world.dropped()
    assert in_all.startswith("Serial1: ")
    dropped, heard = (int(number.replace(",", "")) for number in re.findall(r"([\d,]+) (?:of|bytes \()", in_all))
    assert dropped == pytest.approx(22.9 * (FLOOD_BYTES_PER_S - 5882), rel=0.05)
    assert dropped > sum(told)
    assert heard == pytest.approx(23.9 * FLOOD_BYTES_PER_S, rel=0.05)


def test_text_that_is_pasted_into_serial_over_tcp_arrives_whole(clock):
    mega = Mega(build_firmware("echo", [SOURCES / "echo.cpp"], library=False))
    world = RealTime(mega, clock, clock.sleep)
    end = TcpServer(0, clock, quiet)
    world.connect(0, end)
    client = socket.create_connection(("127.0.0.1", end.port))
    client.setblocking(False)
    slices_until(world, lambda: end.connected)
    world.run(0.01)
    text = b"".join(b"line %d of a text\n" % number for number in range(300))
    client.sendall(text)
    answer = answer_of(world, lambda: client.recv(4096), len(text))
    if answer.startswith(b"ready\r\n"):
        answer = answer[7:] + answer_of(world, lambda: client.recv(4096), 7)
    assert answer == text
    assert world.dropped() == []
    client.close()
    world.close()


@pytest.mark.parametrize(
    "form", ["", "tcp", "tcp:host", "tcp:host:x", "tcp:host:70000", "udp-listen:0", "/dev/ttyACM0@fast", "com1"]
)
def test_a_wrong_end_is_refused_with_what_it_may_be(form):
    with pytest.raises(BadEnd, match="not a number from 1|must be one of"):
        open_end(form)


# The tool's words, and the sketch's --------------------------------------------------


class Screen:
    """A terminal on which both print."""

    def __init__(self) -> None:
        self.text = b""

    def write(self, data: bytes) -> None:
        self.text += data

    def flush(self) -> None:
        pass


@pytest.fixture
def screen() -> Screen:
    return Screen()


@pytest.fixture
def words(clock, screen) -> Words:
    return Words(clock, screen, screen, same_place=True)


def test_words_wait_until_the_sketchs_line_has_ended(words, screen, clock):
    words.print(b"item 3 ")
    words.say("tcp: connection lost")
    clock.now += 0.3
    words.tick()
    assert screen.text == b"item 3 "
    words.print(b"of 10\r\nitem 4")
    assert screen.text == b"item 3 of 10\r\ntcp: connection lost\nitem 4"


def test_prompt_is_printed_again_below_the_words(words, screen, clock):
    words.print(b"Hello\r\n> ")
    words.say("tcp: connection lost")
    words.say("tcp: connected")
    clock.now += 0.6
    words.tick()
    words.tick()
    words.print(b"status\r\n")
    assert screen.text == b"Hello\r\n> \ntcp: connection lost\ntcp: connected\n> status\r\n"


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
                          preexec_fn=can_be_interrupted) as running:  # fmt: skip
        assert next(line for line in running.stdout if line.startswith(b"ready"))
        running.send_signal(signal.SIGINT)
        assert b" s simulated, deepest stack " in running.stderr.read()
    assert running.returncode == 0


@pytest.mark.parametrize("together", [True, False])
def test_simulates_last_words_stand_on_a_line_of_their_own(together):
    elf = build_firmware("echo", [SOURCES / "echo.cpp"], library=False)
    command = [ROOT / "tools" / "simulate", str(elf), "--for", "0.2", "--serial1", "none"]
    ran = subprocess.run(
        command,
        input=b"half a line",
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT if together else subprocess.PIPE,
        timeout=60,
        check=False,
    )
    printed, _, rest = ran.stdout.partition(b"half a line")
    assert printed == b"Serial1 is not connected\nready\r\n"
    assert rest.startswith(b"\n0.200 s simulated") if together else rest == b""


def test_simulate_connects_serial_to_something_else_too():
    elf = build_firmware("echo", [SOURCES / "echo.cpp"], library=False)
    ran = simulate(elf, "--for", 0.05, "--serial0", "none", "--serial1", "none", text=b"hello\n")
    assert ran.stdout == b"Serial is not connected\nSerial1 is not connected\n"
    assert simulate(elf, "--console", "--serial0", "none").returncode == 2
