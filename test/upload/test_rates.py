"""Success rates on a line that loses frames at random, in a table; and that what the library says of an end is so.

The same on the compiled firmware, with fewer seeds: test_losses.py.
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
RANDOM_LOSS = pytest.mark.scenario(14, "Random loss: an answer in bounded time, never a false Accepted")


def limit_s(autopilot: str, client: str) -> float:
    """The bound on an upload of the library's, from its first COUNT: five items, on ArduPilot behind home."""
    return longest_s(5 if autopilot == "PX4" else 6, PROOFS[client])


def documented(lost: str, percent: int, client: str, autopilot: str) -> tuple[str, str]:
    """The share of the uploads that succeeded, and their median time, as docs/measurements.md has them."""
    page = documents.place_of("rates").read_text()
    row = re.search(rf"^\| {percent} % of {lost} *\| {re.escape(rates.CLIENTS[client])} *\|(.*)\|$", page, re.M)[1]
    column, cells = list(rates.AUTOPILOTS).index(autopilot), row.split("|")
    return cells[column], cells[len(cells) - len(rates.AUTOPILOTS) + column]


def assert_reader_may_believe(*cells: tuple[str, str]) -> None:
    """The share within 3 points, the time within a tenth."""
    (told, told_s), (found, found_s) = ([float(cell.strip(" %s")) for cell in pair] for pair in cells)
    assert found == pytest.approx(told, abs=3) and found_s == pytest.approx(told_s, rel=0.1, abs=0.1), (
        "the table is wrong: run tools/refresh rates"
    )


@pytest.mark.slow
@RANDOM_LOSS
@pytest.mark.parametrize("client", PROOFS)
@pytest.mark.parametrize(
    "autopilot, lost, percent", [*LINES, *((autopilot, "frames", 70) for autopilot in rates.AUTOPILOTS)]
)
def test_uploads_on_a_lossy_line_end_truthfully_in_bounded_time(autopilot, client, lost, percent):
    ends = rates.uploads(autopilot, client, lost, percent, rates.SEEDS)
    assert [end.seed for end in ends] == list(range(rates.SEEDS))
    assert [end for end in ends if end.is_false_acceptance] == []
    assert [end for end in ends if not end.is_aboard_true] == []
    limit = limit_s(autopilot, client)
    assert [end for end in ends if end.status == "never" or end.took_s > limit] == []
    if (lost, percent) in rates.LINES:
        assert_reader_may_believe(documented(lost, percent, client, autopilot), rates.cells(ends))


@pytest.mark.slow
def test_uploads_succeed_more_often_than_those_of_other_clients_on_the_same_line(record_property):
    for autopilot, lost, percent in LINES:
        succeeded = {
            client: sum(end.is_success for end in rates.uploads(autopilot, client, lost, percent, rates.SEEDS))
            for client in rates.CLIENTS
        }
        shares = [100 * succeeded["upload"] / rates.SEEDS]
        for client in ("usual rule", "without retries"):
            cells = rates.plainer_clients(lost, percent)[client]
            shares.append(float(cells[list(rates.AUTOPILOTS).index(autopilot)].rstrip(" %")))
        assert shares[0] > shares[1] >= shares[2], (autopilot, lost, percent)
        assert succeeded["upload"] >= succeeded["upload-by-answer"], (autopilot, lost, percent)
    record_property("table", [f"uploads on the same lossy lines, {rates.SEEDS} seeds each, by client", rates.rows()])


GOALS = [("bytes", 1, 100), ("bytes", 3, 100), ("bytes", 5, 90), ("frames", 40, 99)]


