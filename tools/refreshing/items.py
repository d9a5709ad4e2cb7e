"""The tables of docs/items.md are made of src/mavmission/item/MissionItem.h, of the rules in Commands.cpp and of
what each vehicle took when it was recorded."""

from __future__ import annotations

import csv
import re

from .readback import ROOT, ROW, SOURCE

DOCUMENT = ROOT / "docs" / "items.md"
HEADER = ROOT / "src" / "mavmission" / "item" / "MissionItem.h"
RECORDINGS = ROOT / "simulation" / "recordings"
VEHICLES = {"copter": "arducopter", "plane": "arduplane", "rover": "ardurover", "PX4": "px4"}

ITEM = re.compile(r"^constexpr MissionItem (\w+)\(([^{}]*)\) \{\s+return ([^{}]*?);\s+\}", re.M)
CONSTANT = re.compile(r"^  (k\w+) = (\d+),", re.M)
LIMITS = {"Sign": "its sign alone", "Centimetres": "to the cm, up to 655.35", "U1": "0 or 1", "U8": "whole, to 255",
          "I8": "whole, ±127", "U16": "whole, to 65535", "I16": "whole, ±32767", "Radius": "whole, ±65535",
          "Zero": "0 alone"}  # fmt: skip
SPECIAL = {("loiterTurns", 1): "whole, to 255, or 256ths below 1", ("loiterTurns", 3): "whole, to 255; in tens to 2550",
           ("fenceInsideCircle", 1): "above 0", ("fenceOutsideCircle", 1): "above 0"}  # fmt: skip


class Maker:
    """A function of the header: its arguments, and which field of the item each of them goes to."""

    def __init__(self, name: str, arguments: str, body: str, comment: str, numbers: dict[str, int]) -> None:
        self.name, self.comment = name, comment
        split = [argument.split("=")[0].split() for argument in re.split(r",\s*", arguments) if argument.strip()]
        self.arguments = [(words[-1], words[-2]) for words in split]
        self.command, self.fields = 0, {}
        if "anyCommand" not in body:
            self.by = body  # another function makes it
            return
        # The call that makes the item, without the constructors within it.
        call = re.search(r"(anyCommand(?:At)?)\((.*)\)", re.sub(r"\s+", " ", body))
        assert call, name
        flat = re.sub(r"\b(?!anyCommand)(\w+)\(([^()]*)\)", r"\2", re.sub(r"\(\)", "", call[2]))
        given = [part.strip() for part in flat.replace("(", "").replace(")", "").split(",")]
        self.command = numbers[given[0]]
        names = [0, 1, 2, 3, 4] if call[1] == "anyCommand" else [0, 5, 6, 7, 1, 2, 3, 4]
        if "CoordinateFrame::" in flat:
            given = [part for part in given if "CoordinateFrame::" not in part]
        for place, text in zip(names[1:], given[1:], strict=False):
            for argument, _ in self.arguments:
                if re.search(rf"\b{argument}\b", text):
                    self.fields[argument] = place

    @property
    def signature(self) -> str:
        return f"`{self.name}({', '.join(argument for argument, _ in self.arguments)})`"


def found(pattern: str, text: str, flags: re.RegexFlag = re.S) -> str:
    """What the pattern's group is in the text."""
    match = re.search(pattern, text, flags)
    assert match, pattern
    return match[1]


def makers() -> list[tuple[str, list[Maker]]]:
    """By part of the header: a mission's, a fence's, a rally plan's."""
    text = HEADER.read_text()
    numbers = {name: int(number) for name, number in CONSTANT.findall(text)}
    parts = re.split(r"^// --- (Items of .*?):.*\n", text[text.index("// Climb vertically") :], flags=re.M)
    titles = ["Items of a mission", *parts[1::2]]
    parts_made = []
    for title, part in zip(titles, parts[::2], strict=True):
        made = []
        for match in ITEM.finditer(part):
            name, arguments, body = match.groups()
            before = re.search(r"(?:^//[^\n]*\n)+\Z", part[: match.start()], re.M)
            comment = " ".join(re.sub(r"^// ?", "", line) for line in before[0].splitlines()) if before else ""
            if name == "jump":
                body = "anyCommand(kDoJump, target, repeats)"
            made.append(Maker(name, arguments, body, comment, numbers))
        for maker in (maker for maker in made if not maker.command):
            name, given = re.findall(r"^(\w+)\((.*)\)", re.sub(r"\s+", " ", maker.by))[0]
            other = next(one for one in made if one.name == name and one.command)
            maker.command = other.command
            words = re.sub(r"\(.*?\)", "", given).split(", ")
            own = [argument for argument, _ in maker.arguments]
            maker.fields = {word: other.fields[argument] for word, (argument, _) in
                            zip(words, other.arguments, strict=False) if word in own}  # fmt: skip
        parts_made.append((title, made))
    return parts_made


