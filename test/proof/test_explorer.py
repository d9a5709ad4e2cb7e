"""Every way that an operation can go: the MissionClient itself against models of both autopilots, by test/explorer.

Any number of frames may be lost, in both directions, and up to `--faults` more are repeated, delayed past the next,
damaged or cut short, or come once more some time later (`--copies`); the autopilot may reboot, the sketch cancel, the
Arduino be reset, at any point. What must hold is in explorer/Referee.h, and for plans as files in
explorer/FileReferee.h: it ends; what it says is so; a failure has its cause; no frame is sent that the protocol
forbids.
A scenario by hand, to any bound:

    build/venv/bin/python test/proof/test_explorer.py PX4 upload-in-doubt 3 --faults 3

A planted defect, of explorer_defects.diff, is a line of the library changed in a copy of it.
"""

from __future__ import annotations

import functools
import os
import subprocess
import sys
from pathlib import Path

if __name__ == "__main__":
    root = Path(__file__).resolve().parents[2]
    sys.path[:0] = [str(root), str(root / "tools"), str(root / "test" / "support")]

import pytest

from mutating.programs import sources_of
from planted import defects, with_defect
from simulation.firmware import ROOT, library_sources
from simulation.host_build import FAST, build_host
from simulation.together import together

EXPLORER = ROOT / "test" / "explorer"
# The rest form and the next timer of a client are about its private members.
OWN_FLAGS = ["-std=c++17", "-fno-access-control"]
AUTOPILOTS = ("ArduPilot", "LateArduPilot", "PX4")
SERVERS = ("MAVSDK", "Betaflight", "iNav")  # of a firmware that the library does not know: explorer/Generic.cpp
MOST_BYTES = 2_000_000_000  # One exploration may hold so many; two run side by side.
# Of three operations, with each autopilot, and of two minutes at a console: as many as find each planted defect, in
# tools/test; and in --all.
WALKS, ALL_WALKS = 20_000, 100_000
SESSIONS, ALL_SESSIONS = 150, 450
BETAFLIGHT = 1  # MAVMISSION_GENERIC_FIRMWARE
COLUMNS = ["operation", "autopilot", "beside losses", "states", "transitions", "longest", "fewest to fail",
           "violations"]  # fmt: skip


@functools.cache
def build_explorer(library: tuple[Path, ...] | None = None, generic: int = 0) -> Path:
    """`generic`: which firmware the library is told that a generic autopilot has."""
    defines = {"MAVMISSION_GENERIC_FIRMWARE": generic} if generic else {}
    if generic:  # nothing else is compiled so
        library = tuple(together(library or library_sources()))
    return build_host(
        "explorer", sources_of(EXPLORER), "g++", FAST, own_flags=OWN_FLAGS, defines=defines, library=library
    )


@functools.cache
def explore(words: str, program: Path | None = None) -> dict[str, str]:
    """What an exploration found, by name; `broken` is the rule and the shortest way to it."""
    limited = ["prlimit", f"--as={MOST_BYTES}", program or build_explorer(), *words.split()]
    ran = subprocess.run(limited, capture_output=True, text=True, check=False)
    assert ran.returncode in (0, 1), f"{words}: {ran.stdout}{ran.stderr}"
    figures, _, broken = ran.stdout.partition("broken=")
    found = dict(line.split("=", 1) for line in figures.splitlines() if not line.startswith("end="))
    return found | {"broken": broken}


PROOFS = ("upload", "upload-in-doubt", "upload-verified")


def single(autopilot: str, most_items: int = 4, proofs: tuple[str, ...] = PROOFS) -> list[str]:
    """Each operation with each number of items, what is read being what the autopilot holds.

    ensure() is a look, an upload and a read-back, each of which is explored by itself: so it has an item less.
    """
    sizes = range(most_items + 1)
    most_ensured = max(most_items - 1, 1)
    return [
        *(f"{autopilot} {proof} {n}" for proof in proofs for n in sizes),
        *(f"{autopilot} download 0 --held {n}" for n in sizes),
        *(f"{autopilot} verify {n} --held {n} --held-plan 1" for n in sizes),
        *(f"{autopilot} verify {n} --held {held}" for n, held in ((2, 2), (2, 3), (1, 0)) if n <= most_items),
        *(f"{autopilot} ensure {n} --held {n} --held-plan 1" for n in range(most_items)),
        *(f"{autopilot} ensure {n} --held {held}" for n, held in ((2, 2), (1, 2), (2, 1), (0, 1), (1, 0))
          if max(n, held) <= most_ensured),
        *(f"{autopilot} clear 0 --held {n}" for n in (0, most_items)),
    ]  # fmt: skip


