"""The library's signing on this computer, asked line by line; see test/host/programs/signing.cpp."""

from __future__ import annotations

import functools
import hashlib
import subprocess
from pathlib import Path

from simulation.fake_autopilot import mavlink
from simulation.firmware import library_file
from simulation.host_build import HOST, build_host

KEY = hashlib.sha256(b"a secret of the tests").digest()
OTHER_KEY = hashlib.sha256(b"another one").digest()
MINUTE = 6_000_000  # [10 us]
UNIT = 1 << 16  # of the time that a store keeps [10 us]
SIGNATURE = 13  # [bytes]


@functools.cache
def program(compiler: str = "g++") -> Path:
    parts = [library_file(f"{name}.cpp") for name in ("Sha256", "Signing")]
    return build_host("signing", [HOST / "programs" / "signing.cpp"], compiler, library=parts)


class SigningProgram:
    """The program, running. An answer is a line of words."""

    def __init__(self, compiler: str = "g++") -> None:
        self._running = subprocess.Popen(
            [program(compiler)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, bufsize=1
        )
        assert self._running.stdin is not None and self._running.stdout is not None
        self._asked, self._answers = self._running.stdin, self._running.stdout

    def close(self) -> None:
        self._asked.close()
        assert self._running.wait() == 0, "it ended with a finding of the sanitizers"
        self._answers.close()

    def ask(self, *words: object) -> str:
        self._asked.write(" ".join(map(str, words)) + "\n")
        answer = self._answers.readline().rstrip("\n")
        assert answer not in ("", "what?"), f"{words[0]}: {answer or 'it has ended'}"
        return answer

    def begin(self, key: bytes = KEY, link: int = 7, kept: int | None = None) -> None:
        """As after a reset: all is forgotten but what the store keeps, or is given to it here."""
        if kept is not None:
            self.ask("kept", kept)
        self.ask("begin", key.hex(), link)

    def sign(self, frame: bytes, cut: int = 0) -> bytes:
        """The frame with its signature."""
        return frame + bytes.fromhex(self.ask("sign", frame.hex(), cut).split()[0])

    def accepts(self, frame: bytes) -> bool:
        return self.ask("check", bytes(frame).hex()) == "accepted"

    @property
    def counters(self) -> dict[str, int]:
        names = ("accepted", "wrong", "replayed", "old", "too many streams")
        return dict(zip(names, map(int, self.ask("counters").split()), strict=True))

    @property
    def time(self) -> int:
        """Of the last signature, or the accepted frame that was ahead of it [10 us]."""
        return int(self.ask("time").split()[0])

    @property
    def kept(self) -> int:
        """What the store keeps [0.65536 s]."""
        return int(self.ask("time").split()[1])

    @property
    def saves(self) -> int:
        return int(self.ask("time").split()[2])


def signer(sender: tuple[int, int] = (1, 1), *, key: bytes = KEY, link: int = 0, time: int = 0) -> mavlink.MAVLink:
    """A pymavlink that signs, and accepts only what is signed."""
    made = mavlink.MAVLink(None, *sender)
    made.signing.secret_key = key
    made.signing.sign_outgoing = True
    made.signing.link_id = link
    made.signing.timestamp = time
    return made


def unsigned_frame(message, sender: tuple[int, int] = (1, 191)) -> bytes:
    """A frame that says it is signed, with the checksum that belongs to that, but without the signature."""
    return bytes(message.pack(signer(sender)))[:-SIGNATURE]
