// The page: what is chosen on it goes to two workers, and what they say is shown.

import { ArduPilotBuild } from "./ardupilot/build.js";
import { AUTOPILOTS, hashOf, MOST_SEED, PLAIN, stateOf } from "./address.js";
import { packed, unpacked } from "./carried.js";
import { EventLog } from "./event_log.js";
import { saved } from "./download.js";
import { Drawing } from "./drawing.js";
import { Dropped } from "./dropped.js";
import { Editor } from "./editor.js";
import { showFields } from "./fields.js";
import { Frames } from "./frames.js";
import { BUTTONS, flightInWords, headline } from "./headline.js";
import { PlanMap } from "./map.js";
import { numbered, numberOf } from "./numbers.js";
import { entryOf, exampleOf, isSketch } from "./own.js";
import { PinPanel } from "./pins.js";
import { Playback } from "./playback.js";
import { isOffered, Pixhawk } from "./pixhawk.js";
import { hasPlace } from "./places.js";
import { Timeline } from "./timeline.js";
import { vcdOf } from "./vcd.js";

const HZ = 16_000_000;
const RAM = 8192;
const FLASH = 253952;
const EXAMPLES_FLY_AT = [-353632621, 1491652374, 584]; // latitude, longitude [1e-7 degrees], altitude [m]
const MOST_TEXT = 60000; // of the console [characters]
const SLOW = 0.95;
const STORES = "PlanConsole stores your plan";
const KEPT = "PlanConsole waits for a command: the plan that it had is still in the EEPROM.";
const STOPPED = "PlanConsole refused the plan, or failed: the serial monitor says why.";
const TOO_LONG = "The address does not carry the plan: it is too long for one.";
const HAS_CPP = ". Its C++ for a sketch stands under “Your own plan”.";
const WAS_DRAWN = "it takes the place of the plan that you drew, which the browser's “Back” brings back";
const IN_PLACE_OF_HOME = "nothing, in the place of the autopilot's home";
// What PlanConsole does with a dropped plan that is aboard, by its step.
const NEXT = {
  2: " PlanConsole verifies it.", 3: " PlanConsole starts it.", 4: " PlanConsole has verified and started it.",
};
// What is done to the simulated line, and not to a real one; and to the simulated autopilot.
const LINE = ["loss", "bytes", "seed", "cable", "lose", "latency"];
const AUTOPILOT = ["reset-autopilot", "pilot", "lands", "battery", "station"];
const NOT_ARMING = "UploadMission"; // which a real autopilot gets instead of one that arms
const WRITTEN = "your sketch";
const SHOWN_EVERY_MS = 150;
const LARGEST_FILE = 64_000_000; // bytes, as tools/planning takes it
const KINDS = { 0: "plan", 1: "fence", 2: "rally points" };
const NAMES = { ardupilot: "ArduPilot", px4: "PX4", port: "the Pixhawk", build: "ArduPilot" };

const at = (id) => document.getElementById(id);
const map = new PlanMap(at("map"));
const timeline = new Timeline(at("timeline"), (frame) => frames.selectFrame(frame));
const frames = new Frames(at("frames"), ({ hex }) => hex && python.postMessage({ does: "explain", hex }));
const eventLog = new EventLog(at("event-log"));
const pins = new PinPanel(at("pins"), (pin, isDown) => mega.postMessage({ does: "press", pin, isDown }));
const editor = new Editor({
  area: at("source"), compile: at("compile"), back: at("source-back"), errors: at("errors"), says: at("compiler-says"),
}, () => {
  notice("");
  whenCompiled = state.example;
}, (made) => runOwn(entryOf({
  ...made, name: WRITTEN, image: made.hex, says: "The sketch as it is written in the editor.",
}), state.example === whenCompiled));
const playback = new Playback(({ now, news, printed }) => {
  showNews({ now, news });
  if (printed) print(printed);
});
const drawing = new Drawing(map, at("points"), drawn);
const mega = new Worker("mega/worker.js", { type: "module" });
const python = new Worker("python/worker.js", { type: "module" });

