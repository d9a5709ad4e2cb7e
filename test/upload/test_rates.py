"""Success rates on a line that loses frames or bytes at random, in a table; and that what the library says of an end is
so. The library's own client, compiled for this computer, against the explorer's models of the autopilots.
"""

from __future__ import annotations

import re
import subprocess

import pytest

from measuring import documents, rates
from planted import with_defect
from truth import longest_s

# What each client proves, as truth.longest_s() calls it.
PROOFS = {"upload-by-answer": "ByAnswer", "upload": "InDoubt"}
LINES = [(autopilot, *line) for autopilot in rates.AUTOPILOTS for line in rates.LINES]
BOTH = pytest.mark.parametrize("autopilot", ["ArduPilot", "PX4"])
RANDOM_LOSS = pytest.mark.scenario(14, "Random loss: an answer in bounded time, never a false Accepted")
ITEM = 49  # bytes
pytestmark = pytest.mark.slow


def limit_s(autopilot: str, client: str) -> float:
    """The bound on an upload of the library's, from its first COUNT: five items, on ArduPilot behind home."""
    return longest_s(5 if autopilot == "PX4" else 6, PROOFS[client])


def assert_true(ends: tuple[rates.Upload, ...], longest: float) -> None:
    assert [end for end in ends if end.is_false_acceptance or not end.is_aboard_true] == []
    assert [end for end in ends if end.status == "never" or end.took_s > longest] == []


def documented(lost: str, percent: int, client: str, autopilot: str) -> list[float]:
    """The share of the uploads that succeeded [%], and their median time [s], as docs/measurements.md has them."""
    page = documents.place_of("rates").read_text()
    head, row = (re.search(rf"^\| {first} *\|(.*)\|$", page, re.M)[1].split("|")
                 for first in ("lost", f"{percent} % of {lost}"))  # fmt: skip
    column = [name.strip() for name in head].index(f"{rates.CLIENTS[client]}, {autopilot}")
    return [float(figure.strip(" %s")) for figure in row[column].split(",")]


@RANDOM_LOSS
@pytest.mark.parametrize("client", PROOFS)
@pytest.mark.parametrize(
    "autopilot, lost, percent", [*LINES, *((autopilot, "frames", 70) for autopilot in rates.AUTOPILOTS)]
)
def test_uploads_on_a_lossy_line_end_truthfully_in_bounded_time(autopilot, client, lost, percent):
    ends = rates.uploads(autopilot, client, lost, percent, rates.SEEDS)
    assert [end.seed for end in ends] == list(range(rates.SEEDS))
    assert_true(ends, limit_s(autopilot, client))
    if (lost, percent) in rates.LINES and autopilot in rates.IN_TABLE:
        told, told_s = documented(lost, percent, client, autopilot)
        found, found_s = (float(cell.strip(" %s")) for cell in rates.cells(ends))
        assert found == pytest.approx(told, abs=3) and found_s == pytest.approx(
            told_s, rel=0.1, abs=0.1
        ), "the table is wrong: run tools/refresh rates"


def test_uploads_succeed_more_often_than_those_of_other_clients_on_the_same_line(record_property):
    for autopilot, lost, percent in LINES:
        ours, by_answer = (
            sum(end.is_success for end in rates.uploads(autopilot, client, lost, percent, rates.SEEDS))
            for client in ("upload", "upload-by-answer")
        )
        plainer, column = rates.plainer_clients(lost, percent), list(rates.AUTOPILOTS).index(autopilot)
        usual, none = (float(plainer[client][column].rstrip(" %")) for client in ("usual rule", "without retries"))
        assert 100 * ours / rates.SEEDS > usual >= none and ours >= by_answer, (autopilot, lost, percent)
    record_property("table", [f"uploads on the same lossy lines, {rates.SEEDS} seeds each, by client", rates.rows()])


