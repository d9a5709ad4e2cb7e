"""Everything in the repository that is made of something else: its name, what goes into it, how it is made.

What is made in no time is made each time, and compared. What has to be measured or drawn names its inputs: it is stale
when their digest is another one than in test/figures/measured.toml, and so are figures that were changed there by hand.
It is then made again, unless it has a sample: something short, measured first. Where that comes out as it did before,
within its share, all of it would.
"""

from __future__ import annotations

import functools
import importlib
import operator
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from building import ROOT
from measuring import documents, record

from . import fetched, items, keywords, readback, statuses

Files = dict[Path, bytes]
UPLOADER = "examples/01.First/UploadMission"
COMPILED = ("src", UPLOADER, "tools/building.py", "simulation/firmware.py")
SIMULATED = (*COMPILED, "simulation")
WRITING = {"record", "documents"}  # of tools/measuring: what writes figures down, and measures none
HOST = ("src", "simulation/host_build.py", "simulation/hearing", "test/host/Frames.cpp", "test/host/arduino")


@dataclass(frozen=True)
class Thing:
    name: str
    made: Callable[[], Files]
    inputs: tuple[str, ...] = ()
    sample: Callable[[], record.Section] | None = None
    share: float = 0.0
    is_same: Callable[[bytes, bytes], bool] = operator.eq  # what is kept and what was made
    group: str = ""  # of tools/setup, beside demo
    # Of a section of test/figures/measured.toml, what is measured, and how it is compared.
    measure: Callable[[], record.Section] | None = None
    more_is_better: tuple[str, ...] = ()

    def beyond(self, fresh: record.Section) -> list[str]:
        """What of it is beyond its bound, or far from what is recorded."""
        return record.beyond(record.load()[self.name], fresh, more_is_better=self.more_is_better)

    def broken(self) -> list[str]:
        """What of the record is beyond its bound."""
        return self.beyond(record.section(self.name))

    def stale_files(self) -> Files:
        """Those that are to be written."""
        return {file: data for file, data in self.made().items()
                if not file.exists() or not self.is_same(file.read_bytes(), data)}  # fmt: skip


def later(module: str, name: str) -> Callable:
    """A function of a module that needs what tools/setup demo brings; the table's names are known without."""
    package = "refreshing" if module == "commands" else "measuring"
    return lambda *values: getattr(importlib.import_module(f"{package}.{module}"), name)(*values)


def text(file: str, make: Callable[[], str]) -> Callable[[], Files]:
    return lambda: {ROOT / file: make().encode()}


def table(name: str, make: Callable[[], str], *inputs: str, **more) -> Thing:
    """What stands between the marks of this name in a document."""

    def made() -> Files:
        place = documents.place_of(name)
        return {place: documents.with_table(place.read_text(), name, make()).encode()}

    return Thing(name, made, inputs, **more)


def measured(name: str, module: str, function: str, *inputs: str) -> Thing:
    """A table that is measured, and not kept elsewhere."""
    return table(name, later(module, function), *inputs, *modules_of(module))


def recorded(name: str, make: Callable[..., str], *sections: str) -> Thing:
    """A table of what is in test/figures/measured.toml."""
    return table(name, lambda: make(*map(record.section, sections)))


@functools.cache
def modules_of(name: str) -> tuple[str, ...]:
    """This one of tools/measuring, the sketches that it runs, and the modules that it measures with."""
    file = f"tools/measuring/{name}.py"
    text = (ROOT / file).read_text()
    imports = re.findall(r"^from \.(\w*) import (.*)$", text, re.M)
    others = {other for module, names in imports for other in ([module] if module else names.split(", "))} - WRITING
    sketches = [f"test/measured/{sketch}.cpp" for sketch in re.findall(r'measured\("(\w+)"', text)]
    own = [file, *sketches, *["test/measured/items.h"] * bool(sketches)]
    return tuple(dict.fromkeys([*own, *(one for other in sorted(others) for one in modules_of(other))]))


def section(name: str, module: str, function: str, *inputs: str, has_bounds: bool = True,
            more_is_better: tuple[str, ...] = (), **more) -> Thing:  # fmt: skip
    """Of test/figures/measured.toml."""
    measure = later(module, function)
    inputs = tuple(dict.fromkeys([*inputs, *modules_of(module)]))

    def made() -> Files:
        fresh = measure()
        whole = record.load()
        bounded = record.with_bounds(fresh, whole.get(name), more_is_better=more_is_better)
        whole[name] = bounded if has_bounds else fresh
        return {record.FILE: in_order(whole).encode()}

    return Thing(name, made, inputs, measure=measure, more_is_better=more_is_better, **more)


