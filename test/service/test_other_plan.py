"""Another ground station puts its own plan aboard: aboard(), isOurPlan() and start() agree about it."""

from __future__ import annotations

import pytest

from plans import HOME, on_the_wire, waypoint
from simulation.fake_autopilot import mavlink
from starts import HOPS, VEHICLES, hops, is_flying, know_vehicle

OTHER = pytest.mark.scenario(58, "Somebody else's plan is noticed, and aboard(), isOurPlan() and start() agree")
MISSION_CURRENT = mavlink.MAVLINK_MSG_ID_MISSION_CURRENT
STATION = (255, 190)
STREAM = {"streams": {MISSION_CURRENT: 1.0}}


@pytest.fixture
def uploaded(build_service):
    """Our plan is aboard, and the line is quiet again."""

    def make(personality: str, **options):
        options = STREAM | options if personality == "ArduPilot" else options
        service = build_service(personality, **options)
        service.upload(HOPS[personality])
        assert service.done() == "Accepted"
        service.run(4.0)
        expect(service, is_ours=True)
        return service

    return make


def expect(service, is_ours: bool) -> None:
    """Fail unless all three say so."""
    state = service.state
    assert state.aboard == ("OurPlan" if is_ours else "OtherPlan")
    assert service.followed.ours == is_ours
    if not is_ours:
        before = len(service.heard("COMMAND_LONG"))
        service.order_of("start")
        assert service.done() == "Unproven"
        assert len(service.heard("COMMAND_LONG")) == before, "start() has sent something"


def put_by_another(service, plan, elsewhere: bool = True) -> None:
    """The other station uploads it, in the steps of the protocol; elsewhere: through a link of its own."""
    autopilot, now = service.autopilot, service.now
    sender = STATION

    def say(message) -> None:
        packer = mavlink.MAVLink(None, *sender)
        autopilot.receive(message.pack(packer), now, elsewhere)

    say(mavlink.MAVLink_mission_count_message(1, 1, len(plan), 0))
    for seq, one in enumerate(plan):
        say(mavlink.MAVLink_mission_item_int_message(
            1, 1, seq, one.frame, one.command, one.current, one.autocontinue, one.param1, one.param2, one.param3,
            one.param4, one.x, one.y, one.z, 0))  # fmt: skip
    assert len(autopilot.received()) == len(plan)


def another(change: str, personality: str) -> list:
    """A plan that differs from ours in this."""
    plan = on_the_wire(HOPS[personality], personality)
    return {"longer": [*plan, waypoint()], "shorter": plan[:-1],
            "same length": [*plan[:-1], plan[-1]._replace(x=plan[-1].x + 1000)]}[change]  # fmt: skip


@OTHER
@pytest.mark.parametrize(
    "personality, change",
    [("ArduPilot", "longer"), ("ArduPilot", "shorter"), ("PX4", "longer"), ("PX4", "shorter"), ("PX4", "same length")],
)
def test_plan_that_another_station_uploads_is_noticed(uploaded, personality, change):
    service = uploaded(personality)
    put_by_another(service, another(change, personality))
    service.run(3.0)
    expect(service, is_ours=False)


@OTHER
def test_plan_of_the_same_length_by_another_line_is_not_noticed_on_ardupilot(uploaded):
    service = uploaded("ArduPilot")
    put_by_another(service, another("same length", "ArduPilot"))
    service.run(5.0)
    assert service.state.aboard == "OurPlan" and service.followed.ours
    service.verify(HOPS["ArduPilot"])
    assert service.done() == "Differs"
    assert service.state.aboard == "NotKnown" and not service.followed.ours


@OTHER
@pytest.mark.parametrize("behind_s", [0.05, 0.3, 0.6, 0.9])
def test_plan_that_another_station_uploads_right_behind_ours_is_noticed_soon(build_service, personality, behind_s):
    service = build_service(personality, **STREAM if personality == "ArduPilot" else {})
    service.run(2.5)
    service.upload(HOPS[personality])
    assert service.done() == "Accepted"
    service.run(behind_s)
    put_by_another(service, another("longer", personality))
    service.run(2.2)
    expect(service, is_ours=False)


@OTHER
@pytest.mark.parametrize("way", ["cleared by another station", "lost in a restart"])
def test_plan_that_is_gone_is_noticed(uploaded, personality, way):
    service = uploaded(personality)
    if way == "lost in a restart":
        service.autopilot.reboot(service.now)
        service.autopilot.load([])
        service.run(4.0)
    else:
        message = mavlink.MAVLink_mission_clear_all_message(1, 1, 0)
        service.autopilot.receive(message.pack(mavlink.MAVLink(None, *STATION)), service.now, elsewhere=True)
    service.run(3.5)
    assert service.followed.total == 0
    expect(service, is_ours=False)


