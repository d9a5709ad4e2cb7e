"""Plans as files on the firmware: one conversation of each operation with ArduPilot, and the time that a plan takes."""

from __future__ import annotations

import pytest

from areas import FIELD, POINTS
from downloads import WRITTEN, as_ardupilot_has_it, loaded, same
from plans import HOME, OLD_PLAN, SURVEY
from simulation.bench import FunctionPlan, same_bits
from simulation.fake_autopilot.ftp import BURST, CREATE, HEADER, OPEN_RO, READ, TERMINATE, WRITE, Request
from simulation.service import FENCE, HOME_INDEX, MISSION, RALLY

BY_FILE = pytest.mark.scenario(62, "A plan is uploaded, looked for and read as a file", "ArduPilot")
FTP = "FILE_TRANSFER_PROTOCOL"
LIMIT_S = 30
LOOK = [OPEN_RO, READ, BURST, TERMINATE]
BY_ITEMS = ("MISSION_REQUEST_LIST", "MISSION_REQUEST_INT", "MISSION_COUNT", "MISSION_ITEM_INT")


def spoken(service, direction: str = ">") -> list[Request]:
    """The requests of the client, or with "<" the autopilot's answers, as they left."""
    return [Request.of(entry.message) for entry in service.wire.frames(direction, FTP)]


def ended(service, *order) -> tuple[str, list[int]]:
    """How an order ends, and the opcodes of what was asked for. All of it goes by file, which is closed then."""
    before = len(spoken(service))
    assert service.order_of(*order) in ("WaitingForAutopilot", "Transferring")
    status = service.done(LIMIT_S)
    assert service.tell("byfile")[0].split(" ")[2] == "1" and service.heard(*BY_ITEMS) == []
    assert service.autopilot.ftp._type is None, "a file is open"
    return status, [request.opcode for request in spoken(service)[before:]]


@BY_FILE
def test_plan_is_written_looked_for_verified_and_read(build_service):
    service = build_service("ArduPilot", defines={"BENCH_FILES": 1})
    service.autopilot.load(OLD_PLAN)
    service.use(WRITTEN)
    assert ended(service, "fileupload", MISSION) == ("Accepted", [CREATE, WRITE, WRITE, WRITE, TERMINATE, *LOOK])
    kept = [one._replace(param4=0.0 if one.param4 != one.param4 else one.param4) for one in WRITTEN]
    assert same_bits(service.autopilot.received(), [HOME, *as_ardupilot_has_it(kept)])
    assert (service.state.aboard, service.state.done, service.state.total) == ("OurPlan", 8, 8)
    assert ended(service, "fileensure", MISSION) == ("AlreadyAboard", LOOK)
    assert ended(service, "fileverify", MISSION) == ("Verified", LOOK)
    assert ended(service, "filedownload", MISSION, 60, HOME_INDEX - 1) == ("Downloaded", LOOK)
    assert service.sunk == [HOME_INDEX, *range(8)] and same(service.sink(8), WRITTEN)
    loaded(service, [*WRITTEN[:1], WRITTEN[1]._replace(y=85455969), *WRITTEN[2:]])
    assert ended(service, "fileverify", MISSION) == ("Differs", LOOK)
    assert (service.state.failed_item, service.state.field) == (1, "Longitude")
    status, asked = ended(service, "fileensure", MISSION)
    assert status == "Accepted" and asked.index(OPEN_RO) < asked.index(CREATE) and service.state.aboard == "OurPlan"


@BY_FILE
@pytest.mark.parametrize("mission_type, plan", [(FENCE, FIELD), (RALLY, POINTS)], ids=["fence", "rally"])
def test_fence_and_rally_points_have_files_of_their_own(build_service, mission_type, plan):
    service = build_service("ArduPilot", defines={"BENCH_FILES": 1})
    service.use(plan)
    assert ended(service, "fileupload", mission_type)[0] == "Accepted"
    assert same_bits(service.autopilot.missions[mission_type].received, plan)
    assert ended(service, "fileverify", mission_type) == ("Verified", LOOK)


@BY_FILE
def test_ardupilot_that_is_still_starting_has_no_room_and_takes_the_plan_later(build_service):
    """Nor does it open the file; what it says then is said of the items."""
    service = build_service("ArduPilot", defines={"BENCH_FILES": 1}, storage_s=4.0, uptime_s=0.0)
    service.use(SURVEY)
    service.order_of("fileupload", MISSION)
    assert service.done(LIMIT_S) == "NoSpace"
    assert (service.state.aboard, service.now < 4.0) == ("AsBefore", True)
    service.run_until(4.5)
    service.order_of("fileupload", MISSION)
    assert service.done(LIMIT_S) == "Accepted" and service.state.aboard == "OurPlan"


@BY_FILE
def test_plan_is_written_in_little_more_than_the_time_of_its_bytes(build_bench):
    """The goal is 1.25 times that, from CreateFile to the answer to TerminateSession."""
    count = 200
    bench = build_bench("ArduPilot", defines={"BENCH_FILES": 1})
    bench.use(FunctionPlan(count))
    bench.tell("fileupload")
    assert bench.run_until_ended(LIMIT_S) == "Accepted"
    said, answered = (bench.wire.frames(direction, FTP) for direction in "><")
    closed = next(entry.time for entry, answer in zip(answered, spoken(bench, "<"), strict=True)
                  if answer.req_opcode == TERMINATE)  # fmt: skip
    took, bytes_s = closed - said[0].time, (HEADER.size + 38 * (count + 1)) / 5760
    print(f"{count} items: {took:.2f} s, the bytes of the file alone {bytes_s:.2f} s")
    assert took < 1.25 * bytes_s
