"""What takes long by itself, beside update(): reading a number of a text, looking whether EEPROM holds a plan."""

from __future__ import annotations

from simulation.mega import Mega

from .firmware import measured
from .record import Section
from .report import aligned, rounded
from .runs import HZ

# By the numbers that test/measured/work.cpp takes them by, and the function in it that is watched.
TEXT, BEGIN, BLOCK = (1, "measured_take"), (2, "measured_begin"), (3, "measured_block")
MOST_WAYPOINTS = 127  # of a file, in a Mega's EEPROM
MOST_MS = 20_000  # for any of it: EEPROM is slow to write

HEAD = "QGC WPL 110\n0\t1\t0\t16\t0\t0\t0\t0\t-35.36326210\t149.16523740\t584.090000\t1\n"
# As Mission Planner writes them, and the worst that may be there.
USUAL = "1\t0\t3\t16\t2.50000000\t0.00000000\t0.00000000\t0.00000000\t-35.36145000\t149.16523740\t20.300000\t1\n"
WORST = "1\t0\t3\t16\t9.999999999999999999e-44\t0\t0\t0\t0\t0\t0\t1\n"


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


def sha256_block() -> int:
    return longest(BLOCK)


def costs() -> Section:
    """[cycles]"""
    return {
        "`WaypointsText::take()`, of numbers as Mission Planner writes them": longest(TEXT, HEAD + USUAL),
        "the same, of a number of 19 digits near the smallest float": longest(TEXT, HEAD + WORST),
        f"`EepromPlan::begin()`, {MOST_WAYPOINTS} waypoints kept": longest(BEGIN),
    }


def table(costs: Section) -> str:
    lines = [["one call", "cycles", "ms"]]
    return aligned(lines + [[call, rounded(cycles), f"{1000 * cycles / HZ:.2g}"] for call, cycles in costs.items()],
                   left=1)  # fmt: skip
