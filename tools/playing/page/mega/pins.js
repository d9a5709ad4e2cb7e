// The pins of an Arduino Mega: what a sketch has made of them, and the buttons between them and GND.

const PORTS = { // the address of its PIN register; DDR and PORT follow
  A: 0x20, B: 0x23, C: 0x26, D: 0x29, E: 0x2c, F: 0x2f, G: 0x32, H: 0x100, J: 0x103, K: 0x106, L: 0x109,
};
// By the numbers on the board.
const DIGITAL = ("E0 E1 E4 E5 G5 E3 H3 H4 H5 H6 B4 B5 B6 B7 J1 J0 H1 H0 D3 D2 D1 D0 A0 A1 A2 A3 A4 A5 A6 A7 " +
  "C7 C6 C5 C4 C3 C2 C1 C0 D7 G2 G1 G0 L7 L6 L5 L4 L3 L2 L1 L0 B3 B2 B1 B0").split(" ");
const OF_SERIAL = [0, 1, 18, 19]; // Serial and Serial1

export class Pins {
  constructor(cpu) {
    this.cpu = cpu;
    this.pressed = new Set(); // numbers of pins
    for (const [name, pin] of Object.entries(PORTS)) {
      const { data } = cpu;
      cpu.writeHooks[pin] = (value) => {
        data[pin + 2] ^= value; // a one toggles
        return true;
      };
      cpu.readHooks[pin] = () => data[pin + 2] & ~this.toGround(name, data[pin + 1]);
    }
  }

  // The bits of a port that a button holds low.
  toGround(name, outputs) {
    let low = 0;
    for (const number of this.pressed) if (DIGITAL[number][0] === name) low |= 1 << DIGITAL[number][1];
    return low & ~outputs;
  }

  // {outputs: {number: level}, inputs: numbers of those with a pull-up}.
  get state() {
    const { data } = this.cpu;
    const found = { outputs: {}, inputs: [] };
    DIGITAL.forEach((place, number) => {
      if (OF_SERIAL.includes(number)) return;
      const pin = PORTS[place[0]];
      const bit = 1 << place[1];
      if (data[pin + 1] & bit) found.outputs[number] = data[pin + 2] & bit ? 1 : 0;
      else if (data[pin + 2] & bit) found.inputs.push(number);
    });
    return found;
  }
}
