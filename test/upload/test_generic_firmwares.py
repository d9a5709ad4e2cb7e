"""Betaflight and iNav, by their sources, where the library is told that a generic autopilot is one of them."""

from __future__ import annotations

import math

import pytest

from plans import LAND, LOITER_TIME, NO_PLACE, RETURN, TAKEOFF, jump, waypoint
from simulation.fake_autopilot import item, mavlink
from simulation.fake_autopilot.betaflight import Betaflight
from simulation.fake_autopilot.inav import Inav

GENERIC = pytest.mark.scenario(29, "Betaflight and iNav, as MAVMISSION_GENERIC_FIRMWARE names them: what each takes")
NUMBERS = {"Betaflight": 1, "Inav": 2}  # of MAVMISSION_GENERIC_FIRMWARE
KINDS = {"Betaflight": Betaflight, "Inav": Inav}
ON_LINE = {"baud": 57600, "response_delay_s": Inav.response_delay_on_line_s, "heartbeat_at_s": 0.05, "uptime_s": 60.0}
NAN = math.nan
X, Y = -353632621, 1491652374
PLAN = [waypoint(X + 900 * n, Y, 20.25, param4=NAN) for n in range(4)]  # no yaw is set
ABOVE_SEA = [one._replace(frame=0, z=600.0 + n / 3) for n, one in enumerate(PLAN)]
OLD = [waypoint(X, Y + 900 * n, 50.0) for n in range(3)]


def server(firmware: str, **options):
    if firmware == "Inav":
        options.setdefault("autopilot", mavlink.MAV_AUTOPILOT_GENERIC)
    return KINDS[firmware](**ON_LINE, **options)


@pytest.fixture
def build(build_service):
    """A Service, with the firmware compiled for that autopilot; the autopilot holds an old plan."""

    def made(firmware: str, **options):
        service = build_service(server(firmware, **options), defines={"MAVMISSION_GENERIC_FIRMWARE": NUMBERS[firmware]})
        service.autopilot.load(OLD)
        return service

    return made


@GENERIC
@pytest.mark.parametrize("firmware", KINDS)
def test_unset_yaws_go_out_as_0_and_nothing_stands_in_homes_place(build, firmware):
    service = build(firmware)
    service.upload(PLAN, proof="InDoubt")
    assert service.done(limit_s=10) == "Accepted"
    assert service.state.aboard == "OurPlan" and service.state.firmware == firmware
    sent = service.heard("MISSION_ITEM_INT")
    assert [(one.seq, one.command, one.param4) for one in sent] == [(n, 16, 0.0) for n in range(4)]
    assert len(service.autopilot.held) == 4


@GENERIC
@pytest.mark.parametrize("firmware", KINDS)
def test_plan_above_sea_level_is_read_back_and_verified(build, firmware):
    """Betaflight multiplies its centimetres by 0.01, iNav divides them by 100; the frame comes as _INT."""
    service = build(firmware)
    service.upload(ABOVE_SEA, proof="Always")
    assert service.done(limit_s=10) == "Accepted"
    service.verify(ABOVE_SEA)
    assert service.done(limit_s=10) == "Verified"
    service.ensure(ABOVE_SEA)
    assert service.done(limit_s=10) == "AlreadyAboard"
    service.verify([*ABOVE_SEA[:3], ABOVE_SEA[3]._replace(z=ABOVE_SEA[3].z + 0.02)])
    assert service.done(limit_s=10) == "Differs"
    assert (service.state.failed_item, service.state.field) == (3, "Height")


@GENERIC
def test_betaflights_heights_above_home_prove_an_upload_and_no_plan_of_before(build):
    """It gives them above sea level, by a home that is not known here."""
    service = build("Betaflight")
    service.upload(PLAN, proof="Always")
    assert service.done(limit_s=10) == "Accepted"
    service.verify(PLAN)
    assert service.done(limit_s=10) == "Differs"
    assert (service.state.failed_item, service.state.field) == (0, "Reference")
    service.ensure([one._replace(z=30.0) for one in PLAN])
    assert service.done(limit_s=10) == "Accepted"  # it was uploaded again
    assert [round(one.z, 2) for one in service.autopilot.held] == [614.12] * 4


