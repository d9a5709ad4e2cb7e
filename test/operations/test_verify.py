"""Is what is aboard the plan? The comparison knows what each autopilot rewrites, and is no looser."""

from __future__ import annotations

import math

import pytest

from downloads import WRITTEN, loaded
from plans import HOME, LAND, NO_PLACE, SPEED, SURVEY, jump, waypoint
from simulation.fake_autopilot import Item, item, mavlink
from simulation.fake_autopilot.items import f32
from simulation.recordings import readback
from simulation.service import FENCE, MISSION, RALLY, field_texts

VERIFY = pytest.mark.scenario(41, "Verify: equal, an item differs, the count differs, what autopilots rewrite")


@VERIFY
def test_plan_that_was_uploaded_verifies(service):
    service.upload(WRITTEN)
    assert service.done() == "Accepted"
    assert service.verify() == "WaitingForAutopilot"
    assert service.done() == "Verified"
    state = service.state
    assert (state.done, state.total, state.failed_item, state.field) == (8, 8, None, "None")
    assert state.aboard == "OurPlan"


@VERIFY
def test_plan_that_somebody_else_put_aboard_verifies_if_it_is_the_same(service):
    loaded(service, WRITTEN)
    assert service.state.aboard == "NotKnown"
    service.verify(WRITTEN)
    assert service.done() == "Verified"
    assert service.state.aboard == "OurPlan"


@VERIFY
def test_longer_plan_verifies(service):
    service.upload([waypoint(z=n + 1.0) for n in range(60)])
    assert service.done(limit_s=20) == "Accepted"
    service.verify()
    assert service.done(limit_s=20) == "Verified"


@VERIFY
def test_landing_far_from_any_place_verifies(service):
    """On PX4 it gets a place: that of the nearest waypoint in the plan, 45 items off, looked for while items come."""
    plan = [waypoint(z=5.0), *[item(SPEED, frame=NO_PLACE, param1=1.0, param2=3.0, param3=-1.0)] * 45, item(LAND)]
    service.upload(plan, proof="Always")
    assert service.done(limit_s=20) == "Accepted"
    service.verify()
    began = service.now
    assert service.done(limit_s=20) == "Verified"
    assert service.now - began < 5.0


# What becomes of one field, and how it is named. All are kept by both autopilots in these commands.
CHANGES = [
    ("Command", {"command": 17}),
    ("Reference", {"frame": 0}),
    ("Param1", {"param1": 4.0}),
    ("Latitude", {"x": 473979421}),
    ("Longitude", {"y": 85455969}),
    ("Height", {"z": 20.26}),
]


@VERIFY
@pytest.mark.parametrize("field, change", CHANGES, ids=[name for name, _ in CHANGES])
def test_item_that_differs_is_named_with_its_field(service, field, change):
    changed = [one._replace(**change) if index == 1 else one for index, one in enumerate(WRITTEN)]
    loaded(service, changed)
    service.verify(WRITTEN)
    assert service.done() == "Differs"
    state = service.state
    assert (state.failed_item, state.field) == (1, field)


@VERIFY
@pytest.mark.parametrize("param", [1, 2, 3])
def test_parameter_that_differs_is_named(service, param):
    changed = [one._replace(**{f"param{param}": getattr(one, f"param{param}") + 1}) if index == 2 else one
               for index, one in enumerate(WRITTEN)]  # fmt: skip
    loaded(service, changed)
    service.verify(WRITTEN)
    assert service.done() == "Differs"
    assert (service.state.failed_item, service.state.field) == (2, f"Param{param}")


@VERIFY
def test_yaw_that_differs_is_named_where_the_autopilot_keeps_it(build_service):
    service = build_service("PX4")
    loaded(service, [one._replace(param4=90.0) if index == 3 else one for index, one in enumerate(WRITTEN)])
    service.verify(WRITTEN)
    assert service.done() == "Differs"
    assert (service.state.failed_item, service.state.field) == (3, "Param4")


@VERIFY
def test_autocontinue_that_differs_is_named(build_service):
    service = build_service("PX4")
    loaded(service, [one._replace(autocontinue=0) if index == 3 else one for index, one in enumerate(WRITTEN)])
    service.verify(WRITTEN)
    assert service.done() == "Differs"
    assert (service.state.failed_item, service.state.field) == (3, "Autocontinue")


@VERIFY
def test_autocontinue_of_0_is_no_difference_where_it_always_reads_as_1(build_service):
    service = build_service("ArduPilot")
    plan = [waypoint(autocontinue=0), waypoint(), waypoint(autocontinue=0)]
    service.upload(plan, proof="Always")
    assert service.done() == "Accepted"
    loaded(service, [plan[0], plan[1]._replace(z=21.0), plan[2]])
    service.verify(plan)
    assert service.done() == "Differs"
    assert (service.state.failed_item, service.state.field) == (1, "Height")


