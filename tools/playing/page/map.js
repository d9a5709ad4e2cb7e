// The map: a grid, north, a scale, the plan that is meant, the plan aboard, and the aircraft. Drawn as SVG; no tiles.

import { HOME } from "./numbers.js";
import {
  flatAround, hasPlace, isCircle, isCorner, isFlownTo, isRally, isReturn, lengthInWords, placeFrom, roundBelow,
} from "./places.js";

const SVG = "http://www.w3.org/2000/svg";
const MARGIN_PX = 46; // around what is shown, on a map that is large enough
const SMALLEST_M = 60; // of what is shown
const LARGEST_M = 4e7; // across the map: the Earth
const MOST_PX = 1000; // to a metre
const GRID_PX = 70; // between two lines, at the least
const TRAIL = 1500; // places
const MANY = 60; // points, which are drawn smaller then
const LETTER_PX = 8; // of a point's number
const LINE_PX = 15;

export class PlanMap {
  constructor(svg) {
    this.svg = svg;
    this.size = { width: 0, height: 0 };
    this.drawn = []; // by hand; it outlives a run
    this.isFrozen = false; // while one draws, the map stays where it is
    new ResizeObserver(() => this.measure()).observe(svg);
    this.forget();
  }

  // A new run.
  forget(home) {
    this.home = home || null;
    this.meant = [];
    this.arrived = [];
    this.held = {};
    this.vehicle = null;
    this.trail = [];
    this.heading = 0;
    this.draw();
  }

  show(changed) {
    Object.assign(this, changed);
    this.draw();
  }

  move(vehicle) {
    const before = this.vehicle;
    this.vehicle = vehicle;
    const place = { x: vehicle.lat, y: vehicle.lon };
    const isFirst = !before;
    if (isFirst && !this.home) this.home = place;
    if (isFirst || !this.flat) return this.draw();
    const [east, north] = this.flat(place);
    const [eastBefore, northBefore] = this.flat({ x: before.lat, y: before.lon });
    if (Math.hypot(east - eastBefore, north - northBefore) > 0.02) {
      this.heading = (Math.atan2(east - eastBefore, north - northBefore) * 180) / Math.PI;
      this.trail.push(place);
      if (this.trail.length > TRAIL) this.trail.shift();
    }
    if (!this.isInView(place)) return this.draw();
    return this.drawAircraft();
  }

  measure() {
    const { width, height } = this.svg.getBoundingClientRect();
    if (!width || !height || (width === this.size.width && height === this.size.height)) return;
    this.size = { width, height };
    this.draw();
  }

  get everything() {
    const held = Object.values(this.held).flat();
    return [...this.meant, ...this.arrived, ...held, ...this.drawn].filter(hasPlace);
  }

  draw() {
    const { width, height } = this.size;
    if (!width) return;
    const places = [...this.everything, ...(this.home ? [this.home] : [])];
    if (this.vehicle) places.push({ x: this.vehicle.lat, y: this.vehicle.lon });
    const origin = this.home || places[0] || { x: 0, y: 0 };
    if (!this.isFrozen || !this.perMetre) {
      this.flat = flatAround(origin);
      this.back = placeFrom(origin);
      this.fit(places.map(this.flat));
    }
    this.svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
    this.svg.replaceChildren(...this.grid());
    this.svg.classList.toggle("dense", this.everything.length > 2 * MANY);
    this.numbered = []; // the boxes of the numbers that stand on the map
    // What is drawn lies above what is aboard while one draws, and below it when it is flown.
    const drawn = [this.path(this.drawn, "drawn"), this.points(this.drawn, "drawn")];
    const [below, above] = this.isFrozen ? [[], drawn] : [drawn, []];
    const groups = [
      below, this.fences(), this.path(this.meant, "meant"), this.path(this.held.plan || [], "held"), this.returning(),
      this.points(this.meant, "meant"), this.points(this.arrived, "arrived"), this.points(this.held.plan || [], "held"),
      above, this.rallies(), this.homeMark(), this.aircraft(), this.scale(), this.north(),
    ];
    this.svg.append(...groups.flat(2).filter(Boolean));
    this.drawAircraft();
  }

