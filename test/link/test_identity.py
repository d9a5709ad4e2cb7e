"""Who we are, and whom we talk to, on the simulated Mega. (Whom we hear: test/host/units/identity.cpp and
autopilot_finder.cpp; frames of strangers: test/upload/test_troubles.py.)"""

from __future__ import annotations

import pytest

from plans import SURVEY, on_the_wire
from simulation.bench import FunctionPlan, same_bits
from simulation.fake_autopilot import mavlink
from simulation.peer import heartbeat

# A frame is put off while another is on the line: MISSION_ITEM_INT takes 8.5 ms at 57600 baud.
HEARTBEAT_JITTER_S = 0.011
HEARTBEATS = pytest.mark.scenario(38, "Heartbeats, and finding the autopilot")


@HEARTBEATS
@pytest.mark.parametrize("address", [(1, 1), (42, 1), (255, 200)])
def test_heartbeat_of_a_companion_of_the_autopilot_goes_out_each_second_throughout(make_bench, personality, address):
    bench = make_bench(system_id=address[0], component_id=address[1])
    if personality == "PX4":
        bench.autopilot.address = address
    bench.run(2.0)
    bench.upload(FunctionPlan(250))
    bench.run(18.0)
    assert bench.ends == ["Accepted"] and bench.state.address == address
    times = bench.sent_at("HEARTBEAT")
    assert times == [pytest.approx(times[0] + count, abs=HEARTBEAT_JITTER_S) for count in range(20)]
    message = bench.heard("HEARTBEAT")[0]
    told = (message.type, message.autopilot, message.base_mode, message.custom_mode, message.mavlink_version)
    assert told == (mavlink.MAV_TYPE_ONBOARD_CONTROLLER, mavlink.MAV_AUTOPILOT_INVALID, 0, 0, 3)
    assert message.system_status == mavlink.MAV_STATE_ACTIVE
    assert {(one.get_srcSystem(), one.get_srcComponent()) for one in bench.heard()} == {
        (address[0], mavlink.MAV_COMP_ID_ONBOARD_COMPUTER)
    }
    assert {(one.target_system, one.target_component) for one in bench.mission_messages()} == {address}


@HEARTBEATS
def test_nothing_but_heartbeats_is_sent_before_an_autopilot_is_heard_when_the_ids_are_set(line):
    line.tell("ids", 7, 100)
    line.upload(SURVEY)
    line.run(10)
    sent = [(one.get_type(), one.get_srcSystem(), one.get_srcComponent()) for one in line.heard()]
    assert sent == [("HEARTBEAT", 7, 100)] * 10


@HEARTBEATS
@pytest.mark.parametrize("address", [(2, 1), (1, 2)], ids=["another system", "another component"])
def test_nothing_is_sent_while_two_autopilots_are_heard_and_the_plan_goes_out_when_one_has_gone(
    bench, personality, address
):
    bench.upload(SURVEY)
    bench.run(0.3)
    sent = len(bench.heard())
    for _ in range(5):
        bench.say(heartbeat(), address)
        bench.run(1.0)
    assert len(bench.heard()) == sent and bench.status == "WaitingForAutopilot" and not bench.state.found
    assert bench.run_until_ended(limit_s=8) == "Accepted"
    assert same_bits(bench.autopilot.received(), on_the_wire(SURVEY, personality))
