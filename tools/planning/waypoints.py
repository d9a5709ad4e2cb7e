"""QGC WPL 110, Mission Planner's .waypoints: a line an item, twelve columns, line 0 home, jumps to line numbers.

    QGC WPL 110
    0  1  0  16  0 0 0 0    -35.3632621 149.1652374 584  1
    1  0  3  22  0 0 0 NaN  -35.3632621 149.1652374 20   1

The columns: number, current, frame, command, parameters 1 to 4, latitude, longitude, altitude, autocontinue.
A file of a fence or of rally points has the same form.
"""

from __future__ import annotations

import math
from decimal import Decimal
from pathlib import Path

from . import commands
from .bad_plan import BadPlan
from .exact import DoesNotFit, decimal_of, decimal_text, degrees_text, e7_of, float32_of
from .plan import FENCE_COMMANDS, GLOBAL, JUMP, NO_PLACE, RALLY_POINT, WAYPOINT, Home, Item, Plan, Step, modern
from .settling import Notes, settled

HEADER = "QGC WPL 110"
COLUMNS = (
    "its number",
    "current",
    "frame",
    "command",
    "parameter 1",
    "parameter 2",
    "parameter 3",
    "parameter 4",
    "latitude",
    "longitude",
    "altitude",
    "autocontinue",
)
# A file of these may begin with one of them instead of home, as MAVProxy writes it.
OTHER_KINDS = (*FENCE_COMMANDS, RALLY_POINT)
WHOLE = {0: 65535, 1: 255, 2: 255, 3: 65535, 11: 1}  # column -> the largest


def read(file: Path, text: str, unset_as_zero: bool = False) -> Plan:
    """The plan in `text`; BadPlan, with the line, if it is none or says what cannot be carried exactly."""
    return read_lines(file, lines_of(text), 1, unset_as_zero)


def lines_of(text: str) -> list[str]:
    """As an editor counts them."""
    return text.replace("\r\n", "\n").replace("\r", "\n").split("\n")


def read_lines(file: Path, lines: list[str], first: int, unset_as_zero: bool = False) -> Plan:
    """The same, of the lines from line `first` of a file on."""
    return _Reader(file, first, unset_as_zero).plan(lines)


