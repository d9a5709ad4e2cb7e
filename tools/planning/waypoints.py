"""QGC WPL 110, Mission Planner's .waypoints: a line an item, twelve columns, line 0 home, jumps to line numbers.

    QGC WPL 110
    0  1  0  16  0 0 0 0    -35.3632621 149.1652374 584  1
    1  0  3  22  0 0 0 NaN  -35.3632621 149.1652374 20   1

Such a text is read by the library's own reader, src/mavmission/text/WaypointsText.h, which describes the format: so the
tool takes what the board takes, and makes the same items of it. Here are the words for what is wrong with a text, and
what makes an old text one that the library reads: QGC WPL 120, of an old QGroundControl, which has no home, and lines
whose numbers are in any order, where no item names another one by its number.
"""

from __future__ import annotations

import math
import re
from pathlib import Path

from . import commands, judge
from .bad_plan import BadPlan, cut
from .exact import decimal_text, degrees_text
from .plan import FRAMES, GLOBAL, JUMP, NO_PLACE, WAYPOINT, Home, Item, Plan, ReadText, Step
from .progress import Progress
from .settling import Notes
from .unset import is_unset_not_0

HEADER = "QGC WPL 110"
WITHOUT_HOME = "QGC WPL 120"
NO_HOME = b"0 1 0 16 0 0 0 0 0 0 0 1"
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
SET_CURRENT, ROI = 224, 201  # beside DO_JUMP they name an item by its number; a region of interest with parameter 1 = 2


def read(file: Path, text: str | bytes, unset_as_zero: bool = False, renumber: bool = False) -> Plan:
    """The plan in `text`; BadPlan, with the line, if it is none or says what cannot be carried exactly.

    `renumber`: lines are numbered as they follow one another, whatever their numbers, and jumps with them.
    """
    return read_lines(file, lines_of(text), 1, unset_as_zero, renumber)


def lines_of(text: str | bytes) -> list[str]:
    """As an editor counts them; each byte that is no ASCII is a character."""
    data = text.encode("utf-8", "surrogateescape") if isinstance(text, str) else text
    return re.split("\r\n|\r|\n", data.decode("latin-1"))


def read_lines(file: Path, lines: list[str], first: int, unset_as_zero: bool = False, renumber: bool = False) -> Plan:
    """The same, of the lines from line `first` of a file on."""
    plan, notes = Plan(file), Notes()
    if not any(line.strip() for line in lines):
        raise BadPlan(file, first, "the file is empty")
    said = judge.text("\n".join(lines))
    extra = 0  # lines that the text has before its items, and the file has not
    if renumber or said.error == "OutOfOrder" or words_of(lines[0]) == WITHOUT_HOME.split():
        present, extra = _present(file, lines, first, renumber, notes)
        said = judge.text("\n".join(present))
    shift = first - 1 - extra
    if said.error and said.error != "NoItems":
        raise BadPlan(file, said.line + shift, f"{_item_at(said, lines, extra)}{_wrong(said, lines, extra)}")
    for index, (line, item) in enumerate(said.items):
        words = words_of(lines[line - 1 - extra])
        name = f"item {index} ({commands.name_of(item.command)}, number {words[0]} in the file)"
        item = _without_unset(item, index, notes) if unset_as_zero else item
        _note(item, index, words, notes)
        plan.steps(said.kind).append(Step(item, line + shift, name))
    if said.home is not None and not extra:
        if said.home.frame != GLOBAL:
            notes.add(
                f"line 0 has frame {said.home.frame} and is taken for home, its altitude for one above sea level; if it"
                " is the first item, put a line of home before it"
            )
        home = Home(said.home.x, said.home.y, said.home.z)
        plan.home = home if home.is_somewhere else None
    elif said.kind == "mission" and plan.mission:
        why = f'"{WITHOUT_HOME}" has no home' if extra else "there is no line of home before it"
        first_name = commands.name_of(plan.mission[0].item.command)
        notes.add(f"the first line, a {first_name}, is the first item: {why}")
    plan.notes = notes.texts()
    return plan


def words_of(line: str) -> list[str]:
    """A line's words; none of a comment."""
    words = line.split()
    return [] if words and words[0].startswith("#") else words


def _note(item: Item, index: int, words: list[str], notes: Notes) -> None:
    """What is not taken as it stands in the file, or is not certain."""
    if words[1].lstrip("+") not in ("0", "1"):
        notes.add('"current" is neither 0 nor 1, which means nothing in a plan: 0 is written', index)
    if item.frame == NO_PLACE and (item.x, item.y) == (0, 0) and any(re.search("[1-9]", word) for word in words[8:10]):
        notes.add("places of commands that have none are left out", index)
    if item.command == SET_CURRENT or (item.command == ROI and item.param1 == 2):
        notes.add("names another item by its number, which is not changed", index)
    if item.frame != NO_PLACE and not commands.is_at_a_place(item.command):
        if any(commands.uses(item.command, i) and (item.x, item.y)[i - 5] for i in (5, 6)):
            notes.add(
                "parameters 5 and 6 are taken for a place, as the frame says: if they are numbers, write 2", index
            )


