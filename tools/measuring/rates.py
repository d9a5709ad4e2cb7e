"""How often an upload succeeds on a line that loses frames or bytes at random: the library beside plainer clients.

The library's own MissionClient, compiled for this computer, puts a plan of five items aboard models of both
autopilots (test/explorer), in simulated time, over a line of 57600 baud. The models hear bytes through the autopilots'
own parsers (simulation/hearing). The n-th frame of a direction, or its n-th byte, is lost or not by the seed alone.
What three plainer clients reach on the same lines was measured once, and is in test/rates/plainer_clients.toml.
"""

from __future__ import annotations

import functools
import subprocess
import tomllib
from dataclasses import dataclass
from pathlib import Path

from building import ROOT
from simulation.host_build import FAST, HOST, build_host

from .documents import aligned

RATES, EXPLORER = ROOT / "test" / "rates", ROOT / "test" / "explorer"
HEARING = ROOT / "simulation" / "hearing" / "Hearing.cpp"
MODELS = ("ArduPilot.cpp", "Autopilot.cpp", "FileWords.cpp", "Generic.cpp", "Message.cpp", "Plans.cpp", "Px4.cpp")

# Name on the command line -> in words.
AUTOPILOTS = {"ArduPilot": "ArduPilot", "LateArduPilot": "ArduPilot, ACK late", "PX4": "PX4"}
# Servers of a firmware that the library does not know (test/explorer/Generic.cpp), and what is lost of bytes there [%].
SERVERS = {"MAVSDK": "MAVSDK's", "Betaflight": "Betaflight's", "iNav": "iNav's"}
SERVER_LINES = (0, 1, 3)
IN_TABLE = ("ArduPilot", "PX4")
PLAINER = "usual rule"  # that of test/rates/plainer_clients.toml which the table has
CLIENTS = {"upload-by-answer": "`uploadWithoutReadback()`", "upload": "`upload()`"}
MOST_HELD = 302  # items on the wire, home included: an even number
OWN_FLAGS = ["-std=c++17", "-fno-access-control", f"-DMOST_HELD={MOST_HELD}"]
LINES = (("frames", 5), ("frames", 25), ("frames", 40), ("bytes", 1), ("bytes", 3), ("bytes", 5))  # what is lost [%]
SEEDS = 200
# Latency each way [ms], bytes lost [%], items: for long plans, and for lines that answer late.
LONG = [(0, 0, 60), (0, 1, 60), (0, 3, 60), (0, 5, 60), (0, 0, 300), (0, 1, 300)]
LATE = LONG + [(late_ms, percent, items) for late_ms in (150, 500) for items in (5, 60) for percent in (0, 1, 3)]
LATE_SEEDS = 20
BUSY = 2000  # telemetry on a busy line [bytes/s]
# upload() of five items where 1 % of the bytes are lost: what the median may be [s].
MEDIAN_S = 1.5
# What is sent unasked [bytes/s].
TELEMETRY = {"ArduPilot": 0, "LateArduPilot": 0, "PX4": 1100, "MAVSDK": 0, "Betaflight": 0, "iNav": 0}


@dataclass(frozen=True)
class Upload:
    """One upload's end: what the client said, and what was so."""

    seed: int
    status: str  # `never`: it did not end
    is_aboard: bool
    aboard: str  # what the client says is aboard
    is_aboard_true: bool
    took_s: float  # from the first COUNT
    bytes_sent: int  # by the client in that time
    repeated_unasked: int  # COUNTs and items
    zeros: int  # between frames
    bytes_repeated: int  # zeros, and what was sent before
    telemetry: int  # frames that the autopilot had to send unasked
    left_out: int  # and those of them for which its line had no room

    @property
    def is_success(self) -> bool:
        return self.status == "Accepted" and self.is_aboard

    @property
    def is_false_acceptance(self) -> bool:
        return self.status == "Accepted" and not self.is_aboard


@functools.cache
def build_rates(library: tuple[Path, ...] | None = None) -> Path:
    shared = [HOST / name for name in ("Frames.cpp", "Names.cpp", "PlanFrames.cpp")]
    sources = [*sorted(RATES.glob("*.cpp")), *(EXPLORER / name for name in MODELS), *shared, HEARING]
    return build_host("rates", sources, "g++", FAST, own_flags=OWN_FLAGS, library=library)


