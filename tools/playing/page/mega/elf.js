// An ELF file, as the Arduino IDE leaves it: what goes into flash, and what its symbols say.

const ELF = 0x464c457f, HEADER = 52, AVR = 83, MACHINE_2560 = 6, LOAD = 1, SYMBOLS = 2, ALLOCATED = 2;
const RAM_FROM = 0x800200, RAM_TO = 0x810000;
// What the Arduino core calls behind each pass through loop().
const PASS = "_Z14serialEventRunv";

export const isElf = (bytes) => bytes.length >= 4 && new DataView(bytes.buffer).getUint32(0, true) === ELF;

// {pieces, pass, ram}: {address, bytes} of flash, the address of PASS or 0, and the bytes of RAM that are taken. Throws
// an Error that says what is wrong.
export function readElf(bytes) {
  if (!isElf(bytes)) throw new Error("it is no ELF file");
  const view = new DataView(bytes.buffer);
  // A part of the file that it promises to have.
  const whole = (from, size) => {
    if (from + size > bytes.length) throw new Error("the .elf file was cut off");
    return from;
  };
  whole(0, HEADER);
  const half = (at) => view.getUint16(at, true);
  const word = (at) => view.getUint32(at, true);
  if (half(18) !== AVR || (word(36) & 0x7f) !== MACHINE_2560) throw new Error("it is not for an Arduino Mega 2560");
  const table = (from, size, count) =>
    Array.from({ length: whole(from, size * count) && count }, (_, turn) => from + turn * size);
  const pieces = table(word(28), half(42), half(44))
    .filter((at) => word(at) === LOAD && word(at + 16) > 0 && word(at + 12) < RAM_FROM)
    .map((at) => {
      const from = whole(word(at + 4), word(at + 16));
      return { address: word(at + 12), bytes: bytes.subarray(from, from + word(at + 16)) };
    });
  const sections = table(word(32), half(46), half(48));
  const isInRam = (address) => address >= RAM_FROM && address < RAM_TO;
  const inRam = sections.filter((at) => word(at + 8) & ALLOCATED && isInRam(word(at + 12)));
  const symbols = sections.find((at) => word(at + 4) === SYMBOLS);
  let pass = 0;
  if (symbols) {
    const names = word(sections[word(symbols + 24)] + 16);
    const wanted = new TextEncoder().encode(`${PASS}\0`);
    const isPass = (at) => wanted.every((letter, turn) => bytes[names + word(at) + turn] === letter);
    const found = table(word(symbols + 16), 16, word(symbols + 20) / 16).find(isPass);
    if (found) pass = word(found + 4);
  }
  return { pieces, pass, ram: inRam.reduce((sum, at) => sum + word(at + 20), 0) };
}