def pairs(autopilot: str) -> list[str]:
    """An operation after one that ended somehow, or was broken off."""
    return [f"{autopilot} {first} {second}" for first, second in (
        ("upload-in-doubt 2", "upload-in-doubt 1"), ("upload-in-doubt 1", "upload-in-doubt 2"),
        ("upload-in-doubt 1", "verify 1"), ("upload 2", "download 0"), ("download 0", "upload-in-doubt 1"),
        ("clear 0", "upload-in-doubt 1"), ("upload 1", "clear 0"), ("upload 2", "ensure 1"), ("ensure 1", "ensure 1"),
    )]  # fmt: skip


def by_kind(autopilot: str) -> list[tuple[str, str]]:
    """Fences and rally points, beside a mission and one behind the other. (Shorter fences wait for a second first.)"""
    cases = []
    for lossy in ("", " --lossy 1"):
        cases += [(words, f"--held-beside 2 --losses 3{lossy}") for words in single(f"{autopilot} rally", 2)]
        for beside in ("--faults 1", "--reboots 1", "--cancels 1"):
            cases += [
                (words, f"--held-beside 2 --losses 1 {beside}{lossy}") for words in single(f"{autopilot} rally", 2)
            ]
        fences = ("upload 4", "upload-in-doubt 4", "upload-verified 4", "ensure 4", "download 0 --held 4", "clear 0")
        cases += [(f"{autopilot} fence {words}", f"--held-beside 1 --losses 2{lossy}") for words in fences]
        cases.append((f"{autopilot} fence verify 4 --held 4 --held-plan 1", f"--held-beside 1 --losses 2{lossy}"))
    followed = (
        ("upload-in-doubt 2", "rally-upload-in-doubt 1"), ("rally-upload-in-doubt 2", "upload-in-doubt 1"),
        ("rally-upload-in-doubt 2", "rally-upload-in-doubt 1"), ("rally-upload 2", "verify 1"),
        ("upload-in-doubt 2", "rally-download 0"), ("rally-download 0", "upload-in-doubt 2"),
        ("rally-upload 1", "clear 0"), ("upload 1", "rally-clear 0"), ("rally-clear 0", "upload-in-doubt 1"),
        ("upload 2", "rally-ensure 1"), ("rally-ensure 1", "ensure 1"), ("fence-upload 4", "upload-in-doubt 1"),
        ("upload-in-doubt 1", "fence-upload-in-doubt 4"), ("fence-upload 4", "fence-clear 0"),
    )  # fmt: skip
    for beside in ("--losses 3", "--losses 2 --cancels 1", "--losses 2 --resets 1", "--losses 3 --lossy 1",
                   "--losses 1 --lossy 1 --latency 150", "--losses 1 --lossy 1 --latency 300"):  # fmt: skip
        cases += [(f"{autopilot} {one} {other}", f"--held-beside 2 {beside}") for one, other in followed]
    return [(words.replace(" rally ", " rally-").replace(" fence ", " fence-"), options) for words, options in cases]


