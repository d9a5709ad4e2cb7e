"""start(), startMission() and setMode() beside a pilot: whoever takes the aircraft keeps it.

MAVLink has no order that counts only in the mode that was seen. So an order leaves right behind a heartbeat, and what
a pilot sets while it is on its way is set again. PX4 tells its mode once a second and when it is asked: what a pilot
sets in the 10 ms between its heartbeat and the order cannot be seen there.
"""

from __future__ import annotations

import pytest

from simulation.fake_autopilot import mavlink
from simulation.service import asks_for_heartbeat
from starts import ARM, MISSION_START, SET_MODE, hops, made, told, upload

PILOT = pytest.mark.scenario(49, "start() beside a pilot: the mode that he sets stays, and the status says so")

OTHERS = {"copter": 5, "rover": 4, "px4": (4, 3)}  # LOITER, HOLD, HOLD
BEGINS = {"copter": (MISSION_START, 0), "rover": (SET_MODE, 10), "px4": (MISSION_START, 0)}
OFFSETS_MS = (-18, -12, -6, -1, 1, 6, 12, 22, 37, 80, 200)


def mode_of(service):
    autopilot = service.autopilot
    return autopilot.kind.modes[autopilot.mode] if hasattr(autopilot, "kind") else \
        (autopilot.main_mode, autopilot.sub_mode)  # fmt: skip


def set_by_pilot(service, mode, now) -> None:
    service.autopilot._set_mode(*(mode if isinstance(mode, tuple) else (mode,)), now)


def ready(build_service, vehicle, **options):
    service = made(build_service, vehicle, **options)
    if vehicle == "px4":
        service.autopilot._set_mode(3, 0, 0.0)  # POSCTL
    upload(service, hops(vehicle, 4))
    service.run_until(6.0)  # the same moment for each
    return service


def heard_at(build_service, vehicle, order) -> float:
    """When the autopilot hears that order in a start() that nobody disturbs."""
    service = ready(build_service, vehicle)
    service.order_of("start")
    assert service.done() == "Done"
    entries = [entry for entry in service.autopilot.log if entry.direction == ">"
               and entry.message.get_type() == "COMMAND_LONG"
               and (entry.message.command, entry.message.param2) == order]  # fmt: skip
    (entry,) = entries
    return entry.time


def watch(service) -> list:
    """When which mode was set from now on, by anybody."""
    modes = []
    autopilot, react = service.autopilot, service.autopilot._set_mode

    def note(*arguments):
        result = react(*arguments)
        modes.append((arguments[-1], mode_of(service)))
        return result

    autopilot._set_mode = note
    return modes


@PILOT
@pytest.mark.parametrize("vehicle", BEGINS)
def test_mode_of_a_pilot_beside_the_order_that_begins_stays(build_service, vehicle):
    at = heard_at(build_service, vehicle, BEGINS[vehicle])
    other = OTHERS[vehicle]
    for offset_ms in OFFSETS_MS:
        service = ready(build_service, vehicle)
        moment = at + offset_ms / 1000
        service.autopilot.at("pilot", moment, lambda now, s=service: set_by_pilot(s, other, now))
        service.order_of("start")
        modes = watch(service)
        status = service.done()
        if status == "Done" and moment > service.now - 0.03:
            continue  # his heartbeat came when start() had ended
        service.run(3.0)
        unseen = vehicle == "px4" and -10 < offset_ms < 0
        expected = ("Done", (4, 4)) if unseen else ("TakenOver", other)
        assert (status, mode_of(service)) == expected, f"{offset_ms}: {modes}"
        undone_s = [time for time, mode in modes if mode == other and time > moment + 0.0005]
        assert not undone_s or undone_s[0] - moment < 0.3, f"{offset_ms}: {modes}"
        assert (ARM, 0, 0) not in told(service)
        # A pilot who was sooner than that order has kept it from leaving; PX4 is armed by it.
        assert service.autopilot.armed or vehicle == "px4"
        assert service.state.arming == ("Armed" if service.autopilot.armed else "Untouched")


@PILOT
@pytest.mark.parametrize("vehicle", BEGINS)
@pytest.mark.parametrize("order, at_ms", [("mode", 10), ("mode", 20), ("mode", 28), ("startmission", 20)])
def test_mode_that_a_pilot_sets_beside_another_order_stays(build_service, vehicle, order, at_ms):
    service = ready(build_service, vehicle)
    other = OTHERS[vehicle]
    service.order_of("arm")
    assert service.done() == "Done"
    service.run_until(8.0)
    moment = service.now + at_ms / 1000
    service.autopilot.at("pilot", moment, lambda now: set_by_pilot(service, other, now))
    modes = watch(service)
    if order == "mode":
        service.set_mode("ReturnToLaunch")
    else:
        service.order_of(order)
    status = service.done()
    service.run(3.0)
    is_after = [mode for _, mode in modes][-1] == other
    assert status == ("TakenOver" if is_after else "Done"), modes
    assert mode_of(service) == [mode for _, mode in modes][-1]
    if vehicle != "px4":
        assert mode_of(service) == other


