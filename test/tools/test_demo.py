"""tools/demo shows what happens, and says that all is well only when it is; the pages have the pictures it draws."""

from __future__ import annotations

import io
import re
import shlex
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from itertools import cycle, pairwise
from pathlib import Path

import pytest
from pymavlink import mavutil
from rich.console import Console

from building import ROOT, build_sketch
from demonstration import demonstration as inside
from demonstration.demonstration import Demonstration, Settings
from demonstration.named_frames import NamedFrame
from demonstration.plan_in_firmware import NotOnePlan, plan_in
from demonstration.screen import PlainScreen, TerminalScreen
from examples import example_folders
from refreshing.things import shows_the_same
from simulation.fake_autopilot import MISSION, ArduPilot

SKETCHES = Path(__file__).resolve().parents[1] / "demonstrated"
AUTOPILOTS = ["ardupilot", "px4"]
PAGES = [ROOT / "docs" / "simulation.md", ROOT / "docs" / "design" / "proof.md"]
COMMAND = re.compile(r"^(tools/demo .*--timeline (docs/[\w/]+\.svg))$", re.M)
COMMANDS = [found for page in PAGES for found in COMMAND.findall(page.read_text())]
# And StartMission flies as the README's sketch does, FollowBeacon as GoToPlaces.
WITH_TESTS_OF_THEIR_OWN = {"UploadMission", "StartMission", "GoToPlaces", "NextWaypoint", "WorkAtWaypoints",
                           "FollowBeacon", "GridFromFunction"}  # fmt: skip


def shown(example: str = "UploadMission", **settings) -> tuple[bool, str]:
    """Whether the verdict is good, and everything on the screen."""
    out = io.StringIO()
    screen = PlainScreen(out)
    verdict = Demonstration(Settings(example, fast=True, **settings), screen).run()
    screen.verdict(verdict.sentence, verdict.good)
    return verdict.good, out.getvalue()


def sketch(name: str) -> str:
    return str(SKETCHES / f"{name}.cpp")


@pytest.mark.parametrize("autopilot", AUTOPILOTS)
def test_first_example_ends_with_its_plan_aboard(autopilot):
    good, text = shown(autopilot=autopilot)
    assert good, text
    assert "its plan: survey, 4 items in flash" in text
    assert "MISSION_COUNT" in text and "MISSION_ACK ACCEPTED" in text
    assert text.splitlines()[-1].startswith("The plan is aboard: all")


@pytest.mark.slow
def test_flight_that_ends_elsewhere_is_good_where_it_is_disarmed():
    good, text = shown("NextWaypoint", vehicle="rover")
    assert good and text.splitlines()[-1].endswith(
        "has been at 2 places, and is disarmed on the ground 23 m from home."
    )


@pytest.mark.slow
def test_flight_that_has_not_ended_is_a_failure_with_the_places_so_far():
    good, text = shown("GoToPlaces", fly_s=20.0)
    place, verdict = text.splitlines()[-2:]
    assert place == "place 1: 32 m from the one before, 10.0 m up"
    assert not good and verdict.startswith("FAILED: after 20 s ArduPilot is still armed, 10.0 m up.")


@pytest.fixture(scope="module")
def flight_of_the_readme(tmp_path_factory) -> str:
    text = (ROOT / "README.md").read_text().split("## A flight", 1)[1]
    folder = tmp_path_factory.mktemp("readme") / "ReadmeFlight"
    folder.mkdir()
    (folder / "ReadmeFlight.ino").write_text(text.split("```cpp\n", 1)[1].split("```", 1)[0])
    return str(folder)


@pytest.mark.slow
@pytest.mark.parametrize("autopilot", AUTOPILOTS)
def test_the_flight_of_the_readme_is_good_as_it_stands(autopilot, flight_of_the_readme):
    good, text = shown(flight_of_the_readme, autopilot=autopilot, described={"flies": True})
    assert good and "is disarmed on the ground at home" in text.splitlines()[-1], text


@pytest.mark.slow
def test_each_work_is_done_and_the_landing_is_known_on_a_lossy_link():
    good, text = shown("WorkAtWaypoints", byte_loss_percent=3, seed=5)
    said = re.findall(r"Serial +(at the stop of item \d|landed)", text)
    assert good and said == ["at the stop of item 1", "at the stop of item 2", "landed"]


