"""Success rates on a line that loses frames at random, in a table; and that what the library says of an end is so.

The same on the compiled firmware, with fewer seeds: test_losses.py.
"""

from __future__ import annotations

import subprocess

import pytest

import rates
from measuring import documents
from planted import with_defect

LINES = [(autopilot, percent) for autopilot in rates.AUTOPILOTS for percent in rates.PERCENTS]
RANDOM_LOSS = pytest.mark.scenario(14, "Random loss: an answer in bounded time, never a false Accepted")


@pytest.mark.slow
@RANDOM_LOSS
@pytest.mark.parametrize("client", rates.OURS)
@pytest.mark.parametrize("autopilot, percent", [*LINES, *((autopilot, 70) for autopilot in rates.AUTOPILOTS)])
def test_uploads_on_a_lossy_line_end_truthfully_in_bounded_time(autopilot, client, percent):
    ends = rates.uploads(autopilot, client, percent, rates.SEEDS)
    assert [end.seed for end in ends] == list(range(rates.SEEDS))
    assert [end for end in ends if end.is_false_acceptance] == []
    assert [end for end in ends if not end.is_aboard_true] == []
    limit_s = rates.limit_s(autopilot, client)
    assert [end for end in ends if end.status == "never" or end.took_s > limit_s] == []


@pytest.mark.slow
def test_uploads_succeed_more_often_than_those_of_other_clients_on_the_same_line(record_property):
    for autopilot, percent in LINES:
        succeeded = {
            client: sum(end.is_success for end in rates.uploads(autopilot, client, percent, rates.SEEDS))
            for client in rates.CLIENTS
        }
        assert succeeded["upload"] > succeeded["usual-rule"] > succeeded["no-retries"], (autopilot, percent)
        assert succeeded["upload"] >= succeeded["upload-by-answer"], (autopilot, percent)
    record_property("table", [f"uploads on the same lossy lines, {rates.SEEDS} seeds each, by client", rates.rows()])


@pytest.mark.slow
def test_table_in_the_documents_is_not_stale():
    current = documents.is_current("rates", rates.for_documents())
    assert current, "run build/venv/bin/python test/support/rates.py --write-docs"


# What the measurement itself is worth -----------------------------------------


@pytest.mark.slow
@pytest.mark.parametrize("client", rates.CLIENTS)
@pytest.mark.parametrize("autopilot", rates.AUTOPILOTS)
def test_every_client_succeeds_on_a_line_that_loses_nothing_and_none_on_one_that_loses_all(autopilot, client):
    assert all(end.is_success and end.took_s < 2 for end in rates.uploads(autopilot, client, 0, 5))
    # (The library's waits for an autopilot for ever, by default: it has not begun then.)
    if client not in rates.OURS:
        assert {(end.status, end.is_aboard) for end in rates.uploads(autopilot, client, 100, 5)} == {
            ("TimedOut", False)
        }


@pytest.mark.slow
def test_each_seed_loses_other_frames_and_always_the_same_ones():
    ends = rates.uploads("PX4", "usual-rule", 25, 20)
    assert len({end.took_s for end in ends}) > 5
    assert rates.uploads.__wrapped__("PX4", "usual-rule", 25, 20) == ends


@pytest.mark.slow
def test_a_false_acceptance_would_be_found():
    lying = with_defect("UploadTransfer.cpp", "if (tries_ == kTries) return Status::Unconfirmed;",
                        "if (tries_ == kTries) return Status::Accepted;")  # fmt: skip
    ends = rates.uploads("PX4", "upload-by-answer", 70, rates.SEEDS, rates.build_rates(lying))
    assert any(end.is_false_acceptance and not end.is_aboard_true for end in ends)


@pytest.mark.slow
def test_an_upload_that_never_ends_would_be_found():
    waiting = with_defect("UploadTransfer.cpp", "if (since(progressMs_, nowMs) < kPassiveMs) break;", "break;")
    # (The limit on the whole transfer ends it still: 132 s are longer than the rules allow.)
    ends = rates.uploads("ArduPilot", "upload-by-answer", 40, rates.SEEDS, rates.build_rates(waiting))
    assert any(end.took_s > rates.limit_s("ArduPilot", "upload-by-answer") for end in ends)


@pytest.mark.slow
@pytest.mark.parametrize("words, problem", [
    ("ArduPilot upload 5", "four arguments are wanted"),
    ("Ardupilot upload 5 1", "no such autopilot"),
    ("PX4 download 5 1", "no such client"),
    ("PX4 upload 101 1", "a number is missing or too large"),
    ("PX4 upload 5 x", "a number is missing or too large"),
])  # fmt: skip
def test_wrong_arguments_are_answered_by_how_it_is_used(words, problem):
    ran = subprocess.run([rates.build_rates(), *words.split()], capture_output=True, text=True, check=False)
    assert ran.returncode == 2
    assert ran.stderr.startswith(f"{problem}\nusage: rates ")