let known = null; // examples.json
let ends = []; // how an operation can end, in the sketch's words
let state = { ...PLAIN };
let run = 0;
let isReady = false; // the autopilot has loaded
let isOutside = false; // something else is in the place of the simulated autopilot
let isPort = false; // a serial port, at which there may be a real aircraft
let plan = null; // the plan that was dropped onto the page
let dropped = null; // and is being put aboard
let progress = {};
let held = {};
let isPaused = false;
let onCard = ""; // the plan that was dropped last, as the Mega's SD card has it
let latest = ["Loading.", "loading"]; // what outcome() was told last
let files = null; // of the plan that was drawn or dropped last: {name, cpp, plan, waypoints, errors}
let seen = {}; // {heard, vehicle, flown, read, said}: what there was to see of the run
let line = ""; // of the sketch's, as far as it has printed it
let verdict = null; // of what is aboard: {good, knows, replaced, sentence}
let ramFree = null;
let whenCompiled = ""; // the example that was chosen when the editor's sketch was given to the compiler
let shownLater = null;

const hearOutside = (bytes) => python.postMessage({ does: "outside", bytes });
const pixhawk = new Pixhawk(hearOutside, (why) => {
  if (!isOutside) return;
  notice(`The real autopilot is no longer connected: ${why}. The simulated one is used again.`);
  goOutside("");
});
const build = new ArduPilotBuild(hearOutside, (why) => {
  if (!isOutside) return;
  notice(`ArduPilot has ended: ${why}. The simulated autopilot is used again.`);
  goOutside("");
});

// Telling

function notice(text, isTrouble = true) {
  at("notice").textContent = text;
  at("told").hidden = at("notice").hidden = !text;
  at("notice").classList.toggle("trouble", isTrouble);
}

function outcome(text, kind = "going") {
  const place = at("outcome");
  const isPulled = isReady && !isPort && state.cable === "pulled";
  const whole = `${isPaused ? "Paused. " : ""}${isPulled ? "The cable is pulled: nothing passes. " : ""}${text}`;
  latest = [text, kind];
  if (place.textContent !== whole) place.textContent = whole;
  place.dataset.state = kind;
}

const example = () => known.examples.find((one) => one.name === state.example);
const autopilot = () => (isOutside ? (isPort ? "port" : "build") : state.autopilot);
const isOrdered = () => example().ordered && !isOutside;
const isConsole = () => state.example === "PlanConsole";

// One run, from power-on

function begin() {
  run++;
  playback.stop();
  clearTimeout(shownLater);
  shownLater = null;
  progress = {};
  held = {};
  seen = {};
  line = "";
  verdict = null;
  dropped = null;
  if (!isConsole()) plan = null;
  if (isReady && !plan && state.plan) change({ plan: "" }, false);
  const home = placeOf(plan) || EXAMPLES_FLY_AT;
  map.forget(isPort ? null : { x: home[0], y: home[1], height: home[2] });
  map.show({ meant: meantItems() });
  timeline.forget();
  at("console").textContent = "";
  frames.forget();
  eventLog.forget();
  pins.forget(example().pins);
  if (isOrdered()) pins.offer("Send “lower 2 m of rope”", () => python.postMessage({ does: "interfere", who: "order" }));
  showFields(at("fields"), null);
  setPace(1);
  at("vehicle").textContent = isPort ? "" : "The aircraft is not known yet.";
  showItems();
  showSizes();
  if (!isReady) return;
  outcome(firstWords());
  const { port1, port2 } = new MessageChannel();
  const { loss, bytes, latency } = isPort ? PLAIN : state;
  const settings = {
    autopilot: isOutside ? "outside" : state.autopilot, loss, bytes, latency, seed: state.seed, hz: HZ, home,
    arms: Boolean(example().arms),
    held: example().reads && !isOutside ? known.held[state.autopilot] : null,
  };
  python.postMessage({ does: "start", settings, port: port1, number: run }, [port1]);
  if (!isPort && state.cable === "pulled") python.postMessage({ does: "cable", joined: false });
  if (!isPort && state.lose === "ack") python.postMessage({ does: "loseNext", name: "MISSION_ACK" });
  const number = run;
  firmwareOf(example())
    .then((hex) => {
      if (number !== run) return;
      const { pass } = example();
      mega.postMessage({ does: "start", hex, pass, card: onCard || known.card, port: port2, number }, [port2]);
      if (plan) dropped = new Dropped(plan, type, ends);
    })
    .catch((error) => number === run && outcome(`${example().name} was not loaded: ${error.message}.`, "bad"));
}

async function firmwareOf({ image, name }) {
  return image || (await fetch(`examples/${name}.hex`)).text();
}

