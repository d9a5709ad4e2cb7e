"""A .waypoints text as the library reads it, beside pymavlink's loader and exact arithmetic; and texts that are bad."""

from __future__ import annotations

import math
import struct
from decimal import ROUND_HALF_UP, Context, Decimal
from fractions import Fraction

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from pymavlink import mavwp

from waypoints_reader import WaypointsReader, error_texts

HOME = "0\t1\t0\t16\t0\t0\t0\t0\t-35.363261\t149.165230\t584.000000\t1"
GOOD = [
    "1\t0\t3\t22\t0.00000000\t0.00000000\t0.00000000\t0.00000000\t0.00000000\t0.00000000\t20.000000\t1",
    "2\t0\t3\t16\t0.00000000\t0.00000000\t0.00000000\t0.00000000\t-35.36326210\t149.16523740\t20.500000\t1",
    "3\t0\t3\t177\t2.00000000\t3.00000000\t0.00000000\t0.00000000\t0.00000000\t0.00000000\t0.000000\t1",
    "4\t0\t3\t20\t0.00000000\t0.00000000\t0.00000000\t0.00000000\t0.00000000\t0.00000000\t0.000000\t1",
]
# A share of MAV_CMD that has a place; and two that have none.
PLACES, NO_PLACES, JUMP = (16, 17, 19, 21, 22, 82, 195), (20, 93, 178, 206), 177
FLOAT_BYTES = struct.Struct("<f")
EXACT = Context(prec=100)
LARGEST = FLOAT_BYTES.unpack(b"\xff\xff\x7f\x7f")[0]
SETTINGS = settings(max_examples=120, deadline=None, derandomize=True)


@pytest.fixture(scope="module")
def reader():
    made = WaypointsReader()
    yield made
    made.close()


def text_of(lines: list[str], end: str = "\n") -> str:
    return end.join(["QGC WPL 110", *lines]) + end


# Numbers as people and programs write them -----------------------------------------


def decimals(limit: int, places: int):
    """Texts of numbers up to the limit with so many decimals at the most, 15 significant digits in all."""
    whole = st.integers(-limit, limit)
    part = st.text("0123456789", max_size=places)
    return st.builds(written, whole, part, st.booleans(), st.sampled_from(["", "+"]))


def written(whole: int, part: str, minus_zero: bool, plus: str) -> str:
    sign = "-" if whole < 0 or (minus_zero and whole == 0) else plus
    part = part[: max(0, 15 - len(str(abs(whole))))]
    return f"{sign}{abs(whole)}{'.' if part else ''}{part}"


scientific = st.builds(lambda digits, exponent: f"{digits}e{exponent}", decimals(9, 8), st.integers(-30, 30))
numbers = st.one_of(st.just("0.00000000"), decimals(1000, 8), decimals(10**9, 3), scientific)
latitudes, longitudes = decimals(89, 12), decimals(179, 12)
wholes = st.integers(-2000, 2000).map(str)


@st.composite
def lines(draw) -> list[list[str]]:
    """The fields of each line behind the first, numbered as they must be."""
    count = draw(st.integers(2, 12))
    made = [
        ["0", "1", "0", draw(st.sampled_from(["0", "16"])), *"0000", draw(latitudes), draw(longitudes), "584.1", "1"]
    ]
    for number in range(1, count):
        command = draw(st.sampled_from([*PLACES, *NO_PLACES, JUMP]))
        params = [draw(numbers) for _ in range(4)]
        params[3] = draw(st.one_of(numbers, st.sampled_from(["nan", "NaN", "-nan"])))
        if command == JUMP:
            params[0] = draw(
                st.integers(1, count - 1).map(
                    lambda target: draw(st.sampled_from(["", ".", ".000"])).join([str(target), ""])
                )
            )
        place = [draw(latitudes), draw(longitudes)] if command in PLACES else [draw(wholes), draw(wholes)]
        frame = draw(st.sampled_from(["0", "3", "10"]))
        made.append(
            [
                str(number),
                draw(st.sampled_from("01")),
                frame,
                str(command),
                *params,
                *place,
                draw(numbers),
                draw(st.sampled_from("01")),
            ]
        )
    return made


