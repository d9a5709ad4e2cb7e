// An Arduino Mega 2560: avr8js with what that chip has otherwise than the 328p, for which avr8js is made.

import { CPU } from "../vendor/avr8js/cpu/cpu.js";
import { avrInstruction } from "../vendor/avr8js/cpu/instruction.js";
import { ADCMuxInputType, ADCReference, AVRADC, adcConfig } from "../vendor/avr8js/peripherals/adc.js";
import { AVREEPROM, EEPROMMemoryBackend, eepromConfig } from "../vendor/avr8js/peripherals/eeprom.js";
import { AVRSPI, spiConfig } from "../vendor/avr8js/peripherals/spi.js";
import { AVRTimer, timer0Config } from "../vendor/avr8js/peripherals/timer.js";
import { Card } from "./card.js";
import { piecesOf } from "./hex.js";
import { Pins } from "./pins.js";
import { Timer16 } from "./timer16.js";
import { Usart } from "./usart.js";

export const HZ = 16_000_000;
const FLASH_BYTES = 0x40000; // more than 64 K words: avr8js then pushes return addresses of 3 bytes, as the chip does
const RAM_BEGIN = 0x200; // behind the registers of the 2560; avr8js allows for 0x100
const RAM_BYTES = 8192;
const AVR8JS_REGISTERS = 0x100;
export const RAM_END = RAM_BEGIN + RAM_BYTES - 1;
const EEPROM_BYTES = 4096;
const ERASED = 0xffff;
const SPL = 93, SPH = 94, SREG = 95;
const I = 0x80; // of SREG: interrupts are enabled

// The 2560's interrupt vectors, by their numbers; an address is two words for each.
const TIMER0_COMPA = 21, TIMER0_COMPB = 22, TIMER0_OVF = 23, SPI_READY = 24, USART0_RX = 25, ADC_READY = 29, EE_READY = 30;
const USART1_RX = 36;
// avr8js takes 2 cycles for what takes the chip 5: two, and a push of three bytes.
const RESPONSE_CYCLES = 3;

const TIMER0 = {
  ...timer0Config,
  compAInterrupt: 2 * TIMER0_COMPA,
  compBInterrupt: 2 * TIMER0_COMPB,
  ovfInterrupt: 2 * TIMER0_OVF,
};
// Erasing and writing a byte together take 3.4 ms; avr8js adds up the times of the two halves.
const EEPROM = { ...eepromConfig, eepromReadyInterrupt: 2 * EE_READY, eraseCycles: 27_200, writeCycles: 27_200 };
// A0 to A7, and with MUX5 A8 to A15; a pin to which nothing is connected reads 0.
const MUX5 = 0x20;
const PINS = Array.from({ length: 16 }, (_, pin) => [
  (pin & 7) | (pin < 8 ? 0 : MUX5),
  { type: ADCMuxInputType.SingleEnded, channel: pin },
]);
const ADC = {
  ...adcConfig,
  adcInterrupt: 2 * ADC_READY,
  numChannels: PINS.length,
  muxInputMask: 0x3f,
  muxChannels: Object.fromEntries(PINS),
  adcReferences: [ADCReference.AREF, ADCReference.AVCC, ADCReference.Internal1V1, ADCReference.Internal2V56],
};
// The numbers of their interrupts for channel A, and the pins of their channels.
const TIMERS16 = [
  { number: 1, base: 0x80, vector: 17, channels: [11, 12, 13] },
  { number: 3, base: 0x90, vector: 32, channels: [5, 2, 3] },
  { number: 4, base: 0xa0, vector: 42, channels: [6, 7, 8] },
  { number: 5, base: 0x120, vector: 47, channels: [46, 45, 44] },
];
const SPI = { ...spiConfig, spiInterrupt: 2 * SPI_READY };
const UCSR0A = 0xc0, UCSR1A = 0xc8;

export class Crashed extends Error {}

export class Mega {
  // hex: the text of the .hex file, or {address, bytes} of the pieces of its flash. pass: the address in flash of what
  // the Arduino core calls once in each pass through loop(), by which the passes are counted; 0 counts none.
  // text: of the file on its SD card.
  constructor(hex, pass = 0, text = "") {
    this.text = text;
    this.flash = new Uint16Array(FLASH_BYTES / 2).fill(ERASED);
    const bytes = new Uint8Array(this.flash.buffer);
    for (const piece of typeof hex === "string" ? piecesOf(hex) : hex) {
      const end = piece.address + piece.bytes.length;
      if (end > FLASH_BYTES) throw new Error("this firmware does not fit a Mega's flash");
      bytes.set(piece.bytes, piece.address);
    }
    this.pass = pass ? pass / 2 : -1;
    this.eeprom = new EEPROMMemoryBackend(EEPROM_BYTES);
    this.resets = 0;
    this.lowestSp = RAM_END;
    this.ports = [];
    this.start();
    this.fillWithNoise();
    this.forgetPasses();
  }

