"""Reading, verifying, clearing and finding plans on the firmware: one conversation of each, and what needs an AVR."""

from __future__ import annotations

import pytest

from areas import FIELD, POINTS
from downloads import WRITTEN, loaded, same
from plans import OLD_PLAN, SURVEY
from simulation.bench import FunctionPlan, item_of_function_plan
from simulation.fake_autopilot import Item, mavlink
from simulation.fake_autopilot.items import f32
from simulation.recordings import readback
from simulation.service import ALL, FENCE, HOME_INDEX, MISSION, RALLY, field_texts

LISTS = pytest.mark.scenario(42, "REQUEST_LIST or its answer is lost")
ITEMS = pytest.mark.scenario(43, "An item or its request is lost")
CLOSES = pytest.mark.scenario(44, "Our final ACK is lost, and the next operation still works")


@pytest.mark.parametrize("direction, name", [
    pytest.param(">", "MISSION_REQUEST_LIST", marks=LISTS), pytest.param("<", "MISSION_COUNT", marks=LISTS),
    pytest.param(">", "MISSION_REQUEST_INT", marks=ITEMS), pytest.param("<", "MISSION_ITEM_INT", marks=ITEMS),
    pytest.param(">", "MISSION_ACK", marks=CLOSES),
])  # fmt: skip
def test_plan_is_read_and_cleared_whatever_is_lost_once(service, personality, direction, name):
    loaded(service, WRITTEN)
    service.wire.lose(direction, name=name)
    service.download()
    assert service.done() == "Downloaded"
    assert service.sunk == [HOME_INDEX] * (personality == "ArduPilot") + list(range(8))
    assert same(service.sink(8), WRITTEN)
    service.order_of("clear", MISSION)
    assert service.done() == "Cleared" and service.autopilot.plan() == []


def test_items_that_come_as_floats_are_made_integers(service):
    """Of 24 bits, which the AVR does without arithmetic of floats."""
    loaded(service, SURVEY)
    push = service.autopilot._push

    def as_float(time, message) -> None:
        if not isinstance(message, bytes) and message.get_type() == "MISSION_ITEM_INT":
            words = message.to_dict()
            del words["mavpackettype"]
            divisor = 1 if message.frame == 2 else 1e7
            message = mavlink.MAVLink_mission_item_message(**{**words, "x": words["x"] / divisor,
                                                              "y": words["y"] / divisor})  # fmt: skip
        push(time, message)

    service.autopilot._push = as_float
    service.download()
    assert service.done() == "Downloaded"
    for read, meant in zip(service.sink(5), SURVEY, strict=True):
        assert abs(read.x - meant.x) < 25 and abs(read.y - meant.y) < 10
        assert (read.command, read.z) == (meant.command, meant.z)


@pytest.mark.scenario(45, "Clear: of all types, the first ACK kept back")
def test_all_three_plans_are_cleared_though_an_answer_does_not_come(service):
    for mission_type, plan in ((MISSION, OLD_PLAN), (FENCE, FIELD), (RALLY, POINTS)):
        service.autopilot.load(plan, mission_type)
    service.autopilot.faults.keep_back("MISSION_ACK", times=1)
    service.order_of("clear", ALL)
    assert service.done() == "Cleared"
    assert [service.autopilot.plan(mission_type) for mission_type in (MISSION, FENCE, RALLY)] == [[], [], []]
    first, second, *_ = service.sent_at("MISSION_CLEAR_ALL")
    assert second - first == pytest.approx(1.5, abs=0.01)
    state = service.state
    assert (state.aboard, state.aboard_fence, state.aboard_rally) == ("Nothing",) * 3


@pytest.mark.scenario(45, "Clear: PX4 is busy with another station", "PX4")
def test_px4_that_is_busy_is_asked_to_clear_until_it_is_free(build_service):
    service = build_service("PX4")
    service.autopilot.load(OLD_PLAN)
    service.run(2.0)
    station = mavlink.MAVLink(None, 255, 190)
    service.autopilot.receive(mavlink.MAVLink_mission_count_message(1, 1, 3, 0).pack(station), service.now)
    service.order_of("clear", MISSION)
    assert service.done(limit_s=12) == "Cleared"
    assert len(service.heard("MISSION_CLEAR_ALL")) > 1


@pytest.mark.scenario(56, "A plan is put aboard only if it is not there already")
@pytest.mark.parametrize("count", [10, 600])
def test_px4_is_asked_for_its_checksum_alone_whatever_the_length(build_bench, count):
    """The goal is 0.3 s from REQUEST_LIST to the status."""
    bench = build_bench("PX4", defines={"BENCH_ENSURE": 1})
    bench.autopilot.load([item_of_function_plan(index) for index in range(count)])
    bench.ensure(FunctionPlan(count))
    assert bench.run_until_ended(limit_s=30) == "AlreadyAboard"
    (asked_s,) = bench.sent_at("MISSION_REQUEST_LIST")
    ended_s = next(event.ms for event in bench.events if event.word == "end") / 1000
    print(f"PX4, {count} items: {1000 * (ended_s - asked_s):.0f} ms from REQUEST_LIST to the status")
    assert ended_s - asked_s < 0.3
    assert bench.heard("MISSION_REQUEST_INT", "MISSION_COUNT", "MISSION_ITEM_INT") == []


VERIFY = pytest.mark.scenario(41, "Verify: equal, an item differs, what autopilots rewrite")


@VERIFY
def test_item_that_differs_is_named_with_its_field_and_start_is_refused(service):
    service.upload(SURVEY)
    assert service.done() == "Accepted"
    loaded(service, [*SURVEY[:3], SURVEY[3]._replace(y=85459971), SURVEY[4]])
    service.verify(SURVEY)
    assert service.done() == "Differs"
    assert (service.state.failed_item, service.state.field, service.state.aboard) == (3, "Longitude", "NotKnown")
    service.order_of("start")
    assert service.done() == "Unproven" and service.heard("COMMAND_LONG") == []


@VERIFY
def test_each_field_has_its_words(build_service):
    service = build_service("PX4")
    for name, text in field_texts().items():
        assert service.text_of_field(name) == text


# -- Every row of the recordings, by the comparison itself on the simulated Mega.


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


def type_of(item: Item) -> int:
    return FENCE if 5000 <= item.command <= 5004 else RALLY if item.command == 5100 else MISSION


@VERIFY
@pytest.mark.parametrize("vehicle, firmware", [("arducopter", "ArduPilot"), ("px4", "PX4")])
def test_every_item_that_was_accepted_compares_equal_to_its_read_back(build_service, vehicle, firmware):
    """Of those whose items mean the same when they are kept: others are refused before they are sent."""
    service = build_service(firmware)

    def field(one: Item, other: Item) -> str:
        return service.compared(one, other, firmware, type_of(one))

    all_rows = rows(vehicle)
    sendable = [(sent, read) for sent, read in all_rows if field(sent, sent) == "None"]
    assert len(sendable) > 0.6 * len(all_rows)
    assert [(sent, read) for sent, read in sendable if field(sent, read) != "None"] == []
