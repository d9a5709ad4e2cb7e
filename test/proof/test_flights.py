"""Others take the aircraft between any two frames: the library as it ships, in flights against small models of the
autopilots, by test/flights.

A pilot, a failsafe, another station, a line that is cut or loses, a loop() that stands still, devices of other kinds, a
second vehicle that is heard when the first one is silent: each acts at every moment of a clean flight at which a frame
leaves or arrives, and some of them at random on lossy links. What must hold is in flights/Referee.h: whoever takes
the aircraft keeps it, nothing is left armed, no other aircraft is spoken to, and what the library says is so.
By hand, and one flight told in words:

    build/venv/bin/python test/proof/test_flights.py PX4 goTo each 1
    build/venv/bin/python test/proof/test_flights.py Copter start one pilot@120

A planted defect, of flight_defects.diff, is a line of the library changed in a copy of it.
"""

from __future__ import annotations

import collections
import functools
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

if __name__ == "__main__":
    root = Path(__file__).resolve().parents[2]
    sys.path[:0] = [str(root), str(root / "tools"), str(root / "test" / "support")]

import pytest

from mutating.programs import sources_of
from planted import defects
from simulation.firmware import ROOT
from simulation.host_build import FAST, build_host

FLIGHTS = ROOT / "test" / "flights"
AUTOPILOTS = ("Copter", "Rover", "PX4")
COLUMNS = ["autopilot", "bytes lost", "flights", "somebody took it", "undone, longest", "undone and never shown",
           "from his mode to the order, longest", "violations"]  # fmt: skip
WINDOW_MS = 30  # from the heartbeat that shows no foreign mode to the order's arrival: docs/in_control.md
GIVEN_BACK_MS = 300
TWO_HEARTBEATS_MS = 2000


@functools.cache
def build_flights(library: tuple[Path, ...] | None = None) -> Path:
    return build_host("flights", sources_of(FLIGHTS), "g++", FAST, library=library)


@functools.cache
def fly(words: str, program: Path | None = None) -> dict[str, Any]:
    """What the flights found, by name; `rules` were broken, `broken` is the first flight that has broken one."""
    ran = subprocess.run([program or build_flights(), *words.split()], capture_output=True, text=True, check=False)
    assert ran.returncode in (0, 1), f"{words}: {ran.stdout}{ran.stderr}"
    figures, _, broken = ran.stdout.partition("broken=")
    lines = [line.split("=", 1) for line in figures.splitlines()]
    rules = [words.partition(" ")[2] for name, words in lines if name == "rule"]
    ends = [tuple(words.split(" ", 1)) for name, words in lines if name == "end"]
    return dict(lines) | {"rules": "\n".join(rules), "ends": ends, "broken": broken}


def expect_nothing_broken(record_property, flown: list[tuple[str, str, str]]) -> int:
    """Fly each (autopilot, bytes lost, words), and print one row for each; the flights in all."""
    rows = []
    for autopilot, lost, words in flown:
        found = fly(f"{autopilot} {words}")
        assert found["violations"] == "0", f"{autopilot} {words}\n{found['broken']}"
        assert int(found["taken"]) > 0
        rows.append([autopilot, lost, found["flights"], found["taken"], found["undone_ms"] + " ms", found["unseen"],
                     found["window_ms"] + " ms", "0"])  # fmt: skip
        assert int(found["window_ms"]) <= WINDOW_MS
        if lost == "none" and " each " in words:  # one actor: no line is cut beside a pilot
            assert int(found["undone_ms"]) < GIVEN_BACK_MS
    record_property("table", ["flights in which others take the aircraft", [COLUMNS, *rows]])
    return sum(int(row[2]) for row in rows)


def seeds(few: int, all_of_them: int):
    """From which one on, and how many: in tools/test these few, with --all the others, too."""
    rest = pytest.param(few + 1, all_of_them - few, marks=[pytest.mark.slow, pytest.mark.thorough])
    return pytest.mark.parametrize(("first", "count"), [(1, few), rest])


# One flight in so many; tools/test --all takes more. (Those of the planted defects are flown each time.)
@pytest.mark.parametrize("one_in", [30, pytest.param(8, marks=[pytest.mark.slow, pytest.mark.thorough])])
def test_whoever_acts_at_any_moment_keeps_the_aircraft(record_property, one_in):
    flown = [(autopilot, "none", f"all each {one_in} --own {own}") for autopilot in AUTOPILOTS for own in (0, 1)]
    flights = expect_nothing_broken(record_property, flown)
    assert one_in > 8 or flights > 12_500  # as docs/design/proof.md says


