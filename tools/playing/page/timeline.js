// Frames against time: the latest talk in full, and below it the last seconds as they go by.
//
// A talk is what crosses the line without a longer silence, apart from what comes unasked: an upload, a download, a
// command and its answer. It is drawn as large as the place allows, and stays until the next one begins.

const SILENCE_S = 1.6; // that ends a talk: an answer is waited for 1.5 s
const LONGEST_S = 6; // of a talk that is drawn: its end
const SHORTEST_S = 0.1;
const PASSING_S = 12; // in the strip below
const STRIP_PX = 52;
const LABEL_PX = 13; // a line of labels
const BAR_PX = 12;
const HATCH_PX = 9;
const REACH_PX = 3; // beside a frame, where a click still means it
const KEPT = 3000;
const UNASKED = ["HEARTBEAT", "STATUSTEXT", "MISSION_ITEM_REACHED"]; // begin no talk
const FONT = '"DejaVu Sans", system-ui, sans-serif';

export class Timeline {
  // choose: is called with a frame that was clicked.
  constructor(canvas, choose) {
    this.canvas = canvas;
    this.drawn = []; // {frame, left, right, top, bottom}: where frames that are listed stand in the picture
    canvas.addEventListener("click", ({ offsetX, offsetY }) => {
      const hit = this.drawn.find((one) => offsetX >= one.left - REACH_PX && offsetX <= one.right + REACH_PX &&
        offsetY >= one.top && offsetY <= one.bottom);
      if (hit) choose(hit.frame);
    });
    this.factor = 1;
    this.isCalm = matchMedia("(prefers-reduced-motion: reduce)");
    this.forget();
    const draw = () => {
      this.draw();
      requestAnimationFrame(draw);
    };
    requestAnimationFrame(draw);
  }

  forget() {
    this.frames = [];
    this.events = []; // {at, words, cut}: what was done to the line or to an end of it
    this.talk = null; // {began, ended}
    this.now = 0;
    this.at = performance.now(); // when `now` was true [ms]
  }

  add(frames, now) {
    this.frames.push(...frames);
    if (this.frames.length > KEPT) this.frames.splice(0, this.frames.length - KEPT);
    for (const { label, text, began, ended } of frames) {
      if (!label || UNASKED.some((name) => text.startsWith(name))) continue;
      if (!this.talk || began - this.talk.ended > SILENCE_S) this.talk = { began, ended };
      this.talk.ended = Math.max(this.talk.ended, ended);
    }
    this.now = now;
    this.at = performance.now();
  }

  addEvent(event) {
    this.events.push(event);
  }

  // {from, to} of each time in which the cable was pulled, until `end`.
  cuts(end) {
    const cuts = [];
    let from = null;
    for (const { at, cut } of this.events) {
      if (cut === undefined) continue;
      if (cut) {
        from ??= at;
      } else if (from !== null) {
        cuts.push({ from, to: at });
        from = null;
      }
    }
    return from === null ? cuts : [...cuts, { from, to: end }];
  }

  // Simulated time now; between two messages it goes on at the pace that was measured.
  get time() {
    if (this.isCalm.matches) return this.now;
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
    const pen = canvas.getContext("2d");
    pen.setTransform(dots, 0, 0, dots, 0, 0);
    pen.clearRect(0, 0, width, height);
    const colour = coloursOf(canvas);
    this.drawn = [];
    this.drawStrip(pen, colour, width, height);
    this.drawTalk(pen, colour, width, height - STRIP_PX);
  }

  // The last seconds: where the talks are, and what goes on between them.
  drawStrip(pen, colour, width, height) {
    const end = this.time;
    const top = height - STRIP_PX;
    const x = (time) => width - ((end - time) / PASSING_S) * width;
    pen.fillStyle = colour.line;
    pen.fillRect(0, top, width, 1);
    if (this.talk) {
      pen.fillStyle = colour.shade;
      const from = x(Math.max(this.talk.began, this.talk.ended - LONGEST_S));
      pen.fillRect(from - 2, top + 1, Math.max(4, x(this.talk.ended) - from + 4), STRIP_PX - 18);
    }
    for (const cut of this.cuts(end)) hatch(pen, colour, x(cut.from), x(cut.to), top + 1, STRIP_PX - 18);
    for (const frame of this.frames) {
      if (frame.ended < end - PASSING_S) continue;
      pen.fillStyle = colour[kindOf(frame)];
      const isMega = frame.way === ">";
      pen.fillRect(x(frame.began), top + (isMega ? 6 : 20), Math.max(1, x(frame.ended) - x(frame.began)), 10);
    }
    pen.font = `11px ${FONT}`;
    pen.textAlign = "left";
    pen.fillStyle = colour.lost;
    for (const { at, words } of this.events.filter((one) => one.at > end - PASSING_S)) {
      pen.fillRect(x(at), top, 2, STRIP_PX - 17);
      pen.fillText(words, Math.min(x(at) + 5, width - pen.measureText(words).width - 4), top + 29);
    }
    pen.textAlign = "center";
    pen.fillStyle = colour.dim;
    for (let second = Math.max(0, Math.ceil((end - PASSING_S) / 2) * 2); second <= end; second += 2) {
      pen.fillText(`${second} s`, Math.max(14, Math.min(width - 16, x(second))), height - 4);
    }
  }