@pytest.mark.slow
@pytest.mark.parametrize("autopilot", AUTOPILOTS)
def test_plan_that_each_autopilot_gets_differently_is_judged_right(autopilot):
    good, text = shown(sketch("many_kinds"), autopilot=autopilot)
    assert good, text
    assert "Serial             accepted: the plan is aboard" in text


# (test/documents/test_examples_run.py has each beside both.)
@pytest.mark.slow
@pytest.mark.parametrize(
    ("example", "autopilot"), [*zip(sorted({*example_folders()} - WITH_TESTS_OF_THEIR_OWN), cycle(AUTOPILOTS))]
)
def test_each_example_runs_to_a_good_end(example, autopilot):
    good, text = shown(example, autopilot=autopilot)
    assert good, text


def test_lost_and_repeated_frames_are_marked():
    good, text = shown(autopilot="px4", loss_percent=25, seed=1)
    assert good, text
    assert "[lost]" in text and "[again]" in text


@pytest.mark.slow
def test_plan_in_ram_is_judged_as_it_was_when_the_upload_began():
    good, text = shown(sketch("in_ram"))
    assert good, text
    assert "route, 2 items in RAM" in text
    assert "-35.3620276" in text  # 12,345 further north than the linker left it


@pytest.mark.slow
def test_plan_from_a_function_is_judged_by_what_was_sent():
    good, text = shown("GridFromFunction", autopilot="px4")
    assert good, text
    assert "comes from a function" in text
    assert "all 302 items" in text


def test_line_that_loses_everything_is_a_failure(monkeypatch):
    monkeypatch.setattr(inside, "LIMIT_S", 20.0)
    good, text = shown(loss_percent=100)
    assert not good
    assert text.splitlines()[-1].startswith("FAILED: ")


def test_sketch_that_uploads_nothing_is_a_failure():
    good, text = shown("ReadTelemetry", described={"limit_s": 3.0})
    assert not good
    assert "FAILED: in 3 s the sketch began no upload." in text


class Tampered(ArduPilot):
    """Holds another item than it was sent."""

    def received(self, mission_type=MISSION):
        items = super().received(mission_type)
        return [*items[:2], items[2]._replace(x=items[2].x + 1), *items[3:]] if len(items) > 2 else items


class Forgetful(ArduPilot):
    """Says that it holds fewer items than it took."""

    def plan(self, mission_type=MISSION):
        return super().plan(mission_type)[:-1]


@pytest.mark.parametrize(
    ("fake", "says"), [(Tampered, "FAILED: 1 of 5 items differ."), (Forgetful, "holds 4 items, not 5")]
)
def test_one_bit_of_difference_aboard_is_a_failure(monkeypatch, fake, says):
    monkeypatch.setattr(inside, "an_autopilot", lambda name, vehicle: fake(response_delay_s=0.006))
    good, text = shown()
    assert not good
    assert says in text
    assert ("<-- DIFFERS" in text) == (fake is Tampered)


def test_log_is_read_by_the_ground_stations_library(tmp_path):
    file = tmp_path / "upload.tlog"
    assert shown(log=file, autopilot="px4")[0]
    log = mavutil.mavlink_connection(str(file), dialect="common")
    names, times = [], []
    while (message := log.recv_match()) is not None:
        names.append(message.get_type())
        times.append(message._timestamp)
    assert names.count("MISSION_ITEM_INT") == 4
    assert names.count("MISSION_ACK") == 1
    assert "BAD_DATA" not in names
    assert times == sorted(times)
    assert 3 < times[-1] - times[0] < 30


def test_terminal_gets_the_bar_and_the_table():
    out = io.StringIO()
    screen = TerminalScreen(Console(file=out, force_terminal=True, width=160, color_system=None))
    verdict = Demonstration(Settings(fast=True), screen).run()
    screen.verdict(verdict.sentence, verdict.good)
    screen.close()
    assert verdict.good
    assert "5/5" in out.getvalue() and "aboard" in out.getvalue()
    assert "\x1b[?25h" in out.getvalue()  # the cursor is back


