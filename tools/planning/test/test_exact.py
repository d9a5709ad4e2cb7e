"""tools/plan carries a plan to the bit: from text to the wire's numbers, between the formats, and into a header."""

from __future__ import annotations

import json
import random
import struct
import subprocess
from decimal import Decimal
from fractions import Fraction
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pymavlink import mavwp

from building import ROOT, build_sketch
from demonstration.plan_in_firmware import plan_in
from planned import E7_LONGITUDES, FLOATS, NAN, WITH_PLACE, WITHOUT_PLACE, bits, plan_of, plans
from planning import BadPlan, Item, commands, qgc_plan, waypoints
from planning.exact import DoesNotFit, decimal_of, decimal_text, degrees_text, e7_of, float32_of, float_bits, int32_of
from planning.header import header_of, namespace_of
from planning.located_json import Value, parse
from planning.makers import NAMED, source_of
from planning.round_trip import sketch_for
from simulation.host_build import FAST, OUTPUT, build_host

FILE = Path("drawn.plan")
QUICK = settings(deadline=None, max_examples=150, derandomize=True)

# Numbers -----------------------------------------------------------------------


@QUICK
@given(E7_LONGITUDES)
def test_coordinate_is_the_same_after_its_text(e7):
    assert e7_of(decimal_of(degrees_text(e7))) == e7
    assert Fraction(degrees_text(e7)) * 10**7 == e7


def test_longitude_that_a_float_would_move_by_a_metre_is_exact():
    assert e7_of(Decimal("149.1652374")) == 1491652374
    assert e7_of(Decimal("149.16523739999999")) == 1491652374
    assert e7_of(Decimal("-179.99999995")) == -1800000000  # halfway: to the even one


@QUICK
@given(FLOATS)
def test_float_is_the_same_after_its_text(value):
    assert float_bits(float32_of(decimal_of(decimal_text(value)))) == float_bits(value)
    # Whoever rounds it to 64 bits first comes to the same.
    assert struct.pack("<f", float(decimal_text(value))) == struct.pack("<f", value)


@QUICK
@given(st.decimals(min_value=Decimal("-1e30"), max_value=Decimal("1e30"), allow_nan=False))
def test_number_becomes_the_nearest_float(number):
    value = Fraction(float32_of(number))
    near = struct.unpack("<f", struct.pack("<f", float(number)))[0]
    for bits_off in (-1, 0, 1):
        other = struct.unpack("<f", struct.pack("<I", max(0, float_bits(abs(near)) + bits_off)))[0]
        other = -other if number < 0 else other
        assert abs(value - Fraction(number)) <= abs(Fraction(other) - Fraction(number))


def test_number_between_two_floats_is_rounded_once():
    # One step of a 64-bit float above the middle of two 32-bit ones: rounding twice would go to the even one below.
    middle = Fraction(1) + Fraction(1, 2**24)
    text = f"{Decimal(middle.numerator) / Decimal(middle.denominator)}" + "0" * 12 + "1"
    assert float32_of(Decimal(text)) == 1 + 2**-23
    assert struct.unpack("<f", struct.pack("<f", float(text)))[0] == 1.0


@pytest.mark.parametrize("text", ["1e39", "-3.5e38", "1e999999999"])
def test_number_that_no_float_holds_is_refused(text):
    with pytest.raises(DoesNotFit):
        float32_of(Decimal(text))


@pytest.mark.parametrize("text", ["2147483648", "-2147483649", "0.5", "1e999999999"])
def test_number_that_no_int32_holds_is_refused(text):
    with pytest.raises(DoesNotFit):
        int32_of(Decimal(text))


# JSON --------------------------------------------------------------------------

DOCUMENTS = st.recursive(
    st.one_of(st.none(), st.booleans(), st.integers(), st.floats(allow_nan=False, allow_infinity=False), st.text()),
    lambda inner: st.one_of(st.lists(inner, max_size=4), st.dictionaries(st.text(), inner, max_size=4)),
    max_leaves=20,
)


def plain(value: Value):
    if isinstance(value.raw, dict):
        return {key: plain(member) for key, member in value.raw.items()}
    return [plain(entry) for entry in value.raw] if isinstance(value.raw, list) else value.raw


@QUICK
@given(DOCUMENTS, st.data())
def test_json_that_is_spoiled_is_refused_when_python_refuses_it(document, data):
    text = json.dumps(document, indent=1)
    start = data.draw(st.integers(0, len(text)))
    end = data.draw(st.integers(start, len(text)))
    spoiled = text[:start] + data.draw(st.sampled_from(["", ",", "}", "[", '"', "1", "nul"])) + text[end:]
    try:
        wanted = json.loads(spoiled, parse_float=Decimal, parse_int=Decimal, object_pairs_hook=once)
    except ValueError:
        with pytest.raises(BadPlan) as refused:
            parse(FILE, spoiled)
        assert 1 <= refused.value.line <= spoiled.count("\n") + 1
    else:
        assert plain(parse(FILE, spoiled)) == wanted


