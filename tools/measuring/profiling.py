"""Where the cycles go: by function, in an upload under telemetry."""

from __future__ import annotations

from simulation.mega import Mega

from .firmware import ours
from .peer import Peer
from .runs import MS, SECOND


def profile(kind: str = "px4") -> str:
    """A table of cycles from the first COUNT to the final answer, the line to the Mega full."""
    mega = Mega(ours().built.elf)
    peer = Peer(mega, kind, saturate=True)
    peer.until_open()
    peer.heartbeat()
    peer.run_until_heard("MISSION_COUNT")
    mega.start_profile()
    begun = mega.cycle
    peer.run_until_accepted(10 * SECOND)
    took = mega.cycle - begun
    head = f"UploadMission, {kind}: {took / MS:.1f} ms from COUNT to the final answer, {took:,} cycles"
    return f"{head}\n{mega.profile()}"
