"""A plan drawn: the map from above, and the height along the way."""

from __future__ import annotations

import math
from pathlib import Path

import matplotlib

matplotlib.use("Agg")

from matplotlib import pyplot  # noqa: E402
from matplotlib.patches import Circle, Polygon  # noqa: E402

from .bad_plan import BadPlan  # noqa: E402
from .flight import EARTH_RADIUS, Speeds, fly, is_flown_to  # noqa: E402
from .plan import CIRCLE_INSIDE, CIRCLES, CORNER_INSIDE, CORNERS, Item, Plan  # noqa: E402

SUFFIXES = (".svg", ".png")
PATH, INSIDE, OUTSIDE, RALLY, HOME = "#1f5fa8", "#2e8b57", "#c0392b", "#8e44ad", "#222222"
MOST_NUMBERS = 60  # more would hide the way


def draw(plan: Plan, file: Path, speeds: Speeds) -> None:
    """Writes the drawing: equal for equal plans. Raises BadPlan."""
    if file.suffix.lower() not in SUFFIXES:
        raise BadPlan(file, None, f"a drawing is written as {' or '.join(SUFFIXES)}")
    around = [
        (item.x, item.y)
        for kind in plan.kinds
        for item in plan.items(kind)
        if (item.x, item.y) != (0, 0) and item.frame != 2
    ]
    if plan.home is not None:
        around.append((plan.home.x, plan.home.y))
    if not around:
        raise BadPlan(plan.file, None, "it has no places: there is nothing to draw")
    with matplotlib.rc_context({"svg.hashsalt": "plan", "svg.fonttype": "path", "font.size": 9, "figure.dpi": 100}):
        figure, (above, height) = pyplot.subplots(2, 1, figsize=(8, 9), height_ratios=(3, 1), layout="constrained")
        try:
            _Map(above, around[-1] if plan.home is not None else around[0]).draw(plan)
            _height(height, plan, speeds)
            figure.savefig(file, metadata={"Date": None} if file.suffix.lower() == ".svg" else {"Software": None})
        except OSError as error:
            raise BadPlan(file, None, f"cannot be written: {error.strerror}") from None
        finally:
            pyplot.close(figure)


class _Map:
    """East and north of a place, in metres."""

    def __init__(self, axes, origin: tuple[int, int]) -> None:
        self._axes, self._origin = axes, origin
        self._east_scale = math.cos(math.radians(origin[0] / 1e7))

    def _metres(self, item: Item) -> tuple[float, float]:
        east = (item.y - self._origin[1] + 1_800_000_000) % 3_600_000_000 - 1_800_000_000  # across the date line
        return (
            math.radians(east / 1e7) * EARTH_RADIUS * self._east_scale,
            math.radians((item.x - self._origin[0]) / 1e7) * EARTH_RADIUS,
        )

    def draw(self, plan: Plan) -> None:
        axes = self._axes
        self._fence(plan)
        self._way(plan)
        for number, item in enumerate(plan.items("rally")):
            axes.plot(
                *self._metres(item),
                marker="^",
                color=RALLY,
                linestyle="none",
                label="rally point" if not number else None,
            )
        if plan.home is not None:
            axes.plot(0, 0, marker="*", markersize=12, color=HOME, linestyle="none", label="home, as it was planned")
        axes.set_aspect("equal", adjustable="datalim")
        axes.set(xlabel="east [m]", ylabel="north [m]", title=plan.file.name)
        axes.grid(alpha=0.3)
        axes.margins(0.08)
        axes.legend(loc="best", fontsize=8)

    def _way(self, plan: Plan) -> None:
        flown = [(number, item) for number, item in enumerate(plan.items()) if is_flown_to(item)]
        if not flown:
            return
        points = [self._metres(item) for _, item in flown]
        self._axes.plot(*zip(*points), color=PATH, marker="o", markersize=4, linewidth=1.4, label="mission")
        every = math.ceil(len(points) / MOST_NUMBERS)
        for (number, _), point in list(zip(flown, points))[::every]:
            self._axes.annotate(str(number), point, textcoords="offset points", xytext=(4, 3), color=PATH, fontsize=7)

    def _fence(self, plan: Plan) -> None:
        items = plan.items("fence")
        labelled: set[str] = set()
        index = 0
        while index < len(items):
            item = items[index]
            inside = item.command in (CORNER_INSIDE, CIRCLE_INSIDE)
            look = {
                "fill": not inside,
                "alpha": 1.0 if inside else 0.25,
                "color": INSIDE if inside else OUTSIDE,
                "linewidth": 1.5,
            }
            name = "must not leave" if inside else "must not enter"
            label = None if name in labelled else name
            if item.command in CORNERS:
                count = max(int(item.param1), 1)
                corners = [self._metres(corner) for corner in items[index : index + count]]
                self._axes.add_patch(Polygon(corners, closed=True, label=label, **look))
                index += count - 1
            elif item.command in CIRCLES:
                self._axes.add_patch(Circle(self._metres(item), item.param1, label=label, **look))
            else:
                self._axes.plot(*self._metres(item), marker="X", color=INSIDE, linestyle="none", label="return point")
                name = ""
            labelled.add(name)
            index += 1


def _height(axes, plan: Plan, speeds: Speeds) -> None:
    flight = fly(plan, speeds)
    along, heights, travelled = [], [], 0.0
    for leg in flight.legs:
        if leg.climb is None:
            continue
        if not along:
            along, heights = [travelled], [leg.start.z]
        travelled += leg.distance
        along.append(travelled)
        heights.append(leg.end.z)
    axes.plot(along, heights, color=PATH, marker="o", markersize=3, linewidth=1.4)
    if along:
        axes.fill_between(along, heights, min(0.0, *heights), color=PATH, alpha=0.12)
    axes.set(xlabel="along the way, jumps carried out [m]", ylabel="height above home [m]")
    if flight.doubts:
        axes.set_title("; ".join(flight.doubts), fontsize=7)
    axes.grid(alpha=0.3)
