"""Autopilots that are neither ArduPilot nor PX4, or only say so, on the simulated Mega: a scenario of each. (Which
commands each takes: test/host/generic. Every way that an upload to each can go: test/explorer.)"""

from __future__ import annotations

import math

import pytest

from plans import HOME, LAND, LOITER_TIME, NO_PLACE, RETURN, SURVEY, TAKEOFF, jump, on_the_wire, waypoint
from simulation.bench import same_bits
from simulation.fake_autopilot import item, mavlink
from simulation.fake_autopilot.betaflight import Betaflight
from simulation.fake_autopilot.inav import Inav

NUMBERS = {"Betaflight": 1, "Inav": 2}  # of MAVMISSION_GENERIC_FIRMWARE
KINDS = {"Betaflight": Betaflight, "Inav": Inav}
NAN = math.nan
X, Y = -353632621, 1491652374
PLAN = [waypoint(X + 900 * n, Y, 20.25, param4=NAN) for n in range(4)]  # no yaw is set
ABOVE_SEA = [one._replace(frame=0, z=600.0 + n / 3) for n, one in enumerate(PLAN)]
CIRCLE = item(LOITER_TIME, frame=0, x=X, y=Y, z=612.34, param1=30.0)
TAKEN = {
    "Betaflight": [item(TAKEOFF, frame=0, z=610.0, param4=NAN), *ABOVE_SEA, CIRCLE, item(LAND, frame=0, param4=NAN)],
    "Inav": [*ABOVE_SEA, CIRCLE, item(201, frame=0, x=X, y=Y, z=590.0, param1=3.0),
             item(115, frame=NO_PLACE, param1=90.0, param2=20.0), jump(0, -1), item(RETURN, frame=NO_PLACE)],
}  # fmt: skip
BY_MACRO = pytest.mark.scenario(29, "Betaflight and iNav, as MAVMISSION_GENERIC_FIRMWARE names them")


def server(kind, **options):
    return kind(baud=57600, response_delay_s=Inav.response_delay_on_line_s, heartbeat_at_s=0.05, uptime_s=60.0,
                **options)  # fmt: skip


def built(build_service, firmware: str):
    """A Service, with the firmware compiled for that autopilot; the autopilot holds an old plan."""
    options = {"autopilot": mavlink.MAV_AUTOPILOT_GENERIC} if firmware == "Inav" else {}
    service = build_service(server(KINDS[firmware], **options),
                            defines={"MAVMISSION_GENERIC_FIRMWARE": NUMBERS[firmware]})  # fmt: skip
    service.autopilot.load([waypoint(X, Y + 900 * n, 50.0) for n in range(3)])
    return service


@pytest.mark.slow
@BY_MACRO
@pytest.mark.parametrize("firmware", KINDS)
def test_what_it_takes_is_read_back_and_verified_and_what_it_does_not_take_is_refused(build_service, firmware):
    """Unset yaws go out as 0, and nothing stands in home's place. Betaflight multiplies its centimetres by 0.01, iNav
    divides them by 100."""
    service, plan = built(build_service, firmware), TAKEN[firmware]
    service.upload([*PLAN[:2], item(82, x=X, y=Y, z=20.0)])  # a spline
    assert (service.done(), service.state.failed_item) == ("NotFlown", 2)
    assert service.heard("MISSION_COUNT") == []
    service.upload(plan, proof="Always")
    assert service.done() == "Accepted"
    assert service.state.aboard == "OurPlan" and service.state.firmware == firmware
    sent = service.heard("MISSION_ITEM_INT")
    assert [one.seq for one in sent] == list(range(len(plan))) and len(service.autopilot.held) == len(plan)
    assert not any(math.isnan(one.param4) for one in sent)
    if firmware == "Betaflight":  # it would land at 0 N 0 E
        assert (service.autopilot.held[-1].x, service.autopilot.held[-1].y) == (X, Y)
    service.ensure(plan)
    assert service.done() == "AlreadyAboard"
    service.verify([*plan[:3], plan[3]._replace(z=plan[3].z + 0.02), *plan[4:]])
    assert service.done() == "Differs"
    assert (service.state.failed_item, service.state.field) == (3, "Height")


@BY_MACRO
def test_items_of_inav_are_compared_as_integers_where_bytes_are_lost(build_service):
    """It knows the older request, too, and answers it with its places as floats: some metres beside them."""
    service = built(build_service, "Inav")
    service.upload(PLAN, proof="Always")
    assert service.done() == "Accepted"
    service.wire.lose(">", name="MISSION_REQUEST_INT", seq=2, times=3)
    service.verify(PLAN)
    assert service.done() == "Verified"
    assert service.heard("MISSION_REQUEST") == []


