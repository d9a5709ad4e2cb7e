"""How long operations take at 57600 baud: plans by item and by file, and beside telemetry that is paused or not."""

from __future__ import annotations

from simulation.bench import Bench, FunctionPlan
from simulation.quiet import RECORDED, Quiet, as_recorded, default_list

from .documents import aligned

LISTENS_S = 2.0  # before an operation begins
LONGEST_S = 300.0

# By the mission protocol and as files, beside the simulated ArduPilot ----------------

FILE_PLANS = (10, 50, 200)
LINES = ("idle", "full")  # without telemetry, and with as much as in the recordings
REQUESTS = ("FILE_TRANSFER_PROTOCOL", "MISSION_COUNT", "MISSION_REQUEST_LIST")
UPLOADS = (("upload", 2), ("fileupload",))
READINGS = (("verify",), ("fileverify",))


def operation_s(made: Bench, words: tuple, end: str) -> float:
    """From the first request on [s]. Raises RuntimeError unless it ends so."""
    since_s = made.now
    made.tell(*words)
    if (ended := made.run_until_ended(LONGEST_S)) != end:
        raise RuntimeError(f"{words} ended as {ended}")
    ended_s = [event.ms for event in made.events if event.word == "end"][-1] / 1000
    return ended_s - min(time for time in made.sent_at(*REQUESTS) if time > since_s)


def bench(line: str, items: int) -> Bench:
    options = as_recorded("ArduPilot") if line == "full" else {}
    made = Bench("ArduPilot", defines={"BENCH_FILES": 1, "BENCH_ENSURE": 1}, **options)
    made.run(LISTENS_S)
    made.use(FunctionPlan(items))
    return made


def read_s(line: str, items: int, words: tuple) -> float:
    """Of what reads the plan aboard."""
    made = bench(line, items)
    made.tell("fileupload")
    made.run_until_ended(LONGEST_S)
    made.run(LISTENS_S)
    return operation_s(made, words, "Verified")


def files() -> str:
    """A row for each plan on each line."""
    lines = [["line", "items", "`Accepted`, by item", "`Accepted`, by file", "`Verified`, by item",
              "`Verified`, by file"]]  # fmt: skip
    for line in LINES:
        for items in FILE_PLANS:
            took = [*(operation_s(bench(line, items), words, "Accepted") for words in UPLOADS),
                    *(read_s(line, items, words) for words in READINGS)]  # fmt: skip
            lines.append([line, str(items), *(f"{seconds:.2f}" for seconds in took)])
    note = "Seconds, from the first request on, at 57600 baud beside the simulated ArduPilot."
    return f"{note}\n\n{aligned(lines, left=1)}"


# On a full line, as it is and with a TelemetryPause ----------------------------------

QUIET_PLANS = (50, 200)


def quiet_bench(personality: str) -> Quiet:
    return Quiet(personality, **as_recorded(personality))


def hushing_s(personality: str) -> float:
    """From the first command to the last answer that the messages of the list need to be silent [s]."""
    on = quiet_bench(personality)
    on.run_until_idle()
    on.run_until(3.0)
    on.upload_quietly(QUIET_PLANS[-1])
    asked = on.asked_since(3.0, -1)
    if asked != default_list(personality):
        raise RuntimeError(f"{personality} was asked for {asked}")
    began = next(when for when, _, interval in on.asked if when >= 3.0 and interval == -1)
    return on.now - began


def quiet_transfers() -> str:
    lines = [["57600 baud, full line; seconds, as it is / quiet", *RECORDED]]
    for what, took_s in (("upload of", Quiet.transfer_s), ("reading back", Quiet.read_back_s)):
        for items in QUIET_PLANS:
            cells = (" / ".join(f"{took_s(quiet_bench(name), used, items):.2f}" for used in (False, True))
                     for name in RECORDED)  # fmt: skip
            lines.append([f"{what} {items} items", *cells])
    lines.append(["switching off", *(f"{hushing_s(name):.2f}" for name in RECORDED)])
    return aligned(lines, left=1)
