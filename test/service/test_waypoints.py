"""A .waypoints text as the library reads it, beside pymavlink's loader. host/units/waypoints_text.cpp has each rule."""

from __future__ import annotations

import math
import random
import struct

import pytest
from pymavlink import mavwp

from waypoints_reader import WaypointsReader

PLACES, NO_PLACES, JUMP = (16, 17, 19, 21, 22, 82, 195), (20, 93, 178, 206), 177


@pytest.fixture(scope="module")
def reader():
    made = WaypointsReader()
    yield made
    made.close()


def text_of(choose: random.Random) -> tuple[str, int]:
    """A good text as some program may have written it, and its items."""

    def number(limit: int, places: int) -> str:
        part = "".join(choose.choices("0123456789", k=min(places, 15 - len(str(limit)))))
        return choose.choice(("", "-", "+")) + f"{choose.randrange(limit)}.{part}"

    def any_number() -> str:
        return choose.choice(
            ("0.00000000", number(1000, 8), number(10**9, 3), f"{number(9, 8)}e{choose.randint(-30, 30)}")
        )

    count = choose.randint(2, 12)
    rows = [["0", "1", "0", choose.choice(("0", "16")), *"0000", number(89, 12), number(179, 12), "584.1", "1"]]
    for line in range(1, count):
        command = choose.choice((*PLACES, *NO_PLACES, JUMP))
        params = [*(any_number() for _ in range(3)), choose.choice((any_number(), "nan", "NaN", "-nan"))]
        if command == JUMP:
            params[0] = f"{choose.randrange(1, count)}{choose.choice(('', '.', '.000'))}"
        place = (
            [number(89, 12), number(179, 12)] if command in PLACES else [str(choose.randint(-2000, 2000)) for _ in "xy"]
        )
        frame, current, autocontinue = choose.choice(("0", "3", "10")), choose.choice("01"), choose.choice("01")
        rows.append([str(line), current, frame, str(command), *params, *place, any_number(), autocontinue])
    end, between = choose.choice(("\n", "\r\n")), choose.choice(("\t", " ", "  ", " \t"))
    text = "QGC WPL 110" + choose.choice(("", " ", "\t")) + end
    for row in rows:
        text += choose.choice(("", end, "# of the west field" + end, "   " + end))
        text += choose.choice(("", " ")) + between.join(row) + choose.choice(("", "\t")) + end
    return (text if choose.random() < 0.5 else text.removesuffix(end)), count - 1


def same_float(ours: bytes, theirs: float) -> bool:
    return math.isnan(struct.unpack("<f", ours)[0]) if math.isnan(theirs) else ours == struct.pack("<f", theirs)


def test_a_text_is_read_as_pymavlinks_loader_reads_it(reader, tmp_path):
    file = tmp_path / "text.waypoints"
    for seed in range(200):
        text, count = text_of(random.Random(seed))
        file.write_text(text, newline="")
        loader = mavwp.MAVWPLoader()
        loader.load(str(file))
        read = reader.read(text)
        assert read.good, (read, text)
        assert loader.count() == count + 1 == len(read.items) + 1
        for index, ours in enumerate(read.items):
            theirs = loader.wp(index + 1)
            has_place = theirs.command in PLACES
            params = [theirs.param1 - (theirs.command == JUMP), theirs.param2, theirs.param3, theirs.param4]
            assert all(map(same_float, ours.params, params)), (index, text)
            assert same_float(ours.z, theirs.z)
            assert (ours.command, ours.current, ours.autocontinue) == (
                theirs.command,
                theirs.current,
                theirs.autocontinue,
            )
            assert ours.frame == (theirs.frame if has_place else 2)
            steps = 10**7 if has_place else 1
            assert abs(ours.x - theirs.x * steps) <= 0.5 + 1e-6 and abs(ours.y - theirs.y * steps) <= 0.5 + 1e-6
