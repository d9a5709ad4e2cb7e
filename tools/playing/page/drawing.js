// Waypoints drawn by hand: a click on the map sets one, a drag moves it, and its row in a list has place and height as
// numbers, for the keyboard.

import { NORTH_30_M, WAYPOINT } from "./places.js";

const HEIGHT_M = 20; // of the first; each further one begins with that of the one before
const MOST_POINTS = 60;
const SHAPE = /^(-?\d{1,10}\.-?\d{1,10}\.\d{1,4}_?){1,60}r?$/;
const RELATIVE = 3;

// In the address: latitude.longitude.height of each, and r for a return to home.
const pointsOf = (word) => word.replace("r", "").split("_").filter(Boolean).map((one) => {
  const [x, y, height] = one.split(".").map(Number);
  return { x, y, height };
});
export const isDrawing = (word) =>
  SHAPE.test(word) && pointsOf(word).every(({ x, y }) => Math.abs(x) <= 90e7 && Math.abs(y) <= 180e7);
const wordOf = ({ points, returns }) =>
  points.length ? points.map(({ x, y, height }) => `${x}.${y}.${height}`).join("_") + (returns ? "r" : "") : "";

export class Drawing {
  // changed: is called when the plan has.
  constructor(map, list, changed) {
    Object.assign(this, { map, list, changed, isOn: false, points: [], returns: true });
    map.svg.addEventListener("pointerdown", (event) => this.press(event));
  }

  get word() {
    return wordOf(this);
  }

  // What Python makes files of.
  get plan() {
    const { home } = this.map;
    return {
      home: [home.x, home.y, home.height || 0], returns: this.returns,
      points: this.points.map(({ x, y, height }) => [x, y, height]),
    };
  }

  take(word) {
    if (word === this.word) return;
    this.returns = !word || word.endsWith("r");
    this.points = pointsOf(word);
    this.show();
  }

  turn(isOn) {
    this.isOn = isOn;
    this.map.isFrozen = isOn;
    this.map.svg.classList.toggle("drawing", isOn);
    this.map.draw();
  }

  add(place) {
    if (this.points.length === MOST_POINTS) return;
    this.points.push({ ...place, height: this.points.at(-1)?.height ?? HEIGHT_M });
    this.tell();
  }

  // Without a pointer: 30 m north of the last one.
  addNext() {
    const last = this.points.at(-1) || this.map.home;
    this.add({ x: last.x + NORTH_30_M, y: last.y });
  }

  tell() {
    this.show();
    this.changed();
  }

  press(event) {
    if (!this.isOn || event.button) return;
    event.preventDefault();
    const number = event.target.closest("[data-drawn]")?.dataset.drawn;
    if (number === undefined) return this.add(this.placeOf(event));
    const point = this.points[number];
    const move = (moved) => {
      Object.assign(point, this.placeOf(moved));
      this.show();
    };
    const end = () => {
      removeEventListener("pointermove", move);
      this.changed();
    };
    addEventListener("pointermove", move);
    addEventListener("pointerup", end, { once: true });
  }

  placeOf({ clientX, clientY }) {
    const { left, top } = this.map.svg.getBoundingClientRect();
    return this.map.placeAt(clientX - left, clientY - top);
  }

  show() {
    const drawn = this.points.map((point, turn) => ({
      ...point, command: WAYPOINT, frame: RELATIVE, number: turn + 1, words: `${point.height} m above home`,
    }));
    this.map.show({ drawn });
    while (this.list.children.length > this.points.length) this.list.lastChild.remove();
    this.points.forEach((point, turn) => {
      const row = this.list.children[turn] || this.list.appendChild(this.rowOf(turn));
      const [x, y, height] = row.querySelectorAll("input");
      x.value = (point.x / 1e7).toFixed(7);
      y.value = (point.y / 1e7).toFixed(7);
      height.value = point.height;
    });
  }

  rowOf(turn) {
    const row = document.createElement("li");
    const field = (words, step, least, most, take) => {
      const input = Object.assign(document.createElement("input"), { type: "number", step, min: least, max: most });
      input.setAttribute("aria-label", `${words} of waypoint ${turn + 1}`);
      input.onchange = () => {
        const value = Number(input.value);
        if (input.value !== "" && value >= least && value <= most) take(this.points[turn], value);
        this.tell();
      };
      return input;
    };
    const remove = Object.assign(document.createElement("button"), { type: "button", textContent: "Remove" });
    remove.setAttribute("aria-label", `Remove waypoint ${turn + 1}`);
    remove.onclick = () => {
      this.points.splice(turn, 1);
      this.tell();
    };
    row.append(
      `${turn + 1}`,
      field("Latitude", 0.0001, -90, 90, (point, value) => { point.x = Math.round(value * 1e7); }),
      field("Longitude", 0.0001, -180, 180, (point, value) => { point.y = Math.round(value * 1e7); }),
      field("Height", 1, 0, 9999, (point, value) => { point.height = Math.round(value); }), "m", remove,
    );
    return row;
  }
}