def by_file() -> list[tuple[str, str]]:
    """PlanFiles on ArduPilot. A plan of 6 items and home is written in two pieces, both on their way at once."""
    cases = [("file-upload 1", ""), *((f"file-verify {n} --held {n} --held-plan 1", "") for n in (0, 1, 2))]
    for lossy in ("", " --lossy 1"):
        cases += [(f"file-upload {n}", f"--losses 4{lossy}") for n in (0, 2, 3, 6, 7)]
        for beside in ("--reboots 1", "--cancels 1", "--faults 1"):
            cases += [(f"file-upload {n}", f"--losses 2 {beside}{lossy}") for n in (0, 1, 2)]
            cases.append(("file-verify 2 --held 2 --held-plan 1", f"--losses 2 {beside}{lossy}"))
    cases += [("file-upload 6", f"--losses 2 {beside}") for beside in ("--cancels 1", "--others 1")]
    # Another client, and an item that ArduPilot does not take.
    cases += [("file-upload 1", "--losses 1 --others 3"), ("file-upload 2", "--losses 2 --others 2")]
    cases += [("file-upload 1", f"--losses 1 --others 2 {beside}") for beside in ("--cancels 1", "--reboots 1")]
    cases += [(f"file-verify 2 --held {held} --held-plan 1", "--losses 2 --others 2") for held in (2, 3)]
    for item in (1, 2):
        cases.append(("file-upload 2", f"--refused {item} --losses 2 --cancels 1 --others 1"))
        cases.append(("file-upload 2", f"--refused {item} --losses 4 --lossy 1"))
    # An operation behind an upload by file that ended somehow, or was broken off.
    for second in ("file-upload 1", "file-upload 3", "file-verify 2", "upload-in-doubt 1", "verify 2", "clear 0"):
        cases += [(f"file-upload 2 {second}", f"--losses 2 {beside}") for beside in ("--cancels 1", "--resets 1")]
        # The file of before a reset, which the board looks for then: with its header and not closed, too.
        cases += [(f"file-upload 2 {second}", f"--losses 4 --resets 1{lossy}") for lossy in ("", " --lossy 1")]
        cases.append((f"file-upload 2 {second}", "--losses 1 --resets 1 --others 1"))
    return [(f"ArduPilot {words}", options) for words, options in cases]


def expect_nothing_broken(record_property, title: str, scenarios: list[tuple[str, str]], generic: int = 0) -> int:
    """Explore each (words, options), and print one row for each operation with each autopilot; the states in all."""
    rows: dict[tuple[str, ...], list[int]] = {}
    program = build_explorer(generic=generic)
    for words, options in scenarios:
        found = explore(f"{words} {options}", program)
        assert found["violations"] == "0", f"{words} {options}\n{found['broken']}"
        assert found["whole"] == "1" and int(found["states"]) > 10
        autopilot, *operation = (word for word in words.split(" --")[0].split() if not word.isdigit())
        row = rows.setdefault((", ".join(operation), autopilot, options.replace("--", "") or "-"), [0, 0, 0, 99])
        row[0] += int(found["states"])
        row[1] += int(found["transitions"])
        row[2] = max(row[2], int(found["longest_ms"]))
        row[3] = min(row[3], int(found["fewest_faults"]) % 100)
    lines = [
        [*key, f"{states:,}", f"{transitions:,}", f"{longest / 1000:.1f} s", "-" if fewest == 99 else str(fewest), "0"]
        for key, (states, transitions, longest, fewest) in rows.items()
    ]
    total = [f"{sum(row[i] for row in rows.values()):,}" for i in (0, 1)]
    record_property("table", [title, [COLUMNS, *lines, ["all", "", "", *total, "", "", "0"]]])
    return sum(row[0] for row in rows.values())


# tools/test explores one scenario in fourteen; --all the others, too. (Those of the planted defects are explored each
# time.)
ONE_IN = 14
PARTS = pytest.mark.parametrize("part", ["sample", pytest.param("rest", marks=pytest.mark.thorough)])


def seeds(few: int, all_of_them: int):
    """From which one on, and how many: in tools/test these few, with --all the others, too."""
    rest = pytest.param(few + 1, all_of_them - few, marks=pytest.mark.thorough)
    return pytest.mark.parametrize(("first", "count"), [(1, few), rest])


def of_part(part: str, scenarios: list[tuple[str, str]]) -> list[tuple[str, str]]:
    return [one for number, one in enumerate(scenarios) if (number % ONE_IN == 0) == (part == "sample")]


@pytest.mark.slow
@PARTS
def test_no_way_breaks_a_rule_with_reboots_cancels_and_a_fault_beside_any_losses(record_property, part):
    """An upload in doubt goes every way of the one by answer and of the one that is always read back.

    So these two are explored beside losses alone; and an ensure() that uploads, beside more than losses, to three of
    them.
    """
    scenarios = []
    for autopilot in AUTOPILOTS:
        # (PX4 renews its 5 s with each item that it hears, so that repeats make many more ways.)
        most = 1 if autopilot == "PX4" else 2
        for lossy in ("", " --lossy 1"):
            scenarios += [(words, lossy.strip()) for words in single(autopilot, most + 1)]
            for beside, items in (("--reboots 1", most), ("--cancels 1", most), ("--faults 1", 1)):
                for words in single(autopilot, items, ("upload-in-doubt",)):
                    is_whole = " ensure " in words and "--held-plan" not in words
                    scenarios.append((words, f"{beside}{' --losses 3' if is_whole else ''}{lossy}"))
    states = expect_nothing_broken(record_property, "explored: plans of 0 to 4 items", of_part(part, scenarios))
    assert states > {"sample": 3_000_000, "rest": 31_000_000}[part]  # docs/design/proof.md has the sum