function firstWords() {
  if (plan) return `${STORES}.`;
  if (isConsole()) return "PlanConsole waits for a command: type help, or choose a plan of your own.";
  if (example().reads) return `The Mega reads the plan that ${NAMES[autopilot()]} holds.`;
  return `The Mega is looking for ${NAMES[autopilot()]}.`;
}

// What the sketch does while no plan is on its way.
function tellOfSketch() {
  if (!isReady) return;
  const { name, reads, prints } = example();
  if (plan || isConsole() || Object.keys(progress).length) return;
  const told = { ...seen, name, reads, prints, ordered: isOrdered(), autopilot: NAMES[autopilot()] };
  outcome(headline(told), seen.read ? "good" : "going");
}

// Whether item 0 of the plan on the wire is home.
function hasHome() {
  return isOutside ? !isPort || progress.plan?.sent[0]?.words === IN_PLACE_OF_HOME : state.autopilot === "ardupilot";
}

function placeOf(read) {
  if (!read) return null;
  if (read.home?.some((value) => value !== 0)) return read.home;
  const first = read.items.find(hasPlace);
  return first ? [first.x, first.y, 0] : null;
}

function meantItems() {
  if (plan) return numbered("plan", plan.items, false);
  return Object.entries(meant()).flatMap(([kind, items]) =>
    numbered(KINDS[kind], items.map(([[frame, command, , , param1, , , , x, y, z], words], seq) => ({
      seq, frame, command, param1, x, y, z, kind: KINDS[kind], words,
    })), hasHome()));
}

// What the sketch is meant to put aboard: [values, words] of each item, by kind.
function meant() {
  const listed = Object.entries(example().meant?.[state.autopilot] || {});
  return Object.fromEntries(listed.map(([kind, items]) => [kind, items.map((turn) => known.items[turn])]));
}

function type(text) {
  mega.postMessage({ does: "type", text });
}

// What the workers say

mega.onmessage = ({ data }) => {
  if (data.run !== run) return;
  if (data.says === "printed") print(data.text);
  if (data.says === "measured") showMeasured(data);
  if (data.says === "pins") showPins(data.state);
  if (data.says === "reset") map.show({ arrived: [] });
  if (data.says === "crashed") outcome(`The Mega has crashed: ${data.why}`, "bad");
};
mega.onerror = (error) => outcome(`The Mega's worker has failed: ${error.message}`, "bad");

python.onmessage = ({ data }) => {
  const { says } = data;
  if (says === "loading") loading(data.what);
  if (says === "fetched") showFetched(data.bytes);
  if (says === "ready") ready(data);
  if (says === "read") take(data);
  if (says === "drawn" && drawing.points.length) showFiles({ name: "drawn", ...data.files });
  if (says === "explained") showFields(at("fields"), data.frame);
  if (says === "failed") outcome(`It cannot go on: ${data.why}`, "bad");
  if (data.run !== run) return;
  if (says === "news") showNews(data);
  if (says === "judged") judged(data.verdict);
  if (says === "outside") (isPort ? pixhawk : build).send(data.bytes);
};
python.onerror = (error) => outcome(`The autopilot's worker has failed: ${error.message}`, "bad");

function showPins(state) {
  pins.show(state);
  if (seen.waits === state.inputs.length > 0) return;
  seen.waits = state.inputs.length > 0;
  if (verdict) judged(verdict);
  else tellOfSketch();
}

function loading(what) {
  if (playback.isOn) return;
  const then = what === "Python" ? "Python, 13 MB" : "its messages and its parser";
  outcome(`The autopilot is loading: ${then}. Then the Mega is switched on.`, "loading");
}

function showFetched(bytes) {
  const all = known?.loads || 0;
  const seconds = Math.round(performance.now() / 1000);
  at("fetched").value = all && Math.min(1, bytes / all);
  const of = `${(bytes / 1e6).toFixed(1)} of ${(all / 1e6).toFixed(1)} MB, ${seconds} s`;
  at("fetched-words").textContent = bytes < all ? of : `${of}: all is here, and is being started`;
}

// Until the autopilot is there, the run that the page opens with is shown as it was recorded.
async function playRecorded() {
  const isRecorded = Object.keys(PLAIN).every((name) => name === "draw" || state[name] === PLAIN[name]);
  if (isReady || !isRecorded) return;
  await playback.begin("examples/recorded.json");
  if (isReady) playback.stop();
  else outcome(`A recorded run of ${state.example} is shown while the autopilot is loading.`, "loading");
}

