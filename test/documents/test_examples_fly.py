"""Each example that arms: it flies its story to the end, and arms and moves nothing behind a person."""

from __future__ import annotations

import pytest

from benching.flights import STALL, firmware
from building import build_sketch
from example_runs import Run
from simulation.fake_autopilot import mavlink
from simulation.mega import Image

PRESS = {"StartButton": 2.2, "FlyByButtons": 1.2}  # how long its button is held [s]
BUTTON, FORWARD, LEFT = (0x2C, 1 << 4), (0x2C, 1 << 5), (0x32, 1 << 5)  # pins 2 to 4 of a Mega: ports and bits
PILOTS = {"copter": (5,), "rover": (4,), "px4": (3, 0)}  # the modes in which a pilot flies: LOITER, HOLD, POSITION
OWN = {"copter": (3,), "rover": (10,), "px4": (4, 4)}  # the mode in which the plan is flown
STEERED = ("GoToPlaces", "FollowBeacon", "FlyByButtons")
# What arms, moves, sets a mode or changes the plan.
ORDERS = {"COMMAND_LONG", "COMMAND_INT", "SET_MODE", "MISSION_COUNT", "MISSION_SET_CURRENT", "MISSION_CLEAR_ALL",
          "SET_POSITION_TARGET_GLOBAL_INT", "SET_POSITION_TARGET_LOCAL_NED"}  # fmt: skip
QUESTIONS = {mavlink.MAV_CMD_REQUEST_MESSAGE, mavlink.MAV_CMD_SET_MESSAGE_INTERVAL}


class Story(Run):
    """An example beside a copter or a rover of ArduPilot, or PX4's copter."""

    def __init__(self, example: str, vehicle: str = "copter", **options) -> None:
        self.vehicle = vehicle
        if vehicle != "px4":
            options = {"vehicle": vehicle, "uptime_s": 0.0, "ready_s": 2.0, "position_s": 0.0, **options}
        super().__init__(example, "PX4" if vehicle == "px4" else "ArduPilot", **options)
        self.run(0.3)
        if example in PRESS:
            self.press(PRESS[example])

    def press(self, seconds: float, button: tuple[int, int] = BUTTON) -> None:
        place, bit = button
        self.mega.poke_int(place, self.mega.peek_int(place) & ~bit)
        self.run(seconds)
        self.mega.poke_int(place, self.mega.peek_int(place) | bit)
        self.run(0.1)

    def reach(self, stage: str, limit_s: float = 100.0) -> None:
        """Until it has printed a line that begins so; "armed": until it is armed."""
        limit = self.now + limit_s
        while not (self.autopilot.armed if stage == "armed" else any(line.startswith(stage) for line in self.lines)):
            assert self.now < limit, self.lines
            self.run(0.02 if stage == "armed" else 0.1)

    def set_mode(self, *mode: int) -> None:
        self.autopilot._set_mode(*mode, self.now)

    def disarm(self) -> None:
        """By hand, on the ground."""
        self.autopilot.flight.land_at_once()
        self.autopilot._disarm(self.now)

    @property
    def orders(self) -> list:
        return [one for one in self.autopilot.messages(">", *ORDERS) if getattr(one, "command", 0) not in QUESTIONS]


def pilot(story: Story) -> None:
    """Takes over, lands, disarms, and gives back."""
    story.set_mode(*PILOTS[story.vehicle])
    story.run(2.5)
    if story.autopilot.armed:
        story.disarm()
    story.run(1.5)
    story.set_mode(*OWN[story.vehicle])


def person(story: Story) -> None:
    """Disarms it, or arms it, by hand."""
    if story.autopilot.armed:
        story.disarm()
        return
    story.autopilot.armed = True
    story.run(1.2)
    story.autopilot.armed = False


def cut(story: Story) -> None:
    """The cable is out for 7 s; meanwhile it lands."""
    story.is_plugged = False
    story.run(3.0)
    if story.autopilot.armed:
        story.disarm()
    story.run(4.0)
    story.is_plugged = True


