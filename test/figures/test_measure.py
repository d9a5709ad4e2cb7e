"""The figures hold their bounds, mean what they say, and are what the documents print."""

from __future__ import annotations

import fcntl
import hashlib
import pickle
import re
import subprocess
import sys
from collections.abc import Callable

import pytest

from building import BUILD, ROOT
from measuring import bounds, calls, documents, features, figures, growth, profiling, report, runs, tricks
from measuring.firmware import baseline, measured, ours
from measuring.peer import KINDS, Peer, as_wire, telemetry_frames
from simulation.mega import Mega

WHAT_FIGURES_DEPEND_ON = (
    "src", "examples/01.First/UploadMission", "test/measured", "test/baseline", "simulation/fake_autopilot",
    "simulation/recordings", "simulation/firmware.py", "tools/measuring", "simulation/mega",
    "tools/building.py", "tools/baseline.py",
)  # fmt: skip


def tree_digest() -> str:
    whole = hashlib.sha256()
    for name in WHAT_FIGURES_DEPEND_ON:
        place = ROOT / name
        for file in sorted(place.rglob("*")) if place.is_dir() else [place]:
            if file.is_file() and "__pycache__" not in file.parts:
                whole.update(str(file).encode() + b"\0" + file.read_bytes())
    return whole.hexdigest()[:16]


