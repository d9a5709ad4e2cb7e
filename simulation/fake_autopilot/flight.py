"""A flight along a plan's items: simple, but in the right order and at a likely pace.

Every leg is flown from standstill to standstill at a constant acceleration, up to a speed.
Nothing is steered: what matters to a client is which item is flown when.
"""
import math
from collections.abc import Callable, Sequence
from typing import NamedTuple

from .dialect import mavlink
from .items import Item

METRES_PER_E7 = 0.011131884502145034  # a 1e-7 degree of latitude [m]
PLACE_IGNORED = 7  # in the type mask of a target: a coordinate that does not count
HIGHEST = 1e6  # [m]; no plan means more, and GLOBAL_POSITION_INT could not tell of it
ELSEWHERE = 2.0  # [m] away, at least
MOST_JUMPS_AT_ONCE = 1000  # a plan of nothing but jumps must not hang the test

WAYPOINT = mavlink.MAV_CMD_NAV_WAYPOINT
SPLINE_WAYPOINT = mavlink.MAV_CMD_NAV_SPLINE_WAYPOINT
LOITER_UNLIM = mavlink.MAV_CMD_NAV_LOITER_UNLIM
LOITER_TURNS = mavlink.MAV_CMD_NAV_LOITER_TURNS
LOITER_TIME = mavlink.MAV_CMD_NAV_LOITER_TIME
LOITER_TO_ALT = mavlink.MAV_CMD_NAV_LOITER_TO_ALT
RETURN = mavlink.MAV_CMD_NAV_RETURN_TO_LAUNCH
LAND = mavlink.MAV_CMD_NAV_LAND
TAKEOFF = mavlink.MAV_CMD_NAV_TAKEOFF
VTOL_TAKEOFF = mavlink.MAV_CMD_NAV_VTOL_TAKEOFF
VTOL_LAND = mavlink.MAV_CMD_NAV_VTOL_LAND
PAYLOAD_PLACE = mavlink.MAV_CMD_NAV_PAYLOAD_PLACE
DELAY = mavlink.MAV_CMD_NAV_DELAY
CONDITION_DELAY = mavlink.MAV_CMD_CONDITION_DELAY
JUMP = mavlink.MAV_CMD_DO_JUMP

_TO_A_PLACE = {WAYPOINT, SPLINE_WAYPOINT, LOITER_UNLIM, LOITER_TURNS, LOITER_TIME,
               LOITER_TO_ALT, LAND, VTOL_LAND, PAYLOAD_PLACE}
LANDINGS = (LAND, VTOL_LAND)
_ABSOLUTE_FRAMES = {mavlink.MAV_FRAME_GLOBAL, mavlink.MAV_FRAME_GLOBAL_INT,
                    mavlink.MAV_FRAME_MISSION}


class Place(NamedTuple):
    """Where a vehicle is."""

    lat_e7: int  # [1e-7 degrees]
    lon_e7: int  # [1e-7 degrees]
    height: float  # [m above home]

    def distance(self, other: "Place") -> float:
        """[m], near enough for a leg."""
        north = (other.lat_e7 - self.lat_e7) * METRES_PER_E7
        east = ((other.lon_e7 - self.lon_e7) * METRES_PER_E7
                * math.cos(math.radians(self.lat_e7 * 1e-7)))
        return math.sqrt(north ** 2 + east ** 2 + (other.height - self.height) ** 2)

    def towards(self, other: "Place", share: float) -> "Place":
        """The place that share [0..1] of the way to other."""
        return Place._make(type(a)(a + (b - a) * share) for a, b in zip(self, other, strict=True))


