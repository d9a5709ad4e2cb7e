"""What the tests of plans as files share: a bench whose sketch has PlanFiles, and what went over its line.

service = with_files(build_service)
service.use(plan)
service.order_of("fileverify", MISSION)
requests(service)                      # [OPEN_RO, READ, BURST, TERMINATE]
"""

from __future__ import annotations

from simulation.fake_autopilot import mavlink
from simulation.fake_autopilot.ftp import OPEN_RO, Request
from simulation.service import Service

FTP = "FILE_TRANSFER_PROTOCOL"
BY_ITEMS = ("MISSION_REQUEST_LIST", "MISSION_REQUEST_INT", "MISSION_COUNT", "MISSION_ITEM_INT")
OTHER = (254, 190)  # another client


def with_files(build_service, personality: str = "ArduPilot", **options) -> Service:
    return build_service(personality, defines={"BENCH_FILES": 1}, **options)


def spoken(service, direction: str = ">") -> list[Request]:
    """The requests of the client, or with "<" the autopilot's answers, as they left."""
    return [Request.of(entry.message) for entry in service.wire.frames(direction, FTP)]


def requests(service) -> list[int]:
    """The opcodes of the client's requests."""
    return [request.opcode for request in spoken(service)]


def is_by_file(service) -> bool:
    (line,) = service.tell("byfile")
    return line.split(" ")[2] == "1"


def by_items(service) -> list[str]:
    """What the client has sent of the mission protocol."""
    return [message.get_type() for message in service.heard(*BY_ITEMS)]


def open_file(service) -> bytes | None:
    """What is in the file that is open, or None."""
    ftp = service.autopilot.ftp
    return None if ftp._type is None else bytes(ftp._data)


def other_asks(service, opcode: int, session: int, seq: int, data: bytes = b"", offset: int = 0) -> None:
    """A request by another client, on another link."""
    request = Request(seq, session, opcode, len(data), 0, 0, offset, data)
    message = mavlink.MAVLink_file_transfer_protocol_message(0, 1, 1, list(request.packed()))
    service.autopilot.ftp.hear(message, OTHER, service.now)


def other_opens(service, session: int = 7, opcode: int = OPEN_RO) -> None:
    other_asks(service, opcode, session, 1, b"@MISSION/mission.dat")