@st.composite
def texts(draw) -> tuple[str, int]:
    """A good text as some program may have written it, and its items."""
    end = draw(st.sampled_from(["\n", "\r\n"]))
    between = draw(st.sampled_from(["\t", " ", "  ", " \t"]))
    rows = draw(lines())
    text = "QGC WPL 110" + draw(st.sampled_from(["", " ", "\t"])) + end
    for row in rows:
        text += draw(st.sampled_from(["", end, "# of the west field" + end, "   " + end]))
        text += draw(st.sampled_from(["", " "])) + between.join(row) + draw(st.sampled_from(["", "\t"])) + end
    return (text if draw(st.booleans()) else text.removesuffix(end)), len(rows) - 1


def same_float(ours: bytes, theirs: float) -> bool:
    if math.isnan(theirs):
        return math.isnan(FLOAT_BYTES.unpack(ours)[0])
    return ours == FLOAT_BYTES.pack(theirs)


@SETTINGS
@given(texts(), st.randoms(use_true_random=False))
def test_a_text_is_read_as_pymavlinks_loader_reads_it(reader, tmp_path_factory, made, random):
    text, count = made
    file = tmp_path_factory.getbasetemp() / "text.waypoints"
    file.write_text(text, newline="")
    loader = mavwp.MAVWPLoader()
    loader.load(str(file))
    order = random.sample(range(count), count)
    read = reader.read(text, order)
    assert read.good, (read, text)
    assert loader.count() == count + 1 == len(read.items) + 1
    for index, ours in enumerate(read.items):
        theirs = loader.wp(index + 1)
        has_place = theirs.command in PLACES
        params = [theirs.param1 - (theirs.command == JUMP), theirs.param2, theirs.param3, theirs.param4]
        assert all(map(same_float, ours.params, params)), (index, text)
        assert same_float(ours.z, theirs.z)
        assert (ours.command, ours.current, ours.autocontinue) == (theirs.command, theirs.current, theirs.autocontinue)
        assert ours.frame == (theirs.frame if has_place else 2)
        steps = 10**7 if has_place else 1
        assert abs(ours.x - theirs.x * steps) <= 0.5 + 1e-6
        assert abs(ours.y - theirs.y * steps) <= 0.5 + 1e-6
    assert read.again == [read.items[index] for index in order]


# Exactness -------------------------------------------------------------------------


def nearest_float(text: str) -> bytes:
    """The float nearest to the number, the even one of two; by fractions, without rounding twice."""
    exact = abs(Fraction(Decimal(text)))
    near = int.from_bytes(FLOAT_BYTES.pack(min(float(exact), LARGEST)), "little")
    candidates = [bits for bits in (near - 1, near, near + 1) if 0 <= bits < 0x7F800000]

    def away(bits: int) -> tuple[Fraction, int]:
        return abs(Fraction(FLOAT_BYTES.unpack(bits.to_bytes(4, "little"))[0]) - exact), bits & 1

    sign = 0x80000000 if text.startswith("-") else 0
    return (min(candidates, key=away) | sign).to_bytes(4, "little")


def line_with(param1: str = "0", x: str = "0", y: str = "0") -> str:
    return text_of([HOME, f"1 0 3 16 {param1} 0 0 0 {x} {y} 20 1"])


any_digits = st.text("0123456789", min_size=1, max_size=19)
any_number = st.builds(
    lambda sign, digits, point, exponent: f"{sign}{digits[:point] or '0'}.{digits[point:]}{exponent}",
    st.sampled_from(["", "-"]),
    any_digits,
    st.integers(0, 30),
    st.one_of(st.just(""), st.integers(-60, 7).map("e{}".format)),
)
# Midway between two floats, and a hair beside it.
midways = st.builds(
    lambda bits, hair: f"{Decimal(2 * bits + 1) / 2**9}{hair}",
    st.integers(2**23, 2**24 - 1),
    st.sampled_from(["", "0001"]),
)


