"""What grows with a plan, what takes long in one call, and what signing costs."""

from __future__ import annotations

from simulation.bench import Bench, FunctionPlan
from simulation.fake_autopilot import mavlink
from simulation.mega import Mega
from simulation.signing_program import KEY, signer

from .calls import UPLOAD, Caller
from .documents import aligned, rounded
from .firmware import measured
from .record import Section
from .runs import HZ, upload_of

# How an upload at 57600 baud grows with its plan: RAM does not, time does -----------

PLANS = (10, 100, 1_000, 10_000)


def growth() -> Section:
    """Of plans of so many items: globals and the stack of update(), interrupts apart [bytes], and the upload [s]."""
    return {str(items): {"ram": ram_for(items), "seconds": round(upload_of(items).cycles / HZ, 2)} for items in PLANS}


def ram_for(items: int) -> int:
    caller = Caller("PX4", items)
    return caller.mega.globals_bytes + caller.play(UPLOAD)


def growth_table(costs: Section) -> str:
    lines = [["items", "RAM [bytes]", "time [s]", "time per item [ms]"]]
    lines += [[f"{int(items):,}", rounded(cost["ram"]), f"{cost['seconds']:.1f}",
               f"{1000 * cost['seconds'] / int(items):.1f}"] for items, cost in costs.items()]  # fmt: skip
    return aligned(lines, left=0)


# One call by itself, beside update() -----------------------------------------------

# By the numbers that test/measured/work.cpp takes them by, and the function in it that is watched.
TEXT, BEGIN, BLOCK = (1, "measured_take"), (2, "measured_begin"), (3, "measured_block")
MOST_WAYPOINTS = 127  # of a file, in a Mega's EEPROM
MOST_MS = 20_000  # for any of it: EEPROM is slow to write

HEAD = "QGC WPL 110\n0\t1\t0\t16\t0\t0\t0\t0\t-35.36326210\t149.16523740\t584.090000\t1\n"
# As Mission Planner writes them, and the worst that may be there.
USUAL = "1\t0\t3\t16\t2.50000000\t0.00000000\t0.00000000\t0.00000000\t-35.36145000\t149.16523740\t20.300000\t1\n"
WORST = "1\t0\t3\t16\t9.999999999999999999e-44\t0\t0\t0\t0\t0\t0\t1\n"
WORK = {
    "`WaypointsText::take()`, of numbers as Mission Planner writes them": (TEXT, HEAD + USUAL),
    "the same, of a number of 19 digits near the smallest float": (TEXT, HEAD + WORST),
    f"`EepromPlan::begin()`, {MOST_WAYPOINTS} waypoints kept": (BEGIN, ""),
}


def longest(work: tuple[int, str], text: str = "") -> int:
    """The longest call [cycles], interrupts apart."""
    number, function = work
    mega = Mega(measured("work", ITEMS=MOST_WAYPOINTS))
    mega.run_ms(5)
    watch = mega.watch(function)
    mega.poke("characters", text.encode() + b"\0")
    mega.poke_int("workDue", number)
    for _ in range(MOST_MS):
        mega.run_ms(1)
        if not mega.peek_int("workDue"):
            break
    if mega.peek_int("workDue") or not mega.peek_int("isGood"):
        raise RuntimeError(f"{function} did not do what it should")
    return watch.calls.longest_own


def work() -> Section:
    """[cycles]"""
    return {call: longest(*done) for call, done in WORK.items()}


def work_table(costs: Section) -> str:
    lines = [["one call", "cycles", "ms"]]
    return aligned(lines + [[call, rounded(cycles), f"{1000 * cycles / HZ:.2g}"] for call, cycles in costs.items()],
                   left=1)  # fmt: skip


# Signing ----------------------------------------------------------------------------

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


def signing() -> Section:
    """Cycles, milliseconds and frames, as the rows of the table name them."""
    return {
        HASH: longest(BLOCK),
        PIECE: longest_piece(),
        UPDATE: {name: longest_update(signed=name == SIGNED) for name in (SIGNED, PLAIN)},
        ITEM: {name: round(item_ms(signed=name == SIGNED), 1) for name in (SIGNED, PLAIN)},
        FRAMES: {f"{loop_ms} ms": checked_in_a_second(loop_ms) for loop_ms in LOOPS_MS},
    }


def signing_table(costs: Section) -> str:
    """As the documents have it."""
    loops, frames = (" / ".join(map(str, part)) for part in (LOOPS_MS, costs[FRAMES].values()))
    return aligned([
        ["", "", SIGNED, PLAIN],
        *([row, "cycles", rounded(costs[row]), "–"] for row in (HASH, PIECE)),
        [UPDATE, "cycles", *map(rounded, costs[UPDATE].values())],
        [ITEM, "ms", *map(str, costs[ITEM].values())],
        [f"{FRAMES}, loop of {loops} ms", "frames", frames, "–"],
    ], left=2)  # fmt: skip
