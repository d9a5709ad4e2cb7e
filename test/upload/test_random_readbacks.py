"""Every random item of the recordings through the library's own upload(plan, Readback::Always), on this computer.

Each comes aboard and verifies, because what the autopilot keeps of it means the same; or it is refused before
MISSION_COUNT, naming the item and the field. And of each item that came aboard every field, altered by its smallest
step, is seen: by a bit of a float, by 1 of an integer. Passed over is only what was sent: a field that one version
drops may come back as it was written from another one.

The autopilot answers as the row says. Where the library sends another item than the row's (it numbers jumps, chooses
the frame of what has no place, finds one for a landing), and for the waypoints around it, the fake autopilots answer,
which keep every row as the real ones did (test_fake_readbacks.py). A fence of one item that was accepted, and then not
there, is answered as it is when it is sent again.
"""

from __future__ import annotations

import functools
import itertools
import math
from collections import Counter

import pytest

from readbacks import ACCEPTED, Row, kept, rows
from replayed import End, replay
from simulation.fake_autopilot import MISSION, RALLY, Item, item, mavlink
from simulation.fake_autopilot.items import f32

# The recording: HEARTBEAT.autopilot and .type.
VEHICLES = {
    "arducopter": (mavlink.MAV_AUTOPILOT_ARDUPILOTMEGA, mavlink.MAV_TYPE_QUADROTOR),
    "ardurover": (mavlink.MAV_AUTOPILOT_ARDUPILOTMEGA, mavlink.MAV_TYPE_GROUND_ROVER),
    "arduplane": (mavlink.MAV_AUTOPILOT_ARDUPILOTMEGA, mavlink.MAV_TYPE_FIXED_WING),
    "px4": (mavlink.MAV_AUTOPILOT_PX4, mavlink.MAV_TYPE_QUADROTOR),
}
JUMP = mavlink.MAV_CMD_DO_JUMP
REFUSALS = {"BadLatitude", "BadLongitude", "BadAltitude", "BadFrame", "BadJump", "NeedsCoordinates", "NotANumber",
            "NotFlown", "NotKept"}  # fmt: skip
FIRST_FIELD = 4  # of Field: param1

WAYPOINT = item(mavlink.MAV_CMD_NAV_WAYPOINT, frame=3, x=-353632170, y=1491652720, z=20.0)


def plan_of(group: list[Row], recording: str, raw: bool) -> list[Item]:
    """What a sketch would upload. The row's item stands between two waypoints; ArduPilot has a home before them."""
    if group[0].mission_type != MISSION:
        return [row.sent for row in group]
    (row,) = group
    plan = [WAYPOINT, row.sent, WAYPOINT]
    if recording == "px4":
        return plan
    if raw:
        return [WAYPOINT, *plan]
    if row.sent.command == JUMP:  # as the sketch counts
        plan[1] = row.sent._replace(param1=f32(row.sent.param1 - 1))
    return plan


def answer_to(group: list[Row], recording: str, sent: Item) -> tuple[int, Item | None]:
    for row in group:
        if sent.same_as(row.sent) and row.mission_type == MISSION and (row.result != ACCEPTED or row.read is not None):
            return row.result, row.read
    return kept(recording, group[0].mission_type, sent)


@functools.cache
def ends(recording: str, raw: bool = False) -> list[tuple[list[Row], End]]:
    groups = [list(group) for _, group in itertools.groupby(rows(recording), key=lambda row: row.plan)]
    plans = (
        (*VEHICLES[recording], group[0].mission_type, raw, plan_of(group, recording, raw),
         functools.partial(answer_to, group, recording))
        for group in groups
    )  # fmt: skip
    return list(zip(groups, replay(plans), strict=True))


BOTH_NUMBERINGS = pytest.mark.parametrize("raw", [False, True], ids=["", "raw"])
EACH = pytest.mark.parametrize("recording", VEHICLES)