  get cycle() {
    return this.cpu.cycles;
  }

  serial(number) {
    return this.ports[number];
  }

  // The bytes of stack that were in use at the deepest.
  get deepestStack() {
    return RAM_END - this.lowestSp;
  }

  // Press the button: RAM and EEPROM keep what they hold, and time goes on.
  reset() {
    this.resets++;
    const { cpu, ports, pins } = this;
    this.start();
    this.cpu.data.set(cpu.data.subarray(RAM_BEGIN), RAM_BEGIN);
    this.cpu.cycles = cpu.cycles;
    this.ports.forEach((port, number) => port.takeOver(ports[number]));
    this.pins.pressed = pins.pressed;
    this.passBegan = -1;
  }

  start() {
    const cpu = new CPU(this.flash, RAM_BEGIN - AVR8JS_REGISTERS + RAM_BYTES);
    this.cpu = cpu;
    this.timer0 = new AVRTimer(cpu, TIMER0);
    this.analog = new AVRADC(cpu, ADC);
    this.memory = new AVREEPROM(cpu, this.eeprom, EEPROM);
    this.pins = new Pins(cpu);
    for (const one of TIMERS16) {
      new Timer16(cpu, one, (channel, level) => this.pins.drive(one.channels[channel], level));
    }
    const card = new Card(this.text);
    this.spi = new AVRSPI(cpu, SPI, HZ);
    this.spi.onTransfer = (byte) => card.exchange(byte);
    this.ports = [new Usart(cpu, UCSR0A, USART0_RX), new Usart(cpu, UCSR1A, USART1_RX)];
  }

  // RAM holds noise at power-on; firmware must not count on zeros.
  fillWithNoise() {
    let noise = 2463534242;
    for (let at = RAM_BEGIN; at <= RAM_END; at++) {
      noise ^= noise << 13;
      noise ^= noise >>> 17;
      noise ^= noise << 5;
      this.cpu.data[at] = noise;
    }
  }

  // Run to a cycle, a few more if the last instruction takes them.
  run(until) {
    const { cpu, flash, pass } = this;
    const { data } = cpu;
    let lowest = this.lowestSp;
    while (cpu.cycles < until) {
      const { pc } = cpu;
      if (pc === pass) this.passes();
      const opcode = flash[pc];
      if (opcode === ERASED || opcode === undefined) throw new Crashed(`it ran into erased flash at ${2 * pc}`);
      const wasEnabled = data[SREG] & I;
      avrInstruction(cpu);
      const sp = data[SPL] | (data[SPH] << 8);
      if (sp < lowest && !isStackPointerTorn(opcode)) lowest = sp;
      // The chip executes one more instruction behind that which enables interrupts: SPL is written there.
      if (!wasEnabled && data[SREG] & I) continue;
      if (cpu.nextInterrupt >= 0 && data[SREG] & I) {
        cpu.tick();
        cpu.cycles += RESPONSE_CYCLES;
      } else if (cpu.nextClockEvent !== null && cpu.nextClockEvent.cycles <= cpu.cycles) {
        cpu.tick();
      }
    }
    this.lowestSp = lowest;
  }

  passes() {
    const now = this.cpu.cycles;
    if (this.passBegan >= 0) {
      const took = now - this.passBegan;
      this.passCount++;
      if (took > this.longestPass) this.longestPass = took;
      if (took < this.shortestPass) this.shortestPass = took;
    }
    this.passBegan = now;
  }

  // {count, longest, shortest}: the passes through loop() since the last call [cycles].
  takePasses() {
    const taken = { count: this.passCount, longest: this.longestPass, shortest: this.shortestPass };
    this.forgetPasses();
    return taken;
  }

  forgetPasses() {
    this.passBegan = -1;
    this.passCount = 0;
    this.longestPass = 0;
    this.shortestPass = Infinity;
  }
}

// A function that makes room on the stack writes SPH, then SREG, then SPL: in between SP means nothing.
function isStackPointerTorn(opcode) {
  return (opcode & 0xfe0f) === 0xbe0e || (opcode & 0xfe0f) === 0xbe0f;
}