@VERIFY
def test_jump_to_another_item_is_named(service):
    loaded(service, [jump(2, 3) if one.command == 177 else one for one in WRITTEN])
    service.verify(WRITTEN)
    assert service.done() == "Differs"
    assert (service.state.failed_item, service.state.field) == (4, "Param1")


@VERIFY
@pytest.mark.parametrize("count", [1, 7, 9])
def test_count_that_differs_is_named_and_nothing_is_read(service, count):
    loaded(service, [waypoint(z=n + 1.0) for n in range(count)])
    service.verify(WRITTEN)
    assert service.done() == "Differs"
    state = service.state
    assert (state.failed_item, state.field) == (None, "Count")
    assert service.heard("MISSION_REQUEST_INT") == []


@VERIFY
def test_no_plan_aboard_is_not_a_plan(service):
    service.verify(WRITTEN)
    assert service.done() == "Differs"
    assert service.state.field == "Count"


@VERIFY
def test_empty_plan_verifies_where_there_is_none(service, personality):
    service.verify("empty")
    assert service.done() == "Verified"
    if personality == "ArduPilot":
        service.autopilot.load([HOME])
        service.verify("empty")
        assert service.done() == "Verified"
    loaded(service, SURVEY)
    service.verify("empty")
    assert service.done() == "Differs"


@VERIFY
def test_home_is_the_autopilots_own_however_items_are_numbered(build_service):
    service = build_service("ArduPilot")
    service.tell("raw", 1)
    service.upload([HOME, *SURVEY])
    assert service.done() == "Accepted"
    service.verify()
    assert service.done() == "Verified"


@VERIFY
def test_start_is_refused_after_a_verification_that_found_another_plan(service):
    service.upload(SURVEY)
    assert service.done() == "Accepted"
    loaded(service, [*SURVEY[:-1], waypoint()])
    service.verify(SURVEY)
    assert service.done() == "Differs"
    assert service.state.aboard == "NotKnown"
    service.order_of("start")
    assert service.done() == "Unproven"
    assert service.heard("COMMAND_LONG") == []


@VERIFY
def test_what_differs_can_be_uploaded_again_by_one_call(service):
    loaded(service, [*SURVEY[:-1], waypoint()])
    service.verify(SURVEY)
    assert service.done() == "Differs"
    service.order_of("uploadagain")
    assert service.done() == "Accepted"
    service.verify()
    assert service.done() == "Verified"


@VERIFY
def test_verification_tells_the_autopilot_that_it_has_ended(service):
    loaded(service, [waypoint(z=n + 1.0) for n in range(5)])
    service.verify(SURVEY)
    assert service.done() == "Differs"
    service.run(0.1)
    assert [ack.type for ack in service.heard("MISSION_ACK")] == [mavlink.MAV_MISSION_OPERATION_CANCELLED]
    service.verify([waypoint(z=n + 1.0) for n in range(5)])
    assert service.done() == "Verified"


@VERIFY
def test_each_field_has_its_words(build_service):
    service = build_service("PX4")
    for name, text in field_texts().items():
        assert service.text_of_field(name) == text


# --- Every row of the recordings, both ways, by the comparison itself on the simulated Mega.


def rows(vehicle: str) -> list[tuple[Item, Item]]:
    """(as sent, as read back) of what that vehicle accepted, and the library sends: it refuses a NaN that is no yaw."""
    pairs = []
    for row in readback(vehicle):
        if row["result"] != "ACCEPTED" or (row["sent_p4"] == "nan" and row["name"] == "NAV_LOITER_TIME"):
            continue
        sent = made(row, "sent", int(row["command"]), 0, 1)
        read = made(row, "read", int(row["read_command"]), int(row["read_current"]), int(row["read_autocontinue"]))
        if vehicle != "px4" and sent.z != read.z:
            # Six digits are not all that was read.
            whole = f32(int(f32(sent.z * 100)) * f32(0.01))
            read = read._replace(z=whole) if f"{whole:.6g}" == f"{read.z:.6g}" else read
        pairs.append((sent, read))
    return pairs


def made(row: dict[str, str], side: str, command: int, current: int, autocontinue: int) -> Item:
    numbers = [f32(float(row[f"{side}_{name}"])) for name in ("p1", "p2", "p3", "p4")]
    return Item(int(row[f"{side}_frame"]), command, current, autocontinue, *numbers,
                int(float(row[f"{side}_x"])), int(float(row[f"{side}_y"])), f32(float(row[f"{side}_z"])))  # fmt: skip


VEHICLES = [("arducopter", "ArduPilot"), pytest.param("ardurover", "ArduPilot", marks=pytest.mark.slow), ("px4", "PX4")]


@VERIFY
@pytest.mark.parametrize("vehicle, firmware", VEHICLES)
def test_every_item_that_was_accepted_compares_equal_to_its_read_back(build_service, vehicle, firmware):
    service = build_service(firmware)
    different = []
    for sent, read in sendable(service, vehicle, firmware):
        field = service.compared(sent, read, firmware, type_of(sent))
        if field != "None":
            different.append((field, sent, read))
    assert different == []


