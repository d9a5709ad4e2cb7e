"""The playground's page in a browser, as a test sees it."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, ClassVar

from playing.browser import Browser
from playing.serving import Server
from simulation.fake_autopilot import FakeAutopilot

STARTS_S = 240.0
ENDS_S = 240.0

# What an example that does not arm shows in the page when it has done its work: where, and which words.
DONE = {
    "UploadMission": ("#outcome", "are aboard ArduPilot as they were meant, and the Mega knows it."),
    "UploadWithProgress": ("#console", "aboard: our plan, whole"),
    "EnsureMission": ("#console", "aboard: our plan, whole"),
    "VerifyUpload": ("#console", "aboard: our plan, whole"),
    "DownloadMission": ("#console", "downloaded: the plan has been read"),
    "GridFromFunction": ("#outcome", "are aboard ArduPilot as they were meant, and the Mega knows it."),
    "FenceAndRally": ("#outcome", "are aboard ArduPilot as they were meant, and the Mega knows it."),
    "UploadByFile": ("#outcome", "are aboard ArduPilot as they were meant, and the Mega knows it."),
    "PlanFromSd": ("#console", "accepted: the plan is aboard"),
    "LinkDoctor": ("#console", "all is well"),
    "ReadTelemetry": ("#console", "-353632621 1491652374"),
    "FitLight": ("#console", "fit: all is well"),
    "CheckParameters": ("#console", "MIS_RESTART: 1.00 done: the autopilot confirmed it"),
}
# How high each one flies [m] that lands by itself; what it prints then is "landed".
FLOWN = {
    "StartMission": 10, "NextWaypoint": 10, "WorkAtWaypoints": 10, "GoToPlaces": 10, "FollowBeacon": 10,
    "StartButton": 10, "FlyByButtons": 5,
}  # fmt: skip

_GO = """
history.replaceState(null, "", arguments[0]);
dispatchEvent(new HashChangeEvent("hashchange"));
document.getElementById("again").click();
"""
_REST = """
const pause = document.getElementById("pause");
if (pause.textContent === "Pause") pause.click();
"""
# A run that begins after this stands still until a step lets it run: the autopilot's end is not given what the Mega
# has sent before that, and the Mega waits for its answer. So what a test does meanwhile, however slow the machine,
# takes none of the page's time.
_HOLD = """
const Free = MessageChannel;
window.stepped = { slices: 0, held: [], release: () => (window.MessageChannel = Free) };
window.MessageChannel = class {
  constructor() {
    const toFar = new Free(), toMega = new Free();
    [this.port1, this.port2] = [toFar.port1, toMega.port1];
    const line = (window.stepped = { ...window.stepped, slices: 0, held: [] });
    line.give = () => {
      while (line.held.length && line.held[0].slice < line.slices) toFar.port2.postMessage(line.held.shift());
    };
    line.release = () => {
      window.MessageChannel = Free;
      line.slices = Infinity;
      line.give();
    };
    toMega.port2.onmessage = ({ data }) => {
      line.held.push(data);
      line.give();
    };
    toFar.port2.onmessage = ({ data }) => {
      toMega.port2.postMessage(data);
      if (data.slice === line.slices - 1) line.done();
    };
  }
};
"""
_STEP = """
const { stepped: line } = window, [arriving, slices] = arguments;
if (arriving.length) window.arrives(arriving);
await new Promise((done) => {
  line.done = done;
  line.slices += slices;
  line.give();
});
return [window.heard.splice(0), document.getElementById("outcome").innerText];
"""
SLICE_S = 0.005  # tools/playing/page/mega/worker.js
STEP_SLICES = 20
_DROP = """
const [name, text] = arguments;
const data = new DataTransfer();
data.items.add(new File([text], name));
for (const kind of ["dragenter", "dragover", "drop"]) {
  document.getElementById("map").dispatchEvent(
    new DragEvent(kind, { dataTransfer: data, bubbles: true, cancelable: true }));
}
"""


# Where the map and what can be pressed stand, from the top left of the page, but for what a run brings.
_PLACES = """
const own = "#pins, #points, #errors, #drawn-part, #typing, details, #told";
const found = [...document.querySelectorAll("main button, main select, main input, main label, #map")]
  .filter((one) => one.checkVisibility() && !one.closest(own));
