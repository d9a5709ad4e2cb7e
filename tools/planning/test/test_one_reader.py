"""tools/plan and the board make the same of a .waypoints text: the same items, byte by byte, or the same refusal."""

from __future__ import annotations

import random
from pathlib import Path

import pytest

from building import ROOT
from planned import FILES
from planning import BadPlan, judge, waypoints
from waypoints_reader import WaypointsReader

COMMANDS = (16, 22, 21, 20, 178, 183, 203, 189, 92, 195, 30, 36, 601, 31999)
NUMBERS = ("0", "1", "-1", "+2.5", "1e1", "1E-05", ".5", "5.", "007", "3.4028235e38", "1e39", "1e-50", "nan", "9" * 40,
           "0.1234567890123456789", "16777217", "inf", "1,5", "0x10", "--1", "2_0")  # fmt: skip
PLACES = ("-35.3632621", "149", "0", "90.00000004", "90.1", "-180", "47.39697211349564", "1e1", "47,5")
GAPS, ENDS = ("\t", " ", " \t ", "   "), ("\n", "\r\n", "\r")
HEADERS = ("QGC WPL 110",) * 12 + (
    "QGC\tWPL\t110", "QGC  WPL 110 \t", "QGC WPL 100", "qgc wpl 110", "\ufeffQGC WPL 110",
)  # fmt: skip
COMMENTS = (b"# a comment", b"  \t# 7 \xe4\xfc\xff", b"#" * 400, b"# \xc3\xa4 " + b"9" * 300, b" \t ", b"", b"#\x00")


def made(seed: int) -> bytes:
    """A text, much of whose kinds of trouble are in it, but few at once."""
    choose = random.Random(seed)
    usual, gap, end = choose.random() < 0.6, choose.choice(GAPS), choose.choice(ENDS)
    fence = choose.random() < 0.2
    rows = [] if choose.random() < 0.2 else ["0 1 0 16 0 0 0 0 -35.3 149.1 584 1".split()]
    for number in range(len(rows), len(rows) + choose.randrange(1, 6)):
        command = choose.choice((5000, 5001, 5003, 5005, 5100) if fence else COMMANDS) if number else 22 + 4981 * fence
        place = ("0", "0") if command in (20, 178, 183) and choose.random() < 0.8 else ("-35.3", "149.1")
        row = [
            number, 0, choose.choice((0, 3, 10, 5, 6, 11, 2) if not usual else (0, 3)), command, 3, 0, 0, 0, *place, 20,
            1,
        ]  # fmt: skip
        row = list(map(str, row))
        if not usual and choose.random() < 0.5:
            column = choose.randrange(12)
            row[column] = choose.choice(PLACES if column in (8, 9) else NUMBERS)
        if not usual and choose.random() < 0.1:
            row = row[:-1] if choose.random() < 0.5 else [*row, "1"]
        rows.append(row)
    lines = [choose.choice(HEADERS).encode()]
    for row in rows:
        lines += choose.sample(COMMENTS, choose.choice((0, 0, 0, 1, 2)))
        lines.append((choose.choice(("", "", " ")) + gap.join(row) + choose.choice(("", "", " ", "\t\t"))).encode())
    data = end.encode().join(lines) + choose.choice((end, end * 3, "", "  ")).encode()
    return data + choose.choice((b"",) * 30 + (b"\0" * 20, b"\xff" * 5, b"\n" + data))


FOUND = [*sorted(FILES.glob("*.waypoints")), *sorted((ROOT / "examples").glob("**/*.txt"))]
TEXTS = [*(file.read_bytes() for file in FOUND), *map(made, range(200))]


@pytest.fixture(scope="module")
def board():
    reader = WaypointsReader()
    yield reader
    reader.close()


def test_both_readers_make_the_same_of_200_files(board):
    read = []
    for text in TEXTS:
        theirs = board.read(text)
        try:
            plan = waypoints.read(Path("a.waypoints"), text)
        except BadPlan as error:
            said = judge.text("\n".join(waypoints.lines_of(text)))
            assert not theirs.good and (said.error, said.line, said.field) == (theirs.error, theirs.line, theirs.field)
            assert error.line == theirs.line, text
            continue
        if theirs.error == "NoItems":
            assert plan.kinds == []
            continue
        if theirs.error == "OutOfOrder":  # and no item names another one: the tool numbers them anew, and says so
            assert any("renumbered" in note for note in plan.notes)
            continue
        assert theirs.good and plan.kinds == [theirs.kind], (text, theirs)
        ours = [item.packed() for item in plan.items(theirs.kind)]
        packed = [b"".join(one.params) + packed_rest(one) for one in theirs.items]
        assert ours == packed, text
        read.append(theirs.kind)
    assert len(read) > len(TEXTS) / 3 and {"mission", "fence"} <= set(read)


def packed_rest(item) -> bytes:
    numbers = (item.x, item.y)
    return (
        b"".join(number.to_bytes(4, "little", signed=True) for number in numbers)
        + item.z
        + bytes((item.command & 255, item.command >> 8, item.frame, item.current, item.autocontinue))
    )