def in_order(whole: dict) -> str:
    """The record's text: its sections as they are listed below, then what they were made from."""
    names = [record.MADE_WITH, *(thing.name for thing in THINGS if thing.measure), SAMPLES, MADE_FROM]
    return record.text_of({name: whole[name] for name in names if whole.get(name)})


def printed_by(*command: str) -> str:
    """Raises RuntimeError with what it said, if it fails."""
    ran = subprocess.run([sys.executable, *command], cwd=ROOT, capture_output=True, text=True, check=False)
    if ran.returncode != 0:
        raise RuntimeError(f"{' '.join(command)}: {ran.stderr}")
    return ran.stdout


def udp() -> str:
    return printed_by("test/support/udp_rates.py").rstrip("\n")


# Pictures -------------------------------------------------------------------------------------------


def shown(picture: bytes) -> set[str]:
    """What a picture says in words, figures apart: those hang on each cycle."""
    texts = ("".join(element.itertext()) for element in ElementTree.fromstring(picture).iter()
             if element.tag.endswith("}text"))  # fmt: skip
    return {re.sub(r"\d[\d.]*", "", words).strip() for words in texts}


def shows_the_same(kept: bytes, fresh: bytes) -> bool:
    return shown(kept) == shown(fresh)


def drawn(file: str, *command: str) -> Callable[[], Files]:
    def made() -> Files:
        with tempfile.TemporaryDirectory() as folder:
            fresh = Path(folder) / Path(file).name
            printed_by(*command, str(fresh))
            return {ROOT / file: fresh.read_bytes()}

    return made


def timeline(file: str, *options: str) -> Thing:
    """The picture of a run, as the page that shows it says how to draw it."""
    return Thing(file, drawn(file, "tools/demo", "--fast", *options, "--timeline"), ("src", UPLOADER, "simulation",
                 "tools/demonstration"), is_same=shows_the_same, group="pictures")  # fmt: skip


# All of them, those first that others are made from -----------------------------------------------

SAMPLES, MADE_FROM = "samples", "made_from"  # tables of test/figures/measured.toml
THINGS = (
    Thing("keywords", text("keywords.txt", keywords.keywords)),
    Thing("commands", text("tools/planning/commands.txt", later("commands", "table"))),
    Thing("statuses", statuses.pages),
    table("read-back", readback.table),
    table("items", items.tables),
    section("figures", "figures", "measured_ours", *SIMULATED, more_is_better=("cpu_left_57600", "cpu_left_115200")),
    section("baseline", "figures", "measured_baseline", "test/baseline", "src/mavmission/mavlink", "simulation",
            "tools/baseline.py", "tools/building.py", has_bounds=False),
    section("features", "features", "features", *COMPILED),
    section("stack", "calls", "stacks", *SIMULATED),
    section("updates", "updates", "longest_updates", *SIMULATED, sample=later("updates", "sample"), share=record.SHARE),
    section("signing", "costs", "signing", *SIMULATED, more_is_better=("0 ms", "1 ms", "2 ms", "5 ms")),
    section("work", "costs", "work", *SIMULATED),
    section("growth", "costs", "growth", *SIMULATED),
    recorded("in short", later("figures", "in_short"), "figures"),
    recorded("measured", later("figures", "for_documents"), "figures", "baseline"),
    recorded("features", later("features", "table"), "features"),
    recorded("signing", later("costs", "signing_table"), "signing"),
    recorded("work", later("costs", "work_table"), "work"),
    recorded("growth", later("costs", "growth_table"), "growth"),
    measured("quiet transfers", "times", "quiet_transfers", *SIMULATED),
    measured("files", "times", "files", *SIMULATED),
    measured("rates", "rates", "for_documents", *HOST, "test/rates", "test/explorer"),
    table("udp", udp, *HOST, "simulation/fake_autopilot", "test/day/client.cpp", "test/support/udp_rates.py",
          "test/support/udp_client.py", "test/support/datagrams.py"),
    timeline("docs/upload.svg"),
    timeline("docs/recovered.svg", "--lose", "MISSION_ACK:1"),
    timeline("docs/design/lossy.svg", "--loss-bytes", "3", "--seed", "5"),
    Thing("docs/playground.png", drawn("docs/playground.png", "tools/playground", "--picture"),
          ("tools/playing/page", "docs/farm.plan"), group="browser"),
    Thing("fetched", text("test/figures/fetched.toml", fetched.made), ("tools/setup", "tools/requirements")),
)  # fmt: skip
