"""PX4 1.17.0: its modes, its commands, its flight, around its mission protocol."""
import math
from typing import Iterable, Optional

from .autopilot import FakeAutopilot
from .dialect import mavlink
from .feasibility import objection
from .flight import TAKEOFF, Flight, Pace, Place
from .items import FENCE, MISSION, RALLY, Item, whole_number
from .px4_missions import Missions, State

CRITICAL = mavlink.MAV_SEVERITY_CRITICAL
INFO = mavlink.MAV_SEVERITY_INFO

RESULT_ACCEPTED = mavlink.MAV_RESULT_ACCEPTED
RESULT_REJECTED_FOR_NOW = mavlink.MAV_RESULT_TEMPORARILY_REJECTED
RESULT_DENIED = mavlink.MAV_RESULT_DENIED
RESULT_UNSUPPORTED = mavlink.MAV_RESULT_UNSUPPORTED

MAIN_MODES = {1: "MANUAL", 2: "ALTCTL", 3: "POSCTL", 4: "AUTO", 5: "ACRO", 6: "OFFBOARD",
              7: "STABILIZED"}
AUTO = 4
SUB_TAKEOFF, SUB_LOITER, SUB_MISSION, SUB_RTL, SUB_LAND = 2, 3, 4, 5, 6
_PLAN_MODES = (SUB_TAKEOFF, SUB_MISSION, SUB_LAND)

PACE = Pace(acceleration=1.88, speed=5.0, climb=0.89, descent=0.7, spool_up_s=2.0)

TELLS_PERIOD_S = 1.02  # of MISSION_CURRENT and of a repeated MISSION_ITEM_REACHED
REACHED_AGAIN = 10  # times, at the most
DISARM_AFTER_LANDING_S = 2.0

MISSION_CURRENT = mavlink.MAVLINK_MSG_ID_MISSION_CURRENT
GLOBAL_POSITION_INT = mavlink.MAVLINK_MSG_ID_GLOBAL_POSITION_INT


def custom_mode(main: int, sub: int = 0) -> int:
    """HEARTBEAT.custom_mode as PX4 packs it."""
    return main << 16 | sub << 24


