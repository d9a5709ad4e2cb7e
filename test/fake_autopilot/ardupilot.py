"""ArduPilot 4.6.3: its modes, its commands, its flight, around its mission protocol."""
import math
from typing import Iterable, Optional

from .ardupilot_missions import Missions
from .autopilot import TEXT_LAG_S, Address, FakeAutopilot
from .dialect import mavlink
from .flight import TAKEOFF, Flight, Pace, Place
from .items import FENCE, MISSION, RALLY, Item, f32, whole_number

BOOT_TEXT = b"\r\n\r\nInit ArduCopter V4.6.3\r\n\r\nFree RAM: 262144\r\n"

WARNING = mavlink.MAV_SEVERITY_WARNING
INFO = mavlink.MAV_SEVERITY_INFO
CRITICAL = mavlink.MAV_SEVERITY_CRITICAL

RESULT_ACCEPTED = mavlink.MAV_RESULT_ACCEPTED
RESULT_DENIED = mavlink.MAV_RESULT_DENIED
RESULT_UNSUPPORTED = mavlink.MAV_RESULT_UNSUPPORTED
RESULT_FAILED = mavlink.MAV_RESULT_FAILED

MODES = {
    "copter": {"STABILIZE": 0, "ALT_HOLD": 2, "AUTO": 3, "GUIDED": 4, "LOITER": 5, "RTL": 6,
               "LAND": 9, "BRAKE": 17},
    "rover": {"MANUAL": 0, "HOLD": 4, "LOITER": 5, "AUTO": 10, "RTL": 11, "GUIDED": 15},
    "plane": {"MANUAL": 0, "FBWA": 5, "AUTO": 10, "RTL": 11, "LOITER": 12, "GUIDED": 15},
}
_FIRST_MODE = {"copter": "STABILIZE", "rover": "MANUAL", "plane": "MANUAL"}
_GUIDED_BY_ITSELF = ("AUTO", "GUIDED", "LOITER", "RTL", "LAND", "BRAKE")

PACES = {
    "copter": Pace(acceleration=1.14, speed=10.0, climb=1.45, descent=0.8, spool_up_s=2.0),
    "rover": Pace(acceleration=1.0, speed=2.0, climb=1.0, descent=1.0, spool_up_s=0.0),
    "plane": Pace(acceleration=3.0, speed=22.0, climb=5.0, descent=3.0, spool_up_s=3.0),
}

# What it calls an item in its texts. The first four are seen, the others by source.
_ITEM_NAMES = {16: "WP", 22: "Takeoff", 20: "RTL", 21: "Land", 17: "LoitUnlim",
               18: "LoitTurns", 19: "LoitTime", 31: "LoitAltitude", 82: "SplineWP",
               93: "Delay", 94: "PayloadPlace", 112: "CondDelay", 115: "CondYaw",
               177: "Jump", 178: "ChangeSpeed", 181: "SetRelay", 183: "SetServo"}

TIMESYNC_PERIOD_S = 10.0
RUNTIME_PERIOD_S = 30.0
ARMING_REFUSED_S = 30.0
DISARM_AFTER_LANDING_S = 2.0
PARAM_COUNT = 1375

MISSION_CURRENT = mavlink.MAVLINK_MSG_ID_MISSION_CURRENT
GLOBAL_POSITION_INT = mavlink.MAVLINK_MSG_ID_GLOBAL_POSITION_INT
_STREAMS = {0: (MISSION_CURRENT, GLOBAL_POSITION_INT),  # MAV_DATA_STREAM_ALL
            2: (MISSION_CURRENT,), 6: (GLOBAL_POSITION_INT,)}

# Of its own dialect, and in its streams: MEMINFO, AHRS, SIMSTATE, WIND, AHRS2, EKF_STATUS_REPORT.
_ARDUPILOTMEGA = {152, 163, 164, 168, 178, 193}


