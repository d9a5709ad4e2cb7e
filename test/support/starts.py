"""What the tests of start() share: plans for three vehicles, and what is flown first."""

from __future__ import annotations

import pytest

from plans import NAN, waypoint
from simulation.fake_autopilot import item

ASK_VEHICLE = 3000  # DO_VTOL_TRANSITION, which moves nothing as it is sent
ARM, SET_MODE, MISSION_START, REQUEST_MESSAGE, SET_CURRENT = 400, 176, 300, 512, 224
VEHICLES = {"copter": ("ArduPilot", "copter"), "rover": ("ArduPilot", "rover"), "px4": ("PX4", "copter")}
ON_VEHICLES = pytest.mark.parametrize("vehicle", VEHICLES)


def hops(vehicle: str, items: int, east: int = 0) -> list:
    """Takes off where the vehicle stands, flies north, lands. A rover only drives."""
    lat, lon = (473977418, 85455938) if vehicle == "px4" else (-353632620, 1491652370)
    legs = [waypoint(lat + 2000 * number, lon + east, 5.0) for number in range(1, items + 1)]
    if vehicle == "rover":
        return legs
    yaw = {"param4": NAN} if vehicle == "px4" else {}
    return [item(22, x=lat, y=lon, z=5.0, **yaw), *legs[1:-1], item(21, x=lat, y=lon + east)]


def made(build_service, vehicle: str, **options):
    personality, kind = VEHICLES[vehicle]
    if vehicle == "rover":
        options = {"uptime_s": 120.0, **options}
    service = build_service(personality, vehicle=kind, **options)
    service.begun = begun_of(service)
    return service


def begun_of(service) -> list[int]:
    """The items, by the sketch's numbers, that are begun while the aircraft is armed."""
    flight, begun = service.autopilot.flight, []
    home = 1 if hasattr(service.autopilot, "kind") else 0
    tell = flight._begun

    def note(index: int, item, now: float) -> None:
        if service.autopilot.armed:
            begun.append(index - home)
        tell(index, item, now)

    flight._begun = note
    return begun


def upload(service, plan) -> None:
    service.upload(plan, proof="Always")
    assert service.done(limit_s=20) == "Accepted"


def set_current(service, item: int) -> None:
    """As another ground station may, or an earlier flight."""
    service.order_of("setcurrent", item)
    assert service.done() == "Done"


def current_on_the_wire(service) -> int:
    autopilot = service.autopilot
    return autopilot.current if hasattr(autopilot, "current") else autopilot.missions.current


def start(service, item: int = 0, limit_s: float = 30.0) -> str:
    service.begun.clear()
    service.order_of("start", item)
    return service.done(limit_s)


def told(service) -> list[tuple]:
    """What the autopilot was told to do; not what it was asked."""
    return [(one.command, one.param1, one.param2) for one in service.heard("COMMAND_LONG", "COMMAND_INT")
            if one.command not in (REQUEST_MESSAGE, ASK_VEHICLE)]  # fmt: skip


def expect_flying_from(service, vehicle: str, item: int) -> None:
    """What Done says: armed, in its mission mode, and this item is the first that is flown."""
    service.run(1.2)
    assert service.state.armed and service.state.modes == ["Auto"]
    assert service.state.arming == "Armed"
    assert service.begun[0] == item, f"it begins with item {service.begun[0]}"
    assert service.autopilot.flight.index is not None


# Near where each fake stands, and short.
HOPS = {
    "ArduPilot": [item(22, x=-353632620, y=1491652370, z=5.0), waypoint(-353632720, 1491652370, 5.0),
                  item(21, x=-353632720, y=1491652370)],
    "PX4": [item(22, x=473977428, y=85455937, z=5.0, param4=NAN), waypoint(473978428, 85455937, 5.0),
            item(21, x=473978428, y=85455937)],
}  # fmt: skip


def uploaded(service, plan=None, **options):
    service.upload(plan or HOPS["PX4" if hasattr(service.autopilot, "main_mode") else "ArduPilot"], **options)
    assert service.done(limit_s=20) == "Accepted"
    return service


def is_flying(service) -> bool:
    """Or has flown, while it was asked once more."""
    autopilot = service.autopilot
    return autopilot.armed and (autopilot.flight.index is not None or autopilot.complete)


LANDING_FIRST = [item(21, x=473977428, y=85455937), waypoint(473978428, 85455937)]


def know_vehicle(service, personality: str) -> None:
    """Have the client ask an ArduPilot whether it is a plane, as it does once, by a mode in which it is already."""
    if personality == "ArduPilot":
        service.set_mode("Manual")
        assert service.done() == "Done"
