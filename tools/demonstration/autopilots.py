"""The autopilots that an example is shown with."""

from __future__ import annotations

from simulation.fake_autopilot import FENCE, MISSION, RALLY, ArduPilot, FakeAutopilot, Px4, item, mavlink
from simulation.recordings import repeated

NAMES = {"ardupilot": "ArduPilot", "px4": "PX4"}
KINDS = {MISSION: "plan", FENCE: "fence", RALLY: "rally points"}

EXAMPLES_FLY_AT = (-353632621, 1491652374, 584.0)  # latitude, longitude [1e-7 degrees], altitude [m]

# What an autopilot holds before an example that only reads.
HELD = [
    item(mavlink.MAV_CMD_NAV_TAKEOFF, x=-353632621, y=1491652374, z=20.0),
    item(mavlink.MAV_CMD_NAV_WAYPOINT, x=-353614500, y=1491652374, z=25.0),
    item(mavlink.MAV_CMD_NAV_RETURN_TO_LAUNCH, frame=mavlink.MAV_FRAME_MISSION),
]


def an_autopilot(name: str, vehicle: str = "copter", **options) -> FakeAutopilot:
    """With what it sends unasked on a telemetry port; the line's own time is the simulator's."""
    if name == "px4":
        return Px4(
            telemetry=repeated("px4/clean_with_streams"), response_delay_s=Px4.response_delay_on_line_s, **options
        )
    return ArduPilot(vehicle=vehicle, response_delay_s=ArduPilot.response_delay_on_line_s, **options)


def one_to_fly(
    name: str, vehicle: str = "copter", *, home: tuple[int, int, float] = EXAMPLES_FLY_AT, uptime_s: float = 60.0
) -> FakeAutopilot:
    """Ready to be armed. It tells where it is, and no more than that."""
    if name == "px4":
        return Px4(response_delay_s=Px4.response_delay_on_line_s, home=home, uptime_s=uptime_s)
    delay_s = ArduPilot.response_delay_on_line_s
    return ArduPilot(vehicle=vehicle, response_delay_s=delay_s, home=home, uptime_s=uptime_s)
