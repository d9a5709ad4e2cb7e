"""What somebody else does in the middle of a run: a pilot, a low battery, a ground station."""

from __future__ import annotations

import math
from typing import Any

from demonstration.words import HOME
from simulation.fake_autopilot import MISSION, Item, item, mavlink

STATION = (255, 190)  # its system and its component
MEGA = (1, 191)
ROPE_M = 2
PX4_POSITION, PX4_RETURN, PX4_LAND = (3, 0), (4, 5), (4, 6)  # PX4's main and sub mode


def pilots_numbers(autopilot: Any) -> tuple[int, ...]:
    kind = getattr(autopilot, "kind", None)
    return (kind.modes["LOITER"],) if kind else PX4_POSITION


def numbers_of_mode(autopilot: Any) -> tuple[int, ...]:
    kind = getattr(autopilot, "kind", None)
    return (kind.modes[autopilot.mode],) if kind else (autopilot.main_mode, autopilot.sub_mode)


def is_pilots(autopilot: Any) -> bool:
    """A pilot has taken it, and it is in his mode still."""
    return getattr(autopilot, "taken_from", None) is not None and (
        numbers_of_mode(autopilot) == pilots_numbers(autopilot)
    )


def pilot_turns_the_switch(autopilot: Any, now: float) -> str:
    """Of the remote control: to his mode, and from it back to the mode of before; in words."""
    gives_back = is_pilots(autopilot)
    numbers = autopilot.taken_from if gives_back else pilots_numbers(autopilot)
    autopilot.taken_from = None if gives_back else numbers_of_mode(autopilot)
    autopilot.at("pilot", now, lambda time: autopilot._set_mode(*numbers, time))
    if gives_back:
        return "the pilot sets the mode of before again"
    return f"a pilot sets {'LOITER' if hasattr(autopilot, 'kind') else 'POSCTL'}"


def pilot_lands(autopilot: Any, now: float) -> str:
    """And it disarms on the ground; in words."""
    if not autopilot.armed:
        return "the pilot lands: it is disarmed already"
    kind = getattr(autopilot, "kind", None)
    numbers = (kind.modes[kind.land_mode],) if kind else PX4_LAND
    autopilot.at("pilot", now, lambda time: autopilot._set_mode(*numbers, time))
    return "the pilot lands: he sets LAND"


def battery_is_low(autopilot: Any, now: float) -> str:
    """An autopilot in flight returns; in words."""
    if not (autopilot.armed and autopilot.flight.airborne(now)):
        return "the battery is low: on the ground nothing happens"
    kind = getattr(autopilot, "kind", None)
    numbers = (kind.modes["RTL"],) if kind else PX4_RETURN

    def fail(time: float) -> None:
        autopilot._set_mode(*numbers, time)
        if not kind:
            autopilot.in_failsafe = True

    autopilot.at("failsafe", now, fail)
    return "the battery is low: the autopilot returns"


def other_station_uploads(autopilot: Any, now: float) -> str:
    """A short plan by a line of its own, in the steps of the protocol; in words."""
    home = autopilot.flight.home
    plan = [
        item(mavlink.MAV_CMD_NAV_TAKEOFF, x=home.lat_e7, y=home.lon_e7, z=15.0),
        item(mavlink.MAV_CMD_NAV_WAYPOINT, x=home.lat_e7 + 4000, y=home.lon_e7, z=15.0),
        item(mavlink.MAV_CMD_NAV_RETURN_TO_LAUNCH, frame=mavlink.MAV_FRAME_MISSION),
    ]
    count = len(plan)
    sent = [HOME, *plan] if hasattr(autopilot, "kind") else plan
    packer = mavlink.MAVLink(None, *STATION)
    messages = [mavlink.MAVLink_mission_count_message(*autopilot.address, len(sent), MISSION)]
    messages += [as_message(seq, one, autopilot.address) for seq, one in enumerate(sent)]
    for message in messages:
        autopilot.receive(message.pack(packer), now, elsewhere=True)
    return f"another ground station uploads its {count} items"


def station_orders(autopilot: Any, now: float) -> str:
    """A winch, of the Mega's component, as the autopilot forwards it; in words."""
    order = mavlink.MAVLink_command_long_message(
        *MEGA, mavlink.MAV_CMD_DO_WINCH, 0, 1, mavlink.WINCH_RELATIVE_LENGTH_CONTROL, ROPE_M, 0, 0, 0, 0
    )
    autopilot.send_raw(order.pack(mavlink.MAVLink(None, *STATION)), now)
    return f"a ground station sends DO_WINCH: {ROPE_M} m of rope"


def as_message(seq: int, one: Item, to: tuple[int, int]) -> Any:
    params = (0.0 if math.isnan(value) else value for value in one[4:8])
    return mavlink.MAVLink_mission_item_int_message(
        *to, seq, one.frame, one.command, one.current, one.autocontinue, *params, one.x, one.y, one.z, MISSION
    )
