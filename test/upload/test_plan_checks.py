"""A plan that cannot be right, or is not flown by this autopilot, is refused before its first byte leaves: on the Mega,
and as real autopilots have answered. (Each rule by itself: test/host/units/wire_plan.cpp.)"""

from __future__ import annotations

import math

import pytest

from plans import JUMP, NO_PLACE, OLD_PLAN, waypoint
from simulation import recordings
from simulation.bench import same_bits
from simulation.fake_autopilot import Item, item, mavlink
from wrong_plans import WRONG_EVERYWHERE, WRONG_ON_ONE, with_item


@pytest.mark.scenario(35, "Arguments are checked before the first byte")
def test_wrong_item_is_refused_by_its_number_and_nothing_is_sent(bench, personality):
    bench.autopilot.load(OLD_PLAN)
    wrong_here = [(status, wrong) for where, status, wrong in WRONG_ON_ONE if where == personality]
    for status, wrong in [*WRONG_EVERYWHERE, *wrong_here]:
        bench.upload(with_item(2, wrong))
        assert (bench.run_until_ended(limit_s=5), bench.state.failed_item) == (status, 2), wrong
    assert bench.mission_messages() == [] and same_bits(bench.autopilot.received(), OLD_PLAN)
    assert bench.ends == bench.ends_called_back


@pytest.mark.scenario(52, "NaN only as a yaw; what is not flown is refused by name")
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
