"""The fake autopilots start, jump, refuse and end a mission as the real ones in simulation/recordings did.

And they are flown without a mission, by commands, as those were.

As in test_recordings.py the client's side of each recording is played to a fake. Here a vehicle
moves, and so the pace of flying is the recording's: the fake arrives at an item, and on the
ground, when the real one did.

- Answers (MISSION_*, COMMAND_ACK and the like) are compared with answers, texts with texts, each
  in order: which of the two kinds goes first on a busy line is chance.
- MISSION_CURRENT that answers a request is compared with what the real one answered. What it tells
  from time to time is compared with what the fake would tell then.
- HEARTBEAT is compared with what the fake would tell then, but for ArduCopter's system_status:
  when that says that it flies depends on how it flies.
- Whether it is landed, and where it flies to, is compared where there is no plan.
- Texts and items reached are compared with their times too.

Not compared, because the fakes do not imitate it: texts about sensors, of the simulator and of the
log file; telemetry and parameters; how often MISSION_CURRENT is told (but for request_messages):
ArduPilot holds its streams back during an upload, and PX4 tells of an item once more, now and
then, when it was reached.

px4/guided_flight_2 is compared up to the failsafe that it calls in OFFBOARD with one target a second: the real one then
announced its return, and flew on to the targets, which the fake does without announcing it.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import pairwise
from typing import NamedTuple

import pytest

from plans import waypoint
from recorded import (
    OPTIONS,
    fields,
    is_clocked,
    is_repetition,
    plans_uploaded,
    play,
    said_by,
    said_in_recording,
    transcript,
)
from simulation import recordings
from simulation.fake_autopilot import ArduPilot, Px4, mavlink

NAMES, GUIDED = recordings.starts(), recordings.guided()
EACH = pytest.mark.parametrize("name", [*NAMES, *GUIDED])
WITHOUT_A_PLAN = pytest.mark.parametrize("name", GUIDED)
ON_ARDUPILOT = pytest.mark.parametrize("name", [name for name in NAMES if not name.startswith("px4")])

ALIKE_WITHIN_S = 0.4  # what is told from time to time, by both
LASTING_S = 1.2  # told each second, this is told once at the least
TOLD_WITHIN_S = 0.2  # now and then a recorded answer is late by so much
LANDED_WITHIN_S = 2.3  # PX4 tells every 2.24 s whether it is landed, and how it leaves the ground is its own affair
SPOOLED_UP_WITHIN_S = 0.7  # it takes PX4 1.3 to 1.9 s
ANSWERED_WITHIN_S = 0.060
MISSION_CURRENT = 42
UNTIL_S = {"px4/guided_flight_2": 43.05}


def recorded(name: str, direction: str, *kinds: str) -> list:
    return [one for one in recordings.heard(name) if one.direction == direction and one.message.get_type() in kinds
            and one.time < until(name)]


def until(name: str) -> float:
    return UNTIL_S.get(name, math.inf)


# -- the state in which the recorded autopilot was ------------------------------------------------


class Before(NamedTuple):
    """What differs from recording to recording."""

    options: dict = {}
    reached: int | None = None  # the last item, before
    plan: str = "B"  # the plan aboard a PX4
    current: int = 0
    complete: bool = False


BEFORE = {
    "arducopter/request_messages": Before(reached=1),
    "ardurover/request_messages": Before({"streams": {MISSION_CURRENT: 1.0}}, reached=1),
    # The position is good when it says "EKF3 IMU0 is using GPS".
    "ardurover/mission_start_first_2_last_4": Before({"ready_s": 90.0, "position_s": 13.66}),
    "ardurover/auto_and_arming": Before({"ready_s": 103.0, "position_s": 6.07}),
    "px4/mission_end": Before(complete=True),
    "px4/mission_start_first_2_last_4": Before(current=3, complete=True),
    "px4/request_messages": Before(current=3, complete=True),
    "px4/set_current_while_running": Before(plan="A", complete=True),
    "px4/start_clear_then_upload": Before(current=1),
    "px4/start_set_current_0_after_arming": Before(current=1),
    "px4/start_stale_arm_in_hold_then_mission_mode": Before(current=3, complete=True),
    "px4/start_set_current_1": Before(complete=True),
    "px4/start_stale_current": Before(plan="A", complete=True),
}


def fake_without_a_plan(name: str):
    home = (-353632621, 1491652371, 584.08)
    if name.startswith("px4/"):
        mode = (4, 4) if name == "px4/guided_flight" else (4, 3)
        system = recorded(name, "<", "HEARTBEAT")[0].message.get_srcSystem()
        fake = Px4(uptime_s=100.0, system_id=system, home=home, mode=mode, hears_station=True)
        # The mission that it had flown was still its mode; what it goes back to on the ground is HOLD.
        fake._mode_when_disarmed = (4, 3)
        if mode == (4, 4):
            fake.load([waypoint(*home[:2], 6.0)])
    else:
        vehicle = {"arducopter": "copter", "ardurover": "rover"}[name.split("/")[0]]
        fake = ArduPilot(vehicle=vehicle, uptime_s=120.0, home=home)
        fake.mode = "HOLD" if vehicle == "rover" else "STABILIZE"
    return fake


def fake_for(name: str):
    if name in GUIDED:
        return fake_without_a_plan(name)
    before = BEFORE.get(name, Before())
    beat = recorded(name, "<", "HEARTBEAT")[0]
    folder = name.split("/")[0]
    uploads = plans_uploaded(f"{folder}/start_stale_current") if folder not in OPTIONS else []
    if name.startswith("px4"):
        fake = Px4(**OPTIONS.get(folder, {}), uptime_s=100.0, hears_station=True,
                   system_id=beat.message.get_srcSystem(),
                   mode=(beat.message.custom_mode >> 16 & 0xFF, beat.message.custom_mode >> 24),
                   tells_at_s=recorded(name, "<", "MISSION_CURRENT")[0].time)  # fmt: skip
        if folder not in OPTIONS:
            fake.load(uploads["AB".index(before.plan) + 1])
        fake.missions.current = fake._known_current = before.current
        fake.complete = before.complete
    else:
        vehicle = "rover" if name.startswith("ardurover") else "copter"
        fake = ArduPilot(vehicle=vehicle, uptime_s=100.0, **OPTIONS.get(folder, {}), **before.options)
        mode = next(mode for mode, number in fake.kind.modes.items() if number == beat.message.custom_mode)
        fake.mode = fake.mode if mode == "AUTO" else mode  # that was ordered before it was told
        if folder not in OPTIONS:
            fake.load(uploads[1])
        if before.reached is not None:
            fake._last_reached = before.reached
            fake.stream(MISSION_CURRENT, 0.25, 0.0)
    return fake


# -- the pace of the recording --------------------------------------------------------------------

ON_THE_GROUND = ("SIM Hit ground", "Landing detected")
AUTO_LOITER, AUTO_TAKEOFF = 4 << 16 | 3 << 24, 4 << 16 | 2 << 24


class Told(NamedTuple):
    """What the fake would tell at a time of the recording."""

    time: float
    current: tuple
    heartbeat: tuple
    landed: int | None
    target: object


class Played(NamedTuple):
    """A recording, and the fake to which its client's side was played."""

    name: str
    fake: object
    sent: list[tuple[float, float]]  # of the client's frames: (time in the recording, time at the fake)
    told: list[Told]


