// A plan that was dropped onto the page, put aboard by PlanConsole as a person would at its terminal: a command, and
// the next one when the sketch has said that it is done. The lines of the file follow one another as they are stored:
// sent at once they would come faster than the Mega takes them.

const STEPS = [
  { types: "load\n", done: "stored: list prints it" },
  { types: "upload\n", done: "accepted: the plan is aboard" },
  { types: "verify\n", done: "verified: what is aboard is the plan" },
  { types: "start\n", done: "done: the autopilot confirmed it" },
];
const HEAD = 2; // lines before the first item
const AHEAD = 2; // items that are sent before the first of them is stored
const WHERE_IN_TEXT = /^line (\d+)(?:, field \d+)?: (.*)$/;
const FIRST_ROW = 3; // of an item in the text: behind the line that names its kind, and home
const WHERE_IN_PLAN = /^item (\d+)(?:: (.*))?$/; // counted from 1
const REFUSED = [
  "nothing was loaded; further lines are ignored, up to end",
  "the EEPROM could not store it",
];

export class Dropped {
  // type: gives a text to the sketch. ends: how an operation can end, in the sketch's words.
  constructor(plan, type, ends) {
    this.plan = plan;
    this.type = type;
    this.ends = ends;
    this.step = -1;
    this.failed = false;
    this.text = "";
    this.words = ""; // what the sketch found wrong
    this.item = -1; // and with which item
    this.lines = [...plan.waypoints.split(/\r?\n/).filter(Boolean), "end"];
    this.count = this.lines.length - HEAD - 1; // of items
    this.stored = 0; // of them
    this.next();
    this.feed();
  }

  get isOver() {
    return this.failed || this.step >= STEPS.length;
  }

  // What is wrong, with the place in the file that was dropped; "" if the sketch has not said it of an item.
  get why() {
    const place = this.plan.places[this.item];
    return this.failed && place ? `${place}: ${this.words.replace(/^refused: /, "")}` : "";
  }

  next() {
    this.step++;
    if (!this.isOver) this.type(STEPS[this.step].types);
  }

  // The next lines of the file.
  feed() {
    const sent = HEAD + this.count + 1 - this.lines.length;
    const due = Math.max(0, HEAD + this.stored + AHEAD - sent);
    const lines = this.lines.splice(0, this.stored + AHEAD > this.count ? this.lines.length : due);
    if (lines.length) this.type(lines.map((line) => `${line}\n`).join(""));
  }

  fail() {
    this.failed = true;
    if (this.lines.length) this.type("end\n"); // of the text, so that the console takes commands again
    this.lines = [];
  }

  // What the sketch has printed.
  hear(text) {
    this.text += text;
    const lines = this.text.split(/\r?\n/);
    this.text = lines.pop();
    for (const line of lines) {
      const [, row, words] = line.match(WHERE_IN_TEXT) || [];
      if (row) [this.item, this.words] = [row - FIRST_ROW, words];
      const [, item, about] = line.match(WHERE_IN_PLAN) || [];
      if (item && (about || this.failed)) [this.item, this.words] = [item - 1, about || this.words];
      if (this.isOver) continue;
      if (this.step === 0 && /^\d+$/.test(line)) {
        this.stored = Number(line);
        this.feed();
      }
      if (line === STEPS[this.step].done) {
        this.next();
      } else if (REFUSED.includes(line)) {
        this.fail();
      } else if (this.ends.includes(line)) {
        this.words = line;
        this.fail();
      }
    }
  }
}
