// In the place of a build of ArduPilot's simulator: its interface, and behind it whoever is at the other end of a
// channel, which a test plays. (https://ardupilot.org/dev/docs/sitl-wasm.html)

const ROOM = 700; // bytes that wait for the vehicle, at most: less than what the Mega may send at once

export default async function create({ wasmMemory, wasmBinary, mainScriptUrlOrBlob, preRun, arguments: words, onAbort }) {
  const isShared = wasmMemory.buffer instanceof SharedArrayBuffer;
  const files = {};
  for (const run of preRun) run({ FS: { writeFile: (name, text) => (files[name] = text) } });
  const channel = new BroadcastChannel("vehicle");
  let heard = [], waits = [], free = 1024;
  channel.onmessage = ({ data: { bytes, abort } }) => {
    if (abort) onAbort(abort);
    else waits.push(...bytes);
  };
  channel.postMessage({ started: { isShared, files, words, binary: [...wasmBinary], script: mainScriptUrlOrBlob } });
  setInterval(() => {
    if (heard.length) channel.postMessage({ heard });
    heard = [];
  }, 5);
  const view = (at, length) => new Uint8Array(wasmMemory.buffer, at, length);
  const functions = {
    ardupilot_malloc: (size) => (free += size) - size,
    ardupilot_serial_read: (port, at, most) => {
      const bytes = port === 0 ? waits.splice(0, most) : [];
      view(at, bytes.length).set(bytes);
      return bytes.length;
    },
    ardupilot_serial_write: (port, at, length) => {
      const taken = Math.min(length, ROOM - heard.length);
      if (port === 0) heard.push(...view(at, taken));
      return taken;
    },
  };
  return { cwrap: (name) => functions[name] };
}