def at_no_pace_of_its_own(fake) -> None:
    """Each leg, and each landing, lasts until arrive()."""
    flight = fake.flight
    own_leg: Callable = flight._leg

    def leg(item):
        target, takes_s = own_leg(item)
        return target, math.inf if takes_s > 0 else 0.0

    flight._leg = leg
    flight.pace = flight.pace._replace(descent=1e-9)


def moved(name: str) -> Played:
    fake = fake_for(name)
    if name in GUIDED:
        fake._follow_flight = lambda: fake.never("leg")
    else:
        at_no_pace_of_its_own(fake)
    heard = recordings.heard(name)
    told: list[Told] = []
    flies = "request_messages" not in name

    def follow(one, now: float) -> float:
        """What the real one said has come: arrive as it did, and note what the fake says by then."""
        now = max(now, one.time)
        message, kind = one.message, one.message.get_type()
        has_climbed = name in GUIDED and kind == "HEARTBEAT" and message.custom_mode == AUTO_LOITER \
            and fake.heartbeat().custom_mode == AUTO_TAKEOFF
        is_reached = flies and kind == "MISSION_ITEM_REACHED" and not is_repetition(one, heard)
        if has_climbed or is_reached:
            fake.arrive(now)
        if kind == "STATUSTEXT" and message.text.startswith(ON_THE_GROUND):
            if name not in GUIDED and fake.flight.index is not None and not fake.flight.sinking:
                fake.arrive(now)
            fake.arrive(now)
        fake._advance(now)
        state = fake.message_of(mavlink.MAVLINK_MSG_ID_EXTENDED_SYS_STATE, now)
        told.append(Told(now, what_is_told(fake._mission_current()), what_is_told(fake.heartbeat()),
                         None if state is None else state.landed_state,
                         fake.message_of(mavlink.MAVLINK_MSG_ID_POSITION_TARGET_GLOBAL_INT, now)))
        return now

    _, sent = play(name, fake, follow)
    return Played(name, fake, sent, told)


