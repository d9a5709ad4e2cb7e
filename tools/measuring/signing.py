"""What signing costs: cycles of hashing, the longest update(), items and frames in time."""

from __future__ import annotations

from simulation.bench import Bench, FunctionPlan
from simulation.fake_autopilot import mavlink
from simulation.signing_program import KEY, signer

from .record import Section
from .report import aligned, rounded
from .work import sha256_block

SIGNED, PLAIN = "signed", "not signed"
HASH, PIECE = "a block of SHA-256", "the longest piece of hashing in an update()"
UPDATE = "longest update() of an upload on a full line"
ITEM = "an item of an upload to ArduPilot at 57600 baud"
FRAMES = "frames checked in a second, no byte lost"
DEFINES = {"MAVMISSION_SIGNING": 1}
SINCE_2015_S = 375_000_000.0  # the autopilot's clock at the start
LOOPS_MS = (0, 1, 2, 5)  # beside update()
FULL_LINE = 5000.0  # telemetry [bytes/s]
# One that is for us, so that it must be checked: 31 bytes, two blocks of SHA-256.
FRAME = mavlink.MAVLink_mission_current_message(3, 10, 2, 1, 0, 0, 0)
LINE_FRAMES = 185  # of those in a second: a full line of 57600 baud


def bench(*, signed: bool, **options) -> Bench:
    """The tests' firmware beside an autopilot that signs as it does, or does not."""
    if not signed:
        return Bench("ArduPilot", **options)
    made = Bench("ArduPilot", defines=DEFINES, signing_key=KEY, signing_time_s=SINCE_2015_S, **options)
    made.tell("sign", 7)
    return made


def longest_update(*, signed: bool) -> int:
    """In an upload on a full line [cycles], interrupts included."""
    on = bench(signed=signed, telemetry=FULL_LINE)
    on.tell("callbacks", 0)  # which print
    watch = on.mega.watch("updateClient")
    upload(on, 10)
    return watch.calls.longest


def longest_piece() -> int:
    """Of hashing, in one update() [cycles]."""
    on = bench(signed=True)
    watch = on.mega.watch("mavmission::detail::Sha256::work")
    upload(on, 10)
    return watch.calls.longest_own


def item_ms(*, signed: bool) -> float:
    """Of an upload at 57600 baud, in a loop that does nothing else."""
    few, many = (transfer_s(bench(signed=signed), items) for items in (10, 60))
    return 1000 * (many - few) / 50


def upload(on: Bench, items: int) -> None:
    on.upload(FunctionPlan(items))
    if (ended := on.run_until_ended(limit_s=20)) != "Accepted":
        raise RuntimeError(f"an upload under measurement ended with {ended}")


def transfer_s(on: Bench, items: int) -> float:
    """From COUNT to the acceptance."""
    upload(on, items)
    return on.wire.frames("<", "MISSION_ACK")[-1].time - on.wire.frames(">", "MISSION_COUNT")[-1].time


def checked_in_a_second(loop_ms: int) -> int:
    """The most frames for us that come in a second, evenly, and are all checked without the loss of a byte."""
    least, beyond = 0, LINE_FRAMES + 1
    while beyond - least > 1:
        middle = (least + beyond) // 2
        least, beyond = (middle, beyond) if all_are_checked(loop_ms, middle) else (least, middle)
    return least


def all_are_checked(loop_ms: int, count: int) -> bool:
    """Of so many in a second; loop() takes so long beside update()."""
    on = Bench(None, defines=DEFINES)
    on.tell("sign", 7)
    autopilot = signer((1, 1), time=round(SINCE_2015_S * 100_000))
    on.say_bytes(bytes(mavlink.MAVLink_heartbeat_message(2, 12, 81, 0, 3, 3).pack(autopilot)))
    on.run(0.2)
    on.tell("nosleep", 1)
    on.tell("stall", 1 if loop_ms else 0, loop_ms)
    begun, before = on.now, accepted(on)
    for n in range(count):
        on.run_until(begun + n / count)
        autopilot.seq = n % 256
        on.say_bytes(bytes(FRAME.pack(autopilot)))
    on.run(0.2)
    return accepted(on) - before == count and on.mega.serial(1).lost == 0


def accepted(on: Bench) -> int:
    (line,) = on.tell("signing")
    return int(line.partition("accepted=")[2].split()[0])


def costs() -> Section:
    """Cycles, milliseconds and frames, as the rows of the table name them."""
    return {
        HASH: sha256_block(),
        PIECE: longest_piece(),
        UPDATE: {name: longest_update(signed=name == SIGNED) for name in (SIGNED, PLAIN)},
        ITEM: {name: round(item_ms(signed=name == SIGNED), 1) for name in (SIGNED, PLAIN)},
        FRAMES: {f"{loop_ms} ms": checked_in_a_second(loop_ms) for loop_ms in LOOPS_MS},
    }


def table(costs: Section) -> str:
    """As the documents have it."""
    loops, frames = (" / ".join(map(str, part)) for part in (LOOPS_MS, costs[FRAMES].values()))
    return aligned([
        ["", "", SIGNED, PLAIN],
        *([row, "cycles", rounded(costs[row]), "–"] for row in (HASH, PIECE)),
        [UPDATE, "cycles", *map(rounded, costs[UPDATE].values())],
        [ITEM, "ms", *map(str, costs[ITEM].values())],
        [f"{FRAMES}, loop of {loops} ms", "frames", frames, "–"],
    ], left=2)  # fmt: skip