function ready({ ms, ends: told }) {
  isReady = true;
  ends = told;
  document.body.dataset.readyMs = Math.round(ms);
  at("loading").hidden = true;
  playback.stop();
  askForFiles();
  if (known) beginOrCarry();
}

// The plan in the address is read first, if there is one.
async function beginOrCarry() {
  const word = state.plan;
  if (!word) return begin();
  try {
    const { name, bytes } = await unpacked(word);
    python.postMessage({ does: "read", name, bytes, word }, [bytes]);
  } catch {
    notice("The plan in the address is damaged, and is ignored.");
    change({ plan: "" }, true);
  }
}

function print(text) {
  const place = at("console");
  const isAtEnd = place.scrollTop + place.clientHeight >= place.scrollHeight - 8;
  place.append(text.replaceAll("\r", "")); // a text of its own: a screen reader says what is new
  while (place.textContent.length > MOST_TEXT) place.firstChild.remove();
  if (isAtEnd) place.scrollTop = place.scrollHeight;
  const lines = `${line}${text}`.split(/\r?\n/);
  line = lines.pop();
  seen.said = lines.findLast((one) => one.trim()) || seen.said;
  tellOfSketch();
  if (lines.length) eventLog.say(seen.said, timeline.now);
  if (!dropped) return;
  const step = dropped.step;
  dropped.hear(text);
  if (!dropped.step && dropped.stored) outcome(`${STORES}: ${dropped.stored} of ${dropped.count} items.`);
  if (dropped.step !== step && verdict?.good) judged(verdict);
  if (dropped.failed) outcome(dropped.why ? `The plan was refused: ${dropped.why}` : STOPPED, "bad");
}

function showNews({ now, news }) {
  for (const event of news.events || []) {
    timeline.addEvent(event);
    eventLog.add(event);
  }
  seen.read ||= news.read;
  seen.heard ||= news.frames?.some(({ way, lost, text }) => way === "<" && !lost && text.startsWith("HEARTBEAT"));
  if (news.frames) {
    timeline.add(news.frames, now);
    frames.add(news.frames);
    eventLog.hear(news.frames);
  } else {
    timeline.add([], now);
  }
  if (news.held) Object.assign(held, news.held);
  const isNews = [Boolean(news.held), ...Object.entries(news.progress || {}).map(([kind, now]) => learn(kind, now))];
  if (isNews.includes(true)) showLater();
  if (news.vehicle) {
    map.move(news.vehicle);
    const { armed, mode, height, item } = news.vehicle;
    const before = flightInWords(seen);
    seen.vehicle = news.vehicle;
    at("pilot").textContent = news.vehicle.pilots ? "The pilot gives back" : "A pilot takes over";
    if (armed && height >= 1) document.body.dataset.flownMs ??= Math.round(performance.now()); // a recorded flight, too
    seen.flown ||= armed;
    if (isReady && verdict && flightInWords(seen) !== before) judged(verdict);
    const flies = item === null || item === undefined ? "" : `, item ${numberOf("plan", item, hasHome())}`;
    at("vehicle").textContent = `${mode}, ${armed ? "armed" : "disarmed"}, ${height.toFixed(1)} m${flies}`;
  }
  eventLog.wait(now);
  tellOfSketch();
}

// How far the transfer of a kind has come; whether that is further than what was known.
function learn(kind, { announced, arrived, told, sent }) {
  const before = progress[kind];
  const isFurther = !before || sent.length > 0 || before.announced !== announced || before.arrived !== arrived ||
    before.told !== told;
  const known = before ? before.sent : [];
  for (const item of sent) known[item.seq] = item;
  progress[kind] = { announced, arrived, told, sent: known };
  return isFurther || (verdict?.good && !verdict.knows);
}

// The map and the list are drawn anew a few times a second, however fast the items come.
function showLater() {
  if (shownLater) return;
  const number = run;
  shownLater = setTimeout(() => {
    shownLater = null;
    if (number !== run) return;
    const shown = Object.entries(held).map(([kind, items]) => [kind, numbered(kind, items, hasHome())]);
    map.show({ held: Object.fromEntries(shown), arrived: arrivedItems() });
    showItems();
    python.postMessage({ does: "judge", meant: plan || isOutside ? {} : meant() });
  }, SHOWN_EVERY_MS);
}

function arrivedItems() {
  return Object.entries(progress).flatMap(([kind, { sent, arrived }]) =>
    numbered(kind, sent, hasHome()).filter((item) => item.seq < arrived && !held[kind]?.[item.seq]));
}