@pytest.mark.parametrize(
    "lost, percent, least", [("bytes", 1, 100), ("bytes", 3, 100), ("bytes", 5, 90), ("frames", 40, 99)]
)
@pytest.mark.parametrize("client", ["upload", "upload-verified"])
@BOTH
def test_uploads_on_bad_lines_succeed_as_often_and_as_soon_as_promised(autopilot, client, lost, percent, least):
    is_timed = (lost, percent, client) == ("bytes", 1, "upload")  # reading back in any case takes longer
    ends = rates.uploads(autopilot, client, lost, percent, 1000 if is_timed else 100)
    times = sorted(end.took_s for end in ends if end.is_success)
    assert 100 * len(times) >= least * len(ends)
    assert not is_timed or times[len(times) // 2] <= rates.MEDIAN_S


@RANDOM_LOSS
@pytest.mark.parametrize("percent, least, seeds", [(0, 100, 100), (1, 99, 1000), (3, 90, 100)])
@pytest.mark.parametrize("server", rates.SERVERS)
def test_uploads_to_servers_of_an_unknown_firmware_succeed_as_often_as_promised(server, percent, least, seeds):
    ends = rates.uploads(server, "upload", "bytes", percent, seeds)
    assert 100 * sum(end.is_success for end in ends) >= least * len(ends)
    for client in PROOFS:
        assert_true(rates.uploads(server, client, "bytes", percent, 100), 120 + 2 * 5 + 0.1)


@RANDOM_LOSS
# On a late line beside telemetry alone, which makes it harder: docs/measurements.md has both.
@pytest.mark.parametrize(
    "latency_ms, percent, items, telemetry",
    [(*line, telemetry) for line in rates.LATE for telemetry in (0, rates.BUSY) if telemetry or line[0] == 0],
)
@BOTH
def test_long_plans_and_lines_that_answer_late_succeed_as_often_as_promised(
    autopilot, latency_ms, percent, items, telemetry
):
    ends = rates.late_uploads(autopilot, percent, rates.LATE_SEEDS, telemetry, latency_ms, items)
    least_of_20 = 15 if percent == 5 or (latency_ms == 500 and percent == 3) else 20
    assert sum(end.is_success for end in ends) >= least_of_20
    assert_true(ends, 130 + 2 * items)


@pytest.mark.parametrize("latency_ms", [150, 500])
@pytest.mark.parametrize("autopilot", rates.AUTOPILOTS)
def test_nothing_is_sent_twice_on_a_late_line_that_loses_nothing(autopilot, latency_ms):
    """PX4 repeats each request every 265 ms, ArduPilot every second, before our answer can arrive."""
    (end, *_) = rates.uploads(autopilot, "upload", "bytes", 0, 1, latency_ms=latency_ms, items=20)
    assert end.is_success and end.repeated_unasked == end.zeros == end.bytes_repeated == 0


@pytest.mark.parametrize("telemetry", [0, 500, 1100, 4000, 100000])
@pytest.mark.parametrize("loop_ms", [0, 2])
@pytest.mark.parametrize("baud", [9600, 57600, 115200])
@pytest.mark.parametrize("autopilot", rates.AUTOPILOTS)
def test_nothing_is_repeated_unasked_nor_filled_on_a_line_that_loses_nothing(autopilot, baud, loop_ms, telemetry):
    """A full line, a final answer 700 ms late and a slow loop among them."""
    for client in rates.CLIENTS:
        for end in rates.uploads(autopilot, client, "frames", 0, 3, None, baud, loop_ms, telemetry):
            assert end.is_success and end.repeated_unasked == end.zeros == 0
            assert end.took_s < 2 or (baud, loop_ms) != (57600, 0) or telemetry > 1100


@pytest.mark.parametrize("lost, percent", [("bytes", 1), ("bytes", 3), ("bytes", 5), ("frames", 40)])
@pytest.mark.parametrize("baud, most", [(9600, 0.5), (57600, 0.8)])
@BOTH
def test_unasked_repeats_leave_a_fifth_of_a_quick_line_and_half_of_a_slow_one(autopilot, baud, most, lost, percent):
    """Of our direction: the rest is for heartbeats, and for what the sketch sends."""
    for end in rates.uploads(autopilot, "upload", lost, percent, 50, None, baud):
        assert end.bytes_repeated <= end.took_s * baud / 10 * most + 2 * ITEM, end.seed


@pytest.mark.parametrize("telemetry", [1000, 3000])
@BOTH
def test_telemetry_keeps_its_share_while_items_are_repeated(autopilot, telemetry):
    """Beside 60 items, on a line that carries 5,760 bytes a second and loses 3 % of them."""
    ends = rates.uploads(autopilot, "upload", "bytes", 3, 6, None, 57600, 0, telemetry, 0, 60)
    assert sum(end.telemetry for end in ends) > 1000
    assert sum(end.left_out for end in ends) == 0


# What the measurement itself is worth -----------------------------------------


def test_each_seed_loses_other_frames_and_always_the_same_ones():
    ends = rates.uploads("PX4", "upload", "frames", 25, 20)
    assert len({end.took_s for end in ends}) > 5
    assert rates.uploads.__wrapped__("PX4", "upload", "frames", 25, 20) == ends


def broken(right: str, wrong: str):
    return rates.build_rates(with_defect("UploadTransfer.cpp", right, wrong))


def test_a_false_acceptance_would_be_found():
    lying = broken(
        "isCounting ? Status::NoAnswer : Status::TimedOut;", "isCounting ? Status::NoAnswer : Status::Accepted;"
    )
    ends = rates.uploads("PX4", "upload-by-answer", "frames", 70, rates.SEEDS, lying)
    assert any(end.is_false_acceptance and not end.is_aboard_true for end in ends)


def test_an_upload_that_never_ends_would_be_found():
    waiting = broken("(isCounting ? kCountingMs : kPassiveMs)", "(isCounting ? 0xFFFF : kPassiveMs)")
    # (The limit on the whole transfer ends it still: 132 s are longer than the rules allow.)
    ends = rates.uploads("ArduPilot", "upload-by-answer", "frames", 98, 40, waiting)
    assert any(end.took_s > limit_s("ArduPilot", "upload-by-answer") for end in ends)


def test_invalid_sequence_that_may_answer_an_older_item_would_lead_astray():
    """The condition that keeps an upload to ArduPilot from running ahead of it."""
    ends = rates.late_uploads(
        "ArduPilot", 3, 40, 0, 500, 60, broken("pace.isBehind(since(transfer.startedMs_, ms))", "true")
    )
    assert sum(end.is_success for end in ends) < 38


def test_wrong_arguments_are_answered_by_how_it_is_used():
    for words, problem in (("ArduPilot upload frames 5", "five to ten arguments are wanted"),
                           ("Ardupilot upload frames 5 1", "no such autopilot"),
                           ("PX4 upload frames 101 1", "a number is missing or too large")):  # fmt: skip
        ran = subprocess.run([rates.build_rates(), *words.split()], capture_output=True, text=True, check=False)
        assert ran.returncode == 2 and ran.stderr.startswith(f"{problem}\nusage: rates ")
