"""QGC WPL 110, Mission Planner's .waypoints: a line an item, twelve columns, line 0 home, jumps to line numbers.

    QGC WPL 110
    0  1  0  16  0 0 0 0    -35.3632621 149.1652374 584  1
    1  0  3  22  0 0 0 NaN  -35.3632621 149.1652374 20   1

The columns: number, current, frame, command, parameters 1 to 4, latitude, longitude, altitude, autocontinue. A file of
a fence or of rally points has the same form. Line 0 is home if it is a waypoint, or a command that does not exist: it
is never sent. Any other command there is an item. QGC WPL 120, of an old QGroundControl, has no home.

Programs take the lines in the order of the file. So their numbers matter only where an item names another one by its
number: elsewhere they may be in any order.
"""

from __future__ import annotations

import math
from dataclasses import replace
from decimal import Decimal
from pathlib import Path

from . import commands
from .bad_plan import BadPlan, cut
from .exact import DoesNotFit, decimal_of, decimal_text, degrees_text, e7_of, float32_of, is_whole
from .plan import (
    FENCE_COMMANDS,
    GLOBAL,
    JUMP,
    NO_PLACE,
    RALLY_POINT,
    RELATIVE,
    WAYPOINT,
    Home,
    Item,
    Plan,
    Step,
    modern,
)
from .progress import Progress
from .settling import Notes, settled, settled_current

HEADER = "QGC WPL 110"
WITHOUT_HOME = "QGC WPL 120"
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
HOMES = (0, WAYPOINT)  # of line 0; Mission Planner writes 0 where it has no home
SET_CURRENT, ROI = 224, 201  # beside DO_JUMP they name an item by its number; a region of interest with parameter 1 = 2
WHOLE = {0: (0, 65535), 1: (-1, 255), 2: (0, 255), 3: (0, 65535), 11: (0, 1)}  # column -> the smallest, the largest
BLANKS = " \t\r\f\v"
LONGEST_LINE = 255  # [characters], as the library's own reader takes it


def read(file: Path, text: str, unset_as_zero: bool = False, renumber: bool = False) -> Plan:
    """The plan in `text`; BadPlan, with the line, if it is none or says what cannot be carried exactly.

    `renumber`: lines are numbered as they follow one another, whatever their numbers, and jumps with them.
    """
    return read_lines(file, lines_of(text), 1, unset_as_zero, renumber)


def lines_of(text: str) -> list[str]:
    """As an editor counts them."""
    return text.replace("\r\n", "\n").replace("\r", "\n").split("\n")


def read_lines(file: Path, lines: list[str], first: int, unset_as_zero: bool = False, renumber: bool = False) -> Plan:
    """The same, of the lines from line `first` of a file on."""
    return _Reader(file, first, unset_as_zero, renumber).plan(lines)