function judged(now) {
  verdict = now.good || now.replaced ? now : null;
  if (dropped?.failed) return;
  if (verdict) {
    const flight = flightInWords(seen);
    const waits = seen.waits && !flight ? BUTTONS : "";
    const next = verdict.good ? NEXT[dropped?.step] || "" : "";
    const isOthers = verdict.replaced && Object.values(held).some((items) => items.length);
    const kind = verdict.good ? "good" : isOthers ? "bad" : "going";
    outcome(verdict.sentence + next + (flight && ` ${flight}`) + waits, kind);
  } else {
    tellOfTransfer(now.sentence);
  }
  showItems();
}

function tellOfTransfer(sentence) {
  const kinds = Object.entries(progress);
  const [name, now] = kinds.findLast(([, { told }]) => !told) || kinds.at(-1) || [];
  if (!now) return;
  const refused = sentence.includes("last word") ? ` ${sentence}` : "";
  const home = name === "plan" && hasHome() ? 1 : 0;
  const arrived = `${Math.max(0, now.arrived - home)} of ${now.announced - home}`;
  outcome(`${name === "plan" ? "" : `${name}: `}${arrived} items have arrived.${refused}`, refused ? "bad" : "going");
}

function showItems() {
  const isReplaced = Boolean(verdict?.replaced); // then what is aboard is shown
  const meant = isReplaced ? [] : meantItems();
  const rows = []; // [number, how, words]
  for (const kind of Object.values(KINDS)) {
    const now = isReplaced ? null : progress[kind];
    const aboard = held[kind] || [];
    // A file's items count without home, which is ArduPilot's first: they stand until the Mega sends its own.
    const isFile = plan && kind === "plan" && !now && !isReplaced;
    const wanted = isFile ? plan.items : plan ? [] : meant.filter((item) => item.kind === kind);
    const count = Math.max(now?.announced || 0, wanted.length, aboard.length);
    for (let seq = 0; seq < count; seq++) {
      const item = now?.sent[seq] || aboard[seq] || wanted[seq];
      const arrived = now && seq < now.arrived;
      const isAboard = verdict?.good || (!now && aboard[seq]);
      const kindOf = isAboard ? "aboard" : arrived ? "arrived" : now?.sent[seq] ? "sent" : "planned";
      const words = item?.words || "comes from a function";
      rows.push([numberOf(kind, seq, !isFile && hasHome()), kindOf, kind === "plan" ? words : `${kind}: ${words}`]);
    }
  }
  if (!rows.length) rows.push(["", "", "No plan yet."]);
  const list = at("items");
  while (list.children.length > rows.length) list.lastChild.remove();
  rows.forEach((row, turn) => fillRow(list.children[turn] || list.appendChild(emptyRow()), row));
}

function emptyRow() {
  const row = document.createElement("li");
  row.append(...["number", "", ""].map((name) => Object.assign(document.createElement("span"), { className: name })));
  return row;
}

function fillRow(row, [number, how, words]) {
  const key = `${number} ${how} ${words}`;
  if (row.dataset.key === key) return;
  row.dataset.key = key;
  const [first, second, third] = row.children;
  first.textContent = number;
  second.textContent = how;
  second.className = how;
  third.textContent = words;
}

function showSizes() {
  const { ram, flash, says, prints, listens, name, image } = example();
  at("typing").hidden = !listens;
  if (!image) editor.show(name);
  at("console").dataset.hint = prints ? "What the sketch prints appears here." : `${name} prints nothing.`;
  at("says").textContent = says;
  at("ram").textContent = ram === null ? "not known of a .hex" : `${ram} of ${RAM} bytes`;
  at("flash").textContent = `${flash.toLocaleString("en")} of ${FLASH.toLocaleString("en")} bytes`;
  for (const id of ["stack", "free", "left", "longest", "clock", "factor"]) at(id).textContent = "-";
  ramFree = ram === null ? NaN : RAM - ram;
}

function showMeasured({ now, factor, pace, stack, passes, cycles, lost }) {
  timeline.factor = factor;
  at("stack").textContent = `${stack} bytes`;
  at("free").textContent = ramFree ? `${(ramFree - stack).toLocaleString("en")} bytes` : "-";
  if (passes.count) {
    const idle = (passes.count * passes.shortest) / cycles;
    at("left").textContent = `${(100 * Math.min(1, idle)).toFixed(1)} %`;
    at("longest").textContent = `${((passes.longest / HZ) * 1e6).toFixed(0)} µs`;
  }
  at("clock").textContent = `${now.toFixed(1)} s${lost ? `, ${lost} bytes overrun` : ""}`;
  const isSlow = factor < SLOW * pace;
  at("factor").textContent = isSlow || pace < 1 ? `${factor.toFixed(2)} of real time` : "real time";
  at("factor").classList.toggle("slow", isSlow);
}

