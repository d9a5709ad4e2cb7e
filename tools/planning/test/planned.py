"""Items and plans for the tests of tools/plan."""

from __future__ import annotations

import math
from pathlib import Path

from hypothesis import strategies as st

from planning import Home, Item, Plan, Step, commands

FILES = Path(__file__).resolve().parent / "files"
FARM = Path(__file__).resolve().parents[3] / "docs" / "farm.plan"

NAN = math.nan
E7_LATITUDES = st.integers(-900_000_000, 900_000_000)
E7_LONGITUDES = st.integers(-1_800_000_000, 1_800_000_000)
INT32S = st.integers(-(2**31), 2**31 - 1)
FLOATS = st.one_of(
    st.floats(width=32, allow_nan=False, allow_infinity=False),
    st.integers(-1000, 1000).map(float),
    st.sampled_from([0.1, 20.1, 25.5, 1e-3, 16777216.0, 0.30000001192092896]).map(lambda value: f32(value)),
)
WITH_PLACE = [16, 17, 18, 19, 21, 22, 31, 82, 84, 85, 94, 189, 195, 201]
WITHOUT_PLACE = [20, 93, 112, 114, 115, 178, 181, 183, 197, 203, 205, 206, 211, 530, 1000, 2000, 2001]
YAWS = {16, 17, 21, 22, 84, 85}


def f32(value: float) -> float:
    import struct

    return struct.unpack("<f", struct.pack("<f", value))[0]


@st.composite
def placed(draw) -> Item:
    command = draw(st.sampled_from(WITH_PLACE))
    yaw = draw(st.one_of(st.just(NAN), FLOATS)) if command in YAWS else draw(FLOATS)
    return Item(
        draw(st.sampled_from([0, 3, 10])),
        command,
        0,
        draw(st.integers(0, 1)),
        *(draw(FLOATS) for _ in range(3)),
        yaw,
        draw(E7_LATITUDES),
        draw(E7_LONGITUDES),
        draw(FLOATS),
    )


@st.composite
def placeless(draw) -> Item:
    return Item(
        2,
        draw(st.sampled_from(WITHOUT_PLACE)),
        0,
        draw(st.integers(0, 1)),
        *(draw(FLOATS) for _ in range(4)),
        draw(INT32S),
        draw(INT32S),
        draw(FLOATS),
    )


@st.composite
def missions(draw) -> list[Item]:
    items = draw(st.lists(st.one_of(placed(), placeless()), min_size=1, max_size=8))
    for _ in range(draw(st.integers(0, 2))):
        target = float(draw(st.integers(0, len(items) - 1)))
        repeats = float(draw(st.integers(-1, 9)))
        items.insert(draw(st.integers(0, len(items))), Item(2, 177, 0, 1, target, repeats, 0.0, 0.0, 0, 0, 0.0))
    return items


@st.composite
def fences(draw) -> list[Item]:
    items = []
    for _ in range(draw(st.integers(0, 2))):
        corners = draw(st.integers(3, 6))
        command = draw(st.sampled_from([5001, 5002]))
        items += [
            Item(0, command, 0, 1, float(corners), 0.0, 0.0, 0.0, draw(E7_LATITUDES), draw(E7_LONGITUDES), 0.0)
            for _ in range(corners)
        ]
    for _ in range(draw(st.integers(0, 2))):
        command = draw(st.sampled_from([5003, 5004]))
        items.append(Item(0, command, 0, 1, draw(FLOATS), 0.0, 0.0, 0.0, draw(E7_LATITUDES), draw(E7_LONGITUDES), 0.0))
    if draw(st.booleans()):
        items.append(Item(3, 5000, 0, 1, 0.0, 0.0, 0.0, 0.0, draw(E7_LATITUDES), draw(E7_LONGITUDES), draw(FLOATS)))
    return items


@st.composite
def rally_points(draw) -> list[Item]:
    return [
        Item(3, 5100, 0, 1, 0.0, 0.0, 0.0, 0.0, draw(E7_LATITUDES), draw(E7_LONGITUDES), draw(FLOATS))
        for _ in range(draw(st.integers(0, 3)))
    ]


@st.composite
def homes(draw) -> Home:
    return Home(draw(E7_LATITUDES.filter(bool)), draw(E7_LONGITUDES), draw(FLOATS))


@st.composite
def plans(draw) -> Plan:
    return plan_of(draw(missions()), draw(fences()), draw(rally_points()), draw(st.one_of(st.none(), homes())))


def plan_of(mission=(), fence=(), rally=(), home=None) -> Plan:
    return Plan(Path("drawn.plan"), steps(mission), steps(fence), steps(rally), home)


def steps(items) -> list[Step]:
    return [Step(item, 1, f"item {n} ({commands.name_of(item.command)})") for n, item in enumerate(items)]


def bits(items) -> list[bytes]:
    """What two lists of items have in common if they are equal to the bit."""
    return [item.packed() for item in items]


def at(north_m: float, east_m: float = 0.0, z: float = 20.0, command: int = 16, **more) -> Item:
    """A place [m] from 0 N 0 E, where a metre is the same both ways."""
    metre = 1e7 / 111_195.08
    item = Item(3, command, 0, 1, 0.0, 0.0, 0.0, NAN, round(north_m * metre) or 1, round(east_m * metre), z)
    return item._replace(**more)