@pytest.mark.slow
@EACH
@BOTH_NUMBERINGS
def test_each_item_verifies_or_is_refused_before_count_by_its_own_status(recording, raw):
    found = ends(recording, raw)
    tally = Counter()
    for group, end in found:
        tally[end.status] += len(group)
    print(f"\n{recording}: {tally['Accepted']} of {len(rows(recording))} rows came aboard and verified")
    for status, count in sorted(tally.items()):
        if status != "Accepted":
            print(f"  {count} refused: {status}")
    # A fence whose corners do not add up is refused by ArduPilot, as a whole; everything else is foreseen.
    unforeseen = [(group, end) for group, end in found if end.status not in {"Accepted", *REFUSALS}]
    assert unforeseen == []
    assert tally["Accepted"] > 900
    for group, end in found:
        if end.status != "Accepted":
            assert end.sent == [], (group, end)
            # Numbered as the plan is, where home is the autopilot's own.
            expected = 2 if raw and recording != "px4" else 1
            assert end.failed_item is not None and (group[0].mission_type != MISSION or end.failed_item == expected)
            assert (end.status == "NotKept") == (end.field >= FIRST_FIELD), (group, end)


@pytest.mark.slow
@EACH
def test_what_came_aboard_means_what_was_sent(recording):
    """Told by the rows alone: each field is kept, or dropped, or one of the rewritings of docs/readback.md."""
    for group, end in ends(recording):
        if end.status != "Accepted":
            continue
        for row in group:
            if row.read is None:
                continue
            for name, sent, read in zip(Item._fields[4:], row.sent[4:], row.read[4:], strict=True):
                if read != sent and not (math.isnan(sent) and math.isnan(read)):
                    assert is_passed_over(recording, row, name, sent, read), (name, row)


@functools.cache
def dropped(recording: str) -> frozenset[tuple[int, int, str]]:
    """(plan type, command, field) that this vehicle always gives back as 0."""
    kept_some, seen = set(), set()
    for row in rows(recording):
        if row.read is not None:
            for name, read in zip(Item._fields[4:], row.read[4:], strict=True):
                place = 2 if recording == "px4" and row.sent.frame == 2 else 0
                seen.add((row.mission_type, row.sent.command + place * 65536, name))
                if read != 0:
                    kept_some.add((row.mission_type, row.sent.command + place * 65536, name))
    return frozenset(seen - kept_some)


def is_passed_over(recording: str, row: Row, name: str, sent: float, read: float) -> bool:
    command, is_px4 = row.sent.command, recording == "px4"
    place = 2 if is_px4 and row.sent.frame == 2 else 0
    if (row.mission_type, command + place * 65536, name) in dropped(recording):
        return True
    in_centimetres = abs(read) <= abs(sent) and abs(sent - read) < 0.0101
    turned = read == (-1 if sent < 0 else 1) and (recording != "arduplane" or sent == 0)
    if is_px4:
        return {
            "param2": command == JUMP and (sent, read) == (-1, 65535),
            "param4": -180 <= sent <= 360 and math.isclose(read % 360, sent % 360, abs_tol=4e-5),
            "x": command == mavlink.MAV_CMD_DO_LAND_START and read == int(f32(sent)),
            "y": command == mavlink.MAV_CMD_DO_LAND_START and read == int(f32(sent)),
        }.get(name, False)
    return {
        "param1": command == mavlink.MAV_CMD_NAV_PAYLOAD_PLACE and in_centimetres,
        "param3": (command == 223 and in_centimetres) or (command == mavlink.MAV_CMD_NAV_LOITER_TIME and turned),
        "param4": command == mavlink.MAV_CMD_NAV_LAND and turned,
        "z": in_centimetres or command == mavlink.MAV_CMD_DO_MOUNT_CONTROL,
    }.get(name, False)


@EACH
@BOTH_NUMBERINGS
def test_each_field_of_what_came_aboard_is_seen_when_it_is_altered_by_its_smallest_step(recording, raw):
    passed = []
    accepted = 0
    for group, end in ends(recording, raw):
        accepted += end.status == "Accepted"
        sent = plan_of(group, recording, raw)
        before = 1 if recording != "px4" and not raw and group[0].mission_type == MISSION else 0
        for index, name, altered in end.passed:
            was = as_sent(sent[index - before], name, recording, before)
            now = getattr(altered, name)
            if name == "autocontinue" and group[0].mission_type != MISSION:
                continue  # a fence and a rally point have none
            if now != was:
                passed.append((name, sent[index - before], altered))
    assert passed == []
    assert accepted > 500