def reset(story: Story) -> None:
    """Of the Arduino, in flight. Then the aircraft lands."""
    story.mega.reset()
    story._said += b"reset\n"
    story.run(0.3)
    story.press(0.0)  # a hand that is off the button: the simulated pin is low behind a reset
    story.run(2.7)
    story.disarm()


# A mode that is set while the plan is uploaded is the one from which it starts; of an arming, the line alone knows.
NOT_NOW = (("preparing", pilot), ("armed", cut))
BY_PILOT, BY_SILENCE, ARMED = (
    "ended by a pilot",
    "ended by silence",
    "ended by a refusal: the autopilot is armed",
)
# (the example, the stage, what a person does, what the console says then)
BEHIND = [
    *(("StartMission", stage, act, said)
      for stage in ("preparing", "not ready", "armed", "flying")
      for act, said in ((pilot, BY_PILOT), (person, BY_PILOT), (cut, BY_SILENCE))
      if (stage, act) not in NOT_NOW),
    ("StartMission", "flying", reset, ARMED),
    ("StartButton", "flying", pilot, BY_PILOT),
    ("StartButton", "flying", reset, None),
    *(("NextWaypoint", stage, act, said)
      for stage in ("flying", "landed")
      for act, said in ((pilot, BY_PILOT), (person, BY_PILOT), (cut, BY_SILENCE))),
    ("NextWaypoint", "flying", reset, ARMED),
    ("WorkAtWaypoints", "at the stop", pilot, BY_PILOT),
    ("WorkAtWaypoints", "at the stop", cut, BY_SILENCE),
    ("WorkAtWaypoints", "at the stop", reset, ARMED),
    *(("GoToPlaces", stage, act, said)
      for stage in ("preparing", "not ready", "armed")
      for act, said in ((pilot, BY_PILOT), (person, BY_PILOT), (cut, BY_SILENCE))
      if (stage, act) not in NOT_NOW),
    *((example, "at the stop", act, said)
      for example in STEERED
      for act, said in ((pilot, BY_PILOT), (person, BY_PILOT), (cut, BY_SILENCE))),
    ("GoToPlaces", "at the stop", reset, ARMED),
]  # fmt: skip


def cases() -> list:
    """Each row beside one vehicle, in turn: what the library does beside each of them is said by test/flights."""
    rows = []
    for number, (example, stage, act, said) in enumerate(BEHIND):
        # A PX4 and a rover say nothing while they are not ready; of a rover nothing is steered.
        told = ["copter"] if stage == "not ready" else ["copter", "px4", *["rover"] * (example not in STEERED)]
        vehicle = told[number % len(told)]
        name = f"{example}-{stage.replace(' ', '_')}-{act.__name__}-{vehicle}"
        rows.append(pytest.param(example, stage, act, said, vehicle, id=name,
                                 marks=() if vehicle == "copter" else pytest.mark.slow))  # fmt: skip
    return rows


@pytest.mark.parametrize(("example", "stage", "act", "said", "vehicle"), cases())
def test_nothing_is_armed_or_moved_behind_a_person(example, stage, act, said, vehicle):
    story = Story(example, vehicle, **({"ready_s": 40.0} if stage == "not ready" else {}))
    story.reach(stage)
    if stage in ("flying", "at the stop"):
        story.run(1.5)
    act(story)
    story.run(1.3)  # an order may be on its way until a heartbeat shows what has been done
    before = len(story.orders)
    story.run(12.0)
    assert story.orders[before:] == [] and not story.autopilot.armed, story.lines
    assert said is None or any(line.startswith(said) for line in story.lines[-3:]), story.lines
    if said is not None and example not in PRESS:
        return
    # A person asks for it again, by the button.
    story.press(PRESS[example])
    story.run(6.0)
    assert story.autopilot.armed, story.lines