@SETTINGS
@given(st.one_of(any_number, midways))
@example("1e-45")
@example("7.006492321624085353e-46")  # less than half of the smallest float
@example("7.006492321624085355e-46")  # more
@example("1.17549429e-38")  # below the smallest normal float
@example("340282346638528859800000000000000000000")
@example("340282356779733661600000000000000000000")  # the last that is not rounded beyond the largest
@example("16777217")
@example("16777219")
@example("0." + "0" * 44 + "14012984643248170")
@example("-0")
@example("1e-999")
def test_a_number_of_up_to_19_digits_becomes_the_nearest_float(reader, text):
    read = reader.read(line_with(param1=text))
    assert read.good, (text, read)
    assert read.items[0].params[0] == nearest_float(text), text


@SETTINGS
@given(st.text("0123456789", min_size=20, max_size=60))
@example("0" * 50 + "1")
def test_of_longer_numbers_the_rest_decides_only_between_two_equally_near(reader, digits):
    read = reader.read(line_with(param1=f"1.{digits}"))
    assert read.items[0].params[0] in (nearest_float(f"1.{digits}"), nearest_float(f"1.{digits[:18]}"))
    read = reader.read(line_with(param1=f"16777217.{digits}"))
    assert read.items[0].params[0] == nearest_float(f"16777217.{digits}")


@pytest.mark.parametrize("text", ["340282356779733661700000000000000000000", "1e39", "-1e39", "1e999", "9" * 60])
def test_a_number_beyond_the_largest_float_is_refused(reader, text):
    read = reader.read(line_with(param1=text))
    assert (read.error, read.line, read.field) == ("TooLarge", 3, 5)


degrees = st.builds(
    lambda whole, part: f"{whole}.{part}", st.integers(-89, 89), st.text("0123456789", min_size=1, max_size=30)
)


@SETTINGS
@given(degrees)
@example("-35.36326205")
@example("35.36326204999999999999999999999")
@example("-0.00000005")
@example("0.000000049")
@example("90.00000004")
@example("9000e-2")
def test_a_coordinate_becomes_the_nearest_1e_7_degree(reader, text):
    read = reader.read(line_with(x=text, y=text))
    assert read.good, (text, read)
    exact = int(Decimal(text).scaleb(7, EXACT).quantize(Decimal(1), ROUND_HALF_UP, EXACT))
    assert (read.items[0].x, read.items[0].y) == (exact, exact)


# Going to and fro --------------------------------------------------------------------


def long_text(items: int, comment: str = "") -> str:
    rows = (
        f"{n}\t0\t3\t16\t{n % 7}\t0\t0\t0\t{-35 - n / 1e6:.8f}\t{149 + n / 1e6:.8f}\t{n % 100}.5\t1\n{comment}"
        for n in range(1, items + 1)
    )
    return text_of([HOME]) + "".join(rows)


@pytest.mark.parametrize("comment", ["", "# a line between\r\n\r\n"])
def test_an_item_out_of_order_costs_a_few_lines_however_long_the_plan(reader, comment):
    orders = {12: range(11, -1, -1), 3000: [2999, 0, 1500, 1499, 1500, 1501, 7, 2998, 2999, 2999, 1, 2000]}
    for items, order in orders.items():
        read = reader.read(long_text(items, comment), list(order))
        assert read.good and len(read.items) == items
        assert read.again == [read.items[index] for index in order]
        assert read.most_bytes < 20 * 120


def test_what_is_not_read_through_or_is_bad_gives_no_item(reader):
    read = reader.read("QGC WPL 110\n", [0, 1, 65535])
    assert not read.good and read.items == [] and read.again == [None] * 3


