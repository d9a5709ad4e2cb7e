"""A build of ArduPilot's simulator that the visitor brings, in the place of the simulated autopilot; here a script with
the build's interface takes its place, and the tests' own ArduPilot speaks through it."""

from __future__ import annotations

from pathlib import Path

import pytest

from played import Page
from simulation.fake_autopilot import ArduPilot

pytestmark = pytest.mark.slow

STAND_IN = Path(__file__).with_name("stand_in.js")
BINARY = [0, 97, 115, 109]
GLOBAL_POSITION_INT = 33
HOME = (-353632621, 1491652374, 584.0)
CHOOSE = """
const [script, binary, names] = arguments;
window.started = null;
window.heard = [];
window.arrives = (bytes) => window.channel.postMessage({ bytes });
window.channel?.close();
window.channel = new BroadcastChannel("vehicle");
window.channel.onmessage = ({ data: { started, heard } }) => {
  if (started) window.started = started;
  else window.heard.push(...heard);
};
const data = new DataTransfer();
for (const [name, text] of [[names[0], script], [names[1], Uint8Array.from(binary)]]) {
  if (name) data.items.add(new File([text], name));
}
const chooser = document.getElementById("build");
chooser.files = data.files;
chooser.dispatchEvent(new Event("change"));
"""


@pytest.fixture
def own(page):
    """The page with a sketch that arms; behind the test without a build."""
    page.begin("#example=StartMission")
    page.browser.run("document.getElementById('own-build').open = true")
    yield page
    page.browser.run("window.stepped?.release()")
    page.browser.run("document.getElementById('end-build').click()")
    page.browser.run("document.getElementById('own-build').open = false")


def choose(page: Page, names: tuple[str, str] = ("arducopter.js", "arducopter.wasm")) -> None:
    page.browser.run(CHOOSE, STAND_IN.read_text(), BINARY, names)


def test_the_sketch_uploads_to_a_build_and_starts_it(own):
    own.hold()
    choose(own)
    own.wait_for_text("#build-says", "It runs, and the emulated Mega's Serial1 is its SERIAL0.")
    started = own.value("window.started")
    assert started["isShared"] and started["binary"] == BINARY and started["script"].startswith("blob:")
    words = started["words"]
    assert words[:4] == ["--model", "quad", "--home", "-35.3632621,149.1652374,584,0"]
    assert words[6:] == ["--serial0", "wasm", "--serial1", "none", "--serial2", "none"]
    assert words[4] == "--defaults" and "FRAME_CLASS 1" in started["files"][words[5]].splitlines()
    # It is simulated: a sketch that arms may run, and its line may be broken.
    assert own.value("document.getElementById('example').value") == "StartMission"
    assert own.value("[...document.getElementById('example').options].some((one) => one.disabled)") is False
    assert not own.value("document.getElementById('cable').disabled")
    assert own.value("document.getElementById('pilot').disabled")

    autopilot = ArduPilot(heartbeat_at_s=0.0, home=HOME, uptime_s=60.0)
    autopilot.set_interval(GLOBAL_POSITION_INT, 250_000, 0.0)
    own.speak_with(autopilot, "The autopilot has accepted all 5 items. In flight, in AUTO.")
    assert len(autopilot.received()) == 5 and autopilot.armed
    assert own.browser.text("#vehicle").startswith("AUTO, armed")
    assert own.on_map(".aircraft[visibility=visible]") == 1


def test_a_build_that_ends_is_told_and_the_simulated_autopilot_is_used_again(own):
    choose(own, ("ardurover.js", "ardurover.wasm"))
    own.wait_for_text("#build-says", "It runs")
    assert own.value("window.started.words")[1] == "rover"
    own.browser.run("window.channel.postMessage({ abort: 'it reboots' })")
    own.wait_for_text("#notice", "ArduPilot has ended: it reboots. The simulated autopilot is used again.")
    assert own.wait_until_good().startswith("All ")


@pytest.mark.parametrize(("names", "says"), [
    (("arducopter.js", ""), "choose both files of a build, such as arducopter.js and arducopter.wasm"),
    (("", "arducopter.wasm"), "choose both files of a build, such as arducopter.js and arducopter.wasm"),
])  # fmt: skip
def test_files_that_are_no_build_are_refused_in_words(own, names, says):
    choose(own, names)
    own.wait_for_text("#build-says", f"ArduPilot was not started: {says}.")
    assert own.value("document.getElementById('end-build').disabled")


def test_a_script_that_is_no_module_of_a_build_is_refused(own):
    own.browser.run(CHOOSE, "export default 7;", BINARY, ["arducopter.js", "arducopter.wasm"])
    own.wait_for_text("#build-says", "ArduPilot was not started: arducopter.js cannot be started: ")
    assert own.wait_until_good().startswith("All ")
