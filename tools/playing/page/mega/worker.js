// The Mega's worker: runs it at real time, in slices, in step with the autopilot's end of its line.
//
// Slice by slice the Mega's bytes go to Python's worker, and what that answers to slice k arrives at the Mega with
// slice k + 2: so both work at once, and what happens depends on simulated time alone, however fast the computer is.

import { HZ, Mega } from "./mega.js";

const SLICE_S = 0.005;
const BEHIND = 2; // slices
const FALLEN_BEHIND_S = 0.5;
const TOLD_EVERY_MS = 250;
const LONGEST_TURN_MS = 40; // before messages are looked at again
const PINS_EVERY_SLICES = 6; // 30 ms
const CONSOLE = 0, TELEM = 1;

let mega = null;
let run = 0; // the number of this run: messages of an earlier run are ignored
let autopilot = null; // the port to its end of the line
let slice = 0;
let answers = new Map(); // by slice
let pace = 1; // of simulated time beside the clock; 0: paused
let isStepping = false; // to the next frame, as fast as it goes
let since = { clock: 0, s: 0 }; // a time of the clock [ms], and what simulated time was due then
let timer = null;
let told = { at: 0, cycle: 0 };
let pinsTold = { slice: 0, key: "" };
let toType = [];
let decoder = new TextDecoder();

onmessage = ({ data }) => {
  const does = { start, reset, type, stop, setPace, toNextFrame, press };
  try {
    does[data.does](data);
  } catch (error) {
    fail(error);
  }
};

// What is due now is what has been run.
function beAbreast() {
  since = { clock: performance.now(), s: slice * SLICE_S };
  told = { at: since.clock, cycle: mega ? mega.cycle : 0 };
}

function setPace({ factor }) {
  pace = factor;
  isStepping = false;
  beAbreast();
  go();
}

function toNextFrame() {
  pace = 0;
  isStepping = true;
  go();
}

function start({ hex, pass, card, port, number }) {
  stop();
  run = number;
  mega = new Mega(hex, pass, card);
  autopilot = port;
  autopilot.onmessage = ({ data: answer }) => {
    answers.set(answer.slice, answer.bytes);
    if (answer.isFrame && isStepping) isStepping = false;
    go();
  };
  slice = 0;
  answers = new Map();
  toType = [];
  decoder = new TextDecoder();
  isStepping = false;
  pinsTold = { slice: 0, key: "" };
  beAbreast();
  go();
}

function stop() {
  clearTimeout(timer);
  if (autopilot) autopilot.close();
  autopilot = null;
  mega = null;
}

function reset() {
  if (!mega) return;
  mega.reset();
  postMessage({ says: "reset", run });
}

function type({ text }) {
  toType.push(...new TextEncoder().encode(text));
}

// A button between a pin and GND.
function press({ pin, isDown }) {
  if (isDown) mega?.pins.pressed.add(pin);
  else mega?.pins.pressed.delete(pin);
}

function fail(error) {
  stop();
  postMessage({ says: "crashed", run, why: error.message });
}

// Run until simulated time is abreast of the clock, or until the autopilot's end must answer first.
function go() {
  if (!mega) return;
  clearTimeout(timer);
  const turn = performance.now();
  try {
    for (;;) {
      if (!pace && !isStepping) break; // setPace() or toNextFrame() call go()
      const now = performance.now();
      const aheadS = isStepping ? 0 : slice * SLICE_S - since.s - ((now - since.clock) / 1000) * pace;
      if (aheadS > 0) {
        timer = setTimeout(go, (aheadS / pace) * 1000);
        break;
      }
      if (aheadS < -FALLEN_BEHIND_S) since.s += aheadS;
      const due = slice - BEHIND;
      if (due >= 0 && !answers.has(due)) break; // its message calls go()
      if (now - turn > LONGEST_TURN_MS) {
        timer = setTimeout(go, 0);
        break;
      }
      runSlice(due);
    }
    tell();
  } catch (error) {
    fail(error);
  }
}

function runSlice(due) {
  const telem = mega.serial(TELEM);
  const console = mega.serial(CONSOLE);
  if (due >= 0) {
    telem.send(answers.get(due));
    answers.delete(due);
  }
  if (toType.length && console.isListening) console.send(toType.splice(0));
  mega.run((slice + 1) * SLICE_S * HZ);
  const sent = telem.takeSent();
  autopilot.postMessage({
    slice,
    now: (slice + 1) * SLICE_S,
    bytes: Uint8Array.from(sent, (one) => one.byte),
    left: Float64Array.from(sent, (one) => one.left),
    baud: HZ / telem.bitCycles,
  });
  const printed = console.takeSent();
  if (printed.length) {
    const text = decoder.decode(Uint8Array.from(printed, (one) => one.byte), { stream: true });
    postMessage({ says: "printed", run, text });
  }
  slice++;
  tellPins();
}

// What the sketch has made of the pins, when that changes.
function tellPins() {
  if (slice < pinsTold.slice + PINS_EVERY_SLICES) return;
  const { state } = mega.pins;
  const key = JSON.stringify(state);
  if (key !== pinsTold.key) postMessage({ says: "pins", run, state });
  pinsTold = { slice, key };
}

function tell() {
  const now = performance.now();
  if (now - told.at < TOLD_EVERY_MS) return;
  const cycles = mega.cycle - told.cycle;
  const passes = mega.takePasses();
  postMessage({
    says: "measured",
    run,
    now: mega.cycle / HZ,
    pace,
    factor: cycles / HZ / ((now - told.at) / 1000),
    stack: mega.deepestStack,
    passes,
    cycles,
    lost: mega.serial(TELEM).lost,
  });
  told = { at: now, cycle: mega.cycle };
}