@pytest.mark.slow
@PARTS
def test_no_operation_is_misled_by_the_one_before_it(record_property, part):
    scenarios = []
    for autopilot in ("ArduPilot", "PX4"):
        for options in ("--losses 3", "--losses 2 --cancels 1", "--losses 2 --resets 1", "--losses 3 --lossy 1"):
            scenarios += [(words, options) for words in pairs(autopilot)]
        # A shorter plan behind a longer one: PX4 may take it for the beginning of that.
        for options in ("--losses 8", "--losses 8 --lossy 1"):
            scenarios.append((f"{autopilot} upload-in-doubt 2 upload-in-doubt 1", options))
    # Repeats leave sooner than answers come: the answers to them come when the next operation has begun.
    late = [(words, f"--losses 1 --lossy 1 --latency {ms}") for autopilot in ("ArduPilot", "PX4")
            for ms in (150, 300) for words in pairs(autopilot)]  # fmt: skip
    late += [(words, "--losses 3 --cancels 1") for words in pairs("LateArduPilot")]
    # Those are few states.
    scenarios = [*of_part(part, scenarios), *(late if part == "sample" else [])]
    expect_nothing_broken(record_property, "explored: two operations, one behind the other", scenarios)


def by_server(server: str) -> list[tuple[str, str]]:
    """By few losses: uploads that have been given up begin anew, and where all is lost that is so for 120 s.

    With latency, COUNT is repeated before its answer can come.
    """
    scenarios = []
    for lossy in ("", " --lossy 1"):
        scenarios += [(words, f"--losses 3{lossy}") for words in single(server, 2)]
        for beside in ("--faults 1", "--reboots 1", "--cancels 1"):
            scenarios += [(words, f"--losses 2 {beside}{lossy}") for words in single(server, 2)]
    for latency in (150, 300, 500):
        uploads = [f"{server} {words}" for words in ("upload 1", "upload-in-doubt 2", "ensure 1 --held 2")]
        scenarios += [(words, f"--losses 1 --lossy 1 --latency {latency}") for words in uploads]
    for beside in ("--losses 2", "--losses 1 --cancels 1", "--losses 1 --resets 1"):
        scenarios += [(words, beside) for words in pairs(server)]
    return scenarios


@pytest.mark.slow
def test_no_server_of_an_unknown_firmware_misleads_the_client(record_property):
    scenarios = [one for server in SERVERS for one in by_server(server)]
    expect_nothing_broken(record_property, "explored: servers of an unknown firmware", scenarios)


@pytest.mark.slow
def test_betaflight_does_not_mislead_a_client_that_is_told_of_it(record_property):
    scenarios = by_server("Betaflight")
    states = expect_nothing_broken(record_property, "explored: Betaflight, by its macro", scenarios, BETAFLIGHT)
    assert states > 200_000


@pytest.mark.slow
@pytest.mark.parametrize("generic", [0, BETAFLIGHT])
def test_an_acceptance_that_betaflight_takes_back_is_not_believed(generic):
    """A network brings COUNT once more behind the last item, and Betaflight deletes the plan that it has accepted."""
    words = "Betaflight upload-in-doubt 1 --losses 2 --faults 1"
    right = "if (client.plan_.has(kIsReadBack) && client.transfer_.hasBegun()) return Status::Unconfirmed;"
    assert explore(words, build_explorer(generic=generic))["violations"] == "0"
    found = explore(words, build_explorer(with_defect("Upload.cpp", right, ""), generic))
    assert found["broken"].startswith(("aboard() says our plan, and it is not", "Accepted, and not read back"))


@pytest.mark.slow
def test_no_fence_and_no_rally_points_are_misled_by_a_mission_nor_mislead_one(record_property):
    scenarios = [*by_kind("ArduPilot"), *by_kind("PX4")]
    states = expect_nothing_broken(record_property, "explored: fences and rally points beside a mission", scenarios)
    assert states > 350_000