# The plan in the firmware ---------------------------------------------------


@pytest.mark.slow
def test_several_plans_must_be_told_apart():
    elf = build_sketch("FenceAndRally").elf
    with pytest.raises(NotOnePlan, match="fence, rallyPoints"):
        plan_in(elf)
    assert plan_in(elf, "rallyPoints").count == 2
    with pytest.raises(NotOnePlan, match="no plan called east"):
        plan_in(elf, "east")


# The timeline -------------------------------------------------------------


def words_in(picture: Path) -> str:
    return "\n".join("".join(element.itertext()) for element in ElementTree.parse(picture).iter()
                     if element.tag.endswith("}text"))  # fmt: skip


def test_pages_show_each_picture_that_their_commands_draw():
    drawn = [ROOT / picture for _, picture in COMMANDS]
    shown = [page.parent / picture for page in PAGES
             for picture in re.findall(r"\]\(((?:upload|recovered|lossy)\.svg)\)", page.read_text())]  # fmt: skip
    assert drawn == shown
    assert len(drawn) == 3


@pytest.mark.slow
@pytest.mark.parametrize(("command", "picture"), COMMANDS)
def test_picture_on_the_page_shows_what_its_command_draws(command, picture, tmp_path):
    fresh = tmp_path / "fresh.svg"
    words = [str(fresh) if word == picture else word for word in shlex.split(command)[1:]]
    subprocess.run([sys.executable, ROOT / "tools" / "demo", *words], check=True, capture_output=True)
    assert shows_the_same((ROOT / picture).read_bytes(), fresh.read_bytes()), f"run  tools/refresh {picture}"


def test_lost_answer_and_what_recovered_it_are_in_the_picture():
    words = words_in(ROOT / "docs" / "recovered.svg")
    for expected in ("ACK ACCEPTED, lost", "ITEM_INT 4, again", "ACK ERROR", "REQUEST_LIST"):
        assert expected in words
    clean = words_in(ROOT / "docs" / "upload.svg")
    assert ", lost" not in clean and ", again" not in clean
    assert "ACK ACCEPTED" in clean


def test_each_frame_takes_its_bytes_time_and_none_overlaps_another():
    demonstration = Demonstration(Settings(autopilot="px4", fast=True), PlainScreen(io.StringIO()))
    demonstration.run()
    byte_s = demonstration._line.byte_s
    assert 10 / byte_s == pytest.approx(57600, rel=0.03)
    crossed = demonstration._line.crossed
    assert {crossing.entry.direction for crossing in crossed} == {">", "<"}
    for crossing in crossed:
        least = len(crossing.entry.data) * byte_s
        # The sketch may be late with a byte in the middle of a frame; the autopilot's come in slices of 1 ms.
        assert least - 1e-9 <= crossing.ended - crossing.began < least + 0.004, crossing
    for way in "><":
        spans = sorted((crossing.began, crossing.ended) for crossing in crossed if crossing.entry.direction == way)
        assert all(after[0] >= before[1] - 1e-6 for before, after in pairwise(spans))


def test_named_frame_is_lost_and_no_other():
    _, text = shown(autopilot="px4", lose=(NamedFrame("MISSION_ITEM_INT:3"),))
    lost = [line for line in text.splitlines() if "[lost]" in line]
    assert len(lost) == 1 and "MISSION_ITEM_INT 2:" in lost[0]
    assert "MISSION_ITEM_INT:3 lost" in text.splitlines()[0]


# The tool -------------------------------------------------------------------


def run_tool(*arguments: str) -> subprocess.CompletedProcess:
    return subprocess.run([sys.executable, ROOT / "tools" / "demo", *arguments], capture_output=True, text=True)


def test_tool_exits_with_a_good_verdict_and_without_colours_in_a_pipe():
    ran = run_tool("--fast", "--autopilot", "px4")
    assert (ran.returncode, ran.stderr) == (0, "")
    assert "\x1b" not in ran.stdout


@pytest.mark.slow
def test_tool_exits_with_a_bad_verdict():
    ran = run_tool("--fast", "--fly", "8")
    assert ran.returncode == 1 and "FAILED: in 8 s the sketch has not armed ArduPilot." in ran.stdout