# Bad texts ---------------------------------------------------------------------------


def spoiled(line: int, field: int, value: str) -> str:
    """A good text with another value in a field of a line, both counted from 1."""
    rows = [HOME, *GOOD]
    fields = rows[line - 2].split("\t")
    fields[field - 1] = value
    rows[line - 2] = "\t".join(fields)
    return text_of(rows)


BAD = {
    "another version": ("QGC WPL 120\n" + HOME, "NotWaypoints", 1, 0),
    "no first line": (HOME + "\n", "NotWaypoints", 1, 0),
    "no more than half of it": ("QGC WPL", "NotWaypoints", 1, 0),
    "something behind it": ("QGC WPL 1100\n" + HOME, "NotWaypoints", 1, 0),
    "nothing at all": ("", "NotWaypoints", 1, 0),
    "a plan of QGroundControl": ('{\n "fileType": "Plan"}', "NotWaypoints", 1, 0),
    "no home": ("QGC WPL 110\r\n", "NoItems", 2, 0),
    "home alone": (text_of([HOME]), "NoItems", 3, 0),
    "eleven fields": (text_of([HOME, GOOD[0].rpartition("\t")[0]]), "TooFewFields", 3, 0),
    "thirteen fields": (text_of([HOME, GOOD[0] + "\t1"]), "TooManyFields", 3, 0),
    "it breaks off": (text_of([HOME, *GOOD])[:-12], "TooFewFields", 6, 0),
    "a line too long": (text_of([HOME, GOOD[0] + " " * 200]), "LineTooLong", 3, 0),
    "a second plan": (text_of([HOME, *GOOD]) * 2, "SecondPlan", 7, 0),
    "an end that was not written": (text_of([HOME, *GOOD]) + "\0" * 99, "Padding", 7, 0),
    "a line is missing": (text_of([HOME, GOOD[0], GOOD[2]]), "OutOfOrder", 4, 1),
    "a line comes twice": (text_of([HOME, GOOD[0], GOOD[0]]), "OutOfOrder", 4, 1),
    "it begins with 1": (text_of(GOOD), "OutOfOrder", 2, 1),
    "the line below an empty one": (text_of([HOME, "", "# west", GOOD[1]]), "OutOfOrder", 5, 1),
    "a negative number": (spoiled(3, 1, "-1"), "OutOfOrder", 3, 1),
    "an altitude of which nothing says what it is from": (spoiled(3, 3, "2"), "NoReference", 3, 3),
    "a local frame": (spoiled(3, 3, "1"), "BadTextFrame", 3, 3),
    "frame 12": (spoiled(3, 3, "12"), "BadTextFrame", 3, 3),
    "a command with a point": (spoiled(3, 4, "16.0"), "NotWhole", 3, 4),
    "a command beyond 65535": (spoiled(3, 4, "65536"), "TooLarge", 3, 4),
    "a word": (spoiled(3, 5, "fast"), "BadNumber", 3, 5),
    "a comma": (spoiled(4, 9, "-35,3632621"), "BadNumber", 4, 9),
    "two points": (spoiled(4, 9, "-35.36.1"), "BadNumber", 4, 9),
    "two signs": (spoiled(4, 9, "--35"), "BadNumber", 4, 9),
    "a sign alone": (spoiled(4, 9, "-"), "BadNumber", 4, 9),
    "a point alone": (spoiled(4, 9, "."), "BadNumber", 4, 9),
    "an exponent without digits": (spoiled(4, 5, "1e"), "BadNumber", 4, 5),
    "infinity": (spoiled(4, 5, "inf"), "BadNumber", 4, 5),
    "half a nan": (spoiled(4, 8, "na"), "BadNumber", 4, 8),
    "a nan as latitude": (spoiled(4, 9, "nan"), "BadNumber", 4, 9),
    "a nan as altitude": (spoiled(4, 11, "nan"), "BadNumber", 4, 11),
    "hexadecimal": (spoiled(4, 5, "0x10"), "BadNumber", 4, 5),
    "a byte that is no text": (spoiled(4, 5, "\x00").encode(), "Padding", 4, 4),
    "a latitude beyond the pole": (spoiled(4, 9, "90.0000001"), "BeyondLatitude", 4, 9),
    "latitude and longitude exchanged": (spoiled(4, 9, "149.165"), "BeyondLatitude", 4, 9),
    "a longitude beyond 180": (spoiled(4, 10, "-180.0000001"), "BeyondLongitude", 4, 10),
    "a longitude far beyond": (spoiled(4, 10, "4294967296000000"), "TooLarge", 4, 10),
    "half a param5": (text_of([HOME, *GOOD[:3], "4 0 2 203 0 0 0 0 0.5 0 0 1"]), "NotWhole", 6, 9),
    "autocontinue 3": (spoiled(4, 12, "3"), "NotZeroOrOne", 4, 12),
    "a jump to home": (spoiled(5, 5, "0"), "BadTarget", 5, 5),
    "a jump to half a line": (spoiled(5, 5, "1.5"), "BadTarget", 5, 5),
    "a jump backwards out of the file": (spoiled(5, 5, "-1"), "BadTarget", 5, 5),
    "a jump beyond the last line": (spoiled(5, 5, "5"), "BadTarget", 5, 5),
    "a jump to nan": (spoiled(5, 5, "nan"), "BadTarget", 5, 5),
    "a corner of a fence in a mission": (text_of([HOME, *GOOD, "5 0 0 5001 4 0 0 0 1 2 0 1"]), "MixedKinds", 7, 4),
    "a waypoint among the corners of a fence": (
        text_of(["0 0 0 5001 4 0 0 0 1 2 0 1", *GOOD[1:]]).replace("2\t0", "1\t0", 1), "MixedKinds", 3, 4),
    "a rally point behind a fence": (
        text_of(["0 0 0 5003 4 0 0 0 1 2 0 1", "1 0 3 5100 0 0 0 0 1 2 20 1"]), "MixedKinds", 3, 4),
    "a jump out of a file without home": (
        text_of(["0 0 3 22 0 0 0 0 1 2 20 1", "1 0 3 177 2 1 0 0 0 0 0 1"]), "BadTarget", 3, 5),
}  # fmt: skip


