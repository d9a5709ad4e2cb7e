// An SD card on the SPI bus, FAT16, with one file that can be read: PLAN.TXT.

const SECTOR = 512, FAT = 1, FAT_SECTORS = 32, ROOT = FAT + 2 * FAT_SECTORS, ROOT_SECTORS = 32;
const DATA = ROOT + ROOT_SECTORS, CLUSTERS = 8000; // of one sector each
const IDLE = 1, UNKNOWN = 4, NOTHING = 0xff, BEGIN = 0xfe;
const RESET = 0, CONDITION = 8, LENGTH = 16, READ = 17, OPEN = 41, FOR_SD = 55, VOLTAGES = 58;

export class Card {
  constructor(text) {
    this.file = new TextEncoder().encode(text);
    this.command = [];
    this.answer = [];
    this.isIdle = true;
  }

  // A byte to the card, and the one that comes from it meanwhile.
  exchange(byte) {
    const said = this.answer.length ? this.answer.shift() : NOTHING;
    if (this.command.length || byte >> 6 === 1) {
      if (this.command.push(byte) === 6) {
        const [code, ...rest] = this.command;
        this.command = [];
        const value = rest.slice(0, 4).reduce((sum, one) => 256 * sum + one, 0);
        this.answer = [NOTHING, ...this.obey(code & 0x3f, value)];
      }
    }
    return said;
  }

  obey(command, value) {
    if (command === RESET) this.isIdle = true;
    if (command === OPEN) this.isIdle = false;
    const state = this.isIdle ? IDLE : 0;
    if ([RESET, OPEN, FOR_SD, LENGTH].includes(command)) return [state];
    if (command === CONDITION) return [state, 0, 0, 1, value & 0xff];
    if (command === VOLTAGES) return [state, this.isIdle ? 0 : 0x80, 0xff, 0x80, 0];
    if (command === READ) return [0, NOTHING, BEGIN, ...this.sector(Math.floor(value / SECTOR)), 0, 0];
    return [state | UNKNOWN];
  }

  sector(number) {
    const bytes = new Uint8Array(SECTOR);
    const view = new DataView(bytes.buffer);
    const half = (at, value) => view.setUint16(at, value, true);
    const used = Math.ceil(this.file.length / SECTOR);
    if (number === 0) {
      half(11, SECTOR);
      bytes[13] = 1; // sectors of a cluster
      half(14, FAT);
      bytes[16] = 2;
      half(17, (ROOT_SECTORS * SECTOR) / 32);
      half(19, DATA + CLUSTERS);
      bytes[21] = 0xf8;
      half(22, FAT_SECTORS);
      half(510, 0xaa55);
    } else if (number < ROOT) {
      const first = ((number - FAT) % FAT_SECTORS) * (SECTOR / 2);
      for (let turn = 0; turn < SECTOR / 2; turn++) {
        const cluster = first + turn;
        if (cluster < 2 || cluster === used + 1) half(2 * turn, 0xffff);
        else if (cluster <= used) half(2 * turn, cluster + 1);
      }
    } else if (number === ROOT) {
      bytes.set(new TextEncoder().encode("PLAN    TXT "));
      half(26, 2);
      view.setUint32(28, this.file.length, true);
    } else if (number >= DATA) {
      bytes.set(this.file.subarray((number - DATA) * SECTOR, (number - DATA + 1) * SECTOR));
    }
    return bytes;
  }
}
