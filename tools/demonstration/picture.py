"""A timeline as an SVG that is the same to the byte for the same run."""

from __future__ import annotations

import io
import math
import re
from pathlib import Path
from typing import Any

from .timeline import STEPS_S, Burst, Mark, Timeline

COLOURS = {">": "#1f5fa8", "<": "#1b7f4b"}
LOST, AGAIN, OTHER = "#c62828", "#d97706", "#b8b8b8"
NAMES = {">": "Mega → autopilot", "<": "autopilot → Mega"}
Y = {">": 1.0, "<": 0.0}  # where each of the two speaks: the Mega above

WIDTH_IN, HEIGHT_IN = 10.0, 5.6
LEFT, RIGHT, BETWEEN = 0.09, 0.99, 0.045  # of the figure's width
LADDER = (0.50, 0.14)  # bottom and height, of the figure's
USE = (0.09, 0.14)
LABEL_IN = 0.125  # the least distance of two labels
LONGEST_LABEL = 20  # [letters]
TICK_IN = 0.55  # the least distance of two ticks


def draw(timeline: Timeline, file: Path, title: str, verdict: str) -> None:
    """Raises OSError if the file cannot be written."""
    import matplotlib

    # For this picture alone: a process may draw others.
    look: dict[Any, Any] = {"svg.hashsalt": "mavmission", "svg.fonttype": "none", "font.size": 8,
                            "font.sans-serif": ["DejaVu Sans", "Arial"]}  # fmt: skip
    with matplotlib.rc_context(look):
        drawn = svg_of(timeline, title, verdict)
    # A tenth of a point is enough, and the pictures go with each release.
    file.write_text(re.sub(r"\d+\.\d{2,}", lambda number: f"{float(number[0]):.1f}", drawn))


def svg_of(timeline: Timeline, title: str, verdict: str) -> str:
    from matplotlib.backends.backend_svg import FigureCanvasSVG
    from matplotlib.figure import Figure

    figure = Figure(figsize=(WIDTH_IN, HEIGHT_IN))
    FigureCanvasSVG(figure)
    figure.text(LEFT, 0.975, title, size=11, weight="bold", va="top")
    figure.text(LEFT, 0.93, verdict, size=9, va="top")
    places = placed(timeline.bursts)
    for number, (burst, (left, width)) in enumerate(zip(timeline.bursts, places, strict=True)):
        ladder = figure.add_axes((left, LADDER[0], width, LADDER[1]))
        use = figure.add_axes((left, USE[0], width, USE[1]), sharex=ladder)
        draw_ladder(ladder, burst, width * WIDTH_IN)
        draw_use(use, burst, timeline.step_s, width * WIDTH_IN)
        if number == 0:
            ladder.set_yticks((1, 0), ("Mega", "autopilot"), size=9)
            use.set_ylabel(f"% of the line,\neach {1000 * timeline.step_s:g} ms")
        else:
            use.set_yticklabels(())
            silence = burst.began - timeline.bursts[number - 1].ended
            figure.text(left - BETWEEN / 2, LADDER[0] + LADDER[1] / 2, f"{silence:.2f} s of silence",
                        ha="center", va="center", rotation=90, color="#777777")  # fmt: skip
    figure.text((LEFT + RIGHT) / 2, 0.015, "simulated time since power-on [s]", ha="center")
    draw_legend(figure, timeline)
    drawn = io.StringIO()
    figure.savefig(drawn, format="svg", metadata={"Date": None, "Creator": None})
    return drawn.getvalue()


def placed(bursts: list[Burst]) -> list[tuple[float, float]]:
    """Left edge and width of each, in shares of the figure's: as much as its labels need."""
    room = RIGHT - LEFT - BETWEEN * (len(bursts) - 1)
    needs = [burst.labelled + 2 for burst in bursts]
    places, left = [], LEFT
    for need in needs:
        width = room * need / sum(needs)
        places.append((left, width))
        left += width + BETWEEN
    return places


