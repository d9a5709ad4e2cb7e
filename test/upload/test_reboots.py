"""Either side is switched off and on, or the cable between them pulled and put back, at each point of an upload."""

from __future__ import annotations

import pytest

from plans import OLD_PLAN, SURVEY, on_the_wire, waypoint
from simulation.bench import FunctionPlan, same_bits
from truth import LOOP_S, expect_truth, longest_s

OTHER = [waypoint(470000000 + 7 * n, 80000000, 40.0 + n) for n in range(4)]
ALL_SENT = "all"  # items sent; the final ACK not heard

RESET = pytest.mark.scenario(23, "The Arduino was reset in mid-upload")

# From a reset: two heartbeats and what makes sure of the autopilot (2.3 s), then a quick transfer.
RESTARTED_S = 2.8


def go_to(bench, personality: str, items: int | str, plan=SURVEY) -> None:
    """Begin an upload, and go on until so many items of it have left; -1: until its COUNT has."""
    if items == ALL_SENT:
        bench.autopilot.faults.swallow_final_ack()
        items = len(on_the_wire(plan, personality))
    bench.autopilot.load(OLD_PLAN)
    bench.upload(plan)
    if items == -1:
        bench.run_until_sent("MISSION_COUNT")
    elif items:
        bench.run_until_sent("MISSION_ITEM_INT", items)
    else:
        bench.run_until_sent("MISSION_COUNT")
        bench.run(0.009)  # the request for item 0 has been heard


def uploaded_after_reset(bench, plan, personality: str) -> float:
    """Reset, upload to the end; how long that took [s]."""
    began = bench.now
    bench.reset()
    bench.upload(plan)
    assert bench.run_until_ended(limit_s=30) == "Accepted"
    assert same_bits(bench.autopilot.received(), on_the_wire(plan, personality))
    assert bench.state.aboard == "OurPlan"
    return bench.now - began


@RESET
@pytest.mark.parametrize("items", [-1, 0, 1, 2, 3, 4, ALL_SENT])
def test_upload_after_a_reset_in_mid_upload_waits_for_no_time_out(bench, personality, items):
    """The same plan again, as from setup()."""
    go_to(bench, personality, items)
    assert uploaded_after_reset(bench, SURVEY, personality) < RESTARTED_S


@RESET
@pytest.mark.slow
@pytest.mark.parametrize("part", range(5))
def test_reset_at_any_millisecond_of_an_upload_is_survived(build_bench, personality, part):
    """Frames are cut short by it, too."""
    for ms in range(part, 130, 5):
        bench = build_bench(personality)
        bench.autopilot.load(OLD_PLAN)
        bench.upload(SURVEY)
        bench.run_until_sent("MISSION_COUNT")
        bench.run(ms / 1000)
        # Resets again in the next transfer, as a brown-out does.
        bench.reset()
        bench.upload(SURVEY)
        bench.run(1.3 + ms / 1000)
        assert uploaded_after_reset(bench, SURVEY, personality) < RESTARTED_S, ms


REBOOT = pytest.mark.scenario(39, "The autopilot reboots in mid-transfer")


@REBOOT
@pytest.mark.parametrize("silent_s", [3.0, *(pytest.param(s, marks=pytest.mark.slow) for s in (0.05, 12.0))])
@pytest.mark.parametrize("items", [-1, 0, 1, 3, ALL_SENT])
def test_autopilot_that_reboots_ends_the_upload_truthfully_and_takes_the_next_one(bench, personality, items, silent_s):
    go_to(bench, personality, items)
    bench.autopilot.reboot(bench.now, silent_for_s=silent_s)
    bench.run_until_ended(limit_s=30)
    status = expect_truth(bench, SURVEY, personality)
    # A COUNT that was not answered goes out again, and may be heard after the reboot.
    if items in (-1, 0) and silent_s < 12:
        assert status in ("Accepted", "TimedOut")
    elif items == ALL_SENT:
        assert status in ("Accepted", "Unconfirmed")
    else:
        assert status in ("TimedOut", "NoAnswer")
    assert bench.now - bench.sent_at("MISSION_COUNT")[0] <= longest_s(len(on_the_wire(SURVEY, personality)))
    bench.upload(OTHER)
    assert bench.run_until_ended(limit_s=30) == "Accepted"
    assert same_bits(bench.autopilot.received(), on_the_wire(OTHER, personality))


