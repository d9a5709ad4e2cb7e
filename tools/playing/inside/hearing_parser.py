"""MAVLink's own C parser in a browser: simulation/hearing as WebAssembly, in the place of the file of this name there.

The page's worker gives it as the JavaScript module `hearing`: its exports.
"""

from __future__ import annotations

from hearing import exports  # type: ignore[import-not-found]  # only in the page's worker

_LONGEST_FRAME = 280  # MAVLINK_MAX_PACKET_LEN


class Parser:
    """One parser, used as the autopilot `by` uses it: a HeardBy."""

    def __init__(self, by: int) -> None:
        self._parser = exports.hearing_new(by)

    def __del__(self) -> None:
        exports.hearing_free(self._parser)

    def take(self, data: bytes) -> tuple[int, bytes]:
        """How many bytes were taken, up to the end of the first undamaged frame; and that frame, or b""."""
        piece = data[: exports.size_of_room()]
        exports.put(piece)
        length_at = exports.room_for_length()
        taken = exports.hearing_take(
            self._parser, exports.room_for_bytes(), len(piece), exports.room_for_frame(), length_at
        )
        length = int.from_bytes(exports.bytes_at(length_at, 2).to_bytes(), "little")
        return taken, exports.bytes_at(exports.room_for_frame(), length).to_bytes() if length else b""
