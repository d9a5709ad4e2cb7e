"""A plan that cannot be right, or is not flown by this autopilot, is refused before its first byte leaves."""

from __future__ import annotations

import math

import pytest

from plans import (
    DELAY,
    HOME,
    JUMP,
    NAN,
    NO_PLACE,
    OLD_PLAN,
    RETURN,
    SPEED,
    SURVEY,
    jump,
    on_the_wire,
    smooth_steps,
    steps,
    waypoint,
)
from simulation import recordings
from simulation.bench import FunctionPlan, aboard_names, is_end, same_bits, status_names
from simulation.enumerators import texts_of
from simulation.fake_autopilot import Item, item, mavlink
from wrong_plans import WRONG_EVERYWHERE, WRONG_ON_ONE, with_item

ARGUMENTS = pytest.mark.scenario(35, "Arguments are checked before the first byte")


def expect_refused(bench, plan, status: str, failed_item: int | None) -> None:
    """It says so at once, nothing has left, and what is aboard stays."""
    bench.autopilot.load(OLD_PLAN)
    bench.upload(plan)
    assert bench.run_until_ended(limit_s=5) == status
    bench.run(0.2)
    state = bench.state
    assert (state.status, state.failed_item, state.busy, state.done) == (status, failed_item, False, 0)
    assert bench.mission_messages() == []
    assert same_bits(bench.autopilot.received(), OLD_PLAN)
    assert bench.ends == bench.ends_called_back == [status]


@ARGUMENTS
@pytest.mark.parametrize(
    ("status", "wrong"), WRONG_EVERYWHERE, ids=lambda value: value if isinstance(value, str) else ""
)
def test_wrong_item_is_refused_by_its_number(bench, status, wrong):
    expect_refused(bench, with_item(2, wrong), status, 2)


@ARGUMENTS
@pytest.mark.parametrize("index", [0, 4])
def test_wrong_item_is_found_at_either_end_of_the_plan(bench, index):
    expect_refused(bench, with_item(index, waypoint(x=900000001)), "BadLatitude", index)


@ARGUMENTS
@pytest.mark.parametrize(
    ("personality", "status", "wrong"), WRONG_ON_ONE, ids=lambda value: value if isinstance(value, str) else ""
)
def test_item_that_one_autopilot_does_not_take_is_refused_for_it(build_bench, personality, status, wrong):
    expect_refused(build_bench(personality), with_item(3, wrong), status, 3)


@ARGUMENTS
@pytest.mark.parametrize("count", [65536, 100000, 2**32 - 1])
def test_more_items_than_the_protocol_can_count_are_too_many(bench, count):
    assert bench.upload(FunctionPlan(count)) == "TooManyItems"
    assert bench.run_until_ended(limit_s=1) == "TooManyItems"
    bench.run(3)
    assert bench.mission_messages() == []


@ARGUMENTS
def test_refused_plan_does_not_bar_the_next_one(bench, personality):
    bench.upload(with_item(1, waypoint(z=NAN)))
    assert bench.run_until_ended(limit_s=5) == "NotANumber"
    bench.upload(SURVEY)
    assert bench.run_until_ended(limit_s=5) == "Accepted"
    assert bench.state.failed_item is None
    assert same_bits(bench.autopilot.received(), on_the_wire(SURVEY, personality))


YAW = pytest.mark.scenario(52, "NaN only as a yaw; what is not flown is refused by name")


@YAW
@pytest.mark.parametrize("vehicle", ["arducopter", "ardurover", "px4"])
def test_recorded_answer_to_each_command_is_foreseen(build_bench, vehicle):
    """Everything that a real autopilot refused is refused before COUNT; what it took comes aboard."""
    personality, kind = {"arducopter": ("ArduPilot", "copter"), "ardurover": ("ArduPilot", "rover"),
                         "px4": ("PX4", "copter")}[vehicle]  # fmt: skip
    rows = [row for row in recordings.readback(vehicle) if not row["name"].startswith("type")]  # fence and rally
    taken = {row["command"] for row in rows if row["result"] == "ACCEPTED"}
    bench = build_bench(personality, vehicle=kind)
    wrong = []
    for row in rows:
        recorded = as_sent(row)
        counts = len(bench.heard("MISSION_COUNT"))
        plan = [waypoint(), recorded._replace(param1=0.0) if recorded.command == JUMP else recorded]
        if recorded.command == mavlink.MAV_CMD_DO_JUMP_TAG:  # ArduPilot takes it without the tag, too
            plan.append(item(mavlink.MAV_CMD_JUMP_TAG, frame=NO_PLACE, param1=recorded.param1))
        bench.upload(plan)
        status = bench.run_until_ended(limit_s=5)
        asked = len(bench.heard("MISSION_COUNT")) > counts
        if row["command"] not in taken:
            right = status == "NotFlown" and not asked and bench.state.failed_item == 1
        elif status == "NotKept":
            right = not asked and bench.state.failed_item == 1 and is_changed(row)
        elif row["result"] == "ACCEPTED" and not has_nan_beside_a_yaw(recorded):
            right = status == "Accepted"
        else:
            right = status == "Accepted" or not asked
        if not right:
            wrong.append((row["command"], row["name"], row["sent_frame"], row["result"], status))
    assert wrong == []
    assert len(rows) > 100


