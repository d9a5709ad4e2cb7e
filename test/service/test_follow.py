"""Following the mission as a real autopilot flew it. host/units/mission_follower.cpp has each rule."""

from __future__ import annotations

import pytest

from simulation.recordings import heard


@pytest.mark.scenario(51, "An item is reached once; a command that must not happen twice is not repeated")
@pytest.mark.parametrize(
    "flight, personality, options",
    [("arducopter/flight", "ArduPilot", {}), ("px4/flight", "PX4", {"tells_at_s": 600.0})],
)
def test_recorded_flight_is_followed_item_by_item(build_service, flight, personality, options):
    service = build_service(personality, **options)
    service.run(2.0)
    for entry in heard(flight):
        if entry.direction == "<" and entry.message.get_type() in ("MISSION_CURRENT", "MISSION_ITEM_REACHED"):
            service.say(entry.message)
            service.run(0.01)
    assert service.reached == [0, 1, 2]
    assert service.currents[:3] == [0, 1, 2]
    assert service.followed.total == 4