@GENERIC
def test_follower_notices_that_betaflight_has_dropped_the_plan_that_it_accepted(build):
    """It does when a line brings our MISSION_COUNT again, or when another station begins an upload."""
    service = build("Betaflight")
    service.upload(ABOVE_SEA, proof="InDoubt")
    assert service.done(limit_s=10) == "Accepted"
    service.run(3.0)
    assert service.state.aboard == "OurPlan"
    (count,) = service.wire.frames(">", "MISSION_COUNT")
    service.autopilot.receive(count.data, service.now)
    service.run(3.0)
    assert service.autopilot.held == []
    assert service.state.aboard == "OtherPlan"


REFUSED = {
    "Betaflight": {"a return, which it would drop": item(RETURN, frame=NO_PLACE), "a jump": jump(0),
                   "a spline": item(82, x=X, y=Y, z=20.0), "turns": item(18, x=X, y=Y, z=20.0, param1=2.0),
                   "a servo": item(183, frame=NO_PLACE, param1=9.0, param2=1500.0)},
    "Inav": {"a takeoff": item(TAKEOFF, x=X, y=Y, z=20.0), "a delay": item(93, frame=NO_PLACE, param1=5.0),
             "a spline": item(82, x=X, y=Y, z=20.0), "a speed": item(178, frame=NO_PLACE, param1=1.0, param2=5.0)},
}  # fmt: skip


@GENERIC
@pytest.mark.parametrize("firmware, name", [(firmware, name) for firmware in REFUSED for name in REFUSED[firmware]])
def test_command_that_it_does_not_take_or_fly_is_refused_before_anything_is_sent(build, firmware, name):
    service = build(firmware)
    service.upload([*PLAN[:2], REFUSED[firmware][name]])
    assert service.done(limit_s=10) == "NotFlown"
    assert service.state.failed_item == 2
    assert service.autopilot.held == OLD
    assert service.wire.frames(">", "MISSION_COUNT") == []


@GENERIC
@pytest.mark.parametrize("firmware", KINDS)
def test_what_it_takes_is_read_back_as_it_was_sent(build, firmware):
    service = build(firmware)
    plan = [*ABOVE_SEA, item(LOITER_TIME, frame=0, x=X, y=Y, z=612.34, param1=30.0)]
    if firmware == "Inav":
        plan += [item(201, frame=0, x=X, y=Y, z=590.0, param1=3.0), item(115, frame=NO_PLACE, param1=90.0, param2=20.0),
                 jump(0, -1), item(RETURN, frame=NO_PLACE)]  # fmt: skip
    else:
        plan = [item(TAKEOFF, frame=0, z=610.0, param4=NAN), *plan, item(LAND, frame=0, param4=NAN)]
    service.upload(plan, proof="Always")
    assert service.done(limit_s=10) == "Accepted"
    assert len(service.autopilot.held) == len(plan)
    if firmware == "Betaflight":  # It would land at 0 N 0 E.
        assert (service.autopilot.held[-1].x, service.autopilot.held[-1].y) == (X, Y)


@GENERIC
def test_fence_that_betaflight_would_store_and_not_enforce_is_refused(build):
    service = build("Betaflight")
    service.upload([item(5001, frame=0, x=X + n, y=Y, param1=4.0) for n in range(4)], mission_type=1)
    assert service.done(limit_s=10) == "NotFlown"
    assert service.autopilot.fence == []


@GENERIC
def test_fence_that_inav_does_not_take_is_refused(build):
    service = build("Inav")
    service.upload([item(5001, frame=0, x=X + n, y=Y, param1=4.0) for n in range(4)], mission_type=1)
    assert service.done(limit_s=10) == "NotFlown"


@GENERIC
@pytest.mark.parametrize("number", [1, 2])
def test_ardupilot_and_px4_are_what_they_say_in_that_firmware_too(build_bench, personality, number):
    bench = build_bench(personality, defines={"MAVMISSION_GENERIC_FIRMWARE": number})
    plan = [item(TAKEOFF, x=X, y=Y, z=20.0), *PLAN[1:3], item(RETURN, frame=NO_PLACE)]
    bench.upload(plan, proof="Always")
    assert bench.run_until_ended(limit_s=10) == "Accepted"
    assert bench.state.firmware == {"PX4": "Px4"}.get(personality, personality)
