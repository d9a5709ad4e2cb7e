"""What docs/autopilots.md says of ArduPilot, of PX4 and of MAVLink 1 is what the firmware does there.

A proof is a function of an autopilot and a MAVLink version: it lets the firmware do on a bench what the row names,
and returns the words that the cell must then have.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from itertools import dropwhile, takewhile

import pytest

from areas import FIELD, POINTS
from building import ROOT
from downloads import WRITTEN, same
from parts import NEW, OLD
from plans import OLD_PLAN, SURVEY, on_the_wire, waypoint
from simulation.bench import same_bits, status_names
from simulation.parameters import ParameterBench
from simulation.service import FENCE, MISSION, RALLY, Service
from simulation.steered import bits as float_bits
from simulation.vehicle import LISTENERS, VehicleBench
from starts import HOPS, LANDING_FIRST, is_flying, uploaded

# Column: the fake autopilot there, and its options. PX4 is not asked to speak MAVLink 1: it answers in 2.
COLUMNS = {
    "ArduPilot": ("ArduPilot", {}),
    "PX4": ("PX4", {}),
    "ArduPilot over MAVLink 1": ("ArduPilot", {"mavlink_version": 1}),
}
Make = Callable[..., Service]


def read_table(page: str) -> dict[str, dict[str, str]]:
    """Row -> column -> cell."""
    lines = dropwhile(lambda line: line != f"| | {' | '.join(COLUMNS)} |", page.splitlines())
    head, _, *rows = [[cell.strip() for cell in line.strip("|").split("|")]
                      for line in takewhile(lambda line: line.startswith("|"), lines)] or [[], []]  # fmt: skip
    return {row[0]: dict(zip(head[1:], row[1:], strict=True)) for row in rows}


class Refused(Exception):
    """It is not done there; the words of the cell that says so."""


def expect(ended: str, status: str) -> None:
    if ended != status:
        raise Refused(f"no: `{ended}`")


def whole_service(make: Make, personality: str) -> str:
    """A plan goes up, is verified, comes back as it was, and is taken away."""
    service = make()
    service.autopilot.load(OLD_PLAN)
    service.upload(WRITTEN)
    expect(service.done(limit_s=20), "Accepted")
    service.verify(WRITTEN)
    expect(service.done(), "Verified")
    service.download()
    expect(service.done(), "Downloaded")
    assert same(service.sink(len(WRITTEN)), WRITTEN)
    service.order_of("clear", MISSION)
    expect(service.done(), "Cleared")
    return "yes" if len(service.autopilot.plan()) <= 1 else "no"  # ArduPilot keeps home


LEFTOVERS_S = 10.5  # MissionClient::kLeftoversMs


def proof_of_a_lost_answer(make: Make, personality: str) -> str:
    service = make()
    service.autopilot.load(OLD_PLAN)
    service.autopilot.faults.swallow_final_ack()
    service.run(LEFTOVERS_S)  # before that PX4's answer may be to an upload from before a reset, and is read back too
    service.upload(SURVEY, proof="InDoubt")
    expect(service.done(limit_s=30), "Accepted")
    assert same_bits(service.autopilot.received(), on_the_wire(SURVEY, personality))
    if service.heard("MISSION_REQUEST_LIST"):
        return "read back"
    answers = [entry.message for entry in service.wire.frames("<", "MISSION_ACK")]
    return "checksum in the answer" if answers[-1].opaque_id else "no proof"


def plan_that_is_there(make: Make, personality: str) -> str:
    """How ensure() finds that nothing has to be uploaded; and that something has, where another plan is aboard."""
    service = make()
    service.autopilot.load(on_the_wire(SURVEY, personality))
    service.ensure(SURVEY)
    expect(service.done(limit_s=30), "AlreadyAboard")
    found = "by reading" if service.heard("MISSION_REQUEST_INT") else "by its checksum"
    assert service.heard("MISSION_COUNT") == []
    service.autopilot.load(OLD_PLAN)
    service.ensure(SURVEY)
    expect(service.done(limit_s=30), "Accepted")
    assert same_bits(service.autopilot.received(), on_the_wire(SURVEY, personality))
    return found


def upload_that_breaks_off(make: Make, personality: str) -> str:
    """What is aboard when the cable is pulled in the middle of an upload by PlanFiles, and what aboard() says."""
    service = make(defines={"BENCH_FILES": 1})
    service.autopilot.load(OLD_PLAN)
    before = service.autopilot.received()
    service.use(SURVEY * 10)
    service.order_of("fileupload", MISSION)
    limit = service.now + 5.0
    while not service.heard("MISSION_ITEM_INT") and len(service.heard("FILE_TRANSFER_PROTOCOL")) < 4:
        assert service.now < limit, "nothing ended within 5 s: nothing was sent"
        service.run(0.01)
    service.wire.pull()
    assert service.done(limit_s=30) != "Accepted"
    is_old = same_bits(service.autopilot.received(), before)
    return "yes" if is_old and service.state.aboard == "AsBefore" else "no"


def somebody_elses_plan(make: Make, personality: str) -> str:
    """aboard(), when another station has put a longer plan there."""
    service = uploaded(make(), HOPS[personality])
    service.run(5.0)
    assert service.state.aboard == "OurPlan"
    service.autopilot.load([*on_the_wire(HOPS[personality], personality), waypoint()])
    service.run(5.0)
    return "yes" if service.state.aboard == "OtherPlan" and not service.followed.ours else "no"


def fence_and_rally(make: Make, personality: str) -> str:
    service = make()
    ends = set()
    for mission_type, plan in ((FENCE, FIELD), (RALLY, POINTS)):
        service.upload(plan, mission_type)
        ends.add(service.done())
        if ends == {"Accepted"}:
            assert same_bits(service.autopilot.received(mission_type), plan)
            service.verify(plan, mission_type)
            assert service.done() == "Verified"
        else:
            assert service.mission_messages() == []
    expect(" or ".join(ends), "Accepted")
    return "yes"


def part(make: Make, personality: str) -> str:
    service = make()
    service.upload(OLD)
    assert service.done() == "Accepted"
    before = service.autopilot.received()
    plan = [*OLD[:2], *NEW[2:5], *OLD[5:]]
    service.upload_part(plan, 2, 3)
    ended = service.done()
    assert ended == "Accepted" or same_bits(service.autopilot.received(), before)
    expect(ended, "Accepted")
    return "yes" if same_bits(service.autopilot.received(), on_the_wire(plan, personality)) else "no"


def flying(make: Make, personality: str) -> str:
    """Every order of the row, then start() on the ground."""
    service = uploaded(make(), HOPS[personality])
    for order in (("mode", 3), ("arm",), ("setcurrent", 1), ("disarm",), ("setcurrent", 0), ("start",)):
        service.order_of(*order)
        expect(service.done(), "Done")
        service.run(1.5)  # a heartbeat says whether it is armed
        assert order != ("arm",) or service.state.armed
        assert order != ("mode", 3) or "Hold" in service.state.modes
    return "yes" if is_flying(service) else "no"


def followed(make: Make, personality: str) -> str:
    service = uploaded(make(), HOPS[personality])
    service.order_of("start")
    expect(service.done(), "Done")
    limit = service.now + 200.0
    while service.autopilot.armed:
        assert service.now < limit, f"it still flies item {service.autopilot.flight.index}"
        service.run(0.5)
    service.run(3.0)
    # ArduCopter disarms at the end of its landing, and does not call that reached.
    is_told = service.reached == [0, 1, 2][: 3 if personality == "PX4" else 2] and 2 in service.currents
    return "yes" if is_told else f"current {service.currents}, reached {service.reached}"


def infeasible(make: Make, personality: str) -> str:
    service = uploaded(make(), LANDING_FIRST)
    before = len(service.ends)
    service.run(6.0)
    later = service.ends[before:]
    return f"`{later[0]}`" if later else "-"


def quiet_transfers(make: Make, personality: str) -> str:
    """A full line is silent at the end of a transfer, and full again soon after it."""
    service = make(telemetry=5000.0, defines={"BENCH_QUIET": 1})
    service.upload([waypoint(473977420 + 100 * n) for n in range(50)])
    expect(service.done(limit_s=20), "Accepted")
    end = service.now
    service.run(3.0)
    heard = [entry.time for entry in service.wire.frames("<", "ATTITUDE")]
    silent = not any(end - 0.3 <= time < end for time in heard)
    return "yes" if silent and any(time > end + 2.5 for time in heard) else "no"


def flown_without_a_plan(make: Make, personality: str) -> str:
    """It takes off, goes to a place, and is there."""
    service = make(defines={"BENCH_STEERING": True})
    lat, lon = service.autopilot.flight.home[:2]
    for order in (("takeoff", float_bits(8.0)), ("goTo", (lat + 2000) % 2**32, lon, float_bits(9.0), 3)):
        service.order_of(*order)
        expect(service.done(limit_s=30), "Done")
    service.run(40.0)
    where = service.autopilot.flight.where(service.now)
    return "yes" if abs(where.lat_e7 - lat - 2000) < 20 and abs(where.height - 9.0) < 0.1 else "no"


def target_that_moves(make: Make, personality: str) -> str:
    """It follows a target, and stays where it is when the target is renewed no more."""
    service = make(defines={"BENCH_STEERING": True, "BENCH_TARGET": True})
    lat, lon = service.autopilot.flight.home[:2]
    service.order_of("takeoff", float_bits(8.0))
    expect(service.done(limit_s=30), "Done")
    service.run(15.0)
    service.tell("renewing", 100)
    service.order_of("follow", (lat + 2000) % 2**32, lon, float_bits(9.0), 3)
    expect(service.done(limit_s=30), "Done")
    service.run(20.0)
    where = service.autopilot.flight.where(service.now)
    service.tell("renewing", 0)
    service.run(8.0)
    has_held = status_names()[int(service.tell("target")[0].split(" ")[2])] == "NotRenewed"
    is_there = abs(where.lat_e7 - lat - 2000) < 20 and abs(where.height - 9.0) < 0.1
    return "yes" if has_held and is_there and service.autopilot.flight.airborne(service.now) else "no"


def velocity(make: Make, personality: str) -> str:
    """It flies at a velocity, and stands when that is renewed no more."""
    service = make(defines={"BENCH_STEERING": True, "BENCH_VELOCITY": True})
    flight = service.autopilot.flight
    service.order_of("takeoff", float_bits(8.0))
    expect(service.done(limit_s=30), "Done")
    service.run(15.0)
    service.tell("flying", 100)
    service.order_of("fly", float_bits(2.0), *[float_bits(0.0)] * 3)
    expect(service.done(limit_s=30), "Done")
    service.run(10.0)
    flown_m = flight.where(service.now).distance(flight.home._replace(height=8.0))
    service.tell("flying", 0)
    service.run(12.0)
    has_held = status_names()[int(service.tell("flown")[0].split(" ")[2])] == "NotRenewed"
    return "yes" if has_held and 18 < flown_m < 24 and flight.airborne(service.now) else "no"


def telemetry(make: Make, personality: str) -> str:
    """Each listener has its interval confirmed, and then hears its message."""
    bench = make(kind=VehicleBench)
    bench.autopilot.instruments.rc = [1500] * 8
    bench.run_until_confirmed(*LISTENERS)
    bench.run(6.0)
    return "yes" if bench.heard_all(*LISTENERS) else "no"


def parameters(make: Make, personality: str) -> str:
    """A number and a whole number are read, and set to something else."""
    bench = make(kind=ParameterBench)
    known = bench.autopilot.parameters.all
    names = {"ArduPilot": ("WPNAV_SPEED", "SERIAL1_BAUD"), "PX4": ("MIS_TAKEOFF_ALT", "SER_TEL1_BAUD")}
    number, whole = names[personality]
    for name in (number, whole):
        expect(bench.read(name), "Done")
        assert bench.value[0] == known[name].value
    expect(bench.set(number, 3.25), "Done")
    expect(bench.set_whole(whole, 115), "Done")
    return "yes" if (known[number].value, known[whole].value) == (3.25, 115) else "no"


PROOFS: dict[str, Callable[[Make, str], str]] = {
    "upload, download, verify, clear a mission": whole_service,
    "proof of an upload whose last answer was lost": proof_of_a_lost_answer,
    "a plan that is aboard already is found, and not uploaded again (`ensure()`)": plan_that_is_there,
    "after an upload that breaks off the old plan is still aboard (`PlanFiles`)": upload_that_breaks_off,
    "a longer plan that another ground station uploads is detected (`MissionFollower`)": somebody_elses_plan,
    "fence and rally points": fence_and_rally,
    "upload of a part of the plan": part,
    "start, arm, modes, current item": flying,
    "current item and items reached": followed,
    "flight without a plan (`Steering`)": flown_without_a_plan,
    "a moving target is followed; at the end the aircraft holds (`MovingTarget`)": target_that_moves,
    "velocities are flown; at the end the aircraft holds (`VelocityTarget`)": velocity,
    "telemetry, at an interval that is confirmed (`PositionListener` and others)": telemetry,
    "parameters read and set (`Parameters`)": parameters,
    "a plan found infeasible after it was accepted": infeasible,
    "telemetry silent during transfers (`TelemetryPause`)": quiet_transfers,
}


TABLE = read_table((ROOT / "docs" / "autopilots.md").read_text())


def test_each_row_has_its_proof_and_each_proof_its_row():
    assert list(TABLE) == list(PROOFS)
    assert all(list(columns) == list(COLUMNS) and all(columns.values()) for columns in TABLE.values())


@pytest.mark.slow
@pytest.mark.parametrize(
    ("row", "column", "words"),
    [(row, column, re.sub(r"\s+", " ", cell)) for row, cells in TABLE.items() for column, cell in cells.items()],
)
def test_cell_says_what_the_firmware_does(build_service, row, column, words):
    personality, options = COLUMNS[column]
    try:
        found = PROOFS[row](lambda **more: build_service(personality, **options, **more), personality)
    except Refused as refused:
        found = str(refused)
    assert found == words
