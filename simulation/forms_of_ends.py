"""What a serial port of the simulated Mega can be connected to, in words; simulation/mega/ends.py makes them."""

from __future__ import annotations

FORMS = """\
  pty                     a new pseudo-terminal; its path is printed
  tcp:HOST:PORT           connects to a server, and tries again until it can
  tcp-listen:PORT         is a server for one client at a time
  udp:HOST:PORT           sends to this address, and receives from everybody who answers
  udp-listen:PORT         receives, and sends to the one who has sent last
  /dev/NAME[@BAUD]        a serial device (default: 57600 baud)
  none                    not connected"""


class BadEnd(Exception):
    """Nothing can be connected to this; the text says what can."""


def parts_of(form: str) -> tuple[str, str, int]:
    """The kind of end, its host or its path, its port or its baud rate. Raises BadEnd."""
    kind, _, rest = form.partition(":")
    if form in ("none", "pty"):
        return form, "", 0
    if form.startswith("/"):
        path, _, baud = form.partition("@")
        return "device", path, number(form, baud or "57600")
    if kind in ("tcp-listen", "udp-listen"):
        return kind, "", number(form, rest, 65535)
    if kind in ("tcp", "udp") and ":" in rest:
        host, _, port = rest.rpartition(":")
        return kind, host, number(form, port, 65535)
    raise BadEnd(f"{form!r} is nothing to connect to; it must be one of\n{FORMS}")


def number(form: str, text: str, most: int = 4_000_000) -> int:
    if not text.isascii() or not text.isdigit() or not 0 < int(text) <= most:
        raise BadEnd(f"{text!r} in {form!r} is not a number from 1 to {most}")
    return int(text)