@pytest.mark.slow
def test_no_operation_is_misled_by_a_frame_that_the_line_brings_once_more(record_property):
    """30, 120 or 300 ms later: within an operation, and in the second and the third one behind it."""
    scenarios = []
    for autopilot in AUTOPILOTS:
        scenarios += [(words, "--losses 1 --copies 2") for words in single(autopilot, 2)]
        scenarios += [(words, options) for words in pairs(autopilot) for options in
                      ("--losses 1 --copies 1", "--losses 0 --copies 2")]  # fmt: skip
    followed = ("upload-in-doubt 2", "clear 0", "ensure 1", "verify 2", "download 0")
    scenarios += [
        (f"{autopilot} {one} {two} {three}", "--losses 0 --copies 1")
        for autopilot in ("ArduPilot", "PX4")
        for one in followed
        for two in followed[:4]
        for three in ("upload-in-doubt 2", "clear 0", "verify 1")
    ]
    by_files = ("file-upload 2", "file-upload 6", "file-verify 2 --held 2 --held-plan 1", "file-upload 2 clear 0",
                "file-upload 2 upload-in-doubt 1", "file-upload 2 file-upload 1", "file-upload 2 file-verify 2",
                "file-upload 2 clear 0 file-upload 1")  # fmt: skip
    scenarios += [(f"ArduPilot {words}", options) for words in by_files for options in
                  ("--losses 1 --copies 1", "--losses 0 --copies 2")]  # fmt: skip
    kinds = ("fence-upload 4 fence-clear 0", "rally-upload-in-doubt 2 upload-in-doubt 1", "rally-clear 0 clear 0",
             "rally-ensure 1 rally-verify 1")  # fmt: skip
    scenarios += [(f"{autopilot} {words}", "--held-beside 2 --losses 1 --copies 1") for autopilot in AUTOPILOTS
                  for words in kinds]  # fmt: skip
    states = expect_nothing_broken(record_property, "explored: frames that come once more", scenarios)
    assert states > 300_000


@pytest.mark.slow
@seeds(WALKS, ALL_WALKS)
def test_no_operation_is_misled_on_lines_that_double_delay_and_lose_frames_at_random(first, count):
    """Three operations one behind the other, by item and by file, beside copies, losses, reboots and cancels."""
    for autopilot in AUTOPILOTS:
        found = explore(f"{autopilot} walks {count} --seed {first}")
        assert found["violations"] == "0", found["broken"]
        assert int(found["operations"]) > 2.9 * count  # some have more copies on their way than the line has places


@pytest.mark.slow
@seeds(SESSIONS, ALL_SESSIONS)
def test_a_console_that_is_typed_at_does_what_complete_lines_say_and_says_what_is_true(first, count):
    """Files, commands and what resembles them, whole and spoilt, pasted and typed while operations run."""
    operations = 0
    for autopilot in AUTOPILOTS:
        found = explore(f"{autopilot} typed {count} --seed {first}")
        assert found["violations"] == "0", found["broken"]
        operations += int(found["operations"])
    assert operations > 44 * count


@pytest.mark.slow
@PARTS
def test_a_plan_by_file_leaves_the_old_plan_or_the_new_one_or_says_neither(record_property, part):
    scenarios = of_part(part, by_file())
    states = expect_nothing_broken(record_property, "explored: plans as files, of 0 to 7 items", scenarios)
    assert states > {"sample": 700_000, "rest": 400_000}[part]  # docs/design/proof.md has the sum


DEFECTS = defects("explorer_defects.diff")


@pytest.mark.slow
@pytest.mark.parametrize("defect", DEFECTS)
def test_a_planted_defect_is_found(defect):
    planted = DEFECTS[defect]
    assert explore(planted.words)["violations"] == "0"
    found = explore(planted.words, build_explorer(planted.library))
    assert int(found["violations"]) > 0
    assert found["broken"].startswith(planted.rule), found["broken"]
    assert "arrives" in found["broken"] or "is lost" in found["broken"]  # how it came to that


if __name__ == "__main__":
    explorer = build_explorer()
    os.execv(explorer, [str(explorer), *sys.argv[1:]])
