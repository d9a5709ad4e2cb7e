"""What one ArduPilot vehicle does otherwise than the next."""
from typing import NamedTuple

from .flight import Pace

_BY_ITSELF = frozenset(("AUTO", "GUIDED", "LOITER", "RTL", "LAND", "BRAKE"))


class Vehicle(NamedTuple):
    """Copter and Rover as recorded, the others by source."""

    modes: dict[str, int]  # name -> HEARTBEAT.custom_mode
    first_mode: str  # after power-on
    pace: Pace
    not_ready: str  # why it will not be armed in its first half minute
    armed: str  # what it says when it has been armed
    disarmed: str
    reached: str  # what it says at a waypoint
    auto_refused: str  # what it says last when AUTO is not to be had
    no_plan: str | None = None  # and before that, without a plan
    not_armed_in: frozenset = frozenset()  # modes
    # In AUTO, armed and on the ground, it begins with nothing but a takeoff, and waits for MISSION_START to do that.
    needs_takeoff: bool = False
    disarms_idle_s: float | None = None  # on the ground, after so long
    ready_s: float = 30.0  # from power-on to the first arming
    position_s: float = 0.0  # and from there to a position good enough for the modes that need one
    land_mode: str | None = None  # in which it comes down and disarms
    always_stabilized: bool = False  # HEARTBEAT's flags: stabilised in each mode, and deaf to the pilot in none
    complete: str | None = None  # what it says at the end of the plan
    by_itself: frozenset = _BY_ITSELF  # the modes with HEARTBEAT's flag GUIDED
    idle_modes: frozenset | None = None  # those in which HEARTBEAT says STANDBY; None: in any, on the ground
    manual_modes: frozenset = frozenset(("MANUAL",))
    is_plane: bool = False
    hovers: bool = False  # a plane that takes off upwards by NAV_TAKEOFF, in GUIDED


_PLANE = Vehicle(
    modes={"MANUAL": 0, "TRAINING": 3, "FBWA": 5, "FBWB": 6, "AUTO": 10, "RTL": 11, "LOITER": 12, "GUIDED": 15},
    first_mode="MANUAL",
    pace=Pace(acceleration=3.0, speed=22.0, climb=5.0, descent=3.0, spool_up_s=3.0),
    not_ready="Arm: AHRS: waiting for home", armed="Throttle armed", disarmed="Throttle disarmed",
    reached="Reached waypoint #{}", auto_refused="Flight mode change failed",
    manual_modes=frozenset(("MANUAL", "TRAINING", "FBWA", "FBWB", "AUTO", "RTL", "LOITER", "GUIDED")), is_plane=True)

VEHICLES = {
    "copter": Vehicle(
        modes={"STABILIZE": 0, "ALT_HOLD": 2, "AUTO": 3, "GUIDED": 4, "LOITER": 5, "RTL": 6,
               "LAND": 9, "BRAKE": 17},
        first_mode="STABILIZE",
        pace=Pace(acceleration=1.14, speed=10.0, climb=1.45, descent=0.8, spool_up_s=2.0),
        not_ready="Arm: AHRS: waiting for home", armed="Arming motors", disarmed="Disarming motors",
        reached="Reached command #{}", auto_refused="Mode change to AUTO failed: init failed",
        not_armed_in=frozenset(("AUTO", "RTL", "LAND")), needs_takeoff=True, disarms_idle_s=10.0,
        land_mode="LAND", always_stabilized=True),
    "rover": Vehicle(
        modes={"MANUAL": 0, "HOLD": 4, "LOITER": 5, "AUTO": 10, "RTL": 11, "GUIDED": 15},
        first_mode="MANUAL",
        pace=Pace(acceleration=1.0, speed=2.0, climb=1.0, descent=1.0, spool_up_s=0.0, flies=False),
        not_ready="Arm: AHRS: not using configured AHRS type", armed="Throttle armed",
        disarmed="Throttle disarmed", reached="Reached waypoint #{}",
        auto_refused="Flight mode change failed", no_plan="No Mission. Can't set AUTO.",
        position_s=10.0, complete="Mission Complete", idle_modes=frozenset(("HOLD",))),
    "plane": _PLANE,
    "quadplane": _PLANE._replace(
        modes={**_PLANE.modes, "QLOITER": 19, "QLAND": 20, "QRTL": 21}, hovers=True, land_mode="QLAND",
        pace=Pace(acceleration=3.0, speed=22.0, climb=2.5, descent=1.5, spool_up_s=3.0)),
    "sub": Vehicle(
        modes={"STABILIZE": 0, "ALT_HOLD": 2, "AUTO": 3, "GUIDED": 4, "SURFACE": 9, "POSHOLD": 16, "MANUAL": 19},
        first_mode="MANUAL",
        pace=Pace(acceleration=1.0, speed=1.0, climb=0.5, descent=0.5, spool_up_s=0.0, flies=False),
        not_ready="Arm: AHRS: waiting for home", armed="Arming motors", disarmed="Disarming motors",
        reached="Reached command #{}", auto_refused="Flight mode change failed", idle_modes=frozenset()),
    "blimp": Vehicle(
        modes={"LAND": 0, "MANUAL": 1, "VELOCITY": 2, "LOITER": 3, "RTL": 4},
        first_mode="MANUAL",
        pace=Pace(acceleration=1.0, speed=2.0, climb=0.5, descent=0.5, spool_up_s=0.0),
        not_ready="Arm: AHRS: waiting for home", armed="Arming motors", disarmed="Disarming motors",
        reached="Reached command #{}", auto_refused="Flight mode change failed"),
}