class ArduPilot(FakeAutopilot):
    """ArduCopter, ArduRover or ArduPlane.

    home: (latitude [1e-7 degrees], longitude [1e-7 degrees], altitude [m]); None until one
    is set. item_limit, fence_limit, rally_limit: how many items it has room for; only the
    650 of the mission is known. radio_slowdown_s: how much later than after one second it
    asks again, as behind a slow radio.
    """

    autopilot_type = mavlink.MAV_AUTOPILOT_ARDUPILOTMEGA
    response_delay_s = 0.017
    response_delay_on_line_s = 0.006
    # On a full line of 57600 baud an item that is read comes 163 ms after its request, instead of 17: seen.
    transmit_buffer_seen = 800

    def __init__(self, *, item_limit: int = 650, fence_limit: int = 84, rally_limit: int = 84,
                 home: Optional[tuple[int, int, float]] = (-353632620, 1491652370, 584.09),
                 armed: bool = False, mode: Optional[str] = None, radio_slowdown_s: float = 0.0,
                 **options) -> None:
        super().__init__(**options)
        self.home = home
        self.radio_slowdown_s = radio_slowdown_s
        self.armed = armed
        self.mode = mode or _FIRST_MODE[self.vehicle]
        if self.mode not in MODES[self.vehicle]:
            raise ValueError(f"a {self.vehicle}'s mode is one of {', '.join(MODES[self.vehicle])}"
                             f", not {self.mode}")
        self.current = 0  # the item that MISSION_CURRENT tells of
        self.complete = False
        self.guided_targets: list[tuple[float, Item]] = []
        self._may_take_off = armed
        self._seen: set[Address] = set()
        self.missions = {MISSION: Missions(self, MISSION, item_limit),
                         FENCE: Missions(self, FENCE, fence_limit),
                         RALLY: Missions(self, RALLY, rally_limit)}
        lat, lon, altitude = home or (0, 0, 0.0)
        self.flight = Flight(PACES[self.vehicle], Place(lat, lon, 0.0), altitude,
                             lambda: self.missions[MISSION].held,
                             self._item_begun, self._item_reached, self._plan_over)
        self._hears = {
            "MISSION_COUNT": self._to_missions(Missions.on_count),
            "MISSION_ITEM_INT": self._to_missions(Missions.on_item),
            "MISSION_ITEM": self._to_missions(Missions.on_item),
            "MISSION_WRITE_PARTIAL_LIST": self._to_missions(Missions.on_write_partial_list),
            "MISSION_REQUEST_LIST": self._to_missions(Missions.on_request_list),
            "MISSION_REQUEST_INT": self._to_missions(Missions.on_request),
            "MISSION_REQUEST": self._to_missions(Missions.on_request),
            "MISSION_CLEAR_ALL": self._to_missions(Missions.on_clear),
            "MISSION_SET_CURRENT": self._on_set_current,
            "COMMAND_LONG": self._on_command,
            "COMMAND_INT": self._on_command,
            "SET_MODE": self._on_set_mode,
            "REQUEST_DATA_STREAM": self._on_request_data_stream,
        }
        self._start_timers(0.0)

    def thinned_by(self) -> int:
        # By source: streams come at a quarter of their rate while it asks for items; not while it is read.
        return 4 if any(missions.receiving for missions in self.missions.values()) else 1

    # -- the plan -------------------------------------------------------------------------

    def plan(self, mission_type: int = MISSION) -> list[Item]:
        return self.missions[mission_type].as_read()

    def received(self, mission_type: int = MISSION) -> list[Item]:
        return list(self.missions[mission_type].received)

    def load(self, items: Iterable[Item], mission_type: int = MISSION) -> None:
        self.missions[mission_type].load(list(items))

    def home_item(self) -> Item:
        """Item 0 as it is read: the current home, to the centimetre."""
        lat, lon, altitude = self.home or (0, 0, 0.0)
        return Item(0, mavlink.MAV_CMD_NAV_WAYPOINT, 0, 1, 0.0, 0.0, 0.0, 0.0, lat, lon,
                    f32(round(altitude * 100) * f32(0.01)))

    def is_flying_plan(self) -> bool:
        return self.armed and self.flight.index is not None

    def plan_changed(self, now: float) -> None:
        """A rover begins its leg again; the others keep on."""
        self.complete = False
        if not self.missions[MISSION].held:
            self.current = 0
        if self.vehicle == "rover" and self.is_flying_plan():
            self._fly_from(self.flight.index, now)

    def fly_there_now(self, item: Item, now: float) -> None:
        """An item whose `current` is 2 or 3 is an order (by source), not part of a plan."""
        self.guided_targets.append((now, item))

    # -- what it hears --------------------------------------------------------------------

    def _hear(self, message, now: float) -> None:
        sender = (message.get_srcSystem(), message.get_srcComponent())
        if sender == self.address:
            return  # taken for itself
        self._seen.add(sender)
        if self._is_for_us(message):
            super()._hear(message, now)

    def _is_for_us(self, message) -> bool:
        """Its router hands on what is for a component it has seen, and keeps the rest."""
        system = getattr(message, "target_system", 0)
        component = getattr(message, "target_component", 0)
        if system == 0:
            return True
        if system != self.address[0]:
            return False
        return component in (0, self.address[1]) or (system, component) not in self._seen

    def _to_missions(self, react):
        def hear(message, sender, now: float) -> None:
            missions = self.missions.get(message.mission_type)
            if missions is None:
                self.answer(mavlink.MAVLink_mission_ack_message(
                    *sender, mavlink.MAV_MISSION_UNSUPPORTED, message.mission_type), now)
                return
            react(missions, message, sender, now)
        return hear

    def _on_set_current(self, message, sender, now: float) -> None:
        if self._set_current(message.seq, now):
            self.answer(self._mission_current(), now)

    def _set_current(self, seq: int, now: float) -> bool:
        if not 0 <= seq < len(self.missions[MISSION].held):
            return False
        self.current = max(seq, 1) if len(self.missions[MISSION].held) > 1 else 0
        self.complete = False
        if self.is_flying_plan():
            self._fly_from(self.current, now)
        return True

    def _on_request_data_stream(self, message, sender, now: float) -> None:
        for identity in _STREAMS.get(message.req_stream_id, ()):
            on = message.start_stop and message.req_message_rate
            self.default_stream(identity, 1.0 / message.req_message_rate if on else 0.0, now)

    def _on_set_mode(self, message, sender, now: float) -> None:
        """SET_MODE has no acknowledgement: the next HEARTBEAT tells."""
        self._set_mode(message.custom_mode, now)

    # -- commands -------------------------------------------------------------------------

    def _on_command(self, message, sender, now: float) -> None:
        act = {
            mavlink.MAV_CMD_COMPONENT_ARM_DISARM: self._arm_or_disarm,
            mavlink.MAV_CMD_DO_SET_MODE: self._do_set_mode,
            mavlink.MAV_CMD_MISSION_START: self._mission_start,
            mavlink.MAV_CMD_DO_SET_MISSION_CURRENT: self._do_set_mission_current,
            mavlink.MAV_CMD_SET_MESSAGE_INTERVAL: self._set_message_interval,
            mavlink.MAV_CMD_REQUEST_MESSAGE: self._request_message,
        }.get(message.command)
        result = RESULT_UNSUPPORTED if act is None else act(message, now)
        self.answer(mavlink.MAVLink_command_ack_message(
            message.command, result, 0, 0, *sender), now)

    def _arm_or_disarm(self, message, now: float) -> int:
        if message.param1 == 0:
            if self.armed and self.flight.airborne(now):
                return RESULT_FAILED
            if self.armed:
                self._disarm(now)
            return RESULT_ACCEPTED
        if message.param1 != 1:
            return RESULT_UNSUPPORTED
        if self.armed:
            return RESULT_ACCEPTED
        objection = None
        if now < self.booted_at_s + ARMING_REFUSED_S:
            objection = "Arm: AHRS: waiting for home"
        elif self.vehicle == "copter" and self.mode in ("AUTO", "RTL", "LAND"):
            objection = "Arm: Mode not armable"
        if objection:
            self.text(CRITICAL, objection, now)
            return RESULT_FAILED
        self.armed = True
        self._may_take_off = self.vehicle != "copter"
        self.text(INFO, "Arming motors" if self.vehicle == "copter" else "Throttle armed", now)
        if self.mode == "AUTO":
            self._enter_auto(now)
        return RESULT_ACCEPTED

    def _do_set_mode(self, message, now: float) -> int:
        changed = self._set_mode(whole_number(message.param2), now)
        return RESULT_ACCEPTED if changed else RESULT_FAILED

    def _mission_start(self, message, now: float) -> int:
        if message.param1 or message.param2:
            return RESULT_DENIED
        if self.mode != "AUTO" and not self._set_mode(MODES[self.vehicle]["AUTO"], now):
            return RESULT_FAILED
        self._may_take_off = True
        if self.armed and self._waits_for_takeoff(now):
            self.flight.begin(self.flight.index, now)
            self._follow_flight()
        return RESULT_ACCEPTED

    def _do_set_mission_current(self, message, now: float) -> int:
        if not self._set_current(whole_number(message.param1), now):
            return RESULT_FAILED
        self.answer(self._mission_current(), now)
        return RESULT_ACCEPTED

    def _set_message_interval(self, message, now: float) -> int:
        identity = whole_number(message.param1)
        known = identity in mavlink.mavlink_map or identity in _ARDUPILOTMEGA
        if not known or not math.isfinite(message.param2):
            return RESULT_FAILED
        self.set_interval(identity, message.param2, now)
        return RESULT_ACCEPTED

    def _request_message(self, message, now: float) -> int:
        reply = self.message_of(whole_number(message.param1), now)
        if reply is None:
            return RESULT_FAILED
        self.answer(reply, now)
        return RESULT_ACCEPTED

    def _disarm(self, now: float) -> None:
        self.armed = self._may_take_off = False
        self.flight.stop(now)
        self._follow_flight()
        self.text(INFO, "Disarming motors", now)

    # -- modes ----------------------------------------------------------------------------

    def _set_mode(self, custom_mode: int, now: float) -> bool:
        names = {number: name for name, number in MODES[self.vehicle].items()}
        name = names.get(custom_mode)
        if name is None:
            self.text(WARNING, f"No such mode {custom_mode}", now)
            return False
        if name == "AUTO" and len(self.missions[MISSION].held) < 2:
            self.text(WARNING, "Mode change to AUTO failed: init failed", now)
            return False
        changed = name != self.mode
        self.mode = name
        if changed:
            self.answer(self.heartbeat(), now)
            self.flight.stop(now)
            self._follow_flight()
            if name == "AUTO" and self.armed:
                self._enter_auto(now)
        return True

    def _enter_auto(self, now: float) -> None:
        if self.complete:
            self.current, self.complete = 0, False
        self._fly_from(max(self.current, 1), now)

    def _fly_from(self, index: int, now: float) -> None:
        self.flight.begin(index, now)
        self._follow_flight()

    def _waits_for_takeoff(self, now: float) -> bool:
        index = self.flight.index
        if index is None or self.flight.airborne(now) or self.flight.ends_at < math.inf:
            return False
        held = self.missions[MISSION].held
        return index < len(held) and held[index].command == TAKEOFF

    # -- flying ---------------------------------------------------------------------------

    def _follow_flight(self) -> None:
        """Come back when the item being flown ends."""
        held = self.missions[MISSION].held
        index = self.flight.index
        if index is not None and not self._may_take_off and index < len(held) \
                and held[index].command == TAKEOFF:
            self.flight.wait()  # for MISSION_START
        if index is None or self.flight.ends_at == math.inf:
            self.never("leg")
        else:
            self.at("leg", self.flight.ends_at, self._leg_over)

    def _leg_over(self, now: float) -> None:
        self.flight.advance(now)
        self._follow_flight()

    def _item_begun(self, index: int, item: Item, now: float) -> None:
        if self.current == index and item.command == TAKEOFF and self._may_take_off:
            return  # it was announced when AUTO began
        self.current = index
        name = _ITEM_NAMES.get(item.command, f"Cmd{item.command}")
        self.text(INFO, f"Mission: {index} {name}", now - self.response_delay_s,
                  later_s=2 * TEXT_LAG_S)

    def _item_reached(self, index: int, item: Item, now: float) -> None:
        self.send_now(mavlink.MAVLink_mission_item_reached_message(index), now)
        if item.command in (16, 82):
            self.text(INFO, f"Reached command #{index}", now - self.response_delay_s)

    def _plan_over(self, now: float) -> None:
        self.complete = True
        if not self.flight.airborne(now) and self.vehicle == "copter":
            self.at("disarm", now + DISARM_AFTER_LANDING_S,
                    lambda time: self._disarm(time) if self.armed else None)

    # -- what it sends --------------------------------------------------------------------

    def heartbeat(self):
        base = mavlink.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED
        if self.vehicle == "copter":
            base |= mavlink.MAV_MODE_FLAG_STABILIZE_ENABLED
        base |= mavlink.MAV_MODE_FLAG_MANUAL_INPUT_ENABLED
        if self.mode in _GUIDED_BY_ITSELF:
            base |= mavlink.MAV_MODE_FLAG_GUIDED_ENABLED
        if self.armed:
            base |= mavlink.MAV_MODE_FLAG_SAFETY_ARMED
        status = (mavlink.MAV_STATE_ACTIVE if self.armed and self.flight.airborne(self._now)
                  else mavlink.MAV_STATE_STANDBY)
        return mavlink.MAVLink_heartbeat_message(
            self.vehicle_types[self.vehicle], self.autopilot_type, base,
            MODES[self.vehicle][self.mode], status, 3)

    def _mission_current(self):
        total = max(0, len(self.missions[MISSION].held) - 1)
        if total == 0:
            state = mavlink.MISSION_STATE_NO_MISSION
        elif self.complete:
            state = mavlink.MISSION_STATE_COMPLETE
        elif self.is_flying_plan():
            state = mavlink.MISSION_STATE_ACTIVE
        elif self.current:
            state = mavlink.MISSION_STATE_PAUSED
        else:
            state = mavlink.MISSION_STATE_NOT_STARTED
        return mavlink.MAVLink_mission_current_message(
            self.current, total, state, 1 if self.mode == "AUTO" else 0)

    def message_of(self, identity: int, now: float):
        lat, lon, height = self.flight.where(now)
        altitude_mm = round((self.flight.home_altitude + height) * 1000)
        boot_ms = max(0, round((now - self.booted_at_s) * 1000))
        if identity == mavlink.MAVLINK_MSG_ID_HEARTBEAT:
            return self.heartbeat()
        if identity == MISSION_CURRENT:
            return self._mission_current()
        if identity == GLOBAL_POSITION_INT:
            return mavlink.MAVLink_global_position_int_message(
                boot_ms, lat, lon, altitude_mm, round(height * 1000), 0, 0, 0, 0)
        if identity == mavlink.MAVLINK_MSG_ID_HOME_POSITION and self.home:
            return mavlink.MAVLink_home_position_message(
                self.home[0], self.home[1], round(self.home[2] * 1000), 0, 0, 0,
                [math.nan] * 4, 0, 0, 0, boot_ms * 1000)
        if identity == mavlink.MAVLINK_MSG_ID_AUTOPILOT_VERSION:
            capabilities = mavlink.MAV_PROTOCOL_CAPABILITY_MISSION_FLOAT \
                | mavlink.MAV_PROTOCOL_CAPABILITY_COMMAND_INT \
                | mavlink.MAV_PROTOCOL_CAPABILITY_MISSION_FENCE \
                | mavlink.MAV_PROTOCOL_CAPABILITY_MISSION_RALLY
            if not self.faults.takes_only_float_items:
                capabilities |= mavlink.MAV_PROTOCOL_CAPABILITY_MISSION_INT
            if self.mavlink_version == 2:
                capabilities |= mavlink.MAV_PROTOCOL_CAPABILITY_MAVLINK2
            return mavlink.MAVLink_autopilot_version_message(
                capabilities, 4 << 24 | 6 << 16 | 3 << 8 | 255, 0, 0, 0,
                [0] * 8, [0] * 8, [0] * 8, 0, 0, 0)
        return None

    def tell_param(self, name: str, kind: int, value: float, now: float) -> None:
        """A PARAM_VALUE nobody asked for: it tells of each parameter that it changes."""
        self.answer(mavlink.MAVLink_param_value_message(
            name.encode(), value, kind, PARAM_COUNT, 65535), now, later_s=0.003)

    # -- start ----------------------------------------------------------------------------

    def _start_timers(self, now: float) -> None:
        self.at("timesync", now + TIMESYNC_PERIOD_S, self._timesync)
        self.at("runtime", now + RUNTIME_PERIOD_S, self._runtime)

    def _timesync(self, now: float) -> None:
        self.send_now(mavlink.MAVLink_timesync_message(0, max(0, round(now * 1e9)) + 1), now)
        self.at("timesync", now + TIMESYNC_PERIOD_S, self._timesync)

    def _runtime(self, now: float) -> None:
        self.tell_param("STAT_RUNTIME", mavlink.MAV_PARAM_TYPE_INT32,
                        round(now - self.booted_at_s), now)
        self.at("runtime", now + RUNTIME_PERIOD_S, self._runtime)

    def _restart(self, now: float) -> None:
        for missions in self.missions.values():
            missions.forget_transfer()
        self.armed = self._may_take_off = self.complete = False
        self.mode = _FIRST_MODE[self.vehicle]
        self.current = 0
        self._seen.clear()
        self.flight.land_at_once()
        self.flight.forget_jumps()
        self._start_timers(now)
