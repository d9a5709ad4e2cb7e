// MAVLink's C parser as the autopilots use it, compiled to WebAssembly: what hearing_parser.py calls.

export async function hearing(url) {
  const { instance } = await instantiated(url);
  const { exports } = instance;
  exports._initialize();
  return {
    ...exports,
    put: (bytes) => memoryOf(exports).set(bytes.toJs ? bytes.toJs() : bytes, exports.room_for_bytes()),
    bytes_at: (at, length) => memoryOf(exports).slice(at, at + length),
  };
}

const memoryOf = (exports) => new Uint8Array(exports.memory.buffer);

// A server may not know what a .wasm is: then it is read first and compiled afterwards.
async function instantiated(url) {
  const bytes = await (await fetch(url)).arrayBuffer();
  return WebAssembly.instantiate(bytes);
}