def measured_once(name: str, measure: Callable[[], object]):
    """What `measure` returns, measured once for all workers of a test run."""
    folder = BUILD / "measured"
    folder.mkdir(parents=True, exist_ok=True)
    kept = folder / f"{name}-{tree_digest()}.pickle"
    with open(folder / f"{name}.lock", "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not kept.exists():
            kept.write_bytes(pickle.dumps(measure()))
    return pickle.loads(kept.read_bytes())


@pytest.fixture(scope="session")
def rows() -> list[figures.Row]:
    """All the figures."""
    values = measured_once(
        "figures", lambda: {row.figure.key: (row.baseline_2, row.baseline_1, row.ours) for row in figures.measure()}
    )
    return [figures.Row(figure, *values[figure.key]) for figure in figures.FIGURES]


@pytest.fixture(scope="session")
def costs() -> list[growth.Cost]:
    """How the cost grows with the plan."""
    return [growth.Cost(*cost) for cost in measured_once("growth", lambda: [tuple(cost) for cost in growth.costs()])]


@pytest.mark.slow
def test_no_figure_is_beyond_its_bound(rows):
    failures = [finding.text for finding in bounds.compare(rows, bounds.load()) if finding.failed]
    assert not failures, "\n".join(failures)


def test_each_bound_has_its_figure():
    assert list(bounds.load()) == [figure.key for figure in figures.FIGURES]


@pytest.mark.slow
def test_table_in_the_documents_is_not_stale(rows):
    fresh = report.for_documents(rows, features.table())
    assert documents.is_current(report.MARK, fresh), "run tools/measure --write-docs"


@pytest.mark.slow
def test_ours_is_better_than_either_baseline_where_both_are_measured(rows):
    for row in rows:
        if row.figure.key in ("globals", "globals_and_stack", "byte_mean", "byte_worst", "turnaround"):
            assert row.ours < row.baseline_1 < row.baseline_2, row.figure.label


# The measurements mean what they say ----------------------------------------


def test_two_runs_give_the_same_figures():
    first, second = (
        (runs.parsing(ours(), 3000), runs.turnaround(ours(), 2), runs.cpu_left(57600, seconds=0.1)) for _ in range(2)
    )
    assert first == second


def test_parser_is_counted_once_per_byte():
    mega = Mega(ours().built.elf)
    peer = Peer(mega, serve=False)
    peer.until_open()
    polled, read = mega.watch(ours().poll), mega.watch(runs.READ)
    data = b"".join(telemetry_frames("px4")[:20])
    mega.run_until(peer.put(data) + 10 * runs.MS)
    # A poll ends with a read() that finds nothing, or with a frame.
    assert read.calls.count - polled.calls.count <= len(data) <= read.calls.count


@pytest.mark.parametrize("wire", [1, 2])
def test_baseline_is_measured_in_the_mavlink_that_it_speaks(wire):
    subject = baseline(wire)
    mega = Mega(subject.built.elf)
    peer = Peer(mega, "ardupilot", wire, saturate=True)
    peer.until_open()
    peer.heartbeat()
    peer.run_until_accepted(runs.SECOND)
    peer.run(20 * runs.MS)
    assert mega.peek_int("accepted") == 1
    assert all(frame[0] == (0xFE if wire == 1 else 0xFD) for frame in as_wire(telemetry_frames("px4"), wire))


def test_saturated_line_has_no_gaps():
    mega = Mega(measured("each_millisecond", BAUD=57600, WITHOUT_LIBRARY=True))
    peer = Peer(mega, saturate=True, serve=False)
    peer.until_open()
    peer.run(100 * runs.MS)
    received = mega.watch(runs.RECEIVED)
    peer.run(runs.SECOND)
    assert received.calls.count == pytest.approx(runs.SECOND / runs.FROM_MEGA, abs=2)


def test_half_of_the_transmit_line_is_in_use():
    mega = Mega(measured("each_millisecond", BAUD=57600, WITHOUT_LIBRARY=True))
    mega.run_ms(100)
    mega.serial(1).sent()
    mega.run_ms(1000)
    assert len(mega.serial(1).sent()) == pytest.approx(57600 / 20, abs=60)


@pytest.mark.parametrize(("baud", "left"), [(57600, 90), (115200, 81)])
def test_core_alone_leaves_what_its_interrupts_leave(baud, left):
    # Known beforehand, from the core's interrupt routines: a check of the definition.
    assert runs.cpu_left(baud, library=False, seconds=0.2) == pytest.approx(left, abs=1)


@pytest.mark.slow
def test_ratio_of_an_upload_cannot_be_better_than_the_line():
    upload = runs.upload_of(10)
    assert upload.cycles > upload.on_the_wire
    assert upload.on_the_wire > 10 * (30 * runs.FROM_MEGA + 12 * runs.TO_MEGA)


def test_stall_fills_the_receive_ring():
    mega = Mega(measured("watched", BAUD=57600))
    peer = Peer(mega, saturate=True, serve=False)
    peer.until_open()
    mega.poke_int("stallMs", 100)
    read = mega.watch(runs.READ)
    peer.run(90 * runs.MS)
    read.forget()
    peer.run(20 * runs.MS)  # one update() in it
    # Of the 64 that it may look at; the others it looks at again, behind the gap.
    assert 40 <= read.calls.count <= 65


@pytest.mark.slow
def test_stack_of_update_is_the_deepest_of_the_public_calls():
    taken = calls.stacks()
    assert max(taken, key=taken.get).startswith("update()")
    assert all(0 <= depth < 400 for depth in taken.values())


@pytest.mark.slow
def test_stack_of_a_call_is_part_of_the_stack_of_the_upload(rows):
    by_key = {row.figure.key: row.ours for row in rows}
    deepest = by_key["globals_and_stack"] - by_key["globals"]
    assert deepest - 60 < max(calls.Caller(kind).upload() for kind in KINDS) < deepest + 60


@pytest.mark.slow
def test_empty_sketch_is_the_smallest_and_a_client_that_uploads_costs_more():
    rows = features.features()
    assert min(row.flash for row in rows) == rows[0].flash
    by_name = {row.label: row for row in rows}
    upload = by_name["Uploads a plan from flash, and reads it back when the answer is in doubt"]
    assert rows[0].flash < upload.flash < by_name["The upload with its status printed in words"].flash


@pytest.mark.slow
def test_ram_does_not_grow_with_the_plan_and_time_grows_with_it():
    ten, hundred = growth.costs((10, 100))
    assert ten.ram == hundred.ram
    assert hundred.seconds == pytest.approx(10 * ten.seconds, rel=0.15)


@pytest.mark.slow
def test_ram_is_the_same_for_ten_thousand_items(costs):
    by_items = {cost.items: cost for cost in costs}
    small, large = by_items[100], by_items[10_000]
    assert small.ram == large.ram
    assert large.seconds == pytest.approx(100 * small.seconds, rel=0.02)


@pytest.mark.slow
def test_picture_in_the_documents_is_not_stale(costs, tmp_path):
    growth.draw(costs, tmp_path / "cost.svg")
    assert (tmp_path / "cost.svg").read_text() == growth.PICTURE.read_text(), "run tools/measure --growth"
    assert any("cost.svg)" in place.read_text() for place in documents.DOCUMENTS)


def test_every_trick_is_still_in_the_code():
    assert all(tricks.undone(trick).is_dir() for trick in tricks.tricks().values())


@pytest.mark.slow
def test_library_without_a_trick_is_what_is_measured():
    base = tricks.taken()
    file, text, _ = tricks.tricks()["`update()` hides its object's address from the optimiser"]
    more = tricks.taken(tricks.undone(tricks.Trick(file, text, text + ' asm volatile("nop\\n nop\\n nop");')))
    assert more.flash == base.flash + 6 and more.globals == base.globals


COSTS = re.compile(r"//.*\d (?:cycles|bytes (?:less|more|of flash|of RAM)|kB)")


def test_comments_of_the_library_name_no_cost_that_nothing_measures_anew():
    """Such a figure is in a table that a tool writes, or is printed by tools/measure --tricks."""
    places = [file for kind in ("*.h", "*.cpp") for file in (ROOT / "src").rglob(kind) if "mavlink" not in file.parts]
    assert [
        f"{file.name}: {line}" for file in places for line in file.read_text().splitlines() if COSTS.search(line)
    ] == []


def test_profile_names_the_library_and_the_core():
    text = profiling.profile("ardupilot")
    assert "mavmission::detail::FrameParser" in text
    assert runs.RECEIVED in text


# Bounds ---------------------------------------------------------------------

SIZE = next(figure for figure in figures.FIGURES if figure.key == "flash")
LEFT = next(figure for figure in figures.FIGURES if figure.more_is_better)


@pytest.mark.parametrize(
    ("figure", "value", "bound", "failed", "told"),
    [
        (SIZE, 100, 100, False, False),
        (SIZE, 101, 100, True, True),
        (SIZE, 99, 100, False, False),
        (SIZE, 97, 100, False, True),
        (LEFT, 80.0, 80.0, False, False),
        (LEFT, 79.9, 80.0, True, True),
        (LEFT, 82.0, 80.0, False, True),
    ],
)
def test_figure_fails_beyond_its_bound_and_is_told_of_when_clearly_better(figure, value, bound, failed, told):
    found = bounds.compare([figures.Row(figure, None, None, value)], {figure.key: bounds.Bound(bound)})
    assert [finding.failed for finding in found] == ([failed] if told else [])


def test_figure_without_a_bound_fails():
    assert bounds.compare([figures.Row(SIZE, None, None, 5)], {})[0].failed


def test_bounds_only_tighten():
    text = "# why\n\n[flash]\nbound = 100\ngoal = 50\n\n[cpu_left_57600]\nbound = 80.0\n"
    better = [figures.Row(SIZE, None, None, 90), figures.Row(LEFT, None, None, 81.5)]
    assert bounds.tightened(text, better) == text.replace("100", "90").replace("80.0", "81.5")
    worse = [figures.Row(SIZE, None, None, 110), figures.Row(LEFT, None, None, 70.0)]
    assert bounds.tightened(text, worse) == text


def test_figures_of_another_compiler_or_other_flags_are_not_compared(tmp_path):
    bounds.refuse_other_tools()
    file = tmp_path / "bounds.toml"
    file.write_text(bounds.FILE.read_text().replace("-Wl,--no-relax", "-Wl,--relax"))
    with pytest.raises(bounds.BadBounds, match="-Wl,--relax, and this would be .*-Wl,--no-relax: they"):
        bounds.refuse_other_tools(file)


# The tool -------------------------------------------------------------------


def run_tool(*arguments: str) -> subprocess.CompletedProcess:
    return subprocess.run(
        [sys.executable, ROOT / "tools" / "measure", *arguments], capture_output=True, text=True, check=False
    )


def test_tool_prints_one_figure_beside_the_baseline():
    ran = run_tool("--only", "globals")
    assert ran.returncode == 0, ran.stderr
    assert "4,082 / 1,642" in ran.stdout
