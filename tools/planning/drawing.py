"""A plan drawn: the map from above, and the height along the way."""

from __future__ import annotations

import io
import math
import textwrap
from collections import Counter
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path
from typing import Any

import matplotlib

matplotlib.use("Agg")

from matplotlib import pyplot
from matplotlib.patches import Circle as Disc
from matplotlib.patches import Polygon as Area
from matplotlib.ticker import FuncFormatter

from .bad_plan import BadPlan, shown_name
from .fences import Circle, Polygon, shapes
from .files import write_bytes
from .flight import EARTH_RADIUS, Flight, Leg, Speeds, distance_from_home, fly, is_flown_to, places_of
from .plan import Plan
from .table import length_text

PATH, INSIDE, OUTSIDE, RALLY, HOME = "#1f5fa8", "#2e8b57", "#c0392b", "#8e44ad", "#222222"
GROUND = "#7d5a3c"
START, END = "#27ae60", "#d35400"
NOT_FLOWN, OTHER_HEIGHT = "#888888", "#b9770e"
IN_KILOMETRES = 5_000.0  # [m] that a picture shows, beyond which its axes count kilometres
LARGEST_FENCE = 5.0  # of the mission's size; a larger one is not drawn whole
MOST_MARKS = 60  # of items; more would hide the way
ARROWS = 14
THINNEST, WIDEST = 0.06, 1.4  # [points]
MAP_POINTS, CELLS = 400, 40  # the map's shorter side on the paper, and how many parts of it are looked at by themselves
INKED = 0.35  # of the paper, where lines are closest
TITLE_WIDTH, TITLE_LINES = 72, 3
COMPASS = ("north", "north-east", "east", "south-east", "south", "south-west", "west", "north-west")


def draw(plan: Plan, file: Path, speeds: Speeds) -> None:
    """Writes the drawing: equal for equal plans. Raises BadPlan."""
    suffix = file.suffix.lower()
    if not places_of(plan) and (plan.home is None or not plan.home.is_somewhere):
        raise BadPlan(plan.file, None, "it has no places: there is nothing to draw")
    flight = fly(plan, speeds)
    has_heights = any(line for _, line in height_lines(flight))
    look: dict[Any, Any] = {"svg.hashsalt": "plan", "svg.fonttype": "path", "font.size": 9, "figure.dpi": 100}
    picture = io.BytesIO()
    with matplotlib.rc_context({**look, "text.parse_math": False}):
        rows = 2 if has_heights else 1
        figure, axes = pyplot.subplots(
            rows,
            1,
            figsize=(8, 9 if has_heights else 7),
            height_ratios=(3, 1)[:rows],
            layout="constrained",
            squeeze=False,
        )
        try:
            figure.suptitle(title_of(plan), fontsize=11)
            above = _Map(axes[0][0], plan)
            above.draw(flight)
            if has_heights:
                _height(axes[1][0], flight)
            figure.draw_without_rendering()  # places on the paper are known then
            above.label()
            metadata = {"Date": None} if suffix == ".svg" else {"Software": None}
            figure.savefig(picture, format=suffix[1:], metadata=metadata)
        finally:
            pyplot.close(figure)
    write_bytes(file, picture.getvalue())


def title_of(plan: Plan) -> str:
    """The file's name, on as many lines as it takes, and no more than there are."""
    lines = textwrap.wrap(shown_name(plan.file), TITLE_WIDTH) or [""]
    if len(lines) > TITLE_LINES:
        lines = [*lines[: TITLE_LINES - 1], lines[TITLE_LINES - 1][: TITLE_WIDTH - 3] + "..."]
    return "\n".join(lines)


Point = tuple[float, float]


