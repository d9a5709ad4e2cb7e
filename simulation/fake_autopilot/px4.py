"""PX4 1.17.0, or 1.18 on its way: its modes, its commands, its flight, around its mission protocol."""
import math
from collections.abc import Iterable

from . import hearing, instruments, parameters
from .autopilot import TEXT_LAG_S, FakeAutopilot
from .dialect import mavlink
from .feasibility import objection
from .flight import DELAY, JUMP, LANDINGS, PLACE_IGNORED, RETURN, Flight, Pace, Place
from .items import FENCE, MISSION, RALLY, Item, whole_number
from .px4_missions import Missions, State
from .px4_rewriting import AT_A_PLACE
from .velocities import velocity_of

CRITICAL = mavlink.MAV_SEVERITY_CRITICAL
INFO = mavlink.MAV_SEVERITY_INFO

RESULT_ACCEPTED = mavlink.MAV_RESULT_ACCEPTED
RESULT_REJECTED_FOR_NOW = mavlink.MAV_RESULT_TEMPORARILY_REJECTED
RESULT_DENIED = mavlink.MAV_RESULT_DENIED
RESULT_UNSUPPORTED = mavlink.MAV_RESULT_UNSUPPORTED
RESULT_FAILED = mavlink.MAV_RESULT_FAILED

MAIN_MODES = {1: "MANUAL", 2: "ALTCTL", 3: "POSCTL", 4: "AUTO", 5: "ACRO", 6: "OFFBOARD",
              7: "STABILIZED"}
AUTO, OFFBOARD = 4, 6
SUB_TAKEOFF, SUB_LOITER, SUB_MISSION, SUB_RTL, SUB_LAND = 2, 3, 4, 5, 6
_PLAN_MODES = (SUB_TAKEOFF, SUB_MISSION, SUB_LAND)

_FOR_A_WHILE = (SUB_TAKEOFF, SUB_RTL, SUB_LAND)  # it does not go back to these when it is disarmed
MODE_NAMES = {(AUTO, SUB_MISSION): "Mission", (6, 0): "Offboard"}  # those that need something first

PACE = Pace(acceleration=1.88, speed=5.0, climb=0.89, descent=0.7, spool_up_s=2.0, reaches_land_above=True,
            takes_off_at_place=True)

TELLS_PERIOD_S = 1.02  # of MISSION_CURRENT and of a repeated MISSION_ITEM_REACHED
REACHED_AGAIN = 10  # times, at the most
DISARM_AFTER_LANDING_S = 2.0  # in LAND; at the end of a plan at once
MISSION_LANDED_S = 0.18  # from the landing to the text, and as long again to the disarming
LOOKS_AFTER_S = 0.025  # after it has accepted a plan; 0.010 to 0.062 seen
HOLDS_AFTER_S = 0.1  # from the end of its plan in the air to the change to HOLD; less than 0.24 seen
COMMANDER_S = 0.005  # so much later answers the part that arms and changes modes; 0.004 to 0.014 seen
STREAM_S = 1.0  # OFFBOARD wants a target in this time
STREAM_GONE_S = 0.14  # and when it has still none so much later, it returns; 1.14 s from the last target seen
DEFAULT_TAKEOFF_M = 2.5  # its parameter MIS_TAKEOFF_ALT
PARAM_AGAIN_S = 0.012  # from PARAM_VALUE to its second copy, after a change; 7 to 19 ms seen
TEXT_LENGTH = 50  # of a STATUSTEXT; what is longer comes in several

MISSION_CURRENT = mavlink.MAVLINK_MSG_ID_MISSION_CURRENT
MISSION_ITEM_REACHED = mavlink.MAVLINK_MSG_ID_MISSION_ITEM_REACHED
_TO_THE_COMMANDER = (mavlink.MAV_CMD_DO_SET_MODE, mavlink.MAV_CMD_COMPONENT_ARM_DISARM,
                     mavlink.MAV_CMD_MISSION_START, mavlink.MAV_CMD_DO_SET_STANDARD_MODE)
_NO_STREAMS = (MISSION_CURRENT, MISSION_ITEM_REACHED)  # they come as they come, and cannot be asked for
GLOBAL_POSITION_INT = mavlink.MAVLINK_MSG_ID_GLOBAL_POSITION_INT
POSITION_TARGET_GLOBAL_INT = mavlink.MAVLINK_MSG_ID_POSITION_TARGET_GLOBAL_INT
EXTENDED_SYS_STATE = mavlink.MAVLINK_MSG_ID_EXTENDED_SYS_STATE


# MAV_STANDARD_MODE: the mode of a multicopter, as PX4 1.16 lists them.
STANDARD_MODES = {
    mavlink.MAV_STANDARD_MODE_POSITION_HOLD: (3, 0), mavlink.MAV_STANDARD_MODE_ORBIT: (3, 1),
    mavlink.MAV_STANDARD_MODE_ALTITUDE_HOLD: (2, 0), mavlink.MAV_STANDARD_MODE_SAFE_RECOVERY: (AUTO, SUB_RTL),
    mavlink.MAV_STANDARD_MODE_MISSION: (AUTO, SUB_MISSION), mavlink.MAV_STANDARD_MODE_LAND: (AUTO, SUB_LAND),
    mavlink.MAV_STANDARD_MODE_TAKEOFF: (AUTO, SUB_TAKEOFF),
}  # fmt: skip
# The list of modes: (mode, its name if it has no standard one, whether it can be set).
MODES = [((1, 0), "Manual", True), ((2, 0), "", True), ((3, 0), "", True), ((AUTO, SUB_MISSION), "", True),
         ((AUTO, SUB_LOITER), "Hold", True), ((AUTO, SUB_RTL), "", True), ((AUTO, SUB_LAND), "", True),
         ((AUTO, SUB_TAKEOFF), "", True), ((OFFBOARD, 0), "Offboard", False)]  # fmt: skip