class Px4(FakeAutopilot):
    """PX4 on a multicopter.

    home: (latitude [1e-7 degrees], longitude [1e-7 degrees], altitude [m]).
    item_limit, fence_limit, rally_limit: how many items it has room for; not seen.
    infeasible_text: whether it says in a STATUSTEXT why it will not fly an accepted plan (by
    source). The recorded one did not: it said so only by mission_state in MISSION_CURRENT.
    takeoff_required: its parameter MIS_TKO_LAND_REQ, off by default.
    """

    autopilot_type = mavlink.MAV_AUTOPILOT_PX4
    response_delay_s = 0.010
    response_delay_on_line_s = 0.0005

    def __init__(self, *, item_limit: int = 2000, fence_limit: int = 64, rally_limit: int = 32,
                 home: tuple[int, int, float] = (473977428, 85455937, 489.5),
                 armed: bool = False, mode: Optional[tuple[int, int]] = None,
                 infeasible_text: bool = True, takeoff_required: bool = False,
                 tells_at_s: float = 0.5, **options) -> None:
        super().__init__(**options)
        if self.mavlink_version != 2:
            raise ValueError("PX4 speaks MAVLink 2: give mavlink_version=2")
        self.home = home
        self.armed = armed
        self.main_mode, self.sub_mode = mode or (AUTO, SUB_LOITER)
        self.infeasible_text = infeasible_text
        self.takeoff_required = takeoff_required
        self.complete = False
        self._text_number = 0
        self._reached: Optional[int] = None
        self._reached_again = 0
        self.missions = Missions(self, {MISSION: item_limit, FENCE: fence_limit,
                                        RALLY: rally_limit})
        self.flight = Flight(PACE, Place(home[0], home[1], 0.0), home[2],
                             lambda: self.missions.held[MISSION],
                             self._item_begun, self._item_reached, self._plan_over)
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
        }
        self.at("tell", tells_at_s, self._tell)

    # -- the plan -------------------------------------------------------------------------

    def plan(self, mission_type: int = MISSION) -> list[Item]:
        return self.missions.as_read(mission_type)

    def received(self, mission_type: int = MISSION) -> list[Item]:
        return list(self.missions.received[mission_type])

    def load(self, items: Iterable[Item], mission_type: int = MISSION) -> None:
        self.missions.load(list(items), mission_type)

    @property
    def objection(self) -> Optional[str]:
        """Why it will not fly the plan aboard; None if it will."""
        return objection(self.missions.held[MISSION], self.home[2],
                         not self.flight.airborne(self._now), self.takeoff_required)

    def plan_changed(self, first: int, now: float) -> None:
        """A new plan is aboard: fly it from item `first` if one was being flown."""
        flying = self.flight.index is not None
        self.missions.current = first
        self.complete = False
        self.flight.forget_jumps()
        words = self.objection
        if words and self.infeasible_text:
            self.text(CRITICAL, words + "\t", now, later_s=0.025)
        if not flying:
            return
        self.flight.stop(now)
        if words or not self.missions.held[MISSION]:
            self._set_mode(AUTO, SUB_LOITER, now)
        else:
            self._fly_from(first, now)

    def forget_reached(self) -> None:
        """A new upload ends the repeating of MISSION_ITEM_REACHED."""
        self._reached = None

    # -- what it hears --------------------------------------------------------------------

    def _on_set_current(self, message, sender, now: float) -> None:
        if message.target_system != self.address[0]:
            return
        if self.missions.state is not State.IDLE:
            self.text(CRITICAL, "WPM: IGN WP CURR CMD: Busy\t", now)
        elif not self._set_current(message.seq, now):
            self.text(CRITICAL, "WPM: WP CURR CMD: Not in list\t", now)

    def _set_current(self, seq: int, now: float) -> bool:
        """MISSION_CURRENT tells of it when its turn comes, within about a second."""
        if not 0 <= seq < len(self.missions.held[MISSION]):
            return False
        self.missions.current = seq
        self.complete = False
        if self.flight.index is not None:
            self._fly_from(seq, now)
        return True

    def _on_set_mode(self, message, sender, now: float) -> None:
        """SET_MODE is taken for MAV_CMD_DO_SET_MODE, and acknowledged as that."""
        if message.target_system not in (0, self.address[0]):
            return
        main, sub = message.custom_mode >> 16 & 0xFF, message.custom_mode >> 24 & 0xFF
        result = self._mode_ordered(main, sub, now)
        self._command_ack(mavlink.MAV_CMD_DO_SET_MODE, result, sender, now)

    # -- commands -------------------------------------------------------------------------

    def _on_command(self, message, sender, now: float) -> None:
        if message.target_system not in (0, self.address[0]) \
                or message.target_component not in (0, self.address[1]):
            return
        act = {
            mavlink.MAV_CMD_COMPONENT_ARM_DISARM: self._arm_or_disarm,
            mavlink.MAV_CMD_DO_SET_MODE: self._do_set_mode,
            mavlink.MAV_CMD_MISSION_START: self._mission_start,
            mavlink.MAV_CMD_DO_SET_MISSION_CURRENT: self._do_set_mission_current,
            mavlink.MAV_CMD_SET_MESSAGE_INTERVAL: self._set_message_interval,
            mavlink.MAV_CMD_REQUEST_MESSAGE: self._request_message,
        }.get(message.command)
        if act is None:
            self._command_ack(message.command, RESULT_UNSUPPORTED, sender, now)
            return
        self._command_ack(message.command, act(message, now), sender, now)

    def _command_ack(self, command: int, result: int, sender, now: float) -> None:
        self.answer(mavlink.MAVLink_command_ack_message(command, result, 0, 0, *sender), now)

    def _arm_or_disarm(self, message, now: float) -> int:
        if message.param1 == 1:
            self.armed = True
            return RESULT_ACCEPTED
        if message.param1 != 0:
            return RESULT_UNSUPPORTED
        if self.armed and self.flight.airborne(now):
            self.text(CRITICAL, "Disarming denied: not landed\t", now)
            return RESULT_REJECTED_FOR_NOW
        self._disarm(now)
        return RESULT_ACCEPTED

    def _disarm(self, now: float) -> None:
        self.armed = False
        self.flight.stop(now)
        self._follow_flight()

    def _do_set_mode(self, message, now: float) -> int:
        return self._mode_ordered(whole_number(message.param2),
                                  whole_number(message.param3), now)

    def _mode_ordered(self, main: int, sub: int, now: float) -> int:
        if main not in MAIN_MODES or not 0 <= sub <= 255:
            return RESULT_UNSUPPORTED
        if (main, sub) == (AUTO, SUB_MISSION) and not self._can_fly_plan():
            return RESULT_REJECTED_FOR_NOW
        self._set_mode(main, sub, now)
        return RESULT_ACCEPTED

    def _can_fly_plan(self) -> bool:
        return bool(self.missions.held[MISSION]) and self.objection is None

    def _mission_start(self, message, now: float) -> int:
        """Arms by itself."""
        if not self._can_fly_plan():
            self.text(CRITICAL, "Mission start denied! No valid mission\t", now)
            return RESULT_REJECTED_FOR_NOW
        if not self.armed:
            self.armed = True
            self.text(INFO, "Armed by mission start\t", now, later_s=0.001)
        self._set_mode(AUTO, SUB_MISSION, now)
        return RESULT_ACCEPTED

    def _do_set_mission_current(self, message, now: float) -> int:
        if not self._set_current(whole_number(message.param1), now):
            return RESULT_DENIED
        return RESULT_ACCEPTED

    def _set_message_interval(self, message, now: float) -> int:
        identity = whole_number(message.param1)
        if identity not in mavlink.mavlink_map or not math.isfinite(message.param2):
            return RESULT_DENIED
        if identity == MISSION_CURRENT:
            return RESULT_ACCEPTED  # and nothing changes: it is no stream, it comes each second
        self.set_interval(identity, message.param2, now)
        return RESULT_ACCEPTED

    def _request_message(self, message, now: float) -> int:
        reply = self.message_of(whole_number(message.param1), now)
        if reply is None:
            return RESULT_DENIED
        self.answer(reply, now)
        return RESULT_ACCEPTED

    # -- modes and flying -----------------------------------------------------------------

    def _set_mode(self, main: int, sub: int, now: float) -> None:
        if (main, sub) == (self.main_mode, self.sub_mode) and self.flight.index is not None:
            return
        self.main_mode, self.sub_mode = main, sub
        self.flight.stop(now)
        self._follow_flight()
        if self.armed and (main, sub) == (AUTO, SUB_MISSION) and self._can_fly_plan():
            if self.complete:
                self.missions.current, self.complete = 0, False
            self.text(INFO, "Executing Mission\t", now, later_s=0.18)
            self._fly_from(self.missions.current, now)

    def _fly_from(self, index: int, now: float) -> None:
        self.flight.begin(index, now)
        self._follow_flight()

    def _follow_flight(self) -> None:
        if self.flight.index is None or self.flight.ends_at == math.inf:
            self.never("leg")
        else:
            self.at("leg", self.flight.ends_at, self._leg_over)

    def _leg_over(self, now: float) -> None:
        self.flight.advance(now)
        self._follow_flight()

    def _item_begun(self, index: int, item: Item, now: float) -> None:
        self.missions.current = index
        if item.command == TAKEOFF and not self.flight.airborne(now):
            height = item.z - self.home[2] if item.frame == 5 else item.z
            self.text(INFO, f"Climb to {height:.1f} meters above home\t", now, later_s=0.35)
            self.text(INFO, "Takeoff detected\t", now, later_s=PACE.spool_up_s)

    def _item_reached(self, index: int, item: Item, now: float) -> None:
        self._reached, self._reached_again = index, 0
        self.send_now(mavlink.MAVLink_mission_item_reached_message(index), now)

    def _plan_over(self, now: float) -> None:
        self.complete = True
        if self.flight.airborne(now):
            self.sub_mode = SUB_LOITER
        else:
            self.at("disarm", now + DISARM_AFTER_LANDING_S, self._disarm)

    # -- what it sends --------------------------------------------------------------------

    def _text_message(self, severity: int, words: str):
        number = self._text_number
        self._text_number += 1
        return mavlink.MAVLink_statustext_message(severity, words.encode(), number, 0)

    def heartbeat(self):
        base = (mavlink.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED
                | mavlink.MAV_MODE_FLAG_AUTO_ENABLED
                | mavlink.MAV_MODE_FLAG_GUIDED_ENABLED
                | mavlink.MAV_MODE_FLAG_STABILIZE_ENABLED)
        if self.main_mode != AUTO:
            base = (mavlink.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED
                    | mavlink.MAV_MODE_FLAG_STABILIZE_ENABLED
                    | mavlink.MAV_MODE_FLAG_MANUAL_INPUT_ENABLED)
        status = mavlink.MAV_STATE_STANDBY
        if self.armed:
            base |= mavlink.MAV_MODE_FLAG_SAFETY_ARMED
            status = mavlink.MAV_STATE_ACTIVE
        return mavlink.MAVLink_heartbeat_message(
            self.vehicle_types[self.vehicle], self.autopilot_type, base,
            custom_mode(self.main_mode, self.sub_mode), status, 3)

    def _tell(self, now: float) -> None:
        self.send_now(self._mission_current(), now)
        if self.missions.held[MISSION] and self._reached is not None \
                and self._reached_again < REACHED_AGAIN:
            self._reached_again += 1
            self.send_now(mavlink.MAVLink_mission_item_reached_message(self._reached), now)
        self.at("tell", now + TELLS_PERIOD_S, self._tell)

    def _mission_current(self):
        total = len(self.missions.held[MISSION])
        in_plan_mode = self.main_mode == AUTO and self.sub_mode in _PLAN_MODES
        if total == 0 or self.objection:
            state = mavlink.MISSION_STATE_NO_MISSION
        elif self.complete:
            state = mavlink.MISSION_STATE_COMPLETE
        elif in_plan_mode:
            state = mavlink.MISSION_STATE_ACTIVE
        elif self._reached is not None:
            state = mavlink.MISSION_STATE_PAUSED
        else:
            state = mavlink.MISSION_STATE_NOT_STARTED
        return mavlink.MAVLink_mission_current_message(
            self.missions.current, total or 65535, state, 1 if in_plan_mode else 2,
            self.missions.checksums[MISSION], self.missions.checksums[FENCE],
            self.missions.checksums[RALLY])

    def message_of(self, identity: int, now: float):
        lat, lon, height = self.flight.where(now)
        boot_ms = max(0, round((now - self.booted_at_s) * 1000))
        if identity == mavlink.MAVLINK_MSG_ID_HEARTBEAT:
            return self.heartbeat()
        if identity == MISSION_CURRENT:
            return self._mission_current()
        if identity == GLOBAL_POSITION_INT:
            return mavlink.MAVLink_global_position_int_message(
                boot_ms, lat, lon, round((self.home[2] + height) * 1000), round(height * 1000),
                0, 0, 0, 0)
        if identity == mavlink.MAVLINK_MSG_ID_HOME_POSITION:
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
        return None

    def _restart(self, now: float) -> None:
        self.missions.forget_transfer()
        self.missions.current = 0
        self.armed = self.complete = False
        self.main_mode, self.sub_mode = AUTO, SUB_LOITER
        self._reached = None
        self._text_number = 0
        self.flight.land_at_once()
        self.flight.forget_jumps()
        self.at("tell", now + TELLS_PERIOD_S / 2, self._tell)