@BY_MACRO
@pytest.mark.parametrize(
    "refused",
    [item(115, frame=NO_PLACE, param1=-90.0), item(115, frame=NO_PLACE, param1=360.0),
     item(201, frame=0, x=X, y=Y, z=590.0, param1=0.0)],
)  # fmt: skip
def test_what_inav_refuses_in_the_midst_of_an_upload_is_not_sent_to_it(build_service, refused):
    """By then its items have replaced those of the plan aboard."""
    service = built(build_service, "Inav")
    service.upload([PLAN[0], refused, PLAN[1]])
    assert (service.done(), service.state.failed_item, service.state.field) == ("NotKept", 1, "Param1")
    assert service.heard("MISSION_COUNT") == []


@BY_MACRO
def test_betaflights_heights_above_home_prove_an_upload_and_no_plan_of_before(build_service):
    """It gives them above sea level, by a home that is not known here."""
    service = built(build_service, "Betaflight")
    service.upload(PLAN, proof="Always")
    assert service.done() == "Accepted"
    service.verify(PLAN)
    assert service.done() == "Differs"
    assert (service.state.failed_item, service.state.field) == (0, "Reference")
    service.ensure([one._replace(z=30.0) for one in PLAN])
    assert service.done() == "Accepted"  # it was uploaded again
    assert [round(one.z, 2) for one in service.autopilot.held] == [614.12] * 4


@BY_MACRO
def test_follower_notices_that_betaflight_has_dropped_the_plan_that_it_accepted(build_service):
    """It does when a line brings our MISSION_COUNT again, or when another station begins an upload."""
    service = built(build_service, "Betaflight")
    service.upload(ABOVE_SEA, proof="InDoubt")
    assert service.done() == "Accepted"
    service.run(3.0)
    assert service.state.aboard == "OurPlan"
    service.autopilot.receive(service.wire.frames(">", "MISSION_COUNT")[0].data, service.now)
    service.run(3.0)
    assert service.autopilot.held == [] and service.state.aboard == "OtherPlan"


@pytest.mark.scenario(29, "A server of an unknown firmware accepts: that alone is no proof, and it is read back")
@pytest.mark.parametrize("proof, ended", [("ByAnswer", "Unconfirmed"), ("InDoubt", "Accepted")])
def test_plan_comes_aboard_an_unknown_firmware_that_the_sketch_names(build_bench, proof, ended):
    bench = build_bench(server(Inav, autopilot=mavlink.MAV_AUTOPILOT_GENERIC))
    bench.tell("talk", 1, 1)
    plan = [one._replace(frame=0, z=600.0, param4=0.0) for one in PLAN]
    bench.upload(plan, proof=proof)
    assert bench.run_until_ended(limit_s=20) == ended
    assert len(bench.autopilot.held) == len(plan)
    assert bool(bench.heard("MISSION_REQUEST_LIST")) == (ended == "Accepted")


@pytest.mark.scenario(28, "An autopilot that only says that it is an ArduPilot: no false Accepted")
@pytest.mark.parametrize("takes_all, ended", [(False, "Unsupported"), (True, "Differs")])
def test_upload_to_an_impostor_is_never_accepted(build_bench, takes_all, ended):
    bench = build_bench(server(Inav, takes_all=takes_all))
    plan = [one._replace(param4=0.0) for one in PLAN]
    bench.upload(plan, proof="InDoubt")
    assert bench.run_until_ended(limit_s=30) == ended and bench.state.aboard != "OurPlan"
    assert bench.autopilot.held == ([HOME, *plan] if takes_all else [])  # and HOME moves nothing


@pytest.mark.scenario(4, "An ArduPilot without MISSION_ITEM and MISSION_REQUEST")
def test_ardupilot_that_has_the_newer_messages_alone_is_read_back(build_service):
    service = build_service("ArduPilot", is_int_only=True)
    service.upload(SURVEY, proof="InDoubt")
    assert service.done() == "Accepted" and service.state.aboard == "OurPlan"
    assert len(service.heard("MISSION_REQUEST_LIST")) == 1
    service.ensure(SURVEY)
    assert service.done() == "AlreadyAboard"
    service.download()
    assert service.done() == "Downloaded"
    assert same_bits(service.autopilot.received(), on_the_wire(SURVEY, "ArduPilot"))
    assert service.heard("MISSION_ITEM", "MISSION_REQUEST") == service.wire.frames("<", "MISSION_REQUEST") == []
    service.order_of("clear", 0)
    assert service.done() == "Cleared"
