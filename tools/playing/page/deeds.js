// What was done to the run, and what came of it, in words: each deed, and behind it what the Mega and its sketch did.

const WAITS_S = 3; // before it is said that nothing came of it
const LASTS_S = 12; // what happens later has other reasons
const MOST_FRAMES = 5; // of them that are told for a deed
const MOST_LINES = 3; // of the sketch's
const MOST_DEEDS = 12;
const PROGRESS = /^\d+(\/\d+)?$/; // a line that is no result

export class Deeds {
  constructor(list) {
    this.list = list;
    this.forget();
  }

  forget() {
    this.latest = null;
    this.list.replaceChildren();
  }

  // awaits: a frame is to be lost that has not come yet.
  add({ at, words, awaits = false }) {
    const line = document.createElement("li");
    line.textContent = `${at.toFixed(1)} s: ${words}.`;
    this.list.prepend(line);
    while (this.list.children.length > MOST_DEEDS) this.list.lastChild.remove();
    this.latest = { at, since: at, line, frames: 0, lines: 0, types: new Set(), isAnswered: false, awaits };
  }

  // What has crossed the line.
  hear(frames) {
    if (!this.latest) return;
    for (const { way, text, lost, again, began } of frames) {
      if (!text || began < this.latest.at || text.startsWith("HEARTBEAT")) continue;
      if (lost) this.lose(began);
      if (way === ">") this.send(began, text, again, lost);
      else if (lost) this.tellFrame(began, `lost: ${text}`);
    }
  }

  lose(at) {
    const { latest } = this;
    if (latest.awaits) Object.assign(latest, { awaits: false, since: at, frames: 0, types: new Set() });
  }

  // Of many items the first is told, and each that is sent again or lost.
  send(at, text, again, lost) {
    const { latest } = this;
    const type = text.split(" ")[0];
    const isNew = !latest.types.has(type);
    latest.types.add(type);
    if (latest.awaits || !(isNew || again || lost)) return;
    const isTold = this.tellFrame(at, `the Mega sends ${again ? "again " : ""}${text}${lost ? ", which is lost" : ""}`);
    latest.isAnswered ||= isTold;
  }

  say(line, now) {
    const { latest } = this;
    if (!latest || latest.awaits || !line || PROGRESS.test(line)) return;
    if (latest.lines === MOST_LINES || !this.isRecent(now)) return;
    latest.lines++;
    latest.isAnswered = true;
    this.tell(now, `the sketch says “${line}”`);
  }

  wait(now) {
    const { latest } = this;
    if (!latest || latest.isAnswered || now < latest.since + WAITS_S) return;
    latest.isAnswered = true;
    this.tell(now, latest.awaits ? "none has come yet: “Restart the Mega” lets the sketch begin anew"
      : "the Mega has had nothing to do about it");
  }

  isRecent(at) {
    return at <= this.latest.since + LASTS_S;
  }

  tellFrame(at, words) {
    if (this.latest.frames === MOST_FRAMES || !this.isRecent(at)) return false;
    this.latest.frames++;
    this.tell(at, words);
    return true;
  }

  tell(at, words) {
    this.latest.line.append(` +${Math.max(0, at - this.latest.at).toFixed(2)} s: ${words}.`);
  }
}