@seeds(20, 150)
def test_whoever_acts_keeps_the_aircraft_on_a_line_that_loses(record_property, first, count):
    flown = [(autopilot, f"{loss / 10} %" if loss else "none", f"all random {count} --loss {loss} --seed {first}")
             for autopilot in AUTOPILOTS for loss in (0, 5, 30)]  # fmt: skip
    flights = expect_nothing_broken(record_property, flown)
    assert flights > 83 * count


@seeds(40, 350)
def test_whoever_takes_it_while_loop_stands_still_keeps_it(record_property, first, count):
    flown = [(autopilot, f"{loss / 10} %" if loss else "none", f"all standstills {count} --loss {loss} --seed {first}")
             for autopilot in AUTOPILOTS for loss in (0, 5)]  # fmt: skip
    expect_nothing_broken(record_property, flown)


@seeds(20, 340)
def test_operations_at_random_with_two_vehicles_end_true_and_concern_their_own(first, count):
    """20 in a row, beside all actors; the sketch names the other vehicle at times."""
    operations, ends = 0, collections.Counter()
    for autopilot in AUTOPILOTS:
        found = fly(f"{autopilot} all plays {count} --seed {first}")
        assert found["violations"] == "0", found["broken"]
        operations += int(found["operations"])
        ends.update({words: int(times) for times, words in found["ends"]})
    assert operations > 58 * count
    assert min(ends[words] for words in ENDS) > count // 4, ends


ENDS = ("done: the autopilot confirmed it", "accepted: the plan is aboard", "cleared: no plan is aboard",
        "a pilot or another station is in control", "no autopilot heard in time")  # fmt: skip


# What a sketch does to an aircraft that it flies.
TAKEN_FROM = ("start", "goTo", "pause", "resume", "returnHome", "follow")


@seeds(50, 200)
def test_two_hundred_pilots_take_it_in_each_operation_and_keep_it(first, count):
    """Each at a random moment of an operation. (Referee.h says what must hold, and Flight.cpp that it all ends.)"""
    for autopilot in AUTOPILOTS:
        for loss in (0, 30):
            found = fly(f"{autopilot} all pilots {count} --loss {loss} --seed {first}")
            assert found["violations"] == "0", found["broken"]
            taken = {task: int(found[task].split(" ")[0]) for task in TAKEN_FROM}
            assert min(taken.values()) >= count, taken
            assert int(found["window_ms"]) <= WINDOW_MS
            assert int(found["undone_ms"]) < (TWO_HEARTBEATS_MS if loss else GIVEN_BACK_MS)


# Modes that are set again later than behind two heartbeats, on a line that loses 3 of 100 bytes: at most 1 of so
# many. There 74 of 100 orders are lost, and 86 of 100 requests for a heartbeat bring none, so that no limit holds for
# each of them. Before a mode was set again behind each heartbeat it was every second.
LATE_ONE_IN = 200


@seeds(30, 100)
def test_a_mode_that_an_order_undoes_is_set_again_at_once(first, count):
    """Somebody sets a mode while an order is under way; others set other ones in the second behind it."""
    for autopilot in AUTOPILOTS:
        for loss in (0, 5, 30):
            found = fly(f"{autopilot} all overtakes {count} --loss {loss} --seed {first}")
            assert found["violations"] == "0", found["broken"]
            if loss < 30:
                assert int(found["undone_ms"]) < GIVEN_BACK_MS
            else:
                again, late = int(found["set_again"]), int(found["longer_2000"])
                assert again >= count // 20 or autopilot == "PX4"  # PX4 does not tell of a mode when it is set
                assert late * LATE_ONE_IN <= again


DEFECTS = defects("flight_defects.diff")
# Each time: an arming at any time, an autopilot that another one follows, targets into silence, another station's plan,
# an arming that is not seen.
ALWAYS = ("kArmDisarm", "a silent autopilot", "a target leaves", "a follower does", "arm() believes")
DEFECT = [name if name.startswith(ALWAYS) else pytest.param(name, marks=pytest.mark.thorough) for name in DEFECTS]


@pytest.mark.slow
@pytest.mark.parametrize("defect", DEFECT)
def test_a_planted_defect_is_found(defect):
    planted = DEFECTS[defect]
    assert fly(planted.words)["violations"] == "0"
    found = fly(planted.words, build_flights(planted.library))
    assert int(found["violations"]) > 0
    assert any(line.startswith(planted.rule) for line in found["rules"].splitlines()), found["rules"]
    assert "the sketch begins" in found["broken"]  # how it came to that


if __name__ == "__main__":
    flights = build_flights()
    os.execv(flights, [str(flights), *sys.argv[1:]])
