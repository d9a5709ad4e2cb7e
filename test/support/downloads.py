"""What the tests of downloads and of verify() share: a plan that comes back as written, and how it is put aboard."""

from __future__ import annotations

from plans import HOME, NAN, jump, waypoint
from simulation.fake_autopilot import item, mavlink

# As a sketch writes it, with nothing in it that an autopilot drops, but for the altitudes' millimetres.
WRITTEN = [
    item(22, x=473977420, y=85455970, z=20.0, param4=NAN),
    waypoint(473979420, 85455970, z=20.25, param1=3.0, param4=NAN),
    item(178, frame=2, param1=1.0, param2=4.5, param3=-1.0),
    waypoint(-473979420, -1785459970, z=25.5, param4=NAN),
    jump(1, 3),
    item(93, frame=2, param1=5.0, param2=-1.0, param3=-1.0, param4=-1.0),
    waypoint(473977420, 85459970, z=600.0, frame=0, param4=NAN),
    item(20, frame=2),
]


def same(ones, others) -> bool:
    return len(ones) == len(others) and all(one.same_as(other) for one, other in zip(ones, others, strict=True))


def loaded(service, plan):
    """Put a plan aboard as another ground station would have."""
    service.autopilot.load([HOME, *as_ardupilot_has_it(plan)] if is_ardupilot(service) else plan)


def is_ardupilot(service) -> bool:
    return service.autopilot.autopilot_type == mavlink.MAV_AUTOPILOT_ARDUPILOTMEGA


def as_ardupilot_has_it(plan):
    """Jumps count home too."""
    return [one._replace(param1=one.param1 + 1) if one.command == 177 else one for one in plan]
