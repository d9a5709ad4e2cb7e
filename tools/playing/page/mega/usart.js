// A serial port of the ATmega2560, and the peer's end of its cable.
//
// avr8js has a USART, which forgets a byte that has arrived when the sketch switches its transmit interrupt on or off,
// and has no second place to write to. This one has the chip's buffers: two bytes received beside the arriving one, and
// one to be sent beside the one that is leaving.

const RXC = 0x80, TXC = 0x40, UDRE = 0x20, U2X = 0x02, MPCM = 0x01; // UCSRnA
const RXCIE = 0x80, TXCIE = 0x40, UDRIE = 0x20, RXEN = 0x10, TXEN = 0x08; // UCSRnB
const EIGHT_BITS = 0x06; // UCSRnC
const BITS_OF_A_BYTE = 10; // a start bit, eight, a stop bit
const RECEIVED = 2;

export class Usart {
  // ucsra: the address of the port's first register. vector: the number of its receive interrupt; those for an empty
  // data register and for the end of sending follow.
  constructor(cpu, ucsra, vector) {
    this.cpu = cpu;
    this.A = ucsra;
    this.B = ucsra + 1;
    this.C = ucsra + 2;
    this.UBRRL = ucsra + 4;
    this.UDR = ucsra + 6;
    this.sent = []; // {byte, left}: the cycle at which its stop bit was over
    this.lost = 0; // bytes that came to a full receiver
    this.unheard = 0; // bytes that came while the receiver was off
    this.arriving = []; // {byte, at}: from the peer, not before cycle `at`
    this.isArriving = false;
    this.received = [];
    this.leaving = -1; // the byte in the shift register, or none
    this.next = -1; // the byte behind it
    const interrupt = (turn, mask, enable) => ({
      address: 2 * (vector + turn), flagRegister: this.A, flagMask: mask, enableRegister: this.B, enableMask: enable,
      constant: true,
    });
    this.onReceived = interrupt(0, RXC, RXCIE);
    this.onEmpty = interrupt(1, UDRE, UDRIE);
    this.onSent = { ...interrupt(2, TXC, TXCIE), constant: false };
    cpu.data[this.A] = UDRE;
    cpu.data[this.B] = 0;
    cpu.data[this.C] = EIGHT_BITS;
    cpu.writeHooks[this.A] = (value) => {
      const cleared = value & TXC;
      cpu.data[this.A] = (cpu.data[this.A] & ~(U2X | MPCM | cleared)) | (value & (U2X | MPCM));
      this.request();
      return true;
    };
    cpu.writeHooks[this.B] = (value) => {
      cpu.data[this.B] = value;
      if (!(value & RXEN)) {
        this.received.length = 0;
        cpu.data[this.A] &= ~RXC;
      }
      this.request();
      return true;
    };
    cpu.writeHooks[this.UDR] = (value) => {
      this.write(value);
      return true;
    };
    cpu.readHooks[this.UDR] = () => this.read();
  }

  get bitCycles() {
    const { data } = this.cpu;
    const divider = ((data[this.UBRRL + 1] & 0x0f) << 8) | data[this.UBRRL];
    return (divider + 1) * (data[this.A] & U2X ? 8 : 16);
  }

  get byteCycles() {
    return BITS_OF_A_BYTE * this.bitCycles;
  }

  get isListening() {
    return (this.cpu.data[this.B] & RXEN) !== 0;
  }

  // Bytes from the peer, one behind the other, the first not before cycle `at`.
  send(bytes, at = 0) {
    for (const byte of bytes) this.arriving.push({ byte, at });
    if (!this.isArriving) this.begin();
  }

  // Bytes from the peer that have not arrived whole.
  get unsent() {
    return this.arriving.length;
  }

  // What has been sent since the last call.
  takeSent() {
    const { sent } = this;
    this.sent = [];
    return sent;
  }

  // The chip was reset; the cable and what is on its way in it stay as they are.
  takeOver(before) {
    this.lost = before.lost;
    this.unheard = before.unheard;
    this.sent = before.sent;
    this.send(before.arriving.map((one) => one.byte));
  }

  begin() {
    const first = this.arriving[0];
    this.isArriving = first !== undefined;
    if (!this.isArriving) return;
    const wait = Math.max(0, first.at - this.cpu.cycles);
    this.cpu.addClockEvent(() => this.arrive(), wait + this.byteCycles);
  }

  arrive() {
    const { byte } = this.arriving.shift();
    if (!this.isListening) {
      this.unheard++;
    } else if (this.received.length > RECEIVED) {
      this.lost++;
    } else {
      this.received.push(byte);
      this.cpu.data[this.A] |= RXC;
      this.request();
    }
    this.begin();
  }

  read() {
    const byte = this.received.length ? this.received.shift() : 0;
    if (!this.received.length) this.cpu.data[this.A] &= ~RXC;
    this.request();
    return byte;
  }

  write(byte) {
    if (!(this.cpu.data[this.B] & TXEN)) return;
    if (this.leaving < 0) {
      this.leave(byte);
    } else {
      this.next = byte;
      this.cpu.data[this.A] &= ~UDRE;
      this.request();
    }
  }

  leave(byte) {
    this.leaving = byte;
    this.cpu.addClockEvent(() => this.left(), this.byteCycles);
  }

  left() {
    this.sent.push({ byte: this.leaving, left: this.cpu.cycles });
    this.leaving = -1;
    if (this.next >= 0) {
      this.leave(this.next);
      this.next = -1;
      this.cpu.data[this.A] |= UDRE;
    } else {
      this.cpu.data[this.A] |= TXC;
    }
    this.request();
  }

  // Ask for the interrupts whose flags and enabling bits are both set.
  request() {
    const { cpu } = this;
    for (const one of [this.onReceived, this.onEmpty, this.onSent]) {
      const asks = cpu.data[this.A] & one.flagMask && cpu.data[this.B] & one.enableMask;
      if (asks) cpu.queueInterrupt(one);
      else cpu.clearInterrupt(one, false);
    }
  }
}