@PILOT
@pytest.mark.parametrize("vehicle", BEGINS)
def test_each_order_leaves_right_behind_a_heartbeat(build_service, vehicle):
    """Lost and repeated orders, too."""
    service = ready(build_service, vehicle)
    orders = (SET_MODE, ARM, MISSION_START)
    service.wire.lose(">", name="COMMAND_LONG", times=2, where=lambda message: message.command in orders)
    before = service.now
    service.order_of("start")
    assert service.done(limit_s=30) == "Done"
    sent = [entry.time for entry in service.wire.frames(">", "COMMAND_LONG")
            if entry.time > before and entry.message.command in orders]  # fmt: skip
    heartbeats = [entry.time for entry in service.wire.frames("<", "HEARTBEAT") if entry.time > before]
    asked = [entry for entry in service.wire.frames(">", "COMMAND_LONG") if asks_for_heartbeat(entry.message)]
    assert len(sent) >= 3 and asked
    for time in sent:
        age = min(time - heartbeat for heartbeat in heartbeats if heartbeat < time)
        assert age < 0.035, "from the first byte of the heartbeat to the last of the order"


@PILOT
@pytest.mark.parametrize("silent_s", [0.2, 4.2, 4.35])
def test_start_is_not_done_by_a_current_item_behind_a_heartbeat_with_a_pilots_mode(build_service, silent_s):
    """PX4's MISSION_CURRENT need not say whether the mission flies. The time of an order is kept in a byte, for 4 s."""
    at = heard_at(build_service, "px4", BEGINS["px4"])
    service = ready(build_service, "px4")
    autopilot = service.autopilot
    autopilot._mission_state = lambda: mavlink.MISSION_STATE_UNKNOWN
    shown_s, told_s = at + 0.06, at + silent_s
    service.wire.lose("<", name="HEARTBEAT", times=1000, where=lambda _: shown_s < service.now < told_s)
    service.wire.lose("<", name="MISSION_CURRENT", times=1000, where=lambda _: at < service.now < told_s)

    def tell(now):
        autopilot.answer(autopilot.heartbeat(), now, later_s=0.001)
        autopilot.answer(autopilot._mission_current(), now, later_s=0.002)

    autopilot.at("pilot", at + 0.1, lambda now: set_by_pilot(service, OTHERS["px4"], now))
    autopilot.at("told", told_s, tell)
    service.order_of("start")
    assert service.done() == "TakenOver"
    assert mode_of(service) == OTHERS["px4"]
    shown = [entry.message.custom_mode for entry in service.wire.frames("<", "HEARTBEAT")
             if at < entry.time < told_s and entry.fate == ""]  # fmt: skip
    assert shown and 4 << 16 | 4 << 24 in shown, "a heartbeat has shown that it flies"


STALL_S = 0.7


def stall_at(service, time: float) -> None:
    """loop() stands still then, once in this test."""
    service.tell("stall", round(time * 1000), round(STALL_S * 1000))


@PILOT
@pytest.mark.parametrize("order", ["start", "mode"])
@pytest.mark.parametrize("vehicle", BEGINS)
def test_no_order_leaves_behind_a_heartbeat_that_has_waited_while_loop_stood_still(build_service, vehicle, order):
    """The heartbeat that was asked for waits in the receive buffer meanwhile, and the pilot takes the aircraft."""
    other = OTHERS[vehicle]
    stood_still = 0
    for number in range(14):
        service = ready(build_service, vehicle)
        began = 6.0 + 0.004 + 0.007 * number
        moment = began + STALL_S / 2
        service.autopilot.at("pilot", moment, lambda now, s=service: set_by_pilot(s, other, now))
        stall_at(service, began)
        modes = watch(service)
        if order == "mode":
            service.set_mode("ReturnToLaunch")
        else:
            service.order_of("start")
        status = service.done(limit_s=30)
        service.run(2.0)
        stood_still += status == "TakenOver"
        undone = [mode for time, mode in modes if time > moment + 0.0005 and mode != other]
        assert undone == [], f"{number}: {modes}"
    assert stood_still > 1


@PILOT
@pytest.mark.parametrize("vehicle", ["copter", "rover"])
def test_pilot_who_disarms_is_told_by_start_arming_whatever_mode_he_has_set(build_service, vehicle):
    at = heard_at(build_service, vehicle, (ARM, 0))
    for behind_ms in (20, 40):  # a heartbeat has shown it armed, and it does not fly yet
        service = ready(build_service, vehicle)

        def take(now, s=service):
            s.autopilot.armed = False
            set_by_pilot(s, OTHERS[vehicle], now)

        service.autopilot.at("pilot", at + behind_ms / 1000, take)
        service.order_of("start")
        assert service.done() in ("TakenOver", "NotArmed"), behind_ms
        assert not service.autopilot.armed and service.state.arming != "Armed", behind_ms