@pytest.mark.parametrize("what", BAD)
def test_a_bad_text_is_refused_with_its_line_and_the_reason(reader, what):
    text, error, line, field = BAD[what]
    read = reader.read(text)
    assert (read.error, read.line, read.field) == (error, line, field)
    assert not read.good and read.items == []


def test_every_reason_but_the_stores_own_has_a_bad_text():
    # A text cannot be made unreadable, or sent too fast, or be too much for a store, by what is written in it.
    others = {"None", "Unreadable", "NotKept", "TooFast", "NoRoom"}
    assert {error for _, error, _, _ in BAD.values()} | others == set(error_texts())
    assert all(error_texts().values())


@pytest.mark.parametrize("text", [
    "\ufeff" + text_of([HOME, *GOOD]),
    text_of([HOME, *GOOD], "\r\n"),
    text_of([HOME, *GOOD])[:-1],
    text_of([HOME, *GOOD]) + "\n\n  \n# end",
    text_of([HOME, *GOOD]).replace("\t", "    "),
    spoiled(5, 5, "4"),
], ids=["a byte order mark", "CR LF", "no newline at the end", "empty lines at the end", "blanks",
        "a jump to the last line"])  # fmt: skip
def test_a_good_text_is_good_however_it_is_laid_out(reader, text):
    read = reader.read(text, [3, 2, 1, 0])
    assert read.good and [item.command for item in read.items] == [22, 16, 177, 20]
    assert read.again == read.items[::-1]


