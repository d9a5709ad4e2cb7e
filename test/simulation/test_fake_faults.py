"""Faults in the fake autopilots themselves, each as it was ordered."""

from __future__ import annotations

import pytest

from fake_talk import ACCEPTED, BOTH, DENIED, ERROR, INVALID_SEQUENCE, NO_SPACE, client_of, missions, waypoints
from simulation.fake_autopilot import FENCE, RALLY, ArduPilot, Px4, item


@BOTH
@pytest.mark.parametrize("result", [1, 15, 200])
@pytest.mark.parametrize("step", ["count", 0, 1, 2, "end"])
def test_any_result_can_be_ordered_at_any_step_of_an_upload(autopilot, result, step):
    fake = autopilot()
    fake.faults.refuse(result, step)
    client = client_of(fake)
    assert client.upload(waypoints(3)) == result
    if autopilot is Px4:
        assert fake.received() == []
    assert client.upload(waypoints(3)) == ACCEPTED


@BOTH
def test_any_result_can_be_ordered_in_a_download_and_a_clear(autopilot):
    fake = autopilot()
    fake.load(waypoints(3))
    fake.faults.refuse(DENIED, "list")
    fake.faults.refuse(ERROR, ("read", 1))
    fake.faults.refuse(NO_SPACE, "clear")
    client = client_of(fake)
    assert missions(client.say(client.request_list())) == [("ACK", DENIED)]
    assert missions(client.say(client.request_list())) == [("COUNT", 3)]
    assert missions(client.say(client.request_int(0))) == [("ITEM", 0)]
    assert missions(client.say(client.request_int(1))) == [("ACK", ERROR)]
    assert missions(client.say(client.clear_all())) == [("ACK", NO_SPACE)]
    assert missions(client.say(client.clear_all())) == [("ACK", ACCEPTED)]


@BOTH
def test_it_falls_silent_from_a_time_on_for_a_while(autopilot):
    fake = autopilot()
    fake.faults.fall_silent(from_time=2.0, for_s=3.0)
    fake.run(10.0)
    times = [time for time, _ in fake.outbox]
    assert not [time for time in times if 2.0 <= time < 5.0]
    assert [time for time in times if time < 2.0] and [time for time in times if time >= 5.0]


@BOTH
@pytest.mark.parametrize("step, heard", [("count", 0), (0, 1), (1, 2)])
def test_it_falls_silent_from_a_step_on(autopilot, step, heard):
    fake = autopilot()
    fake.faults.fall_silent(step=step)
    client = client_of(fake)
    said = missions(client.say(client.count(3)))
    for seq in range(3):
        said += missions(client.say(client.item(waypoints(1)[0], seq)))
    assert len(said) == heard
    assert client.wait(20.0) == []
    with pytest.raises(ValueError, match="say when"):
        fake.faults.fall_silent()


@BOTH
def test_a_reboot_forgets_the_transfer_and_keeps_the_plan(autopilot):
    fake = autopilot(uptime_s=100)
    old = waypoints(3)
    fake.load(old)
    client = client_of(fake)
    client.say(client.count(3))
    fake.reboot(client.now, silent_for_s=4.0)
    assert missions(client.say(client.item(old[0], 0))) == []
    silent_until = fake.booted_at_s
    answers = client.wait(20.0)
    assert missions(answers) == []
    assert not [time for time, direction, _ in fake.log
                if direction == "<" and silent_until - 4.0 < time < silent_until]
    assert fake.received() == old
    assert client.upload(waypoints(2, first=8)) == ACCEPTED


@BOTH
def test_the_final_ack_can_be_swallowed_though_the_plan_is_aboard(autopilot):
    fake = autopilot()
    fake.faults.swallow_final_ack()
    client = client_of(fake)
    plan = waypoints(2)
    client.say(client.count(2))
    client.say(client.item(plan[0], 0))
    assert missions(client.say(client.item(plan[1], 1), wait_s=5.0)) == []
    assert fake.received() == plan
    assert client.upload(plan) == ACCEPTED


@BOTH
def test_the_final_ack_can_be_late(autopilot):
    fake = autopilot()
    fake.faults.delay_final_ack(0.7)
    client = client_of(fake)
    client.say(client.count(1))
    assert missions(client.say(client.item(waypoints(1)[0], 0), wait_s=0.7)) == []
    assert missions(client.wait(0.1)) == [("ACK", ACCEPTED)]


@BOTH
def test_items_can_be_asked_for_out_of_order(autopilot):
    fake = autopilot()
    fake.faults.request_instead(1, 2, 0)
    client = client_of(fake)
    client.say(client.count(3))
    asked = [seq for kind, seq in missions(client.say(client.item(waypoints(1)[0], 0), 4.0))
             if kind != "ACK"]
    assert asked[:3] == [2, 0, 1]


def circle(radius: float):
    return item(5003, x=-353632620, y=1491652370, param1=radius)


def test_ardupilot_accepts_a_short_fence_in_the_place_of_a_longer_one_and_wipes_it_when_it_could_be_read():
    fake = ArduPilot()
    client = client_of(fake)
    three, two, one = [circle(30.0), circle(40.0), circle(45.0)], [circle(30.0), circle(40.0)], [circle(60.0)]
    for fence, kept in ((three, 3), (two, 0), (two, 2), (one, 1), (three, 3), (one, 0), (one, 1)):
        assert client.upload(fence, FENCE) == ACCEPTED
        assert client.ask(client.request_list(FENCE)).count == len(fence)
        client.wait(1.0)
        assert client.ask(client.request_list(FENCE)).count == kept


def test_ardupilot_accepts_a_rally_point_at_0_0_and_cannot_give_it():
    fake = ArduPilot()
    client = client_of(fake)
    place = item(5100, x=-353632620, y=1491652370)
    assert client.upload([place, item(5100), place], RALLY) == ACCEPTED
    assert missions(client.say(client.request_list(RALLY))) == [("COUNT", 3)]
    assert missions(client.say(client.request_int(0, RALLY))) == [("ITEM", 0)]
    assert missions(client.say(client.request_int(1, RALLY))) == [("ACK", INVALID_SEQUENCE)]
    assert missions(client.say(client.request_int(2, RALLY))) == [("ITEM", 2)]