LEG = ["preparing", "flying", "landed"]
TALES = {
    "StartMission": LEG,
    "StartButton": LEG,
    "NextWaypoint": LEG + LEG,
    "WorkAtWaypoints": ["preparing", "flying", "at the stop of item 1", "flying", "at the stop of item 2", "sensor: 0",
                        "flying", "landed"],
    "GoToPlaces": ["preparing", "flying", "at the stop", "to 1", "flying", "at the stop", "to 2", "flying",
                   "at the stop", "to 3", "flying", "at the stop", "flying", "landed"],
    "FollowBeacon": ["preparing", "flying", "at the stop", "done: the autopilot confirmed it", "flying", "landed"],
}  # fmt: skip
AWAY_M = {"NextWaypoint": 23.0}  # where it lands [m from home]; else at home


# What is not here test/tools/test_demo.py flies to its end; a StartButton is a StartMission with a button.
# Beside a PX4 a NextWaypoint flies as a StartMission, GoToPlaces as a FollowBeacon.
FLOWN = [("StartMission", "copter px4 rover"), ("StartButton", "copter"), ("NextWaypoint", "copter"),
         ("WorkAtWaypoints", "px4 rover"), ("GoToPlaces", "copter rover"), ("FollowBeacon", "px4 rover")]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("example", "vehicle"), [(example, vehicle) for example, beside in FLOWN for vehicle in beside.split()]
)
def test_an_example_flies_its_story_to_the_end(example, vehicle):
    story = Story(example, vehicle)
    flight, worked_at = story.autopilot.flight, {}
    if vehicle == "rover" and example in STEERED:
        story.run(8.0)
        assert story.lines == ["preparing", "ended by a refusal: autopilot: command not supported"]
        assert not story.autopilot.armed
        return
    while story.lines.count("landed") < TALES[example].count("landed"):
        assert story.now < 240, story.lines
        story.run(0.5)
        if story.lines and story.lines[-1].startswith("at the stop of"):
            worked_at.setdefault(len(story.lines), []).append(flight.where(story.now))
    own = [line for line in story.lines if not line.startswith("not ready")]
    assert own == TALES[example]
    assert not story.autopilot.armed
    assert round(flight.where(story.now).distance(flight.home)) == AWAY_M.get(example, 0)
    # It works for 3 s, and stands there meanwhile.
    at_work = [places[:6] for places in worked_at.values()]
    assert bool(at_work) == (example == "WorkAtWaypoints")
    assert all(place.distance(places[0]) < 1.0 for places in at_work for place in places)


def test_a_flight_waits_for_a_late_gps_with_the_autopilots_own_words():
    for example in ("StartMission", "GoToPlaces"):
        story = Story(example, ready_s=65.0)
        story.reach("flying")
        assert 65.0 < story.now < 75.0
        waited = [line for line in story.lines if line.startswith("not ready")]
        assert waited[-2:] == ["not ready: autopilot: failed; its text says why",
                               "not ready: Arm: AHRS: waiting for home"]  # fmt: skip
        assert len(story.lines) <= 5, story.lines


@pytest.mark.slow
def test_an_arduino_that_fails_at_a_stop_leaves_the_plan_to_the_autopilot():
    story = Story("WorkAtWaypoints")
    story.reach("at the stop")
    story.is_plugged = False
    story.run(100.0)
    flight = story.autopilot.flight
    assert not story.autopilot.armed and flight.where(story.now).distance(flight.home) < 0.5


@pytest.mark.slow
def test_fly_by_buttons_flies_as_long_as_a_button_is_held_and_lands_also_behind_a_cut_cable():
    story = Story("FlyByButtons")  # (a PX4 without targets is flown home by its failsafe)
    story.reach("at the stop")
    story.run(2.0)
    flight = story.autopilot.flight
    ground = flight.where(story.now)
    for button, seconds in ((FORWARD, 5.0), (LEFT, 3.0)):
        story.press(seconds, button)
        story.run(3.0)
    there = flight.where(story.now)
    assert 7.0 < there.distance(ground) < 14.0
    heading = flight.heading(story.now)
    assert 300 < heading or heading > 40
    story.is_plugged = False
    story.run(7.0)
    story.is_plugged = True
    story.run(4.0)
    before = flight.where(story.now)
    story.press(5.0, FORWARD)
    story.run(2.0)
    assert flight.where(story.now).distance(before) > 7.0
    story.press(1.2)
    story.reach("ended by silence", 60.0)
    assert not story.autopilot.armed