  fit(flat) {
    const { width, height } = this.size;
    const easts = flat.length ? flat.map(([east]) => east) : [0];
    const norths = flat.length ? flat.map(([, north]) => north) : [0];
    const least = (values) => values.reduce((a, b) => Math.min(a, b));
    const most = (values) => values.reduce((a, b) => Math.max(a, b));
    const [west, east, south, north] = [least(easts), most(easts), least(norths), most(norths)];
    const wide = Math.max(east - west, SMALLEST_M);
    const high = Math.max(north - south, SMALLEST_M);
    const margin = Math.min(MARGIN_PX, width / 4, height / 4); // a scale of none would have lines without end
    this.perMetre = Math.min((width - 2 * margin) / wide, (height - 2 * margin) / high);
    this.centre = [(west + east) / 2, (south + north) / 2];
  }

  at(place) {
    return this.onScreen(this.flat(place));
  }

  onScreen([east, north]) {
    const { width, height } = this.size;
    return [width / 2 + (east - this.centre[0]) * this.perMetre, height / 2 - (north - this.centre[1]) * this.perMetre];
  }

  placeAt(left, top) {
    const { width, height } = this.size;
    const east = this.centre[0] + (left - width / 2) / this.perMetre;
    return this.back([east, this.centre[1] - (top - height / 2) / this.perMetre]);
  }

  // Show more of the surroundings, or less.
  zoom(factor) {
    this.perMetre = Math.min(MOST_PX, Math.max(this.size.width / LARGEST_M, this.perMetre * factor));
    this.draw();
  }

  isInView(place) {
    const [x, y] = this.at(place);
    return x > 8 && y > 8 && x < this.size.width - 8 && y < this.size.height - 8;
  }

  get gridM() {
    let step = roundBelow((2 * GRID_PX) / this.perMetre);
    if (step * this.perMetre < GRID_PX) step *= 2;
    return step;
  }

  grid() {
    const { width, height } = this.size;
    const step = this.gridM;
    const lines = [];
    const [east0, north0] = [this.centre[0] - width / 2 / this.perMetre, this.centre[1] - height / 2 / this.perMetre];
    for (let east = Math.ceil(east0 / step) * step; ; east += step) {
      const [x] = this.onScreen([east, 0]);
      if (x > width) break;
      lines.push(made("line", { class: "grid", x1: x, x2: x, y1: 0, y2: height }));
    }
    for (let north = Math.ceil(north0 / step) * step; ; north += step) {
      const [, y] = this.onScreen([0, north]);
      if (y < 0) break;
      lines.push(made("line", { class: "grid", x1: 0, x2: width, y1: y, y2: y }));
    }
    return lines;
  }

  // What is flown, in its order; from home where the first item is no place.
  path(items, kind) {
    const places = items.filter(isFlownTo);
    if (kind === "held" && this.held.plan && this.home && places.length && places[0].seq > 1) places.unshift(this.home);
    if (places.length < 2) return null;
    return made("polyline", { class: `path ${kind}`, points: places.map((one) => this.at(one).join(",")).join(" ") });
  }

  returning() {
    const plan = this.held.plan?.length ? this.held.plan : this.meant;
    const last = plan.filter(isFlownTo).at(-1);
    if (!last || !this.home || !plan.some(isReturn)) return null;
    const [x1, y1] = this.at(last);
    const [x2, y2] = this.at(this.home);
    return made("line", { class: "returning", x1, y1, x2, y2 });
  }

  points(items, kind) {
    const isPoint = (item) => !isCorner(item) && !isCircle(item) && !isRally(item) && item.number !== HOME;
    const shown = items.filter((item) => hasPlace(item) && isPoint(item));
    const isDense = shown.length > MANY;
    const small = isDense ? 2.5 : 6;
    return shown.map((item) => {
      const [x, y] = this.at(item);
      const point = made("g", { class: `point ${kind}` });
      point.append(
        isFlownTo(item) ? made("circle", { cx: x, cy: y, r: kind === "meant" ? small + (isDense ? 1 : 3) : small })
          : made("rect", { x: x - 5, y: y - 5, width: 10, height: 10, transform: `rotate(45 ${x} ${y})` }),
      );
      if (kind === "drawn") point.dataset.drawn = item.number - 1;
      if (kind !== "meant" && kind !== "arrived") point.append(...this.number(item.number, x + 13, y - 9));
      const title = made("title");
      title.textContent = `${item.number}: ${item.words || item.command}`;
      point.append(title);
      return point;
    });
  }

