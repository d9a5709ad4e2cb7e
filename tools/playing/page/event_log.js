// What was done to the run, and what came of it, in words: each event, and after it what the Mega and its sketch did.

const WAITS_S = 3; // before it is said that nothing came of it
const LASTS_S = 12; // what happens later has other reasons
const MOST_FRAMES = 5; // of them that are told for an event
const MOST_LINES = 3; // of the sketch's
const MOST_EVENTS = 12;
const PROGRESS = /^\d+(\/\d+)?$/; // a line that is no result

export class EventLog {
  constructor(list) {
    this.list = list;
    this.forget();
  }

  forget() {
    this.latest = null; // to which what is heard and said belongs
    this.awaiting = []; // events whose frame has not come yet
    this.list.replaceChildren();
  }

  // awaits: the frame that is to be lost and has not come yet: ">", "<", or the beginning of its name.
  add({ at, words, awaits = "" }) {
    this.end(at);
    const line = document.createElement("li");
    line.textContent = `${at.toFixed(1)} s: ${words}.`;
    this.list.prepend(line);
    while (this.list.children.length > MOST_EVENTS) this.list.lastChild.remove();
    this.latest = { at, since: at, line, frames: 0, lines: 0, types: new Set(), isAnswered: false, awaits };
    if (awaits) this.awaiting.push(this.latest);
  }

  // The latest event is followed by another one, and keeps its line: also where nothing has come of it.
  end(at) {
    const { latest } = this;
    if (!latest || latest.isAnswered || latest.awaits) return;
    latest.isAnswered = true;
    this.tell(at, "nothing had come of it until then");
  }

  // What has crossed the line.
  hear(frames) {
    if (!this.latest) return;
    for (const { way, text, lost, again, began } of frames) {
      if (!text || text.startsWith("HEARTBEAT")) continue;
      if (lost) this.lose(began, way, text);
      if (began < this.latest.at) continue;
      if (way === ">") this.send(began, text, again, lost);
      else if (lost) this.tellFrame(began, `lost: ${text}`);
    }
  }

  // What comes of a loss belongs to the event that has waited for it, whatever was done since.
  lose(at, way, text) {
    const isIt = (awaits) => awaits === way || (way === "<" && text.startsWith(awaits));
    const event = this.awaiting.find((one) => one.at <= at && isIt(one.awaits));
    if (!event) return;
    this.awaiting.splice(this.awaiting.indexOf(event), 1);
    if (event !== this.latest) this.end(at);
    this.latest = Object.assign(event, { awaits: "", since: at, frames: 0, types: new Set(), isAnswered: false });
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
    for (const event of new Set([...this.awaiting, this.latest])) {
      if (!event || event.isAnswered || now < event.since + WAITS_S) continue;
      event.isAnswered = true;
      this.tell(now, event.awaits ? "none has come yet: “Restart the Mega” lets the sketch begin anew"
        : "the Mega has had nothing to do about it", event);
    }
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

  tell(at, words, event = this.latest) {
    event.line.append(` +${Math.max(0, at - event.at).toFixed(2)} s: ${words}.`);
  }
}
