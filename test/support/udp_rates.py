"""How often an upload over UdpLink succeeds in a network that loses datagrams, for tools/refresh: docs/radio.md."""

from __future__ import annotations

import statistics
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
if __name__ == "__main__":
    sys.path[:0] = [str(ROOT), str(ROOT / "tools")]

from datagrams import Network  # noqa: E402
from measuring.documents import aligned  # noqa: E402
from plans import SURVEY, on_the_wire  # noqa: E402
from udp_client import UdpClient  # noqa: E402

PAGE = ROOT / "docs" / "radio.md"
AUTOPILOTS = ("ArduPilot", "PX4")
LATENCY_MS, LOSS = (5, 50, 150, 500), (0, 3, 10)
SEEDS = 20
HEAD = ["each way", "datagrams lost", *(f"median, longest, {one}" for one in AUTOPILOTS)]


def network(seed: int, lose: float, latency_ms: float) -> Network:
    """With some datagrams that come twice, and some that others overtake."""
    return Network(seed, lose=lose, repeat=2, reorder=5, latency_s=latency_ms / 1000, jitter_s=2 * latency_ms / 1000)


def upload(personality: str, seed: int, lose: float, latency_ms: float) -> tuple[str, bool, float]:
    """How it ended, whether the plan is aboard, and how long it took from the first COUNT [s]."""
    with UdpClient(personality, network(seed, lose, latency_ms)) as client:
        client.upload(SURVEY)
        ended = client.run_until_ended(limit_s=300)
        began = next(time for time, message in client.sent if message.get_type() == "MISSION_COUNT")
        return ended, client.autopilot.received() == on_the_wire(SURVEY, personality), client.now - began


def row(latency_ms: float, lose: float) -> list[str]:
    """Raises RuntimeError for an acceptance that is false; names the successes where not all uploads are."""
    times = []
    for personality in AUTOPILOTS:
        ends = [upload(personality, seed, lose, latency_ms) for seed in range(SEEDS)]
        took = [seconds for ended, aboard, seconds in ends if ended == "Accepted" and aboard]
        if any(ended == "Accepted" and not aboard for ended, aboard, _ in ends):
            raise RuntimeError(f"{personality}, {latency_ms} ms, {lose} %: Accepted, and not aboard")
        less = f", {len(took)} of {SEEDS}" if len(took) < SEEDS else ""
        times.append(f"{statistics.median(took):.1f} s, {max(took):.1f} s{less}")
    return [f"{latency_ms} ms", f"{lose} %", *times]


def in_the_page() -> list[list[str]]:
    """The rows that docs/radio.md has."""
    text = PAGE.read_text().partition("<!-- udp: begin -->")[2].partition("<!-- udp: end -->")[0]
    lines = [line for line in text.splitlines() if line.startswith("|")]
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in lines[2:]]


if __name__ == "__main__":
    print(aligned([HEAD, *(row(latency_ms, lose) for latency_ms in LATENCY_MS for lose in LOSS)], left=2))
