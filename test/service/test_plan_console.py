"""The PlanConsole example on a simulated Mega: port, EEPROM, and flight. host/units/plan_console.cpp has more."""

from __future__ import annotations

import pytest

from example_runs import Run, commands, is_ardupilot

HEAD = ["QGC WPL 110", "0\t1\t0\t16\t0\t0\t0\t0\t-35.3632621\t149.1652374\t584.1\t1"]
SURVEY = [
    "1\t0\t3\t22\t0\t0\t0\t0\t-35.3632621\t149.1652374\t20\t1",
    "2\t0\t3\t16\t0\t0\t0\t0\t-35.3630000\t149.1652374\t20.5\t1",
    "3\t0\t3\t177\t2\t2\t0\t0\t0\t0\t0\t1",
    "4\t0\t3\t21\t0\t0\t0\t0\t-35.3632621\t149.1652374\t0\t1",
]
KEPT = "stored: list prints it"


class Console(Run):
    """The example on a Mega; the keyboard is Serial."""

    def __init__(self, personality: str, **options) -> None:
        super().__init__("PlanConsole", personality, **options)
        self.run(0.1)

    def send(self, *lines: str, end: str = "\r\n") -> None:
        self.mega.serial(0).send("".join(line + end for line in lines).encode())

    def answer(self, line: str, last: str, limit_s: float = 5.0) -> list[str]:
        """What it prints after a line is sent, up to `last`."""
        before = len(self.lines)
        self.send(line)
        limit = self.now + limit_s
        while last not in self.lines[before:]:
            assert self.now < limit, f"{last!r} was not printed within {limit_s} s:\n" + "\n".join(self.lines[before:])
            self.run(0.05)
        return self.lines[before : before + self.lines[before:].index(last) + 1]

    def load(self, *lines: str, **options) -> list[str]:
        before = len(self.lines)
        self.send("load", *HEAD, *lines, "end", **options)
        limit = self.now + 2 + 0.12 * len(lines)
        while KEPT not in self.lines[before:]:
            assert self.now < limit, "it was not kept:\n" + "\n".join(self.lines[before:])
            self.run(0.05)
        return self.lines[before:]

    def listed(self) -> list[str]:
        before = len(self.lines)
        self.send("list")
        self.run(0.5)
        while True:
            said = len(self._said)
            self.run(0.2)
            if len(self._said) == said:
                return self.lines[before:]

    def nothing_was_lost(self) -> bool:
        return self.mega.serial(0).lost == 0 and self.mega.serial(1).lost == 0


def test_a_plan_is_stored_uploaded_downloaded_and_flown(personality):
    console = Console(personality)
    assert console.load(*SURVEY) == ["send the file, then end", "1", "2", "3", "4", KEPT]
    plan = ["QGC WPL 110", "0\t0\t0\t16\t0\t0\t0\t0\t0\t0\t0\t1", *(
        row.replace("\t3\t177", "\t2\t177") for row in SURVEY)]  # fmt: skip
    console.mega.reset()
    console.run(0.3)
    assert console.listed() == plan
    lines = console.answer("upload", "aboard: our plan, whole")
    assert "4/4" in lines and lines[-2:] == ["accepted: the plan is aboard", "aboard: our plan, whole"]
    assert commands(console) == [22, 16, 177, 21]
    assert console.autopilot.received()[-2].param1 == 1 + is_ardupilot(console)
    assert console.answer("verify", "aboard: our plan, whole")[-2] == "verified: what is aboard is the plan"
    console.answer("erase", "erased")
    console.mega.reset()
    console.run(2.3)
    assert console.answer("upload", "no plan is stored: type load") == ["no plan is stored: type load"]
    assert "downloaded: the plan has been read" in console.answer("download", KEPT, limit_s=15.0)
    assert [row.replace("\tnan", "\t0") for row in console.listed()] == plan
    console.answer("clear", "aboard: no plan")
    assert commands(console) == []
    assert "what differs: number of items" in console.answer("verify", "aboard: not known")
    console.answer("start", "the plan aboard may not be ours", limit_s=8.0)
    console.answer("upload", "aboard: our plan, whole")
    console.answer("start", "done: the autopilot confirmed it", limit_s=60.0)
    console.run(1.5)  # until its next heartbeat says that it is armed
    assert console.answer("upload", "the autopilot is armed")[-1] == "the autopilot is armed"
    assert console.nothing_was_lost()


def test_a_text_of_which_bytes_were_lost_is_refused():
    console = Console("PX4")
    # Numbers that take longer to read than the line takes to bring the next: the port's ring runs over.
    row = "\t".join(
        ["1\t0\t3\t16", *["1.234567890123456789e-37"] * 4, "-35.3632621", "149.1652374", "9.99999999999999999e-38", "1"]
    )
    console.send("load", *HEAD, row, "end")
    too_fast = "line 3: too fast for the EEPROM: send it line by line"
    assert too_fast in console.until(too_fast, 3.0)
    console.run(1.0)
    assert console.answer("list", "no plan is stored: type load")[-1] == "no plan is stored: type load"
    console.send("load", *HEAD)
    console.run(0.5)
    for field in row.split("\t"):
        console.send(field, end=" ")
        console.run(0.1)
    console.send("", "end")
    assert console.until(KEPT, 3.0)[-1] == KEPT
    assert len(console.listed()) == 3


@pytest.mark.slow
def test_start_that_is_refused_says_that_the_aircraft_is_disarmed_again():
    console = Console("ArduPilot")
    console.load(*SURVEY[:2], SURVEY[3].replace("4", "3", 1))
    console.answer("upload", "aboard: our plan, whole")
    console.autopilot._begins_with_takeoff = lambda: False
    lines = console.answer("start", "it is disarmed again", limit_s=60.0)
    assert "autopilot: failed; its text says why" in lines
    console.run(1.2)
    assert not console.autopilot.armed
    assert "it is disarmed again" not in console.answer("verify", "aboard: our plan, whole", limit_s=20.0)