def once(pairs):
    if len(dict(pairs)) != len(pairs):
        raise ValueError("twice")
    return dict(pairs)


def test_each_value_knows_its_line():
    document = parse(FILE, '{\n "a": [1,\n  2,\n  {"b": null}\n ]\n}')
    assert [entry.line for entry in document.need("a").array()] == [2, 3, 4]
    assert document.need("a").raw[2].need("b").line == 4


def test_json_that_is_very_deep_is_refused():
    with pytest.raises(BadPlan, match="deep"):
        parse(FILE, "[" * 100_000)


# The formats -------------------------------------------------------------------


def same(one, other) -> bool:
    return all(bits(one.items(kind)) == bits(other.items(kind)) for kind in ("mission", "fence", "rally"))


@QUICK
@given(plans())
def test_plan_is_the_same_after_a_dot_plan(plan):
    text, _ = qgc_plan.write(plan)
    read = qgc_plan.read(FILE, text)
    assert same(read, plan) and read.home == plan.home
    assert qgc_plan.write(read)[0] == text


@pytest.mark.slow
@QUICK
@given(plans())
def test_dot_plan_by_waypoints_is_the_same_dot_plan(plan):
    plan = plan_of(plan.items(), home=plan.home)
    by_waypoints = waypoints.read(FILE, waypoints.write(plan)[0])
    assert qgc_plan.write(by_waypoints)[0] == qgc_plan.write(plan)[0]


@settings(deadline=None, max_examples=30, derandomize=True)
@given(plans())
def test_waypoints_are_what_pymavlink_reads(tmp_path_factory, plan):
    file = tmp_path_factory.mktemp("read") / "drawn.waypoints"
    file.write_text(waypoints.write(plan)[0])
    loader = mavwp.MAVWPLoader()
    assert loader.load(str(file)) == len(plan.mission) + 1
    for number, item in enumerate(plan.items(), start=1):
        read = loader.wp(number)
        numbers = [item.param1 + 1 if item.command == 177 else item.param1, *item[5:8], item.z]
        assert (read.seq, read.command, read.frame, read.autocontinue) == (
            number, item.command, item.frame, item.autocontinue,
        )  # fmt: skip
        got = [read.param1, read.param2, read.param3, read.param4, read.z]
        assert struct.pack("<5f", *got) == struct.pack("<5f", *numbers)
        scale = 1 if item.frame == 2 else 1e7
        assert (round(read.x * scale), round(read.y * scale)) == (item.x, item.y)


def test_jump_counts_home_in_waypoints_and_from_1_in_a_dot_plan():
    jump = Item(2, 177, 0, 1, 0.0, 3.0, 0.0, 0.0, 0, 0, 0.0)
    plan = plan_of([Item(3, 16, 0, 1, 0.0, 0.0, 0.0, NAN, 1, 1, 20.0), jump])
    assert waypoints.write(plan)[0].splitlines()[3].split("\t")[3:6] == ["177", "1", "3"]
    items = json.loads(qgc_plan.write(plan)[0])["mission"]["items"]
    assert items[0]["doJumpId"] == 1 == items[1]["params"][0]


def test_jump_goes_to_the_item_with_the_id_wherever_that_stands():
    plan = plan_of(
        [Item(3, 16, 0, 1, 0.0, 0.0, 0.0, NAN, n + 1, 1, 20.0) for n in range(3)]
        + [Item(2, 177, 0, 1, 2.0, 3.0, 0.0, 0.0, 0, 0, 0.0)]
    )
    document = json.loads(qgc_plan.write(plan)[0])
    items = document["mission"]["items"]
    items[2]["doJumpId"] = items[3]["params"][0] = 70
    text = json.dumps(document)
    read = qgc_plan.read(FILE, text)
    assert read.items()[3].param1 == 2.0


# The header --------------------------------------------------------------------

DUMP = """
#include <MavMission.h>
#include <stdio.h>
#include "{header}"
#include "mavmission/plan/ItemSource.h"
template <size_t N>
void dump(const mavmission::MissionItem (&plan)[N]) {{
  for (const mavmission::MissionItem& item : plan) {{
    uint8_t bytes[33];
    memcpy(bytes, &item, sizeof(bytes));
    for (uint8_t byte : bytes) printf("%02x", byte);
    printf("\\n");
  }}
}}
int main() {{
  dump({namespace}::mission);
  dump({namespace}::fence);
  dump({namespace}::rally);
  return 0;
}}
"""