def as_sent(item: Item, name: str, recording: str, before: int) -> float:
    value = getattr(item, name)
    if name == "frame":
        return {5: 0, 6: 3, 11: 10}.get(value, value)
    return value


@EACH
def test_what_the_autopilot_would_make_of_a_refused_value_is_told_where_it_is_known(recording):
    told = unknown = 0
    for group, end in ends(recording):
        if end.status != "NotKept" or len(group) > 1 or group[0].result != ACCEPTED or group[0].read is None:
            continue
        (row,) = group
        sent, read = row.sent[end.field], row.read[end.field]
        if recording == "px4" and row.sent.frame != 2 and end.field >= FIRST_FIELD + 4:
            continue  # it would go out without a place, and the row had one
        if math.isnan(end.kept_value):
            # A negative number for an unsigned one and one beyond 2^31 depend on the board; a heading beyond a turn.
            assert sent < 0 or f32(abs(sent)) >= 2**31 or (recording == "px4" and abs(sent) > 180), (row, end)
            unknown += 1
        else:
            assert f32(end.kept_value) == f32(read), (row, end)
            assert f32(end.kept_value) != sent, (row, end)
            told += 1
    print(f"\n{recording}: told of {told} values, not known of {unknown}")
    assert told > 300


@EACH
def test_numbers_whose_meaning_depends_on_the_board_are_refused(recording):
    """What a float below 0 becomes where it is kept unsigned, and one beyond 2^31 where it is kept as an integer."""
    refused = 0
    for group, end in ends(recording):
        for row in group:
            if row.read is None or row.mission_type != MISSION:
                continue
            for name, sent, read in zip(Item._fields[4:8], row.sent[4:8], row.read[4:8], strict=True):
                is_for_ever = row.sent.command == JUMP and recording == "px4" and sent == -1
                wraps = sent <= -1 and read > 0 and name != "param4" and not is_for_ever
                is_beyond = abs(sent) >= 2**31 and read not in (0, sent)
                if wraps or is_beyond:
                    assert end.status in REFUSALS, (row, end)
                    refused += 1
    assert refused > 0


def test_a_command_that_is_in_no_recording_goes_out():
    unknown = item(31337, frame=3, x=1, y=2, z=3.0, param1=1.5)
    plans = (
        (*vehicle, MISSION, False, [WAYPOINT, unknown, WAYPOINT], lambda sent: (ACCEPTED, sent))
        for vehicle in VEHICLES.values()
    )
    for end in replay(plans):
        assert end.status == "Accepted"
        assert [sent.command for sent in end.sent].count(31337) <= 1


def test_commands_that_one_vehicle_refused_are_not_flown_there():
    taken = {name: {row.sent.command for row in rows(name) if row.mission_type == MISSION} for name in VEHICLES}
    commands = sorted(set().union(*taken.values()) - {mavlink.MAV_CMD_NAV_FENCE_RETURN_POINT})
    for name, vehicle in VEHICLES.items():
        plans = ((*vehicle, MISSION, False, [WAYPOINT, item(command, frame=3, x=1, y=2, z=3.0), WAYPOINT],
                  lambda sent: (ACCEPTED, sent)) for command in commands)  # fmt: skip
        for command, end in zip(commands, replay(plans), strict=True):
            assert (end.status == "NotFlown") == (command not in taken[name]), (name, command, end.status)


def test_rally_points_at_the_origin_are_refused_where_they_could_not_be_read():
    for recording in ("arducopter", "ardurover", "arduplane"):
        lost = [(group, end) for group, end in ends(recording)
                if (group[0].mission_type, group[0].result, group[0].read) == (RALLY, ACCEPTED, None)]  # fmt: skip
        assert len(lost) > 3
        assert {end.status for _, end in lost} <= {"NeedsCoordinates", "NotANumber"}
