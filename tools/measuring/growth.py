"""How the cost of an upload at 57600 baud grows with its plan: RAM does not, time does."""

from __future__ import annotations

from .calls import Caller
from .record import Section
from .report import aligned, rounded
from .runs import HZ, upload_of

PLANS = (10, 100, 1_000, 10_000)


def costs(plans: tuple[int, ...] = PLANS) -> Section:
    """Of plans of so many items: globals and the stack of update(), interrupts apart [bytes], and the upload [s]."""
    return {str(items): {"ram": ram_for(items), "seconds": round(upload_of(items).cycles / HZ, 2)} for items in plans}


def ram_for(items: int) -> int:
    caller = Caller("px4", items)
    return caller.mega.globals_bytes + caller.upload()


def table(costs: Section) -> str:
    lines = [["items", "RAM [bytes]", "time [s]", "time per item [ms]"]]
    lines += [[f"{int(items):,}", rounded(cost["ram"]), f"{cost['seconds']:.1f}",
               f"{1000 * cost['seconds'] / int(items):.1f}"] for items, cost in costs.items()]  # fmt: skip
    return aligned(lines, left=0)
