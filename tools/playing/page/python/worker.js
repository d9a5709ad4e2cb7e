// Python's worker: the autopilot's end of the line, the project's own autopilot and wire, stepped by the Mega's worker.

import { loadPyodide } from "../vendor/pyodide/pyodide.mjs";
import { countFetched } from "./counted.js";
import { hearing } from "./hearing.js";

const NEWS_EVERY_MS = 60;

let python = null;
let autopilotEnd = null;
let mega = null; // the port to the Mega's worker
let run = 0;
let now = 0;
let newsAt = 0;
let later = null; // the timer of news that are to be told
let shown = 0; // frames that are shown, and have crossed
let isOutside = false;

onmessage = ({ data }) => {
  const does = {
    start, stop, lose, cable, loseNext, latency, interfere, restart, forget, judge, read, outside, explain, draw,
  };
  try {
    does[data.does](data);
  } catch (error) {
    postMessage({ says: "failed", run, why: String(error.message || error) });
  }
};

async function load() {
  const begun = performance.now();
  let fetched = 0;
  countFetched((bytes) => {
    fetched += bytes;
    postMessage({ says: "fetched", bytes: fetched });
  });
  const world = fetch(new URL("../world.zip", import.meta.url)).then((answer) => answer.arrayBuffer());
  const parser = hearing(new URL("../hearing.wasm", import.meta.url));
  postMessage({ says: "loading", what: "Python" });
  python = await loadPyodide({ indexURL: new URL("../vendor/pyodide/", import.meta.url).href });
  postMessage({ says: "loading", what: "the autopilot" });
  python.registerJsModule("hearing", { exports: await parser });
  python.unpackArchive(await world, "zip", { extractDir: "/world" });
  python.runPython("import sys; sys.path.insert(0, '/world'); import inside.autopilot_end");
  const ends = JSON.parse(python.FS.readFile("/world/ends.json", { encoding: "utf8" }));
  postMessage({ says: "ready", ms: performance.now() - begun, ends });
}

load().catch((error) => postMessage({ says: "failed", run, why: `the autopilot cannot be loaded: ${error.message}` }));

function start({ settings, port, number }) {
  stop();
  run = number;
  now = 0;
  isOutside = settings.autopilot === "outside";
  const module = python.pyimport("inside.autopilot_end");
  shown = 0;
  autopilotEnd = module.AutopilotEnd(JSON.stringify(settings));
  module.destroy();
  mega = port;
  mega.onmessage = ({ data: heard }) => step(heard);
}

function stop() {
  if (mega) mega.close();
  if (autopilotEnd) autopilotEnd.destroy();
  mega = null;
  autopilotEnd = null;
}

function step({ slice, now: until, bytes, left, baud }) {
  if (!autopilotEnd) return;
  now = until;
  try {
    const data = python.toPy(bytes);
    const times = python.toPy(left);
    const answer = autopilotEnd.step(until, data, times, baud);
    const arriving = answer.toJs();
    for (const used of [data, times, answer]) used.destroy();
    const shownBefore = shown;
    shown = autopilotEnd.shown_crossed;
    mega.postMessage({ slice, bytes: arriving, isFrame: shown > shownBefore }, [arriving.buffer]);
    if (isOutside) giveOutside();
    tell();
  } catch (error) {
    stop();
    postMessage({ says: "failed", run, why: `the autopilot has failed: ${error.message}` });
  }
}

function giveOutside() {
  const given = autopilotEnd.take_for_outside();
  const bytes = given.toJs();
  given.destroy();
  if (bytes.length) postMessage({ says: "outside", run, bytes }, [bytes.buffer]);
}

// What is new, at most so often; and the last of it too, when nothing follows.
function tell() {
  const waits = newsAt + NEWS_EVERY_MS - performance.now();
  if (waits > 0) {
    later ??= setTimeout(() => {
      later = null;
      tell();
    }, waits);
    return;
  }
  newsAt = performance.now();
  if (!autopilotEnd) return;
  const news = autopilotEnd.news();
  if (news) postMessage({ says: "news", run, now, news: JSON.parse(news) });
}

function lose({ frames, bytes }) {
  autopilotEnd?.lose(frames, bytes);
}

function cable({ joined }) {
  autopilotEnd?.cable(joined);
  tellAtOnce();
}

function loseNext({ name }) {
  autopilotEnd?.lose_next(name);
  tellAtOnce();
}

function latency({ milliseconds }) {
  autopilotEnd?.latency(milliseconds);
  tellAtOnce();
}

function interfere({ who }) {
  autopilotEnd?.interfere(who);
  tellAtOnce();
}

function restart() {
  autopilotEnd?.restart(now);
  tellAtOnce();
}

function forget() {
  autopilotEnd?.mega_restarts();
  tellAtOnce();
}

// An event is told of though the Mega may be paused.
function tellAtOnce() {
  newsAt = 0;
  tell();
}

function judge({ meant }) {
  if (!autopilotEnd) return;
  const verdict = autopilotEnd.verdict(JSON.stringify(meant));
  postMessage({ says: "judged", run, verdict: JSON.parse(verdict) });
}

function outside({ bytes }) {
  if (!autopilotEnd || !isOutside) return;
  const data = python.toPy(bytes);
  autopilotEnd.hear_outside(data);
  data.destroy();
}

// A plan file that was dropped onto the page.
function read({ name, bytes, word }) {
  const module = python.pyimport("inside.autopilot_end");
  const data = python.toPy(new Uint8Array(bytes));
  try {
    postMessage({ says: "read", name, word, plan: JSON.parse(module.plan_of(name, data)) });
  } finally {
    data.destroy();
    module.destroy();
  }
}

// A plan that was drawn on the map.
function draw({ plan }) {
  const module = python.pyimport("inside.drawn");
  try {
    postMessage({ says: "drawn", files: JSON.parse(module.drawn_as(JSON.stringify(plan))) });
  } finally {
    module.destroy();
  }
}

// A frame, field by field.
function explain({ hex, id }) {
  const module = python.pyimport("inside.explained");
  const data = python.toPy(Uint8Array.from(hex.match(/../g), (byte) => parseInt(byte, 16)));
  try {
    postMessage({ says: "explained", id, frame: JSON.parse(module.explained(data)) });
  } finally {
    data.destroy();
    module.destroy();
  }
}
