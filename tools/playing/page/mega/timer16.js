// A 16-bit timer of the ATmega2560, by its events alone: avr8js's own is called for each of its counts.

const TOV = 1, OCF = [2, 4, 8], COM = [6, 4, 2], OCR = [8, 10, 12]; // by channel
const TCCRB = 1, TCNT = 4, ICR = 6;
const DIVIDERS = [0, 1, 8, 64, 256, 1024, 0, 0];
// By WGM: the highest count or the register that holds it, and whether it counts down again.
const TOPS = [0xffff, 0xff, 0x1ff, 0x3ff, "A", 0xff, 0x1ff, 0x3ff, "I", "A", "I", "A", "I", 0xffff, "I", "A"];
const isDual = (wgm) => [1, 2, 3, 8, 9, 10, 11].includes(wgm);
const isPwm = (wgm) => ![0, 4, 12, 13].includes(wgm);

export class Timer16 {
  // base: the address of TCCRnA. number: of the timer. vector: the number of its interrupt for channel A. set: is
  // called with a channel, 0 to 2, and the level that the timer gives its pin; null: the other one.
  constructor(cpu, { base, number, vector }, set) {
    Object.assign(this, { cpu, base, set, flags: 0x35 + number, began: 0, stopped: 0 });
    this.asked = [0, 0, 0]; // what was written to OCRnx, which PWM takes over when it begins anew
    this.compare = [0, 0, 0];
    this.high = 0; // the byte that is kept until the low one is written
    const interrupt = (turn, flag) => ({ address: 2 * (vector + turn), flagRegister: this.flags, flagMask: flag,
      enableRegister: 0x6e + number, enableMask: flag });
    this.interrupts = [...OCF.map((flag, turn) => interrupt(turn, flag)), interrupt(3, TOV)];
    this.next = () => this.event();
    const { data } = cpu;
    const anew = (at) => {
      cpu.writeHooks[base + at] = (value) => {
        const count = this.count;
        data[base + at] = value;
        this.begin(count);
        return true;
      };
    };
    anew(0);
    anew(TCCRB);
    const word = (at, take) => {
      cpu.writeHooks[base + at + 1] = (value) => {
        this.high = value;
      };
      cpu.writeHooks[base + at] = (value) => {
        data[base + at + 1] = this.high;
        data[base + at] = value;
        take((this.high << 8) | value);
        return true;
      };
    };
    word(TCNT, (value) => this.begin(value));
    word(ICR, () => this.begin(this.count));
    OCR.forEach((at, channel) => word(at, (value) => {
      this.asked[channel] = value;
      if (this.mode[2]) return;
      this.compare[channel] = value;
      this.begin(this.count);
    }));
    cpu.readHooks[base + TCNT] = () => {
      const { count } = this;
      data[base + TCNT + 1] = count >> 8;
      return count & 0xff;
    };
    cpu.writeHooks[this.flags] = (value) => {
      for (const one of this.interrupts) cpu.clearInterruptByFlag(one, value);
      return true;
    };
    cpu.writeHooks[0x6e + number] = (value) => {
      for (const one of this.interrupts) cpu.updateInterruptEnable(one, value);
    };
  }

  get mode() {
    const { data } = this.cpu;
    const wgm = (data[this.base] & 3) | ((data[this.base + TCCRB] >> 1) & 12);
    return [TOPS[wgm], isDual(wgm), isPwm(wgm)];
  }

  get divider() {
    return DIVIDERS[this.cpu.data[this.base + TCCRB] & 7];
  }

  get top() {
    const [top] = this.mode;
    if (top === "A") return this.compare[0];
    return top === "I" ? this.cpu.data[this.base + ICR] | (this.cpu.data[this.base + ICR + 1] << 8) : top;
  }

  // In counts.
  get period() {
    return this.mode[1] ? Math.max(1, 2 * this.top) : this.top + 1;
  }

  get count() {
    const { divider, period, top } = this;
    if (!divider) return this.stopped;
    const phase = Math.floor((this.cpu.cycles - this.began) / divider) % period;
    return this.mode[1] && phase > top ? period - phase : phase;
  }

  // Go on at a count.
  begin(count) {
    const { cpu, divider } = this;
    cpu.clearClockEvent(this.next);
    this.stopped = count;
    if (!divider) return;
    this.began = cpu.cycles - count * divider;
    this.phase = count;
    this.schedule();
  }

  // [phase, channel or -1 for a new period, whether it counts down then]: what comes in this period, in its order.
  get events() {
    const { period, top } = this;
    const found = [];
    this.compare.forEach((value, channel) => {
      if (!this.mode[1]) {
        if (value <= top) found.push([value + 1, channel, false]);
      } else if (value && value < top) {
        found.push([value, channel, false], [period - value, channel, true]);
      }
    });
    return [...found, [period, -1, false]].sort(([one], [other]) => one - other);
  }

  schedule() {
    [this.due] = this.events.find(([phase]) => phase > this.phase) || [this.phase + 1];
    this.cpu.addClockEvent(this.next, this.began + this.due * this.divider - this.cpu.cycles);
  }

  event() {
    this.phase = this.due;
    for (const [phase, channel, isDown] of this.events) {
      if (phase !== this.due) continue;
      if (channel < 0) this.wrap();
      else this.match(channel, isDown);
    }
    this.schedule();
  }

  // 0: the pin is not the timer's; 1: toggle, 2: clear, 3: set, at a match.
  com(channel) {
    return (this.cpu.data[this.base] >> COM[channel]) & 3;
  }

  match(channel, isDown) {
    this.cpu.setInterruptFlag(this.interrupts[channel]);
    const com = this.com(channel);
    if (com) this.set(channel, com === 1 ? null : (com === 3) !== isDown);
  }

  wrap() {
    const [top, isBack, isPulse] = this.mode;
    this.began += this.period * this.divider;
    this.phase = 0;
    if (isPulse || top === 0xffff) this.cpu.setInterruptFlag(this.interrupts[3]);
    if (!isPulse) return;
    this.compare = [...this.asked];
    this.compare.forEach((value, channel) => {
      const com = this.com(channel);
      if (com > 1) this.set(channel, (com === 2) === (!isBack || value > 0));
    });
  }
}
