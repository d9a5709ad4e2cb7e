"""The console on a simulated Mega: the PlanConsole example, beside a fake autopilot, typed at and pasted into."""

from __future__ import annotations

import pytest

from example_runs import Run, commands, is_ardupilot
from plans import HOME, NAN, jump, waypoint

HEAD = ["QGC WPL 110", "0\t1\t0\t16\t0\t0\t0\t0\t-35.3632621\t149.1652374\t584.1\t1"]
SURVEY = [
    "1\t0\t3\t22\t0\t0\t0\t0\t-35.3632621\t149.1652374\t20\t1",
    "2\t0\t3\t16\t0\t0\t0\t0\t-35.3630000\t149.1652374\t20.5\t1",
    "3\t0\t3\t177\t2\t2\t0\t0\t0\t0\t0\t1",
    "4\t0\t3\t21\t0\t0\t0\t0\t-35.3632621\t149.1652374\t0\t1",
]
KEPT = "stored: list prints it"
PASSED_OVER = "nothing was loaded; further lines are ignored, up to end"
TORN = (0xFF, 0x00, 0x4D, 0xA5)  # what may be left of a byte whose writing was cut short


def long_plan(count: int) -> list[str]:
    zeros = "\t".join(["0.00000000"] * 4)
    return [
        f"{n}\t0\t3\t16\t{zeros}\t{-35.3632621 + n / 1e6:.8f}\t149.16523740\t{20 + n / 4:.6f}\t1"
        for n in range(1, count + 1)
    ]


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


@pytest.fixture
def console(personality):
    return Console(personality)


def test_a_plan_is_loaded_put_aboard_verified_and_listed(console):
    lines = console.load(*SURVEY)
    assert lines == ["send the file, then end", "1", "2", "3", "4", KEPT]
    lines = console.answer("upload", "aboard: our plan, whole")
    assert lines[-2:] == ["accepted: the plan is aboard", "aboard: our plan, whole"]
    assert "4/4" in lines
    assert commands(console) == [22, 16, 177, 21]
    assert console.autopilot.received()[-2].param1 == 1 + is_ardupilot(console)
    assert console.answer("verify", "aboard: our plan, whole")[-2] == "verified: what is aboard is the plan"
    assert console.listed() == ["QGC WPL 110", "0\t0\t0\t16\t0\t0\t0\t0\t0\t0\t0\t1", *(
        row.replace("\t3\t177", "\t2\t177") for row in SURVEY)]  # fmt: skip
    assert console.nothing_was_lost()


def test_a_plan_stays_when_the_power_goes(console):
    console.load(*SURVEY)
    before = console.listed()
    console.mega.reset()
    console.run(0.3)
    assert console.listed() == before
    console.answer("erase", "erased")
    console.mega.reset()
    console.run(0.3)
    assert console.answer("upload", "no plan is stored: type load") == ["no plan is stored: type load"]


