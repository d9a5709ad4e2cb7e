"""What an autopilot at rest says of itself: attitude, GPS, battery, remote control, sensors, estimator, vibration.

Values as recorded, but for PX4's wind, which no recording has.
"""
import math
from dataclasses import dataclass, field

from . import ardupilot_dialect
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
    present: int = 0x5371FC2F  # sensors: MAV_SYS_STATUS_SENSOR
    enabled: int = 0x5361FC2F
    healthy: int = 0x5771FC2F
    is_ardupilot: bool = True  # EKF_STATUS_REPORT and WIND, not ESTIMATOR_STATUS and WIND_COV
    flags: int = 0x033F  # of the estimator
    # Of velocity, place, height, compass.
    ratios: list[float] = field(default_factory=lambda: [0.051, 0.016, 0.012, 0.022])
    vibration: list[float] = field(default_factory=lambda: [0.003, 0.003, 0.003])  # [m/s^2]
    clipping: int = 0
    wind: list[float] = field(default_factory=lambda: [-180.0, 0.0, 0.0])  # as in the message
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
        if identity == mavlink.MAVLINK_MSG_ID_SYS_STATUS:
            return mavlink.MAVLink_sys_status_message(
                self.present, self.enabled, self.healthy, 250, round(1000 * self.volts), self.current_ca,
                self.remaining, 0, 0, 0, 0, 0, 0)
        if identity == mavlink.MAVLINK_MSG_ID_VIBRATION:
            return mavlink.MAVLink_vibration_message(boot_ms * 1000, *self.vibration, self.clipping, 0, 0)
        return self._message_of_either(identity, boot_ms)

    def _message_of_either(self, identity: int, boot_ms: int):
        if self.is_ardupilot and identity == ardupilot_dialect.EKF_STATUS_REPORT:
            return ardupilot_dialect.ekf_status_report(self.flags, *self.ratios)
        if self.is_ardupilot and identity == ardupilot_dialect.WIND:
            return ardupilot_dialect.wind(*self.wind)
        if not self.is_ardupilot and identity == mavlink.MAVLINK_MSG_ID_ESTIMATOR_STATUS:
            return mavlink.MAVLink_estimator_status_message(
                boot_ms * 1000, self.flags, *self.ratios, 0.0, 0.0, 0.3, 0.2)
        if not self.is_ardupilot and identity == mavlink.MAVLINK_MSG_ID_WIND_COV:
            return mavlink.MAVLink_wind_cov_message(boot_ms * 1000, *self.wind, 0.5, 0.5, 400.0, 0.1, 0.0)
        return None


def of_ardupilot() -> Instruments:
    """As ArduCopter in its simulator, which has a remote control."""
    return Instruments(fix_type=mavlink.GPS_FIX_TYPE_RTK_FIXED,
                       rc=[1500, 1500, 1000, 1500, 1800, 1000, 1000, 1800])


def of_px4() -> Instruments:
    """As PX4 in its simulator: no remote control, and a current that is not measured."""
    return Instruments(volts=16.2, current_ca=-100, consumed_mah=-149, airspeed=math.nan, tells_target=False,
                       is_ardupilot=False, present=0x300402F, enabled=0x301402F, healthy=0x1320C83F,
                       ratios=[0.1, 0.2, 0.05, 0.1], vibration=[0.0, 0.011, 0.113], wind=[3.0, -4.0, 0.25])
