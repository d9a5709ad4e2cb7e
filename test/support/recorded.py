"""A recording's client side, played to a fake autopilot, and how what the fake answers is compared."""

from __future__ import annotations

import math
from typing import Any

from simulation import recordings
from simulation.fake_autopilot import FENCE, MISSION, RALLY, ArduPilot, Item, Px4, mavlink
from simulation.fake_autopilot.betaflight import Betaflight

ANSWER_WITHIN_S = 0.050
BAUD = 57600  # of the recorded line
CLIENT = (255, 190)
NOT_ABOUT_MISSIONS = ("EKF", "AHRS:", "PreArm:", "SIM ", "[logger]", "Arming disabled:",
                      "Warning: Arming Checks Disabled")  # fmt: skip
TELLS_AGAIN = ("MISSION_CURRENT", "MISSION_ITEM_REACHED")

# The recording whose last accepted plan is aboard when this one begins, by mission type.
ABOARD_BEFORE = {
    "arducopter/client_vanishes": {MISSION: "arducopter/item_lost"},
    "px4/item_lost": {MISSION: "px4/clean_with_streams"},
    "px4/client_vanishes": {MISSION: "px4/item_lost"},
    "px4/items_repeated": {MISSION: "px4/item_lost"},
    "px4/count_repeated": {MISSION: "px4/item_lost"},
    "px4/wrong_sequence": {MISSION: "px4/count_repeated"},
    "px4/second_client": {MISSION: "px4/item_lost"},
    "px4/float_items": {RALLY: "px4/rally"},
    "px4/flight": {MISSION: "px4/refused_items"},
}
# Of the fake, by folder of recordings.
OPTIONS: dict[str, dict[str, Any]] = {"arducopter_4_8": {"home": (473977420, 85455940, 488.1), "lists_modes": True},
                                      "px4_1_18": {"is_1_18": True}}
UNRECORDED_FENCE_ID = 2043668742  # of a fence aboard in px4/flight that no recording shows


def plans_uploaded(name: str, mission_type: int = MISSION) -> list[list[Item]]:
    """The plans of this type that the client of a recording began to send."""
    plans: list[dict[int, Item]] = [{}]
    for one in recordings.heard(name):
        if one.direction != ">" or getattr(one.message, "mission_type", None) != mission_type:
            continue
        if one.message.get_type() == "MISSION_COUNT" and one.message.get_srcSystem() == CLIENT[0]:
            plans.append({})
        elif one.message.get_type() == "MISSION_ITEM_INT":
            plans[-1][one.message.seq] = Item.of(one.message)
    return [[items[seq] for seq in sorted(items)] for items in plans]


def plan_uploaded(name: str, mission_type: int) -> list[Item]:
    """The last whole plan of this type that the client of a recording sent."""
    return plans_uploaded(name, mission_type)[-1]


def is_of_ground_station(name: str) -> bool:
    """Whether its client says that it is one. (Few recordings begin with another kind of client.)"""
    return not any(one.direction == ">" and one.message.get_type() == "HEARTBEAT"
                   and one.message.type != mavlink.MAV_TYPE_GCS for one in recordings.heard(name))  # fmt: skip


def fake_for(name: str):
    """A fake in the state in which the recorded autopilot was."""
    if name.startswith("arducopter"):
        options = OPTIONS.get(name.split("/")[0], {})
        fake = ArduPilot(uptime_s=100.0, port_signs=not name.endswith("port_off"), **options)
    else:
        first_told = next(one.time for one in recordings.heard(name) if one.message.get_type() == "MISSION_CURRENT")
        if name.startswith("betaflight/"):
            return Betaflight(uptime_s=100.0, has_home=False, tells_at_s=first_told)
        fake = Px4(uptime_s=100.0, infeasible_text=False, tells_at_s=first_told,
                   hears_station=is_of_ground_station(name), **OPTIONS.get(name.split("/")[0], {}))  # fmt: skip
    for mission_type, earlier in ABOARD_BEFORE.get(name, {}).items():
        fake.load(plan_uploaded(earlier, mission_type), mission_type)
    if name == "px4/flight":
        fake.missions.checksums[FENCE] = UNRECORDED_FENCE_ID
    return fake