class _Reader:
    def __init__(self, file: Path, first: int, unset_as_zero: bool, renumber: bool) -> None:
        self._file = file
        self._plan = Plan(file)
        self._notes = Notes()
        self._unset_as_zero, self._renumber = unset_as_zero, renumber
        self._line = first
        self._numbers: dict[int, int | None] = {}  # of a line in the file -> of its item; None: home
        self._is_renumbered = self._has_names = False
        self._jumps: list[tuple[int, Decimal]] = []  # items that jump, and where to, as the file counts

    def _bad(self, text: str, line: int | None = None) -> BadPlan:
        return BadPlan(self._file, line or self._line, text)

    def plan(self, lines: list[str]) -> Plan:
        if not any(line.strip() for line in lines):
            raise self._bad("the file is empty")
        header = " ".join(lines[0].split()) if lines and len(lines[0]) <= LONGEST_LINE else ""
        if header not in (HEADER, WITHOUT_HOME):
            seen = f", and is {cut(lines[0])}" if lines else ""
            raise self._bad(f'the first line must be "{HEADER}" (or "{WITHOUT_HOME}"){seen}')
        steps: list[Step] = []
        expected = 0
        self._has_names = any(names_an_item(line) for line in lines[1:])
        self._renumber = self._renumber or not self._has_names
        with Progress("lines read") as progress:
            for line in lines[1:]:
                self._line += 1
                progress.step()
                values = self._values_of(line)
                if values is None:
                    continue
                number = self._number(values[0], expected)
                if expected == 0 and number == 0 and header == HEADER and self._is_home(values[3]):
                    self._home(values)
                    self._numbers[number] = None
                else:
                    if expected == 0:
                        self._begin_without_home(header, values[3])
                    self._numbers[number] = len(steps)
                    steps.append(self._step(values, len(steps)))
                expected += 1
        if expected == 0:
            raise self._bad("there is no line 0, which is home")
        self._resolve_jumps(steps)
        self._sort(steps)
        self._plan.notes = self._notes.texts()
        return self._plan

    def _values_of(self, line: str) -> list | None:
        """The numbers of a line; None if it has none to have."""
        if line.lstrip(BLANKS).startswith("#"):
            return None
        if len(line) > LONGEST_LINE:
            raise self._bad(f"the line has {len(line):,} characters, and {LONGEST_LINE} is the most for an item")
        words = line.split()
        if not words:
            return None
        if len(words) != len(COLUMNS):
            raise self._bad(f"{len(words)} columns, and not {len(COLUMNS)}: {', '.join(COLUMNS)}")
        return self._values(words)

    def _number(self, number: int, expected: int) -> int:
        """A line's number in the file, which jumps name."""
        if number in self._numbers:
            raise self._bad(f"number {number} is there twice")
        if number != expected:
            if not self._renumber:
                raise self._bad(
                    f"this is number {number}, and {expected} is due: lines are missing or in another order;"
                    " --renumber numbers them as they stand, and their jumps with them"
                )
            if not self._is_renumbered:
                self._is_renumbered = True
                with_jumps = ", and jumps with them" if self._has_names else ""
                self._notes.add(f"from line {self._line} on the items are renumbered{with_jumps}")
        return number

    def _values(self, words: list[str]) -> list:
        values: list = []
        for column, word in enumerate(words):
            name = COLUMNS[column]
            if column in WHOLE:
                least, most = WHOLE[column]
                digits = word[1:] if least < 0 and word.startswith("-") else word
                if not (digits.isascii() and digits.isdigit()) or len(digits) > 9 or not least <= int(word) <= most:
                    raise self._bad(f"{name} must be a whole number from {max(least, 0)} to {most}, and is {cut(word)}")
                values.append(int(word))
                continue
            try:
                values.append(decimal_of(word))
            except ValueError:
                hint = ": write a point, not a comma" if "," in word else ""
                raise self._bad(f"{name} must be a number, and is {cut(word)}{hint}") from None
        return values

    def _is_home(self, command: int) -> bool:
        if command not in HOMES and not commands.is_known(command):
            self._notes.add(f"line 0 is taken for home, though no command has its number {command}: it is never sent")
            return True
        return command in HOMES

    def _begin_without_home(self, header: str, command: int) -> None:
        if command in FENCE_COMMANDS or command == RALLY_POINT:
            return
        why = f'"{WITHOUT_HOME}" has no home' if header == WITHOUT_HOME else "there is no line of home before it"
        self._notes.add(f"the first line, a {commands.name_of(command)}, is the first item: {why}")

    def _home(self, values: list) -> None:
        frame = values[2]
        if modern(frame) not in (GLOBAL, RELATIVE):
            raise self._bad(
                f"line 0 is home, which is above sea level, and has frame {frame}: write frame 0, or, if it is the"
                " first item, put a line of home before it"
            )
        x, y, z = values[8:11]
        if x.is_nan() or y.is_nan() or z.is_nan():
            raise self._bad("home has no place")
        try:
            self._plan.home = Home(e7_of(x), e7_of(y), float32_of(z))
        except DoesNotFit as error:
            raise self._bad(f"home: {error}") from None
        if modern(frame) != GLOBAL:
            self._notes.add(
                f"line 0 has frame {frame} and is taken for home, its altitude for one above sea level; if it is the"
                " first item, put a line of home before it"
            )
        if not self._plan.home.is_somewhere:
            self._plan.home = None

    def _step(self, values: list, index: int) -> Step:
        number, current, frame, command, *params, autocontinue = values
        name = f"item {index} ({commands.name_of(command)}, number {number} in the file)"
        if command == JUMP:
            self._jumps.append((index, params[0]))
            params[0] = Decimal(0)
        try:
            item = settled(
                command,
                frame,
                params,
                settled_current(current, index, self._notes),
                autocontinue,
                number=index,
                notes=self._notes,
                unset_as_zero=self._unset_as_zero,
            )
        except DoesNotFit as error:
            raise self._bad(f"{name}: {error}") from None
        if command == 224 or (command == 201 and item.param1 == 2):
            self._notes.add("names another item by its number, which is not changed", index)
        return Step(item, self._line, name)

    def _resolve_jumps(self, steps: list[Step]) -> None:
        """Jumps name lines by their numbers in the file: here they name items."""
        for index, target in self._jumps:
            step = steps[index]
            number = int(target) if not target.is_nan() and is_whole(target) and abs(target) <= 65535 else None
            if number not in self._numbers:
                shown = "NaN" if target.is_nan() else cut(f"{target:f}" if target.adjusted() < 40 else str(target), "")
                raise self._bad(f"{step.name}: it jumps to number {shown}, and no line has that", step.line)
            item = self._numbers[number]
            if item is None:
                raise self._bad(f"{step.name}: it jumps to number {number}, which is home and no item", step.line)
            steps[index] = replace(step, item=step.item._replace(param1=float(item)))

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


def names_an_item(line: str) -> bool:
    """Whether a line's item names another one by its number."""
    words = line.split()
    if len(words) < 5 or not words[3].isdigit():
        return False
    command = int(words[3])
    return command in (JUMP, SET_CURRENT) or (command == ROI and words[4].partition(".")[0] == "2")


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
    for number, step in enumerate(Progress("lines written").of(plan.steps(kind))):
        if any(math.isnan(value) for value in (*step.item[4:8], step.item.z)):
            notes.add("unset numbers are written as NaN, which not every program reads", number)
        if step.group:
            notes.add("surveys and other patterns are written as their items")
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