def in_px4() -> dict[str, list[str]]:
    """The Kinds of param1 to param4, x, y, z of each InPx4."""
    text = SOURCE.read_text()
    names = found(r"enum class InPx4 : uint8_t \{(.*?)\}", text).replace(",", " ").split()
    table = found(r"const Both kInPx4\[\].*?\{(.*?)\n\};", text)
    rows = re.findall(r"four\((.*?)\), four\((.*?)\)", table)
    return {
        name: [kind.strip() for kind in (*first.split(","), *second.split(",")[:3])]
        for name, (first, second) in zip(names, rows, strict=True)
    }


def kinds() -> dict[tuple[int, str], list[str] | None]:
    """Of a command and a vehicle the Kinds of its fields 1 to 7; None: not taken."""
    text = SOURCE.read_text()
    names = found(r"enum class InArduPilot : uint8_t \{(.*?)\}", text).replace(",", " ").split()
    places = [cell.split(", ")[:3] for cell in re.findall(
        r"four\((.*?)\)", found(r"kInArduPilot\[\].*?\{(.*?)\n\};", text))]  # fmt: skip
    ardupilot = dict(zip(names, places, strict=True))
    known: dict[tuple[int, str], list[str] | None] = {}
    for number, *params, where, px4, name in ROW.findall(text):
        kept = None if where == "NotTaken" else [*params, *ardupilot[where]]
        for vehicle in ("plane",) if " on a plane" in name else ("copter", "plane", "rover"):
            known.setdefault((int(number), vehicle), kept)
        if " on a plane" not in name:
            known[int(number), "PX4"] = None if px4 == "NotTaken" else in_px4()[px4]
    for vehicle, file in VEHICLES.items():
        for command in {command for command, of in known if of == vehicle} - taken(file):
            known[command, vehicle] = None
    return known


def taken(file: str) -> set[int]:
    """The commands that a vehicle accepted at least once."""
    with (RECORDINGS / f"readback_random_{file}.csv").open() as rows:
        return {int(row["command"]) for row in csv.DictReader(rows) if row["result"] == "ACCEPTED"}


def cell(made: list[Maker], kept: list[str] | None, vehicle: str) -> str:
    """What a vehicle does with the arguments of a function, of which there may be several of one name."""
    if kept is None:
        return "does not take it"
    limits, unused = [], []
    for argument, field in {argument: field for maker in made for argument, field in maker.fields.items()}.items():
        kind = kept[field - 1]
        of = {argument: kind for maker in made for argument, kind in maker.arguments}[argument]
        if kind in ("D", "NoYaw"):
            unused.append(argument)
        elif (special := SPECIAL.get((made[0].name, field))) and (kind == "Special" or "Circle" in made[0].name):
            limits.append(f"{argument}: {special}")
        elif argument == "corners":
            limits.append("corners: 3 to 255")  # src/mavmission/plan/Areas.h
        elif kind == "Sign" and vehicle == "plane":
            limits.append(f"{argument}: -1, 0 or 1")
        elif field == 7 and kind == "I16":
            limits.append(f"{argument}: whole metres")
        elif kind in LIMITS and of not in ("bool", "uint8_t"):
            limits.append(f"{argument}: {LIMITS[kind]}")
    if unused:
        limits.append(f"not used: {', '.join(unused)}")
    return "; ".join(limits) or "all"


def in_ardupilot(cells: dict[str, str]) -> str:
    """What its vehicles do: a copter, and in what another one differs."""
    others = [f"on a {vehicle} {cells[vehicle]}" for vehicle in ("plane", "rover") if cells[vehicle] != cells["copter"]]
    return "; ".join([cells["copter"], *others])


def tables() -> str:
    known = kinds()
    lines = []
    for title, part in makers():
        lines += [f"### {title}", "", "| function | | ArduPilot | PX4 |", "|---|---|---|---|"]
        for name in dict.fromkeys(maker.name for maker in part):
            made = [maker for maker in part if maker.name == name]
            comments = list(dict.fromkeys(maker.comment for maker in made if maker.comment))
            cells = {vehicle: cell(made, known[made[0].command, vehicle], vehicle) for vehicle in VEHICLES}
            signatures = "<br>".join(dict.fromkeys(maker.signature for maker in made))
            lines.append(f"| {signatures} | {' '.join(comments)} | {in_ardupilot(cells)} | {cells['PX4']} |")
        lines.append("")
    return "\n".join(lines)