def draw_ladder(axes, burst: Burst, width_in: float) -> None:
    axes.set(xlim=(burst.began, burst.ended), ylim=(0, 1), yticks=())
    for side in ("left", "right"):
        axes.spines[side].set_visible(False)
    for mark in burst.marks:
        draw_mark(axes, mark)
    per_in = (burst.ended - burst.began) / width_in
    for direction in "><":
        for mark in with_room(burst.marks, direction, LABEL_IN * per_in):
            above = direction == ">"
            axes.annotate(worded(mark), (mark.began, Y[direction]), (0, 4 if above else -4),
                          textcoords="offset points", rotation=90, ha="center", va="bottom" if above else "top",
                          color=colour(mark), annotation_clip=False)  # fmt: skip
    axes.tick_params(axis="x", bottom=False, labelbottom=False)


def draw_mark(axes, mark: Mark) -> None:
    start, end = Y[mark.direction], 1 - Y[mark.direction]
    if not mark.label:
        axes.plot((mark.began, mark.ended), (start, end), color=LOST if mark.lost else OTHER, lw=0.7, zorder=1)
    elif mark.lost:
        middle = (mark.began + mark.ended) / 2
        axes.plot((mark.began, middle), (start, 0.5), color=LOST, lw=1.6, ls=(0, (3, 1)))
        axes.plot((middle,), (0.5,), "x", color=LOST, ms=7, mew=2)
    else:
        axes.annotate("", (mark.ended, end), (mark.began, start),
                      arrowprops={"arrowstyle": "-|>", "color": colour(mark), "lw": 1.4, "shrinkA": 0, "shrinkB": 0,
                                  "mutation_scale": 7})  # fmt: skip


def with_room(marks: list[Mark], direction: str, least: float) -> list[Mark]:
    """Those whose labels do not overlap: what was lost or repeated first, then in order of time."""
    chosen: list[Mark] = []
    ours = [mark for mark in marks if mark.direction == direction and mark.label]
    for mark in sorted(ours, key=lambda mark: (not (mark.lost or mark.again), mark.began)):
        if all(abs(mark.began - other.began) >= least for other in chosen):
            chosen.append(mark)
    return sorted(chosen, key=lambda mark: mark.began)


def worded(mark: Mark) -> str:
    what = ", lost" if mark.lost else ", again" if mark.again else ""
    room = LONGEST_LABEL - len(what)
    return (mark.label if len(mark.label) <= room else mark.label[: room - 1] + "…") + what


def colour(mark: Mark) -> str:
    return LOST if mark.lost else AGAIN if mark.again else COLOURS[mark.direction]


def draw_use(axes, burst: Burst, step_s: float, width_in: float) -> None:
    for direction in "><":
        shares = [100 * share for share in burst.use[direction]]
        edges = [burst.began + step * step_s for step in range(len(shares) + 1)]
        axes.stairs(shares, edges, color=COLOURS[direction], lw=1.2)
        axes.stairs(shares, edges, color=COLOURS[direction], alpha=0.15, fill=True)
    axes.set(xlim=(burst.began, burst.ended), ylim=(0, 105), yticks=(0, 50, 100))
    axes.grid(alpha=0.3)
    axes.set_xticks(*ticks(burst, max(1, int(width_in / TICK_IN))))


def ticks(burst: Burst, most: int) -> tuple[list[float], list[str]]:
    """Round times within the burst and their words, as close as there is room for; its beginning if none is round."""
    for step in STEPS_S:
        times = [number * step for number in range(math.ceil(burst.began / step), math.floor(burst.ended / step) + 1)]
        if len(times) <= most:
            break
    times = times or [burst.began]
    decimals = max(0, -math.floor(math.log10(step) + 1e-9))
    return times, [f"{time:.{decimals}f}" for time in times]


def draw_legend(figure, timeline: Timeline) -> None:
    from matplotlib.lines import Line2D

    lines = [Line2D((), (), color=COLOURS[way], lw=1.6,
                    label=f"{NAMES[way]}: {100 * timeline.share[way]:.1f} % of the line")
             for way in "><"]  # fmt: skip
    lines += [Line2D((), (), color=AGAIN, lw=1.6, label="said again"),
              Line2D((), (), color=LOST, lw=1.6, ls=(0, (3, 1)), marker="x", label="lost"),
              Line2D((), (), color=OTHER, lw=0.7, label="heartbeats, telemetry")]  # fmt: skip
    figure.legend(handles=lines, loc="upper left", bbox_to_anchor=(LEFT - 0.008, 0.905), ncols=5, frameon=False,
                  handlelength=1.8, borderpad=0)  # fmt: skip