@OTHER
def test_plan_of_the_same_length_that_comes_without_a_word_is_found_by_a_look(uploaded):
    """As a file written by MAVLink FTP comes."""
    service = uploaded("ArduPilot")
    plan = HOPS["ArduPilot"]
    service.autopilot.load([HOME, *plan[:-1], plan[-1]._replace(x=plan[-1].x + 1000)])
    service.run(5.0)
    assert service.state.aboard == "OurPlan"  # nothing has told
    service.verify(plan)
    assert service.done() == "Differs"
    assert service.state.aboard == "NotKnown" and not service.followed.ours
    service.order_of("start")
    assert service.done() == "Unproven"


@OTHER
def test_upload_of_another_station_that_breaks_off_is_noticed_on_ardupilot(uploaded):
    service = uploaded("ArduPilot")
    now = service.now
    count = mavlink.MAVLink_mission_count_message(1, 1, len(HOPS["ArduPilot"]) + 1, 0)
    service.autopilot.receive(count.pack(mavlink.MAVLink(None, *STATION)), now)
    service.run(10.0)
    expect(service, is_ours=False)


@OTHER
def test_order_of_another_station_to_fly_somewhere_is_no_plan(uploaded):
    """ArduPilot accepts it as it accepts an upload."""
    service = uploaded("ArduPilot")
    one = waypoint()
    there = mavlink.MAVLink_mission_item_int_message(1, 1, 0, 3, 16, 2, 1, 0, 0, 0, 0, one.x, one.y, one.z, 0)
    service.autopilot.receive(there.pack(mavlink.MAVLink(None, *STATION)), service.now)
    service.run(3.0)
    assert [ack.type for ack in service.autopilot.messages("<", "MISSION_ACK")][-1] == mavlink.MAV_MISSION_ACCEPTED
    expect(service, is_ours=True)


@OTHER
@pytest.mark.parametrize("name", ["MISSION_ACK", "STATUSTEXT"])
def test_our_own_upload_raises_no_alarm_when_its_end_is_lost_or_late(uploaded, name):
    service = uploaded("ArduPilot")
    service.wire.lose("<", name=name)
    service.upload(HOPS["ArduPilot"], proof="InDoubt")
    assert service.done(30) == "Accepted"
    service.run(4.0)
    expect(service, is_ours=True)
    service.wire.delay("<", 1.0, name=name)
    service.upload(HOPS["ArduPilot"][:2], proof="InDoubt")
    assert service.done(30) == "Accepted"
    service.run(4.0)
    expect(service, is_ours=True)


@OTHER
def test_px4_that_gets_our_plan_back_is_ours_again(uploaded):
    service = uploaded("PX4")
    put_by_another(service, [waypoint(), waypoint(1, 2)])
    service.run(3.0)
    expect(service, is_ours=False)
    put_by_another(service, HOPS["PX4"])
    service.run(3.0)
    assert service.state.aboard == "OurPlan" and service.followed.ours


@OTHER
def test_start_notices_it_by_itself_and_does_not_arm(build_service, personality):
    """Before anything else has told: MISSION_CURRENT, which it asks for, is about another plan."""
    service = build_service(personality, uptime_s=120.0)
    service.upload(HOPS[personality])
    assert service.done() == "Accepted"
    service.autopilot.load([*on_the_wire(HOPS[personality], personality), waypoint()])
    began = service.now
    service.order_of("start")
    assert service.done(30) == "Unproven"
    assert service.now - began < 2.0  # two MISSION_CURRENTs, of which PX4 sends one a second
    assert service.state.step == "FirstItem"
    assert not service.autopilot.armed
    assert service.state.aboard == "OtherPlan"
    assert not service.followed.ours


@OTHER
@pytest.mark.parametrize("vehicle", ["copter", "rover", "px4"])
@pytest.mark.parametrize("behind_s", [0.02, 0.08, 0.12, 0.16, 0.2, 0.25, 0.3, 0.4, 0.6, 0.9, 1.2])
def test_start_beside_an_upload_of_another_station_is_never_done(build_service, vehicle, behind_s):
    """What it has armed is disarmed again, while it stands; in the air it is left to the pilot."""
    personality, kind = VEHICLES[vehicle]
    service = build_service(personality, vehicle=kind, uptime_s=120.0, **STREAM if personality == "ArduPilot" else {})
    plan = hops(vehicle, 4)
    know_vehicle(service, personality)
    service.upload(plan)
    assert service.done() == "Accepted"
    service.run(3.0)
    before = len(service.ends)
    service.order_of("start")
    service.run(behind_s)
    if service.ends[before:]:
        return  # it was done before
    wire = on_the_wire(plan, personality)
    put_by_another(service, [*wire, *wire[-2:]])
    ended = service.done(30)
    assert ended == ("FliesOtherPlan" if service.autopilot.armed else "Unproven")
    service.run(3.0)
    assert service.state.aboard == "OtherPlan"
    assert is_flying(service) or not service.autopilot.armed
