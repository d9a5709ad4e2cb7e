"""The Python that runs in the browser: the simulated autopilot and wire as they are here, in one archive.

What cannot run there is replaced: the C parser by the same C as WebAssembly (inside/hearing_parser.py), and what the
compiled library is asked for of the commands by a table of its answers.
"""

from __future__ import annotations

import json
import zipfile
from pathlib import Path

from building import ROOT
from planning import judge
from simulation.enumerators import texts_of

INSIDE = Path(__file__).resolve().parent / "inside"
NO_DATE = (1980, 1, 1, 0, 0, 0)  # the same files make the same archive

SIMULATION = ("__init__", "wire")
DEMONSTRATION = ("__init__", "autopilots", "conversation", "frame_names", "line", "named_frames", "timeline", "words")
PLANNING = (
    "__init__", "bad_plan", "commands", "exact", "files", "flight", "header", "json_text", "kml_path",
    "landing_pattern", "litchi", "located_json", "makers", "plan", "progress", "qgc_mission", "qgc_plan",
    "recognising", "settling", "unset", "waypoints",
)  # fmt: skip
OWN = ("drawn", "explained", "autopilot_end", "interference")
RECORDINGS = ("px4/clean_with_streams.txt",)


def contents() -> dict[str, bytes]:
    """What is in the archive, by its name there."""
    found: dict[str, bytes] = {}
    simulation = ROOT / "simulation"
    for name in SIMULATION:
        found[f"simulation/{name}.py"] = (simulation / f"{name}.py").read_bytes()
    for file in sorted((simulation / "fake_autopilot").glob("*.py")):
        found[f"simulation/fake_autopilot/{file.name}"] = file.read_bytes()
    found["simulation/fake_autopilot/hearing_parser.py"] = (INSIDE / "hearing_parser.py").read_bytes()
    found["simulation/recordings/__init__.py"] = (simulation / "recordings" / "__init__.py").read_bytes()
    for recording in RECORDINGS:
        found[f"simulation/recordings/{recording}"] = (simulation / "recordings" / recording).read_bytes()
    for name in DEMONSTRATION:
        found[f"demonstration/{name}.py"] = (ROOT / "tools" / "demonstration" / f"{name}.py").read_bytes()
    for name in PLANNING:
        found[f"planning/{name}.py"] = (ROOT / "tools" / "planning" / f"{name}.py").read_bytes()
    found["planning/judge.py"] = (INSIDE / "judge.py").read_bytes()
    found["planning/commands.txt"] = (ROOT / "tools" / "planning" / "commands.txt").read_bytes()
    found["known.json"] = json.dumps(judge.known()).encode()
    found["errors.json"] = json.dumps(judge.text_errors()).encode()
    found["ends.json"] = json.dumps(ends()).encode()
    found["mavmission_dialect.py"] = (ROOT / "build" / "dialect" / "mavmission_dialect.py").read_bytes()
    for name in OWN:
        found[f"inside/{name}.py"] = (INSIDE / f"{name}.py").read_bytes()
    return found


def ends() -> list[str]:
    """How an operation can end, as a sketch prints it: the texts of mavmission::Status behind those of its way."""
    texts = texts_of("Status.h", "MAVMISSION_STATUSES")
    return list(texts.values())[list(texts).index("Transferring") + 1 :]


def make_world(archive: Path) -> None:
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as out:
        for name, data in contents().items():
            info = zipfile.ZipInfo(name, NO_DATE)
            info.compress_type = zipfile.ZIP_DEFLATED
            out.writestr(info, data)
