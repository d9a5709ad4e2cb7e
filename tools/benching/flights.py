"""An example on the Mega, flown to its end on a simulator, and a person, a failsafe or a fault that comes in between.

What is a contradiction: an aircraft that is armed, moved or set to another mode by the sketch behind a person or a
failsafe, or behind a reset; a console that says what is not so; a flight that does not end as the example says.
"""

from __future__ import annotations

import math
import random
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

from building import BUILD, build_sketch
from examples import example_folder
from simulation.fake_autopilot import mavlink
from simulation.fake_autopilot.frames import FrameSplitter
from simulation.fake_autopilot.px4 import custom_mode
from simulation.fake_autopilot.vehicles import VEHICLES
from simulation.wire import message_in
from trial_names import FAILSAFES, PAUSED, PLANNED, PRINTED, Flown

from .scenarios import Result, item_of, placed

HEARTBEAT_S = 1.2  # so late a state may be shown


class Crew(NamedTuple):
    """How a person flies a vehicle: the names of modes."""

    modes: dict[str, int]  # name -> HEARTBEAT.custom_mode
    takes: str = "LOITER"  # the mode of a pilot who takes over
    lands: str | None = "LAND"  # None: it drives
    disarms: bool = False  # a person does, when it stands
    returns: str = "RTL"
    shows_s: float = 0.3  # what leaves within this time of a person's order cannot have known of it


CREWS = {
    "arducopter": Crew(VEHICLES["copter"].modes),
    "ardurover": Crew(VEHICLES["rover"].modes, "HOLD", None),
    "arduplane": Crew(VEHICLES["plane"].modes, lands="FBWA", disarms=True),
    "quadplane": Crew(VEHICLES["quadplane"].modes, "QLOITER", "QLAND"),
    "ardusub": Crew(VEHICLES["sub"].modes, "MANUAL", None),
    "px4": Crew({"TAKEOFF": custom_mode(4, 2), "HOLD": custom_mode(4, 3), "MISSION": custom_mode(4, 4),
                 "RTL": custom_mode(4, 5), "LAND": custom_mode(4, 6), "POSITION": custom_mode(3),
                 "OFFBOARD": custom_mode(6)}, "POSITION", shows_s=HEARTBEAT_S),
}  # fmt: skip
# What brings a failsafe about, as parameters of a vehicle or else of ArduPilot's; the last one switches it on.
BROUGHT_ABOUT: dict[str, dict[str, dict[str, float]]] = {
    "the battery is low": {
        "": {"SIM_BATT_VOLTAGE": 9.0, "BATT_LOW_TIMER": 1, "BATT_LOW_VOLT": 10.5, "BATT_FS_LOW_ACT": 1},
        "px4": {"CBRK_SUPPLY_CHK": 0, "SIM_BAT_DRAIN": 1.0, "SIM_BAT_MIN_PCT": 1.0, "COM_LOW_BAT_ACT": 2}},
    "the ground station is lost": {
        "": {"FS_GCS_ENABLE": 1},
        **dict.fromkeys(("arduplane", "quadplane"), {"FS_GCS_ENABL": 1}),
        "px4": {"COM_DL_LOSS_T": 5, "NAV_DLL_ACT": 2}},
    "the fence is breached": {
        "": {"FENCE_TYPE": 1, "FENCE_ALT_MAX": 1.0, "FENCE_ACTION": 1, "FENCE_ENABLE": 1},
        "ardurover": {"FENCE_TYPE": 2, "FENCE_RADIUS": 5.0, "FENCE_ACTION": 1, "FENCE_ENABLE": 1},
        "px4": {"GF_MAX_VER_DIST": 1.0, "GF_ACTION": 3}},
}  # fmt: skip
LANDINGS = {"NextWaypoint": 2}
# The buttons of the examples, as (data register, bit) of the pin on a Mega, from the one that begins the flight.
BUTTONS = {"StartButton": ((0x2C, 4),), "FlyByButtons": ((0x2C, 4), (0x2C, 5), (0x32, 5), (0x2C, 3))}
PRESSED_S = {"StartButton": 2.5, "FlyByButtons": 1.4}
ORDERS = {"SET_MODE", "MISSION_COUNT", "MISSION_SET_CURRENT", "MISSION_CLEAR_ALL", "MISSION_START",
          "SET_POSITION_TARGET_GLOBAL_INT", "SET_POSITION_TARGET_LOCAL_NED"}  # fmt: skip
