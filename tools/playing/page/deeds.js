// What was done to the run, and what came of it, in words: each deed, and behind it what the Mega and its sketch did.

const WAITS_S = 3; // before it is said that nothing came of it
const MOST_RESULTS = 4;
const MOST_DEEDS = 12;

export class Deeds {
  constructor(list) {
    this.list = list;
    this.forget();
  }

  forget() {
    this.latest = null;
    this.list.replaceChildren();
  }

  add({ at, words }) {
    const line = document.createElement("li");
    line.textContent = `${at.toFixed(1)} s: ${words}.`;
    this.list.prepend(line);
    while (this.list.children.length > MOST_DEEDS) this.list.lastChild.remove();
    this.latest = { at, line, results: 0, isAnswered: false };
  }

  // What has crossed the line.
  hear(frames) {
    if (!this.latest) return;
    for (const { way, text, lost, again, began } of frames) {
      if (!text || began < this.latest.at || text.startsWith("HEARTBEAT")) continue;
      if (lost) this.tell(began, `lost: ${text}`);
      else if (way === ">") this.answer(began, `the Mega sends ${again ? "again " : ""}${text}`);
    }
  }

  say(line, now) {
    if (this.latest && line) this.answer(now, `the sketch says “${line}”`);
  }

  wait(now) {
    if (!this.latest || this.latest.isAnswered || now < this.latest.at + WAITS_S) return;
    this.answer(now, "the Mega has had nothing to do about it");
  }

  answer(now, words) {
    this.latest.isAnswered = true;
    this.tell(now, words);
  }

  tell(now, words) {
    const { latest } = this;
    if (latest.results === MOST_RESULTS) return;
    latest.results++;
    latest.line.append(` +${Math.max(0, now - latest.at).toFixed(2)} s: ${words}.`);
  }
}
