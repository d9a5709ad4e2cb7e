// The pins that a sketch uses, as lamps, as servos and as buttons to GND; and a button that orders its payload
// something.

// Of the pulse for 0 degrees, and for half a turn, as the Arduino library "Servo" has them [us].
const LEAST = 544, MOST = 2400;

export class PinPanel {
  // press: is called with the number of a pin and whether its button is down.
  constructor(list, press) {
    this.list = list;
    this.press = press;
    this.forget();
  }

  // names: what the sketch calls its pins, by their numbers.
  forget(names = {}) {
    this.names = names;
    this.rows = new Map();
    this.list.replaceChildren();
  }

  show({ outputs, inputs, servos }) {
    for (const [number, width] of Object.entries(servos)) {
      const angle = Math.round(Math.min(1, Math.max(0, (width - LEAST) / (MOST - LEAST))) * 180);
      const row = this.row(number, "servo", "span");
      row.textContent = `D${number}: servo at ${angle}°, ${width} µs`;
      row.style.setProperty("--angle", `${angle - 90}deg`);
      this.rows.get(`${number} lamp`)?.parentNode.remove();
      this.rows.delete(`${number} lamp`);
    }
    for (const [number, level] of Object.entries(outputs)) {
      const row = this.row(number, "lamp", "span");
      row.textContent = `D${number}${this.nameOf(number, ", ")}: ${level ? "on" : "off"}`;
      row.classList.toggle("lit", level === 1);
    }
    for (const number of inputs) this.row(number, "button", "button");
  }

  // A button that stands there from the beginning.
  offer(words, act) {
    const button = this.row(0, "order", "button");
    Object.assign(button, { type: "button", textContent: words, onclick: act });
  }

  nameOf(number, before) {
    return number in this.names ? before + this.names[number] : "";
  }

  row(number, kind, element) {
    const key = `${number} ${kind}`;
    if (this.rows.has(key)) return this.rows.get(key);
    const row = Object.assign(document.createElement(element), { className: kind });
    if (kind === "button") this.makeButton(row, Number(number));
    const item = document.createElement("li");
    item.append(row);
    this.list.append(item);
    this.rows.set(key, row);
    return row;
  }

  makeButton(row, number) {
    row.type = "button";
    row.textContent = `D${number}: ${this.nameOf(number, "") || "button to GND"}`;
    row.setAttribute("aria-pressed", "false");
    row.onclick = () => {
      const isDown = row.getAttribute("aria-pressed") === "false";
      row.setAttribute("aria-pressed", isDown);
      this.press(number, isDown);
    };
  }
}