class _Map:
    """East and north of a place, in metres: of home, or of the first item where home is far or nowhere."""

    def __init__(self, axes, plan: Plan) -> None:
        self._axes, self._plan = axes, plan
        home = plan.home if plan.home is not None and plan.home.is_somewhere else None
        self._far = distance_from_home(plan)
        self._home = home if self._far is None else None
        places = places_of(plan)
        self._origin = (self._home.x, self._home.y) if self._home is not None else (places[0].x, places[0].y)
        self._from = "home" if self._home is not None else "the first item"
        # Where east is as long as it looks: in the middle of what is drawn.
        latitudes = [item.x for item in places] or [self._origin[0]]
        self._east_scale = max(math.cos(math.radians((min(latitudes) + max(latitudes)) / 2e7)), 1e-3)
        self._labels: list[tuple[str, Point, str]] = []  # in order of importance

    def _metres(self, place) -> Point:
        """Of anything with x and y in 1e-7 degrees."""
        east = (place.y - self._origin[1] + 1_800_000_000) % 3_600_000_000 - 1_800_000_000  # across the date line
        return (
            math.radians(east / 1e7) * EARTH_RADIUS * self._east_scale,
            math.radians((place.x - self._origin[0]) / 1e7) * EARTH_RADIUS,
        )

    def draw(self, flight: Flight) -> None:
        axes = self._axes
        self._fence()
        self._rally()
        self._way(flight)
        if self._home is not None:
            axes.plot(0, 0, marker="*", markersize=8, color=HOME, linestyle="none", label="home", zorder=5)
        elif self._far is not None:
            self._tell_home()
        axes.set_aspect("equal", adjustable="datalim")
        axes.margins(0.08)
        axes.grid(alpha=0.3)
        axes.autoscale_view()
        self._look_at_the_mission()
        unit = in_kilometres(axes, axes.xaxis, axes.yaxis)
        axes.set(xlabel=f"east of {self._from} [{unit}]", ylabel=f"north of {self._from} [{unit}]")
        handles, names = axes.get_legend_handles_labels()
        if handles:
            axes.legend(
                handles, names, loc="upper center", bbox_to_anchor=(0.5, -0.09), ncols=4, fontsize=8, frameon=False
            )

    def _look_at_the_mission(self) -> None:
        """A fence that is much larger than the mission goes beyond the picture: the mission would be a dot in it."""
        ways = [self._metres(item) for item in self._plan.items() if is_flown_to(item) and (item.x, item.y) != (0, 0)]
        if len(ways) < 2 or not self._plan.items("fence"):
            return
        if self._home is not None:
            ways.append((0.0, 0.0))
        axes = self._axes
        spans = [(min(values), max(values)) for values in zip(*ways, strict=True)]
        own = max(high - low for low, high in spans)
        drawn = max(high - low for low, high in (axes.get_xlim(), axes.get_ylim()))
        if own <= 0 or drawn <= LARGEST_FENCE * own:
            return
        for (low, high), limit in zip(spans, (axes.set_xlim, axes.set_ylim), strict=True):
            limit(low - 0.15 * own, high + 0.15 * own)
        (left, right), (bottom, top) = axes.get_xlim(), axes.get_ylim()
        self._labels = [one for one in self._labels if left <= one[1][0] <= right and bottom <= one[1][1] <= top]
        axes.set_title("the fence goes beyond the picture", fontsize=9, color=INSIDE, loc="right")

    def _tell_home(self) -> None:
        """Home is too far to be in the picture."""
        assert self._plan.home is not None and self._far is not None
        east, north = self._metres(self._plan.home)
        towards = COMPASS[round(math.degrees(math.atan2(east, north)) / 45) % 8]
        self._axes.set_title(
            f"its home is {length_text(self._far)} away, to the {towards}: not drawn", fontsize=9, color=OUTSIDE
        )

    # -- the way ---------------------------------------------------------------------------

    def _way(self, flight: Flight) -> None:
        placed = [(number, item) for number, item in enumerate(self._plan.items()) if is_flown_to(item)]
        if not placed:
            return
        points = [self._metres(item) for _, item in placed]
        flown = self._flown(flight)
        # Of two widths: lanes of a survey are thin, and the way to it is not.
        possible = widths(flown)
        width = WIDEST if len(points) <= MOST_MARKS else 0.8
        thin = min(possible, default=width)
        is_thin = [one < width for one in possible]
        single = [line for line, narrow in zip(flown, is_thin, strict=True) if not narrow]
        lanes = [line for line, narrow in zip(flown, is_thin, strict=True) if narrow]
        others = [line for line in pairwise(points) if line not in flown and line[::-1] not in flown]
        self._lines(
            others, color=NOT_FLOWN, linewidth=min(0.6, thin), linestyle=":", label="next in the file, not flown"
        )
        self._lines(lanes, color=PATH, linewidth=thin, label=None if single else "mission")
        self._lines(single, color=PATH, linewidth=width, label="mission")
        if len(points) <= MOST_MARKS:
            self._axes.plot(*zip(*points, strict=True), color=PATH, marker="o", markersize=4, linestyle="none")
        self._arrows(flown, max(thin, 0.3))
        start, end = (flown[0][0], flown[-1][1]) if flown else (points[0], points[-1])
        # Both are seen where they are one place, and home with them.
        self._axes.plot(*start, marker="o", markersize=10, color=START, linestyle="none", label="start", zorder=4)
        self._axes.plot(
            *end, marker="s", markersize=13, color=END, fillstyle="none", linestyle="none", label="end", zorder=4
        )
        # First and last first: what is in between gets what room is left.
        order = [0, len(placed) - 1, *range(1, len(placed) - 1)]
        self._labels += [(str(placed[i][0]), points[i], PATH) for i in dict.fromkeys(order)]

    def _flown(self, flight: Flight) -> list[tuple[Point, Point]]:
        """The legs over the ground, in their order, each once."""
        legs = [(self._metres(leg.start), self._metres(leg.end)) for leg in flight.legs if leg.distance]
        if self._far is not None and self._plan.home is not None:
            home = self._metres(self._plan.home)
            legs = [leg for leg in legs if home not in leg]
        return list(dict.fromkeys(legs))

    def _lines(self, lines, label: str | None, **look) -> None:
        """One line for all: points that do not follow one another are set apart by a gap."""
        xs: list[float] = []
        ys: list[float] = []
        for start, end in lines:
            if not xs or (xs[-1], ys[-1]) != start:
                xs += [math.nan, start[0]] if xs else [start[0]]
                ys += [math.nan, start[1]] if ys else [start[1]]
            xs.append(end[0])
            ys.append(end[1])
        if xs:
            self._axes.plot(xs, ys, label=label, **look)

    def _arrows(self, lines: list[tuple[Point, Point]], width: float) -> None:
        """Which way it goes: some arrows, as far apart along the way as one another."""
        lengths = [math.dist(*line) for line in lines]
        total = sum(lengths)
        if not total:
            return
        due, travelled, before = total / ARROWS / 2, 0.0, 0.0
        for line, length in zip(lines, lengths, strict=True):
            travelled += length
            # Behind an arrow the next leg that is as long has one too: lanes of a survey go to and fro.
            if travelled < due and not 0 < before <= 2 * length:
                continue
            before = 0.0 if travelled < due else length
            if travelled >= due:
                due += total / ARROWS * (1 + (travelled - due) // (total / ARROWS))
            self._arrow(*line, width)

    def _arrow(self, start: Point, end: Point, width: float) -> None:
        middle = ((start[0] + end[0]) / 2, (start[1] + end[1]) / 2)
        ahead = (middle[0] + (end[0] - start[0]) / 1000, middle[1] + (end[1] - start[1]) / 1000)
        look = {"arrowstyle": "-|>", "color": PATH, "linewidth": width, "mutation_scale": 9, "shrinkA": 0, "shrinkB": 0}
        self._axes.annotate("", ahead, xytext=middle, arrowprops=look)

    # -- the fence, rally points -----------------------------------------------------------

    def _fence(self) -> None:
        labelled: set[str] = set()
        for number, shape in enumerate(shapes(self._plan.items("fence")), start=1):
            label = None if shape.name in labelled else shape.name
            labelled.add(shape.name)
            if isinstance(shape, Polygon | Circle):
                colour = INSIDE if shape.inside else OUTSIDE
                look = {"facecolor": (colour, 0.08 if shape.inside else 0.25), "edgecolor": colour, "linewidth": 1.5}
                if isinstance(shape, Polygon):
                    corners = [self._metres(corner) for corner in shape.corners]
                    self._axes.add_patch(Area(corners, closed=True, label=label, **look))
                    place = max(corners, key=lambda point: (point[1], -point[0]))
                    if not shape.inside:
                        place = tuple(sum(values) / len(corners) for values in zip(*corners, strict=True))
                else:
                    centre = self._metres(shape.centre)
                    self._axes.add_patch(Disc(centre, abs(shape.radius), label=label, **look))
                    place = (centre[0], centre[1] + shape.radius) if shape.inside else centre
                self._labels.append((f"fence {number}: {shape.name}", place, colour))
            else:
                place = self._metres(shape.item)
                self._axes.plot(*place, marker="X", color=INSIDE, linestyle="none", label=label)
                self._labels.append((shape.name, place, INSIDE))

    def _rally(self) -> None:
        for number, item in enumerate(self._plan.items("rally")):
            place = self._metres(item)
            label = "rally point" if not number else None
            self._axes.plot(*place, marker="^", color=RALLY, linestyle="none", label=label)
            self._labels.append((f"rally {number}", place, RALLY))

    # -- labels ----------------------------------------------------------------------------

    def label(self) -> None:
        """Names what there is room to name: no label lies on another, on the right of its place or on the left."""
        taken: list[tuple[float, float, float, float]] = []
        bounds = self._axes.bbox
        halo = {"facecolor": "white", "alpha": 0.7, "edgecolor": "none", "pad": 0.5}
        for text, point, colour in self._labels:
            x, y = self._axes.transData.transform(point)
            width = 7 + 5 * len(text)
            sides = (("left", x + 2), ("right", x - 2 - width))
            for side, left in sides[:1] if text.isdigit() else sides:
                box = (left, y + 1, left + width, y + 15)
                within = bounds.x0 <= box[0] and box[2] <= bounds.x1 and bounds.y0 <= box[1] and box[3] <= bounds.y1
                if not within or any(overlap(box, other) for other in taken):
                    continue
                taken.append(box)
                look = {"color": colour, "fontsize": 7, "bbox": halo, "annotation_clip": False, "ha": side}
                away = (4 if side == "left" else -4, 3)
                self._axes.annotate(text, point, textcoords="offset points", xytext=away, **look)
                break


def widths(lines: list[tuple[Point, Point]]) -> list[float]:
    """How wide each line may be drawn [points] so that paper is seen between it and those beside it."""
    east, north = ([point[side] for line in lines for point in line] for side in (0, 1))
    size = max(max(east) - min(east), max(north) - min(north)) if lines else 0
    if not size:
        return [WIDEST] * len(lines)
    cell = size / CELLS

    def cells(start: Point, end: Point) -> list[tuple[int, int]]:
        """Of a grid, those that a line crosses, about: one for each length of a cell."""
        steps = math.ceil(math.dist(start, end) / cell)
        along = [(step + 0.5) / steps for step in range(steps)]
        return [
            (
                int((start[0] + part * (end[0] - start[0]) - min(east)) // cell),
                int((start[1] + part * (end[1] - start[1]) - min(north)) // cell),
            )
            for part in along
        ]

    crossed = [cells(*line) for line in lines]
    lines_in = Counter(place for places in crossed for place in places)
    ink = INKED * MAP_POINTS / CELLS
    most = [sorted(lines_in[place] for place in places)[len(places) // 2] if places else 1 for places in crossed]
    return [max(THINNEST, min(WIDEST, ink / count)) for count in most]


def overlap(one, other) -> bool:
    return one[0] < other[2] and other[0] < one[2] and one[1] < other[3] and other[1] < one[3]


def in_kilometres(axes, *sides) -> str:
    """The unit of a picture's axes, and its axes counting it."""
    limits = [abs(high - low) for high, low in (axes.get_xlim(), axes.get_ylim())]
    size = max(limits) if len(sides) == 2 else limits[0]
    if size <= IN_KILOMETRES:
        return "m"
    for side in sides:
        side.set_major_formatter(FuncFormatter(lambda metres, _: f"{metres / 1000:,g}"))
    return "km"


# The height ------------------------------------------------------------------------------


HOME_LINE, GROUND_LINE = "above home", "the ground, above home"


def height_lines(flight: Flight) -> Iterator[tuple[str, list[tuple[float, float]]]]:
    """By what a height is measured from, its line along the way [m], with a gap where it is not known."""
    ends: dict[str, list[tuple[float, float]]] = {HOME_LINE: []}
    travelled = 0.0
    for leg in flight.legs:
        for reference, start, end in references(leg):
            line = ends.setdefault(reference, [])
            if not line or line[-1] != (travelled, start):
                if line:
                    line.append((math.nan, math.nan))
                line.append((travelled, start))
            line.append((travelled + leg.distance, end))
        travelled += leg.distance
    yield from ends.items()


def references(leg: Leg) -> Iterator[tuple[str, float, float]]:
    """What both ends of a leg are measured from, and their heights above that."""
    start, end = leg.start, leg.end
    if start.z is not None and end.z is not None:
        yield HOME_LINE, start.z, end.z
    elif start.other and end.other and start.other[0] == end.other[0]:
        yield end.other[0], start.other[1], end.other[1]
    if start.ground is not None and end.ground is not None:
        yield GROUND_LINE, start.ground, end.ground


def _height(axes, flight: Flight) -> None:
    lines = [(reference, line) for reference, line in height_lines(flight) if line]
    for reference, line in lines:
        is_home = reference == HOME_LINE
        along, heights = zip(*line, strict=True)
        many = len(line) > 2 * MOST_MARKS
        axes.plot(
            along,
            heights,
            color=PATH if is_home else GROUND if reference == GROUND_LINE else OTHER_HEIGHT,
            linestyle="-" if is_home or reference == GROUND_LINE else "--",
            marker=None if many else "o",
            markersize=3,
            linewidth=0.8 if many else 1.4,
            label=reference,
        )
        if is_home or reference == GROUND_LINE:
            known = [height for height in heights if height == height]
            axes.fill_between(along, heights, min(0.0, *known), color=PATH if is_home else GROUND, alpha=0.12)
    total = flight.distance
    axes.set_xlim(-0.02 * total, 1.02 * total or 1.0)
    unit = in_kilometres(axes, axes.xaxis)
    only = lines[0][0] if len(lines) == 1 else ""
    axes.set(xlabel=f"along the way, jumps carried out [{unit}]", ylabel=f"height {only} [m]".replace("  ", " "))
    if len(lines) > 1:
        axes.legend(fontsize=8)
    if flight.doubts:
        doubts = textwrap.shorten("not known: " + "; ".join(flight.doubts), 2 * TITLE_WIDTH - 10, placeholder=" ...")
        axes.set_title("\n".join(textwrap.wrap(doubts, TITLE_WIDTH + 20)), fontsize=7)
    axes.grid(alpha=0.3)
