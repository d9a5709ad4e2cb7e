"""How the cost of an upload grows with its plan: RAM and time, and a picture of both."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

from building import ROOT

from .calls import Caller
from .report import aligned
from .runs import HZ, upload_of

PLANS = (10, 100, 1_000, 10_000)
PICTURE = ROOT / "docs" / "cost.svg"


class Cost(NamedTuple):
    """Of a plan of so many items at 57600 baud."""

    items: int
    ram: int  # globals and the stack of update(), interrupts apart [bytes]
    seconds: float


def costs(plans: tuple[int, ...] = PLANS) -> list[Cost]:
    return [Cost(items, ram_for(items), upload_of(items).cycles / HZ) for items in plans]


def ram_for(items: int) -> int:
    caller = Caller("px4", items)
    return caller.mega.globals_bytes + caller.upload()


def table(measured: list[Cost]) -> str:
    lines = [["items", "RAM [bytes]", "time [s]", "time per item [ms]"]]
    for cost in measured:
        lines.append(
            [f"{cost.items:,}", f"{cost.ram:,}", f"{cost.seconds:.2f}", f"{1000 * cost.seconds / cost.items:.2f}"]
        )
    return aligned(lines, left=0)


def draw(measured: list[Cost], file: Path = PICTURE) -> None:
    """An SVG that is the same to the byte for the same figures."""
    import matplotlib

    matplotlib.use("svg")
    matplotlib.rcParams.update({"svg.hashsalt": "mavmission", "svg.fonttype": "none", "font.size": 10,
                                "font.sans-serif": ["DejaVu Sans", "Arial"]})  # fmt: skip
    from matplotlib import pyplot

    items = [cost.items for cost in measured]
    figure, (ram, seconds) = pyplot.subplots(1, 2, figsize=(8, 3), layout="constrained")
    ram.plot(items, [cost.ram for cost in measured], "o-")
    ram.set(
        xscale="log", xlabel="items", ylabel="globals and stack [bytes]", ylim=(0, 8192), title="RAM, of a Mega's 8,192"
    )
    seconds.plot(items, [cost.seconds for cost in measured], "o-")
    seconds.set(
        xscale="log", yscale="log", xlabel="items", ylabel="time of the upload [s]", title="time, at 57600 baud"
    )
    for axes in (ram, seconds):
        axes.grid(alpha=0.3)
    file.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(file, format="svg", metadata={"Date": None, "Creator": None})
    pyplot.close(figure)
