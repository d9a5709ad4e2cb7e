"""Messages of ArduPilot's own dialect (ardupilotmega.xml), which tools/mavlink does not have, for encoding only."""
import struct

from .dialect import mavlink

EKF_STATUS_REPORT = 193
WIND = 168


class OfArduPilot(mavlink.MAVLink_message):
    """A message from its payload as it lies on the wire."""

    def __init__(self, identity: int, name: str, crc_extra: int, payload: bytes) -> None:
        super().__init__(identity, name)
        self.crc_extra = crc_extra
        self.payload = payload

    def pack(self, mav, force_mavlink1: bool = False) -> bytes:
        return self._pack(mav, self.crc_extra, self.payload, force_mavlink1=force_mavlink1)


def ekf_status_report(flags: int, velocity: float, place: float, height: float, compass: float) -> OfArduPilot:
    """flags: EKF_STATUS_FLAGS; the others are variances, without a unit."""
    return OfArduPilot(EKF_STATUS_REPORT, "EKF_STATUS_REPORT", 71,
                       struct.pack("<5fHf", velocity, place, height, compass, 0.0, flags, 0.0))


def wind(direction: float, speed: float, down: float) -> OfArduPilot:
    """direction: from which it comes [degrees]; speeds [m/s]."""
    return OfArduPilot(WIND, "WIND", 1, struct.pack("<3f", direction, speed, down))
