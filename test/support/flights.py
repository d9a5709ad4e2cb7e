"""What the tests that fly a plan to its end share."""

from __future__ import annotations

from starts import uploaded


def flies_px4(service) -> bool:
    return hasattr(service.autopilot, "main_mode")


def reached_in(service, *items: int) -> list[int]:
    """Of items that end in a landing: ArduCopter disarms at the end of that, and does not call it reached."""
    return list(items) if flies_px4(service) else list(items[:-1])


def started(service, plan=None):
    uploaded(service, plan)
    service.order_of("start")
    assert service.done() == "Done"
    return service


def fly(service, limit_s: float = 200.0) -> None:
    """To the end, and a little more."""
    limit = service.now + limit_s
    while service.autopilot.armed:
        assert service.now < limit, f"it still flies item {service.autopilot.flight.index}"
        service.run(0.5)
    service.run(3.0)