def custom_mode(main: int, sub: int = 0) -> int:
    """HEARTBEAT.custom_mode as PX4 packs it."""
    return main << 16 | sub << 24


def _standard_mode(main: int, sub: int) -> int:
    return next((standard for standard, mode in STANDARD_MODES.items() if mode == (main, sub)),
                mavlink.MAV_STANDARD_MODE_NON_STANDARD)


class Px4(FakeAutopilot):
    """PX4 on a multicopter.

    home: (latitude [1e-7 degrees], longitude [1e-7 degrees], altitude [m]).
    item_limit, fence_limit, rally_limit: how many items it has room for; not seen.
    infeasible_text: whether it says in a STATUSTEXT why it will not fly an accepted plan (by
    source). The recorded one did not: it said so only by mission_state in MISSION_CURRENT.
    takeoff_required: its parameter MIS_TKO_LAND_REQ, off by default. streams: further messages that
    it sends unasked, and how often [s]. is_1_18: as PX4 1.18 (a state of August 2026, before its release) it tells
    again how many items a plan has, has DO_SET_MISSION_CURRENT, takes SETUP_SIGNING, and refuses an item that has a
    number in a parameter that it does not know.
    hears_station: a ground station is on its link, too. By source it sends a STATUSTEXT nowhere else.
    """

    autopilot_type = mavlink.MAV_AUTOPILOT_PX4
    heard_by = hearing.PX4
    response_delay_s = 0.010
    response_delay_on_line_s = 0.0005

    def __init__(self, *, item_limit: int = 2000, fence_limit: int = 64, rally_limit: int = 32,
                 home: tuple[int, int, float] = (473977428, 85455937, 489.5),
                 armed: bool = False, mode: tuple[int, int] | None = None,
                 infeasible_text: bool = True, takeoff_required: bool = False,
                 tells_at_s: float = 0.5, streams: dict[int, float] | None = None,
                 is_1_18: bool = False, hears_station: bool = False, **options) -> None:
        super().__init__(**options)
        self.is_1_18 = is_1_18
        self.hears_station = hears_station
        if self.mavlink_version != 2:
            raise ValueError("PX4 speaks MAVLink 2: give mavlink_version=2")
        self.home = home
        self.armed = armed
        self.main_mode, self.sub_mode = mode or (AUTO, SUB_LOITER)
        self.infeasible_text = infeasible_text
        self.takeoff_required = takeoff_required
        self.complete = False
        self._is_set_since = False  # its current item, since the plan was complete
        self.instruments = instruments.of_px4()
        self.parameters = parameters.of_px4()
        self._parameters_set = 0
        self._mode_when_disarmed = (self.main_mode, self.sub_mode)
        self._known_current = self._told_current = 0  # see _on_set_current
        self._state_before: int | None = None  # of the mission, until it has looked at a new plan
        self._text_number = 0
        self._reached: int | None = None
        self._reached_again = 0
        self._streamed_at = -math.inf  # when the last target for OFFBOARD was heard [s]
        self.home_is_known = True
        self.in_failsafe = False  # it then flies for its own reasons, in HOLD, RTL or LAND
        self._has_lost_stream = False  # why it is in its failsafe: its targets have ended in OFFBOARD
        self._takeoff_z = math.nan  # of the last takeoff that was commanded [m above sea level]
        self.missions = Missions(self, {MISSION: item_limit, FENCE: fence_limit,
                                        RALLY: rally_limit})
        self.flight = Flight(PACE, Place(home[0], home[1], 0.0), home[2],
                             lambda: self.missions.held[MISSION],
                             self._item_begun, self._item_reached, self._plan_over, self._landed, self._jumped)
        missions = self.missions
        self._hears = {
            "MISSION_COUNT": missions.on_count,
            "MISSION_ITEM_INT": missions.on_item,
            "MISSION_ITEM": missions.on_item,
            "MISSION_ACK": missions.on_ack,
            "MISSION_REQUEST_LIST": missions.on_request_list,
            "MISSION_REQUEST_INT": missions.on_request,
            "MISSION_REQUEST": missions.on_request,
            "MISSION_CLEAR_ALL": missions.on_clear,
            "MISSION_SET_CURRENT": self._on_set_current,
            "COMMAND_LONG": self._on_command,
            "COMMAND_INT": self._on_command,
            "SET_MODE": self._on_set_mode,
            "SET_POSITION_TARGET_GLOBAL_INT": self._on_set_target,
            "SET_POSITION_TARGET_LOCAL_NED": self._on_set_velocity,
            "PARAM_REQUEST_READ": self._on_param_request_read,
            "PARAM_SET": self._on_param_set,
            **({"SETUP_SIGNING": self._on_setup_signing} if is_1_18 else {}),
        }
        self.at("tell", tells_at_s, self._tell)
        self._streams = streams or {}
        self._begin_streams(0.0)

    def _begin_streams(self, now: float) -> None:
        for identity, period_s in self._streams.items():
            self.default_stream(identity, period_s, now)

    # -- the plan -------------------------------------------------------------------------

    def plan(self, mission_type: int = MISSION) -> list[Item]:
        return self.missions.as_read(mission_type)

    def received(self, mission_type: int = MISSION) -> list[Item]:
        return list(self.missions.received[mission_type])

    def load(self, items: Iterable[Item], mission_type: int = MISSION) -> None:
        self.missions.load(list(items), mission_type)
        self._known_current = self.missions.current

    @property
    def objection(self) -> str | None:
        """Why it will not fly the plan aboard; None if it will."""
        return objection(self.missions.held[MISSION], self.home[2],
                         not self.flight.airborne(self._now), self.takeoff_required)

    def plan_changed(self, flagged: int | None, now: float) -> None:
        """A new plan is aboard. The current item stays what it was, if the plan flags no other as current.

        MISSION_CURRENT names the new plan at once; its state and the words for what is wrong follow.
        """
        missions = self.missions
        flying = self.flight.index is not None
        state_before = self._mission_state()
        last = max(len(missions.held[MISSION]) - 1, 0)
        missions.current = min(missions.current, last) if flagged is None else flagged
        self._known_current = missions.current
        self.complete = False
        self._state_before = state_before
        self.flight.forget_jumps()
        self.at("look", now + self.response_delay_s + LOOKS_AFTER_S, self._look)
        self._tell_if_changed(now)
        if not flying:
            return
        self.flight.stop(now)
        if not self._can_fly_plan():
            self._set_mode(AUTO, SUB_LOITER, now)
        else:
            self._fly_from(missions.current, now)

    def _look(self, now: float) -> None:
        self._state_before = None
        words = self.objection
        if words and self.infeasible_text:
            self.text(CRITICAL, words + "\t", now - self.response_delay_s, later_s=0.0)

    def _tell_if_changed(self, now: float) -> None:
        """A MISSION_CURRENT beside those of each second, for an item it has not told of yet."""
        if self._known_current != self._told_current:
            self.answer(self._mission_current(), now, later_s=0.005)

    def forget_reached(self) -> None:
        """A new upload ends the repeating of MISSION_ITEM_REACHED."""
        self._reached = None

    # -- what it hears --------------------------------------------------------------------

    def _on_set_current(self, message, sender, now: float) -> None:
        """MISSION_CURRENT tells of it when its turn comes, within about a second.

        But of one that comes while a new plan is still being looked at, it tells nothing until the
        next plan or start, though that is the current item then.
        """
        if message.target_system != self.address[0]:
            return
        if self.missions.state is not State.IDLE:
            self.text(CRITICAL, "WPM: IGN WP CURR CMD: Busy\t", now)
        elif not self._set_current(message.seq, now):
            self.text(CRITICAL, "WPM: WP CURR CMD: Not in list\t", now)

    def _set_current(self, seq: int, now: float) -> bool:
        if not 0 <= seq < len(self.missions.held[MISSION]):
            return False
        self.missions.current = seq
        self._is_set_since = True
        if self._state_before is None:
            self._known_current = seq
        if self.flight.index is not None:
            self._fly_from(seq, now)
        return True

    def _on_setup_signing(self, message, sender, now: float) -> None:
        if self.armed:  # by source
            self.text(CRITICAL, "MAVLink signing: rejected while armed", now)
            return
        super()._on_setup_signing(message, sender, now)
        words = "key accepted" if any(message.secret_key) else "disabled"
        self.text(INFO, f"MAVLink signing {words}", now)

    def _on_param_request_read(self, message, sender, now: float) -> None:
        if not self._is_for_its_parameters(message):
            return
        known = self.parameters.asked_for(message)
        if known is not None:
            self.answer(self.parameters.told(known), now)

    def _is_for_its_parameters(self, message) -> bool:
        return message.target_system == self.address[0] and message.target_component in (0, self.address[1])

    def _on_param_set(self, message, sender, now: float) -> None:
        """It takes any number, also NaN, of the parameter's own type; a change is told a second time."""
        known = self.parameters.all.get(message.param_id)
        if known is None or message.param_type != known.kind or not self._is_for_its_parameters(message):
            return

        def take(time: float) -> None:
            before = known.value
            known.value = self.parameters.from_the_wire(known, message.param_value)
            self.send_now(self.parameters.told(known), time)
            if abs(known.value - before) > 0:  # not so from or to NaN
                self.at(f"{known.name} again", time + PARAM_AGAIN_S,
                        lambda later: self.send_now(self.parameters.told(known), later))

        self._parameters_set += 1
        self.at(f"parameter {self._parameters_set}", now + self.response_delay_s, take)

    def _on_set_mode(self, message, sender, now: float) -> None:
        """SET_MODE is taken for MAV_CMD_DO_SET_MODE, and acknowledged as that."""
        if message.target_system not in (0, self.address[0]):
            return
        main, sub = message.custom_mode >> 16 & 0xFF, message.custom_mode >> 24 & 0xFF
        self._command_ack(mavlink.MAV_CMD_DO_SET_MODE, self._mode_ordered(main, sub, now), sender, now)

    def _on_set_target(self, message, sender, now: float) -> None:
        """Flown to in OFFBOARD alone, which wants a stream of them.

        By source: it looks at the frame, and takes these numbers of frames alone; a height above home needs home.
        """
        if message.target_system not in (0, self.address[0]) \
                or message.target_component not in (0, self.address[1]):
            return
        height = message.alt
        if message.coordinate_frame == mavlink.MAV_FRAME_GLOBAL_INT:
            height -= self.home[2]
        elif message.coordinate_frame != mavlink.MAV_FRAME_GLOBAL_RELATIVE_ALT_INT:
            self.text(CRITICAL, f"SET_POSITION_TARGET_GLOBAL_INT invalid coordinate frame {message.coordinate_frame}\t",
                      now)
            return
        elif not self.home_is_known:
            return
        if self._is_flown_to(now) and not message.type_mask & PLACE_IGNORED:
            self.flight.chase(Place(message.lat_int, message.lon_int, height), now)
            self._follow_flight()

    def _is_flown_to(self, now: float) -> bool:
        """A target for OFFBOARD has come."""
        self._streamed_at = now
        if self._has_lost_stream:
            self._set_mode(OFFBOARD, 0, now)  # what was ordered is still OFFBOARD, and can be flown again
        if self.main_mode != OFFBOARD:
            return False
        self._watch_stream()
        return self.armed and self.flight.airborne(now)

    def _on_set_velocity(self, message, sender, now: float) -> None:
        """By source: a yaw counts from north in both frames, and without one the heading stays."""
        if message.target_system not in (0, self.address[0]) \
                or message.target_component not in (0, self.address[1]):
            return
        if message.coordinate_frame not in (mavlink.MAV_FRAME_LOCAL_NED, mavlink.MAV_FRAME_BODY_NED):
            self.text(CRITICAL, "SET_POSITION_TARGET_LOCAL_NED coordinate frame "
                      f"{message.coordinate_frame} unsupported\t", now)
            return
        velocity = velocity_of(message)
        if velocity is None or not self._is_flown_to(now):
            return
        if message.coordinate_frame == mavlink.MAV_FRAME_BODY_NED:
            velocity = velocity.turned(self.flight.heading(now))
        if velocity.yaw is not None:
            self.flight.face(velocity.yaw)
        else:
            self.flight.turn(velocity.rate or 0.0, now, 2 * STREAM_S)
        self.flight.drive(velocity.north_east_up, now, 2 * STREAM_S)
        self._follow_flight()

    def _watch_stream(self) -> None:
        self.never("stream gone")
        self.at("stream late", self._streamed_at + STREAM_S, self._stream_is_late)

    def _stream_is_late(self, now: float) -> None:
        if self.armed and self.main_mode == OFFBOARD:
            self.text(CRITICAL, "Failsafe activated\t", now)
            self.at("stream gone", now + STREAM_GONE_S, self._stream_is_gone)

    def _stream_is_gone(self, now: float) -> None:
        """It returns. (Had a target come meanwhile, it would go on.)"""
        if self.armed and self.main_mode == OFFBOARD:
            self._set_mode(AUTO, SUB_RTL, now)
            self.in_failsafe = self._has_lost_stream = True

    def _has_stream(self, now: float) -> bool:
        return now - self._streamed_at <= STREAM_S

    # -- commands -------------------------------------------------------------------------

    def _on_command(self, message, sender, now: float) -> None:
        if message.target_system not in (0, self.address[0]) \
                or message.target_component not in (0, self.address[1]):
            return
        act = {
            mavlink.MAV_CMD_COMPONENT_ARM_DISARM: self._arm_or_disarm,
            mavlink.MAV_CMD_DO_SET_MODE: self._do_set_mode,
            mavlink.MAV_CMD_DO_SET_STANDARD_MODE: self._set_standard_mode,
            mavlink.MAV_CMD_MISSION_START: self._mission_start,
            mavlink.MAV_CMD_NAV_TAKEOFF: self._nav_takeoff,
            mavlink.MAV_CMD_DO_REPOSITION: self._do_reposition,
            mavlink.MAV_CMD_DO_CHANGE_SPEED: self._do_change_speed,
            mavlink.MAV_CMD_SET_MESSAGE_INTERVAL: self._set_message_interval,
            mavlink.MAV_CMD_GET_MESSAGE_INTERVAL: self._get_message_interval,
            mavlink.MAV_CMD_REQUEST_MESSAGE: self._request_message,
            mavlink.MAV_CMD_REQUEST_AUTOPILOT_CAPABILITIES: None if self.is_1_18 else self._request_capabilities,
            mavlink.MAV_CMD_DO_SET_MISSION_CURRENT: self._do_set_mission_current if self.is_1_18 else None,
        }.get(message.command)
        if act is None:
            self._command_ack(message.command, RESULT_UNSUPPORTED, sender, now)
            return
        if self.is_1_18 and message.get_type() == "COMMAND_INT" and message.frame != mavlink.MAV_FRAME_GLOBAL_INT:
            self._command_ack(message.command, mavlink.MAV_RESULT_COMMAND_UNSUPPORTED_MAV_FRAME, sender, now)
            return
        result = act(message, now)
        if message.command == mavlink.MAV_CMD_DO_SET_MODE and not self.is_1_18:
            # Two of its parts answer, and the first knows nothing yet.
            self._command_ack(message.command, RESULT_ACCEPTED, sender, now)
        by_commander = message.command in _TO_THE_COMMANDER
        self._command_ack(message.command, result, sender, now, COMMANDER_S if by_commander else 0.0)

    def _command_ack(self, command: int, result: int, sender, now: float, later_s: float = 0.0) -> None:
        self.answer(mavlink.MAVLink_command_ack_message(command, result, 0, 0, *sender), now, later_s)

    def _arm_or_disarm(self, message, now: float) -> int:
        """In mission mode, arming begins the plan at its current item."""
        if message.param1 == 1:
            if self.armed:
                return RESULT_ACCEPTED
            in_mission_mode = (self.main_mode, self.sub_mode) == (AUTO, SUB_MISSION)
            if in_mission_mode and not self._can_fly_plan():
                self.text(CRITICAL, "Arming denied: Resolve system health failures first\t", now,
                          later_s=COMMANDER_S + TEXT_LAG_S)
                return RESULT_REJECTED_FOR_NOW
            self.armed = True
            self.text(INFO, "Armed by external command\t", now, later_s=COMMANDER_S + 0.001)
            if in_mission_mode:
                self._fly_plan(now)
            elif (self.main_mode, self.sub_mode) == (AUTO, SUB_TAKEOFF):
                self._take_off(now, COMMANDER_S + 0.17)
            return RESULT_ACCEPTED
        if message.param1 != 0:
            return RESULT_UNSUPPORTED
        if self.armed and self.flight.airborne(now):
            self.text(CRITICAL, "Disarming denied: not landed\t", now)
            return RESULT_REJECTED_FOR_NOW
        if self.armed:
            self._disarm(now)
            self.text(INFO, "Disarmed by external command\t", now, later_s=COMMANDER_S + 0.001)  # by source
        return RESULT_ACCEPTED

    def _disarm(self, now: float) -> None:
        self.armed = False
        self.flight.stop(now)
        self._follow_flight()
        self.main_mode, self.sub_mode = self._mode_when_disarmed

    def _do_set_mode(self, message, now: float) -> int:
        return self._mode_ordered(whole_number(message.param2),
                                  whole_number(message.param3), now)

    def _mode_ordered(self, main: int, sub: int, now: float) -> int:
        """Disarmed it takes any mode; what is missing then keeps it from being armed."""
        if main not in MAIN_MODES or not 0 <= sub <= 255:
            return RESULT_REJECTED_FOR_NOW if self.is_1_18 else RESULT_UNSUPPORTED
        name = MODE_NAMES.get((main, sub))
        is_possible = self._has_stream(now) if name == "Offboard" else self._can_fly_plan()
        if self.armed and name and not is_possible:
            self.text(CRITICAL, f"Switching to {name} is currently not available\t", now,
                      later_s=COMMANDER_S + TEXT_LAG_S)
            return RESULT_REJECTED_FOR_NOW
        self._set_mode(main, sub, now)
        return RESULT_ACCEPTED

    def _set_standard_mode(self, message, now: float) -> int:
        mode = STANDARD_MODES.get(whole_number(message.param1))
        return RESULT_FAILED if mode is None else self._mode_ordered(*mode, now)

    def _can_fly_plan(self) -> bool:
        return bool(self.missions.held[MISSION]) and self.objection is None

    def _mission_start(self, message, now: float) -> int:
        """Arms by itself, and begins at item param1, in the air too."""
        if not self._can_fly_plan():
            self.text(CRITICAL, "Mission start denied! No valid mission\t", now,
                      later_s=COMMANDER_S + TEXT_LAG_S)
            return RESULT_DENIED
        first = whole_number(message.param1)
        if 0 <= first < len(self.missions.held[MISSION]):
            self.missions.current = self._known_current = first
            self.complete = False
        if self.flight.index is not None:
            self._fly_from(self.missions.current, now)
        else:
            if not self.armed:
                self.armed = True
                self.text(INFO, "Armed by mission start\t", now, later_s=COMMANDER_S + 0.001)
            self._set_mode(AUTO, SUB_MISSION, now)
        self._tell_if_changed(now)
        return RESULT_ACCEPTED

    def _do_set_mission_current(self, message, now: float) -> int:
        """-1: the current item. With param2 = 1 the jumps count anew. MISSION_CURRENT tells of it when it flies."""
        seq, items = message.param1, len(self.missions.held[MISSION])
        if not math.isfinite(seq) or seq < -1 or message.param2 not in (0, 1):
            return RESULT_DENIED
        if not self._can_fly_plan() or int(seq) >= items:
            return RESULT_FAILED
        is_other = int(seq) not in (-1, self.missions.current)
        if message.param2 == 1:
            self.flight.forget_jumps()
        if is_other or message.param2 == 1:
            self._is_set_since = True
        if is_other:
            self.missions.current = int(seq)
            if self.flight.index is not None:
                self._fly_from(int(seq), now)
        return RESULT_ACCEPTED

    def _nav_takeoff(self, message, now: float) -> int:
        """Its mode is TAKEOFF then; disarmed, it takes off once it is armed. z is above the sea."""
        self._takeoff_z = message.z if message.get_type() == "COMMAND_INT" else message.param7
        self._set_mode(AUTO, SUB_TAKEOFF, now)
        if self.armed:
            self._take_off(now, 0.15)
        return RESULT_ACCEPTED

    def _take_off(self, now: float, said_later_s: float) -> None:
        here = self.flight.where(now)
        height = self._takeoff_z - self.home[2]
        if math.isnan(height):
            height = DEFAULT_TAKEOFF_M
            self.text(INFO, f"Using default takeoff altitude: {height:.1f} m\t", now, later_s=said_later_s)
        if here.height <= 0.1:
            self.text(INFO, "Takeoff detected\t", now, later_s=PACE.spool_up_s)
        spool_up_s = PACE.spool_up_s if here.height <= 0.1 else 0.0
        self.flight.fly_to(here._replace(height=max(height, here.height + 0.2)), now, spool_up_s=spool_up_s)
        self._follow_flight()

    def _do_reposition(self, message, now: float) -> int:
        """It ignores the frame: z is above the sea. Without the flag that changes the mode it refuses, and in
        HOLD flies there all the same."""
        if message.get_type() == "COMMAND_INT":
            lat, lon, z = message.x, message.y, message.z
        elif math.isnan(message.param5) or math.isnan(message.param6):
            lat, lon, z = None, None, message.param7
        else:
            lat, lon, z = round(message.param5 * 1e7), round(message.param6 * 1e7), message.param7
        changes_mode = whole_number(message.param2) & 1
        if changes_mode:
            self._set_mode(AUTO, SUB_LOITER, now)
        if self.armed and (self.main_mode, self.sub_mode) == (AUTO, SUB_LOITER) and self.flight.airborne(now):
            here = self.flight.where(now)
            height = here.height if math.isnan(z) else z - self.home[2]
            if lat is None:  # stays where it is
                lat, lon = here.lat_e7, here.lon_e7
            self.flight.fly_to(Place(lat, lon, height), now)
            self._follow_flight()
        return RESULT_ACCEPTED if changes_mode else RESULT_UNSUPPORTED

    def _do_change_speed(self, message, now: float) -> int:
        self.flight.pace = self.flight.pace._replace(speed=message.param2 if message.param2 > 0 else PACE.speed)
        return RESULT_ACCEPTED

    def _set_message_interval(self, message, now: float) -> int:
        identity = whole_number(message.param1)
        if identity not in mavlink.mavlink_map or not math.isfinite(message.param2):
            return RESULT_DENIED
        if identity in _NO_STREAMS:
            return RESULT_FAILED
        self.set_interval(identity, message.param2, now)
        return RESULT_ACCEPTED

    def _get_message_interval(self, message, now: float) -> int:
        identity = whole_number(message.param1)
        self.answer(mavlink.MAVLink_message_interval_message(identity, self.interval_us(identity)), now)
        return RESULT_ACCEPTED

    def _request_message(self, message, now: float) -> int:
        identity = whole_number(message.param1)
        if identity == mavlink.MAVLINK_MSG_ID_AVAILABLE_MODES:
            return self._tell_modes(whole_number(message.param2), now)
        reply = None if identity in _NO_STREAMS else self.message_of(identity, now)
        if reply is None:
            return RESULT_DENIED
        self.answer(reply, now)
        return RESULT_ACCEPTED

    def _tell_modes(self, number: int, now: float) -> int:
        """An entry of its list; 0: all of them."""
        if number > len(MODES):
            return RESULT_DENIED
        for index in range(len(MODES)) if number == 0 else [number - 1]:
            (main, sub), name, can_be_set = MODES[index]
            self.answer(mavlink.MAVLink_available_modes_message(
                len(MODES), index + 1, _standard_mode(main, sub), custom_mode(main, sub),
                0 if can_be_set else mavlink.MAV_MODE_PROPERTY_NOT_USER_SELECTABLE, name.encode()), now)
        return RESULT_ACCEPTED

    def _request_capabilities(self, message, now: float) -> int:
        self.answer(self.message_of(mavlink.MAVLINK_MSG_ID_AUTOPILOT_VERSION, now), now)
        return RESULT_ACCEPTED

    # -- modes and flying -----------------------------------------------------------------

    def _set_mode(self, main: int, sub: int, now: float) -> None:
        if (main, sub) == (self.main_mode, self.sub_mode) and self.flight.index is not None:
            return
        self.main_mode, self.sub_mode = main, sub
        self.in_failsafe = self._has_lost_stream = False
        if main == OFFBOARD:
            self._watch_stream()
        if main != AUTO or sub not in _FOR_A_WHILE:
            self._mode_when_disarmed = (main, sub)
        self.flight.stop(now)
        if self.armed and (main, sub) == (AUTO, SUB_LAND):
            self.complete = False
            self.flight.sink(now)
        elif (main, sub) == (AUTO, SUB_RTL) and self.flight.airborne(now):
            self.flight.fly_to(self.flight.home._replace(height=self.flight.where(now).height), now, lands=True)
        self._follow_flight()
        if self.armed and (main, sub) == (AUTO, SUB_MISSION) and self._can_fly_plan():
            self._fly_plan(now)

    def _fly_plan(self, now: float) -> None:
        """From its current item, wherever that stands. A finished plan begins anew only when it has been disarmed."""
        if self.complete and not self._is_set_since:
            if self.flight.airborne(now):  # by source: it was seen to hold again
                self.text(CRITICAL, "No valid mission available, loitering\t", now)
                self.at("hold", now + HOLDS_AFTER_S, self._hold_at_end)
                return
            self.missions.current = 0
        self.complete = self._is_set_since = False
        self.text(INFO, "Executing Mission\t", now, later_s=0.18)
        self._fly_from(self.missions.current, now)

    def _fly_from(self, index: int, now: float) -> None:
        self.flight.begin(index, now)
        self._follow_flight()

    def arrive(self, now: float) -> None:
        """End the item being flown now, and not at its own pace."""
        self._advance(now)
        self._leg_over(now)

    def _follow_flight(self) -> None:
        if self.flight.ends_at == math.inf:
            self.never("leg")
        else:
            self.at("leg", self.flight.ends_at, self._leg_over)

    def _leg_over(self, now: float) -> None:
        has_climbed = (self.main_mode, self.sub_mode) == (AUTO, SUB_TAKEOFF) and self.flight.target is not None
        self.flight.advance(now)
        self._follow_flight()
        if has_climbed:
            self.sub_mode = SUB_LOITER
            self._mode_when_disarmed = (AUTO, SUB_LOITER)

    def _item_begun(self, index: int, item: Item, now: float) -> None:
        self.missions.current = self._known_current = index
        if not self.flight.airborne(now) and item.command in AT_A_PLACE and item.command not in LANDINGS:
            height = item.z - self.home[2] if item.frame == 5 else item.z
            self.text(INFO, f"Climb to {height:.1f} meters above home\t", now, later_s=0.35)
            self.text(INFO, "Takeoff detected\t", now, later_s=PACE.spool_up_s)
        if item.command == RETURN and self.flight.airborne(now):  # it is a mode, and the plan is over
            self._item_reached(index, item, now)
            self._end_plan()
            self._set_mode(AUTO, SUB_RTL, now)

    def _item_reached(self, index: int, item: Item, now: float) -> None:
        """Seen: of an item and those behind it that take no time and have no place only the last is reported."""
        held = self.missions.held[MISSION]
        if index + 1 < len(held) and held[index + 1].command not in (*AT_A_PLACE, DELAY, JUMP):
            return
        self._reached, self._reached_again = index, 0
        self.send_now(mavlink.MAVLink_mission_item_reached_message(index), now)

    def _landed(self, now: float) -> bool:
        """On the ground: the plan is complete, in LAND too, but for a landing in its middle."""
        index, held = self.flight.index, self.missions.held[MISSION]
        if index is not None and index + 1 < len(held):
            return True
        if index is not None and index < len(held) and self._reached != index:
            self._item_reached(index, held[index], now)
        self._end_plan()
        now -= self.response_delay_s  # of its own accord
        self.text(INFO, "Landing detected\t", now, later_s=0.0)
        if index is None:
            self.at("disarm", now + DISARM_AFTER_LANDING_S, self._disarm_landed)
        else:
            self.text(INFO, "Mission finished, landed\t", now, later_s=MISSION_LANDED_S)
            self.at("disarm", now + 2 * MISSION_LANDED_S, self._disarm_landed)
        return False

    def _disarm_landed(self, now: float) -> None:
        if self.armed and not self.flight.airborne(now):
            self._disarm(now)
            self.text(INFO, "Disarmed by landing\t", now, later_s=0.0)

    def _hold_at_end(self, now: float) -> None:
        if self.complete and (self.main_mode, self.sub_mode) == (AUTO, SUB_MISSION):
            self.sub_mode = SUB_LOITER
            self._mode_when_disarmed = (AUTO, SUB_LOITER)

    def _end_plan(self) -> None:
        self.complete, self._is_set_since = True, False
        self.flight.forget_jumps()

    def _jumped(self, index: int, item: Item, times: int, now: float) -> None:
        self.missions.tell_of_jump(index, now)

    def _plan_over(self, now: float) -> None:
        self._end_plan()
        if self.flight.airborne(now):
            self.text(INFO, "Mission finished, loitering\t", now - self.response_delay_s, later_s=0.008)
            self.at("hold", now + HOLDS_AFTER_S, self._hold_at_end)
        else:
            self.at("disarm", now + DISARM_AFTER_LANDING_S, self._disarm_landed)

    # -- what it sends --------------------------------------------------------------------

    def text(self, severity: int, words: str, now: float, later_s: float = TEXT_LAG_S) -> None:
        if not self.hears_station:
            return
        number = self._text_number
        self._text_number += 1
        for chunk, start in enumerate(range(0, len(words), TEXT_LENGTH)):
            self.answer(mavlink.MAVLink_statustext_message(
                severity, words[start:start + TEXT_LENGTH].encode(), number, chunk), now, later_s + 0.010 * chunk)

    def heartbeat(self):
        base = (mavlink.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED
                | mavlink.MAV_MODE_FLAG_AUTO_ENABLED
                | mavlink.MAV_MODE_FLAG_GUIDED_ENABLED
                | mavlink.MAV_MODE_FLAG_STABILIZE_ENABLED)
        if self.main_mode != AUTO:
            base = (mavlink.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED
                    | mavlink.MAV_MODE_FLAG_STABILIZE_ENABLED
                    | mavlink.MAV_MODE_FLAG_MANUAL_INPUT_ENABLED)
        if self.main_mode == OFFBOARD:
            base &= ~mavlink.MAV_MODE_FLAG_MANUAL_INPUT_ENABLED
        status = mavlink.MAV_STATE_STANDBY
        if self.main_mode == OFFBOARD and not self._has_stream(self._now):
            status = mavlink.MAV_STATE_UNINIT
        if (self.main_mode, self.sub_mode) == (AUTO, SUB_MISSION) and not self._can_fly_plan():
            status = mavlink.MAV_STATE_UNINIT  # it would not be armed like this
        if self.armed:
            base |= mavlink.MAV_MODE_FLAG_SAFETY_ARMED
            status = mavlink.MAV_STATE_CRITICAL if self.in_failsafe else mavlink.MAV_STATE_ACTIVE
        return mavlink.MAVLink_heartbeat_message(
            self.vehicle_types[self.vehicle], self.autopilot_type, base,
            custom_mode(self.main_mode, self.sub_mode), status, 3)

    def _tell(self, now: float) -> None:
        self.send_now(self._mission_current(), now)
        self._told_current = self._known_current
        if self.missions.held[MISSION] and self._reached is not None \
                and self._reached_again < REACHED_AGAIN:
            self._reached_again += 1
            self.send_now(mavlink.MAVLink_mission_item_reached_message(self._reached), now)
        self.at("tell", now + TELLS_PERIOD_S, self._tell)

    def _in_plan_mode(self) -> bool:
        return self.main_mode == AUTO and self.sub_mode in _PLAN_MODES

    def _mission_state(self) -> int:
        if self._state_before is not None:
            return self._state_before
        if not self._can_fly_plan():
            return mavlink.MISSION_STATE_NO_MISSION
        if self.complete:
            return mavlink.MISSION_STATE_COMPLETE
        if self._in_plan_mode():
            return mavlink.MISSION_STATE_ACTIVE
        if self._reached is not None:
            return mavlink.MISSION_STATE_PAUSED
        return mavlink.MISSION_STATE_NOT_STARTED

    def _mission_current(self):
        checksums = self.missions.checksums
        return mavlink.MAVLink_mission_current_message(
            self._known_current, len(self.missions.held[MISSION]) or 65535, self._mission_state(),
            1 if self._in_plan_mode() else 2, checksums[MISSION], checksums[FENCE], checksums[RALLY])

    def message_of(self, identity: int, now: float):
        lat, lon, height = self.flight.where(now)
        boot_ms = max(0, round((now - self.booted_at_s) * 1000))
        if identity == mavlink.MAVLINK_MSG_ID_HEARTBEAT:
            return self.heartbeat()
        if identity == MISSION_CURRENT:
            return self._mission_current()
        if identity == mavlink.MAVLINK_MSG_ID_CURRENT_MODE:
            shown = custom_mode(self.main_mode, self.sub_mode)
            return mavlink.MAVLink_current_mode_message(
                _standard_mode(self.main_mode, self.sub_mode), shown, shown)
        if identity == GLOBAL_POSITION_INT:
            return mavlink.MAVLink_global_position_int_message(
                boot_ms, lat, lon, round((self.home[2] + height) * 1000), round(height * 1000),
                *self.flight.velocity(now), 0)
        if identity == EXTENDED_SYS_STATE:
            takes_off = (self.main_mode, self.sub_mode) == (AUTO, SUB_TAKEOFF)
            return mavlink.MAVLink_extended_sys_state_message(0, self.flight.landed_state(now, takes_off))
        if identity == POSITION_TARGET_GLOBAL_INT and self.armed and self.flight.target:
            target = self.flight.target
            return mavlink.MAVLink_position_target_global_int_message(
                boot_ms, 5, 0, int(target.lat_e7 * 1e-7 * 1e7), int(target.lon_e7 * 1e-7 * 1e7),
                self.home[2] + target.height, 0, 0, 0, 0, 0, 0, 0, 0)
        if identity == mavlink.MAVLINK_MSG_ID_HOME_POSITION and self.home_is_known:
            return mavlink.MAVLink_home_position_message(
                self.home[0], self.home[1], round(self.home[2] * 1000), 0, 0, 0,
                [1.0, 0.0, 0.0, 0.0], 0, 0, 0, boot_ms * 1000)
        if identity == mavlink.MAVLINK_MSG_ID_AUTOPILOT_VERSION:
            capabilities = (mavlink.MAV_PROTOCOL_CAPABILITY_MISSION_FLOAT
                            | mavlink.MAV_PROTOCOL_CAPABILITY_COMMAND_INT
                            | mavlink.MAV_PROTOCOL_CAPABILITY_MAVLINK2
                            | mavlink.MAV_PROTOCOL_CAPABILITY_MISSION_FENCE
                            | mavlink.MAV_PROTOCOL_CAPABILITY_MISSION_RALLY)
            if not self.faults.takes_only_float_items:
                capabilities |= mavlink.MAV_PROTOCOL_CAPABILITY_MISSION_INT
            return mavlink.MAVLink_autopilot_version_message(
                capabilities, 1 << 24 | 17 << 16 | 255, 0, 0, 0,
                [0] * 8, [0] * 8, [0] * 8, 0, 0, 0)
        return self.instruments.message_of(
            identity, boot_ms, self.flight.where(now), round((self.home[2] + height) * 1000))

    def _restart(self, now: float) -> None:
        self.missions.forget_transfer()
        self.missions.current = 0
        self.armed = self.complete = False
        self.main_mode, self.sub_mode = self._mode_when_disarmed = (AUTO, SUB_LOITER)
        self._reached = self._state_before = None
        self._known_current = self._told_current = 0
        self._text_number = 0
        self.flight.land_at_once()
        self.flight.forget_jumps()
        self.at("tell", now + TELLS_PERIOD_S / 2, self._tell)
        self._begin_streams(now)