  drawTalk(pen, colour, width, height) {
    pen.font = `12px ${FONT}`;
    const lane = height / 2;
    const names = [[">", "Mega \u2192 autopilot", 0], ["<", "autopilot \u2192 Mega", lane]];
    if (this.talk) {
      const ended = Math.max(this.talk.ended, this.talk.began + SHORTEST_S);
      const began = Math.max(this.talk.began, ended - LONGEST_S);
      const left = 12;
      const right = width - 110; // for the last label
      const x = (time) => left + ((time - began) / (ended - began)) * (right - left);
      for (const cut of this.cuts(ended)) {
        if (cut.to > began && cut.from < ended) hatch(pen, colour, x(Math.max(cut.from, began)), x(cut.to), 0, height);
      }
      this.drawTimes(pen, colour, x, began, ended, height);
      this.drawEvents(pen, colour, x, began, ended, height);
      for (const [way, , top] of names) this.drawLane(pen, colour, x, { way, top, lane, width, began, ended });
    }
    pen.font = `600 12px ${FONT}`;
    pen.textAlign = "left";
    for (const [, words, top] of names) {
      pen.fillStyle = colour.ground;
      pen.globalAlpha = 0.85;
      pen.fillRect(0, top + 1, pen.measureText(words).width + 14, 18);
      pen.globalAlpha = 1;
      pen.fillStyle = colour.text;
      pen.fillText(words, 7, top + 14);
    }
  }

  drawTimes(pen, colour, x, began, ended, height) {
    const step = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2].find((one) => x(began + one) - x(began) >= 70) || 5;
    pen.textAlign = "left";
    for (let turn = Math.ceil(began / step); turn * step <= ended; turn++) {
      const time = turn * step;
      pen.fillStyle = colour.line;
      pen.fillRect(x(time), 0, 1, height);
      pen.fillStyle = colour.dim;
      pen.fillText(`${time.toFixed(step < 0.1 ? 2 : 1)} s`, x(time) + 3, height - 4);
    }
  }

  drawEvents(pen, colour, x, began, ended, height) {
    pen.textAlign = "left";
    pen.fillStyle = colour.lost;
    for (const { at, words } of this.events.filter((one) => one.at >= began && one.at <= ended)) {
      pen.fillRect(x(at), 0, 2, height);
      pen.fillText(words, x(at) + 5, height / 2 - 4);
    }
  }

  drawLane(pen, colour, x, { way, top, lane, width, began, ended }) {
    const bottom = top + lane - 18;
    pen.fillStyle = colour.line;
    pen.fillRect(0, bottom, width, 1);
    const lines = Math.max(1, Math.floor((lane - 18 - BAR_PX - 22) / LABEL_PX));
    const taken = Array(lines).fill(-Infinity); // where each line of labels ends [px]
    pen.textAlign = "left";
    for (const frame of this.frames) {
      if (frame.way !== way || frame.ended < began || frame.began > ended) continue;
      const from = x(frame.began);
      const kind = kindOf(frame);
      pen.fillStyle = colour[kind];
      const wide = Math.max(2, x(frame.ended) - from);
      pen.fillRect(from, bottom - BAR_PX, wide, BAR_PX);
      if (frame.text) this.drawn.push({ frame, left: from, right: from + wide, top, bottom });
      if (kind === "other" || !frame.label) continue;
      const line = taken.findIndex((end) => end < from);
      if (line < 0) continue;
      const words = `${frame.label}${frame.lost ? " lost" : frame.again ? " again" : ""}`;
      const baseline = bottom - BAR_PX - 5 - line * LABEL_PX;
      pen.fillRect(from, baseline, 1, bottom - BAR_PX - baseline);
      pen.fillText(words, from + 3, baseline);
      taken[line] = from + pen.measureText(words).width + 8;
    }
  }
}

// The cable is not there.
function hatch(pen, colour, from, to, top, height) {
  pen.save();
  pen.beginPath();
  pen.rect(from, top, Math.max(2, to - from), height);
  pen.clip();
  pen.strokeStyle = colour.lost;
  pen.globalAlpha = 0.5;
  pen.beginPath();
  for (let left = Math.max(0, from) - height; left < Math.min(to, pen.canvas.width); left += HATCH_PX) {
    pen.moveTo(left, top + height);
    pen.lineTo(left + height, top);
  }
  pen.stroke();
  pen.restore();
}

function kindOf(frame) {
  if (frame.lost) return "lost";
  return frame.label && frame.label !== "HEARTBEAT" ? frame.way : "other";
}

function coloursOf(element) {
  const style = getComputedStyle(element);
  const value = (name) => style.getPropertyValue(name).trim();
  return {
    ">": value("--mega"), "<": value("--autopilot"), lost: value("--bad"), other: value("--faint"),
    line: value("--line"), dim: value("--dim"), text: value("--text"), ground: value("--panel"), shade: value("--grid"),
  };
}