def is_compared(message) -> bool:
    kind = message.get_type()
    if kind == "STATUSTEXT":
        return not message.text.startswith(NOT_ABOUT_MISSIONS)
    return kind.startswith("MISSION_") or kind == "COMMAND_ACK"


def is_clocked(message) -> bool:
    """Told over and over, by a clock that has nothing to do with the client."""
    return message.get_type() in TELLS_AGAIN


def fields(message) -> tuple:
    left_out = {"mavpackettype", "id"} if message.get_type() == "STATUSTEXT" else {"mavpackettype"}
    values = {}
    for key, value in message.to_dict().items():
        if key not in left_out:
            values[key] = "nan" if isinstance(value, float) and math.isnan(value) else value
    return (message.get_type(), tuple(values.items()))


def play(name: str, fake=None, on_told=None):
    """Play the client's side of a recording to a fake. Returns the fake and what it heard.

    on_told(one, now [s]), if there is one, is called for each frame that the real autopilot sent.
    Result: (fake, [(time in the recording, time at the fake)] of client frames).
    """
    fake = fake or fake_for(name)
    heard = recordings.heard(name)
    answered = 0  # how many compared messages the recorded autopilot has sent so far
    last_from_autopilot = -math.inf
    client_times = []
    now = line_free = 0.0
    for one in heard:
        if one.direction == "<":
            if on_told is not None:
                now = max(now, on_told(one, now))
            if is_compared(one.message) and not is_repetition(one, heard):
                answered += 1
                last_from_autopilot = one.time
            continue
        due = one.time
        if one.message.get_type() != "HEARTBEAT" and one.time - last_from_autopilot < ANSWER_WITHIN_S:
            cause = wait_for(fake, answered, now, limit=one.time + 30.0)
            due = cause + one.time - last_from_autopilot
        # Frames written together arrive one after the other.
        line_free = max(line_free + recordings.BITS_PER_BYTE * len(one.frame) / BAUD, due)
        now = max(now, line_free)
        fake.receive(one.frame, now)
        if one.message.get_type() != "HEARTBEAT":
            client_times.append((one.time, now))
    fake.run(max(now, heard[-1].time) + 0.1)
    return fake, client_times


def is_repetition(one, heard) -> bool:
    """A MISSION_CURRENT or MISSION_ITEM_REACHED is no cause, but the first of a number is."""
    if one.message.get_type() == "MISSION_CURRENT":
        return True
    if one.message.get_type() != "MISSION_ITEM_REACHED":
        return False
    earlier = [
        other.message.seq
        for other in heard
        if other.direction == "<" and other.time < one.time and other.message.get_type() == "MISSION_ITEM_REACHED"
    ]
    return bool(earlier) and earlier[-1] == one.message.seq


def causes(fake) -> list[float]:
    """When the fake sent each message that can have caused a client's answer [s]."""
    times, last_reached = [], None
    for time, direction, message in fake.log:
        if direction != "<" or not is_compared(message):
            continue
        if message.get_type() == "MISSION_CURRENT":
            continue
        if message.get_type() == "MISSION_ITEM_REACHED":
            if message.seq == last_reached:
                continue
            last_reached = message.seq
        times.append(time)
    return times


def wait_for(fake, count: int, now: float, limit: float) -> float:
    """Let the fake run until it has sent `count` such messages; the time of the last [s]."""
    while len(causes(fake)) < count:
        due = fake.next_event(now)
        assert due is not None and due <= limit, f"the fake says less than the real one:\n{transcript(fake)}"
        now = due
        fake.run(now)
    return causes(fake)[count - 1]


def transcript(fake) -> str:
    return "\n".join(
        f"{time:9.4f} {direction} {message}"
        for time, direction, message in fake.log
        if is_compared(message) or direction == ">"
    )


def said_by(fake):
    return [(time, message) for time, direction, message in fake.log if direction == "<" and is_compared(message)]


def said_in_recording(name: str) -> list[tuple[float, Any]]:
    """The same of the real one."""
    heard = recordings.heard(name)
    return [(one.time, one.message) for one in heard if one.direction == "<" and is_compared(one.message)]
