"""What a test says to the firmware in an autopilot's name, on a line where nobody else speaks."""

from __future__ import annotations

from simulation.fake_autopilot import mavlink

AUTOPILOT = (1, 1)
US = (1, mavlink.MAV_COMP_ID_ONBOARD_COMPUTER)


def heartbeat(autopilot: int = mavlink.MAV_AUTOPILOT_PX4, kind: int = mavlink.MAV_TYPE_QUADROTOR, base_mode: int = 0):
    return mavlink.MAVLink_heartbeat_message(kind, autopilot, base_mode, 0, mavlink.MAV_STATE_STANDBY, 3)


def request_int(seq: int, to: tuple[int, int] = US, mission_type: int = 0):
    return mavlink.MAVLink_mission_request_int_message(*to, seq, mission_type)


def request(seq: int, to: tuple[int, int] = US, mission_type: int = 0):
    return mavlink.MAVLink_mission_request_message(*to, seq, mission_type)


def ack(result: int = 0, to: tuple[int, int] = US, mission_type: int = 0, opaque_id: int = 0):
    return mavlink.MAVLink_mission_ack_message(*to, result, mission_type, opaque_id)


def find(line, autopilot: int = mavlink.MAV_AUTOPILOT_PX4, version: int = 2) -> None:
    """Let the firmware hear two heartbeats, after which it is sure of its autopilot."""
    for _ in range(2):
        line.say(heartbeat(autopilot), AUTOPILOT, version)
        line.run(0.7)
