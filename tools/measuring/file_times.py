"""How long plans take to go up and to come back, by the mission protocol and as files, beside the time of their bytes.

The firmware on a simulated Mega, at 57600 baud, beside the simulated ArduPilot: on a line without telemetry, and on one
that is full of it as in the recordings.
"""

from __future__ import annotations

from simulation.bench import Bench, FunctionPlan
from simulation.fake_autopilot.ftp import HEADER, ITEM_SIZE, TERMINATE, Request
from simulation.quiet import as_recorded

from .report import aligned

BAUD = 57600
PLANS = (10, 50, 200, 600)
LINES = {"idle": {}, "full": as_recorded("ArduPilot")}
FTP = "FILE_TRANSFER_PROTOCOL"
READINGS = (("verify", "Verified"), ("fileverify", "Verified"), ("ensure", "AlreadyAboard"),
            ("fileensure", "AlreadyAboard"))  # fmt: skip
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


def stored_s(made: Bench) -> float:
    """When the autopilot's answer to the plan came: MISSION_ACK, or that to TerminateSession."""
    for entry in made.wire.frames("<", FTP, "MISSION_ACK"):
        if entry.message.get_type() == "MISSION_ACK" or Request.of(entry.message).req_opcode == TERMINATE:
            return entry.time
    raise RuntimeError("the autopilot has not answered")


def uploaded(line: str, items: int, by_file: bool) -> tuple[float, float]:
    """From the first request to the autopilot's answer, and to Accepted, reading back included [s]."""
    made = bench(line)
    made.use(FunctionPlan(items))
    since_s = made.now
    made.tell(*(("fileupload",) if by_file else ("upload", 2)))
    if (ended := made.run_until_ended(LONGEST_S)) != "Accepted":
        raise RuntimeError(f"{items} items on a {line} line: {ended}")
    began = began_s(made, since_s)
    return stored_s(made) - began, ended_s(made) - began


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


def bytes_s(items: int) -> float:
    """The time of the file's bytes alone, home included [s]."""
    return (HEADER.size + ITEM_SIZE * (items + 1)) * 10 / BAUD


def rows() -> list[list[str]]:
    """The table, its head first: a row for each plan on each line."""
    table = [["line", "items", "bytes alone", "answered, by item", "answered, by file", "`Accepted`, by item",
              "`Accepted`, by file", "`Verified`, by item", "`Verified`, by file", "`AlreadyAboard`, by item",
              "`AlreadyAboard`, by file"]]  # fmt: skip
    for line in LINES:
        for items in PLANS:
            (item_s, item_proven_s), (file_s, file_proven_s) = (uploaded(line, items, way) for way in (False, True))
            took = [bytes_s(items), item_s, file_s, item_proven_s, file_proven_s,
                    *(read(line, items, *way) for way in READINGS)]  # fmt: skip
            table.append([line, str(items), *(f"{seconds:.2f}" for seconds in took)])
    return table


def for_documents() -> str:
    """What stands between the marks in the documents."""
    note = "Seconds, from the first request on, at 57600 baud beside the simulated ArduPilot."
    return f"{note}\n\n{aligned(rows(), left=1)}"
