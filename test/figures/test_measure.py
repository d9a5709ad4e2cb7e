"""The figures hold their bounds, mean what they say, and are what test/figures/measured.toml and the documents say."""

from __future__ import annotations

import fcntl
import functools
import pickle
import re
import subprocess
import sys
from collections.abc import Callable

import pytest

from building import BUILD, ROOT
from measuring import figures, record, runs, tricks, updates
from measuring.firmware import measured, ours
from measuring.peer import Longest, Peer, telemetry_frames
from refreshing import refresh
from refreshing.things import THINGS
from simulation.firmware import library_file

SECTIONS = {thing.name: thing for thing in THINGS if thing.measure}


def measured_once(name: str, measure: Callable[[], record.Section]) -> record.Section:
    """What `measure` returns, measured once for all workers of a test run."""
    folder = BUILD / "measured"
    folder.mkdir(parents=True, exist_ok=True)
    kept = folder / f"{name}-{refresh.inputs_of(SECTIONS[name])}.pickle"
    with open(folder / f"{name}.lock", "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not kept.exists():
            kept.write_bytes(pickle.dumps(measure()))
    return pickle.loads(kept.read_bytes())


@functools.cache
def is_stale(name: str) -> bool:
    return refresh.is_stale(SECTIONS[name])


def section(name: str) -> record.Section:
    """As recorded, where what it is made of is what was measured; else measured now."""
    return measured_once(name, SECTIONS[name].measure) if is_stale(name) else record.section(name)


# What takes long is left to tools/test --all.
DEAR = ("baseline", "features", "growth", "signing")


@pytest.mark.slow
@pytest.mark.parametrize("name", [pytest.param(name, marks=pytest.mark.thorough if name in DEAR else ())
                                  for name in SECTIONS if name != "updates"])  # fmt: skip
def test_no_figure_is_beyond_its_bound_or_far_from_what_is_recorded(name):
    assert SECTIONS[name].beyond(section(name)) == []


@pytest.mark.slow
@pytest.mark.parametrize("operation", updates.OPERATIONS)
def test_update_stays_within_its_bound(operation):
    """In one loop, on one line of those whose longest is recorded."""
    bounds = record.load()["updates"][operation]
    for played, ended in updates.courses(operation, *updates.SAMPLE) if is_stale("updates") else ():
        assert ended != 0, "it has not ended: it was not seen whole"
        assert played.watch.calls.count > 0
        found = Longest.seen_by([played.watch])
        assert found.waited <= bounds["waited"][1] and found.own <= bounds["own"][1], found


def test_no_update_takes_more_than_a_millisecond():
    recorded = record.section("updates")
    assert recorded.keys() == updates.OPERATIONS.keys()
    assert max(one["waited"] for one in recorded.values()) <= updates.GOAL


def test_ours_is_better_than_either_baseline_where_both_are_measured():
    ours, older = record.section("figures"), record.section("baseline")
    for key in ("globals", "globals_and_stack", "byte_mean", "byte_worst", "turnaround"):
        assert ours[key] < older[key]["MAVLink 1"] < older[key]["MAVLink 2"], key


# The measurements mean what they say ----------------------------------------


def test_parser_is_counted_once_per_byte():
    peer = Peer(ours().built.elf, serve=False)
    mega = peer.mega
    polled, read = mega.watch(ours().poll), mega.watch(runs.READ)
    data = b"".join(telemetry_frames("PX4")[:20])
    mega.run_until(peer.put(data) + 10 * runs.MS)
    # A poll ends with a read() that finds nothing, or with a frame.
    assert read.calls.count - polled.calls.count <= len(data) <= read.calls.count


def test_saturated_line_has_no_gaps():
    peer = Peer(measured("each_millisecond", BAUD=57600, WITHOUT_LIBRARY=True), saturate=True, serve=False)
    mega = peer.mega
    peer.run(100 * runs.MS)
    received = mega.watch(runs.RECEIVED)
    peer.run(runs.SECOND)
    assert received.calls.count == pytest.approx(runs.SECOND / runs.FROM_MEGA, abs=2)


@pytest.mark.parametrize(("baud", "left"), [(57600, 90), (115200, 81)])
def test_core_alone_leaves_what_its_interrupts_leave(baud, left):
    # Known beforehand, from the core's interrupt routines: a check of the definition.
    assert runs.cpu_left(baud, library=False, seconds=0.2) == pytest.approx(left, abs=1)


@pytest.mark.slow
def test_ram_does_not_grow_with_the_plan_and_time_grows_with_it():
    costs = section("growth")
    assert len({cost["ram"] for cost in costs.values()}) == 1
    assert costs["100"]["seconds"] == pytest.approx(10 * costs["10"]["seconds"], rel=0.15)
    assert costs["10000"]["seconds"] == pytest.approx(100 * costs["100"]["seconds"], rel=0.02)


def test_every_trick_is_still_in_the_code_and_a_copy_is_made_without_it():
    for trick in tricks.tricks().values():
        (changed,) = tricks.undone(trick).rglob(trick.file)
        assert trick.instead in changed.read_text() and trick.text in library_file(trick.file).read_text()


COSTS = re.compile(r"//.*\d (?:cycles|bytes (?:less|more|of flash|of RAM)|kB)")


def test_comments_of_the_library_name_no_cost_that_nothing_measures_anew():
    """Such a figure is in a table that a tool writes, or is printed by tools/measure --tricks."""
    places = [file for kind in ("*.h", "*.cpp") for file in (ROOT / "src").rglob(kind) if "mavlink" not in file.parts]
    assert [
        f"{file.name}: {line}" for file in places for line in file.read_text().splitlines() if COSTS.search(line)
    ] == []


# The record -----------------------------------------------------------------


def test_bound_is_one_percent_beyond_and_at_least_a_step():
    assert [record.bound_of(value) for value in (16322, 507, 3, 0, 67.1, 1.011)] == [16486, 513, 4, 0, 67.8, 1.022]
    assert record.bound_of(84.5, more_is_better=True) == 83.6


def test_bounds_only_tighten_and_one_that_was_taken_away_is_made_anew():
    old = {"flash": [100, 101], "left": [80.0, 79.2], "sketch": {"ram": [200, 202], "flash": 900}}
    fresh = {"flash": 110, "left": 90.0, "sketch": {"ram": 150, "flash": 950}}
    tight = {"flash": [110, 101], "left": [90.0, 89.1], "sketch": {"ram": [150, 152], "flash": [950, 960]}}
    assert record.with_bounds(fresh, old, more_is_better=("left",)) == tight
    raised = record.with_bounds({**fresh, "left": 70.0}, tight, more_is_better=("left",), may_raise=True)
    assert raised == {**tight, "flash": [110, 112], "left": [70.0, 69.3]}


@pytest.mark.parametrize(
    ("known", "fresh", "said"),
    [
        ([1000, 1010], 1010, []),
        ([1000, 1010], 1011, ["one: 1011 is beyond its bound 1010"]),
        ([1000, 1010], 989, ["one: 1000 is recorded, and 989 was measured: run tools/refresh"]),
        (1000, 1011, ["one: 1000 is recorded, and 1011 was measured: run tools/refresh"]),
        (None, 5, ["one: None is recorded, and 5 was measured: run tools/refresh"]),
    ],
)
def test_figure_is_told_of_beyond_its_bound_and_where_a_reader_would_call_the_record_wrong(known, fresh, said):
    assert record.beyond({} if known is None else {"one": known}, {"one": fresh}) == said


def test_each_figure_that_is_to_be_large_has_its_bound_below():
    recorded = record.load()["figures"]
    assert list(recorded) == [figure.key for figure in figures.FIGURES]
    assert {key for key, (value, bound) in recorded.items() if bound < value} == set(figures.MORE_IS_BETTER)


def test_figures_of_another_compiler_or_other_flags_are_not_compared():
    whole = record.load()
    record.refuse_other_tools(whole)
    whole[record.MADE_WITH] = whole[record.MADE_WITH].replace("-Wl,--no-relax", "-Wl,--relax")
    with pytest.raises(record.BadRecord, match="-Wl,--relax, and this would be .*-Wl,--no-relax: they"):
        record.refuse_other_tools(whole)


def test_tool_prints_one_figure_beside_the_baseline():
    command = [sys.executable, ROOT / "tools" / "measure", "--only", "globals"]
    ran = subprocess.run(command, capture_output=True, text=True)
    assert ran.returncode == 0, ran.stderr
    assert "4,082 / 1,642" in ran.stdout