def as_sent(row: dict[str, str]) -> Item:
    return Item(
        int(row["sent_frame"]), int(row["command"]), 0, 1,
        *(float(row[f"sent_p{number}"]) for number in (1, 2, 3, 4)),
        int(row["sent_x"]), int(row["sent_y"]), float(row["sent_z"]),
    )  # fmt: skip


def is_changed(row: dict[str, str]) -> bool:
    """Something of it is kept, and is another value."""
    if row["result"] != "ACCEPTED":
        return True
    pairs = [
        (float(row[f"sent_{name}"]), float(row[f"read_{name}"])) for name in ("p1", "p2", "p3", "p4", "x", "y", "z")
    ]
    return any(sent != read and not math.isnan(sent) for sent, read in pairs)


def has_nan_beside_a_yaw(one: Item) -> bool:
    """A NaN where MAV_CMD's table has no yaw that may be unset."""
    beside = (one.param1, one.param2, one.param3, one.z)
    return any(map(math.isnan, beside)) or (math.isnan(one.param4) and one.command not in (16, 17, 21, 22, 84, 85))


NO_PLACES = pytest.mark.scenario(52, "Items without a place go out in the frame that is taken")


@NO_PLACES
@pytest.mark.parametrize("frame", [0, 2, 3, 5, 6])
def test_item_without_a_place_is_sent_in_the_mission_frame(bench, frame):
    plan = [waypoint(), item(SPEED, frame=frame, param1=1.0, param2=5.0, param3=-1.0),
            item(DELAY, frame=frame, param1=3.0, param2=-1.0, param3=-1.0, param4=-1.0),
            item(RETURN, frame=frame)]  # fmt: skip
    bench.upload(plan)
    assert bench.run_until_ended(limit_s=5) == "Accepted"
    assert same_bits(bench.autopilot.received()[-3:], [one._replace(frame=NO_PLACE) for one in plan[1:]])


HOME_SLOT = pytest.mark.scenario(40, "ArduPilot's home slot and the sketch's own numbering")


@HOME_SLOT
@pytest.mark.parametrize("before", [[], OLD_PLAN], ids=["no plan before", "a plan before"])
def test_same_plan_means_the_same_flight_on_both(bench, personality, before):
    bench.autopilot.load(before)
    bench.upload(SURVEY)
    assert bench.run_until_ended(limit_s=5) == "Accepted"
    flown = bench.autopilot.received()
    if personality == "ArduPilot":
        assert same_bits(flown[:1], [HOME])
        assert bench.autopilot.plan()[0] == bench.autopilot.home_item()
        flown = flown[1:]
    assert same_bits(flown, SURVEY)
    assert bench.state.total == len(SURVEY)


@HOME_SLOT
@pytest.mark.parametrize("wire_item", [0, 1, 3, 5])
def test_failed_item_is_the_sketchs_number(bench, personality, wire_item):
    bench.autopilot.faults.refuse(mavlink.MAV_MISSION_INVALID_PARAM7, step=wire_item)
    bench.upload([waypoint() for _ in range(8)])
    assert bench.run_until_ended(limit_s=5) == "InvalidParam7"
    home_items = 1 if personality == "ArduPilot" else 0
    expected = wire_item - home_items if wire_item >= home_items else None
    assert bench.state.failed_item == expected


RAW = pytest.mark.scenario(40, "Raw numbering")


@RAW
def test_raw_numbers_go_out_as_they_are(bench):
    bench.tell("raw", 1)
    plan = [waypoint(z=1.0), waypoint(z=2.0), jump(1), item(SPEED, frame=NO_PLACE, param1=1.0, param2=4.0, param3=-1.0)]
    bench.upload(plan)
    assert bench.run_until_ended(limit_s=5) == "Accepted"
    assert same_bits(bench.autopilot.received(), plan)
    assert steps(bench) == smooth_steps(4)
    assert bench.state.total == 4


ARMED = pytest.mark.scenario(48, "Upload while armed")


@ARMED
def test_upload_while_armed_is_refused_unless_the_sketch_allows_it(make_bench, personality):
    bench = make_bench(armed=True)
    expect_refused(bench, SURVEY, "Armed", None)
    assert bench.state.armed
    bench.tell("armed", 1)
    bench.upload()
    assert bench.run_until_ended(limit_s=5) == "Accepted"
    assert same_bits(bench.autopilot.received(), on_the_wire(SURVEY, personality))


def test_every_status_and_aboard_has_its_text(line):
    for word, names, texts in (("text", status_names(), texts_of("Status.h", "MAVMISSION_STATUSES")),
                               ("aboard", aboard_names(), texts_of("Status.h", "MAVMISSION_ABOARD"))):  # fmt: skip
        assert len(names) == len(texts)
        for number, name in enumerate(names):
            (answer,) = line.tell(word, number)
            assert answer.split(" ", 3)[3] == texts[name]
        (answer,) = line.tell(word, len(names))
        assert answer.split(" ")[3:] == [""]
    assert is_end("Accepted") and not is_end("Transferring")