// What one does

function change(changed, isAnew) {
  state = { ...state, ...changed };
  history.replaceState(null, "", hashOf(state));
  showState();
  if (isAnew) begin();
}

function showState() {
  at("example").value = state.example;
  for (const choice of document.getElementsByName("autopilot")) {
    choice.checked = choice.value === state.autopilot;
    choice.disabled = isOutside;
  }
  for (const id of ["loss", "bytes"]) {
    showRange(id, `${state[id]} %`);
  }
  at("seed").value = state.seed;
  const isPulled = state.cable === "pulled";
  at("cable").classList.toggle("on", isPulled);
  at("cable").textContent = isPulled ? "Join the cable" : "Pull the cable";
  showRange("latency", `${state.latency} ms`);
  for (const id of LINE) at(id).disabled = isPort;
  for (const id of AUTOPILOT) at(id).disabled = isOutside;
  for (const option of at("example").options) {
    const { arms } = known.examples.find((one) => one.name === option.value);
    option.disabled = isPort && arms;
  }
  at("file").disabled = isPort;
  at("pixhawk").textContent = isPort ? "Close the port" : "Choose a port";
  at("pixhawk").disabled = !isOffered() || (isOutside && !isPort);
  at("build").disabled = isOutside;
  at("end-build").disabled = !isOutside || isPort;
}

// The words stand beside the slider; a screen reader says them as its value, once.
function showRange(id, words) {
  at(id).value = state[id];
  at(id).setAttribute("aria-valuetext", words);
  at(`${id}-value`).textContent = words;
}

function takeAddress(isFirst) {
  const names = known.examples.map((one) => one.name);
  const { state: wanted, complaints } = stateOf(location.hash, names);
  const refused = isPort && known.examples.find((one) => one.name === wanted.example).arms;
  notice(complaints.length ? `Parts of the address are not known, and are ignored: ${complaints.join(", ")}` : "");
  if (refused) return notice("A sketch that arms does not run with a real autopilot: the address is ignored.");
  const isSame = !isFirst && Object.keys(wanted).every((name) => wanted[name] === state[name]);
  state = wanted;
  if (!isSame) files = null;
  drawing.take(state.draw);
  askForFiles();
  showState();
  if (isSame) return;
  plan = null;
  if (isReady) beginOrCarry();
  else begin();
}

// The plan that is drawn has changed.
function drawn() {
  if (!drawing.points.length) files = null;
  change({ draw: drawing.word }, false);
  askForFiles();
}

function askForFiles() {
  at("returns").checked = drawing.returns;
  if (isReady && drawing.points.length) python.postMessage({ does: "draw", plan: drawing.plan });
  showFiles(files);
}

// One's own plan in the form that is chosen, or why it has none.
function showFiles(made) {
  files = made;
  const form = at("form").value;
  const { waypoints, error, errors } = files || {};
  const text = files?.[form] || "";
  at("points").hidden = !drawing.points.length;
  at("fly").disabled = isPort || !waypoints;
  at("save-drawn").disabled = at("copy-drawn").disabled = !text;
  at("drawn-text").textContent = text || errors?.[form] || error || "";
}

// The plan of a file takes the place of the one that was drawn. Whether there was one.
function own(name, made) {
  const wasDrawn = drawing.points.length > 0;
  if (wasDrawn) {
    history.pushState(null, "", location.hash);
    draw(false);
    drawing.take("");
    change({ draw: "" }, false);
  }
  at("returns").checked = drawing.returns;
  showFiles({ ...made, name: name.replace(/\.[^.]*$/, "") });
  return wasDrawn;
}

// Of simulated time beside the clock; 0: paused.
function setPace(factor) {
  isPaused = factor === 0;
  if (!isPaused) at("pace").value = factor;
  at("pause").textContent = isPaused ? "Go on" : "Pause";
  outcome(...latest);
  timeline.factor = factor;
  mega.postMessage({ does: "setPace", factor });
}

function sendLoss() {
  python.postMessage({ does: "lose", frames: state.loss, bytes: state.bytes });
}