# What the maker of a command sets: which parameters may be anything, and what the others are.
SHAPES = {
    16: {"param1", "param2", "yaw"}, 17: {"param3", "yaw"}, 18: {"param1", "param3"}, 19: {"param1", "param3"},
    20: set(), 21: {"yaw"}, 22: {"yaw"}, 93: {"param1"}, 115: {"param1"}, 177: {"param1", "param2"}, 178: {"param2"},
    181: {"param1"}, 183: {"param1", "param2"}, 195: set(), 197: set(), 203: set(), 206: {"param1"},
}  # fmt: skip
FIXED = {
    93: {"param2": -1.0, "param3": -1.0, "param4": -1.0}, 178: {"param1": 1.0, "param3": -1.0}, 203: {"x": 1},
    181: {"param2": 1.0}, 21: {"frame": 3, "z": 0.0},
}  # fmt: skip
WHOLE = (177, 181, 183)


def many_items(seed: int, count: int) -> list[Item]:
    """As the makers make them, and with one member changed; and any others."""
    chance = random.Random(seed)
    special = [
        -0.0, 1.0, -1.0, 0.1, 20.1, 90.0, 180.0, -90.5, 359.9, 65535.0, 65536.0, 16777217.0, 1e-7, 1e-30, 3e38, 2.5e9,
    ]  # fmt: skip

    def number() -> float:
        drawn = chance.choice(
            [
                chance.choice(special), round(chance.uniform(-400, 400), chance.randrange(5)),
                chance.uniform(-1e6, 1e6), float(chance.randint(0, 300)),
            ]  # fmt: skip
        )
        return float32_of(Decimal(repr(drawn)))

    def place() -> tuple[int, int]:
        return chance.randint(-(9 * 10**8), 9 * 10**8), chance.randint(-18 * 10**8, 18 * 10**8)

    def shaped(command: int) -> Item:
        placed = commands.is_at_a_place(command)
        shape = SHAPES[command]
        made = Item(chance.choice([0, 3, 3, 10]) if placed else 2, command, 0, 1, 0.0, 0.0, 0.0, 0.0, 0, 0, 0.0)
        if placed and chance.random() < 0.8:
            x, y = place()
            made = made._replace(x=x, y=y, z=number())
        free = {name: float(chance.randint(0, 255)) if command in WHOLE else number() for name in shape - {"yaw"}}
        if command == 115:  # a heading that Degrees can have
            free["param1"] = chance.choice([90.0, -45.5, 0.0, 179.9, number()])
        if "yaw" in shape:
            free["param4"] = chance.choice([NAN, NAN, 0.0, 90.0, -45.5, number()])
        return made._replace(**free)._replace(**FIXED.get(command, {}))

    placed = [command for command in SHAPES if commands.is_at_a_place(command)]
    items = [shaped(command)._replace(frame=frame) for command in placed for frame in (0, 2, 3, 5, 6, 10, 11)]
    for _ in range(count):
        item = shaped(chance.choice(list(SHAPES)))
        if chance.random() < 0.3:
            member = chance.choice(
                ["param1", "param2", "param3", "param4", "z", "x", "frame", "current", "autocontinue"]
            )
            other = {
                "x": chance.choice([-(2**31), 2**31 - 1, 7]), "current": 1, "autocontinue": 0,
                "frame": chance.choice([0, 2, 3, 5, 6, 10, 11]),
            }  # fmt: skip
            item = item._replace(**{member: other.get(member, chance.choice([0.0, number()]))})
        items.append(item)
        command = chance.choice([*WITH_PLACE, *WITHOUT_PLACE, 31999])
        items.append(
            Item(3 if command in WITH_PLACE else 2, command, 0, 1, *(number() for _ in range(4)), *place(), number())
        )
    return items


def test_items_of_the_header_tests_are_written_by_every_maker():
    written = {source_of(item).split("(")[0] for item in many_items(1, 200)}
    assert written >= {
        "takeoff", "waypoint", "loiterTime", "loiterTurns", "loiterUnlimited", "land", "returnToLaunch", "delay",
        "changeSpeed", "jump", "setServo", "setRelay", "takePicture", "cameraTriggerDistance", "regionOfInterest",
        "regionOfInterestOff", "turnTo",
    }  # fmt: skip


def fence_and_rally(seed: int) -> tuple[list[Item], list[Item]]:
    chance = random.Random(seed)
    place = [chance.randint(-(9 * 10**8), 9 * 10**8) for _ in range(40)]
    fence = [
        Item(
            chance.choice([0, 0, 3]), 5000 + n % 5, 0, 1, float(chance.choice([4, 4, 12.5, 300])), 0.0, 0.0, 0.0,
            place[n], place[n + 1], chance.choice([0.0, 0.0, 30.0]),
        )  # fmt: skip
        for n in range(20)
    ]
    rally = [
        Item(chance.choice([0, 3, 10]), 5100, 0, 1, 0.0, 0.0, 0.0, 0.0, place[n], place[n + 2], 25.5) for n in range(6)
    ]
    return fence, rally


