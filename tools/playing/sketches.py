"""The examples as the page has them: each one's .hex as it was compiled, and what is known of it."""

from __future__ import annotations

import json
import math
import re
import shutil
from collections.abc import Callable, Iterable
from functools import partial
from pathlib import Path
from typing import Any

from building import ROOT, build_sketch
from demonstration.autopilots import HELD, NAMES
from demonstration.demonstration import description, plans_of
from demonstration.wire_form import on_the_wire
from demonstration.words import item_in_words
from examples import example_folder, example_folders, sketch_of
from simulation.fake_autopilot import MISSION, Item
from simulation.mega import Image

# What the Arduino core calls behind each pass through loop().
PASS = "serialEventRun()"
# Parts of start(), and of Steering, which are linked where a sketch arms: such a sketch is not given a real aircraft.
ARMING = re.compile(
    r"mavmission::(detail::(Client::(Starting::on|Arming::fillDisarming)|StartTransfer::leave)"
    r"|Steering::(fill|leave|onEvent|beginStep))\("
)
# Such a sketch reads what is typed: itself, or by what it gives its console to.
LISTENS = re.compile(r"\(CONSOLE,|CONSOLE\.(read|available|parse|find)")
# A sketch that can be ordered something.
PAYLOAD = "mavmission::Payload::take("
# constexpr uint8_t kFlyOrLand = 2, kForward = 3; and HoldButton button(kFlyOrLand, 2000).
CONSTANTS = re.compile(r"^constexpr uint8_t (.*?);", re.M)
PIN = re.compile(r"k(\w+?)(?:Pin)? = (\d+)$")
HOLDS = re.compile(r"^HoldButton \w+\((?:k(\w+?)(?:Pin)?|(\d+))(?:, (\d+))?\)", re.M)
HOLD_MS = 1000  # HoldButton's own [ms]
NOT_HERE = "REMOVE THE PROPELLERS WHILE YOU TRY IT."  # said of a real aircraft
CARD = "PlanFromSd"  # the text that it has without a card is the file on the card


def make_sketches(folder: Path, loads: int, tell: Callable[[str], None]) -> None:
    """folder/NAME.hex and NAME.ino for each example, and folder/examples.json. loads: what the page fetches before its
    first run [bytes]; tell: is called with what is compiled next."""
    folder.mkdir(parents=True, exist_ok=True)
    # In the order in which one learns, which is README.md's.
    readme = (ROOT / "README.md").read_text()
    names = sorted(example_folders(), key=lambda name: readme.index(f"\n| [{name}]("))
    examples = []
    for number, name in enumerate(names, start=1):
        examples.append(made(name, folder, partial(tell, f"{number} of {len(names)}: {name}")))
    # Most items are in several examples: each is in the list once.
    items: dict[str, int] = {}
    for example in examples:
        for kinds in example.get("meant", {}).values():
            for kind, pairs in kinds.items():
                kinds[kind] = [items.setdefault(json.dumps(pair), len(items)) for pair in pairs]
    known = {"examples": examples, "card": text_of(CARD), "items": [json.loads(pair) for pair in items], "loads": loads,
             "held": {autopilot: values(on_the_wire(HELD, autopilot)) for autopilot in NAMES}}  # fmt: skip
    (folder / "examples.json").write_text(json.dumps(known, separators=(",", ":"), allow_nan=False) + "\n")


def made(name: str, folder: Path, compiling: Callable[[], None]) -> dict[str, Any]:
    built = build_sketch(example_folder(name), compiling=compiling)
    shutil.copyfile(built.hex, folder / f"{name}.hex")
    shutil.copyfile(sketch_of(name), folder / f"{name}.ino")
    image = Image.load(built.elf)
    source = sketch_of(name).read_text()
    described = description(name)
    reads = described.get("reads", False)
    plans = plans_of(built.elf, described) if "runs_s" not in described and not reads else {}
    # A plan in RAM may change before it is sent: of it, as of one that a function computes, what is sent is meant.
    fixed = {kind: plan.items(no_ram) for kind, plan in plans.items() if not plan.in_ram}
    meant = {
        autopilot: {kind: on_the_wire(items, autopilot) if kind == MISSION else items for kind, items in fixed.items()}
        for autopilot in NAMES
    }
    known = {
        "name": name,
        "says": said(sketch_of(name)),
        "flash": built.flash,
        "ram": built.ram,
        "pass": image.symbol(PASS).address,
        "reads": reads,
        "arms": any(ARMING.match(symbol.name) for symbol in image.symbols),
        "prints": "CONSOLE" in source,
        "listens": LISTENS.search(source) is not None,
        "ordered": any(symbol.name.startswith(PAYLOAD) for symbol in image.symbols),
        "pins": pins_of(source),
        "meant": {autopilot: {kind: list(zip(values(items), map(item_in_words, items), strict=True))
                              for kind, items in kinds.items()}
                  for autopilot, kinds in meant.items() if kinds},
    }  # fmt: skip
    return {key: value for key, value in known.items() if value}  # what is not there is false, or nothing


def pins_of(source: str) -> dict[str, str]:
    """What a sketch calls its pins, and how long a button is to be held, by their numbers."""
    named = [PIN.match(one) for line in CONSTANTS.findall(source) for one in line.split(", ")]
    numbers = {match[1]: match[2] for match in named if match}
    words = {number: re.sub(r"(?<!^)([A-Z])", r" \1", name).lower() for name, number in numbers.items()}
    for name, number, ms in HOLDS.findall(source):
        pin = number or numbers[name]
        held = f"hold it for {int(ms or HOLD_MS) / 1000:g} s"
        words[pin] = f"{words[pin]}, {held}" if pin in words else held
    return words


def text_of(name: str) -> str:
    """The plan that an example has in its text."""
    return "".join(json.loads(line) for line in re.findall(r'^ +("[^"]*\\n")', sketch_of(name).read_text(), re.M))


def no_ram(address: int, size: int) -> bytes:
    raise AssertionError("a plan in flash asks for no RAM")


def values(items: Iterable[Item]) -> list[list]:
    """As JSON has them: a number that is unset is null, and one that is whole has no point."""
    return [
        [None if math.isnan(value) else int(value) if value == int(value) else value for value in item]
        for item in items
    ]


def said(sketch: Path) -> str:
    """The comment at the head of a sketch."""
    lines = []
    for line in sketch.read_text().splitlines():
        if not line.startswith("//"):
            break
        lines.append(line.removeprefix("//").strip())
    text = " ".join(lines).partition(" With a card")[0]
    return " ".join(text.replace(NOT_HERE, "").split())
