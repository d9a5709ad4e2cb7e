"""The memory of a sketch that uses the whole service: a canary below the stack, and nothing that grows with use.

To simulate each millisecond of a day would take five minutes; here the firmware's clock jumps between the rounds of
operations, as if loop() had stood still, so that they are spread over a day in which millis() wraps. test_day.py lives
through every millisecond, on the computer.
"""

from __future__ import annotations

from plans import SURVEY, waypoint
from simulation.service import MISSION

CANARY = 0xA5
ROUNDS = 60  # of four operations
DAY_MS = 24 * 3600 * 1000
OTHER = [waypoint(), *SURVEY]


def go_round(service, plan) -> None:
    """Each of the transfers once."""
    service.upload(plan, proof="Always")
    assert service.done() == "Accepted"
    service.verify(plan)
    assert service.done() == "Verified"
    service.download()
    assert service.done() == "Downloaded"
    service.order_of("clear", MISSION)
    assert service.done() == "Cleared"


def test_stack_keeps_off_a_canary_and_does_not_grow_with_use(service):
    mega = service.mega
    for plan in (SURVEY, OTHER):
        go_round(service, plan)
    depth = mega.deepest_stack
    below = mega.address("_end")  # the first byte behind the globals; there is no heap
    free = mega.ram_end + 1 - depth - below
    assert free > 1000, "there is nothing between them to watch"
    mega.poke(below, bytes((CANARY,)) * free)
    for turn in range(ROUNDS):
        service.set_millis(2**32 - DAY_MS // 2 + turn * DAY_MS // (ROUNDS - 1))
        go_round(service, (SURVEY, OTHER)[turn % 2])
    touched = [below + place for place, byte in enumerate(mega.peek(below, free)) if byte != CANARY]
    # An interrupt may come one call deeper than it did in the first rounds.
    assert mega.deepest_stack <= depth + 40
    assert all(address >= mega.ram_end + 1 - depth - 40 for address in touched)
