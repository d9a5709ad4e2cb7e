// The state that an address names: #example=UploadMission&autopilot=px4&loss=20&seed=3

import { CARRIED } from "./carried.js";
import { isDrawing } from "./drawing.js";

export const AUTOPILOTS = ["ardupilot", "px4"];
export const MOST_LOSS = 50; // percent of the frames, each way
export const MOST_BYTES = 10; // percent of the bytes, each way
export const MOST_SEED = 999999;

export const PLAIN = {
  example: "StartMission", autopilot: "ardupilot", loss: 0, bytes: 0, latency: 0, seed: 0, cable: "joined", lose: "",
  plan: "", draw: "",
};
const CABLES = ["joined", "pulled"];
export const MOST_LATENCY = 1000; // ms, each way
const LOST = ["", "ack"];

// {state, complaints}: what is not understood is as in PLAIN, and is complained of in words.
export function stateOf(hash, examples) {
  const state = { ...PLAIN };
  const complaints = [];
  for (const [name, value] of new URLSearchParams(hash.replace(/^#/, ""))) {
    const taken = Object.hasOwn(TAKERS, name) ? TAKERS[name](value, examples) : undefined;
    if (taken === undefined) complaints.push(`${shortened(name)}=${shortened(value)}`);
    else state[name] = taken;
  }
  return { state, complaints };
}

export function hashOf(state) {
  const words = Object.entries(state).filter(([name, value]) => name === "example" || value !== PLAIN[name]);
  return `#${new URLSearchParams(words)}`;
}

const oneOf = (values) => (value) => (values.includes(value) ? value : undefined);
const numberTo = (most, step) => (value) => {
  const number = Number(value);
  const isIn = value.trim() !== "" && number >= 0 && number <= most;
  return isIn ? Math.round(number / step) * step : undefined;
};

const TAKERS = {
  example: (value, examples) => (examples.includes(value) ? value : undefined),
  autopilot: oneOf(AUTOPILOTS),
  loss: numberTo(MOST_LOSS, 1),
  bytes: numberTo(MOST_BYTES, 0.5),
  latency: numberTo(MOST_LATENCY, 50),
  seed: numberTo(MOST_SEED, 1),
  cable: oneOf(CABLES),
  lose: oneOf(LOST),
  draw: (value) => (isDrawing(value) ? value : undefined),
  plan: (value) => (CARRIED.test(value) ? value : undefined),
};

const shortened = (text) => (text.length > 24 ? `${text.slice(0, 24)}...` : text);