QUESTIONS = {mavlink.MAV_CMD_REQUEST_MESSAGE, mavlink.MAV_CMD_SET_MESSAGE_INTERVAL}
DISARMING = "COMMAND_LONG 400 "
TAKEOFF, LAND = mavlink.MAV_CMD_NAV_TAKEOFF, mavlink.MAV_CMD_NAV_LAND
STATES = ("idle", "preparing", "not ready", "flying", "at the stop", "landed", "ended")
ARMS_S, ENDS_S, PRINTS_S, PERSON_S, SILENT_S, LANDS_S = 120.0, 400.0, 90.0, 45.0, 30.0, 120.0
STILL_CM_S = 30  # on the ground
SILENCE_S = 5.0  # after so long a Flight takes the autopilot for gone
FAULT_S = 12.0  # within which a sketch has noticed what befell it
FAILS_S = 25.0  # within which a failsafe does what it is to do
MOVED_M, HIGH_M = 2.0, 4.0  # it is under way, and as high as each flight goes
STALL = "fieldStallMs"  # of the sketches that are flown


@cache
def firmware(example: str) -> Path:
    """The example as it is, but for a loop() that can be made to stand still."""
    folder = BUILD / "field" / "sketches" / example
    folder.mkdir(parents=True, exist_ok=True)
    for source in example_folder(example).iterdir():
        text = source.read_text()
        if source.suffix == ".ino":
            stands = f"if ({STALL} != 0) {{\n    delay({STALL});\n    {STALL} = 0;\n  }}"
            text = f'extern "C" {{\nvolatile uint16_t {STALL} __attribute__((used));\n}}\n' + text.replace(
                "void loop() {", f"void loop() {{\n  {stands}")  # fmt: skip
        target = folder / source.name
        if not target.exists() or target.read_text() != text:
            target.write_text(text)
    return build_sketch(folder).elf