@pytest.mark.slow
@pytest.mark.parametrize("lost, percent, least_share", GOALS)
@pytest.mark.parametrize("client", ["upload", "upload-verified"])
@pytest.mark.parametrize("autopilot", ["ArduPilot", "PX4"])
def test_uploads_on_bad_lines_succeed_as_often_and_as_soon_as_promised(
    autopilot, client, lost, percent, least_share
):
    is_timed = (lost, percent, client) == ("bytes", 1, "upload")  # reading back in any case takes longer
    ends = rates.uploads(autopilot, client, lost, percent, 1000 if is_timed else 100)
    times = sorted(end.took_s for end in ends if end.is_success)
    assert 100 * len(times) >= least_share * len(ends)
    if is_timed:
        assert times[len(times) // 2] <= rates.MEDIAN_S[autopilot]


@pytest.mark.slow
@RANDOM_LOSS
@pytest.mark.parametrize("percent, least_share, seeds", [(0, 100, 100), (1, 99, 1000), (3, 90, 100)])
@pytest.mark.parametrize("server", rates.SERVERS)
def test_uploads_to_servers_of_an_unknown_firmware_succeed_as_often_as_promised(
    server, percent, least_share, seeds
):
    ends = rates.uploads(server, "upload", "bytes", percent, seeds)
    assert 100 * sum(end.is_success for end in ends) >= least_share * len(ends)
    for client in PROOFS:
        ends = rates.uploads(server, client, "bytes", percent, 100)
        assert [end for end in ends if end.is_false_acceptance or not end.is_aboard_true] == []
        assert [end for end in ends if end.status == "never" or end.took_s > 120 + 2 * 5 + 0.1] == []


def least_of_20(latency_ms: int, percent: int) -> int:
    return 15 if percent == 5 or (latency_ms == 500 and percent == 3) else 20


@pytest.mark.slow
@RANDOM_LOSS
@pytest.mark.parametrize("telemetry", [0, rates.BUSY])
@pytest.mark.parametrize("latency_ms, percent, items", rates.LATE)
@pytest.mark.parametrize("autopilot", ["ArduPilot", "PX4"])
def test_long_plans_and_lines_that_answer_late_succeed_as_often_as_promised(
    autopilot, latency_ms, percent, items, telemetry
):
    ends = rates.late_uploads(autopilot, percent, rates.LATE_SEEDS, telemetry, latency_ms, items)
    assert sum(end.is_success for end in ends) >= least_of_20(latency_ms, percent)
    assert [end for end in ends if end.is_false_acceptance or not end.is_aboard_true] == []
    assert [end for end in ends if end.took_s > 130 + 2 * items] == []


@pytest.mark.slow
@pytest.mark.parametrize("latency_ms", [150, 500])
@pytest.mark.parametrize("autopilot", rates.AUTOPILOTS)
def test_nothing_is_sent_twice_on_a_late_line_that_loses_nothing(autopilot, latency_ms):
    """PX4 repeats each request every 265 ms, ArduPilot every second, before our answer can arrive."""
    (end, *_) = rates.uploads(autopilot, "upload", "bytes", 0, 1, latency_ms=latency_ms, items=20)
    assert end.is_success and end.repeated_unasked == 0 and end.zeros == 0 and end.bytes_repeated == 0


@pytest.mark.slow
def test_invalid_sequence_that_may_answer_an_older_item_would_lead_astray():
    """The condition that keeps an upload to ArduPilot from running ahead of it."""
    credulous = with_defect("UploadTransfer.cpp", "pace.isBehind(since(transfer.startedMs_, ms))", "true")
    ends = rates.late_uploads("ArduPilot", 3, 40, 0, 500, 60, rates.build_rates(credulous))
    assert sum(end.is_success for end in ends) < 38


ITEM = 49  # bytes


@pytest.mark.slow
@pytest.mark.parametrize("telemetry", [0, 500, 1100, 4000, 100000])
@pytest.mark.parametrize("loop_ms", [0, 2])
@pytest.mark.parametrize("baud", [9600, 57600, 115200])
@pytest.mark.parametrize("autopilot", rates.AUTOPILOTS)
def test_nothing_is_repeated_unasked_nor_filled_on_a_line_that_loses_nothing(autopilot, baud, loop_ms, telemetry):
    """A full line, a final answer 700 ms late and a slow loop among them."""
    for end in rates.uploads(autopilot, "upload", "frames", 0, 3, None, baud, loop_ms, telemetry):
        assert end.is_success
        assert end.repeated_unasked == 0 and end.zeros == 0


@pytest.mark.slow
@pytest.mark.parametrize("lost, percent", [("bytes", 1), ("bytes", 3), ("bytes", 5), ("frames", 40)])
@pytest.mark.parametrize("baud", [9600, 57600])
@pytest.mark.parametrize("autopilot", ["ArduPilot", "PX4"])
def test_unasked_repeats_take_a_quarter_of_the_line_at_the_most(autopilot, baud, lost, percent):
    for end in rates.uploads(autopilot, "upload", lost, percent, 50, None, baud):
        carried = end.took_s * baud / 10
        assert end.bytes_repeated <= carried / 4 + 2 * ITEM, end.seed


# What the measurement itself is worth -----------------------------------------


@pytest.mark.slow
@pytest.mark.parametrize("client", rates.CLIENTS)
@pytest.mark.parametrize("autopilot", rates.AUTOPILOTS)
def test_every_upload_succeeds_on_a_line_that_loses_nothing(autopilot, client):
    assert all(end.is_success and end.took_s < 2 for end in rates.uploads(autopilot, client, "frames", 0, 5))


@pytest.mark.slow
def test_each_seed_loses_other_frames_and_always_the_same_ones():
    ends = rates.uploads("PX4", "upload", "frames", 25, 20)
    assert len({end.took_s for end in ends}) > 5
    assert rates.uploads.__wrapped__("PX4", "upload", "frames", 25, 20) == ends


@pytest.mark.slow
def test_a_false_acceptance_would_be_found():
    lying = with_defect("UploadTransfer.cpp", "isCounting ? Status::NoAnswer : Status::TimedOut;",
                        "isCounting ? Status::NoAnswer : Status::Accepted;")  # fmt: skip
    ends = rates.uploads("PX4", "upload-by-answer", "frames", 70, rates.SEEDS, rates.build_rates(lying))
    assert any(end.is_false_acceptance and not end.is_aboard_true for end in ends)


@pytest.mark.slow
def test_an_upload_that_never_ends_would_be_found():
    waiting = with_defect("UploadTransfer.cpp", "(isCounting ? kCountingMs : kPassiveMs)",
                          "(isCounting ? 0xFFFF : kPassiveMs)")  # fmt: skip
    # (The limit on the whole transfer ends it still: 132 s are longer than the rules allow.)
    ends = rates.uploads("ArduPilot", "upload-by-answer", "frames", 98, rates.SEEDS, rates.build_rates(waiting))
    assert any(end.took_s > limit_s("ArduPilot", "upload-by-answer") for end in ends)


@pytest.mark.slow
@pytest.mark.parametrize("words, problem", [
    ("ArduPilot upload frames 5", "five to ten arguments are wanted"),
    ("Ardupilot upload frames 5 1", "no such autopilot"),
    ("PX4 download frames 5 1", "no such client"),
    ("PX4 upload bits 5 1", "frames or bytes are lost"),
    ("PX4 upload frames 101 1", "a number is missing or too large"),
    ("PX4 upload bytes 5 x", "a number is missing or too large"),
    ("PX4 upload bytes 5 1 0", "a number is missing or too large"),
])  # fmt: skip
def test_wrong_arguments_are_answered_by_how_it_is_used(words, problem):
    ran = subprocess.run([rates.build_rates(), *words.split()], capture_output=True, text=True, check=False)
    assert ran.returncode == 2
    assert ran.stderr.startswith(f"{problem}\nusage: rates ")
