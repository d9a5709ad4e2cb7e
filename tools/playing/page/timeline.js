// Frames against time: what is on the line, as it goes, one lane for each direction. The newest is at the right.

const SHOWN_S = 6;
const KEPT = 2000;
const LABEL_PX = 9; // a line of labels
const LANES = { ">": 0, "<": 1 };

export class Timeline {
  constructor(canvas) {
    this.canvas = canvas;
    this.frames = [];
    this.now = 0;
    this.at = 0; // when `now` was true [ms]
    this.factor = 1;
    this.isQuiet = matchMedia("(prefers-reduced-motion: reduce)");
    const draw = () => {
      this.draw();
      requestAnimationFrame(draw);
    };
    requestAnimationFrame(draw);
  }

  forget() {
    this.frames = [];
    this.now = 0;
    this.at = performance.now();
  }

  add(frames, now) {
    this.frames.push(...frames);
    if (this.frames.length > KEPT) this.frames.splice(0, this.frames.length - KEPT);
    this.now = now;
    this.at = performance.now();
  }

  // Simulated time now; between two messages it goes on at the pace that was measured.
  get time() {
    if (this.isQuiet.matches) return Math.floor(this.now * 2) / 2;
    return this.now + Math.min(0.4, ((performance.now() - this.at) / 1000) * Math.min(1, this.factor));
  }

  draw() {
    const { canvas } = this;
    const { clientWidth: width, clientHeight: height } = canvas;
    if (!width || !height) return;
    const dots = devicePixelRatio || 1;
    if (canvas.width !== Math.round(width * dots) || canvas.height !== Math.round(height * dots)) {
      canvas.width = Math.round(width * dots);
      canvas.height = Math.round(height * dots);
    }
    const colour = coloursOf(canvas);
    const pen = canvas.getContext("2d");
    pen.setTransform(dots, 0, 0, dots, 0, 0);
    pen.clearRect(0, 0, width, height);
    const end = this.time;
    const x = (time) => width - 8 - ((end - time) / SHOWN_S) * (width - 8);
    this.drawSeconds(pen, colour, x, end, height);
    const lane = height / 2;
    for (const way of [">", "<"]) this.drawLane(pen, colour, x, end, way, LANES[way] * lane, lane);
  }

  drawSeconds(pen, colour, x, end, height) {
    pen.font = "11px system-ui, sans-serif";
    pen.textBaseline = "alphabetic";
    for (let second = Math.ceil(Math.max(0, end - SHOWN_S)); second <= end; second++) {
      pen.fillStyle = colour.line;
      pen.fillRect(x(second), 0, 1, height - 14);
      pen.fillStyle = colour.dim;
      pen.textAlign = "center";
      pen.fillText(`${second} s`, x(second), height - 3);
    }
  }

  drawLane(pen, colour, x, end, way, top, high) {
    const bottom = top + high - 16;
    const bar = 12;
    pen.fillStyle = colour.line;
    pen.fillRect(0, bottom, 4000, 1);
    const taken = []; // where each line of labels ends [px]
    const lines = Math.max(1, Math.floor((high - bar - 24) / (LABEL_PX + 4)));
    for (const frame of this.frames) {
      if (frame.way !== way || frame.ended < end - SHOWN_S || frame.began > end) continue;
      const from = x(frame.began);
      const wide = Math.max(1.5, x(frame.ended) - from);
      const kind = frame.lost ? "lost" : frame.label && frame.label !== "HEARTBEAT" ? way : "other";
      pen.fillStyle = colour[kind];
      pen.fillRect(from, bottom - bar, wide, bar);
      if (kind === "other" || !frame.label) continue;
      pen.font = "11px system-ui, sans-serif";
      pen.textAlign = "left";
      const words = frame.lost ? `${frame.label} lost` : frame.label;
      const line = [...Array(lines).keys()].find((turn) => (taken[turn] ?? -Infinity) < from);
      if (line === undefined) continue;
      const high_ = bottom - bar - 5 - line * (LABEL_PX + 4);
      pen.fillRect(from, high_, 1, bottom - bar - high_);
      pen.fillText(words, from + 3, high_ + 3);
      taken[line] = from + pen.measureText(words).width + 8;
    }
    pen.font = "600 11px system-ui, sans-serif";
    pen.textAlign = "left";
    const words = way === ">" ? "Mega → autopilot" : "autopilot → Mega";
    pen.fillStyle = colour.ground;
    pen.globalAlpha = 0.85;
    pen.fillRect(0, top + 2, pen.measureText(words).width + 12, 16);
    pen.globalAlpha = 1;
    pen.fillStyle = colour.text;
    pen.fillText(words, 6, top + 14);
  }
}

function coloursOf(element) {
  const style = getComputedStyle(element);
  const value = (name) => style.getPropertyValue(name).trim();
  return {
    ">": value("--mega"), "<": value("--autopilot"), lost: value("--bad"), other: value("--faint"),
    line: value("--line"), dim: value("--dim"), text: value("--text"), ground: value("--panel"),
  };
}
