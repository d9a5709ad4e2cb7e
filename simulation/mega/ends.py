"""What a serial port of the simulated Mega may be connected to.

An End never waits: read() hands over what has come, write() passes on what it
can. An end whose peer is away drops what is sent to it, as a loose cable does,
and finds the peer again when it is back. So does one whose peer does not read.
"""

from __future__ import annotations

import errno
import os
import select
import socket
import sys
import time
import tty
from collections.abc import Callable
from typing import TYPE_CHECKING, Protocol

from simulation.forms_of_ends import BadEnd, parts_of

from .words import Words

if TYPE_CHECKING:
    from serial import Serial

RETRY_S = 0.5  # between two tries to reach a peer that is away


class End(Protocol):
    name: str

    def read(self, most: int) -> bytes: ...

    def write(self, data: bytes) -> None: ...

    def close(self) -> None: ...


class Outside:
    """An end whose peer is no serial port, and knows nothing of the line's rate."""

    can_wait = True  # whether the peer is held back while it is not read


class Nothing:
    """A cable with nothing at its end."""

    name = "not connected"

    def read(self, most: int) -> bytes:
        return b""

    def write(self, data: bytes) -> None:
        pass

    def close(self) -> None:
        pass


class Terminal:
    """This program's own input and output."""

    name = "this terminal"

    def __init__(self, listen: bool = True, words: Words | None = None) -> None:
        self._listen = listen and sys.stdin is not None
        self._words = words or Words()

    def read(self, most: int) -> bytes:
        self._words.tick()
        if not self._listen or not select.select([sys.stdin], [], [], 0)[0]:
            return b""
        data = os.read(sys.stdin.fileno(), most)
        self._listen = bool(data)  # nothing, though ready: the end of the input
        return data

    def write(self, data: bytes) -> None:
        self._words.print(data)

    def close(self) -> None:
        pass


class Pty(Outside):
    """A new pseudo-terminal, for any program that opens a serial device."""

    def __init__(self) -> None:
        self._master, self._slave = os.openpty()
        tty.setraw(self._slave)
        os.set_blocking(self._master, False)
        # The slave stays open here, so that a program may close it and come again.
        self.name = os.ttyname(self._slave)

    def read(self, most: int) -> bytes:
        try:
            return os.read(self._master, most)
        except BlockingIOError:
            return b""

    def write(self, data: bytes) -> None:
        try:
            os.write(self._master, data)
        except BlockingIOError:
            pass  # nobody reads

    def close(self) -> None:
        os.close(self._master)
        os.close(self._slave)


class Tcp(Outside):
    """One TCP connection at a time, made again whenever it breaks."""

    def __init__(self, clock: Callable[[], float], say: Callable[[str], None]) -> None:
        self._clock = clock
        self._say = say
        self._connection: socket.socket | None = None
        self.name = "TCP"

    def reach(self) -> socket.socket | None:
        """A new connection if one can be had now."""
        raise NotImplementedError

    @property
    def connected(self) -> bool:
        return self._connection is not None

    def read(self, most: int) -> bytes:
        if self._connection is None:
            self._connection = self.reach()
            if self._connection is None:
                return b""
            self._connection.setblocking(False)
            self._connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            self._say(f"{self.name}: connected")
        try:
            data = self._connection.recv(most)
        except BlockingIOError:
            return b""
        except OSError:
            data = b""
        if not data:
            self._lose()
        return data

    def write(self, data: bytes) -> None:
        if self._connection is None:
            return
        try:
            self._connection.send(data)
        except BlockingIOError:
            pass  # the peer does not read
        except OSError:
            self._lose()

    def _lose(self) -> None:
        if self._connection is not None:
            self._connection.close()
            self._say(f"{self.name}: connection lost")
        self._connection = None

    def close(self) -> None:
        if self._connection is not None:
            self._connection.close()
        self._connection = None


class TcpClient(Tcp):
    """Connects to a listening peer, such as a simulated autopilot."""

    def __init__(self, host: str, port: int, clock: Callable[[], float], say: Callable[[str], None]) -> None:
        super().__init__(clock, say)
        self._address = (host, port)
        self._tries = 0
        self._retry_at = clock()
        self._trying: socket.socket | None = None
        self.name = f"tcp:{host}:{port}"

    def reach(self) -> socket.socket | None:
        if self._trying is None:
            if self._clock() < self._retry_at:
                return None
            self._retry_at = self._clock() + RETRY_S
            self._trying = self._begin()
        if self._trying is None or not select.select([], [self._trying], [], 0)[1]:
            return None
        made, self._trying = self._trying, None
        if made.getsockopt(socket.SOL_SOCKET, socket.SO_ERROR) == 0:
            return made
        made.close()
        return None

    def _begin(self) -> socket.socket | None:
        try:
            found = socket.getaddrinfo(*self._address, type=socket.SOCK_STREAM)
        except OSError:
            return None
        # localhost may be ::1 first, where few simulated autopilots listen: each address has its turn.
        family, kind, protocol, _, address = found[self._tries % len(found)]
        self._tries += 1
        trying = socket.socket(family, kind, protocol)
        trying.setblocking(False)
        if trying.connect_ex(address) in (0, errno.EINPROGRESS):
            return trying
        trying.close()
        return None

    def close(self) -> None:
        super().close()
        if self._trying is not None:
            self._trying.close()
        self._trying = None


