"""Is what is aboard the plan? The comparison knows what each autopilot rewrites, and is no looser."""

from __future__ import annotations

import pytest

from downloads import WRITTEN, loaded
from plans import HOME, SURVEY, waypoint
from simulation.fake_autopilot import Item, mavlink
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
@pytest.mark.parametrize("count", [1, 7, 9])
def test_count_that_differs_is_named_and_nothing_is_read(service, count):
    loaded(service, [waypoint(z=n + 1.0) for n in range(count)])
    service.verify(WRITTEN)
    assert service.done() == "Differs"
    state = service.state
    assert (state.failed_item, state.field) == (None, "Count")
    assert service.heard("MISSION_REQUEST_INT") == []


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