// A plan was read. word: that of the address, if it was carried there.
async function take({ name, plan: read, word }) {
  const isKnown = read.waypoints && read.waypoints === files?.waypoints; // what was drawn, or dropped before
  const wasDrawn = read.files && !isKnown && own(name, read.files);
  if (read.error) return notice(`The plan was refused: ${read.error}${read.files?.cpp ? HAS_CPP : ""}`);
  const carried = word || (await packed({ name: name.replace(/\.[^.]*$/, ".waypoints"), waypoints: read.waypoints }));
  const notes = [...(wasDrawn ? [WAS_DRAWN] : []), ...read.notes, ...(carried ? [] : [TOO_LONG])];
  notice(notes.length ? `${name}: ${notes.join("; ")}` : "", false);
  plan = read;
  onCard = read.waypoints;
  change({ example: "PlanConsole", plan: carried }, true);
}

async function readFile(file) {
  if (!file) return;
  if (isSketch(file.name)) return readSketch(file);
  if (isPort) return notice("PlanConsole can arm, so it does not run with a real autopilot.");
  if (!isReady) return notice("The autopilot is still loading: choose the plan when that is done.");
  if (file.size > LARGEST_FILE) return notice(`The plan was refused: ${file.name} is larger than 64 MB.`);
  const bytes = await file.arrayBuffer();
  python.postMessage({ does: "read", name: file.name, bytes }, [bytes]);
}

// A sketch of one's own takes its place among the examples, and runs, unless another one was chosen meanwhile.
// Whether it does.
function runOwn(own, isWanted = true) {
  if (isPort) {
    notice("A sketch of your own may arm, so it does not run with a real autopilot.");
    return false;
  }
  known.examples = [own, ...known.examples.filter(({ name }) => name !== own.name)];
  showExamples();
  if (!isWanted) {
    showState();
    notice(`${own.name} is compiled: choose it in the list of examples.`, false);
    return false;
  }
  plan = null;
  change({ example: own.name, plan: "" }, true);
  notice(`${own.name} runs as it was compiled. The address does not carry it.`, false);
  return true;
}

async function readSketch(file) {
  if (isPort) return notice("A sketch of your own may arm, so it does not run with a real autopilot.");
  try {
    runOwn(exampleOf(file.name, new Uint8Array(await file.arrayBuffer())));
  } catch (error) {
    notice(`${file.name} was refused: ${error.message}.`);
  }
}

// where: "port", "build", or "" for the simulated autopilot.
function goOutside(where) {
  isOutside = where !== "";
  isPort = where === "port";
  at("pixhawk-says").textContent = isPort ? "The emulated Mega's Serial1 is that port. Remove the propellers." : "";
  at("build-says").textContent = where === "build" ? "It runs, and the emulated Mega's Serial1 is its SERIAL0." : "";
  plan = null;
  if (isPort && example().arms) state = { ...state, example: NOT_ARMING };
  showState();
  begin();
}

