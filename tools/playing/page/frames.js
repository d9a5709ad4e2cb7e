// The list of frames, the newest first. One of them may be chosen, by a click or by the arrow keys.

const MOST_LINES = 400;
const STEPS = { ArrowDown: 1, ArrowUp: -1, PageDown: 8, PageUp: -8 };

export class Frames {
  // choose: is called with the frame that was chosen.
  constructor(list, choose) {
    this.list = list;
    this.choose = choose;
    this.count = 0;
    list.addEventListener("click", (event) => this.select(event.target.closest("li")));
    list.addEventListener("keydown", (event) => {
      const step = STEPS[event.key];
      if (!step) return;
      event.preventDefault();
      const rows = [...list.children];
      const from = rows.indexOf(this.selected);
      this.select(rows[Math.max(0, Math.min(rows.length - 1, from < 0 ? 0 : from + step))]);
    });
    this.forget();
  }

  forget() {
    this.selected = null;
    this.rows = new Map(); // by frame
    this.list.replaceChildren();
    this.list.removeAttribute("aria-activedescendant");
  }

  add(frames) {
    const told = frames.filter((frame) => frame.text);
    this.list.prepend(...told.map((frame) => this.rowOf(frame)).reverse());
    while (this.list.children.length > MOST_LINES) {
      this.rows.delete(this.list.lastChild.frame);
      this.list.lastChild.remove();
    }
  }

  rowOf(frame) {
    const row = document.createElement("li");
    row.id = `frame-${this.count++}`;
    row.setAttribute("role", "option");
    row.className = `${frame.way === ">" ? "from-mega" : "from-autopilot"}${frame.lost ? " lost" : ""}`;
    const time = document.createElement("time");
    time.textContent = `${frame.at.toFixed(3)} s`;
    const way = document.createElement("span");
    way.textContent = frame.way === ">" ? "Mega →" : "autopilot →";
    const words = document.createElement("span");
    words.textContent = `${frame.text}${frame.lost ? ` [${frame.lost}]` : frame.again ? " [again]" : ""}`;
    row.append(time, way, words);
    row.frame = frame;
    this.rows.set(frame, row);
    return row;
  }

  selectFrame(frame) {
    this.select(this.rows.get(frame));
  }

  select(row) {
    if (!row) return;
    this.selected?.removeAttribute("aria-selected");
    this.selected = row;
    row.setAttribute("aria-selected", "true");
    this.list.setAttribute("aria-activedescendant", row.id);
    row.scrollIntoView({ block: "nearest" });
    this.choose(row.frame);
  }
}