def test_frames_are_given_with_their_present_numbers(reader):
    rows = [f"{n} 0 {frame} 189 0 0 0 0 1 2 3 1" for n, frame in enumerate((0, 3, 5, 6, 10, 11, 2), start=1)]
    assert [item.frame for item in reader.read(text_of([HOME, *rows])).items] == [0, 3, 0, 3, 10, 10, 2]


# Line 0 ------------------------------------------------------------------------------


def numbered(rows: list[str], first: int = 0) -> str:
    return text_of([f"{number} {row}" for number, row in enumerate(rows, start=first)])


CORNERS = [f"0 0 5001 4 0 0 0 {x} {y} 0 1" for x, y in ((1, 1), (1, 2), (2, 2), (2, 1))]
RALLY = [f"0 3 5100 0 0 0 0 {x} 2 25 1" for x in (1, 2)]
FROM_TAKEOFF = [
    "1 3 22 0 0 0 0 1 2 20 1",
    "0 3 16 0 0 0 0 3 4 20 1",
    "0 2 177 0 2 0 0 0 0 0 1",
    "0 3 21 0 0 0 0 1 2 0 1",
]


@pytest.mark.parametrize(
    ("rows", "kind", "commands"),
    [
        (CORNERS, "fence", [5001] * 4),
        (RALLY, "rally", [5100] * 2),
        (RALLY[:1], "rally", [5100]),
        (["0 0 5000 0 0 0 0 1 2 0 1", *CORNERS], "fence", [5000] + [5001] * 4),
        (FROM_TAKEOFF, "mission", [22, 16, 177, 21]),
        (["0 2 178 1 5 -1 0 0 0 0 1", *FROM_TAKEOFF[:1]], "mission", [178, 22]),
    ],
    ids=["a fence", "rally points", "one rally point", "a fence with a return point", "a takeoff", "a speed"],
)
def test_line_0_is_an_item_if_it_is_no_waypoint(reader, rows, kind, commands):
    count = len(rows)
    read = reader.read(numbered(rows), list(range(count))[::-1])
    assert read.good and read.kind == kind
    assert [item.command for item in read.items] == commands
    assert read.again == read.items[::-1]


@pytest.mark.parametrize("command", ["0", "16"])
@pytest.mark.parametrize("frame", ["0", "3"])
def test_line_0_is_home_if_it_is_a_waypoint(reader, command, frame):
    home = f"0 1 {frame} {command} 0 0 0 0 1 2 3 1"
    for rows, kind in ((GOOD, "mission"), ([f"{n} {row}" for n, row in enumerate(CORNERS, 1)], "fence")):
        read = reader.read(text_of([home, *rows]))
        assert read.good and len(read.items) == 4 and read.kind == kind


def test_jump_in_a_file_without_home_goes_to_the_line_that_it_names(reader):
    jump = reader.read(numbered(FROM_TAKEOFF)).items[2]
    assert (jump.command, jump.params[0]) == (177, FLOAT_BYTES.pack(0))  # to the takeoff
    behind_home = reader.read(text_of([HOME, *GOOD])).items[2]
    assert (behind_home.command, behind_home.params[0]) == (177, FLOAT_BYTES.pack(1))


def test_plan_without_home_is_read_in_any_order(reader):
    rows = [f"0 3 21 0 0 0 0 {n / 100:.2f} 1 2 1" for n in range(1, 400)]
    order = [398, 0, 1, 0, 200, 201, 0, 398, 1]
    read = reader.read(numbered(rows), order)
    assert read.good and len(read.items) == 399
    assert read.again == [read.items[index] for index in order]
    assert read.most_bytes < 20 * 60


@pytest.mark.parametrize("position", range(0, 420, 7))
def test_a_text_cut_anywhere_never_gives_half_an_item(reader, position):
    whole = text_of([HOME, *GOOD])
    read = reader.read(whole[:position])
    assert [item for item in read.items] == reader.read(whole).items[: len(read.items)]