def what_is_told(message) -> tuple:
    if message.get_type() == "HEARTBEAT":
        copter = message.autopilot != mavlink.MAV_AUTOPILOT_PX4 and message.type == mavlink.MAV_TYPE_QUADROTOR
        return (message.base_mode, message.custom_mode, None if copter else message.system_status)
    return (message.seq, message.total, message.mission_state, message.mission_mode, message.mission_id)


@pytest.fixture(scope="module")
def played():
    """Plays each recording once."""
    made: dict[str, Played] = {}

    def play_once(name: str) -> Played:
        if name not in made:
            made[name] = moved(name)
        return made[name]

    return play_once


# -- what it answers ------------------------------------------------------------------------------


def said_by_both(played: Played) -> tuple[list, list]:
    """What is compared of the fake and of the real one."""
    ends = until(played.name)
    return tuple([(time, message) for time, message in said if time < ends]
                 for said in (said_by(played.fake), said_in_recording(played.name)))


def answers(said) -> list[tuple]:
    return [fields(message) for _, message in said if message.get_type() != "STATUSTEXT" and not is_clocked(message)]


@EACH
def test_it_answers_as_the_real_one(played, name):
    said, real = said_by_both(played(name))
    assert answers(said) == answers(real), transcript(played(name).fake)


def reached(said) -> list[tuple[float, int]]:
    """(time, item), without repetitions."""
    told = [(time, message.seq) for time, message in said if message.get_type() == "MISSION_ITEM_REACHED"]
    return [one for before, one in zip([(0.0, None), *told], told, strict=False) if one[1] != before[1]]


@EACH
def test_it_calls_the_same_items_reached_and_not_later(played, name):
    said, real = map(reached, said_by_both(played(name)))
    assert [seq for _, seq in said] == [seq for _, seq in real]
    for (said_time, seq), (real_time, _) in zip(said, real, strict=True):
        assert said_time - real_time < TOLD_WITHIN_S, seq


def texts(said) -> list[tuple[float, str, int]]:
    """(time, text, severity), put together from their pieces."""
    whole: list[tuple[float, str, int]] = []
    for time, message in said:
        if message.get_type() == "STATUSTEXT" and message.chunk_seq:
            whole[-1] = (whole[-1][0], whole[-1][1] + message.text, message.severity)
        elif message.get_type() == "STATUSTEXT":
            whole.append((time, message.text, message.severity))
    return whole


@EACH
def test_it_says_in_words_what_the_real_one_said_and_when(played, name):
    said, real = map(texts, said_by_both(played(name)))
    assert [one[1:] for one in said] == [one[1:] for one in real], transcript(played(name).fake)
    for (said_time, words, _), (real_time, _, _) in zip(said, real, strict=True):
        within_s = SPOOLED_UP_WITHIN_S if words.startswith("Takeoff") else TOLD_WITHIN_S
        assert abs(said_time - real_time) < within_s, f"{words}: {said_time:.3f} s, not {real_time:.3f} s"