@functools.cache
def uploads(
    autopilot: str, client: str, lost: str, percent: int, seeds: int, program: Path | None = None, baud: int = 57600,
    loop_ms: int = 0, telemetry: int | None = None, latency_ms: int = 0, items: int = 5,
) -> tuple[Upload, ...]:
    """The ends of the uploads with the seeds from 0 on. Raises RuntimeError if the program fails."""
    words = [str(program or build_rates()), autopilot, client, lost, *map(str, (percent, seeds, baud, loop_ms))]
    if telemetry is None:
        telemetry = TELEMETRY[autopilot]
    words += map(str, (telemetry, latency_ms, items))
    ran = subprocess.run(words, capture_output=True, text=True, check=False)
    if ran.returncode != 0:
        raise RuntimeError(f"{' '.join(map(str, words))}: {ran.stderr}")
    found = []
    for line in ran.stdout.splitlines():
        seed, status, is_aboard, aboard, is_true, ms, *counts = line.split()
        end = Upload(int(seed), status, is_aboard == "1", aboard, is_true == "1", int(ms) / 1000, *map(int, counts))
        found.append(end)
    return tuple(found)


def plainer_clients(lost: str, percent: int) -> dict[str, list[str]]:
    """By what each does, its cells of the table's row for this line."""
    return tomllib.loads((RATES / "plainer_clients.toml").read_text())[f"{percent} % of {lost}"]


def rows(seeds: int = SEEDS, lines: tuple[tuple[str, int], ...] = LINES) -> list[list[str]]:
    """The table, its head first: a row for each line, in which each client has a column for each autopilot."""
    clients = [PLAINER, *CLIENTS.values()]
    table = [["lost", *(f"{client}, {autopilot}" for client in clients for autopilot in IN_TABLE)]]
    columns = [list(AUTOPILOTS).index(autopilot) for autopilot in IN_TABLE]
    for lost, percent in lines:
        plainer = plainer_clients(lost, percent)[PLAINER]
        medians = plainer[-len(AUTOPILOTS):]  # fmt: skip
        ends = [uploads(autopilot, client, lost, percent, seeds) for client in CLIENTS for autopilot in IN_TABLE]
        table.append([f"{percent} % of {lost}", *(f"{plainer[at]}, {medians[at]}" for at in columns),
                      *(", ".join(cells(one)) for one in ends)])  # fmt: skip
    return table


def server_rows(seeds: int = SEEDS) -> list[list[str]]:
    """upload() to servers of an unknown firmware: a row for each loss."""
    table = [["bytes lost", *(f"Accepted, median, {name}" for name in SERVERS.values())]]
    for percent in SERVER_LINES:
        by_server = [uploads(server, "upload", "bytes", percent, seeds) for server in SERVERS]
        table.append([f"{percent} %", *(", ".join(cells(ends)) for ends in by_server)])
    return table


def late_rows(seeds: int = LATE_SEEDS) -> list[list[str]]:
    """upload() where plans are long or answers come late: the median times, a row for each delay and plan."""
    percents = sorted({percent for _, percent, _ in LATE})
    table = [["each way", "items", *(f"{autopilot}, {percent} %" for autopilot in IN_TABLE for percent in percents)]]
    for latency_ms, items in dict.fromkeys((latency_ms, items) for latency_ms, _, items in LATE):
        row = [f"{latency_ms} ms", str(items)]
        for autopilot in IN_TABLE:
            for percent in percents:
                is_tried = (latency_ms, percent, items) in LATE
                ends = late_uploads(autopilot, percent, seeds, 0, latency_ms, items) if is_tried else ()
                row.append(median_s(ends))
        table.append(row)
    return table


def late_uploads(
    autopilot: str, percent: int, seeds: int, telemetry: int, latency_ms: int, items: int, program: Path | None = None
) -> tuple[Upload, ...]:
    return uploads(
        autopilot, "upload", "bytes", percent, seeds, program, telemetry=telemetry, latency_ms=latency_ms, items=items
    )


def cells(ends: tuple[Upload, ...]) -> tuple[str, str]:
    """How many succeeded, and their median time."""
    return share(sum(end.is_success for end in ends), len(ends)), median_s(ends)


def median_s(ends: tuple[Upload, ...]) -> str:
    """Of the successes, from the first COUNT."""
    times = sorted(end.took_s for end in ends if end.is_success)
    return f"{times[len(times) // 2]:.1f} s" if times else "-"


def share(part: int, whole: int) -> str:
    return f"{100 * part / whole:.1f} %"


def for_documents() -> str:
    """What stands between the marks in the documents."""
    note = (
        f"Uploads of five items, {SEEDS} for each autopilot on each line, by `tools/refresh rates`: how many ended as\n"
        "`Accepted`, and their median time from the first COUNT."
    )
    late = (
        f"`upload()` of long plans, and on slow lines: the median time of the successes of {LATE_SEEDS}, by the "
        "autopilot and the\nbytes lost."
    )
    servers = (
        f"The same, {SEEDS} of each, to servers of a firmware that the library does not know, by their sources. By\n"
        "`upload()`: `uploadWithoutReadback()` is never accepted there, since an acceptance of theirs is no proof."
    )
    return (
        f"{note}\n\n{aligned(rows(), left=1)}\n\n{late}\n\n{aligned(late_rows(), left=2)}\n\n"
        f"{servers}\n\n{aligned(server_rows(), left=1)}"
    )