@pytest.mark.slow
@pytest.mark.parametrize("befalls", ["a long cut", "a reset", "a pilot"])
def test_a_button_lands_what_is_in_the_air_behind_a_long_cut_or_a_reset_but_nothing_of_a_pilots(befalls):
    story = Story("FlyByButtons")
    story.reach("at the stop")
    if befalls == "a pilot":
        story.set_mode(*PILOTS["copter"])
    elif befalls == "a reset":
        story.mega.reset()
        story.run(0.3)
        story.press(0.0)
    else:
        story.is_plugged = False
        story.run(25.0)
        story.is_plugged = True
    story.run(4.0)
    said = len(story.lines)
    story.press(1.2)
    story.run(20.0)
    is_pilots = befalls == "a pilot"
    refused = ["preparing", "ended by a refusal: the autopilot is armed"]
    assert story.lines[said:] == (refused if is_pilots else ["flying", "landed"]), story.lines
    assert story.autopilot.armed == is_pilots
    assert befalls != "a long cut" or story.lines[said - 1] == "ended by silence"


ASKED_LONG_AGO = """
#include <MavMission.h>
#include <MavMissionMonitor.h>
using namespace mavmission;
MissionClient autopilot(TELEM);
SteeredFlight flight(autopilot);
void setup() {
  CONSOLE.begin(115200);
  beginTelem(57600);
  flight.begin();
}
void loop() {
  flight.update();
  static bool isDone;
  if (isDone || millis() < 6000) return;
  isDone = true;
  CONSOLE.println(toString(flight.land()));
}
"""


@pytest.mark.slow
def test_what_a_person_has_asked_for_long_ago_takes_no_aircraft_that_somebody_flies(tmp_path):
    folder = tmp_path / "AskedLongAgo"
    folder.mkdir()
    (folder / "AskedLongAgo.ino").write_text(ASKED_LONG_AGO)
    story = Story("StartMission", image=Image.load(build_sketch(folder).elf))
    story.set_mode(4)  # GUIDED, by another station
    story.run(1.5)
    story.autopilot.armed = True
    story.run(9.0)
    assert story.lines == ["the aircraft is not in the air"]
    assert story.orders == [] and story.autopilot.armed


@pytest.mark.slow
@pytest.mark.parametrize("stands_ms", [2000, 4000])
def test_a_loop_that_stood_still_in_the_air_ends_no_flight_and_the_button_lands_it(stands_ms):
    story = Story("FlyByButtons", image=Image.load(firmware("FlyByButtons")))
    story.reach("at the stop")
    story.run(2.0)
    story.mega.poke_int(STALL, stands_ms)
    story.run(stands_ms / 1000 + 4.0)
    assert story.lines[-1] == "at the stop", story.lines
    story.press(1.2)
    story.reach("landed", 60.0)
    assert not story.autopilot.armed


@pytest.mark.slow
def test_a_rover_that_has_arrived_is_disarmed_also_where_its_last_item_is_set_once_more():
    story = Story("WorkAtWaypoints", "rover")
    story.reach("flying")
    while not story.autopilot.complete:
        assert story.now < 200, story.lines
        story.run(0.002)
    story.autopilot._set_current(story.autopilot.current, story.now)
    story.reach("landed", 20.0)
    assert not story.autopilot.armed and not story.autopilot.complete


def test_a_button_that_is_stuck_or_pressed_again_starts_nothing():
    story = Story("StartButton")
    place, bit = BUTTON
    story.mega.poke_int(place, story.mega.peek_int(place) & ~bit)
    story.reach("landed")
    story.run(8.0)  # it is still held
    assert story.lines.count("preparing") == 1 and not story.autopilot.armed
    story.mega.poke_int(place, story.mega.peek_int(place) | bit)
    story.run(0.2)
    story.press(1.5)  # too short
    assert story.lines.count("preparing") == 1
    story.press(2.2)  # a second flight
    story.run(3.0)
    assert story.lines.count("flying") == 2 and story.autopilot.armed
