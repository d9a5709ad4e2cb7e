"""ArduPilot 4.6.3: its modes, its commands, its flight, around its mission protocol."""
import itertools
import math
from collections.abc import Iterable

from . import hearing, instruments, parameters
from .ardupilot_missions import Missions
from .autopilot import TEXT_LAG_S, Address, FakeAutopilot
from .dialect import mavlink
from .flight import LANDINGS, PLACE_IGNORED, TAKEOFF, VTOL_TAKEOFF, WAYPOINT, Flight, Place
from .ftp import Ftp
from .items import FENCE, MISSION, RALLY, Item, f32, whole_number
from .parameters import NO_INDEX
from .vehicles import VEHICLES
from .velocities import OF_AIRCRAFT, Velocity, velocity_of

BOOT_TEXT = b"\r\n\r\nInit ArduCopter V4.6.3\r\n\r\nFree RAM: 262144\r\n"

WARNING = mavlink.MAV_SEVERITY_WARNING
NOTICE = mavlink.MAV_SEVERITY_NOTICE
INFO = mavlink.MAV_SEVERITY_INFO
CRITICAL = mavlink.MAV_SEVERITY_CRITICAL

RESULT_ACCEPTED = mavlink.MAV_RESULT_ACCEPTED
RESULT_DENIED = mavlink.MAV_RESULT_DENIED
RESULT_UNSUPPORTED = mavlink.MAV_RESULT_UNSUPPORTED
RESULT_FAILED = mavlink.MAV_RESULT_FAILED

# What it calls an item in its texts. The first four are seen, the others by source.
_ITEM_NAMES = {16: "WP", 22: "Takeoff", 20: "RTL", 21: "Land", 17: "LoitUnlim",
               18: "LoitTurns", 19: "LoitTime", 31: "LoitAltitude", 82: "SplineWP",
               93: "Delay", 94: "PayloadPlace", 112: "CondDelay", 115: "CondYaw",
               177: "Jump", 178: "ChangeSpeed", 181: "SetRelay", 183: "SetServo"}

TIMESYNC_PERIOD_S = 10.0
RUNTIME_PERIOD_S = 30.0
DISARM_AFTER_LANDING_S = 2.0
LANDS_AFTER_M = 27.0  # a quadplane's last waypoint must be so far before its landing; by its cruising speed
HOVERS_WITHIN_M, HOVERS_BELOW_M = 60.0, 15.0  # of home; by WP_LOITER_RAD 40 and Q_RTL_ALT
PLANE_DISARMS_S = 20.0  # LAND_DISARMDELAY's default; by source
ON_THE_GROUND_S = 0.02  # a copter in LAND that stands on the ground disarms after so long
LANDED_AFTER_ARMING_S = 2.0  # a copter in LAND that never left the ground disarms no earlier
WITHOUT_POSITION_S = 1.0  # after so long, armed, an EKF failsafe; and so long after the position it ends
NOTHING_REACHED = 65535
VELOCITY_S = 3.0  # a velocity is flown at for so long; a copter's GUID_TIMEOUT, fixed on a rover
PARAM_READ_S = 0.02  # from a request to the answer, beside response_delay_s; 40 to 185 ms seen

MISSION_CURRENT = mavlink.MAVLINK_MSG_ID_MISSION_CURRENT
MISSION_ITEM_REACHED = mavlink.MAVLINK_MSG_ID_MISSION_ITEM_REACHED
AUTOPILOT_VERSION = mavlink.MAVLINK_MSG_ID_AUTOPILOT_VERSION
GLOBAL_POSITION_INT = mavlink.MAVLINK_MSG_ID_GLOBAL_POSITION_INT
_WAYPOINTS = (16, 82)
_TAKEOFFS = (TAKEOFF, VTOL_TAKEOFF)
_NAVIGATION = range(16, 96)  # the commands that fly somewhere or wait; the others are done in passing
_ABOVE_HOME, _ABOVE_THE_SEA, _ABOVE_GROUND = (3, 6), (0, 5), (10, 11)  # MAV_FRAME
POSITION_TARGET_GLOBAL_INT = mavlink.MAVLINK_MSG_ID_POSITION_TARGET_GLOBAL_INT
EXTENDED_SYS_STATE = mavlink.MAVLINK_MSG_ID_EXTENDED_SYS_STATE
PLACE_ALONE = 65016  # POSITION_TARGET_GLOBAL_INT.type_mask: velocity, acceleration and yaw say nothing
_STREAMS = {0: (MISSION_CURRENT, GLOBAL_POSITION_INT),  # MAV_DATA_STREAM_ALL
            2: (MISSION_CURRENT,), 6: (GLOBAL_POSITION_INT,)}

