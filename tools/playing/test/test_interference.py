"""Somebody else has a hand in a run of the page: what the autopilot does, and what the sketch makes of it."""

from __future__ import annotations

import json

import pytest

from building import build_sketch
from demonstration.autopilots import EXAMPLES_FLY_AT
from playing.inside.autopilot_end import AutopilotEnd
from playing.inside.interference import as_message
from simulation.fake_autopilot import item, mavlink
from simulation.mega import Mega

HZ, SLICE_S = 16_000_000, 0.02
SLICE_CYCLES = 80_000  # 5 ms
BAUD = 57600.0
PILOT, RETURN = {"ardupilot": "LOITER", "px4": "POSCTL"}, {"ardupilot": "RTL", "px4": "RTL"}


class Run:
    """An example beside the page's end of the line."""

    def __init__(self, example: str, autopilot: str, arms: bool, latency: int = 0) -> None:
        self.mega = Mega(build_sketch(example).elf)
        self.end = AutopilotEnd(json.dumps({
            "autopilot": autopilot, "loss": 0, "bytes": 0, "latency": latency, "seed": 1, "hz": self.mega.hz,
            "arms": arms, "home": EXAMPLES_FLY_AT,
        }))  # fmt: skip
        self.printed = b""
        self.events: list[str] = []
        self.frames: list[dict] = []

    @property
    def height_m(self) -> float:
        return self.end.autopilot.flight.where(self.now).height

    @property
    def now(self) -> float:
        return self.mega.cycle / self.mega.hz

    def until(self, is_so, limit_s: float) -> None:
        limit = self.now + limit_s
        while not is_so():
            assert self.now < limit, self.printed
            self.mega.run_until(self.mega.cycle + SLICE_CYCLES)
            self.printed += bytes(one.byte for one in self.mega.serial(0).sent())
            sent = self.mega.serial(1).sent()
            data, left = bytes(one.byte for one in sent), [one.left for one in sent]
            arriving = self.end.step(self.now, data, left, BAUD)
            if arriving:
                self.mega.serial(1).send(arriving, self.mega.cycle)
            news = json.loads(self.end.news() or "{}")
            self.events += [event["words"] for event in news.get("events", [])]
            self.frames += news.get("frames", [])

    def for_s(self, seconds: float) -> None:
        end = self.now + seconds
        self.until(lambda: self.now >= end, seconds + 1)


@pytest.mark.slow
@pytest.mark.parametrize("autopilot", ["ardupilot", "px4"])
@pytest.mark.parametrize("who, modes, words", [
    ("pilot", PILOT, "a pilot sets "), ("battery", RETURN, "the battery is low: the autopilot returns"),
])  # fmt: skip
def test_a_mode_that_somebody_sets_in_flight_stays(autopilot, who, modes, words):
    run = Run("GoToPlaces", autopilot, arms=True)
    run.until(lambda: b"to 1\r\n" in run.printed, 60)
    run.for_s(2.0)
    run.end.interfere(who)
    run.for_s(10.0)
    assert run.end._mode() == modes[autopilot]
    assert any(event.startswith(words) for event in run.events)
    if who != "pilot":
        return
    run.end.interfere("lands")
    run.until(lambda: not run.end.autopilot.armed, 60)
    run.for_s(10.0)
    assert not run.end.autopilot.armed and b"ended by a pilot" in run.printed


@pytest.mark.parametrize("autopilot", ["ardupilot", "px4"])
def test_a_pilot_who_gives_it_back_sets_the_mode_of_before(autopilot):
    run = Run("UploadMission", autopilot, arms=False)
    run.for_s(0.5)
    before = run.end._mode()
    for mode in (PILOT[autopilot], before, PILOT[autopilot]):
        run.end.interfere("pilot")
        run.for_s(0.5)
        assert run.end._mode() == mode
    assert [event.split(" sets ")[0] for event in run.events] == ["a pilot", "the pilot", "a pilot"]


def test_a_low_battery_on_the_ground_is_told_and_does_nothing():
    run = Run("UploadMission", "ardupilot", arms=False)
    run.for_s(0.5)
    mode = run.end._mode()
    run.end.interfere("battery")
    run.for_s(0.5)
    assert run.end._mode() == mode and run.events == ["the battery is low: on the ground nothing happens"]


@pytest.mark.parametrize("autopilot", ["ardupilot", "px4"])
def test_the_plan_of_another_station_is_aboard_in_the_place_of_ours(autopilot):
    run = Run("UploadMission", autopilot, arms=False)
    run.until(lambda: json.loads(run.end.verdict("{}"))["good"], 10)
    run.end.interfere("station")
    run.for_s(0.5)
    assert len(run.end.autopilot.received()) == (4 if autopilot == "ardupilot" else 3)
    assert run.events == ["another ground station uploads its 3 items"]
    verdict = json.loads(run.end.verdict("{}"))
    assert not verdict["good"] and verdict["replaced"]
    items = "3 items and home" if autopilot == "ardupilot" else "3 items"
    assert f" now: {items}, which are not those that the Mega put there." in verdict["sentence"]


def test_a_further_plan_of_the_mega_takes_the_place_of_its_first_one():
    settings = {"autopilot": "px4", "loss": 0, "bytes": 0, "seed": 1, "hz": HZ, "home": EXAMPLES_FLY_AT}
    end = AutopilotEnd(json.dumps(settings))
    packer, parser, now = mavlink.MAVLink(None, 1, 191), mavlink.MAVLink(None), 1.0
    for heights in ((10.0, 20.0, 30.0), (40.0, 50.0)):
        said = [mavlink.MAVLink_mission_count_message(1, 1, len(heights), 0)]
        for _ in range(60):
            data = b"".join(message.pack(packer) for message in said)
            left = [int((now + turn * 10 / BAUD) * HZ) for turn in range(1, len(data) + 1)]
            now += SLICE_S
            answers = parser.parse_buffer(end.step(now, data, left, BAUD)) or []
            asked = [answer.seq for answer in answers if answer.get_type().startswith("MISSION_REQUEST")]
            said = [as_message(seq, item(16, x=1, y=2, z=heights[seq]), (1, 1)) for seq in asked]
        verdict = json.loads(end.verdict("{}"))
        assert verdict["good"] and verdict["sentence"].startswith(f"All {len(heights)} items are aboard PX4")


@pytest.mark.parametrize(("name", "way"), [(">", ">"), ("<", "<"), ("MISSION_ACK", "<"), ("MISSION_REQUEST*", "<")])
def test_the_next_frame_that_is_named_is_lost_and_the_upload_ends_accepted(name, way):
    run = Run("UploadMission", "ardupilot", arms=False)
    run.end.lose_next(name)
    run.until(lambda: json.loads(run.end.verdict("{}")).get("knows"), 20)
    (lost,) = [frame for frame in run.frames if frame["lost"]]
    assert lost["way"] == way and lost["text"].startswith(name.strip("<>*"))
    assert len(run.events) == 1 and run.events[0].endswith("will be lost")


def test_what_is_late_takes_so_much_longer_each_way():
    run = Run("UploadMission", "ardupilot", arms=False, latency=300)
    run.until(lambda: json.loads(run.end.verdict("{}")).get("knows"), 20)
    asked = next(frame["ended"] for frame in run.frames if frame["text"].startswith("MISSION_COUNT"))
    answered = next(frame["began"] for frame in run.frames if frame["text"].startswith("MISSION_REQUEST"))
    assert 0.6 <= answered - asked < 0.65
