"""What the fake autopilots answer to who reads their plan."""

from __future__ import annotations

from fake_talk import ERROR, client_of, missions, waypoints, words
from simulation.fake_autopilot import ArduPilot, Px4


def test_ardupilot_serves_requests_in_any_order_to_anyone():
    fake = ArduPilot()
    fake.load(waypoints(4))
    client = client_of(fake)
    for seq in (3, 1, 1, 0):
        assert missions(client.say(client.request_int(seq))) == [("ITEM", seq)]
    assert missions(client.say(client.request_int(4))) == [("ACK", ERROR)]


def test_px4_serves_the_next_item_or_the_last_one_again():
    fake = Px4()
    fake.load(waypoints(4))
    client = client_of(fake)
    assert missions(client.say(client.request_int(0))) == []  # no download: silence
    client.say(client.request_list())
    for seq in (0, 0, 1, 1, 2):
        assert missions(client.say(client.request_int(seq))) == [("ITEM", seq)]
    answers = client.say(client.request_int(0))
    assert missions(answers) == [("ACK", ERROR)]
    assert words(answers) == ["WPM: REJ. CMD: Req. WP was unexpected"]


def test_px4_answers_a_request_list_for_an_empty_plan():
    client = client_of(Px4())
    assert missions(client.say(client.request_list())) == [("COUNT", 0)]


def test_px4_flags_its_current_item():
    fake = Px4()
    client = client_of(fake)
    plan = waypoints(3)
    plan[1] = plan[1]._replace(current=1)
    client.upload(plan)
    assert [one.current for one in client.download()] == [0, 1, 0]