def _without_unset(item: Item, index: int, notes: Notes) -> Item:
    unset = [i for i in range(1, 5) if math.isnan(item[3 + i]) and not is_unset_not_0(item.command, i)]
    if unset:
        notes.add("unset parameters are taken for 0", index)
    return Item._make(0.0 if place - 3 in unset else value for place, value in enumerate(item))


# Old texts -------------------------------------------------------------------


def _present(file: Path, lines: list[str], first: int, renumber: bool, notes: Notes) -> tuple[list[str], int]:
    """The lines of a text that the library reads, and how many there are before the items that are not in the file."""
    has_home = words_of(lines[0]) != WITHOUT_HOME.split()
    has_names = any(names_an_item(line) for line in lines[1:])
    made = [lines[0]] if has_home else [HEADER, NO_HOME.decode()]
    numbers: dict[str, int] = {}
    is_renumbered = False
    for place, line in enumerate(lines[1:], start=first + 1):
        if not (words := words_of(line)):
            continue
        due = len(numbers)
        if words[0] in numbers:
            raise BadPlan(file, place, f"number {words[0]} is there twice")
        if words[0] != str(due) and words[0].isdigit():
            if has_names and not renumber:
                raise BadPlan(file, place, _out_of_order(words[0], due))
            if not is_renumbered:
                with_jumps = ", and jumps with them" if has_names else ""
                notes.add(f"from line {place} on the items are renumbered{with_jumps}")
            is_renumbered = True
        numbers[words[0]] = due
    for line in lines[1:]:
        words = words_of(line)
        if words and words[0].isdigit():
            words[0] = str(numbers[words[0]] + (not has_home))
            if len(words) > 4 and words[3] == str(JUMP):
                target = re.sub(r"\.0*$", "", words[4])
                # What names no line stays wrong.
                words[4] = str(numbers[target] + (not has_home)) if target in numbers else "65535"
        made.append("\t".join(words) if words else line)
    return made, len(made) - len(lines)


def names_an_item(line: str) -> bool:
    """Whether a line's item names another one by its number."""
    words = words_of(line)
    if len(words) < 5 or not words[3].isdigit():
        return False
    command = int(words[3])
    return command in (JUMP, SET_CURRENT) or (command == ROI and words[4].partition(".")[0] == "2")


def _out_of_order(number: str, due: int) -> str:
    return (
        f"this is number {cut(number, '')}, and {due} is due: lines are missing or in another order; --renumber numbers"
        " them as they stand, and their jumps with them"
    )


# What is wrong ----------------------------------------------------------------


def _item_at(said: ReadText, lines: list[str], extra: int) -> str:
    """The item whose field is bad."""
    words = words_of(lines[said.line - 1 - extra]) if said.field and 0 < said.line - extra <= len(lines) else []
    if len(words) < 4 or not words[3].isdigit():
        return ""
    index = sum(1 for line, _ in said.items if line < said.line)
    return f"item {index} ({commands.name_of(int(words[3]))}, number {words[0]} in the file): "


def _wrong(said: ReadText, lines: list[str], extra: int) -> str:
    """In words, with what stands there."""
    line = lines[said.line - 1 - extra] if 0 < said.line - extra <= len(lines) else ""
    words = words_of(line)
    name, word = (COLUMNS[said.field - 1], words[said.field - 1]) if 0 < said.field <= len(words) else ("", "")
    due = sum(1 for other in lines[1 : said.line - 1 - extra] if words_of(other))
    match said.error:
        case "NotWaypoints":
            return f'the first line must be "{HEADER}" (or "{WITHOUT_HOME}"), and is {cut(line)}'
        case "TooFewFields" | "TooManyFields":
            return f"{len(words)} columns, and not {len(COLUMNS)}: {', '.join(COLUMNS)}"
        case "LineTooLong":
            return f"the line has {len(line):,} characters, and 255 is the most for an item"
        case "OutOfOrder":
            return _out_of_order(word, due)
        case "BadTarget":
            to = "which is home and no item" if re.fullmatch(r"0(\.0*)?", word) else "and no line has that"
            return f"it jumps to number {cut(word, '')}, {to}"
        case "NoReference":
            return f"frame 2 says of no altitude what it is measured from: {FRAMES}"
        case "BadTextFrame":
            return (
                f"frame {cut(word, '')} is no altitude reference: {FRAMES}; 2 where there is neither place nor altitude"
            )
        case "BadNumber" | "NotWhole" if word.endswith("QGC"):
            return "a second plan begins behind this line: keep one of them (FILE_WRITE appends: remove the file first)"
        case "BadNumber" | "NotWhole":
            hint = ": write a point, not a comma" if "," in word else ""
            whole = "whole " if said.error == "NotWhole" else ""
            return f"{name} must be a {whole}number, and is {cut(word)}{hint}"
    return f"{said.words} ({name} is {cut(word)})" if word else said.words


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