# Of its own dialect, and in its streams: MEMINFO, AHRS, SIMSTATE, WIND, AHRS2, EKF_STATUS_REPORT.
_ARDUPILOTMEGA = {152, 163, 164, 168, 178, 193}


class ArduPilot(FakeAutopilot):
    """ArduCopter, ArduRover, ArduPlane, ArduSub or Blimp.

    home: (latitude [1e-7 degrees], longitude [1e-7 degrees], altitude [m]); None until one
    is set. item_limit, fence_limit, rally_limit: how many items it has room for; only the
    650 of the mission is known. radio_slowdown_s: how much later than after one second it
    asks again, as behind a slow radio. ready_s, position_s: in place of the Vehicle's.
    storage_s: how long after power-on it has no room for plans, since its storage is not there yet.
    vehicle_type: HEARTBEAT.type, as a plane has it in Q_MAV_TYPE; None for the vehicle's own.
    streams: the messages it sends unasked, and how often [s]; by default none, as a port whose
    SRn_ parameters are 0. ftp: False for BRD_OPTIONS' bit that disables MAVLink FTP.
    is_int_only: without MISSION_ITEM and MISSION_REQUEST, of which 4.6 warns; no such version is known yet.
    lists_modes: it has AVAILABLE_MODES, as later than 4.6. port_signs: False for bit 0 of its port's MAVn_OPTIONS.
    """

    autopilot_type = mavlink.MAV_AUTOPILOT_ARDUPILOTMEGA
    heard_by = hearing.ARDUPILOT
    response_delay_s = 0.017
    response_delay_on_line_s = 0.006
    # On a full line of 57600 baud an item that is read comes 163 ms after its request, instead of 17: seen.
    transmit_buffer_seen = 800

    def __init__(self, *, item_limit: int = 650, fence_limit: int = 84, rally_limit: int = 84,
                 home: tuple[int, int, float] | None = (-353632620, 1491652370, 584.09),
                 armed: bool = False, mode: str | None = None, radio_slowdown_s: float = 0.0,
                 ready_s: float | None = None, position_s: float | None = None, storage_s: float = 0.0,
                 vehicle_type: int | None = None,
                 streams: dict[int, float] | None = None, ftp: bool = True, lists_modes: bool = False,
                 port_signs: bool = True, is_int_only: bool = False, **options) -> None:
        super().__init__(**options)
        self.is_int_only = is_int_only
        self.kind = VEHICLES[self.vehicle]
        self.lists_modes = lists_modes
        if ready_s is not None:
            self.kind = self.kind._replace(ready_s=ready_s)
        if position_s is not None:
            self.kind = self.kind._replace(position_s=position_s)
        self.vehicle_type = self.vehicle_types[self.vehicle] if vehicle_type is None else vehicle_type
        self.home = home
        self.storage_s = storage_s
        self.radio_slowdown_s = radio_slowdown_s
        self.armed = armed
        self.mode = mode or self.kind.first_mode
        if self.mode not in self.kind.modes:
            raise ValueError(f"a {self.vehicle}'s mode is one of {', '.join(self.kind.modes)}"
                             f", not {self.mode}")
        self.current = 0  # the item that MISSION_CURRENT tells of; an upload leaves it alone
        self.running = False  # the plan; may be so without AUTO, too
        self.complete = False
        self.parameters = parameters.of_ardupilot(self.vehicle)
        self.guided_targets: list[tuple[float, Item]] = []
        self.instruments = instruments.of_ardupilot()
        self._last_reached = NOTHING_REACHED
        self._may_take_off = armed
        self._armed_at = 0.0
        self._command = 0  # of the item being flown, whatever has been uploaded since
        self._of_its_own_accord = False  # what it does just now, and not because it was told
        self._in_silence = False
        self._seen: set[Address] = set()
        self.missions = {MISSION: Missions(self, MISSION, item_limit),
                         FENCE: Missions(self, FENCE, fence_limit),
                         RALLY: Missions(self, RALLY, rally_limit)}
        lat, lon, altitude = home or (0, 0, 0.0)
        self.flight = Flight(self.kind.pace, Place(lat, lon, 0.0), altitude,
                             lambda: self.missions[MISSION].held,
                             self._item_begun, self._item_reached, self._plan_over, self._landed, self._jumped)
        self.ftp = Ftp(self, ftp)
        self._hears = {
            "FILE_TRANSFER_PROTOCOL": self.ftp.hear,
            **({"SETUP_SIGNING": self._on_setup_signing} if port_signs else {}),
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
            "SET_POSITION_TARGET_GLOBAL_INT": self._on_set_target,
            "SET_POSITION_TARGET_LOCAL_NED": self._on_set_velocity,
            "REQUEST_DATA_STREAM": self._on_request_data_stream,
            "PARAM_REQUEST_READ": self._on_param_request_read,
            "PARAM_SET": self._on_param_set,
        }
        for name in ("MISSION_ITEM", "MISSION_REQUEST") if is_int_only else ():
            del self._hears[name]
        self._streams = streams or {}
        self._start_timers(0.0)

    def thinned_by(self) -> int:
        # By source: streams come at a quarter of their rate while it asks for items, and while it answers FTP; not
        # while items are read.
        is_busy = any(missions.receiving for missions in self.missions.values()) or self.ftp.is_answering(self._now)
        return 4 if is_busy else 1

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
        """The current item stays what it was, whatever it is now; without a plan there is none."""
        self.complete = False
        if not self.missions[MISSION].held:
            self.current = 0

    def item_stored(self, now: float) -> None:
        """On its way to a waypoint it begins the leg again with each item of an upload."""
        index = self.flight.index
        if not self.running or index is None or index >= len(self.missions[MISSION].held) \
                or self._command not in _WAYPOINTS:
            return
        self._fly_from(index, now)
        self.text(CRITICAL, "Auto mission changed, restarted command", now, later_s=3 * TEXT_LAG_S)

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

    def has_storage(self, now: float) -> bool:
        return now >= self.booted_at_s + self.storage_s

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
        """The answer names the number that was asked for; 0 means 1 all the same. Beyond the plan: no answer."""
        if self._set_current(message.seq, now):
            answer = self._mission_current()
            answer.seq = message.seq
            self.answer(answer, now)

    def _set_current(self, seq: int, now: float) -> bool:
        if not 0 <= seq < len(self.missions[MISSION].held):
            return False
        if seq == 0 or self.complete:
            self.flight.forget_jumps()
        self.current = max(seq, 1) if len(self.missions[MISSION].held) > 1 else 0
        self.complete = False
        if self.running and self.mode == "AUTO":
            self._fly_from(self.current, now)
        return True

    def _on_set_target(self, message, sender, now: float) -> None:
        """One is enough: it flies on to the last one. There is no answer, and in another mode than GUIDED it does
        nothing; a plane takes nothing but the altitude (by source)."""
        if self.mode == "GUIDED" and not message.type_mask & PLACE_IGNORED and not self.kind.is_plane:
            self._fly_guided(message.lat_int, message.lon_int, message.alt, message.coordinate_frame, now, moves=True)

    def _on_set_velocity(self, message, sender, now: float) -> None:
        """Flown at until 3 s have passed without another one; then it stands. In another mode than GUIDED it does
        nothing, and a plane never does. A yaw as seen from the aircraft is a turn by so much, each time; a copter that
        is told neither a yaw nor a rate looks where it flies (by source)."""
        velocity = velocity_of(message)
        if self.mode != "GUIDED" or velocity is None or self.kind.is_plane or not self.armed:
            return
        if self.kind.needs_takeoff and not self.flight.airborne(now):
            return
        flight, is_of_aircraft = self.flight, message.coordinate_frame in OF_AIRCRAFT
        over_ground = velocity.turned(flight.heading(now)) if is_of_aircraft else velocity
        if not self.kind.needs_takeoff:
            over_ground = self._steer_rover(velocity, over_ground, now)
        elif velocity.yaw is not None:
            flight.face(velocity.yaw + (flight.heading(now) if is_of_aircraft else 0.0))
        elif velocity.rate is not None:
            flight.turn(velocity.rate, now, VELOCITY_S)
        elif velocity.speed > 0:
            flight.face(over_ground.direction)
        flight.drive(over_ground.north_east_up, now, VELOCITY_S)
        self._follow_flight()

    def _steer_rover(self, velocity: Velocity, over_ground: Velocity, now: float) -> Velocity:
        """It drives forward in the direction that is named, or, with a rate of turn, forward or backwards."""
        if velocity.rate is None:
            self.flight.face(over_ground.direction)
            return over_ground
        ahead = velocity.speed * (-1.0 if velocity.x < 0 else 1.0)
        self.flight.turn(velocity.rate, now, VELOCITY_S)
        return Velocity(ahead, 0.0, 0.0, None, None).turned(self.flight.heading(now))

    def _on_request_data_stream(self, message, sender, now: float) -> None:
        for identity in _STREAMS.get(message.req_stream_id, ()):
            on = message.start_stop and message.req_message_rate
            self.default_stream(identity, 1.0 / message.req_message_rate if on else 0.0, now)

    def _on_param_request_read(self, message, sender, now: float) -> None:
        """It looks in between other work; one that it does not have it passes over."""
        known = self.parameters.asked_for(message)
        if known is not None:
            by_name = message.param_index < 0
            self.answer(self.parameters.told(known, NO_INDEX if by_name else None), now, later_s=PARAM_READ_S)

    def _on_param_set(self, message, sender, now: float) -> None:
        known = self.parameters.all.get(message.param_id)
        if known is None or not math.isfinite(message.param_value):
            return
        if known.read_only:
            self.text(WARNING, f"Param write denied ({known.name})", now)
        else:
            known.value = self.parameters.from_the_wire(known, message.param_value)
        self.answer(self.parameters.told(known, NO_INDEX), now)

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
            mavlink.MAV_CMD_NAV_TAKEOFF: self._nav_takeoff,
            mavlink.MAV_CMD_DO_VTOL_TRANSITION: self._do_vtol_transition,
            mavlink.MAV_CMD_DO_REPOSITION: self._do_reposition,
            mavlink.MAV_CMD_DO_CHANGE_SPEED: self._do_change_speed,
            mavlink.MAV_CMD_CONDITION_YAW: self._condition_yaw,
            mavlink.MAV_CMD_SET_MESSAGE_INTERVAL: self._set_message_interval,
            mavlink.MAV_CMD_GET_MESSAGE_INTERVAL: self._get_message_interval,
            mavlink.MAV_CMD_REQUEST_MESSAGE: self._request_message,
            mavlink.MAV_CMD_REQUEST_AUTOPILOT_CAPABILITIES: self._request_capabilities,
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
        objection = self._why_not_armed(now)
        if objection:
            self.text(CRITICAL, objection, now)
            return RESULT_FAILED
        self.armed, self._armed_at = True, now
        self._may_take_off = not self.kind.needs_takeoff
        self.text(INFO, self.kind.armed, now)
        if self.kind.disarms_idle_s is not None:
            self.at("idle", now + self.kind.disarms_idle_s, self._disarm_if_idle)
        if self.mode == "AUTO" and self.flight.index is None:
            self._begin_plan(now)
        elif self.mode == "AUTO":
            self._go_on(now)
        return RESULT_ACCEPTED

    def _why_not_armed(self, now: float) -> str | None:
        if now < self.booted_at_s + self.kind.ready_s:
            return self.kind.not_ready
        if self.kind.hovers and self._lands_too_short():
            return f"Arm: VTOL land too short, min {LANDS_AFTER_M:.0f}m"
        if self.mode == "AUTO" and int(self.parameters.value("AUTO_OPTIONS")) & 1:
            return None
        return f"Arm: {self.mode} mode not armable" if self.mode in self.kind.not_armed_in else None

    def _lands_too_short(self) -> bool:
        """Whether a landing of its plan is nearer to the waypoint before than it can stop within."""
        legs = itertools.pairwise(self.missions[MISSION].held[1:])
        return any(item.command in LANDINGS and before.command == WAYPOINT
                   and Place(int(item.x), int(item.y), 0.0).distance(Place(int(before.x), int(before.y), 0.0))
                   < LANDS_AFTER_M for before, item in legs)

    def _disarm_if_idle(self, now: float) -> None:
        takes_off = self.mode == "AUTO" and self._may_take_off
        if self.armed and not takes_off and not self.flight.airborne(now):
            self._disarm(now)

    def _do_set_mode(self, message, now: float) -> int:
        changed = self._set_mode(whole_number(message.param2), now)
        return RESULT_ACCEPTED if changed else RESULT_FAILED

    def _mission_start(self, message, now: float) -> int:
        if message.param1 or message.param2:
            return RESULT_DENIED
        if not self._set_mode(self.kind.modes["AUTO"], now):
            return RESULT_FAILED
        self._may_take_off = self.armed
        if self.armed and self.flight.waiting:
            self._go_on(now)
        return RESULT_ACCEPTED

    def _do_set_mission_current(self, message, now: float) -> int:
        """With param2 = 1 the plan begins to run, even disarmed and in another mode; it moves nothing there."""
        reset, seq = message.param2 == 1, whole_number(message.param1)
        if not 0 <= seq < len(self.missions[MISSION].held):
            return RESULT_DENIED
        if reset:
            self.flight.forget_jumps()
            self.running = True
        self._set_current(seq, now)
        if reset and self.mode != "AUTO":
            self._announce(self.current, now)
        self.answer(self._mission_current(), now, later_s=0.001)
        return RESULT_ACCEPTED

    def _nav_takeoff(self, message, now: float) -> int:
        """Climbs where it stands, in GUIDED; z is above home, of a plane above where it stands."""
        if not self.kind.needs_takeoff and not self.kind.is_plane:
            return RESULT_UNSUPPORTED
        z = message.z if message.get_type() == "COMMAND_INT" else message.param7
        if getattr(message, "frame", 3) not in _ABOVE_HOME:
            return RESULT_DENIED  # by source
        if self.kind.is_plane and not self.kind.hovers:
            return RESULT_FAILED
        if self.mode != "GUIDED" or not self.armed or self.flight.airborne(now) or not z > 0:
            return RESULT_FAILED
        here = self.flight.where(now)
        self.flight.fly_to(here._replace(height=z), now, spool_up_s=self.kind.pace.spool_up_s)
        self._follow_flight()
        return RESULT_ACCEPTED

    def _do_vtol_transition(self, message, now: float) -> int:
        """Only planes know it. Its effect on one that flies its mission is not imitated."""
        if not self.kind.is_plane:
            return RESULT_UNSUPPORTED
        why = "VTOL not available" if not self.kind.hovers else "VTOL transition only in AUTO"
        if self.kind.hovers and self.mode == "AUTO":
            if whole_number(message.param1) in (mavlink.MAV_VTOL_STATE_MC, mavlink.MAV_VTOL_STATE_FW):
                return RESULT_ACCEPTED
            why = "Invalid VTOL mode"
        self.text(NOTICE, why, now)
        return RESULT_FAILED

    def _do_reposition(self, message, now: float) -> int:
        """As COMMAND_INT alone. In another mode than GUIDED it wants the flag that changes the mode."""
        if message.get_type() != "COMMAND_INT":
            return RESULT_UNSUPPORTED
        if self.mode != "GUIDED" and not whole_number(message.param2) & 1:
            return RESULT_DENIED
        if message.x == message.y == 0 or not math.isfinite(message.z):
            return RESULT_DENIED
        if message.frame not in (*_ABOVE_HOME, *_ABOVE_THE_SEA, *_ABOVE_GROUND):
            self.text(INFO, f"Unknown mavlink coordinate frame {message.frame}", now, later_s=2 * TEXT_LAG_S)
            return RESULT_DENIED
        if not self._set_mode(self.kind.modes["GUIDED"], now):
            return RESULT_FAILED
        self._fly_guided(message.x, message.y, message.z, message.frame, now)
        return RESULT_ACCEPTED

    def _fly_guided(self, lat: int, lon: int, z: float, frame: int, now: float, moves: bool = False) -> None:
        """On the ground a copter does not leave it, and a disarmed vehicle does not move."""
        height = z - self.flight.home_altitude if frame in _ABOVE_THE_SEA else z
        if self.armed and (self.flight.airborne(now) or not self.kind.needs_takeoff):
            fly_to = self.flight.chase if moves else self.flight.fly_to
            fly_to(Place(lat, lon, height), now)
            self._follow_flight()

    def _do_change_speed(self, message, now: float) -> int:
        """A copter has speeds of its own upwards and downwards; in GUIDED, one that is set sets the other one back."""
        if not message.param2 > 0:
            return RESULT_FAILED  # by source
        set_now = {"speed": message.param2}
        if self.kind.needs_takeoff and message.param1 >= 2:
            usual = self.kind.pace
            set_now = {"climb": usual.climb, "descent": usual.descent} if self.mode == "GUIDED" else {}
            set_now["climb" if message.param1 < 3 else "descent"] = message.param2
        self.flight.pace = self.flight.pace._replace(**set_now)
        return RESULT_ACCEPTED

    def _condition_yaw(self, message, now: float) -> int:
        """A copter's alone. By source: a relative turn counts from where it looks."""
        if not self.kind.needs_takeoff or self.kind.is_plane:
            return RESULT_UNSUPPORTED
        if not 0 <= message.param1 <= 360 or message.param4 not in (0.0, 1.0):
            return RESULT_FAILED
        from_deg = self.flight.heading(now) if message.param4 else 0.0
        self.flight.face(from_deg + (-message.param1 if message.param4 and message.param3 < 0 else message.param1))
        return RESULT_ACCEPTED

    def _set_message_interval(self, message, now: float) -> int:
        identity = whole_number(message.param1)
        known = identity in mavlink.mavlink_map or identity in _ARDUPILOTMEGA
        if not known or not math.isfinite(message.param2):
            return RESULT_FAILED
        self.set_interval(identity, message.param2, now)
        return RESULT_ACCEPTED

    def _get_message_interval(self, message, now: float) -> int:
        identity = whole_number(message.param1)
        self.answer(mavlink.MAVLink_message_interval_message(identity, self.interval_us(identity)), now)
        return RESULT_ACCEPTED

    def _request_message(self, message, now: float) -> int:
        identity = whole_number(message.param1)
        if identity == mavlink.MAVLINK_MSG_ID_AVAILABLE_MODES and self.lists_modes:
            return self._tell_mode(whole_number(message.param2), now)
        reply = self.message_of(identity, now)
        if identity == MISSION_ITEM_REACHED:
            reply = mavlink.MAVLink_mission_item_reached_message(self._last_reached)
        if reply is None:
            return RESULT_FAILED
        self.answer(reply, now, later_s=0.001)
        return RESULT_ACCEPTED

    def _tell_mode(self, number: int, now: float) -> int:
        """An entry of its list, behind the answer. Beyond the list it accepts, and tells nothing (seen)."""
        modes = list(self.kind.modes.items())
        if 1 <= number <= len(modes):
            name, custom = modes[number - 1]
            self.answer(mavlink.MAVLink_available_modes_message(
                len(modes), number, mavlink.MAV_STANDARD_MODE_NON_STANDARD, custom, 0, name.encode()), now,
                later_s=0.001)  # fmt: skip
        return RESULT_ACCEPTED

    def _request_capabilities(self, message, now: float) -> int:
        self.answer(self.message_of(AUTOPILOT_VERSION, now), now, later_s=0.001)
        return RESULT_ACCEPTED

    def _disarm(self, now: float) -> None:
        """The plan is rewound; in AUTO it begins to run again at once."""
        self.armed = self._may_take_off = False
        self.flight.stop(now)
        self._follow_flight()
        self.text(INFO, self.kind.disarmed, now)
        self.current = 0
        self.flight.forget_jumps()
        if self.mode == "AUTO" and self.running:
            self._begin_plan(now)

    # -- modes ----------------------------------------------------------------------------

    def _set_mode(self, custom_mode: int, now: float) -> bool:
        names = {number: name for name, number in self.kind.modes.items()}
        name = names.get(custom_mode)
        if name is None:
            self.text(WARNING, f"No such mode {custom_mode}", now)
            return False
        if name == self.mode:
            return True
        objections = self._why_not_mode(name, now)
        if objections:
            for number, (severity, words) in enumerate(objections, start=1):
                self.text(severity, words, now, later_s=number * TEXT_LAG_S)
            return False
        if self.mode == "AUTO":
            self.running = False
        if name == "RTL" and self.kind.hovers and self.flight.airborne(now) and self._is_near_home(now):
            name = "QRTL"
        self.mode = name
        self.answer(self.heartbeat(), now, later_s=0.003)
        self.flight.stop(now)
        self._follow_flight()
        if name == "AUTO":
            self._begin_plan(now)
        elif name == self.kind.land_mode and self.armed:
            self._land(now)
        elif name in ("RTL", "QRTL") and self.flight.airborne(now):
            self.flight.fly_to(self.flight.home._replace(height=self.flight.where(now).height), now,
                               lands=self.kind.land_mode is not None)
            self._follow_flight()
        return True

    def _is_near_home(self, now: float) -> bool:
        """So near that a quadplane hovers there."""
        here = self.flight.where(now)
        return here.height < HOVERS_BELOW_M and here.distance(self.flight.home) < HOVERS_WITHIN_M

    def _why_not_mode(self, name: str, now: float) -> list[tuple[int, str]]:
        """What it says, in (severity, words), when this mode is not to be had; nothing if it is."""
        held = self.missions[MISSION].held
        why: list[tuple[int, str]] = []
        if name in self.kind.by_itself and self.armed and now < self._position_at():
            pass
        elif name != "AUTO":
            return []
        elif len(held) < 2:
            why = [(NOTICE, self.kind.no_plan)] if self.kind.no_plan else []
        elif self.kind.needs_takeoff and self.armed and not self.flight.airborne(now) \
                and not self._begins_with_takeoff():
            why = [(CRITICAL, "Auto: Missing Takeoff Cmd")]
        else:
            return []
        return [*why, (WARNING, self.kind.auto_refused)]

    def _position_at(self) -> float:
        return self.booted_at_s + self.kind.ready_s + self.kind.position_s

    def _begins_with_takeoff(self) -> bool:
        """Whether the next item that flies is one."""
        held = self.missions[MISSION].held
        for item in held[max(self.current, 1):]:
            if item.command in _NAVIGATION:
                return item.command in _TAKEOFFS
        return False

    def _land(self, now: float) -> None:
        """LAND as a mode: at once on the ground."""
        if self.flight.airborne(now):
            self.flight.sink(now)
            self._follow_flight()
        else:
            self.at("disarm", max(now + ON_THE_GROUND_S, self._armed_at + LANDED_AFTER_ARMING_S),
                    self._disarm_landed)

    # -- flying ---------------------------------------------------------------------------

    def _begin_plan(self, now: float) -> None:
        """Run the plan from its current item; disarmed it waits there."""
        if self.complete:
            self.current, self.complete = 0, False
            self.flight.forget_jumps()
        self.running = True
        self._fly_from(max(self.current, 1), now)

    def _fly_from(self, index: int, now: float) -> None:
        self.flight.begin(index, now)
        self._follow_flight()

    def _go_on(self, now: float) -> None:
        """Fly the item that was waited with."""
        assert self.flight.index is not None, "no item is flown"
        self._in_silence = True
        self._fly_from(self.flight.index, now)
        self._in_silence = False

    def _must_wait(self) -> bool:
        """Whether the item being flown must not move anything yet."""
        index, held = self.flight.index, self.missions[MISSION].held
        if index is None or self.flight.sinking:
            return False
        waits_for_start = not self._may_take_off and index < len(held) and held[index].command == TAKEOFF
        return not self.armed or waits_for_start

    def _follow_flight(self) -> None:
        """Come back when the item being flown ends."""
        if self._must_wait():
            self.flight.wait()
        if self.flight.ends_at == math.inf:
            self.never("leg")
        else:
            self.at("leg", self.flight.ends_at, self._leg_over)

    def _leg_over(self, now: float) -> None:
        self._of_its_own_accord = True
        self.flight.advance(now)
        if self.mode == "RTL" and self.kind.hovers and self.flight.sinking:
            self.mode = "QRTL"  # with Q_RTL_MODE 1
            self.answer(self.heartbeat(), now, later_s=0.003)
        self._follow_flight()
        self._of_its_own_accord = False

    def arrive(self, now: float) -> None:
        """End the item being flown now, and not at its own pace."""
        self._advance(now)
        self._leg_over(now)

    def _item_begun(self, index: int, item: Item, now: float) -> None:
        self.current, self._command = index, item.command
        if not self._in_silence:
            self._announce(index, now)

    def _announce(self, index: int, now: float) -> None:
        held = self.missions[MISSION].held
        if index >= len(held):
            return
        name = _ITEM_NAMES.get(held[index].command, f"Cmd{held[index].command}")
        self.text(INFO, f"Mission: {index} {name}", self._cause(now), later_s=2 * TEXT_LAG_S)

    def _jumped(self, index: int, item: Item, times: int, now: float) -> None:
        of = f"{whole_number(item.param2)}" if item.param2 >= 0 else "unlimited"
        self.text(INFO, f"Mission: {index} Jump {times}/{of}", self._cause(now), later_s=2 * TEXT_LAG_S)

    def _cause(self, now: float) -> float:
        """What it does of its own accord is told without the delay of an answer."""
        return now - self.response_delay_s if self._of_its_own_accord else now

    def _item_reached(self, index: int, item: Item, now: float) -> None:
        self._last_reached = index
        self.send_now(mavlink.MAVLink_mission_item_reached_message(index), now)
        if item.command in _WAYPOINTS:
            self.text(INFO, self.kind.reached.format(index), self._cause(now))

    def _landed(self, now: float) -> bool:
        """On the ground: disarm, unless the plan takes off again."""
        index, held = self.flight.index, self.missions[MISSION].held
        if index is not None and self.kind.land_mode is None:
            return True
        following = [item for item in held[index + 1:] if item.command in _NAVIGATION] if index is not None else []
        if following and following[0].command in _TAKEOFFS:
            return True
        self.at("disarm", now + DISARM_AFTER_LANDING_S, self._disarm_landed)
        return False

    def _disarm_landed(self, now: float) -> None:
        if self.armed and not self.flight.airborne(now):
            self._disarm(now - self.response_delay_s)

    def _plan_over(self, now: float) -> None:
        self.complete, self.running = True, False
        if self.kind.complete:
            self.text(NOTICE, self.kind.complete, self._cause(now), later_s=2 * TEXT_LAG_S)
        if (self.kind.land_mode is not None or self.kind.is_plane) and not self.flight.airborne(now):
            wait_s = PLANE_DISARMS_S if self.kind.land_mode is None else DISARM_AFTER_LANDING_S
            self.at("disarm", now + wait_s, self._disarm_landed)

    # -- what it sends --------------------------------------------------------------------

    def heartbeat(self):
        kind = self.kind
        base = mavlink.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED
        if kind.always_stabilized:
            base |= mavlink.MAV_MODE_FLAG_STABILIZE_ENABLED
        if kind.always_stabilized or self.mode in kind.manual_modes:
            base |= mavlink.MAV_MODE_FLAG_MANUAL_INPUT_ENABLED
        if self.mode in kind.by_itself:
            base |= mavlink.MAV_MODE_FLAG_GUIDED_ENABLED
        if self.armed:
            base |= mavlink.MAV_MODE_FLAG_SAFETY_ARMED
        return mavlink.MAVLink_heartbeat_message(
            self.vehicle_type, self.autopilot_type, base,
            kind.modes[self.mode], self._system_status(), 3)

    def _system_status(self) -> int:
        now, kind = self._now, self.kind
        if self.armed and kind.position_s \
                and self._armed_at + WITHOUT_POSITION_S < now < self._position_at() + WITHOUT_POSITION_S \
                and self._armed_at < self._position_at():
            return mavlink.MAV_STATE_CRITICAL
        at_rest = (not (self.armed and self.flight.airborne(now)) if kind.idle_modes is None
                   else self.mode in kind.idle_modes)
        return mavlink.MAV_STATE_STANDBY if at_rest else mavlink.MAV_STATE_ACTIVE

    def _mission_current(self):
        total = max(0, len(self.missions[MISSION].held) - 1)
        if total == 0:
            state = mavlink.MISSION_STATE_NO_MISSION
        elif self.complete:
            state = mavlink.MISSION_STATE_COMPLETE
        elif self.running:
            state = mavlink.MISSION_STATE_ACTIVE
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
                boot_ms, lat, lon, altitude_mm, round(height * 1000), *self.flight.velocity(now), 0)
        if identity == mavlink.MAVLINK_MSG_ID_HOME_POSITION and self.home:
            return mavlink.MAVLink_home_position_message(
                self.home[0], self.home[1], round(self.home[2] * 1000), 0, 0, 0,
                [math.nan] * 4, 0, 0, 0, boot_ms * 1000)
        if identity == EXTENDED_SYS_STATE and (self.kind.needs_takeoff or self.kind.is_plane):  # by source
            vtol_state = mavlink.MAV_VTOL_STATE_UNDEFINED if self.kind.is_plane and not self.kind.hovers \
                else mavlink.MAV_VTOL_STATE_MC
            return mavlink.MAVLink_extended_sys_state_message(vtol_state, self.flight.landed_state(now))
        if identity == POSITION_TARGET_GLOBAL_INT and self.flight.target and self.mode == "GUIDED":
            target = self.flight.target
            return mavlink.MAVLink_position_target_global_int_message(
                boot_ms, 0, PLACE_ALONE, target.lat_e7, target.lon_e7, target.height, 0, 0, 0, 0, 0, 0, 0, 0)
        if identity == mavlink.MAVLINK_MSG_ID_AUTOPILOT_VERSION:
            capabilities = mavlink.MAV_PROTOCOL_CAPABILITY_MISSION_FLOAT \
                | mavlink.MAV_PROTOCOL_CAPABILITY_COMMAND_INT \
                | mavlink.MAV_PROTOCOL_CAPABILITY_MISSION_FENCE \
                | mavlink.MAV_PROTOCOL_CAPABILITY_MISSION_RALLY
            if not self.faults.takes_only_float_items:
                capabilities |= mavlink.MAV_PROTOCOL_CAPABILITY_MISSION_INT
            if self.ftp.is_enabled:
                capabilities |= mavlink.MAV_PROTOCOL_CAPABILITY_FTP
            if self.mavlink_version == 2:
                capabilities |= mavlink.MAV_PROTOCOL_CAPABILITY_MAVLINK2
            return mavlink.MAVLink_autopilot_version_message(
                capabilities, 4 << 24 | 6 << 16 | 3 << 8 | 255, 0, 0, 0,
                [0] * 8, [0] * 8, [0] * 8, 0, 0, 0)
        return self.instruments.message_of(identity, boot_ms, self.flight.where(now), altitude_mm)

    def tell_param(self, name: str, kind: int, value: float, now: float) -> None:
        """A PARAM_VALUE nobody asked for: it tells of each parameter that it changes."""
        self.answer(mavlink.MAVLink_param_value_message(
            name.encode(), value, kind, self.parameters.count, NO_INDEX), now, later_s=0.003)

    # -- start ----------------------------------------------------------------------------

    def _start_timers(self, now: float) -> None:
        for identity, period_s in self._streams.items():
            self.default_stream(identity, period_s, now)
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
        self.ftp.forget()
        self.armed = self._may_take_off = self.complete = self.running = False
        self.mode = self.kind.first_mode
        self.current = 0
        self._last_reached = NOTHING_REACHED
        self._seen.clear()
        self.flight.land_at_once()
        self.flight.forget_jumps()
        self._start_timers(now)
