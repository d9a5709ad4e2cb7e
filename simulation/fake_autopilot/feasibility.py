"""Whether PX4 will fly a plan that it has accepted (by source)."""
from collections.abc import Sequence

from .flight import DELAY, JUMP, LAND, TAKEOFF, VTOL_LAND, VTOL_TAKEOFF
from .items import Item
from .px4_rewriting import AT_A_PLACE

_ABSOLUTE = (0, 5)
_RETURN = 20


def objection(items: Sequence[Item], home_altitude: float, landed: bool = True,
              takeoff_required: bool = False) -> str | None:
    """Why the plan will not be flown, in PX4's words; None if it will be.

    home_altitude [m above sea level]. takeoff_required stands for its parameter
    MIS_TKO_LAND_REQ, which is off by default.
    """
    if not items:
        return None
    if items[0].command == LAND and landed:
        return "Mission rejected: starts with landing"
    place_before = takeoff_found = False
    for item in items:
        if item.command in (TAKEOFF, VTOL_TAKEOFF):
            height = item.z - home_altitude if item.frame in _ABSOLUTE else item.z
            if height < 1e-6:
                return "Mission rejected: Takeoff altitude below home altitude!"
            if place_before:
                return "Mission rejected: takeoff not first waypoint item"
            takeoff_found = True
        if item.command == _RETURN or (item.command in AT_A_PLACE
                                       and item.command not in (DELAY, JUMP)):
            place_before = True
    if takeoff_required and landed and not takeoff_found:
        return "Mission rejected: Takeoff waypoint required."
    if takeoff_required and items[-1].command not in (LAND, VTOL_LAND, _RETURN):
        return "Mission rejected: Landing waypoint/pattern required."
    return None
