"""The example that uploads a .waypoints file, beside a fake autopilot: its text in flash, and files on a card.

The card is simulation/sketches/card/SD.h, which is to the example what the SD library is.
"""

from __future__ import annotations

from functools import cache

from example_runs import Run, commands, is_ardupilot
from examples import sketch_of
from simulation.fake_autopilot import mavlink
from simulation.firmware import ROOT, build_firmware
from simulation.mega import Image

SKETCH = sketch_of("PlanFromSd")
CARD = ROOT / "simulation" / "sketches" / "card"
HEAD = "QGC WPL 110\r\n0\t1\t0\t16\t0\t0\t0\t0\t-35.3632621\t149.1652374\t584\t1\r\n"


def with_slashes_removed(sketch: str) -> str:
    """As the sketch's comment tells to do for a card."""
    told, what, rest = sketch.partition("remove the two slashes at the beginning of the next line:\n")
    assert what and rest.startswith("// #define CARD_SELECT 10\n")
    return told + what + rest.removeprefix("// ")


@cache
def image_with_card() -> Image:
    source = ROOT / "build" / "examples" / "PlanFromSdWithCard.cpp"
    source.parent.mkdir(parents=True, exist_ok=True)
    sketch = with_slashes_removed(SKETCH.read_text())
    source.write_text(f'#include <Arduino.h>\n#line 1 "{SKETCH}"\n{sketch}')
    return Image.load(build_firmware("PlanFromSdWithCard", [source], include_dirs=[CARD]))


class RunWithCard(Run):
    def __init__(self, personality: str, text: str | None) -> None:
        super().__init__("PlanFromSd", personality, image=image_with_card())
        self.put(b"" if text is None else text.encode())
        if text is None:
            self.mega.poke_int("cardSize", 0xFFFF)

    def put(self, text: bytes) -> None:
        self.mega.poke("cardText", text.ljust(4000, b"\0"))
        self.mega.poke_int("cardSize", len(text))
        self.mega.poke_int("cardReadable", len(text))


def waypoints(count: int) -> str:
    rows = (
        f"{n}\t0\t3\t16\t{n % 5}\t0\t0\t0\t{-35.3632621 + n / 1e5:.7f}\t149.1652374\t{20 + n}.25\t1\r\n"
        for n in range(1, count + 1)
    )
    return HEAD + "".join(rows)


def test_plan_from_sd(personality):
    example = Run("PlanFromSd", personality)
    lines = example.until("accepted: the plan is aboard", 6.0)
    assert lines == ["items: 5", "accepted: the plan is aboard"]
    assert commands(example) == [22, 16, 16, 177, 20]
    items = example.autopilot.received()
    assert [(one.x, one.y, one.z) for one in items[-4:-2]] == [
        (-353632621, 1491652374, 20.0),
        (-353614500, 1491652374, 25.5),
    ]
    assert items[-2].param1 == 1 + is_ardupilot(example)  # the file's item 2


def test_a_file_on_a_card():
    example = RunWithCard("ArduPilot", waypoints(60))
    lines = example.until("accepted: the plan is aboard", 15.0)
    assert lines == ["items: 60", "accepted: the plan is aboard"]
    items = example.autopilot.received()[-60:]
    assert [(one.x, one.z) for one in items] == [(-353632621 + 100 * n, 20.25 + n) for n in range(1, 61)]


def test_a_bad_file_is_not_uploaded_nor_one_that_is_not_there():
    example = RunWithCard("PX4", HEAD + "1\t0\t3\t16\t0\t0\t0\t0\t-95.0\t149.1\t20\t1")
    example.until("line 3, field 9: a latitude beyond 90 degrees", 3.0)
    missing = RunWithCard("PX4", None)
    lines = missing.until("line 1: it cannot be read to its end", 3.0)
    assert lines[0] == "no card, or no PLAN.TXT on it"
    for one in (example, missing):
        one.run(3.0)
        assert not one.autopilot.messages(">", "MISSION_COUNT")


def test_a_card_that_is_pulled_during_the_upload_ends_it():
    example = RunWithCard("ArduPilot", waypoints(40))
    while len(example.autopilot.messages(">", "MISSION_ITEM_INT")) < 10:
        example.run(0.01)
        assert example.now < 10
    example.mega.poke_int("cardReadable", 300)
    assert example.until("the plan's source gave no item", 3.0)[-1] == "the plan's source gave no item"
    assert example.autopilot.messages(">", "MISSION_ACK")[-1].type == mavlink.MAV_MISSION_OPERATION_CANCELLED