class _Reader:
    def __init__(self, file: Path, first: int, unset_as_zero: bool) -> None:
        self._file = file
        self._plan = Plan(file)
        self._notes = Notes()
        self._unset_as_zero = unset_as_zero
        self._line = first

    def _bad(self, text: str, line: int | None = None) -> BadPlan:
        return BadPlan(self._file, line or self._line, text)

    def plan(self, lines: list[str]) -> Plan:
        if not lines or lines[0].split() != HEADER.split():
            raise self._bad(f'the first line must be "{HEADER}"' + (f", and is {lines[0][:40]!r}" if lines else ""))
        steps: list[Step] = []
        expected = 0
        for self._line, line in enumerate(lines[1:], start=self._line + 1):
            words = line.split()
            if not words or words[0].startswith("#"):
                continue
            if len(words) != len(COLUMNS):
                raise self._bad(f"{len(words)} columns, and not {len(COLUMNS)}: {', '.join(COLUMNS)}")
            values = self._values(words)
            if values[0] != expected:
                raise self._bad(
                    f"this is number {values[0]}, and {expected} is due: lines are missing or in another order"
                )
            if expected == 0 and values[3] not in OTHER_KINDS:
                self._home(values)
            else:
                steps.append(self._step(values, len(steps)))
            expected += 1
        if expected == 0:
            raise self._bad("there is no line 0, which is home")
        self._sort(steps)
        self._plan.notes = self._notes.texts()
        return self._plan

    def _values(self, words: list[str]) -> list:
        values: list = []
        for column, word in enumerate(words):
            name = COLUMNS[column]
            if column in WHOLE:
                if not (word.isascii() and word.isdigit()) or len(word) > 9 or int(word) > WHOLE[column]:
                    raise self._bad(f"{name} must be a whole number from 0 to {WHOLE[column]}, and is {word!r}")
                values.append(int(word))
                continue
            try:
                values.append(decimal_of(word))
            except ValueError:
                hint = ": write a point, not a comma" if "," in word else ""
                raise self._bad(f"{name} must be a number, and is {word!r}{hint}") from None
        return values

    def _home(self, values: list) -> None:
        _, _, frame, command, *_ = values
        if command not in (0, WAYPOINT):  # Mission Planner writes 0 where it has no home
            raise self._bad(
                f"line 0 is home, and here a {commands.name_of(command)}, which would not be flown: put home before it"
            )
        if modern(frame) != GLOBAL:
            raise self._bad(f"home is above sea level, which is frame 0, and has frame {frame}")
        x, y, z = values[8:11]
        if x.is_nan() or y.is_nan() or z.is_nan():
            raise self._bad("home has no place")
        try:
            self._plan.home = Home(e7_of(x), e7_of(y), float32_of(z))
        except DoesNotFit as error:
            raise self._bad(f"home: {error}") from None
        if not self._plan.home.is_somewhere:
            self._plan.home = None

    def _step(self, values: list, index: int) -> Step:
        number, current, frame, command, *params, autocontinue = values
        name = f"item {index} ({commands.name_of(command)}, number {number} in the file)"
        if command == JUMP:
            params[0] = self._target(name, params[0])
        try:
            item = settled(
                command,
                frame,
                params,
                current,
                autocontinue,
                number=index,
                notes=self._notes,
                unset_as_zero=self._unset_as_zero,
            )
        except DoesNotFit as error:
            raise self._bad(f"{name}: {error}") from None
        if command == 224 or (command == 201 and item.param1 == 2):
            self._notes.add("names another item by number, which goes out as it is", index)
        return Step(item, self._line, name)

    def _target(self, name: str, target: Decimal) -> Decimal:
        """The sketch's number of the item that a jump goes to: the file's counts home."""
        if target == 0:
            raise self._bad(f"{name}: it jumps to number 0, which is home and no item")
        return target if target.is_nan() else target - 1

    def _sort(self, steps: list[Step]) -> None:
        """Puts the items where they belong: a file is of one kind."""
        for kind, among in (("fence", FENCE_COMMANDS), ("rally", (RALLY_POINT,))):
            if any(step.item.command in among for step in steps):
                others = [step for step in steps if step.item.command not in among]
                if others:
                    raise self._bad(
                        f"{others[0].name} is not of the {kind}: a .waypoints file is of one kind", others[0].line
                    )
                setattr(self._plan, kind, [plain(step) for step in steps])
                return
        self._plan.mission = steps


def plain(step: Step) -> Step:
    """A fence or rally item: "go on with the next" and "current" mean nothing there."""
    return Step(step.item._replace(autocontinue=1, current=0), step.line, step.name)


# Writing --------------------------------------------------------------------


def write(plan: Plan, kind: str = "mission") -> tuple[str, list[str]]:
    """The text of a .waypoints file of one kind of the plan's items, and what of the plan it does not carry."""
    notes = Notes()
    lines = [HEADER, _home_line(plan.home or Home(0, 0, 0.0))]
    if plan.home is None:
        notes.add("there is no home in the plan; line 0 is written as 0, 0, 0")
    for number, step in enumerate(plan.steps(kind)):
        if any(math.isnan(value) for value in (*step.item[4:8], step.item.z)):
            notes.add(
                "unset numbers are written as NaN; for a program that does not read that, say --unset-as-zero", number
            )
        if step.group:
            notes.add("patterns are written as the items that they carry")
        lines.append(item_line(number + 1, step.item))
    for other in plan.kinds:
        if other != kind:
            notes.add(
                f"the {other} ({len(plan.steps(other))} items) is not in it; --part {other} writes it to one of its own"
            )
    if plan.hover_speed is not None or plan.cruise_speed is not None:
        notes.add("the speeds that the plan was drawn for are not in a .waypoints file")
    return "\n".join(lines) + "\n", notes.texts()


def _home_line(home: Home) -> str:
    return item_line(0, Item(GLOBAL, WAYPOINT, 1, 1, 0.0, 0.0, 0.0, 0.0, *home))


def item_line(number: int, item: Item) -> str:
    """One line; `number` counts home as 0."""
    param1 = item.param1 + 1 if item.command == JUMP else item.param1
    floats = [decimal_text(value) for value in (param1, item.param2, item.param3, item.param4)]
    place = [str(item.x), str(item.y)] if item.frame == NO_PLACE else [degrees_text(item.x), degrees_text(item.y)]
    return "\t".join(
        [
            *map(str, (number, item.current, item.frame, item.command)),
            *floats,
            *place,
            decimal_text(item.z),
            str(item.autocontinue),
        ]
    )