class Flight:
    def __init__(self, world: Any, flown: Flown, result: Result, chance: random.Random) -> None:
        self.world, self.truth, self.flown, self.result, self.chance = world, world.truth, flown, result, chance
        self.crew = CREWS[world.simulator.name]
        self.pressed: set[int] = set()
        self.top = 0.0
        world.watches.append(self._watch)
        self.began = world.now

    def _watch(self) -> None:
        self.top = max(self.top, self.truth.height)
        mega = self.world.mega
        for number, (register, bit) in enumerate(BUTTONS.get(self.flown.example, ()) if mega else ()):
            level = mega.peek_int(register, 1)
            wanted = level & ~(1 << bit) if number in self.pressed else level | 1 << bit
            if wanted != level:
                mega.poke_int(register, wanted, 1)

    def wrong(self, words: str) -> None:
        self.result.wrong.append(words)

    def press(self, number: int, seconds: float) -> None:
        self.pressed.add(number)
        self.world.run(seconds)
        self.pressed.discard(number)

    def said(self, word: str, since: float = -1.0) -> list[tuple[float, str]]:
        return [(time, line) for time, line in self.world.said if line.startswith(word) and time >= since]

    @property
    def last_state(self) -> str:
        return next((line for _, line in reversed(self.world.said) if line.startswith(STATES)), "")

    def changes(self, since: float) -> list[tuple[float, int, bool]]:
        return [one for one in self.truth.modes if one[0] > since]

    def landings(self) -> int:
        modes = [(self.began, 0, False), *self.changes(self.began)]
        return sum(was and not now for (_, _, was), (_, _, now) in zip(modes, modes[1:], strict=False))

    def armed_again(self, since: float) -> bool:
        """Whether it is armed after it was not, behind this time."""
        was = [one[2] for one in self.truth.modes if one[0] <= since][-1:]
        for _, _, now in self.changes(since):
            if now and was == [False]:
                return True
            was = [now]
        return False

    def orders(self, since: float) -> list[str]:
        """What has left the board later than this that arms, moves, sets a mode or changes the plan."""
        found = []
        for entry in self.world.wire.frames(">"):
            message = entry.message
            if message is None or entry.time <= since:
                continue
            kind = message.get_type()
            if kind == "SET_POSITION_TARGET_LOCAL_NED" and (message.vx, message.vy, message.vz) == (0, 0, 0):
                continue  # a stop, which docs/steering.md promises at the end
            if kind in ORDERS or (kind.startswith("COMMAND_") and getattr(message, "command", 0) not in (0, *QUESTIONS)
                                  and kind != "COMMAND_ACK"):  # fmt: skip
                found.append(f"{kind} {getattr(message, 'command', '')} {entry.time - since:.2f} s behind it")
        return found

    # The flight

    def fly(self) -> None:
        world, truth = self.world, self.truth
        if self.flown.befalls == "3 % of bytes":
            world.wire.damage_bytes(lose=3.0)
        world.power_on(firmware(self.flown.example))
        if self.flown.example in BUTTONS:
            world.run(5.0)
            self.press(0, PRESSED_S[self.flown.example])
        if not world.until(lambda: truth.armed, ARMS_S):
            self.wrong(f"never armed; the console's last state is {self.last_state!r}")
            return
        befalls = self.flown.befalls
        if befalls in ("undisturbed", "3 % of bytes"):
            self.to_the_end()
            self.judge_end()
        elif befalls.startswith(("a pilot", "a failsafe", "a station orders", *FAILSAFES)):
            self.behind_a_person()
        elif befalls.startswith("a station"):
            self.beside_a_station()
        else:
            self.behind_a_fault()
        for time, _ in self.said("landed"):
            state = [armed for at, _, armed in truth.modes if at <= time + HEARTBEAT_S]
            if state and state[-1]:
                self.wrong(f"'landed' at {time - self.began:.1f} s, and it is armed")
        self.result.status = self.last_state

    def to_the_end(self, limit_s: float = ENDS_S) -> None:
        world, truth = self.world, self.truth
        if self.flown.example == "FlyByButtons" and world.until(lambda: bool(self.said("at the stop")), 90):
            self.press(1, 4.0)
            world.run(3.0)
            if not self.said("ended"):  # else it would begin anew
                self.press(0, PRESSED_S[self.flown.example])

        def is_over() -> bool:
            wanted = LANDINGS.get(self.flown.example, 1)
            ended = self.said("ended")
            if ended and world.now - ended[-1][0] > PERSON_S:
                return True  # it stays in the air
            return not truth.armed and (self.landings() >= wanted or bool(ended))

        world.until(is_over, limit_s)
        world.run(10.0)

    def judge_end(self) -> None:
        """Of a flight to its end."""
        if lost := self.lost_too_much():
            self.result.notes.append(lost)
            return self.bring_down()
        if self.last_state != "landed":
            self.wrong(f"nobody was there, and the console's last state is {self.last_state!r}")
        if self.truth.armed:
            self.wrong("it is armed at the end")
        if (landings := self.landings()) != LANDINGS.get(self.flown.example, 1):
            self.wrong(f"it has landed {landings} times")
        if self.top < HIGH_M and self.crew.lands:
            self.wrong(f"it has flown no higher than {self.top:.1f} m")
        if self.flown.example in PLANNED:
            judge_aboard(self.world, self.result)
        self.result.notes.append(f"as high as {self.top:.1f} m")

    def lost_too_much(self) -> str:
        """What a line that loses bytes may do to a flight, if the sketch says so; "": nothing."""
        if self.flown.befalls != "3 % of bytes":
            return ""
        if self.last_state == "ended by silence" and self.longest_silence() >= SILENCE_S:
            return "no heartbeat of the autopilot's came through for too long"
        modes = [mode for _, mode, _ in self.truth.modes]
        offboard = self.crew.modes.get("OFFBOARD")
        without = [self.crew.modes[name] for name in (self.crew.returns, self.crew.takes)]
        failed = any(one == offboard and other in without for one, other in zip(modes, modes[1:], strict=False))
        if failed and self.last_state.startswith("ended by a failsafe"):
            return "so many targets were lost that it left OFFBOARD"
        return ""

    def longest_silence(self) -> float:
        """[s] between two heartbeats of the autopilot's that the board has heard whole."""
        splitter, heard = FrameSplitter(), [self.began]
        for time, mark, data in self.world.crossed:
            for frame, is_whole in splitter.feed(data) if mark == "<" else ():
                message = message_in(frame) if is_whole else None
                if message is not None and message.get_type() == "HEARTBEAT" and message.get_srcComponent() == 1:
                    heard.append(time)
        return max(later - time for time, later in zip(heard, heard[1:], strict=False))

    def is_under_way(self) -> bool:
        return self.truth.armed and (self.truth.height if self.crew.lands else self.truth.moved) > MOVED_M

    def moment(self) -> None:
        """A random one of the flight."""
        self.world.until(self.is_under_way, 60.0)
        self.world.run(self.chance.uniform(0, 15))

    def behind_a_person(self) -> None:
        world, truth, befalls, crew, modes = self.world, self.truth, self.flown.befalls, self.crew, self.crew.modes
        mine: set[int] = set()
        if befalls == "a pilot disarms":
            world.run(self.chance.uniform(0, 2.0))
            came = world.now
            truth.arm(False)
            if truth.armed:
                self.result.notes.append("it could not be disarmed")
                return self.bring_down()
            mine |= {truth.mode}
            at = truth.modes[-1][0]
        else:
            self.moment()
            if not truth.armed:
                self.result.notes.append("it was over before the person came")
                return
            if self.said("ended"):
                self.wrong(f"nobody was there yet, and the console says {self.last_state!r}")
                return self.bring_down()
            goes_on = world.now
            if befalls == "a pilot comes while loop() stands still":
                goes_on = self.stand_still()
                world.run(self.chance.uniform(0.2, 1.8))
            came, own = world.now, truth.mode
            returns = {modes[name] for name in (crew.returns, crew.lands, "QRTL") if name in modes}
            if befalls.startswith("a pilot"):
                mine |= {modes[crew.takes]}
                truth.set_mode(modes[crew.takes])
                world.until(lambda: truth.mode in mine, 3.0)
            elif own not in returns:
                mine |= returns
                self.bring_about()
                world.until(lambda: truth.mode in mine, FAILS_S)
            if truth.mode not in mine:
                self.result.notes.append(f"{befalls}: this did not come to be")
                return self.bring_down()
            # A sketch that has stood still hears of it by the next heartbeat.
            at = max(truth.modes[-1][0], goes_on + HEARTBEAT_S if goes_on > came else 0.0)
            if befalls == "a pilot lands":
                world.run(4.0)
                self.land(mine)
            elif befalls == "a pilot gives back":
                world.run(8.0)
                mine |= {own}
                truth.set_mode(own)
        self.result.notes.append(f"the person came at {came - self.began:.1f} s")
        world.until(lambda: not truth.armed, PERSON_S)
        world.run(PERSON_S / 2)
        self.judge_kept(at, mine)
        if any(came < time <= at and mode not in mine for time, mode, _ in truth.modes):
            self.result.notes.append("the person's mode was replaced before the sketch could hear of it")
        if not self.said("ended", came - 0.2):
            self.wrong(f"the console never said 'ended' behind it; its last state is {self.last_state!r}")
        elif self.last_state == "ended by a pilot" and not befalls.startswith("a pilot"):
            self.wrong("the console says 'ended by a pilot', and none was there")
        self.bring_down()

    def failsafe(self) -> dict[str, float]:
        """The parameters that bring it about."""
        table = BROUGHT_ABOUT.get(self.flown.befalls, {})
        return table.get(self.world.simulator.name, table.get("", {}))

    def bring_about(self) -> None:
        """A return that is no pilot's."""
        if self.flown.befalls == "a failsafe":
            self.world.simulator.has_remote = False
        elif self.flown.befalls in FAILSAFES:
            for name, value in self.failsafe().items():
                self.truth.set_parameter(name, value)
            self.truth.is_silent = self.flown.befalls == "the ground station is lost"
        else:
            self.truth.set_mode(self.crew.modes[self.crew.returns])

    def land(self, mine: set[int]) -> None:
        """The truth does, or disarms what drives."""
        crew, truth = self.crew, self.truth
        if crew.lands is not None:
            mine.add(crew.modes[crew.lands])
            truth.set_mode(crew.modes[crew.lands])
        if crew.disarms:
            self.world.until(self.is_still, LANDS_S)
        if crew.disarms or crew.lands is None:
            truth.arm(False)

    def is_still(self) -> bool:
        told = self.truth.latest["GLOBAL_POSITION_INT"]
        return max(map(abs, (told.vx, told.vy, told.vz))) < STILL_CM_S

    # A second station, which leaves the mode as it is

    def beside_a_station(self) -> None:
        world, truth, befalls = self.world, self.truth, self.flown.befalls
        self.moment()
        if self.crew.lands:
            world.until(lambda: self.top > HIGH_M or not truth.armed, 30.0)
        if not truth.armed:
            self.result.notes.append("it was over before the station came")
            return
        came, is_one_plan = world.now, self.flown.example in ("StartMission", "StartButton")
        counts = [one.message.count for one in world.wire.frames(">", "MISSION_COUNT")]
        if befalls == PAUSED:
            if truth.command(mavlink.MAV_CMD_DO_PAUSE_CONTINUE, 0) != mavlink.MAV_RESULT_ACCEPTED:
                self.wrong("it could not be paused")
            world.run(self.chance.uniform(5, 20))
            if is_one_plan and (orders := self.orders(came + self.crew.shows_s)):
                self.wrong(f"it sent {len(orders)} orders while it was paused, the first {orders[0]}")
            truth.command(mavlink.MAV_CMD_DO_PAUSE_CONTINUE, 1)
        elif befalls == "a station sets the current item":
            truth.set_current(seq := self.chance.randint(truth.homes, counts[-1] - 1))
            came = world.now
            self.result.notes.append(f"the station set item {seq - truth.homes}")
        else:
            return self.behind_another_plan(counts[-1] - truth.homes)
        self.result.notes.append(f"the station came at {came - self.began:.1f} s")
        self.to_the_end()
        ends = next((time for time, _ in self.said("landed", came)), world.now)
        # A rover is disarmed at the end of its plan.
        orders = [one for one in self.orders(came + self.crew.shows_s) if not one.startswith(DISARMING)]
        if is_one_plan and orders:
            self.wrong(f"it sent {len(orders)} orders behind the station, the first {orders[0]}")
        if is_one_plan and self.armed_again(ends):
            self.wrong("it was armed again behind its landing")
        self.judge_end()

    def behind_another_plan(self, own: int) -> None:
        """Of another number of items, which is what tells it from ours on ArduPilot."""
        world, truth = self.world, self.truth
        here = truth.latest["GLOBAL_POSITION_INT"]
        plan = [item_of(0)._replace(x=here.lat + 500 * index, y=here.lon, z=12.0) for index in range(own + 2)]
        if self.crew.lands:
            plan[0], plan[-1] = plan[0]._replace(command=TAKEOFF), plan[-1]._replace(command=LAND, z=0.0)
        truth.upload_beside(plan)
        if truth.placed_beside is None:
            self.result.notes.append("the station's plan was refused")
            return self.bring_down()
        at = world.now + 3 * HEARTBEAT_S  # MISSION_CURRENT comes once a second, and the second one counts
        self.result.notes.append(f"the station's plan came at {world.now - self.began:.1f} s")
        is_over = self.last_state == "landed"
        world.until(lambda: not truth.armed, LANDS_S)
        world.run(PERSON_S / 2)
        if orders := self.orders(at):
            self.wrong(f"it sent {len(orders)} orders behind another station's plan, the first {orders[0]}")
        if self.armed_again(at):
            self.wrong("it was armed again behind another station's plan")
        if not is_over and not self.last_state.startswith("ended by another station"):
            self.wrong(f"another station's plan was flown, and the console's last state is {self.last_state!r}")
        if placed(truth.received()[truth.homes :]) != truth.placed_beside:
            self.wrong("another station's plan was replaced")
        self.bring_down()

    def judge_kept(self, at: float, mine: set[int]) -> None:
        """Nothing of the sketch's behind this time."""
        if orders := self.orders(at + self.crew.shows_s):
            self.wrong(f"it sent {len(orders)} orders behind it, the first {orders[0]}")
        names = {number: name for name, number in self.crew.modes.items()}
        # Of a mode that comes with the disarming, the autopilot is the author.
        others = [(time, names.get(mode, str(mode)))
                  for time, mode, armed in self.changes(at) if armed and mode not in mine]  # fmt: skip
        if late := [name for time, name in others if time > at + self.crew.shows_s]:
            self.wrong(f"other modes came behind it: {late}")
        elif others:
            self.result.notes.append(f"{others[0][1]} came {others[0][0] - at:.2f} s behind it, by an order on its way")
        if self.armed_again(at):
            self.wrong("it was armed again behind it")

    def behind_a_fault(self) -> None:
        world, befalls = self.world, self.flown.befalls
        self.moment()
        at = world.now
        if befalls == "the board is reset":
            world.mega.reset()
            world.until(lambda: not self.truth.armed, 150.0 if self.flown.example in PLANNED else 15.0)
            world.run(10.0)
            if orders := self.orders(at + 0.1):
                self.wrong(f"it sent {len(orders)} orders behind the reset, the first {orders[0]}")
            if self.armed_again(at):
                self.wrong("it was armed again behind the reset")
            flies_on = self.flown.example in PLANNED and self.flown.example != "WorkAtWaypoints" and self.crew.lands
            if self.truth.armed and flies_on:
                self.wrong("the plan was not flown to its end behind the reset")
            self.bring_down()
            return
        if befalls == "the cable is out":
            world.wire.pull()
            world.run(self.chance.choice((2.0, 8.0)))
            world.wire.plug()
        else:
            self.stand_still()
        world.run(FAULT_S)
        if not self.said("ended", at):
            self.to_the_end()
        if ended := self.said("ended", at):
            self.result.notes.append(ended[0][1])
            if orders := self.orders(ended[0][0] + 0.05):
                self.wrong(f"it sent {len(orders)} orders behind {ended[0][1]!r}, the first {orders[0]}")
            self.bring_down()
        else:
            self.judge_end()

    def stand_still(self) -> float:
        """loop() does, for 2 or 8 s from now on; when it goes on [s]."""
        ms = self.chance.choice((2000, 8000))
        self.world.mega.poke_int(STALL, ms)
        return self.world.now + ms / 1000

    def bring_down(self) -> None:
        """The truth lands what is still in the air."""
        if self.truth.armed:
            self.result.notes.append(f"brought down from {self.truth.height:.0f} m by the truth")
            self.world.simulator.has_remote, self.truth.is_silent = True, False
            for name in [*self.failsafe()][-1:]:
                self.truth.set_parameter(name, 0)
            self.land(set())
            self.world.until(lambda: not self.truth.armed, 90.0)
            if self.truth.armed:
                self.wrong("it could not be brought down")


