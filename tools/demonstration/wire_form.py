"""What must arrive at an autopilot for a plan to mean there what it means in the sketch: what the library sends of it.

That this is right for each autopilot is shown elsewhere, by what real ones kept of it (simulation/recordings).
"""

from __future__ import annotations

from planning import Item as PlannedItem
from planning import judge
from simulation.fake_autopilot import Item, mavlink

from .words import HOME


def on_the_wire(plan: list[Item], autopilot: str, vehicle: int = mavlink.MAV_TYPE_QUADROTOR) -> list[Item]:
    """The items of a mission that must arrive, at "ardupilot" home before them. `vehicle`: a MAV_TYPE. An item that the
    library refuses is as it was: it is not sent, and neither is the plan."""
    if not plan:
        return []
    sent = judge.on_the_wire([PlannedItem._make(item) for item in plan], autopilot, vehicle)
    items = [item if made is None else Item._make(made) for item, made in zip(plan, sent, strict=True)]
    return [HOME, *items] if autopilot == "ardupilot" else items