class TcpServer(Tcp):
    """Listens, and serves one client at a time."""

    def __init__(self, port: int, clock: Callable[[], float], say: Callable[[str], None]) -> None:
        super().__init__(clock, say)
        self._listener = socket.create_server(("", port))
        self._listener.setblocking(False)
        self.port = self._listener.getsockname()[1]
        self.name = f"tcp-listen:{self.port}"

    def reach(self) -> socket.socket | None:
        try:
            return self._listener.accept()[0]
        except OSError:
            return None

    def close(self) -> None:
        super().close()
        self._listener.close()


class Udp(Outside):
    """Datagrams: to a fixed peer, or to whoever sent last."""

    can_wait = False

    def __init__(
        self, peer: tuple[str, int] | None, port: int = 0, say: Callable[[str], None] = lambda text: None
    ) -> None:
        self._say = say
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.setblocking(False)
        if port:
            self._socket.bind(("", port))
        self._peer = peer
        self._heard: tuple[str, int] | None = None
        self._kept = b""
        self.name = f"udp:{peer[0]}:{peer[1]}" if peer else f"udp-listen:{port}"

    def read(self, most: int) -> bytes:
        while len(self._kept) < most:
            try:
                data, sender = self._socket.recvfrom(65536)
            except OSError:  # nothing there, or the peer's port is closed just now
                break
            if sender != self._heard:
                self._say(f"{self.name}: hears {sender[0]}:{sender[1]}")
                self._peer = self._heard = sender
            self._kept += data
        data, self._kept = self._kept[:most], self._kept[most:]
        return data

    def write(self, data: bytes) -> None:
        if self._peer is None:
            return
        try:
            self._socket.sendto(data, self._peer)
        except OSError:
            pass  # the peer is away

    def close(self) -> None:
        self._socket.close()


class Device(Outside):
    """A serial device of this computer, opened again when it was unplugged."""

    def __init__(self, path: str, baud: int, clock: Callable[[], float], say: Callable[[str], None]) -> None:
        self._path = path
        self._baud = baud
        self._clock = clock
        self._say = say
        self._retry_at = clock()
        self._open: Serial | None = None
        self.name = f"{path}@{baud}"

    def _reach(self) -> Serial | None:
        """The device, if it is open, or can be opened again."""
        from serial import Serial, SerialException

        if self._open is None and self._clock() >= self._retry_at:
            self._retry_at = self._clock() + RETRY_S
            try:
                self._open = Serial(self._path, self._baud, timeout=0, write_timeout=0)
                self._say(f"{self.name}: open")
            except (SerialException, OSError):
                return None
        return self._open

    def read(self, most: int) -> bytes:
        device = self._reach()
        if device is None:
            return b""
        try:
            return device.read(most)
        except OSError:  # SerialException is one
            self._lose(device)
            return b""

    def write(self, data: bytes) -> None:
        from serial import SerialTimeoutException

        device = self._reach()
        if device is None:
            return
        try:
            device.write(data)
        except SerialTimeoutException:
            pass  # its buffer is full
        except OSError:
            self._lose(device)

    def _lose(self, device: Serial) -> None:
        device.close()
        self._open = None
        self._say(f"{self.name}: gone; waiting for it")

    def close(self) -> None:
        if self._open is not None:
            self._open.close()
        self._open = None


def to_stderr(text: str) -> None:
    print(text, file=sys.stderr, flush=True)


def open_end(
    form: str,
    clock: Callable[[], float] = time.monotonic,
    say: Callable[[str], None] = to_stderr,
) -> End:
    """The end that a text such as tcp:localhost:5760 means; FORMS lists them all."""
    try:
        return _open_end(form, clock, say)
    except OSError as error:
        raise BadEnd(f"cannot open {form}: {error.strerror or error}") from error


def _open_end(form: str, clock: Callable[[], float], say: Callable[[str], None]) -> End:
    kind, where, figure = parts_of(form)
    if kind == "none":
        return Nothing()
    if kind == "pty":
        return Pty()
    if kind == "device":
        return Device(where, figure, clock, say)
    if kind in ("tcp-listen", "udp-listen"):
        return TcpServer(figure, clock, say) if kind == "tcp-listen" else Udp(None, figure, say)
    return TcpClient(where, figure, clock, say) if kind == "tcp" else Udp((where, figure), say=say)