  // A point's number, unless it would stand on another one.
  number(number, left, bottom) {
    const right = left + LETTER_PX * String(number).length;
    const stands = (one) => left < one.right && right > one.left && Math.abs(one.bottom - bottom) < LINE_PX;
    if (this.numbered.some(stands)) return [];
    this.numbered.push({ left, right, bottom });
    const text = made("text", { x: left, y: bottom });
    text.textContent = number;
    return [text];
  }

  fences() {
    const drawn = [];
    for (const [source, kind] of [[this.meant, "meant"], [this.held.fence || [], "held"]]) {
      for (let first = 0; first < source.length; first++) {
        const item = source[first];
        if (isCircle(item)) {
          const [cx, cy] = this.at(item);
          drawn.push(made("circle", { class: `fence ${kind}`, cx, cy, r: item.param1 * this.perMetre }));
        } else if (isCorner(item)) {
          const corners = source.slice(first, first + item.param1);
          const points = corners.map((one) => this.at(one).join(",")).join(" ");
          drawn.push(made("polygon", { class: `fence ${kind}`, points }));
          first += corners.length - 1;
        }
      }
    }
    return drawn;
  }

  rallies() {
    const points = [...this.meant.filter(isRally), ...(this.held["rally points"] || [])];
    return points.map((item) => letterAt(this.at(item), "R", "rally"));
  }

  homeMark() {
    return this.home ? letterAt(this.at(this.home), "H", "home") : null;
  }

  aircraft() {
    this.trailLine = made("polyline", { class: "trail" });
    this.aircraftShape = made("path", { class: "aircraft", d: "M0,-13 L9,10 L0,5 L-9,10 Z" });
    return [this.trailLine, this.aircraftShape];
  }

  drawAircraft() {
    if (!this.vehicle || !this.aircraftShape) {
      this.aircraftShape?.setAttribute("visibility", "hidden");
      return;
    }
    const [x, y] = this.at({ x: this.vehicle.lat, y: this.vehicle.lon });
    this.aircraftShape.setAttribute("visibility", "visible");
    this.aircraftShape.setAttribute("transform", `translate(${x} ${y}) rotate(${this.heading})`);
    this.aircraftShape.classList.toggle("armed", this.vehicle.armed);
    this.trailLine.setAttribute("points", this.trail.map((place) => this.at(place).join(",")).join(" "));
  }

  scale() {
    const metres = this.gridM;
    const length = metres * this.perMetre;
    const bottom = this.size.height - 16;
    const group = made("g", { class: "scale" });
    group.append(made("path", { d: `M14,${bottom - 6} v6 h${length} v-6` }));
    const words = made("text", { x: 14 + length / 2, y: bottom - 6, "text-anchor": "middle" });
    words.textContent = lengthInWords(metres);
    group.append(words);
    return group;
  }

  north() {
    const x = this.size.width - 24;
    const group = made("g", { class: "north" });
    group.append(made("path", { d: `M${x},14 l7,20 l-7,-5 l-7,5 Z` }));
    const letter = made("text", { x, y: 48, "text-anchor": "middle" });
    letter.textContent = "N";
    group.append(letter);
    return group;
  }
}

function made(name, attributes = {}) {
  const element = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  return element;
}

function letterAt([x, y], letter, kind) {
  const group = made("g", { class: `mark ${kind}` });
  group.append(made("rect", { x: x - 9, y: y - 9, width: 18, height: 18, rx: 4 }));
  const text = made("text", { x, y: y + 5, "text-anchor": "middle" });
  text.textContent = letter;
  group.append(text);
  return group;
}