@pytest.mark.slow
def test_a_reset_at_any_time_of_storing_leaves_the_old_plan_or_the_new_one():
    console = Console("PX4")
    old, new = long_plan(3), [row.replace("149.1", "148.1") for row in long_plan(4)]
    console.load(*old)
    old_list = console.listed()
    console.load(*new)
    new_list = console.listed()
    seen = set()
    for step in range(40):
        before, after = (old_list, new_list) if step % 2 else (new_list, old_list)
        if console.listed() != before:
            console.load(*before[2:])
        console.send("load", *after, "end")
        # A byte takes 3.4 ms: the power goes in the midst of one, or between two.
        console.run(0.030 + 0.0107 * (step // 2))
        torn = console.mega.eeprom_writing
        if torn is not None:
            console.mega.write_eeprom(torn, bytes((TORN[step % 4],)))
        console.mega.reset()
        console.run(0.1)
        now = console.listed()
        assert now in (before, after)
        seen.add(now == before)
    assert seen == {True, False}


@pytest.mark.parametrize("end", ["\n", "\r"])
def test_lines_end_as_the_terminal_ends_them(console, end):
    lines = console.load(*SURVEY, end=end)
    assert lines[-1] == KEPT
    console.send("load", *HEAD, SURVEY[0], "2 0 3 16 x", end=end)
    console.until("line 4, field 5: not a number", 3.0)


def test_bad_text_is_refused_with_its_line_and_the_old_plan_stays(console):
    console.load(*SURVEY)
    before = console.listed()
    console.send("load", *HEAD, SURVEY[0], SURVEY[1].replace("-35.36", "-95.36"), SURVEY[2], SURVEY[3], "end")
    said = "line 4, field 9: a latitude beyond 90 degrees"
    console.until(said, 3.0)
    console.run(1.0)
    assert console.lines[console.lines.index(said) :] == [said, PASSED_OVER, "nothing was loaded"]
    assert console.listed() == before
    console.mega.reset()
    console.run(0.2)
    assert console.listed() == before


@pytest.mark.parametrize("lines, said", [
    (["load", "end"], "line 1: the first line is not QGC WPL 110"),
    (["load", *HEAD, "end"], "line 3: no item after home"),
    (["load", *HEAD, SURVEY[0], SURVEY[2]], "line 4, field 1: the lines are not numbered 0, 1, 2, ..."),
    (["load", *HEAD, SURVEY[0], SURVEY[1], "upload"], "line 5: not a number"),
    (["load", *HEAD, SURVEY[0], SURVEY[1], SURVEY[2].replace("\t2\t2", "\t7\t2"), "end"],
     "line 5, field 5: a jump to home, or out of the plan"),
    (["load", "cancel"], "nothing was loaded"),
    (["end"], "nothing is being loaded: type load first"),
    (["list"], "no plan is stored: type load"),
    (["upload"], "no plan is stored: type load"),
    (["Verify"], "no plan is stored: type load"),
    (["fly"], "unknown command: type help"),
    (["downloadeverything"], "unknown command: type help"),
    (["hexlp\b\b\b", "he\x7f\x7fhelp"], "help: list the commands"),
])  # fmt: skip
def test_what_is_said_of_a_mistake(lines, said):
    console = Console("PX4")
    console.send(*lines)
    assert said in console.until(said, 3.0)
    assert KEPT not in console.lines
    # And the console goes on.
    console.send("end")
    console.run(0.2)
    assert console.answer("status", "stored: items 0")[-1] == "stored: items 0"


def test_more_items_than_the_eeprom_holds_are_refused(console):
    console.load(*SURVEY)
    before = console.listed()
    plan = long_plan(130)
    console.send("load", *HEAD, *plan[:90])
    console.run(4.0)
    console.send(*plan[90:], "end")
    console.until("item 128: more items than there is room for", 20.0)
    console.run(1.0)
    assert console.listed() == before
    assert console.nothing_was_lost()


def test_a_text_that_comes_faster_than_it_is_stored_is_refused(console):
    console.send("load", *HEAD, *long_plan(160), "end")
    console.until(PASSED_OVER, 20.0)
    assert [
        line
        for line in console.lines
        if line.endswith(": too fast for the EEPROM: send it line by line")
    ]
    console.run(1.0)
    assert console.answer("list", "no plan is stored: type load")[-1] == "no plan is stored: type load"


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


def test_status_and_help(console):
    console.run(2.5)
    lines = console.answer("status", "stored: items 0")
    assert lines == [
        f"{'ArduPilot' if is_ardupilot(console) else 'PX4'}, disarmed",
        "idle",
        "aboard: not known",
        "stored: items 0",
    ]
    lines = console.answer("help", "start: ARM, and fly the plan aboard")
    assert [line.partition(":")[0] for line in lines] == [
        "help", "status", "load", "end", "upload", "cancel", "erase", "list", "verify", "download", "clear",
        "start"]  # fmt: skip


def test_what_is_aboard_is_downloaded_and_kept(console):
    plan = [waypoint(-353632621, 1491652374, 20.0, param4=NAN), waypoint(-5, -1799999999, 20.5, frame=0, param4=NAN),
            jump(1 + is_ardupilot(console), 3), *(waypoint(n, n, float(n)) for n in range(1, 9))]  # fmt: skip
    console.autopilot.load([HOME, *plan] if is_ardupilot(console) else plan)
    lines = console.answer("download", KEPT, limit_s=15.0)
    assert "downloaded: the plan has been read" in lines
    rows = [line.split("\t") for line in console.listed()[2:]]
    assert [row[3] for row in rows] == ["16", "16", "177"] + ["16"] * 8
    assert rows[1][8:11] == ["-0.0000005", "-179.9999999", "20.5"]
    assert rows[2][4] == "2"
    assert console.nothing_was_lost()


@pytest.mark.slow
def test_a_download_that_fails_leaves_the_plan_that_is_kept(console):
    console.load(*SURVEY)
    before = console.listed()
    console.autopilot.load([waypoint(n, n, float(n)) for n in range(1, 201)])
    console.answer("download", "the plan aboard is too large for the sink", limit_s=60.0)
    console.run(1.0)
    assert console.listed() == before


def test_a_plan_that_is_aboard_is_cleared_and_differs(console):
    console.load(*SURVEY)
    console.answer("upload", "aboard: our plan, whole")
    console.answer("clear", "aboard: no plan")
    assert commands(console) == []
    lines = console.answer("verify", "aboard: not known")
    assert "what is aboard is not the plan" in lines and "what differs: number of items" in lines


@pytest.mark.slow
def test_start_that_is_refused_says_that_the_aircraft_is_disarmed_again():
    console = Console("ArduPilot")
    console.load(*SURVEY[:2], SURVEY[3].replace("4", "3", 1))
    console.answer("upload", "aboard: our plan, whole")
    console.autopilot._begins_with_takeoff = lambda: False
    lines = console.answer("start", "it is disarmed again", limit_s=60.0)
    assert "autopilot: failed" in lines
    console.run(1.2)
    assert not console.autopilot.armed
    assert "it is disarmed again" not in console.answer("verify", "aboard: our plan, whole", limit_s=20.0)


@pytest.mark.slow
def test_start_flies_what_is_aboard(console):
    assert console.answer("start", "aboard: not known", limit_s=8.0)[0].startswith(
        "the plan aboard may not be ours"
    )
    console.load(*SURVEY[:2], SURVEY[3].replace("4", "3", 1))
    console.answer("upload", "aboard: our plan, whole")
    console.answer("start", "done: the autopilot confirmed it", limit_s=60.0)
    assert console.autopilot.armed
    console.run(1.5)  # until its next heartbeat says so
    assert console.answer("upload", "the autopilot is armed")[-1] == "the autopilot is armed"
    assert console.autopilot.armed
