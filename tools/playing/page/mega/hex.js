// Intel HEX, as the compiler leaves it for avrdude.

const DATA = 0;
const END = 1;
const SEGMENT = 2;
const START_SEGMENT = 3;
const LINEAR = 4;
const START_LINEAR = 5;

// The pieces of a .hex file: [{address, bytes}]. Throws an Error that names the line.
export function piecesOf(text) {
  const pieces = [];
  let base = 0;
  let isEnded = false;
  text.split(/\r?\n/).forEach((line, index) => {
    if (line === "" || isEnded) return;
    const bytes = bytesOf(line, index + 1);
    const address = (bytes[1] << 8) | bytes[2];
    const data = bytes.subarray(4, bytes.length - 1);
    switch (bytes[3]) {
      case DATA:
        pieces.push({ address: base + address, bytes: data });
        break;
      case END:
        isEnded = true;
        break;
      case SEGMENT:
        base = ((data[0] << 8) | data[1]) << 4;
        break;
      case LINEAR:
        base = ((data[0] << 8) | data[1]) * 0x10000;
        break;
      case START_SEGMENT:
      case START_LINEAR:
        break; // where a PC would begin; an AVR begins at 0
      default:
        throw new Error(`line ${index + 1} of the .hex file has a type that it cannot have: ${bytes[3]}`);
    }
  });
  if (!isEnded) throw new Error("the .hex file was cut off: its last line is missing");
  return pieces;
}

function bytesOf(line, number) {
  const isHex = /^:(?:[0-9a-fA-F]{2}){5,}$/.test(line);
  const bytes = isHex ? Uint8Array.from(line.slice(1).match(/../g), (pair) => parseInt(pair, 16)) : new Uint8Array(1);
  const sum = bytes.reduce((total, byte) => (total + byte) & 0xff, 0);
  const isWhole = isHex && sum === 0 && bytes.length === bytes[0] + 5;
  if (!isWhole) throw new Error(`line ${number} of the .hex file is damaged`);
  return bytes;
}
