"""How long plans take to go up and to come back, by the mission protocol and as files.

The firmware on a simulated Mega, at 57600 baud, beside the simulated ArduPilot: on a line without telemetry, and on one
that is full of it as in the recordings.
"""

from __future__ import annotations

from simulation.bench import Bench, FunctionPlan
from simulation.quiet import as_recorded

from .report import aligned

BAUD = 57600
PLANS = (10, 50, 200)
LINES = {"idle": {}, "full": as_recorded("ArduPilot")}
FTP = "FILE_TRANSFER_PROTOCOL"
READINGS = (("verify", "Verified"), ("fileverify", "Verified"))
LISTENS_S = 2.0  # before an operation begins
LONGEST_S = 300.0


def bench(line: str) -> Bench:
    # A generator of telemetry is used up by one bench.
    options = as_recorded("ArduPilot") if line == "full" else LINES[line]
    made = Bench("ArduPilot", baud=BAUD, defines={"BENCH_FILES": 1, "BENCH_ENSURE": 1}, **options)
    made.run(LISTENS_S)
    return made


def began_s(made: Bench, since_s: float) -> float:
    """When the last byte of the operation's first request left."""
    times = made.sent_at(FTP, "MISSION_COUNT", "MISSION_REQUEST_LIST")
    return min(time for time in times if time > since_s)


def ended_s(made: Bench) -> float:
    return [event.ms for event in made.events if event.word == "end"][-1] / 1000


def uploaded(line: str, items: int, by_file: bool) -> float:
    """From the first request to Accepted, reading back included [s]."""
    made = bench(line)
    made.use(FunctionPlan(items))
    since_s = made.now
    made.tell(*(("fileupload",) if by_file else ("upload", 2)))
    if (ended := made.run_until_ended(LONGEST_S)) != "Accepted":
        raise RuntimeError(f"{items} items on a {line} line: {ended}")
    return ended_s(made) - began_s(made, since_s)


def read(line: str, items: int, word: str, end: str) -> float:
    """From the first request of what reads the plan aboard to its end [s]."""
    made = bench(line)
    made.use(FunctionPlan(items))
    made.tell("fileupload")
    made.run_until_ended(LONGEST_S)
    made.run(LISTENS_S)
    since_s = made.now
    made.tell(word)
    if (ended := made.run_until_ended(LONGEST_S)) != end:
        raise RuntimeError(f"{items} items on a {line} line: {ended}")
    return ended_s(made) - began_s(made, since_s)


def rows() -> list[list[str]]:
    """The table, its head first: a row for each plan on each line."""
    table = [["line", "items", "`Accepted`, by item", "`Accepted`, by file", "`Verified`, by item",
              "`Verified`, by file"]]  # fmt: skip
    for line in LINES:
        for items in PLANS:
            took = [*(uploaded(line, items, by_file) for by_file in (False, True)),
                    *(read(line, items, *way) for way in READINGS)]  # fmt: skip
            table.append([line, str(items), *(f"{seconds:.2f}" for seconds in took)])
    return table


def for_documents() -> str:
    """What stands between the marks in the documents."""
    note = "Seconds, from the first request on, at 57600 baud beside the simulated ArduPilot."
    return f"{note}\n\n{aligned(rows(), left=1)}"
