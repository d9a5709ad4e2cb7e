"""Bytes on a line <-> MAVLink frames, without ever touching one byte at a time."""
import hashlib
from functools import cache
from pathlib import Path
from xml.etree import ElementTree

from .dialect import mavlink

MAGIC_V1 = 0xFE
MAGIC_V2 = 0xFD
SIGNED = 0x01  # the only incompatibility flag there is
_MAGICS = (MAGIC_V1, MAGIC_V2)
_SIGNATURE_LENGTH = 13
_DECODER = mavlink.MAVLink(None)

_learned_crc_extra: dict[int, int] = {}


def message_id(frame: bytes) -> int:
    """The message id in the header of a whole frame."""
    if frame[0] == MAGIC_V2:
        return frame[7] | frame[8] << 8 | frame[9] << 16
    return frame[5]



def _checksum_at(frame: bytes) -> int:
    """Index of the first checksum byte."""
    return frame[1] + (10 if frame[0] == MAGIC_V2 else 6)


def _crc(body: bytes, crc_extra: int) -> int:
    return mavlink.x25crc(body + bytes((crc_extra,))).crc


def crc_extra_of(frame: bytes) -> int | None:
    """CRC_EXTRA of the frame's message; None if the dialect does not know the message."""
    known = mavlink.mavlink_map.get(message_id(frame))
    return known.crc_extra if known else None


def is_intact(frame: bytes) -> bool:
    """Whether the checksum is right. Messages the dialect does not know are taken on trust."""
    crc_extra = crc_extra_of(frame)
    if crc_extra is None:
        return True
    end = _checksum_at(frame)
    return _crc(frame[1:end], crc_extra) == frame[end] | frame[end + 1] << 8


def decode(frame: bytes):
    """The message in an intact frame. Raises mavlink.MAVError for a damaged one."""
    return _DECODER.decode(bytearray(frame))


def renumbered(frame: bytes, sequence: int, system: int, component: int) -> bytes:
    """The frame as another sender would have sent it: new running number and source ids.

    Works for messages outside the dialect too: their CRC_EXTRA is learned from the frame,
    which must be intact.
    """
    end = _checksum_at(frame)
    crc_extra = crc_extra_of(frame)
    if crc_extra is None:
        crc_extra = _learn_crc_extra(frame)
    header = bytearray(frame[:end])
    first = 4 if frame[0] == MAGIC_V2 else 2
    header[first:first + 3] = bytes((sequence & 0xFF, system, component))
    return bytes(header) + _crc(bytes(header[1:]), crc_extra).to_bytes(2, "little")


def signed(frame: bytes, signing) -> bytes:
    """A MAVLink 2 frame as its sender would have signed it; moves pymavlink's `signing` on."""
    end = _checksum_at(frame)
    crc_extra = crc_extra_of(frame)
    if crc_extra is None:
        crc_extra = _learn_crc_extra(frame)
    header = bytes((*frame[:2], frame[2] | SIGNED, *frame[3:end]))
    whole = header + _crc(header[1:], crc_extra).to_bytes(2, "little")
    whole += bytes((signing.link_id,)) + signing.timestamp.to_bytes(6, "little")
    signing.timestamp += 1
    return whole + hashlib.sha256(signing.secret_key + whole).digest()[:6]


def _learn_crc_extra(frame: bytes) -> int:
    identity = message_id(frame)
    if identity not in _learned_crc_extra:
        end = _checksum_at(frame)
        sent = frame[end] | frame[end + 1] << 8
        for candidate in range(256):
            if _crc(frame[1:end], candidate) == sent:
                _learned_crc_extra[identity] = candidate
                break
        else:
            raise ValueError(f"frame of message {identity} is damaged: give an intact one")
    return _learned_crc_extra[identity]


_DEFINITIONS = Path(__file__).resolve().parents[2] / "tools" / "mavlink"
_SIZES = {"char": 1, "uint8_t": 1, "int8_t": 1, "uint16_t": 2, "int16_t": 2, "uint32_t": 4,
          "int32_t": 4, "float": 4, "uint64_t": 8, "int64_t": 8, "double": 8}


@cache
def _lengths_v1() -> dict[int, int]:
    """Message id -> length of its payload without the extension fields."""
    lengths = {}
    for path in _DEFINITIONS.glob("*.xml"):
        for message in ElementTree.parse(path).iterfind("messages/message"):
            lengths[int(message.attrib["id"])] = _base_length(message)
    return lengths


def _base_length(message: ElementTree.Element) -> int:
    length = 0
    for part in message:
        if part.tag == "extensions":
            break
        if part.tag == "field":
            kind, _, count = part.attrib["type"].partition("[")
            length += _SIZES[kind.replace("_mavlink_version", "")] * int(count.rstrip("]") or 1)
    return length


def packed(message, packer, version: int) -> bytes:
    """The frame of a message in MAVLink 1 or 2; the packer's running number is left alone.

    MAVLink 1 has no extension fields; pymavlink would send them all the same.
    """
    frame = bytes(message.pack(packer, force_mavlink1=version == 1))
    if version == 2:
        return frame
    length = _lengths_v1()[frame[5]]
    body = bytes((length,)) + frame[2:6 + length]
    return bytes((MAGIC_V1,)) + body + _crc(body, message.crc_extra).to_bytes(2, "little")


class FrameSplitter:
    """Cuts a byte stream into pieces: whole frames, and what lies between them.

    It resynchronises no better than the autopilots' own parser: a frame whose checksum is
    wrong is thrown away whole, with whatever good frame began inside it.
    """

    def __init__(self) -> None:
        self._buffer = bytearray()
        self._needed = 1  # bytes in it, before there can be a piece more

    def feed(self, data: bytes) -> list[tuple[bytes, bool]]:
        """The pieces completed by `data`, in order: (bytes, is an intact frame)."""
        buffer = self._buffer
        buffer += data
        if len(buffer) < self._needed:
            return []
        pieces: list[tuple[bytes, bool]] = []
        start = 0
        while start < len(buffer):
            if buffer[start] not in _MAGICS:
                end = start + 1
                while end < len(buffer) and buffer[end] not in _MAGICS:
                    end += 1
                pieces.append((bytes(buffer[start:end]), False))
                start = end
                continue
            length = self._frame_length(buffer, start)
            if length == 0:
                pieces.append((bytes(buffer[start:start + 1]), False))
                start += 1
                continue
            if length is None or start + length > len(buffer):
                self._needed = length or len(buffer) - start + 1
                break
            frame = bytes(buffer[start:start + length])
            pieces.append((frame, is_intact(frame)))
            start += length
        else:
            self._needed = 1
        del buffer[:start]
        return pieces

    @staticmethod
    def _frame_length(buffer: bytearray, start: int) -> int | None:
        """Length of the frame that begins at start; None if not known yet, 0 if it is none."""
        available = len(buffer) - start
        if buffer[start] == MAGIC_V1:
            return None if available < 2 else buffer[start + 1] + 8
        if available < 3:
            return None
        flags = buffer[start + 2]
        if flags & ~SIGNED:
            return 0
        return buffer[start + 1] + 12 + (_SIGNATURE_LENGTH if flags & SIGNED else 0)
