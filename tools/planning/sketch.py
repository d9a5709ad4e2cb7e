"""A sketch of a plan: it puts the plan aboard and lists what came back; for tools/demo --plan and a real Mega."""

from __future__ import annotations

import re
from pathlib import Path

from .bad_plan import BadPlan, shown_name
from .files import write_text
from .header import header_of, namespace_of
from .plan import KINDS, Plan

TEMPLATE = Path(__file__).resolve().with_name("round_trip.cpp.in")
TYPES = dict(zip(KINDS, ("PlanType::Mission", "PlanType::Fence", "PlanType::Rally"), strict=True))


def write_sketch(plan: Plan, folder: Path) -> Path:
    """Writes the sketch and its header into `folder`, whose name the sketch bears; the .ino."""
    if not re.fullmatch(r"[A-Za-z0-9][A-Za-z0-9_.-]{0,62}", folder.name):
        raise BadPlan(folder, None, "Arduino wants letters, digits, '.', '_' and '-' in a sketch's name")
    namespace = namespace_of(plan)
    header = f"{namespace}.h"
    text = header_of(plan)
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise BadPlan(folder, None, f"cannot be made: {error.strerror}") from None
    write_text(folder / header, text)
    sketch = folder / f"{folder.name}.ino"
    write_text(sketch, sketch_of(plan, header, namespace))
    return sketch


def sketch_of(plan: Plan, header: str, namespace: str) -> str:
    cases = [f"    case {n}:\n      return inFlash({namespace}::{kind});" for n, kind in enumerate(plan.kinds)]
    filled = {
        "FILE": shown_name(plan.file),
        "HEADER": header,
        "PARTS": str(len(plan.kinds)),
        "TYPES": ", ".join(TYPES[kind] for kind in plan.kinds),
        "CASES": "\n".join(cases),
    }
    return re.sub(r"@([A-Z]+)@", lambda match: filled[match[1]], TEMPLATE.read_text())
