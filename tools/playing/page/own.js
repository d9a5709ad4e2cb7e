// A compiled sketch that was dropped onto the page: a .hex or an .elf of the Arduino IDE, for a Mega.

import { isElf, readElf } from "./mega/elf.js";
import { piecesOf } from "./mega/hex.js";

const VECTORS = 57; // of an ATmega2560, each a jump
const FLASH = 253952;

export const isSketch = (name) => /\.(hex|elf)$/i.test(name);

// As an entry of examples.json. Throws an Error that says what is wrong.
export function exampleOf(name, bytes) {
  const { pieces, pass, ram } = isElf(bytes) || /\.elf$/i.test(name) ? readElf(bytes)
    : { pieces: piecesOf(new TextDecoder().decode(bytes)), pass: 0, ram: null };
  if (!isOfMega(pieces)) throw new Error("it is not for an Arduino Mega 2560");
  const flash = pieces.filter(({ address }) => address < FLASH).reduce((sum, piece) => sum + piece.bytes.length, 0);
  return entryOf({ name, image: pieces, pass, ram, flash, says: "Your own sketch, as it was compiled." });
}

// made: its name, image and sizes.
export function entryOf(made) {
  return {
    ...made, arms: true, prints: true, listens: true,
  };
}

function isOfMega(pieces) {
  const flash = new Uint8Array(4 * VECTORS);
  for (const { address, bytes } of pieces) {
    if (address < flash.length) flash.set(bytes.subarray(0, flash.length - address), address);
  }
  return Array.from({ length: VECTORS }, (_, turn) => flash[4 * turn] | (flash[4 * turn + 1] << 8))
    .every((word) => (word & 0xfe0e) === 0x940c || (word & 0xf000) === 0xc000);
}