def judge_aboard(world: Any, result: Result) -> None:
    """What the board has sent last of a plan, item by item, must be what the truth reads."""
    sent: dict[int, dict[int, Any]] = {}
    for entry in world.wire.frames(">", "MISSION_ITEM_INT", "MISSION_COUNT"):
        message = entry.message
        if message.get_type() == "MISSION_COUNT":
            sent[message.mission_type] = {}
        else:
            sent.setdefault(message.mission_type, {})[message.seq] = message
    for kind, items in sent.items():
        home = world.truth.homes if kind == 0 else 0
        meant = placed([items[seq] for seq in sorted(items)][home:])
        held = placed(world.truth.received(kind)[home:])
        same = len(held) == len(meant) and all(
            one[0] == other[0]
            and all(math.isclose(a, b, abs_tol=0.01) for a, b in zip(one[1:], other[1:], strict=True))
            for one, other in zip(held, meant, strict=True)
        )
        if not same:
            result.wrong.append(f"the plan aboard is not what was sent: {len(held)} items, and {len(meant)} were sent")
    if not sent:
        result.notes.append("nothing was sent item by item")


def play_printed(world: Any, example: str, result: Result) -> None:
    """An example that does not arm, until it has printed that its work is done."""
    words = PRINTED[example]
    world.power_on(firmware(example))
    began = world.now
    if not words:
        world.run(SILENT_S)
    elif not world.until(lambda: any(words in line for line in world.lines), PRINTS_S):
        result.wrong.append(f"{words!r} was not printed within {PRINTS_S:.0f} s: {world.lines[-3:]}")
    world.run(1.0)
    result.seconds = world.now - began
    result.status = world.lines[-1] if world.lines else ""
    if "aboard" in words or not words:
        judge_aboard(world, result)
    if world.truth.armed:
        result.wrong.append("it is armed")