def sendable(service, vehicle: str, firmware: str) -> list[tuple[Item, Item]]:
    """The rows whose items mean the same when they are kept: others are refused before they are sent."""
    all_rows = rows(vehicle)
    found = [(sent, read) for sent, read in all_rows if service.compared(sent, sent, firmware, type_of(sent)) == "None"]
    assert len(found) > 0.6 * len(all_rows)
    return found


def type_of(item: Item) -> int:
    return FENCE if 5000 <= item.command <= 5004 else RALLY if item.command == 5100 else MISSION


def nudged(value: float) -> float:
    return 1.0 if math.isnan(value) else value + 2.0


@pytest.mark.slow
@VERIFY
@pytest.mark.parametrize("vehicle, firmware", VEHICLES)
def test_every_field_that_changes_in_a_read_back_is_named(build_service, vehicle, firmware):
    service = build_service(firmware)
    unseen = []
    for sent, read in sendable(service, vehicle, firmware):
        for field, change in {
            "Command": {"command": read.command + 1},
            "Reference": {"frame": 10},
            "Param1": {"param1": nudged(read.param1)},
            "Param2": {"param2": nudged(read.param2)},
            "Param3": {"param3": nudged(read.param3)},
            "Param4": {"param4": nudged(read.param4)},
            "Latitude": {"x": read.x + 1},
            "Longitude": {"y": read.y - 1},
            "Height": {"z": f32(read.z + 0.02)},
            "Autocontinue": {"autocontinue": 1 - read.autocontinue},
        }.items():
            changed = read._replace(**change)
            if field == "Autocontinue" and type_of(sent) != MISSION:
                continue  # means nothing there
            seen = service.compared(sent, changed, firmware, type_of(sent))
            # A value that was dropped is allowed to come back as it was sent.
            if seen != field and not changed.same_as(sent._replace(current=read.current)):
                name = {"Height": "z", "Latitude": "x", "Longitude": "y"}.get(field, field.lower())
                if field.startswith("Param") and getattr(changed, name) == getattr(sent, name):
                    continue
                unseen.append((field, seen, sent, changed))
    assert unseen == []


@VERIFY
@pytest.mark.parametrize("vehicle, firmware", VEHICLES)
def test_no_read_back_is_taken_for_another_row_of_the_same_command(build_service, vehicle, firmware):
    """A looser comparison would: what was sent twice with different numbers must stay apart."""
    service = build_service(firmware)
    pairs = rows(vehicle)
    confused = []
    for sent, _ in pairs:
        mine = [read for other, read in pairs if other == sent][:1]
        for other, read in pairs:
            if other.command != sent.command or any(read.same_as(one) for one in mine):
                continue
            if service.compared(sent, read, firmware, type_of(sent)) == "None" and not equivalent(sent, read, pairs):
                confused.append((sent, read))
    assert confused == []


def equivalent(sent: Item, read: Item, pairs) -> bool:
    """Two items that the autopilot itself makes the same."""
    return any(one.same_as(read) for other, one in pairs if other.same_as(sent))


@VERIFY
@pytest.mark.parametrize("height", [0.1, 1.005, 8.35, 16.1, 20.125, 33.33, 127.99, 333.33, 600.126, 4095.99, -12.345])
def test_heights_verify_as_ardupilot_cuts_them(build_service, height):
    service = build_service("ArduPilot")
    service.upload([waypoint(z=f32(height)), waypoint(z=f32(height + 0.009))], proof="Always")
    assert service.done() == "Accepted"


@VERIFY
@pytest.mark.parametrize("height, other", [(20.0, 20.01), (20.0, 19.99), (100.5, 100.49), (0.0, 0.01), (-5.0, 5.0)])
def test_heights_a_centimetre_apart_differ(service, height, other):
    loaded(service, [waypoint(z=f32(other))])
    service.verify([waypoint(z=f32(height))])
    assert service.done() == "Differs"
    assert service.state.field == "Height"


@VERIFY
def test_every_recorded_item_verifies_in_a_plan(make_service, personality):
    """In plans of 20: what a plan may hold, as one would write it."""
    service = make_service()
    vehicle = {"ArduPilot": "arducopter", "PX4": "px4"}[personality]
    items = [sent for sent, _ in rows(vehicle) if sent.command not in (177, 5000, 5001, 5002, 5003, 5004, 5100)]
    verified = 0
    for at in range(0, len(items), 20):
        service.upload([waypoint(z=5.0), *items[at : at + 20]])
        status = service.done(limit_s=20)
        if status == "Accepted":
            verified += 1
            service.verify()
            assert service.done(limit_s=20) == "Verified", (service.state, items[at + service.state.failed_item - 1])
    assert verified > 0
