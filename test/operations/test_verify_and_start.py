"""verifyAndStart(): a start() between two looks at each item, so that a plan as long as ours is noticed, too."""

from __future__ import annotations

import pytest

from plans import HOME
from starts import ARM, ON_VEHICLES, expect_flying_from, hops, made, told, upload

LOOKS = pytest.mark.scenario(49, "verifyAndStart() compares each item before it arms, and when it flies")
LISTS = "MISSION_REQUEST_LIST"
OTHERS = {"copter": 5, "rover": 4}  # LOITER, HOLD


def verify_and_start(service, item: int = 0, limit_s: float = 30.0) -> str:
    service.begun.clear()
    service.order_of("startproven", item)
    return service.done(limit_s)


def run_until(service, is_so, limit_s: float = 10.0) -> None:
    limit = service.now + limit_s
    while not is_so():
        assert service.now < limit
        service.run(0.005)


def put_another(service, vehicle: str) -> None:
    """As many items as ours, brought by another line, or as a file: no message tells of it."""
    plan = hops(vehicle, 4, east=3000)
    service.autopilot.load(plan if vehicle == "px4" else [HOME, *plan])


@LOOKS
@ON_VEHICLES
def test_it_flies_what_it_has_compared(build_service, vehicle):
    service = made(build_service, vehicle)
    upload(service, hops(vehicle, 4))
    before = len(service.heard(LISTS))
    assert verify_and_start(service) == "Done"
    # PX4 names its plan by a checksum, so that one look is enough.
    assert len(service.heard(LISTS)) - before == (1 if vehicle == "px4" else 2)
    assert service.state.aboard == "OurPlan"
    assert len(service.ends_called_back) == 2  # of the upload, and of this: no look tells an end of its own
    expect_flying_from(service, vehicle, 0)


@LOOKS
@ON_VEHICLES
def test_a_plan_as_long_as_ours_is_found_before_anything_is_ordered(build_service, vehicle):
    service = made(build_service, vehicle)
    upload(service, hops(vehicle, 4))
    put_another(service, vehicle)
    service.run(1.5)
    before = len(told(service))
    assert verify_and_start(service) == "Differs"
    assert len(told(service)) == before and not service.autopilot.armed
    assert service.state.failed_item == (0 if vehicle == "rover" else 1) and service.state.arming == "Untouched"


@LOOKS
@pytest.mark.parametrize("vehicle", ["copter", "rover"])
def test_a_plan_as_long_as_ours_that_comes_behind_the_look_is_found_when_it_flies(build_service, vehicle):
    service = made(build_service, vehicle)
    upload(service, hops(vehicle, 4))
    service.order_of("startproven", 0)
    run_until(service, lambda: service.autopilot.armed)
    put_another(service, vehicle)
    assert service.done(30) == "Unproven"
    assert service.state.aboard == "OtherPlan" and service.state.step == "Confirm"
    assert (ARM, 0, 0) in told(service) and len(service.ends_called_back) == 2
    # On the ground it is disarmed again; in the air the autopilot refuses that.
    assert service.state.arming == ("Armed" if service.autopilot.armed else "Disarmed")


@LOOKS
@pytest.mark.parametrize("vehicle", ["copter", "rover"])
def test_a_mode_that_a_pilot_sets_during_a_look_stays(build_service, vehicle):
    for look in (1, 2):
        service = made(build_service, vehicle)
        upload(service, hops(vehicle, 8))
        before = len(service.heard(LISTS))
        service.order_of("startproven", 0)
        run_until(service, lambda made=service, looks=before + look: len(made.heard(LISTS)) == looks)
        service.run(0.05)
        service.autopilot._set_mode(OTHERS[vehicle], service.now)
        assert service.done(30) == "TakenOver"
        service.run(1.5)
        autopilot = service.autopilot
        assert autopilot.kind.modes[autopilot.mode] == OTHERS[vehicle] and autopilot.armed == (look == 2)
