"""What an autopilot at rest says of itself: attitude, GPS, battery, remote control. Values as recorded."""
import math
from dataclasses import dataclass, field

from .dialect import mavlink
from .flight import Place

NO_CELL = 65535
NOT_MEASURED_C = 32767


@dataclass
class Instruments:
    """Tests set other values. rc: the channels [us]; none: no receiver, and RC_CHANNELS is not sent."""

    roll: float = 0.0012  # [rad]
    pitch: float = -0.0019
    yaw: float = -0.0141
    fix_type: int = mavlink.GPS_FIX_TYPE_3D_FIX
    satellites: int = 10
    volts: float = 12.6
    current_ca: int = 0  # [10 mA]; below 0: not measured
    consumed_mah: int = 0
    remaining: int = 100  # [%]
    rc: list[int] = field(default_factory=list)
    rssi: int = 255
    airspeed: float = 0.05  # [m/s]
    tells_target: bool = True  # NAV_CONTROLLER_OUTPUT; in PX4's recordings of a copter there is none

    def message_of(self, identity: int, boot_ms: int, place: Place, altitude_mm: int):
        """The message of this id; None for one that is not about these, or has nothing to tell."""
        if identity == mavlink.MAVLINK_MSG_ID_ATTITUDE:
            return mavlink.MAVLink_attitude_message(boot_ms, self.roll, self.pitch, self.yaw, 0.0003, 0.0002, 0.0025)
        if identity == mavlink.MAVLINK_MSG_ID_GPS_RAW_INT:
            return mavlink.MAVLink_gps_raw_int_message(
                boot_ms * 1000, self.fix_type, place.lat_e7, place.lon_e7, altitude_mm, 70, 110, 5, 16851,
                self.satellites, altitude_mm, 900, 1780, 400, 0, 0)
        if identity == mavlink.MAVLINK_MSG_ID_BATTERY_STATUS:
            cells = [round(1000 * self.volts), *[NO_CELL] * 9]
            return mavlink.MAVLink_battery_status_message(
                0, 0, 0, NOT_MEASURED_C, cells, self.current_ca, self.consumed_mah, -1, self.remaining,
                0, 0, [0] * 4, 0, 0)
        if identity == mavlink.MAVLINK_MSG_ID_VFR_HUD:
            return mavlink.MAVLink_vfr_hud_message(self.airspeed, 0.12, 359, 0, altitude_mm / 1000, -0.03)
        if identity == mavlink.MAVLINK_MSG_ID_NAV_CONTROLLER_OUTPUT and self.tells_target:
            return mavlink.MAVLink_nav_controller_output_message(0, 0, -90, -90, 120, 0, 0, -1.5)
        if identity == mavlink.MAVLINK_MSG_ID_RC_CHANNELS and self.rc:
            return mavlink.MAVLink_rc_channels_message(
                boot_ms, len(self.rc), *self.rc, *[0] * (18 - len(self.rc)), self.rssi)
        return None


def of_ardupilot() -> Instruments:
    """As ArduCopter in its simulator, which has a remote control."""
    return Instruments(fix_type=mavlink.GPS_FIX_TYPE_RTK_FIXED,
                       rc=[1500, 1500, 1000, 1500, 1800, 1000, 1000, 1800])


def of_px4() -> Instruments:
    """As PX4 in its simulator: no remote control, and a current that is not measured."""
    return Instruments(volts=16.2, current_ca=-100, consumed_mah=-149, airspeed=math.nan, tells_target=False)
