"""A run of the example that the page opens with, as the page is told of it: shown until Python has come.

Recorded where the page is made, with the simulated Mega of the tests, and kept until the firmware or the autopilot's
end changes.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

from building import BUILD, build_sketch
from demonstration.autopilots import EXAMPLES_FLY_AT
from simulation.mega import Mega

EXAMPLE, AUTOPILOT = "StartMission", "ardupilot"
LASTS_S = 60.0
SLICE_CYCLES = 80_000  # 5 ms
TOLD_EVERY_S = 0.2
BAUD = 57600.0


def make_recorded(file: Path, world: Path, tell: Callable[[str], None]) -> None:
    """file: what the page reads. world: the archive of the page's Python. tell: is called where it is recorded anew."""
    elf = build_sketch(EXAMPLE).elf
    key = hashlib.sha256(elf.read_bytes() + world.read_bytes() + Path(__file__).read_bytes()).hexdigest()[:16]
    kept = BUILD / "playground" / f"recorded-{key}.json"
    if not kept.is_file():
        tell("the run that the page opens with")
        kept.parent.mkdir(parents=True, exist_ok=True)
        for old in kept.parent.glob("recorded-*.json"):
            old.unlink(missing_ok=True)
        text = json.dumps(recorded(elf), separators=(",", ":"))
        fresh = kept.with_suffix(f".{file.parent.parent.name}.new")
        fresh.write_text(text)
        fresh.replace(kept)
    file.write_text(kept.read_text())


def recorded(elf: Path) -> dict[str, Any]:
    """{example, autopilot, from: the time of the takeoff, which is shown first, told: [[time, news, printed], ...]}."""
    from .inside.autopilot_end import AutopilotEnd

    mega = Mega(elf)
    end = AutopilotEnd(json.dumps({
        "autopilot": AUTOPILOT, "loss": 0, "bytes": 0, "seed": 0, "hz": mega.hz, "arms": True, "home": EXAMPLES_FLY_AT,
    }))  # fmt: skip
    told: list[list] = []
    takes_off_s = 0.0
    printed = b""
    while (now := mega.cycle / mega.hz) < LASTS_S:
        mega.run_until(mega.cycle + SLICE_CYCLES)
        printed += bytes(one.byte for one in mega.serial(0).sent())
        sent = mega.serial(1).sent()
        arriving = end.step(now, bytes(one.byte for one in sent), [one.left for one in sent], BAUD)
        if arriving:
            mega.serial(1).send(arriving, mega.cycle)
        if now < (told[-1][0] if told else 0.0) + TOLD_EVERY_S:
            continue
        news = json.loads(end.news() or "{}")
        for frame in news.get("frames", []):
            frame["hex"] = ""  # its fields are Python's to explain
            frame.update({key: round(frame[key], 6) for key in ("at", "began", "ended")})
        news["frames"] = [
            {key: value for key, value in frame.items() if value or key not in ("again", "lost")}
            for frame in news.get("frames", []) if frame["text"]
        ]  # fmt: skip
        if not takes_off_s and news.get("vehicle", {}).get("height", 0) > 0:
            takes_off_s = now
        told.append([round(now, 3), news, printed.decode(errors="replace")])
        printed = b""
    return {"example": EXAMPLE, "autopilot": AUTOPILOT, "from": round(takes_off_s, 3), "told": told}