@REBOOT
def test_autopilot_that_greets_with_text_when_it_starts_is_found(make_bench, personality):
    bench = make_bench(boot_text=b"\r\n\r\nInit ArduCopter V4.6.3\r\n\r\nFree RAM: 262144\r\n", uptime_s=0.0)
    bench.upload(SURVEY)
    assert bench.run_until_ended(limit_s=10) == "Accepted"
    bench.autopilot.reboot(bench.now)
    bench.run(6)
    bench.upload(OTHER)
    assert bench.run_until_ended(limit_s=10) == "Accepted"
    assert same_bits(bench.autopilot.received(), on_the_wire(OTHER, personality))


@REBOOT
def test_autopilot_that_appears_30_s_late_gets_its_plan_and_heard_nothing_before(make_bench, personality):
    tells = {"tells_at_s": 30.5} if personality == "PX4" else {}
    bench = make_bench(heartbeat_at_s=30.0, **tells)
    bench.upload(SURVEY)
    bench.run_until(29.9)
    assert bench.heard() == []
    assert bench.status == "WaitingForAutopilot"
    assert bench.run_until_ended(limit_s=10) == "Accepted"
    assert bench.now < 30.0 + 1.5
    expect_truth(bench, SURVEY, personality)


CABLE = pytest.mark.scenario(39, "The cable is pulled and put back")


@CABLE
@pytest.mark.parametrize("way", [None, "<", ">"], ids=["both ways", "to us", "to the autopilot"])
@pytest.mark.parametrize("pulled_s", [2.0, 7.5, *(pytest.param(s, marks=pytest.mark.slow) for s in (0.3, 4.5, 20.0))])
@pytest.mark.parametrize("items", [-1, 2, ALL_SENT])
def test_pulled_cable_ends_truthfully_and_the_next_upload_is_accepted(bench, personality, items, pulled_s, way):
    bench.autopilot.load(OLD_PLAN)
    wire_count = len(on_the_wire(SURVEY, personality))
    bench.upload(SURVEY)
    if items == -1:
        bench.run_until_sent("MISSION_COUNT")
    else:
        bench.run_until_sent("MISSION_ITEM_INT", wire_count if items == ALL_SENT else items)
    bench.wire.pull(way)
    bench.run(pulled_s)
    bench.wire.plug(way)
    bench.run_until_ended(limit_s=30)
    status = expect_truth(bench, SURVEY, personality)
    # PX4 gives up after 5 s, ArduPilot after 8 s.
    gives_up_s = 8.0 if personality == "ArduPilot" else 5.0
    if pulled_s + 0.5 < gives_up_s and items != ALL_SENT:
        assert status == "Accepted"
    assert bench.now - bench.sent_at("MISSION_COUNT")[0] <= longest_s(wire_count)
    bench.upload(OTHER)
    assert bench.run_until_ended(limit_s=40) == "Accepted"
    assert same_bits(bench.autopilot.received(), on_the_wire(OTHER, personality))


@CABLE
def test_loose_contact_in_a_long_upload_is_survived(bench, personality):
    """Both ways, for half a second of each two."""
    plan = FunctionPlan(60)
    bench.autopilot.load(OLD_PLAN)
    bench.wire.delay("<", 0.15, name="MISSION_REQUEST*", times=None)  # some 10 s
    bench.upload(plan)
    while not bench.ends:
        bench.run(1.5)
        bench.wire.pull()
        bench.run(0.5)
        bench.wire.plug()
        assert bench.now < 60
    assert bench.run_until_ended(limit_s=LOOP_S) == "Accepted"
    expect_truth(bench, plan, personality)
