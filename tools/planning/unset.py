"""Parameters that may be unset, and mean something else then than if they were 0."""

from __future__ import annotations

# By command. A yaw is "as you fly" and not
# north, an actuator or a gimbal's angle is left as it is, home keeps the heading that the autopilot has.
UNSET_IS_NOT_0 = {
    **dict.fromkeys((16, 17, 21, 22, 84, 85), {4}),  # NAV_...
    179: {2, 3, 4},  # DO_SET_HOME
    187: {1, 2, 3, 4, 5, 6},  # DO_SET_ACTUATOR
    1000: {1, 2, 3, 4},  # DO_GIMBAL_MANAGER_PITCHYAW
}


def is_unset_not_0(command: int, number: int) -> bool:
    """Whether parameter `number` may be unset, and must then not be taken for 0."""
    return number in UNSET_IS_NOT_0.get(command, ())