REQUESTS = pytest.mark.parametrize("name", [name for name in NAMES if name.endswith("request_messages")])


@REQUESTS
def test_it_sends_what_was_asked_for_beside_its_acknowledgement(played, name):
    """AUTOPILOT_VERSION, of which nothing else is compared, and MESSAGE_INTERVAL."""
    kinds = ("AUTOPILOT_VERSION", "MESSAGE_INTERVAL", "COMMAND_ACK")

    def brief(messages) -> list:
        return [message.get_type() if message.get_type() == kinds[0] else fields(message)
                for message in messages if message.get_type() in kinds]

    assert brief(played(name).fake.messages("<")) == brief(one.message for one in recorded(name, "<", *kinds))


@REQUESTS
def test_it_sends_mission_current_at_the_interval_that_was_asked_for(played, name):
    """4 Hz, then 5 Hz, then none for 3 s, then none or one each second; but PX4 always one each second."""
    orders = [one.time for one in recorded(name, ">", "COMMAND_LONG")
              if (one.message.command, one.message.param1) == (511, MISSION_CURRENT)]
    theirs = [one.time for one in recorded(name, "<", "MISSION_CURRENT")]
    mine = [time for time, direction, message in played(name).fake.log
            if direction == "<" and message.get_type() == "MISSION_CURRENT"]
    for begins, ends in zip([0.0, *orders], [*orders, recordings.heard(name)[-1].time], strict=True):
        counts = [sum(begins + ANSWERED_WITHIN_S < time < ends for time in times) for times in (mine, theirs)]
        assert abs(counts[0] - counts[1]) <= 1, f"from {begins:.3f} to {ends:.3f} s"


# -- what it tells from time to time --------------------------------------------------------------


def in_turn(told: list) -> list:
    """Without repetitions."""
    return [one for before, one in zip([None, *told], told, strict=False) if one != before]


def lasting(told: list[tuple[float, tuple]]) -> list[tuple]:
    """What was told for long enough, in turn."""
    result, begun = [], told[0][0]
    for (_, before), (time, now) in pairwise(told):
        if now != before:
            if time - begun > LASTING_S:
                result.append(before)
            begun = time
    return in_turn(result)


def is_in_order(part: list, whole: list) -> bool:
    rest = iter(whole)
    return all(one in rest for one in part)


# (Which plan was aboard in px4/guided_flight is not known.)
@pytest.mark.parametrize(("kind", "name"), [
    *(("HEARTBEAT", name) for name in [*NAMES, *GUIDED]),
    *(("MISSION_CURRENT", name) for name in [*NAMES, *GUIDED] if name != "px4/guided_flight"),
])  # fmt: skip
def test_it_would_tell_what_the_real_one_told(played, name, kind):
    told = [(one.time, one.current if kind == "MISSION_CURRENT" else one.heartbeat) for one in played(name).told
            if one.time < until(name)]
    real = [(one.time, what_is_told(one.message)) for one in recorded(name, "<", kind)]
    answered = answer_times(name)
    unasked = [(time, what) for time, what in real
               if not any(0 <= time - asked <= ANSWERED_WITHIN_S for asked in answered)]
    for time, what in unasked:
        near = {mine for at, mine in told if abs(at - time) <= ALIKE_WITHIN_S}
        assert what in near, f"{what} at {time:.3f} s; the fake: {near}"
    if len(unasked) > 3:
        assert is_in_order(lasting(told), in_turn([what for _, what in real])), (lasting(told), real)


def answer_times(name: str) -> list[float]:
    """When something was asked that ArduPilot answers by a MISSION_CURRENT."""
    if name.startswith("px4"):
        return []
    return [one.time for one in recorded(name, ">", "MISSION_SET_CURRENT", "COMMAND_LONG")
            if one.message.get_type() == "MISSION_SET_CURRENT" or one.message.command == 224
            or (one.message.command, one.message.param1) == (512, MISSION_CURRENT)]


