"""The fake autopilots say what the real ones said in test/recordings.

Each recording's client side is played to the fake, and what the fake answers is held
against what the real autopilot did:

- Compared: MISSION_*, STATUSTEXT and COMMAND_ACK, in the same order with the same fields.
  Left out are texts about sensors, and the number of a STATUSTEXT and of a MISSION_CURRENT
  or MISSION_ITEM_REACHED that merely repeats the one before: those two come with a clock of
  their own, and are compared by what they say and, on PX4, by their period.
- A client frame that came within 50 ms of an autopilot's message was its answer, and follows
  the fake's same message by as much. Any other comes at its recorded time.
- How many milliseconds an answer takes is not compared. What the autopilot does of its own
  accord (asks again, gives up) is: its time since the client's last frame may differ by 10 %,
  and so may the time between two such messages.
"""

from itertools import pairwise

import pytest

from plain_client import PlainClient
from recorded import TELLS_AGAIN, fields, is_clocked, play, said_by, said_in_recording, transcript
from simulation import recordings
from simulation.fake_autopilot import FENCE, RALLY, ArduPilot, Item, Px4, mavlink

OWN_ACCORD_AFTER_S = 0.150
TOLERANCE = 0.10
LATENCY_S = 0.030  # what an answer's milliseconds may add to an interval


def without_clocked(said):
    return [(time, message) for time, message in said if not is_clocked(message)]


@pytest.fixture(scope="module", params=recordings.names())
def played(request):
    fake, client_times = play(request.param)
    return request.param, fake, client_times


def test_the_fake_says_what_the_real_autopilot_said(played):
    name, fake, _ = played
    real = [fields(message) for _, message in without_clocked(said_in_recording(name))]
    said = [fields(message) for _, message in without_clocked(said_by(fake))]
    # The recording ends while the autopilot may be about to say more.
    assert said[:len(real)] == real, transcript(fake)
    assert len(said) - len(real) <= 1, transcript(fake)


def test_it_asks_again_and_gives_up_when_the_real_one_does(played):
    name, fake, client_times = played
    real = without_clocked(said_in_recording(name))
    said = without_clocked(said_by(fake))
    for (real_time, real_message), (said_time, _) in zip(real, said, strict=True):
        real_quiet = since_client(real_time, [recorded for recorded, _ in client_times])
        if real_quiet is None or real_quiet < OWN_ACCORD_AFTER_S \
                or name.endswith("streams_10hz"):
            continue  # an answer; on the full line of that one even answers took longer
        if name.endswith("flight"):
            continue  # pace of flying, which is nobody's protocol
        quiet = since_client(said_time, [played_at for _, played_at in client_times])
        assert abs(quiet - real_quiet) <= TOLERANCE * real_quiet + LATENCY_S, \
            f"{real_message} after {quiet:.3f} s, the real one after {real_quiet:.3f} s"


def since_client(time: float, client_times: list[float]):
    """How long the client had been quiet at a time [s]; None before its first frame."""
    earlier = [sent for sent in client_times if sent <= time]
    return time - earlier[-1] if earlier else None


def requests_again(said) -> list[float]:
    """The intervals between requests for the same item that follow one another [s]."""
    intervals = []
    for (before, first), (after, second) in pairwise(said):
        if first.get_type().startswith("MISSION_REQUEST") and fields(first) == fields(second) \
                and after - before > OWN_ACCORD_AFTER_S:
            intervals.append(after - before)
    return intervals


def test_each_repeated_request_comes_at_the_real_interval(played):
    name, fake, _ = played
    real = requests_again(without_clocked(said_in_recording(name)))
    said = requests_again(without_clocked(said_by(fake)))
    assert len(said) == len(real)
    for ours, theirs in zip(said, real, strict=True):
        assert ours == pytest.approx(theirs, rel=TOLERANCE)


def told(said, kind: str) -> list[tuple]:
    """What is told by the messages of a kind, without repetitions."""
    result: list[tuple] = []
    for _, message in said:
        if message.get_type() == kind and (not result or result[-1] != fields(message)):
            result.append(fields(message))
    return result


@pytest.mark.parametrize("kind", TELLS_AGAIN)
def test_it_tells_of_the_same_current_and_reached_items(played, kind):
    name, fake, _ = played
    real = told(said_in_recording(name), kind)
    said = told(said_by(fake), kind)
    if (name, kind) == ("arducopter/clean_then_streams_10hz", "MISSION_CURRENT"):
        # It tells of the growing plan during the upload: which lengths is chance.
        assert [said[0], said[-1]] == [real[0], real[-1]]
        lengths = [dict(values)["total"] for _, values in said]
        assert lengths == sorted(lengths)
        return
    assert said == real, transcript(fake)