at("example").onchange = (event) => {
  notice("");
  plan = null;
  change({ example: event.target.value }, true);
};
for (const choice of document.getElementsByName("autopilot")) {
  choice.onchange = () => {
    if (!choice.checked || !AUTOPILOTS.includes(choice.value)) return;
    notice("");
    change({ autopilot: choice.value }, true);
  };
}
for (const id of ["loss", "bytes"]) {
  at(id).oninput = (event) => {
    change({ [id]: Number(event.target.value) }, false);
    sendLoss();
  };
}
at("seed").onchange = (event) => {
  const seed = Math.round(Number(event.target.value));
  change({ seed: seed >= 0 && seed <= MOST_SEED ? seed : state.seed }, true);
};
at("cable").onclick = () => {
  const cable = state.cable === "pulled" ? "joined" : "pulled";
  change({ cable }, false);
  python.postMessage({ does: "cable", joined: cable === "joined" });
  outcome(...latest);
};
at("lose").onclick = () => python.postMessage({ does: "loseNext", name: at("lose-what").value });
at("latency").oninput = (event) => change({ latency: Number(event.target.value) }, false);
at("latency").onchange = () => python.postMessage({ does: "latency", milliseconds: state.latency });
for (const who of ["pilot", "lands", "battery", "station"]) {
  at(who).onclick = () => python.postMessage({ does: "interfere", who });
}
at("pause").onclick = () => setPace(isPaused ? Number(at("pace").value) : 0);
at("pace").onchange = () => setPace(Number(at("pace").value));
at("next-frame").onclick = () => {
  setPace(0);
  mega.postMessage({ does: "toNextFrame" });
};
at("vcd").onclick = () => saved("line.vcd", vcdOf(timeline.frames));
function draw(isOn) {
  drawing.turn(isOn);
  at("draw").setAttribute("aria-pressed", isOn);
  for (const id of ["wider", "closer"]) at(id).hidden = !isOn;
  at("map-part").scrollIntoView({ block: "nearest" });
}
at("draw").onclick = () => draw(!drawing.isOn);
at("add-point").onclick = () => drawing.addNext();
at("wider").onclick = () => map.zoom(0.7);
at("closer").onclick = () => map.zoom(1.4);
at("returns").onchange = (event) => {
  drawing.returns = event.target.checked;
  drawing.tell();
};
at("form").onchange = () => showFiles(files);
at("save-drawn").onclick = () => {
  const form = at("form").value;
  saved(`${files.name}.${form === "cpp" ? "h" : form}`, files[form]);
};
at("fly").onclick = () => {
  draw(false);
  const bytes = new TextEncoder().encode(files.waypoints).buffer;
  python.postMessage({ does: "read", name: `${files.name}.waypoints`, bytes }, [bytes]);
};
at("reset-mega").onclick = () => {
  verdict = null;
  progress = {};
  seen = {};
  line = "";
  dropped = null;
  mega.postMessage({ does: "reset" });
  python.postMessage({ does: "forget" });
  if (isReady) outcome(isConsole() ? KEPT : firstWords());
};
at("reset-autopilot").onclick = () => {
  python.postMessage({ does: "restart" });
};
at("heard").onclick = () => notice("");
at("again").onclick = () => begin();
async function copy(text, what, otherwise) {
  try {
    await navigator.clipboard.writeText(text);
    notice(`${what} is in the clipboard.`, false);
  } catch {
    notice(otherwise, false);
  }
}
at("share").onclick = () =>
  copy(location.href, "The address of this state", `The address of this state: ${location.href}`);
at("copy-drawn").onclick = () => {
  const what = drawing.points.length ? "The plan that you drew" : "Your plan";
  copy(files[at("form").value], what, "This browser does not copy: mark the text below.");
};
at("typing").onsubmit = (event) => {
  event.preventDefault();
  if (!isReady) return notice("The Mega is not switched on yet.");
  type(`${at("line").value}\n`);
  at("line").value = "";
};
at("file").onchange = (event) => {
  readFile(event.target.files[0]);
  event.target.value = "";
};
at("pixhawk").onclick = async () => {
  if (isOutside) return pixhawk.close();
  try {
    if (await pixhawk.open()) goOutside("port");
  } catch (error) {
    at("pixhawk-says").textContent = `The port was not opened: ${error.message}`;
  }
};
at("build").onchange = async ({ target }) => {
  const files = [...target.files];
  target.value = "";
  at("build-says").textContent = "ArduPilot is starting.";
  try {
    await build.open(files, EXAMPLES_FLY_AT);
    goOutside("build");
  } catch (error) {
    at("build-says").textContent = `ArduPilot was not started: ${error.message}.`;
  }
};
at("end-build").onclick = () => build.close();
for (const kind of ["dragenter", "dragover"]) {
  addEventListener(kind, (event) => {
    event.preventDefault();
    document.body.classList.add("dropping");
  });
}
addEventListener("dragleave", (event) => {
  if (!event.relatedTarget) document.body.classList.remove("dropping");
});
addEventListener("drop", (event) => {
  event.preventDefault();
  document.body.classList.remove("dropping");
  readFile(event.dataTransfer.files[0]);
});
addEventListener("hashchange", () => takeAddress(false));

if (!isOffered()) {
  at("pixhawk").disabled = true;
  at("pixhawk-says").textContent = "This browser has no Web Serial: Chrome and Edge on a computer have it.";
}

function showExamples() {
  at("example").replaceChildren(...known.examples.map(({ name }) => new Option(name, name)));
}

async function open() {
  const answer = await fetch("examples/examples.json");
  known = await answer.json();
  editor.offer(answer.headers.has("Playground-Compiler"));
  showExamples();
  takeAddress(true);
  playRecorded();
  document.body.dataset.shownMs = Math.round(performance.now());
}

open().catch((error) => outcome(`The page cannot start: ${error.message}`, "bad"));
