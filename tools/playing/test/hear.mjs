// Gives stdin to the page's parser; the frames that it finds, in hexadecimal, as JSON.
import fs from "node:fs";

const [, , file, by] = process.argv;
const { instance } = await WebAssembly.instantiate(fs.readFileSync(file));
const { exports } = instance;
exports._initialize();
const parser = exports.hearing_new(Number(by));
const frames = [];
let data = fs.readFileSync(0);
while (data.length) {
  const piece = data.subarray(0, exports.size_of_room());
  new Uint8Array(exports.memory.buffer).set(piece, exports.room_for_bytes());
  const lengthAt = exports.room_for_length();
  const [from, to] = [exports.room_for_bytes(), exports.room_for_frame()];
  const taken = exports.hearing_take(parser, from, piece.length, to, lengthAt);
  const memory = Buffer.from(exports.memory.buffer);
  const length = memory.readUInt16LE(lengthAt);
  if (length) frames.push(memory.subarray(to, to + length).toString("hex"));
  data = data.subarray(taken);
}
process.stdout.write(JSON.stringify(frames));