class Pace(NamedTuple):
    """How a vehicle moves."""

    acceleration: float  # [m/s2]
    speed: float  # [m/s]
    climb: float  # of a takeoff [m/s]
    descent: float  # of a landing [m/s]
    spool_up_s: float  # from the start of a takeoff to leaving the ground
    flies: bool = True  # or keeps to the ground, whatever altitude an item has
    # Whether a landing that is elsewhere counts as reached when it begins to sink there; else on the ground.
    reaches_land_above: bool = False
    takes_off_at_place: bool = False  # in the air, a takeoff is a waypoint; else it only climbs

    def leg_s(self, distance: float) -> float:
        """How long a leg of so many metres takes."""
        if distance < self.speed ** 2 / self.acceleration:
            return 2 * math.sqrt(distance / self.acceleration)
        return distance / self.speed + self.speed / self.acceleration


class Flight:
    """Flies a plan. Tells of each item that begins and ends through its callbacks.

    landed(now) is called on the ground, at the end of a landing; it answers whether the plan goes on.
    jumped(index, item, times, now), if there is one, is called when a jump is taken for the times-th time.
    """

    def __init__(self, pace: Pace, home: Place, home_altitude: float,
                 items: Callable[[], Sequence[Item]],
                 begun: Callable[[int, Item, float], None],
                 reached: Callable[[int, Item, float], None],
                 over: Callable[[float], None],
                 landed: Callable[[float], bool],
                 jumped: Callable[[int, Item, int, float], None] | None = None) -> None:
        self.pace = pace
        self.home = home
        self.home_altitude = home_altitude  # [m above sea level]
        self.index: int | None = None  # of the item being flown; None when not flying one
        self.ends_at = math.inf  # when that item ends [s]
        self.waiting = False  # at the beginning of that item, for begin()
        self.sinking = False  # at the end of a landing
        self.target: Place | None = None  # of fly_to(); None when not flying to a place of no plan
        self._moves_to_land = False
        self._lands_at_target = self._into_ground = False
        self._is_steady = False  # flies at its speed from the first moment on
        self._heading, self._turn, self._turns_from, self._turns_until = 0.0, 0.0, 0.0, 0.0
        self._items = items
        self._begun, self._reached, self._over, self._landed = begun, reached, over, landed
        self._jumped = jumped
        self._from, self._to = home, home
        self._began_at = 0.0
        self._stands_s = 0.0  # at the end of the leg
        self._jumps_done: dict[int, int] = {}

    def where(self, now: float) -> Place:
        """Where the vehicle is now."""
        if now >= self.ends_at or self._from == self._to:
            return self._to
        length = self.ends_at - self._stands_s - self._began_at
        if now >= self._began_at + length > self._began_at:
            return self._to
        if not 0 < length < math.inf:
            return self._to
        if now < self._began_at:
            return self._from
        share = (now - self._began_at) / length
        return self._from.towards(self._to, share if self._is_steady else share * share * (3 - 2 * share))

    def velocity(self, now: float) -> tuple[int, int, int]:
        """To the north, to the east, down [cm/s], as in GLOBAL_POSITION_INT."""
        one, other, s = self.where(now - 0.05), self.where(now), 0.05
        north, east = (other.lat_e7 - one.lat_e7) * METRES_PER_E7, (other.lon_e7 - one.lon_e7) * METRES_PER_E7
        east *= math.cos(math.radians(other.lat_e7 * 1e-7))
        north, east, down = (max(-32768, min(32767, round(100 * metres / s)))
                             for metres in (north, east, one.height - other.height))  # fmt: skip
        return int(north), int(east), down

    def airborne(self, now: float) -> bool:
        return self.where(now).height > 0.1

    def landed_state(self, now: float, takes_off: bool = False) -> int:
        """As in EXTENDED_SYS_STATE."""
        if not self.airborne(now):
            return mavlink.MAV_LANDED_STATE_ON_GROUND
        if takes_off:
            return mavlink.MAV_LANDED_STATE_TAKEOFF
        return mavlink.MAV_LANDED_STATE_LANDING if self.sinking else mavlink.MAV_LANDED_STATE_IN_AIR

    def fly_to(self, target: Place, now: float, *, spool_up_s: float = 0.0, lands: bool = False) -> None:
        """Leave the plan and fly to a place; with lands, come down there. Into the ground, it lands on the way."""
        self.stop(now)
        target = target if self.pace.flies else target._replace(height=self._from.height)
        self.target, self._lands_at_target = target, lands
        if target.height < 0:
            self._into_ground, target = True, target._replace(height=0.0)
        climbs = target[:2] == self._from[:2] and target.height > self._from.height
        takes_s = (target.height - self._from.height) / self.pace.climb if climbs \
            else max(self.pace.leg_s(self._from.distance(target)),
                     (self._from.height - target.height) / self.pace.descent)
        self._to, self._began_at = target, now + spool_up_s
        self.ends_at = self._began_at + max(takes_s, 0.02)

    def chase(self, target: Place, now: float) -> None:
        """Fly to a target that moves: at full speed, without slowing down for each place that is named."""
        target = target if self.pace.flies else target._replace(height=self.where(now).height)
        if target == self.target:
            return
        self.stop(now)
        rise = target.height - self._from.height
        takes_s = max(self._from.distance(target) / self.pace.speed,
                      rise / self.pace.climb if rise > 0 else -rise / self.pace.descent)
        self.target, self._to, self._began_at, self._is_steady = target, target, now, True
        self.ends_at = now + max(takes_s, 0.02)

    def drive(self, velocity: tuple[float, float, float], now: float, lasts_s: float) -> None:
        """Fly to the north, to the east and up [m/s] for so long, and stay there; no lower than the ground."""
        self.stop(now)
        here, (north, east, up) = self._from, velocity
        east_e7 = east / METRES_PER_E7 / math.cos(math.radians(here.lat_e7 * 1e-7))
        height = here.height + (up * lasts_s if self.pace.flies else 0.0)
        self._to = Place(here.lat_e7 + round(north * lasts_s / METRES_PER_E7), here.lon_e7 + round(east_e7 * lasts_s),
                         max(height, 0.0))
        self._began_at, self.ends_at, self._is_steady = now, now + lasts_s, True

    def heading(self, now: float) -> float:
        """[degrees from north]"""
        return (self._heading + self._turn * (max(min(now, self._turns_until) - self._turns_from, 0.0))) % 360.0

    def face(self, heading: float) -> None:
        self._heading, self._turn = heading % 360.0, 0.0

    def turn(self, degrees_per_s: float, now: float, lasts_s: float) -> None:
        """Clockwise for so long."""
        self.face(self.heading(now))
        self._turn, self._turns_from, self._turns_until = degrees_per_s, now, now + lasts_s

    def begin(self, index: int, now: float) -> None:
        """Fly item `index`, and from there on."""
        self._from = self.where(now)
        self.target = None
        self._is_steady = False
        self.waiting = self.sinking = False
        for _ in range(MOST_JUMPS_AT_ONCE):
            items = self._items()
            if not 0 <= index < len(items):
                break
            item = items[index]
            self.index = index
            if item.command == JUMP:
                index = self._after_jump(index, item, now)
                continue
            self._begun(index, item, now)
            if self.index is None:
                return
            target, takes_s = self._leg(item)
            if takes_s > 0:
                self._to, self._began_at, self.ends_at = target, now, now + takes_s
                return
            self._reached(index, item, now)
            if self.index is None:
                return
            index += 1
        self.stop(now)
        self._over(now)

    def advance(self, now: float) -> None:
        """The item being flown has ended: go on to the next."""
        index = self.index
        items = self._items()
        item = items[index] if index is not None and index < len(items) else None
        self._from = self._to
        self.ends_at = math.inf
        sank = self.sinking or self._into_ground
        self.sinking = self._into_ground = False
        if sank and not self._landed(now):
            return
        if index is None and self._lands_at_target and not sank:
            self.sink(now)
        if index is None:
            return
        lands = item is not None and item.command in LANDINGS and self.pace.flies
        reached_above = self.pace.reaches_land_above and self._moves_to_land
        if item is not None and (not lands or sank != reached_above):
            self._reached(index, item, now)
        if lands and not sank:
            self.sink(now)
            return
        if self.index is not None:
            self.begin(index + 1, now)

    def wait(self) -> None:
        """Keep to the item, and stay where it begins until begin() is called again."""
        self._to, self.ends_at = self._from, math.inf
        self.waiting = True

    def sink(self, now: float) -> None:
        """Come down where we are."""
        self._from = self.where(now)
        self._is_steady = False
        self._to = self._from._replace(height=0.0)
        self._stands_s = 0.0
        self._began_at, self.ends_at = now, now + max(self._from.height, 0.0) / self.pace.descent
        self.sinking = True

    def stop(self, now: float) -> None:
        """Fly no item any more: stay where we are."""
        self._to = self._from = self.where(now)
        self.index, self.ends_at, self._stands_s = None, math.inf, 0.0
        self.waiting = self.sinking = self._lands_at_target = self._into_ground = self._is_steady = False
        self.target = None

    def land_at_once(self) -> None:
        """As after a restart: on the ground, at rest, where it is."""
        self._from = self._to = self._to._replace(height=0.0)
        self.index, self.ends_at, self._stands_s = None, math.inf, 0.0
        self.waiting = self.sinking = self._lands_at_target = self._into_ground = self._is_steady = False
        self.target = None

    def forget_jumps(self) -> None:
        self._jumps_done.clear()

    def _after_jump(self, index: int, item: Item, now: float) -> int:
        done = self._jumps_done.get(index, 0)
        if 0 <= int(item.param2) <= done:
            return index + 1
        self._jumps_done[index] = done + 1
        if self._jumped is not None:
            self._jumped(index, item, done + 1, now)
        return int(item.param1)

    def _height(self, item: Item) -> float:
        """The item's altitude [m above home]; where it is, for one that is no altitude."""
        if not self.pace.flies or not math.isfinite(item.z):
            return self._from.height
        height = item.z - self.home_altitude if item.frame in _ABSOLUTE_FRAMES else item.z
        return max(-HIGHEST, min(HIGHEST, height))

    def _leg(self, item: Item) -> tuple[Place, float]:
        """Where the item leads, and how long it takes [s]; 0 for what is done on the spot."""
        here = self._from
        self._stands_s = 0.0
        is_waypoint = self.pace.takes_off_at_place and here.height > 0.1
        if item.command in (TAKEOFF, VTOL_TAKEOFF) and not is_waypoint:
            target = here._replace(height=self._height(item))
            climb_s = max(0.0, target.height - here.height) / self.pace.climb
            on_ground_s = self.pace.spool_up_s if here.height <= 0.1 else 0.0
            return target, on_ground_s + climb_s
        if item.command == RETURN:
            target = self.home._replace(height=0.0)
            over_home = self.home._replace(height=here.height)
            return target, (self.pace.leg_s(here.distance(over_home))
                            + here.height / self.pace.descent)
        if item.command in (DELAY, CONDITION_DELAY):
            return here, max(0.0, item.param1)
        if item.command not in (*_TO_A_PLACE, TAKEOFF, VTOL_TAKEOFF):
            return here, 0.0
        lat, lon = (item.x, item.y) if item.x or item.y else (here.lat_e7, here.lon_e7)
        target = Place(int(lat), int(lon), self._height(item))
        takes_s = max(self.pace.leg_s(here.distance(target)), 0.02)
        if item.command in LANDINGS:
            target = target._replace(height=here.height)
            self._moves_to_land = here.distance(target) > ELSEWHERE
            takes_s = max(self.pace.leg_s(here.distance(target)), 0.02)
        elif item.command == LOITER_UNLIM:
            takes_s = math.inf
        elif item.command in (WAYPOINT, SPLINE_WAYPOINT, LOITER_TIME):
            self._stands_s = 0.0 if math.isnan(item.param1) else max(0.0, item.param1)
            takes_s += self._stands_s
        elif item.command == LOITER_TURNS:
            takes_s += 20.0 * max(0.0, item.param1)
        return target, takes_s