@ON_ARDUPILOT
def test_it_answers_by_the_same_current_item(played, name):
    """Or not at all, where the item is beyond the plan. (One that says the same as before may be a stream's.)"""
    one_played = played(name)
    at_fake = dict(one_played.sent)
    mine = [(time, message) for time, direction, message in one_played.fake.log
            if direction == "<" and message.get_type() == "MISSION_CURRENT"]
    real = [(one.time, one.message) for one in recorded(name, "<", "MISSION_CURRENT")]
    for asked in answer_times(name):
        told = [what_is_told(message) for time, message in mine
                if 0 <= time - at_fake[asked] <= ANSWERED_WITHIN_S]
        theirs = [what_is_told(message) for time, message in real if 0 <= time - asked <= ANSWERED_WITHIN_S]
        before = [what_is_told(message) for time, message in real if time < asked]
        if told or theirs[-1:] != before[-1:]:
            assert told == theirs[-1:], f"asked at {asked:.3f} s"


# -- without a plan -------------------------------------------------------------------------------


@WITHOUT_A_PLAN
def test_it_is_landed_and_in_the_air_when_the_real_one_was(played, name):
    for one in recorded(name, "<", "EXTENDED_SYS_STATE"):
        near = {told.landed for told in played(name).told if abs(told.time - one.time) <= LANDED_WITHIN_S}
        assert one.message.landed_state in near, f"{one.message} at {one.time:.3f} s; the fake: {near}"


# Up to when the place is where it then was: a takeoff, and at the end a takeoff in the air and a hold.
FLIES_TO_PLACES = {"px4/guided_flight": (12.0, 1e9), "px4/guided_flight_2": (14.6, 35.8)}


@WITHOUT_A_PLAN
def test_it_flies_to_the_places_to_which_the_real_one_flew(played, name):
    """On PX4 to the same height above the sea, whatever the frame. The recorded ArduCopter has not told of it."""
    begins, ends = FLIES_TO_PLACES.get(name, (0.0, 1e9))
    for one in recorded(name, "<", "POSITION_TARGET_GLOBAL_INT"):
        if not begins < one.time < ends:
            continue
        place = (one.message.lat_int, one.message.lon_int)
        near = [told.target for told in played(name).told
                if told.target is not None and abs(told.time - one.time) <= LANDED_WITHIN_S]
        same = [target for target in near if max(abs(target.lat_int - place[0]), abs(target.lon_int - place[1])) <= 1]
        assert same, f"{place} at {one.time:.3f} s; the fake: {near}"
        if name.startswith("px4/"):
            assert any(target.alt == pytest.approx(one.message.alt, abs=0.01) for target in same), same


def test_px4_takes_8_m_above_home_for_8_m_above_the_sea_and_lands():
    """What the recording shows, at the fake's own pace."""
    home = (-353632621, 1491652371, 584.08)
    fake = Px4(uptime_s=100.0, home=home)
    client = mavlink.MAVLink(None, 255, 190)

    def send(message, now: float) -> None:
        fake.receive(message.pack(client), now)

    nan = float("nan")
    send(mavlink.MAVLink_command_long_message(1, 1, 400, 0, 1, 0, 0, 0, 0, 0, 0), 1.0)
    send(mavlink.MAVLink_command_long_message(1, 1, 22, 0, -1, 0, 0, nan, nan, nan, home[2] + 10), 1.1)
    fake.run(20.0)
    assert fake.flight.where(20.0).height == pytest.approx(10.0, abs=0.1)
    send(mavlink.MAVLink_command_int_message(1, 1, 6, 192, 0, 0, -1, 1, 0, nan, home[0] + 1500, home[1], 8.0), 20.0)
    fake.run(60.0)
    assert fake.flight.where(60.0).height == 0 and not fake.armed


def test_real_px4_counts_its_height_from_the_home_that_it_names():
    """So home's altitude is what GLOBAL_POSITION_INT says above the sea, less what it says above home."""
    places = [(one.time, one.message.alt - one.message.relative_alt)
              for one in recorded("px4/guided_flight", "<", "GLOBAL_POSITION_INT")]  # fmt: skip
    compared = 0
    for one in recorded("px4/guided_flight", "<", "HOME_POSITION"):
        near = [altitude for at, altitude in places if abs(at - one.time) < 0.02]
        assert all(abs(altitude - one.message.altitude) <= 1 for altitude in near), one
        compared += len(near)
    assert compared == 8