def test_its_heartbeats_show_the_same_modes_and_states(played):
    name, fake, _ = played
    real = [(one.time, one.message) for one in recordings.heard(name) if one.direction == "<"]
    said = [(time, message) for time, direction, message in fake.log if direction == "<"]
    assert told(said, "HEARTBEAT") == told(real, "HEARTBEAT")


@pytest.mark.parametrize("name", [name for name in recordings.names()
                                  if name.startswith("px4")])
def test_px4_tells_of_the_current_item_at_the_real_period(name):
    fake, _ = play(name)
    intervals = told_intervals(said_by(fake))
    real = told_intervals(said_in_recording(name))
    assert intervals
    for interval in intervals:
        assert interval == pytest.approx(sorted(real)[len(real) // 2], rel=TOLERANCE)


def told_intervals(said) -> list[float]:
    times = [time for time, message in said if message.get_type() == "MISSION_CURRENT"]
    return [after - before for before, after in pairwise(times)]


# -- what is read back ------------------------------------------------------------------------

RESULTS = {name[len("MAV_MISSION_"):]: value for name, value in vars(mavlink).items()
           if name.startswith("MAV_MISSION_") and isinstance(value, int)
           and not name.startswith("MAV_MISSION_TYPE")}


def item_sent(row) -> Item:
    return Item(int(row["sent_frame"]), int(row["command"]), 0, 1,
                *(float(row[f"sent_p{n}"]) for n in range(1, 5)),
                int(row["sent_x"]), int(row["sent_y"]), float(row["sent_z"]))


def six_digits(value) -> str:
    return f"{float(value):.6g}"


def as_printed(item: Item) -> dict[str, str]:
    return {"read_frame": str(item.frame), "read_command": str(item.command),
            "read_p1": six_digits(item.param1), "read_p2": six_digits(item.param2),
            "read_p3": six_digits(item.param3), "read_p4": six_digits(item.param4),
            "read_x": str(item.x), "read_y": str(item.y), "read_z": six_digits(item.z),
            "read_current": str(item.current), "read_autocontinue": str(item.autocontinue)}


def fake_of(vehicle: str):
    return {"arducopter": lambda: ArduPilot(vehicle="copter"),
            "ardurover": lambda: ArduPilot(vehicle="rover"),
            "px4": lambda: Px4(infeasible_text=False)}[vehicle]()


MISSION_ROWS = [
    pytest.param(vehicle, row, id=f"{vehicle}-line{number}-{row['name']}")
    for vehicle in ("arducopter", "ardurover", "px4")
    for number, row in enumerate(recordings.readback(vehicle), start=2)
    if not row["name"].startswith("type")]


@pytest.mark.parametrize("vehicle, row", MISSION_ROWS)
def test_a_mission_item_is_refused_or_read_back_as_by_the_real_one(vehicle, row):
    around = Item(3, 16, 0, 1, 0.0, 0.0, 0.0, 0.0, -353632620, 1491652370, 20.0)
    client = PlainClient(fake_of(vehicle))
    result = client.upload([around, item_sent(row), around])
    assert result == RESULTS[row["result"]]
    if result == mavlink.MAV_MISSION_ACCEPTED:
        read = client.download()
        assert as_printed(read[1]) == {key: row[key] for key in as_printed(read[1])}
        assert all(a.same_as(b) for a, b in zip(read, client.fake.plan(), strict=True))


@pytest.mark.parametrize("vehicle", ["arducopter", "ardurover", "px4"])
@pytest.mark.parametrize("command, mission_type", [("5001", FENCE), ("5003", FENCE),
                                                   ("5100", RALLY)])
def test_a_fence_or_rally_plan_is_read_back_as_by_the_real_one(vehicle, command, mission_type):
    rows = [row for row in recordings.readback(vehicle) if row["command"] == command]
    client = PlainClient(fake_of(vehicle))
    assert client.upload([item_sent(row) for row in rows],
                         mission_type) == mavlink.MAV_MISSION_ACCEPTED
    for row, read in zip(rows, client.download(mission_type), strict=True):
        assert as_printed(read) == {key: row[key] for key in as_printed(read)}