def test_header_means_exactly_the_plan_on_the_host(tmp_path):
    plan = plan_of(many_items(1, 100), *fence_and_rally(1))
    header = tmp_path / "drawn.h"
    header.write_text(header_of(plan))
    source = OUTPUT / "header_dump.cpp"
    source.parent.mkdir(parents=True, exist_ok=True)
    source.write_text(DUMP.format(header=header, namespace=namespace_of(plan)))
    program = build_host("header_dump", [source], "g++", FAST, library=[])
    dumped = subprocess.run([program], capture_output=True, text=True, check=True).stdout.split()
    meant = [packed.hex() for kind in plan.kinds for packed in bits(plan.items(kind))]
    assert dumped == meant


@pytest.mark.slow
def test_header_means_exactly_the_plan_on_the_mega():
    # What tools/demo takes for a plan in firmware is finite and known.
    mission = [item for item in many_items(2, 200) if item.command != 31999 and item.z == item.z]
    plan = plan_of(mission, *fence_and_rally(2))
    elf = build_sketch(sketch_for(plan).parent).elf
    for kind in plan.kinds:
        read = plan_in(elf, kind).items(lambda *_: b"")
        assert bits(Item(*item) for item in read) == bits(plan.items(kind))


@pytest.mark.parametrize(
    ("item", "source"),
    [
        (
            Item(3, 16, 0, 1, 0.0, 0.0, 0.0, NAN, -353632621, 1491652374, 20.0),
            "waypoint(-35.3632621_deg, 149.1652374_deg, 20_m)",
        ),
        (
            Item(0, 16, 0, 1, 2.5, 0.0, 0.0, NAN, 1, -1, 584.1),
            "waypoint(0.0000001_deg, -0.0000001_deg, aboveSeaLevel(584.1_m), 2.5_s)",
        ),
        (Item(3, 22, 0, 1, 0.0, 0.0, 0.0, NAN, 0, 0, 20.0), "takeoff(20_m)"),
        (Item(3, 21, 0, 1, 0.0, 0.0, 0.0, NAN, 0, 0, 0.0), "land()"),
        (Item(2, 177, 0, 1, 2.0, -1.0, 0.0, 0.0, 0, 0, 0.0), "jump(2, -1)"),
        (Item(2, 20, 0, 1, 0.0, 0.0, 0.0, 0.0, 0, 0, 0.0), "returnToLaunch()"),
        (Item(2, 178, 0, 1, 1.0, 7.5, -1.0, 0.0, 0, 0, 0.0), "changeSpeed(7.5_mps)"),
        (Item(2, 206, 0, 1, 25.0, 0.0, 1.0, 0.0, 0, 0, 0.0), "anyCommand(kDoSetCameraTriggerDistance, 25, 0, 1)"),
        (
            Item(3, 16, 1, 1, 0.0, 0.0, 0.0, NAN, 10, 20, 5.0),
            "MissionItem{0, 0, 0, Yaw().inDegrees(), 10, 20, 5, kNavWaypoint, CoordinateFrame::GlobalRelative, 1, 1}",
        ),
        (
            Item(3, 22, 0, 1, 15.0, 0.0, 0.0, NAN, 10, 20, 5.0),
            "anyCommandAt(kNavTakeoff, 0.0000010_deg, 0.0000020_deg, 5_m, 15, 0, 0, Yaw().inDegrees())",
        ),
    ],
)
def test_item_is_written_as_a_person_would_where_that_is_exact(item, source):
    rounded = item._replace(z=float32_of(Decimal(repr(item.z))))
    assert source_of(rounded) == source


def test_named_commands_are_those_of_the_library():
    header = (ROOT / "src/mavmission/item/MissionItem.h").read_text()
    for number, name in NAMED.items():
        assert f"  {name} = {number},\n" in header
    assert header.count(" = ", 0, header.index("// A step of a plan")) == len(NAMED)


@pytest.mark.parametrize(
    ("file", "name"),
    [
        ("farm.plan", "farmPlan"), ("North field-2.plan", "northField2Plan"), ("delay.plan", "delayPlan"),
        ("my_plan.plan", "myPlan"), ("2024.plan", "the2024Plan"), ("plan.plan", "planPlan"), ("äcker.plan", "ckerPlan"),
    ],
)
def test_namespace_is_made_of_the_files_name(file, name):
    plan = plan_of()
    plan.file = Path(file)
    assert namespace_of(plan) == name
