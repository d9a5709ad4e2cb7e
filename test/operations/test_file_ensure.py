"""PlanFiles.ensure(): ArduPilot's plan is looked at as a file, and replaced by one only where it is another plan."""

from __future__ import annotations

import pytest

from disorders import latency_of
from downloads import loaded
from files import by_items, is_by_file, open_file, other_opens, requests, with_files
from plans import OLD_PLAN, on_the_wire, waypoint
from simulation.bench import same_bits
from simulation.fake_autopilot import mavlink
from simulation.fake_autopilot.ftp import BURST, CREATE, OPEN_RO, READ, TERMINATE, WRITE
from simulation.service import MISSION
from simulation.wire import Wire

ENSURED = pytest.mark.scenario(65, "A plan is looked for as a file, and uploaded only where it is not aboard")
LIMIT_S = 30
LONG = [waypoint(x=470000000 + 7 * n, z=n + 1.0) for n in range(20)]
LOOK = [OPEN_RO, READ, BURST, TERMINATE]


def ensuring(service, plan=None, mission_type=MISSION) -> str:
    if plan is not None:
        service.use(plan)
    return service.order_of("fileensure", mission_type)


@ENSURED
def test_plan_that_is_aboard_is_read_as_a_file_and_nothing_else(build_service):
    service = with_files(build_service)
    loaded(service, LONG)
    assert ensuring(service, LONG) == "WaitingForAutopilot"
    assert service.done(LIMIT_S) == "AlreadyAboard"
    assert requests(service) == LOOK and by_items(service) == []
    state = service.state
    assert (state.aboard, state.done, state.total, state.failed_item) == ("OurPlan", 20, 20, None)
    assert is_by_file(service)
    assert open_file(service) is None


@ENSURED
@pytest.mark.parametrize("aboard", [OLD_PLAN, [*LONG, LONG[0]], [*LONG[:11], waypoint(z=99.0), *LONG[12:]], []],
                         ids=["other", "longer", "one item", "none"])  # fmt: skip
def test_other_plan_is_replaced_by_a_file(build_service, aboard):
    service = with_files(build_service)
    loaded(service, aboard)
    ensuring(service, LONG)
    assert service.done(LIMIT_S) == "Accepted"
    asked = requests(service)
    assert asked.index(OPEN_RO) < asked.index(CREATE) and asked[-4:] == LOOK
    assert WRITE in asked and by_items(service) == []
    assert same_bits(service.autopilot.received()[1:], on_the_wire(LONG, "ArduPilot")[1:])
    state = service.state
    assert (state.aboard, state.failed_item, state.field) == ("OurPlan", None, "None")


@ENSURED
@pytest.mark.parametrize("is_allowed", [False, True])
def test_armed_autopilot_keeps_the_plan_that_it_has(build_service, is_allowed):
    service = with_files(build_service, armed=True)
    service.tell("armed", is_allowed)
    for aboard, ends in ((OLD_PLAN, "Armed"), (on_the_wire(LONG, "ArduPilot"), "AlreadyAboard")):
        service.autopilot.load(aboard)
        ensuring(service, LONG)
        assert service.done(LIMIT_S) == ends
        assert same_bits(service.autopilot.received(), aboard)
        assert service.state.aboard == ("OurPlan" if ends == "AlreadyAboard" else "NotKnown")
    assert "MISSION_COUNT" not in by_items(service)


@ENSURED
@pytest.mark.parametrize("is_allowed", [False, True])
def test_autopilot_that_is_armed_while_the_file_is_written_keeps_its_plan(build_service, is_allowed):
    service = with_files(build_service)
    service.autopilot.load(OLD_PLAN)
    service.tell("armed", is_allowed)
    service.run(0.8)
    ensuring(service, LONG)
    while CREATE not in requests(service):
        service.run(0.001)
    service.autopilot.armed = True
    service.say(mavlink.MAVLink_heartbeat_message(2, 3, 128 | 81, 0, 4, 3))
    assert service.done(LIMIT_S) == "Armed"
    assert by_items(service) == []
    service.run(3.0)
    assert same_bits(service.autopilot.received(), OLD_PLAN)
    assert open_file(service) is None


@ENSURED
@pytest.mark.parametrize("is_there", [True, False], ids=["there", "other"])
@pytest.mark.parametrize("case", ["PX4", "MAVLink 1", "switched off", "held by another", "lossy"])
def test_without_a_file_the_look_is_that_of_the_client(build_service, case, is_there):
    personality = "PX4" if case == "PX4" else "ArduPilot"
    options = {"MAVLink 1": {"mavlink_version": 1}, "switched off": {"ftp": False}}.get(case, {})
    service = with_files(build_service, personality, **options)
    loaded(service, LONG if is_there else OLD_PLAN)
    service.run(1.0)
    if case == "held by another":
        other_opens(service)
    if case == "lossy":
        service.say_bytes(b"\x55" * 5)
    ensuring(service, LONG)
    assert service.done(LIMIT_S) == ("AlreadyAboard" if is_there else "Accepted")
    assert service.state.aboard == "OurPlan"
    assert not is_by_file(service)
    asked = by_items(service)
    assert asked[0] == "MISSION_REQUEST_LIST"
    assert not (case == "PX4" and is_there and len(asked) > 1), "PX4 is asked for its checksum alone"


@ENSURED
@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("is_there", [True, False], ids=["there", "other"])
def test_what_it_says_is_true_on_a_bad_line(build_service, seed, is_there):
    service = with_files(build_service, wire=Wire(seed=seed))
    loaded(service, LONG if is_there else OLD_PLAN)
    service.run(1.2)
    for direction in "<>":
        service.wire.at_random(direction, lose=15, repeat=3)
    service.wire.set_latency(latency_of(seed))
    ensuring(service, LONG)
    ended = service.done(150)
    is_aboard = len(service.autopilot.received()) == 21
    assert (ended in ("AlreadyAboard", "Accepted")) == (service.state.aboard == "OurPlan")
    assert ended != "Accepted" or (is_aboard and not is_there)
    assert ended != "AlreadyAboard" or is_there
    assert not is_there or ended in ("AlreadyAboard", "TimedOut", "NoAnswer")