return Object.fromEntries(found.map((one) => {
  const { left, top, width, height } = one.getBoundingClientRect();
  return [one.id || one.textContent.trim(), [left + scrollX, top + scrollY, width, height].map(Math.round)];
}));
"""


class Page:
    """One page that has been opened; a run of it after another."""

    first_words = first_loaded = ""
    first_shown = 0
    first_places: ClassVar[dict[str, list[int]]] = {}
    # From the address to the map, to the first aircraft in the air (of a recorded run), and to the Mega's power-on.
    shown_s = flown_s = ready_s = 0.0
    asked_for: tuple[str, ...] | list[str] = ()

    def __init__(self, browser: Browser, server: Server) -> None:
        self.browser = browser
        self.address = server.address

    def open(self, hash_: str = "") -> None:
        """From the server, until the autopilot has loaded; what is seen meanwhile is kept."""
        self.browser.requests()
        self.load(hash_, "shownMs")
        self.first_words = self.outcome  # while the autopilot loads
        self.first_shown = self.on_map(".grid") + self.on_map(".point.meant")
        self.first_places = self.places
        self.browser.wait_for("return document.body.dataset.readyMs", STARTS_S)
        self.first_loaded = self.value("document.getElementById('fetched-words').textContent")
        self.flown_s = int(self.value("document.body.dataset.flownMs || 1e9")) / 1000
        self.shown_s = int(self.value("document.body.dataset.shownMs")) / 1000
        self.ready_s = int(self.value("document.body.dataset.readyMs")) / 1000
        self.asked_for = [address for address in self.browser.requests()
                          if not address.startswith(("chrome", "data:", "about:"))]  # fmt: skip

    def load(self, hash_: str, until: str = "readyMs") -> None:
        """The whole page anew."""
        self.browser.go("about:blank")
        self.browser.go(self.address + hash_)
        self.browser.wait_for(f"return document.body.dataset.{until}", STARTS_S)

    def rest(self) -> None:
        """Pause the run, until begin()."""
        self.browser.run(_REST)

    def begin(self, hash_: str) -> None:
        """Another address on the same page: everything begins anew."""
        self.browser.run(_GO, hash_)

    def hold(self) -> None:
        """The next run stands still, but for speak_with()."""
        self.browser.run(_HOLD)

    def speak_with(self, autopilot: FakeAutopilot, until: str, limit_s: float = 90.0) -> bytes:
        """The autopilot is behind window.arrives() and window.heard until the outcome contains this; what it heard.

        Of a run that began after hold(), which is free then. limit_s: of the page's time.
        """
        now, arriving, said, outcome = 0.0, b"", b"", ""
        while until not in outcome:
            assert now < limit_s, f"not within {limit_s} s: {until}; it says: {outcome}"
            heard, outcome = self.browser.run(_STEP, list(arriving), STEP_SLICES)
            now += STEP_SLICES * SLICE_S
            autopilot.receive(bytes(heard), now)
            arriving = autopilot.run(now)
            said += bytes(heard)
        self.browser.run("window.stepped.release()")
        return said

    def drop(self, name: str, text: str) -> None:
        self.browser.run(_DROP, name, text)

    def wait_until_good(self, limit_s: float = ENDS_S) -> str:
        self.browser.wait_for("return document.getElementById('outcome').dataset.state === 'good'", limit_s)
        return self.outcome

    def wait_for_text(self, selector: str, text: str, limit_s: float = ENDS_S) -> None:
        script = f"return document.querySelector({json.dumps(selector)}).innerText.includes({json.dumps(text)})"
        self.browser.wait_for(script, limit_s)

    @property
    def outcome(self) -> str:
        return self.browser.text("#outcome")

    @property
    def notice(self) -> str:
        return self.browser.text("#notice")

    @property
    def frames(self) -> list[str]:
        """What crossed the line, the oldest first."""
        return self.browser.text("#frames").splitlines()[::-1]

    def on_map(self, selector: str) -> int:
        """How many elements of the map are such."""
        return self.browser.run("return document.querySelectorAll('#map ' + arguments[0]).length", selector)

    def value(self, script: str) -> Any:
        return self.browser.run(f"return {script}")

    @property
    def places(self) -> dict[str, list[int]]:
        """left, top, width and height of the map and of what can be pressed, by id."""
        return self.browser.run(_PLACES)

    def shot(self, file: Path) -> None:
        self.browser.screenshot(file)
