// The pins of an Arduino Mega: what a sketch has made of them, the buttons between them and GND, and servos.

const PORTS = { // the address of its PIN register; DDR and PORT follow
  A: 0x20, B: 0x23, C: 0x26, D: 0x29, E: 0x2c, F: 0x2f, G: 0x32, H: 0x100, J: 0x103, K: 0x106, L: 0x109,
};
// By the numbers on the board.
const DIGITAL = ("E0 E1 E4 E5 G5 E3 H3 H4 H5 H6 B4 B5 B6 B7 J1 J0 H1 H0 D3 D2 D1 D0 A0 A1 A2 A3 A4 A5 A6 A7 " +
  "C7 C6 C5 C4 C3 C2 C1 C0 D7 G2 G1 G0 L7 L6 L5 L4 L3 L2 L1 L0 B3 B2 B1 B0").split(" ");
const OF_SERIAL = [0, 1, 18, 19]; // Serial and Serial1
const CYCLES_US = 16;
// Of a servo's pulse, and from one to the next [us].
const PULSE = [500, 2500], EVERY = [3000, 30000];

const isIn = ([least, most], value) => value >= least && value <= most;

export class Pins {
  constructor(cpu) {
    this.cpu = cpu;
    this.pressed = new Set(); // numbers of pins
    this.driven = new Map(); // by number: the level that a timer gives
    this.pulses = new Map(); // by number: {rose [cycles], every, width [us]}
    for (const [name, pin] of Object.entries(PORTS)) {
      const { data } = cpu;
      cpu.writeHooks[pin] = (value) => {
        this.write(name, data[pin + 2] ^ value); // a one toggles
        return true;
      };
      cpu.writeHooks[pin + 2] = (value) => {
        this.write(name, value);
        return true;
      };
      cpu.readHooks[pin] = () => data[pin + 2] & ~this.toGround(name, data[pin + 1]);
    }
  }

  write(name, value) {
    const { data } = this.cpu;
    const port = PORTS[name] + 2;
    const changed = (data[port] ^ value) & data[port - 1];
    data[port] = value;
    for (let bit = 0; changed >> bit; bit++) {
      if ((changed >> bit) & 1) this.edge(DIGITAL.indexOf(name + bit), (value >> bit) & 1);
    }
  }

  // A timer gives a level to its pin; null: the other one.
  drive(number, level) {
    const [port, bit] = DIGITAL[number];
    if (!((this.cpu.data[PORTS[port] + 1] >> bit) & 1)) return;
    const before = this.driven.get(number) || false;
    const now = level ?? !before;
    this.driven.set(number, now);
    if (now !== before) this.edge(number, now);
  }

  // An output has changed.
  edge(number, level) {
    const now = this.cpu.cycles;
    const before = this.pulses.get(number) || {};
    const since = (now - before.rose) / CYCLES_US;
    this.pulses.set(number, { ...before, ...(level ? { rose: now, every: since } : { width: since }) });
  }

  // Whether what a pin does is for a servo.
  isServo({ rose, every, width }) {
    return isIn(PULSE, width) && isIn(EVERY, every) && this.cpu.cycles - rose < 4 * EVERY[1] * CYCLES_US;
  }

  // The bits of a port that a button holds low.
  toGround(name, outputs) {
    let low = 0;
    for (const number of this.pressed) if (DIGITAL[number][0] === name) low |= 1 << DIGITAL[number][1];
    return low & ~outputs;
  }

  // {outputs: {number: level}, inputs: numbers of those with a pull-up, servos: {number: width of its pulse [us]}}.
  get state() {
    const { data } = this.cpu;
    const found = { outputs: {}, inputs: [], servos: {} };
    DIGITAL.forEach((place, number) => {
      if (OF_SERIAL.includes(number)) return;
      const pin = PORTS[place[0]];
      const bit = 1 << place[1];
      const pulse = this.pulses.get(number);
      if (pulse && this.isServo(pulse)) found.servos[number] = Math.round(pulse.width);
      else if (data[pin + 1] & bit) found.outputs[number] = data[pin + 2] & bit ? 1 : 0;
      else if (data[pin + 2] & bit) found.inputs.push(number);
    });
    return found;
  }
}
